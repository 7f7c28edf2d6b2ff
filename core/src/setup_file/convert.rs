//! The setup that a file describes, and the file that describes a setup.

use super::{ActiveFile, EdgeFile, MachineFile, SetupFile, SolidFile, ToolFile, ToolProbeFile};
use crate::control::{Control, Definitions, Edge, Frame, Limits, Tool, Value, delivery_in, nct_data};
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::{Clock, Setup};
use crate::message::printable;
use crate::name::numbered;
use crate::refused::{Path, Refused};
use crate::series::draw::known;
use crate::syntax::definitions::definitions;
use crate::workpiece::{ToolProbe, Turret, Workpiece, tool};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The machine that a file describes: delivery values of the control, then what the file says.
///
/// # Errors
/// What it describes cannot be.
pub fn setup(file: SetupFile) -> Result<Setup, Refused> {
    let mut control = delivery_in(file.control, file.units);
    control.plane = file.plane;
    control.limits = Limits { minus: file.machine.limits_minus, plus: file.machine.limits_plus };
    control.spindle_positions = file.machine.spindle_positions;
    control.deflection = file.machine.deflection;
    control.rotary_centre = Mcs(file.machine.rotary_centre);
    let mut real_tools = BTreeMap::new();
    for (number, ToolFile { name, edges }) in file.tools {
        let mut tool = Tool { name, edges: BTreeMap::new() };
        for (edge, mut data) in edges {
            real_tools.extend(data.real.take().map(|real| ((number, edge), real)));
            tool.edges.insert(edge, data.into());
        }
        control.tools.insert(number, tool);
    }
    for (name, frame) in file.frames {
        place_frame(&mut control, &name, frame)?;
    }
    control.environments.extend(file.environments);
    control.definitions = defined(&file.definitions)?;
    for (name, value) in file.data {
        control.data.insert(numbered(name), value);
    }
    of_nct(&control)?;
    control.take_setting_data();
    control.fill_fields();
    activate(&mut control, &file.active)?;
    let setup = Setup {
        name: file.name,
        control,
        probe: file.probe,
        workpiece: Workpiece { solids: each("workpiece", file.workpiece, SolidFile::solid)? },
        tool_probes: each("toolProbes", file.tool_probes, tool_probe)?,
        real_tools,
        turret: file.machine.turret,
        position: Mcs(file.position),
        clock: clock(&file.clock)?,
        skip: file.skip,
        series: file.series,
        temperature: file.temperature,
    };
    setup.possible()?;
    known(&setup)?;
    Ok(setup)
}

/// Refuses a parameter of an NCT machine that cannot be. The variables are not asked: programs write them.
fn of_nct(control: &Control) -> Result<(), Refused> {
    let parameters = nct_data::all().filter(|datum| !datum.name.starts_with('#'));
    for datum in parameters.filter(|_| control.dialect == Dialect::Nct) {
        let range = &datum.element.range;
        let Some(Value::Number(number)) = control.data.get(datum.name) else { continue };
        if !range.contains(*number) || number.fract() != 0.0 {
            let refused = Refused::new("setup-datum-range", Path::of(&["data", datum.name])).number("value", *number);
            return Err(refused.number("min", range.min).number("max", range.max));
        }
    }
    Ok(())
}

/// What the lines of definition files add to a control.
///
/// # Errors
/// A line that defines nothing.
pub fn defined(lines: &[String]) -> Result<Arc<Definitions>, Refused> {
    let path = Path::of(&["definitions"]);
    let mut all = Definitions::default();
    for (index, line) in lines.iter().enumerate() {
        let found = definitions(line.as_bytes());
        if !found.problems.is_empty() || found.definitions.is_empty() && !line.trim().is_empty() {
            return Err(Refused::new("setup-definition", path.element(index)).text("text", printable(line)));
        }
        all.extend(found.definitions);
    }
    Ok(Arc::new(all))
}

/// The moment that a text names; none: that of delivery.
fn clock(text: &str) -> Result<Clock, Refused> {
    if text.is_empty() {
        return Ok(Clock::default());
    }
    let wrong = |_| Refused::new("setup-clock", Path::of(&["clock"])).text("text", printable(text));
    text.parse().map_err(wrong)
}

/// What the elements of a list stand for.
fn each<F, T>(name: &str, list: Vec<F>, read: impl Fn(F, &Path) -> Result<T, Refused>) -> Result<Vec<T>, Refused> {
    let path = Path::of(&[name]);
    list.into_iter().enumerate().map(|(index, one)| read(one, &path.element(index))).collect()
}

fn tool_probe(file: ToolProbeFile, path: &Path) -> Result<ToolProbe, Refused> {
    let ToolProbeFile { solid, pre_travel, delay, repeatability } = file;
    Ok(ToolProbe { solid: solid.solid(&path.member("solid"))?, pre_travel, delay, repeatability })
}

fn place_frame(control: &mut Control, name: &str, frame: Frame) -> Result<(), Refused> {
    let index = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.strip_suffix(']')?.parse().ok() };
    if name == "$P_SETFR" {
        control.stored.system = frame;
    } else if let Some(number) = index("$P_CHBFR[") {
        control.stored.channel.insert(number, frame);
    } else if let Some(number) = index("$P_NCBFR[") {
        control.stored.global.insert(number, frame);
    } else {
        let unknown = || Refused::new("setup-frame", Path::of(&["frames", name])).text("name", name);
        control.frames.insert(control.make().settable_named(name).ok_or_else(unknown)?, frame);
    }
    Ok(())
}

fn activate(control: &mut Control, file: &ActiveFile) -> Result<(), Refused> {
    (control.tool, control.edge) = (file.tool, file.edge);
    control.transverse = file.transverse;
    control.spindle = file.spindle;
    control.rotary = file.rotary;
    if !file.frame.is_empty() {
        let unknown = || Refused::new("setup-frame", Path::of(&["active", "frame"])).text("name", &file.frame);
        control.settable = control.make().settable_named(&file.frame).ok_or_else(unknown)?;
    }
    control.activate(control.settable);
    let number = file.units.strip_prefix('G').and_then(|digits| digits.parse().ok());
    if file.units.is_empty() || number.is_some_and(|number| control.choose_units(number)) {
        return Ok(());
    }
    Err(Refused::new("setup-units", Path::of(&["active", "units"])).text("name", &file.units))
}

/// As the setup file has it.
impl Serialize for Setup {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        SetupFile::from(self).serialize(to)
    }
}

/// A file that reads back to the same setup.
impl From<&Setup> for SetupFile {
    fn from(setup: &Setup) -> SetupFile {
        let control = &setup.control;
        SetupFile {
            control: control.dialect,
            name: setup.name.clone(),
            units: control.basic_units,
            plane: control.plane,
            active: ActiveFile {
                tool: control.tool,
                edge: control.edge,
                frame: control.make().settable_name(control.settable),
                units: format!("{:?}", control.unit_function()),
                transverse: control.transverse,
                spindle: control.spindle,
                rotary: control.rotary,
            },
            machine: MachineFile::of(control, setup.turret),
            tools: tools(setup),
            frames: frames(control),
            environments: control.environments.clone(),
            definitions: control.definitions.lines.clone(),
            data: control.data.iter().map(|(name, value)| (name.clone(), value.clone())).collect(),
            probe: setup.probe,
            tool_probes: setup.tool_probes.iter().map(Into::into).collect(),
            workpiece: setup.workpiece.solids.iter().map(Into::into).collect(),
            position: setup.position.0,
            clock: if setup.clock == Clock::default() { String::new() } else { setup.clock.to_string() },
            skip: setup.skip.clone(),
            series: setup.series.clone(),
            temperature: setup.temperature,
        }
    }
}

impl MachineFile {
    pub(super) fn of(control: &Control, turret: Turret) -> MachineFile {
        let Limits { minus, plus } = control.limits;
        MachineFile {
            limits_minus: minus,
            limits_plus: plus,
            spindle_positions: control.spindle_positions,
            rotary_centre: control.rotary_centre.0,
            deflection: control.deflection,
            turret,
        }
    }
}

fn tools(setup: &Setup) -> BTreeMap<i64, ToolFile> {
    let tool = |(number, tool): (&i64, &Tool)| {
        let edge = |(edge, data): (&i64, &Edge)| {
            let real = setup.real_tools.get(&(*number, *edge));
            (*edge, EdgeFile::of(data.clone(), real.cloned()))
        };
        (*number, ToolFile { name: tool.name.clone(), edges: tool.edges.iter().map(edge).collect() })
    };
    setup.control.tools.iter().map(tool).collect()
}

fn frames(control: &Control) -> BTreeMap<String, Frame> {
    let settable = control.frames.iter().map(|(number, frame)| (control.make().settable_name(*number), *frame));
    let channel = control.stored.channel.iter().map(|(number, frame)| (format!("$P_CHBFR[{number}]"), *frame));
    let global = control.stored.global.iter().map(|(number, frame)| (format!("$P_NCBFR[{number}]"), *frame));
    settable.chain(channel).chain(global).chain([("$P_SETFR".to_owned(), control.stored.system)]).collect()
}

impl From<&ToolProbe> for ToolProbeFile {
    fn from(probe: &ToolProbe) -> ToolProbeFile {
        let ToolProbe { ref solid, pre_travel, delay, repeatability } = *probe;
        ToolProbeFile { solid: solid.into(), pre_travel, delay, repeatability }
    }
}

impl EdgeFile {
    fn of(edge: Edge, real: Option<tool::Tool>) -> EdgeFile {
        let Edge { kind, tip, length, radius, length_wear, radius_wear, additive, setup, further } = edge;
        EdgeFile { kind, tip, length, radius, length_wear, radius_wear, additive, setup, further, real }
    }
}

impl From<EdgeFile> for Edge {
    fn from(file: EdgeFile) -> Edge {
        let EdgeFile { kind, tip, length, radius, length_wear, radius_wear, additive, setup, further, real: _ } = file;
        Edge { kind, tip, length, radius, length_wear, radius_wear, additive, setup, further }
    }
}
