//! CYCLE982 held against the manual, hand calculation and itself.

mod checks;
mod drill;
mod loops;
mod machine;
mod motion;
mod picture;
mod simulation;
