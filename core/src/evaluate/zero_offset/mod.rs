//! What correcting a zero offset writes (B:1930-2003, B:6153): afterwards the measured point has the set
//! coordinates, as soon as the corrected frame is active. The rotation is kept. DESIGN.md derives the formulas.

#[cfg(test)]
mod tests;
mod turn;

pub use turn::{levelled, moved, placed, rotary, rotation, seen, seen_turn, turned};

use super::knum::ZeroCode;
use super::{Write, knum};
pub use crate::control::frames::Store;
use crate::control::{AXES, Control, Frame, Value, frames::CHANNEL_MASK};
use crate::geometry::Wcs;

/// Values of a frame closer than this, mm or degree, are the same: rounding is no correction.
const SAME: f64 = 1e-12;

/// The frame to correct.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// Where it is stored.
    pub store: Store,
    /// Calculated as if G500 were active, whose frame is `$P_UIFR[0]` (`_KNUM` = 1000, B:1938).
    pub without_settable: bool,
    /// The cycle makes it active itself (`_KNUM` = 9999, B:1965).
    pub activate: bool,
}

/// Finds the frame. None: `_KNUM` is 0. Error: number of the alarm.
pub(crate) fn target(control: &Control, code: i64) -> Result<Option<Target>, u32> {
    let Some(code) = knum::zero(code)? else { return Ok(None) };
    let stored = |store| Target { store, without_settable: false, activate: false };
    Ok(Some(match code {
        ZeroCode::Stored(Store::System) if !system_frame(control) => return Err(61321),
        ZeroCode::Stored(store) => stored(store),
        ZeroCode::LastBasic => Target { without_settable: true, ..stored(last_basic(control)?) },
        ZeroCode::Active if control.settable == 0 => Target { activate: true, ..stored(last_basic(control)?) },
        ZeroCode::Active => Target { activate: true, ..stored(Store::Settable(control.settable)) },
    }))
}

/// Whether a frame that is corrected has a scale factor, or one that is active as soon as it is right: then it could
/// not be measured in it again, and what was measured in another one would come out multiplied.
pub fn scaled(control: &Control, target: &Target) -> bool {
    let settable = target.without_settable.then(|| control.stored_frame(Store::Settable(0)));
    std::iter::once(control.stored_frame(target.store)).chain(settable).any(|frame| frame.scaled())
}

/// Whether the control has the system frame that `_KNUM` = 2000 means (MD28082 bit 0, B:1977-1986).
pub fn system_frame(control: &Control) -> bool {
    control.machine_bit("MD28082", 0)
}

/// The channel basic frame of the highest bit in `$P_CHBFRMASK`, without a mask the last one; else 61412 (A:15931).
pub(crate) fn last_basic(control: &Control) -> Result<Store, u32> {
    let index = match control.data.get(CHANNEL_MASK) {
        Some(Value::Number(bits)) => (*bits as u32).checked_ilog2().map(|bit| bit as usize),
        _ => control.channel_basic_numbers().last().copied(),
    };
    index.map(Store::ChannelBasic).ok_or(61412)
}

/// Whether a frame and those in effect with it only move and turn: no mirror, no scale factor.
pub fn rigid(control: &Control, target: &Target) -> bool {
    let own = control.stored_frame(target.store);
    let plain = |frame: &Frame| !frame.scaled() && frame.mirror == [false; 3];
    plain(&own) && control.chain().iter().all(plain)
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

impl Measured {
    /// Nothing is measured yet; axes that will not be are here, which counts in a frame tilted against the present one.
    pub fn at(here: [f64; 3]) -> Measured {
        Measured { actual: here, set: here, axes: [false; 3] }
    }

    /// A coordinate of X (0), Y (1) or Z (2), as given and as measured, mm.
    pub fn put(&mut self, axis: usize, set: f64, actual: f64) {
        self.set[axis] = set;
        self.actual[axis] = actual;
        self.axes[axis] = true;
    }
}

/// What the correction writes. The chain is system : global basic : channel basic : settable : programmed frame.
/// Fine part with MD18600 = 1; coarse with 0, `_CHBIT[21]` = 1 or `$P_SETFR` (B:1990-2003, B:14035-14039).
pub fn writes(control: &Control, target: &Target, measured: &Measured) -> Vec<Write> {
    let (before, old, after) = around(control, target);
    let shift = missing(control, (&before, &old, &after), measured);
    if target.store == Store::System || control.bit("_CHBIT[21]") || control.number("MD18600") == 0.0 {
        return coarse(target, &old, shift);
    }
    let fine = std::array::from_fn(|axis| old.fine[axis] + shift[axis]);
    part(target, &AXES, "FI", fine, old.fine)
}

/// What has to be added to the translation of a frame, so that the point gets its set coordinates.
fn missing(control: &Control, (before, frame, after): (&[Frame], &Frame, &[Frame]), measured: &Measured) -> [f64; 3] {
    let machine = control.to_machine(Wcs(measured.actual));
    let seen = before.iter().chain([frame]).chain(after).fold(machine.0, |point, frame| frame.inward(point));
    let wrong = std::array::from_fn(|axis| if measured.axes[axis] { seen[axis] - measured.set[axis] } else { 0.0 });
    let turned = after.iter().rev().fold(wrong, |direction, frame| frame.turn(direction));
    frame.turn(turned)
}

/// Frames in effect outside of the target (outermost first), which stay (B:1967), it as stored, frames inside of it.
fn around(control: &Control, target: &Target) -> (Vec<Frame>, Frame, Vec<Frame>) {
    let mut before = vec![control.part_frame];
    let mut after = Vec::new();
    let settable = match target.store {
        Store::Settable(_) => None,
        _ if target.without_settable => Some((Store::Settable(0), control.stored_frame(Store::Settable(0)))),
        _ => Some((Store::Settable(control.settable), control.active)),
    };
    let others = control.basic_in_effect().map(|(store, frame)| (store, *frame)).chain(settable);
    for (store, frame) in others.filter(|(store, _)| *store != target.store) {
        if store < target.store {
            before.push(frame);
        } else {
            after.push(frame);
        }
    }
    after.extend([control.plane_frame, control.program_frame]);
    (before, control.stored_frame(target.store), after)
}

/// Into the coarse part, the fine part included and erased (B:1990-2003).
fn coarse(target: &Target, old: &Frame, shift: [f64; 3]) -> Vec<Write> {
    let whole = std::array::from_fn(|axis| old.coarse[axis] + old.fine[axis] + shift[axis]);
    let mut writes = part(target, &AXES, "TR", whole, old.coarse);
    writes.extend(part(target, &AXES, "FI", [0.0; 3], old.fine));
    writes
}

/// What of a part of the frame (`TR`, `FI`, `RT`) is different from before, axis by axis.
fn part(target: &Target, axes: &[&str; 3], part: &str, values: [f64; 3], before: [f64; 3]) -> Vec<Write> {
    let stem = stem(target.store);
    let changed = (0..3).filter(|axis| (values[*axis] - before[*axis]).abs() >= SAME);
    changed.map(|axis| Write { name: format!("{stem}{},{part}]", axes[axis]), value: values[axis] }).collect()
}

/// Name of the frame's variable as far as its axis.
fn stem(store: Store) -> String {
    match store {
        Store::Settable(number) => format!("$P_UIFR[{number},"),
        Store::ChannelBasic(index) => format!("$P_CHBFR[{index},"),
        Store::GlobalBasic(index) => format!("$P_NCBFR[{index},"),
        Store::System => "$P_SETFR[".to_string(),
    }
}
