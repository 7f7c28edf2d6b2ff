//! What a call came to on a real machine: its quantities with the values of a protocol.

use super::figures::{Figure, Sort, found, measured as axis};
use super::gauge::{BandKind, Gauge, gauge};
use super::{Answer, Verdict, beyond, feature, inside};
use crate::entry::{Inputs, ProbeUse};
use crate::geometry::{Dir, Wcs};
use crate::machine::Entry;
use crate::message::Message;
use crate::run;
use crate::run::called::Called;
use std::collections::BTreeMap;

/// A value of a protocol, in the unit of the call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// As it was measured.
    pub actual: f64,
    /// The setpoint that stands beside it, where that is another one than in the run: a centre may be expected where
    /// the probe stands.
    pub set: Option<f64>,
}

/// Values by the result that has them.
pub type Values = BTreeMap<&'static str, Value>;

/// How the faces that a call touches deviate, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviates {
    /// By how much all of them are shifted.
    pub shift: Dir<Wcs>,
    /// By how much each lies further out along its normal.
    pub out: f64,
    /// The same for faces across X, Y and Z of the workpiece.
    pub across: [f64; 3],
}

/// What a call came to with these values; what has none was not measured.
pub fn measured(called: &Called, outcome: &run::Outcome, values: &Values) -> Answer {
    let (entries, _) = called.entries(outcome);
    let mut sorts = real(called, &entries, values, |value, set| value.set.or(set));
    let gauge = gauge(called, &entries, &outcome.control, &mut sorts);
    let figures: Vec<Figure> = sorts.into_iter().map(|(_, figure)| figure).collect();
    let verdict = verdict(&called.inputs, gauge.as_ref());
    let words = if figures.is_empty() { "record-missing" } else { verdict.key() };
    Answer {
        screen: None,
        feature: feature(&called.inputs),
        corrected: Vec::new(),
        verdict,
        verdict_words: Message::new(words),
        alarm: None,
        why: why(verdict, gauge.as_ref(), figures.is_empty()),
        figures,
        gauge,
    }
}

/// The quantities of a call that have a value. `expected`: the setpoint of a value, which the run has as this one.
fn real(
    called: &Called,
    entries: &[Entry],
    values: &Values,
    expected: impl Fn(&Value, Option<f64>) -> Option<f64>,
) -> Vec<(Sort, Figure)> {
    let sorts = found(called, entries).into_iter();
    let with = sorts.filter_map(|(sort, figure)| {
        let value = values.get(figure.name)?;
        let set = expected(value, figure.set);
        let deviation = set.map(|set| value.actual - set);
        Some((sort, Figure { actual: value.actual, set, deviation, ..figure }))
    });
    with.collect()
}

fn verdict(inputs: &Inputs, gauge: Option<&Gauge>) -> Verdict {
    let Some(gauge) = gauge else { return Verdict::Measured };
    if gauge.needles.iter().all(|one| one.kind != BandKind::Bad) {
        return Verdict::Within;
    }
    let tolerance = gauge.marks.iter().any(|mark| ["_TUL", "H"].contains(&mark.name));
    beyond(inputs, tolerance, gauge.worst().map(|worst| worst > 0.0))
}

fn why(verdict: Verdict, gauge: Option<&Gauge>, none: bool) -> Message {
    let key = match verdict {
        _ if none => return Message::new("record-why-missing"),
        Verdict::Within => "answer-why-within",
        _ => "record-why-beyond",
    };
    match gauge.and_then(|gauge| Some((gauge.limit()?, gauge.unit))) {
        Some((limit, unit)) => Message::new(key).number("limit", limit).text("unit", unit),
        None => Message::new("answer-why-measured"),
    }
}

/// How the faces that a call touches deviate by these values from where the run expects them. Of several spheres nobody
/// can tell which touch is whose.
pub fn deviates(called: &Called, entries: &[Entry], values: &Values) -> Deviates {
    let inputs = &called.inputs;
    let purpose = &inputs.cycle.purpose;
    let sorts = real(called, entries, values, |_, set| set);
    let spheres = sorts.iter().filter(|(sort, _)| *sort == Sort::Sphere).count();
    let mut all = Deviates::default();
    if purpose.probe != ProbeUse::Workpiece || purpose.calibrates.holds(inputs) || spheres > 1 {
        return all;
    }
    let outward = if inside(inputs) == Some(true) { -1.0 } else { 1.0 };
    let axes = inputs.plane.axes();
    let halved = |axis: usize| if inputs.diameters && axis == 0 { 0.5 } else { 1.0 };
    for (sort, figure) in sorts {
        let Some(by) = figure.deviation.map(|by| if figure.unit == "deg" { by } else { by * called.units.factor() })
        else {
            continue;
        };
        match sort {
            Sort::Size | Sort::Sphere => all.out += outward * by / 2.0,
            Sort::Length(index) => all.across[axes[index.min(2)]] += outward * by / 2.0,
            Sort::Centre(index) => all.shift[axes[index.min(2)]] += by,
            Sort::Two => all.out += outward * by * axis(inputs).map_or(1.0, |index| halved(axes[index])),
            Sort::Position => {
                if let Some(axis) = axis(inputs).map(|index| axes[index]) {
                    all.shift[axis] += by * halved(axis);
                }
            }
            _ => {}
        }
    }
    all
}
