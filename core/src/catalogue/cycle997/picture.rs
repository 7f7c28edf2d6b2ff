//! CYCLE997 drawn: the first sphere from above with its points in their order, beside it the section with the way over
//! the sphere and the last point; with three spheres their triangle beside both. Missing values are drawn as in the
//! manual's examples. Short distances are drawn longer than they are; the workpiece zero stands where the drawing has
//! room.

use super::params::{ANGLE, DIAMETER, REPEATED, THREE};
use super::points::{DIAMETER_SIDE, centres, directions};
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arc, arrow, circle, corners, dimension, line, polar, polygon, round, swept};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// What is drawn, mm and degree.
struct Scene {
    size: f64,
    ball: f64,
    path: f64,
    /// Directions of the points in the plane, in their order.
    points: Vec<f64>,
    angle: bool,
    three: bool,
    diameter: bool,
    repeated: bool,
}

impl Scene {
    /// Distance of the ball centre from the centre at the set position, and at the start of a measuring block.
    fn way(&self) -> (f64, f64) {
        let switching = self.size / 2.0 + self.ball;
        (switching, switching + self.path)
    }

    /// Centre of the section: beside the view from above, below it where the triangle of three spheres stands beside
    /// both.
    fn section(&self) -> [f64; 2] {
        let apart = 2.0 * self.way().1 + self.size * if self.three { 0.75 } else { 0.9 };
        if self.three { [0.0, -apart] } else { [apart, 0.0] }
    }
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = sphere(&scene);
    if scene.three {
        triangle(&scene, inputs, &mut shapes);
    } else {
        centre(&scene, &mut shapes);
    }
    if scene.angle {
        angles(&scene, &mut shapes);
    }
    for (index, direction) in scene.points.iter().enumerate() {
        touch(&scene, *direction, index + 1, &mut shapes);
    }
    if scene.diameter {
        diameter(&scene, &mut shapes);
    }
    section(&scene, &mut shapes);
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let size = inputs.positive(names::SETVAL, 50.0);
    Scene {
        size,
        ball: size * 0.06,
        path: inputs.positive(names::FA, 2.0).clamp(size * 0.15, size * 0.25),
        points: directions(inputs),
        angle: ANGLE.holds(inputs),
        three: THREE.holds(inputs),
        diameter: DIAMETER.holds(inputs),
        repeated: REPEATED.holds(inputs),
    }
}

/// The sphere from above, with the safe area of its centre, wider than it is.
fn sphere(scene: &Scene) -> Vec<PictureShape> {
    let half = scene.size / 2.0;
    // where the section stands below, its text would lie upon the last point
    let [x, y] = if scene.three { scene.section() } else { [0.0; 2] };
    let low = y - scene.size * 0.28;
    let outline = round([0.0; 2], half);
    let area = corners([0.0; 2], [scene.size * 0.14; 2]);
    let mut shapes = vec![
        polygon(ShapeKind::Material, outline.clone()),
        polygon(ShapeKind::Edge, outline).of(names::SETVAL),
        polygon(ShapeKind::Tolerance, area).of(names::TSA),
        line(ShapeKind::Touch, vec![[0.0; 2]]).of(names::SETV0),
        dimension(names::SETVAL, [x - half, low], [x + half, low]),
    ];
    if scene.repeated {
        let found = scene.size * 0.05;
        let label = line(ShapeKind::Label, vec![[found, scene.size * 0.14]]);
        shapes.push(circle(ShapeKind::Axis, [found, found / 2.0], found).of(names::MVAR));
        shapes.push(label.text("2×").of(names::MVAR));
    }
    shapes
}

/// The set centre of the only sphere, measured from the workpiece zero.
fn centre(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let zero = -scene.way().1 - scene.size * 0.35;
    let reach = -zero;
    shapes.push(line(ShapeKind::Axis, vec![[zero, zero], [reach, zero]]).text("0").of(names::KNUM));
    shapes.push(line(ShapeKind::Axis, vec![[zero, zero], [zero, reach]]).of(names::KNUM));
    shapes.push(line(ShapeKind::Axis, vec![[0.0, zero], [0.0, reach]]).of(names::SETV0));
    shapes.push(line(ShapeKind::Axis, vec![[zero, 0.0], [reach, 0.0]]).of(names::SETV1));
    let (low, left) = (zero * 0.93, zero * 0.95);
    shapes.push(dimension(names::SETV0, [zero, low], [0.0, low]));
    shapes.push(dimension(names::SETV1, [left, zero], [left, 0.0]));
}

/// Starting angle, indexing angle, and the arcs that the probe follows from point to point.
fn angles(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let (_, start) = scene.way();
    let [first, second, ..] = scene.points[..] else {
        return;
    };
    let reach = start + scene.size * 0.14;
    let ends = vec![[0.0; 2], polar(first, reach)];
    shapes.push(line(ShapeKind::Axis, ends).of(names::STA1));
    shapes.extend(swept(names::STA1, reach, 0.0, first));
    shapes.extend(swept(names::INCA, scene.size * 0.2, first, second));
    for pair in scene.points.windows(2) {
        let way = arc([0.0; 2], start, pair[0], pair[1]);
        shapes.push(line(ShapeKind::Path, way).of(names::RF));
    }
}

/// One touch in the plane: start of the measuring block, way, point.
fn touch(scene: &Scene, direction: f64, number: usize, shapes: &mut Vec<PictureShape>) {
    let (switching, start) = scene.way();
    let ends = [polar(direction, start), polar(direction, switching)];
    shapes.push(line(ShapeKind::Path, ends.to_vec()).of(names::FA));
    shapes.push(circle(ShapeKind::Probe, ends[0], scene.ball).of(names::PRNUM));
    let point = polar(direction, scene.size / 2.0);
    shapes.push(circle(ShapeKind::Touch, point, scene.ball * 0.3).of(names::NMSP));
    let inside = polar(direction, scene.size / 2.0 - 1.6 * scene.ball);
    let label = line(ShapeKind::Label, vec![inside]).text(format!("P{number}"));
    shapes.push(label.of(names::NMSP));
}

/// The additional point for the diameter, in plus direction of the abscissa.
fn diameter(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let (switching, start) = scene.way();
    let [from, tip] = [start, switching].map(|distance| polar(DIAMETER_SIDE, distance));
    let beyond = polar(DIAMETER_SIDE, start + 3.0 * scene.ball);
    shapes.push(line(ShapeKind::Path, vec![beyond, tip]).of(names::MVAR));
    shapes.push(circle(ShapeKind::Probe, from, scene.ball).of(names::MVAR));
    shapes.push(arrow(ShapeKind::Path, from, tip, scene.ball * 1.4).of(names::MVAR));
    shapes.push(line(ShapeKind::Label, vec![beyond]).text("Ø").of(names::MVAR));
}

/// Section through the sphere: its holder below, the height of the set centre, the way over it, the last point.
fn section(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let size = scene.size;
    let [middle, equator] = scene.section();
    let (switching, start) = scene.way();
    let low = equator - start - size * if scene.three { 0.1 } else { 0.35 };
    let holder = corners([middle, (low + equator - size * 0.45) / 2.0], [size * 0.16, equator - low - size * 0.45]);
    shapes.push(polygon(ShapeKind::Material, holder));
    let cut = round([middle, equator], size / 2.0);
    shapes.push(polygon(ShapeKind::Cut, cut).of(names::SETVAL));
    let (left, right) = (middle - start, middle + start);
    let (over, safe) = (equator + start, equator + start + size * 0.4);
    let axis = vec![[left - size * 0.2, equator], [right + size * 0.1, equator]];
    shapes.push(line(ShapeKind::Axis, axis).of(names::SETV2));
    if !scene.three {
        let ground = vec![[left - size * 0.2, low], [right, low]];
        let beside = left - size * 0.1;
        shapes.push(line(ShapeKind::Axis, ground).text("0").of(names::KNUM));
        shapes.push(dimension(names::SETV2, [beside, low], [beside, equator]));
    }
    let mut way = vec![[middle, safe], [right, safe], [right, equator]];
    if !scene.angle {
        // up and across between the points, then to the last one
        way.extend([[right, over], [left, over], [left, equator]]);
    }
    shapes.push(line(ShapeKind::Path, way).of(names::MVAR));
    for at in [[middle, safe], [right, equator]] {
        shapes.push(circle(ShapeKind::Probe, at, scene.ball).of(names::PRNUM));
    }
    let down = vec![[middle, over], [middle, equator + switching]];
    shapes.push(line(ShapeKind::Path, down).of(names::FA));
    shapes.push(circle(ShapeKind::Probe, [middle, over], scene.ball).of(names::PRNUM));
    let top = equator + size / 2.0;
    shapes.push(circle(ShapeKind::Touch, [middle, top], scene.ball * 0.3).of(names::NMSP));
    let last = format!("P{}", scene.points.len() + 1);
    let label = line(ShapeKind::Label, vec![[middle, top - 1.6 * scene.ball]]);
    shapes.push(label.text(last).of(names::NMSP));
    let beside = middle + 2.2 * scene.ball;
    shapes.push(dimension(names::FA, [beside, over], [beside, equator + switching]));
}

/// Set centres where they are missing: those of the manual's example (B:8482).
const EXAMPLE: [[f64; 2]; 3] = [[100.0, 100.0], [600.0, 100.0], [1100.0, 1100.0]];

/// The triangle of the set centres from above, at a scale of its own, with the order of the spheres.
fn triangle(scene: &Scene, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let size = scene.size;
    let fields = centres(inputs);
    let set: Vec<[f64; 2]> = fields
        .iter()
        .zip(EXAMPLE)
        .map(|([x, y, _], [u, v])| [inputs.given(x).unwrap_or(u), inputs.given(y).unwrap_or(v)])
        .collect();
    let zero = [scene.way().1 + size * 1.1, -size * 1.5];
    let corner = zero.map(|value| value + size * 0.8);
    let places = fitted(&set, corner, [size * 3.0, size * 1.6]);
    shapes.push(polygon(ShapeKind::Axis, places.clone()).of(names::TNVL));
    for pair in places.windows(2) {
        shapes.push(line(ShapeKind::Path, pair.to_vec()).of(names::MVAR));
        shapes.push(arrow(ShapeKind::Path, pair[0], pair[1], scene.ball * 1.6).of(names::MVAR));
    }
    let (right, top) = (zero[0] + size * 4.2, zero[1] + size * 2.5);
    shapes.push(line(ShapeKind::Axis, vec![zero, [right, zero[1]]]).text("0").of(names::KNUM));
    shapes.push(line(ShapeKind::Axis, vec![zero, [zero[0], top]]).of(names::KNUM));
    for (index, ([u, v], [x, y, z])) in places.into_iter().zip(fields).enumerate() {
        let under = zero[1] - size * (0.05 + 0.42 * (index + 1) as f64);
        shapes.push(dimension(x, [zero[0], under], [u, under]));
        shapes.push(line(ShapeKind::Axis, vec![[u, under], [u, zero[1]]]).of(x));
        shapes.push(dimension(y, [u, zero[1]], [u, v]));
        let ball = circle(ShapeKind::Edge, [u, v], size * 0.12);
        shapes.push(ball.text((index + 1).to_string()).of(x));
        let label = line(ShapeKind::Label, vec![[u, v + size * 0.3]]);
        shapes.push(label.text(*z).of(z));
    }
}

/// Points at a scale at which they fill a rectangle, given by its lower left corner and its size.
fn fitted(points: &[[f64; 2]], corner: [f64; 2], room: [f64; 2]) -> Vec<[f64; 2]> {
    let ends = [0, 1].map(|axis| {
        let values = points.iter().map(|point| point[axis]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        (low, values.fold(f64::NEG_INFINITY, f64::max) - low)
    });
    let scale = [0, 1].map(|axis| room[axis] / ends[axis].1.max(f64::MIN_POSITIVE));
    let scale = scale[0].min(scale[1]);
    let scale = if scale.is_finite() { scale } else { 0.0 };
    points.iter().map(|point| [0, 1].map(|axis| corner[axis] + (point[axis] - ends[axis].0) * scale)).collect()
}
