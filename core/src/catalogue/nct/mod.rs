//! What the probing macros of the NCT controls share (manual C).

#[cfg(test)]
pub(crate) mod bench;
pub(crate) mod checks;
pub(crate) mod corner;
pub(crate) mod correct;
pub(crate) mod figures;
pub(crate) mod help;
pub(crate) mod levels;
pub(crate) mod params;
pub(crate) mod part;
pub(crate) mod plane_axis;
pub(crate) mod print;
pub(crate) mod ring;
pub(crate) mod surface;
pub(crate) mod tasks;
pub(crate) mod touch;
pub(crate) mod walls;

#[cfg(test)]
mod calibration_tests;
#[cfg(test)]
mod measuring_tests;
#[cfg(test)]
mod proposal_tests;

pub use crate::control::{FALSE_TRIGGER, PATH_OBSTRUCTED};

use super::common::CYCLE;
use crate::catalogue::prelude::*;
use crate::control::Units;
use crate::dialect::Dialect;

/// A value is missing, out of range, or excludes another (C:1123-1137).
pub const FORMAT_ERROR: Code = Code::Nct("FORMAT ERROR");
/// No length offset is applied (C:125-132).
pub const NO_TOOL_LENGTH: Code = Code::Nct("NO TOOL LENGTH");
/// The stylus touches before the start (C:125-132).
pub const STYLUS_IN_CONTACT: Code = Code::Nct("STYLUS IN CONTACT");
/// The last protected positioning did not reach its target (C:121-123).
pub const OUT_OF_POSITION: Code = Code::Nct("OUT OF POSITION");
/// No wall within the overtravel (C:1123-1137).
pub const PROBE_FAIL: Code = Code::Nct("PROBE FAIL");
/// The values leave nothing to move (C:1123-1137).
pub const NO_MOVEMENT: Code = Code::Nct("NO MOVEMENT");
/// Deviation greater than H (C:1142).
pub const OUT_OF_TOLERANCE: Code = Code::Nct("OUT OF TOLERANCE");
/// Deviation greater than U; spelled as the control does (C:1143).
pub const UPPER_TOLERANCE: Code = Code::Nct("UPPER TOL EXEEDED");
/// The corrected tool no longer fits into the bore (C:1144).
pub const TOOL_TOO_LARGE: Code = Code::Nct("TOOL DIA OFFS TOO LARGE");

/// The stylus is stuck: something lies on its way back (C:1338).
pub const SCANNING_OBSTRUCTED: Code = Code::Nct("SCANNING OBSTRUCTED");
/// No position after the third attempt (C:1339).
pub const SCANNING_FAIL: Code = Code::Nct("SCANNING FAIL");

/// What every measuring macro can stop with (C:195-204, C:1123-1137).
pub const MEASURING: &[Code] =
    &[FORMAT_ERROR, NO_TOOL_LENGTH, STYLUS_IN_CONTACT, PROBE_FAIL, NO_MOVEMENT, FALSE_TRIGGER, OUT_OF_POSITION];

/// The ways beside what is measured are protected like those of G101 (C:125-132).
pub const PROTECTED: &[Code] = &[PATH_OBSTRUCTED];
/// Limits of the deviation (C:1142-1143).
pub const LIMITS: &[Code] = &[OUT_OF_TOLERANCE, UPPER_TOLERANCE];

/// What every macro starts from.
pub const MACRO: Cycle = Cycle { dialect: Dialect::Nct, alarms: &[MEASURING], ..CYCLE };

/// What is corrected by a macro whose address S or T says it; the worked measurement has S (C:1089).
pub const CORRECTED: &[MayCorrect] = &[
    (When::Always, Corrects::Zero, &[]),
    (When::Always, Corrects::Tool, &[(address::S, ""), (address::T, "3")]),
    (When::Always, Corrects::Nothing, &[(address::S, "")]),
];

/// Datum that a failed G101 leaves at 1 and the measuring macros look at. The manual gives it no number (C:121-123).
pub const POSITION_LOST: &str = "OUT_OF_POSITION";
/// Machine parameter PRNT: 0 switches the print-out off (C:60). Where it is not set, the macros print.
pub const PRINT_ENABLED: &str = "P9143";

const FREE: &[Need] = &[optional(When::Always, "need-nct-optional")];

/// A length that may be left out.
pub const LENGTH: Param = Param { unit: Unit::ActiveLength, needs: FREE, ..PARAM };
/// A whole number that may be left out.
pub const NUMBER: Param = Param { kind: Kind::Integer, needs: FREE, ..PARAM };
/// A register: the print has "less than 6", but the examples use T1, so that 1 must be the lower end (C:1097).
pub const REGISTER: Param = Param { range: Range::closed(1.0, 99.0), alarm: Some(FORMAT_ERROR), ..NUMBER };
/// Nothing, the data line, or header and data line (C:1100-1101).
pub const PRINT: Param = Param {
    kind: Kind::Choice(&[(0, "nct-print-none"), (1, "nct-print-line"), (2, "nct-print-header")]),
    needs: FREE,
    ..PARAM
};

/// Overtravel Q where it is not given, as the calibrations have it: 10 mm or 0.4 inch (C:187, C:391). mm.
pub const OVERTRAVEL: [f64; 2] = [10.0, 0.4 * 25.4];

/// That overtravel for the active system of units, mm.
pub fn overtravel(control: &Control) -> f64 {
    let inch = control.active_units == Units::Inch;
    OVERTRAVEL[usize::from(inch)]
}

/// Name of an axis.
pub const fn axis_name(axis: usize) -> Name {
    address::AXES[axis]
}

/// Address of an axis of the plane: 0 abscissa, 1 ordinate, 2 applicate.
pub fn axis_of(inputs: &Inputs, index: usize) -> Name {
    axis_name(inputs.plane.axes()[index.min(2)])
}

/// Value along an axis, where it is given, mm.
pub fn given(inputs: &Inputs, index: usize) -> Option<f64> {
    inputs.given(axis_of(inputs, index))
}

/// What every macro looks at first: a length is applied and the stylus is free (C:118-121).
pub(crate) fn ready(machine: &mut dyn Machine) -> Result<(), Stop> {
    if machine.control().active_edge().is_none() {
        return Err(Stop::Alarm(NO_TOOL_LENGTH));
    }
    if machine.in_contact() {
        return Err(Stop::Alarm(STYLUS_IN_CONTACT));
    }
    Ok(())
}

/// What a measuring macro looks at first; a failed G101 before it stops it (C:121-123).
pub(crate) fn ready_to_measure(machine: &mut dyn Machine) -> Result<(), Stop> {
    if machine.control().number(POSITION_LOST) == 1.0 {
        return Err(Stop::Alarm(OUT_OF_POSITION));
    }
    ready(machine)
}
