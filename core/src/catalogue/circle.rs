//! Points that lie on a circle, and checks for them, at a starting angle and steps of an indexing angle: CYCLE979, CYCLE997.

use super::{names, shared_checks};
use crate::check::{Inputs, error};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;
use crate::own;

/// The probe must have been calibrated with its ball diameter (B:6873, B:8221).
pub fn ball_known(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let probe_wrong = found.iter().any(|one| one.param == Some(names::PRNUM));
    let Some(code) = inputs.given(names::PRNUM).filter(|_| !probe_wrong) else {
        return;
    };
    let index = code as i64 % 100 - 1;
    if control.number(&format!("_WP[{index},0]")) == 0.0 {
        found.push(own::BALL_UNKNOWN.finding().at(names::PRNUM));
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
        own::ANGLES_SUM.finding().number("sum", sum)
    } else if step.abs() > useful {
        let finding = own::ANGLES_WIDE.finding();
        let finding = finding.number("points", f64::from(points));
        let finding = finding.number("useful", useful);
        let finding = finding.hint_number("points", f64::from(points));
        finding.hint_number("useful", useful)
    } else {
        found.extend(narrow(step, four));
        return;
    };
    found.push(finding.at(names::INCA));
}

/// Points close together: how far an error of one of them moves the centre along the middle of the arc.
fn narrow(step: f64, four: bool) -> Option<Diagnostic> {
    let cosine = |part: f64| (part * step).to_radians().cos();
    let between = match four {
        true => cosine(0.5) - cosine(1.5),
        false => 1.0 - cosine(1.0),
    };
    shared_checks::enlarged(own::ENLARGED, 2.0 / between.abs(), names::INCA)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::fit;
    use crate::message::Arg;

    /// How far the centre of a circle of radius 20 moves, in parts of what its points are off: those in the middle of the
    /// arc outwards, those at its ends inwards.
    fn moved(step: f64, four: bool) -> f64 {
        let directions = points(30.0, step, four);
        let off = 1e-7;
        let ends = [0, directions.len() - 1];
        let measured: Vec<[f64; 2]> = directions
            .iter()
            .enumerate()
            .map(|(index, angle)| (if ends.contains(&index) { -off } else { off }, angle))
            .map(|(off, angle)| (20.0 + off, angle.to_radians().sin_cos()))
            .map(|(radius, (sine, cosine))| [radius * cosine, radius * sine])
            .collect();
        let ([x, y], _) = fit::circle(&measured).unwrap();
        x.hypot(y) / off
    }

    // oracle: peer (the fit itself, of points that are off), hand (16.26 and 11.49 degree: the cosines of DESIGN.md)
    #[test]
    fn points_close_together_are_doubted_with_what_they_do() {
        for (four, limit) in [(false, 16.26), (true, 11.49)] {
            for step in [2.0, -7.5, 10.0, 14.0, 20.0, 60.0] {
                let found = narrow(step, four);
                assert_eq!(found.is_some(), f64::abs(step) < limit, "{step}");
                let Some(found) = found else { continue };
                let [(_, Arg::Number(told))] = found.message.args[..] else {
                    unreachable!()
                };
                assert!(
                    (told / moved(step, four) - 1.0).abs() < 0.01,
                    "{step} {told}"
                );
            }
        }
    }
}
