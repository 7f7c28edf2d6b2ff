//! G65 P9969: rectangular digitizing of a free surface (C:1276-1355).

mod addresses;
mod checks;
mod follow;
mod help;
mod picture;
mod simulate;
#[cfg(test)]
mod tests;

use super::nct;
use super::nct::{params, part};
use crate::control::Control;
use crate::dialect::Dialect;
use crate::entry::{
    Cycle, Drawing, Help, Inputs, Proposal, Purpose, ResultField, Simulation, Unit, Variant, Work, address,
};
use crate::geometry::Wcs;
use crate::workpiece::free::Example;
use crate::workpiece::{Shape, Workpiece};
use std::sync::Arc;

/// The macro.
pub static P9969: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G65 P9969",
    key: "p9969",
    variants: &[Variant { number: 0, key: "p9969-rectangle", source: "C:1278" }],
    params: addresses::PARAMS,
    purpose: Purpose::MILLING,
    lists: &[],
    settings: &[],
    results: &[
        count("POINTS", "result-p9969-points"),
        count("LINES", "result-p9969-lines"),
        params::length("LOWEST", "result-p9969-lowest", "C:1262-1266"),
        params::length("HIGHEST", "result-p9969-highest", "C:1262-1266"),
    ],
    alarms: &[&[
        nct::FORMAT_ERROR,
        nct::NO_TOOL_LENGTH,
        nct::OUT_OF_POSITION,
        nct::STYLUS_IN_CONTACT,
        nct::SCANNING_OBSTRUCTED,
        nct::SCANNING_FAIL,
    ]],
    checks: checks::checks,
    help: Help::new(&[help::HELP]),
    picture: Drawing::new(picture::picture),
    example: &[
        (address::X, "60"),
        (address::Y, "40"),
        (address::Z, "-12"),
        (address::J, "8"),
        (address::R, "3"),
        (address::Q, "4"),
        (address::F, "120"),
        (address::S, "1000"),
    ],
    simulation: Some(Simulation::scanning(Work { propose, simulate: simulate::simulate }, &[], follow::scanner)),
    source: "C:1276-1355",
};

const fn count(name: &'static str, key: &'static str) -> ResultField {
    ResultField { unit: Unit::None, ..params::length(name, key, "C:1262-1266") }
}

/// Rim of the proposed surface beside the rectangle, so that the ball is never at an edge, mm.
const RIM: f64 = 8.0;

/// Hills and hollows under a rectangle that begins at the zero of the WCS; the lowest point lies above the deepest
/// position, the stylus above the highest.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let [first, second, axial] = control.plane.axes();
    let end = |axis: usize| inputs.number(nct::axis_name(axis));
    let size = [first, second].map(|axis| end(axis).abs() + 2.0 * RIM);
    let height = (size[0].min(size[1]) / 5.0).min(10.0);
    let (mut middle, mut start) = ([0.0; 3], [0.0; 3]);
    for axis in [first, second] {
        middle[axis] = end(axis) / 2.0;
    }
    middle[axial] = end(axial) + height + 2.0;
    start[axial] = middle[axial] + 5.0;
    let surface = Example::Waves.heights(size, height).surface();
    let solids = surface.map(|surface| part::in_plane(Shape::Free(Arc::new(surface)), middle, control));
    Proposal {
        workpiece: Workpiece {
            solids: solids.into_iter().collect(), // none where the rectangle is larger than anything can be
        },
        start: Wcs(start),
        ..Proposal::default()
    }
}
