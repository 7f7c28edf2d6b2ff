//! A corner of two edges (B:3174-3250). A ball that rests on an edge has its centre the radius away along the normal,
//! whichever axis it came along, so that the edges are the lines through the centres, moved by the radius.

use super::Flat;
use crate::geometry::Degrees;

/// How an edge is touched: along abscissa (0) or ordinate (1), in plus (+1) or minus direction (-1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Axis of the plane.
    pub axis: usize,
    /// Direction of travel.
    pub sign: f64,
}

/// A corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where it lies.
    pub at: Flat,
    /// Angle of the first edge against the abscissa; an edge has no beginning: above −90 up to 90.
    pub angle: Degrees,
}

/// A line: a point of it, and a unit vector along it.
type Line = (Flat, Flat);

/// The corner of the edge through the first two ball centres and another one: through the third at a right angle, or
/// through the third and the fourth. None: two centres lie upon each other, or the edges are parallel.
pub fn corner(balls: &[Flat], sides: [Side; 2], radius: f64) -> Option<Corner> {
    let (first, second) = match *balls {
        [a, b, c] => {
            let first = edge([a, b], sides[0], radius)?;
            let [x, y] = first.1;
            (first, moved((c, [-y, x]), sides[1], radius))
        }
        [a, b, c, d] => (edge([a, b], sides[0], radius)?, edge([c, d], sides[1], radius)?),
        _ => return None,
    };
    let [x, y] = first.1;
    let angle = Degrees::of((y / x).atan());
    let angle = if x == 0.0 { Degrees(90.0) } else { angle };
    Some(Corner { at: crossing(first, second)?, angle })
}

/// The edge through two ball centres.
fn edge([from, to]: [Flat; 2], side: Side, radius: f64) -> Option<Line> {
    let way = [to[0] - from[0], to[1] - from[1]];
    let length = way[0].hypot(way[1]);
    (length > 0.0).then(|| moved((from, way.map(|part| part / length)), side, radius))
}

/// A line of ball centres moved into the material, towards which the probe travelled.
fn moved((at, along): Line, side: Side, radius: f64) -> Line {
    let normal = [-along[1], along[0]];
    let towards = if normal[side.axis.min(1)] * side.sign > 0.0 { radius } else { -radius };
    ([at[0] + towards * normal[0], at[1] + towards * normal[1]], along)
}

/// Sine of the least angle between two lines that still cross.
const PARALLEL: f64 = 1e-9;

/// Where two lines cross; none: they are parallel.
pub(super) fn crossing((from, along): Line, (other, beside): Line) -> Option<Flat> {
    let sine = along[0] * beside[1] - along[1] * beside[0];
    let way = [other[0] - from[0], other[1] - from[1]];
    let gone = (way[0] * beside[1] - way[1] * beside[0]) / sine;
    (sine.abs() > PARALLEL && gone.is_finite()).then(|| [from[0] + gone * along[0], from[1] + gone * along[1]])
}
