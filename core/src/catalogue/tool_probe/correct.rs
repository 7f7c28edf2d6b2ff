//! What measuring a tool found: the results, the limits, the correction of the edge in use (B:4310-4326).

use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::{correct, tolerance};
use crate::evaluate::tolerance::{RESOLUTION, exceeds};
use crate::evaluate::{mean, tool_offset};

/// A length or the radius of the tool in use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// 0 to 2: L1 to L3; 3: radius.
    pub part: usize,
    /// Index of the field in `_OVR[]` that takes it; the difference follows in the next.
    pub result: usize,
    /// As measured, before the empirical value, mm.
    pub value: f64,
}

/// Reports, decides, corrects; each value on its own.
pub fn finish(machine: &mut dyn Machine, inputs: &Inputs, found: &[Measured], repetition: u32) -> Result<Next, Stop> {
    report_call(machine, inputs);
    for one in found {
        let used = one.value - tolerance::empirical(machine.control(), inputs);
        let difference = used - active(machine.control(), one.part);
        results::length(machine, one.result, used);
        results::length(machine, one.result + 1, difference);
        if decide(machine, inputs, one.part, difference, repetition)? == Next::Again {
            return Ok(Next::Again);
        }
    }
    Ok(Next::Done)
}

/// Reports and corrects without limits and into the geometry, as an incremental measurement does (B:9935).
pub fn finish_always(machine: &mut dyn Machine, inputs: &Inputs, found: &[Measured]) -> Next {
    report_call(machine, inputs);
    for one in found {
        let difference = one.value - active(machine.control(), one.part);
        results::length(machine, one.result, one.value);
        results::length(machine, one.result + 1, difference);
        write(machine, one.part, difference, true);
    }
    Next::Done
}

/// The length or radius that counts now, wear included, mm.
pub fn active(control: &Control, part: usize) -> f64 {
    match part {
        tool_offset::RADIUS => control.active_radius(),
        _ => control.active_edge().map_or(0.0, |edge| edge.total_length(part) + edge.location(control.location)[part]),
    }
}

/// What all measurements of tools tell (B:4233-4240).
fn report_call(machine: &mut dyn Machine, inputs: &Inputs) {
    let (tool, edge) = (machine.control().tool, machine.control().edge);
    results::length(machine, 29, inputs.number(names::TDIF));
    tolerance::report_empirical(machine, inputs);
    results::integer(machine, 0, edge);
    let memories = mean::memories(inputs.number(names::EVNUM) as i64);
    results::integer(machine, 7, memories.empirical);
    results::integer(machine, 8, tool);
}

/// From `_TSA` on the difference is an alarm (61303), from `_TDIF` on it is reported (62306); up to `_TZL` nothing is
/// corrected.
fn decide(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    part: usize,
    difference: f64,
    repetition: u32,
) -> Result<Next, Stop> {
    let reaches = |limit: Name| difference.abs() >= inputs.number(limit) - RESOLUTION;
    let remeasured = machine.control().bit("_CHBIT[3]");
    let corrected = exceeds(difference.abs(), inputs.number(names::TZL));
    let (key, limit, announced) = match (reaches(names::TSA), reaches(names::TDIF), corrected, remeasured) {
        (true, ..) => ("evaluate-tool-safe-area", names::TSA, Some(62303)),
        (_, true, ..) => ("evaluate-tool-difference", names::TDIF, Some(62306)),
        (_, _, false, _) => ("evaluate-tool-small", names::TZL, None),
        _ if !machine.corrects() => ("evaluate-tool-simulated", names::TZL, None),
        (.., true) => ("evaluate-tool-wear", names::TZL, None),
        _ => ("evaluate-tool-geometry", names::TZL, None),
    };
    let message = Message::new(key).number("difference", difference).number("limit", inputs.number(limit));
    machine.record(Step::Decision { message });
    if announced.is_some_and(|number| tolerance::repeat(machine, number, repetition)) {
        return Ok(Next::Again);
    }
    match announced {
        Some(62303) => return Err(alarm(machine, 61303)),
        None if corrected => write(machine, part, difference, !remeasured),
        _ => tolerance::inform(machine, announced),
    }
    Ok(Next::Done)
}

/// First measurement: the geometry takes everything and the wear is erased; later ones change the wear (B:4314-4322).
fn write(machine: &mut dyn Machine, part: usize, difference: f64, geometry: bool) {
    let control = machine.control();
    let target = tool_offset::Target { tool: control.tool, edge: control.edge, part, location: None, inverted: false };
    let writes = tool_offset::writes(control, &target, difference, geometry);
    correct::write(machine, &writes);
}
