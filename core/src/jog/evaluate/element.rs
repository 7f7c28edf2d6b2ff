//! An element of four touches: where each block begins and ends, and what the touches say (B:3315-3374).

use super::{Flat, round};
use crate::geometry::{Degrees, Wcs};
use crate::jog::mask::Element;
use crate::jog::stylus::{Stylus, Touch};

/// An element as it is expected. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// What is touched.
    pub element: Element,
    /// Size along the first and the second direction: diameter twice, or length and width; 0 in a hole: not known.
    pub size: Flat,
    /// Angle of the first direction against the abscissa.
    pub angle: Degrees,
    /// From the start down to measuring depth; 0 inside.
    pub infeed: f64,
}

/// An element as it was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Centre in abscissa and ordinate of the WCS, mm.
    pub centre: Flat,
    /// Height of the ball's centre while it was touched, mm.
    pub height: f64,
    /// Diameter; of a rectangle length and width, mm.
    pub size: Flat,
}

/// A block, by the centre of the ball in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Start.
    pub start: Flat,
    /// End.
    pub end: Flat,
    /// Direction of travel against the abscissa.
    pub towards: Degrees,
}

/// Sides of an element in the order in which they are touched, against its angle.
const SIDES: [f64; 4] = [0.0, 180.0, 90.0, 270.0];

/// One of the four blocks on a line through `at`: `path` before and behind the wall, inside not longer than there is
/// room; a hole whose diameter is not known is touched from the middle (A:3236).
pub fn block(size: &Size, number: usize, at: Flat, radius: f64, path: f64) -> Block {
    let side = size.angle + Degrees(SIDES[number.min(3)]);
    let half = size.size[usize::from(number > 1)] / 2.0;
    let inside = size.element.inside;
    let wall = if inside { half - radius } else { half + radius };
    let [start, end] = match inside {
        true if half == 0.0 => [0.0, 2.0 * path],
        true => [wall - path.min(wall), wall + path.min(wall)],
        false => [wall + path, wall - path],
    };
    let (sine, cosine) = side.sin_cos();
    let on = |way: f64| [at[0] + way * cosine, at[1] + way * sine];
    Block { start: on(start), end: on(end), towards: if inside { side } else { side + Degrees(180.0) } }
}

/// The place through which the line across has to run: in the middle of the first two balls.
pub fn middle(at: Flat, angle: Degrees, balls: [Flat; 2]) -> Flat {
    let (sine, cosine) = angle.sin_cos();
    let along = |ball: Flat| ball[0] * cosine + ball[1] * sine;
    let gone = (along(balls[0]) + along(balls[1])) / 2.0 - along(at);
    [at[0] + gone * cosine, at[1] + gone * sine]
}

/// The element by its four positions at switching, in the order of the blocks: a rectangle by its faces, along the axes
/// by the trigger values; a round one by its balls.
pub fn element(stylus: &Stylus, size: &Size, latched: [Wcs; 4], height: f64) -> Found {
    let balls = latched.map(|at| stylus.in_plane(stylus.ball_at(at)));
    let ball = 2.0 * stylus.radius;
    if size.element.round {
        let round = round(size.angle, balls);
        let diameter = round.reach + if size.element.inside { ball } else { -ball };
        return Found { centre: round.centre, height, size: [diameter, 0.0] };
    }
    let [abscissa, ordinate, _] = stylus.plane.axes();
    let face = |number: usize| {
        let outward = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let sign = if size.element.inside { outward } else { -outward };
        stylus.surface(&Touch { at: latched[number], axis: [abscissa, ordinate][number / 2], sign })
    };
    let [right, left, upper, lower] = std::array::from_fn(face);
    let centre = [(right + left) / 2.0, (upper + lower) / 2.0];
    Found { centre, height, size: [(right - left).abs(), (upper - lower).abs()] }
}
