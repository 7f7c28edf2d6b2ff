//! What can be wrong with a program while it runs, each with its place and its own number.

use crate::diagnostic::{Code, Diagnostic, Severity, Span};
use crate::message::Message;

/// Number of the first problem.
pub const FIRST: u16 = 300;

/// Keys of all problems; the position gives the number, counted from [`FIRST`].
pub const KEYS: &[&str] = &[
    "run-unknown-word",
    "run-unknown-variable",
    "run-not-simulated",
    "run-index",
    "run-division",
    "run-not-a-number",
    "run-function",
    "run-read-only",
    "run-label",
    "run-unmatched",
    "run-subprogram",
    "run-depth",
    "run-steps",
    "run-trace-limit",
    "run-no-tool",
    "run-no-feed",
    "run-arc",
    "run-crash",
    "run-not-finite",
    "run-alarm",
    "run-machine-function",
    "run-radius-compensation",
    "run-call",
    "run-no-simulation",
    "run-shear",
    "run-limit",
    "run-array-size",
    "run-text-long",
    "run-range",
    "run-type",
    "run-declared-twice",
    "run-argument",
    "run-arguments",
    "run-cancelled",
    "run-spline",
    "run-alarm-number",
    "run-set-alarm",
    "run-swivel",
    "run-alone",
    "run-no-program",
    "run-contour-begin",
    "run-contour-end",
    "run-contour-plane",
    "run-contour-tool",
    "run-contour-narrow",
    "run-contour-approach",
    "run-offset-variable",
    "run-crash-stylus",
    "run-crash-body",
    "run-stylus",
    "run-endless",
    "run-repeated",
    "run-not-measured",
    "run-axis-name",
    "run-system-variable",
    "run-positioning",
    "run-axis-variable",
];

/// Something wrong at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Place.
    pub span: Span,
    /// What.
    pub message: Message,
}

impl Problem {
    /// A problem that names the word at its place.
    pub fn new(key: &'static str, span: Span, word: impl Into<String>) -> Problem {
        Problem {
            span,
            message: Message::new(key).text("word", word),
        }
    }

    /// As a finding.
    pub fn diagnostic(&self, severity: Severity) -> Diagnostic {
        let code = code(&self.message.key);
        Diagnostic {
            span: Some(self.span),
            ..Diagnostic::new(severity, code, self.message.clone())
        }
    }
}

/// Number of a problem of this module.
pub fn code(key: &str) -> Code {
    let position = KEYS.iter().position(|known| *known == key).unwrap_or(99);
    Code::Own(FIRST + position as u16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_problem_has_words() {
        let words = include_str!("../../messages/en/run.ftl");
        for key in KEYS {
            assert!(words.contains(&format!("\n{key} = ")), "{key}");
        }
    }
}
