//! CYCLE119: position in space (B:8541-8592). From three set and three measured points it computes the frame between
//! them and corrects one, if it is told to. It measures nothing; CYCLE997 calls it for three spheres, a program may
//! call it with points of its own.

mod checks;
mod params;
mod picture;
mod simulate;
#[cfg(test)]
mod tests;

use super::common::{CYCLE, alarms, angle, integer, length};
use crate::entry::*;

/// The cycle. Example: that of the manual, B:8600-8622; its active frame is G54, which a form without a program has to
/// name.
pub static CYCLE119: Cycle = Cycle {
    name: "CYCLE119",
    key: "cycle119",
    variants: &[Variant { number: 0, key: "cycle119-position", source: "B:8541;A:9386" }],
    purpose: Purpose { probe: ProbeUse::None, ..Purpose::MILLING },
    lists: &[ArgumentList::direct(
        "CYCLE119",
        &[
            Arg::Variable("_SETPOINT"),
            Arg::Variable("_MEASPOINT"),
            Arg::Output("_ALARM"),
            Arg::Output("_RES"),
            Arg::Output("_REFRAME"),
            Arg::Param(params::TARGET),
            Arg::Param(params::LIMIT),
        ],
        "B:8557",
    )],
    params: params::PARAMS,
    results: &[
        integer("_ALARM", "result-119-alarm", When::Always, "B:8579"),
        ResultField {
            unit: Unit::BasicLength,
            ..length("_RES", "result-119-distortion", When::Always, "B:8573;B:8581-8583;A:9416")
        },
        length("_REFRAME[X,TR]", "result-119-frame-x", When::Always, "B:8584"),
        length("_REFRAME[Y,TR]", "result-119-frame-y", When::Always, "B:8584"),
        length("_REFRAME[Z,TR]", "result-119-frame-z", When::Always, "B:8584"),
        angle("_REFRAME[X,RT]", "result-119-turn-x", When::Always, "B:8584"),
        angle("_REFRAME[Y,RT]", "result-119-turn-y", When::Always, "B:8584"),
        angle("_REFRAME[Z,RT]", "result-119-turn-z", When::Always, "B:8584"),
    ],
    alarms: &[&alarms([61321, 61411, 61412, 61414])], // A:15862, A:15930-15933
    checks: checks::checks,
    // B:8541-8592
    help: Help::new(&[&[
        measures(When::Always, "help-cycle119-does", "B:8547"),
        before(When::Always, "help-cycle119-variables", "B:8559-8586"),
        before(When::Always, "help-cycle119-points", "B:8563-8565"),
        before(When::Always, "help-cycle119-alarm", "B:8579-8580"),
        order(When::Always, "help-cycle119-frame", "B:8581-8584"),
        order(When::Always, "help-cycle119-decides", "B:8566-8576"),
        corrects(When::Always, "help-cycle119-left", "B:8579-8586"),
        corrects(When::Always, "help-cycle119-frame-moved", "B:8566-8573"),
        corrects(When::Always, "help-cycle119-again", "B:8592"),
        wrong(When::Always, "help-cycle119-line", "B:8582;A:15930"),
        wrong(When::Always, "help-cycle119-distorted", "B:8575-8576;A:15933"),
        wrong(When::Always, "help-cycle119-order", "B:8563-8565"),
        wrong(When::Always, "help-cycle119-mirrored", "B:8588;A:15930"),
        wrong(When::Always, "help-cycle119-absent", "B:8588;A:15862;A:15932"),
        wrong(When::Always, "help-cycle119-unseen", "B:8579-8583"),
    ]]),
    picture: Drawing::new(picture::picture),
    simulation: Some(Simulation::new(|_, _| Proposal::default(), simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Points)],
        corrects: &[(When::Always, Corrects::Zero, &[]), (When::Always, Corrects::Nothing, &[(params::TARGET, "0")])],
        options: &[(When::Always, "aim-from", "aim-from-position")],
    },
    source: "B:8541-8622",
    ..CYCLE
};
