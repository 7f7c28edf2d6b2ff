//! Findings under a number of the control. Those of ours are raised by their names in [`crate::own`].

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;

/// The control would stop, or the result would be wrong.
pub fn error(code: Code, message: Message) -> Diagnostic {
    Diagnostic::new(Severity::Error, code, message)
}

/// A colleague would ask.
pub fn warning(code: Code, message: Message) -> Diagnostic {
    Diagnostic::new(Severity::Warning, code, message)
}
