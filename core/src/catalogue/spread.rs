//! Warnings about points that lie so that what follows from them is far more uncertain than each of them.

use crate::catalogue::prelude::*;
use crate::evaluate::spread;
use crate::evaluate::spread::{Circle, LENGTH, MOST_SPREAD, Touched, told};
use crate::own::Own;

/// A circle through points, said at this parameter.
pub fn circle(circle: Circle, at: Name) -> Option<Diagnostic> {
    let finding = own::SPREAD_CIRCLE.finding().number("diameter", told(circle.diameter));
    let uncertain = circle.diameter.max(circle.worse()) > MOST_SPREAD;
    uncertain.then(|| finding.number("centre", told(circle.worse())).at(at))
}

/// A circle of which the centre alone counts.
pub fn centre(circle: Circle, at: Name) -> Option<Diagnostic> {
    let finding = own::SPREAD_CENTRE.finding().number("centre", told(circle.worse()));
    (circle.worse() > MOST_SPREAD).then(|| finding.at(at))
}

/// The angle of a line through two points.
pub fn angle(touched: [Touched; 2], at: Name) -> Option<Diagnostic> {
    let factor = spread::line(touched)?;
    let [x, y] = [0, 1].map(|i| touched[1].at[i] - touched[0].at[i]);
    // tenths of a millimetre are enough for a reader, and what is advised must be enough as well
    let needed = (x.hypot(y) * factor / MOST_SPREAD * 10.0).ceil() / 10.0;
    Some(uncertain(own::SPREAD_ANGLE, factor, at)?.number("length", LENGTH).hint_number("needed", needed))
}

/// The corner where two lines meet.
pub fn corner(touched: &[Touched], at: Name) -> Option<Diagnostic> {
    uncertain(own::SPREAD_CORNER, spread::corner(touched)?, at)
}

/// The position of three points in space.
pub fn triangle(points: [V3; 3], at: Name) -> Option<Diagnostic> {
    Some(uncertain(own::SPREAD_TRIANGLE, spread::turn(points)?, at)?.number("length", LENGTH))
}

/// A finding about what is so many times less certain than a point.
fn uncertain(sentence: Own, factor: f64, at: Name) -> Option<Diagnostic> {
    (factor > MOST_SPREAD).then(|| sentence.finding().number("factor", told(factor)).at(at))
}
