//! What the measuring macros do with a deviation: results, operator messages, M, T and S (C:481-501, C:1079-1099).

use super::{OUT_OF_TOLERANCE, TOOL_TOO_LARGE, UPPER_TOLERANCE, axis_name, print};
use crate::catalogue::prelude::*;
use crate::control::NCT;
use crate::evaluate::tolerance::exceeds;

/// Letter of the part of a register that M and T mean where the side of the cutter made the surface: its radius.
pub const RADIUS: &str = "D";
/// Letter of the part of a register where the face of the tool made the surface: its length.
pub const LENGTH: &str = "H";

/// A place that was measured along an axis of the WCS, mm.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Axis: 0 X, 1 Y, 2 Z.
    pub axis: usize,
    /// Where it should be.
    pub nominal: f64,
    /// Measured minus nominal.
    pub deviation: f64,
}

/// What was found, mm.
pub struct Found<'a> {
    /// Measured minus nominal; H and U limit its size.
    pub deviation: f64,
    /// Nominal size where two walls were measured; none: one surface.
    pub size: Option<f64>,
    /// +1 where a greater measure is metal that is left, −1 where it is metal that is missing.
    pub metal: f64,
    /// What S moves by.
    pub places: &'a [Place],
    /// Letter of the part of the registers.
    pub register: &'static str,
}

impl Found<'_> {
    /// Metal that is left on the whole size; M stores it, negative where too much is gone (C:491, C:927-931,
    /// C:1092-1095).
    fn excess(&self) -> f64 {
        self.metal * self.deviation
    }
}

/// Results, messages, corrections, print-out; `values` in mm.
pub fn finish(machine: &mut dyn Machine, inputs: &Inputs, values: &[(&str, f64)], found: &Found) {
    results(machine, values);
    correct(machine, inputs, found);
    print::print(machine, inputs, found);
}

/// Messages first, then M, and unless U is exceeded T or S (C:1083-1099).
fn correct(machine: &mut dyn Machine, inputs: &Inputs, found: &Found) {
    let beyond = |name: Name| inputs.given(name).is_some_and(|limit| exceeds(found.deviation.abs(), limit));
    if beyond(address::H) {
        machine.record(Step::Alarm(OUT_OF_TOLERANCE));
    }
    if let Some(register) = inputs.given(address::M) {
        machine.write_correction(format!("{}{register}", found.register), found.excess());
    }
    if beyond(address::U) {
        machine.record(Step::Alarm(UPPER_TOLERANCE));
        machine.record(Step::Decision { message: Message::new("decision-nct-no-update") });
        return;
    }
    if let Some(register) = inputs.given(address::T) {
        correct_tool(machine, register as i64, found);
    }
    if let Some(offset) = inputs.given(address::S) {
        move_offset(machine, offset as usize, found.places);
    }
}

/// The wear takes the excess of metal at one surface: a smaller register brings the tool nearer to it. The tool has to
/// fit between walls (C:984, C:1144).
fn correct_tool(machine: &mut dyn Machine, register: i64, found: &Found) {
    let name = format!("{}W{register}", found.register);
    let before = machine.control().variable(&name).unwrap_or(0.0);
    let surfaces = if found.size.is_some() { 2.0 } else { 1.0 };
    machine.write_correction(name, before - found.excess() / surfaces);
    let diameter = 2.0 * machine.control().register(register).total_radius();
    if found.metal < 0.0 && found.size.is_some_and(|room| diameter > room) {
        machine.record(Step::Alarm(TOOL_TOO_LARGE));
    }
}

/// The work offset moves so that what was measured gets its nominal coordinates in it (C:776: "to coordinate X100 Y80
/// in coordinate system G56"); the one in effect counts at once, as in the examples, which never call it again
/// (C:1159-1183).
pub fn move_offset(machine: &mut dyn Machine, offset: usize, places: &[Place]) {
    let active = machine.control().settable;
    // An offset other than the one in use is calculated from that: there the deviation was found.
    let from = if offset == 0 { 0 } else { active };
    let mut shift = [0.0; 3];
    places.iter().for_each(|place| shift[place.axis] = place.deviation);
    let by = machine.control().direction_to_machine(Dir::new(shift)).0;
    let measured = |axis: usize| places.iter().any(|place| place.axis == axis);
    for axis in (0..3).filter(|axis| measured(*axis) || by[*axis] != 0.0) {
        let control = machine.control();
        let [before, from] = [offset, from].map(|number| control.variable(&offset_of(number, axis)).unwrap_or(0.0));
        if from + by[axis] != before {
            machine.write_correction(offset_of(offset, axis), from + by[axis]);
        }
    }
    machine.control().offset_written(offset);
}

/// An axis of a work offset, `G54 X`; 0 is the common one.
fn offset_of(number: usize, axis: usize) -> String {
    format!("{} {}", NCT.settable_name(number), axis_name(axis))
}

/// Leaves results in the active unit; `values` in mm.
pub fn results(machine: &mut dyn Machine, values: &[(&str, f64)]) {
    let per = machine.control().active_factor();
    values.iter().for_each(|(name, value)| machine.write(name, value / per));
}

/// Leaves the values of a calibration in the basic system of the machine (C:92-94); `values` in mm.
pub fn calibration(machine: &mut dyn Machine, values: &[(&str, f64)]) {
    let per = machine.control().basic_factor();
    values.iter().for_each(|(name, value)| machine.write(name, value / per));
}
