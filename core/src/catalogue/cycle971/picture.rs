//! CYCLE971 drawn: at the left the probe from above, at the right the section in which the tool touches it. Probe and
//! tool stand for any size; short distances are drawn longer than they are.

use super::params::{APPLICATE, AUTOMATIC, CALIBRATE, INCREMENTAL, MEASURE, ROTATING, WORKPIECE};
use crate::catalogue::tool_probe::figures::bands;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{circle, corners, dimension, line, polygon, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Half the edge length of the probe, mm.
const PROBE: f64 = 10.0;
/// Height of its cap, mm.
const CAP: f64 = 7.0;
/// Where the section is drawn beside the view from above, mm.
const SECTION: f64 = 66.0;
/// How far the end of the tool stands below the upper side at a measurement in the plane, mm.
const DEPTH: f64 = 4.0;
/// Length of the drawn tool, mm.
const TOOL: f64 = 22.0;

/// What is drawn, mm.
struct Scene {
    /// Direction in the plane in which the tool stands beside the probe or is offset: abscissa or ordinate.
    across: usize,
    /// Side on which it stands.
    side: f64,
    radius: f64,
    path: f64,
    /// `_ID`, as far as it can be drawn.
    inward: f64,
    /// Offset of the tool axis from the centre of the probe, at a measurement from above.
    offset: f64,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = vec![
        rectangle(ShapeKind::Material, [0.0; 2], [2.0 * PROBE; 2]),
        rectangle(ShapeKind::Material, [SECTION, -CAP / 2.0], [2.0 * PROBE, CAP]),
        rectangle(ShapeKind::Material, [SECTION, -CAP - 9.0], [6.0, 18.0]),
    ];
    reference(inputs, &mut shapes);
    if AUTOMATIC.holds(inputs) {
        all_sides(inputs, &scene, &mut shapes);
    } else if APPLICATE.holds(inputs) {
        from_above(inputs, &scene, &mut shapes);
    } else {
        beside(inputs, &scene, &mut shapes);
    }
    let (face, out) = face(inputs, &scene);
    shapes.extend(bands(inputs, face, out));
    tool(inputs, &scene, &mut shapes);
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let automatic = AUTOMATIC.holds(inputs);
    let axis = if automatic { 3 } else { inputs.integer(names::MA) };
    let given = inputs.given(names::FA).unwrap_or(2.0);
    let side = if INCREMENTAL.holds(inputs) && given > 0.0 { -1.0 } else { 1.0 };
    let offset = axis > 100 && axis % 10 == 3 && !INCREMENTAL.holds(inputs);
    let radius = if offset { 16.0 } else { 6.0 };
    let inward = inputs.given(names::ID).filter(|inward| *inward > 0.0).map_or(0.0, |inward| inward.clamp(2.0, 6.0));
    Scene {
        across: usize::from(matches!(axis, 2 | 102 | 203)),
        side,
        radius,
        path: given.abs().clamp(5.0, 14.0),
        inward,
        offset: if offset { radius - inward } else { 0.0 },
    }
}

/// A point of the view from above, given along the drawn direction and across it.
fn above(scene: &Scene, along: f64, across: f64) -> [f64; 2] {
    let mut point = [across; 2];
    point[scene.across] = scene.side * along;
    point
}

/// A point of the section, given along the drawn direction and upwards.
fn cut(scene: &Scene, along: f64, up: f64) -> [f64; 2] {
    [SECTION + scene.side * along, up]
}

/// The data of the probe, and the axes of the system they belong to: square to the probe as the machine's, turned as a
/// workpiece system may be.
fn reference(inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let turned = WORKPIECE.holds(inputs);
    let (sin, cos) = (if turned { 18.0_f64 } else { 0.0 }).to_radians().sin_cos();
    let corner = [-34.0, -26.0];
    let end = |x: f64, y: f64| [corner[0] + x * cos - y * sin, corner[1] + x * sin + y * cos];
    let axes = vec![end(14.0, 0.0), corner, end(0.0, 14.0)];
    shapes.push(line(ShapeKind::Axis, axes).of(names::MVAR));
    let array = if turned { "_TPW" } else { "_TP" };
    let number = inputs.integer(names::PRNUM).clamp(1, 99) - 1;
    let label = line(ShapeKind::Label, vec![[SECTION, -CAP - 24.0]]);
    shapes.push(label.text(format!("{array}[{number},0…9]")).of(names::PRNUM));
}

/// One side of the probe, touched in the plane.
fn beside(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let start = PROBE + scene.path + scene.radius;
    let touch = PROBE + scene.radius;
    let face = vec![above(scene, PROBE, -PROBE), above(scene, PROBE, PROBE)];
    let edge = vec![cut(scene, PROBE, -CAP), cut(scene, PROBE, 0.0)];
    let way = vec![above(scene, start, 0.0), above(scene, touch, 0.0)];
    shapes.extend([
        line(ShapeKind::Edge, face).of(names::MA),
        line(ShapeKind::Edge, edge).of(names::MA),
        line(ShapeKind::Path, way).of(names::FA),
        circle(ShapeKind::Touch, above(scene, PROBE, 0.0), 0.9).of(names::NMSP),
        dimension(names::FA, cut(scene, start - scene.radius, -CAP - 7.0), cut(scene, PROBE, -CAP - 7.0)),
    ]);
    if !INCREMENTAL.holds(inputs) {
        approach(scene, start, shapes);
    }
    if inputs.integer(names::MA) > 100 && !INCREMENTAL.holds(inputs) {
        centring(scene, shapes);
    }
    if MEASURE.holds(inputs) {
        let low = -DEPTH - scene.inward;
        let at = start + scene.radius + 4.0;
        shapes.push(dimension(names::ID, cut(scene, at, low), cut(scene, at, -DEPTH)));
    }
}

/// How the cycle comes to the start of the measuring block: beside the probe, then down.
fn approach(scene: &Scene, start: f64, shapes: &mut Vec<PictureShape>) {
    let from = vec![above(scene, start, 26.0), above(scene, start, 0.0)];
    let down = vec![cut(scene, start, TOOL + 6.0), cut(scene, start, -DEPTH)];
    shapes.push(line(ShapeKind::Path, from));
    shapes.push(line(ShapeKind::Path, down));
}

/// The two touches in the other axis by which the centre is found first.
fn centring(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let start = PROBE + scene.path + scene.radius;
    for side in [1.0, -1.0] {
        let way = [start, PROBE + scene.radius].map(|at| above(scene, 0.0, side * at));
        shapes.push(line(ShapeKind::Path, way.to_vec()).of(names::MA));
        let at = above(scene, 0.0, side * PROBE);
        shapes.push(circle(ShapeKind::Touch, at, 0.9).of(names::MA));
    }
}

/// The upper side of the probe, touched along the tool axis.
fn from_above(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let edge = vec![cut(scene, -PROBE, 0.0), cut(scene, PROBE, 0.0)];
    let side = scene.offset + scene.radius + 4.0;
    let way = vec![cut(scene, scene.offset, scene.path), cut(scene, scene.offset, 0.0)];
    shapes.extend([
        rectangle(ShapeKind::Edge, [0.0; 2], [2.0 * PROBE; 2]).of(names::MA),
        line(ShapeKind::Edge, edge).of(names::MA),
        line(ShapeKind::Path, way).of(names::FA),
        circle(ShapeKind::Touch, cut(scene, 0.0, 0.0), 0.9).of(names::NMSP),
        dimension(names::FA, cut(scene, side, scene.path), cut(scene, side, 0.0)),
    ]);
    if scene.offset > 0.0 {
        let axis = vec![above(scene, 0.0, 0.0), above(scene, scene.offset, 0.0)];
        shapes.push(line(ShapeKind::Axis, axis).of(names::MA));
    }
    if inputs.uses(names::ID) {
        inward(scene, shapes);
    }
    if !INCREMENTAL.holds(inputs) {
        let up = scene.path + TOOL;
        let down = [up + 8.0, up].map(|up| cut(scene, scene.offset, up));
        shapes.push(line(ShapeKind::Path, down.to_vec()));
    }
}

/// `_ID` at a tool that is offset: from its outermost point, over the centre of the probe, inwards.
fn inward(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let out = scene.offset - scene.radius;
    let up = scene.path + 9.0;
    let point = cut(scene, out + scene.inward.max(1.0), up);
    shapes.push(dimension(names::ID, cut(scene, out, up), point));
}

/// Automatic calibration: from above, the four sides, and once more from above in the found centre (B:4700-4704).
fn all_sides(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let far = PROBE + scene.path + scene.radius;
    let sides = [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]];
    shapes.push(rectangle(ShapeKind::Edge, [0.0; 2], [2.0 * PROBE; 2]).of(names::MVAR));
    for (index, [x, y]) in sides.into_iter().enumerate() {
        let at = |distance: f64| [x * distance, y * distance];
        let way = vec![at(far), at(PROBE + scene.radius)];
        shapes.push(line(ShapeKind::Path, way).of(names::FA));
        shapes.push(circle(ShapeKind::Touch, at(PROBE), 0.9).of(names::NMSP));
        let number = line(ShapeKind::Label, vec![[x * far - 3.0, y * far + 3.0]]);
        shapes.push(number.text(format!("{}", index + 2)).of(names::MVAR));
    }
    let number = line(ShapeKind::Label, vec![cut(scene, -PROBE - 6.0, 2.0)]);
    shapes.push(number.text("1, 6").of(names::MVAR));
    from_above(inputs, scene, shapes);
}

/// The touched side in the section, and the direction out of it.
fn face(inputs: &Inputs, scene: &Scene) -> ([[f64; 2]; 2], [f64; 2]) {
    let upper = AUTOMATIC.holds(inputs) || APPLICATE.holds(inputs);
    if upper {
        let face = [cut(scene, -PROBE, 0.0), cut(scene, PROBE, 0.0)];
        return (face, [0.0, 1.0]);
    }
    let face = [cut(scene, PROBE, -CAP), cut(scene, PROBE, 0.0)];
    (face, [scene.side, 0.0])
}

/// The tool from above and in the section: smooth for calibration; with its edges standing still, or turning.
fn tool(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let upper = AUTOMATIC.holds(inputs) || APPLICATE.holds(inputs);
    let (along, up) =
        if upper { (scene.offset, scene.path) } else { (PROBE + scene.path + scene.radius, -DEPTH - scene.inward) };
    let centre = above(scene, along, 0.0);
    shapes.push(circle(ShapeKind::Probe, centre, scene.radius).of(names::MVAR));
    let step = if MEASURE.holds(inputs) { scene.inward } else { 0.0 };
    shapes.push(body(scene, along, up, step));
    if CALIBRATE.holds(inputs) {
        return;
    }
    let [x, y] = centre;
    let r = scene.radius;
    if ROTATING.holds(inputs) {
        let sense = |degrees: i32| {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            [x + 0.6 * r * cos, y + 0.6 * r * sin]
        };
        let arc = (0..=9).map(|step| sense(step * 30)).collect();
        shapes.push(line(ShapeKind::Path, arc).of(names::MVAR));
    } else {
        let edges = corners(centre, [1.2 * r, 1.2 * r]);
        for pair in [[0, 2], [1, 3]] {
            let ends = pair.iter().filter_map(|index| edges.get(*index).copied());
            shapes.push(line(ShapeKind::Axis, ends.collect()).of(names::MVAR));
        }
        shapes.push(circle(ShapeKind::Axis, [x, y], 0.2 * r).of(names::MVAR));
    }
}

/// The tool in the section; an edge whose widest point lies above the end, or whose deepest lies inside, is stepped.
fn body(scene: &Scene, along: f64, up: f64, step: f64) -> PictureShape {
    let r = scene.radius;
    let outline = if scene.offset > 0.0 {
        let tip = (r - step).max(r * 0.2);
        vec![[-r, TOOL], [-r, 2.0], [-tip, 0.0], [tip, 0.0], [r, 2.0], [r, TOOL]]
    } else {
        vec![[-r, TOOL], [-r, step], [-r * 0.7, 0.0], [r * 0.7, 0.0], [r, step], [r, TOOL]]
    };
    let place = |[x, y]: [f64; 2]| cut(scene, along + x, up + y);
    polygon(ShapeKind::Probe, outline.into_iter().map(place).collect()).of(names::MVAR)
}
