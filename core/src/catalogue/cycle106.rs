//! CYCLE106(PAR1): keeps the log (B:11244-11253): old files, follow-up files, pages. CYCLE100 calls it by itself.

use super::logging;
use super::logging::params::{JOB, log_params};
use super::logging::{CONTENT_ALARMS, FILE_ALARMS, params};
use crate::catalogue::prelude::*;

/// The cycle.
pub static CYCLE106: Cycle = Cycle {
    name: "CYCLE106",
    key: "cycle106",
    variants: &[
        Variant { number: 1, key: "log-job-header", source: "B:11250" },
        Variant { number: 2, key: "log-job-values", source: "B:11251" },
    ],
    lists: &[ArgumentList::direct("CYCLE106", &[Arg::Param(JOB.name)], "B:11244-11253")],
    params: log_params!(
        Param { key: "log-job", example: "2", alarm: Some(Code::Alarm(61360)), source: "B:11244-11253", ..JOB },
        params::FILE;
        header HEADER;
        values VALUES
    ),
    alarms: &[CONTENT_ALARMS, FILE_ALARMS],
    help: Help::new(&[
        &[
            measures(HEADER, "help-cycle106-header", "B:11246-11253"),
            measures(VALUES, "help-cycle106-values", "B:11246-11253"),
            before(When::Always, "help-cycle106-alone", "B:11213-11217;B:11253"),
            logging::help::chosen(VALUES),
            order(When::Always, "help-cycle106-keeps", "B:11253;B:11435"),
            logging::help::header(HEADER),
            logging::help::block(VALUES),
            wrong(When::Always, "help-cycle106-number", "B:11248-11251;A:15902"),
        ],
        logging::help::FORMAT,
        logging::help::FILE,
    ]),
    simulation: Some(Simulation::new(logging::simulate::propose, logging::simulate::sequence)),
    source: "B:11244-11253",
    ..logging::PRINTS
};

/// The header is printed.
const HEADER: When = When::Variant(&[1]);
/// A block of values is printed.
const VALUES: When = When::Variant(&[2]);
