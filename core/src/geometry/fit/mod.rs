//! Elements nearest to measured points, by least squares of the distances, and held against reference pairs.

#[cfg(test)]
mod reference;
pub mod round;
pub mod straight;

pub use round::{circle, in_line, nearest};
pub use straight::{line, plane};
