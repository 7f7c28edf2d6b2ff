//! Checks that the cycles at a tool probe share.

use super::{ProbeData, count};
use crate::catalogue::prelude::*;
use crate::check::announced;
use crate::control::probe::PROBE;

/// An alarm at a parameter, with its cure.
pub fn refused(number: u32, message: Message, hint: &'static str, at: Name) -> Diagnostic {
    error(Code::Alarm(number), message).hint(Message::new(hint)).at(at)
}

/// A probe number beyond the data fields (A:15852).
pub fn number(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let array = count(inputs);
    let fields = control.fields(array);
    let number = inputs.number(names::PRNUM);
    if number > fields {
        let message = Message::new("check-probe-number").number("number", number);
        let hint = Message::new("check-tool-probe-number-hint").number("fields", fields).text("array", array);
        found.push(error(Code::Alarm(61313), message).hint(hint).at(names::PRNUM));
    }
}

/// An empirical value memory beyond the array (`_EVMVNUM[0]`, B:13717). What a control does then is not defined; the
/// access would fail.
pub fn memory(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let number = (inputs.number(names::EVNUM) as i64 % 10_000) as f64;
    let size = control.number("_EVMVNUM[0]");
    if number > size {
        let finding = own::TOOL_MEMORY.finding().number("number", number).number("size", size);
        found.push(finding.hint_text("array", "_EVMVNUM[0]").at(names::EVNUM));
    }
}

/// Order of the limits: a difference is corrected between `_TZL` and `_TDIF` (measuring) or `_TSA` (calibrating), and
/// `_TSA` lies beyond both (B:4324-4326).
pub fn limits(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    // that delivered with the control is nobody's wish: only one that was written gets a warning where it is too large
    let written = inputs.written.contains(names::TDIF.as_str()) || inputs.given(names::TSA) > inputs.given(names::TDIF);
    let limits = [names::TZL, names::TDIF, names::TSA].into_iter().filter(|name| *name != names::TDIF || written);
    let given: Vec<_> = limits.filter_map(|name| Some((name, inputs.given(name)?))).collect();
    for pair in given.windows(2) {
        if let [(small, low), (large, high)] = pair
            && low >= high
        {
            let finding = own::TOOL_LIMITS.finding().text("small", *small).number("low", *low);
            found.push(finding.text("large", *large).number("high", *high).at(*large));
        }
    }
}

/// The tool in use, to be looked at further; none where it is not known. While a workpiece probe is in use, the tool
/// that is meant is still to come: a warning here, 61314 on the machine (A:15855).
pub fn tool_in_use<'a>(control: &'a Control, found: &mut Vec<Diagnostic>) -> Option<&'a Edge> {
    radius(control, found);
    let edge = control.active_edge().filter(|edge| edge.kind != 0)?;
    if edge.kind != PROBE {
        return Some(edge);
    }
    found.push(announced(61314, "check-tool-probe-in-use", names::MVAR));
    None
}

/// Radius and wear of the tool in use that add up below 0: what touches the probe has the radius 0 then.
pub fn radius(control: &Control, found: &mut Vec<Diagnostic>) {
    let radius = control.active_edge().map_or(0.0, Edge::total_radius);
    if radius < 0.0 {
        found.push(own::TOOL_RADIUS.finding().number("radius", radius));
    }
}

/// Speeds with which the cycle positions (B:13726-13733, A:15879-15880).
pub fn speeds(control: &Control, found: &mut Vec<Diagnostic>) {
    let mut alarm = |number, name: &str| {
        let message = Message::new("check-tool-speed").text("name", name);
        found.push(error(Code::Alarm(number), message).hint(Message::new("check-tool-speed-hint")));
    };
    if control.number("_SPEED[0]") < 0.0 {
        alarm(61339, "_SPEED[0]");
    }
    for name in ["_SPEED[1]", "_SPEED[2]"] {
        if control.bit("_CHBIT[2]") && control.number(name) == 0.0 {
            alarm(61338, name);
        }
    }
}

/// Whether the approximate place of the probe is known in the axes of the plane, with the side that is touched in minus
/// direction on the plus side (B:4397, B:8848-8850). The cycle works out its ways from these values.
pub fn place(data: &ProbeData, found: &mut Vec<Diagnostic>) {
    let sides = [0, 1].map(|axis| [-1.0, 1.0].map(|direction| data.datum(axis, direction)));
    if sides.iter().flatten().all(|datum| data.value(*datum) == 0.0) {
        let names: Vec<String> = sides.iter().flatten().map(|datum| data.name(*datum)).collect();
        // the control does not know where it stands
        let finding = own::TOOL_PROBE_EMPTY.finding();
        found.push(finding.text("names", names.join(", ")).at(names::PRNUM));
        return;
    }
    for [minus, plus] in sides.into_iter().filter(|[minus, plus]| data.value(*minus) <= data.value(*plus)) {
        let finding = own::TOOL_PROBE_SIDES.finding().text("minus", data.name(minus));
        found.push(finding.text("plus", data.name(plus)).at(names::PRNUM));
    }
}
