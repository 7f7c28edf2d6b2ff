//! What several values of CYCLE994 say together.

use super::params::{INSIDE_ZONE, zone};
use crate::catalogue::lathe;
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::diagnostic::Severity;

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
    if INSIDE_ZONE.holds(inputs) {
        if shared_checks::fits(names::SETVAL, 2.0 * set / per, ball, found) {
            inside(inputs, set, per * ball, found);
        }
    } else {
        either(inputs, set, per * ball, found);
    }
}

/// Without calibration the stored ball diameter counts alone (B:10901-10906).
fn ball_diameter(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let name = format!("_WP[{},0]", inputs.integer(names::PRNUM) % 100 - 1);
    if control.bit("_CHBIT[7]") && control.number(&name) <= 0.0 {
        found.push(own::TWO_BALL.finding().text("name", &name).hint_text("name", name).at(names::PRNUM));
    }
}

/// The zone in the direction of the measuring axis, where it is given.
fn across(inputs: &Inputs) -> Option<(Name, f64)> {
    let [name, _] = zone(inputs.integer(names::MA) == 1);
    Some((name, inputs.given(name)?))
}

/// The ball's centre passes on the border of the zone (B:10891), inside the measured element; `ball` is its radius as
/// the setpoint counts.
fn inside(inputs: &Inputs, set: f64, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some((name, zone)) = across(inputs) else { return };
    let limit = set - ball;
    if zone.abs() > limit {
        let finding = refused(61334, "check-two-zone-inside", name).number("zone", zone).number("size", set);
        found.push(finding.hint_number("limit", limit));
    }
}

/// Outside the way goes around the zone, inside it has none; the start position alone tells which it is (B:10933).
fn either(inputs: &Inputs, set: f64, ball: f64, found: &mut Vec<Diagnostic>) {
    let given = |name| inputs.given(name).is_some();
    let half = |missing: Name| own::TWO_HALF_ZONE.finding().text("name", missing).at(missing);
    found.extend(match (given(names::SZA), given(names::SZO)) {
        (true, true) => None,
        (false, false) => Some(own::TWO_NO_ZONE.finding()),
        (true, false) => Some(half(names::SZO)),
        (false, true) => Some(half(names::SZA)),
    });
    let Some((name, zone)) = across(inputs) else { return };
    let limit = set + ball;
    if zone.abs() < limit {
        let finding = refused(61334, "check-two-zone-outside", name).number("zone", zone).number("size", set);
        found.push(Diagnostic { severity: Severity::Warning, ..finding.hint_number("limit", limit) });
    }
}
