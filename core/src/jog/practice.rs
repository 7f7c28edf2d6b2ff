//! A machine to practise on: a mill with a probe, a tool probe and a part for each sort of measurement.

use super::mask::{Element, Mask, Task};
use crate::control::{Edge, Frame, Plane};
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::workpiece::{Shape, Solid, Tool, ToolProbe};
use serde::{Deserialize, Serialize};

/// What lies on the table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "PracticePiece"))]
pub enum Piece {
    /// A block: edges, corners, a plane.
    #[default]
    Block,
    /// A rectangular pocket.
    Pocket,
    /// A hole, which is a ring too.
    Hole,
    /// Four holes.
    Holes,
    /// A rectangular spigot.
    Island,
    /// A circular spigot.
    Spigot,
    /// Four circular spigots.
    Spigots,
    /// A tool probe alone.
    Probe,
}

/// The piece on which a mask can be practised.
pub fn piece(mask: &Mask) -> Piece {
    match mask.task {
        Task::Element(Element { round: true, inside: true }) | Task::Ring => Piece::Hole,
        Task::Element(Element { round: true, inside: false }) => Piece::Spigot,
        Task::Element(Element { inside: true, .. }) => Piece::Pocket,
        Task::Element(_) => Piece::Island,
        Task::Centres(Element { inside: true, .. }) => Piece::Holes,
        Task::Centres(_) => Piece::Spigots,
        Task::ToolProbe | Task::ToolLength | Task::ToolRadius => Piece::Probe,
        _ => Piece::Block,
    }
}

/// Middle of what lies alone, mm.
const MIDDLE: [f64; 3] = [50.0, 40.0, 0.0];
/// Middles of four.
const FOUR: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [120.0, 0.0, 0.0], [120.0, 100.0, 0.0], [0.0, 100.0, 0.0]];
/// Diameters of a hole and a spigot, mm.
const HOLE: f64 = 40.0;
const SPIGOT: f64 = 30.0;
/// The tool probe: a cube with this side and its upper face there.
const CUBE: f64 = 20.0;
const PROBE: [f64; 3] = [50.0, 40.0, 50.0];
/// T, name, length and radius of the tools, and what the control believes of both: the first one calibrates.
const TOOLS: [(i64, &str, [f64; 2], [f64; 2]); 2] =
    [(1, "CALIBRATION", [80.0, 5.0], [80.0, 5.0]), (2, "END MILL 20", [95.0, 10.0], [94.8, 9.97])];
/// G54 as the part before left it, mm.
const LEFT: [f64; 3] = [-20.0, 15.0, 10.0];

fn solids(piece: Piece) -> Vec<Solid> {
    let (one, four): (&[[f64; 3]], &[[f64; 3]]) = (&[MIDDLE], &FOUR);
    let (shape, places) = match piece {
        Piece::Block => (Shape::Block { size: [100.0, 80.0, 40.0] }, one),
        Piece::Pocket => (Shape::Pocket { length: [60.0, 44.0], depth: 30.0 }, one),
        Piece::Hole => (Shape::Hole { diameter: HOLE, depth: 30.0 }, one),
        Piece::Holes => (Shape::Hole { diameter: HOLE, depth: 30.0 }, four),
        Piece::Island => (Shape::Island { length: [50.0, 36.0], height: 40.0 }, one),
        Piece::Spigot => (Shape::Shaft { diameter: SPIGOT, height: 40.0 }, one),
        Piece::Spigots => (Shape::Shaft { diameter: SPIGOT, height: 40.0 }, four),
        Piece::Probe => return Vec::new(),
    };
    places.iter().map(|at| Solid::new(shape.clone(), Mcs(*at))).collect()
}

/// The machine with that on its table: the probe in the spindle, over the part, or beside a block.
pub fn machine(piece: Piece) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids = solids(piece);
    let control = &mut setup.control;
    control.frames.insert(1, Frame { coarse: LEFT, ..Frame::default() });
    for (tool, name, real, known) in TOOLS {
        control.tools.entry(tool).or_default().name = name.to_owned();
        let edge =
            |[length, radius]: [f64; 2]| Edge { kind: 120, length: [length, 0.0, 0.0], radius, ..Edge::default() };
        *control.edge_made(tool, 1) = edge(known);
        setup.real_tools.insert((tool, 1), Tool::nominal(&edge(real), control));
    }
    control.set("E_MESS_CAL_D[0]", HOLE);
    for name in ["E_MESS_MT_DL[0]", "E_MESS_MT_DR[0]"] {
        control.set(name, CUBE);
    }
    // trigger values, by axis in minus and in plus direction; of the applicate the upper side alone
    for (axis, middle) in PROBE.into_iter().enumerate().take(2) {
        control.set(format!("_TP[0,{}]", 2 * axis), middle + CUBE / 2.0);
        control.set(format!("_TP[0,{}]", 2 * axis + 1), middle - CUBE / 2.0);
    }
    control.set("_TP[0,4]", PROBE[2]);
    let [x, y, _] = MIDDLE;
    setup.position = match piece {
        Piece::Block => Mcs([-30.0, y, 30.0]),
        Piece::Holes | Piece::Spigots => Mcs([0.0, 0.0, 30.0]),
        Piece::Probe => {
            setup.tool_probes.push(ToolProbe::ideal(Solid::new(Shape::Block { size: [CUBE; 3] }, Mcs(PROBE))));
            let [tool, ..] = TOOLS;
            setup.control.tool = tool.0;
            setup.control.edge = 1;
            Mcs([x, y, 90.0])
        }
        _ => Mcs([x, y, 30.0]),
    };
    setup
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::jog::masks;

    // oracle: self (what a described machine is held against)
    #[test]
    fn every_machine_can_be() {
        for mask in masks::all() {
            assert_eq!(machine(piece(mask)).possible(), Ok(()), "{}", mask.name);
        }
    }
}
