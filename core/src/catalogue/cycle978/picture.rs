//! CYCLE978 drawn: from above for the axes of the plane, as a section for the applicate.

use super::params::{DIFFERENTIAL, TOOL};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, Seen, Staging};
use crate::picture::figures::circle;

/// From the zero point to the surface, mm.
const SET: f64 = 50.0;

/// The surface on its side of the zero point.
pub fn stage(inputs: &Inputs) -> Staging {
    let look = if inputs.integer(names::MA) == 3 { Look::section(0) } else { Look::ABOVE };
    let set = SET.copysign(inputs.number(names::SETVAL));
    let plain = DIFFERENTIAL.holds(inputs).then_some(inputs.variant - 1000);
    let stage = Staging { variant: plain, ..Staging::new(look, Fields::CYCLE) };
    stage.with(names::SETVAL, set).ball(3.0).short(inputs, names::FA, [8.0, 24.0])
}

/// Set position, measuring path and limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen, ..] = looks else { return Vec::new() };
    let axis = usize::from(inputs.integer(names::MA) != 1);
    let mut shapes = seen.limits(inputs, None);
    shapes.extend(seen.measuring_axis(names::MA, axis));
    shapes.extend(seen.position(names::SETVAL, axis, (!TOOL.holds(inputs)).then_some(names::KNUM)));
    shapes.extend(seen.path(names::FA, 0, 2.5));
    if DIFFERENTIAL.holds(inputs) {
        shapes.push(circle(ShapeKind::Axis, seen.start, seen.ball * 1.8).text("180°/0°").of(names::MVAR));
    }
    shapes
}
