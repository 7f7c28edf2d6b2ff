//! How certain a measurement is: the same call, or the same program, many times on a part and with a probe that spread,
//! and what a measured value proves then.

mod causes;
mod whole;

use super::Error;
use super::answer::{Answer, Figure, inside};
use super::form::{FormRequest, form};
use crate::entry::Inputs;
use crate::message::Message;
use crate::run;
use crate::scene::Source;
use crate::series::decide::{COVERAGE, Limits, Proof, guard};
use crate::series::spread::Spread;
use causes::{Cause, Draws};
use serde::{Deserialize, Serialize};
pub use whole::{CallCertainty, WholeCertainty, WholeCertaintyRequest, certainty_of, whole_certainty};

/// What is asked.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct CertaintyRequest {
    /// The form, with its machine and the errors of part and probe.
    pub form: FormRequest,
    /// How many measurements, up to 10 000; absent: 1000.
    pub runs: Option<u32>,
    /// Seed of all random numbers; absent: that of the machine's series.
    pub seed: Option<u64>,
}

/// How certain a measurement is.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CertaintyView {
    /// How many measurements; 0: nothing spreads, or nothing is measured.
    pub runs: u32,
    /// Share of them that did not come to an end.
    pub stopped: f64,
    /// What was measured, the most important first.
    pub figures: Vec<Certain>,
}

/// A quantity and how certain it is, in its unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Certain {
    /// The result that has its actual value: `_OVR[4]`.
    pub name: &'static str,
    /// Meaning of the result.
    pub label: Message,
    /// What stands before its value: `Ø`, `X`; empty: nothing.
    pub symbol: String,
    /// Unit at the call.
    pub unit: &'static str,
    /// As measured.
    pub value: f64,
    /// Expanded uncertainty U = k·u, rounded up to two digits.
    pub expanded: f64,
    /// Decimal places with which value and U are told.
    pub decimals: u32,
    /// Coverage factor k.
    pub coverage: f64,
    /// What the value proves about its limits; absent: nothing limits it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
    /// The same as chances of the part at hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chances: Option<CertainChances>,
    /// What makes how much of the uncertainty, the largest first.
    pub budget: Vec<Contribution>,
}

/// Chances of a part, together 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CertainChances {
    /// Within the limits.
    pub good: f64,
    /// Beyond, metal is left.
    pub rework: f64,
    /// Beyond, metal is missing.
    pub scrap: f64,
    /// Beyond, of what can be neither.
    pub beyond: f64,
}

/// A part of an uncertainty.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Contribution {
    /// What it comes from.
    pub source: Message,
    /// Share of the square of the uncertainty.
    pub share: f64,
}

/// Most measurements of one question.
const MOST: u32 = 10_000;
/// Fewest measurements of which a contribution is told.
const FEWEST: u32 = 200;
/// Part of the measurements that each source alone gets.
const ALONE: u32 = 4;

/// How many measurements each source alone gets, of this many.
fn alone(runs: u32) -> u32 {
    (runs / ALONE).max(FEWEST).min(runs)
}

/// Measures what a form measures many times.
///
/// # Errors
/// Those of the form.
pub fn certainty(asked: CertaintyRequest) -> Result<CertaintyView, Error> {
    let asked_form = FormRequest { predict: true, limits: false, twin: false, comments: None, ..asked.form };
    let Some(outcome) = form(asked_form)?.outcome else { return Ok(CertaintyView::default()) };
    let (Some(answer), Source { setup, call: Some(inputs), outcome, .. }) = (outcome.answer, outcome.trace) else {
        return Ok(CertaintyView::default());
    };
    let draws = Draws { setup: &setup, seed: asked.seed.unwrap_or(setup.series.seed) };
    let causes: Vec<Cause> = draws.causes().into_iter().filter(|cause| cause.concerns(&inputs, &setup)).collect();
    if causes.is_empty() || !outcome.finished() {
        return Ok(CertaintyView::default());
    }
    let runs = asked.runs.unwrap_or(1000).clamp(1, MOST);
    let spread = |causes: &[Cause], runs| spreads(&draws, &inputs, &answer.figures, causes, runs);
    let all = spread(&causes, runs);
    let each: Vec<Vec<Spread>> = match causes.len() {
        1 => vec![all.clone()],
        _ => causes.iter().map(|cause| spread(&[*cause], alone(runs))).collect(),
    };
    let figures = answer.figures.iter().enumerate().filter_map(|(at, figure)| {
        let parts: Vec<f64> = each.iter().map(|spreads| spreads[at].deviation.powi(2)).collect();
        certain(figure, &answer, &inputs, all[at].deviation, budget(&causes, &parts))
    });
    let ended = all.iter().map(Spread::count).max().unwrap_or(0);
    Ok(CertaintyView { runs, stopped: 1.0 - ended as f64 / f64::from(runs), figures: figures.collect() })
}

/// How each quantity of a call spreads by these causes.
fn spreads(draws: &Draws, inputs: &Inputs, figures: &[Figure], causes: &[Cause], runs: u32) -> Vec<Spread> {
    let mut values = vec![Vec::with_capacity(runs as usize); figures.len()];
    for run in 0..runs {
        let outcome = run::predict(inputs.cycle, inputs, &draws.drawn(causes, run));
        if !outcome.finished() {
            continue;
        }
        let growth = draws.growth(causes, run);
        for (figure, values) in figures.iter().zip(&mut values) {
            values.push(grown(figure, outcome.control.number(figure.name), growth));
        }
    }
    values.into_iter().map(Spread::of).collect()
}

/// A value of a part that is so much larger than at the reference temperature.
fn grown(figure: &Figure, value: f64, growth: f64) -> f64 {
    if figure.unit == "deg" { value } else { value * growth }
}

/// The quantity with its uncertainty; none where it does not spread.
fn certain(
    figure: &Figure,
    answer: &Answer,
    inputs: &Inputs,
    uncertainty: f64,
    budget: Vec<Contribution>,
) -> Option<Certain> {
    if uncertainty <= 0.0 {
        return None;
    }
    let (expanded, decimals) = rounded_up(COVERAGE * uncertainty);
    let limits = figure.limits.map(|limits| Limits { low: limits.low, high: limits.high });
    let deviation = watched(figure, answer);
    let judged = limits.zip(deviation);
    Some(Certain {
        name: figure.name,
        label: figure.label.clone(),
        symbol: figure.symbol.clone(),
        unit: figure.unit,
        value: figure.actual,
        expanded,
        decimals,
        coverage: COVERAGE,
        proof: judged.map(|(limits, value)| limits.proof(value, guard(uncertainty))),
        chances: judged.map(|(limits, value)| {
            let chances = limits.chances(value, uncertainty);
            let [rework, scrap, beyond] = match inside(inputs) {
                Some(true) => [chances.low, chances.high, 0.0],
                Some(false) => [chances.high, chances.low, 0.0],
                None => [0.0, 0.0, chances.low + chances.high],
            };
            CertainChances { good: chances.good, rework, scrap, beyond }
        }),
        budget,
    })
}

/// The deviation that the limits watch, empirical value included.
fn watched(figure: &Figure, answer: &Answer) -> Option<f64> {
    let needles = &answer.gauge.as_ref()?.needles;
    let needle = needles.iter().find(|one| one.label.is_empty() || one.label == figure.symbol);
    needle.map(|one| one.value).or(figure.deviation)
}

/// What makes how much, the largest first.
fn budget(causes: &[Cause], squares: &[f64]) -> Vec<Contribution> {
    let sum: f64 = squares.iter().sum();
    let part = |(cause, square): (&Cause, &f64)| {
        let share = if sum > 0.0 { square / sum } else { 0.0 };
        Contribution { source: Message::new(cause.key()), share }
    };
    let mut parts: Vec<Contribution> = causes.iter().zip(squares).map(part).collect();
    parts.sort_by(|a, b| b.share.total_cmp(&a.share));
    parts
}

/// Rounded up to two digits, and the decimal places that they need (JCGM 100, 7.2.6: two digits at most).
fn rounded_up(value: f64) -> (f64, u32) {
    let decimals = (1.0 - value.log10().floor()).clamp(0.0, 12.0);
    let scale = 10f64.powf(decimals);
    ((value * scale - 1e-9).ceil() / scale, decimals as u32)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A hole of 50 mm measured with this repeatability, its size off by this much.
    fn hole(repeatability: f64, size: f64, out_of_round: f64) -> CertaintyView {
        let asked = format!(
            r#"{{ "control": "sinumerik", "cycle": "CYCLE977", "values": {{ "_MVAR": "1", "_SETVAL": "50",
            "_KNUM": "0", "_PRNUM": "1", "_FA": "2", "_TSA": "1", "_TUL": "0.02", "_TLL": "-0.02", "_TMV": "0.01",
            "_TDIF": "0.5", "_TZL": "0", "_K": "1", "_EVNUM": "0", "_NMSP": "1", "_VMS": "0", "_TNUM": "20" }},
            "errors": {{ "part": {{ "size": {size}, "outOfRound": {out_of_round} }},
            "probe": {{ "repeatability": {repeatability} }} }} }}"#
        );
        let form: FormRequest = crate::json::question(&asked).unwrap();
        certainty(CertaintyRequest { form, runs: Some(1000), seed: None }).unwrap()
    }

    // oracle: JCGM 100, eq. 10: two touches and two of the calibration, each with σ: √(2σ² + 2σ²) = 2σ, half of it each
    #[test]
    fn a_hole_is_as_certain_as_touches_and_calibration() {
        let view = hole(0.001, 0.0, 0.0);
        let size = &view.figures[0];
        assert_eq!((size.symbol.as_str(), size.unit, view.stopped), ("Ø", "mm", 0.0));
        assert!((size.expanded / 0.004 - 1.0).abs() < 4.0 / 2000f64.sqrt() + 0.025, "{size:?}");
        assert_eq!((size.decimals, size.proof), (4, Some(Proof::Good)));
        assert!(size.budget.len() == 2 && size.budget.iter().all(|one| (one.share - 0.5).abs() < 0.2), "{size:?}");
        assert_eq!(hole(0.001, 0.0, 0.0), view, "the same seed gives the same answer");
    }

    // oracle: hand: on the limit a part is good with one half, and too large a hole is scrap
    #[test]
    fn on_the_limit_nothing_is_proved() {
        let size = hole(0.0001, 0.02, 0.0).figures.remove(0);
        let chances = size.chances.unwrap();
        assert_eq!(size.proof, Some(Proof::Undecided));
        assert!(chances.good > 0.01 && chances.scrap > 0.01 && chances.rework < 1e-6, "{chances:?}");
        assert_eq!(hole(0.0001, 0.04, 0.0).figures[0].proof, Some(Proof::Bad));
        assert!(hole(0.0001, -0.04, 0.0).figures[0].chances.unwrap().rework > 0.99);
    }

    // oracle: definition; JCGM 100, H.1: lobes at an unknown place are an arc sine of deviation a/√2, and each touch of
    // the two has its own: the opposite one the other sign, so that a diameter does not see three lobes
    #[test]
    fn what_spreads_is_named() {
        assert_eq!(hole(0.0, 0.01, 0.0), CertaintyView::default());
        let view = hole(0.001, 0.0, 0.005);
        assert_eq!(view.figures[0].budget.len(), 3);
        let form = view.figures[0].budget.iter().find(|one| one.source.key == "certainty-form").unwrap();
        assert!(form.share < 0.05, "{view:?}");
    }

    // oracle: hand
    #[test]
    fn an_uncertainty_has_two_digits_rounded_up() {
        assert_eq!(rounded_up(0.001_234), (0.0013, 4));
        assert_eq!(rounded_up(0.004), (0.0040, 4));
        assert_eq!(rounded_up(1.01), (1.1, 1));
        assert_eq!(rounded_up(123.4), (124.0, 0));
    }
}
