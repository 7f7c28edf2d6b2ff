//! Macros of which one axis of the plane takes the nominal value, and the tool axis a depth: G105 and G109.

use super::{FORMAT_ERROR, axis_name};
use crate::catalogue::common::optional;
use crate::check::error;
use crate::control::{Control, Plane};
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, Need, When};
use crate::message::Message;
use crate::name::Name;

const fn need(plane: Plane, reason: &'static str) -> Need {
    optional(When::Plane(plane), reason)
}

/// Needs of X, Y or Z: a depth where it is the tool axis, else one of the two nominal values.
pub const fn needs(tool_axis_in: Plane) -> [Need; 2] {
    [need(tool_axis_in, "need-nct-depth"), optional(When::Always, "need-nct-one-axis")]
}

/// Index (0 or 1) of the axis of the plane whose nominal value is given; none where not exactly one is.
pub fn index(inputs: &Inputs) -> Option<usize> {
    let [first, second, _] = inputs.plane.axes();
    let given = [first, second].map(|axis| inputs.given(axis_name(axis)).is_some());
    match given {
        [true, false] => Some(0),
        [false, true] => Some(1),
        _ => None,
    }
}

/// Address and value of that axis; 0 where there is none.
pub fn nominal(inputs: &Inputs) -> (Name, f64) {
    let name = axis_name(inputs.plane.axes()[index(inputs).unwrap_or(0)]);
    (name, inputs.number(name))
}

/// Address of the tool axis, and the depth where it is given, mm.
pub fn depth(inputs: &Inputs) -> (Name, Option<f64>) {
    let [.., applicate] = inputs.plane.axes();
    let name = axis_name(applicate);
    (name, inputs.given(name))
}

/// Neither axis of the plane (C:519-532), or both: then the surface is not known either.
pub fn check(inputs: &Inputs, _: &Control, findings: &mut Vec<Diagnostic>) {
    if index(inputs).is_some() {
        return;
    }
    let [first, second, _] = inputs.plane.axes().map(axis_name);
    let message = Message::new("nct-one-axis").text("first", first).text("second", second);
    findings.push(error(FORMAT_ERROR, message).hint(Message::new("nct-one-axis-hint")).at(first));
}
