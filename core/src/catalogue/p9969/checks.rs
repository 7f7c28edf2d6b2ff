//! Checks over several addresses of G65 P9969.

use super::addresses::{letter, spacing};
use crate::catalogue::nct::FORMAT_ERROR;
use crate::check::error;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::Inputs;
use crate::message::Message;

/// Both line spacings of the plane (C:1330-1332), or none: then nothing says which axis is scanned along.
pub fn checks(inputs: &Inputs, _: &Control, findings: &mut Vec<Diagnostic>) {
    if spacing(inputs).is_some() {
        return;
    }
    let [first, second, _] = inputs.plane.axes().map(letter);
    let message = Message::new("p9969-one-spacing").text("first", first).text("second", second);
    findings.push(error(FORMAT_ERROR, message).hint(Message::new("p9969-one-spacing-hint")).at(second));
}
