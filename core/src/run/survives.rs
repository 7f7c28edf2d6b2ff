//! How wrong a part may be before its measurement does not come to its end any more.

use super::predict;
use crate::entry::Inputs;
use crate::machine::Setup;

/// An error that is survived up to here counts as one without limit, mm.
const FARTHEST: f64 = 50.0;
/// The first error that is tried, mm; the next ones are twice as large.
const FIRST: f64 = 0.05;
/// How well a limit is known, mm.
const RESOLUTION: f64 = 0.005;

/// The errors on both sides up to which a call comes to its end, mm; none: no limit was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survived {
    /// The smallest, not above 0.
    pub low: Option<f64>,
    /// The largest, not below 0.
    pub high: Option<f64>,
}

/// The limits of one error, of which `with` makes the machine and the part; where that cannot exist, it is not
/// survived. None: the call does not even come to its end without it.
///
/// The limit is found by running the call: what `_FA`, `_TSA` and `_SZA` leave depends on ball, angles and order of
/// touches, and running them is exact whatever decides. Larger errors are tried until one is not survived; between it
/// and the last one that was, the limit is enclosed.
pub fn survived(inputs: &Inputs, with: impl Fn(f64) -> Option<Setup>) -> Option<Survived> {
    let ends = |error: f64| with(error).is_some_and(|setup| predict(inputs.cycle, inputs, &setup).finished());
    ends(0.0).then(|| Survived { low: limit(|size| ends(-size)).map(|size| -size), high: limit(ends) })
}

/// The largest size for which it ends.
fn limit(ends: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut survived, mut failed) = (0.0, FIRST);
    while ends(failed) {
        (survived, failed) = (failed, failed * 2.0);
        if failed > FARTHEST {
            return None;
        }
    }
    while failed - survived > RESOLUTION {
        let middle = 0.5 * (survived + failed);
        if ends(middle) {
            survived = middle;
        } else {
            failed = middle;
        }
    }
    Some(survived)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::sinumerik::testing::{WIDE_BANDS, call, setup, solid};
    use crate::control::Plane;
    use crate::entry::names;
    use crate::geometry::Mcs;
    use crate::workpiece::Shape;

    /// A hole of 60 mm that is measured with this path and safe area.
    fn hole(path: f64, safe: f64) -> Survived {
        let values = [("_SETVAL", 60.0), ("_FA", path), ("_KNUM", 0.0), ("_TNUM", 20.0)];
        let mut inputs = call("CYCLE977", 1, &[&values[..], &WIDE_BANDS].concat());
        inputs.numbers.insert(names::TSA, safe);
        let with = |size: f64| {
            let mut machine = setup(Plane::G17);
            machine.position = Mcs([0.0, 0.0, -10.0]);
            let shape = Shape::Hole { diameter: 60.0, depth: 40.0 };
            let mut part = solid(Plane::G17, shape, [0.0; 3], false);
            part.errors.size = size;
            machine.workpiece.solids.push(part);
            Some(machine)
        };
        survived(&inputs, with).unwrap()
    }

    // oracle: manual B:2213-2225, B:13743-13763: the ball goes _FA before and behind the wall, half of the error of a
    // diameter; before that it would touch while it is positioned. B:6123: the safe area is one of the difference
    #[test]
    fn path_and_safe_area_limit_a_hole() {
        for (path, safe, low, high) in [(2.0, 40.0, -4.0, 4.0), (8.0, 3.0, -3.0, 3.0)] {
            let found = hole(path, safe);
            let near = |found: Option<f64>, wanted: f64| (found.unwrap() - wanted).abs() < 0.011;
            assert!(near(found.low, low), "{path} {safe}: {found:?}");
            assert!(near(found.high, high), "{path} {safe}: {found:?}");
        }
    }

    // oracle: hand
    #[test]
    fn what_never_fails_has_no_limit() {
        assert_eq!(limit(|_| true), None);
        assert_eq!(limit(|size| size < 0.01).map(|found| found < 0.01), Some(true));
    }
}
