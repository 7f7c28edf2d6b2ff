//! What several values of CYCLE978 say together.

use super::params::DIFFERENTIAL;
use crate::catalogue::shared_checks;
use crate::check::refused;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, names};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::measuring(inputs, control, found);
    if DIFFERENTIAL.holds(inputs) {
        differential(inputs, control, found);
    }
}

/// The spindle turns a multi probe between two measurements in the plane (B:6308, B:6418). The alarm for the axis is
/// ours: the manual names none.
fn differential(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::differential(inputs, control, found);
    if inputs.integer(names::MA) == 3 {
        found.push(refused(61325, "check-differential-axis", names::MA));
    }
}
