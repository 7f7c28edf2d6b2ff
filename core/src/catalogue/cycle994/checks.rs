//! What several values of CYCLE994 say together.

use super::params::{INSIDE_ZONE, zone};
use crate::catalogue::lathe;
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::check::announced;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    lathe::checks::measuring(inputs, control, found);
    ball_diameter(inputs, control, found);
    let Some(set) = inputs.given(names::SETVAL) else { return };
    if set <= 0.0 {
        found.push(own::TWO_SETPOINT.finding().number("set", set).at(names::SETVAL));
        return;
    }
    let ball = place::ball_radius(inputs, control);
    let per = measure::per(control, inputs);
    let inside = INSIDE_ZONE.holds(inputs);
    if inside && !shared_checks::fits(names::SETVAL, 2.0 * set / per, ball, found) {
        return;
    }
    if !inside {
        found.extend(missing(inputs));
    }
    found.extend(border(inputs, set, per * ball));
}

/// Without calibration the stored ball diameter counts alone (B:10901-10906).
fn ball_diameter(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let name = format!("_WP[{},0]", inputs.integer(names::PRNUM) % 100 - 1);
    if control.bit("_CHBIT[7]") && control.number(&name) <= 0.0 {
        found.push(own::TWO_BALL.finding().text("name", &name).hint_text("name", name).at(names::PRNUM));
    }
}

/// Outside the way goes around the zone, inside it has none; the start position alone tells which it is (B:10933).
fn missing(inputs: &Inputs) -> Option<Diagnostic> {
    let half = |missing: Name| own::TWO_HALF_ZONE.finding().text("name", missing).at(missing);
    match (inputs.given(names::SZA), inputs.given(names::SZO)) {
        (Some(_), Some(_)) => None,
        (None, None) => Some(own::TWO_NO_ZONE.finding()),
        (Some(_), None) => Some(half(names::SZO)),
        (None, Some(_)) => Some(half(names::SZA)),
    }
}

/// The ball's centre passes on the border of the zone (B:10891), inside the measured element or, as far as the call
/// tells, outside; `ball` is its radius as the setpoint counts.
fn border(inputs: &Inputs, set: f64, ball: f64) -> Option<Diagnostic> {
    let [name, _] = zone(inputs.integer(names::MA) == 1);
    let zone = inputs.given(name)?;
    let (beyond, limit, finding) = match INSIDE_ZONE.holds(inputs) {
        true => (zone.abs() > set - ball, set - ball, refused(61334, "check-two-zone-inside", name)),
        false => (zone.abs() < set + ball, set + ball, announced(61334, "check-two-zone-outside", name)),
    };
    beyond.then(|| finding.number("zone", zone).number("size", set).hint_number("limit", limit))
}
