#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! G102, G103 and G104: what the stylus is comes out, in all planes, mm and inch.

use super::axis_name;
use super::bench::{PLANES, TOOL_AXIS, after, call, codes, length, machine, near, put, stand};
use crate::catalogue::g102::{G102, INDEX};
use crate::catalogue::g103::G103;
use crate::catalogue::g104::G104;
use crate::catalogue::nct;
use crate::control::{Plane, Units};
use crate::dialect::Dialect;
use crate::machine::calibrated::ProbeInCall;
use crate::machine::{Setup, Stop};
use crate::workpiece::{Probe, Shape};
use proptest::prelude::*;

const RING: Shape = Shape::Hole { diameter: 50.0, depth: 30.0 };

/// A ring with its upper face at 0 and its centre off the zero; nothing of the stylus is known.
fn ring(plane: Plane, inch: bool, off: [f64; 2]) -> Setup {
    let mut setup = machine(plane, inch);
    put(&mut setup, RING, [0.0; 3], [off[0], off[1], 0.0], 0.0);
    stand(&mut setup, [0.0, 0.0, -10.0]);
    for name in ["#500", "#501", "#502", "#503", "#504", "#505"] {
        setup.control.set(name, 0.0);
    }
    setup
}

/// Carries out a calibration in the ring, which ends where it began.
fn calibrate(cycle: &'static crate::entry::Cycle, diameter: f64, setup: &Setup) -> Setup {
    let outcome = call(cycle, &[("D", &length(setup, diameter))], setup);
    assert_eq!(outcome.stop, None, "{}", cycle.name);
    assert_eq!(outcome.position, setup.position, "{}", cycle.name);
    after(setup, outcome)
}

// oracle: manual C:161-163, C:176-177: the ball stands beside the spindle, whose axis is that of the hole
#[test]
fn a_hole_bored_by_the_spindle_gives_the_offset() {
    for plane in PLANES {
        for not_indexed in [0.0, 1.0] {
            let mut setup = ring(plane, false, [0.0; 2]);
            setup.probe.skew = [0.12, -0.07];
            setup.control.set(INDEX, not_indexed);
            let setup = calibrate(&G102, 48.0, &setup);
            near(setup.control.number("#504"), 0.12);
            near(setup.control.number("#505"), -0.07);
        }
    }
}

// oracle: manual C:74, C:166-168: two positions of the spindle; where the ring stands does not count
#[test]
fn an_indexed_spindle_gives_the_offset_in_any_ring() {
    for plane in PLANES {
        let mut setup = ring(plane, false, [2.5, -1.5]);
        setup.probe.skew = [0.12, -0.07];
        setup.control.set(INDEX, 20.0);
        let spindle = setup.control.spindle;
        let setup = calibrate(&G102, 50.0, &setup);
        near(setup.control.number("#504"), 0.12);
        near(setup.control.number("#505"), -0.07);
        assert_eq!(setup.control.spindle, spindle);
    }
}

// oracle: manual C:161-177, C:304-307, C:369-371: offset, radii and length are found by G102, G103 and G104; hand: a
// probe of which one of them was not found measures wrong
#[test]
fn the_data_fit_the_probe_after_the_last_calibration() {
    for plane in PLANES {
        for inch in [false, true] {
            let fits = |setup: &Setup| setup.calibration_fits(ProbeInCall { field: 1, mono: false, measures: true });
            let real = |setup: Setup| {
                let probe = Probe { radius: 2.97, skew: [0.12, -0.07], pre_travel: (0.01, 0.0), ..setup.probe };
                Setup { probe, ..setup }
            };
            let round = calibrate(&G102, 50.0, &real(ring(plane, inch, [0.0; 2])));
            assert!(!fits(&round));
            let round = calibrate(&G103, 50.0, &round);
            assert!(!fits(&round));
            let mut above = real(block(plane, inch, 0.3));
            above.control.data = round.control.data.clone();
            assert!(fits(&calibrate_length(&above)), "{plane:?} {inch}");
        }
    }
}

// oracle: manual C:187, C:299: within 10 mm of the centre every wall is reached; further off one is not
#[test]
fn the_limit_of_the_search() {
    let stop = |off: f64, diameter: &str| {
        let setup = ring(Plane::G17, false, [off, 0.0]);
        call(&G103, &[("D", diameter)], &setup).stop
    };
    assert_eq!(stop(9.9, "50"), None);
    assert_eq!(stop(0.0, "31"), None);
    assert_eq!(stop(0.0, "20"), Some(Stop::Alarm(nct::PROBE_FAIL)));
}

// oracle: manual C:397-407: T and the tool axis have to be there
#[test]
fn missing_addresses_are_format_errors() {
    assert_eq!(codes(&G102, &[], Plane::G17), [nct::FORMAT_ERROR]);
    assert_eq!(codes(&G103, &[], Plane::G17), [nct::FORMAT_ERROR]);
    for (plane, axis) in TOOL_AXIS {
        assert_eq!(codes(&G104, &[("T", "98")], plane), [nct::FORMAT_ERROR]);
        assert_eq!(codes(&G104, &[(axis, "0")], plane), [nct::FORMAT_ERROR]);
        assert!(codes(&G104, &[(axis, "0"), ("T", "98")], plane).is_empty());
    }
}

/// A block with its face at 20, the stylus above, its length register as wrong as told.
fn block(plane: Plane, inch: bool, wrong: f64) -> Setup {
    let mut setup = machine(plane, inch);
    let size = [100.0, 100.0, 60.0];
    put(&mut setup, Shape::Block { size }, [0.0, 0.0, 20.0], [0.0; 3], 0.0);
    setup.control.edge_made(0, 98).length[0] += wrong;
    stand(&mut setup, [0.0, 0.0, 100.0]);
    setup
}

fn calibrate_length(setup: &Setup) -> Setup {
    let applicate = setup.control.plane.axes()[2];
    let values = [(axis_name(applicate).as_str(), &*length(setup, 20.0)), ("T", "98")];
    let outcome = call(&G104, &values, setup);
    assert_eq!(outcome.stop, None);
    after(setup, outcome)
}

// oracle: manual C:369-371 (±5 mm), C:383-393; hand: 50 mm to the centre of a ball of 6 mm
#[test]
fn the_length_is_found_as_the_part_outside_of_the_spindle() {
    for plane in PLANES {
        for wrong in [-5.0, -0.3, 0.0, 4.9] {
            let setup = block(plane, false, wrong);
            let spindle = |setup: &Setup| {
                let length = setup.control.active_length();
                [0, 1, 2].map(|i| setup.position[i] + length[i])
            };
            let (before, calibrated) = (spindle(&setup), calibrate_length(&setup));
            near(calibrated.control.register(98).length[0], 53.0);
            for (one, other) in before.into_iter().zip(spindle(&calibrated)) {
                near(one, other); // the spindle has not moved, only its place is told anew
            }
        }
    }
}

// oracle: manual C:374-379: the length holds the axial work offset, which then is 0; the same surface has the same
// coordinate, whatever a length is taken to be
#[test]
fn the_length_is_found_as_a_work_offset() {
    for plane in PLANES {
        let mut setup = block(plane, false, 0.0);
        let applicate = plane.axes()[2];
        let offset = setup.control.frames[&1].coarse[applicate];
        let frame = setup.control.frames.get_mut(&1).unwrap();
        frame.coarse[applicate] = 0.0;
        setup.control.activate(1);
        setup.control.edge_made(0, 98).length[0] += offset + 2.0; // 2 mm wrong
        setup.position[applicate] -= offset + 2.0; // the spindle stands where it stood
        let calibrated = calibrate_length(&setup);
        near(calibrated.control.register(98).length[0], 53.0 + offset);
        let again = call(&G104, &[(axis_name(applicate).as_str(), "20"), ("T", "98")], &calibrated);
        near(again.control.number("DEVIATION"), 0.0);
    }
}

// oracle: manual C:391: 10 mm below; inch 0.4 inch (10.16 mm)
#[test]
fn the_surface_is_looked_for_below_its_height() {
    let stop = |inch: bool, wrong: f64| {
        let setup = block(Plane::G17, inch, wrong);
        call(&G104, &[("Z", &length(&setup, 20.0)), ("T", "98")], &setup).stop
    };
    // a register that is too short shows the surface too low
    assert_eq!(stop(false, 9.9), None);
    assert_eq!(stop(false, 10.1), Some(Stop::Alarm(nct::PROBE_FAIL)));
    assert_eq!(stop(true, 10.1), None);
    assert_eq!(stop(true, 10.2), Some(Stop::Alarm(nct::PROBE_FAIL)));
}

// oracle: manual C:92-94: the values stand in the basic system of the machine
#[test]
fn values_stand_in_the_system_of_the_machine() {
    let mut setup = Setup::calibrated_in(Dialect::Nct, Plane::G17, Units::Inch);
    put(&mut setup, RING, [0.0; 3], [0.0; 3], 0.0);
    stand(&mut setup, [0.0, 0.0, -10.0]);
    setup.control.active_units = Units::Metric;
    let setup = calibrate(&G103, 50.0, &setup);
    near(setup.control.number("#500") * 25.4, 3.0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: definition: what the stylus is comes out, wherever the ring stands
    #[test]
    fn the_stylus_is_recovered(
        plane in 0..3_usize, inch: bool, skew in [-0.3..0.3, -0.3..0.3], off in [-6.0..6.0, -6.0..6.0],
        radius in 1.0..4.0, late in 0.0..0.02
    ) {
        let mut setup = ring(PLANES[plane], inch, off);
        setup.probe.skew = skew;
        setup.probe.radius = radius;
        setup.probe.pre_travel = (late, 0.0);
        setup.control.set(INDEX, 20.0);
        let setup = calibrate(&G103, 50.0, &calibrate(&G102, 50.0, &setup));
        let value = |name: &str| setup.control.number(name);
        prop_assert!((value("#504") - skew[0]).abs() < 1e-9, "{}", value("#504"));
        prop_assert!((value("#505") - skew[1]).abs() < 1e-9, "{}", value("#505"));
        for name in ["#500", "#501", "#502", "#503"] {
            prop_assert!((value(name) - radius + late).abs() < 1e-9, "{name} {}", value(name));
        }
    }

    // oracle: definition; the surface then has its coordinate
    #[test]
    fn the_length_is_recovered(
        plane in 0..3_usize, inch: bool, wrong in -5.0..5.0, real in 40.0..60.0, late in 0.0..0.02
    ) {
        let mut setup = block(PLANES[plane], inch, real - 50.0 + wrong);
        setup.probe.length = real;
        setup.probe.pre_travel = (late, 0.0);
        let setup = calibrate_length(&setup);
        let found = setup.control.register(98).length[0];
        prop_assert!((found - (real + 3.0 - late)).abs() < 1e-9, "{found}");
        let again = calibrate_length(&setup);
        prop_assert!(again.control.number("DEVIATION").abs() < 1e-9);
    }
}
