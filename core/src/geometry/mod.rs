//! A moving ball, or a rod, against surfaces, edges and corners; rigid motions. Knows no cycle and no part.
//!
//! Lengths in mm, parameters along a path in mm from its start. One file a kind of surface.

pub mod arc;
pub mod circle;
pub mod convex;
pub mod extent;
pub mod feature;
pub mod fit;
pub mod lobed;
pub mod mesh;
pub mod met;
pub mod path;
pub mod place;
pub mod point;
pub mod quad;
pub mod rigid;
pub mod rod;
pub mod roots;
pub mod segment;
pub mod stretch;
pub mod swept;
pub mod triangle;
pub mod wall;

pub use feature::Feature;
pub use met::Met;
pub use path::Path;
pub use place::{Mcs, Wcs};

/// A point or direction X Y Z.
pub type V3 = nalgebra::Vector3<f64>;

/// The figures X Y Z of a vector, for serde.
pub(crate) fn figures<S: serde::Serializer>(vector: &V3, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(vector.iter())
}

/// Farthest from the zero of the machine that anything stands or is long, mm: contact is computed to 1e-9 mm, which f64
/// holds up to here.
pub const FARTHEST: f64 = 1e6;

/// Two lengths closer than this, mm, are the same contact.
pub const TOLERANCE: f64 = 1e-9;
