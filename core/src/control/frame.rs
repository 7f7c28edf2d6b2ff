//! One frame: the step from one coordinate system to the next. Lengths in mm, angles in degree.

use crate::geometry::rigid::{angles, rotation};
use crate::geometry::{Degrees, Rpy};
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::ops::{Add, Neg};

/// A frame: position and rotation of a coordinate system in the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Frame {
    /// Coarse translation X Y Z, mm.
    pub coarse: [f64; 3],
    /// Fine translation X Y Z, mm.
    #[serde(default)]
    pub fine: [f64; 3],
    /// Rotation about X Y Z (RPY), degree.
    #[serde(default)]
    pub rotation: Rpy,
    /// Coarse translation of the rotary axes A B C, degree.
    #[serde(default)]
    pub rotary: [Degrees; 3],
    /// Fine translation of the rotary axes A B C, degree.
    #[serde(default)]
    pub rotary_fine: [Degrees; 3],
    // B:744
    /// Scale factors along its own X Y Z; 1: none. Measuring does not work with any other (61310).
    #[serde(default = "unscaled")]
    pub scale: [f64; 3],
    /// Whether the direction of X Y Z is reversed; counts before scale and rotation.
    #[serde(default)]
    pub mirror: [bool; 3],
}

fn unscaled() -> [f64; 3] {
    [1.0; 3]
}

impl Default for Frame {
    fn default() -> Frame {
        Frame {
            coarse: [0.0; 3],
            fine: [0.0; 3],
            rotation: Rpy::default(),
            rotary: [Degrees(0.0); 3],
            rotary_fine: [Degrees(0.0); 3],
            scale: unscaled(),
            mirror: [false; 3],
        }
    }
}

impl Frame {
    /// A pure translation, mm.
    pub fn translation(coarse: [f64; 3]) -> Frame {
        Frame { coarse, ..Frame::default() }
    }

    /// Coarse and fine translation together, mm.
    pub fn origin(&self) -> [f64; 3] {
        add(self.coarse, self.fine)
    }

    /// A point of this system in the one before it, mm.
    pub fn outward(&self, point: [f64; 3]) -> [f64; 3] {
        let scaled = std::array::from_fn(|i| point[i] * self.scale[i]);
        add(self.origin(), self.turn(scaled))
    }

    /// A point of the system before it in this one, mm.
    pub fn inward(&self, point: [f64; 3]) -> [f64; 3] {
        let origin = self.origin();
        let scaled = self.turn_back(std::array::from_fn(|i| point[i] - origin[i]));
        std::array::from_fn(|i| scaled[i] / self.scale[i])
    }

    /// Whether a scale factor other than 1 is in it.
    pub fn scaled(&self) -> bool {
        self.scale != [1.0; 3]
    }

    /// Whether this and another in it are a frame again: a rotation inside of a scale that differs by axis would shear.
    pub fn chains_with(&self, inner: &Frame) -> bool {
        let [x, y, z] = self.scale;
        (x == y && y == z) || inner.rotation == [0.0; 3]
    }

    /// A direction of this system in the one before it.
    pub fn turn(&self, direction: [f64; 3]) -> [f64; 3] {
        let direction = self.mirrored(direction);
        if self.rotation == [0.0; 3] {
            return direction;
        }
        (rotation(self.rotation) * Vector3::from(direction)).into()
    }

    /// A direction of the system before it in this one.
    pub fn turn_back(&self, direction: [f64; 3]) -> [f64; 3] {
        if self.rotation == [0.0; 3] {
            return self.mirrored(direction);
        }
        self.mirrored((rotation(self.rotation).inverse() * Vector3::from(direction)).into())
    }

    /// What [`Frame::turn`] does with a direction, as a matrix.
    pub fn directions(&self) -> Matrix3<f64> {
        rotation(self.rotation).matrix() * Matrix3::from_diagonal(&self.mirrored([1.0; 3]).into())
    }

    fn mirrored(&self, direction: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.sign(i) * direction[i])
    }

    /// -1 for an axis whose direction is reversed.
    fn sign(&self, axis: usize) -> f64 {
        if self.mirror[axis] { -1.0 } else { 1.0 }
    }

    /// Angles of a rotation inside of it as seen outside of its mirrors: each of another axis turns them the other way.
    fn angles_outside(&self, rotation: Rpy) -> Rpy {
        let all: f64 = (0..3).map(|axis| self.sign(axis)).product();
        Rpy(std::array::from_fn(|i| all * self.sign(i) * rotation[i]))
    }

    /// The frame that takes this one back, chained before or behind it; none: a scale and a rotation in it would shear.
    pub fn inverse(&self) -> Option<Frame> {
        if !self.chains_with(self) {
            return None;
        }
        let back = angles(&rotation(self.rotation).inverse());
        Some(Frame {
            coarse: self.inward([0.0; 3]),
            rotation: self.angles_outside(back),
            rotary: add(self.rotary, self.rotary_fine).map(Neg::neg),
            scale: self.scale.map(|scale| 1.0 / scale),
            mirror: self.mirror,
            ..Frame::default()
        })
    }

    /// This frame and another in it (`:` of frames), where [`Frame::chains_with`] holds; without a fine part.
    pub fn then(&self, inner: &Frame) -> Frame {
        let inside = self.angles_outside(inner.rotation);
        let still = self.rotation == [0.0; 3] || inside == [0.0; 3];
        let rotation = match still {
            true => Rpy(add(self.rotation.0, inside.0)),
            false => angles(&(rotation(self.rotation) * rotation(inside))),
        };
        Frame {
            coarse: self.outward(inner.origin()),
            rotation,
            rotary: add(add(self.rotary, self.rotary_fine), add(inner.rotary, inner.rotary_fine)),
            scale: std::array::from_fn(|i| self.scale[i] * inner.scale[i]),
            mirror: std::array::from_fn(|i| self.mirror[i] != inner.mirror[i]),
            ..Frame::default()
        }
    }
}

fn add<T: Add<Output = T> + Copy>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    std::array::from_fn(|i| a[i] + b[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: [f64; 3], b: [f64; 3]) {
        for i in 0..3 {
            assert!((a[i] - b[i]).abs() < 1e-9, "{a:?} {b:?}");
        }
    }

    #[test]
    fn rpy_turns_z_first() {
        // oracle: hand. Rz(90) takes X to Y; then the turned Y axis is -X of the outer system.
        let frame = Frame { rotation: Rpy([0.0, 0.0, 90.0]), ..Frame::default() };
        near(frame.turn([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        // oracle: hand. Z 90, then about the turned X (now outer Y) 90: inner Y goes to outer Z.
        let frame = Frame { rotation: Rpy([90.0, 0.0, 90.0]), ..Frame::default() };
        near(frame.turn([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn angles_come_back() {
        // oracle: self (inverse)
        near(angles(&rotation(Rpy([10.0, -20.0, 130.0]))).0, [10.0, -20.0, 130.0]);
    }

    #[test]
    fn a_scale_works_along_the_own_axes() {
        let frame = Frame {
            coarse: [1.0, 0.0, 0.0],
            rotation: Rpy([0.0, 0.0, 90.0]),
            scale: [2.0, 3.0, 1.0],
            ..Frame::default()
        };
        // oracle: hand: X10 is 20 along the turned X, which is the outer Y
        near(frame.outward([10.0, 0.0, 5.0]), [1.0, 20.0, 5.0]);
        near(frame.inward([1.0, 20.0, 5.0]), [10.0, 0.0, 5.0]);
        assert!(frame.scaled() && !Frame::default().scaled());
        assert!(!frame.chains_with(&frame));
        assert!(frame.chains_with(&Frame::translation([1.0; 3])));
    }

    #[test]
    fn a_mirror_reverses_an_axis() {
        let frame = Frame {
            coarse: [10.0, 0.0, 0.0],
            rotation: Rpy([0.0, 0.0, 90.0]),
            mirror: [true, false, false],
            ..Frame::default()
        };
        // oracle: hand: X3 goes to the minus side of X, which the rotation puts along -Y of the outer system
        near(frame.outward([3.0, 1.0, 2.0]), [9.0, -3.0, 2.0]);
        near(frame.inward([9.0, -3.0, 2.0]), [3.0, 1.0, 2.0]);
        // oracle: hand: seen from outside, a rotation inside of a mirror turns the other way
        let inner = Frame { rotation: Rpy([0.0, 0.0, 30.0]), ..Frame::default() };
        near(frame.then(&inner).rotation.0, [0.0, 0.0, 60.0]);
        assert_eq!(frame.then(&frame).mirror, [false; 3]);
    }

    #[test]
    fn an_inverse_takes_a_frame_back() {
        let frame = Frame {
            coarse: [1.0, -20.0, 3.0],
            fine: [0.1, 0.0, 0.0],
            rotation: Rpy([10.0, -30.0, 120.0]),
            rotary: [0.0, 0.0, 15.0].map(Degrees),
            scale: [2.0; 3],
            mirror: [false, true, true],
            ..Frame::default()
        };
        let inverse = frame.inverse().unwrap_or_default();
        // oracle: hand (either way round nothing is left)
        for both in [frame.then(&inverse), inverse.then(&frame)] {
            near(both.outward([7.0, 8.0, 9.0]), [7.0, 8.0, 9.0]);
            assert_eq!(both.rotary, [Degrees(0.0); 3]);
        }
        let sheared = Frame { scale: [2.0, 1.0, 1.0], ..frame };
        assert_eq!(sheared.inverse(), None);
    }

    #[test]
    fn frames_chain_as_one() {
        let outer = Frame {
            coarse: [1.0, 2.0, 3.0],
            fine: [0.1, 0.0, 0.0],
            rotation: Rpy([0.0, 30.0, 0.0]),
            scale: [2.0; 3],
            mirror: [false, true, true],
            ..Frame::default()
        };
        let inner = Frame {
            coarse: [4.0, 5.0, 6.0],
            fine: [0.0; 3],
            rotation: Rpy([20.0, 0.0, 40.0]),
            scale: [1.0, 0.5, 3.0],
            mirror: [true, false, false],
            ..Frame::default()
        };
        let both = outer.then(&inner);
        // oracle: self (one after the other)
        near(both.outward([7.0, 8.0, 9.0]), outer.outward(inner.outward([7.0, 8.0, 9.0])));
    }
}
