//! The rule by which a leaning plane gets its angles, level or others, in JOG and in CYCLE998: a rotation of the frame
//! about abscissa and ordinate, and about the applicate by 0 (B:3641-3645, B:7278). The example prints it: X −6.1069,
//! Y −14.3030, Z 0.0000 (B:3882). Of the two turns the frame carries out the one behind the other, in the order of its
//! angles (RPY). DESIGN.md has the derivation.

use crate::control::Plane;
use crate::geometry::{Degrees, Rpy, V3, rigid};
use nalgebra::Rotation3;

/// Directions closer than this are the same.
pub const SAME: f64 = 1e-9;

/// The turn about abscissa and ordinate alone that takes one direction to another, of two the one nearer to the turn
/// `before`; what no such turn reaches is reached as nearly as it can.
pub fn tilt(plane: Plane, from: &V3, to: &V3, before: &Rotation3<f64>) -> Rpy {
    let [abscissa, ordinate, _] = plane.axes();
    let (inner, outer) = (abscissa.min(ordinate), abscissa.max(ordinate));
    let (from, to) = (from.normalize(), to.normalize());
    // the inner turn brings the part along the outer axis, which the outer turn leaves
    let [next, last] = [(inner + 1) % 3, (inner + 2) % 3];
    let reach = from[next].hypot(from[last]);
    let along = to[outer].clamp(-reach, reach);
    let up = (reach * reach - along * along).max(0.0).sqrt();
    let [one, other] = [up, -up].map(|up| {
        let wanted = if next == outer { up.atan2(along) } else { along.atan2(up) };
        let first = about(inner, wanted - from[last].atan2(from[next]));
        let between = rigid::rotation(first) * from;
        let [next, last] = [(outer + 1) % 3, (outer + 2) % 3];
        let second = about(outer, to[last].atan2(to[next]) - between[last].atan2(between[next]));
        Rpy(std::array::from_fn(|axis| first[axis] + second[axis]))
    });
    let away = |turn: Rpy| (rigid::rotation(turn).matrix() - before.matrix()).norm();
    if away(one) <= away(other) { one } else { other }
}

/// An angle in radians about an axis, between −180 and 180 degree.
fn about(axis: usize, radians: f64) -> Rpy {
    let turn = std::f64::consts::TAU;
    Rpy::about(axis, Degrees::of(radians - turn * (radians / turn).round()))
}

/// How far a rotation turns about the applicate before it tilts: the part of it that a plane does not determine.
pub fn heading(plane: Plane, rotation: &Rotation3<f64>) -> Degrees {
    let [abscissa, ordinate, _] = plane.axes();
    let seen = rotation * V3::ith(abscissa.min(ordinate), 1.0);
    let angle = match plane {
        Plane::G17 => seen.y.atan2(seen.x),
        Plane::G18 => (-seen.z).atan2(seen.x),
        Plane::G19 => seen.z.atan2(seen.y),
    };
    Degrees::of(angle)
}

/// By how much the turns about abscissa, ordinate and applicate have grown from one rotation to another, behind the
/// heading of the first.
pub fn added(plane: Plane, before: Rpy, after: Rpy) -> Rpy {
    let [before, after] = [before, after].map(rigid::rotation);
    let [.., applicate] = plane.axes();
    let heading = rigid::rotation(Rpy::about(applicate, heading(plane, &before))).inverse();
    let [before, after] = [before, after].map(|rotation| rigid::angles(&(heading * rotation)));
    Rpy(std::array::from_fn(|axis| after[axis] - before[axis]))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn near(found: Rpy, wanted: [f64; 3]) {
        assert!((0..3).all(|axis| (found[axis] - wanted[axis]).abs() < 1e-9), "{found:?} {wanted:?}");
    }

    // oracle: manual B:3882: the normal of the plane that this rotation of the frame makes level
    #[test]
    fn the_printed_rotation_comes_out() {
        let printed = Rpy([-6.1069, -14.303, 0.0]);
        let normal = rigid::rotation(printed) * V3::z();
        near(tilt(Plane::G17, &V3::z(), &normal, &Rotation3::identity()), printed.0);
    }

    // oracle: definition: the turn takes the one to the other, and none is about the applicate
    #[test]
    fn a_tilt_takes_one_direction_to_the_other() {
        for plane in Plane::ALL {
            let [abscissa, ordinate, applicate] = plane.axes();
            for [a, b, c, d] in [[0.3, -0.2, 0.0, 0.0], [0.1, 0.5, -0.4, 0.2], [-0.6, 0.6, 0.3, 0.7], [0.0; 4]] {
                let direction = |a: f64, b: f64| {
                    let mut direction = V3::ith(applicate, 1.0);
                    (direction[abscissa], direction[ordinate]) = (a, b);
                    direction
                };
                let turn = tilt(plane, &direction(c, d), &direction(a, b), &Rotation3::identity());
                assert_eq!(turn[applicate], 0.0, "{plane:?}");
                let turned = rigid::rotation(turn) * direction(c, d).normalize();
                assert!((turned - direction(a, b).normalize()).norm() < 1e-12, "{plane:?} {turn:?}");
            }
        }
    }

    // oracle: definition: heading and tilt together are the rotation
    #[test]
    fn a_rotation_is_a_heading_and_a_tilt() {
        for plane in Plane::ALL {
            let [.., applicate] = plane.axes();
            let whole = rigid::rotation(Rpy([11.0, -23.0, 37.0]));
            let turned = rigid::rotation(Rpy::about(applicate, heading(plane, &whole)));
            let rest = turned.inverse() * whole;
            let tilted = tilt(plane, &V3::ith(applicate, 1.0), &(rest * V3::ith(applicate, 1.0)), &rest);
            let both = turned * rigid::rotation(tilted);
            assert!((both.matrix() - whole.matrix()).norm() < 1e-12, "{plane:?} {tilted:?}");
        }
    }

    // oracle: definition: what already lies as it should stays, however far it is turned, whichever direction is meant
    #[test]
    fn of_two_tilts_the_one_that_is_there_stays() {
        for plane in Plane::ALL {
            let [abscissa, ordinate, applicate] = plane.axes();
            for [first, second] in [[80.0, 60.0], [-70.0, 85.0], [10.0, -40.0], [170.0, 20.0]] {
                let (inner, outer) = (abscissa.min(ordinate), abscissa.max(ordinate));
                let mut there = Rpy::default();
                (there[inner], there[outer]) = (first, second);
                let before = rigid::rotation(there);
                for (along, up) in [(0.0, 1.0), (0.3, 1.0), (0.6, -1.0)] {
                    let mut normal = V3::ith(applicate, up);
                    normal[abscissa] = along;
                    let found = tilt(plane, &normal, &(before * normal), &before);
                    assert!((rigid::rotation(found).matrix() - before.matrix()).norm() < 1e-12, "{plane:?} {found:?}");
                }
            }
        }
    }

    // oracle: definition, at rotations whose trace rounding makes larger than 3: found by a loop over many parts
    #[test]
    fn what_lies_right_stays_whatever_rounding_makes_of_it() {
        for plane in Plane::ALL {
            let [.., applicate] = plane.axes();
            for step in 0..2000 {
                let angle = |by: f64| 40.0 * (f64::from(step) * by).sin();
                let whole = rigid::rotation(Rpy([angle(0.37), angle(0.73), angle(1.19)]));
                let rest = rigid::rotation(Rpy::about(applicate, heading(plane, &whole))).inverse() * whole;
                let normal = V3::ith(applicate, 1.0);
                let found = rigid::rotation(tilt(plane, &normal, &(rest * normal), &rest));
                assert!((found.matrix() - rest.matrix()).norm() < 1e-12, "{plane:?} {step}");
            }
        }
    }
}
