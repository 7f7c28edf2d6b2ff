//! Findings under a number of the control. Those of ours are raised by their names in [`crate::own`].

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;
use crate::name::Name;

/// The control would stop, or the result would be wrong.
pub fn error(code: Code, message: Message) -> Diagnostic {
    Diagnostic::new(Severity::Error, code, message)
}

/// What an alarm of the control refuses at a parameter; the words of what helps have the key of the cause and `-hint`.
pub fn refused(alarm: u32, key: &'static str, at: Name) -> Diagnostic {
    error(Code::Alarm(alarm), Message::new(key)).hint(Message::new(format!("{key}-hint"))).at(at)
}

/// What an alarm of the control announces at a parameter, without stopping; words as of [`refused`].
pub fn announced(alarm: u32, key: &'static str, at: Name) -> Diagnostic {
    Diagnostic { severity: Severity::Warning, ..refused(alarm, key, at) }
}

/// A colleague would ask.
pub fn warning(code: Code, message: Message) -> Diagnostic {
    Diagnostic::new(Severity::Warning, code, message)
}
