//! G103: effective ball radius in four directions (C:282-370).
//!
//! The formula is not printed. The centre is found at four walls first; from it each wall is touched once more, and
//! the radius is half the diameter less the way. D is therefore the exact diameter: the text calls an approximate one
//! enough (C:317), which contradicts the ring of known size (C:288). A stylus that switches later in one direction
//! shows the difference in the radial offset of G102; only offset and radius together are used, and their sum is right
//! in every direction.

use super::nct;
use super::nct::ring::D;
use super::nct::touch::Calibration;
use super::nct::walls::{home, travel};
use super::nct::{correct, ring};
use crate::catalogue::prelude::*;

/// The macro.
pub static G103: Cycle = Cycle {
    name: "G103",
    key: "g103",
    variants: &[Variant { number: 0, key: "g103-radius", source: "C:309" }],
    purpose: Purpose {
        calibrates: When::Always,
        tasks: &[nct::tasks::task(Task::Ball, &[0], 0, &[(address::D, Meaning::Nominal)])],
        ..Purpose::MILLING
    },
    params: &[Param { key: "g103-d", usual: Range::closed(25.0, 1000.0), example: "50", source: "C:317-319", ..D }],
    results: &[
        ring::value("#500", "result-g103-1-plus", "C:304"),
        ring::value("#501", "result-g103-1-minus", "C:305"),
        ring::value("#502", "result-g103-2-plus", "C:306"),
        ring::value("#503", "result-g103-2-minus", "C:307"),
    ],
    help: Help::new(&[
        &[
            measures(When::Always, "help-g103-measures-radius", "C:288-317"),
            before(When::Always, "help-g103-before-ring", "C:288-299"),
            order(When::Always, "help-g103-order-centre", "C:309-345"),
            corrects(When::Always, "help-g103-corrects-radius", "C:309-345"),
            wrong(When::Always, "help-g103-wrong-size", "C:288-317"),
        ],
        nct::help::MEASURING,
        nct::help::ONE_MACRO,
        nct::help::CALIBRATING,
    ]),
    simulation: Some(Simulation::new(ring::propose, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Probe)],
        corrects: &[(When::Always, Corrects::Probe, &[])],
        options: &[(When::Always, "aim-measured", "g103-radius")],
    },
    source: "C:282-370",
    ..ring::CALIBRATION
};

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let [abscissa, ordinate, _] = machine.control().plane.axes();
    let spindle = ring::centre(machine, inputs)?;
    travel(machine, ordinate, spindle[1])?;
    let mut radii = [0.0; 4];
    for (index, axis) in [abscissa, ordinate].into_iter().enumerate() {
        let offset = Calibration::of(machine, index).offset;
        let centre = spindle[index] + offset;
        let [upper, lower] = ring::walls(machine, inputs, axis)?.map(|at| at + offset);
        let radius = inputs.number(address::D) / 2.0;
        radii[2 * index] = radius - (upper - centre);
        radii[2 * index + 1] = radius - (centre - lower);
    }
    home(machine, start)?;
    let names = ["#500", "#501", "#502", "#503"];
    let values: [(&str, f64); 4] = std::array::from_fn(|i| (names[i], radii[i]));
    correct::calibration(machine, &values);
    Ok(())
}
