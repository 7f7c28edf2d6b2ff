//! Parts that stand in the working plane.

use crate::control::Control;
use crate::geometry::Wcs;
use crate::geometry::rigid::angles;
use crate::workpiece::{PartErrors, Shape, Solid};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// A solid whose X, Y, Z lie along abscissa, ordinate and applicate; `at` in the active WCS, mm.
pub fn in_plane(shape: Shape, at: [f64; 3], control: &Control) -> Solid {
    let columns = control.plane.axes().map(|axis| {
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        Vector3::from(control.direction_to_machine(unit))
    });
    let turn = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns));
    Solid { shape, at: control.to_machine(Wcs(at)).0, rotation: angles(&turn), errors: PartErrors::default() }
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
