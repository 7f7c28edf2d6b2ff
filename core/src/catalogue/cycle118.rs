//! CYCLE118(PAR1,PAR2,PAR3,PAR4,PAR5): makes texts of real numbers with so many decimals (B:11262-11320): of one number, or
//! of up to ten that stand in consecutive R parameters.

use super::common::{ALWAYS_REQUIRED, PARAM, alarms, integer, optional, required};
use super::help::{HelpLine, before, corrects, measures, order, wrong};
use super::{
    Arg, ArgumentList, Cycle, Dialect, Drawing, Help, Kind, Param, Range, Style, Variant, When,
    logging,
};

/// How many numbers.
const COUNT: &str = "PAR4";
/// More than one number.
const MANY: When = When::Above {
    param: COUNT,
    than: 1.0,
};
/// Most numbers of a call (A:15904).
const MOST: f64 = 10.0;

/// The cycle.
pub static CYCLE118: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE118",
    key: "cycle118",
    variants: &[Variant {
        number: 0,
        key: "cycle118-format",
        source: "B:11262;A:12580",
    }],
    purpose: logging::PURPOSE,
    lists: &[ArgumentList {
        style: Style::Direct,
        name: "CYCLE118",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Param("PAR1"),
            Arg::Param("PAR2"),
            Arg::Output("PAR3"),
            Arg::Param(COUNT),
            Arg::Param("PAR5"),
        ],
        source: "B:11262",
    }],
    settings: &[],
    params: PARAMS,
    results: &[
        integer("PAR3", "result-118-text", When::Always, "B:11290"),
        integer(
            "_TXT[0]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 1.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[1]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 1.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[2]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 2.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[3]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 3.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[4]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 4.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[5]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 5.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[6]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 6.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[7]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 7.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[8]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 8.0,
            },
            "B:11280",
        ),
        integer(
            "_TXT[9]",
            "result-118-field",
            When::Above {
                param: COUNT,
                than: 9.0,
            },
            "B:11280",
        ),
    ],
    alarms: &[&alarms([61362])], // A:15904
    checks: |_, _, _| {},
    help: Help::new(&[LINES]),
    picture: Drawing::NONE,
    // the example of the manual, B:11296-11308
    example: &[("PAR1", "31.830988618"), ("PAR2", "2")],
    simulation: None,
    source: "B:11262-11320",
};

const PARAMS: &[Param] = &[
    Param {
        name: "PAR1",
        key: "118-number",
        needs: &[
            optional(MANY, "need-118-registers"),
            required(When::Always, "need-118-one"),
        ],
        source: "B:11288",
        ..PARAM
    },
    Param {
        name: "PAR2",
        key: "118-decimals",
        kind: Kind::Integer,
        range: Range::NOT_NEGATIVE,
        usual: Range::closed(0.0, 6.0),
        needs: ALWAYS_REQUIRED,
        source: "B:11289",
        ..PARAM
    },
    Param {
        name: COUNT,
        key: "118-count",
        kind: Kind::Integer,
        range: Range::closed(1.0, MOST),
        alarm: Some(alarms([61362])[0]),
        needs: &[optional(When::Always, "need-118-count")],
        source: "B:11291;A:15904",
        ..PARAM
    },
    Param {
        name: "PAR5",
        key: "118-register",
        kind: Kind::Integer,
        range: Range::NOT_NEGATIVE,
        needs: &[required(MANY, "need-118-registers")],
        source: "B:11292",
        ..PARAM
    },
];

const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle118-does", "B:11264-11266"),
    before(When::Always, "help-cycle118-variable", "B:11270-11272"),
    before(When::Always, "help-cycle118-registers", "B:11276-11278"),
    order(When::Always, "help-cycle118-rounds", "B:11288-11290"),
    order(When::Always, "help-cycle118-many", "B:11276-11280"),
    corrects(When::Always, "help-cycle118-left", "B:11280;B:11320"),
    wrong(When::Always, "help-cycle118-count", "A:15904"),
    wrong(When::Always, "help-cycle118-length", "B:11272"),
];
