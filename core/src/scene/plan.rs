//! A help picture as the projection of a cycle at work: the proposed part, the touches and the ways of the simulation
//! on it, carried out with values that can be drawn, seen onto the plane and in sections beside that.

use super::Source;
use super::frames::{UNITS, system};
use super::plan_solid::{Cut, meets, outline};
use crate::catalogue::example::example;
use crate::check;
use crate::control::{AXES, Edge, MachineSort, Plane, Transverse};
use crate::entry::stage::{Look, SIZE, Seen, Staging, Touched, add, distance, ring, unit};
use crate::entry::{Inputs, Proposal, Staged, address, names};
use crate::geometry::{Around, Mcs, V3};
use crate::machine::entries::Other;
use crate::machine::{InUse, MotionKind, Setup, Sim, Step, Trace, probe_place};
use crate::name::Name;
use crate::picture::figures::{circle, frame, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};
use crate::run::call::perform;
use crate::workpiece::{Boundary, Drawn, Shape, Solid, Tool, Workpiece, seen};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Entries of a trace after which nothing more is carried out, or looked at.
const STEPS: usize = 1000;
/// Pieces in which an arc is drawn.
const PIECES: u32 = 48;
/// Free paper between two views, mm.
const GAP: f64 = 0.24 * SIZE;
/// Largest and smallest radius of a touched point, mm.
const TOUCH: f64 = 1.4;
const LEAST_TOUCH: f64 = 0.8;
/// Touches nearer to each other, mm, are one: in a picture, and of a part with errors that is touched several times.
const SAME: f64 = 1e-3;
const REPEATED: f64 = 0.2;
/// Thickness of a forbidden area around an element, mm.
const WALL: f64 = 0.12 * SIZE;
/// Values that no picture shows and that no nominal part needs: nothing is corrected, and each place is touched once.
const NEUTRAL: [(Name, f64); 14] = [
    (names::KNUM, 0.0),
    (names::TNUM, 0.0),
    (names::DLNUM, 0.0),
    (names::EVNUM, 0.0),
    (names::K, 1.0),
    (names::PRNUM, 1.0),
    (names::NMSP, 1.0),
    (names::VMS, 0.0),
    (names::TSA, 50.0),
    (names::TDIF, 50.0),
    (names::TUL, 50.0),
    (names::TLL, -50.0),
    (names::TZL, 0.0),
    (names::TMV, 0.1),
];

/// What a macro corrects and allows.
const CORRECTIONS: [Name; 7] = [address::S, address::T, address::M, address::H, address::U, address::V, address::W];

/// Views that are kept: those of a call, and those of the worked example where the cycle stops at its values.
const KEPT: usize = 2;

thread_local! {
    /// The views that were asked for last, the newest first.
    static MADE: RefCell<VecDeque<Rc<Views>>> = const { RefCell::new(VecDeque::new()) };
}

/// The picture of a call; where the cycle stops at its values, that of the worked example.
pub fn draw(inputs: &Inputs, staged: &Staged) -> Picture {
    let views = Views::of(inputs, staged);
    if views.complete {
        return drawn(&views, inputs, staged);
    }
    let example = worked(inputs);
    drawn(&Views::of(&example, staged), &example, staged)
}

/// A call as it was carried out, a mm of the machine as a mm of the paper, with the dimensions of its picture; none:
/// its picture shows no cycle at work.
pub fn to_scale(source: &Source) -> Option<Picture> {
    let inputs = source.call.as_ref()?;
    let staged = inputs.cycle.picture.at_work()?;
    let staging = Staging { scale: 1.0, then: None, ..(staged.stage)(inputs) };
    let upright = staging.looks.first().is_some_and(|look| look.up[2] != 0.0);
    let performed = Performed::done(inputs, staging, source);
    let Laid { mut shapes, seen, .. } = laid(std::slice::from_ref(&performed), GAP);
    shapes.extend((staged.marks)(inputs, &seen));
    Some(Picture { view: if upright { View::Section } else { View::Plane }, shapes })
}

/// A cycle at work, laid out on the paper.
struct Views {
    /// All that decides over them: they are made of this alone.
    tasks: Vec<Task>,
    laid: Laid,
    complete: bool,
}

/// What is carried out for a picture: values that draw well, and how it is seen.
#[derive(PartialEq)]
struct Task {
    inputs: Inputs,
    staging: Staging,
}

impl Views {
    /// The views of a call. They have few of its values, so that at most keystrokes they are those of the one before.
    fn of(inputs: &Inputs, staged: &Staged) -> Rc<Views> {
        let tasks = tasks(inputs, staged);
        let known = |made: &VecDeque<Rc<Views>>| made.iter().find(|views| views.tasks == tasks).map(Rc::clone);
        if let Some(known) = MADE.with_borrow(known) {
            return known;
        }
        let all: Vec<Performed> = tasks.iter().map(Performed::of).collect();
        let complete = all.iter().all(|one| one.complete);
        let views = Rc::new(Views { tasks, laid: laid(&all, GAP), complete });
        MADE.with_borrow_mut(|made| {
            made.push_front(Rc::clone(&views));
            made.truncate(KEPT);
        });
        views
    }
}

fn tasks(inputs: &Inputs, staged: &Staged) -> Vec<Task> {
    let mut all = Vec::new();
    let mut next = Some((staged.stage)(inputs));
    while let Some(mut staging) = next {
        next = staging.then.take().map(|staging| *staging);
        all.push(Task::of(inputs, staging));
    }
    all
}

/// All views of it, one beside the other, with their marks.
fn drawn(views: &Views, inputs: &Inputs, staged: &Staged) -> Picture {
    let Laid { shapes, seen, .. } = &views.laid;
    let mut shapes = shapes.clone();
    shapes.extend((staged.marks)(inputs, seen));
    let upright = views.tasks.iter().flat_map(|task| &task.staging.looks).next().is_some_and(|look| look.up[2] != 0.0);
    Picture { view: if upright { View::Section } else { View::Plane }, shapes }
}

/// Views on the paper: their figures, and of each what it shows and how far it was moved there.
#[derive(Default)]
pub(super) struct Laid {
    shapes: Vec<PictureShape>,
    pub(super) seen: Vec<Seen>,
    pub(super) moved: Vec<[f64; 2]>,
}

/// Lays out all views; `gap`: free paper between two of them, mm.
pub(super) fn laid(all: &[Performed], gap: f64) -> Laid {
    let mut laid = Laid::default();
    for (one, look) in all.iter().flat_map(|one| one.staging.looks.iter().map(move |look| (one, look))) {
        let (mut figures, mut view) = one.view(look);
        let middle = |extent: [[f64; 2]; 2]| (extent[0][1] + extent[1][1]) / 2.0;
        let by = match (laid.seen.first(), laid.seen.last()) {
            (Some(first), _) if look.below => {
                [first.middle()[0] - view.middle()[0], first.extent[0][1] - gap - view.extent[1][1]]
            }
            (Some(first), Some(before)) => {
                [before.extent[1][0] + gap - view.extent[0][0], middle(first.extent) - middle(view.extent)]
            }
            _ => [0.0; 2],
        };
        figures.iter_mut().for_each(|figure| figure.shift(by));
        view.shift(by);
        laid.shapes.extend(figures);
        laid.seen.push(view);
        laid.moved.push(by);
    }
    laid
}

/// The worked example of the variant in this plane.
fn worked(inputs: &Inputs) -> Inputs {
    let cycle = inputs.cycle;
    let variants = cycle.variants.iter();
    let variant = variants.clone().find(|one| one.number == inputs.variant).or(variants.clone().next());
    let typed = variant.map(|variant| example(cycle, variant)).unwrap_or_default();
    let control = crate::control::delivery(cycle.dialect);
    let Inputs { plane, diameters, body, nose, tool_type, minus, .. } = *inputs;
    Inputs { plane, diameters, body, nose, tool_type, minus, ..check::read(cycle, &typed, &control, &mut Vec::new()) }
}

/// A way that is not measured, machine coordinates, and after how many touches it comes.
struct Way {
    points: Vec<V3>,
    round: bool,
    after: usize,
}

/// A touch, machine coordinates: point, centre of the ball there and where its measuring block begins.
struct Touch {
    at: V3,
    ball: V3,
    start: V3,
}

/// Work of a cycle, as it is drawn.
pub(super) struct Performed {
    proposal: Proposal,
    pub(super) staging: Staging,
    /// The tool at the first touch, from the position of the machine on.
    tool: Vec<Drawn>,
    ways: Vec<Way>,
    touches: Vec<Touch>,
    start: V3,
    /// Zero of the call's coordinate system, and its abscissa, ordinate and applicate, machine coordinates.
    zero: V3,
    axes: [V3; 3],
    letters: [&'static str; 3],
    /// mm of the paper for a mm of the machine.
    scale: f64,
    complete: bool,
}

/// What was carried out: on what, what happened, in which plane; `same`: touches nearer than that, mm, are one.
struct Done<'a> {
    setup: &'a Setup,
    trace: &'a Trace,
    plane: Plane,
    same: f64,
}

impl Done<'_> {
    fn seen(&self, proposal: Proposal, staging: Staging) -> Performed {
        let steps: Vec<Step> = self.trace.entries.iter().take(STEPS).map(|entry| entry.step).collect();
        let steps: Vec<&Step> = steps.iter().collect();
        let to_ball = to_ball(&steps);
        let (ways, touches) = motions(&steps, to_ball, staging.all_ways, self.same);
        let (zero, axes) = system(&self.setup.control).unwrap_or(([0.0; 3], UNITS));
        Performed {
            complete: true,
            start: V3::from(self.setup.position.0) + to_ball,
            zero: zero.into(),
            axes: self.plane.axes().map(|axis| axes[axis].into()),
            letters: [""; 3],
            scale: 1.0,
            tool: before_touch(self.trace),
            proposal,
            staging,
            ways,
            touches,
        }
    }
}

impl Task {
    /// With the values that draw well in place of those of the call.
    fn of(inputs: &Inputs, staging: Staging) -> Task {
        let mut inputs = inputs.clone();
        let cycle = inputs.cycle;
        let known = |name: &Name| cycle.param(name).is_some();
        inputs.numbers.extend(NEUTRAL.into_iter().filter(|(name, _)| known(name)));
        inputs.numbers.retain(|name, _| !CORRECTIONS.contains(name) && !staging.left_out.contains(name));
        inputs.numbers.extend(staging.values.iter().copied());
        inputs.texts.clear();
        Task { inputs, staging: Staging { scale: 1.0, ..staging } } // the values are those of the picture already
    }
}

impl Performed {
    fn of(Task { inputs, staging }: &Task) -> Performed {
        let mut drawn = inputs.clone();
        drawn.plane = plane(inputs, staging);
        let mut setup = machine(inputs, staging);
        if staging.tool.is_some() {
            check::tool_in_use(&mut drawn, &setup.control);
        }
        vary(&mut drawn, staging.proposed.or(staging.variant));
        let proposal = inputs.cycle.work().map(|work| (work.propose)(&drawn, &setup.control)).unwrap_or_default();
        vary(&mut drawn, Some(staging.variant.unwrap_or(inputs.variant)));
        setup.workpiece = proposal.workpiece.clone();
        setup.tool_probes.clone_from(&proposal.tool_probes);
        let lying = proposal.real_tool.clone().map(|tool| (setup.control.active_place(), tool));
        setup.real_tools.extend(lying);
        for made in &proposal.tools {
            let tool = setup.control.tools.entry(made.tool).or_default();
            tool.edges.entry(made.edge).or_insert_with(|| made.data.clone());
        }
        setup.position = setup.control.to_machine(proposal.start);
        let mut sim = Sim::new(&setup);
        sim.trace_limit = STEPS;
        let complete = perform(&mut sim, &drawn).is_ok();
        let of = Done { setup: &setup, trace: &sim.trace, plane: drawn.plane, same: SAME };
        Performed {
            complete,
            letters: inputs.plane.axes().map(|axis| AXES[axis]),
            ..of.seen(proposal, staging.clone())
        }
    }

    /// The call as it was carried out on a setup, to be seen from where its picture is, in the size of a picture.
    pub(super) fn done(inputs: &Inputs, mut staging: Staging, source: &Source) -> Performed {
        let Source { setup, outcome, zones, .. } = source;
        let proposal = Proposal {
            workpiece: setup.workpiece.clone(),
            tool_probes: setup.tool_probes.clone(),
            zones: zones.clone(),
            ..Proposal::default()
        };
        staging.ball = setup.probe.radius * staging.scale;
        let of = Done { setup, trace: &outcome.trace, plane: inputs.plane, same: REPEATED };
        let mut done = Performed { scale: staging.scale, ..of.seen(proposal, staging) };
        let touches = &done.touches;
        done.proposal.workpiece.solids.retain(|solid| {
            let boundary = Boundary::of(&Workpiece { solids: vec![solid.clone()] });
            touches.iter().any(|touch| boundary.distance(touch.at.into()).abs() < REPEATED)
        });
        done
    }

    /// To the right and upwards on the paper, machine axes.
    fn across(&self, look: &Look) -> [V3; 2] {
        let [abscissa, ordinate, applicate] = self.axes;
        [look.right, look.up].map(|[x, y, z]| abscissa * x + ordinate * y + applicate * z)
    }

    /// A machine position or direction on the paper.
    fn seen(&self, look: &Look, point: V3) -> [f64; 2] {
        self.across(look).map(|way| (way.dot(&point) * self.scale * 1e6).round() / 1e6)
    }

    /// A place on the paper where the first touch that is shown lies, machine coordinates; none without a touch.
    pub(super) fn at(&self, look: &Look, [x, y]: [f64; 2]) -> Option<V3> {
        let (_, touch) = self.touches.iter().enumerate().find(|(index, _)| look.shows(*index))?;
        let [right, up] = self.across(look);
        let sight = self.sight(look);
        Some((right * x + up * y) / self.scale + sight * sight.dot(&touch.at))
    }

    /// The line of sight, machine coordinates, away from the paper.
    pub(super) fn sight(&self, look: &Look) -> V3 {
        let [right, up] = self.across(look);
        right.cross(&up)
    }

    fn view(&self, look: &Look) -> (Vec<PictureShape>, Seen) {
        let fields = &self.staging.fields;
        let place = |point| self.seen(look, point);
        let ball = self.staging.ball;
        let touches: Vec<Touched> = self
            .touches
            .iter()
            .enumerate()
            .take(look.until())
            .filter(|(index, _)| look.shows(*index))
            .map(|(index, touch)| Touched {
                number: index + 1,
                at: place(touch.at),
                ball: place(touch.ball),
                start: place(touch.start),
            })
            .filter(|touch| look.flat || distance(touch.start, touch.ball) > ball / 20.0)
            .collect();
        let touches = if look.tool.is_some() { self.settled(look, touches) } else { touches };
        let (mut shapes, lines) = self.part(look);
        let edges = self.edges(look, &lines, &touches);
        shapes.extend(edges.iter().cloned());
        let zones = self.zones(look, &mut shapes);
        self.ways(look, &mut shapes);
        let with = |shape: PictureShape, field: Option<Name>| PictureShape { field, ..shape };
        let mut starts: Vec<[f64; 2]> = Vec::new();
        for touch in &touches {
            shapes.push(with(line(ShapeKind::Path, vec![touch.start, touch.ball]), fields.path));
            let before = shapes.len();
            if look.balls && !starts.iter().any(|start| distance(*start, touch.start) < 1e-3) {
                shapes.push(with(circle(ShapeKind::Probe, touch.start, ball), fields.probe));
                starts.push(touch.start);
            }
            let point = with(circle(ShapeKind::Touch, touch.at, (ball * 0.3).clamp(LEAST_TOUCH, TOUCH)), fields.touch);
            let name = fields.marks.get(touch.number - 1).map(|name| (*name).to_owned());
            let text = name.or_else(|| Some(format!("{}{}", fields.mark?, touch.number)));
            shapes.push(point);
            let names = if fields.at_start { before } else { shapes.len() - 1 };
            if let Some(named) = shapes.get_mut(names) {
                named.text = text;
            }
        }
        if let (Some(field), Some(touch)) = (look.tool, touches.first()) {
            shapes.extend(self.tool.iter().map(|piece| self.piece(look, piece, touch.start).of(field)));
        }
        let start = place(self.start);
        if look.called && touches.iter().all(|touch| distance(touch.start, start) > 2.5 * ball) {
            shapes.push(with(circle(ShapeKind::Probe, start, ball), fields.probe));
        }
        let extent = extent(&shapes);
        let letters = look.axes.map(|axis| self.letters[axis]);
        let part = self::extent(&edges);
        let seen = Seen { touches, edges, part, zones, start, zero: place(self.zero), extent, ball, letters };
        (shapes, seen)
    }

    fn solids(&self) -> impl Iterator<Item = &Solid> {
        let probes = self.proposal.tool_probes.iter().map(|probe| &probe.solid);
        self.proposal.workpiece.solids.iter().chain(probes)
    }

    /// Part and tool probe with what holds them, as bodies, and the boundary lines that can be touched.
    fn part(&self, look: &Look) -> (Vec<PictureShape>, Vec<PictureShape>) {
        let kind = if look.cut { ShapeKind::Cut } else { ShapeKind::Material };
        let cut = self.cut(look);
        let seen = |solid, kind| outline(solid, kind, cut, |point| self.seen(look, point));
        let solids: Vec<&Solid> = self.solids().collect();
        let touches = self.touches.iter().take(look.until());
        let touched: Vec<usize> = touches.filter_map(|touch| nearest(&solids, touch.at)).collect();
        let holds = self.proposal.fixture.iter().filter(|_| look.held);
        let holds = holds.filter(|holds| nearest(&solids, holds.at.into()).is_some_and(|part| touched.contains(&part)));
        let mut bodies = Vec::new();
        for holds in holds {
            let of = if matches!(holds.shape, Shape::Chuck { .. }) { ShapeKind::Cut } else { ShapeKind::Material };
            bodies.extend(seen(holds, of).map(|outline| outline.body));
        }
        let mut lines = Vec::new();
        let shown = |index: &usize| touched.is_empty() || touched.contains(index);
        for (_, solid) in solids.iter().enumerate().filter(|(index, _)| shown(index)) {
            let Some(outline) = seen(solid, kind) else { continue };
            bodies.push(outline.body);
            lines.extend(outline.lines);
        }
        (bodies, lines)
    }

    /// Where a tool touches a side all along, the place next to the middle of the side; each place once.
    fn settled(&self, look: &Look, touches: Vec<Touched>) -> Vec<Touched> {
        let middle = self.solids().next().map_or([0.0; 2], |probe| self.seen(look, probe.at.into()));
        let mut settled: Vec<Touched> = Vec::new();
        for mut touch in touches {
            let [x, y] = unit(touch.ball, touch.start).map(f64::abs);
            let (axis, across) = if x > y { (0, 1) } else { (1, 0) };
            let pieces = self.tool.iter().flat_map(|piece| self.piece(look, piece, touch.ball).points);
            let touching = pieces.filter(|point| (point[axis] - touch.at[axis]).abs() < 1e-3);
            let [low, high] = touching.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
                [low.min(point[across]), high.max(point[across])]
            });
            if low <= high {
                touch.at[across] = middle[across].clamp(low, high);
            }
            if settled.iter().all(|other| distance(other.at, touch.at) > 1e-3) {
                settled.push(Touched { number: settled.len() + 1, ..touch });
            }
        }
        settled
    }

    /// A piece of a tool that stands here on the paper.
    fn piece(&self, look: &Look, piece: &Drawn, stands: [f64; 2]) -> PictureShape {
        let seen = |point: V3| self.seen(look, point);
        let (outline, axis, at) = match piece {
            Drawn::Plate { corners, .. } => {
                let corners = corners.iter().map(|corner| add(stands, seen(*corner)));
                return polygon(ShapeKind::Probe, corners.collect());
            }
            Drawn::Round { outline, axis, at } => (outline, seen(*axis), add(stands, seen(*at))),
        };
        if axis == [0.0; 2] {
            let widest = outline.iter().fold(0.0_f64, |widest, [out, _]| widest.max(*out));
            return circle(ShapeKind::Probe, at, widest);
        }
        let [x, y] = axis;
        let side = |side: f64| outline.iter().map(move |[out, up]| [up * x - side * out * y, up * y + side * out * x]);
        let around = side(1.0).chain(side(-1.0).rev());
        polygon(ShapeKind::Probe, around.map(|point| add(at, point)).collect())
    }

    /// The plane of a section: through its first touch.
    fn cut(&self, look: &Look) -> Option<Cut> {
        let touch = self.touches.iter().enumerate().find(|(index, _)| look.shows(*index))?.1;
        let [right, up] = self.across(look);
        look.cut.then(|| Cut { at: touch.at, normal: right.cross(&up) })
    }

    /// The boundary lines that are touched, in the order of the touches; of a side seen from before all.
    fn edges(&self, look: &Look, lines: &[PictureShape], touches: &[Touched]) -> Vec<PictureShape> {
        let mut edges: Vec<PictureShape> = Vec::new();
        for touch in touches {
            let all = lines.iter().find(|line| meets(line, touch.at)).map_or(lines, std::slice::from_ref);
            let shown = all.iter().filter(|line| all.len() == 1 || look.flat && line.circle.is_none());
            let fresh = shown.filter(|line| !edges.contains(line)).cloned().collect::<Vec<_>>();
            edges.extend(fresh);
        }
        let fields = self.staging.fields.edges;
        for (index, edge) in edges.iter_mut().enumerate() {
            edge.field = fields.get(index).or(fields.last()).copied();
        }
        edges
    }

    /// The zones; where what lies beyond is forbidden, that is drawn.
    fn zones(&self, look: &Look, shapes: &mut Vec<PictureShape>) -> Vec<[[f64; 2]; 2]> {
        let fields = &self.staging.fields;
        let mut corners = Vec::new();
        for zone in self.proposal.zones.iter().filter(|_| fields.zone.is_some()) {
            let Some(outline) = outline(zone, ShapeKind::Zone, None, |point| self.seen(look, point)) else { continue };
            let body = outline.body;
            let around @ [low, high] = extent(std::slice::from_ref(&body));
            let figure = |points| polygon(ShapeKind::Zone, points);
            let figures = match (fields.beyond, body.circle, look.cut) {
                (false, ..) => vec![body],
                (true, Some((centre, radius)), _) => vec![ring(ShapeKind::Zone, centre, radius, radius + WALL)],
                (true, None, false) => {
                    let wide = body.points.iter().map(|point| {
                        [0, 1].map(|axis| point[axis] + WALL * (point[axis] - (low[axis] + high[axis]) / 2.0).signum())
                    });
                    vec![figure(frame(wide.collect(), body.points.clone()))]
                }
                (true, None, true) => [[low[0] - WALL, low[0]], [high[0], high[0] + WALL]]
                    .map(|[from, to]| figure(vec![[from, low[1]], [to, low[1]], [to, high[1]], [from, high[1]]]))
                    .to_vec(),
            };
            shapes.extend(figures.into_iter().map(|shape| PictureShape { field: fields.zone, ..shape }));
            corners.push(around);
        }
        corners
    }

    /// The ways between the touches, each place once.
    fn ways(&self, look: &Look, shapes: &mut Vec<PictureShape>) {
        let mut drawn: Vec<[[f64; 2]; 2]> = Vec::new();
        let arc = self.staging.fields.arc.filter(|_| look.way.is_none());
        for way in self.ways.iter().filter(|way| (look.since..look.until()).contains(&way.after)) {
            let Some(field) = (if way.round { look.way.or(arc) } else { look.way }) else { continue };
            let mut points: Vec<[f64; 2]> = way.points.iter().map(|point| self.seen(look, *point)).collect();
            points.dedup();
            let (Some(from), Some(to)) = (points.first().copied(), points.last().copied()) else { continue };
            if points.len() < 2 || !way.round && (drawn.contains(&[from, to]) || drawn.contains(&[to, from])) {
                continue;
            }
            drawn.push([from, to]);
            shapes.push(line(ShapeKind::Path, points).of(field));
        }
    }
}

impl Seen {
    fn shift(&mut self, by: [f64; 2]) {
        for touch in &mut self.touches {
            for place in [&mut touch.at, &mut touch.ball, &mut touch.start] {
                *place = add(*place, by);
            }
        }
        self.edges.iter_mut().for_each(|edge| edge.shift(by));
        for place in self
            .zones
            .iter_mut()
            .flatten()
            .chain(&mut self.part)
            .chain(&mut self.extent)
            .chain([&mut self.start, &mut self.zero])
        {
            *place = add(*place, by);
        }
    }
}

/// Place in the list of the solid whose origin is nearest to a point.
fn nearest(solids: &[&Solid], point: V3) -> Option<usize> {
    let away = |index: &usize| (V3::from(solids[*index].at) - point).norm();
    (0..solids.len()).min_by(|one, other| away(one).total_cmp(&away(other)))
}

/// The plane in which it is carried out: that of the machine, where the cycle has one of its own.
fn plane(inputs: &Inputs, staging: &Staging) -> Plane {
    match inputs.cycle.purpose.machine {
        MachineSort::Turning => staging.plane.unwrap_or(Plane::G18),
        _ => inputs.plane,
    }
}

fn vary(inputs: &mut Inputs, variant: Option<i64>) {
    let Some(variant) = variant else { return };
    inputs.variant = variant;
    inputs.numbers.extend(inputs.cycle.variant_param().map(|name| (name, variant as f64)));
}

/// The core's own machine for the cycle, with the probe of the picture.
fn machine(inputs: &Inputs, staging: &Staging) -> Setup {
    let ball = staging.ball;
    let mut setup = Setup::for_variant(inputs.cycle, inputs.variant, plane(inputs, staging));
    for (name, value) in &staging.data {
        setup.control.set(name, *value);
    }
    if let Some(edge) = &staging.tool {
        let (tool, number) = setup.control.active_place();
        *setup.control.edge_made(tool, number) = edge.clone();
    }
    setup.control.transverse = if inputs.diameters { Transverse::Diameter } else { Transverse::Radius };
    setup.probe.radius = ball;
    setup.probe.stylus = Some(0.0); // out of the way
    let make = setup.control.make();
    let place = if make.registers { probe_place(make) } else { setup.control.active_place() };
    setup.control.calibrate(place, ball);
    let (tool, edge) = (setup.control.tool, setup.control.edge);
    if let Some(edge) = setup.control.edge_of_mut(tool, edge) {
        let lies = |tip: &i64| Edge { tip: *tip, ..edge.clone() }.body() == inputs.body;
        edge.tip = staging.tip.or_else(|| (5..=8).find(lies).filter(|_| inputs.body.is_some())).unwrap_or(edge.tip);
    }
    setup
}

/// The tool at the first touch, from the position of the machine on.
fn before_touch(trace: &Trace) -> Vec<Drawn> {
    let touches = |other: &Other| matches!(other.step, Step::Touch { .. });
    let used = trace.entries.others().find(touches).and_then(|entry| trace.in_use.get(entry.in_use));
    let tool = used.and_then(|used| Some((used, used.tool.as_ref()?)));
    let pieces = |(used, tool): (&InUse, &Tool)| seen::tool(tool, V3::from(used.length), used.plane, None).0;
    tool.map(pieces).unwrap_or_default()
}

/// From the point to which the tool length refers to the centre of the ball, as the first touch shows it.
fn to_ball(steps: &[&Step]) -> V3 {
    let touch = steps.windows(2).find_map(|pair| match pair {
        [Step::Motion { to, .. }, Step::Touch { ball, .. }] => Some(V3::from(*ball) - V3::from(*to)),
        _ => None,
    });
    touch.unwrap_or_default()
}

/// Ways and touches of a trace, each place touched once; `all`: retracting and finding nothing are ways too; `same`:
/// places nearer than that, mm, are one.
fn motions(steps: &[&Step], to_ball: V3, all: bool, same: f64) -> (Vec<Way>, Vec<Touch>) {
    let (mut ways, mut touches): (Vec<Way>, Vec<Touch>) = (Vec::new(), Vec::new());
    let mut measured = None;
    for (index, step) in steps.iter().enumerate() {
        if let Step::Motion { kind: MotionKind::Measuring, from, .. } = step {
            measured = Some(V3::from(*from) + to_ball);
        }
        match step {
            Step::Motion { kind, from, to, around, .. } if is_way(*kind, steps.get(index + 1), all) => {
                let points = course(*from, *to, around.as_ref());
                let points = points.into_iter().map(|point| V3::from(point) + to_ball).collect();
                ways.push(Way { points, round: around.is_some(), after: touches.len() });
            }
            Step::Touch { point, ball, .. } => {
                let near = |touch: &Touch| (touch.at - V3::from(*point)).norm() < same;
                if let (Some(start), false) = (measured, touches.iter().any(near)) {
                    touches.push(Touch { at: V3::from(*point), ball: V3::from(*ball), start });
                }
            }
            _ => {}
        }
    }
    (ways, touches)
}

/// Whether a motion is drawn as a way: one that measures is, where `all` are and no touch follows it.
fn is_way(kind: MotionKind, next: Option<&&Step>, all: bool) -> bool {
    match kind {
        MotionKind::Measuring => all && !matches!(next, Some(Step::Touch { .. })),
        MotionKind::Retract => all,
        _ => true,
    }
}

fn course(from: Mcs, to: Mcs, around: Option<&Around<Mcs>>) -> Vec<Mcs> {
    match around {
        Some(around) => (0..=PIECES).map(|piece| around.at(from, to, f64::from(piece) / f64::from(PIECES))).collect(),
        None => vec![from, to],
    }
}

/// Lower left and upper right corner of figures.
pub fn extent(shapes: &[PictureShape]) -> [[f64; 2]; 2] {
    let corners = |shape: &PictureShape| {
        let circle = shape.circle.map(|(centre, radius)| [-radius, radius].map(|by| centre.map(|part| part + by)));
        shape.points.iter().copied().chain(circle.into_iter().flatten()).collect::<Vec<_>>()
    };
    let all = shapes.iter().flat_map(corners);
    let [low, high] = all.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], point| {
        [[0, 1].map(|axis| low[axis].min(point[axis])), [0, 1].map(|axis| high[axis].max(point[axis]))]
    });
    if low[0] > high[0] { [[0.0; 2]; 2] } else { [low, high] }
}

#[cfg(all(test, feature = "json"))]
#[path = "pictogram/mod.rs"]
mod pictogram;
#[cfg(test)]
#[path = "plan_tests.rs"]
mod tests;
