//! Checks about the probe in use and the coordinate system.

use super::TIPS;
use crate::catalogue::prelude::*;
use crate::check::announced;
use crate::control::probe::Unfit;

/// What every call that measures a workpiece is checked for.
pub fn measuring(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    shared_checks::mirror(control, found);
    shared_checks::memories(inputs, control, found);
    shared_checks::weighting(inputs, control, found);
    shared_checks::tolerances(inputs, found);
    tip(control, found);
    shared_checks::rotation(control, found);
}

/// Cutting edge position of the probe in use, where it is known and permitted. While a milling probe is in use, the
/// right one is still to come: a warning here, 61309 on the machine (B:8708, A:15848, A:15856).
pub fn tip(control: &Control, found: &mut Vec<Diagnostic>) -> Option<i64> {
    let edge = control.active_edge().filter(|edge| edge.kind != 0)?;
    if !edge.is_turning() {
        let told = if control.unfit(edge) == Some(Unfit::Type) { refused } else { announced };
        found.push(told(61309, "check-lathe-probe", names::PRNUM).number("type", edge.kind as f64));
        return None;
    }
    if !TIPS.contains(&edge.tip) {
        found.push(wrong_tip(edge.tip, "check-lathe-tip-hint"));
        return None;
    }
    Some(edge.tip)
}

/// A cutting edge position that the call cannot work with.
pub fn wrong_tip(tip: i64, hint: &'static str) -> Diagnostic {
    let message = Message::new("check-lathe-tip").number("tip", tip as f64);
    error(Code::Alarm(61315), message).hint(Message::new(hint)).at(names::PRNUM)
}
