//! Parts on a table of rotary axes.

use super::{PartErrors, Solid};
use crate::control::Control;
use crate::geometry::{Degrees, Rpy, V3, rigid};

impl Control {
    /// A part as it stands now; as it is given it is clamped with all rotary axes at 0.
    pub fn on_table(&self, solid: &Solid) -> Solid {
        if self.rotary == [Degrees(0.0); 3] {
            return solid.clone();
        }
        let turn = self.table_turn();
        let centre = V3::from(self.rotary_centre);
        let clamped = solid.place();
        Solid {
            shape: solid.shape.clone(),
            at: (centre + turn * (clamped.translation.vector - centre)).into(),
            rotation: rigid::angles(&(turn * clamped.rotation)),
            errors: PartErrors { shift: [0.0; 3], tilt: Rpy::default(), ..solid.errors },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::geometry::Mcs;
    use crate::workpiece::Shape;

    #[test]
    fn a_positive_angle_turns_the_table_clockwise() {
        let mut control = delivery(Dialect::Sinumerik);
        control.rotary_centre = Mcs([10.0, 0.0, 0.0]);
        control.rotary[2] = Degrees(90.0);
        let solid = Solid {
            shape: Shape::Sphere { diameter: 5.0 },
            at: Mcs([30.0, 0.0, 7.0]),
            rotation: Rpy::default(),
            errors: PartErrors { shift: [1.0, 0.0, 0.0], tilt: Rpy([0.0, 0.0, 30.0]), ..PartErrors::default() },
        };
        let turned = control.on_table(&solid);
        // oracle: manual B:627, hand: 21 mm from the centre along X, then along minus Y
        let wanted = [10.0, -21.0, 7.0];
        for (found, wanted) in turned.at.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12);
        }
        assert!((turned.rotation[2] + 60.0).abs() < 1e-12);
        assert_eq!(turned.errors, PartErrors::default());
    }
}
