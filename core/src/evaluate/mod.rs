//! From measured values to decisions and corrections. Knows the control's data, but no cycle.

pub mod frames;
pub mod knum;
pub mod mean;
pub mod symmetry;
pub mod tolerance;
pub mod tool_offset;
pub mod units;
pub mod zero_offset;

/// One datum of the control that a correction changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// `$TC_DP15[20,1]`, `$P_UIFR[1,X,FI]`, `_MV[9]`.
    pub name: String,
    /// Before, in the basic system of units.
    pub before: f64,
    /// After, in the basic system of units.
    pub after: f64,
}
