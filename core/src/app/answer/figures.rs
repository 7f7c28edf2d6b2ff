//! What was measured: actual value, setpoint and deviation of each quantity, as the results of the call have them.

use super::gauge::Limited;
use super::{axes, element};
use crate::entry::{Element, Inputs, ResultField, names};
use crate::machine::{Entry, Step};
use crate::message::Message;
use crate::run::called::Called;
use serde::Serialize;
use std::collections::BTreeMap;

/// A quantity that was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Figure {
    /// The result that has its actual value: `_OVR[4]`.
    pub name: &'static str,
    /// Meaning of the result.
    pub label: Message,
    /// Sort of the quantity in a word or two.
    pub heading: Message,
    /// What stands before its value: `Ø`, `X`, `L1`; empty: nothing.
    pub symbol: String,
    /// As measured, in its unit.
    pub actual: f64,
    /// As it should be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<f64>,
    /// Actual minus set; of a calibration, new minus stored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<f64>,
    /// Unit at the call.
    pub unit: &'static str,
    /// Its tolerance; absent: it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Limited>,
}

/// Sort of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    /// Diameter or width between walls.
    Size,
    /// Length of a rectangle along an axis.
    Length(usize),
    /// Diameter or radius from two points.
    Two,
    /// Diameter of a sphere.
    Sphere,
    /// Centre along an axis.
    Centre(usize),
    /// Position along the measuring axis.
    Position,
    /// Angle about an axis.
    Angle(usize),
    /// Corner along an axis.
    Corner(usize),
    /// Length of a tool.
    ToolLength(&'static str),
    /// Radius of a tool.
    ToolRadius,
    /// Diameter of a tool or ball.
    Ball,
    /// Trigger point: axis and sign.
    Trigger(usize, char),
    /// Trigger point of a geometry axis.
    TriggerOf(&'static str),
    /// Displacement of the ball.
    Skew(usize),
    /// Length of the probe.
    Probe,
    /// Any other.
    Other,
}

/// A quantity by the keys of its results: actual value, setpoint, deviation (empty: there is none).
struct Row(&'static str, &'static str, &'static str, Sort);

/// All quantities, the most important of a call first.
const ROWS: &[Row] = &[
    Row("result-actual-size", "result-set-size", "result-difference-size", Sort::Size),
    Row(
        "result-actual-length-abscissa",
        "result-set-length-abscissa",
        "result-difference-length-abscissa",
        Sort::Length(0),
    ),
    Row(
        "result-actual-length-ordinate",
        "result-set-length-ordinate",
        "result-difference-length-ordinate",
        Sort::Length(1),
    ),
    Row("result-actual-two", "result-set-two", "result-difference-two", Sort::Two),
    Row(
        "result-actual-centre-abscissa",
        "result-set-centre-abscissa",
        "result-difference-centre-abscissa",
        Sort::Centre(0),
    ),
    Row(
        "result-actual-centre-ordinate",
        "result-set-centre-ordinate",
        "result-difference-centre-ordinate",
        Sort::Centre(1),
    ),
    Row("result-actual-position", "result-set-position", "result-difference-position", Sort::Position),
    Row("result-actual-angle", "result-set-angle", "result-difference-angle", Sort::Angle(2)),
    Row(
        "result-actual-angle-abscissa",
        "result-set-angle-abscissa",
        "result-difference-angle-abscissa",
        Sort::Angle(0),
    ),
    Row(
        "result-actual-angle-ordinate",
        "result-set-angle-ordinate",
        "result-difference-angle-ordinate",
        Sort::Angle(1),
    ),
    Row(
        "result-sphere1-actual-diameter",
        "result-sphere1-set-diameter",
        "result-sphere1-difference-diameter",
        Sort::Sphere,
    ),
    Row(
        "result-sphere1-actual-abscissa",
        "result-sphere1-set-abscissa",
        "result-sphere1-difference-abscissa",
        Sort::Centre(0),
    ),
    Row(
        "result-sphere1-actual-ordinate",
        "result-sphere1-set-ordinate",
        "result-sphere1-difference-ordinate",
        Sort::Centre(1),
    ),
    Row(
        "result-sphere1-actual-applicate",
        "result-sphere1-set-applicate",
        "result-sphere1-difference-applicate",
        Sort::Centre(2),
    ),
    Row("result-sphere2-actual-diameter", "", "result-sphere2-difference-diameter", Sort::Sphere),
    Row("result-sphere2-actual-abscissa", "", "result-sphere2-difference-abscissa", Sort::Centre(0)),
    Row("result-sphere2-actual-ordinate", "", "result-sphere2-difference-ordinate", Sort::Centre(1)),
    Row("result-sphere2-actual-applicate", "", "result-sphere2-difference-applicate", Sort::Centre(2)),
    Row("result-sphere3-actual-diameter", "", "result-sphere3-difference-diameter", Sort::Sphere),
    Row("result-sphere3-actual-abscissa", "", "result-sphere3-difference-abscissa", Sort::Centre(0)),
    Row("result-sphere3-actual-ordinate", "", "result-sphere3-difference-ordinate", Sort::Centre(1)),
    Row("result-sphere3-actual-applicate", "", "result-sphere3-difference-applicate", Sort::Centre(2)),
    Row("result-corner-abscissa", "", "", Sort::Corner(0)),
    Row("result-corner-ordinate", "", "", Sort::Corner(1)),
    Row("result-edge-angle", "", "", Sort::Angle(2)),
    Row("result-actual-l1", "", "result-difference-l1", Sort::ToolLength("L1")),
    Row("result-actual-l2", "", "result-difference-l2", Sort::ToolLength("L2")),
    Row("result-actual-radius", "", "result-difference-radius", Sort::ToolRadius),
    Row("result-ball-diameter", "", "result-ball-difference", Sort::Ball),
    Row("result-probe-length", "", "", Sort::Probe),
    Row("result-trigger-minus-abscissa", "", "result-trigger-minus-abscissa-difference", Sort::Trigger(0, '−')),
    Row("result-trigger-plus-abscissa", "", "result-trigger-plus-abscissa-difference", Sort::Trigger(0, '+')),
    Row("result-trigger-minus-ordinate", "", "result-trigger-minus-ordinate-difference", Sort::Trigger(1, '−')),
    Row("result-trigger-plus-ordinate", "", "result-trigger-plus-ordinate-difference", Sort::Trigger(1, '+')),
    Row("result-trigger-minus-applicate", "", "result-trigger-minus-applicate-difference", Sort::Trigger(2, '−')),
    Row("result-trigger-plus-applicate", "", "result-trigger-plus-applicate-difference", Sort::Trigger(2, '+')),
    Row("result-trigger-minus-1", "", "result-trigger-minus-1-difference", Sort::TriggerOf("X−")),
    Row("result-trigger-plus-1", "", "result-trigger-plus-1-difference", Sort::TriggerOf("X+")),
    Row("result-trigger-minus-2", "", "result-trigger-minus-2-difference", Sort::TriggerOf("Y−")),
    Row("result-trigger-plus-2", "", "result-trigger-plus-2-difference", Sort::TriggerOf("Y+")),
    Row("result-trigger-minus-3", "", "result-trigger-minus-3-difference", Sort::TriggerOf("Z−")),
    Row("result-trigger-plus-3", "", "result-trigger-plus-3-difference", Sort::TriggerOf("Z+")),
    Row("result-skew-abscissa", "", "", Sort::Skew(0)),
    Row("result-skew-ordinate", "", "", Sort::Skew(1)),
    Row("result-hole-abscissa", "", "", Sort::Centre(0)),
    Row("result-hole-ordinate", "", "", Sort::Centre(1)),
    Row("result-nct-diameter", "", "result-nct-deviation", Sort::Size),
    Row("result-g109-width", "", "result-g109-deviation", Sort::Size),
    Row("result-nct-position", "", "result-nct-position-deviation", Sort::Position),
    Row("result-nct-corner-1", "", "result-nct-corner-shift-1", Sort::Corner(0)),
    Row("result-nct-corner-2", "", "result-nct-corner-shift-2", Sort::Corner(1)),
    Row("result-nct-centre-1", "", "result-nct-shift-1", Sort::Centre(0)),
    Row("result-nct-centre-2", "", "result-nct-shift-2", Sort::Centre(1)),
    Row("result-g109-centre", "", "result-g109-shift", Sort::Other),
    Row("result-g104-length", "", "result-g104-deviation", Sort::Probe),
    Row("result-g102-1", "", "", Sort::Skew(0)),
    Row("result-g102-2", "", "", Sort::Skew(1)),
    Row("result-g103-1-plus", "", "", Sort::Trigger(0, '+')),
    Row("result-g103-1-minus", "", "", Sort::Trigger(0, '−')),
    Row("result-g103-2-plus", "", "", Sort::Trigger(1, '+')),
    Row("result-g103-2-minus", "", "", Sort::Trigger(1, '−')),
    Row("result-p9920-length", "", "", Sort::ToolLength("L")),
    Row("result-p9920-diameter", "", "", Sort::Ball),
    Row("result-p9920-reference", "", "", Sort::Other),
    Row("result-p9920-disk", "", "", Sort::Other),
    Row("result-p9920-z", "", "", Sort::Other),
    Row("result-p9920-x", "", "", Sort::Other),
    Row("result-p9920-y", "", "", Sort::Other),
    Row("result-p9969-lowest", "", "", Sort::Other),
    Row("result-p9969-highest", "", "", Sort::Other),
];

/// The quantities that a call wrote, with their sorts.
pub(super) fn found(called: &Called, entries: &[Entry]) -> Vec<(Sort, Figure)> {
    let inputs = &called.inputs;
    let values = written(called, entries);
    let rows = ROWS.iter().filter_map(|Row(actual, set, deviation, sort)| {
        let (field, value) = values.get(actual)?;
        let of = |key: &str| values.get(key).map(|(_, value)| *value);
        let (heading, symbol) = named(*sort, inputs);
        let deviation = of(deviation);
        let figure = Figure {
            name: field.name,
            label: Message::new(field.key),
            heading: Message::new(heading),
            symbol,
            actual: *value,
            // a result without a setpoint deviates from what was given, that of a calibration from what was stored
            set: of(set).or_else(|| deviation.filter(|_| !compares(inputs)).map(|deviation| value - deviation)),
            deviation,
            unit: called.unit(field.unit),
            limits: None,
        };
        Some((*sort, figure))
    });
    rows.collect()
}

/// Whether the deviations of a call are from what the control has stored.
fn compares(inputs: &Inputs) -> bool {
    inputs.cycle.purpose.calibrates.holds(inputs)
}

/// What a call wrote by the keys of its results.
pub(super) fn written(called: &Called, entries: &[Entry]) -> BTreeMap<&'static str, (&'static ResultField, f64)> {
    let set = |entry: &Entry| match &entry.step {
        Step::Set { name, after, .. } => Some((name.clone(), *after)),
        _ => None,
    };
    let last: BTreeMap<String, f64> = entries.iter().filter_map(set).collect();
    let fields = called.inputs.cycle.results.iter().filter(|field| field.when.holds(&called.inputs));
    fields.filter_map(|field| Some((field.key, (field, *last.get(field.name)?)))).collect()
}

/// Heading of a sort, and what stands before its values.
fn named(sort: Sort, inputs: &Inputs) -> (&'static str, String) {
    let axes = axes(inputs);
    let round = matches!(element(inputs), Some(Element::Hole | Element::Shaft));
    let axis = |index: usize| axes[index.min(2)].to_owned();
    let none = String::new;
    match sort {
        Sort::Size if round => ("answer-diameter", "Ø".to_owned()),
        Sort::Size => ("answer-width", none()),
        Sort::Length(index) => ("answer-length", axis(index)),
        Sort::Two if inputs.diameters && measured(inputs).is_some_and(|index| axes[index] == "X") => {
            ("answer-diameter", "Ø".to_owned())
        }
        Sort::Two => ("answer-radius", "R".to_owned()),
        Sort::Sphere | Sort::Ball => ("answer-diameter", "Ø".to_owned()),
        Sort::Centre(index) => ("answer-centre", axis(index)),
        Sort::Position => ("answer-position", measured(inputs).map_or_else(none, axis)),
        Sort::Angle(_) => ("answer-angle", none()),
        Sort::Corner(index) => ("answer-corner", axis(index)),
        Sort::ToolLength(name) => ("answer-tool-length", name.to_owned()),
        Sort::ToolRadius => ("answer-radius", "R".to_owned()),
        Sort::Trigger(index, sign) => ("answer-trigger", format!("{}{sign}", axes[index.min(2)])),
        Sort::TriggerOf(name) => ("answer-trigger", name.to_owned()),
        Sort::Skew(index) => ("answer-skew", axis(index)),
        Sort::Probe => ("answer-probe-length", "L".to_owned()),
        Sort::Other => ("answer-value", none()),
    }
}

/// The measuring axis: 0 abscissa, 1 ordinate, 2 applicate; none where a call names none.
pub(super) fn measured(inputs: &Inputs) -> Option<usize> {
    match inputs.any(names::MA).map(|axis| axis as i64) {
        Some(1) => Some(0),
        Some(2) => Some(1),
        Some(3) => Some(2),
        _ => None,
    }
}
