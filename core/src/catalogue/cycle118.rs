//! CYCLE118(PAR1,PAR2,PAR3,PAR4,PAR5): makes texts of real numbers with so many decimals (B:11262-11320): of one
//! number, or of up to ten that are in consecutive R parameters.

use super::logging;
use super::logging::cells::{CELL, ROW, cells, left};
use super::logging::line::rounded;
use crate::catalogue::prelude::*;
use crate::control::Value;

/// The number.
const NUMBER: Name = Name::new("PAR1");
/// Digits behind the point.
const DECIMALS: Name = Name::new("PAR2");
/// How many numbers.
const COUNT: Name = Name::new("PAR4");
/// The first of several R parameters.
const REGISTER: Name = Name::new("PAR5");
/// More than one number.
const MANY: When = When::Above { param: COUNT, than: 1.0 };
/// Most numbers of a call (A:15904).
const MOST: f64 = 10.0;
/// More of them.
const TOO_MANY: Code = Code::Alarm(61362);

/// The cycle.
pub static CYCLE118: Cycle = Cycle {
    name: "CYCLE118",
    key: "cycle118",
    variants: &[Variant { number: 0, key: "cycle118-format", source: "B:11262;A:12580" }],
    lists: &[ArgumentList::direct(
        "CYCLE118",
        &[Arg::Param(NUMBER), Arg::Param(DECIMALS), Arg::Output("PAR3"), Arg::Param(COUNT), Arg::Param(REGISTER)],
        "B:11262",
    )],
    params: PARAMS,
    results: &[
        integer(TEXT, "result-118-text", When::Always, "B:11290"),
        integer("_TXT[0]", "result-118-field", MANY, "B:11280"),
        integer("_TXT[1]", "result-118-field", MANY, "B:11280"),
        integer("_TXT[2]", "result-118-field", When::Above { param: COUNT, than: 2.0 }, "B:11280"),
        integer("_TXT[3]", "result-118-field", When::Above { param: COUNT, than: 3.0 }, "B:11280"),
        integer("_TXT[4]", "result-118-field", When::Above { param: COUNT, than: 4.0 }, "B:11280"),
        integer("_TXT[5]", "result-118-field", When::Above { param: COUNT, than: 5.0 }, "B:11280"),
        integer("_TXT[6]", "result-118-field", When::Above { param: COUNT, than: 6.0 }, "B:11280"),
        integer("_TXT[7]", "result-118-field", When::Above { param: COUNT, than: 7.0 }, "B:11280"),
        integer("_TXT[8]", "result-118-field", When::Above { param: COUNT, than: 8.0 }, "B:11280"),
        integer("_TXT[9]", "result-118-field", When::Above { param: COUNT, than: 9.0 }, "B:11280"),
    ],
    alarms: &[&[TOO_MANY]],
    help: Help::new(&[&[
        measures(When::Always, "help-cycle118-does", "B:11264-11266"),
        before(When::Always, "help-cycle118-variable", "B:11270-11272"),
        before(When::Always, "help-cycle118-registers", "B:11276-11278"),
        order(When::Always, "help-cycle118-rounds", "B:11288-11290"),
        order(When::Always, "help-cycle118-many", "B:11276-11280"),
        corrects(When::Always, "help-cycle118-left", "B:11280;B:11320"),
        wrong(When::Always, "help-cycle118-count", "A:15904"),
        wrong(When::Always, "help-cycle118-length", "B:11272"),
    ]]),
    picture: Drawing::new(picture),
    simulation: Some(Simulation::new(logging::simulate::propose, simulate)),
    source: "B:11262-11320",
    ..logging::LOG
};

/// The example is that of the manual, B:11296-11308.
const PARAMS: &[Param] = &[
    Param {
        needs: &[optional(MANY, "need-118-registers"), required(When::Always, "need-118-one")],
        example: "31.830988618",
        ..param(NUMBER, "118-number", "B:11288")
    },
    Param {
        kind: Kind::Integer,
        range: Range::NOT_NEGATIVE,
        usual: Range::closed(0.0, 6.0),
        needs: ALWAYS_REQUIRED,
        example: "2",
        ..param(DECIMALS, "118-decimals", "B:11289")
    },
    Param {
        kind: Kind::Integer,
        range: Range::closed(1.0, MOST),
        alarm: Some(TOO_MANY),
        needs: &[optional(When::Always, "need-118-count")],
        ..param(COUNT, "118-count", "B:11291;A:15904")
    },
    Param {
        kind: Kind::Integer,
        range: Range::NOT_NEGATIVE,
        needs: &[required(MANY, "need-118-registers")],
        ..param(REGISTER, "118-register", "B:11292")
    },
];

/// What is handed back.
const TEXT: &str = "PAR3";

/// Makes the texts; the last one is handed back too (B:11320).
fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let (count, decimals) = (inputs.number(COUNT), inputs.number(DECIMALS));
    if count > MOST {
        return Err(Stop::Alarm(TOO_MANY));
    }
    let control = machine.control();
    let mut text = rounded(inputs.number(NUMBER), decimals);
    if count > 1.0 {
        let first = inputs.number(REGISTER);
        for place in 0..count as usize {
            text = rounded(control.number(&format!("R{}", first + place as f64)), decimals);
            control.data.insert(format!("_TXT[{place}]"), Value::Text(text.clone()));
        }
    }
    control.data.insert(TEXT.to_owned(), Value::Text(text));
    Ok(())
}

/// Characters of the variable (B:11272).
const LENGTH: usize = 12;
/// Most decimals for which the picture has room.
const ROOM: f64 = 8.0;

/// The text in its variable below the number, or the R parameters beside the fields that take their texts.
fn picture(inputs: &Inputs) -> Picture {
    let decimals = inputs.number(DECIMALS).clamp(0.0, ROOM) as usize;
    let mut shapes =
        if MANY.holds(inputs) { registers(inputs, decimals) } else { one(inputs.number(NUMBER), decimals) };
    shapes.sort_by_key(|shape| shape.kind == ShapeKind::Dimension);
    Picture { view: View::Plane, shapes }
}

/// The number above its text.
fn one(number: f64, decimals: usize) -> Vec<PictureShape> {
    let text = rounded(number, decimals as f64);
    let middle = left(LENGTH) / 2.0;
    let mut shapes = cells(&text, LENGTH, 0.0, COUNT);
    shapes.push(line(ShapeKind::Label, vec![[middle, ROW]]).text(number.to_string()).of(NUMBER));
    if decimals > 0 {
        let point = text.find('.').unwrap_or_default();
        shapes.push(digits(point + 1, decimals, 0.0));
    }
    shapes
}

/// The decimals of a text whose first one is in this cell.
fn digits(first: usize, decimals: usize, y: f64) -> PictureShape {
    let below = y - CELL * 1.2;
    let ends = [first, first + decimals].map(|cell| [left(cell), below]);
    dimension(DECIMALS, ends[0], ends[1])
}

/// A row for each of the R parameters. What they hold is not known here.
fn registers(inputs: &Inputs, decimals: usize) -> Vec<PictureShape> {
    let count = inputs.number(COUNT).clamp(1.0, MOST) as usize;
    let first = inputs.number(REGISTER).clamp(0.0, 1e4) as usize;
    let text = format!("{:.decimals$}", 0.0);
    let mut shapes = Vec::new();
    for row in 0..count {
        let y = -ROW * row as f64;
        let beside =
            |x: f64, text: String, field| line(ShapeKind::Label, vec![[x, y - CELL * 0.2]]).text(text).of(field);
        shapes.push(beside(-CELL * 2.0, format!("R{}", first + row), REGISTER));
        shapes.extend(cells(&text, LENGTH, y, COUNT));
        shapes.push(beside(left(LENGTH) + CELL * 2.0, format!("_TXT[{row}]"), COUNT));
    }
    if decimals > 0 {
        shapes.push(digits(2, decimals, -ROW * (count - 1) as f64));
    }
    shapes
}
