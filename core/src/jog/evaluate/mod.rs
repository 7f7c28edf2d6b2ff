//! From touches to results: what the mask shows, in the WCS that was active while measuring. Pure functions; points of
//! the plane are abscissa and ordinate, mm. DESIGN.md derives the formulas.

mod calibrate;
mod corner;
mod edge;
mod element;
mod round;
mod tool;

pub use calibrate::{Chord, Ring, length, ring};
pub use corner::{Corner, Side, corner};
pub use edge::{angle, distance};
pub use element::{Block, Found, Size, block, element, middle};
pub use round::{Round, circle, diagonals, directed, level, round};
pub use tool::{beside, new_length, new_radius, tip_height};

/// A point of the plane: abscissa and ordinate, mm.
pub type Flat = [f64; 2];
