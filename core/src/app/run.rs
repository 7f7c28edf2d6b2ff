//! A program carried out.

use super::answer::{Answer, answer};
use super::beside::{Beside, FileStart, Whole};
use super::changes::{Change, changes};
use super::finding::{Finding, placed};
use super::outcome::{Raised, alarms};
use super::record::{ProbeOfCall, Probes, RecordAbout};
use super::start::{Machine, start};
use super::supply::{Needs, curable, lacking};
use super::written::{WrittenFile, written};
use super::{Error, ProgramText};
use crate::control::Value;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::result_unit;
use crate::machine::setup::Setup;
use crate::machine::trace::Step;
use crate::machine::{Entry, Stop};
use crate::message::Message;
use crate::run::called::Called;
use crate::run::left::{CallAt, Left};
use crate::run::mode::Mode;
use crate::run::of_machine::MachineValue;
use crate::run::outcome::{Outcome, PassedOver};
use crate::run::{Limits, Session};
use crate::scene::{Scene, Source};
use crate::syntax;
use crate::syntax::position::Positions;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What is run.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RunRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Which program of the text is run, by its name; absent: the first.
    pub program: Option<String>,
    /// Values for the parameters of the program itself, by name; absent: none.
    pub arguments: Option<BTreeMap<String, Value>>,
    /// Whether what is not there stops the run: a subprogram, a value that only the machine has; absent: no.
    pub strict: Option<bool>,
    /// How it is carried out; absent: in AUTOMATIC.
    pub mode: Option<Mode>,
    /// Line, from 1, up to which a block search goes; absent: the whole program is searched through.
    pub target: Option<u32>,
    /// Work in blocks after which the run is given up; absent: never.
    pub blocks: Option<u32>,
    /// Files beside the program: its subprograms, definition files; absent: none.
    pub with: Option<Vec<Beside>>,
    /// Name of its file, `part.mpf`, which no log can have; absent: none, or the text tells it.
    pub file: Option<String>,
}

/// What a program did.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RunView {
    /// Everything that happened.
    pub trace: Source,
    /// What was found on the way.
    pub diagnostics: Vec<Finding>,
    /// The results of each call; behind them what the program wrote beside them.
    pub results: Vec<RunResult>,
    /// What each measuring call came to, in order.
    pub answers: Vec<RunAnswer>,
    /// What the cycles decided, in order.
    pub decisions: Vec<RunDecision>,
    /// What is different afterwards.
    pub changes: Vec<Change>,
    /// Where it waits for NC START: M0, a text of the operator that halts.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<RunWait>>"))]
    pub waits: Vec<RunWait>,
    /// The alarms in order.
    pub alarms: Vec<RunAlarm>,
    /// Lines of the print-out, and blocks that were sent.
    pub log: Vec<String>,
    /// Files that it left on the control: the log of measurements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<WrittenFile>>"))]
    pub written: Vec<WrittenFile>,
    /// Whether it reached its end.
    pub finished: bool,
    /// What it went on without.
    pub passed_over: Vec<PassedOver>,
    /// Values that only the machine has and that were assumed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<MachineValue>>"))]
    pub machine_values: Vec<MachineValue>,
    /// Where the files beside the program begin.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<FileStart>>"))]
    pub files: Vec<FileStart>,
    /// How it ended.
    pub ending: Message,
    /// Where the values come from, for the record.
    pub about: RecordAbout,
    /// Of a program that came without a machine: what was assumed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub assumed: Option<RunAssumed>,
}

/// What was assumed for a program that came without a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RunAssumed {
    /// In words.
    pub messages: Vec<Message>,
    /// The machine on which it ran.
    pub setup: Setup,
}

/// The call of a program to which something belongs; absent: none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct OfCall {
    /// Line of the call, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// Cycle that is called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<&'static str>,
}

/// How often each call came so far in a run: by this a call of one run is found in another that went another way.
#[derive(Debug, Default)]
pub(super) struct Occurrences(BTreeMap<OfCall, usize>);

impl Occurrences {
    /// A call that comes now, with how often it came before.
    pub fn next(&mut self, call: OfCall) -> (OfCall, usize) {
        let count = self.0.entry(call).or_default();
        *count += 1;
        (call, *count - 1)
    }
}

/// What belongs to the calls of a run, by the call and how often it came before.
pub(super) fn by_occurrence<T>(all: impl Iterator<Item = (OfCall, T)>) -> BTreeMap<(OfCall, usize), T> {
    let mut came = Occurrences::default();
    all.map(|(call, one)| (came.next(call), one)).collect()
}

/// A result of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RunResult {
    /// `_OVR[4]`.
    pub name: String,
    /// Value of the result.
    pub value: f64,
    /// Meaning of the result, where a call left it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<Message>,
    /// Unit of the result, where a call left it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<&'static str>,
    /// That call.
    #[serde(flatten)]
    pub call: OfCall,
}

/// A decision of a cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RunDecision {
    /// What was decided.
    pub message: Message,
    /// By which call.
    #[serde(flatten)]
    pub call: OfCall,
}

/// A halt of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RunWait {
    /// Index of the entry of the trace.
    pub at: usize,
    /// What the operator reads: the last text, `M0` where there is none.
    pub text: String,
}

/// What a measuring call of a run came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RunAnswer {
    /// What it came to.
    #[serde(flatten)]
    pub answer: Answer,
    /// Which call.
    #[serde(flatten)]
    pub call: OfCall,
    /// The probe that measured.
    pub probe: ProbeOfCall,
    /// Numbers or texts of the alarms and operator messages raised in it.
    pub alarms: Vec<String>,
    /// Amid the points that were touched, machine coordinates X Y Z, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub place: Option<[f64; 3]>,
    /// Index of its first entry of the trace.
    pub from: usize,
    /// Index of its last one.
    pub to: usize,
}

/// An alarm of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RunAlarm {
    /// The alarm.
    #[serde(flatten)]
    pub raised: Raised,
    /// By which call.
    #[serde(flatten)]
    pub call: OfCall,
}

impl OfCall {
    fn new(call: Option<CallAt>) -> OfCall {
        OfCall { line: call.map(|call| call.line + 1), cycle: call.map(|call| call.cycle) }
    }
}

/// A run before its first block. `main`: the program of the text; none: the first. `arguments`: values of its own
/// parameters, by name.
pub(super) fn session(
    whole: &Whole,
    setup: &Setup,
    limits: Limits,
    main: Option<&str>,
    arguments: BTreeMap<String, Value>,
) -> Session {
    let macros = &setup.control.definitions.macros;
    let program = syntax::read_held(whole.dialect(), whole.text(), macros, &mut |_| {});
    let session = Session::new(program, setup, limits);
    let session = match main {
        Some(name) => session.of_program(name),
        None => session,
    };
    session.with_arguments(arguments.into_iter().map(|(name, value)| (name.to_ascii_uppercase(), value)).collect())
}

/// A run in pieces, so that whoever waits for it can be told how far it is, halt it and leave it.
///
/// ```
/// use probewright_core::app::{Run, RunRequest};
/// use probewright_core::dialect::Dialect;
///
/// let text = "R1=20*2\nG0 X=R1\nM30\n".into();
/// let control = Dialect::Sinumerik;
/// let (program, arguments, strict, blocks) = (None, None, None, None);
/// let (setup, mode, target, with, file) = (None, None, None, None, None);
/// let asked = RunRequest { control, text, setup, program, arguments, strict, mode, target, blocks, with, file };
/// let mut run = Run::new(asked)?;
/// while !run.advance(100) {}
/// let view = run.view();
/// assert!(view.finished && view.alarms.is_empty());
/// assert_eq!(view.trace.outcome.control.number("R1"), 40.0);
/// # Ok::<(), probewright_core::app::Error>(())
/// ```
pub struct Run {
    session: Session,
    setup: Setup,
    whole: Whole,
}

impl Run {
    /// A run before its first block.
    ///
    /// # Errors
    /// The machine has no such G function of units.
    pub fn new(asked: RunRequest) -> Result<Run, Error> {
        let setup = start(asked.control, asked.setup)?.setup;
        let whole = Whole::new(asked.control, asked.text, asked.with);
        let steps = asked.blocks.map(u64::from);
        let (mode, target) = (asked.mode.unwrap_or_default(), asked.target.unwrap_or_default());
        let strict = asked.strict.unwrap_or_default();
        let limits = Limits { steps, strict, mode, target, ..Limits::default() };
        let arguments = asked.arguments.unwrap_or_default();
        let session = session(&whole, &setup, limits, asked.program.as_deref(), arguments);
        let session = session.of_file(&asked.file.unwrap_or_default());
        Ok(Run { session, setup, whole })
    }

    /// Carries out about so many blocks; true: the run is over.
    pub fn advance(&mut self, blocks: usize) -> bool {
        self.session.advance(blocks as u64)
    }

    /// How much of the main program is done, 0 to 1.
    pub fn share(&self) -> f64 {
        self.session.share
    }

    /// Its motions so far, to be seen while it goes on.
    pub fn motions(&self) -> Scene {
        Scene::of_motions(self.session.entries())
    }

    /// What it did so far.
    pub fn view(self) -> RunView {
        let source: &Arc<Vec<u8>> = self.whole.text();
        let files = self.whole.files(&Positions::new(source));
        let outcome = self.session.outcome();
        let ending = outcome.ending(|line| Whole::line(&files, line));
        let view = RunView::new(self.setup, outcome, source).with_offers(source);
        RunView { files, ending, ..view }
    }
}

impl RunView {
    /// What a program of this text did on a machine.
    pub fn new(setup: Setup, outcome: Outcome, source: &[u8]) -> RunView {
        RunView {
            diagnostics: placed(&outcome.diagnostics, &Positions::new(source)),
            results: results(&outcome),
            answers: answers(&setup, &outcome),
            decisions: decisions(&outcome),
            changes: changes(&outcome),
            waits: waits(&outcome),
            alarms: raised(&outcome),
            log: outcome.log().into_iter().map(str::to_owned).collect(),
            written: written(&outcome),
            finished: outcome.finished(),
            passed_over: outcome.passed_over.clone(),
            machine_values: outcome.machine_values.clone(),
            files: Vec::new(),
            ending: outcome.ending(|line| (None, line)),
            about: RecordAbout::new(&setup),
            assumed: None,
            trace: Source { setup, outcome, zones: Vec::new(), limits: Vec::new(), call: None, apart: false },
        }
    }

    /// With what the machine lacks for the program of this text.
    fn with_offers(mut self, source: &Arc<Vec<u8>>) -> RunView {
        let Source { setup, outcome, .. } = &self.trace;
        let fault =
            outcome.stop.iter().filter_map(|stop| if let Stop::Fault(message) = stop { Some(message) } else { None });
        let problems: Vec<&Message> = outcome.diagnostics.iter().map(|found| &found.message).chain(fault).collect();
        let codes = outcome.alarms();
        if !codes.iter().any(|code| curable(*code)) && !problems.iter().any(|problem| lacking(problem)) {
            return self;
        }
        let macros = &setup.control.definitions.macros;
        let needs = Needs::of(&syntax::read_held(setup.control.dialect, source, macros, &mut |_| {}), setup);
        let offers: Vec<_> = problems.iter().map(|problem| needs.offers(problem)).collect();
        for (finding, offers) in self.diagnostics.iter_mut().zip(&offers) {
            finding.offers.clone_from(offers);
        }
        let faults = offers.into_iter().skip(self.diagnostics.len());
        let lines: Vec<Option<u32>> = self.alarms.iter().map(|alarm| alarm.call.line).collect();
        let alarms = codes.into_iter().zip(lines).map(|(code, line)| needs.offers_at(code, line));
        for (alarm, offers) in self.alarms.iter_mut().zip(alarms.chain(faults)) {
            alarm.raised.offers = offers;
        }
        self
    }
}

fn results(outcome: &Outcome) -> Vec<RunResult> {
    let mut all = Vec::new();
    let mut told = BTreeSet::new();
    for Left { call, units, results } in outcome.left() {
        for (field, value) in results {
            told.insert(field.name);
            all.push(RunResult {
                name: field.name.to_owned(),
                value,
                label: Some(Message::new(field.key)),
                unit: Some(result_unit(field.unit, units, outcome.control.basic_units)),
                call: OfCall::new(Some(call)),
            });
        }
    }
    let rest = outcome.written().into_iter().filter(|(name, _)| !told.contains(name));
    all.extend(rest.map(|(name, value)| RunResult { name: name.to_owned(), value, ..RunResult::default() }));
    all
}

/// What each measuring call came to.
pub(super) fn answers(setup: &Setup, outcome: &Outcome) -> Vec<RunAnswer> {
    let mut probes = Probes::new(setup);
    let answer = |called: &Called| {
        let (entries, ended) = called.entries(outcome);
        let line = entries.first().and_then(|entry| entry.line).map(|line| line + 1);
        let answer = answer(called, outcome);
        RunAnswer {
            call: OfCall { line, cycle: Some(called.inputs.cycle.name) },
            probe: probes.of(&called.inputs, line, ended),
            alarms: codes(&entries, outcome.stop.as_ref().filter(|_| !ended)),
            place: amid(&entries),
            from: called.at,
            to: called.at + entries.len().saturating_sub(1),
            answer,
        }
    };
    outcome.called.iter().map(answer).collect()
}

/// The middle of the points that these steps touched.
pub(super) fn amid(entries: &[Entry]) -> Option<[f64; 3]> {
    let touched = |entry: &Entry| if let Step::Touch { point, .. } = &entry.step { Some(point.0) } else { None };
    let points: Vec<[f64; 3]> = entries.iter().filter_map(touched).collect();
    let mean = [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64);
    (!points.is_empty()).then_some(mean)
}

/// Alarms and messages among these steps, the one that stopped them last.
fn codes(entries: &[Entry], stop: Option<&Stop>) -> Vec<String> {
    let raised = |entry: &Entry| if let Step::Alarm(code) = entry.step { Some(code) } else { None };
    let mut codes: Vec<Code> = entries.iter().filter_map(raised).collect();
    if let Some(Stop::Alarm(code)) = stop
        && codes.last() != Some(code)
    {
        codes.push(*code);
    }
    codes.iter().map(ToString::to_string).collect()
}

fn decisions(outcome: &Outcome) -> Vec<RunDecision> {
    let decisions = outcome.by_call().filter_map(|(call, step)| match step {
        Step::Decision { message } => Some(RunDecision { message: message.clone(), call: OfCall::new(call) }),
        _ => None,
    });
    decisions.collect()
}

/// Halts with the text that stands on the screen then: that of `MSG` stays until the next one.
fn waits(outcome: &Outcome) -> Vec<RunWait> {
    let mut last = "";
    let halt = |text: &str| ["M0", "M1"].contains(&text);
    let halts = outcome.trace.entries.others().filter_map(|other| match other.step {
        Step::Message { text, waits: true } => {
            let text = if halt(text) && !last.is_empty() { last } else { text.as_str() };
            Some(RunWait { at: other.at, text: text.to_owned() })
        }
        Step::Message { text, .. } if !halt(text) => {
            last = text;
            None
        }
        _ => None,
    });
    halts.collect()
}

fn raised(outcome: &Outcome) -> Vec<RunAlarm> {
    let calls = outcome.calls_of_alarms().map(OfCall::new);
    alarms(outcome).into_iter().zip(calls).map(|(raised, call)| RunAlarm { raised, call }).collect()
}
