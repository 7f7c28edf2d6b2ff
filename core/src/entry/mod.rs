//! The shape of an entry of the catalogue: plain data that form, check, program, run and the documents read.

pub mod address;
mod aim;
mod columns;
mod cycle;
mod help;
mod inputs;
mod list;
mod named;
pub mod names;
mod param;
pub mod stage;
mod task;
mod topic;
mod units;
mod when;
mod work;

pub use aim::*;
pub use columns::*;
pub use cycle::*;
pub use help::*;
pub use inputs::{Inputs, Typed};
pub use list::*;
pub use param::*;
pub use task::*;
pub use topic::Topic;
pub use units::*;
pub use when::*;
pub use work::*;
