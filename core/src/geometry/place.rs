//! Points by the coordinate system in which their numbers count, so that one does not pass for another.

use super::V3;
use std::ops::{Add, Sub};

/// A point X Y Z of the active workpiece coordinate system, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Wcs(pub [f64; 3]);

/// A point X Y Z in machine (basic) coordinates, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Mcs(pub [f64; 3]);

/// Its numbers are read and written as those of an array; an array is none of it yet.
macro_rules! numbers_of {
    ($own:ty) => {
        impl std::ops::Deref for $own {
            type Target = [f64; 3];

            fn deref(&self) -> &[f64; 3] {
                &self.0
            }
        }

        impl std::ops::DerefMut for $own {
            fn deref_mut(&mut self) -> &mut [f64; 3] {
                &mut self.0
            }
        }

        impl PartialEq<[f64; 3]> for $own {
            fn eq(&self, numbers: &[f64; 3]) -> bool {
                self.0 == *numbers
            }
        }
    };
}
pub(super) use numbers_of;

/// What points of every coordinate system can do.
macro_rules! points {
    ($($place:ty),*) => {
        $(
            numbers_of!($place);

            impl From<$place> for V3 {
                fn from(place: $place) -> V3 {
                    place.0.into()
                }
            }

            /// The point so far away.
            impl Add<[f64; 3]> for $place {
                type Output = $place;

                fn add(self, way: [f64; 3]) -> $place {
                    Self(std::array::from_fn(|axis| self[axis] + way[axis]))
                }
            }

            /// The way from the other point to this one.
            impl Sub for $place {
                type Output = [f64; 3];

                fn sub(self, from: $place) -> [f64; 3] {
                    std::array::from_fn(|axis| self[axis] - from[axis])
                }
            }
        )*
    };
}

points!(Wcs, Mcs);
