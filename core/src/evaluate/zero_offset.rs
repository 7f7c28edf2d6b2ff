//! What correcting a zero offset writes (B:1930-2003, B:6153): afterwards the measured point has the set
//! coordinates, as soon as the corrected frame is active. The rotation is kept.

use super::Write;
use super::knum::{self, ZeroCode};
use crate::control::frames::{CHANNEL_MASK, GLOBAL_MASK};
use crate::control::variables::AXES;
use crate::control::{Control, Frame, Value};

/// Where a frame is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Store {
    /// `$P_UIFR[n]`.
    Settable(usize),
    /// `$P_CHBFR[n]`.
    ChannelBasic(usize),
    /// `$P_NCBFR[n]`.
    GlobalBasic(usize),
    /// `$P_SETFR`.
    System,
}

/// The frame to correct.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// Where it is stored.
    pub store: Store,
    /// Reckoned as if no settable frame were active (`_KNUM` = 1000, B:1938).
    pub without_settable: bool,
    /// The cycle makes it active itself (`_KNUM` = 9999, B:1965).
    pub activate: bool,
}

/// Finds the frame. None: `_KNUM` is 0. Error: number of the alarm.
pub fn target(control: &Control, code: i64) -> Result<Option<Target>, u32> {
    let Some(code) = knum::zero(code)? else {
        return Ok(None);
    };
    let stored = |store| Target {
        store,
        without_settable: false,
        activate: false,
    };
    Ok(Some(match code {
        ZeroCode::Settable(number) => stored(Store::Settable(number)),
        ZeroCode::ChannelBasic(index) => stored(Store::ChannelBasic(index)),
        ZeroCode::GlobalBasic(index) => stored(Store::GlobalBasic(index)),
        ZeroCode::System if !system_frame(control) => return Err(61321),
        ZeroCode::System => stored(Store::System),
        ZeroCode::LastBasic => Target {
            without_settable: true,
            ..stored(last_basic(control)?)
        },
        ZeroCode::Active if control.settable == 0 => Target {
            activate: true,
            ..stored(last_basic(control)?)
        },
        ZeroCode::Active => Target {
            activate: true,
            ..stored(Store::Settable(control.settable))
        },
    }))
}

/// Whether the control has the system frame that `_KNUM` = 2000 means (MD28082 bit 0, B:1977-1986).
pub fn system_frame(control: &Control) -> bool {
    control.machine_bit("MD28082", 0)
}

/// The channel basic frame of the highest bit in `$P_CHBFRMASK`; without a mask the last one that exists. Alarm 61412
/// where there is none (A:15931).
fn last_basic(control: &Control) -> Result<Store, u32> {
    let index = match control.data.get(CHANNEL_MASK) {
        Some(Value::Number(bits)) => (*bits as u32).checked_ilog2().map(|bit| bit as usize),
        _ => control.channel_basic.keys().next_back().copied(),
    };
    index.map(Store::ChannelBasic).ok_or(61412)
}

/// What was measured. Points X Y Z in the WCS that is active while measuring, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Where the part really is.
    pub actual: [f64; 3],
    /// Where it should be.
    pub set: [f64; 3],
    /// Which of X Y Z were measured; only these are corrected (B:6167-6171).
    pub axes: [bool; 3],
}

/// What the correction writes. The chain is system : global basic : channel basic : settable : programmed frame.
pub fn writes(control: &Control, target: &Target, measured: &Measured) -> Vec<Write> {
    let machine = control.to_machine(measured.actual);
    let (before, old, after) = around(control, target);
    let chained = before
        .iter()
        .fold(machine, |point, frame| frame.inward(point));
    let seen = after
        .iter()
        .fold(old.inward(chained), |point, frame| frame.inward(point));
    let wrong = std::array::from_fn(|axis| {
        if measured.axes[axis] {
            seen[axis] - measured.set[axis]
        } else {
            0.0
        }
    });
    let turned = after
        .iter()
        .rev()
        .fold(wrong, |direction, frame| frame.turn(direction));
    shifted(control, target, &old, old.turn(turned))
}

/// Frames outside of the target (outermost first), the target as stored, frames inside of it. Those around it are the
/// ones in effect, which stay (B:1967).
fn around(control: &Control, target: &Target) -> (Vec<Frame>, Frame, Vec<Frame>) {
    let mut before = Vec::new();
    let mut after = Vec::new();
    let settable = match target.store {
        Store::Settable(_) => None,
        _ if target.without_settable => None,
        _ => Some((Store::Settable(control.settable), control.active)),
    };
    let others = in_effect(control).into_iter().chain(settable);
    for (store, frame) in others.filter(|(store, _)| *store != target.store) {
        if outside(store, target.store) {
            before.push(frame);
        } else {
            after.push(frame);
        }
    }
    after.push(control.program_frame);
    (before, stored(control, target.store), after)
}

/// Basic frames in the chain, outermost first.
fn in_effect(control: &Control) -> Vec<(Store, Frame)> {
    let basic = &control.basic;
    let global = basic.global.iter();
    let global = global
        .filter(|(index, _)| control.included(GLOBAL_MASK, **index))
        .map(|(index, frame)| (Store::GlobalBasic(*index), *frame));
    let channel = basic.channel.iter();
    let channel = channel
        .filter(|(index, _)| control.included(CHANNEL_MASK, **index))
        .map(|(index, frame)| (Store::ChannelBasic(*index), *frame));
    std::iter::once((Store::System, basic.system))
        .chain(global)
        .chain(channel)
        .collect()
}

/// Whether one frame lies outside of the other in the chain.
fn outside(one: Store, other: Store) -> bool {
    let rank = |store| match store {
        Store::System => (0, 0),
        Store::GlobalBasic(index) => (1, index),
        Store::ChannelBasic(index) => (2, index),
        Store::Settable(_) => (3, 0),
    };
    rank(one) < rank(other)
}

/// The frame as stored.
fn stored(control: &Control, store: Store) -> Frame {
    match store {
        Store::Settable(number) => control.frames.get(&number).copied(),
        Store::ChannelBasic(index) => control.channel_basic.get(&index).copied(),
        Store::GlobalBasic(index) => control.global_basic.get(&index).copied(),
        Store::System => Some(control.system),
    }
    .unwrap_or_default()
}

/// Into the fine part with MD18600 = 1; into the coarse part, the fine part included and erased, with MD18600 = 0,
/// `_CHBIT[21]` = 1 or for `$P_SETFR` (B:1990-2003, B:14035-14039).
fn shifted(control: &Control, target: &Target, old: &Frame, shift: [f64; 3]) -> Vec<Write> {
    let coarse = target.store == Store::System
        || control.bit("_CHBIT[21]")
        || control.number("MD18600") == 0.0;
    let stem = match target.store {
        Store::Settable(number) => format!("$P_UIFR[{number},"),
        Store::ChannelBasic(index) => format!("$P_CHBFR[{index},"),
        Store::GlobalBasic(index) => format!("$P_NCBFR[{index},"),
        Store::System => "$P_SETFR[".to_string(),
    };
    let mut writes = Vec::new();
    for (axis, letter) in AXES.iter().enumerate() {
        let mut write = |part: &str, value: f64, before: f64| {
            if value != before {
                writes.push(Write {
                    name: format!("{stem}{letter},{part}]"),
                    value,
                });
            }
        };
        let (in_coarse, in_fine) = (old.coarse[axis], old.fine[axis]);
        if coarse {
            write("TR", in_coarse + in_fine + shift[axis], in_coarse);
            write("FI", 0.0, in_fine);
        } else {
            write("FI", in_fine + shift[axis], in_fine);
        }
    }
    writes
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::Dialect;
    use crate::control::delivery;

    fn control() -> Control {
        let mut control = delivery(Dialect::Sinumerik);
        control.set("MD18600", 1.0);
        control.activate(1);
        control
    }

    fn correct(control: &mut Control, code: i64, measured: &Measured) -> Vec<String> {
        let target = target(control, code).unwrap().unwrap();
        let writes = writes(control, &target, measured);
        for write in &writes {
            assert!(
                control.set_variable(&write.name, write.value),
                "{}",
                write.name
            );
        }
        writes.into_iter().map(|write| write.name).collect()
    }

    const RECTANGLE: Measured = Measured {
        actual: [151.2, 169.4, 120.0],
        set: [150.0, 170.0, 120.0],
        axes: [true, true, false],
    };

    #[test]
    fn the_difference_goes_into_the_fine_part() {
        // oracle: manual B:6276-6278, B:1990
        let mut control = control();
        assert_eq!(
            correct(&mut control, 1, &RECTANGLE),
            ["$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]"]
        );
        let frame = control.frames[&1];
        assert!((frame.fine[0] - 1.2).abs() < 1e-12 && (frame.fine[1] + 0.6).abs() < 1e-12);
        assert_eq!(frame.fine[2], 0.0);
    }

    #[test]
    fn or_with_the_fine_part_into_the_coarse_one() {
        // oracle: manual B:14039
        let mut control = control();
        control.frames.insert(
            1,
            Frame {
                fine: [0.1, 0.2, 0.0],
                ..Frame::default()
            },
        );
        control.activate(1);
        control.set("_CHBIT[21]", 1.0);
        correct(&mut control, 1, &RECTANGLE);
        let frame = control.frames[&1];
        assert!((frame.coarse[0] - 1.3).abs() < 1e-12 && (frame.coarse[1] + 0.4).abs() < 1e-12);
        assert_eq!(frame.fine, [0.0; 3]);
    }

    /// A control with something in every frame.
    fn chained() -> Control {
        let mut control = control();
        let frame = |x: f64, turn: f64| Frame {
            coarse: [x, 2.0 * x, 3.0],
            fine: [0.01, 0.0, 0.02],
            rotation: [0.0, 0.0, turn],
            ..Frame::default()
        };
        control.system = Frame::translation([1.0, 2.0, 3.0]);
        control
            .global_basic
            .insert(0, Frame::translation([5.0, 0.0, 0.0]));
        control.channel_basic.insert(0, frame(10.0, 30.0));
        control.channel_basic.insert(1, frame(-4.0, -12.0));
        control.frames.insert(1, frame(100.0, 20.0));
        control.frames.insert(2, frame(50.0, -75.0));
        control.program_frame = frame(7.0, 11.0);
        control.activate(1);
        control
    }

    #[test]
    fn afterwards_the_point_has_the_set_coordinates() {
        // oracle: self (the definition of B:6153 by the control's own transformation)
        for code in [1, 1011, 1012, 1051, 2000, 9999] {
            for coarse in [0.0, 1.0] {
                let mut control = chained();
                control.set("_CHBIT[21]", coarse);
                let measured = Measured {
                    actual: [31.0, 42.0, 5.0],
                    set: [30.5, 41.7, 5.3],
                    axes: [true; 3],
                };
                let machine = control.to_machine(measured.actual);
                correct(&mut control, code, &measured);
                control.activate(1);
                let seen = control.to_workpiece(machine);
                for axis in 0..3 {
                    assert!(
                        (seen[axis] - measured.set[axis]).abs() < 1e-9,
                        "{code}: {seen:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn another_settable_frame_keeps_its_rotation() {
        // oracle: self (B:6147, B:6153)
        let mut control = chained();
        let measured = Measured {
            actual: [31.0, 42.0, 5.0],
            set: [0.0, 0.0, 0.0],
            axes: [true; 3],
        };
        let machine = control.to_machine(measured.actual);
        correct(&mut control, 2, &measured);
        assert_eq!(control.frames[&2].rotation, [0.0, 0.0, -75.0]);
        control.activate(2);
        assert!(control.to_workpiece(machine).iter().all(|x| x.abs() < 1e-9));
    }

    #[test]
    fn the_last_basic_frame_is_reckoned_without_a_settable_one() {
        // oracle: self (B:1938)
        let mut control = chained();
        let measured = Measured {
            actual: [31.0, 42.0, 5.0],
            set: [1.0, 2.0, 3.0],
            axes: [true; 3],
        };
        let machine = control.to_machine(measured.actual);
        let names = correct(&mut control, 1000, &measured);
        assert!(
            names.iter().all(|name| name.starts_with("$P_CHBFR[1,")),
            "{names:?}"
        );
        control.frames.insert(0, Frame::default());
        control.activate(0);
        let seen = control.to_workpiece(machine);
        assert!(
            seen.iter()
                .zip(measured.set)
                .all(|(a, b)| (a - b).abs() < 1e-9),
            "{seen:?}"
        );
    }

    #[test]
    fn what_does_not_exist_alarms() {
        // oracle: manual A:15862, A:15931
        let mut control = control();
        assert_eq!(target(&control, 100), Err(61321));
        assert_eq!(target(&control, 0), Ok(None));
        control.channel_basic.clear();
        control.set("$P_CHBFRMASK", 0.0);
        assert_eq!(target(&control, 1000), Err(61412));
        // oracle: manual B:1984
        let mut without = control.clone();
        without.set("MD28082", 32.0);
        assert_eq!(target(&without, 2000), Err(61321));
        control.set("$P_CHBFRMASK", 5.0);
        assert_eq!(
            target(&control, 1000).unwrap().unwrap().store,
            Store::ChannelBasic(2)
        );
    }
}
