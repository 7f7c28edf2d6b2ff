//! Putting findings together.

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;

/// A finding without hint and place.
fn finding(severity: Severity, code: Code, message: Message) -> Diagnostic {
    Diagnostic {
        severity,
        code,
        message,
        hint: None,
        param: None,
        span: None,
        cure: None,
    }
}

/// The control would stop, or the result would be wrong.
pub fn error(code: Code, message: Message) -> Diagnostic {
    finding(Severity::Error, code, message)
}

/// A colleague would ask.
pub fn warning(code: Code, message: Message) -> Diagnostic {
    finding(Severity::Warning, code, message)
}

/// Good to know.
pub fn note(code: Code, message: Message) -> Diagnostic {
    finding(Severity::Note, code, message)
}

/// The rest of a finding.
pub trait Finding {
    /// With the cure.
    fn hint(self, hint: Message) -> Self;
    /// At this parameter.
    fn at(self, param: &'static str) -> Self;
}

impl Finding for Diagnostic {
    fn hint(mut self, hint: Message) -> Self {
        self.hint = Some(hint);
        self
    }

    fn at(mut self, param: &'static str) -> Self {
        self.param = Some(param);
        self
    }
}
