//! What several values of CYCLE972, the data of the tool probe and the tool in use say together.

use super::params::CALIBRATE;
use crate::catalogue::shared_checks;
use crate::catalogue::tool_probe::{ProbeData, checks as shared, turning};
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::Inputs;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared::number(inputs, control, false, found);
    shared::memory(inputs, control, found);
    shared::limits(inputs, found);
    shared::speeds(control, found);
    let data = ProbeData::of(inputs, control, false);
    shared::place(&data, &[0, 1], found); // by axes of the plane, B:13370-13384
    shared_checks::rotation(control, found);
    if let Some(edge) = shared::tool_in_use(control, found) {
        turning::tool(inputs, edge, CALIBRATE.holds(inputs), found);
    }
}
