//! CYCLE119: position in space (B:8541-8592). From three set and three measured points it computes the frame between
//! them and corrects one, if it is told to. It measures nothing; CYCLE997 calls it for three spheres, a program may
//! call it with points of its own.

mod checks;
mod help;
mod params;
mod picture;
mod simulate;
#[cfg(test)]
mod tests;

use super::common::{CYCLE, alarms, angle, integer, length};
use crate::control::MachineSort;
use crate::entry::{
    Arg, ArgumentList, Cycle, Drawing, Help, NEVER, ProbeUse, Proposal, Purpose, ResultField, Simulation, Style, Unit,
    Variant, When,
};

/// The cycle. Example: that of the manual, B:8600-8622; its active frame is G54, which a form without a program has to
/// name.
pub static CYCLE119: Cycle = Cycle {
    name: "CYCLE119",
    key: "cycle119",
    variants: &[Variant { number: 0, key: "cycle119-position", source: "B:8541;A:9386" }],
    purpose: Purpose { probe: ProbeUse::None, machine: MachineSort::Milling, calibrates: NEVER, tasks: &[] },
    lists: &[ArgumentList {
        style: Style::Direct,
        name: "CYCLE119",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Variable("_SETPOINT"),
            Arg::Variable("_MEASPOINT"),
            Arg::Output("_ALARM"),
            Arg::Output("_RES"),
            Arg::Output("_REFRAME"),
            Arg::Param(params::TARGET),
            Arg::Param(params::LIMIT),
        ],
        source: "B:8557",
    }],
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
    help: Help::new(&[help::LINES]),
    picture: Drawing::new(picture::picture),
    simulation: Some(Simulation::new(|_, _| Proposal::default(), simulate::simulate)),
    source: "B:8541-8622",
    ..CYCLE
};
