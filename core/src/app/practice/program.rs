//! What a mask means as a program, and a call of a program as its mask.

use super::super::{Error, choose_units, cycle, start};
use super::{Machine, Piece, PracticeChoice, PracticeRefusal, PracticeRequest, Stands, begun, legible, practice};
use crate::app::jog::{JogWrong, act};
use crate::control::{AXES, Control, Plane, UnitFunction};
use crate::dialect::Dialect;
use crate::entry::{Style, Typed};
use crate::geometry::Wcs;
use crate::jog::chance;
use crate::jog::counterpart::{Call, call, masked};
use crate::jog::mask::key;
use crate::jog::masks;
use crate::jog::script::{Line, behind, read};
use crate::jog::{Session, help, measures};
use crate::machine::Setup;
use crate::message::Message;
use crate::program::write::snippet;
use serde::{Deserialize, Serialize};

/// What the mask that is open means as a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeProgram {
    /// Text: plane and zero offset, where the probe stands, the call; empty: there is none.
    pub text: String,
    /// Cycle that is called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<&'static str>,
    /// Its values, as typed.
    pub values: Typed,
    /// What is different; why there is none.
    pub told: Vec<Message>,
    /// The line with which the session ended before its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<PracticeRefusal>,
}

/// A call that is to be practised.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeCallRequest {
    /// Control.
    pub control: Dialect,
    /// Cycle.
    pub cycle: String,
    /// Values as typed, by parameter.
    pub values: Typed,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// G function of units active at the call, where it is not that of the machine.
    pub units: Option<UnitFunction>,
    /// Working plane at the call, where it is not that of the machine.
    pub plane: Option<Plane>,
}

/// A call as its mask.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeCall {
    /// The mask.
    pub mask: PracticeChoice,
    /// What opens it and fills it in, a line a thing.
    pub lines: Vec<String>,
    /// What of the call has no place in it.
    pub told: Vec<Message>,
}

/// What the mask means as a program that is open once a session is carried out.
///
/// # Errors
/// A control that does not measure in JOG, or a machine that cannot be.
pub fn as_program(asked: PracticeRequest) -> Result<PracticeProgram, Error> {
    let (lines, _) = legible(&asked.script);
    let (Stands { mut setup, .. }, truth) = begun(asked)?;
    truth.put(&mut setup);
    let (session, _) = carried_out(&setup, &lines);
    Ok(meant(&session))
}

/// What the mask means as a program that is open once a script is carried out on a machine; with a seed the part lies
/// as chance puts it.
///
/// # Errors
/// A line that cannot be read, or a machine that does not measure in JOG.
pub fn jog_program(script: &str, setup: &Setup, seed: Option<u64>) -> Result<PracticeProgram, JogWrong> {
    let lines = read(script).map_err(JogWrong::Line)?;
    if !measures(setup.control.dialect) {
        return Err(JogWrong::Machine(Message::new("jog-no-jog")));
    }
    let mut setup = setup.clone();
    if let Some(seed) = seed {
        chance::put(&mut setup, seed);
    }
    let (session, refused) = carried_out(&setup, &lines);
    let refusal = |(line, message): (u32, Message)| PracticeRefusal {
        left: behind(script, line),
        hint: help::cure_of(&message, session.mask()),
        line,
        message,
    };
    Ok(PracticeProgram { refused: refused.map(refusal), ..meant(&session) })
}

/// A session as far as its lines do something, and the line that does nothing.
fn carried_out(setup: &Setup, lines: &[Line]) -> (Session, Option<(u32, Message)>) {
    let mut session = Session::new(setup);
    for line in lines {
        if let Err(message) = act(&mut session, &line.command) {
            return (session, Some((line.number, message)));
        }
    }
    (session, None)
}

fn meant(session: &Session) -> PracticeProgram {
    match call(session) {
        Ok(call) => PracticeProgram {
            text: call_text(&call),
            cycle: Some(call.cycle.name),
            values: call.values,
            told: call.differs,
            refused: None,
        },
        Err(why) => {
            let told = vec![why];
            PracticeProgram { text: String::new(), cycle: None, values: Typed::new(), told, refused: None }
        }
    }
}

/// A call as the program has it: plane and zero offset, the way to the start, the values.
pub fn call_text(call: &Call) -> String {
    let Call { cycle, values, control, start, .. } = call;
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let plane = control.plane.code();
    let zero = control.make().settable_name(control.settable);
    let [across, along] =
        [[Some(abscissa), Some(ordinate)], [Some(applicate), None]].map(|axes| words(control, *start, axes));
    let written = snippet(cycle, values, control, Style::Direct, None).text;
    format!("G{plane} {zero}\nG0 {across}\n{along}\n{written}")
}

/// `X10 Y-5`, in the active unit.
fn words(control: &Control, at: Wcs, axes: [Option<usize>; 2]) -> String {
    let word = |axis: usize| {
        let value = at[axis] / control.active_factor();
        format!("{}{}", AXES[axis], (value * 1e9).round() / 1e9 + 0.0)
    };
    axes.into_iter().flatten().map(word).collect::<Vec<_>>().join(" ")
}

/// The mask that measures what a call measures; none: there is none.
///
/// # Errors
/// An unknown cycle, units that the control does not have, or a machine that cannot be.
pub fn as_mask(asked: PracticeCallRequest) -> Result<Option<PracticeCall>, Error> {
    let cycle = cycle(asked.control, &asked.cycle)?;
    if !measures(asked.control) {
        return Ok(None);
    }
    let mut control = start::start(asked.control, asked.setup)?.setup.control;
    if let Some(function) = asked.units {
        choose_units(&mut control, function)?;
    }
    control.plane = asked.plane.unwrap_or(control.plane);
    let found = masked(cycle, &asked.values, &control);
    Ok(found.and_then(|found| {
        let piece: Piece = practice::piece(masks::find(found.mask)?);
        let mask = PracticeChoice { name: found.mask, label: Message::new(key("mask", found.mask)), piece };
        Some(PracticeCall { mask, lines: found.lines, told: found.told })
    }))
}
