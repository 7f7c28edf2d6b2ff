//! Checks of CYCLE982 about the milling tool or drill in use.

use super::drill::NOT_ONE_LENGTH;
use super::params::{
    ABSCISSA, AUTOMATIC, BOTH, DRILL, DRILL_ALONG_APPLICATE, MILLING, ORDINATE, RADIAL, RADIUS, REVERSAL,
    SPINDLE_AS_IT_IS, UPPER, WITH_RADIUS,
};
use crate::catalogue::prelude::*;
use crate::control::machine_data::TOOL_LENGTH_TYPE;
use crate::control::tools::AS_TURNING_TOOL;

/// Touched from the side, so that the radius takes part in the length (B:9637).
const FROM_THE_SIDE: When = When::All(&[
    When::Not(&AUTOMATIC),
    When::Not(&WITH_RADIUS),
    When::Any(&[When::All(&[RADIAL, ABSCISSA]), When::All(&[When::Not(&RADIAL), ORDINATE])]),
]);
/// The spindle of a milling tool would have to be turned, while with `_CHBIT[20]` it stays (B:9275-9277,
/// B:10088-10090).
pub const SPINDLE_HAS_TO_STAY: When =
    When::All(&[SPINDLE_AS_IT_IS, MILLING, When::Any(&[AUTOMATIC, REVERSAL, BOTH, UPPER])]);

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, edge: &Edge, found: &mut Vec<Diagnostic>) {
    if DRILL_ALONG_APPLICATE.holds(inputs) {
        along_applicate(inputs, found);
        return;
    }
    assignment(control, found);
    if DRILL.holds(inputs) && WITH_RADIUS.holds(inputs) {
        found.push(refused(61314, "check-drill-radius", names::MVAR));
        return;
    }
    spindle(inputs, control, found);
    sizes(inputs, edge, found);
}

/// A drill whose L1 counts along the applicate (B:10096-10126). No alarm is named there; 61314 is the nearest.
fn along_applicate(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let key = if inputs.plane == Plane::G18 {
        "check-drill-plane"
    } else if NOT_ONE_LENGTH.holds(inputs) {
        "check-drill-applicate"
    } else {
        return;
    };
    let hint = Message::new("check-drill-applicate-hint");
    found.push(refused(61314, key, names::MVAR).hint(hint));
}

/// L1 lies along X and L2 along Z only with SD 42950 = 2 (B:9192, B:9507).
fn assignment(control: &Control, found: &mut Vec<Diagnostic>) {
    let value = control.number(TOOL_LENGTH_TYPE);
    if value != AS_TURNING_TOOL {
        found.push(own::LENGTH_ASSIGNMENT.finding().number("value", value).at(names::MVAR));
    }
}

/// Turning the spindle to `_STA1`: forbidden by `_CHBIT[20]`, or impossible (B:10088-10094, A:15916); one that turns
/// already stays so (B:9194).
fn spindle(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let drill_reversed = DRILL.holds(inputs) && REVERSAL.holds(inputs);
    if SPINDLE_HAS_TO_STAY.holds(inputs) || drill_reversed && SPINDLE_AS_IT_IS.holds(inputs) {
        found.push(refused(61307, "check-spindle-stays", names::MVAR));
        return;
    }
    if REVERSAL.holds(inputs) && control.spindle_speed != 0.0 {
        found.push(refused(61307, "check-reversal-rotating", names::MVAR));
        return;
    }
    if drill_reversed && !control.spindle_positions {
        found.push(refused(61307, "check-reversal-held", names::MVAR));
    }
    let turned = MILLING.holds(inputs) && !SPINDLE_AS_IT_IS.holds(inputs) && control.spindle_speed == 0.0;
    if turned && !control.spindle_positions {
        found.push(refused(61372, "check-spindle-turns", names::MVAR));
    }
}

/// Sizes in the tool data that the measurement needs (B:9206-9208, B:9636-9637).
fn sizes(inputs: &Inputs, edge: &Edge, found: &mut Vec<Diagnostic>) {
    if FROM_THE_SIDE.holds(inputs) && edge.total_radius() == 0.0 {
        found.push(refused(61351, "check-side-radius", names::MVAR));
    }
    let along = usize::from(RADIAL.holds(inputs)); // L1 of an axial tool lies in the radius's axis, else L2
    if RADIUS.holds(inputs) && edge.total_length(along) == 0.0 {
        found.push(own::RADIUS_LENGTH.finding().text("length", ["L1", "L2"][along]).at(names::MVAR));
    }
}
