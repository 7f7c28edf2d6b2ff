//! Texts made from the catalogue and from results.

#[cfg(feature = "cli")]
pub mod alarms;
#[cfg(feature = "cli")]
pub mod explain;
#[cfg(feature = "cli")]
pub mod findings;
#[cfg(feature = "cli")]
mod help;
#[cfg(feature = "cli")]
pub mod machine;
#[cfg(feature = "cli")]
mod markdown;
#[cfg(feature = "cli")]
pub mod reference;
