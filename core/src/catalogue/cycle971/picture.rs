//! CYCLE971 drawn: at the left the probe from above, at the right the section in which the tool touches it. Probe and
//! tool stand for any size.

use super::params::{APPLICATE, AUTOMATIC, CALIBRATE, INCREMENTAL, MEASURE, ROTATING, WORKPIECE};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::figures::{cube, label, limits};
use crate::picture::figures::{arc, corners, polygon};

/// Length of the drawn tool, mm.
const TOOL: f64 = 22.0;
/// Radius of a tool, and of one whose edge is touched from above beside its axis, mm.
const RADIUS: [f64; 2] = [6.0, 16.0];

/// The touches of automatic calibration: the upper side comes first and once more at the end (B:4700-4704).
const ORDER: [&str; 5] = ["1, 6", "2", "3", "4", "5"];

/// The axis in which the tool stands beside the probe or is offset: abscissa or ordinate.
fn across(inputs: &Inputs) -> usize {
    usize::from(!AUTOMATIC.holds(inputs) && matches!(inputs.integer(names::MA), 2 | 102 | 203))
}

/// Whether the upper side is touched.
fn upper(inputs: &Inputs) -> bool {
    AUTOMATIC.holds(inputs) || APPLICATE.holds(inputs)
}

/// Whether the tool is offset there.
fn offset(inputs: &Inputs) -> bool {
    let aside = APPLICATE.holds(inputs) && inputs.integer(names::MA) > 100;
    aside && !INCREMENTAL.holds(inputs) && !AUTOMATIC.holds(inputs)
}

/// `_ID`, as far as it can be drawn.
fn inward(inputs: &Inputs) -> f64 {
    inputs.given(names::ID).filter(|inward| *inward > 0.0).map_or(0.0, |inward| inward.clamp(2.0, 6.0))
}

/// The probe as a cube about the zero point, the tool before it.
pub fn stage(inputs: &Inputs) -> Staging {
    let fields = Fields { edges: &[names::MA], probe: Some(names::MVAR), mark: None, ..Fields::CYCLE };
    let marks: &[_] = if AUTOMATIC.holds(inputs) { &ORDER } else { &[] };
    let above = Look { called: false, flat: true, ..Look::ABOVE };
    let section = Look { called: false, balls: false, cut: false, ..Look::section(across(inputs)).ways(names::MVAR) };
    Staging { data: cube(), ..Staging::new(above, Fields { marks, ..fields }) }
        .ball(RADIUS[usize::from(offset(inputs))])
        .short(inputs, names::FA, [5.0, 14.0])
        .with(names::ID, inward(inputs))
        .beside(true, section.touching(if AUTOMATIC.holds(inputs) { 1 } else { u32::MAX }))
}

/// Path, edge, limits, the tool and the system of the data.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, section] = looks else { return Vec::new() };
    let mut shapes = limits(inputs, section);
    shapes.extend(reference(inputs, above, section));
    let Some(touch) = section.touches.last() else { return shapes };
    let radius = section.ball;
    shapes.push(body(inputs, touch.start, radius));
    let side = (touch.start[0] - section.middle()[0]).signum();
    let (low, beyond) = (section.extent[0][1], touch.start[0] + side * (radius + 4.0));
    if upper(inputs) {
        shapes.push(section.along(names::FA, 1, [touch.start, touch.ball], beyond));
        if inputs.uses(names::ID) {
            let at = add(touch.start, [-side * radius, 9.0]);
            let ends = [at, add(at, [side * inward(inputs).max(1.0), 0.0])];
            shapes.push(dimension(names::ID, ends[0], ends[1]));
        }
    } else {
        let ends = [touch.start, touch.ball].map(|[x, y]| [x - side * radius, y]);
        shapes.push(section.along(names::FA, 0, ends, low - 4.0));
        if MEASURE.holds(inputs) {
            let deep = [beyond, touch.start[1]];
            shapes.push(dimension(names::ID, deep, add(deep, [0.0, inward(inputs)])));
        }
    }
    if let Some(touch) = above.touches.last().filter(|_| !CALIBRATE.holds(inputs)) {
        shapes.extend(edges(inputs, touch.start, radius));
    }
    shapes
}

/// The data of the probe, and the axes of the system they belong to: square to the probe as the machine's, turned as a
/// workpiece system may be.
fn reference(inputs: &Inputs, above: &Seen, section: &Seen) -> [PictureShape; 2] {
    let turned = WORKPIECE.holds(inputs);
    let (sin, cos) = (if turned { 18.0_f64 } else { 0.0 }).to_radians().sin_cos();
    let corner = [above.extent[0][0] - 14.0, above.extent[0][1] - 14.0];
    let end = |x: f64, y: f64| add(corner, [x * cos - y * sin, x * sin + y * cos]);
    let axes = vec![end(14.0, 0.0), corner, end(0.0, 14.0)];
    let at = [section.middle()[0], section.extent[0][1] - 14.0];
    [line(ShapeKind::Axis, axes).of(names::MVAR), label(inputs, at, 9)]
}

/// The tool in the section; an edge whose widest point lies above the end, or whose deepest lies inside, is stepped.
fn body(inputs: &Inputs, at: [f64; 2], r: f64) -> PictureShape {
    let step = if MEASURE.holds(inputs) { inward(inputs) } else { 0.0 };
    let outline = match offset(inputs) {
        true => {
            let tip = (r - step).max(r * 0.2);
            [[-r, TOOL], [-r, 2.0], [-tip, 0.0], [tip, 0.0], [r, 2.0], [r, TOOL]]
        }
        false => [[-r, TOOL], [-r, step], [-r * 0.7, 0.0], [r * 0.7, 0.0], [r, step], [r, TOOL]],
    };
    polygon(ShapeKind::Probe, outline.map(|point| add(at, point)).to_vec()).of(names::MVAR)
}

/// The tool from above: with its edges standing still, or turning.
fn edges(inputs: &Inputs, centre: [f64; 2], r: f64) -> Vec<PictureShape> {
    if ROTATING.holds(inputs) {
        return vec![line(ShapeKind::Path, arc(centre, 0.6 * r, 0.0, 270.0)).of(names::MVAR)];
    }
    let [a, b, c, d] = corners(centre, [1.2 * r; 2])[..] else { return Vec::new() };
    let edge = |from, to| line(ShapeKind::Axis, vec![from, to]).of(names::MVAR);
    vec![edge(a, c), edge(b, d), circle(ShapeKind::Axis, centre, 0.2 * r).of(names::MVAR)]
}
