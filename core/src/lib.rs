//! Measuring cycles of CNC controls: what can be measured, forms, checks, reading and writing part programs,
//! and the simulation of the control. No browser, no clock, no random source of its own, no IO.
//!
//! Inside: millimetre, degree, mm/min. See ARCHITECTURE.md for the invariants.

#[cfg(feature = "json")]
pub mod app;
pub mod catalogue;
pub mod check;
pub mod control;
pub mod diagnostic;
pub mod dialect;
pub mod encoding;
pub mod entry;
pub mod evaluate;
pub mod form;
pub mod geometry;
#[cfg(feature = "json")]
pub mod json;
pub mod machine;
pub mod message;
pub mod name;
pub mod own;
pub mod picture;
mod problem;
pub mod program;
pub mod range;
pub mod refused;
#[cfg(feature = "cli")]
pub mod report;
pub mod run;
pub mod scan;
pub mod scene;
pub mod support;
pub mod syntax;
#[cfg(test)]
mod test_data;
#[cfg(feature = "cli")]
pub mod words;
pub mod workpiece;

/// Whether this build carries out cycles, draws them and reads descriptions of machines (feature `simulation`). The
/// page's first module does not, and is so much smaller.
pub const SIMULATES: bool = cfg!(feature = "simulation");

/// A place in the manual, for tables that only a whole build shows: the page's first module carries none of them.
const fn cited(source: &'static str) -> &'static str {
    if SIMULATES { source } else { "" }
}
