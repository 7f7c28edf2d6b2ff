//! Addresses that NCT macros take; what each means is told by the parameter of the entry.
#![allow(missing_docs)]

use crate::name::Name;

pub const D: Name = Name::new("D");
pub const E: Name = Name::new("E");
pub const F: Name = Name::new("F");
pub const H: Name = Name::new("H");
pub const I: Name = Name::new("I");
pub const J: Name = Name::new("J");
pub const K: Name = Name::new("K");
pub const M: Name = Name::new("M");
pub const Q: Name = Name::new("Q");
pub const R: Name = Name::new("R");
pub const S: Name = Name::new("S");
pub const T: Name = Name::new("T");
pub const U: Name = Name::new("U");
pub const V: Name = Name::new("V");
pub const W: Name = Name::new("W");
pub const X: Name = Name::new("X");
pub const Y: Name = Name::new("Y");
pub const Z: Name = Name::new("Z");
/// Addresses of the axes.
pub const AXES: [Name; 3] = [X, Y, Z];
