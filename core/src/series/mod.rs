//! A measurement many times: numbers that spread, what is drawn from them, and what follows from a spread.
//!
//! Formulas are of JCGM 100:2008 (uncertainty), JCGM 101:2008 (Monte Carlo), JCGM 106:2012 and ISO 14253-1:2017
//! (decisions), ISO 22514 (capability).

pub mod capability;
pub mod decide;
pub mod draw;
pub mod normal;
pub mod random;
pub mod repeat;
pub mod spread;
pub mod trend;
#[cfg(test)]
mod vectors;
