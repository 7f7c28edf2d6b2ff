//! What CYCLE994 does: the positive point, the way across, the negative point (B:10885-10891, B:11104-11142).

use super::params;
use super::params::INSIDE_ZONE;
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::catalogue::sinumerik::one_point::OnePoint;
use crate::catalogue::sinumerik::target::Target;

/// The border on which the ball's centre passes from one side to the other (B:10891, B:10986-11001).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone {
    /// Geometry axis that is measured, and the one in which the zone is left.
    pub axes: [usize; 2],
    /// Distance from the zero point in both, mm.
    pub border: [f64; 2],
}

impl Zone {
    /// The zone of a call: `_SZA` in the abscissa, `_SZO` in the ordinate or, where it is measured, in the applicate.
    pub fn of(control: &Control, inputs: &Inputs, axis: usize) -> Zone {
        let [one, other] = params::zone(axis == 0);
        let axes = [axis, usize::from(axis == 0)];
        let size = |name, axis| inputs.number(name).abs() / measure::per_axis(control, inputs, axis);
        Zone { axes: axes.map(|axis| control.plane.axes()[axis]), border: [size(one, axes[0]), size(other, axes[1])] }
    }
}

/// Runs the cycle from the present position, which is opposite the positive point.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    measure::begin(machine, inputs, 994);
    let block = Block::prepare(machine, inputs)?;
    let axis = axis(machine, inputs, 1..=3)?;
    let block = if machine.control().bit("_CHBIT[7]") { block.by_ball() } else { block };
    let corrected = measure::corrected(inputs, axis);
    let target = Target::of(machine, inputs, Some(corrected))?;
    let per = measure::per(machine.control(), inputs);
    let set = inputs.number(names::SETVAL);
    let inside = machine.position()[block.axes[axis]].abs() < set / per;
    let zone = zone(machine, inputs, &block, axis, inside)?;
    let point = |side: f64| block.point(axis, if inside { side } else { -side }, side * set / per);
    until_done(|repetition| {
        if repetition > 0 {
            across(machine, &block, zone.as_ref())?;
        }
        let plus = block.measure(machine, &point(1.0))?;
        across(machine, &block, zone.as_ref())?;
        let minus = block.measure(machine, &point(-1.0))?;
        let (direction, ball) = (point(1.0).direction, block.ball_at(machine.position().0));
        let actual = (plus - minus) / 2.0 * per;
        let found = OnePoint { axis, corrected, direction, ball, set, actual, per };
        target.finish(machine, inputs, &found, repetition)
    })
}

/// The zone with the sign of the start: outside always, inside with the first variant, which knows no outside (61307).
/// One that leaves no way for the ball is 61334.
fn zone(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    block: &Block,
    axis: usize,
    inside: bool,
) -> Result<Option<Zone>, Stop> {
    match (INSIDE_ZONE.holds(inputs), inside) {
        (true, false) => return Err(alarm(machine, 61307)),
        (false, true) => return Ok(None),
        _ => {}
    }
    let mut zone = Zone::of(machine.control(), inputs, axis);
    let surface = inputs.number(names::SETVAL) / measure::per(machine.control(), inputs);
    let free = if inside { zone.border[0] <= surface - block.radius } else { zone.border[0] >= surface + block.radius };
    if !free {
        return Err(alarm(machine, 61334));
    }
    zone.border[1] = zone.border[1].copysign(machine.position()[zone.axes[1]]);
    Ok(Some(zone))
}

/// To the other side on the border of the zone (B:11124-11130); without one the measuring block leads there straight
/// (B:11138-11142).
fn across(machine: &mut dyn Machine, block: &Block, zone: Option<&Zone>) -> Result<(), Stop> {
    let Some(Zone { axes, border }) = zone else { return Ok(()) };
    let mut to = machine.position();
    let [measured, left] = *axes;
    let before = to[left];
    let from = border[0].copysign(to[measured]);
    for (axis, value) in [(measured, from), (left, border[1]), (measured, -from), (left, before)] {
        to[axis] = value;
        block.travel(machine, to)?;
    }
    Ok(())
}
