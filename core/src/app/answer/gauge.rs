//! Where deviations lie in their limits, as figures of a scale.

use super::figures::{Figure, Sort, measured, written};
use super::shown;
use crate::control::Control;
use crate::entry::{Inputs, ProbeUse, address, names};
use crate::evaluate::symmetry::symmetric;
use crate::machine::Entry;
use crate::run::called::Called;
use serde::Serialize;

/// A scale with limits and needles; all figures in one unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Gauge {
    /// Unit of all figures.
    pub unit: &'static str,
    /// Left end.
    pub low: f64,
    /// Right end.
    pub high: f64,
    /// From end to end, in order.
    pub bands: Vec<Band>,
    /// Limits that lie on the scale.
    pub marks: Vec<Mark>,
    /// What was measured; beyond an end it is drawn there.
    pub needles: Vec<Needle>,
}

/// A part of a scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Band {
    /// What a deviation there means.
    pub kind: BandKind,
    /// Left end.
    pub from: f64,
    /// Right end.
    pub to: f64,
}

/// What a deviation means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum BandKind {
    /// Within.
    Good,
    /// Within the tolerance, corrected whole.
    Mean,
    /// Beyond.
    Bad,
}

/// A limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Mark {
    /// Parameter that gives it.
    pub name: &'static str,
    /// Where it is.
    pub value: f64,
}

/// A deviation.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Needle {
    /// Axis or quantity; empty: the only one.
    pub label: String,
    /// Deviation that the limits watch, empirical value included.
    pub value: f64,
    /// Where it lies.
    pub kind: BandKind,
}

/// The tolerance of a quantity, as the drawing gives it. A safe area or a dimension difference is none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Limited {
    /// Smallest deviation within the tolerance.
    pub low: f64,
    /// Largest one.
    pub high: f64,
    /// Share of the limit on its side that the deviation takes, empirical value included: 1 on the limit; absent: there
    /// is no room on that side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub used: Option<f64>,
}

impl Limited {
    pub(super) fn new(low: f64, high: f64, value: f64) -> Limited {
        let limit = if value < 0.0 { low } else { high };
        let used = (limit.abs() > RESOLUTION).then(|| value / limit).filter(|share| *share >= 0.0);
        Limited { low, high, used }
    }
}

impl Limited {
    /// Whether a deviation is within the tolerance.
    pub(super) fn holds(&self, value: f64) -> bool {
        (self.low - RESOLUTION..=self.high + RESOLUTION).contains(&value)
    }
}

/// Ends of a scale by the widest limit that is coloured.
const ENDS: f64 = 1.4;

/// What a sum of values and units may be off by, in any unit.
const RESOLUTION: f64 = 1e-9;

impl Gauge {
    /// The deviation that decides, from the middle of the limits: the largest.
    pub(super) fn worst(&self) -> Option<f64> {
        let middle = (self.low + self.high) / 2.0;
        self.needles.iter().map(|needle| needle.value - middle).max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// Whether nothing but the safe area limits anything: what lies in it was measured, not judged.
    pub(super) fn is_area(&self) -> bool {
        self.marks.iter().all(|mark| mark.name == AREA)
    }

    /// The limit within which nothing is wrong.
    pub(super) fn limit(&self) -> Option<f64> {
        self.bands.iter().rfind(|band| band.kind != BandKind::Bad).map(|band| band.to)
    }
}

/// The limits of a quantity by another source than the call, from those of the call; none: those of the call.
pub(super) type Told<'a> = &'a dyn Fn(&Figure, [f64; 2]) -> Option<[f64; 2]>;

/// Limits of a call, mm or degree.
struct Limits {
    /// Beyond it on either side something is wrong.
    outer: [(&'static str, f64); 2],
    /// Within it the mean value decides.
    mean: Option<(&'static str, f64)>,
    /// Others that are drawn where they lie on the scale.
    others: Vec<(&'static str, f64)>,
    /// Whether a deviation on the limit is beyond it.
    reached: bool,
    /// The tolerance of the drawing, lower and upper; none: the call has none.
    tolerance: Option<[f64; 2]>,
}

/// The safe area.
const AREA: &str = "_TSA";

/// The gauge of a call; none where nothing limits it, or nothing was measured. `sorts`: its quantities; those that it
/// watches are told their tolerance. `told`: the limits of a quantity by another source than the call, where the call
/// has a tolerance (its limits go in); none: those of the call.
pub(super) fn gauge(
    called: &Called,
    entries: &[Entry],
    control: &Control,
    sorts: &mut [(Sort, Figure)],
    told: Told<'_>,
) -> Option<Gauge> {
    let inputs = &called.inputs;
    let limits = limits(inputs)?;
    let chain = inputs.any(names::TUL).is_some();
    let offset = empirical(called, entries, control);
    let unit = if inputs.is_angle(names::TSA) { "deg" } else { called.units.name() };
    let factor = called.units.factor();
    let per = |value: f64| shown(value, unit, factor);
    let watched = sorts.iter_mut().filter(|(sort, figure)| watches(*sort, inputs, chain) && figure.deviation.is_some());
    let own = limits.outer.map(|(_, value)| per(value));
    let mean = limits.mean.map(|(name, value)| (name, per(value)));
    let mut scale = None;
    let needles: Vec<Needle> = watched
        .map(|(sort, figure)| {
            let value = figure.deviation.unwrap_or(0.0) - offset;
            let by = |own: [f64; 2]| told(figure, own).filter(|_| chain).unwrap_or(own);
            let band = by(own);
            scale.get_or_insert(band);
            let tolerance = limits.tolerance.map(|both| by(both.map(per)));
            figure.limits = tolerance.map(|[low, high]| Limited::new(low, high, value));
            let kind = kind(value, band, mean.map(|(_, value)| value), limits.reached);
            Needle { label: label(*sort, &figure.symbol), value, kind }
        })
        .collect();
    let [low, high] = scale?;
    let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
    let ends = [middle - ENDS * half, middle + ENDS * half];
    let others = limits.others.iter().map(|(name, value)| (*name, per(*value)));
    let others = others.filter(|(name, _)| *name != limits.outer[0].0);
    let both = mean.into_iter().chain(others);
    let both = both.flat_map(|(name, value)| [(name, middle - value), (name, middle + value)]);
    let outer = [(limits.outer[0].0, low), (limits.outer[1].0, high)];
    let all = outer.into_iter().chain(both).filter(|(_, value)| (ends[0]..=ends[1]).contains(value));
    let mut marks: Vec<Mark> = all.map(|(name, value)| Mark { name, value }).collect();
    marks.sort_by(|a, b| a.value.total_cmp(&b.value));
    let bands = bands(ends, [low, high], mean.map(|(_, value)| value));
    Some(Gauge { unit, low: ends[0], high: ends[1], bands, marks, needles })
}

fn kind(value: f64, [low, high]: [f64; 2], mean: Option<f64>, reached: bool) -> BandKind {
    let slack = if reached { -RESOLUTION } else { RESOLUTION };
    if value > high + slack || value < low - slack {
        BandKind::Bad
    } else if mean.is_some_and(|mean| (value - (low + high) / 2.0).abs() > mean + RESOLUTION) {
        BandKind::Mean
    } else {
        BandKind::Good
    }
}

/// The scale from end to end.
fn bands(ends: [f64; 2], outer: [f64; 2], mean: Option<f64>) -> Vec<Band> {
    let (middle, half) = ((outer[0] + outer[1]) / 2.0, (outer[1] - outer[0]) / 2.0);
    let mean = mean.filter(|mean| *mean < half);
    let inner = mean.map_or(outer, |mean| [(middle - mean).max(outer[0]), (middle + mean).min(outer[1])]);
    let rows = [
        (BandKind::Bad, ends[0], outer[0]),
        (BandKind::Mean, outer[0], inner[0]),
        (BandKind::Good, inner[0], inner[1]),
        (BandKind::Mean, inner[1], outer[1]),
        (BandKind::Bad, outer[1], ends[1]),
    ];
    let wide = rows.into_iter().filter(|(_, from, to)| to > from);
    wide.map(|(kind, from, to)| Band { kind, from, to }).collect()
}

/// What limits the deviations of a call.
fn limits(inputs: &Inputs) -> Option<Limits> {
    let cycle = inputs.cycle;
    let given = |name: crate::name::Name| inputs.any(name).filter(|value| *value > 0.0);
    let both = |name: &'static str, value: f64| [(name, -value), (name, value)];
    let plain = |outer, others| Limits { outer, mean: None, others, reached: false, tolerance: None };
    if let (Some(upper), Some(lower)) = (inputs.any(names::TUL), inputs.any(names::TLL)) {
        let band = symmetric(0.0, upper, lower);
        let others: Vec<_> = [(names::TDIF, "_TDIF"), (names::TSA, AREA)]
            .into_iter()
            .filter_map(|(name, text)| Some((text, inputs.any(name)?)))
            .collect();
        let mean = inputs.any(names::TMV).map(|value| ("_TMV", value));
        // the chain asks for the wider ones first: one that is narrower than the tolerance counts before it
        let narrower = others.iter().copied().filter(|(_, value)| *value < band.upper);
        let narrowest = narrower.min_by(|(_, a), (_, b)| a.total_cmp(b));
        let outer = match narrowest {
            Some((name, value)) => both(name, value),
            None => [("_TLL", band.lower), ("_TUL", band.upper)],
        };
        let tolerance = (band.upper > 0.0).then_some([band.lower, band.upper]);
        return (outer[1].1 > 0.0).then_some(Limits { outer, mean, others, reached: false, tolerance });
    }
    if cycle.purpose.probe == ProbeUse::Tool && !cycle.purpose.calibrates.holds(inputs) {
        let (difference, area) = (given(names::TDIF), given(names::TSA));
        let others = area.map(|value| (AREA, value)).into_iter().collect();
        let (name, value) = difference.map(|value| ("_TDIF", value)).or(area.map(|value| (AREA, value)))?;
        return Some(Limits { reached: true, ..plain(both(name, value), others) });
    }
    if let Some(area) = given(names::TSA) {
        return Some(plain(both(AREA, area), Vec::new()));
    }
    let (tolerance, upper) = (given(address::H), given(address::U));
    let others = upper.map(|value| ("U", value)).into_iter().collect();
    let (name, value) = tolerance.map(|value| ("H", value)).or(upper.map(|value| ("U", value)))?;
    Some(Limits { tolerance: tolerance.map(|value| [-value, value]), ..plain(both(name, value), others) })
}

/// Whether the limits of a call watch a quantity; `chain`: the chain of tolerances of a tool offset.
fn watches(sort: Sort, inputs: &Inputs, chain: bool) -> bool {
    let nct = inputs.any(names::TSA).is_none();
    match sort {
        Sort::Size | Sort::Length(_) | Sort::Two => chain || nct,
        Sort::Centre(index) if !chain && !nct => measured(inputs).is_none_or(|axis| axis == index),
        Sort::Centre(_) => false,
        Sort::Corner(_) | Sort::Skew(_) | Sort::Ball | Sort::Other => false,
        _ => true,
    }
}

/// The empirical value as the cycle subtracts it from what decides; the results of tool probes have it already.
fn empirical(called: &Called, entries: &[Entry], control: &Control) -> f64 {
    if called.inputs.cycle.purpose.probe != ProbeUse::Workpiece {
        return 0.0;
    }
    let stored = written(called, entries).get("result-empirical-value").map_or(0.0, |(_, value)| *value);
    let memory = written(called, entries).get("result-empirical-memory").map_or(0.0, |(_, value)| *value);
    match (memory > 0.0, control.bit("_CHBIT[5]")) {
        (false, _) => 0.0,
        (true, true) => -stored,
        (true, false) => stored,
    }
}

/// What stands at a needle.
fn label(sort: Sort, symbol: &str) -> String {
    match sort {
        Sort::Size | Sort::Two | Sort::Angle(_) => String::new(),
        _ => symbol.to_owned(),
    }
}
