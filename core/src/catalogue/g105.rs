//! G105: surface across one axis of the plane (C:430-560).

use super::nct;
use super::nct::correct::Place;
use super::nct::params::{ALONG_X, ALONG_Y, ALONG_Z};
use super::nct::plane_axis::{X, Y, Z, depth_mark, index, nominal};
use super::nct::walls::{home, travel};
use super::nct::{axis_of, checks, correct, figures, given, params, part, plane_axis, surface};
use crate::catalogue::prelude::*;

/// A nominal coordinate.
const NOMINAL: &str = "g105-nominal";
/// How deep the surface is touched.
const DEPTH: &str = "nct-depth";

/// The macro.
pub static G105: Cycle = Cycle {
    name: "G105",
    key: "g105",
    variants: &[Variant { number: 0, key: "g105-surface", source: "C:450" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::Wall, &[0], 0, nct::tasks::IN_AXIS)], ..Purpose::MILLING },
    params: &[
        Param { key: NOMINAL, labels: &[(ALONG_X, DEPTH)], example: "50", source: "C:472-473", ..X },
        Param { key: NOMINAL, labels: &[(ALONG_Y, DEPTH)], source: "C:472-473", ..Y },
        Param { key: NOMINAL, labels: &[(ALONG_Z, DEPTH)], example: "-10", source: "C:472-473", ..Z },
        Param { source: "C:474", ..params::R },
        Param { source: "C:475", ..params::Q },
        Param { example: "1", source: "C:481", ..params::S },
        Param { key: "nct-t-surface", source: "C:495", ..params::T },
        Param { source: "C:491", ..params::M },
        Param { example: "0.2", source: "C:500", ..params::H },
        Param { source: "C:501", ..params::U },
        Param { example: "2", source: "C:502", ..params::W },
    ],
    results: &[
        params::length("POSITION", "result-nct-position", "C:430-450"),
        params::length("DEVIATION", "result-nct-position-deviation", "C:430-450"),
    ],
    alarms: &[nct::MEASURING, nct::PROTECTED, nct::LIMITS],
    checks,
    help: Help::new(&[
        &[
            measures(When::Always, "help-g105-measures-surface", "C:450-472"),
            before(When::Always, "help-g105-before-side", "C:472-475"),
            order(When::Always, "help-g105-order-touch", "C:450-475"),
            corrects(When::Always, "help-g105-corrects-radius", "C:484-493"),
            wrong(When::Always, "help-g105-wrong-far", "C:475"),
        ],
        nct::help::MEASURING,
        nct::help::ONE_MACRO,
        nct::help::SHIFTS,
    ]),
    picture: Drawing::staged(stage, marks),
    simulation: Some(Simulation::new(propose, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Edge)],
        corrects: nct::CORRECTED,
        options: &[(When::Always, "aim-across", "aim-across-plane")],
    },
    source: "C:430-560",
    ..nct::MACRO
};

fn checks(inputs: &Inputs, _: &Control, findings: &mut Vec<Diagnostic>) {
    plane_axis::check(inputs, findings);
    checks::corrections(inputs, findings);
}

/// Metal is left where the surface stands towards the stylus (C:491).
fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let index = index(inputs);
    let axes = machine.control().plane.axes();
    let (axis, applicate) = (axes[index], axes[2]);
    let (_, nominal) = nominal(inputs);
    if let Some(depth) = given(inputs, 2) {
        let direction = surface::direction(machine, axis, index, nominal)?;
        let contact = surface::spindle_at(machine, index, nominal, direction);
        travel(machine, axis, contact - direction * inputs.number(address::R))?;
        travel(machine, applicate, depth)?;
    }
    let beside = machine.position()[axis];
    let (wall, direction) = surface::touch_wall(machine, index, nominal, inputs.number(address::Q))?;
    travel(machine, axis, beside)?;
    home(machine, start)?;
    let place = Place { axis, nominal, deviation: wall - nominal };
    surface::corrected(machine, inputs, place, -direction, correct::RADIUS);
    Ok(())
}

/// A block that reaches from the zero side to the nominal surface, the stylus on the other side: above where a depth is
/// given, else beside it.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ((_, nominal), depth) = (nominal(inputs), given(inputs, 2));
    let side = 1.0_f64.copysign(nominal);
    let size = [100.0, 100.0, 60.0];
    let height = depth.unwrap_or(-10.0) + 10.0;
    let (mut top, mut start) = ([0.0, 0.0, height], [0.0, 0.0, height + if depth.is_some() { 20.0 } else { -10.0 }]);
    top[index(inputs)] = nominal - side * size[0] / 2.0;
    start[index(inputs)] = nominal + side * 20.0;
    part::propose(Shape::Block { size }, top, start, control)
}

/// From the zero point to the drawn wall, and depth of the touch, mm.
const SET: [f64; 2] = [75.0, -30.0];

/// The wall from the side: the measured axis to the right, the tool axis up.
fn stage(inputs: &Inputs) -> Staging {
    let (name, set) = nominal(inputs);
    let look = Look::section(index(inputs)).ways(address::R);
    let stage = figures::stage(inputs, look, &[]).with(name, SET[0].copysign(set));
    if given(inputs, 2).is_some() { stage.with(axis_of(inputs, 2), SET[1]) } else { stage }
}

/// Coordinate of the wall, depth and limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let position = |seen: &Seen| seen.position(nominal(inputs).0, 0, None);
    let all = |seen: &Seen| [figures::limits(inputs, seen), position(seen), depth_mark(inputs, seen)].concat();
    looks.iter().flat_map(all).collect()
}
