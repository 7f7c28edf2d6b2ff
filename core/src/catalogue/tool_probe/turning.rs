//! Checks about the turning tool with which a tool probe is calibrated, or that is measured there.

use super::checks::refused;
use crate::catalogue::prelude::*;

/// Whether a tool with this cutting edge position can calibrate the probe (B:8839), or can be measured (B:9128).
pub fn allowed(tip: i64, calibrate: bool) -> bool {
    if calibrate { tip == 3 } else { (1..=8).contains(&tip) }
}

/// Type and cutting edge position of the tool in use (B:8834-8839, B:9000-9002, A:15855-15856).
pub fn tool(inputs: &Inputs, edge: &Edge, calibrate: bool, found: &mut Vec<Diagnostic>) {
    if !edge.is_turning() {
        let message = Message::new("check-tool-type").number("type", edge.kind as f64);
        found.push(refused(61314, message, "check-turning-type-hint", names::MVAR));
        return;
    }
    let hint = match (allowed(edge.tip, calibrate), calibrate) {
        (true, true) => return,
        (true, false) => return length(inputs, edge.tip, found),
        (false, true) => "check-tip-calibration-hint",
        (false, false) => "check-tip-hint",
    };
    let message = Message::new("check-tip").number("tip", edge.tip as f64);
    found.push(refused(61315, message, hint, names::MVAR));
}

/// Tools with positions 5 and 7 lie along the abscissa and have no tip across it, those with 6 and 8 the other way
/// round (B:4152, B:9702). No alarm is named; 61325 is the nearest.
fn length(inputs: &Inputs, tip: i64, found: &mut Vec<Diagnostic>) {
    let axis = inputs.number(names::MA) as i64;
    if matches!((tip, axis), (5 | 7, 2) | (6 | 8, 1)) {
        let message = Message::new("check-tip-axis").number("tip", tip as f64);
        found.push(refused(61325, message, "check-tip-axis-hint", names::MA));
    }
}
