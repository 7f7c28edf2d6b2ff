//! Points and directions by the coordinate system in which their numbers count, so that one does not pass for another.
//! What is told in the frame of a solid, and what geometry calculates with, is a plain [`V3`].

use super::V3;
use std::marker::PhantomData;
use std::ops::{Add, Mul, Neg, Sub};

/// A point X Y Z of the active workpiece coordinate system, mm.
///
/// ```compile_fail
/// use probewright_core::geometry::{Mcs, Wcs};
/// let machine: Mcs = Wcs([1.0, 2.0, 3.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Wcs(pub [f64; 3]);

/// A point X Y Z in machine (basic) coordinates, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "[f64; 3]"))]
pub struct Mcs(pub [f64; 3]);

/// A direction X Y Z in the coordinate system whose points are `P`, or a way there in mm.
///
/// ```compile_fail
/// use probewright_core::geometry::{Dir, Mcs, Wcs};
/// let up: Dir<Wcs> = Dir::new([0.0, 0.0, 1.0]);
/// let above = Mcs([1.0, 2.0, 3.0]) + up;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct Dir<P>(pub [f64; 3], PhantomData<P>);

impl<P> Dir<P> {
    /// Of its parts X Y Z.
    pub const fn new(parts: [f64; 3]) -> Dir<P> {
        Dir(parts, PhantomData)
    }
}

impl<P> Add for Dir<P> {
    type Output = Dir<P>;

    fn add(self, other: Dir<P>) -> Dir<P> {
        Dir::new(std::array::from_fn(|axis| self[axis] + other[axis]))
    }
}

impl<P> Neg for Dir<P> {
    type Output = Dir<P>;

    fn neg(self) -> Dir<P> {
        Dir::new(self.map(|part| -part))
    }
}

impl<P> Mul<f64> for Dir<P> {
    type Output = Dir<P>;

    fn mul(self, times: f64) -> Dir<P> {
        Dir::new(self.map(|part| part * times))
    }
}

impl<P> From<V3> for Dir<P> {
    fn from(vector: V3) -> Dir<P> {
        Dir::new(vector.into())
    }
}

/// Reads and writes the numbers of a type as those of an array; an array is none of it yet.
macro_rules! numbers_of {
    ($own:ty $(, $of:ident)?) => {
        impl$(<$of>)? std::ops::Deref for $own {
            type Target = [f64; 3];

            fn deref(&self) -> &[f64; 3] {
                &self.0
            }
        }

        impl$(<$of>)? std::ops::DerefMut for $own {
            fn deref_mut(&mut self) -> &mut [f64; 3] {
                &mut self.0
            }
        }

        impl$(<$of>)? PartialEq<[f64; 3]> for $own {
            fn eq(&self, numbers: &[f64; 3]) -> bool {
                self.0 == *numbers
            }
        }

        impl$(<$of>)? From<$own> for crate::geometry::V3 {
            fn from(own: $own) -> crate::geometry::V3 {
                own.0.into()
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

            impl From<V3> for $place {
                fn from(point: V3) -> $place {
                    Self(point.into())
                }
            }

            /// The point so far away.
            impl Add<Dir<$place>> for $place {
                type Output = $place;

                fn add(self, way: Dir<$place>) -> $place {
                    Self(std::array::from_fn(|axis| self[axis] + way[axis]))
                }
            }

            /// The way from the other point to this one.
            impl Sub for $place {
                type Output = Dir<$place>;

                fn sub(self, from: $place) -> Dir<$place> {
                    Dir::new(std::array::from_fn(|axis| self[axis] - from[axis]))
                }
            }
        )*
    };
}

points!(Wcs, Mcs);
numbers_of!(Dir<P>, P);
