//! A solid on the paper: its outline with what is open in it, and its boundary lines. A circle stays a circle.

use crate::entry::stage::distance;
use crate::geometry::V3;
use crate::picture::figures::frame;
use crate::picture::{PictureShape, ShapeKind, figures};
use crate::workpiece::{Column, Form, FreeSurface, Material, Solid};

/// Material around an opening, in sizes of it.
const AROUND: Material = Material { beside: [1.3, 0.0], below: [1.25, 0.0] };

/// Points of a cut surface nearer to each other than this, mm, are one: no bend between them can be seen.
const APART: f64 = 1.0;

/// A solid on the paper.
pub struct Outline {
    /// All of it, the opening left out where it is seen.
    pub body: PictureShape,
    /// Boundary of the outline: circles and straight lines.
    pub lines: Vec<PictureShape>,
}

/// A plane through a solid, machine coordinates.
#[derive(Clone, Copy)]
pub struct Cut {
    /// A point of it.
    pub at: V3,
    /// Normal of the cut, of length 1.
    pub normal: V3,
}

impl Cut {
    /// Distance of a point from it, mm; negative behind it.
    fn before(&self, point: &V3) -> f64 {
        (point - self.at).dot(&self.normal)
    }
}

/// A solid on the paper; `seen` projects a machine position or direction; `cut`: where it is cut open.
pub fn outline(solid: &Solid, kind: ShapeKind, cut: Option<Cut>, seen: impl Fn(V3) -> [f64; 2]) -> Option<Outline> {
    let place = solid.place();
    let machine = |point: V3| place.transform_point(&point.into()).coords;
    let paper = |point: V3| seen(machine(point));
    let middle = paper(V3::zeros());
    let columns = match solid.form() {
        Form::Columns(columns) => columns,
        Form::Ball(radius) => {
            let ball = |kind| figures::circle(kind, middle, radius);
            return Some(Outline { body: ball(kind), lines: vec![ball(ShapeKind::Edge)] });
        }
        Form::Free(surface) => return Some(free(&surface, kind, cut, machine, &seen)),
    };
    let (outer, opening) = (columns.outer(&AROUND), columns.opening);
    let z = seen(place.rotation * V3::z());
    let upright = z[0].hypot(z[1]);
    let leans = (1e-6..1.0 - 1e-6).contains(&upright);
    if let (Some(cut), Column::Straight(block)) = (cut.filter(|_| leans || opening.is_none()), outer) {
        let rings = [true, false].map(|upper| block.ring(upper).map(machine));
        let body = figures::polygon(kind, section(&rings, cut).into_iter().map(seen).collect());
        return Some(Outline { lines: lines(&body), body });
    }
    if upright < 1e-6 {
        let above = |column: &Column| match column {
            Column::Round(curve, _) => figures::circle(kind, middle, curve.radius),
            Column::Straight(block) => figures::polygon(kind, block.ring(true).map(paper).to_vec()),
        };
        return Some(from_above(above(&outer), opening.as_ref().map(above)));
    }
    let right = [z[1] / upright, -z[0] / upright];
    let at = |along: f64, depth: f64| [0, 1].map(|axis| middle[axis] + along * right[axis] + depth * z[axis]);
    // from where to where a column reaches across Z on the paper, and its lower end
    let span = |column: &Column| {
        let reach = |corner: V3| {
            let [x, y] = paper(corner);
            (x - middle[0]) * right[0] + (y - middle[1]) * right[1]
        };
        let all = match column {
            Column::Round(curve, _) => vec![-curve.radius, curve.radius],
            Column::Straight(block) => block.ring(true).map(reach).to_vec(),
        };
        let (left, end) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
        (left, end, column.hull().bottom)
    };
    let (left, end, low) = span(&outer);
    let mut corners = vec![at(left, 0.0), at(left, low), at(end, low), at(end, 0.0)];
    if let Some((from, to, floor)) = opening.as_ref().map(span) {
        corners.extend([at(to, 0.0), at(to, floor), at(from, floor), at(from, 0.0)]);
    }
    let body = figures::polygon(kind, corners);
    Some(Outline { lines: lines(&body), body })
}

/// A free surface: its rectangle, or where it is cut the surface with what lies below it, as deep as it is high.
fn free(
    surface: &FreeSurface,
    kind: ShapeKind,
    cut: Option<Cut>,
    machine: impl Fn(V3) -> V3,
    seen: impl Fn(V3) -> [f64; 2],
) -> Outline {
    let [low, high] = surface.bounds();
    let Some(cut) = cut else {
        let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
        let body = figures::polygon(kind, corners.map(|[x, y]| seen(machine(V3::new(x, y, high[2])))).into());
        return Outline { lines: lines(&body), body };
    };
    let corners: Vec<V3> = surface.mesh.corners().iter().map(|corner| machine(*corner)).collect();
    let behind: Vec<bool> = corners.iter().map(|corner| cut.before(corner) < 0.0).collect();
    let cut_by = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(|corner| behind[corner as usize]);
        a != b || b != c
    };
    let sides = surface.mesh.triangles().iter().filter(cut_by).flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
    let crossings = sides.filter_map(|side| crossing(side.map(|corner| corners[*corner as usize]), cut));
    let mut top: Vec<[f64; 2]> = crossings.map(&seen).collect();
    top.sort_by(|one, other| one[0].total_cmp(&other[0]));
    top.dedup_by(|one, other| distance(*one, *other) < APART);
    let bottom = seen(machine(V3::new(low[0], low[1], 2.0 * low[2] - high[2])))[1];
    let mut body = top.clone();
    body.extend(top.last().map(|end| [end[0], bottom]));
    body.extend(top.first().map(|begin| [begin[0], bottom]));
    Outline { body: figures::polygon(kind, body), lines: vec![figures::line(ShapeKind::Edge, top)] }
}

fn crossing([from, to]: [V3; 2], cut: Cut) -> Option<V3> {
    let [before, behind] = [from, to].map(|end| cut.before(&end));
    (before * behind < 0.0).then(|| from + (to - from) * (before / (before - behind)))
}

/// A figure with what is open in it, whose boundary counts.
fn from_above(outer: PictureShape, opening: Option<PictureShape>) -> Outline {
    let Some(inner) = opening else { return Outline { lines: lines(&outer), body: outer } };
    let lines = lines(&inner);
    let body = match inner.circle {
        Some(opening) => PictureShape { opening: Some(opening), ..outer },
        None => figures::polygon(outer.kind, frame(outer.points, inner.points)),
    };
    Outline { body, lines }
}

/// The corners of a section through a convex prism, in turn; `rings`: those of both its ends.
fn section([one, other]: &[[V3; 4]; 2], cut: Cut) -> Vec<V3> {
    let around = |ring: &[V3]| -> Vec<[V3; 2]> {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(from, to)| [*from, *to]).collect()
    };
    let along = one.iter().zip(other).map(|(from, to)| [*from, *to]);
    let edges = around(one).into_iter().chain(around(other)).chain(along);
    let mut corners: Vec<V3> = edges.filter_map(|edge| crossing(edge, cut)).collect();
    let middle = corners.iter().sum::<V3>() / corners.len().max(1) as f64;
    let Some(first) = corners.first().map(|corner| corner - middle) else { return corners };
    let second = cut.normal.cross(&first);
    let turn = |corner: &V3| (corner - middle).dot(&second).atan2((corner - middle).dot(&first));
    corners.sort_by(|one, other| turn(one).total_cmp(&turn(other)));
    corners
}

/// The boundary of a figure, line by line.
fn lines(figure: &PictureShape) -> Vec<PictureShape> {
    if let Some((centre, radius)) = figure.circle {
        return vec![figures::circle(ShapeKind::Edge, centre, radius)];
    }
    let next = figure.points.iter().cycle().skip(1);
    figure.points.iter().zip(next).map(|(from, to)| figures::line(ShapeKind::Edge, vec![*from, *to])).collect()
}

/// Whether a boundary line goes through a point.
pub fn meets(line: &PictureShape, point: [f64; 2]) -> bool {
    if let Some((centre, radius)) = line.circle {
        return (distance(point, centre) - radius).abs() < 1e-3;
    }
    let on = |[from, to]: [[f64; 2]; 2]| distance(from, point) + distance(point, to) - distance(from, to) < 1e-3;
    line.points.windows(2).any(|ends| on([ends[0], ends[1]]))
}
