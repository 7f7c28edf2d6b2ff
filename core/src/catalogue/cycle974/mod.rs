//! CYCLE974: one point of a turned part, for a tool offset or a zero offset (B:10409-10872).

mod checks;
mod help;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, CORRECTION, MEASURING};
use crate::catalogue::{common, lathe, newer, older};
use crate::entry::{Cycle, Drawing, Help, Purpose, Simulation, Variant, names};

/// Measuring variants (B:10455-10459).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle974-tool", source: "B:10457;B:10621;A:11674" },
    Variant { number: 100, key: "cycle974-zero", source: "B:10458;B:10539;A:11675" },
    Variant { number: 1000, key: "cycle974-reversal", source: "B:10459;B:10794;A:11676" },
];

/// The entry. Example: the outside diameter of B:10661-10720.
pub static CYCLE974: Cycle = Cycle {
    name: "CYCLE974",
    key: "cycle974",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose::TURNING,
    lists: &[older::CYCLE974, newer::CYCLE974],
    // B:2314, B:13534-13584, B:13739-13773, B:13917-14037
    settings: &[
        "_CBIT[0]", "_CBIT[1]", "_CBIT[2]", "_CHBIT[2]", "_CHBIT[4]", "_CHBIT[5]", "_CHBIT[6]", "_CHBIT[8]",
        "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]", "_CHBIT[19]", "_CHBIT[21]", "_SPEED", "_EV", "_MV",
    ],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        lathe::ALARMS,
        // A:15868, A:15882; 61401 as in the other cycles (A:15920); 61412 for _KNUM = 1000 without a basic frame
        // (A:15931)
        &common::alarms([61327, 61341, 61401, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[CORRECTION, help::LINES, BLOCK, lathe::help::PROBE, CALIBRATED, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[(params::REVERSAL, &[(names::STA1, "0")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    source: "B:10409-10872",
    ..common::CYCLE
};
