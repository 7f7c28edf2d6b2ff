//! What several values of CYCLE982, the data of the tool probe and the tool in use say together.

use super::cutters;
use super::params::{
    ABSCISSA, CALIBRATE, DRILL, IN_WORKPIECE, INCREMENTAL, MEASURE, MILLING, POSITIONED, TURNING, WORKPIECE,
};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{ProbeData, checks as shared, turning};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared::number(inputs, control, found);
    shared::memory(inputs, control, found);
    shared::limits(inputs, found);
    if POSITIONED.holds(inputs) {
        shared::speeds(control, found);
        shared::place(&ProbeData::of(inputs, control), found);
    }
    if IN_WORKPIECE.holds(inputs) {
        shared_checks::rotation(control, found);
    }
    // from before the second digit of `_MVAR`: takes `_TP` for the workpiece system (B:13602-13608)
    if control.bit("_CBIT[5]") && !WORKPIECE.holds(inputs) {
        found.push(own::TOOL_REFERENCE.finding().at(names::MVAR));
    }
    if let Some(edge) = shared::tool_in_use(control, found) {
        tool(inputs, control, edge, found);
    }
}

/// The tool in use: a turning tool for calibration; turning tools, milling tools and drills are measured (B:9330-9338).
fn tool(inputs: &Inputs, control: &Control, edge: &Edge, found: &mut Vec<Diagnostic>) {
    let calibrate = CALIBRATE.holds(inputs);
    if calibrate || TURNING.holds(inputs) {
        turning::tool(inputs, edge, calibrate, found);
        idle_digits(inputs, found);
        direction(inputs, edge.tip, found);
    } else if MILLING.holds(inputs) || DRILL.holds(inputs) {
        cutters::checks(inputs, control, edge, found);
    } else {
        let message = Message::new("check-tool-type").number("type", edge.kind as f64);
        found.push(shared::refused(61314, message, "check-lathe-tool-type-hint", names::MVAR));
    }
}

/// A turning tool is measured as without digits 3 to 5 of `_MVAR`, which count for milling tools and drills only
/// (B:9224-9260).
fn idle_digits(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    if !MEASURE.holds(inputs) || inputs.variant / 100 % 1000 == 0 {
        return;
    }
    let plain = inputs.variant / 100_000 * 100_000 + inputs.variant % 100;
    let finding = own::TURNING_DIGITS.finding().number("value", inputs.variant as f64);
    found.push(finding.hint_number("plain", plain as f64).at(names::MVAR));
}

/// An incremental measurement that travels away from the tip: the back of the tool would meet the probe.
fn direction(inputs: &Inputs, tip: i64, found: &mut Vec<Diagnostic>) {
    let (Some(towards), Some(nose)) = (inputs.given(names::MD), inputs.nose) else { return };
    let side = nose[usize::from(!ABSCISSA.holds(inputs))];
    let sense = if towards == 0.0 { 1.0 } else { -1.0 };
    // a calibration tool may be bent so that its ball also touches from the other side (B:9907)
    if INCREMENTAL.holds(inputs) && MEASURE.holds(inputs) && side == -sense {
        found.push(own::TIP_DIRECTION.finding().number("tip", tip as f64).at(names::MD));
    }
}
