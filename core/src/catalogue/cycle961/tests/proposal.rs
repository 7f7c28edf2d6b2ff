//! From the proposed start CYCLE961 measures the proposed part, and finds what is wrong with it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::params::POINTS;
use super::super::{CYCLE961, VARIANTS};
use super::bench::{PLANES, close_angle, done};
use crate::catalogue::example::example;
use crate::catalogue::sinumerik::testing::{at, call, close, setup};
use crate::check::check;
use crate::entry::{Inputs, names};
use crate::geometry::Rpy;
use crate::machine::Setup;

#[test]
fn the_proposed_part_is_measured_from_the_proposed_start() {
    // oracle: hand (the part moved by 0.3 and -0.2 mm and turned about the applicate by 2 degree)
    let angles = [[0.0, 90.0], [-35.0, 80.0], [120.0, -60.0], [200.0, 130.0]];
    for (plane, variant, [first, opening]) in PLANES
        .into_iter()
        .flat_map(|plane| [105, 106, 107, 108].map(|variant| (plane, variant)))
        .flat_map(|(plane, variant)| angles.map(|angles| (plane, variant, angles)))
    {
        let opening = if variant <= 106 { 90.0_f64.copysign(opening) } else { opening };
        let mut setup = setup(plane);
        let values = [("_STA1", first), ("_INCA", opening), ("_SETV[0]", 80.0), ("_SETV[1]", 60.0), ("_ID", 20.0)];
        let inputs = call("CYCLE961", variant, &values);
        proposed(&mut setup, &inputs, first);
    }
}

#[test]
fn the_worked_examples_are_measured_from_the_proposed_start() {
    // oracle: hand (as above); a corner by places has its reference edge along the abscissa there (B:8090-8124)
    for plane in PLANES {
        for variant in VARIANTS {
            let mut setup = setup(plane);
            let typed = example(&CYCLE961, variant);
            let inputs = check(&CYCLE961, &typed, &setup.control).inputs.unwrap();
            let edge = if POINTS.holds(&inputs) { 0.0 } else { inputs.degrees(names::STA1).0 };
            proposed(&mut setup, &inputs, edge);
        }
    }
}

fn proposed(setup: &mut Setup, inputs: &Inputs, edge: f64) {
    let proposal = (inputs.cycle.work().unwrap().propose)(inputs, &setup.control);
    let plane = setup.control.plane;
    setup.workpiece = proposal.workpiece;
    setup.position = setup.control.to_machine(proposal.start);
    let solid = &mut setup.workpiece.solids[0];
    solid.errors.shift = at(plane, [0.3, -0.2, 0.0]);
    solid.errors.tilt = Rpy(at(plane, [0.0, 0.0, 2.0]));
    let corner = solid.at;
    let sim = done(setup, inputs);
    close_angle(&sim, "_OVR[4]", edge + 2.0);
    close(&sim, "_OVR[5]", corner[plane.axes()[0]] + 0.3);
    close(&sim, "_OVR[6]", corner[plane.axes()[1]] - 0.2);
}
