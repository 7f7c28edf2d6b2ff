//! What a call came to on a real machine: its quantities with the values of a protocol.

use super::figures::{Figure, Sort, found, measured as axis};
use super::gauge::{BandKind, Gauge, Limited, gauge};
use super::{Answer, Verdict, beyond, feature, inside, past, within, words};
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
    /// Half of the last digit of that setpoint.
    pub half: f64,
    /// Smallest and largest permissible value, where the protocol has them.
    pub limits: Option<[f64; 2]>,
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
    /// By which angle they are turned about X, Y and Z of the workpiece, degree; about the first point of them that is
    /// touched.
    pub turn: [f64; 3],
}

/// What a call came to with these values; what has none was not measured.
pub fn measured(called: &Called, outcome: &run::Outcome, values: &Values) -> Answer {
    let (entries, _) = called.entries(outcome);
    let mut sorts = real(called, &entries, values);
    let own: BTreeMap<&str, f64> =
        found(called, &entries).into_iter().filter_map(|(_, figure)| Some((figure.name, figure.set?))).collect();
    let told = |figure: &Figure, band: [f64; 2]| told(values.get(figure.name)?, figure, *own.get(figure.name)?, band);
    let gauge = gauge(called, &entries, &outcome.control, &mut sorts, &told);
    let past = past(gauge.as_ref(), &sorts);
    for (_, figure) in &mut sorts {
        let limits = values.get(figure.name).and_then(|value| value.limits).zip(figure.set);
        let limits = limits.zip(figure.deviation).filter(|_| figure.limits.is_none());
        figure.limits =
            figure.limits.or(limits.map(|(([low, high], set), by)| Limited::new(low - set, high - set, by)));
    }
    let figures: Vec<Figure> = sorts.into_iter().map(|(_, figure)| figure).collect();
    let verdict = verdict(&called.inputs, gauge.as_ref(), past);
    let missing = || Message::new("record-missing");
    let verdict_words = if figures.is_empty() { missing() } else { words(verdict, None, gauge.as_ref()) };
    Answer {
        screen: None,
        feature: feature(&called.inputs),
        corrected: Vec::new(),
        verdict,
        verdict_words,
        alarm: None,
        why: why(verdict, gauge.as_ref(), figures.is_empty()),
        figures,
        gauge,
    }
}

/// The tolerance about the setpoint that a protocol tells; none: that of the call, `band` about its own setpoint. The
/// limits of the protocol come first. Limits that the call gives stay where they are while the setpoint is between
/// them: the control measures from the middle of the tolerance, a log may tell the nominal value. Another setpoint is
/// that of another place.
fn told(value: &Value, figure: &Figure, own: f64, band: [f64; 2]) -> Option<[f64; 2]> {
    let set = figure.set?;
    if let Some(limits) = value.limits {
        return Some(limits.map(|limit| limit - set));
    }
    let (by, [low, high], on) = (own - set, band, value.half + ON);
    (low - on..=high + on).contains(&-by).then_some([low + by, high + by])
}

/// What a setpoint on a limit may be off by beside its last digit, in any unit.
const ON: f64 = 1e-9;

/// The quantities of a call that have a value.
fn real(called: &Called, entries: &[Entry], values: &Values) -> Vec<(Sort, Figure)> {
    let sorts = found(called, entries).into_iter();
    let with = sorts.filter_map(|(sort, figure)| {
        let value = values.get(figure.name)?;
        let set = value.set.or(figure.set);
        let deviation = set.map(|set| value.actual - set);
        Some((sort, Figure { actual: value.actual, set, deviation, ..figure }))
    });
    with.collect()
}

/// `past`: whether a deviation is beyond the tolerance; none: the call has no tolerance.
fn verdict(inputs: &Inputs, gauge: Option<&Gauge>, past: Option<bool>) -> Verdict {
    let Some(gauge) = gauge else { return Verdict::Measured };
    match past {
        Some(true) => beyond(inputs, Some(gauge)),
        None if gauge.needles.iter().any(|one| one.kind == BandKind::Bad) => Verdict::Beyond,
        _ => Verdict::Within,
    }
}

fn why(verdict: Verdict, gauge: Option<&Gauge>, none: bool) -> Message {
    match gauge.and_then(|gauge| Some((gauge, gauge.limit()?))) {
        _ if none => Message::new("record-why-missing"),
        Some((gauge, limit)) if verdict == Verdict::Within => within(gauge, limit),
        Some((gauge, limit)) => Message::new("record-why-beyond").number("limit", limit).text("unit", gauge.unit),
        None => Message::new("answer-why-measured"),
    }
}

/// How the faces that a call touches deviate by these values from where the run expects them, which is its setpoint, or
/// what it measured itself where there is none. One for each body that is touched: several spheres are measured one
/// after the other, each by as many touches (B:8297-8310).
pub fn deviates(called: &Called, entries: &[Entry], values: &Values) -> Vec<Deviates> {
    let inputs = &called.inputs;
    let purpose = &inputs.cycle.purpose;
    let mut all = vec![Deviates::default()];
    if purpose.probe != ProbeUse::Workpiece || purpose.calibrates.holds(inputs) {
        return all;
    }
    let mut spheres = 0;
    for (sort, figure) in found(called, entries) {
        spheres += usize::from(sort == Sort::Sphere);
        if spheres > all.len() {
            all.push(Deviates::default());
        }
        if let (Some(one), Some(value)) = (all.last_mut(), values.get(figure.name)) {
            let by = value.actual - figure.set.unwrap_or(figure.actual);
            let factor = if figure.unit == "deg" { 1.0 } else { called.units.factor() };
            one.add(inputs, sort, by * factor);
        }
    }
    all
}

impl Deviates {
    /// Of a quantity that is by so much larger than it should be, mm or degree.
    fn add(&mut self, inputs: &Inputs, sort: Sort, by: f64) {
        let outward = if inside(inputs) == Some(true) { -1.0 } else { 1.0 };
        let axes = inputs.plane.axes();
        let halved = |axis: usize| if inputs.diameters && axis == 0 { 0.5 } else { 1.0 };
        match sort {
            Sort::Size | Sort::Sphere => self.out += outward * by / 2.0,
            Sort::Length(index) => self.across[axes[index.min(2)]] += outward * by / 2.0,
            Sort::Centre(index) | Sort::Corner(index) => self.shift[axes[index.min(2)]] += by,
            Sort::Angle(index) => self.turn[axes[index.min(2)]] += by,
            Sort::Two => self.out += outward * by * axis(inputs).map_or(1.0, |index| halved(axes[index])),
            Sort::Position => {
                if let Some(axis) = axis(inputs).map(|index| axes[index]) {
                    self.shift[axis] += by * halved(axis);
                }
            }
            _ => {}
        }
    }
}
