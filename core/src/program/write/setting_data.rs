//! What a newer control changes in its setting and machine data: lines of a start-up file, which the control exports
//! and reads too, and assignments of a program.

use super::machine::{value, written};
use crate::control::setting_data::{SETTING_DATA, SettingDatum};
use crate::control::{Control, GENERATION, Value};
use std::fmt::Write;

/// Lines of a start-up file for data that differ from delivery: `N54600 $SNS_MEA_WP_BALL_DIAM[0]=6`, those of the
/// channel behind them. Empty: none does.
pub fn lines(control: &Control, delivered: &Control) -> String {
    let (mut text, generation) = (String::new(), control.number(GENERATION));
    for of_channel in [false, true] {
        let mut head = if of_channel { "CHANDATA(1)\n" } else { "" };
        for (datum, place, value) in differing(control, delivered).filter(|(one, ..)| one.of_channel() == of_channel) {
            let _ = write!(text, "{}", std::mem::take(&mut head));
            let number = if datum.is_named(generation) { format!("N{} ", datum.number) } else { String::new() };
            let _ = writeln!(text, "{number}{}", assigned(datum, place, &value, generation));
        }
    }
    text
}

/// Assignments of a program for the setting data that differ.
pub fn assignments(control: &Control, delivered: &Control) -> String {
    let settings = differing(control, delivered).filter(|(datum, ..)| datum.is_setting());
    let generation = control.number(GENERATION);
    settings.map(|(datum, place, value)| assigned(datum, place, &value, generation) + "\n").collect()
}

/// Its name and value; as a comment with the number where no name is published.
fn assigned(datum: &SettingDatum, place: Option<usize>, value: &Value, generation: f64) -> String {
    if !datum.is_named(generation) {
        return format!("; {}={}", datum.spelled(place), written(value));
    }
    let index = place.map_or_else(String::new, |place| format!("[{place}]"));
    format!("{}{index}={}", datum.identifier(), written(value))
}

/// Data that were typed, and those whose user datum differs, in the order of the numbers.
fn differing<'a>(
    control: &'a Control,
    delivered: &'a Control,
) -> impl Iterator<Item = (&'static SettingDatum, Option<usize>, Value)> + 'a {
    let generation = control.number(GENERATION);
    let places = SETTING_DATA.iter().flat_map(|datum| datum.places(control).into_iter().map(move |at| (datum, at)));
    places.filter_map(move |(datum, place)| {
        let typed = control.data.get(&datum.spelled(place)).cloned();
        let older = || {
            let (gud, _) = datum.older(generation)?;
            let name = gud.spelled(&datum.older_place(place, generation));
            let own = value(control, &name);
            (own != value(delivered, &name)).then_some(own)
        };
        Some((datum, place, typed.or_else(older)?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    // oracle: peer (remedies of 61338: each generation has its speeds in other data; the names of the second are not
    // published)
    #[test]
    fn the_speeds_are_written_in_the_data_of_the_generation() {
        let delivered = delivery(Dialect::Sinumerik);
        for (generation, wanted) in
            [(2.0, "CHANDATA(1)\n; SD55631=700\n"), (3.0, "CHANDATA(1)\nN55634 $SCS_MEA_FEED_PLANE_VALUE=700\n")]
        {
            let mut control = delivery(Dialect::Sinumerik);
            control.set(GENERATION, generation);
            control.set("_SPEED[1]", 700.0);
            assert_eq!(lines(&control, &delivered), wanted);
        }
    }
}
