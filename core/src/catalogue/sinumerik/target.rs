//! What a measurement corrects: a tool or a zero offset, as the hundreds of `_MVAR` say.

use super::tolerance::Sizes;
use super::{correct, tolerance};
use crate::catalogue::prelude::*;
use crate::evaluate::zero_offset::Measured;
use crate::evaluate::{tool_offset, zero_offset};

/// What is corrected; none of it where `_KNUM` is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A tool.
    Tool(Option<tool_offset::Target>),
    /// A zero offset.
    Zero(Option<zero_offset::Target>),
}

/// What a measurement found, as a tool or as a frame is corrected by it. Both write the results.
pub trait Found {
    /// Differences that decide over a tool.
    fn sizes(&self, machine: &mut dyn Machine, inputs: &Inputs) -> Sizes;
    /// Differences that the safe area watches, mm, and the place that decides over a frame.
    fn place(&self, machine: &mut dyn Machine, inputs: &Inputs) -> (Vec<f64>, Measured);
}

impl Target {
    /// Finds it, and refuses what cannot be corrected; `axis` where there is one measuring axis.
    pub fn of(machine: &mut dyn Machine, inputs: &Inputs, axis: Option<usize>) -> Result<Target, Stop> {
        Ok(match inputs.variant / 100 % 10 {
            1 => Target::Zero(correct::zero_target(machine, inputs)?),
            _ => Target::Tool(tolerance::prepare(machine, inputs, axis)?),
        })
    }

    /// Writes the results, decides, corrects. The probe stands where the measurement ends.
    pub fn finish(
        &self,
        machine: &mut dyn Machine,
        inputs: &Inputs,
        found: &impl Found,
        repetition: u32,
    ) -> Result<Next, Stop> {
        let target = match self {
            Target::Tool(target) => {
                let sizes = found.sizes(machine, inputs);
                return tolerance::decide(machine, inputs, &sizes, target.as_ref(), repetition);
            }
            Target::Zero(target) => target,
        };
        let (differences, measured) = found.place(machine, inputs);
        let next = tolerance::safe(machine, inputs, &differences, repetition)?;
        if let (Next::Done, Some(target)) = (next, target) {
            correct::zero(machine, target, &measured);
        }
        Ok(next)
    }
}
