//! Macros of which one axis of the plane takes the nominal value, and the tool axis a depth: G105 and G109.

use super::params::{ALONG_X, ALONG_Y, ALONG_Z, COORDINATE};
use super::{FORMAT_ERROR, axis_of, given};
use crate::catalogue::prelude::*;

/// X: a depth where it is the tool axis, else one of the two nominal values. Key and place in the manual are those of
/// the macro.
pub const X: Param = Param { name: address::X, needs: &needs(ALONG_X), ..COORDINATE };
/// Y: a depth where it is the tool axis, else one of the two nominal values.
pub const Y: Param = Param { name: address::Y, needs: &needs(ALONG_Y), ..COORDINATE };
/// Z: a depth where it is the tool axis, else one of the two nominal values.
pub const Z: Param = Param { name: address::Z, needs: &needs(ALONG_Z), ..COORDINATE };

const fn needs(along_tool: When) -> [Need; 2] {
    [optional(along_tool, "need-nct-depth"), optional(When::Always, "need-nct-one-axis")]
}

/// Index (0 or 1) of the axis of the plane whose nominal value is given; none where not exactly one is.
fn only(inputs: &Inputs) -> Option<usize> {
    match [0, 1].map(|index| given(inputs, index).is_some()) {
        [true, false] => Some(0),
        [false, true] => Some(1),
        _ => None,
    }
}

/// The same; 0 where there is none.
pub fn index(inputs: &Inputs) -> usize {
    only(inputs).unwrap_or(0)
}

/// Address and value of that axis.
pub fn nominal(inputs: &Inputs) -> (Name, f64) {
    let name = axis_of(inputs, index(inputs));
    (name, inputs.number(name))
}

/// The depth in a section, where it is given.
pub fn depth_mark(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    given(inputs, 2).map_or_else(Vec::new, |_| seen.depth(axis_of(inputs, 2)))
}

/// Whether the nominal value is known. Neither axis of the plane (C:519-532), or both: then the surface is not known
/// either.
pub fn check(inputs: &Inputs, findings: &mut Vec<Diagnostic>) -> bool {
    if only(inputs).is_some() {
        return true;
    }
    let first = axis_of(inputs, 0);
    let message = Message::new("nct-one-axis").text("first", first).text("second", axis_of(inputs, 1));
    findings.push(error(FORMAT_ERROR, message).hint(Message::new("nct-one-axis-hint")).at(first));
    false
}
