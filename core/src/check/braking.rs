//! Feeds of a call against the deflection that the probe allows (B:1129-1196).

use crate::control::Control;
use crate::control::braking::measuring_feed;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, ProbeUse, names};
use crate::own;

/// Tells the feeds at which the axis goes on further after the signal than the probe allows, on a machine that says how
/// its axes stop.
pub(super) fn look(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    if inputs.cycle.purpose.probe != ProbeUse::Workpiece || control.deflection.is_none() {
        return;
    }
    if let (Some(chosen), Some(path)) = (inputs.any(names::VMS), inputs.any(names::FA)) {
        let told = feed(control, names::VMS.as_str(), measuring_feed(chosen, path.abs()));
        found.extend(told.map(|one| one.at(names::VMS)));
        // a first, fast touch (B:13772, B:14013)
        if control.bit("_CHBIT[17]") && path.abs() > 1.0 {
            found.extend(feed(control, FAST, control.basic_length(FAST)));
        }
    }
    // on the way round the part nothing is expected, and a touch stops the axes where they are watched (B:13751-13763)
    if let Some(round) = inputs.any(names::RF).filter(|round| *round > 0.0 && control.bit("_CHBIT[2]")) {
        found.extend(feed(control, names::RF.as_str(), round).map(|one| one.at(names::RF)));
    }
}

/// What is said of a datum of the machine that is a feed at which the probe touches, mm/min in every system of units
/// or in that of the control.
pub fn of_datum(control: &Control, name: &str, metric: bool) -> Option<Diagnostic> {
    let factor = if metric { 1.0 } else { control.basic_factor() };
    told(control, name, control.number(name) * factor, factor)
}

/// Feed of a first, fast touch.
const FAST: &str = "_SPEED[3]";

/// What is said of a feed in mm/min.
fn feed(control: &Control, name: &str, feed: f64) -> Option<Diagnostic> {
    told(control, name, feed, control.basic_factor())
}

/// What is said of a feed in mm/min, in the unit that is so many mm/min.
fn told(control: &Control, name: &str, feed: f64, factor: f64) -> Option<Diagnostic> {
    let told = control.deflection_at(feed).filter(|told| told.is_too_far())?;
    let (unit, step) = if factor == 1.0 { ("\u{a0}mm/min", 1.0) } else { ("\u{a0}inch/min", 10.0) };
    let largest = (told.largest / factor * step).floor() / step;
    let thousandths = |value: f64| (value * 1000.0).round() / 1000.0;
    let finding = own::BRAKING.finding().text("name", name).number("feed", thousandths(feed / factor));
    let finding = finding.number("path", told.told()).number("deflection", told.permitted);
    Some(finding.text("unit", unit).hint_text("name", name).hint_number("largest", largest).hint_text("unit", unit))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::catalogue;
    use crate::check::check;
    use crate::control::{Units, delivery_in};
    use crate::dialect::Dialect;
    use crate::entry::{Cycle, Typed};
    use crate::own;

    /// Keys of the arguments that name the feeds which are told.
    fn told(cycle: &'static Cycle, values: &[(&str, &str)], data: &[(&str, f64)], deflection: f64) -> Vec<String> {
        let mut control = delivery_in(Dialect::Sinumerik, Units::Metric);
        // the machine of the manual's example (B:1184-1187)
        let axis = [("MD10050", 0.004), ("MD10070", 4.0), ("MD32300", 1.0), ("MD32200", 1.0)];
        axis.iter().chain(data).for_each(|(name, value)| control.set(*name, *value));
        control.deflection = Some(deflection);
        let typed: Typed = values.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        let found = check(cycle, &typed, &control).diagnostics.into_iter();
        let ours = found.filter(|one| one.code == own::BRAKING.code());
        ours.map(|one| format!("{:?} {:?}", one.message.args, one.hint.map(|hint| hint.args))).collect()
    }

    #[test]
    fn a_feed_beyond_the_deflection_is_told() {
        // oracle: hand (with the example's axis 300 mm/min need 0.3925 mm, 378.9 mm/min need 0.5 mm)
        let cycle = catalogue::find(Dialect::Sinumerik, "CYCLE978").unwrap();
        let call = |feed: &'static str, path: &'static str| {
            vec![("_MVAR", "100"), ("_SETVAL", "10"), ("_MA", "1"), ("_FA", path), ("_VMS", feed)]
        };
        assert_eq!(told(cycle, &call("0", "2"), &[], 0.4).len(), 0);
        let far = told(cycle, &call("0", "2"), &[], 0.39);
        assert!(far.len() == 1 && far[0].contains("0.393") && far[0].contains("300"), "{far:?}");
        assert_eq!(told(cycle, &call("0", "1"), &[], 0.39).len(), 0); // 150 mm/min
        assert_eq!(told(cycle, &call("378", "2"), &[], 0.5).len(), 0);
        let far = told(cycle, &call("380", "2"), &[], 0.5);
        assert!(far.len() == 1 && far[0].contains("378"), "{far:?}");
        // the first touch is as fast as _SPEED[3] says (0.9 mm/min of 900: 1.2525 mm)
        let fast = [("_CHBIT[17]", 1.0), ("_SPEED[3]", 900.0)];
        let far = told(cycle, &call("0", "2"), &fast, 0.5);
        assert!(far.len() == 1 && far[0].contains("_SPEED[3]") && far[0].contains("1.253"), "{far:?}");
    }

    #[test]
    fn without_what_the_machine_says_nothing_is_told() {
        // oracle: hand
        let cycle = catalogue::find(Dialect::Sinumerik, "CYCLE978").unwrap();
        let call = [("_MVAR", "100"), ("_SETVAL", "10"), ("_MA", "1"), ("_FA", "2"), ("_VMS", "5000")];
        assert_eq!(told(cycle, &call, &[("MD32300", 0.0)], 0.1).len(), 0);
        assert_eq!(told(cycle, &call, &[("MD10050", 0.0)], 0.1).len(), 0);
        assert_eq!(told(cycle, &call, &[], 0.1).len(), 1);
    }
}
