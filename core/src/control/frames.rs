//! Coordinate systems: workpiece (WCS) ↔ machine (basic) by the chain frame of the swivel table · system frame ·
//! NCU-global basic frames · channel basic frames · active settable frame · plane of CYCLE800 · programmed frame. mm,
//! degree.

use super::{BasicFrames, Control, Frame, Value};
use crate::geometry::{Dir, Mcs, Wcs};
use std::collections::BTreeSet;

/// Which channel basic frames are in the chain: bit 0 is `$P_CHBFR[0]`.
pub const CHANNEL_MASK: &str = "$P_CHBFRMASK";
/// Which NCU-global basic frames are in the chain: bit 0 is `$P_NCBFR[0]`.
pub const GLOBAL_MASK: &str = "$P_NCBFRMASK";

/// Where a frame is stored, in the order of the chain, outermost first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Store {
    /// `$P_SETFR`.
    System,
    /// `$P_NCBFR[n]`.
    GlobalBasic(usize),
    /// `$P_CHBFR[n]`.
    ChannelBasic(usize),
    /// `$P_UIFR[n]`.
    Settable(usize),
}

/// The frames between machine and WCS while they are out of effect: basic, and of the table, settable, of the
/// plane, programmed.
#[derive(Clone, Debug)]
pub struct InEffect(BasicFrames, [Frame; 4]);

impl Control {
    /// Frames in effect between machine and settable frame, outermost first: table, system, global, channel basic.
    pub fn basic_chain(&self) -> Vec<Frame> {
        self.basic_links().copied().collect()
    }

    fn basic_links(&self) -> impl DoubleEndedIterator<Item = &Frame> {
        std::iter::once(&self.part_frame).chain(self.basic_in_effect().map(|(_, frame)| frame))
    }

    /// The basic frames in effect, outermost first, and where each is stored.
    pub fn basic_in_effect(&self) -> impl DoubleEndedIterator<Item = (Store, &Frame)> {
        let in_mask = |mask: &'static str| move |(index, _): &(&usize, &Frame)| self.included(mask, **index);
        let global = self.basic.global.iter().filter(in_mask(GLOBAL_MASK));
        let channel = self.basic.channel.iter().filter(in_mask(CHANNEL_MASK));
        std::iter::once((Store::System, &self.basic.system))
            .chain(global.map(|(index, frame)| (Store::GlobalBasic(*index), frame)))
            .chain(channel.map(|(index, frame)| (Store::ChannelBasic(*index), frame)))
    }

    /// Whether the bit of a basic frame is set in its mask. Without a mask all count.
    fn included(&self, mask: &str, index: usize) -> bool {
        match self.data.get(mask) {
            Some(Value::Number(bits)) => *bits as u32 >> index.min(31) & 1 == 1,
            _ => true,
        }
    }

    /// Numbers of the channel basic frames that exist: as many as MD28081 says (B:1938), and those that hold something.
    pub fn channel_basic_numbers(&self) -> BTreeSet<usize> {
        let told = self.number("MD28081").clamp(0.0, 16.0) as usize;
        (0..told).chain(self.stored.channel.keys().copied()).collect()
    }

    /// All frames from the machine to the WCS, outermost first.
    pub fn chain(&self) -> Vec<Frame> {
        self.links().copied().collect()
    }

    fn links(&self) -> impl DoubleEndedIterator<Item = &Frame> {
        self.basic_links().chain([&self.active, &self.plane_frame, &self.program_frame])
    }

    /// Takes all frames out of effect, so that the WCS is that of the machine; see [`Control::put_frames`].
    pub fn take_frames(&mut self) -> InEffect {
        let others = [&mut self.part_frame, &mut self.active, &mut self.plane_frame, &mut self.program_frame];
        InEffect(std::mem::take(&mut self.basic), others.map(std::mem::take))
    }

    /// Brings back into effect what [`Control::take_frames`] took out.
    pub fn put_frames(&mut self, InEffect(basic, others): InEffect) {
        self.basic = basic;
        [self.part_frame, self.active, self.plane_frame, self.program_frame] = others;
    }

    /// Whether a frame between machine and WCS turns.
    pub fn rotated(&self) -> bool {
        self.links().any(|frame| frame.rotation != [0.0; 3])
    }

    /// All frames as one, `$P_ACTFRAME`; none: a scale and a rotation in them would shear.
    pub fn total_frame(&self) -> Option<Frame> {
        joined(&self.chain())
    }

    /// A point of the WCS in machine coordinates.
    pub fn to_machine(&self, point: Wcs) -> Mcs {
        Mcs(self.links().rev().fold(point.0, |point, frame| frame.outward(point)))
    }

    /// A point in machine coordinates in the WCS.
    pub fn to_workpiece(&self, point: Mcs) -> Wcs {
        Wcs(self.links().fold(point.0, |point, frame| frame.inward(point)))
    }

    /// A direction of the WCS in machine coordinates.
    pub fn direction_to_machine(&self, direction: Dir<Wcs>) -> Dir<Mcs> {
        Dir::new(self.links().rev().fold(direction.0, |direction, frame| frame.turn(direction)))
    }

    /// A direction in machine coordinates in the WCS.
    pub fn direction_to_workpiece(&self, direction: Dir<Mcs>) -> Dir<Wcs> {
        Dir::new(self.links().fold(direction.0, |direction, frame| frame.turn_back(direction)))
    }

    /// Whether an axis X Y Z of the WCS runs against that of the machine: an odd number of frames mirrors it.
    pub fn mirrored(&self, axis: usize) -> bool {
        let mirrored = |frame: &&Frame| frame.mirror[axis.min(2)];
        self.links().filter(mirrored).count() % 2 == 1
    }

    /// The frame that is stored there.
    pub fn stored_frame(&self, store: Store) -> Frame {
        let frame = match store {
            Store::System => Some(&self.stored.system),
            Store::GlobalBasic(index) => self.stored.global.get(&index),
            Store::ChannelBasic(index) => self.stored.channel.get(&index),
            Store::Settable(number) => self.frames.get(&number),
        };
        frame.copied().unwrap_or_default()
    }

    /// What G54.., G500 do, which is a frame too: stored settable, basic and system frames become active (B:1965).
    pub fn activate(&mut self, number: usize) {
        self.settable = number;
        self.basic = self.stored.clone();
        self.active = self.stored_frame(Store::Settable(number));
        if self.make().common {
            self.active = self.stored_frame(Store::Settable(0)).then(&self.active);
        }
    }

    /// A work offset of NCT was written, 0 the common one: where it is in effect it counts at once (C:1159-1183).
    pub fn offset_written(&mut self, offset: usize) {
        if offset == 0 || offset == self.settable {
            self.activate(self.settable);
        }
    }
}

/// Frames one in the other as one; none: a scale and a rotation in them would shear.
pub fn joined(chain: &[Frame]) -> Option<Frame> {
    chain.iter().try_fold(Frame::default(), |all, frame| all.chains_with(frame).then(|| all.then(frame)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::geometry::{Mcs, Rpy, Wcs};

    fn near(a: [f64; 3], b: [f64; 3]) {
        assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-9), "{a:?} {b:?}");
    }

    #[test]
    fn the_chain_goes_both_ways() {
        let mut control = delivery(Dialect::Sinumerik);
        control.stored.system = Frame::translation([100.0, 0.0, 0.0]);
        control.stored.global.insert(0, Frame::translation([0.0, 10.0, 0.0]));
        control.stored.channel.insert(0, Frame { rotation: Rpy([0.0, 0.0, 90.0]), ..Frame::default() });
        control.frames.insert(1, Frame { coarse: [5.0, 0.0, 0.0], fine: [0.5, 0.0, 0.0], ..Frame::default() });
        control.activate(1);
        // oracle: hand: (1,0,0) -> settable (6.5,0,0) -> turned (0,6.5,0) -> +10 in Y -> +100 in X
        near(control.to_machine(Wcs([1.0, 0.0, 0.0])).0, [100.0, 16.5, 0.0]);
        near(control.to_workpiece(Mcs([100.0, 16.5, 0.0])).0, [1.0, 0.0, 0.0]);
    }

    #[test]
    fn basic_frames_wait_for_the_next_activation() {
        let mut control = delivery(Dialect::Sinumerik);
        let shifted = |control: &Control| control.to_machine(Wcs([0.0; 3]))[0];
        // oracle: manual B:1965 (G500, G54.. make them active), B:1944 (only those of the mask)
        control.stored.system = Frame::translation([1.0, 0.0, 0.0]);
        control.stored.global.insert(3, Frame::translation([10.0, 0.0, 0.0]));
        control.stored.channel.insert(0, Frame::translation([100.0, 0.0, 0.0]));
        assert_eq!(shifted(&control), 0.0);
        control.activate(0);
        assert_eq!(shifted(&control), 111.0);
        control.set(CHANNEL_MASK, 2.0);
        control.set(GLOBAL_MASK, 8.0);
        assert_eq!(shifted(&control), 11.0);
    }
}
