//! Names that belong to the control: its language, its cycles, its functions.

use super::standard::{is_standard, is_step};
use super::user_programs::delivered;
use super::words;
use crate::catalogue;
use crate::control::gud;
use crate::dialect::Dialect;
use crate::syntax::language::is_reserved;

/// `TOOLENV("NAME")`: stores the tool environment.
pub const STORE_ENVIRONMENT: &str = "TOOLENV";
/// `SETAL(61000)`: raises an alarm.
pub const SET_ALARM: &str = "SETAL";
/// `EXECSTRING(TEXT)`: carries out the block that a text holds.
pub const EXECUTE_TEXT: &str = "EXECSTRING";
/// `GOTOS`: back to the first block.
pub const RESTART: &str = "GOTOS";
/// `CYCLE800(…)`: swivels.
pub const SWIVEL: &str = "CYCLE800";

/// Whether a word without value belongs to the control: its language and its cycles, not a program of the user.
pub fn is_of_control(name: &str) -> bool {
    is_standard(name)
        || is_step(name)
        || name.starts_with("CYCLE_") // the parameterizing calls
        || catalogue::find(Dialect::Sinumerik, name).is_some()
        || catalogue::list::newer_alone(name).is_some()
        || ["MSG", STORE_ENVIRONMENT, SET_ALARM].contains(&name)
        || delivered(name)
        || words::known(name)
        || words::transforms(name)
        || [EXECUTE_TEXT, RESTART].contains(&name)
        || is_frame(name)
}

/// Whether a name is taken, so that no label and no program of the user can have it: words of the language, what
/// belongs to the control, its data. In upper case.
pub fn is_taken(name: &str) -> bool {
    is_reserved(name) || is_of_control(name) || words::left_out(name).is_some() || gud::find(name).is_some()
}

/// Whether a word begins a frame instruction.
pub fn is_frame(name: &str) -> bool {
    matches!(name, "TRANS" | "ATRANS" | "ROT" | "AROT" | "MIRROR" | "AMIRROR" | "SCALE" | "ASCALE")
}
