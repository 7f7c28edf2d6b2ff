//! What can be wrong with a program while it runs, each with its place and its own number.

use crate::diagnostic::{Code, Diagnostic, Severity, Span};
use crate::message::Message;

/// Number of the first problem.
pub const FIRST: u16 = 300;

/// Keys of all problems; the position gives the number, counted from [`FIRST`].
pub const KEYS: &[&str] = &[
    "run-unknown-word", "run-unknown-variable", "run-not-simulated", "run-index", "run-division", "run-not-a-number",
    "run-function", "run-read-only", "run-label", "run-unmatched", "run-subprogram", "run-depth", "run-steps",
    "run-trace-limit", "run-no-tool", "run-no-feed", "run-arc", "run-crash", "run-not-finite", "run-alarm",
    "run-machine-function", "run-radius-compensation", "run-call", "run-no-simulation", "run-shear", "run-limit",
    "run-array-size", "run-text-long", "run-range", "run-type", "run-declared-twice", "run-argument", "run-arguments",
    "run-cancelled", "run-spline", "run-alarm-number", "run-set-alarm", "run-swivel", "run-alone", "run-no-program",
    "run-contour-begin", "run-contour-end", "run-contour-plane", "run-contour-tool", "run-contour-narrow",
    "run-contour-approach", "run-offset-variable", "run-crash-stylus", "run-crash-body", "run-stylus", "run-endless",
    "run-repeated", "run-not-measured", "run-axis-name", "run-system-variable", "run-positioning", "run-axis-variable",
    "run-log-on", "run-scan-limit", "run-unread-value", "run-unread-way", "run-parameter", "run-no-edge", "run-far",
    "run-no-value", "run-errors", "run-crash-tool", "run-machine-value", "run-argument-unknown", "run-standard",
    "run-step", "run-data", "run-trace-full", "run-axes", "run-waits", "run-passed", "run-synchronous",
    "run-transformed", "run-restart", "run-program-unknown", "run-skipped-dry-run", "run-skipped-program-test",
    "run-skipped-block-search", "run-skipped-simulation", "run-jobshop", "run-deviation", "run-search-missed",
    "run-mode-none", "run-foreign", "run-log-deleted", "run-log-full", "run-screen-empty", "run-dialogue",
    "run-search-target", "run-setting-absent", "run-result-screen", "run-foreign-log", "run-measuring-input",
];

/// Keys of what a run goes on without: named at its end.
const PASSED_OVER: &[&str] = &["run-unknown-word", "run-not-simulated", "run-subprogram"];

/// What helps, for the problems that do not say it.
const CURES: &[(&str, &str)] = &[
    ("run-unknown-variable", "run-unknown-variable-hint"),
    ("run-subprogram", "run-subprogram-hint"),
    ("run-no-tool", "run-no-tool-hint"),
    ("run-no-edge", "run-no-edge-hint"),
    ("run-parameter", "run-parameter-hint"),
    ("run-machine-value", "run-machine-value-hint"),
    ("run-waits", "run-machine-value-hint"),
    ("run-log-on", "run-log-on-hint"),
    ("run-log-deleted", "run-log-deleted-hint"),
    ("run-log-full", "run-log-full-hint"),
    ("run-screen-empty", "run-screen-empty-hint"),
    ("run-dialogue", "run-dialogue-hint"),
    ("run-setting-absent", "run-setting-absent-hint"),
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
        Problem { span, message: Message::new(key).text("word", word) }
    }

    /// A problem of its place alone.
    pub fn at(key: &'static str, span: Span) -> Problem {
        Problem { span, message: Message::new(key) }
    }

    /// With a number in its sentence.
    pub fn number(self, name: &'static str, value: f64) -> Problem {
        Problem { message: self.message.number(name, value), ..self }
    }

    /// With a text in its sentence.
    pub fn text(self, name: &'static str, text: impl Into<String>) -> Problem {
        Problem { message: self.message.text(name, text), ..self }
    }

    /// As a finding.
    pub fn diagnostic(&self, severity: Severity) -> Diagnostic {
        let key = &*self.message.key;
        Diagnostic {
            span: Some(self.span),
            hint: cure(key).map(Message::new),
            ..Diagnostic::new(severity, code(key), self.message.clone())
        }
    }

    /// The word that a run goes on without.
    pub fn passed_over(&self) -> Option<&str> {
        PASSED_OVER.contains(&&*self.message.key).then(|| self.message.word("word")).flatten()
    }
}

/// Key of what helps.
pub fn cure(key: &str) -> Option<&'static str> {
    CURES.iter().find(|(problem, _)| *problem == key).map(|(_, cure)| *cure)
}

/// Number of a problem of this module.
pub fn code(key: &str) -> Code {
    let position = KEYS.iter().position(|known| *known == key).unwrap_or(99);
    Code::Own(FIRST + position as u16)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use std::path::Path;

    // oracle: self (the table against the words)
    #[test]
    fn every_problem_has_words() {
        let words = [include_str!("../messages/en/run.ftl"), include_str!("../messages/en/digitizing.ftl")];
        for key in KEYS {
            let line = format!("\n{key} = ");
            assert!(words.iter().any(|file| file.contains(&line)), "{key}");
        }
    }

    /// Keys of the problems that the Rust files of a folder raise.
    fn raised(folder: &Path, keys: &mut Vec<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                raised(&path, keys);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for begin in ["Problem::new(", "Problem::at(", "Stop::Fault(Message::new("] {
                let calls = text.split(begin).skip(1);
                let literals = calls.filter_map(|call| call.trim_start().strip_prefix('"'));
                keys.extend(literals.filter_map(|rest| Some(rest.split_once('"')?.0.to_owned())));
            }
        }
    }

    // oracle: self (the sources: what is raised has a number)
    #[test]
    fn every_problem_that_is_raised_stands_in_the_table() {
        let mut keys = Vec::new();
        raised(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut keys);
        assert!(keys.len() > 100, "{}", keys.len());
        for key in keys.iter().filter(|key| key.starts_with("run-")) {
            assert!(KEYS.contains(&key.as_str()), "{key} has no number");
        }
    }
}
