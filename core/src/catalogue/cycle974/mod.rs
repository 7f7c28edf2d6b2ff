//! CYCLE974: one point of a turned part, for a tool offset or a zero offset (B:10409-10872).

pub(crate) mod params;
mod picture;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::common::{TOOL_OFFSET, ZERO_OFFSET};
use crate::catalogue::lathe::{measure, place};
use crate::catalogue::place as plane;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, CORRECTION, MEASURING};
use crate::catalogue::{common, lathe, newer, older};
use params::REVERSAL;

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
    checks,
    // B:10452-10905
    help: Help::new(&[
        CORRECTION,
        &[
            measures(When::Always, "help-cycle974-measures-point", "B:10455-10459"),
            before(When::Always, "help-cycle974-before-opposite", "B:10507-10511"),
            before(REVERSAL, "help-cycle974-before-chuck", "B:10784"),
            order(When::Always, "help-cycle974-order-axis", "B:10511;B:10583;B:10768"),
            order(REVERSAL, "help-cycle974-order-reversal", "B:10784;B:10823"),
            corrects(TOOL_OFFSET, "help-cycle974-corrects-half", "B:10742-10754"),
            corrects(ZERO_OFFSET, "help-cycle974-corrects-one-axis", "B:10525"),
            wrong(When::Always, "help-cycle974-wrong-side", "B:10511"),
            wrong(When::Not(&REVERSAL), "help-cycle974-wrong-run-out", "B:10776-10784"),
        ],
        BLOCK,
        lathe::help::PROBE,
        CALIBRATED,
        AGAIN,
        MEASURING,
    ]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[(REVERSAL, &[(names::STA1, "0")])],
    simulation: Some(Simulation::new(propose, simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Turned)],
        corrects: common::CORRECTED,
        options: &[(When::Always, "aim-touches", "aim-touches-one")],
    },
    source: "B:10409-10872",
    ..common::CYCLE
};

/// What several values say together.
fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    lathe::checks::measuring(inputs, control, found);
    // the cycle turns the part between its two measurements (B:10784, A:15916)
    if REVERSAL.holds(inputs) && !control.spindle_positions {
        found.push(refused(61372, "check-reversal-part", names::MVAR));
    }
}

/// How much further from the surface than the first block the probe starts, mm.
const AWAY: f64 = 5.0;

/// A turned part about the zero point, whose end face or outside is measured, and the start opposite the point, outside
/// of the part, on the side of the setpoint (B:10513-10523).
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let index = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let axis = control.plane.axes()[index];
    let set = inputs.number(names::SETVAL) / measure::per(control, inputs);
    let away = plane::ball_radius(inputs, control) + inputs.number(names::FA) + AWAY;
    let side = if axis != 2 && set < 0.0 { -1.0 } else { 1.0 };
    let (part, start) = place::touched(control, axis, set, side, away);
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, start) }
}
