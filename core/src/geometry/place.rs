//! Points by the coordinate system in which their numbers count, so that one does not pass for another.

use std::ops::{Deref, DerefMut};

/// A point X Y Z of the active workpiece coordinate system, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wcs(pub [f64; 3]);

/// A point X Y Z in machine (basic) coordinates, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
        )*
    };
}

numbers_of!(Wcs, Mcs);
