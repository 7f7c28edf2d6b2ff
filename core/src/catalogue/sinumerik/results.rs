//! Result data `_OVR[]` and `_OVI[]`: written to the control and recorded.

use crate::catalogue::prelude::*;

/// The number of the alarm that the last call raised (B:5699).
pub const ALARM: &str = "_OVI[9]";

/// Writes a datum and records it. A 0 has no sign.
pub fn set(machine: &mut dyn Machine, name: &str, value: f64) {
    machine.write(name, value + 0.0);
}

/// Writes a length (mm) into `_OVR[index]`, in the active system of units.
pub fn length(machine: &mut dyn Machine, index: usize, millimetres: f64) {
    named_length(machine, &format!("_OVR[{index}]"), millimetres);
}

/// Writes a length (mm) into a datum, in the active system of units.
pub fn named_length(machine: &mut dyn Machine, name: &str, millimetres: f64) {
    let value = millimetres / machine.control().active_factor();
    set(machine, name, value);
}

/// Writes the number of the alarm that a helper cycle hands back instead of raising it; 0: all went well.
pub fn hand_back(machine: &mut dyn Machine, name: &str, alarm: Option<u32>) {
    let number = f64::from(alarm.unwrap_or(0));
    set(machine, name, number);
    if alarm.is_some() {
        let message = Message::new("evaluate-handed-back").number("alarm", number).text("name", name);
        machine.record(Step::Decision { message });
    }
}

/// Writes an angle (degree) into `_OVR[index]`.
pub fn angle(machine: &mut dyn Machine, index: usize, degrees: f64) {
    set(machine, &format!("_OVR[{index}]"), degrees);
}

/// Writes `_OVI[index]`.
pub fn integer(machine: &mut dyn Machine, index: usize, value: i64) {
    set(machine, &format!("_OVI[{index}]"), value as f64);
}

/// What every measurement tells about itself: cycle, probe, no alarm yet, safe area (B:5688-5699).
pub fn begin(machine: &mut dyn Machine, inputs: &Inputs, cycle: i64) {
    integer(machine, 2, cycle);
    integer(machine, 5, inputs.integer(names::PRNUM) % 100);
    integer(machine, 9, 0);
    if inputs.is_angle(names::TSA) {
        angle(machine, 28, inputs.degrees(names::TSA).0);
    } else if inputs.cycle.param(names::TSA.as_str()).is_some() {
        length(machine, 28, inputs.number(names::TSA));
    }
}

/// What a measurement with zero offset tells beside: the frame, no tool, nothing written yet (B:5692-5701).
pub fn begin_zero(machine: &mut dyn Machine, inputs: &Inputs) {
    integer(machine, 0, inputs.integer(names::KNUM));
    integer(machine, 8, 0);
    integer(machine, 11, 0);
}
