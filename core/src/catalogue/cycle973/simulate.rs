//! What CYCLE973 does: on a surface of the workpiece system, or in a reference groove of the machine (B:10128-10407).

use super::groove::{Groove, Place};
use super::params::{BALL, GROOVE, SKEW, TWO};
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::calibration::{Calibration, Trigger, store};

/// Runs the cycle from the present position: above the groove, or opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 973);
    results::integer(machine, 3, inputs.variant);
    results::length(machine, 27, inputs.number(names::TZL));
    let block = Block::prepare(machine, inputs)?.uncalibrated();
    let find = if GROOVE.holds(inputs) { groove } else { surface };
    // what is in `_KB` are machine coordinates
    carry_out(machine, !GROOVE.holds(inputs), |machine, repetition| {
        let found = find(machine, inputs, &block)?;
        store(machine, inputs, &found, repetition)
    })
}

/// One direction of one axis; only the measuring axis moves (B:10331-10405).
fn surface(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<Calibration, Stop> {
    let (axis, direction) = (axis(machine, inputs, 1..=3)?, direction(machine, inputs)?);
    let set = inputs.number(names::SETVAL) / measure::per(machine.control(), inputs);
    let triggers = vec![touch(machine, block, &block.point(axis, direction, set))?];
    Ok(Calibration { triggers, ..Calibration::default() })
}

fn touch(machine: &mut dyn Machine, block: &Block, point: &Point) -> Result<Trigger, Stop> {
    Ok(Trigger { axis: point.axis, sign: point.direction, value: block.latch(machine, point)? - point.set })
}

/// One or both directions of an axis in the groove, plus before minus (B:10205-10260).
fn groove(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<Calibration, Stop> {
    let tip = machine.control().active_edge().map_or(0, |edge| edge.tip);
    let Some(groove) = Groove::of(tip) else { return Err(alarm(machine, 61315)) };
    let pair = inputs.integer(names::CALNUM);
    if pair < 1 || pair as f64 > machine.control().number("_CVAL[2]") {
        return Err(alarm(machine, 61333));
    }
    let axis = axis(machine, inputs, 1..=2)?;
    let place = groove.place(machine.control(), pair - 1);
    let directions = if TWO.holds(inputs) { vec![1.0, -1.0] } else { vec![direction(machine, inputs)?] };
    if axis == groove.axes[1] && directions != [-1.0] {
        return Err(alarm(machine, 61326)); // of its base a groove shows one side only
    }
    enter(machine, block, &place, axis)?;
    let mut found = Calibration::default();
    for direction in directions {
        found.triggers.push(touch(machine, block, &point(block, &place, axis, direction))?);
    }
    if let [plus, minus] = found.triggers[..] {
        found.ball = BALL.holds(inputs).then_some(minus.value - plus.value);
        // the ball stands beside where it is believed by what both trigger values share
        found.skew[axis] = SKEW.holds(inputs).then_some(-(minus.value + plus.value) / 2.0);
    }
    Ok(found)
}

/// The wall or the base that is touched in a direction of an axis.
fn point(block: &Block, place: &Place, axis: usize, direction: f64) -> Point {
    if axis == place.axes[1] {
        return block.point(axis, direction, place.base);
    }
    let set = place.walls[usize::from(direction < 0.0)];
    Point { axis, direction, set, path: place.path(block.radius, block.path) }
}

/// Paraxially to the middle between the walls, then to the height at which a wall is touched; to the base the measuring
/// block leads.
fn enter(machine: &mut dyn Machine, block: &Block, place: &Place, axis: usize) -> Result<(), Stop> {
    let [walls, base] = place.axes;
    let mut to = machine.position();
    to[block.axes[walls]] = place.centre();
    block.travel(machine, to)?;
    if axis == walls {
        to[block.axes[base]] = place.height(block.radius, block.path);
        block.travel(machine, to)?;
    }
    Ok(())
}
