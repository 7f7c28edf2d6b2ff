//! A program carried out many times: how its results spread, what follows from them, and which alarms come.

mod asked;
mod collect;
mod example;
mod offered;
#[cfg(test)]
mod tests;

use super::answer::Verdict;
use super::outcome::Raised;
use super::run::{Occurrences, OfCall, by_occurrence};
use crate::control::Control;
use crate::machine::series::Mode;
use crate::message::Message;
use crate::run::Outcome;
use crate::series::capability::Capability;
use crate::series::draw;
use crate::series::spread::Spread;
pub(in crate::app) use asked::prepared;
pub use asked::{Prepared, SeriesExample, SeriesName, SeriesRequest, SeriesStart, series_of, series_start};
use collect::Collected;
pub use offered::{SeriesFollow, SeriesPreset};
use serde::Serialize;

/// How the results of a program spread over many runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesView {
    /// How many runs.
    pub runs: u32,
    /// Seed of all random numbers: the same seed gives the same results.
    pub seed: u64,
    /// Whether a run found what the one before it left.
    pub mode: Mode,
    /// How many runs reached the end of the program.
    pub finished: usize,
    /// The measuring calls, in order.
    pub calls: Vec<SeriesCall>,
    /// How many of them are listed, where the program has more.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub more: Option<Message>,
    /// Alarms and operator messages, each with the share of the runs in which it came.
    pub alarms: Vec<SeriesAlarm>,
}

/// A measuring call over all runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesCall {
    /// Which call.
    #[serde(flatten)]
    pub call: OfCall,
    /// What is measured, in words.
    pub feature: Message,
    /// What was measured, the most important first.
    pub measured: Vec<SeriesFigure>,
    /// What was corrected.
    pub corrected: Vec<SeriesCorrection>,
    /// What followed, with the share of the runs.
    pub verdicts: Vec<SeriesShare>,
    /// In production: what would have followed had no part been corrected.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<SeriesShare>>"))]
    pub uncorrected: Vec<SeriesShare>,
    /// Weight of its mean value, where it keeps one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weight: Option<SeriesWeight>,
    /// Mean and empirical value after each run, where the call has a memory for them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<SeriesMemory>>"))]
    pub memories: Vec<SeriesMemory>,
}

/// The weight with which a call forms its mean value (B:1244-1263).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SeriesWeight {
    /// The parameter that has it.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
}

/// A memory of the control over the first runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SeriesMemory {
    /// As a program would name it: `_MV[0]`.
    pub name: String,
    /// Whether it is a mean value, else an empirical value.
    pub mean: bool,
    /// Unit of the call.
    pub unit: &'static str,
    /// Its value after each of the first 1000 runs, in that unit.
    pub course: Vec<f64>,
}

/// Share of the runs in which something happened.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesShare {
    /// What.
    pub verdict: Verdict,
    /// In words.
    pub words: Message,
    /// In how many runs.
    pub count: usize,
    /// Share of all runs.
    pub share: f64,
    /// Standard error of this share; of all or none of the runs: how much it may be off with 95 % confidence.
    pub error: f64,
    /// Count and share in words, with no more digits than are certain.
    pub told: Message,
}

/// Numbers and how they are spread.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct SeriesSpread {
    /// How many.
    pub count: usize,
    /// Mean.
    pub mean: f64,
    /// Its standard error.
    pub mean_error: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Its standard error.
    pub deviation_error: f64,
    /// The smallest.
    pub min: f64,
    /// 2.5 % are smaller.
    pub low: f64,
    /// Half are smaller.
    pub median: f64,
    /// 2.5 % are larger.
    pub high: f64,
    /// The largest.
    pub max: f64,
}

/// A quantity over all runs, in its unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesFigure {
    /// The result that has its actual value: `_OVR[4]`.
    pub name: &'static str,
    /// Meaning of the result.
    pub label: Message,
    /// Unit at the call.
    pub unit: &'static str,
    /// Its actual values.
    #[serde(flatten)]
    pub spread: SeriesSpread,
    /// How many lie in each of 20 intervals from the smallest to the largest.
    pub histogram: Vec<usize>,
    /// Smallest and largest deviation that is permitted; absent: nothing limits it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<[f64; 2]>,
    /// How well the values hold these limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub capability: Option<Capability>,
    /// Setpoint at the call; absent: there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<f64>,
    /// The actual value in each of the first 1000 runs; null: nothing was measured.
    pub course: Vec<Option<f64>>,
    /// The actual value of each run, not a number where there is none. They are in the table only.
    #[serde(skip)]
    #[cfg_attr(test, ts(skip))]
    pub values: Vec<f64>,
}

/// A datum that was corrected.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesCorrection {
    /// Frame, tool or register.
    pub target: Message,
    /// Axis, length or radius: `X`, `L1`, `R`.
    pub part: String,
    /// Unit of the correction.
    pub unit: &'static str,
    /// By how much, in the runs in which it was corrected.
    #[serde(flatten)]
    pub spread: SeriesSpread,
    /// By how much in each of the first 1000 runs; 0: not at all.
    pub course: Vec<f64>,
}

/// An alarm over all runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesAlarm {
    /// The alarm, or why a run went no further.
    #[serde(flatten)]
    pub raised: Raised,
    /// In how many runs it came.
    pub count: usize,
    /// Share of all runs.
    pub share: f64,
    /// Standard error of this share; of all or none of the runs: how much it may be off with 95 % confidence.
    pub error: f64,
    /// Count and share in words, with no more digits than are certain.
    pub told: Message,
}

impl From<&Spread> for SeriesSpread {
    fn from(spread: &Spread) -> SeriesSpread {
        SeriesSpread {
            count: spread.count(),
            mean: spread.mean,
            mean_error: spread.mean_error(),
            deviation: spread.deviation,
            deviation_error: spread.deviation_error,
            min: spread.quantile(0.0),
            low: spread.quantile(0.025),
            median: spread.quantile(0.5),
            high: spread.quantile(0.975),
            max: spread.quantile(1.0),
        }
    }
}

/// Work in blocks after which a run is given up.
const WORK: u64 = 100_000;

/// In how many runs something happened, with no more digits than are certain: two behind the point at most.
fn share_told(count: usize, share: f64, error: f64) -> Message {
    let [share, error] = [share, error].map(|part| 100.0 * part);
    let digits = if error > 0.0 { (-error.log10().floor()).clamp(0.0, 2.0) as i32 } else { 0 };
    let step = 10f64.powi(-digits);
    let round = |value: f64| (value / step).round() * step;
    let tidy = |value: f64| (value * 100.0).round() / 100.0;
    let message = |key: &'static str| Message::new(key).number("count", count as f64);
    if share >= 100.0 {
        return message("series-share-all").number("least", tidy(((100.0 - error) / step).floor() * step));
    }
    message("series-share").number("share", tidy(round(share))).number("error", tidy(round(error).max(step)))
}

/// First runs whose values are told one by one.
const COURSE: usize = 1000;

/// Runs a program as often as its machine says. `told`: hears which share is done.
///
/// A run that is given up ends the series: the others would take as long, and tell nothing.
pub fn series(prepared: &Prepared, told: &mut dyn FnMut(f64)) -> SeriesView {
    let setup = &prepared.setup;
    let mut collected = Collected::default();
    let mut done = 0.0;
    let passes = if setup.series.mode == Mode::Production { 2.0 } else { 1.0 };
    let all = passes * f64::from(setup.series.runs.max(1));
    let mut further = || {
        done += 1.0;
        told(done / all);
    };
    each(prepared, setup.series.mode, &mut |outcome| {
        further();
        collected.add(setup, outcome)
    });
    let mut view = collected.view(&setup.series);
    if setup.series.mode == Mode::Production {
        let mut without = Collected::default();
        each(prepared, Mode::Independent, &mut |outcome| {
            further();
            without.add(setup, outcome)
        });
        let others = without.view(&setup.series).calls.into_iter().map(|other| (other.call, other.verdicts));
        let mut others = by_occurrence(others);
        let mut came = Occurrences::default();
        for call in &mut view.calls {
            call.uncorrected = others.remove(&came.next(call.call)).unwrap_or_default();
        }
    }
    view
}

/// Carries out all runs in order until one is not to be followed by another.
fn each(prepared: &Prepared, mode: Mode, take: &mut dyn FnMut(&Outcome) -> bool) {
    let setup = &prepared.setup;
    let mut left: Option<Control> = None;
    for run in 0..setup.series.runs {
        let outcome = prepared.run(&draw::machine(setup, &setup.series, run, left.as_ref()));
        if !take(&outcome) {
            return;
        }
        left = (mode == Mode::Production).then_some(outcome.control);
    }
}

/// The runs as a table: a line for each, a column for each quantity. Decimal points, so that any program reads it.
pub fn series_csv(view: &SeriesView) -> String {
    let figures = || view.calls.iter().flat_map(|call| call.measured.iter().map(move |figure| (call, figure)));
    let head = figures().map(|(call, figure)| {
        let line = call.call.line.map_or(String::new(), |line| line.to_string());
        format!(",\"{line} {} {} {}\"", call.call.cycle.unwrap_or_default(), figure.name, figure.unit)
    });
    let mut text = format!("run{}\n", head.collect::<String>());
    let runs = figures().map(|(_, figure)| figure.values.len()).max().unwrap_or(0);
    for run in 0..runs {
        let value = |figure: &SeriesFigure| figure.values.get(run).copied().filter(|value| value.is_finite());
        let cells = figures().map(|(_, figure)| value(figure).map_or(",".to_owned(), |value| format!(",{value}")));
        text += &format!("{}{}\n", run + 1, cells.collect::<String>());
    }
    text
}
