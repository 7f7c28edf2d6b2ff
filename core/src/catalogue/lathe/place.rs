//! Nominal turned parts about the Z axis of the workpiece system, and the tools that a call corrects there.

use crate::catalogue::{ProposedTool, place};
use crate::check::Inputs;
use crate::control::{Control, Edge};
use crate::workpiece::{Shape, Solid};

/// Length of a proposed part, mm.
pub const LENGTH: f64 = 60.0;

/// A turned part with its front face at this Z; diameter and length, bore as [`Shape::Turned`] has it, mm.
pub fn part(control: &Control, face: f64, [diameter, length]: [f64; 2], bore: [f64; 2]) -> Solid {
    let shape = Shape::Turned {
        diameter,
        length,
        bore,
    };
    standing(
        control,
        shape,
        [0.0, 0.0, face],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
    )
}

/// A solid by its place and the directions of its X and Z, all of them X Y Z of the WCS.
pub fn standing(control: &Control, shape: Shape, at: [f64; 3], x: [f64; 3], z: [f64; 3]) -> Solid {
    let axes = control.plane.axes();
    let [at, x, z] = [at, x, z].map(|xyz| axes.map(|axis| xyz[axis]));
    place::solid(control, shape, at, x, z)
}

/// The tool that the call corrects, as a turning tool.
pub fn corrected_tools(inputs: &Inputs) -> Vec<ProposedTool> {
    let mut tools = place::corrected_tools(inputs);
    for tool in &mut tools {
        tool.data = Edge {
            kind: 500,
            tip: 3,
            length: [60.0, 40.0, 0.0],
            radius: 0.8,
            ..Edge::default()
        };
    }
    tools
}
