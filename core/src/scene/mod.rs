//! What is to be seen of a setup and what happened on it, as plain figures in mm: triangles with the normals of the
//! exact surface, edges, paths, touches, coordinate systems, and labels as keys of messages. Colours, widths and pixels
//! are decided by who draws it.
//!
//! What belongs together lies in flat arrays, so that it can be handed over as it is. A solid is drawn in its own
//! frame, f32; [`View`] says what each part of the arrays is, where it stands and when it is there.

pub mod anchors;
mod crease;
mod crooked;
pub mod fit;
pub mod frames;
pub mod labels;
mod made;
pub mod mesh;
pub mod paths;
pub mod plan;
pub mod solid;
#[cfg(test)]
mod tests;
pub mod tool;
pub mod turned;

use crate::entry::Inputs;
use crate::machine::Setup;
use crate::name::Name;
use crate::run::outcome::Outcome;
use crate::workpiece::Solid;
use frames::Frame;
use labels::Label;
use serde::Serialize;
use turned::Reading;

/// What a piece of the triangles is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Matter {
    /// The part, or a tool probe.
    Part,
    /// Faces where a part is cut open.
    Cut,
    /// A chuck.
    Chuck,
    /// The ball of the probe, or what cuts.
    Ball,
    /// The stylus of a probe.
    Stem,
    /// The signal ring of a probe.
    Ring,
    /// A tool besides what of it cuts.
    Stylus,
    /// The body of a probe.
    Body,
    /// What carries a tool.
    Carrier,
    /// A protection zone.
    Zone,
}

/// What a group of lines is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum LineKind {
    /// Grid below everything.
    Grid,
    /// Edges of a part.
    Edge,
    /// Edges of a protection zone.
    Zone,
    /// Edges of a part with the largest errors that a call survives.
    Limit,
    /// Edges of a part without its errors, where these are exaggerated.
    Nominal,
    /// Axis X of a coordinate system.
    AxisX,
    /// Axis Y of a coordinate system.
    AxisY,
    /// Axis Z of a coordinate system.
    AxisZ,
    /// Axis X of a coordinate system before a correction moved it.
    BeforeX,
    /// Axis Y before the correction.
    BeforeY,
    /// Axis Z before the correction.
    BeforeZ,
    /// Dimensions of a drawing.
    Dimension,
    /// A dimension of the part that a parameter of the call gives.
    Size,
    /// Another dimension that a parameter of the call gives: a way, a zone, an angle.
    Anchor,
}

/// A part of the triangles.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ScenePiece", optional_fields))]
pub struct Piece {
    /// What it is.
    pub matter: Matter,
    /// Part of the corners that belongs to the piece, from and to (excluded).
    pub corners: [usize; 2],
    /// Part of the vertices that belongs to the piece.
    pub vertices: [usize; 2],
    /// Where it stands, by index in the places of a standing; none: from the position of the machine on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<usize>,
    /// With which of the tools it is there; none: always.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<usize>,
}

/// A part of the lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct LineGroup {
    /// What it is.
    pub kind: LineKind,
    /// Part of the lines that belongs to the group, from and to (excluded), in lines.
    pub lines: [usize; 2],
    /// Where it stands, by index in the places of a standing; none: machine coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<usize>,
    /// In which of the standings it is there; none: in all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standing: Option<usize>,
    /// Parameter that it explains; of a size and another dimension of a call.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<Name>,
}

/// Where the zero of a frame lies, machine coordinates, mm, and its directions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Place {
    /// Zero.
    pub at: [f64; 3],
    /// Directions X Y Z.
    pub axes: [[f64; 3]; 3],
}

/// How everything stands from an entry of the trace on: rotary axes turn the part.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Standing {
    /// From when this one is done on.
    pub entry: usize,
    /// Where each solid stands: those of the part, then what stays.
    pub places: Vec<Place>,
    /// What is shown at first, without the tool: least and greatest coordinates.
    pub whole: [[f64; 3]; 2],
    /// Of the ground: its height along the upright axis, and the spacing of its grid, mm.
    pub ground: [f64; 2],
}

/// What is in use.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SceneTool", optional_fields))]
pub struct ToolView {
    /// Direction from the ball to what holds it; none: no probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball: Option<[f64; 3]>,
    /// End of the tool, from the position of the machine on.
    pub tip: [f64; 3],
    /// Box around a tool alone, from the position of the machine on; none for a probe, whose stylus may be cut off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extent: Option<[[f64; 3]; 2]>,
    /// Whether a turret is drawn that carries it.
    pub carried: bool,
}

/// Sizes of the probe as it is drawn, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SceneProbe"))]
pub struct Probe {
    /// Radius of the ball.
    pub ball: f64,
    /// From the centre of the ball to the spindle.
    pub length: f64,
    /// Radius of the stylus.
    pub stylus: f64,
    /// From the centre of the ball to the end of the stylus.
    pub reach: f64,
}

/// What the arrays of a scene hold.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SceneView", optional_fields))]
pub struct View {
    /// Parts of the triangles: what is always there, then what may hide a part, then what is seen through.
    pub pieces: Vec<Piece>,
    /// Parts of the lines.
    pub groups: Vec<LineGroup>,
    /// How everything stands, from which entry on; at least one.
    pub standings: Vec<Standing>,
    /// Whatever was in use, each once.
    pub tools: Vec<ToolView>,
    /// From which entry on, on which of them.
    pub in_use: Vec<[usize; 2]>,
    /// The probe.
    pub probe: Probe,
    /// Diagonal of what is to be seen, mm.
    pub size: f64,
    /// Length of the normal at a touch, mm.
    pub normal: f64,
    /// Length of the axes of a coordinate system, mm.
    pub axis: f64,
    /// Coordinate systems.
    pub frames: Vec<Frame>,
    /// What is written beside all that.
    pub labels: Vec<Label>,
    /// Of a turning machine: how the control counts. Dimensions of its part are lines of that kind, and labels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reading: Option<Reading>,
    /// Whether it is a turning machine.
    pub turning: bool,
    /// How many entries the trace has.
    pub entries: usize,
    /// How many times as large the errors of the part are drawn; none: as they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exaggerated: Option<f64>,
}

/// Everything that is to be seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Six numbers a vertex: place in the frame of its piece, mm, and outward unit normal.
    pub vertices: Vec<f32>,
    /// Three vertices a triangle, counter-clockwise seen from outside.
    pub corners: Vec<u32>,
    /// Six numbers a line, mm: from and to, in the frame of its group.
    pub lines: Vec<f64>,
    /// Eight numbers a straight piece of a motion, in order: from, to, machine, mm; between which parts of the motion.
    pub ways: Vec<f64>,
    /// The entry of each.
    pub way_entries: Vec<u32>,
    /// The kind of each: 0 rapid, 1 positioning, 2 measuring, 3 retract.
    pub way_kinds: Vec<u8>,
    /// Six numbers a touch: point, machine coordinates, mm, and outward unit normal.
    pub touches: Vec<f64>,
    /// The entry of each.
    pub touch_entries: Vec<u32>,
    /// The sort of each: 0 of the ball, 1 of stylus or body, 2 a crash.
    pub touch_sorts: Vec<u8>,
    /// Three numbers an entry: centre of the ball when it is done, machine, mm. Empty where nothing moves.
    pub stands: Vec<f64>,
    /// When each entry begins, and the last one ends, s: motions take their time at their feed.
    pub begins: Vec<f64>,
    /// What all this is.
    pub view: View,
}

/// What a scene is made of.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "crate::app::Trace"))]
pub struct Source {
    /// On what it happened.
    pub setup: Setup,
    /// What happened.
    pub outcome: Outcome,
    /// Walls of protection zones, as shaft, web or island.
    pub zones: Vec<Solid>,
    /// The part with the largest errors that a call survives, on both sides.
    pub limits: Vec<Solid>,
    /// The call of the form that asked; none of a run.
    pub call: Option<Inputs>,
    /// Its steps are handed over apart, in columns: as JSON it has none.
    pub apart: bool,
}
