//! CYCLE997 drawn: the first sphere from above with its points in their order, beside it the section with the way over
//! the sphere and the last point; with three spheres their triangle beside both.

use super::params::{ANGLE, DIAMETER, REPEATED, THREE};
use super::points::{CENTRES, DIAMETER_SIDE, centres, directions};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, SIZE, Seen, Staging, add, ends};
use crate::picture::figures::{arrow, circle, dimension, line, polar, polygon};

/// From the zero point to the centre of the first sphere, mm.
const CENTRE: f64 = 1.05 * SIZE;
/// How far away the other spheres stand, so that they are not in the way, mm.
const FAR: f64 = 6.0 * SIZE;

/// The first sphere.
pub fn stage(inputs: &Inputs) -> Staging {
    let last = 1 << directions(inputs).len();
    let section = Look { below: THREE.holds(inputs), held: true, ..Look::section(0).ways(names::MVAR).touching(last) };
    let mut stage = Staging::new(Look::ABOVE.touching(last - 1), Fields { mark: Some("P"), ..Fields::CYCLE })
        .sized(inputs, &[names::SETVAL])
        .short(inputs, names::FA, [0.15 * SIZE, 0.25 * SIZE])
        .angle(inputs, names::STA1)
        .angle(inputs, names::INCA)
        .with(names::RF, 1000.0)
        .with(names::TNVL, SIZE)
        .beside(true, section);
    stage.values.extend(CENTRES.as_flattened().iter().map(|name| (*name, CENTRE)));
    stage.with(names::SETV3, FAR).with(names::SETV7, FAR)
}

/// Set centre, angles, the last points.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, section] = looks else { return Vec::new() };
    let middle = above.middle();
    let mut shapes = above.limits(inputs, Some(middle));
    shapes.push(line(ShapeKind::Touch, vec![middle]).of(names::SETV0));
    shapes.push(above.size(names::SETVAL, 0));
    if REPEATED.holds(inputs) {
        let again = add(middle, [0.05 * SIZE, 0.025 * SIZE]);
        shapes.push(circle(ShapeKind::Axis, again, 0.05 * SIZE).text("2×").of(names::MVAR));
    }
    if ANGLE.holds(inputs) {
        shapes.extend(angles(inputs, above, middle));
    }
    if DIAMETER.holds(inputs) {
        shapes.extend(diameter(above, middle));
    }
    let height = section.zero[1] + CENTRE;
    let [low, high] = section.extent;
    shapes.push(line(ShapeKind::Axis, vec![[low[0], height], [high[0], height]]).of(names::SETV2));
    shapes.extend(section.path(names::FA, 0, 2.2));
    if THREE.holds(inputs) {
        shapes.extend(triangle(inputs, add(middle, [1.8 * SIZE, -1.5 * SIZE])));
    } else {
        shapes.extend(above.centre(middle, [names::SETV0, names::SETV1], Some(names::KNUM)));
        let right = high[0] + 0.05 * SIZE;
        let ground = vec![[low[0], section.zero[1]], [right, section.zero[1]]];
        shapes.push(line(ShapeKind::Axis, ground).text("0").of(names::KNUM));
        shapes.push(dimension(names::SETV2, [right, section.zero[1]], [right, height]));
    }
    shapes
}

/// Starting angle and indexing angle.
fn angles(inputs: &Inputs, above: &Seen, middle: [f64; 2]) -> Vec<PictureShape> {
    let [first, second, ..] = directions(inputs)[..] else { return Vec::new() };
    let reach = 0.92 * SIZE;
    let mut shapes = vec![line(ShapeKind::Axis, vec![middle, add(middle, polar(first.0, reach))]).of(names::STA1)];
    shapes.extend(above.angle(names::STA1, middle, reach, [0.0, first.0]));
    shapes.extend(above.angle(names::INCA, middle, 0.2 * SIZE, [first.0, second.0]));
    shapes
}

/// The additional point for the diameter.
fn diameter(above: &Seen, middle: [f64; 2]) -> [PictureShape; 3] {
    let at = |distance: f64| add(middle, polar(DIAMETER_SIDE.0, distance));
    let [tip, start, beyond] = [0.5 * SIZE + above.ball, 0.72 * SIZE, 0.86 * SIZE].map(at);
    [
        line(ShapeKind::Path, vec![beyond, tip]).of(names::MVAR),
        arrow(ShapeKind::Path, start, tip, above.ball * 1.4).of(names::MVAR),
        line(ShapeKind::Label, vec![beyond]).text("Ø").of(names::MVAR),
    ]
}

/// The triangle of the set centres from above, at a scale of its own, with the order of the spheres. No view of the
/// work can show it: the spheres are too small beside their distances.
fn triangle(inputs: &Inputs, zero: [f64; 2]) -> Vec<PictureShape> {
    let set: Vec<[f64; 2]> = centres(inputs).into_iter().map(|[x, y, _]| [x, y]).collect();
    let places = fitted(&set, zero.map(|value| value + 0.8 * SIZE), [3.0 * SIZE, 1.6 * SIZE]);
    let mut shapes = vec![polygon(ShapeKind::Axis, places.clone()).of(names::TNVL)];
    for pair in places.windows(2) {
        shapes.push(line(ShapeKind::Path, pair.to_vec()).of(names::MVAR));
        shapes.push(arrow(ShapeKind::Path, pair[0], pair[1], 0.1 * SIZE).of(names::MVAR));
    }
    let [right, top] = add(zero, [4.2 * SIZE, 2.5 * SIZE]);
    shapes.push(line(ShapeKind::Axis, vec![zero, [right, zero[1]]]).text("0").of(names::KNUM));
    shapes.push(line(ShapeKind::Axis, vec![zero, [zero[0], top]]).of(names::KNUM));
    for (index, ([u, v], [x, y, z])) in places.into_iter().zip(CENTRES).enumerate() {
        let under = zero[1] - SIZE * (0.05 + 0.42 * (index + 1) as f64);
        shapes.push(dimension(x, [zero[0], under], [u, under]));
        shapes.push(line(ShapeKind::Axis, vec![[u, under], [u, zero[1]]]).of(x));
        shapes.push(dimension(y, [u, zero[1]], [u, v]));
        shapes.push(circle(ShapeKind::Edge, [u, v], 0.12 * SIZE).text((index + 1).to_string()).of(x));
        shapes.push(line(ShapeKind::Label, vec![[u, v + 0.3 * SIZE]]).text(z).of(z));
    }
    shapes
}

/// Points at a scale at which they fill a rectangle, given by its lower left corner and its size.
fn fitted(points: &[[f64; 2]], corner: [f64; 2], room: [f64; 2]) -> Vec<[f64; 2]> {
    let ends = ends(points);
    let scale = [0, 1].map(|axis| room[axis] / (ends[axis].1 - ends[axis].0).max(f64::MIN_POSITIVE));
    let scale = Some(scale[0].min(scale[1])).filter(|scale| scale.is_finite()).unwrap_or(0.0);
    points.iter().map(|point| [0, 1].map(|axis| corner[axis] + (point[axis] - ends[axis].0) * scale)).collect()
}
