//! How a workpiece probe was calibrated, in `_WP[k,9]` and `_WP[k,10]`, and whether a measurement goes with it
//! (`_CBIT[16]`, B:13658-13667). The manual does not tell the code (B:13451-13452); this one is ours: the number of the
//! plane, 100 more for a mono probe; 1 where L1 ends at the centre of the ball, 2 at its circumference; 0 unknown.

use crate::catalogue::common::MONO;
use crate::catalogue::prelude::*;

/// How a probe is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Used {
    /// Number of its data field, from 1.
    pub field: i64,
    /// Whether it is a mono probe.
    pub mono: bool,
    /// Whether `_CBIT[14]` counts: the switch is of the milling cycles (B:13561, B:13650).
    pub milling: bool,
}

impl Used {
    /// As a call uses it.
    fn by(inputs: &Inputs) -> Used {
        Used {
            field: inputs.integer(names::PRNUM) % 100,
            mono: MONO.holds(inputs),
            milling: inputs.cycle.purpose.machine != MachineSort::Turning,
        }
    }

    /// The data in which is noted how it was calibrated, and the codes of its use.
    pub fn noted(self, control: &Control) -> [(String, f64); 2] {
        let plane = f64::from(control.plane.code());
        let reference = if self.milling && control.bit("_CBIT[14]") { 2.0 } else { 1.0 };
        let datum = |place: usize| format!("_WP[{},{place}]", self.field - 1);
        [(datum(9), plane + if self.mono { 100.0 } else { 0.0 }), (datum(10), reference)]
    }

    /// Whether plane, type of probe or reference of the length differ from what was noted at calibration.
    pub fn differs(self, control: &Control) -> bool {
        let mut known = self.noted(control).into_iter().map(|(name, code)| (control.number(&name), code));
        known.any(|(noted, code)| noted != 0.0 && noted != code)
    }
}

/// Notes in the data field of the probe how a call calibrates it.
pub fn note(machine: &mut dyn Machine, inputs: &Inputs) {
    for (name, code) in Used::by(inputs).noted(machine.control()) {
        results::set(machine, &name, code);
    }
}

/// Whether a call uses the probe otherwise than it was calibrated, where that is watched (`_CBIT[16]`).
pub fn differs(control: &Control, inputs: &Inputs) -> bool {
    control.bit("_CBIT[16]") && Used::by(inputs).differs(control)
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
