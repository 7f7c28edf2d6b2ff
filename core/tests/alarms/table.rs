//! What a table of cases is made of.

use probewright_core::diagnostic::Code;
use probewright_core::machine::Setup;

/// The cases of one cycle.
pub struct Table {
    /// A program that measures without an alarm once `{change}` is replaced by [`Table::usual`].
    pub program: &'static str,
    /// What stands at `{change}` when nothing is wrong.
    pub usual: &'static str,
    /// Control, probe and part for it.
    pub setup: fn() -> Setup,
    /// One case for each alarm that can be reached.
    pub cases: Vec<Case>,
    /// Alarms of the entry that nothing raises, each with the reason.
    pub unreached: Vec<(u32, &'static str)>,
}

/// What raises an alarm.
pub struct Case {
    /// The alarm.
    pub code: Code,
    /// What stands at `{change}`.
    pub change: &'static str,
    /// What is different on the machine.
    pub prepare: fn(&mut Setup),
}

/// A case of a SINUMERIK cycle.
pub fn case(number: u32, change: &'static str, prepare: fn(&mut Setup)) -> Case {
    case_of(Code::Alarm(number), change, prepare)
}

/// A case of any control.
pub fn case_of(code: Code, change: &'static str, prepare: fn(&mut Setup)) -> Case {
    Case { code, change, prepare }
}

/// A case that the program alone brings about.
pub fn program(number: u32, change: &'static str) -> Case {
    case(number, change, |_| ())
}
