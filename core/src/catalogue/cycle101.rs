//! CYCLE101: the log is switched off (B:11231-11233).

use super::{Cycle, Dialect, Drawing, Help, Variant, logging};

/// The cycle.
pub static CYCLE101: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE101",
    key: "cycle101",
    variants: &[Variant {
        number: 0,
        key: "cycle101-off",
        source: "B:11231;A:12541",
    }],
    purpose: logging::PURPOSE,
    lists: &[],
    settings: &[],
    params: &[],
    results: &[],
    alarms: &[],
    checks: |_, _, _| {},
    help: Help::NONE,
    picture: Drawing::NONE,
    example: &[],
    simulation: None,
    source: "B:11231-11233",
};
