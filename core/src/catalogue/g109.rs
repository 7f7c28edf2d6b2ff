//! G109: pocket or web along one axis of the plane (C:868-1028).

use super::common::{PARAM, optional};
use super::nct;
use super::nct::correct::{Found, Part};
use super::nct::plane_axis::{depth, index, needs, nominal};
use super::nct::walls::{Outside, Walls, chord, home};
use super::nct::{FORMAT_ERROR, checks, correct, figures, params, part, plane_axis, print};
use crate::check::error;
use crate::control::{Control, Plane};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::entry::stage::{Look, Seen, Staging};
use crate::entry::{
    Chooses, Cycle, Drawing, Help, HelpLine, Inputs, Param, Proposal, Purpose, Simulation, Task, Unit, Variant, When,
    Work, address, before, corrects, measures, order, wrong,
};
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};
use crate::message::Message;
use crate::picture::PictureShape;
use crate::workpiece::{Shape, Workpiece};

/// The stylus stands between the walls.
pub const POCKET: i64 = 0;
/// The stylus stands above; the address of the tool axis says how deep to measure.
pub const WEB: i64 = 1;

/// One of X, Y, Z.
const AXIS: Param =
    Param { key: "g109-width", unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), source: "C:907-911", ..PARAM };

const fn web_in(plane: Plane) -> Chooses {
    Chooses { when: When::Plane(plane), variant: WEB, typed: "0" }
}

/// The macro.
pub static G109: Cycle = Cycle {
    dialect: Dialect::Nct,
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
    lists: &[],
    settings: &[],
    params: &[
        Param {
            name: address::X,
            needs: &needs(Plane::G19),
            chooses: &[web_in(Plane::G19)],
            labels: &[(When::Plane(Plane::G19), "g109-depth")],
            ..AXIS
        },
        Param {
            name: address::Y,
            needs: &needs(Plane::G18),
            chooses: &[web_in(Plane::G18)],
            labels: &[(When::Plane(Plane::G18), "g109-depth")],
            ..AXIS
        },
        Param {
            name: address::Z,
            needs: &needs(Plane::G17),
            chooses: &[web_in(Plane::G17)],
            labels: &[(When::Plane(Plane::G17), "g109-depth")],
            ..AXIS
        },
        Param { needs: &[optional(When::Variant(&[WEB]), "need-nct-optional")], source: "C:912", ..params::R },
        Param { source: "C:913", ..params::Q },
        Param { source: "C:914", ..params::S },
        Param { key: "nct-t-size", source: "C:933", ..params::T },
        Param { source: "C:927", ..params::M },
        Param { source: "C:934", ..params::H },
        Param { source: "C:935", ..params::U },
        Param { source: "C:936", ..params::V },
        Param { source: "C:937", ..params::W },
    ],
    results: &[
        params::length("WIDTH", "result-g109-width", "C:868-887"),
        params::length("DEVIATION", "result-g109-deviation", "C:868-887"),
        params::length("CENTRE", "result-g109-centre", "C:868-887"),
        params::length("SHIFT", "result-g109-shift", "C:868-887"),
    ],
    alarms: &[
        nct::MEASURING,
        &[
            nct::PATH_OBSTRUCTED, // the ways beside a web are protected like those of G101
            nct::OUT_OF_TOLERANCE,
            nct::UPPER_TOLERANCE,
            nct::TOOL_TOO_LARGE,
        ],
    ],
    checks,
    help: Help::new(&[HELP, nct::help::MEASURING, nct::help::SHIFTS]),
    picture: Drawing::staged(stage, marks),
    example: &[(address::X, "80"), (address::S, "1"), (address::H, "0.02"), (address::V, "2"), (address::W, "2")],
    simulation: Some(Simulation::new(Work { propose, simulate }, &[])),
    source: "C:868-1028",
};

fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    plane_axis::check(inputs, control, findings);
    checks::corrections(inputs, findings);
    let (name, width) = nominal(inputs);
    if index(inputs).is_some() && width <= 0.0 {
        let message = Message::new("g109-no-width");
        let hint = Message::new("g109-no-width-hint");
        findings.push(error(FORMAT_ERROR, message).hint(hint).at(name));
    } else if inputs.variant == POCKET {
        checks::room(inputs, name, control, findings);
    }
}

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let index = index(inputs).unwrap_or(0);
    let walls = walls(machine, inputs);
    let axis = walls.axes[index];
    let found = chord(machine, &walls, index)?;
    home(machine, Wcs(walls.start))?;
    let width = 2.0 * (found.half - walls.material() * found.ball);
    let deviation = width - walls.size;
    let along = found.middle - walls.start[axis];
    correct::results(
        machine,
        &[("WIDTH", width), ("DEVIATION", deviation), ("CENTRE", found.middle), ("SHIFT", along)],
    );
    let excess = walls.material() * deviation; // metal on is positive (C:927-931)
    let mut shift = [None; 3];
    shift[axis] = Some(along);
    let found = Found {
        deviation,
        excess,
        at_surface: excess / 2.0,
        shift,
        part: Part::Radius,
        room: walls.outside.is_none().then_some(walls.size),
    };
    correct::correct(machine, inputs, &found);
    let values =
        print::Values { dimension: Some((walls.size, deviation)), positions: vec![("", walls.start[axis], along)] };
    print::print(machine, inputs, &values);
    Ok(())
}

fn walls(machine: &mut dyn Machine, inputs: &Inputs) -> Walls {
    let (_, depth) = depth(inputs);
    Walls {
        outside: depth.map(|depth| Outside { depth, clearance: inputs.number(address::R) }),
        size: nominal(inputs).1,
        overtravel: inputs.number(address::Q),
        start: machine.position().0,
        axes: machine.control().plane.axes(),
    }
}

/// A pocket whose upper face is the zero of the WCS, the stylus inside; or a web, the stylus above.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let [.., applicate] = control.plane.axes();
    let width = Some(nominal(inputs).1).filter(|width| *width > 0.0);
    let mut length = [100.0; 2];
    length[index(inputs).unwrap_or(0)] = width.unwrap_or(80.0);
    let (mut top, mut start) = ([0.0; 3], [0.0; 3]);
    let shape = match depth(inputs) {
        (_, Some(depth)) => {
            top[applicate] = (depth + 10.0).max(0.0);
            start[applicate] = top[applicate] + 20.0;
            let height = top[applicate] - depth + 20.0;
            Shape::Island { length, height }
        }
        _ => {
            start[applicate] = -10.0;
            Shape::Pocket { length, depth: 30.0 }
        }
    };
    Proposal {
        workpiece: Workpiece { solids: vec![part::in_plane(shape, top, control)] },
        start: Wcs(start),
        ..Proposal::default()
    }
}

/// Depth at which a drawn web is touched, mm.
const DEPTH: f64 = -30.0;

/// The walls from the side: the measured axis to the right, the tool axis up.
fn stage(inputs: &Inputs) -> Staging {
    let look = Look::section(index(inputs).unwrap_or(0)).ways(address::R);
    let stage = figures::stage(inputs, look, &[]).sized(inputs, &[nominal(inputs).0]);
    match depth(inputs) {
        (axial, Some(_)) => stage.with(axial, DEPTH),
        _ => stage,
    }
}

/// Width, depth and limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen] = looks else {
        return Vec::new();
    };
    let mut shapes = figures::limits(inputs, seen);
    shapes.push(seen.size(nominal(inputs).0, 0));
    if let (axial, Some(_)) = depth(inputs) {
        shapes.extend(seen.depth(axial));
    }
    shapes
}

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Variant(&[POCKET]), "help-g109-measures-pocket", "C:887-911"),
    measures(When::Variant(&[WEB]), "help-g109-measures-web", "C:887-911"),
    before(When::Variant(&[POCKET]), "help-g109-before-inside", "C:887-911"),
    before(When::Variant(&[WEB]), "help-g109-before-above", "C:887-911"),
    order(When::Variant(&[POCKET]), "help-g109-order-outwards", "C:887-999"),
    order(When::Variant(&[WEB]), "help-g109-order-inwards", "C:887-999"),
    corrects(When::Always, "help-g109-corrects-half", "C:925-960"),
    wrong(When::Always, "help-g109-wrong-width", "C:887-911"),
];
