//! Parts that are in the working plane.

use crate::catalogue::prelude::*;

/// A solid whose X, Y, Z lie along abscissa, ordinate and applicate; `at` in the same order, active WCS, mm.
pub fn in_plane(shape: Shape, at: [f64; 3], control: &Control) -> Solid {
    place::solid(control, shape, at, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
}

/// Such a part with the stylus before it; `start` as `at`.
pub fn propose(shape: Shape, at: [f64; 3], start: [f64; 3], control: &Control) -> Proposal {
    place::proposal(in_plane(shape, at, control), place::in_plane(control, start))
}

/// A rectangle of walls: around an island (`outside`) or a pocket; height or depth in mm.
pub fn rectangle(outside: bool, length: [f64; 2], height: f64) -> Shape {
    if outside { Shape::Island { length, height } } else { Shape::Pocket { length, depth: height } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::{Plane, delivery};
    use crate::dialect::Dialect;
    use crate::geometry::{V3, rigid};

    // oracle: definition of the planes (abscissa, ordinate, applicate)
    #[test]
    fn axes_of_the_part_follow_the_plane() {
        let mut control = delivery(Dialect::Nct);
        for plane in [Plane::G17, Plane::G18, Plane::G19] {
            control.plane = plane;
            let solid = in_plane(Shape::Block { size: [1.0; 3] }, [0.0; 3], &control);
            for (own, axis) in plane.axes().into_iter().enumerate() {
                let (mut mine, mut expected) = (V3::zeros(), V3::zeros());
                mine[own] = 1.0;
                expected[axis] = 1.0;
                assert!((rigid::rotation(solid.rotation) * mine - expected).norm() < 1e-12, "{plane:?}");
            }
        }
    }
}
