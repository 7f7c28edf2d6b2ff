//! The same physical measurement gives the same physical result, whatever the basic system of the machine and the
//! units of the program are.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod call;
mod machines;
mod program;
mod same_result;
#[path = "../running/turning.rs"]
mod turning;

use probewright_core::control::Units;

const BASIC: [Units; 2] = [Units::Metric, Units::Inch];

/// Errors of the part, mm: position and size.
type Errors = ([f64; 3], f64);

/// Values of a call: numbers in mm, mm/min and degree, by parameter.
type Physical = Vec<(&'static str, f64)>;
