//! Subprograms of the measuring cycles that programs of older versions call (B:2380-2405, A:16018-16041), but those
//! that are a call of today (`CYCLES`).

/// A subprogram of the measuring cycles.
pub struct Subroutine {
    /// Name.
    pub name: &'static str,
    /// Key of what it does, with the versions in which it was there.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

const fn subroutine(name: &'static str, key: &'static str, source: &'static str) -> Subroutine {
    Subroutine { name, key, source }
}

/// In the order of their numbers.
pub static SUBROUTINES: [Subroutine; 12] = [
    subroutine("CYCLE102", "subroutine-result", "B:2386"),
    subroutine("CYCLE103", "subroutine-dialogue", "B:2387;A:15977-16007"),
    subroutine("CYCLE104", "subroutine-interface", "B:2388"),
    subroutine("CYCLE107", "subroutine-messages", "B:2391"),
    subroutine("CYCLE108", "subroutine-alarms", "B:2392"),
    subroutine("CYCLE109", "subroutine-transfer", "B:2393"),
    subroutine("CYCLE110", "subroutine-plausibility", "B:2394"),
    subroutine("CYCLE111", "subroutine-measuring", "B:2395"),
    subroutine("CYCLE112", "subroutine-milling", "B:2396"),
    subroutine("CYCLE114", "subroutine-tool", "B:2398-2399;A:2583-2584"),
    subroutine("CYCLE115", "subroutine-zero", "B:2400"),
    subroutine("CYCLE117", "subroutine-approach", "B:2402"),
];

/// The subprogram of this name.
pub fn find(name: &str) -> Option<&'static Subroutine> {
    SUBROUTINES.iter().find(|one| one.name.eq_ignore_ascii_case(name))
}
