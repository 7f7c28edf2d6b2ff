//! Elements nearest to measured points, by least squares of the distances, and held against reference pairs.

#[cfg(test)]
mod reference;
pub mod round;

pub use round::{circle, in_line, nearest};
