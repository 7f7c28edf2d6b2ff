//! CYCLE974 drawn: the turned part from the side for the axes of the plane, from its end for the applicate; with
//! reversal its end is drawn beside it.

use super::params::REVERSAL;
use crate::catalogue::common::ZERO_OFFSET;
use crate::catalogue::lathe::figures;
use crate::catalogue::lathe::figures::{RADIUS, axis, per};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Look, Seen, Staging, add};
use crate::picture::figures::{arc, arrow, circle, line, polar, turn};

/// From the zero point to an end face, mm.
const FACE: f64 = 40.0;

/// The part on the side of the setpoint.
pub fn stage(inputs: &Inputs) -> Staging {
    let look = match axis(inputs) {
        2 => Look { cut: false, ..Look::section(1) },
        _ => Look { held: true, ..Look::ABOVE },
    };
    let set = if axis(inputs) == 0 { FACE } else { RADIUS * per(inputs) };
    figures::stage(inputs, look).with(names::SETVAL, set.copysign(inputs.number(names::SETVAL)))
}

/// Setpoint, limits, what is moved and turned.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen] = looks else { return Vec::new() };
    let paper = usize::from(axis(inputs) != 0);
    let [low, high] = seen.extent;
    let mut shapes = seen.limits(inputs, None);
    shapes.extend(seen.axes(seen.zero, [None; 2]));
    shapes.extend(seen.measuring_axis(names::MA, paper));
    shapes.extend(seen.path(names::FA, 0, 2.5));
    shapes.extend(figures::set(inputs, seen, paper, [low[1] + 8.0, high[0] - 8.0][paper]));
    if ZERO_OFFSET.holds(inputs) {
        let mut tip = seen.zero;
        tip[paper] += 14.0;
        shapes.push(circle(ShapeKind::Axis, seen.zero, 2.4).of(names::KNUM));
        shapes.push(arrow(ShapeKind::Axis, seen.zero, tip, 4.0).of(names::KNUM));
    }
    if REVERSAL.holds(inputs) {
        shapes.extend(reversal(inputs, [high[0] + 36.0 + 1.45 * RADIUS, seen.zero[1]]));
    }
    if let Some(touch) = seen.touches.first().filter(|_| axis(inputs) != 2) {
        shapes.extend(figures::probe(inputs, touch.start));
    }
    shapes
}

/// The end of the part: both points, the turn between them, and how far it is turned for the first one. Of its own, as
/// the probe stays where it is and the part turns.
fn reversal(inputs: &Inputs, centre @ [x, y]: [f64; 2]) -> Vec<PictureShape> {
    let angle = inputs.degrees(names::STA1).positive().0;
    let at = |radius: f64| add(centre, polar(90.0 + angle, radius));
    let point = |number: &str, end: f64| {
        circle(ShapeKind::Touch, [x, y + end * RADIUS], 0.3 * figures::BALL).text(number).of(names::NMSP)
    };
    let mut shapes = vec![
        circle(ShapeKind::Material, centre, RADIUS),
        line(ShapeKind::Axis, vec![[x, y - 27.0], [x, y + 27.0]]),
        line(ShapeKind::Axis, vec![centre, at(RADIUS)]).of(names::STA1),
        line(ShapeKind::Axis, arc(centre, 9.0, 90.0, 90.0 + angle)).of(names::STA1),
        line(ShapeKind::Label, vec![at(RADIUS * 0.6)]).text(names::STA1).of(names::STA1),
        point("1", 1.0),
        point("2", -1.0),
        line(ShapeKind::Label, vec![[x - RADIUS * 1.45, y]]).text("180°").of(names::MVAR),
    ];
    shapes.extend(turn(names::MVAR, centre, RADIUS * 1.2, [110.0, 250.0], 4.0));
    shapes
}
