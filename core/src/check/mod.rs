//! Typed values → checked inputs and findings. The only way to [`Inputs`](crate::entry::Inputs).

pub mod braking;
pub mod expression;
mod finding;
pub mod listed;
pub mod newer;
mod number;
mod targets;
#[cfg(test)]
mod tests;
mod text;
mod typed;
pub mod upkeep;
pub mod variants;

pub use finding::{announced, error, refused, warning};
pub use listed::Sort;
pub use number::{Parsed, parse};
pub use targets::{Target, target};
pub use text::{Text, parse as parse_text, typed as typed_text};
pub use typed::{Checked, check, read, tool_in_use};
