//! Why a run ends early: told once, when the block that caused it is left.

use crate::catalogue::alarms;
use crate::control::Control;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::machine::Stop;
use crate::message::Message;
use crate::problem::Problem;

/// Key of what is said of an alarm that ends the run.
pub const ALARM: &str = "run-alarm";

/// Something wrong in the program, or a stop of the machine, with the place that caused it.
#[derive(Clone, Debug, PartialEq)]
pub struct Halt {
    pub stop: Stop,
    pub span: Span,
}

impl Halt {
    /// Gives a stop of the machine its place in the program.
    pub fn at(span: Span) -> impl FnOnce(Stop) -> Halt {
        move |stop| Halt { stop, span }
    }

    /// As a finding, with the remedy that this control has.
    pub fn diagnostic(&self, control: &Control) -> Diagnostic {
        match &self.stop {
            Stop::Fault(message) => Problem { span: self.span, message: message.clone() }.diagnostic(Severity::Error),
            Stop::Alarm(code) => {
                let hint = Some(Message::new(alarms::cure(*code, control)));
                Diagnostic { code: *code, hint, ..Problem::at(ALARM, self.span).diagnostic(Severity::Error) }
            }
        }
    }
}

impl From<Problem> for Halt {
    fn from(Problem { span, message }: Problem) -> Halt {
        Halt { stop: Stop::Fault(message), span }
    }
}
