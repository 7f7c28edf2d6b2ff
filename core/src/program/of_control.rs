//! Names that belong to the control: its language, its cycles, its functions.

use super::user_programs::delivered;
use super::words;
use crate::catalogue;
use crate::dialect::Dialect;

/// `TOOLENV("NAME")`: stores the tool environment.
pub const STORE_ENVIRONMENT: &str = "TOOLENV";
/// `SETAL(61000)`: raises an alarm.
pub const SET_ALARM: &str = "SETAL";
/// `CYCLE800(…)`: swivels.
pub const SWIVEL: &str = "CYCLE800";

/// Whether a word without value belongs to the control: its language and its cycles, not a program of the user.
pub fn is_of_control(name: &str) -> bool {
    machines(name)
        || name.starts_with("CYCLE_") // the parameterizing calls
        || catalogue::find(Dialect::Sinumerik, name).is_some()
        || ["MSG", STORE_ENVIRONMENT, SET_ALARM].contains(&name)
        || delivered(name)
        || words::known(name)
        || words::beyond(name)
        || is_frame(name)
}

/// Whether a word begins a frame instruction.
pub fn is_frame(name: &str) -> bool {
    matches!(name, "TRANS" | "ATRANS" | "ROT" | "AROT" | "MIRROR" | "AMIRROR" | "SCALE" | "ASCALE")
}

/// Numbers of cycles that drill, mill, turn and swivel, and of parts of the measuring cycles (B:2384-2393).
const OF_CONTROL: [std::ops::RangeInclusive<u32>; 4] = [60..=199, 800..=899, 930..=959, 4071..=4079];

/// Whether a name is that of a cycle of the control that does something which is not simulated: `CYCLE83`.
pub fn machines(name: &str) -> bool {
    let number = name.strip_prefix("CYCLE").and_then(|digits| digits.parse().ok());
    number.is_some_and(|number| OF_CONTROL.iter().any(|numbers| numbers.contains(&number)))
}
