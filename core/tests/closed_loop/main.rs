//! The loop closes: what a calibration finds out makes later measurements right, a corrected zero offset and a
//! corrected tool make the next measurement agree with the setpoint.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bench;
mod calibration;
mod differential;
mod lathe_probe;
mod milled;
mod spread;
mod tilted;
mod tool;
mod turning;
mod zero_offset;
