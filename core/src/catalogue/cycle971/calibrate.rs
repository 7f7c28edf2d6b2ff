//! Calibrating the tool probe: one side, one side with the middle found before, incrementally, all sides (B:4403-4743).

use super::place::Task;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::Point;
use crate::catalogue::tool_probe::store::Trigger;

/// What was found: trigger points to be stored, and differences that count for the safe area only, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Trigger points.
    pub triggers: Vec<Trigger>,
    /// Differences of the sides that were touched to find the middle.
    pub beside: Vec<f64>,
}

/// One side as `_MA` names it (B:15395-15401).
pub fn one(machine: &mut dyn Machine, task: &Task) -> Result<Found, Stop> {
    let number = task.inputs.integer(names::MA);
    let (axis, offset) = (number % 10, number / 100);
    if axis == 3 {
        let offset = task.offset(machine, usize::from(offset == 2));
        let value = task.touch_above(machine, task.place.middle(), offset)?;
        return Ok(Found { triggers: vec![task.place.sides.found(2, -1.0, value)], beside: Vec::new() });
    }
    let axis = usize::from(axis == 2);
    let direction = task.direction(machine, axis)?;
    let mut found = Found::default();
    let other = match offset {
        0 => task.place.sides.middle(1 - axis),
        _ => middle(machine, task, 1 - axis, &mut found.beside)?,
    };
    let point = task.beside(axis, direction);
    task.enter(machine, &point, other, task.place.low())?;
    found.triggers.push(touch(machine, task, &point)?);
    Ok(found)
}

/// Touches a side from where the tool stands beside it.
fn touch(machine: &mut dyn Machine, task: &Task, point: &Point) -> Result<Trigger, Stop> {
    let value = task.block.latch(machine, point)? + point.direction * task.radius;
    Ok(task.place.sides.found(point.axis, point.direction, value))
}

/// The middle of the probe in an axis: both sides, that of the start first, each time down and up to the height of the
/// start.
fn middle(machine: &mut dyn Machine, task: &Task, axis: usize, differences: &mut Vec<f64>) -> Result<f64, Stop> {
    let height = task.at(machine, 2);
    let first = -task.side(machine, axis);
    let other = task.place.sides.middle(1 - axis);
    let mut sum = 0.0;
    for direction in [first, -first] {
        let point = task.beside(axis, direction);
        task.enter(machine, &point, other, task.place.low())?;
        let touched = task.block.latch(machine, &point)?;
        task.go(machine, &[(2, height)])?;
        differences.push(touched - point.set);
        sum += touched;
    }
    Ok(sum / 2.0)
}

/// From where the tool stands over twice the path, whose sign is the direction; nothing else is travelled (B:4587).
pub fn incremental(machine: &mut dyn Machine, task: &Task) -> Result<Trigger, Stop> {
    let axis = (task.inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let direction = task.inputs.number(names::FA).signum();
    let point = task.block.point(axis, direction, 0.0);
    let touched = task.block.latch_from_here(machine, &point)?;
    let reach = if axis == 2 { 0.0 } else { direction * task.radius };
    Ok(task.place.sides.found(axis, direction, touched + reach))
}

/// All sides that `_TP[k,7]` allows: the upper one over the middle that is believed, the middle in the ordinate, both
/// sides of the abscissa, both of the ordinate, and the upper side again over the middle that was found (B:4686-4743).
pub fn automatic(machine: &mut dyn Machine, task: &Task) -> Result<Found, Stop> {
    let high = task.block.start(&task.above());
    task.go(machine, &[(2, high)])?;
    let offset = task.offset(machine, 0);
    let top = task.touch_above(machine, task.place.middle(), offset)?;
    let mut found_top = task.clone();
    found_top.place.sides = task.place.sides.clone().with_top(top);
    let task = &found_top;
    let high = task.block.start(&task.above());
    task.go(machine, &[(2, high)])?;
    let mut found = Found::default();
    let mut middle = task.place.middle();
    if sides(task, 1).len() == 2 {
        let touched = visit(machine, task, 1, middle[0], high)?;
        middle[1] = between(&touched).unwrap_or(middle[1]);
        let points = sides(task, 1).into_iter().zip(touched);
        let difference = |(point, found): (Point, Trigger)| found.value - task.place.sides.trigger(1, point.direction);
        found.beside.extend(points.map(difference));
    }
    for axis in [0, 1] {
        let touched = visit(machine, task, axis, middle[1 - axis], high)?;
        middle[axis] = between(&touched).unwrap_or(middle[axis]);
        found.triggers.extend(touched);
    }
    let value = task.touch_above(machine, middle, offset)?;
    found.triggers.push(task.place.sides.found(2, -1.0, value));
    Ok(found)
}

/// The middle between two sides; none where only one could be touched.
fn between(touched: &[Trigger]) -> Option<f64> {
    let [plus, minus] = touched else { return None };
    Some((plus.value + minus.value) / 2.0)
}

/// Sides of an axis that may be touched, plus direction first.
fn sides(task: &Task, axis: usize) -> Vec<Point> {
    let allowed = [1.0, -1.0].into_iter().filter(|direction| task.place.allows(axis, *direction));
    allowed.map(|direction| task.beside(axis, direction)).collect()
}

/// The sides of an axis that may be touched: each above the probe to it, down, touch, up again.
fn visit(machine: &mut dyn Machine, task: &Task, axis: usize, other: f64, high: f64) -> Result<Vec<Trigger>, Stop> {
    let mut found = Vec::new();
    for point in sides(task, axis) {
        task.enter(machine, &point, other, task.place.low())?;
        found.push(touch(machine, task, &point)?);
        task.go(machine, &[(2, high)])?;
    }
    Ok(found)
}
