//! CYCLE113(PAR1,PAR2): reads date or time of the control as a text (B:11255-11260).

use super::logging;
use super::logging::cells::cells;
use super::logging::params::JOB;
use crate::catalogue::prelude::*;
use crate::control::Value;

/// The cycle.
pub static CYCLE113: Cycle = Cycle {
    name: "CYCLE113",
    key: "cycle113",
    variants: &[
        Variant { number: 1, key: "cycle113-date", source: "B:11258;A:12576" },
        Variant { number: 2, key: "cycle113-time", source: "B:11259;A:12577" },
    ],
    lists: &[ArgumentList::direct("CYCLE113", &[Arg::Param(JOB.name), Arg::Output("PAR2")], "B:11255")],
    params: &[Param { key: "113-job", example: "1", source: "B:11258-11259", ..JOB }],
    results: &[integer(TEXT, "result-113-text", When::Always, "B:11260")],
    help: Help::new(&[&[
        measures(DATE, "help-cycle113-date", "B:11258"),
        measures(TIME, "help-cycle113-time", "B:11259"),
        before(When::Always, "help-cycle113-variable", "B:11260"),
        order(DATE, "help-cycle113-year", "B:11258;B:11483"),
        order(TIME, "help-cycle113-hour", "B:11259;B:11483"),
        corrects(When::Always, "help-cycle113-left", "B:11258-11260"),
        wrong(When::Always, "help-cycle113-short", "B:11260"),
    ]]),
    picture: Drawing::new(picture),
    simulation: Some(Simulation::new(logging::simulate::propose, simulate)),
    source: "B:11255-11260",
    ..logging::LOG
};

const DATE: When = When::Variant(&[1]);
const TIME: When = When::Variant(&[2]);

/// Characters of the variable (B:11260).
const LENGTH: usize = 10;

/// What is handed back.
const TEXT: &str = "PAR2";

/// Hands date or time back. A job that it does not know makes an empty text.
fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let now = machine.now();
    let text = match inputs.given(JOB.name) {
        Some(1.0) => now.date(),
        Some(2.0) => now.time(),
        _ => String::new(),
    };
    machine.control().data.insert(TEXT.to_owned(), Value::Text(text));
    Ok(())
}

/// The variable with a text as the control would write it.
fn picture(inputs: &Inputs) -> Picture {
    let text = if TIME.holds(inputs) { "23:59:00" } else { "06/12/31" };
    Picture { view: View::Plane, shapes: cells(text, LENGTH, 0.0, JOB.name) }
}
