//! What a run tells about the log of measurements where it goes another way than its programmer may expect.

use super::Interpreter;
use crate::catalogue::log;
use crate::diagnostic::{Severity, Span};
use crate::entry::{Inputs, ProbeUse};
use crate::machine::Step;
use crate::message::Message;
use crate::problem::Problem;

/// What a call may decide about the log, with the problem of the program that it is, each told once a call.
const TOLD: [(&str, &str); 2] = [(log::LOG_DELETED, "run-log-deleted"), (log::LOG_FULL, FULL)];

const FULL: &str = "run-log-full";

/// Number of the job that prints the values of the last measurement (B:11239, B:11250).
const VALUES: i64 = 2;

/// Keeps where the log was switched on and what it shows, and tells what the call at this place decided about it.
/// `from`: its first entry of the trace; `logged`: whether the log was on before it.
pub fn called(run: &mut Interpreter, inputs: &Inputs, span: Span, from: usize, logged: bool) {
    let (place, cycle) = (run.placed(span), inputs.cycle);
    let prints = cycle.purpose.probe == ProbeUse::Log && inputs.variant == VALUES;
    if let Some(last) = run.called.last_mut().filter(|_| prints || (logged && cycle.is_measuring_cycle())) {
        last.log = Some(log::layout(&run.sim.control));
    }
    let logs = run.sim.control.bit(log::ON);
    if !logged && logs {
        run.log_on = Some(place);
    }
    if !logged && !logs && cycle.is_measuring_cycle() {
        return;
    }
    let decided = |step: Step| if let Step::Decision { message } = step { Some(message) } else { None };
    let decided: Vec<Message> = run.sim.trace.entries.behind(from).filter_map(|one| decided(one.step)).collect();
    for message in decided {
        let Some((_, key)) = TOLD.into_iter().find(|(known, _)| *known == message.key) else { continue };
        let message = Message { args: message.args, ..Message::new(key) };
        if key == FULL && run.diagnostics.iter().any(|known| known.message == message) {
            continue; // it stays full: told at the first call that it took nothing from
        }
        run.keep(Problem { span: place, message }.diagnostic(Severity::Warning));
    }
}

/// Tells that the log is still on at the end, where the program switched it on: what measures later writes into it, and
/// its file cannot be read out (B:11209, B:11233).
pub fn stays_on(run: &mut Interpreter) {
    let control = &run.sim.control;
    let Some(called) = run.log_on.filter(|_| control.bit(log::ON)) else { return };
    let file = control.text(log::FILE.as_str()).to_owned();
    run.keep(Problem::new("run-log-on", called, file).diagnostic(Severity::Warning));
}
