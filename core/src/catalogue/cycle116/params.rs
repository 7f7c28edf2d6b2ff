//! The elements of the array that the program hands over (B:2430-2438).

use crate::catalogue::common::{PARAM, required};
use crate::diagnostic::Code;
use crate::entry::{Kind, Param, Unit, When};
use crate::name::Name;

/// Number of points.
pub const COUNT: Name = Name::new("_DATE[0]");
/// Abscissa and ordinate of each point.
pub const POINTS: [[Name; 2]; 4] = [
    [Name::new("_DATE[1]"), Name::new("_DATE[2]")],
    [Name::new("_DATE[3]"), Name::new("_DATE[4]")],
    [Name::new("_DATE[5]"), Name::new("_DATE[6]")],
    [Name::new("_DATE[7]"), Name::new("_DATE[8]")],
];

const FOUR: When = When::Number { param: COUNT, is: &[4.0] };

/// In the order of the array.
pub const PARAMS: &[Param] = &[
    Param {
        name: COUNT,
        key: "116-count",
        kind: Kind::Choice(&[(3, "cycle116-three"), (4, "cycle116-four")]),
        alarm: Some(Code::Alarm(61317)),
        needs: &[required(When::Always, "need-116-points")],
        example: "3",
        source: "B:2430;A:15858",
        ..PARAM
    },
    abscissa(0, "0", "B:2431"),
    ordinate(0, "10", "B:2432"),
    abscissa(1, "-10", "B:2433"),
    ordinate(1, "0", "B:2434"),
    abscissa(2, "0", "B:2435"),
    ordinate(2, "-10", "B:2436"),
    Param { needs: &[required(FOUR, "need-116-fourth")], ..abscissa(3, "", "B:2437") },
    Param { needs: &[required(FOUR, "need-116-fourth")], ..ordinate(3, "", "B:2438") },
];

const fn abscissa(point: usize, example: &'static str, source: &'static str) -> Param {
    Param { name: POINTS[point][0], key: "116-abscissa", example, source, ..COORDINATE }
}

const fn ordinate(point: usize, example: &'static str, source: &'static str) -> Param {
    Param { name: POINTS[point][1], key: "116-ordinate", example, source, ..COORDINATE }
}

/// The unit is not named; the result has the same (B:2431-2446).
const COORDINATE: Param =
    Param { unit: Unit::ActiveLength, needs: &[required(When::Always, "need-116-points")], ..PARAM };
