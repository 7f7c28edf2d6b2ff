//! How the path of the tool centre goes from one piece of the contour to the next.

use super::element::{Element, Point, distance, left};
use std::f64::consts::PI;

/// Changes of direction that are none, radian: at 10 mm of radius a step of 0.01 µm.
const SMOOTH: f64 = 1e-6;
/// Changes of direction, radian, above which a corner is rounded outside, as by a SINUMERIK with MD 20210 as delivered.
const POINTED: f64 = 100.0 / 180.0 * PI;
/// By how much a point may lie beside the end of a piece and still be taken for it, mm or radian.
const END: f64 = 1e-7;

/// G450 or G451.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    /// G450: round the corner of the contour.
    #[default]
    Circle,
    /// G451: on to the point where both paths meet.
    Meeting,
}

/// A piece of the contour and the path of the tool centre beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// As programmed.
    pub contour: Element,
    /// Where the centre goes.
    pub path: Element,
    /// How far it is to the left of the contour at its start and at its end, mm.
    pub by: [f64; 2],
}

impl Beside {
    /// The path beside a piece of the contour; none: it has no room.
    pub fn of(contour: Element, by: [f64; 2]) -> Option<Beside> {
        Some(Beside { contour, path: contour.beside(by)?, by })
    }
}

/// From one path to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corner {
    /// Both paths meet as they are.
    Smooth,
    /// Outside: round the end of the contour by so many radians, counter-clockwise positive.
    Round(f64),
    /// The point where both meet; so much of the end of the first and of the start of the second is left out, in the
    /// unit of [`Element::extent`]; what is negative is added.
    Meet {
        at: Point,
        /// Of the first and of the second.
        cut: [f64; 2],
    },
}

/// The corner between two pieces, of the first of which so much is left out at its start. None: the tool has no room.
pub fn corner(first: &Beside, second: &Beside, begun: f64, outside: Outside) -> Option<Corner> {
    let by = second.by[0];
    let turn = turn(&first.contour, &second.contour, by);
    if by.abs() < 1e-9 || turn.abs() < SMOOTH {
        return Some(Corner::Smooth);
    }
    if turn * by > 0.0 {
        return shortened(first, second, begun);
    }
    let found = match outside {
        Outside::Meeting if turn.abs() <= POINTED => continued(first, second),
        _ => None,
    };
    Some(found.unwrap_or(Corner::Round(turn)))
}

/// Change of direction, radian, counter-clockwise positive. Straight back is a turn to the side to which both bend away
/// from each other; where they do not bend, that on which the tool goes round.
fn turn(first: &Element, second: &Element, by: f64) -> f64 {
    let (arrives, departs) = (first.arrives(), second.departs());
    let turn = arrives.perp(&departs).atan2(arrives.dot(&departs));
    let bend = first.curvature() + second.curvature();
    match turn.abs() > PI - SMOOTH {
        true if bend != 0.0 => -PI * bend.signum(),
        true => -PI * by.signum(),
        false => turn,
    }
}

/// Inside: where both paths cross.
fn shortened(first: &Beside, second: &Beside, begun: f64) -> Option<Corner> {
    let room = [first.path.extent() - begun, second.path.extent()];
    let cut = |at| [first.path.way(at, first.path.end), second.path.way(second.path.start, at)];
    meeting(first, second, cut, |cut, side| (-END..=room[side] + END).contains(&cut))
}

/// Outside: where both would cross if they went on; an arc at most by a half turn.
fn continued(first: &Beside, second: &Beside) -> Option<Corner> {
    let room = [first, second].map(|piece| piece.path.round.map_or(f64::INFINITY, |_| PI));
    let cut = |at| [-first.path.way(first.path.end, at), -second.path.way(at, second.path.start)];
    meeting(first, second, cut, |cut, side| (-room[side]..=END).contains(&cut))
}

/// The crossing of the lines or circles of both paths that is nearest to the corner, of those where what is left out of
/// the first (side 0) and of the second (side 1) is allowed.
fn meeting(
    first: &Beside,
    second: &Beside,
    cut: impl Fn(Point) -> [f64; 2],
    allowed: impl Fn(f64, usize) -> bool,
) -> Option<Corner> {
    let corner = first.contour.end;
    let points = crossings(Curve::of(&first.path, first.path.end), Curve::of(&second.path, second.path.start));
    let allowed = |at: &Point| {
        let [end, start] = cut(*at);
        allowed(end, 0) && allowed(start, 1)
    };
    let found = points.into_iter().flatten().filter(allowed);
    let away = |at: &Point| distance(*at, corner);
    let at = found.min_by(|a, b| away(a).total_cmp(&away(b)))?;
    Some(Corner::Meet { at, cut: cut(at) })
}

/// What a path is a piece of.
#[derive(Clone, Copy, Debug)]
enum Curve {
    /// A point and a unit vector.
    Line(Point, Point),
    /// Centre and radius.
    Circle(Point, f64),
}

impl Curve {
    /// The circle is that at this end of the path: an arc beside which the distance changes is none.
    fn of(path: &Element, at: Point) -> Curve {
        match path.round {
            Some(round) => Curve::Circle(round.centre, distance(round.centre, at)),
            None => Curve::Line(path.start, path.departs()),
        }
    }
}

fn crossings(a: Curve, b: Curve) -> [Option<Point>; 2] {
    match (a, b) {
        (Curve::Line(p, u), Curve::Line(q, v)) => {
            let along = (q - p).perp(&v) / u.perp(&v);
            [along.is_finite().then(|| p + u * along), None]
        }
        (Curve::Line(point, along), Curve::Circle(centre, radius))
        | (Curve::Circle(centre, radius), Curve::Line(point, along)) => {
            let foot = point + along * (centre - point).dot(&along);
            beside(foot, along, radius * radius - (foot - centre).dot(&(foot - centre)))
        }
        (Curve::Circle(centre, radius), Curve::Circle(other, size)) => {
            let apart = distance(centre, other);
            let towards = (other - centre) * (1.0 / apart);
            let way = (radius * radius - size * size + apart * apart) / (2.0 * apart);
            beside(centre + towards * way, left(towards), radius * radius - way * way)
        }
    }
}

/// The points on both sides of a middle, whose distance from it has this square, mm².
fn beside(middle: Point, along: Point, square: f64) -> [Option<Point>; 2] {
    // what touches may miss by what f64 leaves
    let half = if square.abs() < 1e-9 { 0.0 } else { square.sqrt() };
    [half, -half].map(|half| half.is_finite().then(|| middle + along * half))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::super::element::Round;
    use super::*;

    /// A line from the zero along the abscissa, and one of the same length from its end in a direction, degree.
    fn lines(degrees: f64, by: f64) -> [Beside; 2] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let corner = Point::new(50.0, 0.0);
        let line = |start, end| Element { start, end, round: None };
        let second = line(corner, Point::new(50.0 + 50.0 * cosine, 50.0 * sine));
        [line(Point::zeros(), corner), second].map(|line| Beside::of(line, [by; 2]).unwrap())
    }

    fn between([first, second]: &[Beside; 2], outside: Outside) -> Option<Corner> {
        corner(first, second, 0.0, outside)
    }

    fn meets(corner: Option<Corner>, [x, y]: [f64; 2]) {
        let Some(Corner::Meet { at, .. }) = corner else {
            panic!("{corner:?}");
        };
        assert!(distance(at, [x, y]) < 1e-12, "{at:?}");
    }

    // oracle: hand
    #[test]
    fn the_side_decides_whether_a_corner_is_outside() {
        for outside in [Outside::Circle, Outside::Meeting] {
            meets(between(&lines(90.0, 5.0), outside), [45.0, 5.0]);
            meets(between(&lines(-90.0, -5.0), outside), [45.0, -5.0]);
            assert_eq!(between(&lines(0.0, 5.0), outside), Some(Corner::Smooth));
            assert_eq!(between(&lines(90.0, 0.0), outside), Some(Corner::Smooth));
            // back on the same line: round the end, whatever side
            assert_eq!(between(&lines(180.0, 5.0), outside), Some(Corner::Round(-PI)));
            assert_eq!(between(&lines(180.0, -5.0), outside), Some(Corner::Round(PI)));
        }
        let round = between(&lines(-90.0, 5.0), Outside::Circle);
        assert_eq!(round, Some(Corner::Round(-PI / 2.0)));
        meets(between(&lines(-90.0, 5.0), Outside::Meeting), [55.0, 5.0]);
        // more pointed than 100 degree
        let pointed = between(&lines(-101.0, 5.0), Outside::Meeting);
        assert!(matches!(pointed, Some(Corner::Round(_))), "{pointed:?}");
    }

    // oracle: hand: the lines cross 48.3 mm before the corner of 12 degree, and the tool of 10 mm has 95.1 mm before it
    #[test]
    fn a_corner_that_is_too_pointed_has_no_room() {
        assert!(between(&lines(168.0, 5.0), Outside::Circle).is_some());
        assert_eq!(between(&lines(168.0, 10.0), Outside::Circle), None);
    }

    // oracle: hand: half circles of 10 beside each other on the abscissa; circles of 15 about 10 and 30 meet over 20
    #[test]
    fn arcs_go_on_until_they_meet() {
        let arc = |centre: f64| Element {
            start: Point::new(centre - 10.0, 0.0),
            end: Point::new(centre + 10.0, 0.0),
            round: Some(Round { centre: Point::new(centre, 0.0), sweep: -PI }),
        };
        let pair = |by| [10.0, 30.0].map(|centre| Beside::of(arc(centre), [by; 2]).unwrap());
        // over both the point between them is inside
        meets(between(&pair(5.0), Outside::Circle), [20.0, 125.0_f64.sqrt()]);
        // below them, inside of the arcs, it is outside
        let below = between(&pair(-5.0), Outside::Meeting);
        assert!(matches!(below, Some(Corner::Round(_))), "{below:?}");
    }
}
