//! How certain each measurement of a program is: the program many times.

use super::{Certain, Draws, MOST, Spread, alone, budget, causes::Cause, certain, grown};
use crate::app::answer::Figure;
use crate::app::beside::Beside;
use crate::app::run::{Occurrences, OfCall, RunAnswer, answers, by_occurrence};
use crate::app::series::{Prepared, SeriesRequest, prepared};
use crate::app::start::Machine;
use crate::app::{Error, ProgramText};
use crate::dialect::Dialect;
use crate::entry::Inputs;
use crate::machine::Setup;
use crate::message::Message;
use crate::run::Outcome;
use serde::{Deserialize, Serialize};

/// A program whose measurements are to be judged.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct WholeCertaintyRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Which program of the text is run, by its name; absent: the first.
    pub program: Option<String>,
    /// Files beside the program; absent: none.
    pub with: Option<Vec<Beside>>,
    /// How many runs, up to 10 000; absent: 400.
    pub runs: Option<u32>,
    /// Seed of all random numbers; absent: that of the machine's series.
    pub seed: Option<u64>,
}

/// How certain the measurements of a program are.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct WholeCertainty {
    /// How many runs; 0: nothing is known.
    pub runs: u32,
    /// Why nothing is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nothing: Option<Message>,
    /// Share of them that did not come to the end.
    pub stopped: f64,
    /// For each measuring call of the run, in order.
    pub calls: Vec<CallCertainty>,
}

/// A call and how certain it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct CallCertainty {
    /// Which call.
    #[serde(flatten)]
    pub call: OfCall,
    /// What it measures, as far as it spreads.
    pub figures: Vec<Certain>,
}

/// Runs whose share of good parts is right to some percent.
const RUNS: u32 = 400;

/// Carries out a program many times. `told`: hears which share is done.
///
/// # Errors
/// The machine cannot be.
pub fn certainty_of(asked: WholeCertaintyRequest, told: &mut dyn FnMut(f64)) -> Result<WholeCertainty, Error> {
    let WholeCertaintyRequest { control, text, setup, program, with, runs, seed } = asked;
    let request = SeriesRequest { control, text, setup, program, with, series: None, example: None };
    Ok(whole_certainty(&prepared(request)?, runs, seed, told))
}

/// Carries out a program as often, 400 times where that is absent. `seed`: absent that of its machine; `told`: hears
/// which share is done.
pub fn whole_certainty(
    prepared: &Prepared,
    runs: Option<u32>,
    seed: Option<u64>,
    told: &mut dyn FnMut(f64),
) -> WholeCertainty {
    let setup = &prepared.setup;
    let once = |machine: &Setup| prepared.run(machine);
    let outcome = once(setup);
    let known = answers(setup, &outcome);
    let draws = Draws { setup, seed: seed.unwrap_or(setup.series.seed) };
    let causes = draws.causes();
    let nothing = nothing(&outcome, &known, &causes);
    let runs = if nothing.is_some() { 0 } else { runs.unwrap_or(RUNS).clamp(1, MOST) };
    // what a calibration finds does not depend on the one before it
    let is_anew = |inputs: &Inputs| causes.contains(&Cause::Calibration) && !Cause::Calibration.concerns(inputs, setup);
    let anew = outcome.called.iter().any(|called| is_anew(&called.inputs));
    let each = if causes.len() > 1 { &causes[..] } else { &[] };
    let sum = runs * (1 + u32::from(anew)) + alone(runs) * each.len() as u32;
    let mut done = 0;
    let mut measure = |causes: &[Cause], runs: u32| {
        let mut measured = Measured::of(&known);
        for run in 0..runs {
            measured.add(setup, &once(&draws.drawn(causes, run)), draws.growth(causes, run));
            done += 1;
            told(f64::from(done) / f64::from(sum.max(1)));
        }
        measured
    };
    let all = measure(&causes, runs);
    let each: Vec<Measured> = each.iter().map(|cause| measure(&[*cause], alone(runs))).collect();
    let others: Vec<Cause> = causes.iter().copied().filter(|cause| *cause != Cause::Calibration).collect();
    let anew = anew.then(|| measure(&others, runs));
    let parts: Vec<(Cause, &Measured)> = match &each[..] {
        [] => causes.iter().map(|cause| (*cause, &all)).collect(),
        each => causes.iter().copied().zip(each).collect(),
    };
    let calls = known.iter().enumerate().map(|(at, one)| {
        let inputs = &outcome.called[at].inputs;
        let own: Vec<_> = parts.iter().copied().filter(|(cause, _)| cause.concerns(inputs, setup)).collect();
        let all = anew.as_ref().filter(|_| is_anew(inputs)).unwrap_or(&all);
        CallCertainty { call: one.call, figures: judged(inputs, at, one, all, &own) }
    });
    let stopped = if runs == 0 { 0.0 } else { 1.0 - f64::from(all.finished) / f64::from(runs) };
    WholeCertainty { runs, nothing, stopped, calls: calls.collect() }
}

/// Why nothing can be known of the certainty of a program.
fn nothing(outcome: &Outcome, known: &[RunAnswer], causes: &[Cause]) -> Option<Message> {
    match outcome.given_up() {
        Some(why) => Some(why.clone()),
        None if known.is_empty() => Some(Message::new("certainty-no-call")),
        None => causes.is_empty().then(|| Message::new("certainty-nothing")),
    }
}

/// What the figures of one call prove. `each`: what spreads it, with what was measured with that alone.
fn judged(
    inputs: &Inputs,
    at: usize,
    RunAnswer { answer, .. }: &RunAnswer,
    all: &Measured,
    each: &[(Cause, &Measured)],
) -> Vec<Certain> {
    let deviation = |measured: &Measured, figure: usize| Spread::of(measured.values[at][figure].clone()).deviation;
    let causes: Vec<Cause> = each.iter().map(|(cause, _)| *cause).collect();
    let figures = answer.figures.iter().enumerate().filter_map(|(figure, shown)| {
        let parts: Vec<f64> = each.iter().map(|(_, measured)| deviation(measured, figure).powi(2)).collect();
        certain(shown, answer, inputs, deviation(all, figure), budget(&causes, &parts))
    });
    figures.collect()
}

/// What was measured over all runs, by call and figure.
struct Measured<'a> {
    known: &'a [RunAnswer],
    values: Vec<Vec<Vec<f64>>>,
    finished: u32,
}

impl<'a> Measured<'a> {
    fn of(known: &'a [RunAnswer]) -> Measured<'a> {
        let values = known.iter().map(|one| vec![Vec::new(); one.answer.figures.len()]).collect();
        Measured { known, values, finished: 0 }
    }

    /// Takes a run: a call counts where it came as often before.
    fn add(&mut self, setup: &Setup, outcome: &Outcome, growth: f64) {
        self.finished += u32::from(outcome.finished());
        let mut now = by_occurrence(answers(setup, outcome).into_iter().map(|one| (one.call, one)));
        let mut came = Occurrences::default();
        for (known, values) in self.known.iter().zip(&mut self.values) {
            let Some(now) = now.remove(&came.next(known.call)) else { continue };
            let of = |shown: &Figure| now.answer.figures.iter().find(|one| one.name == shown.name);
            for (shown, values) in known.answer.figures.iter().zip(values) {
                values.extend(of(shown).map(|one| grown(one, one.actual, growth)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::Plane;
    use crate::geometry::Mcs;
    use crate::series::decide::Proof;
    use crate::syntax::read;
    use crate::workpiece::{Shape, Solid};

    /// Two holes of 50 mm, 100 mm apart; the second is 0.018 mm too large.
    fn two_holes(change: impl Fn(&mut Setup)) -> WholeCertainty {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        for (x, size) in [(0.0, 0.0), (100.0, 0.018)] {
            let mut hole = Solid::new(Shape::Hole { diameter: 50.0, depth: 30.0 }, Mcs([x, 0.0, 0.0]));
            hole.errors.size = size;
            setup.workpiece.solids.push(hole);
        }
        change(&mut setup);
        let call = "_MVAR=1 _SETVAL=50 _KNUM=0\nCYCLE977\n";
        let text = format!(
            "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_TUL=0.02 _TLL=-0.02 _TSA=1 _FA=2 _PRNUM=1\n{call}Z50\nX100\nZ-10\n\
             {call}M30\n"
        );
        let program = read(Dialect::Sinumerik, text.as_bytes()).into();
        whole_certainty(&Prepared { setup, program, main: None }, Some(1000), None, &mut |_| {})
    }

    // oracle: JCGM 100, eq. 10: as for a form, two touches and two of the calibration: u = 2σ; JCGM 106, 7.3: 2 µm from
    // its limit the second proves nothing
    #[test]
    fn each_call_of_a_program_is_as_certain_as_its_touches() {
        let view = two_holes(|setup| setup.probe.repeatability.0 = 0.001);
        assert_eq!((view.runs, view.stopped, view.calls.len()), (1000, 0.0, 2));
        for (call, line) in view.calls.iter().zip([6, 11]) {
            assert_eq!((call.call.line, call.call.cycle), (Some(line), Some("CYCLE977")));
            let size = &call.figures[0];
            assert!((size.expanded / 0.004 - 1.0).abs() < 4.0 / 2000f64.sqrt() + 0.025, "{size:?}");
            assert!(size.budget.len() == 2 && size.budget.iter().all(|one| (one.share - 0.5).abs() < 0.2), "{size:?}");
        }
        let proof = |call: usize| view.calls[call].figures[0].proof;
        assert_eq!((proof(0), proof(1)), (Some(Proof::Good), Some(Proof::Undecided)));
    }

    // oracle: hand (a trigger value of one touch: u = σ; of four touches the mean: σ/2; the calibration before is no
    // part of it): U = 2σ, σ
    #[test]
    fn a_calibration_is_as_certain_as_its_own_touches() {
        for (count, expanded) in [(1, 0.004), (4, 0.002)] {
            let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
            setup.probe.repeatability.0 = 0.002;
            let ring = Solid::new(Shape::Hole { diameter: 50.0, depth: 30.0 }, Mcs([0.0; 3]));
            setup.workpiece.solids.push(ring);
            let text = format!(
                "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_TSA=1 _FA=2 _PRNUM=1 _VMS=0 _NMSP={count}\n\
                 _MVAR=1 _SETVAL=50 _MA=1 _MD=0\nCYCLE976\nM30\n"
            );
            let program = read(Dialect::Sinumerik, text.as_bytes()).into();
            let view = whole_certainty(&Prepared { setup, program, main: None }, Some(400), None, &mut |_| {});
            assert_eq!((view.stopped, view.calls.len()), (0.0, 1), "{view:?}");
            let trigger = &view.calls[0].figures[0];
            assert!((trigger.expanded / expanded - 1.0).abs() < 0.15, "{count}: {trigger:?}");
            assert!(trigger.budget.iter().all(|one| one.source.key == "certainty-touch"), "{trigger:?}");
        }
    }

    // oracle: hand: u = 50 mm · 11.5 µm/(m·K) · 2 K = 1.15 µm
    #[test]
    fn a_warm_part_is_larger() {
        let view = two_holes(|setup| setup.temperature.spread = 2.0);
        let size = &view.calls[0].figures[0];
        assert!((size.expanded / 0.0023 - 1.0).abs() < 4.0 / 2000f64.sqrt() + 0.05, "{size:?}");
        assert_eq!(size.budget[0].source.key, "certainty-temperature");
        let nothing = two_holes(|_| ()).nothing.unwrap();
        assert_eq!(nothing.key, "certainty-nothing");
    }
}
