//! CYCLE961 drawn from above: the corner with its points and the way between them, and to the right, where the height
//! matters, the way in the applicate.

use super::lines::{Point, across, along, away, direction};
use super::params::{MOVED_ABSCISSA, MOVED_ORDINATE, PASSES, PLACES, POINTS, RECTANGLE};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, SIZE, Seen, Staging, ends, unit};
use crate::picture::figures::{circle, dimension, line, polar, ray};

/// The probe is led over the corner, not around it (B:8006-8012).
const RISES: When = When::All(&[PASSES, When::Given(names::ID)]);
/// The touches in their order (B:7998, B:8166).
const ORDER: [&str; 4] = ["P2", "P1", "P3", "P4"];
/// The way up over the corner, or down to places, mm.
const HEIGHT: f64 = 40.0;
/// Half of the longest side of the drawing of places, mm, so that the shortest way reaches the edges.
const PLACED: f64 = 1.2 * SIZE;

/// The corner where the values say.
pub fn stage(inputs: &Inputs) -> Staging {
    let fields = Fields { edges: &[names::STA1, names::INCA], marks: &ORDER, at_start: true, ..Fields::CYCLE };
    let stage = Staging::new(Look::ABOVE.ways(names::MVAR), fields).ball(3.5).with(names::FA, 25.0);
    if POINTS.holds(inputs) {
        return places(inputs, stage);
    }
    let start = inputs.degrees(names::STA1).within_turn().0;
    let opening = match inputs.degrees(names::INCA).within_turn().0 {
        0.0 => 80.0,
        angle => angle.signum() * angle.abs().clamp(20.0, 160.0),
    };
    let [x, y] = unit(polar(start, 1.0), polar(start + opening, 1.0));
    let over = Look { right: [x, y, 0.0], since: 2, called: false, ..Look::section(0) }.ways(names::ID).touching(0b110);
    stage
        .sized(inputs, &[names::SETV0, names::SETV1])
        .with(names::STA1, start)
        .with(names::INCA, opening)
        .with(names::ID, if RISES.holds(inputs) { HEIGHT } else { 0.0 })
        .beside(RISES.holds(inputs), over)
}

/// The places in the size of the picture, the zero point no further beside them than there is room.
fn places(inputs: &Inputs, mut stage: Staging) -> Staging {
    let given = PLACES.map(|place| place.map(|name| inputs.number(name)));
    let ends = ends(&given);
    let size = ends.into_iter().map(|(low, high)| high - low).fold(1e-6, f64::max);
    for (names, place) in PLACES.into_iter().zip(given) {
        for (axis, name) in names.into_iter().enumerate() {
            let (low, high) = ends[axis];
            let zero = 0.0_f64.clamp(low - 0.2 * size, high + 0.2 * size);
            stage.values.push((name, (place[axis] - zero) / size * PLACED));
        }
    }
    let [p1, p2, ..] = given;
    let [x, y] = away(p1, p2);
    let down = Look::section(usize::from(x.abs() > y.abs())).ways(names::ID).touching(0b1);
    stage.with(names::ID, -HEIGHT).beside(true, down)
}

/// A corner on the paper, mm.
struct Corner {
    at: Point,
    /// Directions of the edges from there, the reference edge first; unit vectors.
    edges: [Point; 2],
    /// Where the ball stands before each touch, P1 to P4; of a rectangle the last one is not touched.
    starts: [Point; 4],
}

impl Corner {
    fn of(above: &Seen) -> Option<Corner> {
        let [first, second, ..] = &above.edges[..] else { return None };
        let at = *first.points.iter().find(|end| second.points.contains(end))?;
        let other = |edge: &PictureShape| edge.points.iter().find(|end| **end != at).copied();
        let [p2, p1, p3, ..] = above.touches[..] else { return None };
        let beyond = along(p3.start, away(above.start, p3.start), 1.0);
        let starts = [p1.start, p2.start, p3.start, above.touches.get(3).map_or(beyond, |p4| p4.start)];
        Some(Corner { at, edges: [direction(at, other(first)?), direction(at, other(second)?)], starts })
    }

    /// A coordinate of a place from the workpiece zero as a dimension that ends here, and the way from there to it.
    fn coordinate(&self, above: &Seen, index: usize, axis: usize, to: Point) -> [PictureShape; 2] {
        let field = PLACES[index][axis];
        let way = line(ShapeKind::Axis, vec![to, self.starts[index]]).of(field);
        [above.along(field, axis, [above.zero, to], to[1 - axis]), way]
    }
}

/// Directions and distances or places, the new zero point, heights.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let ([above, beside @ ..], Some(corner)) = (looks, looks.first().and_then(Corner::of)) else { return Vec::new() };
    let mut shapes =
        if POINTS.holds(inputs) { coordinates(&corner, above) } else { directions(inputs, &corner, above) };
    shapes.extend(above.path(names::FA, 0, 2.0));
    shapes.extend(zero_point(inputs, &corner, above));
    for section in beside {
        let at = section.extent[1][0] + 2.0 * section.ball;
        let low = section.touches.first().map_or(section.start, |touch| touch.start);
        shapes.push(dimension(names::ID, [at, low[1]], [at, low[1] + HEIGHT]));
    }
    shapes
}

/// Start, angles and distances.
fn directions(inputs: &Inputs, corner: &Corner, above: &Seen) -> Vec<PictureShape> {
    let angle = |[x, y]: Point| y.atan2(x).to_degrees();
    let start = inputs.degrees(names::STA1).within_turn().0;
    // which way the second edge is turned from the first: 1 counter-clockwise, -1 clockwise
    let sense = across(corner.edges[0], corner.edges[1]).signum();
    let turn = (angle(corner.edges[1]) - start).rem_euclid(360.0);
    let turn = if sense < 0.0 { turn - 360.0 } else { turn };
    let ray = |direction: Point| vec![above.start, along(above.start, direction, 1.15 * SIZE)];
    let mut shapes = vec![
        line(ShapeKind::Axis, ray([1.0, 0.0])).of(names::STA1),
        line(ShapeKind::Axis, ray(corner.edges[0])).of(names::STA1),
        line(ShapeKind::Axis, ray(corner.edges[1])).of(names::INCA),
    ];
    shapes.extend(above.angle(names::STA1, above.start, 0.3 * SIZE, [0.0, start]));
    shapes.extend(above.angle(names::INCA, above.start, 0.2 * SIZE, [start, start + turn]));
    for (name, to, side) in [(names::SETV0, 1, -1.0), (names::SETV1, 3, 1.0)] {
        let [x, y] = direction(above.start, corner.starts[to]);
        let aside = |point| along(point, [-y, x], side * sense * 5.0 * above.ball);
        shapes.push(dimension(name, aside(above.start), aside(corner.starts[to])));
    }
    shapes
}

/// The coordinates of the points from the workpiece zero. Along its line a pair has them one beside the other, outside
/// of the part, across it each at its point, so that no two are in one place.
fn coordinates(corner: &Corner, above: &Seen) -> Vec<PictureShape> {
    let [x, y] = above.zero;
    let axes = [[[x - 0.1 * SIZE, y], [x + SIZE, y]], [[x, y - 0.1 * SIZE], [x, y + 0.8 * SIZE]]];
    let mut shapes = axes.map(|axis| line(ShapeKind::Axis, axis.to_vec()).text("0")).to_vec();
    for (pair, other) in [([0, 1], [2, 3]), ([2, 3], [0, 1])] {
        let [x, y] = away(corner.starts[pair[0]], corner.starts[pair[1]]);
        let axis = usize::from(y.abs() > x.abs());
        shapes.extend(stacked(corner, above, axis, pair, other));
        for index in pair {
            let mut to = corner.starts[index];
            to[axis] += 2.5 * above.ball;
            shapes.extend(corner.coordinate(above, index, 1 - axis, to));
        }
    }
    shapes
}

/// The coordinates of a pair along its line, on the side that is turned away from the other pair: rows, or columns, of
/// which a short one stands outside of a long one, so that the text of the long one has its place above it.
fn stacked(corner: &Corner, above: &Seen, axis: usize, pair: [usize; 2], other: [usize; 2]) -> Vec<PictureShape> {
    let (across, zero) = (1 - axis, above.zero);
    let sum = |[one, two]: [usize; 2]| corner.starts[one][across] + corner.starts[two][across];
    let side = if sum(pair) > sum(other) { 1.0 } else { -1.0 };
    let border = corner.starts.iter().map(|point| point[across] * side).fold(zero[across] * side, f64::max);
    let length = |index: usize| (corner.starts[index][axis] - zero[axis]).abs();
    let [mut near, mut far] = pair;
    if (length(near) > length(far)) == (axis == 0) {
        (near, far) = (far, near);
    }
    // the line of 0 from which they are counted, with room for the texts beside columns
    let mut end = zero;
    end[across] = side * (border + SIZE * [0.36, 0.7][axis]);
    let mut shapes = vec![line(ShapeKind::Axis, vec![zero, end])];
    for (index, away) in [(near, 0.16), (far, 0.32)] {
        let mut to = corner.starts[index];
        to[across] = side * (border + SIZE * away);
        shapes.extend(corner.coordinate(above, index, axis, to));
    }
    shapes
}

/// The new zero point with its axes: the corner, or beside the corner of a rectangle (B:8018-8026).
fn zero_point(inputs: &Inputs, corner: &Corner, above: &Seen) -> Vec<PictureShape> {
    let abscissa = corner.edges[0];
    let ordinate = [-abscissa[1], abscissa[0]];
    let sized = |name| inputs.given(name).unwrap_or(1.0).signum() * 0.25 * SIZE;
    let moved = |name, when: &When| if when.holds(inputs) { sized(name) } else { 0.0 };
    let beside = along(corner.at, abscissa, moved(names::SETV2, &MOVED_ABSCISSA));
    let zero = along(beside, ordinate, moved(names::SETV3, &MOVED_ORDINATE));
    let tips = [abscissa, ordinate].map(|axis| along(zero, axis, 0.22 * SIZE));
    let mut shapes: Vec<_> = tips.into_iter().flat_map(|tip| ray(names::KNUM, zero, tip, above.ball)).collect();
    if RECTANGLE.holds(inputs) {
        shapes.push(circle(ShapeKind::Axis, zero, 1.5 * above.ball).of(names::SETV4));
        let ways = [(names::SETV2, corner.at, beside), (names::SETV3, beside, zero)];
        let ways = ways.into_iter().filter(|(_, from, to)| from != to);
        shapes.extend(ways.map(|(name, from, to)| dimension(name, from, to)));
    }
    shapes
}
