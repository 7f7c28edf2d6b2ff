//! What several values of CYCLE974 say together.

use super::params::REVERSAL;
use crate::catalogue::lathe;
use crate::check::error;
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::entry::{Inputs, names};
use crate::message::Message;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    lathe::checks::measuring(inputs, control, found);
    // the cycle turns the part between its two measurements (B:10784, A:15916)
    if REVERSAL.holds(inputs) && !control.spindle_positions {
        let message = Message::new("check-reversal-part");
        found.push(error(Code::Alarm(61372), message).hint(Message::new("check-reversal-part-hint")).at(names::MVAR));
    }
}
