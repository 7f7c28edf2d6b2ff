//! A solid on the paper: its outline with what is open in it, and its boundary lines. A circle stays a circle.

use crate::entry::stage::distance;
use crate::geometry::{V3, rigid};
use crate::picture::figures::frame;
use crate::picture::{PictureShape, ShapeKind, figures};
use crate::workpiece::{Shape, Solid};

/// Material beside an opening, in sizes of the opening.
const BESIDE: f64 = 1.3;
/// The same below it.
const BELOW: f64 = 1.25;

/// A section across Z of a solid, mm in its own X and Y.
enum Profile {
    Round(f64),
    Corners(Vec<[f64; 2]>),
}

/// A solid as a profile drawn along Z, with an opening at its top.
struct Prism {
    outer: Profile,
    /// From the face at 0 down to here.
    low: f64,
    opening: Option<(Profile, f64)>,
}

fn prism(shape: &Shape) -> Option<Prism> {
    let solid = |outer, low: f64| Prism { outer, low: -low, opening: None };
    let open = |outer, opening, depth: f64| Prism { outer, low: -depth * BELOW, opening: Some((opening, -depth)) };
    let corners = |x: f64, y: f64| Profile::Corners(figures::corners([0.0; 2], [x, y]));
    Some(match *shape {
        Shape::Hole { diameter, depth } => {
            open(corners(diameter * BESIDE, diameter * BESIDE), Profile::Round(diameter / 2.0), depth)
        }
        Shape::Shaft { diameter, height } => solid(Profile::Round(diameter / 2.0), height),
        Shape::Groove { width, depth, length } => open(corners(width * BESIDE, length), corners(width, length), depth),
        Shape::Web { width, height, length } => solid(corners(width, length), height),
        Shape::Pocket { length: [x, y], depth } => open(corners(x * BESIDE, y * BESIDE), corners(x, y), depth),
        Shape::Island { length: [x, y], height } => solid(corners(x, y), height),
        Shape::OuterCorner { angle, length, height } => solid(Profile::Corners(wedge(angle, length, 1.0)), height),
        Shape::InnerCorner { angle, length, depth } => {
            open(Profile::Corners(wedge(angle, length, 1.25)), Profile::Corners(wedge(angle, length, 1.0)), depth)
        }
        Shape::Block { size: [x, y, z] } => solid(corners(x, y), z),
        Shape::Turned { diameter, length, bore: [0.0, _] } => solid(Profile::Round(diameter / 2.0), length),
        Shape::Turned { diameter, length, bore: [bore, depth] } => {
            Prism { low: -length, ..open(Profile::Round(diameter / 2.0), Profile::Round(bore / 2.0), depth) }
        }
        Shape::Chuck { diameter, length, .. } => solid(Profile::Round(diameter / 2.0), length),
        Shape::Sphere { .. } | Shape::Free(_) => return None,
    })
}

/// A parallelogram from the origin along X and along a line that is turned from it, wider about its middle.
fn wedge(angle: f64, [first, second]: [f64; 2], wider: f64) -> Vec<[f64; 2]> {
    let [x, y] = figures::polar(angle, second);
    let middle = [(first + x) / 2.0, y / 2.0];
    let wide = |point: [f64; 2]| [0, 1].map(|axis| middle[axis] + (point[axis] - middle[axis]) * wider);
    [[0.0; 2], [first, 0.0], [first + x, y], [x, y]].map(wide).to_vec()
}

/// Where a solid's own axes lie on the paper.
struct Frame {
    at: [f64; 2],
    x: [f64; 2],
    y: [f64; 2],
    z: [f64; 2],
}

impl Frame {
    fn place(&self, [x, y]: [f64; 2], z: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.at[axis] + x * self.x[axis] + y * self.y[axis] + z * self.z[axis])
    }

    /// Whether it is seen along its Z.
    fn along(&self) -> bool {
        self.z[0].hypot(self.z[1]) < 1e-6
    }

    /// Whether its Z lies neither in the paper nor across it.
    fn leans(&self) -> bool {
        !self.along() && self.z[0].hypot(self.z[1]) < 1.0 - 1e-6
    }

    /// From where to where a profile reaches across Z on the paper, counted along `right`.
    fn span(&self, profile: &Profile, right: [f64; 2]) -> [f64; 2] {
        match profile {
            Profile::Round(radius) => [-radius, *radius],
            Profile::Corners(points) => {
                let at = |point: &[f64; 2]| {
                    let [x, y] = self.place(*point, 0.0);
                    (x - self.at[0]) * right[0] + (y - self.at[1]) * right[1]
                };
                let all = points.iter().map(at);
                [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
            }
        }
    }
}

/// A solid on the paper.
pub struct Outline {
    /// All of it, the opening left out where it is seen.
    pub body: PictureShape,
    /// Its boundary: circles and straight lines.
    pub lines: Vec<PictureShape>,
}

/// A plane through a solid, machine coordinates.
#[derive(Clone, Copy)]
pub struct Cut {
    /// A point of it.
    pub at: V3,
    /// Its normal, of length 1.
    pub normal: V3,
}

/// A solid on the paper; `seen` projects a machine position or direction; `cut`: where it is cut open.
pub fn outline(solid: &Solid, kind: ShapeKind, cut: Option<Cut>, seen: impl Fn(V3) -> [f64; 2]) -> Option<Outline> {
    let turn = rigid::rotation(solid.rotation);
    let [x, y, z] = [V3::x(), V3::y(), V3::z()].map(|axis| seen(turn * axis));
    let frame = Frame { at: seen(V3::from(solid.at)), x, y, z };
    if let Shape::Sphere { diameter } = solid.shape {
        let ball = |kind| figures::circle(kind, frame.at, diameter / 2.0);
        return Some(Outline { body: ball(kind), lines: vec![ball(ShapeKind::Edge)] });
    }
    let prism = prism(&solid.shape)?;
    if let (Some(cut), Profile::Corners(corners)) =
        (cut.filter(|_| frame.leans() || prism.opening.is_none()), &prism.outer)
    {
        let place = |[x, y]: [f64; 2], z: f64| V3::from(solid.at) + turn * V3::new(x, y, z);
        let rings = [0.0, prism.low].map(|z| corners.iter().map(|corner| place(*corner, z)).collect::<Vec<_>>());
        let body = figures::polygon(kind, section(&rings, cut).into_iter().map(seen).collect());
        return Some(Outline { lines: lines(&body), body });
    }
    Some(if frame.along() { from_above(&prism, &frame, kind) } else { from_the_side(&prism, &frame, kind) })
}

fn from_above(prism: &Prism, place: &Frame, kind: ShapeKind) -> Outline {
    let points =
        |points: &[[f64; 2]]| -> Vec<[f64; 2]> { points.iter().map(|point| place.place(*point, 0.0)).collect() };
    let figure = |kind, profile: &Profile| match profile {
        Profile::Round(radius) => figures::circle(kind, place.at, *radius),
        Profile::Corners(corners) => figures::polygon(kind, points(corners)),
    };
    let outer = figure(kind, &prism.outer);
    let Some((opening, _)) = &prism.opening else {
        return Outline { lines: lines(&outer), body: outer };
    };
    let inner = figure(kind, opening);
    let lines = lines(&inner);
    let body = match inner.circle {
        Some(opening) => PictureShape { opening: Some(opening), ..outer },
        None => figures::polygon(kind, frame(outer.points, inner.points)),
    };
    Outline { body, lines }
}

fn from_the_side(prism: &Prism, place: &Frame, kind: ShapeKind) -> Outline {
    let long = place.z[0].hypot(place.z[1]);
    let right = [place.z[1] / long, -place.z[0] / long];
    let at = |along: f64, depth: f64| [0, 1].map(|axis| place.at[axis] + along * right[axis] + depth * place.z[axis]);
    let [left, end] = place.span(&prism.outer, right);
    let mut corners = vec![at(left, 0.0), at(left, prism.low), at(end, prism.low), at(end, 0.0)];
    if let Some((opening, floor)) = &prism.opening {
        let [from, to] = place.span(opening, right);
        corners.extend([at(to, 0.0), at(to, *floor), at(from, *floor), at(from, 0.0)]);
    }
    let body = figures::polygon(kind, corners);
    Outline { lines: lines(&body), body }
}

/// The corners of a section through a convex prism, in turn; `rings`: those of both its ends.
fn section([one, other]: &[Vec<V3>; 2], cut: Cut) -> Vec<V3> {
    let around = |ring: &[V3]| -> Vec<[V3; 2]> {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(from, to)| [*from, *to]).collect()
    };
    let along = one.iter().zip(other).map(|(from, to)| [*from, *to]);
    let edges = around(one).into_iter().chain(around(other)).chain(along);
    let mut corners: Vec<V3> = edges
        .filter_map(|[from, to]| {
            let [before, behind] = [from, to].map(|end| (end - cut.at).dot(&cut.normal));
            (before * behind < 0.0).then(|| from + (to - from) * (before / (before - behind)))
        })
        .collect();
    let middle = corners.iter().sum::<V3>() / corners.len().max(1) as f64;
    let Some(first) = corners.first().map(|corner| corner - middle) else {
        return corners;
    };
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
    let [from, to] = line.points[..] else {
        return false;
    };
    (distance(from, point) + distance(point, to) - distance(from, to)).abs() < 1e-3
}
