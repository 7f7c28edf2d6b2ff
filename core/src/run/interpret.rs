//! Runs a program block by block. A program that never ends is stopped by limits.

use super::flow::{self, Link, Links};
use super::machine::Sim;
use super::problem::{self, Problem};
use super::statement;
use super::trace::Step;
use super::{Outcome, Setup, Stop};
use crate::catalogue::Dialect;
use crate::control::Value;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::message::Message;
use crate::program::tree::{Program, WordKind};
use std::collections::{BTreeMap, BTreeSet};

/// When a run is given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Work: blocks carried out; a long block and a block that writes many elements count as several.
    pub steps: usize,
    /// Levels of subprograms (a SINUMERIK has 12 with the main program).
    pub depth: usize,
    /// Entries of the trace.
    pub trace: usize,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits {
            steps: 100_000,
            depth: 11,
            trace: super::machine::TRACE_LIMIT,
        }
    }
}

/// What stays until it is programmed anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modal {
    /// G0, G1, G2, G3.
    pub motion: u8,
    /// G90 or G91.
    pub absolute: bool,
    /// F as programmed, in the unit of that moment.
    pub feed: f64,
    /// mm in a unit of F.
    pub feed_factor: f64,
    /// T that is waiting for M6.
    pub prepared: Option<i64>,
    /// D programmed after T and before M6.
    pub waiting_edge: Option<i64>,
    /// Whether G41 or G42 is active.
    pub compensation: bool,
}

/// A program on its way.
pub struct Interpreter<'a> {
    /// The program.
    pub program: &'a Program,
    /// The machine.
    pub sim: Sim,
    /// What stays.
    pub modal: Modal,
    /// Local variables (`DEF`), elements of arrays one by one.
    pub locals: BTreeMap<String, Value>,
    /// Local arrays with their sizes.
    pub arrays: BTreeMap<String, Vec<usize>>,
    /// What `MEAS` left: `$AC_MEA[1]`, `$AA_MW[X]`, `$AA_MM[X]`.
    pub measured: BTreeMap<String, f64>,
    /// Findings so far, each place and kind once.
    pub diagnostics: Vec<Diagnostic>,
    /// Jump targets.
    pub targets: BTreeMap<String, Vec<usize>>,
    /// Control structures.
    pub links: Links,
    /// Programs in the same text.
    pub subprograms: BTreeMap<String, usize>,
    /// Where subprograms return to.
    pub returns: Vec<usize>,
    /// Levels allowed.
    pub depth: usize,
    /// Work so far, in blocks; see [`Limits::steps`].
    pub work: usize,
    seen: BTreeSet<(u32, String)>,
}

/// Characters of a block that count as one block's work.
const BLOCK: u32 = 100;

/// Where a run goes on after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// With the next block.
    Block,
    /// With this block.
    Jump(usize),
    /// Nowhere.
    End,
}

/// Runs a program from its first block.
pub fn run(program: &Program, setup: &Setup, limits: Limits) -> Outcome {
    let mut outcome = Outcome::new(setup);
    let mut run = Interpreter::new(program, setup, limits);
    outcome.stop = go(&mut run, limits.steps).err();
    outcome.control = run.sim.control;
    outcome.position = run.sim.position;
    outcome.trace = run.sim.trace;
    outcome.diagnostics = run.diagnostics;
    outcome
}

fn go(run: &mut Interpreter, limit: usize) -> Result<(), Stop> {
    let mut at = 0;
    let mut started = false;
    while run.work < limit {
        let Some(block) = run.program.blocks.get(at) else {
            return Ok(());
        };
        run.sim.line = Some(at as u32);
        run.work += 1 + ((block.span.end - block.span.start) / BLOCK) as usize;
        let header = run
            .program
            .words_of(block)
            .iter()
            .any(|word| matches!(word.kind, WordKind::Header(_)));
        if header && started {
            match run.returns.pop() {
                Some(back) => at = back,
                None => return Ok(()),
            }
            continue;
        }
        started |= !header && !block.words.is_empty();
        match statement::block(run, at)? {
            Next::Block => at += 1,
            Next::Jump(to) => at = to,
            Next::End => return Ok(()),
        }
        run.recordable(block.span)?;
    }
    let message = Message::new("run-steps").number("limit", limit as f64);
    let span = run
        .program
        .blocks
        .get(at)
        .map_or(Span::default(), |block| block.span);
    Err(run.fail(Problem { span, message }))
}

impl<'a> Interpreter<'a> {
    fn new(program: &'a Program, setup: &Setup, limits: Limits) -> Interpreter<'a> {
        let mut sim = Sim::new(setup);
        sim.trace_limit = limits.trace;
        let feed_factor = sim.control.data_factor();
        let nct = program.dialect == Dialect::Nct;
        Interpreter {
            program,
            sim,
            modal: Modal {
                motion: if nct { 0 } else { 1 }, // the NCT programs move without F at first, C:1164
                absolute: true,
                feed: 0.0,
                feed_factor,
                prepared: None,
                waiting_edge: None,
                compensation: false,
            },
            locals: BTreeMap::new(),
            arrays: BTreeMap::new(),
            measured: BTreeMap::new(),
            diagnostics: Vec::new(),
            targets: flow::targets(program),
            links: flow::links(program),
            subprograms: flow::subprograms(program),
            returns: Vec::new(),
            depth: limits.depth,
            work: 0,
            seen: BTreeSet::new(),
        }
    }

    /// A finding that does not stop the run; the same one is told once.
    pub fn tell(&mut self, severity: Severity, problem: &Problem) {
        if self
            .seen
            .insert((problem.span.start, problem.message.key.to_string()))
        {
            self.diagnostics.push(problem.diagnostic(severity));
        }
    }

    /// A finding that stops the run.
    pub fn fail(&mut self, problem: Problem) -> Stop {
        self.tell(Severity::Error, &problem);
        Stop::Fault(problem.message)
    }

    /// Whether the trace takes more; a program that only computes never asks the machine.
    fn recordable(&mut self, span: Span) -> Result<(), Stop> {
        self.sim.room().map_err(|stop| self.stopped(stop, span))
    }

    /// A stop of the machine, with a finding at the place that caused it.
    pub fn stopped(&mut self, stop: Stop, span: Span) -> Stop {
        let (message, code) = match &stop {
            Stop::Fault(message) => (message.clone(), problem::code(&message.key)),
            Stop::Alarm(code) => (Message::new("run-alarm"), *code),
        };
        let key = message.key.to_string();
        let diagnostic = Diagnostic {
            code,
            ..Problem { span, message }.diagnostic(Severity::Error)
        };
        if self.seen.insert((span.start, key)) {
            self.diagnostics.push(diagnostic);
        }
        stop
    }

    /// Records that a datum was written.
    pub fn note_set(&mut self, name: &str, before: f64, after: f64) {
        self.sim.note(Step::Set {
            name: name.to_owned(),
            before,
            after,
        });
    }

    /// Stored and active frames by name.
    pub fn frame_values(&self) -> Vec<(String, f64)> {
        let names = self
            .sim
            .control
            .variable_names()
            .into_iter()
            .filter(|name| name.starts_with("$P_"));
        names
            .filter_map(|name| self.sim.control.variable(&name).map(|value| (name, value)))
            .collect()
    }

    /// What is linked to a block.
    pub fn link(&self, block: usize) -> Option<Link> {
        self.links.get(&block).copied()
    }
}
