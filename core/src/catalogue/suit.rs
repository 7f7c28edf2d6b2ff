//! Which machine a cycle needs.

use crate::catalogue::prelude::*;
use crate::control::machine_data::TOOL_LENGTH_TYPE;
use crate::control::tools::{AS_TURNING_TOOL, LATHE_PROBE};
use crate::dialect::Dialect;
use crate::machine::Setup;
use crate::machine::setup::PROBE_TOOL;

/// T number of the mill that [`Setup::suit`] brings, as in the programs of the manual (B:4872).
const MILL: i64 = 3;

/// Place and size of the first tool probe, `_TP[0,i]`, as in B:4433-4446, mm; its lower side (5), which no tool
/// touches, 22 mm lower, so that it is a cube in every plane.
const TOOL_PROBE: [(usize, f64); 8] =
    [(0, 50.0), (1, 28.0), (2, 42.0), (3, 20.0), (4, 80.0), (5, 58.0), (6, 20.0), (9, 4.0)];

/// Register of the reference tool that [`Setup::suit`] brings on NCT.
const REFERENCE_REGISTER: i64 = 99;

/// Where its tool probe stands, and the length of the reference tool, mm (C:1193-1200).
const NCT_TOOL_PROBE: [(&str, f64); 4] = [("#506", 250.0), ("#507", 300.0), ("#508", 200.0), ("#513", 100.0)];

/// Place of the first tool probe of the turning machine, `_TP[0,i]`, as in B:9044-9047, mm.
const TURNING_TOOL_PROBE: [(usize, f64); 4] = [(0, 220.0), (1, 200.0), (2, 400.0), (3, 380.0)];

impl Setup {
    /// The machine for the first variant of a cycle.
    pub fn for_cycle(cycle: &Cycle, plane: Plane) -> Setup {
        let first = cycle.variants.first();
        Setup::for_variant(cycle, first.map_or(0, |variant| variant.number), plane)
    }

    /// The machine for a variant of a cycle, metric: see [`Setup::calibrated`] and [`Setup::turning`].
    pub fn for_variant(cycle: &Cycle, variant: i64, plane: Plane) -> Setup {
        let mut setup = Setup::calibrated(cycle.dialect, plane);
        setup.suit(cycle, variant);
        setup
    }

    /// Makes a turning machine of it where the cycle is for one, with a probe in its turret where the cycle uses it,
    /// which a milling cycle gets where the machine says that it turns; for a tool probe its place and the tool that
    /// the variant needs. What the machine says of itself counts more.
    pub fn suit(&mut self, cycle: &Cycle, variant: i64) {
        if cycle.dialect == Dialect::Nct {
            if cycle.purpose.probe == ProbeUse::Tool {
                self.mount_reference_tool();
            }
            return;
        }
        let turning = cycle.purpose.machine == MachineSort::Turning;
        if turning {
            self.make_turning();
        }
        match (turning, cycle.purpose.probe) {
            (true, ProbeUse::Workpiece) => self.mount_turning_probe(),
            (true, ProbeUse::Tool) => self.know_tool_probe(&TURNING_TOOL_PROBE),
            (false, ProbeUse::Tool) => self.insert_mill(),
            (false, ProbeUse::Workpiece) => self.stand_turning_probe(),
            _ => {}
        }
        if let Some(needed) = cycle.simulation.as_ref().and_then(|simulation| simulation.tool(variant)) {
            *self.control.edge_made(needed.tool, needed.edge) = needed.data;
            self.control.tools.entry(needed.tool).or_default().name = needed.name;
            (self.control.tool, self.control.edge) = (needed.tool, needed.edge);
        }
    }

    /// A mill in the spindle, and the data of the first tool probe.
    fn insert_mill(&mut self) {
        let edge = Edge { kind: 120, length: [70.0, 0.0, 0.0], radius: 5.0, ..Edge::default() };
        *self.control.edge_made(MILL, 1) = edge;
        (self.control.tool, self.control.edge) = (MILL, 1);
        self.know_tool_probe(&TOOL_PROBE);
    }

    /// The data of the first tool probe, where nothing is known of it.
    fn know_tool_probe(&mut self, data: &[(usize, f64)]) {
        for array in ["_TP", "_TPW"] {
            let name = |index: usize| format!("{array}[0,{index}]");
            if (0..6).all(|index| self.control.number(&name(index)) == 0.0) {
                data.iter().for_each(|(index, value)| self.know(name(*index), *value));
            }
        }
    }

    /// A datum that is a length, mm.
    fn know(&mut self, name: String, length: f64) {
        let value = length / self.control.basic_factor();
        self.control.set(name, value);
    }

    /// Inserts the reference tool of an NCT control; places its tool probe, unless the machine does so itself.
    fn mount_reference_tool(&mut self) {
        (self.control.tool, self.control.edge) = (REFERENCE_REGISTER, REFERENCE_REGISTER);
        if NCT_TOOL_PROBE.iter().all(|(name, _)| self.control.number(name) == 0.0) {
            NCT_TOOL_PROBE.iter().for_each(|(name, value)| self.know((*name).to_owned(), *value));
        }
    }

    /// Where every tool is as long as a turning tool, the probe of a turning machine that stands on the plane, as long
    /// as the one of a spindle (B:4148-4152).
    fn stand_turning_probe(&mut self) {
        if self.control.number(TOOL_LENGTH_TYPE) != AS_TURNING_TOOL {
            return;
        }
        *self.control.edge_made(PROBE_TOOL, 1) = Edge {
            kind: LATHE_PROBE,
            tip: if self.control.plane == Plane::G19 { 8 } else { 7 },
            length: [0.0, 0.0, self.probe.length],
            radius: self.probe.radius,
            ..Edge::default()
        };
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::find;
    use crate::control::Transverse;

    #[test]
    fn a_turning_machine_keeps_what_it_says_of_itself() {
        let cycle = find(Dialect::Sinumerik, "CYCLE974").unwrap();
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G18);
        setup.suit(cycle, 0);
        // oracle: manual B:828 (2 in most cases), B:10275-10285
        assert_eq!(setup.control.number("SD42950"), 2.0);
        assert_eq!(setup.control.number("_KB[0,2]"), 15.021);
        assert_eq!(setup.control.transverse, Transverse::Diameter);
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G18);
        setup.control.set("SD42950", 0.0);
        setup.control.set("_KB[0,2]", 17.5);
        setup.suit(cycle, 0);
        assert_eq!(setup.control.number("SD42950"), 0.0);
        assert_eq!(setup.control.number("_KB[0,2]"), 17.5);
    }

    #[test]
    fn a_machine_that_says_it_turns_gets_a_probe_that_stands_on_the_plane() {
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        for (plane, tip, applicate) in [(Plane::G17, 7, 2), (Plane::G19, 8, 0)] {
            let mut setup = Setup::calibrated(Dialect::Sinumerik, plane);
            setup.control.set("SD42950", 2.0);
            setup.suit(cycle, 1);
            let edge = setup.control.active_edge().unwrap();
            // oracle: manual B:4148-4152 (type 5xy, 7 in G17, 8 in G19)
            assert_eq!((edge.kind, edge.tip), (580, tip));
            assert_eq!(setup.control.unfit(edge), None);
            assert_eq!(setup.control.active_length()[applicate], 50.0);
        }
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.suit(cycle, 1);
        assert_eq!(setup.control.active_edge().unwrap().kind, 710);
    }

    #[test]
    fn the_probe_is_ready() {
        let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G18);
        // oracle: manual B:762-817 (L1 along Y in G18)
        assert_eq!(setup.control.active_length(), [0.0, 50.0, 0.0]);
        assert_eq!(setup.position, [0.0, 500.0, 0.0]);
        let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
        assert_eq!(setup.control.active_length(), [0.0, 0.0, 53.0]); // C:383-393: to the end of the ball
        assert_eq!(setup.control.number("#502"), 3.0);
    }
}
