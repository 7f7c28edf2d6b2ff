//! Points that lie on a circle, and checks for them, at a starting angle and steps of an indexing angle: CYCLE979,
//! CYCLE997.

use crate::catalogue::prelude::*;
use crate::diagnostic::Severity;
use crate::evaluate::spread::{Circle, circle};

/// The probe must have been calibrated with its ball diameter (B:6873, B:8221).
pub fn ball_known(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let probe_wrong = found.iter().any(|one| one.param == Some(names::PRNUM));
    let Some(code) = inputs.given(names::PRNUM).filter(|_| !probe_wrong) else { return };
    let index = code as i64 % 100 - 1;
    if control.number(&format!("_WP[{index},0]")) == 0.0 {
        found.push(own::BALL_UNKNOWN.finding().at(names::PRNUM));
    }
}

/// Directions from the centre to three or four points in their order.
pub fn points(start: Degrees, step: Degrees, four: bool) -> Vec<Degrees> {
    let count = if four { 4 } else { 3 };
    (0..count).map(|index| start + step * f64::from(index)).collect()
}

/// How uncertain the circle through them is; none where their place is not known or told to be wrong.
pub fn spread(inputs: &Inputs, four: bool, found: &[Diagnostic]) -> Option<Circle> {
    let (start, step) = (inputs.given(names::STA1)?, inputs.given(names::INCA)?);
    let wrong = |one: &Diagnostic| one.param == Some(names::INCA) && one.severity == Severity::Error;
    (!found.iter().any(wrong)).then(|| circle(&points(Degrees(start), Degrees(step), four))).flatten()
}

/// Where three or four points lie: not upon each other, and within one turn (B:6850, B:6986, B:8471).
pub fn angles(inputs: &Inputs, four: bool, found: &mut Vec<Diagnostic>) {
    let (Some(start), Some(step)) = (inputs.given(names::STA1), inputs.given(names::INCA)) else { return };
    let (points, useful) = if four { (4, 90.0) } else { (3, 120.0) };
    let sum = start.abs() + f64::from(points - 1) * step.abs();
    let same = step % 180.0 == 0.0; // every second point, or all of them
    let finding = if same {
        refused(61316, "check-angles-same", names::INCA)
    } else if sum > 360.0 {
        own::ANGLES_SUM.finding().number("sum", sum)
    } else if step.abs() > useful {
        let finding = own::ANGLES_WIDE.finding().number("points", f64::from(points)).number("useful", useful);
        finding.hint_number("points", f64::from(points)).hint_number("useful", useful)
    } else {
        return;
    };
    found.push(finding.at(names::INCA));
}
