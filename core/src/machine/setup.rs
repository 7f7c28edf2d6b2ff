//! What a run starts from: the control, the probe as it really is, the part, and where the machine stands.

use crate::control::machine_data::TOOL_LENGTH_TYPE;
use crate::control::probe::PROBE;
use crate::control::tools::{AS_TURNING_TOOL, LATHE_PROBE};
use crate::control::{Control, Edge, Make, Plane, Transverse, Units, delivery_in};
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Clock;
use crate::machine::series::Series;
use crate::machine::temperature::Temperature;
use crate::workpiece::{Probe, Tool, ToolProbe, Turret, Workpiece};
use std::collections::{BTreeMap, BTreeSet};

/// Everything that a run starts from.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "crate::setup_file::SetupFile"))]
pub struct Setup {
    /// What the user calls the machine.
    pub name: String,
    /// State of the control.
    pub control: Control,
    /// The probe as it is.
    pub probe: Probe,
    /// The part.
    pub workpiece: Workpiece,
    /// The tool probes of the machine as they are.
    pub tool_probes: Vec<ToolProbe>,
    /// Tools that are otherwise than their data say, by T and D number.
    pub real_tools: BTreeMap<(i64, i64), Tool>,
    /// What carries the tools of a turning machine.
    pub turret: Turret,
    /// Where the point to which the tool length refers stands.
    pub position: Mcs,
    /// Date and time of the control at the start.
    pub clock: Clock,
    /// Skip levels 0 to 9 that are switched on at the panel: blocks with `/`, `/1` to `/9` are left out.
    pub skip: BTreeSet<u8>,
    /// What varies where a program is run many times.
    pub series: Series,
    /// How well the temperature of the part is known.
    pub temperature: Temperature,
}

/// T number of the probe in [`Setup::calibrated`], as in the programs of the manual (B:5855).
pub const PROBE_TOOL: i64 = 9;
/// Length register of the probe in [`Setup::calibrated`] on NCT, as in the programs of the manual (C:1159).
pub const PROBE_REGISTER: i64 = 98;

/// T and D number of the probe in [`Setup::calibrated`], of a control with registers 0 and H.
pub fn probe_place(make: &Make) -> (i64, i64) {
    if make.registers { (0, PROBE_REGISTER) } else { (PROBE_TOOL, 1) }
}

/// Data of the probe that measures: in the spindle (B:5855), or in a turret (B:10695-10709).
pub fn probe_data(turning: bool) -> Edge {
    match turning {
        true => Edge { kind: LATHE_PROBE, tip: 7, length: [40.123, 100.456, 0.0], radius: 3.0, ..Edge::default() },
        false => Edge { kind: PROBE, length: [50.0, 0.0, 0.0], radius: 3.0, ..Edge::default() },
    }
}

/// The reference grooves of the turning machine, `_KB[0,0..6]`, mm: as in B:10275-10285, and turned by 90 degree.
const REFERENCE_GROOVES: [f64; 7] = [60.123, 50.054, 15.021, 40.118, 30.047, 32.015, 20.015];

impl Setup {
    /// A metric machine with a calibrated probe; see [`Setup::calibrated_in`].
    pub fn calibrated(dialect: Dialect, plane: Plane) -> Setup {
        Setup::calibrated_in(dialect, plane, Units::Metric)
    }

    /// A control as delivered with a calibrated ideal probe in the spindle (ball 6 mm, L1 50 mm: B:5855, B:16259; on
    /// NCT the length is that to the end of the ball), nothing to touch, and the machine far above.
    pub fn calibrated_in(dialect: Dialect, plane: Plane, units: Units) -> Setup {
        let mut control = delivery_in(dialect, units);
        control.plane = plane;
        (control.tool, control.edge) = probe_place(control.make());
        if control.tool != 0 {
            control.tools.entry(control.tool).or_default().name = "PROBE".into();
        }
        *control.edge_made(control.tool, control.edge) = Edge { radius: 0.0, ..probe_data(false) };
        control.calibrate(control.active_place(), 3.0);
        control.activate(control.settable);
        let [_, _, applicate] = plane.axes();
        let mut position = [0.0; 3];
        position[applicate] = 500.0;
        Setup {
            name: String::new(),
            control,
            probe: ideal_probe(),
            workpiece: Workpiece::default(),
            tool_probes: Vec::new(),
            real_tools: BTreeMap::new(),
            turret: Turret::default(),
            position: Mcs(position),
            clock: Clock::default(),
            skip: BTreeSet::new(),
            series: Series::default(),
            temperature: Temperature::default(),
        }
    }

    /// A metric turning machine; see [`Setup::turning_in`].
    pub fn turning(plane: Plane) -> Setup {
        Setup::turning_in(plane, Units::Metric)
    }

    /// A turning machine with this basic system of units and the probe of the manual's examples in its turret,
    /// calibrated (B:10695-10709): T9, type 580, position 7; X in diameters.
    pub fn turning_in(plane: Plane, units: Units) -> Setup {
        let mut setup = Setup::calibrated_in(Dialect::Sinumerik, plane, units);
        setup.make_turning();
        setup.mount_turning_probe();
        setup
    }

    /// X in diameters, and every tool as long as a turning tool (B:828).
    pub(crate) fn make_turning(&mut self) {
        self.control.transverse = Transverse::Diameter;
        if !self.control.data.contains_key(TOOL_LENGTH_TYPE) {
            self.control.set(TOOL_LENGTH_TYPE, AS_TURNING_TOOL);
        }
    }

    /// The probe in the turret, and the grooves in which it is calibrated.
    pub(crate) fn mount_turning_probe(&mut self) {
        *self.control.edge_made(PROBE_TOOL, 1) = probe_data(true);
        for (index, value) in REFERENCE_GROOVES.into_iter().enumerate() {
            let name = format!("_KB[0,{index}]");
            if self.control.number(&name) == 0.0 {
                self.control.set(name, value / self.control.basic_factor());
            }
        }
    }
}

impl Setup {
    /// Data of a new tool of this type; a probe is as long and as thick as the real one.
    pub(crate) fn new_edge(&self, kind: i64) -> Edge {
        let (length, radius) = (self.probe.length, self.probe.radius);
        match kind {
            LATHE_PROBE if self.control.plane == Plane::G18 => Edge { radius, ..probe_data(true) },
            LATHE_PROBE => Edge {
                kind,
                tip: if self.control.plane == Plane::G19 { 8 } else { 7 },
                length: [0.0, 0.0, length],
                radius,
                ..Edge::default()
            },
            PROBE if self.control.make().registers => {
                Edge { kind, length: [length + radius, 0.0, 0.0], radius, ..Edge::default() }
            }
            PROBE => Edge { kind, length: [length, 0.0, 0.0], radius, ..Edge::default() },
            500..=599 => Edge { kind, tip: 3, radius: 0.8, ..probe_data(true) },
            _ => Edge { kind, length: [70.0, 0.0, 0.0], radius: 5.0, ..Edge::default() },
        }
    }
}

/// A probe without errors: ball 6 mm, 50 mm long.
pub fn ideal_probe() -> Probe {
    Probe { radius: 3.0, length: 50.0, repeatability: (0.0, 1), ..Probe::default() }
}
