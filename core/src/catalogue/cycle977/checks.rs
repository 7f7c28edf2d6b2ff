//! What several values of CYCLE977 say together.

use super::params::{OUTSIDE, RECTANGLE, ZONE};
use crate::catalogue::prelude::*;
use crate::check::error;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::measuring(inputs, control, found);
    shared_checks::infeed(inputs, control, found);
    let ball = place::ball_radius(inputs, control);
    for size in sizes(inputs) {
        room(inputs, &size, ball, found);
    }
}

/// One measured size with the protection zone in its direction, mm.
struct Size {
    name: Name,
    size: f64,
    zone: Option<(Name, f64)>,
}

fn sizes(inputs: &Inputs) -> Vec<Size> {
    let pairs = if RECTANGLE.holds(inputs) {
        vec![(names::SETV0, names::SZA), (names::SETV1, names::SZO)]
    } else {
        vec![(names::SETVAL, names::SZA)]
    };
    let zone = |name| inputs.given(name).filter(|_| ZONE.holds(inputs)).map(|zone| (name, zone));
    pairs
        .into_iter()
        .filter_map(|(name, other)| Some(Size { name, size: inputs.given(name)?, zone: zone(other) }))
        .collect()
}

/// Whether ball, measuring path and protection zone find room (B:5801-5809, B:5943-5951).
fn room(inputs: &Inputs, size: &Size, ball: f64, found: &mut Vec<Diagnostic>) {
    let outside = OUTSIDE.holds(inputs);
    if !outside && !shared_checks::fits(size.name, size.size, ball, found) {
        return;
    }
    match size.zone {
        Some((name, zone)) => beside_zone(inputs, (name, zone), size.size, ball, outside, found),
        None if !outside => shared_checks::across(inputs, size.name, size.size, ball, found),
        None => {}
    }
}

/// Beside a zone the path is shortened until the ball fits; where it cannot, the cycle stops with 61334.
fn beside_zone(
    inputs: &Inputs,
    (name, zone): (Name, f64),
    size: f64,
    ball: f64,
    outside: bool,
    found: &mut Vec<Diagnostic>,
) {
    let gap = if outside { zone - size } else { size - zone };
    let free = gap / 2.0 - 2.0 * ball;
    let alarm = |key: &'static str, hint: &'static str| {
        let message = Message::new(key).number("zone", zone).number("size", size).number("ball", 2.0 * ball);
        error(Code::Alarm(61334), message).hint(Message::new(hint).number("limit", limit(size, ball, outside))).at(name)
    };
    let finding = match (gap <= 0.0, free <= 0.0, outside) {
        (true, _, false) => alarm("check-zone-wide", "check-zone-wide-hint"),
        (true, _, true) => alarm("check-zone-narrow", "check-zone-narrow-hint"),
        (_, true, false) => alarm("check-zone-ball", "check-zone-wide-hint"),
        (_, true, true) => alarm("check-zone-ball", "check-zone-narrow-hint"),
        _ if inputs.given(names::FA).is_some_and(|path| path > free) => {
            own::ZONE_SHORTENS.finding().number("free", free).at(names::FA)
        }
        _ => return,
    };
    found.push(finding);
}

/// Largest zone inside, smallest zone outside.
fn limit(size: f64, ball: f64, outside: bool) -> f64 {
    if outside { size + 4.0 * ball } else { size - 4.0 * ball }
}
