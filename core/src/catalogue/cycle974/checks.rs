//! What several values of CYCLE974 say together.

use super::params::REVERSAL;
use crate::catalogue::lathe;
use crate::check::refused;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, names};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    lathe::checks::measuring(inputs, control, found);
    // the cycle turns the part between its two measurements (B:10784, A:15916)
    if REVERSAL.holds(inputs) && !control.spindle_positions {
        found.push(refused(61372, "check-reversal-part", names::MVAR));
    }
}
