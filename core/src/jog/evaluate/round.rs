//! Elements of four touches, what two to four centres make, and a plane through three points (B:3315-3674).

use super::Flat;
use super::corner::crossing;
use crate::control::Plane;
use crate::evaluate::level::tilt;
use crate::geometry::{Degrees, Rpy, V3, Wcs, fit};
use nalgebra::Rotation3;

/// A hole, spigot or rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Centre.
    pub centre: Flat,
    /// How far apart the ball centres were on the line through the middle of the first two, mm.
    pub reach: f64,
}

/// The middle of an element: ball centres at the contact angle, opposite, and across on the line through their middle,
/// on the plus and on the minus side. The first chord may run beside the centre, its middle is exact all the same; the
/// second runs through the centre and is the diameter.
pub fn round(angle: Degrees, balls: [Flat; 4]) -> Round {
    let (sine, cosine) = angle.sin_cos();
    let [along, across] = [[cosine, sine], [-sine, cosine]];
    let on = |ball: Flat, way: Flat| ball[0] * way[0] + ball[1] * way[1];
    let [first, second, third, fourth] = balls;
    let u = (on(first, along) + on(second, along)) / 2.0;
    let v = (on(third, across) + on(fourth, across)) / 2.0;
    Round {
        centre: [u * along[0] + v * across[0], u * along[1] + v * across[1]],
        reach: (on(third, across) - on(fourth, across)).abs(),
    }
}

/// Angle of the way from one centre to another against the abscissa, above −180 up to 180; none: they are one.
pub fn directed(from: Flat, to: Flat) -> Option<Degrees> {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    (x != 0.0 || y != 0.0).then(|| Degrees::of(y.atan2(x)))
}

/// Centre of the circle through three centres; none: there is no circle.
pub fn circle(centres: [Flat; 3]) -> Option<Flat> {
    fit::circle(&centres).map(|(centre, _)| centre)
}

/// Where the lines from the first centre to the third and from the second to the fourth cross; none: they do not.
pub fn diagonals([first, second, third, fourth]: [Flat; 4]) -> Option<Flat> {
    let line = |from: Flat, to: Flat| {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = way[0].hypot(way[1]);
        (length > 0.0).then(|| (from, way.map(|part| part / length)))
    };
    crossing(line(first, third)?, line(second, fourth)?)
}

/// The normal of the plane through three points, its part along the applicate positive, and the turn about abscissa
/// and ordinate that makes it level. None: the points lie in a line, or the plane stands upright.
pub fn level(plane: Plane, points: [Wcs; 3]) -> Option<(V3, Rpy)> {
    let points = points.map(V3::from);
    let [a, b, c] = points;
    let [.., applicate] = plane.axes();
    let normal = (b - a).cross(&(c - a));
    if fit::in_line(points) || normal[applicate].abs() < 1e-9 * normal.norm() {
        return None;
    }
    let normal = normal.normalize() * normal[applicate].signum();
    Some((normal, tilt(plane, &V3::ith(applicate, 1.0), &normal, &Rotation3::identity())))
}
