//! What the points and the target say together.

use super::params::{MEASURED, Names, SET, TARGET};
use crate::catalogue::prelude::*;
use crate::catalogue::spread;
use crate::geometry::fit;

/// Points that make no triangle determine no frame: the cycle hands 61411 back. A corrected frame has to take a
/// rotation.
pub fn checks(inputs: &Inputs, _: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::takes_rotation(TARGET, inputs, found);
    for (names, key) in [(SET, "check-119-set-line"), (MEASURED, "check-119-measured-line")] {
        let Some(points) = points(inputs, names) else { continue };
        if fit::in_line(points) {
            let hint = Message::new("check-119-line-hint");
            found.push(error(Code::Alarm(61411), Message::new(key)).hint(hint).at(names[2][0]));
        } else if names == SET {
            found.extend(spread::triangle(points, names[2][0]));
        }
    }
}

/// The three points where all of their coordinates are known, mm.
pub fn points(inputs: &Inputs, names: Names) -> Option<[V3; 3]> {
    let point = |[x, y, z]: [Name; 3]| Some(V3::new(inputs.given(x)?, inputs.given(y)?, inputs.given(z)?));
    let [a, b, c] = names.map(point);
    Some([a?, b?, c?])
}
