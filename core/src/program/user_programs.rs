//! Programs of the user that the measuring cycles call (B:2476-2530).

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
pub const BEFORE: UserProgram = UserProgram { name: "CYCLE198", key: "user-program-before", source: "B:2482-2498" };
/// Called when the measurement is complete.
pub const BEHIND: UserProgram = UserProgram { name: "CYCLE199", key: "user-program-behind", source: "B:2500-2508" };
/// Both.
pub const ALL: [UserProgram; 2] = [BEFORE, BEHIND];

/// Whether a program of this name is on every control, so that a call of it is right where no text has it.
pub fn delivered(name: &str) -> bool {
    ALL.iter().any(|program| program.name == name)
}
