//! Measuring in JOG: the masks of the functions as data, the touches, what they come to, what is written, and the way
//! of working as a table of states (chapter 4 of the manual, B:2570-4083). SINUMERIK milling machines only (B:2576,
//! B:2608), for setting up a workpiece on the table, often in more than one call (B:2709).

pub mod activation;
pub mod approach;
mod calculate;
mod calibrating;
pub mod chance;
pub mod counterpart;
pub mod evaluate;
pub mod help;
pub mod mask;
pub mod masks;
pub mod offset;
pub mod practice;
pub mod script;
pub mod session;
pub mod settings;
pub mod shadow;
pub mod softkeys;
pub mod states;
pub mod stylus;
mod tools;
pub mod touching;
mod upright;
pub mod values;

pub use calculate::{Outcome, Point, Unfit, calculate, corner_sides};
pub use mask::{Function, Mask};
pub use masks::{FUNCTIONS, OLDER};
pub use session::{Input, Session};
pub use states::State;

use crate::dialect::Dialect;

/// Whether a control measures in JOG (B:2576).
pub fn measures(dialect: Dialect) -> bool {
    dialect == Dialect::Sinumerik
}
