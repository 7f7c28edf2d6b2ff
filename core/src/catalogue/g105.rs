//! G105: surface across one axis of the plane (C:430-560).

use super::common::PARAM;
use super::nct;
use super::nct::correct::{Found, Part};
use super::nct::plane_axis::{depth, index, needs, nominal};
use super::nct::surface::{Wall, spindle_at, touch_wall};
use super::nct::walls::{home, travel};
use super::nct::{FORMAT_ERROR, checks, correct, figures, params, part, plane_axis, print, surface};
use crate::control::{Control, Plane};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::entry::stage::{Look, Seen, Staging};
use crate::entry::{
    Cycle, Drawing, Help, HelpLine, Inputs, Param, Proposal, Purpose, Simulation, Task, Unit, Variant, When, Work,
    address, before, corrects, measures, order, wrong,
};
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};
use crate::picture::PictureShape;
use crate::workpiece::{Shape, Workpiece};

/// One of X, Y, Z.
const AXIS: Param =
    Param { key: "g105-nominal", unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), source: "C:472-473", ..PARAM };
/// The macro.
pub static G105: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G105",
    key: "g105",
    variants: &[Variant { number: 0, key: "g105-surface", source: "C:450" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::Wall, &[0], 0, nct::tasks::IN_AXIS)], ..Purpose::MILLING },
    lists: &[],
    settings: &[],
    params: &[
        Param {
            name: address::X,
            needs: &needs(Plane::G19),
            labels: &[(When::Plane(Plane::G19), "nct-depth")],
            ..AXIS
        },
        Param {
            name: address::Y,
            needs: &needs(Plane::G18),
            labels: &[(When::Plane(Plane::G18), "nct-depth")],
            ..AXIS
        },
        Param {
            name: address::Z,
            needs: &needs(Plane::G17),
            labels: &[(When::Plane(Plane::G17), "nct-depth")],
            ..AXIS
        },
        Param { source: "C:474", ..params::R },
        Param { source: "C:475", ..params::Q },
        Param { source: "C:481", ..params::S },
        Param { key: "nct-t-surface", source: "C:495", ..params::T },
        Param { source: "C:491", ..params::M },
        Param { source: "C:500", ..params::H },
        Param { source: "C:501", ..params::U },
        Param { source: "C:502", ..params::W },
    ],
    results: &[
        params::length("POSITION", "result-nct-position", "C:430-450"),
        params::length("DEVIATION", "result-nct-position-deviation", "C:430-450"),
    ],
    alarms: &[
        nct::MEASURING,
        &[
            nct::PATH_OBSTRUCTED, // the ways beside the surface are protected like those of G101
            nct::OUT_OF_TOLERANCE,
            nct::UPPER_TOLERANCE,
        ],
    ],
    checks,
    help: Help::new(&[HELP, nct::help::MEASURING, nct::help::SHIFTS]),
    picture: Drawing::staged(stage, marks),
    example: &[(address::X, "50"), (address::Z, "-10"), (address::S, "1"), (address::H, "0.2"), (address::W, "2")],
    simulation: Some(Simulation::new(Work { propose, simulate }, &[])),
    source: "C:430-560",
};

fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    plane_axis::check(inputs, control, findings);
    checks::corrections(inputs, findings);
}

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let index = index(inputs).unwrap_or(0);
    let axes = machine.control().plane.axes();
    let (axis, applicate) = (axes[index], axes[2]);
    let (_, nominal) = nominal(inputs);
    if let (_, Some(depth)) = depth(inputs) {
        let direction = surface::direction(machine, axis, index, nominal)?;
        let contact = spindle_at(machine, index, nominal, direction);
        travel(machine, axis, contact - direction * inputs.number(address::R))?;
        travel(machine, applicate, depth)?;
    }
    let beside = machine.position()[axis];
    let wall = touch_wall(machine, index, nominal, inputs.number(address::Q))?;
    travel(machine, axis, beside)?;
    home(machine, start)?;
    finish(machine, inputs, axis, &wall);
    Ok(())
}

/// Results, corrections, print-out. Metal is left where the surface stands towards the stylus (C:491).
fn finish(machine: &mut dyn Machine, inputs: &Inputs, axis: usize, wall: &Wall) {
    let (_, nominal) = nominal(inputs);
    let deviation = wall.position - nominal;
    let excess = -wall.direction * deviation;
    correct::results(machine, &[("POSITION", wall.position), ("DEVIATION", deviation)]);
    let mut shift = [None; 3];
    shift[axis] = Some(deviation);
    let found = Found { deviation, excess, at_surface: excess, shift, part: Part::Radius, room: None };
    correct::correct(machine, inputs, &found);
    let values = print::Values { dimension: None, positions: vec![("", nominal, deviation)] };
    print::print(machine, inputs, &values);
}

/// A block that reaches from the zero side to the nominal surface, the stylus on the other side: above where a depth is
/// given, else beside it.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let axes = control.plane.axes();
    let (axis, applicate) = (axes[index(inputs).unwrap_or(0)], axes[2]);
    let ((_, nominal), (_, depth)) = (nominal(inputs), depth(inputs));
    let side = 1.0_f64.copysign(nominal);
    let size = [100.0, 100.0, 60.0];
    let (mut top, mut start) = ([0.0; 3], [0.0; 3]);
    top[axis] = nominal - side * size[0] / 2.0;
    top[applicate] = depth.unwrap_or(-10.0) + 10.0;
    start[axis] = nominal + side * 20.0;
    start[applicate] = top[applicate] + if depth.is_some() { 20.0 } else { -10.0 };
    Proposal {
        workpiece: Workpiece { solids: vec![part::in_plane(Shape::Block { size }, top, control)] },
        start: Wcs(start),
        ..Proposal::default()
    }
}

/// From the zero point to the drawn wall, and depth of the touch, mm.
const SET: [f64; 2] = [75.0, -30.0];

/// The wall from the side: the measured axis to the right, the tool axis up.
fn stage(inputs: &Inputs) -> Staging {
    let axis = index(inputs).unwrap_or(0);
    let (name, set) = nominal(inputs);
    let look = Look::section(axis).ways(address::R);
    let stage = figures::stage(inputs, look, &[]).with(name, SET[0].copysign(set));
    match depth(inputs) {
        (axial, Some(_)) => stage.with(axial, SET[1]),
        _ => stage,
    }
}

/// Its coordinate, the depth and the limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen] = looks else {
        return Vec::new();
    };
    let mut shapes = figures::limits(inputs, seen);
    shapes.extend(seen.position(nominal(inputs).0, 0, None));
    if let (axial, Some(_)) = depth(inputs) {
        shapes.extend(seen.depth(axial));
    }
    shapes
}

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Always, "help-g105-measures-surface", "C:450-472"),
    before(When::Always, "help-g105-before-side", "C:472-475"),
    order(When::Always, "help-g105-order-touch", "C:450-475"),
    corrects(When::Always, "help-g105-corrects-radius", "C:484-493"),
    wrong(When::Always, "help-g105-wrong-far", "C:475"),
];
