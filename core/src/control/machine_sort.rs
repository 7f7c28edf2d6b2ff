//! Sorts of machines.

use super::Plane;

/// Sort of machine that a cycle is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum MachineSort {
    /// Milling machines and machining centres.
    Milling,
    /// Lathes.
    Turning,
    /// Both.
    Any,
}

impl MachineSort {
    /// The plane in which such a machine works unless told otherwise (B:8718); none where any may be meant.
    pub fn plane(self) -> Option<Plane> {
        match self {
            MachineSort::Milling => Some(Plane::G17),
            MachineSort::Turning => Some(Plane::G18),
            MachineSort::Any => None,
        }
    }
}
