//! Programs of the user that the measuring cycles call (B:2476-2530): what of a text runs around a call, and a
//! skeleton.

pub mod skeleton;

use crate::catalogue::CYCLES;
use crate::diagnostic::Diagnostic;
use crate::entry::Cycle;
use crate::own;
use crate::syntax::Program;
use crate::syntax::programs::programs;
use crate::syntax::targets::Targets;

/// A program that the measuring cycles call.
pub struct UserProgram {
    /// Name, as the cycles call it.
    pub name: &'static str,
    /// Key of when it is called; `.help` behind it is what it is for.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// Called before the measurement.
pub static BEFORE: UserProgram = UserProgram { name: "CYCLE198", key: "user-program-before", source: "B:2482-2498" };
/// Called when the measurement is complete.
pub static BEHIND: UserProgram = UserProgram { name: "CYCLE199", key: "user-program-behind", source: "B:2500-2508" };
/// Both.
pub static ALL: [&UserProgram; 2] = [&BEFORE, &BEHIND];

/// Whether a program of this name is on every control, so that a call of it is right where no text has it.
pub fn delivered(name: &str) -> bool {
    ALL.iter().any(|program| program.name == name)
}

/// Measuring cycles that call them, in the order of the catalogue.
pub fn callers() -> impl Iterator<Item = &'static Cycle> {
    CYCLES.iter().copied().filter(|cycle| cycle.is_measuring_cycle())
}

/// The label from which the lines of a cycle begin; one is printed, `_M977` (B:2492).
pub fn label(cycle: &Cycle) -> String {
    format!("_M{}", cycle.name.trim_start_matches("CYCLE"))
}

/// The user's programs in a text.
pub struct UserPrograms {
    /// Each with its first block, and its labels.
    found: Vec<(&'static UserProgram, usize, Targets)>,
}

impl UserPrograms {
    /// Those of this text.
    pub fn of(program: &Program) -> UserPrograms {
        let all = programs(program);
        let of = |user: &'static UserProgram| {
            let blocks = all.named(user.name)?.blocks.clone();
            Some((user, blocks.start, Targets::within(program, blocks)))
        };
        UserPrograms { found: ALL.into_iter().filter_map(of).collect() }
    }

    /// What runs before and after a call of this cycle, as notes at it.
    pub fn around(&self, cycle: &Cycle) -> Vec<Diagnostic> {
        if !cycle.is_measuring_cycle() {
            return Vec::new();
        }
        let label = label(cycle);
        let note = |(user, first, labels): &(&'static UserProgram, usize, Targets)| {
            let found = labels.blocks(&label).first().copied();
            let sentence = match (user.name == BEFORE.name, found) {
                (true, Some(_)) => own::RUNS_BEFORE,
                (true, None) => own::RUNS_BEFORE_WHOLE,
                (false, Some(_)) => own::RUNS_BEHIND,
                (false, None) => own::RUNS_BEHIND_WHOLE,
            };
            let line = found.unwrap_or(*first) as f64 + 1.0;
            sentence.finding().text("name", user.name).text("label", &label).number("line", line)
        };
        self.found.iter().map(note).collect()
    }
}
