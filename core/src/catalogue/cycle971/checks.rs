//! What several values of CYCLE971, the data of the tool probe and the tool in use say together.

use super::params::{APPLICATE, AUTOMATIC, CALIBRATE, IN_PLANE, INCREMENTAL, RADIUS, ROTATING};
use super::place::over_the_middle;
use super::rotating;
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::checks::refused;
use crate::catalogue::tool_probe::{DEPTH, DIRECTIONS, EDGE_LENGTH, ProbeData, TYPE, checks as shared};
use crate::diagnostic::Severity;

/// The tool is offset from the centre of the probe where it is wider than that (B:4593-4599).
const OFFSET: When = When::Any(&[AUTOMATIC, When::All(&[When::Not(&INCREMENTAL), APPLICATE])]);

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared::number(inputs, control, found);
    shared::memory(inputs, control, found);
    shared::limits(inputs, found);
    path(inputs, found);
    let data = ProbeData::of(inputs, control);
    probe_type(&data, inputs.plane, found);
    if !INCREMENTAL.holds(inputs) {
        shared::speeds(control, found);
        shared::place(&data, found);
        depth(inputs, &data, found);
    }
    if AUTOMATIC.holds(inputs) {
        directions(&data, inputs.plane, found);
    }
    if let Some(edge) = shared::tool_in_use(control, found) {
        tool(inputs, edge, found);
        offset(inputs, &data, edge, found);
    }
    if ROTATING.holds(inputs) {
        rotating::checks(inputs, control, found);
    }
}

/// The measuring path is positive; at incremental calibration its sign is the direction (B:4421-4424, A:15847).
fn path(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let Some(path) = inputs.given(names::FA) else { return };
    let incremental = INCREMENTAL.holds(inputs);
    if path == 0.0 {
        let hint = if incremental { "check-path-direction-hint" } else { "check-path-zero-hint" };
        found.push(refused(61308, Message::new("check-path-zero"), hint, names::FA));
    } else if path < 0.0 && !incremental {
        found.push(refused(61308, Message::new("check-path-sign"), "check-path-sign-hint", names::FA));
    }
}

/// A cube or a disc; a disc is in one plane (B:13366, A:15848, A:15934).
fn probe_type(data: &ProbeData, plane: Plane, found: &mut Vec<Diagnostic>) {
    let (number, key) = match (data.value(TYPE) as i64, plane) {
        (0, _) | (101, Plane::G17) | (201, Plane::G18) | (301, Plane::G19) => return,
        (101 | 201 | 301, _) => (61415, "check-tool-probe-plane"),
        _ => (61309, "check-tool-probe-type"),
    };
    let message = Message::new(key).text("name", data.name(TYPE));
    found.push(refused(number, message, "check-tool-probe-type-hint", names::PRNUM));
}

/// In the plane the tool has to reach below the probe's upper side: an alarm at a radius (A:15891), else a warning.
fn depth(inputs: &Inputs, data: &ProbeData, found: &mut Vec<Diagnostic>) {
    let beside = AUTOMATIC.holds(inputs) || IN_PLANE.holds(inputs);
    if !beside || data.value(DEPTH) != 0.0 {
        return;
    }
    let mut finding = own::TOOL_PROBE_DEPTH.finding();
    if RADIUS.holds(inputs) {
        finding.severity = Severity::Error;
        finding.code = Code::Alarm(61349);
    }
    found.push(finding.text("name", data.name(DEPTH)).at(names::MA));
}

/// Digits of `_TP[k,7]`: 0 not, 1 minus, 2 plus, 3 both; the applicate has to allow minus (B:4720-4741). No alarm is
/// named there; 61309 is the nearest.
fn directions(data: &ProbeData, plane: Plane, found: &mut Vec<Diagnostic>) {
    let code = data.value(DIRECTIONS) as i64;
    let digit = |axis: usize| code / 10_i64.pow(axis as u32) % 10;
    let [_, _, applicate] = plane.axes();
    let key = if code > 999 || (0..3).any(|axis| digit(axis) > 3) {
        "check-directions-code"
    } else if digit(applicate) % 2 == 0 {
        "check-directions-applicate"
    } else {
        return;
    };
    let message = Message::new(key).text("name", data.name(DIRECTIONS)).number("code", code as f64);
    found.push(refused(61309, message, "check-directions-hint", names::MVAR));
}

/// Type and size of the tool in use. Milling tools and drills are measured (B:4157-4175), the radius of milling tools
/// only; turning and grinding tools are taken for wrong (A:15855 does not list the types).
fn tool(inputs: &Inputs, edge: &Edge, found: &mut Vec<Diagnostic>) {
    let drill_radius = RADIUS.holds(inputs) && (200..300).contains(&edge.kind);
    if matches!(edge.kind, 400..=599) || drill_radius {
        let key = if drill_radius { "check-tool-type-drill" } else { "check-tool-type" };
        let message = Message::new(key).number("type", edge.kind as f64);
        found.push(refused(61314, message, "check-tool-type-hint", names::MVAR));
        return;
    }
    let beside = AUTOMATIC.holds(inputs) || IN_PLANE.holds(inputs);
    let along = AUTOMATIC.holds(inputs) || APPLICATE.holds(inputs);
    let missing = [
        (along, edge.total_length(0), "check-tool-length-zero"),
        (beside, edge.total_radius(), "check-tool-radius-zero"),
    ];
    for (_, _, key) in missing.into_iter().filter(|(needed, size, _)| *needed && *size == 0.0) {
        found.push(refused(61351, Message::new(key), "check-tool-zero-hint", names::MVAR));
    }
}

/// A tool that is wider than the probe is offset by its radius less `_ID` (B:4593-4599).
fn offset(inputs: &Inputs, data: &ProbeData, tool: &Edge, found: &mut Vec<Diagnostic>) {
    if !OFFSET.holds(inputs) || over_the_middle(inputs, tool) {
        return;
    }
    let (radius, edge) = (tool.total_radius(), data.value(EDGE_LENGTH));
    let wide = 2.0 * radius > edge;
    let given = inputs.given(names::ID);
    let finding = match given {
        None if wide && edge > 0.0 && CALIBRATE.holds(inputs) => {
            let finding = own::OFFSET_MISSING.finding();
            finding.number("tool", 2.0 * radius).number("edge", edge)
        }
        Some(inward) if wide && inward > radius => own::OFFSET_LARGE.finding().number("radius", radius),
        Some(_) if wide && inputs.number(names::MA) as i64 == 3 => {
            own::OFFSET_ABSCISSA.finding().number("tool", 2.0 * radius).number("edge", edge)
        }
        _ => return,
    };
    found.push(finding.at(names::ID));
}
