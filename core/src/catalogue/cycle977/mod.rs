//! CYCLE977: hole, shaft, groove, web and rectangle, measured parallel to the axes (B:5600-6285).

mod checks;
mod element;
pub mod params;
mod picture;
mod propose;
mod protection;
mod results;
pub mod simulate;
#[cfg(test)]
mod tests;
mod variants;

pub use results::RESULTS;
pub use variants::VARIANTS;

use crate::catalogue::common::alarms;
use crate::catalogue::{Cycle, Dialect, Simulation};

/// The entry. Example: the hole of B:6050-6137.
pub static CYCLE977: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE977",
    key: "cycle977",
    variants: VARIANTS,
    params: params::PARAMS,
    settings: &[],
    results: RESULTS,
    // A:15840-15948, B:13565
    alarms: &alarms([
        61016, 61301, 61302, 61303, 61306, 61307, 61308, 61309, 61310, 61311, 61313, 61318, 61319,
        61320, 61321, 61322, 61323, 61324, 61325, 61328, 61334, 61341, 61343, 61345, 61372, 61373,
        61401, 61402, 61405, 61406, 61407, 62304, 62305, 62306,
    ]),
    checks: checks::checks,
    picture: picture::picture,
    example: &[
        ("_MVAR", "1"),
        ("_SETVAL", "132"),
        ("_KNUM", "2001"),
        ("_TNUM", "20"),
        ("_PRNUM", "1"),
        ("_FA", "1"),
        ("_TSA", "1"),
        ("_VMS", "0"),
        ("_NMSP", "1"),
        ("_EVNUM", "10"),
        ("_K", "3"),
        ("_TZL", "0.01"),
        ("_TMV", "0.02"),
        ("_TUL", "0.03"),
        ("_TLL", "-0.03"),
        ("_TDIF", "0.06"),
    ],
    simulation: Some(Simulation {
        propose: propose::propose,
        simulate: simulate::simulate,
    }),
    source: "B:5600-6285",
};
