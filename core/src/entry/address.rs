//! Addresses that NCT macros take; what each means is told by the parameter of the entry.

use crate::name::Name;

/// Address D.
pub const D: Name = Name::new("D");
/// Address E.
pub const E: Name = Name::new("E");
/// Address F.
pub const F: Name = Name::new("F");
/// Address H.
pub const H: Name = Name::new("H");
/// Address I.
pub const I: Name = Name::new("I");
/// Address J.
pub const J: Name = Name::new("J");
/// Address K.
pub const K: Name = Name::new("K");
/// Address M.
pub const M: Name = Name::new("M");
/// Address Q.
pub const Q: Name = Name::new("Q");
/// Address R.
pub const R: Name = Name::new("R");
/// Address S.
pub const S: Name = Name::new("S");
/// Address T.
pub const T: Name = Name::new("T");
/// Address U.
pub const U: Name = Name::new("U");
/// Address V.
pub const V: Name = Name::new("V");
/// Address W.
pub const W: Name = Name::new("W");
/// Address X.
pub const X: Name = Name::new("X");
/// Address Y.
pub const Y: Name = Name::new("Y");
/// Address Z.
pub const Z: Name = Name::new("Z");
/// Those of the axes.
pub const AXES: [Name; 3] = [X, Y, Z];
