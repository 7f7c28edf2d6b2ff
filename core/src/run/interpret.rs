//! Runs a program block by block.

use super::{
    Halt, Level, Limits, Locals, Modal, Outcome, assumed::Made, called::Called, contour, contour::Contour, defined,
    endless, endless::Watch, halt::ALARM, limits, logged, mode, motion, noted, noted::Noted, of_machine,
    of_machine::Asked, outcome::PassedOver, own_parameters, pieces, pieces::Pieces, repeat, rules::Rules,
    standard::Pattern, statement, subprogram, synchronous, synchronous::Actions, unread, unread::Unread,
};
use crate::catalogue::Functions;
use crate::control::Value;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::foreign::{self, Foreign};
use crate::geometry::{Mcs, Wcs};
use crate::machine::{Entries, Files, Setup, Sim, Step, Stop};
use crate::message::Message;
use crate::problem::Problem;
use crate::syntax::links::{Link, Links};
use crate::syntax::programs::{Programs, Unit};
use crate::syntax::targets::Targets;
use crate::syntax::{Program, links as flow, programs};
use std::cell::{Cell, OnceCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A program on its way.
pub struct Interpreter {
    pub program: Rc<Program>,
    /// Where in the text it is, and what comes behind it.
    pub pieces: Pieces,
    pub sim: Sim,
    /// What stays.
    pub modal: Modal,
    /// Program levels, the main program first.
    pub levels: Vec<Level>,
    /// Variables that all programs of the text see.
    pub shared: Locals,
    /// What `MEAS` left: `$AC_MEA[1]`, `$AA_MW[X]`, `$AA_MM[X]`.
    pub measured: BTreeMap<String, f64>,
    /// Where the spindle nose stood at the end of the last motion of the program, and the position of that moment.
    pub programmed: (Mcs, Wcs),
    /// The direction in which that motion ended, in the WCS; none: there was none, or it is not known.
    pub tangent: Option<[f64; 3]>,
    /// By which functions the machine calls the macros of NCT.
    pub functions: Functions,
    /// What the tool follows with radius compensation.
    pub contour: Option<Contour>,
    /// Findings so far, each place and kind once.
    pub diagnostics: Vec<Diagnostic>,
    targets: OnceCell<Targets>,
    pub links: Links,
    pub programs: Programs,
    /// Place among them of the one that is run as main program.
    main: usize,
    /// When the run is given up.
    pub limits: Limits,
    /// Skip levels that are switched on.
    pub skip: BTreeSet<u8>,
    /// Work so far, in blocks; see [`Limits::steps`].
    pub work: u64,
    /// Blocks that were carried out.
    pub blocks: usize,
    /// A block search did not come to its block yet.
    pub searching: bool,
    /// Whether it was told that not all is recorded.
    pub unrecorded: bool,
    /// Elements of the variables that all programs see.
    pub shared_elements: usize,
    /// The block that comes next.
    pub at: usize,
    /// Work at which the clocks of the control (`#3001` and `#3002` of NCT) stood at 0.
    pub clocks: [f64; 2],
    /// Whether one of them was read: then the program may end when it is late enough.
    pub clock_asked: Cell<bool>,
    /// What shows that the program never ends.
    pub endless: Watch,
    /// Blocks whose motions took long, by the block of the call of their program and their own.
    pub heavy: BTreeSet<(usize, usize)>,
    /// How often the measuring calls were carried out, by the blocks of the call of their program and of their own.
    pub calls: BTreeMap<(usize, usize), usize>,
    /// What words that could not be read would have written.
    pub unread: Unread,
    /// What reading found in the blocks.
    pub errors: unread::Errors,
    /// What is made for a program that came without a machine.
    pub(super) assumed: Option<Made>,
    seen: BTreeSet<(u32, String)>,
    /// What the run went on without, in its order.
    pub passed: Vec<PassedOver>,
    /// The measuring calls so far.
    pub called: Vec<Called>,
    /// What is told as a list at the end: functions of the machine and the like.
    pub noted: Noted,
    /// Positions at which a modal program is still to be called.
    pub pattern: Pattern,
    /// Values of the machine that were assumed, and the arrays of which that was told.
    pub asked: Asked,
    /// The call that switched the log on last, its place in the text.
    pub log_on: Option<Span>,
    pub arrays_asked: BTreeSet<String>,
    /// Synchronised actions that did not act yet.
    pub actions: Actions,
}

/// Words passed over that are kept.
const MOST_PASSED: usize = 1000;

/// Place of the main program of this name among those of a text.
///
/// # Errors
/// It is not there; which are.
pub fn main_program(programs: &Programs, name: &str) -> Result<usize, Problem> {
    programs.place(&name.to_uppercase()).ok_or_else(|| {
        let there: Vec<&str> = programs.names.keys().map(String::as_str).take(NAMED).collect();
        let problem = Problem::new("run-program-unknown", Span::default(), name);
        problem.number("count", there.len() as f64).text("names", there.join(", "))
    })
}

/// Programs that are named where the one that is wanted is not there.
const NAMED: usize = 20;

/// Characters of a block that count as one block's work.
const BLOCK: u32 = 100;

/// How much of what is looked at takes as long as a block; see [`Route::search`](crate::machine::route::Route::search).
const EFFORT: usize = 20;

/// Work between two tellings of how far a run is.
const BETWEEN: u64 = 10_000;

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

/// Runs a program from its first block to its end.
pub fn run(program: &Program, setup: &Setup, limits: Limits) -> Outcome {
    Session::new(Rc::new(program.clone()), setup, limits).complete()
}

/// A run that can be halted between two blocks and goes on later.
pub struct Session {
    pub(super) run: Interpreter,
    before: Setup,
    /// How much of the main program lies behind it, 0 to 1; loops and jumps back do not make it less.
    pub share: f64,
    ended: Option<Result<(), Halt>>,
}

impl Session {
    /// A run before its first block; of a program of a control that is not run here it is over.
    pub fn new(program: impl Into<Rc<Program>>, setup: &Setup, limits: Limits) -> Session {
        let run = Interpreter::new(program.into(), setup, limits);
        let mut session = Session { run, before: setup.clone(), share: 0.0, ended: None };
        if let Some(control) = foreign::control_of(&session.run.program.source) {
            session.refuse_foreign(control);
        } else if let Some(control) = foreign::log_of(&session.run.program.source) {
            session.run.sim.line = Some(0);
            let first = foreign::first_line(&session.run.program.source);
            session.refuse(Problem::at("run-foreign-log", first).text("control", control.name));
        }
        session
    }

    fn refuse_foreign(&mut self, control: &Foreign) {
        let source = &self.run.program.source;
        let count = (control.calls)(source).len();
        let problem = Problem::at("run-foreign", foreign::first_line(source));
        self.run.sim.line = Some(0);
        self.refuse(problem.text("control", control.name).number("count", count as f64));
    }

    /// Whether it is over.
    pub fn is_over(&self) -> bool {
        self.ended.is_some()
    }

    /// With the program of this name as main program, where the text holds several.
    pub fn of_program(mut self, name: &str) -> Session {
        match main_program(&self.run.programs, name) {
            _ if self.is_over() => {}
            Ok(place) => begin_main(&mut self.run, place),
            Err(problem) => self.refuse(problem),
        }
        self
    }

    /// With the main program in the file of this name, where its text does not tell it.
    pub fn of_file(mut self, file: &str) -> Session {
        self.run.sim.files.name_main(file);
        self
    }

    /// Ends the run before its first block.
    fn refuse(&mut self, problem: Problem) {
        let halt = Halt::from(problem);
        let found = halt.diagnostic(&self.run.sim.control);
        _ = self.run.tell_once(found);
        self.ended = Some(Err(halt));
    }

    /// With values for parameters of the program itself, by their names in upper case.
    pub fn with_arguments(mut self, arguments: BTreeMap<String, Value>) -> Session {
        if self.ended.is_none()
            && let Err(problem) = own_parameters::bind(&mut self.run, arguments)
        {
            self.refuse(problem);
        }
        self
    }

    /// With a program that is the beginning of a text; what comes behind it is given when it is needed.
    pub fn in_pieces(mut self, share: [f64; 2], more: pieces::More) -> Session {
        (self.run.pieces.share, self.run.pieces.more) = (share, Some(more));
        self
    }

    /// What happened so far.
    pub fn entries(&self) -> &Entries {
        &self.run.sim.trace.entries
    }

    /// Carries out all that is left.
    pub fn complete(self) -> Outcome {
        self.complete_told(&mut |_| {})
    }

    /// Carries out all that is left, telling from time to time how far it is.
    pub fn complete_told(mut self, told: &mut dyn FnMut(&Session)) -> Outcome {
        self.go_on(told);
        self.outcome()
    }

    /// Carries out all that is left, and stands there.
    pub(super) fn go_on(&mut self, told: &mut dyn FnMut(&Session)) {
        while !self.advance(BETWEEN) {
            told(self);
        }
    }

    /// Blocks that were carried out so far.
    pub fn blocks(&self) -> usize {
        self.run.blocks
    }

    /// Carries out about this much work; true: the run is over.
    pub fn advance(&mut self, work: u64) -> bool {
        let until = self.run.work.saturating_add(work);
        while self.ended.is_none() && self.run.work < until {
            self.ended = one_block(&mut self.run).transpose();
        }
        self.share = self.share.max(self.run.reached());
        self.ended.is_some()
    }

    /// What came out so far; a run that was halted says so.
    pub fn outcome(self) -> Outcome {
        let began = self.run.blocks > 0;
        let over = self.ended.is_some();
        let stop = match self.ended {
            Some(ended) => ended.err().map(|halt| halt.stop),
            None => Some(Stop::Fault(Message::new("run-cancelled"))),
        };
        let mut run = self.run;
        noted::tell(&mut run);
        of_machine::settle(&mut run);
        if stop.is_none() {
            logged::stays_on(&mut run);
        }
        if over && (began || stop.is_none()) {
            mode::ended(&mut run);
        }
        let machine_values = of_machine::all(&run);
        let Interpreter { sim, diagnostics, passed: passed_over, called, .. } = run;
        Outcome { diagnostics, passed_over, called, machine_values, ..Outcome::left_by(sim, &self.before, stop) }
    }
}

/// Carries out the block that comes next; some: that was the end. Then, and before a stop, what waits is driven.
pub fn one_block(run: &mut Interpreter) -> Result<Option<()>, Halt> {
    let went = told(run, next_block);
    if went == Ok(None) {
        return went;
    }
    let done = told(run, contour::finish);
    went.and_then(|end| done.map(|()| end))
}

/// Tells why a step of the run does not come to its end.
fn told<T>(run: &mut Interpreter, step: impl FnOnce(&mut Interpreter) -> Result<T, Halt>) -> Result<T, Halt> {
    step(run).inspect_err(|halt| {
        let found = halt.diagnostic(&run.sim.control);
        _ = run.tell_once(found);
    })
}

fn next_block(run: &mut Interpreter) -> Result<Option<()>, Halt> {
    let at = run.at;
    let own = run.levels.last().is_some_and(|level| level.blocks.contains(&at));
    if !own && pieces::next(run) {
        return Ok(None);
    }
    let span = run.program.blocks.get(at).map(|block| block.span);
    limits::room(run, span)?;
    let (Some(span), true) = (span, own) else { return Ok(go_on(run, subprogram::leave)) };
    run.sim.line = Some(run.pieces.lines + at as u32);
    mode::comes(run, span);
    run.work += 1 + u64::from((span.end - span.start) / BLOCK);
    run.blocks = run.blocks.wrapping_add(1);
    let depth = run.levels.len();
    let place = (run.levels.last().map_or(0, |level| level.call), at);
    let next = told(run, |run| statement::block(run, at));
    of_machine::tell(run);
    // Arcs close to the part take long, and so does any motion among many solids. In a loop they count as more blocks,
    // so that one without end is found soon; a long program drives each of them once.
    let effort = run.sim.effort() / EFFORT;
    if effort > 0 && !run.heavy.insert(place) {
        run.work += effort as u64;
    }
    if run.sim.stylus_touched() {
        run.tell(Severity::Warning, &Problem::new("run-stylus", span, ""));
    }
    limits::data(run, span)?;
    limits::tell(run, span);
    let next = next?;
    if let Next::Jump(to) = next {
        repeat::jumped(run, to);
    }
    run.sim.room().map_err(Halt::at(span))?; // a program that only computes never asks the machine
    let end = go_on(run, |_| next);
    if end.is_none() && run.at <= at && run.levels.len() == depth && endless::again(run) {
        if !of_machine::turn(run, span) && !synchronous::act(run) {
            return Err(Problem::at("run-endless", span).number("line", (run.at + 1) as f64).into());
        }
        endless::forget(run);
    }
    Ok(end)
}

/// Stands before the first block of a program of the text, which is the main program.
fn begin_main(run: &mut Interpreter, place: usize) {
    run.main = place;
    let main = run.main().cloned().unwrap_or_default();
    run.sim.files = Files::beside(main.file.as_deref());
    run.at = main.blocks.start;
    run.levels = vec![Level { blocks: main.blocks, ..Level::default() }];
    own_parameters::begin(run);
}

/// Takes the next block; some: there is none.
fn go_on(run: &mut Interpreter, next: impl FnOnce(&mut Interpreter) -> Next) -> Option<()> {
    match next(run) {
        Next::Block => run.at = repeat::after(run, run.at),
        Next::Jump(to) => run.at = to,
        Next::End => return Some(()),
    }
    None
}

impl Interpreter {
    fn new(program: Rc<Program>, setup: &Setup, limits: Limits) -> Interpreter {
        let mut sim = Sim::new(setup);
        (sim.trace_limit, sim.own_limit, sim.told_limit) = (limits.trace, limits.own, limits.told);
        sim.point_limit = crate::scan::POINTS;
        let (motion, feed_factor) = (Rules::of(program.dialect).motion, sim.control.data_factor());
        let programs = programs::programs(&program);
        let mut run = Interpreter {
            pieces: Pieces::default(),
            programmed: motion::standing(&sim),
            tangent: None,
            functions: Functions::of(&sim.control),
            sim,
            modal: Modal { motion, absolute: true, feed_factor, ..Modal::default() },
            at: 0,
            levels: Vec::new(),
            shared: Locals::new(),
            measured: BTreeMap::new(),
            contour: None,
            diagnostics: Vec::new(),
            targets: OnceCell::new(),
            links: flow::links(&program, &programs),
            programs,
            main: 0,
            limits,
            skip: setup.skip.clone(),
            work: 0,
            searching: limits.mode == mode::Mode::BlockSearch,
            blocks: 0,
            unrecorded: false,
            shared_elements: 0,
            clocks: [0.0; 2],
            clock_asked: Cell::new(false),
            endless: Watch::default(),
            heavy: BTreeSet::new(),
            calls: BTreeMap::new(),
            unread: Unread::new(),
            errors: unread::errors(&program),
            assumed: None,
            seen: BTreeSet::new(),
            passed: Vec::new(),
            called: Vec::new(),
            noted: Noted::new(),
            pattern: Pattern::default(),
            asked: Asked::default(),
            log_on: None,
            arrays_asked: BTreeSet::new(),
            actions: Actions::new(),
            program,
        };
        defined::add(&mut run);
        begin_main(&mut run, 0);
        run
    }

    /// The program that is run as main program.
    pub fn main(&self) -> Option<&Unit> {
        self.programs.units.get(self.main)
    }

    /// Part of the main program that lies before the block that comes next, or before the call that has not returned.
    fn reached(&self) -> f64 {
        let at = self.levels.get(1).map_or(self.at, |called| called.call);
        let main = self.levels.first().map_or(0..0, |main| main.blocks.clone());
        let here = (at.saturating_sub(main.start) as f64 / main.len().max(1) as f64).min(1.0);
        let [from, to] = self.pieces.share;
        from + (to - from) * here
    }

    /// A finding that does not stop the run, told once. What the run passes over is named at its end too.
    pub fn tell(&mut self, severity: Severity, problem: &Problem) {
        if self.tell_once(problem.diagnostic(severity))
            && let Some(word) = problem.passed_over()
        {
            self.pass_over(word.to_owned(), problem.span);
        }
    }

    /// Keeps a finding; false: it was told before.
    pub fn tell_once(&mut self, mut found: Diagnostic) -> bool {
        found.span = found.span.map(|span| self.placed(span));
        self.keep(found)
    }

    /// The alarm that ends the run at this place is told already, with what is wrong.
    pub fn known_alarm(&mut self, span: Span) {
        let place = self.placed(span);
        self.seen.insert((place.start, ALARM.to_owned()));
    }

    /// A place of the program at hand in the text that came.
    pub fn placed(&self, span: Span) -> Span {
        self.pieces.placed(self.program.placed(span))
    }

    /// Keeps a finding whose place is one of the text; false: it was told before.
    pub fn keep(&mut self, found: Diagnostic) -> bool {
        let new = self.seen.insert((found.span.unwrap_or_default().start, found.message.key.to_string()));
        self.diagnostics.extend(new.then_some(found));
        new
    }

    /// Something of the program that is not carried out, each once.
    pub fn pass_over(&mut self, word: String, place: Span) {
        let passed = PassedOver { word, line: self.pieces.lines + self.program.line_of(place.start) + 1 };
        if self.passed.len() < MOST_PASSED && !self.passed.contains(&passed) {
            self.passed.push(passed);
        }
    }

    /// Records that a datum was written.
    pub fn note_set(&mut self, name: &str, before: f64, after: f64) {
        self.sim.note(Step::Set { name: name.to_owned(), before, after });
    }

    /// The blocks that a jump may name; found when the first one does.
    pub fn targets(&self) -> &Targets {
        self.targets.get_or_init(|| Targets::of(&self.program))
    }

    /// What is linked to a block.
    pub fn link(&self, block: usize) -> Option<Link> {
        self.links.get(&block).copied()
    }
}
