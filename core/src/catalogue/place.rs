//! Nominal parts and the probe in the active plane: what proposals and checks of the milling cycles share.

use crate::catalogue::prelude::*;
use crate::evaluate::knum;
use crate::geometry::rigid::angles;
use crate::workpiece::{PartErrors, Workpiece};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Ball radius that the cycle calculates with, mm: half of `_WP[k,0]` of the probe in `_PRNUM` (B:13442), else the
/// radius of the active tool, else 3 mm, the ball of the manual's examples.
pub fn ball_radius(inputs: &Inputs, control: &Control) -> f64 {
    let index = inputs.integer(names::PRNUM) % 100 - 1;
    let stored = control.number(&format!("_WP[{index},0]")) / 2.0;
    let per = crate::entry::factor(crate::entry::Unit::BasicLength, control);
    let active = control.edge_of(control.tool, control.edge).map_or(0.0, |edge| edge.radius);
    [stored * per, active, 3.0].into_iter().find(|radius| *radius > 0.0).unwrap_or(3.0)
}

/// A point given as abscissa, ordinate, applicate in X Y Z of the WCS.
pub fn in_plane(control: &Control, point: [f64; 3]) -> [f64; 3] {
    let mut xyz = [0.0; 3];
    for (index, axis) in control.plane.axes().into_iter().enumerate() {
        xyz[axis] = point[index];
    }
    xyz
}

/// The direction of a geometry axis, or of an axis of the plane, of length 1.
pub fn unit(axis: usize) -> [f64; 3] {
    let mut unit = [0.0; 3];
    unit[axis] = 1.0;
    unit
}

/// On which side of a part the probe stands: +1 on the plus side of the applicate, -1 where its body lies on the minus
/// side, as that of a turning machine's probe with cutting edge position 5 or 6.
pub fn side(control: &Control) -> f64 {
    let Some(stands) = control.active_edge().and_then(Edge::stands) else { return 1.0 };
    let up = control.direction_to_machine(Dir::new(in_plane(control, [0.0, 0.0, 1.0]))).0;
    let along: f64 = up.iter().zip(stands.0).map(|(a, b)| a * b).sum();
    if along < 0.0 { -1.0 } else { 1.0 }
}

/// A nominal solid by its origin and the directions of its X and Z axes: abscissa, ordinate, applicate of the WCS.
pub fn solid(control: &Control, shape: Shape, at: [f64; 3], x: [f64; 3], z: [f64; 3]) -> Solid {
    let direction = |axis: [f64; 3]| Vector3::from(control.direction_to_machine(Dir::new(in_plane(control, axis))).0);
    let (x, z) = (direction(x), direction(z));
    let columns = Matrix3::from_columns(&[x, z.cross(&x), z]);
    Solid {
        shape,
        at: control.to_machine(Wcs(in_plane(control, at))),
        rotation: angles(&Rotation3::from_matrix_unchecked(columns)),
        errors: PartErrors::default(),
    }
}

/// Length of a groove or web across its width, mm.
pub fn along(width: f64) -> f64 {
    (width * 1.5).max(40.0)
}

/// Hole, shaft, groove, web, pocket or island, as the last digit of `_MVAR` counts them from 1 in CYCLE977 and CYCLE979
/// (B:5645-5650, B:6766-6769); diameter, width or both lengths, depth or height in mm.
pub fn element(kind: i64, length: [f64; 2], height: f64) -> Shape {
    let [size, _] = length;
    match kind {
        1 => Shape::Hole { diameter: size, depth: height },
        2 => Shape::Shaft { diameter: size, height },
        3 => Shape::Groove { width: size, depth: height, length: along(size) },
        4 => Shape::Web { width: size, height, length: along(size) },
        5 => Shape::Pocket { length, depth: height },
        _ => Shape::Island { length, height },
    }
}

/// Size of a block whose face is touched, mm: two sides of the face and the thickness behind it.
const FACE: [f64; 3] = [60.0, 60.0, 40.0];
/// How far below the upper edge of the block a side face is touched, mm.
const FACE_DEPTH: f64 = 10.0;

/// Out of a part whose face the probe stands on: abscissa, ordinate, applicate.
pub fn outward(control: &Control) -> [f64; 3] {
    [0.0, 0.0, side(control)]
}

/// A block with a face at `set` of an axis (0 abscissa, 1 ordinate, 2 applicate), and the position opposite that face,
/// `away` from it; `side` +1: outside is the plus side of the axis.
pub fn face(control: &Control, axis: usize, set: f64, side: f64, away: f64) -> (Solid, [f64; 3]) {
    let (mut at, mut start, mut normal) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    (at[axis], start[axis], normal[axis]) = (set, set + side * away, side);
    if axis != 2 {
        at[2] = self::side(control) * (FACE_DEPTH - FACE[0] / 2.0);
    }
    let x = if axis == 2 { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let block = solid(control, Shape::Block { size: FACE }, at, x, normal);
    (block, in_plane(control, start))
}

/// Start height of the ball centre and measuring depth below the face: the infeed is their sum. The ball stays clear
/// of the face by a third of what is left, at most 10 mm.
pub fn above(infeed: f64, ball: f64) -> (f64, f64) {
    let clear = ((infeed - ball) / 3.0).clamp(0.5, 10.0);
    let start = ball + clear;
    (start, (infeed - start).max(0.0))
}

/// A part, and the position from which it is measured.
pub fn proposal(part: Solid, start: [f64; 3]) -> Proposal {
    Proposal { workpiece: Workpiece { solids: vec![part] }, start: Wcs(start), ..Proposal::default() }
}

/// The tool that `_KNUM` and `_TNUM` or `_TNAME` name, as an end mill of 20 mm; none without a tool offset.
pub fn corrected_tools(inputs: &Inputs) -> Vec<ProposedTool> {
    let code = knum::tool(inputs.integer(names::KNUM), inputs.five_digit_edges);
    let (number, name) = (inputs.number(names::TNUM) as i64, inputs.text(names::TNAME));
    let tool = match (number, name) {
        (0, "") => return Vec::new(),
        (0, _) => NAMED,
        _ => number,
    };
    match code {
        Ok(Some(code)) => vec![ProposedTool { tool, name: name.to_owned(), edge: code.edge, data: end_mill() }],
        _ => Vec::new(),
    }
}

/// T number that tool management would give to a tool that is known by its name only.
const NAMED: i64 = 1;

fn end_mill() -> Edge {
    Edge { kind: 120, length: [100.0, 0.0, 0.0], radius: 10.0, ..Edge::default() }
}
