//! The corner from where the ball stood at its edges.
//!
//! The ball touches an edge beside its foremost point unless the edge is parallel to an axis; therefore the lines run
//! through the centres of the ball and are moved to the edges by its radius.

use super::lines::{Point, across, along, direction, distance, shares};
use super::touches::Touch;

/// Sine of an angle between lines that do not meet: a position of 1e-9 mm at a line moves the corner by 0.001 mm.
pub const PARALLEL: f64 = 1e-6;

/// What was measured: abscissa and ordinate of the WCS, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where the edges meet.
    pub point: Point,
    /// Unit vector along the reference edge, from P1 to P2.
    pub edge: Point,
}

/// The corner from three or four touches with the centres of the ball at switching. The second edge of a rectangle is
/// upright on the first. Error: alarm 61368 where the edges do not meet, 61369 where they meet between two points of
/// one (A:15912-15913).
pub fn corner(touches: &[Touch], centres: &[Point], radius: f64) -> Result<Corner, u32> {
    let [b1, b2, b3, ref rest @ ..] = *centres else { return Err(61368) };
    let edge = direction(b1, b2);
    let second = rest.first().map_or([-edge[1], edge[0]], |b4| direction(b3, *b4));
    let first_at = moved(b1, edge, &touches[0], radius);
    let second_at = moved(b3, second, &touches[2], radius);
    let [share, other] = shares([first_at, second_at], [edge, second], PARALLEL).ok_or(61368_u32)?;
    if let Some(b4) = rest.first() {
        let within = |share: f64, from: Point, to: Point| (0.0..=distance(from, to)).contains(&share);
        if within(share, b1, b2) || within(other, b3, *b4) {
            return Err(61369);
        }
    }
    Ok(Corner { point: along(first_at, edge, share), edge })
}

/// A line through the centre of the ball, moved to the edge that it touched.
fn moved(centre: Point, line: Point, touch: &Touch, radius: f64) -> Point {
    let side = if across(line, touch.towards()) < 0.0 { -1.0 } else { 1.0 };
    along(centre, [-line[1] * side, line[0] * side], radius)
}
