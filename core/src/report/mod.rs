//! Texts made from the catalogue and from results.

pub mod alarms;
pub mod explain;
pub mod findings;
mod help;
pub mod machine;
mod markdown;
#[cfg(test)]
mod readme_tests;
pub mod reference;
