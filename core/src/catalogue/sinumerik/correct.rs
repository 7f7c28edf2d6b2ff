//! Writes corrections of tools and zero offsets, and records them.

use super::tolerance::Sizes;
use crate::catalogue::prelude::*;
use crate::evaluate::tool_offset::{GEOMETRY, Target as Tool};
use crate::evaluate::{Write, tool_offset, zero_offset};
use nalgebra::IsometryMatrix3;

/// Finds the quantity that a tool offset corrects; `axis` where there is one measuring axis. None: `_KNUM` = 0.
pub fn tool_target(machine: &mut dyn Machine, inputs: &Inputs, axis: Option<usize>) -> Result<Option<Tool>, Stop> {
    let names = tool_offset::Names {
        code: inputs.integer(names::KNUM),
        tool: inputs.number(names::TNUM) as i64,
        tool_name: inputs.text(names::TNAME),
        location: inputs.number(names::DLNUM) as i64,
        environment: inputs.text(names::TENV),
        axis,
    };
    tool_offset::target(machine.control(), &names).map_err(|number| alarm(machine, number))
}

/// Finds the frame that a zero offset corrects. None: `_KNUM` = 0. One with a scale factor is refused, active or not:
/// what is measured without the factor would come out multiplied in it (B:744, A:15849).
pub fn zero_target(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Option<zero_offset::Target>, Stop> {
    let control = machine.control();
    let target = zero_offset::target(control, inputs.integer(names::KNUM)).map_err(|number| alarm(machine, number))?;
    match target {
        Some(target) if zero_offset::scaled(machine.control(), &target) => Err(alarm(machine, 61310)),
        target => Ok(target),
    }
}

/// Corrects a tool by a difference; the amount entered, mm. A length is shortened by a positive difference.
pub fn tool(machine: &mut dyn Machine, target: &Tool, sizes: &Sizes, difference: f64) -> f64 {
    let sign = if target.part == tool_offset::RADIUS { sizes.radius_sign } else { -1.0 };
    let inverted = if target.inverted { -1.0 } else { 1.0 };
    let amount = sizes.factor * sign * inverted * difference;
    let control = machine.control();
    let writes = tool_offset::writes(control, target, amount, control.bit(GEOMETRY));
    write(machine, &writes);
    amount
}

/// Corrects the translation of a zero offset; see [`frame`].
pub fn zero(machine: &mut dyn Machine, target: &zero_offset::Target, measured: &zero_offset::Measured) {
    let writes = zero_offset::writes(machine.control(), target, measured);
    frame(machine, target, &writes);
}

/// Turns and moves a frame so that what lies where `motion` takes it from its set position has the set coordinates;
/// X Y Z of the WCS that is active while measuring, mm.
pub fn position(machine: &mut dyn Machine, target: &zero_offset::Target, motion: &IsometryMatrix3<f64>, set: [f64; 3]) {
    let writes = zero_offset::moved(machine.control(), target, motion, set);
    frame(machine, target, &writes);
}

/// Corrects a frame and tells so in `_OVI[11]`.
pub fn frame(machine: &mut dyn Machine, target: &zero_offset::Target, writes: &[Write]) {
    apply(machine, target, writes);
    results::integer(machine, 11, 1);
}

/// Writes what corrects a frame and, for `_KNUM` = 9999, activates it. Nothing is told of a frame that is right.
pub fn apply(machine: &mut dyn Machine, target: &zero_offset::Target, writes: &[Write]) {
    write(machine, writes);
    if target.activate {
        let settable = machine.control().settable;
        machine.control().activate(settable);
    }
    if !writes.is_empty() && machine.corrects() {
        let key = if target.activate { "evaluate-activated" } else { "evaluate-not-activated" };
        machine.record(Step::Decision { message: Message::new(key) });
    }
}

/// Writes and records, where the machine corrects.
pub fn write(machine: &mut dyn Machine, writes: &[Write]) {
    if !machine.corrects() {
        return;
    }
    for Write { name, value } in writes {
        let before = machine.control().variable(name).unwrap_or(0.0);
        machine.correct(name, *value);
        machine.record(Step::Set { name: name.clone(), before, after: *value });
    }
}
