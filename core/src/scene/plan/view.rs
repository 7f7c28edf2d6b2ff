//! Work of a cycle as one view shows it: the part, the touches, the zones and the ways on the paper.

use super::Performed;
use super::solid::{Cut, meets, outline};
use crate::entry::stage::{Look, SIZE, Seen, Touched, add, distance, ring, unit};
use crate::geometry::V3;
use crate::name::Name;
use crate::picture::figures::{circle, frame, line, polygon};
use crate::picture::{PictureShape, ShapeKind};
use crate::workpiece::{Drawn, Shape, Solid};

/// Largest and smallest radius of a touched point, mm.
const TOUCH: f64 = 1.4;
const LEAST_TOUCH: f64 = 0.8;
/// Thickness of a forbidden area around an element, mm.
const WALL: f64 = 0.12 * SIZE;

impl Performed {
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
    pub(in crate::scene) fn at(&self, look: &Look, [x, y]: [f64; 2]) -> Option<V3> {
        let (_, touch) = self.touches.iter().enumerate().find(|(index, _)| look.shows(*index))?;
        let [right, up] = self.across(look);
        let sight = self.sight(look);
        Some((right * x + up * y) / self.scale + sight * sight.dot(&touch.at))
    }

    /// The line of sight, machine coordinates, away from the paper.
    pub(in crate::scene) fn sight(&self, look: &Look) -> V3 {
        let [right, up] = self.across(look);
        right.cross(&up)
    }

    pub(super) fn view(&self, look: &Look) -> (Vec<PictureShape>, Seen) {
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

    pub(super) fn solids(&self) -> impl Iterator<Item = &Solid> {
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
    pub(super) fn shift(&mut self, by: [f64; 2]) {
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
