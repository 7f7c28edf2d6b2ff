//! What the control itself answers: operator texts, alarms of the program, the tool environment, the swivel table.

use super::{Call, Datum, Halt, Interpreter, contour, evaluate};
use crate::catalogue::alarms;
use crate::control::Frame;
use crate::diagnostic::{Code, Span};
use crate::geometry::rigid::{angles, rotation};
use crate::geometry::{Degrees, V3};
use crate::machine::Step;
use crate::problem::Problem;
use crate::program::of_control::{SET_ALARM, STORE_ENVIRONMENT, SWIVEL};
use crate::syntax::tree::{Expr, ExprId};
use std::rc::Rc;

/// Numbers that a program may raise: those of cycles, and of users from 65000.
const NUMBERS: std::ops::RangeInclusive<u32> = 60_000..=69_999;

/// `SETAL(65000,"text")`: an alarm; from 62000 and 67000 it only shows (Job planning, alarms in the cycle area).
pub fn raise(run: &mut Interpreter, call: &Call) -> Result<(), Halt> {
    let (number, text) = match &call.args[..] {
        [Some(Datum::Number(number))] => (*number, ""),
        [Some(Datum::Number(number)), Some(Datum::Text(text))] => (*number, text.as_str()),
        _ => return Err(Problem::new("run-function", call.span, SET_ALARM).into()),
    };
    let whole = number as u32;
    if number.fract() != 0.0 || !NUMBERS.contains(&whole) {
        return Err(Problem::new("run-alarm-number", call.span, Datum::Number(number).shown()).into());
    }
    let code = Code::Alarm(whole);
    if alarms::find(&whole.to_string()).is_some() {
        run.sim.note(Step::Alarm(code));
    } else {
        run.sim.note(Step::Message { text: format!("{whole} {text}").trim_end().to_owned() });
    }
    if matches!(whole / 1000, 62 | 67..=69) {
        return Ok(());
    }
    Err(Problem::at("run-set-alarm", call.span).number("number", f64::from(whole)).text("text", text).into())
}

/// Longest name of an environment, characters (B:2078).
const LONGEST: usize = 32;

/// Status of a stored environment.
const STORED: Datum = Datum::Number(0.0);

/// `TOOLENV("NAME")`: stores the tool environment, as a block of its own or as a function with a status (B:2062-2086).
pub fn store_environment(run: &mut Interpreter, args: &[Option<Datum>], place: Span) -> Result<Datum, Problem> {
    match args {
        [Some(Datum::Text(name))] if (1..=LONGEST).contains(&name.chars().count()) => {
            run.sim.control.store_environment(name);
            Ok(STORED)
        }
        _ => Err(Problem::new("run-function", place, STORE_ENVIRONMENT)),
    }
}

/// Status of `TOOLENV("NAME")` as the right side of an assignment; none: that is something else.
pub fn assigned(run: &mut Interpreter, value: ExprId) -> Result<Option<Datum>, Problem> {
    let program = Rc::clone(&run.program);
    let Some(Expr::Call(name, args)) = program.expr(value) else { return Ok(None) };
    if !program.is(*name, STORE_ENVIRONMENT) {
        return Ok(None);
    }
    let args = args.iter().map(|arg| evaluate(run, *arg).map(Some)).collect::<Result<Vec<_>, _>>()?;
    store_environment(run, &args, *name).map(Some)
}

/// Argument with the name of the swivel data set, and the name by which none is meant.
const DATA_SET: usize = 1;
const NO_DATA_SET: &str = "0";

/// Arguments that shift or turn the plane: X0 Y0 Z0, three angles, X1 Y1 Z1.
const OFFSETS: std::ops::Range<usize> = 4..13;

/// CYCLE800 with offsets 0: the table turns the part until the working plane of the active frames lies across the tool,
/// and the coordinate systems turn with it (B:7696-7786, B:7773-7782). The machine axes stay where they are. Data set,
/// mode and direction choose between ways that end in the same plane.
pub fn swivel(run: &mut Interpreter, call: &Call) -> Result<(), Halt> {
    contour::finish(run)?;
    if given_up(call) {
        run.sim.control.part_frame = Frame::default();
        return Ok(());
    }
    let (turns, table) = planned(run, call)?;
    for (axis, to) in turns.into_iter().enumerate() {
        if run.sim.control.rotary[axis] != to {
            run.sim.turn_table(axis, to).map_err(Halt::at(call.span))?;
        }
    }
    run.sim.control.part_frame = table;
    Ok(())
}

/// Whether the call gives the plane up: without values, or with the data set "0". The table stays where it is.
fn given_up(call: &Call) -> bool {
    call.args.iter().all(Option::is_none) || call.arg(DATA_SET) == Some(&Datum::Text(NO_DATA_SET.into()))
}

/// Where the rotary axes go, and the frame that turns with the table.
fn planned(run: &mut Interpreter, call: &Call) -> Result<([Degrees; 3], Frame), Problem> {
    let shifted = OFFSETS.into_iter().any(|place| !matches!(call.arg(place), None | Some(Datum::Number(0.0))));
    if shifted || call.args.len() < 4 {
        return Err(Problem::new("run-swivel", call.span, SWIVEL));
    }
    let control = &mut run.sim.control;
    control.part_frame = Frame::default();
    let total = control.total_frame().ok_or_else(|| Problem::new("run-shear", call.span, SWIVEL))?;
    let turn = rotation(total.rotation).inverse();
    let centre = V3::from(control.rotary_centre);
    let table = Frame { coarse: (centre - turn * centre).into(), rotation: angles(&turn), ..Frame::default() };
    Ok((total.rotation.map(Degrees), table))
}
