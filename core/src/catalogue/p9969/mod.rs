//! G65 P9969: rectangular digitizing of a free surface (C:1276-1355).

mod addresses;
mod follow;
mod picture;
mod simulate;
#[cfg(test)]
mod tests;

use super::nct;
use super::nct::{FORMAT_ERROR, axis_of, params, part};
use crate::catalogue::prelude::*;
use crate::workpiece::free::Example;
use addresses::{letter, spacing};

/// The macro.
pub static P9969: Cycle = Cycle {
    name: "G65 P9969",
    key: "p9969",
    variants: &[Variant { number: 0, key: "p9969-rectangle", source: "C:1278" }],
    params: addresses::PARAMS,
    results: &[
        count("POINTS", "result-p9969-points"),
        count("LINES", "result-p9969-lines"),
        params::length("LOWEST", "result-p9969-lowest", "C:1262-1266"),
        params::length("HIGHEST", "result-p9969-highest", "C:1262-1266"),
    ],
    alarms: &[&[
        FORMAT_ERROR,
        nct::NO_TOOL_LENGTH,
        nct::OUT_OF_POSITION,
        nct::STYLUS_IN_CONTACT,
        nct::SCANNING_OBSTRUCTED,
        nct::SCANNING_FAIL,
    ]],
    checks,
    help: Help::new(&[
        &[
            measures(When::Always, "help-p9969-measures", "C:1262-1275"),
            before(When::Always, "help-stylus", "C:1335-1337"),
            before(When::Always, "help-p9969-before", "C:1280"),
            order(When::Always, "help-p9969-order-lines", "C:1278"),
            order(When::Always, "help-p9969-order-point", "C:1316-1317"),
            order(When::Always, "help-p9969-order-deepest", "C:1280"),
            corrects(When::Always, "help-p9969-corrects", "C:1262-1275;C:1322"),
            wrong(When::Always, "help-p9969-wrong-fast", "C:1318-1321"),
            wrong(When::Always, "help-p9969-wrong-step", "C:1337"),
            wrong(When::Always, "help-p9969-wrong-cavity", "C:1338"),
            wrong(When::Always, "help-p9969-wrong-ball", "C:1272-1275"),
        ],
        nct::help::ONE_MACRO,
    ]),
    picture: Drawing::staged(picture::stage, picture::marks),
    simulation: Some(Simulation::new(propose, simulate::simulate).with_scan(follow::scanner)),
    aims: Aims {
        elements: &[(When::Always, Element::Surface)],
        corrects: &[(When::Always, Corrects::Nothing, &[])],
        options: &[],
    },
    source: "C:1276-1355",
    ..nct::MACRO
};

const fn count(name: &'static str, key: &'static str) -> ResultField {
    ResultField { unit: Unit::None, ..params::length(name, key, "C:1262-1266") }
}

/// Rim of the proposed surface beside the rectangle, so that the ball is never at an edge, mm.
const RIM: f64 = 8.0;

/// Hills and hollows under a rectangle that begins at the zero of the WCS; the lowest point lies above the deepest
/// position, the stylus above the highest.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let end = [0, 1, 2].map(|index| inputs.number(axis_of(inputs, index)));
    let size = [end[0], end[1]].map(|end| end.abs() + 2.0 * RIM);
    let height = (size[0].min(size[1]) / 5.0).min(10.0);
    let top = end[2] + height + 2.0;
    let start = [0.0, 0.0, top + 5.0];
    match Example::Waves.surface(size, height) {
        Ok(surface) => part::propose(Shape::Free(surface), [end[0] / 2.0, end[1] / 2.0, top], start, control),
        // the rectangle is larger than anything can be
        Err(_) => Proposal { start: Wcs(place::in_plane(control, start)), ..Proposal::default() },
    }
}

/// Both line spacings of the plane (C:1330-1332), or none: then nothing says which axis is scanned along.
fn checks(inputs: &Inputs, _: &Control, findings: &mut Vec<Diagnostic>) {
    if spacing(inputs).is_some() {
        return;
    }
    let [first, second, _] = inputs.plane.axes().map(letter);
    let message = Message::new("p9969-one-spacing").text("first", first).text("second", second);
    findings.push(error(FORMAT_ERROR, message).hint(Message::new("p9969-one-spacing-hint")).at(second));
}
