//! The measuring result screen, as the operator has it in the middle of a run (B:12547-12650): shown at the end of a
//! measurement with `_CHBIT[10]` = 1; with `_CHBIT[11]` it waits for NC start, with `_CHBIT[18]` it stays until the
//! next measuring cycle.

use crate::check::upkeep::{SCREEN, SCREEN_HALTS, SCREEN_STAYS};
use crate::control::Control;
use crate::entry::{Inputs, ProbeUse, ResultField};
use crate::machine::{Entry, Step};
use crate::message::Message;
use crate::run::called::Called;
use serde::Serialize;

/// A measuring result screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ResultScreen {
    /// Which of the four screens it is.
    pub title: Message,
    /// Cycle that measured.
    pub cycle: &'static str,
    /// Number of the measuring variant.
    pub variant: i64,
    /// Name of the measuring variant.
    pub measures: Message,
    /// What was measured, a row each.
    pub rows: Vec<ScreenRow>,
    /// Single values below, in the order of the manual's list.
    pub values: Vec<ScreenValue>,
    /// Decimals of its values.
    pub digits: u32,
    /// How long it is shown.
    pub until: ScreenUntil,
    /// Index of the entry of the trace with which it appears.
    pub at: usize,
}

/// A row of a result screen: what has no setpoint or difference leaves it empty.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ScreenRow {
    /// What it is.
    pub label: Message,
    /// Setpoint.
    pub set: Option<f64>,
    /// Actual value, trigger value of a calibration.
    pub actual: Option<f64>,
    /// Actual value minus setpoint, of a calibration the change.
    pub difference: Option<f64>,
    /// Unit of all of them.
    pub unit: &'static str,
}

/// A single value of a result screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ScreenValue {
    /// What it is.
    pub label: Message,
    /// Its value.
    pub value: f64,
    /// Its unit; empty: none.
    pub unit: &'static str,
}

/// How long a result screen is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ScreenUntil {
    /// Until the cycle ends.
    End,
    /// Until NC start.
    Start,
    /// Until the next measuring cycle is called.
    Next,
}

/// Decimals of the screen that the manual shows, whatever `_DIGIT` is, which is that of logs and texts (B:12627-12644).
const DIGITS: u32 = 6;

/// A sort of screens: the key of its title, how the names of its rows begin, the names of its single values.
struct Family {
    title: &'static str,
    rows: &'static [&'static str],
    values: &'static [&'static str],
}

const TRIGGERS: &[&str] = &["trigger", "ball", "probe-length"];

/// Calibrating tool probes (B:12586-12591).
const TOOL_PROBE: Family = Family { title: "screen-tool-probe", rows: TRIGGERS, values: &["probe", "safe-area"] };
/// Measuring the tool (B:12593-12598).
const TOOL: Family = Family {
    title: "screen-tool",
    rows: &["actual", "difference"],
    values: &["safe-area", "dimensional-difference", "tool", "edge"],
};
/// Calibrating workpiece probes (B:12600-12606).
const PROBE: Family = Family {
    title: "screen-probe",
    rows: &["trigger", "ball", "probe-length", "skew"],
    values: &["probe", "safe-area"],
};
/// Workpiece measurement (B:12608-12616).
const WORKPIECE: Family = Family {
    title: "screen-workpiece",
    rows: &["set", "actual", "difference", "sphere", "edge-angle", "corner", "hole", "offset-angle"],
    values: &[
        "upper", "lower", "compensation", "probe", "safe-area", "dimensional-difference", "tool", "additive", "target",
    ],
};

/// The tool that is corrected: 0 of a zero offset, which the screen then leaves out (B:12608-12616).
const CORRECTED: &str = "tool";

/// The screen that a call showed, or that the program asks for behind it (CYCLE102), with what the results held then;
/// none: it showed none. `asked`: what the program asks for, with its index in the trace.
pub fn screen(
    called: &Called,
    entries: &[Entry],
    asked: Option<(usize, ScreenUntil)>,
    control: &Control,
) -> Option<ResultScreen> {
    let inputs = &called.inputs;
    let own = entries.iter().enumerate().find_map(|(at, entry)| Some((called.at + at, shown(&entry.step)?)));
    let (at, until) = own.or(asked)?;
    let family = family(inputs);
    let results = inputs.cycle.results;
    let fields: Vec<&ResultField> = results.iter().filter(|field| field.when.holds(inputs)).collect();
    let value = |field: &ResultField| {
        let at = results.iter().position(|one| one.name == field.name);
        let kept = at.and_then(|at| called.shown.get(at)).copied();
        kept.or_else(|| written(entries, field.name)).unwrap_or_else(|| control.number(field.name))
    };
    let single = |stem: &&str| {
        let named =
            |field: &&&ResultField| stem_of(field) == *stem || stem_of(field).strip_prefix(*stem).is_some_and(is_axis);
        fields
            .iter()
            .filter(named)
            .filter(|field| stem_of(field) != CORRECTED || value(field) != 0.0)
            .map(|field| ScreenValue {
                label: Message::new(field.key),
                value: value(field),
                unit: called.unit(field.unit),
            })
            .collect::<Vec<_>>()
    };
    Some(ResultScreen {
        title: Message::new(family.title),
        cycle: inputs.cycle.name,
        variant: inputs.variant,
        measures: Message::new(name(inputs)),
        rows: rows(&fields, family.rows, &value, called),
        values: family.values.iter().flat_map(single).collect(),
        digits: DIGITS,
        until,
        at,
    })
}

/// Whether a step shows a screen, and how long.
pub fn shown(step: &Step) -> Option<ScreenUntil> {
    let Step::Decision { message } = step else { return None };
    match &*message.key {
        SCREEN => Some(ScreenUntil::End),
        SCREEN_HALTS => Some(ScreenUntil::Start),
        SCREEN_STAYS => Some(ScreenUntil::Next),
        _ => None,
    }
}

fn family(inputs: &Inputs) -> &'static Family {
    let purpose = &inputs.cycle.purpose;
    match (purpose.probe, purpose.calibrates.holds(inputs)) {
        (ProbeUse::Tool, true) => &TOOL_PROBE,
        (ProbeUse::Tool, false) => &TOOL,
        (_, true) => &PROBE,
        (_, false) => &WORKPIECE,
    }
}

/// Key of the name of the variant.
fn name(inputs: &Inputs) -> String {
    let variant = inputs.cycle.variants.iter().find(|one| one.number == inputs.variant);
    variant.map_or_else(|| format!("{}-title", inputs.cycle.key), |one| one.key.to_owned())
}

/// What a call has last written into a datum.
fn written(entries: &[Entry], name: &str) -> Option<f64> {
    entries.iter().rev().find_map(|entry| match &entry.step {
        Step::Set { name: other, after, .. } if other == name => Some(*after),
        _ => None,
    })
}

fn stem_of(field: &ResultField) -> &'static str {
    field.key.strip_prefix("result-").unwrap_or(field.key)
}

/// `-abscissa` behind the name of a limit that a rectangle has twice.
fn is_axis(rest: &str) -> bool {
    ["-abscissa", "-ordinate", "-applicate", "-radius"].contains(&rest)
}

/// Rows in the order of the results: what differs only in `set`, `actual` and `difference` is one row.
fn rows(
    fields: &[&'static ResultField],
    wanted: &[&str],
    value: &dyn Fn(&ResultField) -> f64,
    called: &Called,
) -> Vec<ScreenRow> {
    let mut rows: Vec<(String, ScreenRow)> = Vec::new();
    for field in fields.iter().filter(|field| wanted.iter().any(|begin| stem_of(field).starts_with(begin))) {
        let parts = || stem_of(field).split('-');
        let has = |word: &str| parts().any(|part| part == word);
        let name: Vec<&str> = parts().filter(|part| !["set", "actual", "difference"].contains(part)).collect();
        let name = name.join("-");
        let at = rows.iter().position(|(other, _)| *other == name).unwrap_or_else(|| {
            let empty = ScreenRow {
                label: Message::new(field.key),
                set: None,
                actual: None,
                difference: None,
                unit: called.unit(field.unit),
            };
            rows.push((name, empty));
            rows.len() - 1
        });
        let Some((_, row)) = rows.get_mut(at) else { continue };
        match (has("set"), has("difference")) {
            (true, _) => row.set = Some(value(field)),
            (_, true) => row.difference = Some(value(field)),
            _ => (row.actual, row.label) = (Some(value(field)), Message::new(field.key)),
        }
    }
    rows.into_iter().map(|(_, row)| row).collect()
}
