//! CYCLE105(PAR1): prints the header or a block of values into the log (B:11235-11242). The edition A gives the two
//! numbers the other way round (A:12553).

use super::common::{ALWAYS_REQUIRED, PARAM, optional};
use super::logging;
use super::logging::names::JOB;
use super::logging::params::log_params;
use super::logging::{CONTENT_ALARMS, log_example, names, params};
use crate::dialect::Dialect;
use crate::entry::{
    Arg, ArgumentList, Cycle, Drawing, Help, HelpLine, Kind, Param, Style, Variant, When, before, corrects, measures,
    wrong,
};

/// The cycle.
pub static CYCLE105: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE105",
    key: "cycle105",
    variants: &[
        Variant { number: 0, key: "log-job-values", source: "B:11241" },
        Variant { number: 1, key: "log-job-header", source: "B:11242" },
    ],
    purpose: logging::PURPOSE,
    lists: &[ArgumentList {
        style: Style::Direct,
        name: "CYCLE105",
        when: When::Always,
        base: 0,
        args: &[Arg::Param(JOB)],
        source: "B:11235-11242",
    }],
    settings: logging::SETTINGS,
    params: PARAMS,
    results: &[],
    alarms: &[CONTENT_ALARMS],
    checks: logging::checks,
    help: Help::new(&[LINES, logging::help::FORMAT]),
    picture: Drawing::new(logging::picture),
    example: log_example!((JOB, "0")),
    simulation: None,
    source: "B:11235-11242",
};

/// The header is printed.
const HEADER: When = When::Variant(&[1]);
/// A block of values is printed.
const VALUES: When = When::Variant(&[0]);

const PARAMS: &[Param] = log_params!(
    Param {
        name: JOB,
        key: "log-job",
        kind: Kind::Variant(&[]),
        needs: ALWAYS_REQUIRED,
        source: "B:11235-11242",
        ..PARAM
    };
    header HEADER;
    values VALUES
);

const LINES: &[HelpLine] = &[
    measures(HEADER, "help-cycle105-header", "B:11237-11242"),
    measures(VALUES, "help-cycle105-values", "B:11237-11242"),
    before(When::Always, "help-cycle105-open", "B:11215-11217"),
    logging::help::chosen(VALUES),
    logging::help::header(HEADER),
    logging::help::block(VALUES),
    corrects(HEADER, "help-cycle105-left-header", "B:11237"),
    corrects(VALUES, "help-cycle105-left-values", "B:11237"),
    wrong(When::Always, "help-cycle105-number", "B:11239-11251;A:12547-12555"),
];
