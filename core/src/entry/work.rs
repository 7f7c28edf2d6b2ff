//! What an entry has to be carried out: the cycle at work, its picture, the part that it proposes.

use super::stage::{Seen, Staging};
use super::{Inputs, When};
use crate::control::Control;
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};
use crate::name::Name;
use crate::picture::{Picture, PictureShape};
use crate::workpiece::tool::Tool;
use crate::workpiece::tool_probe::ToolProbe;
use crate::workpiece::{Solid, Workpiece};

/// That a cycle is simulated.
pub struct Simulation {
    pub(super) work: Work,
    pub(super) scan: Option<Scan>,
    tool: Option<fn(i64) -> ProposedTool>,
}

impl Simulation {
    /// A part and a start for it, and what happens there.
    pub const fn new(propose: Propose, simulate: Simulate) -> Simulation {
        Simulation { work: Work { propose, simulate }, scan: None, tool: None }
    }

    /// With a scan of a surface, which can be done in pieces too.
    pub const fn with_scan(self, scan: Scan) -> Simulation {
        Simulation { scan: Some(scan), ..self }
    }

    /// With the tool that each sort of variant needs in use.
    pub const fn with_tool(self, tool: fn(i64) -> ProposedTool) -> Simulation {
        Simulation { tool: Some(tool), ..self }
    }

    /// The tool that a variant needs in use, on a machine that has none yet; none where any will do.
    pub fn tool(&self, variant: i64) -> Option<ProposedTool> {
        Some(self.tool?(variant))
    }
}

/// A cycle at work.
pub struct Work {
    /// The part that is measured.
    pub propose: Propose,
    /// What happens.
    pub simulate: Simulate,
}

/// A nominal part and a safe start position for the values of a form, for a control in this state (plane, frames).
pub type Propose = fn(&Inputs, &Control) -> Proposal;

/// What the control does.
pub type Simulate = fn(&mut dyn Machine, &Inputs) -> Result<(), Stop>;

/// A scan before its first point.
pub type Scan = fn(&mut dyn Machine, &Inputs) -> Result<Box<dyn crate::machine::Scanner>, Stop>;

/// Values as typed where the condition holds, later ones win.
pub type Examples = &'static [(When, &'static [(Name, &'static str)])];

/// How a cycle is drawn.
pub struct Drawing {
    how: How,
}

/// How the figures of a picture come about.
pub enum How {
    /// The cycle at work, with marks at it.
    Staged(Staged),
    /// Of its own.
    Own(fn(&Inputs) -> Picture),
}

/// A cycle at work as a picture shows it.
pub struct Staged {
    /// What is carried out for these values.
    pub stage: fn(&Inputs) -> Staging,
    /// Dimensions and other marks on its views.
    pub marks: fn(&Inputs, &[Seen]) -> Vec<PictureShape>,
}

impl Drawing {
    /// A picture with figures of its own.
    pub const fn new(draw: fn(&Inputs) -> Picture) -> Drawing {
        Drawing { how: How::Own(draw) }
    }

    /// A picture that follows from the work of the cycle.
    pub const fn staged(stage: fn(&Inputs) -> Staging, marks: fn(&Inputs, &[Seen]) -> Vec<PictureShape>) -> Drawing {
        Drawing { how: How::Staged(Staged { stage, marks }) }
    }

    /// How it is drawn.
    pub fn how(&self) -> &How {
        &self.how
    }

    /// How its work is drawn; none where the figures are of its own.
    pub fn at_work(&self) -> Option<&Staged> {
        match &self.how {
            How::Staged(staged) => Some(staged),
            How::Own(_) => None,
        }
    }
}

/// A nominal part with a start position from which the cycle may be called.
#[derive(Clone, Debug, Default)]
pub struct Proposal {
    /// Nominal part in machine coordinates; errors are added by the caller.
    pub workpiece: Workpiece,
    /// What stands beside it and can be touched too, machine coordinates; it has no errors.
    pub fixture: Vec<Solid>,
    /// Protection zones, machine coordinates, to be shown and not touched: a shaft, a web or an island whose walls
    /// part where the probe may go from where it may not.
    pub zones: Vec<Solid>,
    /// Position of the ball centre in the active WCS at the call, X Y Z, mm.
    pub start: Wcs,
    /// Tools that the call corrects, for a machine that has none yet.
    pub tools: Vec<ProposedTool>,
    /// Tool probes, machine coordinates, for a machine that has none yet; errors are added by the caller.
    pub tool_probes: Vec<ToolProbe>,
    /// How the tool in use lies, where its data do not tell it.
    pub real_tool: Option<Tool>,
}

/// A tool with one edge.
#[derive(Clone, Debug)]
pub struct ProposedTool {
    /// T number.
    pub tool: i64,
    /// Name under tool management.
    pub name: String,
    /// D number.
    pub edge: i64,
    /// Data of the tool.
    pub data: crate::control::Edge,
}
