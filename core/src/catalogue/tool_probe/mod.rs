//! What the SINUMERIK cycles at a tool probe share (CYCLE971, CYCLE972, CYCLE982): parameters, data of the probe,
//! checks, what a calibration stores and a measurement corrects.

pub mod checks;
pub mod correct;
mod data;
pub mod figures;
pub mod help;
pub mod params;
mod stand;
pub mod store;
pub mod turning;

use crate::catalogue::prelude::*;
pub use data::{DEPTH, DIRECTIONS, EDGE_LENGTH, ProbeData, TYPE, count};
pub use stand::Stand;

/// Alarms that the manual names for every cycle at a tool probe (A:15840-15943): those of all cycles but for the one
/// about the workpiece probe, and those of tool measurement.
pub const ALARMS: &[Code] = &alarms([
    61016, 61301, 61302, 61303, 61306, 61307, 61308, 61310, 61311, 61312, 61313, 61314, 61320, 61325, 61327, 61328,
    61332, 61336, 61338, 61339, 61340, 61342, 61343, 61344, 61345, 61372, 61373, 61403, 61404, 61405, 61406, 61407,
    61408, 61409, 61410, 61416, 62303, 62306,
]);
