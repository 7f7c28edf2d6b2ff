//! G65 P9969 drawn: the rectangle from above with its lines, and below it one step over the surface from the side.
//! Sizes are drawn in proportion where they can be seen, never as they are.

use super::addresses::letter;
use crate::catalogue::nct::{axis_of, given};
use crate::catalogue::prelude::*;

/// Longer side of the drawn rectangle and shortest side, mm.
const SIDES: [f64; 2] = [64.0, 24.0];
/// Drawn lines less one.
const SPACES: f64 = 3.0;
/// Drawn deepest position, mm.
const DEEPEST: f64 = -18.0;
/// Shortest and longest part of a drawn step, mm.
const STEP: [f64; 2] = [6.0, 16.0];
/// Differences of drawn sides and of drawn steps that can be seen, mm: less makes no other picture.
const SEEN: [f64; 2] = [4.0, 1.0];
/// Feed, mm/min: no picture shows it.
const FEED: f64 = 120.0;
/// Ball radius, mm.
const BALL: f64 = 3.0;

/// Axis of the plane (0 or 1) from line to line: an empty field has the value of the example, so that a letter of the
/// call itself counts more; where none is given, the second.
fn across(inputs: &Inputs) -> usize {
    let letter = |index: usize| letter(inputs.plane.axes()[index]);
    let given = [1, 0].into_iter().filter(|index| inputs.given(letter(*index)).is_some());
    let own = |index: &usize| inputs.cycle.example().all(|(name, _)| name != letter(*index));
    given.clone().find(own).or(given.clone().next()).unwrap_or(1)
}

/// Sides of the drawn rectangle along the axes of the plane, mm.
fn sides(inputs: &Inputs) -> [f64; 2] {
    let ends = [0, 1].map(|index| given(inputs, index).unwrap_or(0.0).abs().max(1e-6));
    ends.map(|end| rounded(end / ends[0].max(ends[1]) * SIDES[0], SEEN[0]).max(SIDES[1]))
}

/// Drawn distance of the points and way up before the next one, mm.
fn step(inputs: &Inputs) -> [f64; 2] {
    let sizes = [address::R, address::Q].map(|name| inputs.given(name).unwrap_or(1.0).abs().max(1e-9));
    sizes.map(|size| rounded(size / sizes[0].max(sizes[1]) * STEP[1], SEEN[1]).max(STEP[0]))
}

fn rounded(length: f64, to: f64) -> f64 {
    (length / to).round() * to
}

/// The scan of a rectangle that begins at the zero.
pub fn stage(inputs: &Inputs) -> Staging {
    let (across, sides, [raster, retract]) = (across(inputs), sides(inputs), step(inputs));
    let letter = |index: usize| letter(inputs.plane.axes()[index]);
    let fields = Fields { path: Some(address::F), edges: &[], ..Fields::MACRO };
    let above = Look { flat: true, balls: false, called: false, ..Look::ABOVE }.ways(address::F);
    let beside = Look { below: true, ..Look::section(1 - across) }.ways(address::F).touching(0b11);
    Staging { all_ways: true, left_out: vec![letter(1 - across)], ..Staging::new(above, fields) }
        .ball(BALL)
        .with(axis_of(inputs, 0), sides[0])
        .with(axis_of(inputs, 1), sides[1])
        .with(axis_of(inputs, 2), DEEPEST)
        .with(letter(across), sides[across] / SPACES)
        .with(address::R, raster)
        .with(address::Q, retract)
        .with(address::F, FEED)
        .beside(true, Look { flat: true, balls: false, called: false, ..beside })
}

/// Sides, distance of the lines, deepest position, and the parts of a step.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, beside] = looks else { return Vec::new() };
    let (across, sides, [_, retract]) = (across(inputs), sides(inputs), step(inputs));
    let end = add(above.zero, sides);
    let [low, high] = above.extent;
    let next = add(above.zero, sides.map(|side| side / SPACES));
    let letter = |index: usize| letter(inputs.plane.axes()[index]);
    let space = above.along(letter(across), across, [above.zero, next], high[1 - across] + 8.0);
    let mut shapes = vec![
        circle(ShapeKind::Probe, above.zero, BALL),
        above.along(axis_of(inputs, 0), 0, [above.zero, end], low[1] - 8.0),
        above.along(axis_of(inputs, 1), 1, [above.zero, end], low[0] - 8.0),
        PictureShape { also: vec![letter(1 - across)], ..space },
    ];
    let deepest = add(beside.zero, [0.0, DEEPEST]);
    let [low, high] = [beside.extent[0][0] - 4.0, beside.extent[1][0] + 4.0];
    shapes.push(line(ShapeKind::Axis, vec![[low, deepest[1]], [high, deepest[1]]]).of(axis_of(inputs, 2)));
    shapes.push(beside.along(axis_of(inputs, 2), 1, [beside.zero, deepest], high + 2.0));
    if let [first, second] = &beside.touches[..] {
        let top = add(first.ball, [0.0, retract]);
        shapes.push(circle(ShapeKind::Probe, first.ball, BALL));
        shapes.push(beside.along(address::Q, 1, [first.ball, top], first.ball[0] - 7.0));
        shapes.push(dimension(address::R, [first.ball[0], top[1] + 5.0], [second.ball[0], top[1] + 5.0]));
    }
    shapes
}
