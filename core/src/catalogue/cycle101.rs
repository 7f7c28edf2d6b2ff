//! CYCLE101: the log is switched off (B:11231-11233).

use super::logging;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Drawing, Help, HelpLine, Variant, When, before, corrects, measures, order, wrong};

/// The cycle.
pub static CYCLE101: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE101",
    key: "cycle101",
    variants: &[Variant { number: 0, key: "cycle101-off", source: "B:11231;A:12541" }],
    purpose: logging::PURPOSE,
    lists: &[],
    settings: &[],
    params: &[],
    results: &[],
    alarms: &[],
    checks: |_, _, _| {},
    help: Help::new(&[LINES]),
    picture: Drawing::new(logging::closed),
    example: &[],
    simulation: None,
    source: "B:11231-11233",
};

const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle101-does", "B:11233"),
    before(When::Always, "help-cycle101-last", "B:11213;B:11233"),
    order(When::Always, "help-cycle101-flag", "B:11233"),
    corrects(When::Always, "help-cycle101-files", "B:11209"),
    wrong(When::Always, "help-cycle101-missing", "B:11209;B:11233"),
];
