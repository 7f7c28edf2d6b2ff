//! The ways of CYCLE982: in which order, to where, and how the milling spindle stands.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::machine::{Real, inputs, machine, mount, place};
use crate::control::Units;
use crate::entry::Inputs;
use crate::machine::{MotionKind, Setup, Sim, Step};

/// Motions and turns as words: `x400` goes there in machine coordinates, `[x380]` measures until there and returns,
/// `s195` turns the spindle.
fn words(sim: &Sim) -> String {
    let mut words = Vec::new();
    for entry in &sim.trace.entries {
        match &entry.step {
            Step::Motion { kind, from, to, .. } => {
                let moved = (0..3).filter(|axis| (from[*axis] - to[*axis]).abs() > 1e-9);
                let moved: Vec<usize> = moved.collect();
                assert!(moved.len() <= 1, "one axis after the other");
                let Some(axis) = moved.first() else { continue };
                let value = format!("{:.4}", to[*axis]);
                let value = value.trim_end_matches('0').trim_end_matches('.');
                let word = format!("{}{value}", ["x", "y", "z"][*axis]);
                match kind {
                    MotionKind::Measuring => words.push(format!("[{word}]")),
                    MotionKind::Retract => {}
                    _ => words.push(word),
                }
            }
            Step::Orient { angle } => words.push(format!("s{}", angle.0)),
            _ => {}
        }
    }
    words.join(" ")
}

/// What a call does.
fn way(setup: &Setup, inputs: &Inputs) -> String {
    let mut sim = Sim::new(setup);
    let outcome = crate::catalogue::cycle982::simulate::simulate(&mut sim, inputs);
    assert_eq!(outcome, Ok(()), "{}", inputs.variant);
    words(&sim)
}

const NOSE: Real = Real { length: [100.0, 60.0], radius: 2.0 };
const MILL: Real = Real { length: [60.0, 50.0], radius: 14.0 };

/// A turning tool with this cutting edge position at abscissa and ordinate.
fn turning(position: i64, start: [f64; 2], variant: i64, axis: f64) -> String {
    let mut setup = machine(Units::Metric);
    mount(&mut setup, NOSE.believed(500, position, [0.0; 3]), NOSE.nose(position));
    place(&mut setup, start);
    let inputs = inputs(&setup, variant, &[("_MA", axis), ("_MD", 1.0)]);
    way(&setup, &inputs)
}

/// A mill along the abscissa or ordinate, with its upper edge where one is measured.
fn milling(start: [f64; 2], variant: i64, axis: f64, prepare: impl Fn(&mut Setup)) -> String {
    let along = usize::from(variant / 10_000 % 10 == 1);
    let upper = variant / 1000 % 10 > 2;
    let mut setup = machine(Units::Metric);
    let real = MILL.cutter(along, if upper { 4.0 } else { 0.0 });
    mount(&mut setup, MILL.believed(120, 0, [0.0; 3]), real);
    place(&mut setup, start);
    prepare(&mut setup);
    let values = [("_MA", axis), ("_MD", 1.0), ("_STA1", 15.0), ("_CORA", 5.0)];
    let inputs = inputs(&setup, variant, &values);
    way(&setup, &inputs)
}

#[test]
fn the_calibration_tool_stands_over_the_middle() {
    // oracle: manual B:8870, B:9441 (tip at the middle minus the radius, _FA before the side, in plus direction 2R
    // more)
    for (start, axis, wanted) in [
        ([250.0, 430.0], 2.0, "z208 x406 [x400]"),
        ([250.0, 430.0], 1.0, "x388 z226 [z220]"),
        ([250.0, 350.0], 2.0, "z208 x370 [x376]"),
        ([170.0, 430.0], 1.0, "x388 z190 [z196]"),
    ] {
        assert_eq!(turning(3, start, 0, axis), wanted);
    }
}

#[test]
fn a_turning_tool_touches_with_its_tip() {
    // oracle: manual B:9073-9081, B:9738-9746, B:9702 (nose over the middle; abscissa first, and back to the start)
    for (position, start, variant, axis, wanted) in [
        (3, [250.0, 430.0], 1, 2.0, "z208 x406 [x400]"),
        (3, [250.0, 430.0], 1, 1.0, "x388 z226 [z220]"),
        (1, [170.0, 350.0], 1, 2.0, "z212 x374 [x380]"),
        (2, [250.0, 350.0], 1, 1.0, "x392 z226 [z220]"),
        (4, [170.0, 430.0], 1, 1.0, "x388 z194 [z200]"),
        (5, [170.0, 430.0], 2, 1.0, "x390 z194 [z200] z170 x430"),
        (6, [250.0, 350.0], 2, 1.0, "z210 x374 [x380] z250 x350"),
        (7, [250.0, 430.0], 2, 1.0, "x390 z226 [z220] z250 x430"),
        (8, [250.0, 430.0], 2, 1.0, "z210 x406 [x400] z250 x430"),
        (3, [250.0, 430.0], 2, 1.0, "x388 z226 [z220] x406 z208 [x400] z250 x430"),
    ] {
        assert_eq!(turning(position, start, variant, axis), wanted, "{position} {variant}");
    }
}

#[test]
fn in_increments_nothing_but_the_measuring_motion_is_travelled() {
    // oracle: manual B:9820-9825, B:9879: back at the start
    let mut setup = machine(Units::Metric);
    mount(&mut setup, NOSE.believed(500, 3, [0.0; 3]), NOSE.nose(3));
    place(&mut setup, [208.0, 406.0]);
    for variant in [100_000, 100_001] {
        let inputs = inputs(&setup, variant, &[("_MA", 2.0), ("_MD", 1.0)]);
        let mut sim = Sim::new(&setup);
        crate::catalogue::cycle982::simulate::simulate(&mut sim, &inputs).unwrap();
        let motions = sim.trace.entries.iter();
        let motions = motions.filter(|entry| matches!(entry.step, Step::Motion { .. }));
        assert_eq!(motions.count(), 2, "{variant}");
        assert!((sim.position[0] - 406.0).abs() < 1e-9);
    }
}

#[test]
fn a_mill_is_measured_from_its_sides() {
    // oracle: manual B:9578-9582, B:9590, B:9642-9644; the ways round the probe are ours
    for (start, variant, axis, wanted) in [
        ([250.0, 440.0], 1, 1.0, "s15 x404 z226 [z220]"),
        ([250.0, 340.0], 1, 1.0, "s15 x376 z226 [z220]"),
        ([250.0, 440.0], 1, 2.0, "z210 s15 x420 [x414]"),
        ([250.0, 440.0], 101, 1.0, "x404 s15 z226 [z220] s200 [z220]"),
        ([250.0, 440.0], 1001, 2.0, "z210 s15 x420 [x414]"),
        ([250.0, 440.0], 2001, 2.0, "z210 s15 x420 [x414] z250 x360 z210 s195 [x366]"),
        ([250.0, 440.0], 2101, 2.0, "z210 s15 x420 [x414] s200 [x414] z250 x360 z210 s15 [x366] s200 [x366]"),
        ([255.0, 430.0], 12_001, 1.0, "x390 s15 z240 [z234] x430 z180 x390 s195 [z186]"),
    ] {
        let found = milling(start, variant, axis, |_| ());
        assert_eq!(sorted(&found), sorted(wanted), "{variant} {found}");
    }
}

/// Turns of the spindle stand where the control makes them, before or after the way to the same point.
fn sorted(words: &str) -> Vec<Vec<&str>> {
    let blocks = words.split('[');
    blocks
        .map(|block| {
            let mut block: Vec<&str> = block.split(' ').collect();
            block.sort_unstable();
            block
        })
        .collect()
}

#[test]
fn automatic_measurement_goes_round_the_probe_and_back() {
    // oracle: manual B:9752-9758 (abscissa first, the same edge turned to the other side, back abscissa before
    // ordinate), A:10922 (eight touches with reversal), B:9762-9793 (an upper edge twice at one place); the ways are
    // ours
    for (start, variant, wanted) in [
        (
            [250.0, 440.0],
            2,
            "x404 s15 z226 [z220] x376 s195 [z220] z250 x420 z210 s15 [x414] z250 x360 z210 s195 [x366] z250 x440",
        ),
        (
            [255.0, 430.0],
            10_002,
            "z240 x390 s15 [z234] x430 z180 x390 s195 [z186] x430 z224 s15 x406 [x400] z196 s195 [x400] z255 x430",
        ),
        (
            [170.0, 440.0],
            3002,
            "x404 s15 z194 [z200] s15 [z200] z170 x420 z210 s15 [x414] z170 x360 z210 s195 [x366] z170 x440",
        ),
        (
            [250.0, 440.0],
            4002,
            "z170 x404 s15 z194 [z200] s15 [z200] z170 x420 z210 s15 [x414] z170 x360 z210 s195 [x366] z170 x440 z250",
        ),
    ] {
        let found = milling(start, variant, 1.0, |_| ());
        assert_eq!(sorted(&found), sorted(wanted), "{variant} {found}");
    }
    let reversed = milling([250.0, 440.0], 102, 1.0, |_| ());
    assert_eq!(reversed.matches('[').count(), 8, "{reversed}");
    assert!(!reversed.contains("s195"), "{reversed}");
}

#[test]
fn a_turning_spindle_is_left_alone() {
    // oracle: manual B:9608-9610, B:10088 (neither a turn nor a stop, with M3 and with _CHBIT[20])
    let wanted = "z210 x420 [x414] z250 x360 z210 [x366]";
    let turns = |setup: &mut Setup| setup.control.spindle_speed = 200.0;
    assert_eq!(milling([250.0, 440.0], 2001, 2.0, turns), wanted);
    let stays = |setup: &mut Setup| setup.control.set("_CHBIT[20]", 1.0);
    assert_eq!(milling([250.0, 440.0], 1, 1.0, stays), "x404 z226 [z220]");
}
