//! G102: radial offset of the stylus (C:150-278).
//!
//! Signs are not printed. The offset is ball centre minus spindle axis, so that every macro adds it to a coordinate of
//! the spindle. Where the spindle cannot be indexed the start is the axis of the hole, which the spindle itself has
//! just bored: offset = start − middle of the contacts. Otherwise the middle is found at both positions of the spindle,
//! and half of the difference is the offset, wherever the ring stands.

use super::nct;
use super::nct::ring::D;
use super::nct::walls::home;
use super::nct::{correct, ring};
use crate::catalogue::prelude::*;

/// The M function that turns the spindle by 180 degree. Where it cannot be indexed, the manual says 1 in one place
/// (C:74) and 0 in another (C:156): both are no M functions that turn a spindle.
pub const INDEX: &str = "#510";

/// The macro.
pub static G102: Cycle = Cycle {
    name: "G102",
    key: "g102",
    variants: &[Variant { number: 0, key: "g102-offset", source: "C:179" }],
    purpose: Purpose { calibrates: When::Always, ..Purpose::MILLING },
    params: &[Param { key: "g102-d", usual: Range::closed(20.0, 1000.0), example: "25", source: "C:187-189", ..D }],
    results: &[ring::value("#504", "result-g102-1", "C:176"), ring::value("#505", "result-g102-2", "C:177")],
    help: Help::new(&[
        &[
            measures(When::Always, "help-g102-measures-offset", "C:150-168"),
            before(When::Always, "help-g102-before-ring", "C:156-187"),
            order(When::Always, "help-g102-order-walls", "C:161-187"),
            corrects(When::Always, "help-g102-corrects-offset", "C:161-168"),
            wrong(When::Always, "help-g102-wrong-moved", "C:156-168"),
        ],
        nct::help::MEASURING,
        nct::help::ONE_MACRO,
        nct::help::CALIBRATING,
    ]),
    simulation: Some(Simulation::new(ring::propose, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Probe)],
        corrects: &[(When::Always, Corrects::Probe, &[])],
        options: &[(When::Always, "aim-measured", "g102-offset")],
    },
    source: "C:150-278",
    ..ring::CALIBRATION
};

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let [abscissa, ordinate, _] = machine.control().plane.axes();
    let first = centre(machine, inputs, start.0)?;
    let indexed = ![0.0, 1.0].contains(&machine.control().number(INDEX));
    let offset = if indexed {
        turn(machine);
        let second = centre(machine, inputs, start.0)?;
        turn(machine);
        [0, 1].map(|i| (second[i] - first[i]) / 2.0)
    } else {
        machine.record(Step::Decision { message: Message::new("decision-g102-hole") });
        [start[abscissa] - first[0], start[ordinate] - first[1]]
    };
    correct::calibration(machine, &[("#504", offset[0]), ("#505", offset[1])]);
    Ok(())
}

/// Where the spindle stands with the ball in the middle of the ring; then back to the start.
fn centre(machine: &mut dyn Machine, inputs: &Inputs, start: [f64; 3]) -> Result<[f64; 2], Stop> {
    let centre = ring::centre(machine, inputs)?;
    home(machine, Wcs(start))?;
    Ok(centre)
}

fn turn(machine: &mut dyn Machine) {
    let angle = machine.control().spindle;
    machine.orient((angle + Degrees(180.0)).positive());
}
