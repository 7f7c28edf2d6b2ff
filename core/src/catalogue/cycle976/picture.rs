//! CYCLE976 drawn: the hole from above with the directions in their order, beside it the stylus with skew and ball
//! diameter where they are determined; or the surface with the direction. Missing values are drawn as in the manual's
//! examples. Short distances are drawn longer than they are.

use super::directions::{Direction, angle, directions};
use super::params::{ANGLE, BALL, FOUR, HOLE, LENGTH, ONE, SKEW, UNKNOWN};
use crate::control::variables::AXES;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arc, arrow, circle, corners, dimension, frame, line, polygon, round};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    if HOLE.holds(inputs) {
        let shapes = hole(inputs);
        return Picture { view: View::Plane, shapes };
    }
    let applicate = LENGTH.holds(inputs) || inputs.integer(names::MA) == 3;
    let view = if applicate { View::Section } else { View::Plane };
    let shapes = surface(inputs, applicate);
    Picture { view, shapes }
}

/// What is drawn of a hole, mm.
struct Hole {
    size: f64,
    ball: f64,
    path: f64,
    /// Angle of the first axis of calibration, degree.
    angle: f64,
}

impl Hole {
    /// A point at a distance from the centre, in a direction counted from the abscissa of calibration, degree.
    fn at(&self, direction: f64, distance: f64) -> [f64; 2] {
        let (sin, cos) = (self.angle + direction).to_radians().sin_cos();
        [distance * cos, distance * sin]
    }
}

fn hole(inputs: &Inputs) -> Vec<PictureShape> {
    let size = inputs.positive(names::SETVAL, 110.246);
    let hole = Hole {
        size,
        ball: size * 0.045,
        path: inputs.positive(names::FA, 2.0).clamp(size * 0.1, size * 0.25),
        angle: angle(inputs) % 360.0,
    };
    let mut shapes = part(&hole);
    axes(&hole, inputs, &mut shapes);
    let degrees = directions(inputs).into_iter().map(Direction::degrees);
    for (index, direction) in degrees.enumerate() {
        touch(&hole, direction, index + 1, &mut shapes);
    }
    start(&hole, inputs, &mut shapes);
    if BALL.holds(inputs) || SKEW.holds(inputs) {
        stylus(&hole, inputs, &mut shapes);
    }
    shapes
}

fn part(hole: &Hole) -> Vec<PictureShape> {
    let radius = hole.size / 2.0;
    let outline = round([0.0; 2], radius);
    let block = corners([0.0; 2], [hole.size * 1.3; 2]);
    let low = -hole.size * 0.3;
    vec![
        polygon(ShapeKind::Material, frame(block, outline.clone())),
        polygon(ShapeKind::Edge, outline).of(names::SETVAL),
        dimension(names::SETVAL, [-radius, low], [radius, low]),
    ]
}

/// The axes of the plane, and those of calibration where they are turned.
fn axes(hole: &Hole, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let reach = hole.size * 0.75;
    let [abscissa, ordinate] = [0, 1].map(|index| AXES[inputs.plane.axes()[index]]);
    shapes.push(line(ShapeKind::Axis, vec![[reach, 0.0], [-reach, 0.0]]).text(abscissa));
    shapes.push(line(ShapeKind::Axis, vec![[0.0, reach], [0.0, -reach]]).text(ordinate));
    if ANGLE.holds(inputs) {
        for direction in [0.0, 90.0] {
            let ends = vec![hole.at(direction + 180.0, reach), hole.at(direction, reach)];
            shapes.push(line(ShapeKind::Axis, ends).of(names::STA1));
        }
        let radius = hole.size * 0.58;
        let swept = arc([0.0; 2], radius, 0.0, hole.angle);
        shapes.push(line(ShapeKind::Path, swept).of(names::STA1));
        let (sin, cos) = (hole.angle / 2.0).to_radians().sin_cos();
        let at = vec![[radius * 1.2 * cos, radius * 1.2 * sin]];
        shapes.push(line(ShapeKind::Label, at).text(names::STA1).of(names::STA1));
    }
    if !FOUR.holds(inputs) {
        let axis = if inputs.integer(names::MA) == 2 { 90.0 } else { 0.0 };
        let ends = vec![hole.at(axis + 180.0, reach), hole.at(axis, reach)];
        shapes.push(line(ShapeKind::Axis, ends).of(names::MA));
    }
    if ONE.holds(inputs) {
        for direction in directions(inputs).into_iter().map(Direction::degrees) {
            let tip = hole.at(direction, hole.size / 2.0 - 2.0 * hole.ball);
            shapes.push(arrow(ShapeKind::Path, [0.0; 2], tip, hole.ball * 1.6).of(names::MD));
        }
    }
}

/// One touch: start of the measuring block, way, point.
fn touch(hole: &Hole, direction: f64, number: usize, shapes: &mut Vec<PictureShape>) {
    let switching = hole.size / 2.0 - hole.ball;
    let begin = switching - hole.path;
    let way = vec![hole.at(direction, begin), hole.at(direction, switching)];
    shapes.push(line(ShapeKind::Path, way).of(names::FA));
    let ball = circle(ShapeKind::Probe, hole.at(direction, begin), hole.ball);
    shapes.push(ball.of(names::PRNUM));
    let point = hole.at(direction, hole.size / 2.0);
    shapes.push(circle(ShapeKind::Touch, point, hole.ball * 0.3).text(number.to_string()).of(names::NMSP));
    if number == 1 {
        let aside = |distance: f64| {
            let ([x, y], [u, v]) = (hole.at(direction, distance), hole.at(direction + 90.0, 1.0));
            let away = hole.ball * 2.0;
            [x + u * away, y + v * away]
        };
        shapes.push(dimension(names::FA, aside(begin), aside(switching)));
    }
}

/// The probe at the call: at the centre, or beside it with the two runs that find it.
fn start(hole: &Hole, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    if !UNKNOWN.holds(inputs) {
        shapes.push(circle(ShapeKind::Probe, [0.0; 2], hole.ball).of(names::PRNUM));
        return;
    }
    let at = [-hole.size * 0.13, hole.size * 0.1];
    shapes.push(line(ShapeKind::Touch, vec![[0.0; 2]]).of(names::MVAR));
    shapes.push(line(ShapeKind::Path, vec![at, [0.0; 2]]).of(names::FA));
    shapes.push(circle(ShapeKind::Probe, at, hole.ball).of(names::PRNUM));
    let turned = arc(at, hole.ball * 1.8, 200.0, 380.0);
    if let [.., from, tip] = turned[..] {
        shapes.push(arrow(ShapeKind::Axis, from, tip, hole.ball).of(names::MVAR));
    }
    shapes.push(line(ShapeKind::Axis, turned).of(names::MVAR));
    let label = line(ShapeKind::Label, vec![[at[0], at[1] + hole.size * 0.1]]);
    shapes.push(label.text("180° / 0°").of(names::MVAR));
}

/// The stylus from the side, beside the hole: ball diameter, and the skew against the spindle's axis.
fn stylus(hole: &Hole, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let (size, axis) = (hole.size, hole.size * 1.0);
    let (top, low, radius) = (size * 0.55, -size * 0.35, size * 0.13);
    let skewed = SKEW.holds(inputs);
    let centre = [axis + if skewed { size * 0.16 } else { 0.0 }, low];
    let spindle = corners([axis, top], [size * 0.3, size * 0.12]);
    shapes.push(polygon(ShapeKind::Material, spindle));
    shapes.push(line(ShapeKind::Axis, vec![[axis, top], [axis, low - size * 0.3]]).of(names::MVAR));
    shapes.push(line(ShapeKind::Path, vec![[axis, top - size * 0.06], centre]).of(names::PRNUM));
    shapes.push(circle(ShapeKind::Probe, centre, radius).of(names::PRNUM));
    if skewed {
        let under = low - size * 0.24;
        let ends = vec![[axis, under], [centre[0], under]];
        shapes.push(line(ShapeKind::Dimension, ends).text("s").of(names::MVAR));
        let drop = vec![[centre[0], low], [centre[0], under - size * 0.05]];
        shapes.push(line(ShapeKind::Axis, drop).of(names::MVAR));
    }
    if BALL.holds(inputs) {
        let beside = low + radius * 1.35;
        let ends = vec![[centre[0] - radius, beside], [centre[0] + radius, beside]];
        shapes.push(line(ShapeKind::Dimension, ends).text("Ø").of(names::MVAR));
    }
}

/// Half the length of the drawn face, mm.
const FACE: f64 = 30.0;
/// Thickness behind the face, mm.
const BEHIND: f64 = 24.0;
/// Ball radius, mm.
const RADIUS: f64 = 4.0;
/// Where the zero point of the axis is drawn, mm from the face.
const ZERO: f64 = -44.0;

/// The face at 0, touched along the first drawing axis, then turned into the measuring axis and direction.
fn surface(inputs: &Inputs, applicate: bool) -> Vec<PictureShape> {
    let path = inputs.positive(names::FA, 2.0).clamp(10.0, 24.0);
    let start = -RADIUS - path;
    let material = if applicate { ShapeKind::Cut } else { ShapeKind::Material };
    let mut shapes = vec![
        polygon(material, vec![[0.0, -FACE], [BEHIND, -FACE], [BEHIND, FACE], [0.0, FACE]]),
        line(ShapeKind::Edge, vec![[0.0, -FACE], [0.0, FACE]]).of(names::SETVAL),
        line(ShapeKind::Axis, vec![[ZERO, 0.0], [BEHIND * 1.3, 0.0]]).of(names::MA),
        line(ShapeKind::Path, vec![[start, 0.0], [-RADIUS, 0.0]]).of(names::FA),
        arrow(ShapeKind::Path, [start, 0.0], [-RADIUS, 0.0], 4.0).of(names::MD),
        circle(ShapeKind::Probe, [start, 0.0], RADIUS).of(names::PRNUM),
        circle(ShapeKind::Touch, [0.0, 0.0], RADIUS * 0.3).text("1").of(names::NMSP),
        dimension(names::FA, [start, RADIUS * 2.0], [-RADIUS, RADIUS * 2.0]),
    ];
    if LENGTH.holds(inputs) {
        let end = path - RADIUS; // the path may be used up behind the set position as well
        let beyond = vec![[-RADIUS, RADIUS * 2.0], [end, RADIUS * 2.0]];
        shapes.push(line(ShapeKind::Dimension, beyond).text(names::FA).of(names::FA));
    }
    if applicate {
        probe_above(inputs, start, &mut shapes);
    }
    let backwards = inputs.given(names::MD).unwrap_or(1.0) == 1.0;
    let upright = applicate || inputs.integer(names::MA) == 2;
    shapes.push(set_position(inputs, upright));
    for shape in &mut shapes {
        turn(shape, backwards, upright);
    }
    shapes
}

/// The set position as a text: in the material, or above it where that is narrow.
fn set_position(inputs: &Inputs, upright: bool) -> PictureShape {
    let text =
        inputs.given(names::SETVAL).map_or(names::SETVAL.to_string(), |set| format!("{} = {set}", names::SETVAL));
    let at = if upright { [BEHIND * 0.4, FACE * 0.45] } else { [0.0, FACE * 1.2] };
    line(ShapeKind::Label, vec![at]).text(text).of(names::SETVAL)
}

/// Stylus and spindle above the ball, with the length that is determined: to the ball's centre, or with `_CBIT[14]` to
/// its circumference (B:5471-5472).
fn probe_above(inputs: &Inputs, start: f64, shapes: &mut Vec<PictureShape>) {
    let nose = start - 30.0;
    shapes.push(line(ShapeKind::Path, vec![[start, 0.0], [nose, 0.0]]).of(names::PRNUM));
    let spindle = corners([nose - 4.0, 0.0], [8.0, 20.0]);
    shapes.push(polygon(ShapeKind::Material, spindle));
    if LENGTH.holds(inputs) {
        let around = inputs.settings.get("_CBIT[14]") == Some(&1.0);
        let tip = if around { start + RADIUS } else { start };
        let ends = vec![[nose, -14.0], [tip, -14.0]];
        shapes.push(line(ShapeKind::Dimension, ends).text("L1").of(names::MVAR));
        shapes.push(line(ShapeKind::Axis, vec![[tip, -18.0], [tip, 0.0]]).of(names::MVAR));
    }
}

/// Turns a figure into the measuring direction and axis.
fn turn(shape: &mut PictureShape, backwards: bool, upright: bool) {
    let place = |[x, y]: [f64; 2]| {
        let x = if backwards { -x } else { x };
        if upright { [-y, x] } else { [x, y] }
    };
    for point in &mut shape.points {
        *point = place(*point);
    }
    if let Some((centre, _)) = &mut shape.circle {
        *centre = place(*centre);
    }
}
