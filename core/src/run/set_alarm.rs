//! `SETAL(65000,"text")`: an alarm of the program.

use super::datum::Datum;
use super::interpret::Interpreter;
use super::statement::Call;
use crate::catalogue::alarms;
use crate::diagnostic::Code;
use crate::machine::Stop;
use crate::machine::trace::Step;
use crate::message::Message;
use crate::problem::Problem;
use crate::program::of_control::SET_ALARM;

/// Numbers that a program may raise: those of cycles, and of users from 65000.
const NUMBERS: std::ops::RangeInclusive<u32> = 60_000..=69_999;

/// Raises the alarm. From 62000 and from 67000 it is shown only, else it stops the program (Job planning, alarms in the
/// cycle area).
pub fn call(run: &mut Interpreter, call: &Call) -> Result<(), Stop> {
    let (number, text) = match &call.args[..] {
        [Some(Datum::Number(number))] => (*number, ""),
        [Some(Datum::Number(number)), Some(Datum::Text(text))] => (*number, text.as_str()),
        _ => return Err(run.fail(Problem::new("run-function", call.span, SET_ALARM))),
    };
    let whole = number as u32;
    if number.fract() != 0.0 || !NUMBERS.contains(&whole) {
        let shown = Datum::Number(number).shown();
        return Err(run.fail(Problem::new("run-alarm-number", call.span, shown)));
    }
    let code = Code::Alarm(whole);
    if alarms::find(&whole.to_string()).is_some() {
        run.sim.note(Step::Alarm(code));
    } else {
        let message = format!("{whole} {text}");
        run.sim.note(Step::Message { text: message.trim_end().to_owned() });
    }
    if matches!(whole / 1000, 62 | 67..=69) {
        return Ok(());
    }
    let message = Message::new("run-set-alarm").number("number", f64::from(whole)).text("text", text);
    Err(run.fail(Problem { span: call.span, message }))
}
