//! A scene made of a run: the part, the tools, the motions and touches, the dimensions of the drawing.

use super::anchors::{self, Anchor};
use super::frames::{self, Frame};
use super::mesh::Mesh;
use super::paths::{self, Way};
use super::solid::{self, Figure};
use super::tool::{self, Tool};
use super::turned::{self, Diameter, Drawing};
use super::{LineGroup, LineKind, Matter, Piece, Place, Probe, Scene, Source, Standing, ToolView, View};
use super::{fit, labels};
use crate::control::Units;
use crate::geometry::{Extent, V3};
use crate::machine::{Entries, Setup, Step};
use crate::name::Name;
use crate::run::outcome::Outcome;
use crate::workpiece::{PartErrors, Shape, Solid};
use nalgebra::IsometryMatrix3;

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
    pub(super) fn made(source: &Source, told: &Source) -> Scene {
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
        let units = told.outcome.control.active_units;
        for mut label in labels::touches(&told.outcome.before, units, &told.outcome.trace.entries) {
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
        let mut figure = Figure::default();
        let mut drawn: Option<&Solid> = None;
        for (place, solid) in part.iter().chain(probes).enumerate() {
            if !drawn.is_some_and(|drawn| alike(drawn, solid)) {
                figure = solid::figure(solid);
                drawn = Some(solid);
            }
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

    pub(super) fn add_drawing(&mut self, drawing: &Drawing, edges: &[Name]) {
        let touches = self.touches.chunks_exact(6).map(|touch| [touch[0], touch[1], touch[2]]);
        let touches: Vec<[f64; 3]> = touches.collect();
        let point = |entry: usize| {
            let place = self.touch_entries.binary_search(&(entry as u32)).ok()?;
            touches.get(place).copied()
        };
        let near = |a: [f64; 3], b: [f64; 3]| (V3::from(a) - V3::from(b)).norm() < SAME;
        let units = if drawing.reading.inch { Units::Inch } else { Units::Metric };
        let touched = drawing.touched.iter().enumerate().filter_map(|(i, touched)| {
            let at = point(touched.entry)?;
            let mut later = drawing.touched[i + 1..].iter();
            let again = later.find(|later| point(later.entry).is_some_and(|point| near(at, point)));
            Some(labels::touched(at, touched.diameter, [Some(touched.entry), again.map(|again| again.entry)], units))
        });
        self.view.labels.extend(touched);
        let dimensions = turned::dimensions(&drawing.diameters, self.view.size);
        for (i, (Diameter { ends, out, set, real }, places, lines)) in dimensions.into_iter().enumerate() {
            let middle = (V3::from(ends[0]) + V3::from(ends[1])) / 2.0;
            let field = labels::explained(edges, &touches, middle, V3::from(out), real);
            let upper = i % 2 == 0;
            let at = places[usize::from(upper)].into();
            self.view.labels.extend(labels::dimension(at, upper, [set, real], field, units));
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
        self.vertices.reserve(6 * mesh.vertices.len());
        for [at, normal] in &mesh.vertices {
            self.vertices.extend([at.x, at.y, at.z, normal.x, normal.y, normal.z].map(|value| value as f32));
        }
        self.corners.reserve(3 * mesh.corners.len());
        for corners in &mesh.corners {
            self.corners.extend(corners.map(|corner| vertex as u32 + corner));
        }
        let piece = Piece {
            matter,
            corners: [corner, self.corners.len()],
            vertices: [vertex, self.vertices.len() / 6],
            place,
            tool,
        };
        self.view.pieces.push(piece);
    }

    pub(super) fn add_lines(
        &mut self,
        lines: &[[V3; 2]],
        kind: LineKind,
        place: Option<usize>,
        standing: Option<usize>,
    ) {
        if lines.is_empty() {
            return;
        }
        let first = self.lines.len() / 6;
        self.lines.reserve(6 * lines.len());
        for [from, to] in lines {
            self.lines.extend([from.x, from.y, from.z, to.x, to.y, to.z]);
        }
        self.view.groups.push(LineGroup { kind, lines: [first, self.lines.len() / 6], place, standing, field: None });
    }
}

/// Whether two solids differ in their places alone: what is drawn of them is in their own frames.
fn alike(one: &Solid, other: &Solid) -> bool {
    let PartErrors { shift, tilt, .. } = other.errors;
    one.shape == other.shape && PartErrors { shift, tilt, ..one.errors } == other.errors
}

fn place(own: &IsometryMatrix3<f64>) -> Place {
    let axes = [V3::x(), V3::y(), V3::z()].map(|axis| (own.rotation * axis).into());
    Place { at: own.translation.vector.into(), axes }
}

fn corners(extent: &Extent) -> [[f64; 3]; 2] {
    [extent.low.into(), extent.high.into()]
}

pub(super) fn extent(figure: &Figure) -> Extent {
    Extent::of(figure.mesh.vertices.iter().chain(&figure.cut.vertices).map(|[at, _]| *at))
}

/// A box in another frame.
fn seen(own: &Extent, place: &IsometryMatrix3<f64>) -> Extent {
    let ends = [own.low, own.high];
    let corner = |i: usize| V3::new(ends[i & 1].x, ends[(i >> 1) & 1].y, ends[i >> 2].z);
    Extent::of((0..8).map(|i| place.transform_point(&corner(i).into()).coords))
}
