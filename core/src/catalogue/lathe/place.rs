//! Nominal turned parts about the Z axis of the workpiece system, and the tools that a call corrects there.

use crate::catalogue::prelude::*;
use crate::geometry::rigid;
use crate::workpiece::PartErrors;

/// Length of a proposed part, mm.
pub const LENGTH: f64 = 60.0;

/// A turned part with its front face at this Z; diameter and length, bore as [`Shape::Turned`] has it, mm.
fn part(control: &Control, face: f64, [diameter, length]: [f64; 2], bore: [f64; 2]) -> Solid {
    let shape = Shape::Turned { diameter, length, bore };
    standing(control, shape, [0.0, 0.0, face], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
}

/// A solid by its place and the directions of its X and Z, all of them X Y Z of the WCS.
pub fn standing(control: &Control, shape: Shape, at: [f64; 3], x: [f64; 3], z: [f64; 3]) -> Solid {
    let axes = control.plane.axes();
    let [at, x, z] = [at, x, z].map(|xyz| axes.map(|axis| xyz[axis]));
    place::solid(control, shape, at, x, z)
}

/// How far the front face stands before the place where the outside is touched, mm.
const BEHIND: f64 = 20.0;
/// Diameter of an end face, mm, and size of a block where no turned part has such a surface.
const FACE: f64 = 40.0;

/// A part with a surface at `set` of a geometry axis and the position opposite it, `away` from it; `side` +1: outside
/// is the plus side. End face and outside are those of a turned part, anything else is a block.
pub fn touched(control: &Control, axis: usize, set: f64, side: f64, away: f64) -> (Solid, [f64; 3]) {
    let mut start = [0.0; 3];
    start[axis] = set + side * away;
    if axis == 2 {
        start[0] = FACE / 4.0; // an end face beside its middle
    }
    let part = if axis == 2 && side > 0.0 {
        part(control, set, [FACE, LENGTH], [0.0; 2])
    } else if axis != 2 && set * side > 0.0 {
        part(control, BEHIND, [2.0 * set.abs(), LENGTH], [0.0; 2])
    } else {
        let (mut at, mut x, mut z) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        (at[axis], z[axis], x[(axis + 1) % 3]) = (set, side, 1.0);
        let size = [FACE, FACE, LENGTH];
        standing(control, Shape::Block { size }, at, x, z)
    };
    (part, start)
}

/// How long a chuck is, how far it stands out around the part, and how deep the part is in it, mm.
const CHUCK: [f64; 3] = [30.0, 20.0, 8.0];

/// The chuck that holds a turned part, without errors of its own; other parts have none.
pub fn chuck(part: &Solid) -> Option<Solid> {
    let Shape::Turned { diameter, length, .. } = part.shape else { return None };
    let [long, around, deep] = CHUCK;
    let behind = rigid::rotation(part.rotation) * V3::from([0.0, 0.0, deep - length]);
    Some(Solid {
        shape: Shape::Chuck { diameter: diameter + 2.0 * around, length: long, grip: diameter },
        at: (V3::from(part.at) + behind).into(),
        rotation: part.rotation,
        errors: PartErrors::default(),
    })
}

/// A part in its chuck, and the position from which it is measured.
pub fn proposal(part: Solid, start: [f64; 3]) -> Proposal {
    Proposal { fixture: chuck(&part).into_iter().collect(), ..place::proposal(part, start) }
}

/// The tool that the call corrects, as a turning tool.
pub fn corrected_tools(inputs: &Inputs) -> Vec<ProposedTool> {
    let mut tools = place::corrected_tools(inputs);
    for tool in &mut tools {
        tool.data = Edge { kind: 500, tip: 3, length: [60.0, 40.0, 0.0], radius: 0.8, ..Edge::default() };
    }
    tools
}
