//! Points that lie on a circle, and checks for them, at a starting angle and steps of an indexing angle: CYCLE979, CYCLE997.

use super::names;
use crate::check::{Finding, Inputs, error, warning};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;

/// The probe must have been calibrated with its ball diameter (B:6873, B:8221).
pub fn ball_known(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let probe_wrong = found.iter().any(|one| one.param == Some(names::PRNUM));
    let Some(code) = inputs.given(names::PRNUM).filter(|_| !probe_wrong) else {
        return;
    };
    let index = code as i64 % 100 - 1;
    if control.number(&format!("_WP[{index},0]")) == 0.0 {
        found.push(
            warning(Code::Own(51), Message::new("check-ball-unknown"))
                .hint(Message::new("check-ball-unknown-hint"))
                .at(names::PRNUM),
        );
    }
}

/// Directions from the centre to three or four points in their order, degree.
pub fn points(start: f64, step: f64, four: bool) -> Vec<f64> {
    let count = if four { 4 } else { 3 };
    (0..count)
        .map(|index| start + f64::from(index) * step)
        .collect()
}

/// Where three or four points lie: not upon each other, and within one turn (B:6850, B:6986, B:8471).
pub fn angles(inputs: &Inputs, four: bool, found: &mut Vec<Diagnostic>) {
    let (Some(start), Some(step)) = (inputs.given(names::STA1), inputs.given(names::INCA)) else {
        return;
    };
    let (points, useful) = if four { (4, 90.0) } else { (3, 120.0) };
    let sum = start.abs() + f64::from(points - 1) * step.abs();
    let same = step % 180.0 == 0.0; // every second point, or all of them
    let finding = if same {
        error(Code::Alarm(61316), Message::new("check-angles-same"))
            .hint(Message::new("check-angles-same-hint"))
    } else if sum > 360.0 {
        error(
            Code::Own(52),
            Message::new("check-angles-sum").number("sum", sum),
        )
        .hint(Message::new("check-angles-sum-hint"))
    } else if step.abs() > useful {
        let with = |key| {
            Message::new(key)
                .number("points", f64::from(points))
                .number("useful", useful)
        };
        warning(Code::Own(53), with("check-angles-wide")).hint(with("check-angles-wide-hint"))
    } else {
        return;
    };
    found.push(finding.at(names::INCA));
}
