//! CYCLE961 drawn from above: the corner with its points and the way between them, and to the right, where the height
//! matters, the way in the applicate. Short distances are drawn longer than they are.

use super::lines::{Point, across, along, away, unit};
use super::params::{PASSES, PLACES, POINTS, RECTANGLE};
use super::scene::{Scene, from_distances, from_points};
use crate::entry::Inputs;
use crate::entry::{When, names};
use crate::picture::figures::{arc, arrow, circle, corners, dimension, frame, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// The probe is led over the corner, not around it (B:8006-8012).
const RISES: When = When::Given(names::ID);

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = if POINTS.holds(inputs) { from_points(inputs) } else { from_distances(inputs) };
    let mut shapes = part(&scene);
    if POINTS.holds(inputs) {
        places(&scene, &mut shapes);
    } else {
        directions(&scene, inputs, &mut shapes);
    }
    for (index, point) in scene.starts.iter().take(scene.touched).enumerate() {
        touch(&scene, *point, index, &mut shapes);
    }
    zero_point(&scene, inputs, &mut shapes);
    if POINTS.holds(inputs) || PASSES.holds(inputs) && RISES.holds(inputs) {
        height(&scene, inputs, &mut shapes);
    }
    Picture { view: View::Plane, shapes }
}

/// The part, seen from above, as far as the edges are touched.
fn part(scene: &Scene) -> Vec<PictureShape> {
    let [first, second] = scene.edges;
    let ends = [along(scene.corner, first, scene.reach[0]), along(scene.corner, second, scene.reach[1])];
    let far = along(ends[0], second, scene.reach[1]);
    let wedge = vec![scene.corner, ends[0], far, ends[1]];
    let material = if scene.outside {
        wedge
    } else {
        let half = [(scene.corner[0] + far[0]) / 2.0, (scene.corner[1] + far[1]) / 2.0];
        let wide = |point: Point| [0, 1].map(|i| half[i] + (point[i] - half[i]) * 1.25);
        frame(wedge.iter().copied().map(wide).collect(), wedge)
    };
    vec![
        polygon(ShapeKind::Material, material),
        line(ShapeKind::Edge, vec![scene.corner, ends[0]]).of(names::STA1),
        line(ShapeKind::Edge, vec![scene.corner, ends[1]]).of(names::INCA),
    ]
}

/// Start, angles and distances.
fn directions(scene: &Scene, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let start = inputs.number(names::STA1) % 360.0;
    let second = scene.edges[1][1].atan2(scene.edges[1][0]).to_degrees();
    let turn = (second - start).rem_euclid(360.0);
    let turn = if scene.sense() < 0.0 { turn - 360.0 } else { turn };
    let ray = |direction, length| vec![[0.0; 2], along([0.0; 2], direction, length)];
    let reach = scene.size * 1.15;
    shapes.push(line(ShapeKind::Axis, ray([1.0, 0.0], reach)).of(names::STA1));
    shapes.push(line(ShapeKind::Axis, ray(scene.edges[0], reach)).of(names::STA1));
    shapes.push(line(ShapeKind::Axis, ray(scene.edges[1], reach)).of(names::INCA));
    for (radius, from, to, name) in [(0.3, 0.0, start, names::STA1), (0.2, start, start + turn, names::INCA)] {
        let sweep = arc([0.0; 2], scene.size * radius, from, to);
        shapes.push(line(ShapeKind::Path, sweep).of(name));
        let at = along([0.0; 2], unit((from + to) / 2.0), scene.size * radius * 1.3);
        shapes.push(line(ShapeKind::Label, vec![at]).text(name).of(name));
    }
    for (name, from, beside) in [(names::SETV0, 1, 0), (names::SETV1, 3, 1)] {
        let [x, y] = scene.edges[beside];
        let side = if beside == 0 { -1.0 } else { 1.0 } * scene.sense() * scene.ball * 5.0;
        let aside = |point| along(point, [-y, x], side);
        shapes.push(dimension(name, aside([0.0; 2]), aside(scene.starts[from])));
    }
    let [p1, p2, p3, p4] = scene.starts;
    let mut way = vec![[0.0; 2], p2, p1];
    if PASSES.holds(inputs) && !RISES.holds(inputs) {
        let around = vec![p1, [0.0; 2], p3];
        shapes.push(line(ShapeKind::Path, around).of(names::ID));
        way.push([0.0; 2]);
    }
    way.push(p3);
    way.extend((scene.touched == 4).then_some(p4));
    way.push([0.0; 2]);
    shapes.push(line(ShapeKind::Path, way).of(names::MVAR));
    shapes.push(circle(ShapeKind::Probe, [0.0; 2], scene.ball).of(names::PRNUM));
}

/// The coordinates of the points from the workpiece zero. Along its line a pair has them one beside the other, outside
/// of the part, across it each at its point, so that no two stand in one place.
fn places(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let [x, y] = scene.zero;
    let size = scene.size;
    for axis in [[[x - size * 0.1, y], [x + size, y]], [[x, y - size * 0.1], [x, y + size * 0.8]]] {
        shapes.push(line(ShapeKind::Axis, axis.to_vec()).text("0"));
    }
    for (pair, other) in [([0, 1], [2, 3]), ([2, 3], [0, 1])] {
        stacked(scene, pair, other, shapes);
        for index in pair {
            beside(scene, pair, index, shapes);
        }
    }
    let [p1, p2, p3, p4] = scene.starts;
    shapes.push(line(ShapeKind::Path, vec![p2, p1, p3, p4]).of(names::MVAR));
}

/// The axis along which a pair of places lies.
fn lies_along(scene: &Scene, [one, other]: [usize; 2]) -> usize {
    let [x, y] = away(scene.starts[one], scene.starts[other]);
    usize::from(y.abs() > x.abs())
}

/// The coordinates of a pair along its line, on the side that is turned away from the other pair: rows, or columns, of
/// which a short one stands outside of a long one, so that the text of the long one has its place above it.
fn stacked(scene: &Scene, pair: [usize; 2], other: [usize; 2], shapes: &mut Vec<PictureShape>) {
    let axis = lies_along(scene, pair);
    let across = 1 - axis;
    let sum = |[one, two]: [usize; 2]| scene.starts[one][across] + scene.starts[two][across];
    let side = if sum(pair) > sum(other) { 1.0 } else { -1.0 };
    let values = scene.starts.iter().map(|point| point[across] * side);
    let border = values.fold(scene.zero[across] * side, f64::max);
    let length = |index: usize| (scene.starts[index][axis] - scene.zero[axis]).abs();
    let [mut near, mut far] = pair;
    if (length(near) > length(far)) == (axis == 0) {
        (near, far) = (far, near);
    }
    // the line of 0 from which they are counted, with room for the texts beside columns
    let mut end = scene.zero;
    end[across] = side * (border + scene.size * [0.36, 0.7][axis]);
    shapes.push(line(ShapeKind::Axis, vec![scene.zero, end]));
    for (index, away) in [(near, 0.16), (far, 0.32)] {
        let mut to = scene.starts[index];
        to[across] = side * (border + scene.size * away);
        let mut from = to;
        from[axis] = scene.zero[axis];
        let field = PLACES[index][axis];
        shapes.push(dimension(field, from, to));
        shapes.push(line(ShapeKind::Axis, vec![to, scene.starts[index]]).of(field));
    }
}

/// The coordinate of a place across the line of its pair, at the place.
fn beside(scene: &Scene, pair: [usize; 2], index: usize, shapes: &mut Vec<PictureShape>) {
    let axis = lies_along(scene, pair);
    let across = 1 - axis;
    let mut to = scene.starts[index];
    to[axis] += scene.ball * 2.5;
    let mut from = to;
    from[across] = scene.zero[across];
    let field = PLACES[index][across];
    shapes.push(dimension(field, from, to));
    shapes.push(line(ShapeKind::Axis, vec![to, scene.starts[index]]).of(field));
}

/// One touch along an axis, towards the edge.
fn touch(scene: &Scene, start: Point, index: usize, shapes: &mut Vec<PictureShape>) {
    let edge = scene.edges[index / 2];
    let normal = toward(scene, start, edge);
    let axis = if normal[0].abs() > normal[1].abs() { [normal[0].signum(), 0.0] } else { [0.0, normal[1].signum()] };
    // from the start along the axis to the edge
    let share = across(away(start, scene.corner), edge) / across(axis, edge);
    let share = share.clamp(0.0, scene.size * 2.0);
    let (contact, stop) = (along(start, axis, share), along(start, axis, (share - scene.ball).max(0.0)));
    shapes.push(line(ShapeKind::Path, vec![start, stop]).of(names::FA));
    shapes.push(arrow(ShapeKind::Path, start, stop, scene.ball).of(names::FA));
    if index == 1 {
        let aside = |point| along(point, edge, scene.ball * 2.0);
        shapes.push(dimension(names::FA, aside(start), aside(stop)));
    }
    shapes.push(circle(ShapeKind::Probe, start, scene.ball).of(names::PRNUM));
    shapes.push(circle(ShapeKind::Touch, contact, scene.ball * 0.4).of(names::NMSP));
    let label = line(ShapeKind::Label, vec![along(start, axis, -scene.ball * 2.0)]);
    shapes.push(label.text(format!("P{}", index + 1)).of(names::NMSP));
}

/// Unit vector across an edge, from a point to the side on which the edge lies.
fn toward(scene: &Scene, point: Point, edge: Point) -> Point {
    let normal = [-edge[1], edge[0]];
    let [x, y] = away(point, scene.corner);
    let sign = if x * normal[0] + y * normal[1] < 0.0 { -1.0 } else { 1.0 };
    [normal[0] * sign, normal[1] * sign]
}

/// The new zero point with its axes: the corner, or beside the corner of a rectangle (B:8018-8026).
fn zero_point(scene: &Scene, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let abscissa = scene.edges[0];
    let ordinate = [-abscissa[1], abscissa[0]];
    let selection = inputs.integer(names::SETV4);
    let moved = |name, selections: [i64; 2]| {
        let active = RECTANGLE.holds(inputs) && selections.contains(&selection);
        let sign = inputs.given(name).unwrap_or(1.0).signum();
        if active { sign * scene.size * 0.25 } else { 0.0 }
    };
    let beside = along(scene.corner, abscissa, moved(names::SETV2, [2, 3]));
    let zero = along(beside, ordinate, moved(names::SETV3, [3, 4]));
    for tip in [along(zero, abscissa, scene.size * 0.22), along(zero, ordinate, scene.size * 0.22)] {
        shapes.push(line(ShapeKind::Axis, vec![zero, tip]).of(names::KNUM));
        shapes.push(arrow(ShapeKind::Axis, zero, tip, scene.ball).of(names::KNUM));
    }
    if !RECTANGLE.holds(inputs) {
        return;
    }
    shapes.push(circle(ShapeKind::Axis, zero, scene.ball * 1.5).of(names::SETV4));
    for (name, from, to) in [(names::SETV2, scene.corner, beside), (names::SETV3, beside, zero)] {
        if from != to {
            shapes.push(dimension(name, from, to));
        }
    }
}

/// The way in the applicate, drawn to the right: down to the points, or over the corner.
fn height(scene: &Scene, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let all = shapes.iter().flat_map(|shape| &shape.points);
    let (right, low, high) = all.fold((0.0_f64, f64::INFINITY, f64::NEG_INFINITY), |(right, low, high), [x, y]| {
        (right.max(*x), low.min(*y), high.max(*y))
    });
    let (width, depth) = (scene.size * 0.25, scene.size * 0.2);
    let middle = [right + scene.size * 0.35, (low + high) / 2.0];
    shapes.push(polygon(ShapeKind::Cut, corners(middle, [width, depth])));
    let (out, low) = (width / 2.0 + scene.ball * 3.0, middle[1]);
    let [left, out] = [-out, out].map(|side| middle[0] + side);
    let high = low + depth / 2.0 + scene.ball * 3.0;
    let path = if POINTS.holds(inputs) {
        vec![[out, high], [out, low]]
    } else {
        vec![[left, low], [left, high], [out, high], [out, low]]
    };
    let ends = path.first().into_iter().chain(path.last());
    shapes.extend(ends.map(|end| circle(ShapeKind::Probe, *end, scene.ball).of(names::ID)));
    shapes.push(line(ShapeKind::Path, path).of(names::ID));
    let beside = out + scene.ball * 2.0;
    shapes.push(dimension(names::ID, [beside, low], [beside, high]));
}
