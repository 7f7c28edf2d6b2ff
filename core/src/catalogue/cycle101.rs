//! CYCLE101: the log is switched off (B:11231-11233).

use super::logging;
use crate::entry::*;

/// The cycle.
pub static CYCLE101: Cycle = Cycle {
    name: "CYCLE101",
    key: "cycle101",
    variants: &[Variant { number: 0, key: "cycle101-off", source: "B:11231;A:12541" }],
    help: Help::new(&[&[
        measures(When::Always, "help-cycle101-does", "B:11233"),
        before(When::Always, "help-cycle101-last", "B:11213;B:11233"),
        order(When::Always, "help-cycle101-flag", "B:11233"),
        corrects(When::Always, "help-cycle101-files", "B:11209"),
        wrong(When::Always, "help-cycle101-missing", "B:11209;B:11233"),
    ]]),
    picture: Drawing::new(logging::closed),
    simulation: Some(Simulation::new(logging::simulate::propose, logging::simulate::off)),
    source: "B:11231-11233",
    ..logging::LOG
};
