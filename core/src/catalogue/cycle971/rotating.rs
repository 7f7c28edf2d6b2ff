//! Speed, feed and compensation of a measurement with rotating spindle (B:4334-4387, B:4776-4807).

use super::params::IN_PLANE;
use crate::catalogue::prelude::*;
use crate::own::Own;

/// All checks about it.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    direction(control, found);
    if control.bit("_CBIT[12]") {
        own_speeds(control, found);
    } else {
        limits(control, found);
    }
    compensation(inputs, control, found);
}

/// A finding of ours at the variant, with `{name}` in its cause.
fn finding(sentence: Own, name: &str) -> Diagnostic {
    sentence.finding().text("name", name).at(names::MVAR)
}

/// `_CM[5]`: 3 as M3 or 4 as M4, whoever sets the speeds (B:4783, A:15910); a spindle that turns already keeps its
/// direction (B:4807).
fn direction(control: &Control, found: &mut Vec<Diagnostic>) {
    if control.spindle_speed == 0.0 && ![3.0, 4.0].contains(&control.number("_CM[5]")) {
        found.push(refused(61366, "check-cm-direction", names::MVAR).text("name", "_CM[5]"));
    }
}

/// `_MFS[0..5]`: speed and feed of up to three probings; a speed of 0 ends them (B:4779-4787, A:15892).
fn own_speeds(control: &Control, found: &mut Vec<Diagnostic>) {
    let value = |index: usize| control.number(&format!("_MFS[{index}]"));
    let second = value(2) > 0.0;
    let third = second && value(4) > 0.0;
    let needed = [(true, 0), (true, 1), (second, 3), (third, 5)];
    for (_, index) in needed.into_iter().filter(|(needed, index)| *needed && value(*index) <= 0.0) {
        let name = format!("_MFS[{index}]");
        found.push(refused(61350, "check-mfs-missing", names::MVAR).text("name", name));
    }
    if !second && value(4) > 0.0 {
        found.push(finding(own::MFS_THIRD, "_MFS[2]"));
    }
}

/// `_CM[]`: limits from which the cycle works out speed and feed (B:4789-4803).
fn limits(control: &Control, found: &mut Vec<Diagnostic>) {
    let value = |index: usize| control.number(&format!("_CM[{index}]"));
    for index in [0, 1, 3, 4].into_iter().filter(|index| value(*index) <= 0.0) {
        let name = format!("_CM[{index}]");
        found.push(finding(own::CM_ZERO, &name));
    }
    let (first, second) = (value(6), value(7));
    let factor = |factor: f64| factor == 0.0 || factor >= 1.0;
    for (name, _) in [("_CM[6]", first), ("_CM[7]", second)].into_iter().filter(|(_, value)| !factor(*value)) {
        found.push(finding(own::CM_FACTOR, name));
    }
    // the second counts only behind the first (B:4800)
    if first >= 1.0 && second >= first {
        found.push(finding(own::CM_ORDER, "_CM[7]"));
    }
}

/// `_MT_COMP`: 1 takes the tables of a make, which are in no manual, 2 those of the user, whose radii and speeds ascend
/// (B:4334-4383).
fn compensation(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let table = if IN_PLANE.holds(inputs) { "_MT_EC_R" } else { "_MT_EC_L" };
    found.push(match control.number("_MT_COMP") as i64 {
        1 if control.number("_TP_CF") == 0.0 => finding(own::COMPENSATION_MAKE, "_TP_CF"),
        1 => finding(own::COMPENSATION_INSIDE, table),
        2 if !ascends(control, table) => finding(own::COMPENSATION_TABLE, table),
        _ => return,
    });
}

/// Whether the radii `[0,1..4]` and the peripheral speeds `[1..5,0]` of a table rise.
fn ascends(control: &Control, table: &str) -> bool {
    let rises = |numbers: Vec<f64>| numbers.windows(2).all(|pair| pair[0] < pair[1]);
    let cell = |row: usize, column: usize| control.number(&format!("{table}[{row},{column}]"));
    rises((1..=4).map(|column| cell(0, column)).collect()) && rises((1..=5).map(|row| cell(row, 0)).collect())
}
