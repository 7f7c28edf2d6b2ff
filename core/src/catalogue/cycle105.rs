//! CYCLE105(PAR1): prints the header or a block of values into the log (B:11235-11242). The edition A gives the two
//! numbers the other way round (A:12553).

use super::logging;
use super::logging::CONTENT_ALARMS;
use super::logging::params::{JOB, log_params};
use crate::entry::*;

/// The cycle.
pub static CYCLE105: Cycle = Cycle {
    name: "CYCLE105",
    key: "cycle105",
    variants: &[
        Variant { number: 0, key: "log-job-values", source: "B:11241" },
        Variant { number: 1, key: "log-job-header", source: "B:11242" },
    ],
    lists: &[ArgumentList::direct("CYCLE105", &[Arg::Param(JOB.name)], "B:11235-11242")],
    params: log_params!(
        Param { key: "log-job", example: "0", source: "B:11235-11242", ..JOB };
        header HEADER;
        values VALUES
    ),
    alarms: &[CONTENT_ALARMS],
    help: Help::new(&[
        &[
            measures(HEADER, "help-cycle105-header", "B:11237-11242"),
            measures(VALUES, "help-cycle105-values", "B:11237-11242"),
            before(When::Always, "help-cycle105-open", "B:11215-11217"),
            logging::help::chosen(VALUES),
            logging::help::header(HEADER),
            logging::help::block(VALUES),
            corrects(HEADER, "help-cycle105-left-header", "B:11237"),
            corrects(VALUES, "help-cycle105-left-values", "B:11237"),
            wrong(When::Always, "help-cycle105-number", "B:11239-11251;A:12547-12555"),
        ],
        logging::help::FORMAT,
    ]),
    simulation: Some(Simulation::new(logging::simulate::propose, logging::simulate::contents)),
    source: "B:11235-11242",
    ..logging::PRINTS
};

/// The header is printed.
const HEADER: When = When::Variant(&[1]);
/// A block of values is printed.
const VALUES: When = When::Variant(&[0]);
