//! What the measuring macros do with a deviation: results, operator messages, M, T and S (C:481-501, C:1079-1099).

use super::{OUT_OF_TOLERANCE, TOOL_TOO_LARGE, UPPER_TOLERANCE, axis_name};
use crate::control::Control;
use crate::control::variables::nct_offset;
use crate::entry::{Inputs, address};
use crate::evaluate::tolerance::exceeds;
use crate::machine::Machine;
use crate::machine::trace::Step;
use crate::message::Message;
use crate::name::Name;

/// Part of a register that M and T mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Radius D: the side of the cutter made the surface.
    Radius,
    /// Length H: the face of the tool made the surface.
    Length,
}

/// What was found, mm.
pub struct Found {
    /// Measured minus nominal; H and U limit its size.
    pub deviation: f64,
    /// Metal that is left on the whole size; M stores it, negative where too much is gone (C:491, C:1092-1095).
    pub excess: f64,
    /// The same at one surface; T takes it out of its register.
    pub at_surface: f64,
    /// Measured place minus nominal place in the axes X Y Z of the WCS that were measured; S moves by it.
    pub shift: [Option<f64>; 3],
    /// Part of the registers.
    pub part: Part,
    /// Width into which the tool of T has to fit (C:984, C:1144).
    pub room: Option<f64>,
}

/// Messages first, then M, and unless U is exceeded T or S (C:1083-1099).
pub fn correct(machine: &mut dyn Machine, inputs: &Inputs, found: &Found) {
    let beyond = |name: Name| inputs.given(name).is_some_and(|limit| exceeds(found.deviation.abs(), limit));
    if beyond(address::H) {
        machine.record(Step::Alarm(OUT_OF_TOLERANCE));
    }
    if let Some(register) = inputs.given(address::M) {
        let name = match found.part {
            Part::Radius => format!("D{register}"),
            Part::Length => format!("H{register}"),
        };
        write(machine, name, found.excess);
    }
    if beyond(address::U) {
        machine.record(Step::Alarm(UPPER_TOLERANCE));
        machine.record(Step::Decision(Message::new("decision-nct-no-update")));
        return;
    }
    if let Some(register) = inputs.given(address::T) {
        correct_tool(machine, register as i64, found);
    }
    if let Some(offset) = inputs.given(address::S) {
        move_offset(machine, offset as usize, found.shift);
    }
}

/// The wear takes the excess of metal: a smaller register brings the tool nearer to the surface.
fn correct_tool(machine: &mut dyn Machine, register: i64, found: &Found) {
    let name = match found.part {
        Part::Radius => format!("DW{register}"),
        Part::Length => format!("HW{register}"),
    };
    let before = machine.control().variable(&name).unwrap_or(0.0);
    write(machine, name, before - found.at_surface);
    let diameter = 2.0 * machine.control().register(register).total_radius();
    if found.room.is_some_and(|room| diameter > room) {
        machine.record(Step::Alarm(TOOL_TOO_LARGE));
    }
}

/// The work offset moves so that what was measured gets its nominal coordinates in it (C:776: "to coordinate X100 Y80
/// in coordinate system G56"); the one in effect counts at once, as in the examples, which never call it again
/// (C:1159-1183).
/// `shift`: measured minus nominal in the axes of the WCS that were measured, mm.
pub fn move_offset(machine: &mut dyn Machine, offset: usize, shift: [Option<f64>; 3]) {
    let active = machine.control().settable;
    // Another offset than the one in use is reckoned from that: there the deviation was found.
    let from = if offset == 0 { 0 } else { active };
    let control = machine.control();
    let by = control.direction_to_machine(shift.map(|shift| shift.unwrap_or(0.0)));
    for axis in (0..3).filter(|axis| shift[*axis].is_some() || by[*axis] != 0.0) {
        let control = machine.control();
        let [before, from] = [offset, from].map(|number| control.variable(&offset_of(number, axis)).unwrap_or(0.0));
        if from + by[axis] != before {
            write(machine, offset_of(offset, axis), from + by[axis]);
        }
    }
    count_at_once(machine.control(), offset);
}

/// An axis of a work offset, `G54 X`; 0 is the common one.
fn offset_of(number: usize, axis: usize) -> String {
    format!("{} {}", nct_offset(number), axis_name(axis))
}

/// A work offset that was written counts at once where it is in effect.
pub fn count_at_once(control: &mut Control, offset: usize) {
    let active = control.settable;
    if offset == 0 || offset == active {
        control.activate(active);
    }
}

/// Writes a register or an offset, mm, and records it.
pub fn write(machine: &mut dyn Machine, name: String, after: f64) {
    let Some(before) = machine.control().variable(&name) else {
        return;
    };
    machine.correct(&name, after);
    machine.record(Step::Set { name, before, after });
}

/// Leaves results in the active unit; `values` in mm.
pub fn results(machine: &mut dyn Machine, values: &[(&str, f64)]) {
    let per = machine.control().active_factor();
    values.iter().for_each(|(name, value)| datum(machine, name, value / per));
}

/// Leaves the values of a calibration in the basic system of the machine (C:92-94); `values` in mm.
pub fn calibration(machine: &mut dyn Machine, values: &[(&str, f64)]) {
    let per = machine.control().basic_factor();
    values.iter().for_each(|(name, value)| datum(machine, name, value / per));
}

/// Writes a datum as it stands in the machine, and records it.
pub fn datum(machine: &mut dyn Machine, name: &str, after: f64) {
    let before = machine.control().number(name);
    machine.control().set(name, after);
    machine.record(Step::Set { name: name.into(), before, after });
}
