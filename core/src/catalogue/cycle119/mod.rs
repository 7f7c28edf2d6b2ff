//! CYCLE119: position in space (B:8541-8592). From three set and three measured points it computes the frame between them
//! and corrects one, if it is told to. It measures nothing; CYCLE997 calls it for three spheres, a program may call it
//! with points of its own.

mod checks;
mod params;
mod picture;
#[cfg(test)]
mod tests;

use super::common::{alarms, integer};
use super::{
    Arg, ArgumentList, Cycle, Dialect, Drawing, MachineSort, NEVER, ProbeUse, Purpose, ResultField,
    Style, Unit, Variant, When,
};

/// The cycle.
pub static CYCLE119: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE119",
    key: "cycle119",
    variants: &[Variant {
        number: 0,
        key: "cycle119-position",
        source: "B:8541;A:9386",
    }],
    purpose: Purpose {
        probe: ProbeUse::None,
        machine: MachineSort::Milling,
        calibrates: NEVER,
    },
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
    settings: &[],
    params: params::PARAMS,
    results: &[
        integer("_ALARM", "result-119-alarm", When::Always, "B:8579"),
        ResultField {
            name: "_RES",
            key: "result-119-distortion",
            when: When::Always,
            unit: Unit::ActiveLength,
            source: "B:8581;A:9416",
        },
        integer("_REFRAME", "result-119-frame", When::Always, "B:8584"),
    ],
    alarms: &[&alarms([61321, 61411, 61412, 61414])], // A:15862, A:15930-15933
    checks: checks::checks,
    picture: Drawing::new(picture::picture),
    // the example of the manual, B:8600-8622
    example: &[
        ("_SETPOINT[0,0]", "10"),
        ("_SETPOINT[0,1]", "0"),
        ("_SETPOINT[0,2]", "0"),
        ("_SETPOINT[1,0]", "0"),
        ("_SETPOINT[1,1]", "20"),
        ("_SETPOINT[1,2]", "0"),
        ("_SETPOINT[2,0]", "0"),
        ("_SETPOINT[2,1]", "0"),
        ("_SETPOINT[2,2]", "30"),
        ("_MEASPOINT[0,0]", "11"),
        ("_MEASPOINT[0,1]", "0"),
        ("_MEASPOINT[0,2]", "0"),
        ("_MEASPOINT[1,0]", "1"),
        ("_MEASPOINT[1,1]", "20"),
        ("_MEASPOINT[1,2]", "0"),
        ("_MEASPOINT[2,0]", "1"),
        ("_MEASPOINT[2,1]", "0"),
        ("_MEASPOINT[2,2]", "30"),
        ("_COR", "9999"),
        ("_RESLIM", "1.2"),
    ],
    simulation: None,
    source: "B:8541-8622",
};
