//! Reference points of machine, workpiece and tool in space, as the control counts them: machine zero M, workpiece zero
//! W and tool reference point F (B:710-746), and the lengths of a tool by plane and type (B:760-828).

use super::extent;
use crate::control::tools::side;
use crate::control::{AXES, Control, Edge, Frame, Plane, delivery};
use crate::dialect::Dialect;
use crate::geometry::{V3, Wcs};
use crate::machine::Setup;
use crate::picture::figures::{arrow, circle, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};
use crate::scene::frames::{UNITS, system};
use crate::workpiece::{Cut, Drawn, Nose, Tool, seen};

/// From where it is seen: the part's front, its right side and its top; machine axes.
const TOWARDS: [f64; 3] = [0.42, -0.8, 0.43];
/// Length of an axis, mm, and of its arrow.
const AXIS: f64 = 45.0;
const ARROW: f64 = 6.0;
/// Sizes of the part, mm: its upper left front corner is W; how far the probe stands from its edges.
const PART: [f64; 3] = [70.0, 60.0, 30.0];
const DEPTH: f64 = 8.0;
/// Half of the size of a drawn plane, mm.
const HALF: f64 = 42.0;
/// Zero offset in Y and Z, mm.
const ZERO: [f64; 2] = [50.0, 20.0];
/// L1, L2, L3 of a tool in an angle head, mm; its radius.
const LENGTHS: [f64; 3] = [90.0, 45.0, 30.0];
const RADIUS: f64 = 6.0;
/// Radius of a spindle, and how far it is drawn above F, mm.
const SPINDLE: [f64; 2] = [20.0, 25.0];
/// Free paper between two figures, mm.
const GAP: f64 = 60.0;
/// Corners of a drawn circle.
const CORNERS: u32 = 32;

/// Machine and workpiece coordinate system.
pub struct Systems {
    /// What is drawn.
    pub picture: Picture,
    /// Position of F from M, mm.
    pub machine: [f64; 3],
    /// Position of the centre of the ball from W, mm.
    pub workpiece: [f64; 3],
}

/// Lengths of tools in a plane.
pub struct Lengths {
    /// What is drawn.
    pub picture: Picture,
    /// The axes of L1, L2 and L3 of a mill.
    pub axes: [&'static str; 3],
    /// The axes of L1 and L2 of a turning tool in G18.
    pub turning: [&'static str; 2],
}

/// A probe at the right side of a part, with this zero offset in X, mm.
pub fn systems(offset: f64) -> Systems {
    let Setup { mut control, probe, .. } = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    control.frames.insert(control.settable, Frame::translation([offset, ZERO[0], ZERO[1]]));
    control.activate(control.settable);
    let [width, depth, height] = PART;
    let workpiece = [width + probe.radius, depth / 2.0, -DEPTH];
    let ball = control.to_machine(Wcs(workpiece));
    let flange = V3::from(ball.0) + V3::from(control.active_length());
    let (zero, axes) = system(&control).unwrap_or(([0.0; 3], UNITS));
    let of_part = |point: [f64; 3]| V3::from(control.to_machine(Wcs(point)).0);
    let sight = Sight::new();
    let mut paper = Paper::new(sight);
    paper.plane("G17", of_part([width / 2.0, depth / 2.0, 0.0]), [V3::x(), V3::y()], HALF + 12.0);
    paper.block(|[x, y, z]| of_part([x * width, y * depth, (z - 1.0) * height]));
    paper.system("M", V3::zeros(), UNITS.map(V3::from));
    paper.system("W", zero.into(), axes.map(V3::from));
    paper.round(flange, V3::z(), SPINDLE);
    paper.round(ball.0.into(), V3::z(), [probe.radius / 3.0, control.active_length()[2]]);
    paper.shapes.push(circle(ShapeKind::Probe, sight.seen(ball.0.into()), probe.radius));
    paper.point("F", flange);
    paper.between(V3::zeros(), flange, "");
    paper.between(zero.into(), ball.0.into(), "");
    Systems { picture: paper.picture(), machine: flange.into(), workpiece }
}

/// A milling tool in an angle head in this plane, and beside it a turning tool in G18.
pub fn lengths(plane: Plane) -> Lengths {
    let milling = with_tool(plane, Edge { kind: 120, length: LENGTHS, radius: RADIUS, ..Edge::default() });
    let turning = with_tool(
        Plane::G18,
        Edge { kind: 500, tip: 3, length: [LENGTHS[0], LENGTHS[1], 0.0], radius: 0.8, ..Edge::default() },
    );
    let mut paper = Paper::new(Sight::new());
    paper.milling_tool(&milling);
    let mut other = Paper::new(Sight::ONTO_TURNING);
    other.turning_tool(&turning);
    paper.beside(other);
    let named = |control: &Control| {
        let edge = control.active_edge().cloned().unwrap_or_default();
        control.length_axes(&edge).map(|axis| AXES[control.plane.axes()[axis]])
    };
    let [first, second, _] = named(&turning);
    Lengths { picture: paper.picture(), axes: named(&milling), turning: [first, second] }
}

/// A control as delivered with this tool in use.
fn with_tool(plane: Plane, edge: Edge) -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = plane;
    (control.tool, control.edge) = (1, 1);
    *control.edge_made(1, 1) = edge;
    control
}

/// How space lies on the paper: without perspective.
#[derive(Clone, Copy)]
struct Sight {
    right: V3,
    up: V3,
}

impl Sight {
    /// As a turning machine is drawn: Z to the right, X up.
    const ONTO_TURNING: Sight = Sight { right: V3::new(0.0, 0.0, 1.0), up: V3::new(1.0, 0.0, 0.0) };

    fn new() -> Sight {
        let towards = V3::from(TOWARDS).normalize();
        let right = V3::z().cross(&towards).normalize();
        Sight { right, up: towards.cross(&right) }
    }

    fn seen(self, point: V3) -> [f64; 2] {
        [self.right.dot(&point), self.up.dot(&point)]
    }
}

/// What is drawn, as it is seen.
struct Paper {
    sight: Sight,
    shapes: Vec<PictureShape>,
}

impl Paper {
    fn new(sight: Sight) -> Paper {
        Paper { sight, shapes: Vec::new() }
    }

    fn picture(self) -> Picture {
        Picture { view: View::Space, shapes: self.shapes }
    }

    fn lines(&mut self, kind: ShapeKind, points: &[V3]) {
        let points = points.iter().map(|point| self.sight.seen(*point)).collect();
        self.shapes.push(line(kind, points));
    }

    fn point(&mut self, name: &str, at: V3) {
        self.shapes.push(circle(ShapeKind::Touch, self.sight.seen(at), 1.5).text(name));
    }

    /// What lies between two points, with its name.
    fn between(&mut self, from: V3, to: V3, name: &str) {
        let ends = [from, to].map(|end| self.sight.seen(end));
        let shape = line(ShapeKind::Dimension, ends.to_vec());
        self.shapes.push(if name.is_empty() { shape } else { shape.text(name) });
    }

    /// An axis with its letter.
    fn axis(&mut self, from: V3, along: V3, letter: &str) {
        let [root, tip] = [from, from + along * AXIS].map(|end| self.sight.seen(end));
        self.shapes.push(line(ShapeKind::Axis, vec![root, tip]));
        self.shapes.push(arrow(ShapeKind::Axis, root, tip, ARROW));
        let beyond = self.sight.seen(from + along * (AXIS + ARROW));
        self.shapes.push(line(ShapeKind::Label, vec![beyond]).text(letter));
    }

    /// A coordinate system with the name of its zero.
    fn system(&mut self, name: &str, zero: V3, axes: [V3; 3]) {
        for (axis, letter) in axes.into_iter().zip(AXES) {
            self.axis(zero, axis, letter);
        }
        self.point(name, zero);
    }

    /// A working plane about a point.
    fn plane(&mut self, name: &str, middle: V3, [abscissa, ordinate]: [V3; 2], half: f64) {
        let corner = |[x, y]: [f64; 2]| middle + (abscissa * x + ordinate * y) * half;
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner);
        let seen = corners.map(|corner| self.sight.seen(corner)).to_vec();
        self.shapes.push(polygon(ShapeKind::Plane, seen));
        let at = self.sight.seen(corner([0.8, -0.85]));
        self.shapes.push(line(ShapeKind::Label, vec![at]).text(name));
    }

    /// A block, whose corners are those of a cube of 1 at their places.
    fn block(&mut self, place: impl Fn([f64; 3]) -> V3) {
        let corners: Vec<V3> = (0..8).map(|bits| place([0, 1, 2].map(|axis| f64::from(bits >> axis & 1)))).collect();
        let seen = corners.iter().map(|corner| self.sight.seen(*corner)).collect();
        self.shapes.push(polygon(ShapeKind::Material, hull(seen)));
        // of the edges those that do not end in the one corner that is behind all others
        let hidden = place([0.0, 1.0, 0.0]);
        for (from, to) in corners.iter().enumerate().flat_map(|(one, from)| {
            let ends = [1, 2, 4].into_iter().filter(move |bit| one & bit == 0);
            ends.filter_map(|bit| Some((*from, *corners.get(one | bit)?))).collect::<Vec<_>>()
        }) {
            if from != hidden && to != hidden {
                self.lines(ShapeKind::Edge, &[from, to]);
            }
        }
    }

    /// A cylinder of this radius and length from a point on.
    fn round(&mut self, at: V3, along: V3, [radius, length]: [f64; 2]) {
        let ends = [at, at + along * length];
        let seen = ends.iter().flat_map(|end| self.ring(*end, along, radius)).collect();
        self.shapes.push(polygon(ShapeKind::Probe, hull(seen)));
    }

    /// Points of a circle about an axis of the machine.
    fn ring(&self, middle: V3, along: V3, radius: f64) -> Vec<[f64; 2]> {
        let (one, other) = (V3::new(along.y, along.z, along.x), V3::new(along.z, along.x, along.y));
        let point = |index: u32| {
            let (sin, cos) = (f64::from(index) / f64::from(CORNERS) * std::f64::consts::TAU).sin_cos();
            self.sight.seen(middle + (one * cos + other * sin) * radius)
        };
        (0..CORNERS).map(point).collect()
    }

    /// F, the way from there to the tip length by length, and the plane about the tip.
    fn measured(&mut self, control: &Control, half: f64) -> V3 {
        let [abscissa, ordinate, _] = control.plane.axes().map(unit);
        let length = V3::from(control.active_length());
        let edge = control.active_edge().cloned().unwrap_or_default();
        let mut at = V3::zeros();
        self.plane(name(control.plane), -length, [abscissa, ordinate], half);
        for (number, axis) in control.length_axes(&edge).into_iter().enumerate() {
            let along = unit(control.plane.axes()[axis]);
            let next = at - along * along.dot(&length);
            if (next - at).norm() > 0.0 {
                self.between(at, next, &format!("L{}", number + 1));
            }
            at = next;
        }
        self.point("F", V3::zeros());
        at
    }

    /// A mill whose axis stands beside that of the spindle, as an angle head holds it.
    fn milling_tool(&mut self, control: &Control) {
        let length = V3::from(control.active_length());
        let up = unit(control.plane.axes()[2]);
        let [neck, reach] = [2.0 * RADIUS, 4.0 * RADIUS];
        let elbow = up * -(up.dot(&length) - reach);
        let upper = up * reach - length;
        let joint = [elbow, upper].into_iter().flat_map(|end| self.ring(end, up, neck)).collect();
        self.round(V3::zeros(), up, SPINDLE);
        self.round(elbow, up, [neck, -elbow.dot(&up)]);
        self.shapes.push(polygon(ShapeKind::Probe, hull(joint)));
        self.round(-length, up, [RADIUS, reach]);
        let tip = self.measured(control, HALF);
        let corner = tip - V3::repeat(HALF) - V3::x() * HALF;
        for (axis, letter) in AXES.into_iter().enumerate() {
            self.axis(corner, unit(axis), letter);
        }
    }

    /// A turning tool in its holder.
    fn turning_tool(&mut self, control: &Control) {
        let length = V3::from(control.active_length());
        let edge = control.active_edge().cloned().unwrap_or_default();
        let nose = Nose { radius: edge.radius, side: side(edge.tip, false) };
        let tool = Tool { length: edge.length, cut: Cut::Nose(nose) };
        for piece in seen::tool(&tool, length, control.plane, None).0 {
            let Drawn::Plate { corners, thick, .. } = piece else { continue };
            let ends = corners.iter().flat_map(|corner| [*corner, corner + thick]);
            let seen = ends.map(|point| self.sight.seen(point - length)).collect();
            self.shapes.push(polygon(ShapeKind::Probe, hull(seen)));
        }
        let tip = self.measured(control, HALF);
        let corner = tip - V3::repeat(HALF);
        for axis in control.plane.axes().into_iter().take(2) {
            self.axis(corner, unit(axis), AXES[axis]);
        }
    }

    /// Another paper beside this one, at half of its height.
    fn beside(&mut self, other: Paper) {
        let [one, next] = [&self.shapes, &other.shapes].map(|shapes| extent(shapes));
        let middle = |[low, high]: [[f64; 2]; 2]| (low[1] + high[1]) / 2.0;
        let by = [one[1][0] + GAP - next[0][0], middle(one) - middle(next)];
        self.shapes.extend(other.shapes.into_iter().map(|mut shape| {
            shape.shift(by);
            shape
        }));
    }
}

fn unit(axis: usize) -> V3 {
    V3::ith(axis, 1.0)
}

fn name(plane: Plane) -> &'static str {
    match plane {
        Plane::G17 => "G17",
        Plane::G18 => "G18",
        Plane::G19 => "G19",
    }
}

/// The convex outline of points, counter-clockwise.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|one, other| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
    let back = points.iter().rev().copied().collect();
    let mut around = half(points);
    around.pop();
    let mut other = half(back);
    other.pop();
    around.append(&mut other);
    around
}

/// The part of an outline on the right of its way through sorted points.
fn half(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for point in points {
        while let [.., before, last] = kept[..] {
            let turn = (last[0] - before[0]) * (point[1] - before[1]) - (last[1] - before[1]) * (point[0] - before[0]);
            if turn > 1e-9 {
                break;
            }
            kept.pop();
        }
        kept.push(point);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The way between two ends with this name, and nothing else has it.
    fn ways(picture: &Picture, name: &str) -> usize {
        picture.shapes.iter().filter(|shape| shape.text.as_deref() == Some(name)).count()
    }

    // oracle: manual B:764-836: the axis of each length by plane, and of a turning tool in G18
    #[test]
    fn each_length_lies_along_its_axis() {
        let all = Plane::ALL.map(|plane| lengths(plane).axes);
        assert_eq!(all, [["Z", "Y", "X"], ["Y", "X", "Z"], ["X", "Z", "Y"]]);
        assert_eq!(lengths(Plane::G17).turning, ["X", "Z"]);
        for (plane, own) in Plane::ALL.into_iter().zip(["G17", "G18", "G19"]) {
            let picture = lengths(plane).picture;
            assert_eq!(["L1", "L2", "L3"].map(|name| ways(&picture, name)), [2, 2, 1], "{plane:?}");
            let planes = [own, "G18"].map(|name| ways(&picture, name));
            assert_eq!(planes, if own == "G18" { [2, 2] } else { [1, 1] });
            assert_eq!(ways(&picture, "F"), 2);
        }
    }

    // oracle: manual B:710-746; hand: the ball 3 mm beside the part of 70 mm, in its middle, 8 mm deep; F 50 mm above
    #[test]
    fn a_zero_offset_moves_the_machine_position_alone() {
        for offset in [60.0, 100.0, 140.0] {
            let Systems { picture, machine, workpiece } = systems(offset);
            assert_eq!(workpiece, [73.0, 30.0, -8.0]);
            assert_eq!(machine, [offset + 73.0, 80.0, 62.0]);
            assert_eq!(["M", "W", "F", "G17"].map(|name| ways(&picture, name)), [1; 4]);
        }
    }

    // oracle: hand
    #[test]
    fn an_outline_leaves_out_what_lies_inside() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let inside = [[1.0, 1.0], [1.0, 0.0], [0.5, 1.5]];
        assert_eq!(hull(square.into_iter().chain(inside).rev().collect()), square);
    }
}
