//! The variables and parameters of NCT controls that describe the machine: calibrated values, the tool probe, signals,
//! printing. Words follow from the name: `datum-nct-500` is #500.

use super::gud::{Element, FEED, LENGTH, Subject, Unit, element, subject};

/// A datum of the machine.
pub struct NctDatum {
    /// `#500`, `P9143`.
    pub name: &'static str,
    /// What it means; its number as delivered in mm, mm/min, 1/min.
    pub element: Element,
}

const fn datum(name: &'static str, element: Element) -> NctDatum {
    NctDatum { name, element }
}

const fn length(name: &'static str, source: &'static str) -> NctDatum {
    datum(name, element("", source).unit(LENGTH))
}

/// A parameter that holds the number of the G function which calls a macro: those from 9041 on have 101 and on (C:58).
const fn calls(name: &'static str) -> NctDatum {
    let last = name.as_bytes()[4] - b'0';
    let count = if name.as_bytes()[3] == b'5' { 10 } else { last };
    datum(name, element("", "C:58").initial(100.0 + count as f64).between(0.0, 999.0))
}

/// Settings of ours: how many levels of macros and of subprograms the control has; 0: not told. The manual of the
/// macros says what each needs (C:142-144), that of the control how many there are.
pub const LEVELS: [&str; 2] = ["PW-MACRO-LEVELS", "PW-SUBPROGRAM-LEVELS"];

const fn levels(name: &'static str) -> NctDatum {
    datum(name, element("", "C:142-144").between(0.0, 99.0))
}

/// All of them. #510 holds the M function that turns the spindle by half a turn; 0 and 1: none does (C:74, C:156).
pub static SUBJECTS: &[Subject<NctDatum>] = &[
    subject(
        "nct-stylus",
        &[
            length("#500", "C:304"),
            length("#501", "C:305"),
            length("#502", "C:306"),
            length("#503", "C:307"),
            length("#504", "C:176"),
            length("#505", "C:177"),
            datum("#510", element("", "C:74;C:156;C:162").between(0.0, 999.0)),
        ],
    ),
    subject(
        "nct-tool-probe",
        &[
            length("#506", "C:1193"),
            length("#507", "C:1194"),
            length("#508", "C:1195"),
            datum("#509", element("", "C:1196;C:1202").initial(40.0).unit(LENGTH).positive()),
            datum("#511", element("", "C:1197;C:1202").initial(1500.0).unit(Unit::Rpm).positive()),
            datum("#512", element("", "C:1198;C:1202").initial(750.0).unit(FEED).positive()),
            length("#513", "C:1200"),
            datum("#1002", element("", "C:1204").between(0.0, 1.0).switch()),
            datum("#1003", element("", "C:1204").initial(1.0).between(0.0, 1.0).switch()),
        ],
    ),
    subject(
        "nct-functions",
        &[
            calls("P9041"),
            calls("P9042"),
            calls("P9043"),
            calls("P9044"),
            calls("P9045"),
            calls("P9046"),
            calls("P9047"),
            calls("P9048"),
            calls("P9049"),
            calls("P9050"),
        ],
    ),
    subject("nct-levels", &[levels(LEVELS[0]), levels(LEVELS[1])]),
    subject("nct-printing", &[datum("P9143", element("", "C:60").initial(1.0).between(0.0, 1.0).switch())]),
];

/// All data, in the order of the subjects.
pub fn all() -> impl Iterator<Item = &'static NctDatum> {
    SUBJECTS.iter().flat_map(|subject| subject.data)
}

/// The datum with this name.
pub fn find(name: &str) -> Option<&'static NctDatum> {
    all().find(|datum| datum.name == name)
}

impl NctDatum {
    /// Key of its words.
    pub fn key(&self) -> String {
        match self.name.strip_prefix("PW-") {
            Some(ours) => format!("datum-nct-{}", ours.to_ascii_lowercase()),
            None => format!("datum-nct-{}", self.name.trim_start_matches(['#', 'P'])),
        }
    }
}
