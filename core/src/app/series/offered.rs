//! What a series can begin with, from the program itself: how its corrections reach the next part, the wear of the
//! tools that it corrects, a part that gets warm.

use super::Prepared;
use crate::app::answer::corrected_data;
use crate::entry::{Inputs, names};
use crate::evaluate::mean;
use crate::machine::Setup;
use crate::machine::series::{Per, Shape, Vary};
use crate::message::Message;
use crate::run::Outcome;
use crate::series::draw::{WARMTH, varied, worn_by};
use serde::Serialize;
use std::collections::BTreeMap;

/// A correction that reaches the next part.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SeriesFollow {
    /// What it changes: name of a variation.
    pub what: String,
    /// The datum that is corrected: `$TC_DP15[20,1]`.
    pub variable: String,
    /// What one unit more of it adds there.
    pub factor: f64,
    /// Frame, tool or register.
    pub target: Message,
    /// Axis, length or radius: `X`, `L1`, `R`.
    pub part: String,
}

/// A variation that is complete.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SeriesPreset {
    /// What it is, in words.
    pub label: Message,
    /// The correction that it belongs to; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of: Option<SeriesFollow>,
    /// Which part of those on the machine, from 1; absent: all of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<usize>,
    /// The variation.
    pub vary: Vary,
}

/// Parts of which this is asked: each takes six runs.
const PARTS: usize = 4;
/// Entries of a run that is short enough to be made so often.
const SHORT: usize = 5000;
/// Errors with which it is tried whether they are corrected, mm: a limit may be below or above them.
const ERRORS: [f64; 3] = [0.02, 0.1, 0.005];
/// Factors of a radius, of a length, of a diameter; what comes near one of them is that one.
const USUAL: [f64; 3] = [0.5, 1.0, 2.0];
/// Near, as a share.
const NEAR: f64 = 0.3;
/// Wear of a tool from part to part that a preset begins with, mm.
const WEAR: f64 = 0.0005;
/// By how much a part gets warmer from the one before it that a preset begins with, K.
const WARMER: f64 = 0.1;

/// What can be offered for this program on this machine.
pub fn offered(prepared: &Prepared) -> (Vec<SeriesFollow>, Vec<SeriesPreset>) {
    let follows = follows(prepared);
    let mut presets = Vec::new();
    for at in 0..prepared.setup.workpiece.solids.len().min(PARTS) {
        let size = size(at);
        let worn: Vec<SeriesPreset> = follows.iter().filter(|one| one.what == size).map(|one| worn(at, one)).collect();
        if let (true, Some(by)) = (worn.is_empty(), worn_by(&prepared.setup, at)) {
            let label = Message::new("series-wear");
            let vary = drifting(size, by * WEAR, BTreeMap::new());
            presets.push(SeriesPreset { label, of: None, part: Some(at + 1), vary });
        }
        presets.extend(worn);
    }
    if !prepared.setup.workpiece.solids.is_empty() {
        let vary = drifting(WARMTH.to_owned(), WARMER, BTreeMap::new());
        presets.push(SeriesPreset { label: Message::new("series-warms"), of: None, part: None, vary });
    }
    (follows, presets)
}

/// The tool that is corrected loses as much from part to part, and its corrections reach the next part: a tool that is
/// smaller leaves what one leaves that is taken for a larger one.
fn worn(at: usize, follow: &SeriesFollow) -> SeriesPreset {
    let follows = BTreeMap::from([(follow.variable.clone(), follow.factor)]);
    let vary = drifting(follow.what.clone(), follow.factor * WEAR, follows);
    SeriesPreset { label: Message::new("series-wear"), of: Some(follow.clone()), part: Some(at + 1), vary }
}

fn drifting(what: String, drift: f64, follows: BTreeMap<String, f64>) -> Vary {
    let (shape, per, values) = (Shape::Normal, Per::Part, Vec::new());
    Vary { what, shape, sigma: 0.0, half: 0.0, mean: 0.0, drift, per, values, follows }
}

fn size(at: usize) -> String {
    format!("workpiece[{at}].errors.size")
}

/// The corrections of a program, each with what it changes on the next part: found by running it on parts with errors.
fn follows(prepared: &Prepared) -> Vec<SeriesFollow> {
    let base = prepared.run(&prepared.setup);
    if base.called.is_empty() || base.trace.entries.len() > SHORT {
        return Vec::new();
    }
    let before = written(&prepared.setup, &base);
    let mut all: Vec<SeriesFollow> = Vec::new();
    for at in 0..prepared.setup.workpiece.solids.len().min(PARTS) {
        let shifts = (0..3).map(|axis| format!("workpiece[{at}].errors.shift[{axis}]"));
        for (axis, what) in std::iter::once(size(at)).chain(shifts).enumerate() {
            let errors = if axis == 0 { &ERRORS[..] } else { &ERRORS[..1] };
            let found = errors.iter().map(|error| tried(prepared, &before, &what, *error, axis.checked_sub(1)));
            let found = found.into_iter().find(|found| !found.is_empty()).unwrap_or_default();
            for one in found {
                if !all.iter().any(|known| (&known.what, &known.variable) == (&one.what, &one.variable)) {
                    all.push(one);
                }
            }
        }
    }
    all
}

/// What a part with this error is corrected by, more than one without it.
fn tried(
    prepared: &Prepared,
    before: &BTreeMap<String, Written>,
    what: &str,
    error: f64,
    axis: Option<usize>,
) -> Vec<SeriesFollow> {
    let Some(setup) = varied(&prepared.setup, what, error) else { return Vec::new() };
    let after = written(&setup, &prepared.run(&setup));
    let one = |(variable, written): (String, Written)| {
        let by = written.by - before.get(&variable).map_or(0.0, |before| before.by);
        let factor = match axis {
            _ if by.abs() < 1e-9 => return None,
            // what is made in a frame moves with it
            Some(axis) if written.frame => (written.axis == Some(axis)).then_some(1.0)?,
            None if written.frame => return None,
            _ => usual(-error / (by * written.weight)),
        };
        let Written { target, part, .. } = written;
        Some(SeriesFollow { what: what.to_owned(), variable, factor, target, part })
    };
    after.into_iter().filter_map(one).collect()
}

/// A usual factor where it is near one.
fn usual(factor: f64) -> f64 {
    let near = |usual: &&f64| (factor.abs() / **usual - 1.0).abs() < NEAR;
    let found = USUAL.iter().find(near).map(|usual| usual.copysign(factor));
    found.unwrap_or((factor * 1000.0).round() / 1000.0)
}

/// A datum that the calls of a run correct.
struct Written {
    by: f64,
    frame: bool,
    axis: Option<usize>,
    /// Weight of the mean value: only one part in so many is corrected at once (B:1244-1263).
    weight: f64,
    target: Message,
    part: String,
}

fn written(setup: &Setup, outcome: &Outcome) -> BTreeMap<String, Written> {
    let mut all: BTreeMap<String, Written> = BTreeMap::new();
    for called in &outcome.called {
        let (entries, _) = called.entries(outcome);
        for one in corrected_data(&entries, &setup.control) {
            let axis = ["X", "Y", "Z"].iter().position(|axis| *axis == one.part);
            let (frame, target, part) = (one.frame, one.target, one.part);
            let fresh = Written { by: 0.0, frame, axis, weight: weight(&called.inputs), target, part };
            all.entry(one.variable).or_insert(fresh).by += one.by;
        }
    }
    all
}

/// The weight of a call that keeps a mean value, else 1.
fn weight(inputs: &Inputs) -> f64 {
    let kept = mean::memories(inputs.any(names::EVNUM).unwrap_or(0.0) as i64).mean > 0;
    if kept { inputs.any(names::K).filter(|weight| *weight >= 1.0).unwrap_or(1.0) } else { 1.0 }
}
