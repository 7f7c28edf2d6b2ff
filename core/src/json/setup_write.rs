//! Writes the setup file, member by member as `setup` reads it; a test holds that it reads back to the same setup.

use super::setup_active::units_of;
use super::{document, object, put, setup_surface, setup_tool};
use crate::SIMULATES;
use crate::control::{Control, Edge, Frame, Plane, Tool, Transverse, Value as Datum, delivery};
use crate::machine::setup::Setup;
use crate::workpiece::seen::Turret;
use crate::workpiece::{PartErrors, Probe, Shape, Solid};
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

/// As the setup file has it.
impl Serialize for Setup {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        if SIMULATES { to_json(self).serialize(to) } else { to.serialize_unit() } // what such a build never has
    }
}

/// As the setup file has it.
impl Serialize for Solid {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        if SIMULATES { solid(self).serialize(to) } else { to.serialize_unit() }
    }
}

/// Writes a setup file that reads back to the same setup.
pub fn to_json(setup: &Setup) -> Value {
    let control = &setup.control;
    let mut setup_file = object([
        ("control", document(&control.dialect)),
        ("units", units_of(control.basic_units).into()),
        ("plane", plane_name(control.plane).into()),
        ("active", active(control)),
        ("tools", by_number(&control.tools, tool)),
        ("frames", frames(control)),
        ("data", object(control.data.iter().map(|(name, value)| (name.as_str(), datum(value))))),
        ("probe", probe(&setup.probe)),
        ("toolProbes", setup_tool::tool_probes(&setup.tool_probes)),
        ("workpiece", solids(&setup.workpiece.solids)),
        ("position", setup.position.0.into()),
    ]);
    for ((tool, edge), real) in &setup.real_tools {
        let edge = &mut setup_file["tools"][tool.to_string()]["edges"][edge.to_string()];
        if edge.is_object() {
            put(edge, "real", setup_tool::real(real));
        }
    }
    if !control.environments.is_empty() {
        put(&mut setup_file, "environments", environments(control));
    }
    if let Some(machine) = machine(setup) {
        put(&mut setup_file, "machine", machine);
    }
    if !setup.skip.is_empty() {
        let levels = setup.skip.iter().copied();
        put(&mut setup_file, "skip", levels.collect::<Value>());
    }
    setup_file
}

/// Stored tool environments by name.
fn environments(control: &Control) -> Value {
    object(control.environments.iter().map(|(name, stored)| {
        let stored = object([
            ("tool", stored.tool.into()),
            ("edge", stored.edge.into()),
            ("location", stored.location.into()),
            ("plane", plane_name(stored.plane).into()),
        ]);
        (name.as_str(), stored)
    }))
}

/// What the machine can do, where that differs from the delivery.
fn machine(setup: &Setup) -> Option<Value> {
    let control = &setup.control;
    let delivered = delivery(control.dialect);
    if control.limits == delivered.limits
        && control.spindle_positions == delivered.spindle_positions
        && control.rotary_centre == delivered.rotary_centre
        && setup.turret == Turret::default()
    {
        return None;
    }
    let limits = |side: [Option<f64>; 3]| side.into_iter().collect::<Value>();
    Some(object([
        ("limitsMinus", limits(control.limits.minus)),
        ("limitsPlus", limits(control.limits.plus)),
        ("spindlePositions", control.spindle_positions.into()),
        ("rotaryCentre", control.rotary_centre.into()),
        ("turret", turret(setup.turret)),
    ]))
}

fn turret(Turret { diameter, width }: Turret) -> Value {
    object([("diameter", diameter.into()), ("width", width.into())])
}

/// Name of a plane.
pub(super) fn plane_name(plane: Plane) -> &'static str {
    match plane {
        Plane::G17 => "G17",
        Plane::G18 => "G18",
        Plane::G19 => "G19",
    }
}

/// G function of the transverse axis.
pub(super) fn transverse_name(transverse: Transverse) -> &'static str {
    match transverse {
        Transverse::Radius => "DIAMOF",
        Transverse::Diameter => "DIAMON",
        Transverse::AbsoluteDiameter => "DIAM90",
    }
}

fn active(control: &Control) -> Value {
    let mut active = object([
        ("tool", control.tool.into()),
        ("edge", control.edge.into()),
        ("units", document(&control.unit_function())),
        ("transverse", transverse_name(control.transverse).into()),
        ("spindle", control.spindle.into()),
        ("rotary", control.rotary.into()),
    ]);
    put(&mut active, "frame", control.settable_name(control.settable));
    active
}

pub(super) fn datum(value: &Datum) -> Value {
    match value {
        Datum::Number(number) => (*number).into(),
        Datum::Text(text) => text.as_str().into(),
    }
}

/// Members by their number.
fn by_number<T>(list: &BTreeMap<i64, T>, view: fn(&T) -> Value) -> Value {
    let mut members = object([]);
    for (number, item) in list {
        put(&mut members, &number.to_string(), view(item));
    }
    members
}

fn tool(tool: &Tool) -> Value {
    object([("name", tool.name.as_str().into()), ("edges", by_number(&tool.edges, edge))])
}

fn edge(edge: &Edge) -> Value {
    let offset = |offset: &[f64; 4]| Value::from(*offset);
    let mut view = object([
        ("type", edge.kind.into()),
        ("length", edge.length.into()),
        ("radius", edge.radius.into()),
        ("lengthWear", edge.length_wear.into()),
        ("radiusWear", edge.radius_wear.into()),
    ]);
    if edge.tip != 0 {
        put(&mut view, "tip", edge.tip);
    }
    if !edge.additive.is_empty() {
        put(&mut view, "additive", by_number(&edge.additive, offset));
    }
    if !edge.setup.is_empty() {
        put(&mut view, "setup", by_number(&edge.setup, offset));
    }
    if !edge.further.is_empty() {
        let mut further = object([]);
        for (number, value) in &edge.further {
            put(&mut further, &number.to_string(), *value);
        }
        put(&mut view, "further", further);
    }
    view
}

fn probe(probe: &Probe) -> Value {
    let (constant, lobes) = probe.pre_travel;
    let (deviation, seed) = probe.repeatability;
    let mut view = object([
        ("radius", probe.radius.into()),
        ("length", probe.length.into()),
        ("skew", probe.skew.into()),
        ("preTravel", [constant, lobes].into()),
        ("delay", probe.delay.into()),
        ("repeatability", Value::Array(vec![deviation.into(), seed.into()])),
    ]);
    if let Some(way) = probe.false_signal {
        put(&mut view, "falseSignal", way);
    }
    if let Some(radius) = probe.stylus {
        put(&mut view, "stylus", radius);
    }
    put_body(&mut view, probe);
    view
}

/// The body of the probe, where it is told.
pub(super) fn put_body(view: &mut Value, probe: &Probe) {
    if let Some(body) = &probe.body {
        let body = object([("radius", body.radius.into()), ("distance", body.distance.into())]);
        put(view, "body", body);
    }
}

fn frames(control: &Control) -> Value {
    let mut frames = object([]);
    for (number, one) in &control.frames {
        put(&mut frames, &control.settable_name(*number), frame(one));
    }
    for (number, one) in &control.channel_basic {
        put(&mut frames, &format!("$P_CHBFR[{number}]"), frame(one));
    }
    for (number, one) in &control.global_basic {
        put(&mut frames, &format!("$P_NCBFR[{number}]"), frame(one));
    }
    put(&mut frames, "$P_SETFR", frame(&control.system));
    frames
}

fn frame(frame: &Frame) -> Value {
    let mut view =
        object([("coarse", frame.coarse.into()), ("fine", frame.fine.into()), ("rotation", frame.rotation.into())]);
    for (name, rotary) in [("rotary", frame.rotary), ("rotaryFine", frame.rotary_fine)] {
        if rotary != [0.0; 3] {
            put(&mut view, name, rotary);
        }
    }
    if frame.scale != Frame::default().scale {
        put(&mut view, "scale", frame.scale);
    }
    if frame.mirror != [false; 3] {
        put(&mut view, "mirror", frame.mirror.to_vec());
    }
    view
}

/// Solids as the setup file and the trace have them.
pub(super) fn solids(list: &[Solid]) -> Value {
    list.iter().map(solid).collect()
}

pub(super) fn solid(solid: &Solid) -> Value {
    let (shape, size): (&str, Value) = match solid.shape {
        Shape::Hole { diameter, depth } => ("hole", [diameter, depth].into()),
        Shape::Shaft { diameter, height } => ("shaft", [diameter, height].into()),
        Shape::Groove { width, depth, length } => ("groove", [width, depth, length].into()),
        Shape::Web { width, height, length } => ("web", [width, height, length].into()),
        Shape::Pocket { length, depth } => ("pocket", [length[0], length[1], depth].into()),
        Shape::Island { length, height } => ("island", [length[0], length[1], height].into()),
        Shape::Block { size } => ("block", size.into()),
        Shape::OuterCorner { angle, length: [x, y], height } => ("outerCorner", [angle, x, y, height].into()),
        Shape::InnerCorner { angle, length: [x, y], depth } => ("innerCorner", [angle, x, y, depth].into()),
        Shape::Turned { diameter, length, bore: [bore, depth] } => ("turned", [diameter, length, bore, depth].into()),
        Shape::Chuck { diameter, length, grip } => ("chuck", [diameter, length, grip].into()),
        Shape::Sphere { diameter } => ("sphere", [diameter].into()),
        Shape::Free(_) => ("surface", Value::Array(Vec::new())),
    };
    let mut view = object([
        ("shape", shape.into()),
        ("size", size),
        ("at", solid.at.into()),
        ("rotation", solid.rotation.into()),
        ("errors", errors(&solid.errors)),
    ]);
    if let Shape::Free(surface) = &solid.shape {
        put(&mut view, "surface", setup_surface::view(surface));
    }
    view
}

fn errors(errors: &PartErrors) -> Value {
    let (amplitude, lobes) = errors.out_of_round;
    object([
        ("shift", errors.shift.into()),
        ("size", errors.size.into()),
        ("tilt", errors.tilt.into()),
        ("taper", errors.taper.into()),
        ("outOfRound", Value::Array(vec![amplitude.into(), lobes.into()])),
    ])
}
