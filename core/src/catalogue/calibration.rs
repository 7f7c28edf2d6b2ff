//! Checks that the cycles which calibrate a workpiece probe share (CYCLE973, CYCLE976).

use crate::catalogue::prelude::*;

/// Ball radius that a calibration positions with: that of the active tool, as the stored one is yet to be found
/// (B:5405, B:5486).
pub fn ball_radius(inputs: &Inputs, control: &Control) -> f64 {
    let active = control.active_edge().map_or(0.0, |edge| edge.radius);
    if active > 0.0 { active } else { place::ball_radius(inputs, control) }
}

/// A new value is stored between `_TZL` and `_TSA` (B:5134).
pub fn band(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    if inputs.given(names::TZL).zip(inputs.given(names::TSA)).is_some_and(|(low, high)| low >= high) {
        found.push(own::CALIBRATION_BAND.finding().at(names::TZL));
    }
}

/// No axis may be mirrored, as the data are of machine directions (B:4153-4154). The manual names no alarm.
pub fn unmirrored(control: &Control, found: &mut Vec<Diagnostic>) {
    if (0..3).any(|axis| control.mirrored(axis)) {
        found.push(own::CALIBRATION_MIRROR.finding());
    }
}

/// While the data of the probe are 0, `_TSA` has to be larger than the ball radius (B:5148, B:10263).
pub fn first(inputs: &Inputs, control: &Control, ball: f64, found: &mut Vec<Diagnostic>) {
    let index = inputs.integer(names::PRNUM) % 100 - 1;
    let never = (1..=6).all(|field| control.number(&format!("_WP[{index},{field}]")) == 0.0);
    if never && inputs.given(names::TSA).is_some_and(|area| area <= ball) {
        let finding = refused(61303, "check-first-calibration", names::TSA).number("ball", ball);
        found.push(finding.hint_number("ball", ball));
    }
}
