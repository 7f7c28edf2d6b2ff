//! CYCLE979 drawn: the element from above with its points at their angles, beside it a section with the way over a web.

use super::params::{FOUR_POINTS, ROUND, TOOL, WEB};
use crate::catalogue::circle;
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, SIZE, Seen, Staging, add};
use crate::picture::figures::{dimension, line, polar};

/// From the zero point to the set centre in both axes, mm.
const CENTRE: f64 = 1.05 * SIZE;
/// Way up over a web, mm.
const LIFT: f64 = 0.4 * SIZE;

/// The element at its angle.
pub fn stage(inputs: &Inputs) -> Staging {
    let start = inputs.degrees(names::STA1).within_turn().0;
    let [x, y] = polar(start, 1.0);
    let section = Look { right: [x, y, 0.0], ..Look::section(0).ways(names::ID) };
    Staging::new(Look::ABOVE, Fields { mark: Some("P"), ..Fields::CYCLE })
        .sized(inputs, &[names::SETVAL])
        .short(inputs, names::FA, [0.1 * SIZE, 0.25 * SIZE])
        .with(names::CPA, CENTRE)
        .with(names::CPO, CENTRE)
        .with(names::STA1, start)
        .angle(inputs, names::INCA)
        .with(names::RF, 1000.0)
        .with(names::ID, LIFT)
        .beside(WEB.holds(inputs), section)
}

/// Set centre, angles, size and limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, beside @ ..] = looks else { return Vec::new() };
    let (tool, round) = (TOOL.holds(inputs), ROUND.holds(inputs));
    let middle = add(above.zero, [CENTRE; 2]);
    let start = inputs.degrees(names::STA1).within_turn().0;
    let mut shapes = above.limits(inputs, (!tool).then_some(middle));
    shapes.extend(above.centre(middle, [names::CPA, names::CPO], (!tool).then_some(names::KNUM)));
    let reach = 0.85 * SIZE;
    let ends = [start + if round { 0.0 } else { 180.0 }, start].map(|angle| add(middle, polar(angle, reach)));
    let from = if round { middle } else { ends[0] };
    shapes.push(line(ShapeKind::Axis, vec![from, ends[1]]).of(names::STA1));
    shapes.extend(above.angle(names::STA1, middle, reach, [0.0, start]));
    if round {
        let step = inputs.degrees(names::INCA).within_turn();
        if let [first, second, ..] = circle::points(Degrees(start), step, FOUR_POINTS.holds(inputs))[..] {
            shapes.extend(above.angle(names::INCA, middle, 0.2 * SIZE, [first.0, second.0]));
        }
        shapes.push(above.size(names::SETVAL, 0));
    } else {
        let aside = polar(start - 90.0, 0.45 * SIZE);
        shapes.extend(above.between(names::SETVAL, [1, 0], aside));
    }
    shapes.extend(above.path(names::FA, 0, 1.8));
    for section in beside {
        let at = section.extent[1][0] + 1.5 * section.ball;
        let level = section.touches.first().map(|touch| touch.start[1]);
        shapes.extend(level.map(|level| dimension(names::ID, [at, level], [at, level + LIFT])));
    }
    shapes
}
