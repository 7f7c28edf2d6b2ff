//! From measured values to decisions and corrections. Knows the control's data, but no cycle.

pub mod knum;
pub mod level;
pub mod mean;
pub mod position;
pub mod spread;
pub mod symmetry;
pub mod tolerance;
pub mod tool_offset;
pub mod zero_offset;

/// One datum of the control that a correction writes; whoever asked for it writes and records it.
#[derive(Clone, Debug, PartialEq)]
pub struct Write {
    /// `$TC_DP15[20,1]`, `$P_UIFR[1,X,FI]`.
    pub name: String,
    /// New value; lengths in mm.
    pub value: f64,
}
