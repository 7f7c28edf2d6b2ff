//! Quantities of a frame and of a cutting edge.

use super::place::{Part, Quantity, axis_and_part};
use crate::control::{Edge, Frame};
use crate::geometry::Degrees;

/// Component of a frame by the names of its axis and its part; none: there is no such component.
pub fn component(frame: &Frame, axis: &str, part: &str) -> Option<f64> {
    let (axis, part) = axis_and_part(axis, part)?;
    Some(part_of(frame, part, axis))
}

/// Writes a component of a frame; false: there is none of this name.
pub fn set_component(frame: &mut Frame, axis: &str, part: &str, value: f64) -> bool {
    let Some((axis, part)) = axis_and_part(axis, part) else { return false };
    set_part(frame, part, axis, value);
    true
}

pub(super) fn part_of(frame: &Frame, part: Part, axis: usize) -> f64 {
    match part {
        Part::Coarse => frame.coarse[axis],
        Part::Fine => frame.fine[axis],
        Part::Rotation => frame.rotation[axis],
        Part::Rotary => frame.rotary[axis].0,
        Part::RotaryFine => frame.rotary_fine[axis].0,
        Part::Scale => frame.scale[axis],
        Part::Mirror => f64::from(u8::from(frame.mirror[axis])),
    }
}

pub(super) fn set_part(frame: &mut Frame, part: Part, axis: usize, value: f64) {
    match part {
        Part::Coarse => frame.coarse[axis] = value,
        Part::Fine => frame.fine[axis] = value,
        Part::Rotation => frame.rotation[axis] = value,
        Part::Rotary => frame.rotary[axis] = Degrees(value),
        Part::RotaryFine => frame.rotary_fine[axis] = Degrees(value),
        Part::Scale => frame.scale[axis] = value,
        Part::Mirror => frame.mirror[axis] = value != 0.0,
    }
}

pub(super) fn edge_quantity(edge: &Edge, quantity: Quantity) -> f64 {
    match quantity {
        Quantity::Kind => edge.kind as f64,
        Quantity::Tip => edge.tip as f64,
        Quantity::Geometry(3) => edge.radius,
        Quantity::Geometry(i) => edge.length[i],
        Quantity::Wear(3) => edge.radius_wear,
        Quantity::Wear(i) => edge.length_wear[i],
        Quantity::Additive(dl, i) => edge.additive.get(&dl).map_or(0.0, |offset| offset[i]),
        Quantity::Setup(dl, i) => edge.setup.get(&dl).map_or(0.0, |offset| offset[i]),
        Quantity::Further(n) => edge.further.get(&n).copied().unwrap_or(0.0),
    }
}

pub(super) fn set_edge_quantity(edge: &mut Edge, quantity: Quantity, value: f64) {
    match quantity {
        Quantity::Kind => edge.kind = value as i64,
        Quantity::Tip => edge.tip = value as i64,
        Quantity::Geometry(3) => edge.radius = value,
        Quantity::Geometry(i) => edge.length[i] = value,
        Quantity::Wear(3) => edge.radius_wear = value,
        Quantity::Wear(i) => edge.length_wear[i] = value,
        Quantity::Additive(dl, i) => edge.additive.entry(dl).or_default()[i] = value,
        Quantity::Setup(dl, i) => edge.setup.entry(dl).or_default()[i] = value,
        Quantity::Further(n) => drop(edge.further.insert(n, value)),
    }
}
