//! Checks about the turning tool with which a tool probe is calibrated, or that is measured there.

use super::checks::refused;
use crate::catalogue::prelude::*;

/// Types of turning tools (B:8838, B:9001).
const TURNING: std::ops::RangeInclusive<i64> = 500..=599;
/// Cutting edge position of the calibration tool (B:8839).
const CALIBRATION_TIP: i64 = 3;

/// Type and cutting edge position of the tool in use (B:8834-8839, B:9000-9002, A:15855,
/// A:15856).
pub fn tool(inputs: &Inputs, edge: &Edge, calibrate: bool, found: &mut Vec<Diagnostic>) {
    if !TURNING.contains(&edge.kind) {
        let message = Message::new("check-tool-type").number("type", edge.kind as f64);
        found.push(refused(61314, message, "check-turning-type-hint", names::MVAR));
        return;
    }
    let hint = match edge.tip {
        CALIBRATION_TIP if calibrate => return,
        _ if calibrate => "check-tip-calibration-hint",
        1..=8 => return length(inputs, edge.tip, found),
        _ => "check-tip-hint",
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
