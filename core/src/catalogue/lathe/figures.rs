//! What the pictures of turned parts share: abscissa (G18: Z) to the right, ordinate (X) up, one size for all parts.

use super::params::DIAMETER;
use crate::catalogue::prelude::*;

/// Ball radius, mm.
pub const BALL: f64 = 3.5;
/// Radius of a drawn part, mm.
pub const RADIUS: f64 = 32.0;

/// The measuring axis: 0 abscissa, 1 ordinate, 2 applicate.
pub fn axis(inputs: &Inputs) -> usize {
    inputs.integer(names::MA).clamp(1, 3) as usize - 1
}

/// How many times a distance from the axis of rotation a value of the measuring axis is.
pub fn per(inputs: &Inputs) -> f64 {
    if DIAMETER.holds(inputs) { 2.0 } else { 1.0 }
}

/// The call with a measuring path that can be seen.
pub fn stage(inputs: &Inputs, look: Look) -> Staging {
    Staging::new(look, Fields::CYCLE).ball(BALL).short(inputs, names::FA, [8.0, 14.0])
}

/// The setpoint along an axis of the paper from zero, a diameter from the other side of it; at `at` of the other axis.
pub fn set(inputs: &Inputs, seen: &Seen, axis: usize, at: f64) -> Option<PictureShape> {
    let to = seen.touches.first()?.at;
    let other = [0, 1].map(|axis| 2.0 * seen.zero[axis] - to[axis]);
    let from = if DIAMETER.holds(inputs) { other } else { seen.zero };
    Some(seen.along(names::SETVAL, axis, [from, to], at))
}

/// Stylus and body of a probe whose ball is here, as the cutting edge position of the one in use says; where none is in
/// use, as that of position 7.
pub fn probe(inputs: &Inputs, ball: [f64; 2]) -> [PictureShape; 2] {
    stylus(ball, inputs.body.unwrap_or([1.0, 0.0]))
}

/// The same; `back`: direction from the ball to the body, of length 1.
pub fn stylus(ball: [f64; 2], back: [f64; 2]) -> [PictureShape; 2] {
    let along = |distance: f64| [ball[0] + back[0] * distance, ball[1] + back[1] * distance];
    let size = [6.0 + 6.0 * back[0].abs(), 6.0 + 6.0 * back[1].abs()];
    [
        line(ShapeKind::Probe, vec![along(BALL), along(18.0)]).of(names::PRNUM),
        rectangle(ShapeKind::Probe, along(24.0), size).of(names::PRNUM),
    ]
}

/// A dimension that stands for no parameter of its own.
pub fn named(text: &str, from: [f64; 2], to: [f64; 2]) -> PictureShape {
    dimension(names::MVAR, from, to).text(text)
}
