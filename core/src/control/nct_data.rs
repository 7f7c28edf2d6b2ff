//! The variables and parameters of NCT controls that describe the machine: calibrated values, the tool probe, signals,
//! printing. Words follow from the name: `datum-nct-500` is #500.

use super::gud::{System, Unit};
use crate::range::Range;

/// A datum of the machine.
pub struct NctDatum {
    /// `#500`, `P9143`.
    pub name: &'static str,
    /// Unit, and the system in which it stands.
    pub unit: Unit,
    /// As delivered, mm, mm/min, 1/min; none: it is 0.
    pub initial: Option<f64>,
    /// Where only these are allowed.
    pub choices: &'static [i64],
    /// What is allowed, in its unit.
    pub range: Range,
    /// Place in the manual.
    pub source: &'static str,
}

/// Data of one subject.
pub struct Subject {
    /// Key of its name behind `machine-group-`.
    pub key: &'static str,
    /// Its data.
    pub data: &'static [NctDatum],
}

const LENGTH: Unit = Unit::Length(System::Basic);

const fn length(name: &'static str, source: &'static str) -> NctDatum {
    NctDatum { name, unit: LENGTH, initial: None, choices: &[], range: Range::ANY, source }
}

const fn delivered(datum: NctDatum, initial: f64, range: Range) -> NctDatum {
    NctDatum { initial: Some(initial), range, ..datum }
}

const fn with_unit(datum: NctDatum, unit: Unit) -> NctDatum {
    NctDatum { unit, ..datum }
}

const fn signal(name: &'static str, initial: f64, source: &'static str) -> NctDatum {
    NctDatum { unit: Unit::None, choices: &[0, 1], ..delivered(length(name, source), initial, Range::closed(0.0, 1.0)) }
}

/// All of them. #510 holds the M function that turns the spindle by half a turn; 0 and 1 mean that none does (C:74,
/// C:156).
pub static SUBJECTS: &[Subject] = &[
    Subject {
        key: "nct-stylus",
        data: &[
            length("#500", "C:304"),
            length("#501", "C:305"),
            length("#502", "C:306"),
            length("#503", "C:307"),
            length("#504", "C:176"),
            length("#505", "C:177"),
            NctDatum { range: Range::closed(0.0, 999.0), ..with_unit(length("#510", "C:74;C:156;C:162"), Unit::None) },
        ],
    },
    Subject {
        key: "nct-tool-probe",
        data: &[
            length("#506", "C:1193"),
            length("#507", "C:1194"),
            length("#508", "C:1195"),
            delivered(length("#509", "C:1196;C:1202"), 40.0, Range::POSITIVE),
            delivered(with_unit(length("#511", "C:1197;C:1202"), Unit::Rpm), 1500.0, Range::POSITIVE),
            delivered(with_unit(length("#512", "C:1198;C:1202"), Unit::Feed(System::Basic)), 750.0, Range::POSITIVE),
            length("#513", "C:1200"),
            signal("#1002", 0.0, "C:1204"),
            signal("#1003", 1.0, "C:1204"),
        ],
    },
    Subject { key: "nct-printing", data: &[signal("P9143", 1.0, "C:60")] },
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
        format!("datum-nct-{}", self.name.trim_start_matches(['#', 'P']))
    }
}
