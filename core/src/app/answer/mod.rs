//! What a call came to, in one line: what was measured, what is corrected, where in its limits, and why.

mod corrected;
mod figures;
mod gauge;
mod measured;
mod screen;
#[cfg(test)]
mod screen_tests;
#[cfg(test)]
mod tests;

pub use corrected::{Correction, Part};
pub(super) use corrected::{corrected, corrected_data};
pub use figures::Figure;
pub use gauge::{Band, BandKind, Gauge, Limited, Mark, Needle};
pub(super) use measured::{Deviates, Value, Values, deviates, measured};
pub use screen::{ResultScreen, ScreenRow, ScreenUntil, ScreenValue};

use super::outcome::Raised;
use crate::catalogue::alarms;
use crate::catalogue::nct::{OUT_OF_TOLERANCE, UPPER_TOLERANCE};
use crate::control::Control;
use crate::diagnostic::Code;
use crate::entry::{Element, Inputs};
use crate::machine::{Entry, Step, Stop};
use crate::message::Message;
use crate::run;
use crate::run::called::{Called, measures};
use serde::Serialize;

/// What a call came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Answer {
    /// What is measured, in words.
    pub feature: Message,
    /// What was measured, the most important first.
    pub figures: Vec<Figure>,
    /// What was corrected; none: nothing.
    pub corrected: Vec<Correction>,
    /// Where the deviations lie in their limits; absent: nothing limits them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gauge: Option<Gauge>,
    /// What follows.
    pub verdict: Verdict,
    /// The verdict in words.
    pub verdict_words: Message,
    /// Number or text of the alarm or operator message behind the verdict.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alarm: Option<String>,
    /// Why, in a sentence.
    pub why: Message,
    /// The measuring result screen; absent: the control shows none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub screen: Option<ResultScreen>,
}

/// What follows from a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Verdict {
    /// Within all limits.
    Within,
    /// Beyond a limit, the program goes on.
    Beyond,
    /// Beyond the tolerance, metal is left.
    Rework,
    /// Beyond the tolerance, metal is missing.
    Scrap,
    /// An alarm stopped it.
    Alarm,
    /// The simulation went no further.
    Stopped,
    /// Nothing limits it.
    Measured,
}

impl Verdict {
    pub(super) fn key(self) -> &'static str {
        match self {
            Verdict::Within => "answer-within",
            Verdict::Beyond => "answer-beyond",
            Verdict::Rework => "answer-rework",
            Verdict::Scrap => "answer-scrap",
            Verdict::Alarm => "answer-alarm",
            Verdict::Stopped => "answer-stopped",
            Verdict::Measured => "answer-measured",
        }
    }
}

/// The call of a form; none of one that is no measurement.
pub(super) fn of_call(inputs: &Inputs, outcome: &run::Outcome) -> Option<Answer> {
    let (units, basic) = (outcome.before.active_units, outcome.before.basic_units);
    let called = Called { at: 0, inputs: inputs.clone(), units, basic, log: None, shown: Vec::new() };
    measures(inputs.cycle).then(|| answer(&called, outcome))
}

/// What a call came to in a run.
pub(super) fn answer(called: &Called, outcome: &run::Outcome) -> Answer {
    let (entries, ended) = called.entries(outcome);
    let entries = &entries[..];
    let stop = outcome.stop.as_ref().filter(|_| !ended);
    let inputs = &called.inputs;
    let mut sorts = figures::found(called, entries);
    let gauge = gauge::gauge(called, entries, &outcome.control, &mut sorts, &|_, _| None);
    let raised = raised(entries);
    let (verdict, alarm) = verdict(inputs, stop, raised, gauge.as_ref(), past(gauge.as_ref(), &sorts));
    Answer {
        feature: feature(inputs),
        screen: screen::screen(called, entries, asked(called, entries.len(), outcome), &outcome.control),
        corrected: corrected::corrected(entries, &outcome.control),
        verdict,
        verdict_words: words(verdict, alarm, gauge.as_ref()),
        alarm: alarm.map(|code| code.to_string()),
        why: why(stop, entries, alarm, gauge.as_ref()),
        figures: sorts.into_iter().map(|(_, figure)| figure).collect(),
        gauge,
    }
}

/// The screen that the program shows between the end of a call and the next one: its index in the trace.
fn asked(called: &Called, length: usize, outcome: &run::Outcome) -> Option<(usize, ScreenUntil)> {
    let from = called.at + length;
    let next = outcome.called.partition_point(|other| other.at < from);
    let until = outcome.called.get(next).map_or(usize::MAX, |next| next.at);
    let mut steps = outcome.trace.entries.others_behind(from).take_while(|other| other.at < until);
    steps.find_map(|other| Some((other.at, screen::shown(other.step)?)))
}

/// What is measured; where that is not known, the cycle.
fn feature(inputs: &Inputs) -> Message {
    let [name, _] = element(inputs).map_or([""; 2], Element::keys);
    if name.is_empty() { Message::new(format!("{}-title", inputs.cycle.key)) } else { Message::new(name) }
}

/// The element of a call.
fn element(inputs: &Inputs) -> Option<Element> {
    let mut elements = inputs.cycle.aims.elements.iter();
    elements.find(|(when, _)| when.holds(inputs)).map(|(_, element)| *element)
}

/// Whether a larger size is metal that is missing; none of what has no size.
pub(super) fn inside(inputs: &Inputs) -> Option<bool> {
    match element(inputs)? {
        Element::Hole | Element::Groove | Element::Pocket => Some(true),
        Element::Shaft | Element::Web | Element::Boss => Some(false),
        _ => None,
    }
}

/// The steps of the last attempt: a measurement that is repeated counts as it was done last.
fn last_attempt(entries: &[Entry]) -> &[Entry] {
    let repeats = |entry: &Entry| decision(entry).is_some_and(|message| message.key == "evaluate-repeat");
    let from = entries.iter().rposition(repeats).map_or(0, |at| at + 1);
    entries.get(from..).unwrap_or_default()
}

fn decision(entry: &Entry) -> Option<&Message> {
    if let Step::Decision { message } = &entry.step { Some(message) } else { None }
}

/// The alarm or message of the last attempt that says a limit was exceeded.
fn raised(entries: &[Entry]) -> Option<Code> {
    let mut codes = last_attempt(entries).iter().filter_map(|entry| match entry.step {
        Step::Alarm(code) => Some(code),
        _ => None,
    });
    codes.find(|code| matches!(code, Code::Alarm(62304..=62306)) || [OUT_OF_TOLERANCE, UPPER_TOLERANCE].contains(code))
}

/// Whether a deviation is beyond the tolerance of the part; none: the call has no tolerance.
fn past(gauge: Option<&Gauge>, sorts: &[(figures::Sort, Figure)]) -> Option<bool> {
    let limited = sorts.iter().filter_map(|(_, figure)| figure.limits);
    let needles = gauge.into_iter().flat_map(|gauge| &gauge.needles);
    limited.zip(needles).map(|(limits, needle)| !limits.holds(needle.value)).reduce(|one, other| one || other)
}

/// What follows, and the alarm behind it. `past`: see [`past`]. Another limit than the tolerance, such as the dimension
/// difference, tells nothing about the part.
fn verdict(
    inputs: &Inputs,
    stop: Option<&Stop>,
    raised: Option<Code>,
    gauge: Option<&Gauge>,
    past: Option<bool>,
) -> (Verdict, Option<Code>) {
    let verdict = match (stop, raised) {
        (Some(Stop::Alarm(code)), _) => return (Verdict::Alarm, Some(*code)),
        (Some(Stop::Fault(_)), _) => Verdict::Stopped,
        (None, None) if gauge.is_some() => Verdict::Within,
        (None, None) => Verdict::Measured,
        (None, Some(code)) => match past {
            _ if matches!(code, Code::Alarm(62304 | 62305)) || code == OUT_OF_TOLERANCE => beyond(inputs, gauge),
            Some(true) => beyond(inputs, gauge),
            Some(false) => Verdict::Within,
            None => Verdict::Beyond,
        },
    };
    (verdict, raised.filter(|_| stop.is_none()))
}

/// What follows beyond the tolerance of the part, by the deviation that decides.
fn beyond(inputs: &Inputs, gauge: Option<&Gauge>) -> Verdict {
    let over = gauge.and_then(Gauge::worst).map(|worst| worst > 0.0);
    match (inside(inputs), over) {
        (Some(inside), Some(over)) if inside == over => Verdict::Scrap,
        (Some(_), Some(_)) => Verdict::Rework,
        _ => Verdict::Beyond,
    }
}

/// The verdict in words. What only the safe area limits is not judged: it says no more than that.
fn words(verdict: Verdict, alarm: Option<Code>, gauge: Option<&Gauge>) -> Message {
    match (verdict, alarm) {
        (Verdict::Alarm, Some(code)) => Message::new(verdict.key()).text("code", code.to_string()),
        (Verdict::Within, _) if gauge.is_some_and(Gauge::is_area) => Message::new("answer-within-area"),
        _ => Message::new(verdict.key()),
    }
}

/// Decisions that say what a difference means.
const CHAIN: [&str; 15] = [
    "evaluate-safe-area", "evaluate-safe-area-angle", "evaluate-difference", "evaluate-oversize", "evaluate-undersize",
    "evaluate-whole", "evaluate-mean", "evaluate-small", "evaluate-tool-safe-area", "evaluate-tool-difference",
    "evaluate-tool-small", "evaluate-tool-geometry", "evaluate-tool-wear", "evaluate-tool-simulated",
    "decision-nct-no-update",
];

/// Why: what the cycle decided, else what stopped it, else what the limits say.
fn why(stop: Option<&Stop>, entries: &[Entry], alarm: Option<Code>, gauge: Option<&Gauge>) -> Message {
    let mut decisions = last_attempt(entries).iter().filter_map(decision);
    let decided = decisions.rfind(|message| CHAIN.contains(&message.key.as_ref()));
    let limit = gauge.and_then(|gauge| gauge.limit());
    match (stop, alarm) {
        (Some(Stop::Alarm(Code::Alarm(61303))) | None, _) if decided.is_some() => {
            decided.cloned().unwrap_or_else(|| Message::new("answer-why-measured"))
        }
        (Some(stop), _) => Raised::stop(stop).message,
        (None, Some(code)) => Message::new(alarms::key(code)),
        (None, None) => match (gauge, limit) {
            (Some(gauge), Some(limit)) => within(gauge, limit),
            _ => Message::new("answer-why-measured"),
        },
    }
}

/// Why a measurement is within its limits.
fn within(gauge: &Gauge, limit: f64) -> Message {
    let key = if gauge.is_area() { "answer-why-area" } else { "answer-why-within" };
    Message::new(key).number("limit", limit).text("unit", gauge.unit)
}

/// A value of mm or degree in its unit.
fn shown(value: f64, unit: &str, control_factor: f64) -> f64 {
    if unit == "deg" { value } else { value / control_factor }
}

/// Names of the axes of the plane at a call: abscissa, ordinate, applicate.
fn axes(inputs: &Inputs) -> [&'static str; 3] {
    inputs.plane.axes().map(|axis| ["X", "Y", "Z"][axis.min(2)])
}

/// Whether a name is one that a correction of this control writes: a tool, a frame or a register.
fn is_corrected(control: &Control, name: &str) -> bool {
    control.variable(name).is_some()
}
