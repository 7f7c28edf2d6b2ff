//! Texts made from the catalogue and from results.

#[cfg(feature = "cli")]
pub mod reference;
