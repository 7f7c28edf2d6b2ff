//! CYCLE100: the log is switched on (B:11227-11229). The file is made anew, the header is printed; from then on every
//! measuring cycle adds a block of values.

use super::logging;
use super::logging::params::log_params;
use super::logging::{CONTENT_ALARMS, FILE_ALARMS, params};
use crate::entry::*;

/// The cycle.
pub static CYCLE100: Cycle = Cycle {
    name: "CYCLE100",
    key: "cycle100",
    variants: &[Variant { number: 0, key: "cycle100-on", source: "B:11227;A:12535" }],
    params: log_params!(params::FILE; header When::Always; values When::Always),
    alarms: &[FILE_ALARMS, CONTENT_ALARMS],
    help: Help::new(&[
        &[
            measures(When::Always, "help-cycle100-does", "B:11211-11213;B:11227"),
            before(When::Always, "help-cycle100-values", "B:11396-11402"),
            order(When::Always, "help-cycle100-begin", "B:11229;B:11253"),
            logging::help::header(When::Always),
            order(When::Always, "help-cycle100-each", "B:11213"),
            wrong(When::Always, "help-cycle100-lost", "B:11200;B:11229"),
            wrong(When::Always, "help-cycle100-old", "B:11229"),
        ],
        logging::help::FORMAT,
        logging::help::FILE,
    ]),
    simulation: Some(Simulation::new(logging::simulate::propose, logging::simulate::on)),
    source: "B:11172-11229",
    ..logging::PRINTS
};
