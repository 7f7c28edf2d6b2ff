//! CYCLE971 finds where the probe is.

#![allow(clippy::unwrap_used)]

use super::bench::{PLANES, call, displace, measured, name, place, random, setup, side};
use crate::catalogue::sinumerik::testing::{called, close, stopped};
use crate::control::Plane;
use crate::workpiece::Noise;

/// Type of a disc that stands in this plane (B:13366).
fn disc_in(plane: Plane) -> f64 {
    match plane {
        Plane::G17 => 101.0,
        Plane::G18 => 201.0,
        Plane::G19 => 301.0,
    }
}

#[test]
fn calibration_finds_a_displaced_probe() {
    // oracle: hand: the sides are where the errors of the solid have moved them
    let mut noise = Noise::new(971);
    for plane in PLANES {
        let axes = plane.axes();
        for (number, along, disc) in [
            (1.0, 0, false),
            (2.0, 1, false),
            (3.0, 2, true),
            (103.0, 2, false),
            (203.0, 2, false),
            (102.0, 1, true),
            (201.0, 0, true),
        ] {
            for plus in [false, true] {
                if plus && along == 2 {
                    continue;
                }
                let shift = [(); 3].map(|()| random(&mut noise));
                let size = if along == 2 { 0.0 } else { random(&mut noise) };
                let inputs = call(0, plane, &[("_MA", number)]);
                let mut setup = setup(&inputs);
                if disc {
                    setup.control.set("_TP[0,8]", disc_in(plane));
                    let position = setup.position;
                    setup = place(setup, &inputs);
                    setup.position = position;
                }
                displace(&mut setup, shift, size);
                if plus {
                    setup.position[axes[along]] -= 100.0;
                }
                let sim = measured(&setup, &inputs);
                let found = side(&setup, "_TP", axes[along], plus, shift, size);
                let what = name("_TP", axes[along], plus);
                close(&sim, &what, found);
                let result = 8 + 4 * axes[along] + 2 * usize::from(plus);
                close(&sim, &format!("_OVR[{result}]"), found);
                let difference = found - setup.control.number(&what);
                close(&sim, &format!("_OVR[{}]", result + 1), difference);
            }
        }
    }
}

#[test]
fn automatic_calibration_finds_all_sides_that_may_be_touched() {
    // oracle: hand; manual B:4686-4743 (a digit for each geometry axis: 1 minus, 2 plus, 3 both)
    let shift = [0.31, -0.27, 0.12];
    for plane in PLANES {
        for (array, variant) in [("_TP", 100_000), ("_TPW", 100_010)] {
            for digits in [333.0, 133.0, 311.0, 113.0, 331.0] {
                let inputs = call(variant, plane, &[]);
                let mut setup = setup(&inputs);
                setup.control.set(format!("{array}[0,7]"), digits);
                let allowed = |axis: usize, plus: bool| {
                    let digit = (digits as i64) / 10_i64.pow(axis as u32) % 10;
                    digit & if plus { 2 } else { 1 } != 0 && !(plus && axis == plane.axes()[2])
                };
                displace(&mut setup, shift, 0.0);
                let sim = measured(&setup, &inputs);
                for axis in 0..3 {
                    for plus in [false, true] {
                        let found = side(&setup, array, axis, plus, shift, 0.0);
                        let what = name(array, axis, plus);
                        let before = setup.control.number(&what);
                        close(&sim, &what, if allowed(axis, plus) { found } else { before });
                    }
                }
            }
        }
    }
}

#[test]
fn incremental_calibration_takes_what_it_finds() {
    // oracle: hand; manual B:4432 (no limits), B:4587 (nothing but the measuring block)
    let shift = [2.3, -1.7, 0.4];
    for plane in PLANES {
        for (variant, array) in [(10_000, "_TP"), (10_010, "_TPW")] {
            for (number, path) in [(1.0, -3.0), (1.0, 3.0), (2.0, -3.0), (2.0, 3.0), (3.0, -3.0)] {
                let inputs = call(variant, plane, &[("_MA", number), ("_FA", path), ("_TSA", 0.1)]);
                let mut setup = setup(&inputs);
                displace(&mut setup, shift, 0.0);
                let axis = plane.axes()[number as usize - 1];
                let plus = path > 0.0;
                let sim = measured(&setup, &inputs);
                close(&sim, &name(array, axis, plus), side(&setup, array, axis, plus, shift, 0.0));
                assert_eq!(sim.position, setup.position);
            }
        }
    }
}

#[test]
fn calibration_keeps_small_differences_and_stops_at_large_ones() {
    // oracle: manual B:4326, B:4515
    for (shift, stored, alarm) in
        [(0.005, 0.0, None), (0.006, 0.006, None), (2.0, 2.0, None), (2.001, 0.0, Some(61303))]
    {
        let inputs = call(0, Plane::G17, &[("_MA", 1.0), ("_TZL", 0.005)]);
        let mut setup = setup(&inputs);
        displace(&mut setup, [shift, 0.0, 0.0], 0.0);
        let (sim, outcome) = called(&setup, &inputs);
        close(&sim, "_TP[0,0]", 50.0 + stored);
        close(&sim, "_OVR[9]", shift);
        match alarm {
            Some(number) => assert_eq!(stopped(outcome), number),
            None => assert_eq!(outcome, Ok(())),
        }
    }
}
