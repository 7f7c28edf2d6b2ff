//! A series as the page asks for it.

use super::offered::{SeriesFollow, SeriesPreset, offered};
use super::{SeriesView, WORK, example, series};
use crate::app::beside::{Beside, Whole};
use crate::app::start::{Machine, start};
use crate::app::{Error, ProgramText};
use crate::dialect::Dialect;
use crate::machine::Setup;
use crate::machine::series::Series;
use crate::message::Message;
use crate::refused::Path;
use crate::run::{self, Limits, Outcome, Session};
use crate::series::draw::{self, Variable};
use crate::syntax::programs::programs;
use crate::syntax::{self, Program};
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use std::sync::Arc;

/// A program to be run many times.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Which program of the text is run, by its name; absent: the first.
    pub program: Option<String>,
    /// Files beside the program; absent: none.
    pub with: Option<Vec<Beside>>,
    /// How often, and what varies; absent: what the machine says.
    pub series: Option<Series>,
    /// Whether the machine is that of the example; absent: no.
    pub example: Option<bool>,
}

/// What a series begins with.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SeriesStart {
    /// That of the machine.
    pub series: Series,
    /// What can vary of its parts and probe.
    pub names: Vec<SeriesName>,
    /// Corrections of the program that reach the next part.
    pub follows: Vec<SeriesFollow>,
    /// Variations that are complete: wear of a tool, a part that gets warm.
    pub presets: Vec<SeriesPreset>,
    /// How to choose the limits of a correction, a paragraph each.
    pub help: Vec<Message>,
    /// The example of the manual.
    pub example: SeriesExample,
}

/// Something that can vary.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesName {
    /// Its name in the setup file.
    pub name: String,
    /// In words.
    pub label: Message,
    /// Which part of those on the machine, from 1; absent: it is of the probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<usize>,
}

/// A program with its series, on a machine of its own.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SeriesExample {
    /// Control.
    pub control: Dialect,
    /// The program.
    pub text: String,
    /// Its series.
    pub series: Series,
}

/// Choice of `_TZL`, `_TMV` and `_K` (B:1239-1263, B:1344-1390, B:2201).
const HELP: [&str; 4] = ["series-choose-order", "series-choose-tzl", "series-choose-tmv", "series-choose-k"];

/// The setup of a question, with its series.
fn machine(asked: &mut SeriesRequest) -> Result<Setup, Error> {
    let mut setup = match asked.example {
        Some(true) => Setup { series: example::series(), ..example::machine() },
        _ => start(asked.control, asked.setup.take())?.setup,
    };
    if let Some(series) = asked.series.take() {
        setup.series = series;
    }
    Ok(setup)
}

/// What the fields of a series hold at first.
///
/// # Errors
/// The machine cannot be.
pub fn series_start(mut asked: SeriesRequest) -> Result<SeriesStart, Error> {
    let setup = machine(&mut asked)?;
    let (control, text) = (Dialect::Sinumerik, example::PROGRAM.to_owned());
    let example = SeriesExample { control, text, series: example::series() };
    let help = HELP.map(Message::new).into();
    let named = |Variable { name, label, solid }| {
        let part = solid.map(|solid| solid + 1);
        SeriesName { name, label: Message::new(label), part }
    };
    let names = draw::variables(&setup).into_iter().map(named).collect();
    let prepared = read(setup, asked);
    let (follows, presets) = offered(&prepared);
    Ok(SeriesStart { names, series: prepared.setup.series, follows, presets, help, example })
}

/// A program that is ready to be run many times.
pub struct Prepared {
    /// The machine, with its series.
    pub setup: Setup,
    /// The program, read.
    pub program: Rc<Program>,
    /// Which program of the text is run, by its name; absent: the first.
    pub main: Option<String>,
}

impl Prepared {
    /// Refuses a main program that the text does not have, before the first run.
    ///
    /// # Errors
    /// Which programs it has.
    pub fn begins(&self) -> Result<(), Error> {
        let Some(name) = &self.main else { return Ok(()) };
        let found = run::main_program(&programs(&self.program), name).map(|_| ());
        found.map_err(|problem| {
            let refused = Error::new("run-program-unknown", Path::of(&["program"]));
            Error { message: problem.message, ..refused }
        })
    }

    /// Carries it out once, on this machine.
    pub(in crate::app) fn run(&self, machine: &Setup) -> Outcome {
        let limits = Limits { steps: Some(WORK), ..Limits::default() }.unrecorded();
        let session = Session::new(Rc::clone(&self.program), machine, limits);
        match &self.main {
            Some(name) => session.of_program(name).complete(),
            None => session.complete(),
        }
    }
}

/// Reads what is to be run.
///
/// # Errors
/// The machine cannot be, a number of the series is beyond its range, it names nothing of the machine, or the text has
/// no program of this name.
pub(in crate::app) fn prepared(mut asked: SeriesRequest) -> Result<Prepared, Error> {
    let setup = machine(&mut asked)?;
    setup.varies()?;
    draw::known(&setup)?;
    let prepared = read(setup, asked);
    prepared.begins()?;
    Ok(prepared)
}

/// A program that was read, on its machine.
fn read(setup: Setup, asked: SeriesRequest) -> Prepared {
    let whole = Whole::new(asked.control, asked.text, asked.with);
    let macros = Arc::clone(&setup.control.definitions.macros);
    let program = syntax::read_held(whole.dialect(), whole.text(), &macros, &mut |_| {});
    Prepared { setup, program: program.into(), main: asked.program }
}

/// Runs a program many times. `told`: hears which share is done.
///
/// # Errors
/// The machine cannot be, a number of the series is beyond its range, or it names nothing of the machine.
pub fn series_of(asked: SeriesRequest, told: &mut dyn FnMut(f64)) -> Result<SeriesView, Error> {
    Ok(series(&prepared(asked)?, told))
}
