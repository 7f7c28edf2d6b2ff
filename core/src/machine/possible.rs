//! Which machines can be: a probe, tools and a part that can exist, and names that the control knows.

use super::Setup;
use super::series::MOST_RUNS;
use crate::control::{BASIC_SYSTEM, Control, Edge, Frame, Units, Value};
use crate::geometry::FARTHEST;
use crate::message::printable;
use crate::refused::{Path, Refused};
use crate::workpiece::{Cut, Cutter, PartErrors, Probe, Shape, Solid, Tool, ToolProbe, Turret};

/// Largest length, angle or feed.
const LIMIT: f64 = FARTHEST;
/// Largest number of a datum: that of the control's own numbers, which units can still be applied to.
const LARGEST: f64 = 1e300;
/// Most solids of a part; every motion is held against each.
const SOLIDS: usize = 50;
/// Most lobes of a round wall.
const LOBES: u32 = 100;
/// Most teeth of a cutter and most tool probes; every motion is held against each tooth and each probe.
const MOST: usize = 100;
/// Basic frames that a control has of each sort.
const BASIC_FRAMES: f64 = 16.0;

impl Setup {
    /// Refuses what cannot be; the first thing found is named with its value, by its place in a setup file.
    pub(crate) fn possible(&self) -> Result<(), Refused> {
        self.governs()?;
        self.varies()?;
        small(&Path::of(&["position"]), &self.position.0)?;
        if let Some(deflection) = self.control.deflection {
            within(&Path::of(&["machine", "deflection"]), deflection, [0.0, LIMIT])?;
        }
        let Turret { diameter, width } = self.turret;
        for (name, size) in [("diameter", diameter), ("width", width)] {
            within(&Path::of(&["machine", "turret", name]), size, [0.0, LIMIT])?;
        }
        self.exists()
    }

    /// Refuses a series that is endless, or spreads that are none.
    ///
    /// # Errors
    /// What is beyond its range, by its place in a setup file.
    pub fn varies(&self) -> Result<(), Refused> {
        let path = Path::of(&["temperature"]);
        within(&path.member("spread"), self.temperature.spread, [0.0, 1000.0])?;
        small(&path.member("expansion"), &[self.temperature.expansion])?;
        let path = Path::of(&["series"]);
        within(&path.member("runs"), f64::from(self.series.runs), [1.0, f64::from(MOST_RUNS)])?;
        let path = path.member("vary");
        within(&path, self.series.vary.len() as f64, [0.0, MOST as f64])?;
        for (index, vary) in self.series.vary.iter().enumerate() {
            let path = path.element(index);
            within(&path.member("sigma"), vary.sigma, [0.0, LIMIT])?;
            within(&path.member("half"), vary.half, [0.0, LIMIT])?;
            if let Some(member) = vary.unused() {
                let refused = Refused::new("setup-vary-unused", path.member(member));
                return Err(refused.text("wanted", if member == "half" { "sigma" } else { "half" }));
            }
            small(&path.member("mean"), &[vary.mean])?;
            small(&path.member("drift"), &[vary.drift])?;
            small(&path.member("values"), &vary.values)?;
            let follows = path.member("follows");
            vary.follows.iter().try_for_each(|(name, factor)| small(&follows.member(name), &[*factor]))?;
            if !vary.says_something() {
                return Err(Refused::new("setup-vary-nothing", path).text("name", vary.what.as_str()));
            }
        }
        Ok(())
    }

    /// Refuses frames and data with which a control cannot calculate.
    fn governs(&self) -> Result<(), Refused> {
        let control = &self.control;
        let frames = Path::of(&["frames"]);
        for (number, one) in &control.frames {
            frame(&frames.member(control.make().settable_name(*number)), one)?;
        }
        for (store, stored) in [("$P_CHBFR", &control.stored.channel), ("$P_NCBFR", &control.stored.global)] {
            for (number, one) in stored {
                let path = frames.member(format!("{store}[{number}]"));
                within(&path, *number as f64, [0.0, BASIC_FRAMES - 1.0])?;
                frame(&path, one)?;
            }
        }
        frame(&frames.member("$P_SETFR"), &control.stored.system)?;
        for (number, tool) in &control.tools {
            tool.edges.iter().try_for_each(|(edge, data)| edge_data(*number, *edge, data))?;
        }
        small(&Path::of(&["active", "spindle"]), &[control.spindle.0])?;
        small(&Path::of(&["active", "rotary"]), &control.rotary.map(|angle| angle.0))?;
        small(&Path::of(&["machine", "rotaryCentre"]), &control.rotary_centre.0)?;
        in_spindle(control)?;
        self.has_its_data()
    }

    /// Refuses data that the control does not have.
    pub(crate) fn has_its_data(&self) -> Result<(), Refused> {
        self.control.data.iter().try_for_each(|(name, value)| datum(&self.control, name, value))?;
        has_its_units(&self.control)?;
        has_its_settings(&self.control)
    }

    /// Refuses a probe, tools, tool probes and a part that cannot exist.
    pub(crate) fn exists(&self) -> Result<(), Refused> {
        probe(&self.probe)?;
        let at = Path::of(&["toolProbes"]);
        count("setup-tool-probes", &at, self.tool_probes.len(), MOST)?;
        for (number, probe) in self.tool_probes.iter().enumerate() {
            tool_probe(&at.element(number), probe)?;
        }
        for ((tool, edge), real) in &self.real_tools {
            real_tool(&edge_path(*tool, *edge).member("real"), real)?;
        }
        let at = Path::of(&["workpiece"]);
        let solids = &self.workpiece.solids;
        count("setup-solids", &at, solids.len(), SOLIDS)?;
        solids.iter().enumerate().try_for_each(|(number, one)| solid(&at.element(number), one))
    }
}

/// MD 10240 is the basic system (B:13594): another one than the machine has would count for nothing.
fn has_its_units(control: &Control) -> Result<(), Refused> {
    let Some(Value::Number(metric)) = control.data.get(BASIC_SYSTEM) else { return Ok(()) };
    let units = if *metric == 0.0 { Units::Inch } else { Units::Metric };
    if units == control.basic_units {
        return Ok(());
    }
    let refused = Refused::new("setup-basic", Path::of(&["data", BASIC_SYSTEM])).number("value", *metric);
    Err(refused.text("units", control.basic_units.name()))
}

/// A setting datum that a newer control does not have, or not with this index, would count for nothing.
fn has_its_settings(control: &Control) -> Result<(), Refused> {
    let Some((name, there)) = control.without_place() else { return Ok(()) };
    let path = Path::of(&["data", &name]);
    let [first, .., last] = &there[..] else {
        let key = if there.is_empty() { "setup-setting-other" } else { "setup-setting-single" };
        return Err(Refused::new(key, path).text("name", printable(&name)));
    };
    Err(Refused::new("setup-setting-place", path).text("first", first).text("last", last))
}

fn edge_path(tool: i64, edge: i64) -> Path {
    Path::of(&["tools"]).member(tool).member("edges").member(edge)
}

fn edge_data(tool: i64, edge: i64, data: &Edge) -> Result<(), Refused> {
    let path = edge_path(tool, edge);
    let of_edge = |refused: Refused| Refused {
        message: crate::message::Message { key: "setup-edge".into(), ..refused.message.clone() }
            .number("tool", tool as f64)
            .number("edge", edge as f64),
        ..refused
    };
    let values = |name: &str, values: &[f64]| small(&path.member(name), values).map_err(of_edge);
    values("length", &data.length)?;
    values("lengthWear", &data.length_wear)?;
    values("radius", &[data.radius])?;
    values("radiusWear", &[data.radius_wear])?;
    for (name, offsets) in [("additive", &data.additive), ("setup", &data.setup)] {
        offsets.values().try_for_each(|offsets| values(name, offsets))?;
    }
    Ok(())
}

/// The tool and the edge that are said to be active are there; an NCT register always is.
fn in_spindle(control: &Control) -> Result<(), Refused> {
    let (tool, edge) = (control.tool, control.edge);
    let there = match (tool, edge) {
        (0, _) => true,
        (_, 0) => control.tools.contains_key(&tool),
        _ => control.edge_of(tool, edge).is_some(),
    };
    if there || control.make().registers {
        return Ok(());
    }
    Err(Refused::new("setup-active", Path::of(&["active"])).text("name", format!("T{tool} D{edge}")))
}

/// User data, R parameters and # variables must exist, and hold what they are given.
fn datum(control: &Control, name: &str, value: &Value) -> Result<(), Refused> {
    let path = Path::of(&["data", name]);
    if let Value::Number(number) = value
        && (number.is_nan() || number.abs() > LARGEST)
    {
        return Err(Refused::new("setup-large", path).text("value", format!("{number:e}")));
    }
    if control.knows(name, value) { Ok(()) } else { Err(Refused::new("setup-datum", path).text("name", name)) }
}

fn frame(path: &Path, frame: &Frame) -> Result<(), Refused> {
    let members = [
        ("coarse", frame.coarse),
        ("fine", frame.fine),
        ("rotation", frame.rotation.0),
        ("rotary", frame.rotary.map(|angle| angle.0)),
        ("rotaryFine", frame.rotary_fine.map(|angle| angle.0)),
    ];
    members.iter().try_for_each(|(name, values)| small(&path.member(name), values))
}

fn probe(probe: &Probe) -> Result<(), Refused> {
    let path = Path::of(&["probe"]);
    above(&path.member("radius"), probe.radius)?;
    within(&path.member("repeatability"), probe.repeatability.0, [0.0, 1.0])?;
    if let Some(radius) = probe.stylus {
        within(&path.member("stylus"), radius, [0.0, LIMIT])?;
    }
    if let Some(body) = &probe.body {
        above(&path.member("body").member("radius"), body.radius)?;
        above(&path.member("body").member("distance"), body.distance)?;
    }
    small(&path.member("length"), &[probe.length])?;
    small(&path.member("skew"), &probe.skew)?;
    small(&path.member("preTravel"), &[probe.pre_travel.0, probe.pre_travel.1])?;
    small(&path.member("delay"), &[probe.delay])
}

/// A tool probe is a cube, or a disc without bore.
fn tool_probe(path: &Path, probe: &ToolProbe) -> Result<(), Refused> {
    solid(&path.member("solid"), &probe.solid)?;
    let cap = match probe.solid.shape {
        Shape::Block { .. } => true,
        Shape::Turned { bore: [bore, _], .. } => bore == 0.0,
        _ => false,
    };
    if !cap {
        return Err(Refused::new("setup-cap", path.member("solid")));
    }
    small(path, &[probe.pre_travel, probe.delay, probe.repeatability.0])
}

fn real_tool(path: &Path, tool: &Tool) -> Result<(), Refused> {
    small(&path.member("length"), &tool.length)?;
    let path = path.member("cut");
    match &tool.cut {
        Cut::Nose(nose) => {
            let path = path.member("nose");
            within(&path.member("radius"), nose.radius, [0.0, LIMIT])?;
            let wrong = nose.side.iter().find(|side| ![-1.0, 0.0, 1.0].contains(*side));
            wrong.map_or(Ok(()), |side| Err(Refused::new("setup-side", path.member("side")).number("value", *side)))
        }
        Cut::Cutter(one) => cutter(&path.member("cutter"), one),
    }
}

fn cutter(path: &Path, cutter: &Cutter) -> Result<(), Refused> {
    let [inside, above] = cutter.chamfer;
    let sizes = [("radius", cutter.radius), ("corner", cutter.corner), ("chamfer", inside), ("chamfer", above)];
    for (name, size) in sizes.into_iter().chain([("disc", cutter.disc)]) {
        within(&path.member(name), size, [0.0, LIMIT])?;
    }
    count("setup-teeth", &path.member("teeth"), cutter.teeth as usize, MOST)?;
    within(&path.member("axis"), cutter.axis as f64, [0.0, 2.0])?;
    let least = cutter.radius - cutter.corner - inside;
    bound(least >= 0.0, || Refused::new("setup-cutter", path.clone()).number("value", least))?;
    small(path, &[cutter.angle.0, cutter.runout[0], cutter.runout[1], cutter.runout_angle.0])
}

/// Refuses a solid that cannot exist, by its place below `path`: sizes are above 0, also where errors make it smaller.
pub(crate) fn solid(path: &Path, solid: &Solid) -> Result<(), Refused> {
    let errors = &solid.errors;
    let at = path.member("errors");
    small(&path.member("at"), &solid.at.0)?;
    small(&path.member("rotation"), &solid.rotation.0)?;
    small(&at.member("shift"), &errors.shift)?;
    small(&at.member("tilt"), &errors.tilt.0)?;
    if let Shape::Free(_) = solid.shape {
        return Ok(()); // looked at where it was made; no error changes its size
    }
    nominal(&path.member("size"), &solid.shape)?;
    with_errors(path, &solid.shape, errors)
}

fn nominal(path: &Path, shape: &Shape) -> Result<(), Refused> {
    if let Shape::OuterCorner { angle, .. } | Shape::InnerCorner { angle, .. } = *shape {
        within(path, angle.0, [1.0, 179.0])?;
    }
    let (across, deep) = sizes(shape);
    across.iter().chain([&deep]).try_for_each(|size| above(path, *size))?;
    if let Shape::Turned { diameter, length, bore: [bore, depth] } = *shape {
        let holds = bore == 0.0 || bore < diameter && depth > 0.0 && depth < length;
        return bound(holds, || Refused::new("setup-bore", path.clone()).number("value", bore));
    }
    Ok(())
}

/// What the errors leave of the sizes.
fn with_errors(path: &Path, shape: &Shape, errors: &PartErrors) -> Result<(), Refused> {
    let (across, deep) = sizes(shape);
    let (amplitude, lobes) = errors.out_of_round;
    count("setup-lobes", &path.member("errors").member("outOfRound"), lobes as usize, LOBES as usize)?;
    let least = across.iter().copied().fold(f64::INFINITY, f64::min) + errors.size - 2.0 * amplitude.abs();
    let bottom = least + errors.taper * deep;
    for (key, size) in [("setup-least", least), ("setup-bottom", bottom)] {
        let refused = || Refused::new(key, path.clone()).number("value", size).number("max", LIMIT);
        bound(size > 0.0 && size <= LIMIT, refused)?;
    }
    Ok(())
}

/// Sizes across, to which errors add, and the depth.
fn sizes(shape: &Shape) -> (Vec<f64>, f64) {
    match *shape {
        Shape::Hole { diameter, depth } => (vec![diameter], depth),
        Shape::Shaft { diameter, height } => (vec![diameter], height),
        Shape::Groove { width, depth, length } => (vec![width, length], depth),
        Shape::Web { width, height, length } => (vec![width, length], height),
        Shape::Pocket { length, depth } => (length.to_vec(), depth),
        Shape::Island { length, height } => (length.to_vec(), height),
        Shape::Block { size: [x, y, z] } => (vec![x, y], z),
        Shape::OuterCorner { angle, length, height: deep } | Shape::InnerCorner { angle, length, depth: deep } => {
            (length.map(|l| l * angle.sin_cos().0).to_vec(), deep)
        }
        Shape::Turned { diameter, length, bore: [bore, _] } => match bore == 0.0 {
            true => (vec![diameter], length),
            false => (vec![diameter, bore], length),
        },
        Shape::Chuck { diameter, length, grip } => (vec![diameter, grip], length),
        Shape::Sphere { diameter } => (vec![diameter], diameter),
        Shape::Free(_) => (Vec::new(), 0.0),
    }
}

/// Lengths, angles or times that can be calculated with.
fn small(path: &Path, values: &[f64]) -> Result<(), Refused> {
    values.iter().try_for_each(|value| within(path, *value, [-LIMIT, LIMIT]))
}

/// A value from here to there, both included.
fn within(path: &Path, value: f64, [min, max]: [f64; 2]) -> Result<(), Refused> {
    let refused = || Refused::new("setup-range", path.clone()).number("value", value);
    bound((min..=max).contains(&value), || refused().number("min", min).number("max", max))
}

/// A size: more than 0.
fn above(path: &Path, value: f64) -> Result<(), Refused> {
    let refused = || Refused::new("setup-above", path.clone()).number("value", value);
    bound(value > 0.0 && value <= LIMIT, || refused().number("min", 0.0).number("max", LIMIT))
}

fn count(key: &'static str, path: &Path, count: usize, most: usize) -> Result<(), Refused> {
    let refused = || Refused::new(key, path.clone()).number("value", count as f64);
    bound(count <= most, || refused().number("max", most as f64))
}

fn bound(holds: bool, refused: impl FnOnce() -> Refused) -> Result<(), Refused> {
    if holds { Ok(()) } else { Err(refused()) }
}
