//! Differential measurement with a probe that was never calibrated: once with the spindle turned by 180 degree, once as
//! it stood (B:6402-6418, B:7570-7582).

use crate::catalogue::prelude::*;

/// What the two touches tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twice {
    /// Coordinate of the surface, mm.
    pub surface: f64,
    /// Skew of the ball in the measuring axis with the spindle as it stood, mm.
    pub skew: f64,
}

/// Touches twice; the probe counts with plus or minus its radius. Its skew is found on the way and stored, alone and in
/// the trigger value of this direction (A:7281-7291), so that the next measurement with the spindle as it stands finds
/// the same surface. Another axis than those of the plane is refused (61325).
pub fn twice(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, point: &Point) -> Result<Twice, Stop> {
    if point.axis > 1 {
        return Err(alarm(machine, 61325));
    }
    let plain = block.uncalibrated();
    let angle = machine.control().spindle;
    machine.orient((angle + Degrees(180.0)).positive());
    let turned = plain.latch(machine, point)?;
    machine.orient(angle.positive());
    let straight = plain.latch(machine, point)?;
    // The latched position is the surface minus radius and minus the skew, which changes its sign with the spindle.
    let skew = (turned - straight) / 2.0;
    let value = plain.trigger(point.axis, point.direction);
    let axis = block.axes[point.axis];
    let sense = if machine.control().mirrored(axis) { -1.0 } else { 1.0 };
    store(machine, inputs, point, sense, [value - skew, skew]);
    Ok(Twice { surface: (turned + straight) / 2.0 - value, skew })
}

/// Stores skew and trigger value with the skew in it, in directions of the machine; `sense`: -1 where the axis is
/// mirrored.
fn store(machine: &mut dyn Machine, inputs: &Inputs, point: &Point, sense: f64, [value, skew]: [f64; 2]) {
    let probe = inputs.integer(names::PRNUM) % 100 - 1;
    let factor = machine.control().basic_factor();
    let plus = point.direction * sense > 0.0;
    let trigger = 2 * point.axis + if plus { 2 } else { 1 };
    for (element, value) in [(trigger, value), (7 + point.axis, skew)] {
        results::set(machine, &format!("_WP[{probe},{element}]"), sense * value / factor);
    }
}
