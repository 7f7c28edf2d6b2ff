//! CYCLE982 and CYCLE972 drawn: the probe between the axes of the plane, abscissa to the right, with the sides that are
//! touched in their order and the tool before the first of them; beside it the milling spindle, seen along its axis.
//! Probe and tool stand for any size. A turning tool has the cutting edge position of the one in use, where none is,
//! position 3. Of a calibration tool, which is bent (B:9907), the simulation knows the ball alone: it is drawn here.

use super::params::{
    ABSCISSA, AUTOMATIC, BOTH, CALIBRATE, DRILL, DRILL_ALONG_APPLICATE, INCREMENTAL, MEASURE, MILLING, OPPOSITE,
    RADIAL, RADIUS, REVERSAL, UPPER, WITH_RADIUS, WORKPIECE,
};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::figures::{HALF, cube, label, limits};
use crate::control::{TOOL_LENGTH_TYPE, tools::side};
use crate::entry::stage::{Touched, unit};
use crate::picture::figures::{arrow, polar, polygon};

/// Centre of the spindle, mm.
const SPINDLE: [f64; 2] = [-54.0, 24.0];
/// Radius of the tool in the spindle, mm.
const SPINDLE_RADIUS: f64 = 9.0;
/// Types of turning tools, milling tools and drills.
const TURNING_TOOL: i64 = 500;
const MILLING_TOOL: i64 = 120;
const TWIST_DRILL: i64 = 200;
/// Radius of the calibration tool, of the nose of a turning tool, of milling tool and drill, and of a disc, whose shank
/// passes the probe while its edge touches the middle (B:9779); mm.
const RADII: [f64; 4] = [5.0, 1.5, 6.0, 16.0];
/// Length of a turning tool in the axis in which it is measured, mm.
const LENGTH: f64 = 40.0;
/// The shank of a calibration tool from the centre of its ball, mm.
const BENT: [[f64; 2]; 5] = [[1.5, 4.0], [4.0, 1.5], [30.0, 16.0], [30.0, 30.0], [16.0, 30.0]];

/// Type of the tool in use; where it is not known, of what the variant is made for.
fn kind(inputs: &Inputs) -> i64 {
    let for_cutters = WITH_RADIUS.holds(inputs) || REVERSAL.holds(inputs) || RADIAL.holds(inputs);
    if CALIBRATE.holds(inputs) {
        TURNING_TOOL
    } else if DRILL.holds(inputs) && !UPPER.holds(inputs) {
        TWIST_DRILL
    } else if for_cutters || MILLING.holds(inputs) {
        MILLING_TOOL
    } else {
        TURNING_TOOL
    }
}

/// The tool in use, as long as it can be drawn.
fn tool(inputs: &Inputs) -> Edge {
    let kind = kind(inputs);
    let nose = inputs.nose.filter(|_| !CALIBRATE.holds(inputs));
    let points = |tip: &i64| Some(side(*tip, inputs.recodes())) == nose;
    let tip = (1..=8).find(points).unwrap_or(3);
    if kind != TURNING_TOOL {
        return Edge { kind, length: [60.0, 60.0, 0.0], ..Edge::default() };
    }
    let [abscissa, ordinate] = side(tip, inputs.recodes()).map(|side| -side * LENGTH);
    let length = if ABSCISSA.holds(inputs) { [ordinate / 2.0, abscissa, 0.0] } else { [ordinate, abscissa / 2.0, 0.0] };
    Edge { kind, tip, length, ..Edge::default() }
}

/// The touches in their order where there are several; the end of a milling tool is touched twice (B:9738-9758).
fn order(inputs: &Inputs) -> &'static [&'static str] {
    let pointed = inputs.nose.is_some_and(|nose| nose.contains(&0.0));
    match (kind(inputs), AUTOMATIC.holds(inputs)) {
        (MILLING_TOOL, true) if RADIAL.holds(inputs) => &["1", "2", "3, 4"],
        (MILLING_TOOL, true) => &["1, 2", "3", "4"],
        (TURNING_TOOL, true) if pointed => &[],
        (_, true) => &["1", "2"],
        _ if BOTH.holds(inputs) => &["1", "2"],
        _ => &[],
    }
}

/// The probe as a cube about the zero point, the tool before it.
pub fn stage(inputs: &Inputs) -> Staging {
    let edges: &[Name] = if AUTOMATIC.holds(inputs) { &[names::MVAR] } else { &[names::MA] };
    let fields = Fields { edges, marks: order(inputs), mark: None, probe: Some(names::MVAR), ..Fields::CYCLE };
    let along_applicate = DRILL_ALONG_APPLICATE.holds(inputs);
    // Z to the right and X up, as in G18
    let [right, up] = match inputs.plane {
        Plane::G17 if along_applicate => [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
        Plane::G19 if along_applicate => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        _ => [Look::ABOVE.right, Look::ABOVE.up],
    };
    let shown = (!CALIBRATE.holds(inputs)).then_some(names::MVAR);
    let look = Look { right, up, balls: false, called: false, tool: shown, ..Look::ABOVE }.ways(names::MVAR);
    let mut data = cube();
    data.extend(along_applicate.then(|| (TOOL_LENGTH_TYPE.to_owned(), 0.0)));
    let radius = match kind(inputs) {
        _ if CALIBRATE.holds(inputs) => 0,
        TURNING_TOOL => 1,
        _ if UPPER.holds(inputs) => 3,
        _ => 2,
    };
    let plane = along_applicate.then_some(inputs.plane);
    let stage = Staging { data, tool: Some(tool(inputs)), plane, ..Staging::new(look, fields) };
    stage.ball(RADII[radius]).short(inputs, names::FA, [5.0, 12.0])
}

/// Paths, limits, sizes, the system of the data and the spindle.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let Some((seen, first)) = looks.first().and_then(|seen| Some((seen, seen.touches.first()?))) else {
        return Vec::new();
    };
    let mut shapes = limits(inputs, seen);
    for touch in &seen.touches {
        let axis = measured_in(touch);
        let at = -beside(seen, 1 - axis) * (HALF + 3.0);
        let path = [touch.at, add(touch.at, [0, 1].map(|axis| touch.start[axis] - touch.ball[axis]))];
        shapes.push(seen.along(names::FA, axis, [path[1], path[0]], at));
        if inputs.uses(names::MD) {
            shapes.extend(towards(names::MD, touch));
        }
        if OPPOSITE.holds(inputs) && axis == usize::from(RADIAL.holds(inputs)) {
            shapes.extend(towards(names::MVAR, touch));
        }
    }
    if !INCREMENTAL.holds(inputs) {
        shapes.push(circle(ShapeKind::Path, seen.start, 1.2).of(names::MVAR));
    }
    if CALIBRATE.holds(inputs) {
        shapes.extend(calibration_tool(inputs, seen, first));
    } else {
        shapes.extend(sizes(inputs, seen, first));
    }
    shapes.extend(reference(inputs, seen));
    shapes.extend(spindle(inputs));
    shapes
}

/// Axis of the plane in which a side is touched.
fn measured_in(touch: &Touched) -> usize {
    usize::from(out(touch)[0].abs() < 0.5)
}

/// Direction from the probe back to the start.
fn out(touch: &Touched) -> [f64; 2] {
    unit(touch.ball, touch.start)
}

/// On which side of the probe the tool stands at the call, 1 or -1.
fn beside(seen: &Seen, axis: usize) -> f64 {
    if seen.start[axis] < seen.zero[axis] - 1e-3 { -1.0 } else { 1.0 }
}

/// On which side of the probe there is room below for words: 1 on that of minus, -1 where the tool lies there.
fn clear(seen: &Seen) -> f64 {
    if (0..2).all(|axis| beside(seen, axis) < 0.0) { -1.0 } else { 1.0 }
}

/// Where words stand below all ways.
fn below(seen: &Seen) -> f64 {
    seen.extent[0][1] - 18.0
}

/// The direction of a touch as an arrow beside its path.
fn towards(field: Name, touch: &Touched) -> [PictureShape; 2] {
    let [x, y] = out(touch);
    let [from, tip] = [9.0, 1.0].map(|away| add(touch.at, [x * away + y.abs() * 6.0, y * away + x.abs() * 6.0]));
    [line(ShapeKind::Path, vec![from, tip]), arrow(ShapeKind::Path, from, tip, 2.5)].map(|shape| shape.of(field))
}

/// Ball and shank, which is bent away from the side that is touched.
fn calibration_tool(inputs: &Inputs, seen: &Seen, touch: &Touched) -> [PictureShape; 2] {
    let nose = side(3, inputs.recodes());
    let centre = [0, 1].map(|axis| touch.start[axis] - nose[axis] * seen.ball);
    let out = out(touch);
    let away = [0, 1].map(|axis| if out[axis].abs() > 0.5 { out[axis] } else { -nose[axis] });
    let shank = BENT.map(|point| [0, 1].map(|axis| centre[axis] + away[axis] * point[axis]));
    [polygon(ShapeKind::Probe, shank.to_vec()), circle(ShapeKind::Probe, centre, seen.ball)]
        .map(|shape| shape.of(names::MVAR))
}

/// The sizes that are corrected: by name, one length of a turning tool and the radius of a milling tool as dimensions.
fn sizes(inputs: &Inputs, seen: &Seen, first: &Touched) -> Vec<PictureShape> {
    let axis = measured_in(first);
    let [along, across] = if RADIAL.holds(inputs) { [1, 0] } else { [0, 1] };
    let length = if axis == 0 && !DRILL_ALONG_APPLICATE.holds(inputs) { "L2" } else { "L1" };
    let turning = kind(inputs) == TURNING_TOOL;
    if turning && seen.touches.len() == 1 {
        let beside = beside(seen, 1 - axis);
        let at = seen.extent[usize::from(beside > 0.0)][1 - axis] + 5.0 * beside;
        let end = add(first.start, out(first).map(|part| part * LENGTH));
        return vec![seen.along(names::MA, axis, [first.start, end], at).text(length)];
    }
    let names = match kind(inputs) {
        TURNING_TOOL => "L1 L2".to_owned(),
        MILLING_TOOL if AUTOMATIC.holds(inputs) => "L1 L2 R".to_owned(),
        _ if RADIUS.holds(inputs) => "R".to_owned(),
        _ if BOTH.holds(inputs) => format!("{length} R"),
        _ => length.to_owned(),
    };
    let at = [SPINDLE[0] * clear(seen), below(seen) + 4.0];
    let mut shapes = vec![line(ShapeKind::Label, vec![at]).text(names).of(names::MVAR)];
    if kind(inputs) == MILLING_TOOL || axis == across && !DRILL_ALONG_APPLICATE.holds(inputs) {
        let mut edge = first.start;
        edge[across] += seen.ball * (seen.zero[across] - edge[across]).signum();
        let beyond = if UPPER.holds(inputs) { -7.0 } else { 26.0 };
        let radius = seen.along(names::MVAR, across, [first.start, edge], first.start[along] + beyond);
        shapes.push(radius.text("R"));
    }
    shapes
}

/// The data of the probe, and the axes of the system they belong to: square to the probe as the machine's, or a
/// workpiece system with its own zero.
fn reference(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let [x, y] = [-34.0 * clear(seen), below(seen)];
    let axes = line(ShapeKind::Axis, vec![[x + 14.0, y], [x, y], [x, y + 14.0]]).of(names::MVAR);
    let mut shapes = vec![axes, label(inputs, [x, y - 7.0], 3)];
    shapes.extend(WORKPIECE.holds(inputs).then(|| circle(ShapeKind::Axis, [x, y], 2.5).of(names::MVAR)));
    shapes
}

/// The tool in the milling spindle with the edge that is turned to the start angle, and the second edge of a
/// measurement with reversal.
fn spindle(inputs: &Inputs) -> Vec<PictureShape> {
    let used = inputs.uses(names::STA1);
    let reversal = MEASURE.holds(inputs) && REVERSAL.holds(inputs);
    if !used && !reversal {
        return Vec::new();
    }
    let edge = |name: Name, degrees: f64| {
        let at = add(SPINDLE, polar(degrees % 360.0, SPINDLE_RADIUS));
        [line(ShapeKind::Edge, vec![SPINDLE, at]), circle(ShapeKind::Touch, at, 0.8)].map(|shape| shape.of(name))
    };
    let start = inputs.given(names::STA1).unwrap_or(0.0);
    let body = [
        circle(ShapeKind::Probe, SPINDLE, SPINDLE_RADIUS),
        line(ShapeKind::Axis, vec![SPINDLE, add(SPINDLE, [SPINDLE_RADIUS + 4.0, 0.0])]),
    ];
    let mut shapes = body.map(|shape| shape.of(names::STA1)).to_vec();
    shapes.extend(edge(names::STA1, start));
    if used {
        let at = add(SPINDLE, [0.0, SPINDLE_RADIUS + 4.0]);
        shapes.push(line(ShapeKind::Label, vec![at]).text(names::STA1).of(names::STA1));
    }
    if reversal {
        shapes.extend(edge(names::CORA, start % 360.0 + 180.0 + inputs.degrees(names::CORA).within_turn().0));
    }
    shapes
}
