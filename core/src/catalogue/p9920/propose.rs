//! A disk where the control believes it to be, the tool above it.

use super::{CALIBRATE, diameter};
use crate::catalogue::prelude::*;
use crate::geometry::Mcs;
use crate::workpiece::ToolProbe;

/// Height of the disk, mm.
const DISK: f64 = 15.0;
/// Length of a tool that the control does not know yet, mm.
const LENGTH: f64 = 80.0;
/// Type of a mill, as on the other control.
const MILL: i64 = 120;

/// Disk, tool and start.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let calibration = inputs.variant == CALIBRATE;
    let register = if calibration { control.edge } else { inputs.integer(address::T) };
    let wide = diameter(inputs, control);
    let assumed = match inputs.given(address::H) {
        Some(length) if calibration && length > 0.0 => length,
        _ => LENGTH,
    };
    let length = control.edge_of(0, register).map_or(assumed, |edge| edge.total_length(0));
    let [top, x, y] = place(control);
    let nose = [x, y, top + inputs.number(address::Z).abs() / 2.0 + length];
    // the macro works along Z; at the call the length of another register may be active, or in another axis
    let mut in_force = control.active_length();
    if calibration {
        in_force = Dir::default();
        in_force[control.plane.axes()[2]] = length;
    }
    Proposal {
        start: control.to_workpiece(Mcs(std::array::from_fn(|axis| nose[axis] - in_force[axis]))),
        tools: vec![ProposedTool {
            tool: 0,
            name: String::new(),
            edge: register,
            data: Edge { kind: MILL, length: [length, 0.0, 0.0], radius: wide / 2.0, ..Edge::default() },
        }],
        tool_probes: vec![ToolProbe::ideal(disk(control, [x, y, top]))],
        ..Proposal::default()
    }
}

/// Upper side of the disk, then its centre in X and Y, machine coordinates, mm.
fn place(control: &Control) -> [f64; 3] {
    let [z, x, y] = ["#506", "#507", "#508"].map(|name| control.basic_length(name));
    [z - control.basic_length("#513"), x, y]
}

fn disk(control: &Control, at: [f64; 3]) -> Solid {
    let shape = Shape::Turned { diameter: control.basic_length("#509").max(1.0), length: DISK, bore: [0.0; 2] };
    Solid::new(shape, Mcs(at))
}
