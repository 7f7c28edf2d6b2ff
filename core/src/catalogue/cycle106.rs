//! CYCLE106(PAR1): keeps the log (B:11244-11253): old files, follow-up files, pages. CYCLE100 calls it by itself.

use super::common::{ALWAYS_REQUIRED, PARAM, alarms, optional, required};
use super::logging;
use super::logging::names::JOB;
use super::logging::params::log_params;
use super::logging::{CONTENT_ALARMS, FILE_ALARMS, log_example, names, params};
use crate::dialect::Dialect;
use crate::entry::{
    Arg, ArgumentList, Cycle, Drawing, Help, HelpLine, Kind, Param, Style, Variant, When, before, measures, order,
    wrong,
};

/// The cycle.
pub static CYCLE106: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE106",
    key: "cycle106",
    variants: &[
        Variant { number: 1, key: "log-job-header", source: "B:11250" },
        Variant { number: 2, key: "log-job-values", source: "B:11251" },
    ],
    purpose: logging::PURPOSE,
    lists: &[ArgumentList {
        style: Style::Direct,
        name: "CYCLE106",
        when: When::Always,
        base: 0,
        args: &[Arg::Param(JOB)],
        source: "B:11244-11253",
    }],
    settings: logging::SETTINGS,
    params: PARAMS,
    results: &[],
    alarms: &[CONTENT_ALARMS, FILE_ALARMS],
    checks: logging::checks,
    help: Help::new(&[LINES, logging::help::FORMAT, logging::help::FILE]),
    picture: Drawing::new(logging::picture),
    example: log_example!((JOB, "2"), (names::FILE, "LOG_1")),
    simulation: None,
    source: "B:11244-11253",
};

/// The header is printed.
const HEADER: When = When::Variant(&[1]);
/// A block of values is printed.
const VALUES: When = When::Variant(&[2]);

const PARAMS: &[Param] = log_params!(
    Param {
        name: JOB,
        key: "log-job",
        kind: Kind::Variant(&[]),
        needs: ALWAYS_REQUIRED,
        alarm: Some(alarms([61360])[0]),
        source: "B:11244-11253",
        ..PARAM
    },
    Param {
        needs: &[required(When::Always, "need-log-file")],
        ..params::FILE
    };
    header HEADER;
    values VALUES
);

const LINES: &[HelpLine] = &[
    measures(HEADER, "help-cycle106-header", "B:11246-11253"),
    measures(VALUES, "help-cycle106-values", "B:11246-11253"),
    before(When::Always, "help-cycle106-alone", "B:11213-11217;B:11253"),
    logging::help::chosen(VALUES),
    order(When::Always, "help-cycle106-keeps", "B:11253;B:11435"),
    logging::help::header(HEADER),
    logging::help::block(VALUES),
    wrong(When::Always, "help-cycle106-number", "B:11248-11251;A:15902"),
];
