//! What a measurement corrects: a tool or a zero offset, as the hundreds of `_MVAR` say.

use super::{correct, tolerance};
use crate::entry::Inputs;
use crate::evaluate::{tool_offset, zero_offset};
use crate::machine::{Machine, Stop};

/// What is corrected; none of it where `_KNUM` is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A tool.
    Tool(Option<tool_offset::Target>),
    /// A zero offset.
    Zero(Option<zero_offset::Target>),
}

impl Target {
    /// Finds it, and refuses what cannot be corrected; `axis` where there is one measuring axis.
    pub fn of(machine: &mut dyn Machine, inputs: &Inputs, axis: Option<usize>) -> Result<Target, Stop> {
        Ok(match inputs.variant / 100 % 10 {
            1 => Target::Zero(correct::zero_target(machine, inputs)?),
            _ => Target::Tool(tolerance::prepare(machine, inputs, axis)?),
        })
    }
}
