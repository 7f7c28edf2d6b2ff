//! CYCLE982 drawn: the probe between the axes of the plane, abscissa to the right, with the sides that are touched in
//! their order and the tool before the first of them; beside it the milling spindle, seen along its axis. Probe and
//! tool stand for any size; short distances are drawn longer than they are. A turning tool is drawn with the cutting
//! edge position of the one in use, where none is, with position 3. The ways round the probe are ours, as the figures
//! of the manual are lost.

mod tools;
mod ways;

use super::params::{
    ABSCISSA, AUTOMATIC, BOTH, CALIBRATE, DRILL, DRILL_ALONG_APPLICATE, INCREMENTAL, MEASURE, MILLING, OPPOSITE,
    RADIAL, RADIUS, REVERSAL, UPPER, WITH_RADIUS, WORKPIECE,
};
use crate::catalogue::tool_probe::figures;
use crate::catalogue::tool_probe::figures::bands;
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::name::Name;
use crate::picture::figures::{arrow, circle, dimension, line, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Half the edge length of the probe, mm.
const PROBE: f64 = 10.0;
/// Centre of the spindle, mm.
const SPINDLE: [f64; 2] = [-54.0, 24.0];
/// Radius of the tool in the spindle, mm.
const SPINDLE_RADIUS: f64 = 9.0;

/// What is drawn, mm.
struct Scene {
    tool: Tool,
    /// Index of the plane's axis along which the tool axis lies.
    along: usize,
    /// Touches in their order, never empty.
    touches: Vec<Touch>,
    path: f64,
    /// 1 in an axis in which the tool touches the plus side, else -1; see [`figures::sides`]. All else is given as if
    /// it were the plus side.
    sides: [f64; 2],
}

/// What touches the probe.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tool {
    /// Calibration tool.
    Ball,
    Insert,
    Cutter,
    Drill,
    /// Cutter that is wider than its shank.
    Disc,
}

/// A touched side.
struct Touch {
    /// Index of the plane's axis in which it is touched.
    axis: usize,
    /// 1 or -1: on which side of the probe.
    side: f64,
    /// Its numbers in the order of measurement; nothing where there is only one.
    order: &'static str,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = vec![rectangle(ShapeKind::Material, [0.0; 2], [2.0 * PROBE; 2])];
    for touch in &scene.touches {
        touched(inputs, &scene, touch, &mut shapes);
    }
    if !INCREMENTAL.holds(inputs) {
        shapes.extend(ways::between(inputs, &scene));
    }
    if let Some(first) = scene.touches.first() {
        shapes.extend(tools::shapes(inputs, &scene, first));
    }
    figures::mirror(&mut shapes, scene.sides);
    reference(inputs, &scene, &mut shapes);
    spindle(inputs, &mut shapes);
    measured(inputs, &scene, &mut shapes);
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let tool = tool(inputs);
    let along = along(inputs);
    let path = inputs.given(names::FA).filter(|path| *path > 0.0);
    let sides = match tool {
        Tool::Ball | Tool::Insert => figures::sides(inputs),
        _ => [1.0; 2],
    };
    Scene {
        tool,
        along,
        touches: touches(inputs, tool, along, sides),
        path: path.unwrap_or(2.0).clamp(5.0, 12.0),
        sides,
    }
}

/// The tool in use; where it is not known, what the variant is made for.
fn tool(inputs: &Inputs) -> Tool {
    let for_cutters = WITH_RADIUS.holds(inputs) || REVERSAL.holds(inputs) || RADIAL.holds(inputs);
    if CALIBRATE.holds(inputs) {
        Tool::Ball
    } else if UPPER.holds(inputs) {
        Tool::Disc
    } else if DRILL.holds(inputs) {
        Tool::Drill
    } else if for_cutters || MILLING.holds(inputs) {
        Tool::Cutter
    } else {
        Tool::Insert
    }
}

/// Index of the axis, Z or X as in G18, along which the tool lies: as the variant says, or that of the plane for a
/// drill with its length there (B:10102-10108).
fn along(inputs: &Inputs) -> usize {
    if DRILL_ALONG_APPLICATE.holds(inputs) {
        usize::from(inputs.plane == Plane::G19)
    } else {
        usize::from(RADIAL.holds(inputs))
    }
}

/// The touches: one, two opposite ones, or all that the tool allows, the abscissa first (B:9738-9758).
fn touches(inputs: &Inputs, tool: Tool, along: usize, sides: [f64; 2]) -> Vec<Touch> {
    let touch = |axis, side, order| Touch { axis, side, order };
    if !AUTOMATIC.holds(inputs) {
        let axis = if DRILL_ALONG_APPLICATE.holds(inputs) { along } else { usize::from(!ABSCISSA.holds(inputs)) };
        let plus = INCREMENTAL.holds(inputs) && inputs.given(names::MD) == Some(0.0);
        let told = if plus { -1.0 } else { 1.0 };
        let side = match INCREMENTAL.holds(inputs) {
            true => told * sides[axis],
            false => 1.0,
        };
        if BOTH.holds(inputs) {
            return vec![touch(axis, 1.0, "1"), touch(axis, -1.0, "2")];
        }
        return vec![touch(axis, side, "")];
    }
    let upper = if tool == Tool::Disc { -1.0 } else { 1.0 };
    match (tool, along) {
        (Tool::Drill, _) => vec![touch(along, 1.0, "")],
        (Tool::Insert, _) => match inputs.nose {
            Some([_, 0.0]) => vec![touch(0, 1.0, "")],
            Some([0.0, _]) => vec![touch(1, 1.0, "")],
            _ => vec![touch(0, 1.0, "1"), touch(1, 1.0, "2")],
        },
        (_, 0) => vec![touch(0, upper, "1, 2"), touch(1, 1.0, "3"), touch(1, -1.0, "4")],
        _ => vec![touch(0, 1.0, "1"), touch(0, -1.0, "2"), touch(1, upper, "3, 4")],
    }
}

/// A point given along the touched axis, outwards from the centre of the probe, and across it.
fn at(touch: &Touch, out: f64, beside: f64) -> [f64; 2] {
    let mut point = [beside; 2];
    point[touch.axis] = touch.side * out;
    point
}

/// The data of the probe, and the axes of the system they belong to: square to the probe as the machine's, or a
/// workpiece system with its own zero.
fn reference(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let workpiece = WORKPIECE.holds(inputs);
    let [x, y] = [-34.0 * clear(scene), -34.0];
    let corner = [x, y];
    let axes = vec![[x + 14.0, y], corner, [x, y + 14.0]];
    shapes.push(line(ShapeKind::Axis, axes).of(names::MVAR));
    if workpiece {
        shapes.push(circle(ShapeKind::Axis, corner, 2.5).of(names::MVAR));
    }
    let array = if workpiece { "_TPW" } else { "_TP" };
    let number = inputs.integer(names::PRNUM).clamp(1, 99) - 1;
    let label = line(ShapeKind::Label, vec![[corner[0], corner[1] - 7.0]]);
    shapes.push(label.text(format!("{array}[{number},0…3]")).of(names::PRNUM));
}

/// On which side of the probe there is room below for words: 1 on that of minus, -1 where the tool lies there.
fn clear(scene: &Scene) -> f64 {
    if scene.sides == [-1.0; 2] { -1.0 } else { 1.0 }
}

/// One side: its limits, the measuring motion, the point that is touched.
fn touched(inputs: &Inputs, scene: &Scene, touch: &Touch, shapes: &mut Vec<PictureShape>) {
    let start = PROBE + scene.path;
    let face = [at(touch, PROBE, -PROBE), at(touch, PROBE, PROBE)];
    let field = if AUTOMATIC.holds(inputs) { names::MVAR } else { names::MA };
    shapes.extend(bands(inputs, face, at(touch, 1.0, 0.0)));
    shapes.extend([
        line(ShapeKind::Edge, face.to_vec()).of(field),
        line(ShapeKind::Path, vec![at(touch, start, 0.0), at(touch, PROBE, 0.0)]).of(names::FA),
        circle(ShapeKind::Touch, at(touch, PROBE, 0.0), 0.8).of(names::NMSP),
        dimension(names::FA, at(touch, start, -PROBE - 3.0), at(touch, PROBE, -PROBE - 3.0)),
    ]);
    if !touch.order.is_empty() {
        let label = line(ShapeKind::Label, vec![at(touch, PROBE - 4.0, 0.0)]);
        shapes.push(label.text(touch.order).of(names::MVAR));
    }
    if inputs.uses(names::MD) {
        let (from, tip) = (at(touch, start, 6.0), at(touch, PROBE + 1.0, 6.0));
        shapes.push(line(ShapeKind::Path, vec![from, tip]).of(names::MD));
        shapes.push(arrow(ShapeKind::Path, from, tip, 2.5).of(names::MD));
    }
}

/// The tool in the milling spindle with the edge that is turned to the start angle, and the second edge of a
/// measurement with reversal.
fn spindle(inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    let [x, y] = SPINDLE;
    let edge = |degrees: f64| {
        let (sin, cos) = (degrees % 360.0).to_radians().sin_cos();
        [x + SPINDLE_RADIUS * cos, y + SPINDLE_RADIUS * sin]
    };
    let angle = |name: Name, degrees: f64| {
        [
            line(ShapeKind::Edge, vec![SPINDLE, edge(degrees)]).of(name),
            circle(ShapeKind::Touch, edge(degrees), 0.8).of(name),
        ]
    };
    let start = inputs.given(names::STA1).unwrap_or(0.0);
    let reversal = MEASURE.holds(inputs) && REVERSAL.holds(inputs);
    if !inputs.uses(names::STA1) && !reversal {
        return;
    }
    let zero = [x + SPINDLE_RADIUS + 4.0, y];
    shapes.push(circle(ShapeKind::Probe, SPINDLE, SPINDLE_RADIUS).of(names::STA1));
    shapes.push(line(ShapeKind::Axis, vec![SPINDLE, zero]).of(names::STA1));
    shapes.extend(angle(names::STA1, start));
    if inputs.uses(names::STA1) {
        let label = line(ShapeKind::Label, vec![[x, y + SPINDLE_RADIUS + 4.0]]);
        shapes.push(label.text(names::STA1).of(names::STA1));
    }
    if reversal {
        let second = start % 360.0 + 180.0 + inputs.number(names::CORA) % 360.0;
        shapes.extend(angle(names::CORA, second));
    }
}

/// Names of the sizes that are corrected.
fn measured(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let length = |axis| if axis == 0 { "L2" } else { "L1" };
    let Some(first) = scene.touches.first().filter(|_| MEASURE.holds(inputs)) else {
        return;
    };
    let text = match scene.tool {
        Tool::Cutter | Tool::Disc if AUTOMATIC.holds(inputs) => "L1 L2 R".to_owned(),
        Tool::Insert if scene.touches.len() > 1 => "L1 L2".to_owned(),
        _ if RADIUS.holds(inputs) => "R".to_owned(),
        _ if BOTH.holds(inputs) => format!("{} R", length(first.axis)),
        _ if DRILL_ALONG_APPLICATE.holds(inputs) => "L1".to_owned(),
        _ => length(first.axis).to_owned(),
    };
    let label = line(ShapeKind::Label, vec![[SPINDLE[0] * clear(scene), -PROBE - 20.0]]);
    shapes.push(label.text(text).of(names::MVAR));
    let against = scene.touches.iter().find(|touch| touch.axis == scene.along);
    if let Some(touch) = against.filter(|_| OPPOSITE.holds(inputs)) {
        let (from, tip) = (at(touch, PROBE + 9.0, 6.0), at(touch, PROBE + 1.0, 6.0));
        shapes.push(arrow(ShapeKind::Path, from, tip, 2.5).of(names::MVAR));
    }
}
