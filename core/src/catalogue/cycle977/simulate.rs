//! What CYCLE977 does: the order of probing, the ways between, what follows (B:5773-5809, B:5892-5957).

use super::element::Element;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, calibrated};
use crate::catalogue::sinumerik::{Next, alarm, correct, results, tolerance};
use crate::check::Inputs;
use crate::diagnostic::Code;
use crate::evaluate::{tool_offset, zero_offset};
use crate::run::{Machine, Stop};

/// What was measured, mm. Entries of axes that are not measured keep their set value.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Found {
    size: [f64; 2],
    centre: [f64; 2],
}

/// What is corrected.
enum Target {
    Tool(Option<tool_offset::Target>),
    Zero(Option<zero_offset::Target>),
}

/// Runs the cycle from the present position, which is the set centre.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let element = Element::of(inputs);
    results::begin(machine, inputs, 977);
    results::integer(machine, 3, inputs.variant);
    let block = Block::prepare(machine, inputs)?;
    let paths = element
        .paths(&block)
        .map_err(|number| alarm(machine, number))?;
    if element.axes().iter().any(|axis| !calibrated(&block, *axis)) {
        return Err(alarm(machine, 61341));
    }
    let target = if element.zero {
        Target::Zero(correct::zero_target(machine, inputs)?)
    } else {
        let axis = (!element.round && !element.rectangle).then_some(element.axes()[0]);
        Target::Tool(tolerance::prepare(machine, inputs, axis)?)
    };
    let start = machine.position();
    for repetition in 0.. {
        let found = measure(machine, &block, &element, paths, start)?;
        report(machine, inputs, &element, &block, start, &found);
        let next = match &target {
            Target::Tool(target) => by_tool(
                machine,
                inputs,
                &element,
                &found,
                target.as_ref(),
                repetition,
            )?,
            Target::Zero(target) => by_zero(
                machine,
                inputs,
                &element,
                &block,
                start,
                &found,
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

/// Touches all sides and ends above the measured centre at the height of the start (B:5957).
fn measure(
    machine: &mut dyn Machine,
    block: &Block,
    element: &Element,
    paths: [f64; 2],
    start: [f64; 3],
) -> Result<Found, Stop> {
    let set = [start[block.axes[0]], start[block.axes[1]]];
    let mut found = Found {
        size: element.size,
        centre: set,
    };
    for axis in element.axes().iter().copied() {
        let mut sides = [0.0; 2];
        for (side, coordinate) in [1.0, -1.0].into_iter().zip(&mut sides) {
            let point = Point {
                axis,
                direction: if element.inside { side } else { -side },
                set: set[axis] + side * element.size[axis] / 2.0,
                path: paths[axis],
            };
            *coordinate = touch(machine, block, element, &point, start, found.centre)?;
        }
        let [plus, minus] = sides;
        found.centre[axis] = (plus + minus) / 2.0;
        found.size[axis] = plus - minus;
        above(machine, block, start, found.centre)?;
    }
    if element.round {
        found.size[0] = found.size[1]; // the diameter comes from the ordinate, B:5773
    }
    Ok(found)
}

/// One side: to the start of its measuring block, there down by the infeed, measure, up again. Sideways the ball runs
/// through the centre found so far.
fn touch(
    machine: &mut dyn Machine,
    block: &Block,
    element: &Element,
    point: &Point,
    start: [f64; 3],
    centre: [f64; 2],
) -> Result<f64, Stop> {
    let [_, _, applicate] = block.axes;
    let other = 1 - point.axis;
    let mut beside = start;
    beside[block.axes[other]] = centre[other] - block.skew[other];
    let mut onto = machine.position();
    onto[block.axes[other]] = beside[block.axes[other]];
    block.travel(machine, onto)?;
    beside[block.axes[point.axis]] = block.start(point);
    let shortened = if element.inside {
        block.travel(machine, beside)?;
        false
    } else {
        block.travel_as_far(machine, beside)?
    };
    let beside = machine.position();
    let mut deep = beside;
    deep[applicate] += element.infeed;
    down(machine, block, deep, shortened)?;
    let coordinate = block.measure(machine, point)?;
    block.travel(machine, beside)?;
    Ok(coordinate)
}

/// The infeed. A collision after a way in the plane that a software limit switch shortened is 61402 (A:15921).
fn down(
    machine: &mut dyn Machine,
    block: &Block,
    deep: [f64; 3],
    shortened: bool,
) -> Result<(), Stop> {
    match block.travel(machine, deep) {
        Err(Stop::Alarm(Code::Alarm(61302))) if shortened => Err(alarm(machine, 61402)),
        outcome => outcome,
    }
}

/// To the centre found so far, at the height of the start.
fn above(
    machine: &mut dyn Machine,
    block: &Block,
    start: [f64; 3],
    centre: [f64; 2],
) -> Result<(), Stop> {
    let mut to = start;
    to[block.axes[0]] = centre[0];
    to[block.axes[1]] = centre[1];
    block.travel(machine, to)
}

/// Setpoints, actual values and differences (B:5675-5685, B:5709-5724).
fn report(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    element: &Element,
    block: &Block,
    start: [f64; 3],
    found: &Found,
) {
    let centre = [start[block.axes[0]], start[block.axes[1]]];
    let mut set = Vec::new();
    let mut actual = Vec::new();
    for (index, axis) in element.sizes().iter().copied().enumerate() {
        if element.zero {
            set.push(element.size[axis]);
        } else {
            let middle = tolerance::middle(inputs, element.size[axis]);
            set.push(middle.setpoint);
            results::length(machine, 8 + index, middle.upper);
            results::length(machine, 12 + index, middle.lower);
        }
        actual.push(found.size[axis]);
    }
    set.extend(centre);
    actual.extend(found.centre);
    for (index, (set, actual)) in set.iter().zip(&actual).enumerate() {
        results::length(machine, index, *set);
        results::length(machine, 4 + index, *actual);
        results::length(machine, 16 + index, actual - set);
    }
}

/// The size decides over the tool (B:6123-6137).
fn by_tool(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    element: &Element,
    found: &Found,
    target: Option<&tool_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    let differences: Vec<f64> = element
        .sizes()
        .iter()
        .map(|axis| found.size[*axis] - tolerance::middle(inputs, element.size[*axis]).setpoint)
        .collect();
    let sizes = tolerance::Sizes {
        differences: &differences,
        factor: 0.5,
        radius_sign: if element.inside { 1.0 } else { -1.0 },
    };
    tolerance::decide(machine, inputs, &sizes, target, repetition)
}

/// The centre decides over the zero offset (B:6153-6171).
#[allow(clippy::too_many_arguments)]
fn by_zero(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    element: &Element,
    block: &Block,
    start: [f64; 3],
    found: &Found,
    target: Option<&zero_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    results::integer(machine, 0, inputs.integer("_KNUM"));
    results::integer(machine, 11, 0);
    let mut measured = zero_offset::Measured {
        actual: start,
        set: start,
        axes: [false; 3],
    };
    let mut differences = Vec::new();
    for axis in element.axes().iter().copied() {
        let geometry = block.axes[axis];
        measured.actual[geometry] = found.centre[axis];
        measured.axes[geometry] = true;
        differences.push(found.centre[axis] - start[geometry]);
    }
    let next = tolerance::safe(machine, inputs, &differences, repetition)?;
    if let (Next::Done, Some(target)) = (next, target) {
        correct::zero(machine, target, &measured);
    }
    Ok(next)
}
