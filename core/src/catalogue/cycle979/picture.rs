//! CYCLE979 drawn: the element from above with its points at their angles, and the way over a web as a section beside
//! it.
//! Missing values are drawn as in the manual's examples. Short distances are drawn longer than they are; the workpiece
//! zero stands where the drawing has room.

use super::params::{FOUR_POINTS, OUTSIDE, ROUND, TOOL, WEB};
use crate::catalogue::circle::points;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arc, circle, corners, dimension, frame, line, polar, polygon, round, swept};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// What is drawn, mm and degree.
struct Scene {
    outside: bool,
    round: bool,
    size: f64,
    /// Angles of the points, in their order.
    points: Vec<f64>,
    ball: f64,
    path: f64,
}

impl Scene {
    /// Distance of the ball centre from the centre at the start of a measuring block, and at the set position.
    fn way(&self) -> (f64, f64) {
        let away = if self.outside { 1.0 } else { -1.0 };
        let switching = self.size / 2.0 + away * self.ball;
        (switching + away * self.path, switching)
    }

    /// Outline of the element, larger by a distance.
    fn outline(&self, wider: f64) -> Vec<[f64; 2]> {
        if self.round {
            return round([0.0; 2], self.size / 2.0 + wider);
        }
        let all = corners([0.0; 2], [self.size + 2.0 * wider, self.size * 1.4]);
        all.into_iter().map(|point| self.turned(point)).collect()
    }

    /// A point of the element that lies along the axes, turned into its place.
    fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let angle = self.points.first().copied().unwrap_or(0.0);
        let (sin, cos) = angle.to_radians().sin_cos();
        [x * cos - y * sin, x * sin + y * cos]
    }
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = part(&scene);
    bands(&scene, TOOL.holds(inputs), &mut shapes);
    centre(&scene, TOOL.holds(inputs), &mut shapes);
    start_angle(&scene, &mut shapes);
    set_size(&scene, &mut shapes);
    if scene.round {
        around(&scene, &mut shapes);
    }
    for (index, angle) in scene.points.iter().enumerate() {
        touch(&scene, *angle, index + 1, &mut shapes);
    }
    if WEB.holds(inputs) {
        over(&scene, &mut shapes);
    }
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let round = ROUND.holds(inputs);
    let start = inputs.number(names::STA1) % 360.0;
    let step = inputs.given(names::INCA).unwrap_or(80.0) % 360.0;
    let points = match round {
        true => points(start, step, FOUR_POINTS.holds(inputs)),
        false => vec![start, start + 180.0],
    };
    let size = inputs.positive(names::SETVAL, 130.0);
    Scene {
        outside: OUTSIDE.holds(inputs),
        round,
        size,
        points,
        ball: size * 0.045,
        path: inputs.positive(names::FA, 2.0).clamp(size * 0.1, size * 0.25),
    }
}

fn part(scene: &Scene) -> Vec<PictureShape> {
    let outline = scene.outline(0.0);
    let edge = polygon(ShapeKind::Edge, outline.clone()).of(names::SETVAL);
    if scene.outside {
        return vec![polygon(ShapeKind::Material, outline), edge];
    }
    let around = if scene.round {
        corners([0.0; 2], [scene.size * 1.3; 2])
    } else {
        scene.outline(scene.size * 0.15) // a groove is open at its ends
    };
    vec![polygon(ShapeKind::Material, frame(around, outline)), edge]
}

/// Tolerance bands of the size, or the safe area of the centre; wider than they are.
fn bands(scene: &Scene, tool: bool, shapes: &mut Vec<PictureShape>) {
    let unit = scene.size * 0.02;
    if !tool {
        let square = corners([0.0; 2], [8.0 * unit; 2]);
        shapes.push(polygon(ShapeKind::Tolerance, square).of(names::TSA));
        return;
    }
    for (from, to, field) in
        [(-2.6, 2.6, names::TSA), (-1.8, 1.8, names::TDIF), (0.0, 1.0, names::TUL), (-1.0, 0.0, names::TLL)]
    {
        let band = frame(scene.outline(to * unit), scene.outline(from * unit));
        shapes.push(polygon(ShapeKind::Tolerance, band).of(field));
    }
}

/// The set centre, measured from the workpiece zero, which is moved unless a tool is corrected.
fn centre(scene: &Scene, tool: bool, shapes: &mut Vec<PictureShape>) {
    let zero = -scene.size * 0.95;
    let reach = scene.size * 0.95;
    let axes = [
        line(ShapeKind::Axis, vec![[zero, zero], [reach, zero]]).text("0"),
        line(ShapeKind::Axis, vec![[zero, zero], [zero, reach]]),
    ];
    shapes.extend(axes.map(|axis| if tool { axis } else { axis.of(names::KNUM) }));
    shapes.push(line(ShapeKind::Axis, vec![[0.0, zero], [0.0, reach]]).of(names::CPA));
    shapes.push(line(ShapeKind::Axis, vec![[zero, 0.0], [reach, 0.0]]).of(names::CPO));
    let (low, left) = (zero * 0.9, zero * 0.93);
    shapes.push(dimension(names::CPA, [zero, low], [0.0, low]));
    shapes.push(dimension(names::CPO, [left, zero], [left, 0.0]));
    shapes.push(line(ShapeKind::Touch, vec![[0.0; 2]]).of(names::CPA));
}

/// The starting angle from the abscissa, drawn outside of everything that is touched.
fn start_angle(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let Some(angle) = scene.points.first().copied() else {
        return;
    };
    let reach = scene.way().0.max(scene.size / 2.0) + scene.size * 0.17;
    shapes.extend(swept(names::STA1, reach, 0.0, angle));
    let from = if scene.round { [0.0; 2] } else { polar(angle + 180.0, reach) };
    let direction = vec![from, polar(angle, reach)];
    shapes.push(line(ShapeKind::Axis, direction).of(names::STA1));
}

fn set_size(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let half = scene.size / 2.0;
    let place = |x: f64| {
        if scene.round { [x, -scene.size * 0.75] } else { scene.turned([x, -scene.size * 0.45]) }
    };
    shapes.push(dimension(names::SETVAL, place(-half), place(half)));
}

/// Indexing angle, and the arcs that the probe follows from point to point.
fn around(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let (start, _) = scene.way();
    if let [first, second, ..] = scene.points[..] {
        shapes.extend(swept(names::INCA, scene.size * 0.2, first, second));
    }
    for pair in scene.points.windows(2) {
        let way = arc([0.0; 2], start, pair[0], pair[1]);
        shapes.push(line(ShapeKind::Path, way).of(names::RF));
    }
}

/// One touch: start of the measuring block, way, point.
fn touch(scene: &Scene, angle: f64, number: usize, shapes: &mut Vec<PictureShape>) {
    let (start, switching) = scene.way();
    let ends = [polar(angle, start), polar(angle, switching)];
    shapes.push(line(ShapeKind::Path, ends.to_vec()).of(names::FA));
    shapes.push(circle(ShapeKind::Probe, ends[0], scene.ball).of(names::PRNUM));
    let point = polar(angle, scene.size / 2.0);
    shapes.push(circle(ShapeKind::Touch, point, scene.ball * 0.3).of(names::NMSP));
    let away = if scene.outside { -2.0 } else { 2.0 } * scene.ball;
    let label = line(ShapeKind::Label, vec![polar(angle, scene.size / 2.0 + away)]);
    shapes.push(label.text(format!("P{number}")).of(names::PRNUM));
    if number == 1 {
        let (u, v) = (polar(angle + 90.0, scene.ball * 1.8), ends);
        let aside = |[x, y]: [f64; 2]| [x + u[0], y + u[1]];
        shapes.push(dimension(names::FA, aside(v[0]), aside(v[1])));
    }
}

/// Section across the web, beside the view from above: up from the first point, across, down to the second.
fn over(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let (half, (start, _)) = (scene.size / 2.0, scene.way());
    let middle = scene.size * 1.15 + start;
    let depth = scene.size * 0.5;
    let (high, low) = (depth * 0.5, -depth * 0.5);
    let block = corners([middle, -depth / 2.0], [2.0 * half, depth]);
    shapes.push(polygon(ShapeKind::Cut, block));
    let (right, left) = (middle + start, middle - start);
    let way = vec![[right, low], [right, high], [left, high], [left, low]];
    shapes.push(line(ShapeKind::Path, way).of(names::ID));
    for at in [[right, low], [right, high], [left, low]] {
        shapes.push(circle(ShapeKind::Probe, at, scene.ball).of(names::ID));
    }
    let beside = right + scene.ball * 2.5;
    shapes.push(dimension(names::ID, [beside, low], [beside, high]));
}
