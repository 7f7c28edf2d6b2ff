//! How a workpiece probe was calibrated, in `_WP[k,9]` and `_WP[k,10]`, and whether a measurement goes with it
//! (`_CBIT[16]`, B:13658-13667). The manual does not tell the code (B:13451-13452); this one is ours: the number of the
//! plane, 100 more for a mono probe; 1 where L1 ends at the centre of the ball, 2 at its circumference; 0 unknown.

use crate::catalogue::common::MONO;
use crate::catalogue::prelude::*;

/// Notes in the data field of the probe how a call calibrates it.
pub fn note(machine: &mut dyn Machine, inputs: &Inputs) {
    for (name, code) in fields(inputs).into_iter().zip(codes(machine.control(), inputs)) {
        results::set(machine, &name, code);
    }
}

/// Whether plane, type of probe or reference of the length differ from what was noted at calibration.
pub fn differs(control: &Control, inputs: &Inputs) -> bool {
    let noted = fields(inputs).map(|name| control.number(&name));
    control.bit("_CBIT[16]")
        && noted.into_iter().zip(codes(control, inputs)).any(|(noted, code)| noted != 0.0 && noted != code)
}

fn fields(inputs: &Inputs) -> [String; 2] {
    let probe = inputs.integer(names::PRNUM) % 100 - 1;
    [9, 10].map(|field| format!("_WP[{probe},{field}]"))
}

fn codes(control: &Control, inputs: &Inputs) -> [f64; 2] {
    let plane = match control.plane {
        Plane::G17 => 17.0,
        Plane::G18 => 18.0,
        Plane::G19 => 19.0,
    };
    // the switch is of the milling cycles (B:13561, B:13650)
    let milling = inputs.cycle.purpose.machine != MachineSort::Turning;
    let reference = if milling && control.bit("_CBIT[14]") { 2.0 } else { 1.0 };
    [plane + if MONO.holds(inputs) { 100.0 } else { 0.0 }, reference]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

    use super::*;
    use crate::catalogue::sinumerik::testing::{call, setup};
    use crate::machine::sim::Sim;

    #[test]
    fn another_plane_type_or_reference_is_noticed() {
        // oracle: manual B:13663-13666
        let call = |probe: f64| call("CYCLE977", 1, &[("_PRNUM", probe)]);
        let with = |plane: Plane, probe: f64, bits: [f64; 2]| {
            let mut sim = Sim::new(&setup(Plane::G17));
            note(&mut sim, &call(1.0));
            sim.control.plane = plane;
            sim.control.set("_CBIT[14]", bits[0]);
            sim.control.set("_CBIT[16]", bits[1]);
            differs(&sim.control, &call(probe))
        };
        assert!(!with(Plane::G17, 1.0, [0.0, 1.0]));
        assert!(with(Plane::G18, 1.0, [0.0, 1.0]));
        assert!(with(Plane::G17, 101.0, [0.0, 1.0]));
        assert!(with(Plane::G17, 1.0, [1.0, 1.0]));
        assert!(!with(Plane::G18, 101.0, [1.0, 0.0]));
        // nothing was noted about the second probe
        assert!(!with(Plane::G18, 2.0, [0.0, 1.0]));
    }

    #[test]
    fn a_turning_machine_does_not_look_at_the_reference_of_milling() {
        // oracle: manual B:13561 (in milling measuring cycles)
        let inputs = call("CYCLE974", 0, &[("_PRNUM", 1.0)]);
        let mut sim = Sim::new(&setup(Plane::G18));
        note(&mut sim, &inputs);
        sim.control.set("_CBIT[14]", 1.0);
        assert!(!differs(&sim.control, &inputs));
    }
}
