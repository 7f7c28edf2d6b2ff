//! What CYCLE961 does: touch two edges in three or four points, and make their corner the zero of a frame (B:7980-8026,
//! B:8136-8170).

use super::corner::{Corner, corner};
use super::lines::Point;
use super::params::{OUTSIDE, POINTS, RECTANGLE};
use super::touches::{Touch, touches};
use crate::catalogue::sinumerik::measuring_block::{Block, all_calibrated};
use crate::catalogue::sinumerik::{alarm, correct, results};
use crate::control::Control;
use crate::entry::{Inputs, names};
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::{Measured, Target};
use crate::geometry::{Wcs, rigid};
use crate::machine::{Machine, Stop};

/// Order in which the points are touched: P2, P1, P3, P4 (B:7998, B:8166).
const ORDER: [usize; 4] = [1, 0, 2, 3];

/// Runs the cycle from the present position, which is opposite the corner, or above it at positioning height.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 961);
    results::integer(machine, 3, inputs.variant);
    let block = Block::prepare(machine, inputs)?;
    let start = machine.position();
    let [abscissa, ordinate, _] = block.axes;
    let here = [start[abscissa], start[ordinate]];
    let touches = touches(inputs, machine.control(), here);
    let sides = touches.iter().map(|touch| (touch.axis, touch.direction));
    all_calibrated(machine, &block, &sides.collect::<Vec<_>>())?;
    let target = correct::zero_target(machine, inputs)?;
    let centres = measure(machine, inputs, &block, &touches, start.0)?;
    let found = corner(&touches, &centres, radius(&block));
    let corner = found.map_err(|number| alarm(machine, number))?;
    let height = height(inputs, &block, start.0);
    report(machine, &corner, height);
    if let Some(target) = target {
        write(machine, inputs, &target, &corner, height);
    }
    Ok(())
}

/// A place at the height of the ball's centre while it touched: with places that of the start and the infeed below it.
fn height(inputs: &Inputs, block: &Block, start: [f64; 3]) -> [f64; 3] {
    let ball = block.ball_at(start);
    match POINTS.holds(inputs) {
        true => raised(block, ball, inputs.number(names::ID)),
        false => ball,
    }
}

/// Radius of the active ball, mm; where it was never determined that of the tool.
fn radius(block: &Block) -> f64 {
    if block.ball > 0.0 { block.ball } else { block.radius }
}

/// Touches all points; the centres of the ball at switching, P1 first. Ends at the start, or above P4 (B:8016, B:8170).
fn measure(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    block: &Block,
    touches: &[Touch],
    start: [f64; 3],
) -> Result<Vec<Point>, Stop> {
    let mut centres = vec![[0.0; 2]; touches.len()];
    let by_points = POINTS.holds(inputs);
    for index in ORDER.into_iter().filter(|index| *index < touches.len()) {
        let touch = &touches[index];
        if index == 2 && !by_points {
            pass(machine, inputs, block, touch, start)?;
        }
        let over = place(block, touch.at, start);
        block.travel(machine, Wcs(over))?;
        if by_points {
            block.travel(machine, Wcs(raised(block, over, inputs.number(names::ID))))?;
        }
        centres[index] = ball(machine, block, touch)?;
        if by_points {
            block.travel(machine, Wcs(over))?;
        }
    }
    if !by_points {
        block.travel(machine, Wcs(start))?;
    }
    Ok(centres)
}

/// From P1 to P3 past an outside corner: over it by `_ID`, or around it through the start (B:8002-8012). Inside the way
/// is free.
fn pass(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, next: &Touch, start: [f64; 3]) -> Result<(), Stop> {
    if !OUTSIDE.holds(inputs) {
        return Ok(());
    }
    let lift = inputs.number(names::ID);
    if lift == 0.0 {
        return block.travel(machine, Wcs(start));
    }
    let here = machine.position();
    block.travel(machine, Wcs(raised(block, here.0, lift)))?;
    let over = raised(block, place(block, next.at, start), lift);
    block.travel(machine, Wcs(over))
}

/// A place in the plane at the height of the start, X Y Z.
fn place(block: &Block, at: Point, start: [f64; 3]) -> [f64; 3] {
    let mut place = start;
    (place[block.axes[0]], place[block.axes[1]]) = (at[0], at[1]);
    place
}

fn raised(block: &Block, from: [f64; 3], lift: f64) -> [f64; 3] {
    let mut to = from;
    to[block.axes[2]] += lift;
    to
}

/// Touches an edge from here; where the centre of the ball stood. Along the measuring axis it follows from the trigger
/// value, which holds the skew, across from the skew.
fn ball(machine: &mut dyn Machine, block: &Block, touch: &Touch) -> Result<Point, Stop> {
    let Touch { axis, direction, path, .. } = *touch;
    let surface = block.measure_from_here(machine, axis, direction, 2.0 * path)?;
    let other = 1 - axis;
    let mut centre = [0.0; 2];
    centre[axis] = surface - direction * radius(block);
    centre[other] = touch.at[other] + block.skew[other];
    Ok(centre)
}

/// Edge and corner in the WCS, then in the machine (B:16033-16057).
fn report(machine: &mut dyn Machine, corner: &Corner, height: [f64; 3]) {
    let control = machine.control();
    let axes = control.plane.axes();
    let edge = vector(control, corner.edge);
    let point = point(control, corner.point, height);
    let machine_edge = control.direction_to_machine(edge);
    let machine_point = control.to_machine(Wcs(point));
    for (first, edge, point) in [(4, edge, point), (20, machine_edge, machine_point.0)] {
        let angle = edge[axes[1]].atan2(edge[axes[0]]).to_degrees();
        results::angle(machine, first, angle);
        results::length(machine, first + 1, point[axes[0]]);
        results::length(machine, first + 2, point[axes[1]]);
    }
}

/// Abscissa along the reference edge, corner or a point beside it as zero; the applicate stays (B:7840-7844).
fn write(machine: &mut dyn Machine, inputs: &Inputs, target: &Target, corner: &Corner, height: [f64; 3]) {
    let control = machine.control();
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let edge = zero_offset::seen(control, target, vector(control, corner.edge));
    let mut turn = [0.0; 3];
    turn[applicate] = edge[ordinate].atan2(edge[abscissa]).to_degrees();
    let rotation = zero_offset::rotation(control, target, &rigid::rotation(turn));
    let [x, y] = beside(inputs);
    let mut measured = Measured { actual: point(control, corner.point, height), set: height, axes: [true; 3] };
    (measured.set[abscissa], measured.set[ordinate]) = (-x, -y);
    measured.axes[applicate] = false;
    let writes = zero_offset::placed(control, target, rotation, &measured);
    correct::apply(machine, target, &writes); // no result tells so (B:7877-7888)
}

/// Where the zero lies from the corner, in the turned system (B:7929-7935, B:8018-8026).
fn beside(inputs: &Inputs) -> Point {
    if !RECTANGLE.holds(inputs) {
        return [0.0; 2];
    }
    let [x, y] = [names::SETV2, names::SETV3].map(|name| inputs.or_zero(name));
    match inputs.integer(names::SETV4) {
        2 => [x, 0.0],
        3 => [x, y],
        4 => [0.0, y],
        _ => [0.0; 2],
    }
}

/// Abscissa and ordinate of a direction as X Y Z.
fn vector(control: &Control, direction: Point) -> [f64; 3] {
    point(control, direction, [0.0; 3])
}

/// Abscissa and ordinate of a point as X Y Z, at this height.
fn point(control: &Control, at: Point, height: [f64; 3]) -> [f64; 3] {
    let [abscissa, ordinate, _] = control.plane.axes();
    let mut point = height;
    (point[abscissa], point[ordinate]) = (at[0], at[1]);
    point
}
