//! Places that the controls tell in different ways: the depth at which a boss or web is touched, and what a corner is
//! to become. Lengths in mm.

use super::twin::part_of;
use crate::catalogue::prelude::*;
use crate::control::Units;

/// Height of the start in the axis of the tool for which a depth is calculated: 20 mm or 0.8 inch. A call of NCT tells
/// the depth as a coordinate, one of SINUMERIK the way there from the start, which neither tells.
pub const START: [f64; 2] = [20.0, 0.8 * 25.4];

/// Height of the start for a system of units, mm.
pub fn start(units: Units) -> f64 {
    START[usize::from(units == Units::Inch)]
}

/// Whether a depth belongs to a task: what is touched from outside.
pub fn has_depth(task: Task) -> bool {
    matches!(task, Task::Boss | Task::Web | Task::Island)
}

/// The coordinate of the tool axis at which a boss, a web or a rectangular spigot is touched.
pub fn depth(inputs: &Inputs, shared: &Shared, control: &Control) -> Option<f64> {
    shared.values.iter().filter(|_| has_depth(shared.task)).find_map(|(name, meaning)| match meaning {
        Meaning::Infeed => Some(start(control.active_units) - inputs.given(*name)?.abs()),
        _ if part_of(*meaning, *name, inputs) == Some(2) => inputs.given(*name),
        _ => None,
    })
}

/// The way from the start down to a depth; none where the start lies below it.
pub fn infeed(depth: f64, units: Units) -> Option<f64> {
    Some(depth - start(units)).filter(|way| *way < 0.0)
}

/// The coordinates that a measured corner gets in the plane.
pub fn corner(inputs: &Inputs, shared: &Shared) -> Option<[f64; 2]> {
    if !matches!(shared.task, Task::InnerCorner | Task::OuterCorner) {
        return None;
    }
    let named = |meaning: Meaning| shared.given(meaning, inputs);
    let [first, second] = [0, 1].map(|part| {
        let found = shared.values.iter().find(|(name, meaning)| in_plane(*meaning, *name, inputs) == Some(part));
        found.map(|(name, _)| inputs.given(*name))
    });
    if let (Some(first), Some(second)) = (first, second) {
        return Some([first?, second?]);
    }
    let abscissa = || Some(-named(Meaning::ZeroAbscissa)?);
    let ordinate = || Some(-named(Meaning::ZeroOrdinate)?);
    match named(Meaning::ZeroAtCorner) {
        Some(2.0) => Some([abscissa()?, 0.0]),
        Some(3.0) => Some([abscissa()?, ordinate()?]),
        Some(4.0) => Some([0.0, ordinate()?]),
        _ => Some([0.0; 2]), // the corner itself is the zero
    }
}

/// What a parameter says of a corner with these coordinates.
pub fn of_corner(meaning: Meaning, name: Name, at: [f64; 2], inputs: &Inputs) -> Option<f64> {
    let itself = at == [0.0; 2];
    match meaning {
        Meaning::CornerInAxis => at.get(in_plane(meaning, name, inputs)?).copied(),
        Meaning::ZeroAtCorner => Some(if itself { 1.0 } else { 3.0 }),
        Meaning::ZeroAbscissa if !itself => Some(-at[0]),
        Meaning::ZeroOrdinate if !itself => Some(-at[1]),
        _ => None,
    }
}

/// Part of the plane of the axis whose address is a coordinate of a corner.
fn in_plane(meaning: Meaning, name: Name, inputs: &Inputs) -> Option<usize> {
    part_of(meaning, name, inputs).filter(|part| meaning == Meaning::CornerInAxis && *part < 2)
}
