//! The tool in use at a step, as the machine has it: what is drawn of it follows from this.

use super::Sim;
use crate::control::{Control, Edge, Plane};
use crate::geometry::{Dir, Mcs};
use crate::workpiece::{Cut, Spindle, Tool};

/// What is in use from one change to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct InUse {
    /// T and D number; of an NCT control T 0 and the register.
    pub place: (i64, i64),
    /// Working plane.
    pub plane: Plane,
    /// Length in effect along X Y Z, mm.
    pub length: Dir<Mcs>,
    /// Data of the cutting edge; none: no correction is in effect.
    pub edge: Option<Edge>,
    /// The tool as it is; none without a correction.
    pub tool: Option<Tool>,
    /// From the position of the machine to the end of the tool, X Y Z, mm.
    pub tip: Dir<Mcs>,
    /// How the spindle stands, of a cutter whose teeth show it.
    pub spindle: Option<Spindle>,
    /// Whether it is a turning machine, as far as its tools tell.
    pub turns: bool,
    /// Whether a turning tool lies mirrored, as the cycle in progress takes it.
    pub recoded: bool,
}

impl InUse {
    /// What is in use on a machine now. A tool that was neither told nor moved is as its data say.
    pub(super) fn of(sim: &Sim) -> InUse {
        let control = &sim.control;
        let edge = control.active_edge().cloned();
        let nominal = || edge.as_ref().map(|edge| Tool::nominal(edge, control).recoded(sim.recoded()));
        let tool = sim.real_tool().cloned().or_else(nominal);
        let tip = tool.as_ref().map_or_else(Dir::default, |tool| tool.error(control));
        InUse {
            place: control.active_place(),
            plane: control.plane,
            length: control.active_length(),
            edge,
            tool,
            tip,
            spindle: spindle(sim),
            turns: control.turns(),
            recoded: sim.recoded(),
        }
    }

    /// Whether this is still in use, and in the same way.
    pub(super) fn lasts(&self, sim: &Sim) -> bool {
        let control = &sim.control;
        self.place == control.active_place()
            && self.plane == control.plane
            && self.length == control.active_length()
            && self.edge.as_ref() == control.active_edge()
            && self.spindle == spindle(sim)
            && self.turns == control.turns()
            && self.recoded == sim.recoded()
    }
}

/// How the spindle of a control stands.
pub(super) fn stands(control: &Control) -> Spindle {
    if control.spindle_speed == 0.0 { Spindle::Stands(control.turned()) } else { Spindle::Turns }
}

fn spindle(sim: &Sim) -> Option<Spindle> {
    let toothed = sim.real_tool().is_some_and(|tool| match &tool.cut {
        Cut::Cutter(cutter) => cutter.teeth > 0,
        Cut::Nose(_) => false,
    });
    toothed.then(|| stands(&sim.control))
}
