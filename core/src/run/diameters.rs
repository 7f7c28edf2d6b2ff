//! How a program writes positions of the transverse axis X: for the whole channel (`DIAMON`), for the axis by itself
//! (`DIAMONA[X]`), in one block (`X=DAC(20)`). 840D sl, Programming Manual Fundamentals, "Channel-specific" and
//! "Axis-specific diameter/radius programming".

use super::{Address, Interpreter, indexed, noted};
use crate::control::Transverse;
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::program::words::of_axis;
use crate::syntax::tree::ExprId;

/// With what all words of diameters begin.
pub const BEGIN: &str = "DIAM";
/// Functions of group 29, in its order.
const FUNCTIONS: [&str; 4] = ["DIAMOF", "DIAMON", "DIAM90", "DIAMCYCOF"];
/// The transverse axis of the simulated machines.
const AXIS: &str = "X";

/// What a function of the channel says: it counts for X while that has none of its own.
pub fn of_channel(run: &mut Interpreter, transverse: Transverse) {
    run.modal.diameters.cycles = false;
    run.unread.retain(|name, _| !FUNCTIONS.contains(&name.as_str()));
    match &mut run.modal.diameters.channel {
        Some(channel) => *channel = transverse,
        None => run.sim.control.transverse = transverse,
    }
}

/// `DIAMCYCOF`: radii from now on, until another function of the group.
pub fn of_cycles(run: &mut Interpreter) {
    of_channel(run, Transverse::Radius);
    run.modal.diameters.cycles = true;
}

/// `DIAMCHAN`: X is written as the channel says; where that says diameters, so may other axes be, which only the
/// machine knows.
pub fn as_channel(run: &mut Interpreter) {
    follow(run);
    if run.sim.control.transverse == Transverse::Radius {
        run.unread.retain(|name, _| !name.starts_with(BEGIN) || !name.contains('['));
    }
}

fn follow(run: &mut Interpreter) {
    run.unread.retain(|name, _| of_axis(name).is_none());
    if let Some(channel) = run.modal.diameters.channel.take() {
        run.sim.control.transverse = channel;
    }
}

/// `DIAMONA[X]` and its like; false: another word. Whether another axis is a transverse one, only the machine knows:
/// from diameters of it on nobody knows where it stands.
pub fn take(run: &mut Interpreter, name: &str, args: &[ExprId], span: Span) -> Result<bool, Problem> {
    let Some(own) = of_axis(name) else { return Ok(false) };
    let [axis] = args else { return Err(Problem::new("run-function", span, name)) };
    let axis = indexed::axis_name(run, *axis)?;
    if axis == AXIS {
        match own {
            Some(own) => of_itself(run, own),
            None => follow(run),
        }
        return Ok(true);
    }
    let others = format!("[{axis}]");
    run.unread.retain(|known, _| !(known.starts_with(BEGIN) && known.ends_with(&others)));
    if own.unwrap_or_else(|| channel(run)) != Transverse::Radius {
        let word = format!("{name}{others}");
        noted::without(run, "run-passed", span, &word);
        if axis.starts_with(['X', 'Y', 'Z']) {
            run.unread.insert(word, span);
        }
    }
    Ok(true)
}

/// X has a mode of its own, whatever the channel has or had.
fn of_itself(run: &mut Interpreter, own: Transverse) {
    run.unread.retain(|name, _| !name.starts_with(BEGIN) || name.contains('['));
    let channel = channel(run);
    run.modal.diameters.channel = Some(channel);
    run.sim.control.transverse = own;
}

fn channel(run: &Interpreter) -> Transverse {
    run.modal.diameters.channel.unwrap_or(run.sim.control.transverse)
}

/// Place of the active function in its group, from 0. DIAMCYCOF is the fourth.
pub fn active(run: &Interpreter) -> usize {
    if run.modal.diameters.cycles { 3 } else { channel(run) as usize }
}

/// The function that `G[29]=number` means.
pub fn function(group: f64, number: f64) -> Option<&'static str> {
    let is = |place: &usize| *place as f64 + 1.0 == number;
    let place = (0..FUNCTIONS.len()).find(is).filter(|_| group == 29.0)?;
    FUNCTIONS.get(place).copied()
}

/// What a dimension says of its block alone: whether absolute, whether by the diameter.
pub fn by_block(mode: &str) -> Option<[bool; 2]> {
    Some(match mode {
        "DAC" => [true, true],
        "DIC" => [false, true],
        "RAC" => [true, false],
        "RIC" => [false, false],
        _ => return None,
    })
}

/// Such a dimension belongs to X; what it says of another address is not known.
pub fn takes(address: &Address, mode: &str) -> Result<(), Problem> {
    let own = address.name == AXIS && address.extension.is_none();
    own.then_some(()).ok_or_else(|| Problem::new("run-not-simulated", address.span, mode))
}
