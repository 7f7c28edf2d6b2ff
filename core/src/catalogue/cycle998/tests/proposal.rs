//! From the proposed start CYCLE998 measures the proposed part, and finds how it is turned.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::angles::Surface;
use super::simulation::{AXES, ONE, PLANES, TWO, done, inputs};
use crate::catalogue::sinumerik::testing::{close, setup};
use crate::entry::names;

#[test]
fn the_proposed_part_is_measured_from_the_proposed_start() {
    // oracle: hand (the part is turned about the axis of the angle by 1.5 degree)
    for plane in PLANES {
        for (variant, axes) in ONE
            .into_iter()
            .flat_map(|variant| AXES.map(|axes| (variant, axes)))
            .chain(TWO.map(|variant| (variant, 302)))
            .filter(|(variant, axes)| (*variant, axes % 10) != (1105, 3))
        {
            let mut inputs = inputs(variant, axes, [7.0, 0.0]);
            inputs.numbers.extend([(names::SETVAL, 12.0), (names::FA, 8.0), (names::TSA, 3.0)]);
            let mut setup = setup(plane);
            setup.probe.stylus = Some(0.0); // faces lean over here by more than a straight one bears
            let proposal = (inputs.cycle.work().unwrap().propose)(&inputs, &setup.control);
            setup.workpiece = proposal.workpiece;
            setup.position = setup.control.to_machine(proposal.start);
            let third = match variant % 10 {
                5 => Surface::of(&inputs).unwrap().third(),
                _ => 0,
            };
            setup.workpiece.solids[0].errors.tilt[plane.axes()[third]] = 1.5;
            let sim = done(&setup, &inputs);
            close(&sim, "_OVR[4]", 8.5);
            close(&sim, "_OVR[16]", 1.5);
        }
    }
}
