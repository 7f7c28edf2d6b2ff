//! Blocks whose axes do not move as they are written: between `TRANSMIT` or `TRACYL` and `TRAFOOF`, or behind a frame
//! that is not simulated, they are those of another coordinate system; between `CONTPRON`, `NPROTDEF` and the like and
//! `EXECUTE` they describe a contour only.

use super::{Address, Call, Interpreter, Words, noted, unread};
use crate::geometry::Degrees;
use crate::program::of_control::is_frame;

/// What the axis words of a program are at present.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axes {
    /// Targets of motions.
    #[default]
    Move,
    /// Of polar or cylindrical coordinates, up to TRAFOOF.
    Transformed,
    /// Of other axes of the machine, up to GEOAX().
    Exchanged,
    /// Of axes whose position was said anew.
    Preset,
    /// Of a frame that is not simulated, up to the next one that replaces it.
    Framed,
    /// Of a plane that is not simulated, up to the next CYCLE800.
    Swivelled,
    /// A description, up to EXECUTE.
    Describe,
}

/// Takes the words of a block that begin or end such a part, before its motion.
pub fn apply(run: &mut Interpreter, found: &mut Words) {
    for at in 0..found.calls.len() {
        let Some(axes) = found.calls.get(at).and_then(|call| begun(run, found, call)) else { continue };
        let before = std::mem::replace(&mut run.modal.axes, axes);
        if let (false, Some(call)) = (matches!(axes, Axes::Move | Axes::Describe), found.calls.get(at)) {
            noted::without(run, "run-transformed", call.span, &call.name);
        }
        // no turning machine has an axis that stays behind where the part was milled
        if before == Axes::Transformed && axes == Axes::Move && run.sim.control.turns() {
            run.unread.remove("Y");
        }
    }
    if run.modal.axes != Axes::Move {
        found.path.stays = true;
        found.positioning.clear();
    }
    if !matches!(run.modal.axes, Axes::Move | Axes::Describe) {
        unread::leave_axes(run, found);
    }
}

fn is_axis(address: &Address) -> bool {
    ["X", "Y", "Z"].contains(&address.name.as_str())
}

/// What stands between the brackets of a call.
fn arguments(run: &Interpreter, call: &Call) -> String {
    let text = run.program.name(call.span);
    text.split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(')').trim()).to_owned()
}

/// What the axes are from a call on; none: it changes nothing.
fn begun(run: &Interpreter, found: &Words, call: &Call) -> Option<Axes> {
    let now = run.modal.axes;
    let ends = |axes: Axes| (now == axes).then_some(Axes::Move);
    match call.name.as_str() {
        "TRANSMIT" | "TRACYL" | "TRACON" => Some(Axes::Transformed),
        "TRAFOOF" | "TRAANG" | "TRAORI" => ends(Axes::Transformed),
        "GEOAX" if arguments(run, call).is_empty() => ends(Axes::Exchanged),
        "GEOAX" => Some(Axes::Exchanged),
        "PRESETON" | "PRESETONS" => {
            let own = |name: &str| ["X", "Y", "Z"].contains(&name.trim());
            arguments(run, call).split(',').any(own).then_some(Axes::Preset)
        }
        "ROTS" | "AROTS" if found.addresses.iter().any(is_axis) => Some(Axes::Framed),
        "TOFRAME" | "TOROT" | "PAROT" if run.sim.control.rotary != [Degrees(0.0); 3] => Some(Axes::Framed),
        "ROTS" | "TOROTOF" | "PAROTOF" => ends(Axes::Framed),
        name if is_frame(name) && !name.starts_with('A') => ends(Axes::Framed),
        "CONTPRON" | "CONTDCON" | "NPROTDEF" | "CPROTDEF" if now == Axes::Move => Some(Axes::Describe),
        "EXECUTE" => ends(Axes::Describe),
        _ => None,
    }
}
