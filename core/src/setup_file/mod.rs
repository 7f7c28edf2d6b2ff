//! The setup file: machine, probe and part as the user describes them. Its schema is `docs/setup.schema.json`.
//!
//! What the file says as the core has it is the core's own type, which serde reads and writes; the types here are those
//! of which the file has another order.

mod convert;
mod solid;

pub use convert::{defined, setup};
pub use solid::{SolidFile, example};

use crate::control::{Environment, Frame, Plane, Transverse, Units, Value, delivery};
use crate::dialect::Dialect;
use crate::geometry::Degrees;
use crate::machine::series::Series;
use crate::machine::temperature::Temperature;
use crate::workpiece::{Probe, Tool, Turret};
#[cfg(feature = "cli")]
use schemars::{generate::SchemaSettings, transform::RecursiveTransform};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Machine, probe and part that a program runs on. Lengths in mm, angles in degree, feeds in mm/min, except in `data`,
/// where a number means what it means on the control: on an inch machine most lengths are inches. Unknown members are
/// refused, so that a slip is told and not ignored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Setup"))]
pub struct SetupFile {
    /// Control.
    control: Dialect,
    /// What the user calls the machine.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    name: String,
    /// Basic system of units of the machine.
    #[serde(default)]
    units: Units,
    /// Working plane at the start.
    #[serde(default)]
    plane: Plane,
    /// What else is active at the start.
    #[serde(default)]
    active: ActiveFile,
    /// What the machine can do.
    #[serde(default)]
    machine: MachineFile,
    /// Tools by T number (NCT: offset registers under T 0).
    #[serde(default)]
    tools: BTreeMap<i64, ToolFile>,
    /// Frames by name: `G54`, `G505`, `COMMON` (NCT), `$P_CHBFR[0]`, `$P_NCBFR[0]`, `$P_SETFR`.
    #[serde(default)]
    frames: BTreeMap<String, Frame>,
    /// Stored tool environments by name, as `TOOLENV("NAME")` makes them.
    #[serde(default)]
    environments: BTreeMap<String, Environment>,
    /// What differs from delivery in user data, R parameters, machine data, # variables: `_WP[0,1]`, `_CHBIT[4]`,
    /// `R10`, `MD18600`, `#500`; `PW-FORMS`, 1 where `_MZ_MASK` decides forms and
    /// code; `PW-JOG`, 1 where measuring in JOG has the masks up to SW 6.2; `PW-GENERATION`, 1 to 3, the generation of
    /// the control; `PW-MACRO-LEVELS` and `PW-SUBPROGRAM-LEVELS`, how many an NCT control has.
    #[serde(default)]
    data: BTreeMap<String, Value>,
    /// User data that the definition files of the machine add (GUD4.DEF, UGUD.DEF …), as they are written there:
    /// `DEF NCK REAL LIMIT[2,3]=SET(1,2)`. Their values are in `data`, where they differ.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<String>>"))]
    definitions: Vec<String>,
    /// The probe as it really is, not as the control believes.
    probe: Probe,
    /// The tool probes of the machine as they really are, not as `_TP` and `_TPW` in `data` believe.
    #[serde(default)]
    tool_probes: Vec<ToolProbeFile>,
    /// The part: every solid can be touched. It is given as it is clamped while the rotary axes stand at 0.
    #[serde(default)]
    workpiece: Vec<SolidFile>,
    /// Where the machine stands at the start: the point to which L1 refers, machine coordinates X Y Z.
    #[serde(default)]
    position: [f64; 3],
    /// Date and time of the control at the start, `2026-05-31T08:00:00`; motions take their time from then on. The log
    /// of measurements prints them. Default: 2000-01-01T00:00:00.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    clock: String,
    /// Skip levels 0 to 9 that are switched on at the panel: blocks with `/`, `/1` to `/9` are left out.
    #[serde(default)]
    skip: BTreeSet<u8>,
    /// What varies where a program is run many times: `probewright series`.
    #[serde(default, skip_serializing_if = "nothing_varies")]
    #[cfg_attr(test, ts(optional, as = "Option<Series>"))]
    series: Series,
    /// How well the temperature of the part is known: a part of how uncertain a measured length is.
    #[serde(default, skip_serializing_if = "Temperature::is_default")]
    #[cfg_attr(test, ts(optional, as = "Option<Temperature>"))]
    temperature: Temperature,
}

impl SetupFile {
    /// Which control the machine has.
    pub fn control(&self) -> Dialect {
        self.control
    }

    /// The same with another part, and with these tools and data beside its own or in their place.
    pub fn with(
        mut self,
        part: Option<Vec<SolidFile>>,
        tools: &BTreeMap<i64, ToolFile>,
        data: &BTreeMap<String, Value>,
    ) -> SetupFile {
        self.workpiece = part.unwrap_or(self.workpiece);
        self.tools.extend(tools.clone());
        self.data.extend(data.clone());
        self
    }
}

/// What is active at the start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Active"))]
struct ActiveFile {
    /// T number in the spindle, 0 none.
    tool: i64,
    /// D number (NCT: H), 0 none.
    edge: i64,
    /// Settable frame, for example `G54`.
    frame: String,
    /// G function of units: `G70`, `G71`, `G700`, `G710` (NCT `G20`, `G21`); none: that of the basic system.
    #[cfg_attr(test, ts(as = "crate::control::UnitFunction"))]
    units: String,
    /// How positions of the transverse axis X of a lathe are given.
    transverse: Transverse,
    /// Position of the spindle, degree, positive as M3 turns it.
    spindle: Degrees,
    /// Where the rotary axes A B C stand, machine, degree.
    rotary: [Degrees; 3],
}

/// What the machine can do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Abilities"))]
struct MachineFile {
    /// Software limit switches on the minus side (MD36100) of the machine axes X Y Z; null: none.
    limits_minus: [Option<f64>; 3],
    /// Software limit switches on the plus side (MD36110) of the machine axes X Y Z; null: none.
    limits_plus: [Option<f64>; 3],
    /// Whether the spindle can be positioned with SPOS.
    spindle_positions: bool,
    /// Point X Y Z on the lines about which the rotary axes turn the part. Which there are: MD20080 and MD30300 in
    /// `data`.
    rotary_centre: [f64; 3],
    /// How far the workpiece probe may be deflected in the directions of measuring, mm; none: not known. With MD10050,
    /// MD10070, MD32300 and MD32200 in `data` feeds beyond it are told.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    deflection: Option<f64>,
    /// The turret of a turning machine.
    turret: Turret,
}

impl Default for MachineFile {
    fn default() -> MachineFile {
        MachineFile::of(&delivery(Dialect::Sinumerik), Turret::default())
    }
}

/// A tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ToolData"))]
pub struct ToolFile {
    /// Name under tool management.
    #[serde(default)]
    name: String,
    /// Edges by D number.
    edges: BTreeMap<i64, EdgeFile>,
}

/// Data of a cutting edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "EdgeData", optional_fields))]
struct EdgeFile {
    /// `$TC_DP1`: 710 3D probe, 120 end mill, 580 probe of a turning machine.
    #[serde(rename = "type")]
    kind: i64,
    /// `$TC_DP2`: cutting edge position of a turning tool or lathe probe, 1 to 9.
    #[serde(default)]
    tip: i64,
    /// Geometry L1 L2 L3.
    length: [f64; 3],
    /// Geometry radius.
    radius: f64,
    /// Wear of L1 L2 L3.
    #[serde(default)]
    length_wear: [f64; 3],
    /// Wear of the radius.
    #[serde(default)]
    radius_wear: f64,
    /// Additive offsets by DL number: L1 L2 L3 radius.
    #[serde(default)]
    additive: BTreeMap<i64, [f64; 4]>,
    /// Setup offsets by DL number: L1 L2 L3 radius.
    #[serde(default)]
    setup: BTreeMap<i64, [f64; 4]>,
    /// Other tool data by number, `$TC_DP7` to 11 and 16 to 25; 21 to 23 are the lengths of the adapter.
    #[serde(default)]
    further: BTreeMap<usize, f64>,
    /// The tool as it really is where it touches a tool probe; none: as its data say at the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    real: Option<Tool>,
}

/// A tool probe as it really is: a cube (`block`) or a disc (`turned` without bore).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ToolProbe"))]
struct ToolProbeFile {
    /// Cap of the tool probe.
    solid: SolidFile,
    /// Travel after contact until the signal.
    #[serde(default)]
    pre_travel: f64,
    /// Delay of the signal, s.
    #[serde(default)]
    delay: f64,
    /// Standard deviation of the switching point, and the seed of its pseudo-random sequence.
    #[serde(default = "always")]
    repeatability: (f64, u64),
}

fn always() -> (f64, u64) {
    (0.0, 1)
}

fn nothing_varies(series: &Series) -> bool {
    *series == Series::default()
}

/// JSON Schema of a file that users write. `Serialize` writes the default values into it.
#[cfg(feature = "cli")]
pub fn schema<T: schemars::JsonSchema>() -> serde_json::Value {
    // whole lines: a doc comment breaks where the code does, a reader's window elsewhere
    let unwrapped = RecursiveTransform(|schema: &mut schemars::Schema| {
        if let Some(serde_json::Value::String(text)) = schema.get_mut("description") {
            let paragraphs: Vec<String> = text.split("\n\n").map(|one| one.replace('\n', " ")).collect();
            *text = paragraphs.join("\n\n");
        }
    });
    let generator = SchemaSettings::default().with_transform(unwrapped).into_generator();
    generator.into_root_schema_for::<T>().to_value()
}
