//! Points by the coordinate system in which their numbers count, so that one does not pass for another.

use super::V3;
use std::ops::{Add, Deref, DerefMut, Sub};

/// A point X Y Z of the active workpiece coordinate system, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Wcs(pub [f64; 3]);

/// A point X Y Z in machine (basic) coordinates, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Mcs(pub [f64; 3]);

/// Its numbers are read and written as those of an array; the array is no point yet.
macro_rules! numbers_of {
    ($($place:ty),*) => {
        $(
            impl Deref for $place {
                type Target = [f64; 3];

                fn deref(&self) -> &[f64; 3] {
                    &self.0
                }
            }

            impl DerefMut for $place {
                fn deref_mut(&mut self) -> &mut [f64; 3] {
                    &mut self.0
                }
            }

            impl PartialEq<[f64; 3]> for $place {
                fn eq(&self, numbers: &[f64; 3]) -> bool {
                    self.0 == *numbers
                }
            }

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

numbers_of!(Wcs, Mcs);
