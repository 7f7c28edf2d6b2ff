//! A moving ball, or a rod, against surfaces, edges and corners; rigid motions. Knows no cycle and no part.
//!
//! Lengths in mm, parameters along a path in mm from its start. One file a kind of surface.

mod angle;
pub mod arc;
mod circle;
pub mod convex;
mod extent;
pub mod feature;
pub mod fit;
mod lobed;
mod mesh;
mod met;
mod path;
mod place;
mod point;
mod quad;
pub mod rigid;
pub mod rod;
pub mod roots;
mod segment;
mod stretch;
mod swept;
pub mod triangle;
mod wall;

pub use angle::Degrees;
pub use arc::Around;
pub use circle::{Circle, radial};
pub use convex::Convex;
pub use extent::Extent;
pub use feature::Feature;
pub use lobed::{LobedWall, Lobes};
pub use mesh::Mesh;
pub use met::{Met, Stand, earliest};
pub use path::Path;
pub use place::{Dir, Mcs, Wcs};
pub use quad::{Quad, Trim};
pub use rigid::Rpy;
pub use rod::Rod;
pub use segment::Segment;
pub use stretch::Stretch;
pub use swept::Swept;
pub use wall::Wall;

/// A point or direction X Y Z.
pub type V3 = nalgebra::Vector3<f64>;

/// For the page, types that are plain figures there.
#[cfg(test)]
macro_rules! figures_of_the_page {
    ($($own:ty: $page:literal),*) => {$(
        impl ts_rs::TS for $own {
            type WithoutGenerics = Self;
            type OptionInnerType = Self;

            fn name(_: &ts_rs::Config) -> String {
                $page.into()
            }

            fn inline(config: &ts_rs::Config) -> String {
                Self::name(config)
            }
        }
    )*};
}
#[cfg(test)]
figures_of_the_page!(Degrees: "number", Rpy: "[number, number, number]", Dir<Mcs>: "[number, number, number]");

/// The figures X Y Z of a vector, for serde.
pub(crate) fn figures<S: serde::Serializer>(vector: &V3, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(vector.iter())
}

/// Farthest place from the zero of the machine, greatest length, mm: to here f64 holds the 1e-9 mm of a contact.
pub const FARTHEST: f64 = 1e6;

/// Two lengths closer than this, mm, are the same contact.
pub const TOLERANCE: f64 = 1e-9;
