//! A turned part in the chuck of a turning machine.

use super::{Body, Form, PartErrors, Shape, Solid};
use crate::geometry::{Degrees, Rpy, V3, rigid};

/// A solid with the spindle turned so far, positive about its Z: a turned part goes round its nominal axis, with errors
/// such as clamped off the centre or askew; every other solid belongs to the machine and stays.
pub fn turned(solid: &Solid, angle: Degrees) -> Solid {
    if angle == Degrees(0.0) || !matches!(solid.shape, Shape::Turned { .. }) {
        return solid.clone();
    }
    let own = rigid::rotation(solid.rotation);
    let turn = own * rigid::rotation(Rpy::about(2, angle)) * own.inverse();
    let errors = &solid.errors;
    Solid {
        errors: PartErrors {
            shift: (turn * V3::from(errors.shift)).into(),
            tilt: rigid::angles(&(turn * rigid::rotation(errors.tilt))),
            ..*errors
        },
        ..solid.clone()
    }
}

/// Number of jaws, and their width in diameters of the chuck.
const JAWS: u32 = 3;
const JAW_WIDTH: f64 = 0.28;

/// A chuck as it is drawn, in its own frame: jaws over the first third, which sweep what can be touched, and the body.
pub(crate) fn seen(solid: &Solid) -> Vec<Body> {
    let Shape::Chuck { diameter, length, grip } = solid.shape else { return Vec::new() };
    let high = length / 3.0;
    let part = |shape, at: [f64; 3], turned| {
        let place = rigid::placed(at.into(), rigid::rotation(Rpy::about(2, turned)));
        Body::of(place, Form::of(&shape, &PartErrors::default()))
    };
    let body = Shape::Turned { diameter: diameter + solid.errors.size, length: length - high, bore: [0.0; 2] };
    let radius = diameter / 2.0;
    let reach = 0.94 * radius - grip / 2.0;
    let jaw = |jaw: u32| {
        let turned = Degrees(360.0 * f64::from(jaw) / f64::from(JAWS));
        let (sine, cosine) = turned.sin_cos();
        let out = (grip + reach) / 2.0;
        part(Shape::Block { size: [reach, JAW_WIDTH * diameter, high] }, [out * cosine, out * sine, 0.0], turned)
    };
    let jaws = (0..if reach > 0.0 { JAWS } else { 0 }).map(jaw);
    std::iter::once(part(body, [0.0, 0.0, -high], Degrees(0.0))).chain(jaws).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Mcs;
    use crate::workpiece::{Boundary, Workpiece};

    #[test]
    fn eccentricity_and_lobes_go_round_with_the_part() {
        // oracle: hand: a point of the machine that is turned with the part is as far from it as before
        let part = Solid {
            shape: Shape::Turned { diameter: 40.0, length: 60.0, bore: [20.0, 30.0] },
            at: Mcs([5.0, -3.0, 10.0]),
            rotation: Rpy::default(),
            errors: PartErrors {
                shift: [0.4, -0.3, 0.2],
                tilt: Rpy([0.5, -0.2, 3.0]),
                out_of_round: (0.05, 3),
                ..PartErrors::default()
            },
        };
        let axis = V3::from([5.0, -3.0, 0.0]);
        for angle in [30.0, 180.0, 355.0] {
            for point in [[32.0, -3.0, -5.0], [12.0, 1.0, -10.0], [5.0, 14.0, 30.0]] {
                let turn = rigid::rotation(Rpy([0.0, 0.0, angle]));
                let moved = axis + turn * (V3::from(point) - axis);
                let far = |solid: Solid, point: V3| {
                    let solids = vec![solid];
                    Boundary::of(&Workpiece { solids }).distance(point.into())
                };
                let before = far(part.clone(), point.into());
                let after = far(turned(&part, Degrees(angle)), moved);
                assert!((before - after).abs() < 1e-9, "{angle} {point:?}: {before} {after}");
            }
        }
    }

    #[test]
    fn what_belongs_to_the_machine_stays() {
        let groove = Solid {
            shape: Shape::Groove { width: 10.0, depth: 20.0, length: 40.0 },
            at: Mcs([60.0, 0.0, 0.0]),
            rotation: Rpy::default(),
            errors: PartErrors { shift: [0.1, 0.2, 0.3], ..PartErrors::default() },
        };
        assert_eq!(turned(&groove, Degrees(90.0)), groove);
    }
}
