//! What CYCLE973 does: on a surface of the workpiece system, or in a reference groove of the machine (B:10128-10407).

use super::groove::{Groove, Place};
use super::params::{BALL, GROOVE, SKEW, TWO};
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::calibration::{Calibration, Trigger, store};
use crate::catalogue::sinumerik::measuring_block::{Block, Point};
use crate::catalogue::sinumerik::{alarm, results, until_done};

/// Runs the cycle from the present position: above the groove, or opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 973);
    results::integer(machine, 3, inputs.variant);
    results::length(machine, 27, inputs.number(names::TZL));
    let block = Block::prepare(machine, inputs)?.uncalibrated();
    if !GROOVE.holds(inputs) {
        return calibrate(machine, inputs, &block, surface);
    }
    // what stands in `_KB` are machine coordinates
    let frames = machine.control().take_frames();
    let outcome = calibrate(machine, inputs, &block, groove);
    machine.control().put_frames(frames);
    outcome
}

/// What finds the data of the probe.
type Find = fn(&mut dyn Machine, &Inputs, &Block) -> Result<Calibration, Stop>;

fn calibrate(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, find: Find) -> Result<(), Stop> {
    until_done(|repetition| {
        let found = find(machine, inputs, block)?;
        store(machine, inputs, &found, repetition)
    })
}

/// Direction of `_MD`; 61326 where it is none (A:15867).
fn direction(machine: &mut dyn Machine, inputs: &Inputs) -> Result<f64, Stop> {
    match inputs.integer(names::MD) {
        0 => Ok(1.0),
        1 => Ok(-1.0),
        _ => Err(alarm(machine, 61326)),
    }
}

/// One direction of one axis; only the measuring axis moves (B:10331-10405).
fn surface(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<Calibration, Stop> {
    let (axis, direction) = (measure::axis(machine, inputs)?, direction(machine, inputs)?);
    let set = inputs.number(names::SETVAL) / measure::per(machine.control(), inputs);
    Ok(found(vec![touch(machine, block, &block.point(axis, direction, set))?]))
}

fn touch(machine: &mut dyn Machine, block: &Block, point: &Point) -> Result<Trigger, Stop> {
    Ok(Trigger { axis: point.axis, sign: point.direction, value: block.latch(machine, point)? - point.set })
}

/// Trigger values alone.
fn found(triggers: Vec<Trigger>) -> Calibration {
    Calibration { triggers, ball: None, skew: [None; 2], centre: None, length: None }
}

/// One or both directions of an axis in the groove (B:10205-10260).
fn groove(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<Calibration, Stop> {
    let tip = machine.control().active_edge().map_or(0, |edge| edge.tip);
    let Some(groove) = Groove::of(tip) else { return Err(alarm(machine, 61315)) };
    let pair = inputs.integer(names::CALNUM);
    if pair < 1 || pair as f64 > machine.control().number("_CVAL[2]") {
        return Err(alarm(machine, 61333));
    }
    let axis = measure::axis(machine, inputs)?;
    if axis > 1 {
        return Err(alarm(machine, 61325));
    }
    let place = groove.place(machine.control(), pair - 1);
    let points = points(machine, inputs, block, &place, axis)?;
    enter(machine, block, &place, axis)?;
    let triggers = points.iter().map(|point| touch(machine, block, point)).collect::<Result<_, _>>()?;
    let mut found = found(triggers);
    if let [plus, minus] = found.triggers[..] {
        found.ball = BALL.holds(inputs).then_some(minus.value - plus.value);
        // the ball stands beside where it is believed by what both trigger values share
        found.skew[axis] = SKEW.holds(inputs).then_some(-(minus.value + plus.value) / 2.0);
    }
    Ok(found)
}

type Points = Result<Vec<Point>, Stop>;

/// What is touched in order: plus before minus. Of its base a groove shows one side only (61326).
fn points(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, place: &Place, axis: usize) -> Points {
    let directions = if TWO.holds(inputs) { vec![1.0, -1.0] } else { vec![direction(machine, inputs)?] };
    let [walls, base] = place.axes;
    if axis == base {
        if directions != [-1.0] {
            return Err(alarm(machine, 61326));
        }
        return Ok(vec![block.point(axis, -1.0, place.base)]);
    }
    let wall = |direction: f64| Point {
        axis: walls,
        direction,
        set: place.walls[usize::from(direction < 0.0)],
        path: place.path(block.radius, block.path),
    };
    Ok(directions.into_iter().map(wall).collect())
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
