//! A straight line or an arc in the working plane, and the line or arc beside it.

use std::f64::consts::TAU;

/// Abscissa and ordinate, mm.
pub type Point = nalgebra::Vector2<f64>;

/// Shorter ways are none, and an arc with a smaller radius is a point, mm.
const NOTHING: f64 = 1e-6;

/// A piece of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    pub start: Point,
    pub end: Point,
    /// Round what; none: straight.
    pub round: Option<Round>,
}

/// How an arc goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    pub centre: Point,
    /// Radian from start to end, counter-clockwise positive; whole turns included.
    pub sweep: f64,
}

impl Element {
    /// Whether anything moves in the plane.
    pub fn moves(&self) -> bool {
        self.round.is_some() || distance(self.start, self.end) > 1e-9
    }

    /// Direction at the start, a unit vector.
    pub fn departs(&self) -> Point {
        self.along(self.start)
    }

    pub fn arrives(&self) -> Point {
        self.along(self.end)
    }

    fn along(&self, at: Point) -> Point {
        match self.round {
            Some(round) => left(direction(round.centre, at)) * round.sweep.signum(),
            None => direction(self.start, self.end),
        }
    }

    /// Length of a line, mm; angle of an arc, radian.
    pub fn extent(&self) -> f64 {
        match self.round {
            Some(round) => round.sweep.abs(),
            None => distance(self.start, self.end),
        }
    }

    /// 1 by the radius, positive counter-clockwise; 0 of a line, 1/mm.
    pub fn curvature(&self) -> f64 {
        self.round.map_or(0.0, |round| round.sweep.signum() / distance(round.centre, self.start))
    }

    /// The line or arc beside this one, so far to the left of its start and end, mm, negative right; none: no room.
    pub fn beside(&self, [begin, end]: [f64; 2]) -> Option<Element> {
        let found = Element {
            start: self.start + left(self.departs()) * begin,
            end: self.end + left(self.arrives()) * end,
            round: self.round,
        };
        let Some(round) = self.round else { return Some(found) };
        let room = |at: Point, by: f64| distance(round.centre, at) - by * round.sweep.signum();
        (room(self.start, begin) > -NOTHING && room(self.end, end) > -NOTHING).then_some(found)
    }

    /// How far one point lies behind another, in the unit of [`Element::extent`]; of an arc from 0 to a whole turn.
    pub fn way(&self, from: Point, to: Point) -> f64 {
        match self.round {
            Some(round) => turned(round, from, to),
            None => (to - from).dot(&self.departs()),
        }
    }

    /// Angle of the arc that begins and ends so far inside of this one, radian; none: a line, or a point.
    pub fn sweep(&self, begun: f64, cut: f64) -> Option<f64> {
        let round = self.round?;
        let radius = distance(round.centre, self.end);
        (radius > NOTHING).then(|| (round.sweep.abs() - begun - cut) * round.sweep.signum())
    }
}

/// Angle from one point to another in the sense of the arc, 0 to a whole turn; just below a whole turn is none at all.
fn turned(round: Round, from: Point, to: Point) -> f64 {
    let angle = |point: Point| {
        let way = point - round.centre;
        way.y.atan2(way.x)
    };
    let turned = ((angle(to) - angle(from)) * round.sweep.signum()).rem_euclid(TAU);
    if TAU - turned < 1e-7 { turned - TAU } else { turned }
}

/// Distance of two points, mm.
pub fn distance(a: impl Into<Point>, b: impl Into<Point>) -> f64 {
    let way = a.into() - b.into();
    way.x.hypot(way.y)
}

/// A quarter turn counter-clockwise.
pub fn left(way: Point) -> Point {
    Point::new(-way.y, way.x)
}

/// Unit vector from one point to another; where both are the same, along the abscissa.
fn direction(from: Point, to: Point) -> Point {
    let (way, length) = (to - from, distance(to, from));
    if length > 0.0 { way * (1.0 / length) } else { Point::x() }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn near(a: Point, b: [f64; 2]) {
        assert!(distance(a, b) < 1e-12, "{a:?} {b:?}");
    }

    // oracle: hand: a quarter of a circle of 10 about the origin, counter-clockwise from X10
    #[test]
    fn beside_an_arc_lies_an_arc_about_the_same_centre() {
        let round = Round { centre: Point::zeros(), sweep: TAU / 4.0 };
        let arc = Element { start: Point::new(10.0, 0.0), end: Point::new(0.0, 10.0), round: Some(round) };
        near(arc.departs(), [0.0, 1.0]);
        near(arc.arrives(), [-1.0, 0.0]);
        let inside = arc.beside([3.0, 3.0]).unwrap();
        near(inside.start, [7.0, 0.0]);
        near(inside.end, [0.0, 7.0]);
        let outside = arc.beside([-3.0, -3.0]).unwrap();
        near(outside.end, [0.0, 13.0]);
        assert!(arc.beside([10.0, 10.0]).unwrap().sweep(0.0, 0.0).is_none());
        assert_eq!(arc.beside([10.1, 10.1]), None);
        assert!((arc.way(arc.start, Point::new(5.0, 5.0)) - TAU / 8.0).abs() < 1e-12);
        assert!((arc.way(Point::new(5.0, 5.0), arc.end) - TAU / 8.0).abs() < 1e-12);
    }
}
