//! One dimension in one axis, which CYCLE978, CYCLE974 and CYCLE994 find: results, and what they correct (B:6336-6349,
//! B:10461-10505, B:10936-10975).

use super::target::Target;
use super::tolerance::Sizes;
use super::{Next, correct, results, tolerance};
use crate::entry::{Inputs, names};
use crate::evaluate::{mean, tool_offset, zero_offset};
use crate::machine::{Machine, Stop};

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnePoint {
    /// Measuring axis: 0 abscissa, 1 ordinate, 2 applicate.
    pub axis: usize,
    /// Axis in which a zero offset is corrected.
    pub corrected: usize,
    /// Direction of probing, +1 or -1.
    pub direction: f64,
    /// Where the centre of the ball stood in the axes that were not measured, X Y Z of the WCS, mm.
    pub ball: [f64; 3],
    /// As given, mm.
    pub set: f64,
    /// As measured, mm.
    pub actual: f64,
    /// How much both are of a length along the axis: 2 for a diameter.
    pub per: f64,
}

/// Writes the results, decides, corrects.
pub fn finish(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &OnePoint,
    target: &Target,
    repetition: u32,
) -> Result<Next, Stop> {
    match target {
        Target::Tool(target) => by_tool(machine, inputs, found, target.as_ref(), repetition),
        Target::Zero(target) => by_zero(machine, inputs, found, target.as_ref(), repetition),
    }
}

/// Setpoint, actual value and difference, each also in the entry of its axis (B:6336-6349).
fn report(machine: &mut dyn Machine, found: &OnePoint, set: f64) {
    for (first, value) in [(0, set), (4, found.actual), (16, found.actual - set)] {
        results::length(machine, first, value);
        results::length(machine, first + 1 + found.axis, value);
    }
}

/// The position decides over the tool: undivided, of a diameter half (B:6698-6699, B:10743-10745).
fn by_tool(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &OnePoint,
    target: Option<&tool_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    let middle = tolerance::middle(inputs, found.set);
    report(machine, found, middle.setpoint);
    results::length(machine, 8, middle.upper);
    results::length(machine, 12, middle.lower);
    let sizes =
        Sizes { differences: &[found.actual - middle.setpoint], factor: 1.0 / found.per, radius_sign: found.direction };
    tolerance::decide(machine, inputs, &sizes, target, repetition)
}

/// The position, less the empirical value, decides over the zero offset (B:6436-6450, B:10525).
fn by_zero(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &OnePoint,
    target: Option<&zero_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    report(machine, found, found.set);
    tolerance::report_empirical(machine, inputs);
    results::begin_zero(machine, inputs);
    let memories = mean::memories(inputs.integer(names::EVNUM));
    results::integer(machine, 7, memories.empirical);
    let counted = found.actual - tolerance::empirical(machine.control(), inputs);
    let next = tolerance::safe(machine, inputs, &[counted - found.set], repetition)?;
    if let (Next::Done, Some(target)) = (next, target) {
        let axes = machine.control().plane.axes();
        let [own, corrected] = [found.axis, found.corrected].map(|axis| axes[axis.min(2)]);
        let mut place = found.ball;
        place.swap(own, corrected); // as if it had been measured in the axis that is corrected
        let mut measured = zero_offset::Measured::at(place);
        measured.put(corrected, found.set / found.per, counted / found.per);
        correct::zero(machine, target, &measured);
    }
    Ok(next)
}
