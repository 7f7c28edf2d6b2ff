//! What several values of CYCLE977 say together.

use super::params::{OUTSIDE, RECTANGLE, ZONE};
use crate::catalogue::prelude::*;
use crate::check::error;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::measuring(inputs, control, found);
    shared_checks::infeed(inputs, control, found);
    let ball = place::ball_radius(inputs, control);
    let sizes: &[(Name, Name)] = match RECTANGLE.holds(inputs) {
        true => &[(names::SETV0, names::SZA), (names::SETV1, names::SZO)],
        false => &[(names::SETVAL, names::SZA)],
    };
    for (size, zone) in sizes {
        room(inputs, *size, *zone, ball, found);
    }
}

/// Whether ball, measuring path and protection zone find room in the direction of a size (B:5801-5809, B:5943-5951).
fn room(inputs: &Inputs, name: Name, zone: Name, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(size) = inputs.given(name) else { return };
    let inside = !OUTSIDE.holds(inputs);
    if inside && !shared_checks::fits(name, size, ball, found) {
        return;
    }
    match inputs.given(zone).filter(|_| ZONE.holds(inputs)) {
        Some(width) => found.extend(beside_zone(inputs, size, (zone, width), ball)),
        None if inside => shared_checks::across(inputs, name, size, ball, found),
        None => {}
    }
}

/// Beside a zone the path is shortened until the ball fits; where it cannot, the cycle stops with 61334.
fn beside_zone(inputs: &Inputs, size: f64, (name, zone): (Name, f64), ball: f64) -> Option<Diagnostic> {
    let (out, wrong, mut hint) = match OUTSIDE.holds(inputs) {
        true => (-1.0, "check-zone-narrow", "check-zone-narrow-hint"),
        false => (1.0, "check-zone-wide", "check-zone-wide-hint"),
    };
    let gap = out * (size - zone);
    let free = gap / 2.0 - 2.0 * ball;
    if free > 0.0 {
        let shortened = inputs.given(names::FA).is_some_and(|path| path > free);
        return shortened.then(|| own::ZONE_SHORTENS.finding().number("free", free).at(names::FA));
    }
    let key = if gap > 0.0 { "check-zone-ball" } else { wrong };
    let message = Message::new(key).number("zone", zone).number("size", size).number("ball", 2.0 * ball);
    // the largest zone inside, the smallest one outside
    let limit = size - out * 4.0 * ball;
    if limit <= 0.0 {
        hint = "check-zone-none-hint";
    }
    Some(error(Code::Alarm(61334), message).hint(Message::new(hint).number("limit", limit)).at(name))
}
