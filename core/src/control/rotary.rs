//! Rotary axes: which channel axes are, where they stand, how they turn the part that is clamped on them.
//!
//! A, B and C turn about lines parallel to X, Y and Z through one point. A positive angle moves the tool
//! counter-clockwise about the part (DIN 66217, B:627), so that the table turns clockwise; C is carried by B, B by A.

use super::{Control, Frame};
use crate::geometry::{Degrees, Dir, Mcs, Rpy, V3, rigid};
use nalgebra::Rotation3;

/// Names by index.
pub const ROTARY: [&str; 3] = ["A", "B", "C"];

impl Control {
    /// The rotary axis (index of its name) with this number among the channel axes, from 1; none where there is no such
    /// axis, where it has no name (MD20080) or is not rotary (MD30300, A:15872).
    pub fn rotary_channel_axis(&self, number: i64) -> Option<usize> {
        let place = number.checked_sub(1)?;
        let name = self.text(&format!("MD20080[{place}]")).trim();
        let rotary = self.number(&format!("MD30300[{place}]")) == 1.0;
        ROTARY.iter().position(|known| rotary && name == *known)
    }

    /// The rotary axis with this name, where the machine has it.
    pub fn rotary_axis(&self, name: &str) -> Option<usize> {
        let axis = ROTARY.iter().position(|known| *known == name)?;
        let mut numbers = 1..=super::machine_data::CHANNEL_AXES as i64;
        numbers.any(|number| self.rotary_channel_axis(number) == Some(axis)).then_some(axis)
    }

    /// Where the table has to stand (machine) for a programmed position of a rotary axis: the frames move it.
    pub fn rotary_to_machine(&self, axis: usize, position: Degrees) -> Degrees {
        let moved = self.chain().iter().map(|frame| (frame.rotary[axis] + frame.rotary_fine[axis]).0).sum();
        position + Degrees(moved)
    }

    /// The direction in the machine about which a positive angle turns a direction of the WCS from one of its axes X Y
    /// Z (by index) towards another: the third axis, reversed where the WCS is mirrored.
    pub fn turn_axis(&self, from: usize, to: usize) -> Dir<Mcs> {
        let direction = |axis| V3::from(self.direction_to_machine(V3::ith(axis, 1.0).into()));
        direction(from).cross(&direction(to)).into()
    }

    /// The direction in the machine about which a positive angle of a rotary axis turns the tool round the part, and
    /// the part the other way: that of its name, turned by the axes that carry it.
    pub fn rotary_direction(&self, axis: usize) -> Dir<Mcs> {
        let carrying = Rpy(std::array::from_fn(|i| if i < axis { self.rotary[i].0 } else { 0.0 }));
        (rigid::rotation(carrying).inverse() * V3::ith(axis.min(2), 1.0)).into()
    }

    /// Where the rotary axes A B C of a swivel table go until the active frames lie as the machine, and the frame that
    /// turns with the table about their centre; none: the frames shear (B:7773-7782).
    pub(crate) fn swivelled(&self) -> Option<([Degrees; 3], Frame)> {
        let mut straight = self.clone();
        straight.part_frame = Frame::default();
        let total = straight.total_frame()?;
        let turn = rigid::rotation(total.rotation).inverse();
        let centre = V3::from(self.rotary_centre);
        let coarse = (centre - turn * centre).into();
        let table = Frame { coarse, rotation: rigid::angles(&turn), ..Frame::default() };
        Some((total.rotation.map(Degrees), table))
    }

    /// How the table is turned, in machine coordinates.
    pub(crate) fn table_turn(&self) -> Rotation3<f64> {
        rigid::rotation(Rpy(self.rotary.map(|angle| angle.0))).inverse()
    }
}

/// Whether a frame variable (`$P_UIFR[1,Z,RT]`, `$P_UIFR[1,C,TR]`) counts in degree.
pub fn is_angle(variable: &str) -> bool {
    let mut parts = variable.trim_end_matches(']').rsplit(',');
    let (part, axis) = (parts.next(), parts.next());
    let axis = axis.map(|axis| axis.rsplit('[').next().unwrap_or(axis));
    part == Some("RT") || matches!(part, Some("TR" | "FI")) && axis.is_some_and(|axis| ROTARY.contains(&axis))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    #[test]
    fn the_fourth_axis_is_a_table_as_delivered() {
        // oracle: manual B:7462 (the example's machine), A:15872
        let mut control = delivery(Dialect::Sinumerik);
        assert_eq!(control.rotary_channel_axis(4), Some(2));
        assert_eq!(control.rotary_axis("C"), Some(2));
        for number in [-1, 0, 1, 3, 5, 99] {
            assert_eq!(control.rotary_channel_axis(number), None, "{number}");
        }
        assert_eq!(control.rotary_axis("A"), None);
        control.set("MD30300[3]", 0.0);
        assert_eq!(control.rotary_axis("C"), None);
    }

    #[test]
    fn which_variables_are_angles() {
        // oracle: hand
        for (name, angle) in [
            ("$P_UIFR[1,Z,RT]", true),
            ("$P_UIFR[1,C,FI]", true),
            ("$P_SETFR[C,TR]", true),
            ("$P_SETFR[X,TR]", false),
            ("$P_UIFR[1,X,FI]", false),
            ("$TC_DP3[9,1]", false),
        ] {
            assert_eq!(is_angle(name), angle, "{name}");
        }
    }

    #[test]
    fn a_part_turns_about_the_axis_that_is_told() {
        // oracle: definition: from one position of an axis to another is a turn about it, against the tool
        let mut control = delivery(Dialect::Sinumerik);
        for axis in 0..3 {
            control.rotary = [20.0, -35.0, 50.0].map(Degrees);
            let before = control.table_turn();
            let about = nalgebra::Unit::new_normalize(V3::from(control.rotary_direction(axis)));
            control.rotary[axis] = control.rotary[axis] + Degrees(25.0);
            let turn = Rotation3::from_axis_angle(&about, -25.0_f64.to_radians());
            let after = turn * before;
            assert!((after.matrix() - control.table_turn().matrix()).norm() < 1e-12, "{axis}");
        }
    }
}
