//! CYCLE978: one point on a surface parallel to an axis (B:6287-6735).

pub(crate) mod params;
mod picture;
mod results;
pub(crate) mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::common::tasks::{AXIS, LOWER, MOST, REACH, SAFE, SET, TOOL, UPPER, ZERO, tool, zero};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CORRECTION, DIFFERENTIAL, MEASURING, PROBE};
use crate::catalogue::{newer, older};

/// Measuring variants (B:6323-6328).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle978-tool", source: "B:6325;B:6596;A:7189" },
    Variant { number: 100, key: "cycle978-zero", source: "B:6326;B:6456;A:7190" },
    Variant { number: 1000, key: "cycle978-differential-tool", source: "B:6327;B:6597;A:7191" },
    Variant { number: 1100, key: "cycle978-differential-zero", source: "B:6328;B:6457;A:7192" },
];

/// Lines of the help page (B:6286-6730).
const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle978-measures-point", "B:6288"),
    before(When::Always, "help-cycle978-before-opposite", "B:6376-6384"),
    order(When::Always, "help-cycle978-order-axis", "B:6376-6388"),
    corrects(params::TOOL, "help-cycle978-corrects-full", "B:6698-6699"),
    corrects(params::ZERO, "help-cycle978-corrects-one-axis", "B:6436-6450"),
    wrong(When::Always, "help-cycle978-wrong-side", "B:6376-6384"),
    wrong(When::Always, "help-cycle978-wrong-oblique", "B:6288"),
];

/// What the other control can do too, first those that correct a zero offset.
const TASKS: &[Shared] = &[
    zero(Task::Wall, 100, When::All(&[When::Variant(&[100, 1100]), IN_PLANE]), BY_ZERO),
    zero(Task::Face, 100, When::All(&[When::Variant(&[100, 1100]), ALONG_TOOL]), BY_ZERO),
    tool(Task::Wall, 0, When::All(&[When::Variant(&[0, 1000]), IN_PLANE]), BY_TOOL),
    tool(Task::Face, 0, When::All(&[When::Variant(&[0, 1000]), ALONG_TOOL]), BY_TOOL),
];

const IN_PLANE: When = When::Number { param: names::MA, is: &[1.0, 2.0] };
const ALONG_TOOL: When = When::Number { param: names::MA, is: &[3.0] };
const BY_ZERO: &[(Name, Meaning)] = &[SET, AXIS, REACH, SAFE, ZERO];
const BY_TOOL: &[(Name, Meaning)] = &[SET, AXIS, REACH, UPPER, LOWER, MOST, TOOL];

/// The entry. Example: the surface of B:6632-6704.
pub static CYCLE978: Cycle = Cycle {
    name: "CYCLE978",
    key: "cycle978",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE978, newer::CYCLE978],
    settings: &["_CBIT[14]"], // B:6400: on a lathe the length ends at the centre of the ball
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        // A:15866-15882, A:15920; 61412 for _KNUM = 1000 without a basic frame (A:15931)
        &common::alarms([61325, 61327, 61341, 61401, 61412]),
    ],
    checks,
    help: Help::new(&[CORRECTION, DIFFERENTIAL, LINES, BLOCK, PROBE, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[(params::ZERO, &[(names::KNUM, "1")])],
    simulation: Some(Simulation::new(propose, simulate::simulate)),
    aims: Aims { elements: &[(When::Always, Element::Edge)], corrects: common::CORRECTED, options: &[] },
    source: "B:6287-6705",
    ..common::CYCLE
};

/// What several values say together. Between differential measurements the spindle turns a multi probe, so that they
/// have to lie in the plane (B:6308, B:6418); the alarm for the axis is ours.
fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::measuring(inputs, control, found);
    if params::DIFFERENTIAL.holds(inputs) {
        shared_checks::differential(inputs, control, found);
        if inputs.integer(names::MA) == 3 {
            found.push(refused(61325, "check-differential-axis", names::MA));
        }
    }
}

/// A block with a face at the set position, and a start opposite it, further away than `_FA` (B:6376-6384): in the
/// plane on the minus side, unless the call measures in the minus direction; above along the applicate.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let axis = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let away = inputs.number(names::FA) + place::ball_radius(inputs, control) + 5.0;
    let side = match axis {
        2 => place::side(control),
        _ if inputs.minus => 1.0,
        _ => -1.0,
    };
    let (part, start) = place::face(control, axis, inputs.number(names::SETVAL), side, away);
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, start) }
}
