//! Calibrating the tool probe: one side, one side with the middle found before, incrementally, all sides (B:4403-4743).

use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::catalogue::tool_probe::store::Trigger;

/// What was found: trigger points to be stored, and differences that count for the safe area only, mm.
#[derive(Default)]
pub struct Found {
    /// Trigger points.
    pub triggers: Vec<Trigger>,
    /// Differences of the sides that were touched to find the middle.
    pub beside: Vec<f64>,
}

/// One side as `_MA` names it (B:15395-15401).
pub fn one(machine: &mut dyn Machine, stand: &Stand) -> Result<Found, Stop> {
    let number = stand.inputs.integer(names::MA);
    let (axis, offset) = (number % 10, number / 100);
    let mut found = Found::default();
    if axis == 3 {
        let value = stand.touch_above(machine, stand.probe.centre(), usize::from(offset == 2))?;
        found.triggers.push(stand.probe.found(2, -1.0, value));
        return Ok(found);
    }
    let axis = usize::from(axis == 2);
    let direction = stand.approach(machine, axis)?;
    let other = match offset {
        0 => stand.probe.middle(1 - axis),
        _ => middle(machine, stand, 1 - axis, &mut found.beside)?,
    };
    found.triggers.push(touch(machine, stand, &stand.beside(axis, direction), other)?);
    Ok(found)
}

/// Goes beside a side, at this place of the other axis, and touches it.
fn touch(machine: &mut dyn Machine, stand: &Stand, point: &Point, other: f64) -> Result<Trigger, Stop> {
    stand.enter(machine, point, other, stand.probe.low())?;
    let value = stand.block.latch(machine, point)? + point.direction * stand.block.radius;
    Ok(stand.probe.found(point.axis, point.direction, value))
}

/// The middle of the probe in an axis: both sides, that of the start first, each time down and up to the height of the
/// start.
fn middle(machine: &mut dyn Machine, stand: &Stand, axis: usize, differences: &mut Vec<f64>) -> Result<f64, Stop> {
    let first = -stand.side(axis);
    let mut sum = 0.0;
    for direction in [first, -first] {
        let point = stand.beside(axis, direction);
        stand.enter(machine, &point, stand.probe.middle(1 - axis), stand.probe.low())?;
        let touched = stand.block.latch(machine, &point)?;
        stand.go(machine, 2, stand.start[2])?;
        differences.push(touched - point.set);
        sum += touched;
    }
    Ok(sum / 2.0)
}

/// From where the tool stands over twice the path, whose sign is the direction; nothing else is travelled (B:4587).
pub fn incremental(machine: &mut dyn Machine, stand: &Stand) -> Result<Trigger, Stop> {
    let axis = (stand.inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let direction = stand.inputs.number(names::FA).signum();
    let touched = stand.block.latch_from_here(machine, &stand.block.point(axis, direction, 0.0))?;
    let reach = if axis == 2 { 0.0 } else { direction * stand.block.radius };
    Ok(stand.probe.found(axis, direction, touched + reach))
}

/// All sides that `_TP[k,7]` allows: the upper one over the middle that is believed, the middle in the ordinate, both
/// sides of the abscissa, both of the ordinate, and the upper side again over the middle that was found (B:4686-4743).
pub fn automatic(machine: &mut dyn Machine, stand: &Stand) -> Result<Found, Stop> {
    let mut middle = stand.probe.centre();
    stand.go(machine, 2, stand.block.start(&stand.above()))?;
    let top = stand.touch_above(machine, middle, 0)?;
    let stand = &Stand { probe: stand.probe.clone().with_top(top), ..stand.clone() };
    let high = stand.block.start(&stand.above());
    stand.go(machine, 2, high)?;
    let mut found = Found::default();
    if stand.probe.allows(1, 1.0) && stand.probe.allows(1, -1.0) {
        let touched = visit(machine, stand, 1, middle[0], high)?;
        middle[1] = between(&touched).unwrap_or(middle[1]);
        let believed = [1.0, -1.0].map(|direction| stand.probe.trigger(1, direction));
        found.beside = touched.iter().zip(believed).map(|(found, believed)| found.value - believed).collect();
    }
    for axis in [0, 1] {
        let touched = visit(machine, stand, axis, middle[1 - axis], high)?;
        middle[axis] = between(&touched).unwrap_or(middle[axis]);
        found.triggers.extend(touched);
    }
    let value = stand.touch_above(machine, middle, 0)?;
    found.triggers.push(stand.probe.found(2, -1.0, value));
    Ok(found)
}

/// The middle between two sides; none where only one could be touched.
fn between(touched: &[Trigger]) -> Option<f64> {
    let [plus, minus] = touched else { return None };
    Some((plus.value + minus.value) / 2.0)
}

/// The sides of an axis that may be touched, plus direction first: each above the probe to it, down, touch, up again.
fn visit(machine: &mut dyn Machine, stand: &Stand, axis: usize, other: f64, high: f64) -> Result<Vec<Trigger>, Stop> {
    let mut found = Vec::new();
    for direction in [1.0, -1.0].into_iter().filter(|direction| stand.probe.allows(axis, *direction)) {
        found.push(touch(machine, stand, &stand.beside(axis, direction), other)?);
        stand.go(machine, 2, high)?;
    }
    Ok(found)
}
