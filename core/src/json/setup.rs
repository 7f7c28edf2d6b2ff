//! The setup file: machine, probe and part. Its schema is `docs/setup.schema.json`.

use super::Error;
use super::setup_surface::{self, SurfaceFile};
use super::setup_tool::{RealFile, ToolProbeFile};
use crate::catalogue::Dialect;
use crate::control::{
    Control, Edge, Environment, Frame, Limits, Plane, Tool, Transverse, Units, Value, delivery,
    delivery_in,
};
use crate::run::setup::Setup;
use crate::workpiece::seen::Turret;
use crate::workpiece::{PartErrors, Probe, Shape, Solid, Workpiece};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// Machine, probe and part that a program runs on. Lengths in mm, angles in degree, feeds in mm/min, except in `data`,
/// where a number means what it means on the control: on an inch machine most lengths are inches. Unknown members are refused, so that a slip is told and not ignored.
#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct SetupFile {
    /// Control.
    control: ControlName,
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
    /// What differs from delivery in user data, R parameters, machine data, # variables: `_WP[0,1]`, `_CHBIT[4]`, `R10`, `MD18600`, `#500`; and `PW-FORMS`, 1 where `_MZ_MASK` decides forms and code.
    #[serde(default)]
    data: BTreeMap<String, DatumFile>,
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

#[derive(Clone, Copy, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "lowercase")]
enum ControlName {
    Sinumerik,
    Nct,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
pub(super) enum UnitsName {
    #[default]
    #[serde(rename = "mm")]
    Millimetre,
    #[serde(rename = "inch")]
    Inch,
}

/// Working plane.
#[derive(Clone, Copy, Default, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
pub(super) enum PlaneName {
    #[default]
    G17,
    G18,
    G19,
}

/// What is in force at the start.
#[derive(Clone, Default, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, default)]
struct ActiveFile {
    /// T number in the spindle, 0 none.
    tool: i64,
    /// D number (NCT: H), 0 none.
    edge: i64,
    /// Settable frame, for example `G54`.
    frame: String,
    /// G function of units: `G70`, `G71`, `G700`, `G710` (NCT `G20`, `G21`); none: that of the basic system.
    units: String,
    /// How positions of X are given.
    transverse: TransverseName,
    /// Position of the spindle, degree.
    spindle: f64,
    /// Where the rotary axes A B C stand, machine, degree.
    rotary: [f64; 3],
}

/// How positions of the transverse axis X of a lathe are given: radii, diameters, diameters where they are absolute.
#[derive(Clone, Copy, Default, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "UPPERCASE")]
enum TransverseName {
    #[default]
    Diamof,
    Diamon,
    Diam90,
}

/// What the machine can do.
#[derive(Clone, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
struct MachineFile {
    /// Software limit switches on the minus side (MD36100) of the machine axes X Y Z; null: none.
    limits_minus: [Option<f64>; 3],
    /// Software limit switches on the plus side (MD36110) of the machine axes X Y Z; null: none.
    limits_plus: [Option<f64>; 3],
    /// Whether the spindle can be positioned with SPOS.
    spindle_positions: bool,
    /// Point X Y Z on the lines about which the rotary axes turn the part. Which there are: MD20080 and MD30300 in `data`.
    rotary_centre: [f64; 3],
    /// The turret of a turning machine.
    turret: TurretFile,
}

/// The disc that carries the tools of a turning machine, its axis parallel to Z. It is shown, and nothing meets it.
#[derive(Clone, Deserialize)]
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
#[derive(Deserialize)]
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
#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub(super) struct EdgeFile {
    /// `$TC_DP1`: 710 3D probe, 120 end mill.
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

/// A stored tool environment.
#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
struct EnvironmentFile {
    /// T number.
    tool: i64,
    /// D number.
    edge: i64,
    /// DL number, 0 none.
    #[serde(default)]
    location: i64,
    /// Working plane.
    #[serde(default)]
    plane: PlaneName,
}

/// A frame.
#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct FrameFile {
    /// Coarse translation X Y Z.
    coarse: [f64; 3],
    /// Fine translation X Y Z.
    #[serde(default)]
    fine: [f64; 3],
    /// Rotation about X Y Z (RPY), degree.
    #[serde(default)]
    rotation: [f64; 3],
    /// Coarse translation of the rotary axes A B C, degree.
    #[serde(default)]
    rotary: [f64; 3],
    /// Fine translation of the rotary axes A B C, degree.
    #[serde(default)]
    rotary_fine: [f64; 3],
    /// Scale factors along its own X Y Z; 1: none. Measuring does not work with any other.
    #[serde(default = "no_scale")]
    scale: [f64; 3],
    /// Whether the direction of X Y Z is reversed.
    #[serde(default)]
    mirror: [bool; 3],
}

fn no_scale() -> [f64; 3] {
    Frame::default().scale
}

#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(untagged)]
pub(super) enum DatumFile {
    Number(f64),
    Text(String),
}

/// The probe as it really is.
#[derive(Deserialize)]
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
}

/// A solid.
#[derive(Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
pub(super) struct SolidFile {
    /// Element.
    shape: ShapeName,
    /// hole: diameter, depth; shaft: diameter, height; groove and web: width, depth, length; pocket and island:
    /// X, Y, depth; block: X, Y, Z; turned: diameter, length, diameter and depth of the bore (0: none); chuck: diameter, length, diameter that it grips; sphere: diameter; outerCorner and innerCorner: angle between the edges in degree,
    /// lengths of the edge along X and of the other one, depth; surface: none.
    #[serde(default)]
    size: Vec<f64>,
    /// What a surface looks like, of this shape only.
    #[serde(default)]
    surface: Option<SurfaceFile>,
    /// Centre of the element at its upper face, of a sphere its centre, of a corner the corner, machine coordinates X Y Z.
    at: [f64; 3],
    /// Orientation about X Y Z (RPY), degree.
    #[serde(default)]
    rotation: [f64; 3],
    /// What is wrong with it.
    #[serde(default)]
    errors: ErrorsFile,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "camelCase")]
enum ShapeName {
    Hole,
    Shaft,
    Groove,
    Web,
    Pocket,
    Island,
    Block,
    Turned,
    Chuck,
    Sphere,
    OuterCorner,
    InnerCorner,
    Surface,
}

/// Errors of a solid. All zero: none.
#[derive(Default, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
struct ErrorsFile {
    /// Displacement X Y Z, machine axes.
    shift: [f64; 3],
    /// Added to every diameter, width and length.
    size: f64,
    /// Turned about X Y Z about the origin of the solid, degree.
    tilt: [f64; 3],
    /// Growth of the diameter per mm of depth.
    taper: f64,
    /// Amplitude of the radius, number of lobes.
    out_of_round: (f64, u32),
}

/// JSON Schema of the setup file. `Serialize` writes the default values into it.
#[cfg(feature = "cli")]
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(SetupFile).to_value()
}

/// Reads a setup file: delivery values of the control, then what the file says.
pub fn from_json(text: &str) -> Result<Setup, Error> {
    setup(serde_json::from_str(text)?)
}

/// The same from a parsed document.
pub(super) fn from_value(value: serde_json::Value) -> Result<Setup, Error> {
    setup(serde_json::from_value(value)?)
}

fn setup(mut file: SetupFile) -> Result<Setup, Error> {
    let dialect = match file.control {
        ControlName::Sinumerik => Dialect::Sinumerik,
        ControlName::Nct => Dialect::Nct,
    };
    let mut control = delivery_in(dialect, units(file.units));
    control.plane = plane(file.plane);
    control.limits = Limits {
        minus: file.machine.limits_minus,
        plus: file.machine.limits_plus,
    };
    control.spindle_positions = file.machine.spindle_positions;
    control.rotary_centre = file.machine.rotary_centre;
    let real_tools = super::setup_tool::real_tools(&mut file.tools);
    for (number, tool) in file.tools {
        control.tools.insert(number, read_tool(tool));
    }
    for (name, frame) in &file.frames {
        place_frame(&mut control, name, frame)?;
    }
    for (name, stored) in file.environments {
        control.environments.insert(name, environment(&stored));
    }
    read_data(&mut control, file.data);
    activate(&mut control, &file.active)?;
    let solids = file
        .workpiece
        .into_iter()
        .map(solid)
        .collect::<Result<_, _>>()?;
    let tool_probes = file.tool_probes.into_iter();
    let tool_probes = tool_probes
        .map(super::setup_tool::tool_probe)
        .collect::<Result<_, _>>()?;
    let TurretFile { diameter, width } = file.machine.turret;
    let setup = Setup {
        control,
        probe: read_probe(&file.probe),
        workpiece: Workpiece { solids },
        tool_probes,
        real_tools,
        turret: Turret { diameter, width },
        position: file.position,
        skip: file.skip,
    };
    super::setup_limits::check(&setup)?;
    Ok(setup)
}

pub(super) fn read_data(control: &mut Control, data: BTreeMap<String, DatumFile>) {
    for (name, datum) in data {
        let value = match datum {
            DatumFile::Number(value) => Value::Number(value),
            DatumFile::Text(text) => Value::Text(text),
        };
        control.data.insert(name, value);
    }
}

fn environment(file: &EnvironmentFile) -> Environment {
    Environment {
        tool: file.tool,
        edge: file.edge,
        location: file.location,
        plane: plane(file.plane),
    }
}

fn activate(control: &mut Control, file: &ActiveFile) -> Result<(), Error> {
    control.tool = file.tool;
    control.edge = file.edge;
    control.transverse = transverse(file.transverse);
    control.spindle = file.spindle;
    control.rotary = file.rotary;
    if !file.frame.is_empty() {
        let unknown = || Error::Unknown {
            what: "frame",
            name: file.frame.clone(),
        };
        control.settable = settable(control, &file.frame).ok_or_else(unknown)?;
    }
    control.activate(control.settable);
    if !file.units.is_empty() {
        choose_units(control, &file.units)?;
    }
    Ok(())
}

/// Makes a G function of units the one in force, by its name: `G70`.
pub(super) fn choose_units(control: &mut Control, name: &str) -> Result<(), Error> {
    let number = name
        .strip_prefix('G')
        .and_then(|digits| digits.parse().ok());
    if number.is_some_and(|number| control.choose_units(number)) {
        return Ok(());
    }
    Err(Error::Unknown {
        what: "G function of units",
        name: name.to_owned(),
    })
}

/// Name of a G function of units, see [`choose_units`].
pub(super) fn units_name(number: u16) -> String {
    format!("G{number}")
}

/// The basic system with this name.
pub(super) fn units(name: UnitsName) -> Units {
    match name {
        UnitsName::Millimetre => Units::Metric,
        UnitsName::Inch => Units::Inch,
    }
}

/// Name of a basic system.
pub(super) fn units_of(basic: Units) -> &'static str {
    match basic {
        Units::Metric => "mm",
        Units::Inch => "inch",
    }
}

/// The plane with this name.
pub(super) fn plane(name: PlaneName) -> Plane {
    match name {
        PlaneName::G17 => Plane::G17,
        PlaneName::G18 => Plane::G18,
        PlaneName::G19 => Plane::G19,
    }
}

fn transverse(name: TransverseName) -> Transverse {
    match name {
        TransverseName::Diamof => Transverse::Radius,
        TransverseName::Diamon => Transverse::Diameter,
        TransverseName::Diam90 => Transverse::AbsoluteDiameter,
    }
}

fn read_tool(file: ToolFile) -> Tool {
    let mut tool = Tool {
        name: file.name,
        edges: BTreeMap::new(),
    };
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
    }
}

fn place_frame(control: &mut Control, name: &str, file: &FrameFile) -> Result<(), Error> {
    let frame = Frame {
        coarse: file.coarse,
        fine: file.fine,
        rotation: file.rotation,
        rotary: file.rotary,
        rotary_fine: file.rotary_fine,
        scale: file.scale,
        mirror: file.mirror,
    };
    let unknown = || Error::Unknown {
        what: "frame",
        name: name.to_owned(),
    };
    let index = |prefix: &str| -> Option<usize> {
        name.strip_prefix(prefix)?.strip_suffix(']')?.parse().ok()
    };
    if name == "$P_SETFR" {
        control.system = frame;
    } else if let Some(number) = index("$P_CHBFR[") {
        control.channel_basic.insert(number, frame);
    } else if let Some(number) = index("$P_NCBFR[") {
        control.global_basic.insert(number, frame);
    } else {
        control
            .frames
            .insert(settable(control, name).ok_or_else(unknown)?, frame);
    }
    Ok(())
}

/// Number of a settable frame by its name: G54..G57 1..4, G505..G599 5..99; NCT G54..G59 1..6 and `COMMON` 0.
fn settable(control: &Control, name: &str) -> Option<usize> {
    let number: usize = if name == "COMMON" {
        0
    } else {
        name.strip_prefix('G')?.parse().ok()?
    };
    match (control.dialect, number) {
        (_, 0) => Some(0),
        (Dialect::Nct, 54..=59) | (_, 54..=57) => Some(number - 53),
        (Dialect::Sinumerik, 500..=599) => Some(number - 500),
        _ => None,
    }
}

/// Name of a settable frame, see [`settable`].
pub(super) fn settable_name(control: &Control, number: usize) -> String {
    match (control.dialect, number) {
        (Dialect::Nct, 0) => "COMMON".to_owned(),
        (Dialect::Sinumerik, 0) => "G500".to_owned(),
        (Dialect::Nct, _) | (_, 1..=4) => format!("G{}", number + 53),
        _ => format!("G{}", number + 500),
    }
}

pub(super) fn solid(file: SolidFile) -> Result<Solid, Error> {
    let shape = match (file.shape, file.surface) {
        (ShapeName::Surface, Some(surface)) if file.size.is_empty() => {
            setup_surface::shape(surface)?
        }
        (ShapeName::Surface, _) | (_, Some(_)) => {
            return Err(Error::Unknown {
                what: "shape",
                name: format!("{:?} with {} sizes", file.shape, file.size.len()),
            });
        }
        (shape, None) => sized(shape, &file.size)?,
    };
    let errors = PartErrors {
        shift: file.errors.shift,
        size: file.errors.size,
        tilt: file.errors.tilt,
        taper: file.errors.taper,
        out_of_round: file.errors.out_of_round,
    };
    Ok(Solid {
        shape,
        at: file.at,
        rotation: file.rotation,
        errors,
    })
}

/// A shape that its sizes tell.
fn sized(shape: ShapeName, size: &[f64]) -> Result<Shape, Error> {
    Ok(match (shape, size) {
        (ShapeName::Hole, &[diameter, depth]) => Shape::Hole { diameter, depth },
        (ShapeName::Shaft, &[diameter, height]) => Shape::Shaft { diameter, height },
        (ShapeName::Groove, &[width, depth, length]) => Shape::Groove {
            width,
            depth,
            length,
        },
        (ShapeName::Web, &[width, height, length]) => Shape::Web {
            width,
            height,
            length,
        },
        (ShapeName::Pocket, &[x, y, depth]) => Shape::Pocket {
            length: [x, y],
            depth,
        },
        (ShapeName::Island, &[x, y, height]) => Shape::Island {
            length: [x, y],
            height,
        },
        (ShapeName::Block, &[x, y, z]) => Shape::Block { size: [x, y, z] },
        (ShapeName::OuterCorner, &[angle, x, y, height]) => Shape::OuterCorner {
            angle,
            length: [x, y],
            height,
        },
        (ShapeName::InnerCorner, &[angle, x, y, depth]) => Shape::InnerCorner {
            angle,
            length: [x, y],
            depth,
        },
        (ShapeName::Turned, &[diameter, length, bore, depth]) => Shape::Turned {
            diameter,
            length,
            bore: [bore, depth],
        },
        (ShapeName::Chuck, &[diameter, length, grip]) => Shape::Chuck {
            diameter,
            length,
            grip,
        },
        (ShapeName::Sphere, &[diameter]) => Shape::Sphere { diameter },
        (shape, size) => {
            return Err(Error::Unknown {
                what: "shape",
                name: format!("{shape:?} with {} sizes", size.len()),
            });
        }
    })
}
