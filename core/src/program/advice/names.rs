//! A program whose file and `PROC` have different names: a call finds it by the name of its file.

use super::at;
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::syntax::Program;
use crate::syntax::programs::{Programs, misnamed};

/// Each of them, at the name behind `PROC`.
pub fn look(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) {
    for (file, said, place) in misnamed(program, programs) {
        let finding = own::PROGRAM_NAMES.finding().text("file", file);
        found.push(at(finding.text("proc", said), place));
    }
}
