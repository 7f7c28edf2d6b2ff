//! Where corner and points lie in the picture of CYCLE961.

use super::lines::{Point, across, along, away, direction, meeting, unit};
use super::params::{OUTSIDE, PLACES, RECTANGLE};
use crate::entry::Inputs;
use crate::entry::names;

/// What is drawn, mm.
pub struct Scene {
    /// Corner of a part, not of a pocket.
    pub outside: bool,
    /// Corner of the part, drawn from the values.
    pub corner: Point,
    /// Directions of the edges from the corner, the reference edge first; unit vectors.
    pub edges: [Point; 2],
    /// Where the ball stands before each touch, P1 to P4; of a rectangle the last one is not touched.
    pub starts: [Point; 4],
    /// How many of them are touched.
    pub touched: usize,
    /// Where the workpiece zero is drawn from which places are counted: no further away than the drawing has room.
    pub zero: Point,
    /// How far the part is drawn along each edge.
    pub reach: [f64; 2],
    /// Size of the drawing.
    pub size: f64,
    /// Ball radius.
    pub ball: f64,
}

impl Scene {
    /// Which way the second edge is turned from the first: 1 counter-clockwise, -1 clockwise.
    pub fn sense(&self) -> f64 {
        if across(self.edges[0], self.edges[1]) < 0.0 { -1.0 } else { 1.0 }
    }
}

/// The start lies opposite the corner, the points in the directions of the edges from there (B:7980-7998).
pub fn from_distances(inputs: &Inputs) -> Scene {
    let start = inputs.number(names::STA1) % 360.0;
    let opening = match inputs.given(names::INCA).unwrap_or(80.0) {
        0.0 => 80.0,
        angle => angle.clamp(-179.5, 179.5),
    };
    let edges = [unit(start), unit(start + opening)];
    let given = [names::SETV0, names::SETV1].map(|name| inputs.positive(name, 100.0));
    let size = given[0].max(given[1]);
    let [first, second] = given.map(|distance| distance.max(size * 0.4));
    let at = |direction, distance| along([0.0; 2], direction, distance);
    let outside = OUTSIDE.holds(inputs);
    let middle = unit(start + opening / 2.0);
    let gap = size * if outside { 0.35 } else { -0.35 };
    Scene {
        outside,
        corner: along([0.0; 2], middle, gap),
        edges,
        zero: [0.0; 2],
        reach: [size * if outside { 1.1 } else { 1.7 }; 2],
        starts: [at(edges[0], first / 2.0), at(edges[0], first), at(edges[1], second / 2.0), at(edges[1], second)],
        touched: if RECTANGLE.holds(inputs) { 3 } else { 4 },
        size,
        ball: size * 0.035,
    }
}

/// Places of the manual's example, where none is given (B:8090-8096).
const EXAMPLE: [Point; 4] = [[50.0, 20.0], [150.0, 20.0], [15.0, 40.0], [15.0, 80.0]];

/// How far beside the places the workpiece zero is drawn at most, as a share of the size of the drawing.
const ZERO: f64 = 0.2;

/// The coordinate 0, or the one nearest to it that is not further from all of these than `most`.
fn near(values: [f64; 4], most: f64) -> f64 {
    let low = values.into_iter().fold(f64::INFINITY, f64::min);
    let high = values.into_iter().fold(f64::NEG_INFINITY, f64::max);
    0.0_f64.clamp(low - most, high + most)
}

/// The edges run beside the lines through the given points (B:8138-8154).
pub fn from_points(inputs: &Inputs) -> Scene {
    let number = |name, otherwise| inputs.given(name).unwrap_or(otherwise);
    let mut starts = EXAMPLE;
    for (point, [abscissa, ordinate]) in starts.iter_mut().zip(PLACES) {
        *point = [number(abscissa, point[0]), number(ordinate, point[1])];
    }
    let [p1, p2, p3, p4] = starts;
    let lines = [direction(p1, p2), direction(p3, p4)];
    let meeting = meeting([p1, p3], lines).unwrap_or(p1);
    let toward = |point: Point, line: Point| {
        let way = away(meeting, point);
        let sign = if way[0] * line[0] + way[1] * line[1] < 0.0 { -1.0 } else { 1.0 };
        [line[0] * sign, line[1] * sign]
    };
    let edges = [toward(p2, lines[0]), toward(p4, lines[1])];
    let reach = |point: Point| (point[0] - meeting[0]).hypot(point[1] - meeting[1]);
    let size = starts.into_iter().map(reach).fold(1e-3, f64::max);
    let outside = OUTSIDE.holds(inputs);
    // the corner lies nearer to the lines than P1 and P3 to where they meet
    let nearest = reach(p1).min(reach(p3)) / 2.0;
    let gap = if outside { nearest.clamp(size * 0.06, size * 0.15) } else { -size * 0.15 };
    Scene {
        outside,
        corner: along(along(meeting, edges[0], gap), edges[1], gap),
        edges,
        zero: [0, 1].map(|axis| near(starts.map(|point| point[axis]), size * ZERO)),
        reach: [reach(p2).max(reach(p1)), reach(p4).max(reach(p3))]
            .map(|far| far + size * if outside { 0.1 } else { 0.35 }),
        starts,
        touched: 4,
        size,
        ball: size * 0.035,
    }
}
