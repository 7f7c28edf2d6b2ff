//! The setup file: machine, probe and part. Its schema is `docs/setup.schema.json`.

use super::setup_active::{ActiveFile, PlaneName, UnitsName, activate, plane, units};
use super::setup_frame::{EnvironmentFile, FrameFile, environment, place_frame};
use super::setup_solid::{SolidFile, solid};
use super::setup_tool::{RealFile, ToolProbeFile, real_tools, tool_probe};
use super::{Error, shape, text};
use crate::control::{Edge, Limits, Tool, Value, delivery, delivery_in};
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::setup::Setup;
use crate::refused::Path;
use crate::workpiece::seen::Turret;
use crate::workpiece::{Probe, ProbeBody, Workpiece};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// Machine, probe and part that a program runs on. Lengths in mm, angles in degree, feeds in mm/min, except in `data`,
/// where a number means what it means on the control: on an inch machine most lengths are inches. Unknown members are
/// refused, so that a slip is told and not ignored.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct SetupFile {
    /// Control.
    control: Dialect,
    /// Basic system of units of the machine.
    #[serde(default)]
    units: UnitsName,
    /// Working plane at the start.
    #[serde(default)]
    plane: PlaneName,
    /// What else is in force at the start.
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
    frames: BTreeMap<String, FrameFile>,
    /// Stored tool environments by name, as `TOOLENV("NAME")` makes them.
    #[serde(default)]
    environments: BTreeMap<String, EnvironmentFile>,
    /// What differs from delivery in user data, R parameters, machine data, # variables: `_WP[0,1]`, `_CHBIT[4]`,
    /// `R10`, `MD18600`, `#500`; and `PW-FORMS`, 1 where `_MZ_MASK` decides forms and code.
    #[serde(default)]
    data: BTreeMap<String, Value>,
    /// The probe as it really is, not as the control believes.
    probe: ProbeFile,
    /// The tool probes of the machine as they really are, not as `_TP` and `_TPW` in `data` believe.
    #[serde(default)]
    tool_probes: Vec<ToolProbeFile>,
    /// The part: every solid can be touched. It is given as it is clamped while the rotary axes stand at 0.
    #[serde(default)]
    workpiece: Vec<SolidFile>,
    /// Where the machine stands at the start: the point to which L1 refers, machine coordinates X Y Z.
    #[serde(default)]
    position: [f64; 3],
    /// Skip levels 0 to 9 that are switched on at the panel: blocks with `/`, `/1` to `/9` are left out.
    #[serde(default)]
    skip: BTreeSet<u8>,
}

/// What the machine can do.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
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
    /// The turret of a turning machine.
    turret: TurretFile,
}

/// The disc that carries the tools of a turning machine, its axis parallel to Z. It is shown, and nothing meets it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, default)]
struct TurretFile {
    /// Diameter; 0: it is not shown.
    diameter: f64,
    /// Width.
    width: f64,
}

impl Default for TurretFile {
    fn default() -> TurretFile {
        let Turret { diameter, width } = Turret::default();
        TurretFile { diameter, width }
    }
}

impl Default for MachineFile {
    fn default() -> MachineFile {
        let control = delivery(Dialect::Sinumerik);
        MachineFile {
            limits_minus: control.limits.minus,
            limits_plus: control.limits.plus,
            spindle_positions: control.spindle_positions,
            rotary_centre: control.rotary_centre,
            turret: TurretFile::default(),
        }
    }
}

/// A tool.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
pub(super) struct ToolFile {
    /// Name under tool management.
    #[serde(default)]
    name: String,
    /// Edges by D number.
    pub(super) edges: BTreeMap<i64, EdgeFile>,
}

/// Data of a cutting edge.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub(super) struct EdgeFile {
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
    #[serde(default)]
    pub(super) real: Option<RealFile>,
}

/// The probe as it really is.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct ProbeFile {
    /// Ball radius.
    radius: f64,
    /// Spindle nose to ball centre.
    length: f64,
    /// Ball centre minus spindle axis at spindle position 0, X Y; of a probe in a turret ball centre minus the point
    /// where L1 and L2 end, abscissa and ordinate, where the length does not count.
    #[serde(default)]
    skew: [f64; 2],
    /// Travel after contact until the signal: constant part, amplitude of the three-lobed part.
    #[serde(default)]
    pre_travel: (f64, f64),
    /// Delay of the signal, s.
    #[serde(default)]
    delay: f64,
    /// Standard deviation of the switching point, and the seed of its pseudo-random sequence.
    #[serde(default)]
    repeatability: (f64, u64),
    /// Way with the signal watched after which it comes once without contact.
    #[serde(default)]
    false_signal: Option<f64>,
    /// Radius of the straight stylus between ball and body; left out: 0.45 of that of the ball; 0: not looked at, for a
    /// stylus of another shape. In a turret it is looked at where `body` tells how long it is.
    #[serde(default)]
    stylus: Option<f64>,
    /// The body that holds the stylus; left out: the stylus goes as far as the spindle.
    #[serde(default)]
    body: Option<BodyFile>,
}

/// The body of the probe, a cylinder as far as the spindle.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
struct BodyFile {
    /// Radius.
    radius: f64,
    /// From the centre of the ball to its lower face.
    distance: f64,
}

/// JSON Schema of the setup file. `Serialize` writes the default values into it.
#[cfg(feature = "cli")]
pub fn schema() -> serde_json::Value {
    let mut schema = schemars::schema_for!(SetupFile).to_value();
    unwrapped(&mut schema);
    schema
}

/// Descriptions in whole lines: a doc comment breaks where the code does, a reader's window elsewhere.
#[cfg(feature = "cli")]
fn unwrapped(value: &mut serde_json::Value) {
    match value {
        serde_json::Value::Object(members) => {
            for (name, member) in members {
                match member {
                    serde_json::Value::String(text) if name == "description" => {
                        let paragraphs: Vec<String> = text.split("\n\n").map(|one| one.replace('\n', " ")).collect();
                        *text = paragraphs.join("\n\n");
                    }
                    member => unwrapped(member),
                }
            }
        }
        serde_json::Value::Array(all) => all.iter_mut().for_each(unwrapped),
        _ => {}
    }
}

/// Reads a setup file: delivery values of the control, then what the file says.
///
/// # Errors
/// The text is no setup: why, with the place.
pub fn from_json(text: &str) -> Result<Setup, Error> {
    let document = text::parse(text)?;
    shape::read(document).and_then(setup).map_err(|refused| text::positioned(refused, text))
}

/// The machine that a file describes.
///
/// # Errors
/// What it describes cannot be.
pub fn setup(mut file: SetupFile) -> Result<Setup, Error> {
    let dialect = file.control;
    let mut control = delivery_in(dialect, units(file.units));
    control.plane = plane(file.plane);
    control.limits = Limits { minus: file.machine.limits_minus, plus: file.machine.limits_plus };
    control.spindle_positions = file.machine.spindle_positions;
    control.rotary_centre = file.machine.rotary_centre;
    let real_tools = real_tools(&mut file.tools);
    for (number, tool) in file.tools {
        control.tools.insert(number, read_tool(tool));
    }
    for (name, frame) in &file.frames {
        place_frame(&mut control, name, frame)?;
    }
    for (name, stored) in file.environments {
        control.environments.insert(name, environment(&stored));
    }
    for (name, value) in file.data {
        control.data.insert(name, value);
    }
    activate(&mut control, &file.active)?;
    let solids = each("workpiece", file.workpiece, solid)?;
    let tool_probes = each("toolProbes", file.tool_probes, tool_probe)?;
    let TurretFile { diameter, width } = file.machine.turret;
    let setup = Setup {
        control,
        probe: read_probe(&file.probe),
        workpiece: Workpiece { solids },
        tool_probes,
        real_tools,
        turret: Turret { diameter, width },
        position: Mcs(file.position),
        skip: file.skip,
    };
    setup.possible()?;
    Ok(setup)
}

/// What the elements of a list stand for.
fn each<F, T>(name: &str, list: Vec<F>, read: impl Fn(&Path, F) -> Result<T, Error>) -> Result<Vec<T>, Error> {
    let path = Path::of(&[name]);
    list.into_iter().enumerate().map(|(index, one)| read(&path.element(index), one)).collect()
}

fn read_tool(file: ToolFile) -> Tool {
    let mut tool = Tool { name: file.name, edges: BTreeMap::new() };
    for (number, edge) in file.edges {
        tool.edges.insert(number, read_edge(&edge));
    }
    tool
}

fn read_edge(file: &EdgeFile) -> Edge {
    Edge {
        kind: file.kind,
        tip: file.tip,
        length: file.length,
        radius: file.radius,
        length_wear: file.length_wear,
        radius_wear: file.radius_wear,
        additive: file.additive.clone(),
        setup: file.setup.clone(),
        further: file.further.clone(),
    }
}

fn read_probe(file: &ProbeFile) -> Probe {
    Probe {
        radius: file.radius,
        length: file.length,
        skew: file.skew,
        pre_travel: file.pre_travel,
        delay: file.delay,
        repeatability: file.repeatability,
        false_signal: file.false_signal,
        stylus: file.stylus,
        body: file.body.map(|body| ProbeBody { radius: body.radius, distance: body.distance }),
    }
}
