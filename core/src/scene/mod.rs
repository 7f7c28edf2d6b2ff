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
pub mod mesh;
pub mod paths;
pub mod plan;
mod plan_solid;
pub mod solid;
#[cfg(test)]
mod tests;
pub mod tool;
pub mod turned;

use crate::entry::Inputs;
use crate::geometry::{Extent, V3};
use crate::machine::{Entries, Setup, Step};
use crate::name::Name;
use crate::run::outcome::Outcome;
use crate::workpiece::{Shape, Solid};
use anchors::Anchor;
use frames::Frame;
use labels::Label;
use mesh::Mesh;
use nalgebra::IsometryMatrix3;
use paths::Way;
use serde::Serialize;
use solid::Figure;
use tool::Tool;
use turned::{Diameter, Drawing, Reading};

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

/// Length of the normal at a touch: in radii of the ball at least, in sizes of the scene, in sizes of a solid at most.
const NORMAL: [f64; 3] = [2.5, 0.07, 0.5];
/// Length of the axes of a coordinate system, and of a stylus of which nothing is known at most; sizes of the scene.
const AXIS: f64 = 0.14;
const REACH: f64 = 0.3;
/// Numbers of a straight piece of a motion.
const WAY: usize = 8;
/// Touches that are nearer to each other, mm, are at the same place.
const SAME: f64 = 1.0;

impl Scene {
    /// What is to be seen of a run.
    pub fn of(source: &Source) -> Scene {
        Scene::made(source, source)
    }

    /// The motions alone, of a run that goes on.
    pub fn of_motions(entries: &Entries) -> Scene {
        let mut scene = Scene { view: View { entries: entries.len(), ..View::default() }, ..Scene::default() };
        scene.add_paths(entries);
        scene
    }

    /// What is to be seen of the first one, labelled with the values of the second one.
    fn made(source: &Source, told: &Source) -> Scene {
        let Source { setup, outcome, zones, limits, call, .. } = source;
        let entries = &outcome.trace.entries;
        let clamped = |solid: &Solid| setup.control.on_table(solid);
        let part: Vec<Solid> = setup.workpiece.solids.iter().map(clamped).collect();
        let turning = outcome.before.turns() || outcome.control.turns();
        let frames = frames::frames(&outcome.before, &outcome.control);
        let mut scene =
            Scene { view: View { frames, turning, entries: entries.len(), ..View::default() }, ..Scene::default() };
        let probes: Vec<Solid> = setup.tool_probes.iter().map(|probe| probe.solid.clone()).collect();
        scene.add_paths(entries);
        let ways = fit::ways(&scene.ways, setup.probe.radius);
        let (smallest, near) = scene.add_solids(&part, &probes, [zones, limits], entries, &ways);
        let size = scene.view.size;
        let [radii, shown, own] = NORMAL;
        scene.view.normal = (radii * setup.probe.radius).max((shown * size).min(own * smallest));
        scene.view.axis = AXIS * size;
        scene.add_tools(setup, outcome);
        scene.add_zones(zones, part.len() + probes.len());
        scene.add_frames();
        scene.view.labels = labels::frames(&scene.view.frames);
        scene.begins = paths::begins(&told.outcome.trace.entries);
        let staged = call.as_ref().and_then(|inputs| Some((inputs, inputs.cycle.picture.at_work()?)));
        let staging = staged.map(|(inputs, staged)| (staged.stage)(inputs));
        let edges = staging.as_ref().map_or(&[] as &[Name], |staging| staging.fields.edges);
        if turning {
            scene.add_drawing(&turned::drawing(&told.setup, &told.outcome), edges);
        }
        if let (Some((inputs, staged)), Some(staging)) = (staged, staging) {
            scene.add_anchors(anchors::anchors(source, inputs, staged, staging), near, turning, edges);
        }
        scene.view.labels.extend(labels::collisions(entries));
        scene.add_touches(told);
        scene
    }

    /// The values at the touches, each where its touch is drawn.
    fn add_touches(&mut self, told: &Source) {
        let places: Vec<[f64; 3]> = self.touches.chunks_exact(6).map(|touch| [touch[0], touch[1], touch[2]]).collect();
        for mut label in labels::touches(&told.outcome.before, &told.outcome.trace.entries) {
            let place = label.from.and_then(|entry| self.touch_entries.binary_search(&(entry as u32)).ok());
            let Some(at) = place.and_then(|place| places.get(place)) else { continue };
            label.at = *at;
            self.view.labels.push(label);
        }
    }

    /// What is to be seen of solids on which nothing happens; `radius`: of the ball, mm.
    pub fn still(solids: &[Solid], radius: f64) -> Scene {
        let mut scene = Scene::default();
        scene.add_solids(solids, &[], [&[], &[]], &Entries::default(), &Extent::default());
        scene.view.probe = Probe { ball: radius, length: radius, ..Probe::default() };
        scene
    }

    fn add_paths(&mut self, entries: &Entries) {
        let count = entries.len(); // most are straight
        self.ways.reserve_exact(WAY * count);
        self.way_entries.reserve_exact(count);
        self.way_kinds.reserve_exact(count);
        for Way { entry, kind, ends, during } in paths::ways(entries) {
            self.ways.extend(ends.as_flattened());
            self.ways.extend(during);
            self.way_entries.push(entry as u32);
            self.way_kinds.push(kind as u8); // in the order in which they are told there
        }
        for other in entries.others() {
            let (point, normal, sort) = match other.step {
                Step::Touch { point, normal, by, .. } if by.measures() => (point, normal, 0),
                Step::Touch { point, normal, .. } => (point, normal, 1),
                Step::Crash { point, normal, .. } => (point, normal, 2),
                _ => continue,
            };
            self.touches.extend(point.iter().chain(&normal.0));
            self.touch_entries.push(other.at as u32);
            self.touch_sorts.push(sort);
        }
    }

    /// Parts and tool probes, and how they stand from when on; gives the size of the smallest solid of the part, mm,
    /// and what is near all of them at the beginning.
    fn add_solids(
        &mut self,
        part: &[Solid],
        probes: &[Solid],
        [zones, limits]: [&[Solid]; 2],
        entries: &Entries,
        ways: &Extent,
    ) -> (f64, Extent) {
        let mut own = Vec::new();
        for (place, solid) in part.iter().chain(probes).enumerate() {
            let figure = solid::figure(solid);
            let matter = if matches!(solid.shape, Shape::Chuck { .. }) { Matter::Chuck } else { Matter::Part };
            self.add_mesh(&figure.mesh, matter, Some(place), None);
            self.add_mesh(&figure.cut, Matter::Cut, Some(place), None);
            self.add_lines(&figure.edges, LineKind::Edge, Some(place), None);
            own.push(extent(&figure));
        }
        let first = own.len() + zones.len();
        for (place, limit) in limits.iter().enumerate() {
            self.add_lines(&solid::figure(limit).edges, LineKind::Limit, Some(first + place), None);
        }
        let stays: Vec<Place> = probes.iter().chain(zones).chain(limits).map(|solid| place(&solid.place())).collect();
        let turned = entries.others().filter_map(|other| match other.step {
            Step::Table { solids, .. } => Some((other.at, solids.as_slice())),
            _ => None,
        });
        let mut first_near = Extent::default();
        for (entry, part) in std::iter::once((0, part)).chain(turned) {
            let placed = part.iter().chain(probes).zip(&own);
            let solids = placed.fold(Extent::default(), |all, (solid, own)| all.with(&seen(own, &solid.place())));
            let fit::Seen { near, shown } = fit::around(&solids, ways, &self.view.frames);
            let standing = self.view.standings.len();
            let below = if fit::is_some(&solids) { &solids } else { &shown };
            self.add_lines(&fit::grid(below, self.view.turning), LineKind::Grid, None, Some(standing));
            let places = part.iter().map(|solid| place(&solid.place())).chain(stays.iter().copied()).collect();
            if standing == 0 {
                self.view.size = fit::size(&shown);
                first_near = near;
            }
            let ground = fit::ground(below, self.view.turning);
            self.view.standings.push(Standing { entry, places, whole: corners(&shown), ground });
        }
        let smallest = own.iter().take(part.len()).map(|one| (one.high - one.low).max()).fold(f64::INFINITY, f64::min);
        (smallest, first_near)
    }

    /// Whatever is in use, where something moves.
    fn add_tools(&mut self, setup: &Setup, outcome: &Outcome) {
        let (tools, in_use) = tool::tools(setup, outcome);
        self.stands = paths::stands(&outcome.trace.entries, &tools).into_flattened();
        let reach = tool::stylus_reach(&setup.probe, REACH * self.view.size);
        let stylus = tool::stylus_radius(&setup.probe);
        self.view.probe = Probe { ball: setup.probe.radius, length: setup.probe.length, stylus, reach };
        self.view.in_use = in_use;
        let mut over = Vec::new();
        for (index, one) in tools.iter().enumerate() {
            let mut extent = Extent::default();
            for (matter, mesh) in tool::meshes(one, &setup.probe, reach) {
                if matter != Matter::Carrier {
                    extent = extent.with(&Extent::of(mesh.vertices.iter().map(|[at, _]| *at)));
                }
                match matter {
                    _ if self.stands.is_empty() => {}
                    Matter::Body | Matter::Ring | Matter::Carrier => over.push((mesh, matter, index)),
                    _ => self.add_mesh(&mesh, matter, None, Some(index)),
                }
            }
            let Tool { ball, tip, carrier, .. } = one;
            self.view.tools.push(ToolView {
                ball: ball.map(Into::into),
                tip: (*tip).into(),
                extent: ball.is_none().then(|| corners(&extent)),
                carried: !carrier.is_empty(),
            });
        }
        for (mesh, matter, index) in over {
            self.add_mesh(&mesh, matter, None, Some(index));
        }
    }

    /// Behind what hides; `first`: place of the first zone.
    fn add_zones(&mut self, zones: &[Solid], first: usize) {
        for (place, zone) in zones.iter().enumerate() {
            let figure = solid::zone(zone);
            self.add_mesh(&figure.mesh, Matter::Zone, Some(first + place), None);
            self.add_lines(&figure.edges, LineKind::Zone, Some(first + place), None);
        }
    }

    fn add_frames(&mut self) {
        const KINDS: [[LineKind; 3]; 2] = [
            [LineKind::AxisX, LineKind::AxisY, LineKind::AxisZ],
            [LineKind::BeforeX, LineKind::BeforeY, LineKind::BeforeZ],
        ];
        for Frame { at, axes, moved, .. } in self.view.frames.clone() {
            let at = V3::from(at);
            for (direction, kind) in axes.into_iter().zip(KINDS[usize::from(moved == Some("before"))]) {
                self.add_lines(&[[at, at + V3::from(direction) * self.view.axis]], kind, None, None);
            }
        }
    }

    fn add_drawing(&mut self, drawing: &Drawing, edges: &[Name]) {
        let touches = self.touches.chunks_exact(6).map(|touch| [touch[0], touch[1], touch[2]]);
        let touches: Vec<[f64; 3]> = touches.collect();
        let point = |entry: usize| {
            let place = self.touch_entries.binary_search(&(entry as u32)).ok()?;
            touches.get(place).copied()
        };
        let near = |a: [f64; 3], b: [f64; 3]| (V3::from(a) - V3::from(b)).norm() < SAME;
        let touched = drawing.touched.iter().enumerate().filter_map(|(i, touched)| {
            let at = point(touched.entry)?;
            let mut later = drawing.touched[i + 1..].iter();
            let again = later.find(|later| point(later.entry).is_some_and(|point| near(at, point)));
            Some(labels::touched(at, touched.diameter, [Some(touched.entry), again.map(|again| again.entry)]))
        });
        self.view.labels.extend(touched);
        let dimensions = turned::dimensions(&drawing.diameters, self.view.size);
        for (i, (Diameter { ends, out, set, real }, places, lines)) in dimensions.into_iter().enumerate() {
            let middle = (V3::from(ends[0]) + V3::from(ends[1])) / 2.0;
            let field = labels::explained(edges, &touches, middle, V3::from(out), real);
            let upper = i % 2 == 0;
            let at = places[usize::from(upper)].into();
            self.view.labels.extend(labels::dimension(at, upper, [set, real], field));
            self.add_lines(&lines, LineKind::Dimension, None, None);
        }
        self.view.reading = Some(drawing.reading);
    }

    /// Dimensions of the call; `edges`: parameters of the part itself, of which a turned one has its diameters.
    fn add_anchors(&mut self, anchors: Vec<Anchor>, near: Extent, turning: bool, edges: &[Name]) {
        for anchor in anchors.into_iter().filter_map(|anchor| anchor.within([near.low, near.high])) {
            let own = !turning && edges.contains(&anchor.field);
            let kind = if own { LineKind::Size } else { LineKind::Anchor };
            self.add_lines(&anchor.lines(turned::OVER * self.view.size), kind, None, None);
            if let Some(group) = self.view.groups.last_mut() {
                group.field = Some(anchor.field);
            }
            self.view.labels.push(labels::anchor(anchor.at, anchor.field, own));
        }
    }

    fn add_mesh(&mut self, mesh: &Mesh, matter: Matter, place: Option<usize>, tool: Option<usize>) {
        if mesh.corners.is_empty() {
            return;
        }
        let (vertex, corner) = (self.vertices.len() / 6, self.corners.len());
        self.vertices.extend(mesh.vertices.iter().flatten().flat_map(|one| one.iter().map(|value| *value as f32)));
        self.corners.extend(mesh.corners.iter().flatten().map(|corner| vertex as u32 + corner));
        let piece = Piece {
            matter,
            corners: [corner, self.corners.len()],
            vertices: [vertex, self.vertices.len() / 6],
            place,
            tool,
        };
        self.view.pieces.push(piece);
    }

    fn add_lines(&mut self, lines: &[[V3; 2]], kind: LineKind, place: Option<usize>, standing: Option<usize>) {
        if lines.is_empty() {
            return;
        }
        let first = self.lines.len() / 6;
        self.lines.extend(lines.iter().flatten().flat_map(|point| point.iter().copied()));
        self.view.groups.push(LineGroup { kind, lines: [first, self.lines.len() / 6], place, standing, field: None });
    }
}

fn place(own: &IsometryMatrix3<f64>) -> Place {
    let axes = [V3::x(), V3::y(), V3::z()].map(|axis| (own.rotation * axis).into());
    Place { at: own.translation.vector.into(), axes }
}

fn corners(extent: &Extent) -> [[f64; 3]; 2] {
    [extent.low.into(), extent.high.into()]
}

fn extent(figure: &Figure) -> Extent {
    Extent::of(figure.mesh.vertices.iter().chain(&figure.cut.vertices).map(|[at, _]| *at))
}

/// A box in another frame.
fn seen(own: &Extent, place: &IsometryMatrix3<f64>) -> Extent {
    let ends = [own.low, own.high];
    let corner = |i: usize| V3::new(ends[i & 1].x, ends[(i >> 1) & 1].y, ends[i >> 2].z);
    Extent::of((0..8).map(|i| place.transform_point(&corner(i).into()).coords))
}
