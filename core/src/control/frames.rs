//! Coordinate systems: workpiece (WCS) ↔ machine (basic) by the chain
//! frame of the swivel table · system frame · NCU-global basic frames · channel basic frames · active settable frame · programmed frame.
//! Lengths in mm, angles in degree.

use super::{BasicFrames, Control, Frame, Value};
use crate::geometry::rigid::{angles, rotation};
use nalgebra::{Matrix3, Vector3};

/// Which channel basic frames are in the chain: bit 0 is `$P_CHBFR[0]`.
pub const CHANNEL_MASK: &str = "$P_CHBFRMASK";
/// Which NCU-global basic frames are in the chain: bit 0 is `$P_NCBFR[0]`.
pub const GLOBAL_MASK: &str = "$P_NCBFRMASK";

impl Default for Frame {
    fn default() -> Frame {
        Frame {
            coarse: [0.0; 3],
            fine: [0.0; 3],
            rotation: [0.0; 3],
            rotary: [0.0; 3],
            rotary_fine: [0.0; 3],
            scale: [1.0; 3],
            mirror: [false; 3],
        }
    }
}

impl Frame {
    /// A pure translation, mm.
    pub fn translation(coarse: [f64; 3]) -> Frame {
        Frame {
            coarse,
            ..Frame::default()
        }
    }

    /// Coarse and fine translation together, mm.
    pub fn origin(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.coarse[i] + self.fine[i])
    }

    /// A point of this system in the one before it.
    pub fn outward(&self, point: [f64; 3]) -> [f64; 3] {
        let scaled = std::array::from_fn(|i| point[i] * self.scale[i]);
        add(self.origin(), self.turn(scaled))
    }

    /// A point of the system before it in this one.
    pub fn inward(&self, point: [f64; 3]) -> [f64; 3] {
        let scaled = self.turn_back(subtract(point, self.origin()));
        std::array::from_fn(|i| scaled[i] / self.scale[i])
    }

    /// Whether a scale factor other than 1 is in it.
    pub fn scaled(&self) -> bool {
        self.scale != [1.0; 3]
    }

    /// Whether this frame followed by another is a frame again: a rotation inside of a scale that differs by axis
    /// would shear.
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

    /// Angles that a rotation inside of this frame has outside of its mirrors: each turns the other way for every mirror
    /// that is not of its own axis.
    fn angles_outside(&self, rotation: [f64; 3]) -> [f64; 3] {
        let all: f64 = (0..3).map(|axis| self.sign(axis)).product();
        std::array::from_fn(|i| all * self.sign(i) * rotation[i])
    }

    /// This frame followed by another inside it (`:` of frames), where [`Frame::chains_with`] holds; the result has no
    /// fine part.
    pub fn then(&self, inner: &Frame) -> Frame {
        let inside = self.angles_outside(inner.rotation);
        let still = self.rotation == [0.0; 3] || inside == [0.0; 3];
        let rotation = match still {
            true => add(self.rotation, inside),
            false => angles(&(rotation(self.rotation) * rotation(inside))),
        };
        Frame {
            coarse: self.outward(inner.origin()),
            fine: [0.0; 3],
            rotation,
            rotary: add(
                add(self.rotary, self.rotary_fine),
                add(inner.rotary, inner.rotary_fine),
            ),
            rotary_fine: [0.0; 3],
            scale: std::array::from_fn(|i| self.scale[i] * inner.scale[i]),
            mirror: std::array::from_fn(|i| self.mirror[i] != inner.mirror[i]),
        }
    }
}

/// The frames between machine and WCS while they are out of effect.
#[derive(Clone, Debug)]
pub struct InEffect {
    basic: BasicFrames,
    part: Frame,
    settable: Frame,
    programmed: Frame,
}

impl Control {
    /// Frames in effect between machine and the settable frame, outermost first: table, system, global basic, channel
    /// basic.
    pub fn basic_chain(&self) -> Vec<Frame> {
        self.basic_links().copied().collect()
    }

    fn basic_links(&self) -> impl DoubleEndedIterator<Item = &Frame> {
        let global = self.basic.global.iter();
        let global = global.filter(|(index, _)| self.included(GLOBAL_MASK, **index));
        let channel = self.basic.channel.iter();
        let channel = channel.filter(|(index, _)| self.included(CHANNEL_MASK, **index));
        [&self.part_frame, &self.basic.system]
            .into_iter()
            .chain(global.chain(channel).map(|(_, frame)| frame))
    }

    /// Whether the bit of a basic frame is set in its mask. Without a mask all count.
    pub fn included(&self, mask: &str, index: usize) -> bool {
        match self.data.get(mask) {
            Some(Value::Number(bits)) => *bits as u32 >> index.min(31) & 1 == 1,
            _ => true,
        }
    }

    /// All frames from the machine to the WCS, outermost first.
    pub fn chain(&self) -> Vec<Frame> {
        self.links().copied().collect()
    }

    fn links(&self) -> impl DoubleEndedIterator<Item = &Frame> {
        self.basic_links()
            .chain([&self.active, &self.program_frame])
    }

    /// Takes all frames out of effect, so that the WCS is that of the machine; see [`Control::put_frames`].
    pub fn take_frames(&mut self) -> InEffect {
        InEffect {
            basic: std::mem::take(&mut self.basic),
            part: std::mem::take(&mut self.part_frame),
            settable: std::mem::take(&mut self.active),
            programmed: std::mem::take(&mut self.program_frame),
        }
    }

    /// Brings back into effect what [`Control::take_frames`] took out.
    pub fn put_frames(&mut self, frames: InEffect) {
        self.basic = frames.basic;
        self.part_frame = frames.part;
        self.active = frames.settable;
        self.program_frame = frames.programmed;
    }

    /// Whether a frame between machine and WCS turns.
    pub fn rotated(&self) -> bool {
        self.links().any(|frame| frame.rotation != [0.0; 3])
    }

    /// All frames as one, `$P_ACTFRAME`; none: a scale and a rotation in them would shear.
    pub fn total_frame(&self) -> Option<Frame> {
        let chain = self.chain();
        chain.iter().try_fold(Frame::default(), |all, frame| {
            all.chains_with(frame).then(|| all.then(frame))
        })
    }

    /// A point of the WCS in machine coordinates.
    pub fn to_machine(&self, point: [f64; 3]) -> [f64; 3] {
        self.links()
            .rev()
            .fold(point, |point, frame| frame.outward(point))
    }

    /// A point in machine coordinates in the WCS.
    pub fn to_workpiece(&self, point: [f64; 3]) -> [f64; 3] {
        self.links().fold(point, |point, frame| frame.inward(point))
    }

    /// A direction of the WCS in machine coordinates.
    pub fn direction_to_machine(&self, direction: [f64; 3]) -> [f64; 3] {
        self.links()
            .rev()
            .fold(direction, |direction, frame| frame.turn(direction))
    }

    /// A direction in machine coordinates in the WCS.
    pub fn direction_to_workpiece(&self, direction: [f64; 3]) -> [f64; 3] {
        self.links()
            .fold(direction, |direction, frame| frame.turn_back(direction))
    }

    /// Whether an axis X Y Z of the WCS runs against that of the machine: an odd number of frames mirrors it.
    pub fn mirrored(&self, axis: usize) -> bool {
        let mirrored = |frame: &&Frame| frame.mirror[axis.min(2)];
        self.links().filter(mirrored).count() % 2 == 1
    }

    /// What G54.., G500 do: the stored settable frame becomes the active one, and so do the stored basic and system
    /// frames (B:1965). G500 (SINUMERIK 0) is a frame too.
    pub fn activate(&mut self, number: usize) {
        self.settable = number;
        self.basic = BasicFrames {
            system: self.system,
            global: self.global_basic.clone(),
            channel: self.channel_basic.clone(),
        };
        self.active = self.frames.get(&number).copied().unwrap_or_default();
        if self.dialect == crate::catalogue::Dialect::Nct {
            let common = self.frames.get(&0).copied().unwrap_or_default();
            self.active = common.then(&self.active);
        }
    }
}

/// Sum of two vectors.
fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + b[i])
}

/// Difference of two vectors.
fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::Dialect;
    use crate::control::delivery::delivery;

    fn near(a: [f64; 3], b: [f64; 3]) {
        for i in 0..3 {
            assert!((a[i] - b[i]).abs() < 1e-9, "{a:?} {b:?}");
        }
    }

    #[test]
    fn rpy_turns_z_first() {
        // oracle: hand. Rz(90) takes X to Y; then the turned Y axis is -X of the outer system.
        let frame = Frame {
            rotation: [0.0, 0.0, 90.0],
            ..Frame::default()
        };
        near(frame.turn([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        // oracle: hand. Z 90, then about the turned X (now outer Y) 90: inner Y goes to outer Z.
        let frame = Frame {
            rotation: [90.0, 0.0, 90.0],
            ..Frame::default()
        };
        near(frame.turn([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn angles_come_back() {
        // oracle: self (inverse)
        near(
            angles(&rotation([10.0, -20.0, 130.0])),
            [10.0, -20.0, 130.0],
        );
    }

    #[test]
    fn the_chain_goes_both_ways() {
        let mut control = delivery(Dialect::Sinumerik);
        control.system = Frame::translation([100.0, 0.0, 0.0]);
        control
            .global_basic
            .insert(0, Frame::translation([0.0, 10.0, 0.0]));
        control.channel_basic.insert(
            0,
            Frame {
                rotation: [0.0, 0.0, 90.0],
                ..Frame::default()
            },
        );
        control.frames.insert(
            1,
            Frame {
                coarse: [5.0, 0.0, 0.0],
                fine: [0.5, 0.0, 0.0],
                ..Frame::default()
            },
        );
        control.activate(1);
        // oracle: hand: (1,0,0) -> settable (6.5,0,0) -> turned (0,6.5,0) -> +10 in Y -> +100 in X
        near(control.to_machine([1.0, 0.0, 0.0]), [100.0, 16.5, 0.0]);
        near(control.to_workpiece([100.0, 16.5, 0.0]), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_scale_works_along_the_own_axes() {
        let frame = Frame {
            coarse: [1.0, 0.0, 0.0],
            rotation: [0.0, 0.0, 90.0],
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
            rotation: [0.0, 0.0, 90.0],
            mirror: [true, false, false],
            ..Frame::default()
        };
        // oracle: hand: X3 goes to the minus side of X, which the rotation puts along -Y of the outer system
        near(frame.outward([3.0, 1.0, 2.0]), [9.0, -3.0, 2.0]);
        near(frame.inward([9.0, -3.0, 2.0]), [3.0, 1.0, 2.0]);
        // oracle: hand: seen from outside, a rotation inside of a mirror turns the other way
        let inner = Frame {
            rotation: [0.0, 0.0, 30.0],
            ..Frame::default()
        };
        near(frame.then(&inner).rotation, [0.0, 0.0, 60.0]);
        assert_eq!(frame.then(&frame).mirror, [false; 3]);
    }

    #[test]
    fn basic_frames_wait_for_the_next_activation() {
        let mut control = delivery(Dialect::Sinumerik);
        let shifted = |control: &Control| control.to_machine([0.0; 3])[0];
        // oracle: manual B:1965 (G500, G54.. make them active), B:1944 (only those of the mask)
        control.system = Frame::translation([1.0, 0.0, 0.0]);
        control
            .global_basic
            .insert(3, Frame::translation([10.0, 0.0, 0.0]));
        control
            .channel_basic
            .insert(0, Frame::translation([100.0, 0.0, 0.0]));
        assert_eq!(shifted(&control), 0.0);
        control.activate(0);
        assert_eq!(shifted(&control), 111.0);
        control.set(CHANNEL_MASK, 2.0);
        control.set(GLOBAL_MASK, 8.0);
        assert_eq!(shifted(&control), 11.0);
    }

    #[test]
    fn frames_chain_as_one() {
        let outer = Frame {
            coarse: [1.0, 2.0, 3.0],
            fine: [0.1, 0.0, 0.0],
            rotation: [0.0, 30.0, 0.0],
            scale: [2.0; 3],
            mirror: [false, true, true],
            ..Frame::default()
        };
        let inner = Frame {
            coarse: [4.0, 5.0, 6.0],
            fine: [0.0; 3],
            rotation: [20.0, 0.0, 40.0],
            scale: [1.0, 0.5, 3.0],
            mirror: [true, false, false],
            ..Frame::default()
        };
        let both = outer.then(&inner);
        // oracle: self (one after the other)
        near(
            both.outward([7.0, 8.0, 9.0]),
            outer.outward(inner.outward([7.0, 8.0, 9.0])),
        );
    }
}
