//! The scenario file: a program, the machine on which it runs, and what must come of it. Its schema is
//! `docs/scenario.schema.json`.

use crate::control::Value;
use crate::refused::{Path, Refused};
use crate::run::mode::Mode;
use crate::setup_file::{SetupFile, SolidFile, ToolFile};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A program on a machine, and case by case what must come of it. Lengths in mm, angles in degree.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Scenario {
    /// What it is about, and where its figures come from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    pub source: String,
    /// The program.
    pub program: ScenarioText,
    /// Files beside it: its subprograms, definition files.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<ScenarioText>>"))]
    pub with: Vec<ScenarioText>,
    /// Which program of the text is run, by its name; absent: the first.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    pub main: String,
    /// Values for the parameters of the program itself, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<String, Value>>"))]
    pub arguments: BTreeMap<String, Value>,
    /// Whether what is not there stops the run: a subprogram, a value that only the machine has.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub strict: bool,
    /// How it is carried out; absent: in AUTOMATIC.
    #[serde(default, skip_serializing_if = "Mode::is_automatic")]
    #[cfg_attr(test, ts(optional, as = "Option<Mode>"))]
    pub mode: Mode,
    /// Line, from 1, up to which a block search goes; absent: the whole program is searched through.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub target: Option<u32>,
    /// The machine with its probe, as a setup file describes it.
    pub setup: SetupFile,
    /// What is carried out, each from the beginning.
    pub cases: Vec<ScenarioCase>,
}

/// A file with a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ScenarioText {
    /// Name of the file.
    pub name: String,
    /// Its text; absent: the file lies beside the scenario.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// A case: what differs from program and machine of the scenario, and what must come of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ScenarioCase {
    /// What it is called.
    pub id: String,
    /// Where the expectation comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    pub oracle: String,
    /// Texts of the program, each with what stands in its place.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<(String, String)>>"))]
    pub replace: Vec<(String, String)>,
    /// The part; absent: that of the setup.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub workpiece: Option<Vec<SolidFile>>,
    /// Tools that differ, by T number.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<i64, ToolFile>>"))]
    pub tools: BTreeMap<i64, ToolFile>,
    /// User and machine data that differ.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<String, Value>>"))]
    pub data: BTreeMap<String, Value>,
    /// Tool and frame data that differ, as a program names them: `$P_UIFR[1,X,FI]`, `H98`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<String, f64>>"))]
    pub variables: BTreeMap<String, f64>,
    /// What must come of it.
    pub expect: Expected,
}

/// What must come of a run. What is absent is not compared.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Expected {
    /// What stops it: the number of an alarm, a message of NCT, the key of a fault; absent: it reaches its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stop: Option<Value>,
    /// Alarms and operator messages in their order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alarms: Option<Vec<Value>>,
    /// What the measuring calls leave in their result data, in the order of their lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calls: Option<Vec<ExpectedCall>>,
    /// All that is corrected or calibrated, with the value afterwards: nothing else may change.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub changes: Option<BTreeMap<String, f64>>,
    /// User data afterwards.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub data: Option<BTreeMap<String, f64>>,
    /// Results that a cycle writes, with their last value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub written: Option<BTreeMap<String, f64>>,
    /// Tool and frame data afterwards.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub variables: Option<BTreeMap<String, f64>>,
    /// Zero points of settable frames afterwards, by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origins: Option<BTreeMap<String, [f64; 3]>>,
    /// Where each measuring motion starts, machine coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub starts: Option<Vec<[f64; 3]>>,
    /// Where the probe switches, machine coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub touches: Option<Vec<[f64; 3]>>,
    /// Where the machine stands at the end of each call, machine coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<Vec<[f64; 3]>>,
    /// Feed of all measuring motions, mm/min.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<f64>,
    /// To where the spindle is turned, degree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientations: Option<Vec<f64>>,
    /// Lines of the print-out, and blocks that are sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub log: Option<Vec<String>>,
    /// Files that it leaves on the control, by name: the log of measurements.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub files: Option<BTreeMap<String, Vec<String>>>,
    /// By how much a number may differ; absent: 0.000001.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
}

impl Expected {
    /// # Errors
    /// A tolerance that no number can meet.
    pub(super) fn proves(&self) -> Result<(), Refused> {
        match self.tolerance {
            Some(tolerance) if !(tolerance >= 0.0 && tolerance.is_finite()) => {
                Err(Refused::new("scenario-tolerance", Path::of(&["tolerance"])).number("value", tolerance))
            }
            _ => Ok(()),
        }
    }
}

/// What a measuring call leaves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ExpectedCall {
    /// Line of the call, from 1.
    pub line: u32,
    /// What is called.
    pub cycle: String,
    /// Its results.
    pub results: BTreeMap<String, f64>,
}
