//! `probewright check`, and how findings are printed.

use crate::file::{self, Control, Problem};
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::json;
use probewright_core::program;
use probewright_core::program::position::Positions;
use probewright_core::words::Words;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Checks every file; 1 when there is an error in one of them.
pub fn check(files: &[PathBuf], control: Option<Control>) -> Result<ExitCode, Problem> {
    let words = Words::english();
    let mut errors = 0;
    for path in files {
        let source = file::bytes(path)?;
        let dialect = file::dialect(control, &source);
        let found = program::findings(&program::read(dialect, &source));
        errors += print_all(path, &source, &found, &words);
    }
    Ok(if errors > 0 {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    })
}

/// Prints findings as `file:line:col: error[61307]: …`; gives the number of errors.
pub fn print_all(path: &Path, source: &[u8], found: &[Diagnostic], words: &Words) -> usize {
    let positions = Positions::new(source);
    for finding in found {
        let place = finding.span.map_or(String::new(), |span| {
            let (line, column) = positions.line_column(span.start);
            format!("{line}:{column}: ")
        });
        println!("{}:{place}{}", path.display(), one_line(finding, words));
    }
    found
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .count()
}

/// `error[61307]: cause. cure`, without a place.
pub fn one_line(finding: &Diagnostic, words: &Words) -> String {
    let severity = match finding.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    let mut line = format!("{severity}[{}]: ", json::code(finding.code));
    if let Some(param) = finding.param {
        line.push_str(param);
        line.push_str(": ");
    }
    line.push_str(&words.text(&finding.message));
    if let Some(hint) = &finding.hint {
        line.push(' ');
        line.push_str(&words.text(hint));
    }
    line
}
