//! CYCLE971 held against the manual, hand calculation and itself.

mod bench;
mod calibration;
mod checks;
mod motion;
mod simulation;
