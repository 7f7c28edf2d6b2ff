//! Checks over several addresses of G110.

use super::BORE;
use crate::catalogue::nct::checks;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, address};

/// What goes wrong with the corrections, and a ball without a way to the wall of a bore.
pub fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    checks::corrections(inputs, findings);
    if inputs.variant == BORE {
        checks::room(inputs, address::D, control, findings);
    }
}
