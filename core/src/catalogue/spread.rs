//! Doubts about points that lie so that what follows from them is far more uncertain than each of them.

use crate::diagnostic::Diagnostic;
use crate::evaluate::spread;
use crate::evaluate::spread::{Circle, DOUBTED, LENGTH, Touched, told};
use crate::geometry::V3;
use crate::name::Name;
use crate::own;

/// A circle through points, said at this parameter.
pub fn circle(circle: Circle, at: Name) -> Option<Diagnostic> {
    let finding = own::SPREAD_CIRCLE.finding();
    let finding = finding.number("diameter", told(circle.diameter));
    let finding = finding.number("centre", told(circle.worse())).at(at);
    (circle.diameter.max(circle.worse()) > DOUBTED).then_some(finding)
}

/// The same where its centre alone counts.
pub fn centre(circle: Circle, at: Name) -> Option<Diagnostic> {
    let finding = own::SPREAD_CENTRE.finding();
    let finding = finding.number("centre", told(circle.worse())).at(at);
    (circle.worse() > DOUBTED).then_some(finding)
}

/// The angle of a line through two points.
pub fn angle(touched: [Touched; 2], at: Name) -> Option<Diagnostic> {
    let factor = spread::line(touched)?;
    let [x, y] = [0, 1].map(|i| touched[1].at[i] - touched[0].at[i]);
    // tenths of a millimetre are enough for a reader, and what is advised must be enough as well
    let needed = (x.hypot(y) * factor / DOUBTED * 10.0).ceil() / 10.0;
    let finding = own::SPREAD_ANGLE.finding();
    let finding = finding.number("factor", told(factor)).number("length", LENGTH);
    (factor > DOUBTED).then_some(finding.hint_number("needed", needed).at(at))
}

/// The corner where two lines meet.
pub fn corner(touched: &[Touched], at: Name) -> Option<Diagnostic> {
    let factor = spread::corner(touched)?;
    let finding = own::SPREAD_CORNER.finding();
    let finding = finding.number("factor", told(factor)).at(at);
    (factor > DOUBTED).then_some(finding)
}

/// The position of three points in space.
pub fn triangle(points: [V3; 3], at: Name) -> Option<Diagnostic> {
    let factor = spread::turn(points)?;
    let finding = own::SPREAD_TRIANGLE.finding();
    let finding = finding.number("factor", told(factor)).number("length", LENGTH);
    (factor > DOUBTED).then_some(finding.at(at))
}
