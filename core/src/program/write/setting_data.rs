//! What a newer control changes in its setting and machine data: lines of a start-up file, which the control exports
//! and reads too, and assignments of a program.

use super::machine::{value, written};
use crate::control::setting_data::{SETTING_DATA, SettingDatum};
use crate::control::{Control, Value};
use std::fmt::Write;

/// Lines of a start-up file for data that differ from delivery: `N54600 $SNS_MEA_WP_BALL_DIAM[0]=6`, those of the
/// channel behind them. Empty: none does.
pub fn lines(control: &Control, delivered: &Control) -> String {
    let mut text = String::new();
    for of_channel in [false, true] {
        let mut head = if of_channel { "CHANDATA(1)\n" } else { "" };
        for (datum, place, value) in differing(control, delivered).filter(|(one, ..)| one.of_channel() == of_channel) {
            let _ = write!(text, "{}", std::mem::take(&mut head));
            let _ = writeln!(text, "N{} {}", datum.number, assigned(datum, place, &value));
        }
    }
    text
}

/// Assignments of a program for the setting data that differ.
pub fn assignments(control: &Control, delivered: &Control) -> String {
    let settings = differing(control, delivered).filter(|(datum, ..)| datum.is_setting());
    settings.map(|(datum, place, value)| assigned(datum, place, &value) + "\n").collect()
}

fn assigned(datum: &SettingDatum, place: Option<usize>, value: &Value) -> String {
    let index = place.map_or_else(String::new, |place| format!("[{place}]"));
    format!("{}{index}={}", datum.identifier(), written(value))
}

/// Data that were typed, and those whose user datum differs, in the order of the numbers.
fn differing<'a>(
    control: &'a Control,
    delivered: &'a Control,
) -> impl Iterator<Item = (&'static SettingDatum, Option<usize>, Value)> + 'a {
    let places = SETTING_DATA.iter().flat_map(|datum| datum.places(control).into_iter().map(move |at| (datum, at)));
    places.filter_map(|(datum, place)| {
        let typed = control.data.get(&datum.spelled(place)).cloned();
        let older = || {
            let (gud, _) = datum.older()?;
            let name = gud.spelled(&datum.older_place(place));
            let own = value(control, &name);
            (own != value(delivered, &name)).then_some(own)
        };
        Some((datum, place, typed.or_else(older)?))
    })
}
