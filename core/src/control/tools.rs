//! Tools and registers: which edge is active, what it is long and how thick, wear included. mm.

use super::{Control, Edge};
use crate::geometry::{Dir, Mcs};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Types of turning tools, the probe of a turning machine among them (B:974-985, B:8708).
pub const TURNING: RangeInclusive<i64> = 500..=599;
/// Type of the probe of a turning machine (B:974-985).
pub const LATHE_PROBE: i64 = 580;
/// Value of SD 42950 with which every tool is as long as a turning tool (B:828).
pub const AS_TURNING_TOOL: f64 = 2.0;

/// 1: cutting edge positions count the other way round in the ordinate, in the cycle that names it (B:13882, B:14051).
pub const REVERSED: &str = "_CHBIT[23]";

/// From S to P in abscissa and ordinate by cutting edge position 1 to 9, in nose radii (B:9441, B:13474-13481); with 9,
/// and where there is none, P is S. S is the centre of the nose, P the point to which the lengths refer. `reversed`:
/// the ordinate is the other way round ([`REVERSED`]).
pub fn side(position: i64, reversed: bool) -> [f64; 2] {
    let [abscissa, ordinate] = match position {
        1 => [1.0, 1.0],
        2 => [-1.0, 1.0],
        3 => [-1.0, -1.0],
        4 => [1.0, -1.0],
        5 => [1.0, 0.0],
        6 => [0.0, 1.0],
        7 => [-1.0, 0.0],
        8 => [0.0, -1.0],
        _ => [0.0, 0.0],
    };
    [abscissa, if reversed { -ordinate } else { ordinate }]
}

impl Control {
    /// Number of the tool with this name, in upper or lower case.
    pub fn tool_named(&self, name: &str) -> Option<i64> {
        self.tools.iter().find(|(_, tool)| tool.name.eq_ignore_ascii_case(name)).map(|(number, _)| *number)
    }

    /// The next T number that no tool has.
    pub fn free_tool(&self) -> i64 {
        (1..).find(|number| !self.tools.contains_key(number)).unwrap_or_default()
    }

    /// Edge D of tool T, as stored.
    pub fn edge_of(&self, tool: i64, edge: i64) -> Option<&Edge> {
        self.tools.get(&tool)?.edges.get(&edge)
    }

    /// Edge D of tool T to be changed; none when the tool or the edge is not there.
    pub fn edge_of_mut(&mut self, tool: i64, edge: i64) -> Option<&mut Edge> {
        self.tools.get_mut(&tool)?.edges.get_mut(&edge)
    }

    /// NCT register of lengths (H) and radii (D), whatever is in the spindle; one that was never written is all zero.
    pub fn register(&self, number: i64) -> Edge {
        self.edge_of(0, number).cloned().unwrap_or_default()
    }

    /// Edge D of tool T (NCT: 0 and the register), made where it is not there.
    pub fn edge_made(&mut self, tool: i64, edge: i64) -> &mut Edge {
        self.tools.entry(tool).or_default().edges.entry(edge).or_default()
    }

    /// Where the data of the edge in effect stand: T in the spindle with the active D (NCT: 0 with the register H).
    pub fn active_place(&self) -> (i64, i64) {
        (if self.make().registers { 0 } else { self.tool }, self.edge)
    }

    /// Edge in effect.
    pub fn active_edge(&self) -> Option<&Edge> {
        let (tool, edge) = self.active_place();
        if edge == 0 { None } else { self.edge_of(tool, edge) }
    }

    /// Whether the lengths of every tool count as those of a turning tool.
    pub fn all_as_turning_tools(&self) -> bool {
        self.data.length_type() == AS_TURNING_TOOL
    }

    /// Whether it is a turning machine by its tools: a turning tool is in use, or every tool is as long as one.
    pub fn turns(&self) -> bool {
        self.active_edge().is_some_and(Edge::is_turning) || self.all_as_turning_tools()
    }

    /// Axis (0 abscissa, 1 ordinate, 2 applicate) of L1, L2, L3: from the applicate on (B:762-817); of turning tools,
    /// and with SD 42950 = 2 of all, L1 in the ordinate and L2 in the abscissa (B:828, B:974-985: X and Z in G18).
    pub fn length_axes(&self, edge: &Edge) -> [usize; 3] {
        if edge.is_turning() || self.all_as_turning_tools() { [1, 0, 2] } else { [2, 1, 0] }
    }

    /// Which of L1, L2 and L3 of an edge counts along the applicate: 0, 1 or 2.
    pub fn length_along_applicate(&self, edge: &Edge) -> usize {
        self.length_axes(edge).into_iter().position(|axis| axis == 2).unwrap_or(0)
    }

    /// Length in effect along X Y Z, see [`Control::length_axes`]. 0 without a correction.
    pub fn active_length(&self) -> Dir<Mcs> {
        let mut length = Dir::default();
        if let Some(edge) = self.active_edge() {
            let (axes, location) = (self.plane.axes(), edge.location(self.location));
            for (i, axis) in self.length_axes(edge).into_iter().enumerate() {
                length[axes[axis]] = edge.total_length(i) + location[i];
            }
        }
        length
    }

    /// Radius in effect, mm; 0 without a correction.
    pub fn active_radius(&self) -> f64 {
        self.active_edge().map_or(0.0, |edge| edge.total_radius() + edge.location(self.location)[3])
    }
}

impl Edge {
    /// Geometry and wear of L1 (0), L2 (1) or L3 (2), with the length of the adapter, mm.
    pub fn total_length(&self, i: usize) -> f64 {
        let adapter = self.further.get(&(21 + i)).copied().unwrap_or(0.0);
        self.length[i] + self.length_wear[i] + adapter
    }

    /// Additive and setup offset of a DL number together: L1 L2 L3 radius, mm.
    pub fn location(&self, number: i64) -> [f64; 4] {
        let offset = |offsets: &BTreeMap<i64, [f64; 4]>| offsets.get(&number).copied().unwrap_or_default();
        let (additive, setup) = (offset(&self.additive), offset(&self.setup));
        std::array::from_fn(|i| additive[i] + setup[i])
    }

    /// Geometry and wear of the radius, mm.
    pub fn total_radius(&self) -> f64 {
        self.radius + self.radius_wear
    }

    /// Whether it is a turning tool, or the probe of a turning machine.
    pub fn is_turning(&self) -> bool {
        TURNING.contains(&self.kind)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Plane, delivery};
    use crate::dialect::Dialect;

    #[test]
    fn lengths_follow_the_plane() {
        let mut control = delivery(Dialect::Sinumerik);
        let edge = Edge { length: [50.0, 2.0, 3.0], length_wear: [0.5, 0.0, 0.0], ..Edge::default() };
        control.tools.entry(9).or_default().edges.insert(1, edge);
        (control.tool, control.edge) = (9, 1);
        // oracle: manual B:762-817
        assert_eq!(control.active_length(), [3.0, 2.0, 50.5]);
        control.plane = Plane::G18;
        assert_eq!(control.active_length(), [2.0, 50.5, 3.0]);
        control.edge = 0;
        assert_eq!(control.active_length(), [0.0; 3]);
    }

    #[test]
    fn lengths_of_turning_tools_follow_the_plane() {
        let mut control = delivery(Dialect::Sinumerik);
        let edge = Edge { kind: LATHE_PROBE, length: [40.0, 100.0, 5.0], ..Edge::default() };
        control.tools.entry(9).or_default().edges.insert(1, edge);
        (control.tool, control.edge) = (9, 1);
        // oracle: manual B:974-985, B:10425 (L1 in X, L2 in Z with G18)
        control.plane = Plane::G18;
        assert_eq!(control.active_length(), [40.0, 5.0, 100.0]);
        control.plane = Plane::G17;
        assert_eq!(control.active_length(), [100.0, 40.0, 5.0]);
    }

    #[test]
    fn on_a_turning_machine_drills_and_mills_are_as_long_as_turning_tools() {
        let mut control = delivery(Dialect::Sinumerik);
        control.plane = Plane::G18;
        (control.tool, control.edge) = (3, 1);
        for (kind, milling) in [(120, true), (200, true), (500, false)] {
            let edge = Edge { kind, length: [40.0, 100.0, 5.0], ..Edge::default() };
            control.tools.entry(3).or_default().edges.insert(1, edge);
            // oracle: manual B:828, B:9192 (2: L1 in X, L2 in Z), B:10096-10108 (0: as on a milling machine)
            control.set("SD42950", 2.0);
            assert_eq!(control.active_length(), [40.0, 5.0, 100.0]);
            control.set("SD42950", 0.0);
            let as_defined = if milling { [100.0, 40.0, 5.0] } else { [40.0, 5.0, 100.0] };
            assert_eq!(control.active_length(), as_defined, "{kind}");
        }
    }

    #[test]
    fn offsets_of_a_location_count_while_it_is_active() {
        let mut control = delivery(Dialect::Sinumerik);
        let edge = Edge {
            length: [50.0, 0.0, 0.0],
            radius: 3.0,
            additive: [(2, [0.1, 0.0, 0.0, 0.01])].into(),
            setup: [(2, [0.02, 0.0, 0.0, 0.0])].into(),
            further: [(21, 5.0)].into(),
            ..Edge::default()
        };
        control.tools.entry(9).or_default().edges.insert(1, edge);
        (control.tool, control.edge) = (9, 1);
        // oracle: hand
        assert_eq!(control.active_length()[2], 55.0);
        control.location = 2;
        assert!((control.active_length()[2] - 55.12).abs() < 1e-12);
        assert!((control.active_radius() - 3.01).abs() < 1e-12);
    }

    #[test]
    fn a_register_exists_when_written() {
        let mut control = delivery(Dialect::Nct);
        assert_eq!(control.register(98).length[0], 0.0);
        control.edge_made(0, 98).length[0] = 120.0;
        control.edge = 98;
        assert_eq!(control.active_edge().unwrap().length[0], 120.0);
    }
}
