//! A nominal part for CYCLE978: a block whose face stands at the set position.

use crate::catalogue::{Proposal, names, place};
use crate::check::Inputs;
use crate::control::Control;
use crate::workpiece::{Shape, Workpiece};

/// Size of the block, mm: two sides of the face and the thickness behind it.
const SIZE: [f64; 3] = [60.0, 60.0, 40.0];
/// How far below the upper edge a side face is touched, mm.
const DEPTH: f64 = 10.0;

/// Part and start: opposite the surface, further away than `_FA` (B:6376-6384); from the minus side in the plane,
/// from above along the applicate.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let set = inputs.number(names::SETVAL);
    let axis = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let away = inputs.number(names::FA) + place::ball_radius(inputs, control) + 5.0;
    let side = if axis == 2 { 1.0 } else { -1.0 };
    let (mut at, mut start, mut normal) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    (at[axis], start[axis], normal[axis]) = (set, set + side * away, side);
    if axis != 2 {
        at[2] = DEPTH - SIZE[0] / 2.0;
    }
    let x = if axis == 2 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let part = place::solid(control, Shape::Block { size: SIZE }, at, x, normal);
    Proposal {
        workpiece: Workpiece { solids: vec![part] },
        start: place::in_plane(control, start),
        tools: place::corrected_tools(inputs),
        ..Proposal::default()
    }
}
