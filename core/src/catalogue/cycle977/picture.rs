//! CYCLE977 drawn: the element from above, and beside it the section with the infeed where there is one.

use super::element::Element;
use super::params::{OUTSIDE, RECTANGLE, TOOL, WIDTH, ZONE};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, SIZE, Seen, Staging};

/// From the start height to the measuring height, mm.
const INFEED: f64 = -32.0;

/// The element, its zone no nearer to the walls than ball and way need.
pub fn stage(inputs: &Inputs) -> Staging {
    let (outside, zone) = (OUTSIDE.holds(inputs), ZONE.holds(inputs));
    let (sizes, edges): (&[_], &[_]) = match RECTANGLE.holds(inputs) {
        true => (&[names::SETV0, names::SETV1], &[names::SETV0, names::SETV0, names::SETV1]),
        false => (&[names::SETVAL], &[names::SETVAL]),
    };
    let section = Look::section(Element::of(inputs).axes[0]).ways(names::ID).touching(1);
    let stage = Staging::new(Look::ABOVE, Fields { edges, beyond: outside, ..Fields::CYCLE })
        .sized(inputs, sizes)
        .short(inputs, names::FA, if zone { [0.06 * SIZE; 2] } else { [0.1 * SIZE, 0.25 * SIZE] })
        .with(names::ID, INFEED)
        .beside(outside || zone, section);
    [names::SZA, names::SZO].into_iter().zip(sizes.iter().cycle()).fold(stage, |stage, (name, size)| {
        let (size, zone) = (stage.value(*size), inputs.number(name) * stage.scale);
        let most = if outside { 2.0 * size } else { size - 0.32 * SIZE };
        stage.with(name, zone.clamp(if outside { size + 0.32 * SIZE } else { 0.2 * most }, most))
    })
}

/// Sizes, infeed and limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, beside @ ..] = looks else { return Vec::new() };
    let (tool, first) = (TOOL.holds(inputs), Element::of(inputs).axes[0]);
    let mut shapes: Vec<PictureShape> = above.limits(inputs, (!tool).then_some(above.middle()));
    let fields = [0, 1].map(|axis| match (WIDTH.holds(inputs), tool) {
        (true, _) if axis == first => Some(names::MA),
        (_, false) => Some(names::KNUM),
        _ => None,
    });
    shapes.extend(above.axes(above.middle(), fields));
    match RECTANGLE.holds(inputs) {
        true => shapes.extend([above.size(names::SETV0, 0), above.size(names::SETV1, 1)]),
        false => shapes.push(above.size(names::SETVAL, first)),
    }
    for zone @ [_, high] in &above.zones {
        shapes.push(above.along(names::SZA, first, *zone, 0.4 * high[1 - first]));
        shapes.extend(RECTANGLE.holds(inputs).then(|| above.along(names::SZO, 1, *zone, 0.4 * high[0])));
    }
    shapes.extend(above.path(names::FA, 0, 2.0));
    shapes.extend(beside.iter().filter_map(|section| section.infeed(names::ID)));
    shapes
}
