//! What CYCLE997 refuses to correct, repeats and stops at on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::simulation::{corrected, ready, written};
use crate::catalogue::sinumerik::testing::{alarms, called, stopped};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::machine::{Setup, Sim, Step, Stop};

/// Runs a variant on a machine and a part that were changed.
fn changed(variant: i64, target: f64, change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), Stop>) {
    let mut setup = ready(Plane::G17, variant);
    let mut inputs = corrected(variant, target);
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn a_distorted_triangle_is_not_corrected() {
    // oracle: manual B:8407-8413, A:15933. Hand: the first side is 1 mm too long, half of it at each end; turning
    // cannot help against that, so that each of its ends is half a millimetre off along the side, less what moving in
    // the plane gives: the sum lies between the millimetre that is too much and twice of it.
    let longer = |limit: f64| {
        changed(10_109, 1.0, move |setup, inputs| {
            let [dx, dy] = [160.0, 30.0].map(|way| way / 160.0_f64.hypot(30.0));
            setup.workpiece.solids[1].errors.shift = [dx, dy, 0.0];
            inputs.numbers.insert(names::TNVL, limit);
        })
    };
    let (sim, outcome) = longer(0.9);
    assert_eq!(stopped(outcome), 61414);
    assert_eq!(sim.control.number("_OVI[12]"), 61414.0);
    assert_eq!(sim.control.number("_OVI[11]"), 0.0);
    assert!(written(&sim).is_empty());
    let (sim, outcome) = longer(2.0);
    assert_eq!(outcome, Ok(()));
    assert_eq!(sim.control.number("_OVI[11]"), 1.0);
    assert!(!written(&sim).is_empty());
}

#[test]
fn without_a_target_nothing_is_corrected() {
    // oracle: manual B:8399
    for variant in [109, 10_109] {
        let (sim, outcome) = changed(variant, 0.0, |setup, _| setup.workpiece.solids[0].errors.shift = [0.5; 3]);
        assert_eq!(outcome, Ok(()));
        assert!(written(&sim).is_empty());
        for (name, value) in [
            ("_OVI[0]", 0.0),
            ("_OVI[2]", 997.0),
            ("_OVI[5]", 1.0),
            ("_OVI[9]", 0.0),
            ("_OVI[11]", 0.0),
            ("_OVI[12]", 0.0),
            ("_OVR[28]", 8.0),
        ] {
            assert_eq!(sim.control.number(name), value, "{name}");
        }
    }
}

#[test]
fn every_difference_is_watched_and_the_sphere_repeated() {
    // oracle: manual B:8373-8379, B:13572-13580
    let touches = |sim: &Sim| {
        let steps = sim.trace.entries.iter();
        steps.filter(|entry| matches!(entry.step, Step::Touch { .. })).count()
    };
    for (axis, size, variant, points) in
        [(0, 0.0, 10_109, 10), (1, 0.0, 10_109, 10), (2, 0.0, 10_109, 10), (2, -1.0, 1_010_109, 12)]
    {
        for repeated in [false, true] {
            let (sim, outcome) = changed(variant, 1.0, |setup, inputs| {
                inputs.numbers.insert(names::TSA, 0.8);
                let sphere = &mut setup.workpiece.solids[1].errors;
                if size == 0.0 {
                    sphere.shift[axis] = 1.0;
                }
                sphere.size = size;
                setup.control.set("_CBIT[0]", f64::from(u8::from(repeated)));
                setup.control.set("_CBIT[1]", 1.0);
            });
            assert_eq!(stopped(outcome), 61303);
            // the first sphere once, the second one up to five times, the third one not at all
            let each = points / 2;
            assert_eq!(touches(&sim), if repeated { 6 * each } else { 2 * each }, "{variant}");
            assert_eq!(alarms(&sim).len(), if repeated { 4 } else { 0 });
            assert!(written(&sim).is_empty());
        }
    }
}

#[test]
fn a_mirrored_frame_is_not_turned() {
    // oracle: manual B:8405; the number is ours. One sphere may be measured and only moves the frame
    let mirrored = |variant: i64| {
        changed(variant, 1.0, |setup, _| {
            setup.control.frames.entry(1).or_default().mirror[0] = true;
            setup.control.activate(1);
            setup.workpiece.solids.iter_mut().for_each(|solid| solid.at[0] *= -1.0);
            setup.position[0] *= -1.0;
        })
    };
    let (sim, outcome) = mirrored(10_109);
    assert_eq!(stopped(outcome), 61411);
    assert!(!sim.trace.entries.iter().any(|entry| matches!(entry.step, Step::Motion { .. })));
    assert_eq!(mirrored(109).1, Ok(()));
}

#[test]
fn points_on_no_circle_are_told() {
    // oracle: manual A:15857: the third point lies upon the first one
    let (sim, outcome) = changed(1109, 1.0, |_, inputs| {
        inputs.numbers.insert(names::INCA, 180.0);
    });
    assert_eq!(stopped(outcome), 61316);
    assert_eq!(sim.control.number("_OVI[12]"), 61316.0);
}
