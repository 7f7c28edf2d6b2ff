#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! What the tests of the macros share.

use super::part;
use crate::check::check;
use crate::control::{Frame, Plane, Units};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Typed};
use crate::geometry::{Dir, Wcs};
use crate::machine::Setup;
use crate::run::{Outcome, predict};
use crate::workpiece::{PartErrors, Shape};

pub const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

/// The axis address of the tool in its plane.
pub const TOOL_AXIS: [(Plane, &str); 3] = [(Plane::G17, "Z"), (Plane::G18, "Y"), (Plane::G19, "X")];

pub fn typed(values: &[(&str, &str)]) -> Typed {
    let pairs = values.iter();
    pairs.map(|(name, value)| (name.to_string(), value.to_string())).collect()
}

/// One call of a macro.
pub fn call(cycle: &'static Cycle, values: &[(&str, &str)], setup: &Setup) -> Outcome {
    let checked = check(cycle, &typed(values), &setup.control);
    let inputs = checked.inputs.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    predict(cycle, &inputs, setup)
}

/// Codes of the errors that a form has.
pub fn codes(cycle: &'static Cycle, values: &[(&str, &str)], plane: Plane) -> Vec<Code> {
    let setup = Setup::calibrated(Dialect::Nct, plane);
    let found = check(cycle, &typed(values), &setup.control).diagnostics;
    let errors = found.into_iter().filter(|one| one.severity == Severity::Error);
    errors.map(|one| one.code).collect()
}

/// A machine in this plane and system of units, G54 at some place.
pub fn machine(plane: Plane, inch: bool) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, plane);
    let at = Frame::translation([11.0, 22.0, 33.0]);
    setup.control.frames.insert(1, at);
    setup.control.activate(1);
    if inch {
        setup.control.active_units = Units::Inch;
    }
    setup
}

/// Coordinates X Y Z from those along the axes of the plane.
pub fn along(plane: Plane, values: [f64; 3]) -> [f64; 3] {
    let mut point = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(values) {
        point[axis] = value;
    }
    point
}

/// Puts a part there, along the axes of the plane in the active WCS; its errors too.
pub fn put(setup: &mut Setup, shape: Shape, at: [f64; 3], shift: [f64; 3], size: f64) {
    let plane = setup.control.plane;
    let mut solid = part::in_plane(shape, at, &setup.control);
    let shift = setup.control.direction_to_machine(Dir::new(along(plane, shift))).0;
    solid.errors = PartErrors { shift, size, ..PartErrors::default() };
    setup.workpiece.solids.push(solid);
}

/// Sends the machine there, along the axes of the plane in the active WCS.
pub fn stand(setup: &mut Setup, at: [f64; 3]) {
    let point = along(setup.control.plane, at);
    setup.position = setup.control.to_machine(Wcs(point));
}

/// The machine after a call.
pub fn after(setup: &Setup, outcome: Outcome) -> Setup {
    Setup { control: outcome.control, position: outcome.position, ..setup.clone() }
}

/// A length as typed in the active system of units.
pub fn length(setup: &Setup, mm: f64) -> String {
    format!("{}", mm / setup.control.active_factor())
}

pub fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
}
