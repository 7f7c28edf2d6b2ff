//! Sizes and a centre, which CYCLE977 and CYCLE979 find: results, and what they correct (B:5675-5724, B:6779-6814).

use super::target::Target;
use super::tolerance::Sizes;
use super::{Next, correct, results, tolerance};
use crate::entry::Inputs;
use crate::evaluate::{tool_offset, zero_offset};
use crate::machine::{Machine, Stop};

/// A value as it should be and as it was measured, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// As given.
    pub set: f64,
    /// As measured.
    pub actual: f64,
}

/// What was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Diameter or width, or both lengths of a rectangle.
    pub sizes: Vec<Pair>,
    /// Centre in abscissa and ordinate. Where an axis is not measured, both values are the same.
    pub centre: [Pair; 2],
    /// Applicate of the ball's centre while measuring, mm: at this height lies the centre that was found.
    pub height: f64,
    /// Axes in which the centre was measured: 0 abscissa, 1 ordinate.
    pub axes: &'static [usize],
    /// Hole, groove or inside rectangle.
    pub inside: bool,
}

/// Writes the results, decides, corrects. The probe stands where the measurement ends.
pub fn finish(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &Found,
    target: &Target,
    repetition: u32,
) -> Result<Next, Stop> {
    match target {
        Target::Tool(target) => by_tool(machine, inputs, found, target.as_ref(), repetition),
        Target::Zero(target) => by_zero(machine, inputs, found, target.as_ref(), repetition),
    }
}

/// Setpoints, actual values and differences: first the sizes, then the centre.
fn report(machine: &mut dyn Machine, sizes: &[Pair], centre: &[Pair]) {
    for (index, Pair { set, actual }) in sizes.iter().chain(centre).enumerate() {
        results::length(machine, index, *set);
        results::length(machine, 4 + index, *actual);
        results::length(machine, 16 + index, actual - set);
    }
}

/// The size decides over the tool (B:6123-6137, B:7105-7117).
fn by_tool(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &Found,
    target: Option<&tool_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    let mut sizes = found.sizes.clone();
    for (index, size) in sizes.iter_mut().enumerate() {
        let middle = tolerance::middle(inputs, size.set);
        size.set = middle.setpoint;
        results::length(machine, 8 + index, middle.upper);
        results::length(machine, 12 + index, middle.lower);
    }
    report(machine, &sizes, &found.centre);
    let differences: Vec<f64> = sizes.iter().map(|size| size.actual - size.set).collect();
    let sizes = Sizes { differences: &differences, factor: 0.5, radius_sign: if found.inside { 1.0 } else { -1.0 } };
    tolerance::decide(machine, inputs, &sizes, target, repetition)
}

/// The centre decides over the zero offset (B:6153-6171, B:7133-7149).
fn by_zero(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &Found,
    target: Option<&zero_offset::Target>,
    repetition: u32,
) -> Result<Next, Stop> {
    report(machine, &found.sizes, &found.centre);
    results::begin_zero(machine, inputs);
    let axes = machine.control().plane.axes();
    let mut place = [0.0; 3];
    let [abscissa, ordinate] = found.centre.map(|pair| pair.actual);
    for (axis, value) in axes.into_iter().zip([abscissa, ordinate, found.height]) {
        place[axis] = value;
    }
    let mut measured = zero_offset::Measured::at(place);
    let mut differences = Vec::new();
    for axis in found.axes.iter().copied() {
        let Pair { set, actual } = found.centre[axis];
        measured.put(axes[axis], set, actual);
        differences.push(actual - set);
    }
    let next = tolerance::safe(machine, inputs, &differences, repetition)?;
    if let (Next::Done, Some(target)) = (next, target) {
        correct::zero(machine, target, &measured);
    }
    Ok(next)
}
