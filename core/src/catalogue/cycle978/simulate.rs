//! What CYCLE978 does: one point of a surface, plain or differential (B:6376-6418).

use crate::catalogue::sinumerik::differential::twice;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, calibrated, turnable};
use crate::catalogue::sinumerik::target::Target;
use crate::catalogue::sinumerik::{Next, alarm, correct, results, tolerance};
use crate::check::Inputs;
use crate::evaluate::{mean, tool_offset, zero_offset};
use crate::run::{Machine, Stop};

/// Runs the cycle from the present position, which is opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 978);
    let block = Block::prepare(machine, inputs)?;
    let axis = match inputs.integer("_MA") {
        axis @ 1..=3 => axis as usize - 1,
        _ => return Err(alarm(machine, 61325)),
    };
    let differential = inputs.variant / 1000 % 10 == 1;
    if differential {
        turnable(machine)?;
    }
    if !differential && !calibrated(&block, axis) {
        return Err(alarm(machine, 61341));
    }
    let target = Target::of(machine, inputs, Some(axis))?;
    let start = machine.position();
    let set = inputs.number("_SETVAL");
    let direction = if set < start[block.axes[axis]] {
        -1.0
    } else {
        1.0
    };
    let point = Point {
        axis,
        direction,
        set,
        path: block.path,
    };
    for repetition in 0.. {
        let actual = match differential {
            true => twice(machine, inputs, &block, &point)?.surface,
            false => block.measure(machine, &point)?,
        };
        let next = match &target {
            Target::Tool(target) => {
                by_tool(machine, inputs, &point, actual, target.as_ref(), repetition)?
            }
            Target::Zero(target) => by_zero(
                machine,
                inputs,
                &block,
                &point,
                actual,
                target.as_ref(),
                repetition,
            )?,
        };
        if next == Next::Done {
            break;
        }
    }
    Ok(())
}

/// Setpoint, actual value and difference, each also in the entry of its axis (B:6336-6349).
fn report(machine: &mut dyn Machine, point: &Point, set: f64, actual: f64) {
    for (first, value) in [(0, set), (4, actual), (16, actual - set)] {
        results::length(machine, first, value);
        results::length(machine, first + 1 + point.axis, value);
    }
}

/// The position decides over the tool, undivided (B:6698-6699).
fn by_tool(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    point: &Point,
    actual: f64,
    target: Option<&tool_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    let middle = tolerance::middle(inputs, point.set);
    report(machine, point, middle.setpoint, actual);
    results::length(machine, 8, middle.upper);
    results::length(machine, 12, middle.lower);
    let sizes = tolerance::Sizes {
        differences: &[actual - middle.setpoint],
        factor: 1.0,
        radius_sign: point.direction,
    };
    tolerance::decide(machine, inputs, &sizes, target, repetition)
}

/// The position, less the empirical value, decides over the zero offset (B:6436-6450).
fn by_zero(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    block: &Block,
    point: &Point,
    actual: f64,
    target: Option<&zero_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    report(machine, point, point.set, actual);
    tolerance::report_empirical(machine, inputs);
    results::begin_zero(machine, inputs);
    results::integer(
        machine,
        7,
        mean::memories(inputs.integer("_EVNUM")).empirical,
    );
    let counted = actual - tolerance::empirical(machine.control(), inputs);
    let next = tolerance::safe(machine, inputs, &[counted - point.set], repetition)?;
    if let (Next::Done, Some(target)) = (next, target) {
        let geometry = block.axes[point.axis];
        let here = machine.position();
        let mut measured = zero_offset::Measured {
            actual: here,
            set: here,
            axes: [false; 3],
        };
        measured.actual[geometry] = counted;
        measured.set[geometry] = point.set;
        measured.axes[geometry] = true;
        correct::zero(machine, target, &measured);
    }
    Ok(next)
}
