//! CYCLE113(PAR1,PAR2): reads date or time of the control as a text (B:11255-11260).

use super::common::{ALWAYS_REQUIRED, PARAM, integer};
use super::logging;
use super::logging::cells::cells;
use super::logging::names::JOB;
use crate::dialect::Dialect;
use crate::entry::{
    Arg, ArgumentList, Cycle, Drawing, Help, HelpLine, Inputs, Kind, Param, Style, Variant, When, before, corrects,
    measures, order, wrong,
};
use crate::picture::{Picture, View};

/// The cycle.
pub static CYCLE113: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE113",
    key: "cycle113",
    variants: &[
        Variant { number: 1, key: "cycle113-date", source: "B:11258;A:12576" },
        Variant { number: 2, key: "cycle113-time", source: "B:11259;A:12577" },
    ],
    purpose: logging::PURPOSE,
    lists: &[ArgumentList {
        style: Style::Direct,
        name: "CYCLE113",
        when: When::Always,
        base: 0,
        args: &[Arg::Param(JOB), Arg::Output("PAR2")],
        source: "B:11255",
    }],
    settings: &[],
    params: &[Param {
        name: JOB,
        key: "113-job",
        kind: Kind::Variant(&[]),
        needs: ALWAYS_REQUIRED,
        source: "B:11258-11259",
        ..PARAM
    }],
    results: &[integer("PAR2", "result-113-text", When::Always, "B:11260")],
    alarms: &[],
    checks: |_, _, _| {},
    help: Help::new(&[LINES]),
    picture: Drawing::new(picture),
    example: &[(JOB, "1")],
    simulation: None,
    source: "B:11255-11260",
};

const DATE: When = When::Variant(&[1]);
const TIME: When = When::Variant(&[2]);

/// Characters of the variable (B:11260).
const LENGTH: usize = 10;

/// The variable with a text as the control would write it.
fn picture(inputs: &Inputs) -> Picture {
    let text = if TIME.holds(inputs) { "23:59:00" } else { "06/12/31" };
    Picture { view: View::Plane, shapes: cells(text, LENGTH, 0.0, JOB) }
}

const LINES: &[HelpLine] = &[
    measures(DATE, "help-cycle113-date", "B:11258"),
    measures(TIME, "help-cycle113-time", "B:11259"),
    before(When::Always, "help-cycle113-variable", "B:11260"),
    order(DATE, "help-cycle113-year", "B:11258;B:11483"),
    order(TIME, "help-cycle113-hour", "B:11259;B:11483"),
    corrects(When::Always, "help-cycle113-left", "B:11258-11260"),
    wrong(When::Always, "help-cycle113-short", "B:11260"),
];
