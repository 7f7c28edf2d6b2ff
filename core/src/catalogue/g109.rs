//! G109: pocket or web along one axis of the plane (C:868-1028).

use super::nct;
use super::nct::correct::Place;
use super::nct::params::{ALONG_X, ALONG_Y, ALONG_Z};
use super::nct::plane_axis::{X, Y, Z, depth_mark, index, nominal};
use super::nct::walls::{Walls, chord, depth, from_outside, home};
use super::nct::{FORMAT_ERROR, axis_of, checks, correct, figures, params, part, plane_axis, walls};
use crate::catalogue::prelude::*;

/// The stylus stands between the walls.
pub const POCKET: i64 = walls::INSIDE;
/// The stylus stands above; the address of the tool axis says how deep to measure.
pub const WEB: i64 = walls::OUTSIDE;

/// The macro.
pub static G109: Cycle = Cycle {
    name: "G109",
    key: "g109",
    variants: &[
        Variant { number: POCKET, key: "g109-pocket", source: "C:911" },
        Variant { number: WEB, key: "g109-web", source: "C:911" },
    ],
    purpose: Purpose {
        tasks: &[
            nct::tasks::task(Task::Pocket, &[POCKET], POCKET, nct::tasks::IN_AXIS),
            nct::tasks::task(Task::Web, &[WEB], WEB, nct::tasks::IN_AXIS),
        ],
        ..Purpose::MILLING
    },
    params: &[
        Param {
            key: "g109-width",
            chooses: &[from_outside(ALONG_X)],
            labels: &[(ALONG_X, "g109-depth")],
            example: "80",
            source: "C:907-911",
            ..X
        },
        Param {
            key: "g109-width",
            chooses: &[from_outside(ALONG_Y)],
            labels: &[(ALONG_Y, "g109-depth")],
            source: "C:907-911",
            ..Y
        },
        Param {
            key: "g109-width",
            chooses: &[from_outside(ALONG_Z)],
            labels: &[(ALONG_Z, "g109-depth")],
            source: "C:907-911",
            ..Z
        },
        Param { needs: &[optional(When::Variant(&[WEB]), "need-nct-optional")], source: "C:912", ..params::R },
        Param { source: "C:913", ..params::Q },
        Param { example: "1", source: "C:914", ..params::S },
        Param { key: "nct-t-size", source: "C:933", ..params::T },
        Param { source: "C:927", ..params::M },
        Param { example: "0.02", source: "C:934", ..params::H },
        Param { source: "C:935", ..params::U },
        Param { example: "2", source: "C:936", ..params::V },
        Param { example: "2", source: "C:937", ..params::W },
    ],
    results: &[
        params::length("WIDTH", "result-g109-width", "C:868-887"),
        params::length("DEVIATION", "result-g109-deviation", "C:868-887"),
        params::length("CENTRE", "result-g109-centre", "C:868-887"),
        params::length("SHIFT", "result-g109-shift", "C:868-887"),
    ],
    alarms: &[nct::MEASURING, nct::PROTECTED, nct::LIMITS, &[nct::TOOL_TOO_LARGE]],
    checks,
    help: Help::new(&[
        &[
            measures(When::Variant(&[POCKET]), "help-g109-measures-pocket", "C:887-911"),
            measures(When::Variant(&[WEB]), "help-g109-measures-web", "C:887-911"),
            before(When::Variant(&[POCKET]), "help-g109-before-inside", "C:887-911"),
            before(When::Variant(&[WEB]), "help-g109-before-above", "C:887-911"),
            order(When::Variant(&[POCKET]), "help-g109-order-outwards", "C:887-999"),
            order(When::Variant(&[WEB]), "help-g109-order-inwards", "C:887-999"),
            corrects(When::Always, "help-g109-corrects-half", "C:925-960"),
            wrong(When::Always, "help-g109-wrong-width", "C:887-911"),
            wrong(When::Variant(&[POCKET]), "help-g109-wrong-room", "C:984-985"),
        ],
        nct::help::MEASURING,
        nct::help::TWO_MACROS,
        nct::help::SHIFTS,
    ]),
    picture: Drawing::staged(stage, marks),
    simulation: Some(Simulation::new(propose, simulate)),
    aims: Aims {
        elements: &[(When::Variant(&[POCKET]), Element::Groove), (When::Variant(&[WEB]), Element::Web)],
        corrects: nct::CORRECTED,
        options: &[],
    },
    source: "C:868-1028",
    ..nct::MACRO
};

fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    let known = plane_axis::check(inputs, findings);
    checks::corrections(inputs, findings);
    let (name, width) = nominal(inputs);
    if known && width <= 0.0 {
        let hint = Message::new("g109-no-width-hint");
        findings.push(error(FORMAT_ERROR, Message::new("g109-no-width")).hint(hint).at(name));
    } else if inputs.variant == POCKET {
        checks::room(inputs, name, control, findings);
    }
}

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let index = index(inputs);
    let walls = Walls::of(machine, inputs, nominal(inputs).1);
    let axis = walls.axes[index];
    let found = chord(machine, &walls, index)?;
    home(machine, Wcs(walls.start))?;
    let width = 2.0 * (found.half - walls.material() * found.ball);
    let deviation = width - walls.size;
    let shift = found.middle - walls.start[axis];
    let places = [Place { axis, nominal: walls.start[axis], deviation: shift }];
    let values = [("WIDTH", width), ("DEVIATION", deviation), ("CENTRE", found.middle), ("SHIFT", shift)];
    correct::finish(machine, inputs, &values, &walls.found(deviation, &places));
    Ok(())
}

fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let width = Some(nominal(inputs).1).filter(|width| *width > 0.0);
    let mut length = [100.0; 2];
    length[index(inputs)] = width.unwrap_or(80.0);
    walls::propose(inputs, control, |outside, height| part::rectangle(outside, length, height))
}

/// Depth at which a drawn web is touched, mm.
const DEPTH: f64 = -30.0;

/// The walls from the side: the measured axis to the right, the tool axis up.
fn stage(inputs: &Inputs) -> Staging {
    let look = Look::section(index(inputs)).ways(address::R);
    let stage = figures::stage(inputs, look, &[]).sized(inputs, &[nominal(inputs).0]);
    if depth(inputs).is_some() { stage.with(axis_of(inputs, 2), DEPTH) } else { stage }
}

/// Width, depth and limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let size = |seen: &Seen| vec![seen.size(nominal(inputs).0, 0)];
    let all = |seen: &Seen| [figures::limits(inputs, seen), size(seen), depth_mark(inputs, seen)].concat();
    looks.iter().flat_map(all).collect()
}
