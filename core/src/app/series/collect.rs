//! What the runs of a series came to, one after the other.

use super::{
    COURSE, SeriesAlarm, SeriesCall, SeriesCorrection, SeriesFigure, SeriesMemory, SeriesShare, SeriesSpread,
    SeriesView, SeriesWeight, share_told,
};
use crate::app::answer::{Figure, Limited, Verdict};
use crate::app::outcome::{Raised, alarms};
use crate::app::run::{Occurrences, OfCall, RunAnswer, answers};
use crate::control::{Control, Units};
use crate::entry::{Inputs, names};
use crate::evaluate::mean;
use crate::machine::Setup;
use crate::machine::series::Series;
use crate::message::Message;
use crate::run::Outcome;
use crate::series::capability::capability;
use crate::series::decide::Limits;
use crate::series::spread::{Spread, share_doubt};
use std::collections::BTreeMap;

/// Most calls of a program whose results are kept: a loop may have any number.
const CALLS: usize = 1000;
/// Intervals of a histogram.
const INTERVALS: usize = 20;

/// The runs so far.
#[derive(Default)]
pub(super) struct Collected {
    runs: usize,
    finished: usize,
    calls: Vec<Call>,
    /// Where among them a call is, by how often it came before in its run.
    places: BTreeMap<(OfCall, usize), usize>,
    /// Most calls of a run.
    most: usize,
    alarms: Vec<(Raised, usize)>,
}

/// A call so far.
struct Call {
    call: OfCall,
    feature: Message,
    weight: Option<SeriesWeight>,
    figures: Vec<Column>,
    corrected: Vec<Corrected>,
    verdicts: Vec<(Verdict, Message, usize)>,
    memories: Vec<SeriesMemory>,
}

/// A quantity so far: a value for each run, not a number where a run has none.
struct Column {
    name: &'static str,
    label: Message,
    unit: &'static str,
    limits: Option<Limited>,
    set: Option<f64>,
    values: Vec<f64>,
    deviations: Vec<f64>,
}

/// A datum so far.
struct Corrected {
    target: Message,
    part: String,
    unit: &'static str,
    by: Vec<f64>,
    course: Vec<f64>,
}

impl Collected {
    /// Takes a run; false: it was given up.
    pub(super) fn add(&mut self, setup: &Setup, outcome: &Outcome) -> bool {
        let answers = answers(setup, outcome);
        self.most = self.most.max(answers.len());
        let mut came = Occurrences::default();
        for (answer, called) in answers.into_iter().zip(&outcome.called) {
            let next = self.calls.len();
            let place = *self.places.entry(came.next(answer.call)).or_insert(next);
            if place == next && next < CALLS {
                self.calls.push(Call::new(&answer, &called.inputs, called.units));
            }
            let Some(call) = self.calls.get_mut(place) else { continue };
            call.add(self.runs, answer);
            call.remember(self.runs, &outcome.control, called.units);
        }
        let mut raised = alarms(outcome);
        raised.dedup();
        for one in raised {
            match self.alarms.iter_mut().find(|(known, _)| (&known.code, &known.message) == (&one.code, &one.message)) {
                Some((_, count)) => *count += 1,
                None => self.alarms.push((one, 1)),
            }
        }
        self.runs += 1;
        self.finished += usize::from(outcome.finished());
        outcome.given_up().is_none()
    }

    /// What they came to.
    pub(super) fn view(self, series: &Series) -> SeriesView {
        let runs = self.runs;
        let alarm = |(raised, count): (Raised, usize)| {
            let share = share(count, runs);
            let error = share_doubt(share, runs);
            SeriesAlarm { raised, count, share, error, told: share_told(count, share, error) }
        };
        let more = || Message::new("series-more").number("count", self.most as f64).number("shown", CALLS as f64);
        SeriesView {
            runs: runs as u32,
            seed: series.seed,
            mode: series.mode,
            finished: self.finished,
            more: (self.most > CALLS).then(more),
            calls: self.calls.into_iter().map(|call| call.view(runs)).collect(),
            alarms: self.alarms.into_iter().map(alarm).collect(),
        }
    }
}

fn share(count: usize, runs: usize) -> f64 {
    count as f64 / runs.max(1) as f64
}

/// The memories of a call, before the first run (B:2303-2342).
fn memories(inputs: &Inputs, units: Units) -> Vec<SeriesMemory> {
    let numbers = mean::memories(inputs.any(names::EVNUM).unwrap_or(0.0) as i64);
    let both = [("_MV", numbers.mean, true), ("_EV", numbers.empirical, false)];
    let used = both.into_iter().filter(|(_, number, _)| *number > 0);
    let memory = |(stem, number, mean)| {
        let name = format!("{stem}[{}]", number - 1);
        SeriesMemory { name, mean, unit: units.name(), course: vec![] }
    };
    used.map(memory).collect()
}

impl Call {
    fn new(answer: &RunAnswer, inputs: &Inputs, units: Units) -> Call {
        let (figures, corrected, verdicts) = (Vec::new(), Vec::new(), Vec::new());
        let (call, feature, memories) = (answer.call, answer.answer.feature.clone(), memories(inputs, units));
        let kept = memories.iter().any(|memory| memory.mean);
        let value = inputs.any(names::K).filter(|_| kept);
        let weight = value.map(|value| SeriesWeight { name: names::K.as_str(), value });
        Call { call, feature, weight, figures, corrected, verdicts, memories }
    }

    /// What the memories hold after this run.
    fn remember(&mut self, run: usize, control: &Control, units: Units) {
        for memory in self.memories.iter_mut().filter(|_| run < COURSE) {
            let value = control.basic_length(&memory.name) / units.factor();
            memory.course.resize(run, value);
            memory.course.push(value);
        }
    }

    fn add(&mut self, run: usize, RunAnswer { answer, .. }: RunAnswer) {
        for figure in &answer.figures {
            let at = self.figures.iter().position(|column| column.name == figure.name).unwrap_or_else(|| {
                self.figures.push(Column::new(figure));
                self.figures.len() - 1
            });
            self.figures[at].add(run, figure);
        }
        for correction in &answer.corrected {
            for part in &correction.parts {
                let known = |one: &Corrected| (&one.target, &one.part) == (&correction.target, &part.name);
                let at = self.corrected.iter().position(known).unwrap_or_else(|| {
                    let (target, part, unit) = (correction.target.clone(), part.name.clone(), part.unit);
                    self.corrected.push(Corrected { target, part, unit, by: Vec::new(), course: Vec::new() });
                    self.corrected.len() - 1
                });
                let one = &mut self.corrected[at];
                one.by.push(part.by);
                if run < COURSE {
                    one.course.resize(run, 0.0);
                    one.course.push(part.by);
                }
            }
        }
        match self.verdicts.iter_mut().find(|(_, words, _)| *words == answer.verdict_words) {
            Some((_, _, count)) => *count += 1,
            None => self.verdicts.push((answer.verdict, answer.verdict_words, 1)),
        }
    }

    fn view(self, runs: usize) -> SeriesCall {
        let verdict = |(verdict, words, count): (Verdict, Message, usize)| {
            let share = share(count, runs);
            let error = share_doubt(share, runs);
            SeriesShare { verdict, words, count, share, error, told: share_told(count, share, error) }
        };
        let corrected = |mut one: Corrected| {
            let spread = SeriesSpread::from(&Spread::of(one.by));
            one.course.resize(runs.min(COURSE), 0.0);
            SeriesCorrection { target: one.target, part: one.part, unit: one.unit, spread, course: one.course }
        };
        let mut verdicts: Vec<SeriesShare> = self.verdicts.into_iter().map(verdict).collect();
        verdicts.sort_by_key(|one| std::cmp::Reverse(one.count));
        SeriesCall {
            call: self.call,
            feature: self.feature,
            weight: self.weight,
            measured: self.figures.into_iter().map(Column::view).collect(),
            corrected: self.corrected.into_iter().map(corrected).collect(),
            verdicts,
            uncorrected: Vec::new(),
            memories: self.memories,
        }
    }
}

impl Column {
    fn new(figure: &Figure) -> Column {
        let Figure { name, label, unit, limits, .. } = figure;
        let (values, deviations) = (Vec::new(), Vec::new());
        Column { name, label: label.clone(), unit, limits: *limits, set: figure.set, values, deviations }
    }

    fn add(&mut self, run: usize, figure: &Figure) {
        self.values.resize(run, f64::NAN);
        self.values.push(figure.actual);
        self.deviations.extend(figure.deviation);
        self.limits = self.limits.or(figure.limits);
        self.set = self.set.or(figure.set);
    }

    fn view(self) -> SeriesFigure {
        let spread = Spread::of(self.values.clone());
        let course = self.values.iter().take(COURSE).map(|value| value.is_finite().then_some(*value));
        let limits = self.limits.map(|limits| Limits { low: limits.low, high: limits.high });
        SeriesFigure {
            name: self.name,
            label: self.label,
            unit: self.unit,
            spread: SeriesSpread::from(&spread),
            histogram: spread.histogram(INTERVALS),
            limits: limits.map(|limits| [limits.low, limits.high]),
            capability: limits.and_then(|limits| capability(&Spread::of(self.deviations), limits)),
            set: self.set,
            course: course.collect(),
            values: self.values,
        }
    }
}
