//! A tool probe that stands elsewhere, is larger and switches late: calibrated on all four sides, it finds every tool,
//! and what was corrected measures as right.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::machine::{PROBE, Real, digit, inputs, machine, mount, place};
use crate::catalogue::find;
use crate::catalogue::sinumerik::testing::random_parts;
use crate::control::{Units, tools::side};
use crate::dialect::Dialect;
use crate::evaluate::tool_offset::RADIUS;
use crate::machine::{Setup, Sim, Step};
use crate::run::{Outcome, predict};
use proptest::prelude::*;

/// How far before the probe a start lies, mm.
const AWAY: f64 = 30.0;
/// The calibration tool.
const CALIBRATION: Real = Real { length: [60.0, 40.0], radius: 3.0 };

fn middle(axis: usize) -> f64 {
    (PROBE[axis][0] + PROBE[axis][1]) / 2.0
}

/// A start before the side that is touched in this direction.
fn before(axis: usize, direction: f64) -> f64 {
    PROBE[axis][usize::from(direction > 0.0)] - direction * AWAY
}

/// Carries out a call from there; what the control has then goes on.
fn call(setup: &mut Setup, start: [f64; 2], variant: i64, values: &[(&'static str, f64)]) {
    place(setup, start);
    let call = inputs(setup, variant, values);
    let mut sim = Sim::new(setup);
    let outcome = crate::catalogue::cycle982::simulate::simulate(&mut sim, &call);
    assert_eq!(outcome, Ok(()), "{variant} {values:?} {start:?}");
    setup.control = sim.control;
}

/// All four sides, in the system of the machine or of the workpiece.
fn calibrate(setup: &mut Setup, workpiece: bool) {
    let mut edge = CALIBRATION.believed(500, 3, [0.0; 3]);
    (edge.length_wear, edge.length) = ([0.0; 3], [60.0, 40.0, 0.0]);
    (edge.radius, edge.radius_wear) = (CALIBRATION.radius, 0.0);
    mount(setup, edge, CALIBRATION.nose(3));
    for axis in 0..2 {
        for direction in [-1.0, 1.0] {
            let mut start = [0, 1].map(|axis| before(axis, -1.0));
            start[axis] = before(axis, direction) - (1.0 + direction) * CALIBRATION.radius;
            let variant = if workpiece { 10 } else { 0 };
            call(setup, start, variant, &[("_MA", axis as f64 + 1.0)]);
        }
    }
}

/// Measures twice: the first time the tool is found, the second time there is nothing to correct.
fn measured(setup: &mut Setup, start: [f64; 2], (variant, axis): (i64, usize), (real, found): (Real, &[usize])) {
    let values = [("_MA", axis as f64 + 1.0), ("_STA1", 15.0), ("_CORA", 3.0)];
    call(setup, start, variant, &values);
    let edge = setup.control.active_edge().unwrap();
    for part in found {
        let error = match *part {
            RADIUS => edge.total_radius() - real.radius,
            length => edge.total_length(length) - real.length[length],
        };
        assert!(error.abs() < 1e-9, "{variant} {start:?}: {part} {error}");
    }
    call(setup, start, variant, &values);
    for part in found {
        let result = if *part == RADIUS { 13 } else { 9 + 2 * part };
        let left = setup.control.number(&format!("_OVR[{result}]"));
        assert!(left.abs() < 1e-9, "{variant} {start:?}: {part} {left}");
    }
}

/// Milling variants with the length and radius that they find: one, two and four points, with and without reversal,
/// upper edges, in axial position; in radial position 10000 more.
const CUTTERS: [(i64, bool); 8] =
    [(1, false), (101, false), (2001, true), (2101, true), (2, true), (102, true), (3002, true), (4102, true)];

proptest! {
    #![proptest_config(random_parts(200))]

    // oracle: hand: the trigger points take in where the probe stands, how large it is and how late it switches
    #[test]
    fn a_calibrated_probe_finds_every_tool_and_then_nothing(
        shift in prop::array::uniform2(-1.0..1.0_f64),
        size in -0.5..0.5_f64,
        late in 0.0..0.1_f64,
        length in prop::array::uniform2(40.0..120.0_f64),
        radius in 12.0..16.0_f64,
        wrong in prop::array::uniform3(-0.6..0.6_f64),
        workpiece in any::<bool>(),
        inch in any::<bool>(),
    ) {
        let mut calibrated = machine(if inch { Units::Inch } else { Units::Metric });
        let probe = &mut calibrated.tool_probes[0];
        probe.pre_travel = late;
        probe.solid.errors.size = size;
        probe.solid.errors.shift = [shift[1], 0.0, shift[0]];
        calibrate(&mut calibrated, workpiece);
        let system = if workpiece { 10 } else { 0 };
        for position in 1..=8 {
            let real = Real { length, radius: 0.8 };
            let sides = side(position, false);
            let mut setup = calibrated.clone();
            let mut edge = real.believed(500, position, [wrong[0], wrong[1], 0.0]);
            (edge.radius, edge.radius_wear) = (0.8, 0.0);
            mount(&mut setup, edge, real.nose(position));
            let start = [0, 1].map(|axis| match sides[axis] {
                0.0 => middle(axis),
                towards => before(axis, towards),
            });
            let crossed = [0, 1].into_iter().filter(|axis| sides[*axis] != 0.0);
            let found: Vec<usize> = crossed.map(|axis| 1 - axis).collect();
            measured(&mut setup, start, (2 + system, 0), (real, &found));
        }
        for (variant, whole) in CUTTERS {
            for radial in [false, true] {
                let real = Real { length, radius };
                let along = usize::from(radial);
                let automatic = digit(variant, 1) == 2;
                let axis = if whole { 1 - along } else { along };
                let found = match (automatic, whole) {
                    (true, _) => vec![0, 1, RADIUS],
                    (_, true) => vec![1 - axis, RADIUS],
                    _ => vec![1 - axis],
                };
                let upper = matches!(digit(variant, 4), 3 | 4);
                let mut setup = calibrated.clone();
                let wrong = if whole { wrong } else { [wrong[0], wrong[1], 0.0] };
                let edge = real.believed(120, 0, wrong);
                mount(&mut setup, edge, real.cutter(along, if upper { 4.0 } else { 0.0 }));
                let mut start = [0.0; 2];
                start[along] = before(along, if digit(variant, 4) == 3 { 1.0 } else { -1.0 });
                start[1 - along] = before(1 - along, -1.0) + 16.0;
                let variant = variant + system + if radial { 10_000 } else { 0 };
                measured(&mut setup, start, (variant, axis), (real, &found));
            }
        }
    }
}

/// One length in the ordinate with a tool of this position that nobody told otherwise; the switch for mirrored
/// positions.
fn in_ordinate(cycle: &str, position: i64, mirrored: f64) -> Outcome {
    let mut setup = machine(Units::Metric);
    setup.control.set("_CHBIT[23]", mirrored);
    let real = Real { length: [60.0, 40.0], radius: 0.8 };
    mount(&mut setup, real.believed(500, position, [0.0; 3]), real.nose(position));
    setup.real_tools.clear();
    place(&mut setup, [middle(0), before(1, -1.0)]);
    let mut inputs = inputs(&setup, 1, &[("_MA", 2.0)]);
    inputs.cycle = find(Dialect::Sinumerik, cycle).unwrap();
    let named = inputs.cycle.settings;
    inputs.settings.retain(|name, _| named.contains(name));
    predict(inputs.cycle, &inputs, &setup)
}

// oracle: manual B:13882 (only active for CYCLE982), B:14051 (mirrored about X: positions 2 and 3 change places)
#[test]
fn mirrored_positions_count_in_this_cycle_alone() {
    let plain = in_ordinate("CYCLE982", 3, 0.0);
    assert!(plain.finished(), "{:?}", plain.alarms());
    let mirrored = in_ordinate("CYCLE982", 2, 1.0);
    let moved = |outcome: &Outcome| -> Vec<Step> {
        let entries = outcome.trace.entries.to_vec();
        let steps = entries.iter().map(|entry| &entry.step);
        let moved = |step: &&Step| matches!(step, Step::Motion { .. } | Step::Touch { .. });
        steps.filter(moved).cloned().collect()
    };
    assert_eq!(moved(&plain), moved(&mirrored));
    assert_eq!(plain.changes(), mirrored.changes());
    assert!(!in_ordinate("CYCLE982", 3, 1.0).finished(), "touched from the wrong side");
    let [off, on] = [0.0, 1.0].map(|bit| in_ordinate("CYCLE972", 3, bit));
    assert!(off.finished());
    assert_eq!(moved(&off), moved(&on));
    assert_eq!(off.changes(), on.changes());
}

// oracle: manual B:13602-13608 (calibrated and measured in the workpiece system, with _TP); self (the way of digit 2)
#[test]
fn the_old_switch_measures_in_the_workpiece_system() {
    for (variant, axis) in [(0, 2.0), (1, 2.0), (2, 1.0), (100_000, 2.0), (100_001, 2.0)] {
        let run = |digit: i64, switch: f64, same: bool| {
            let mut setup = machine(Units::Metric);
            setup.control.set("_CBIT[5]", switch);
            for index in 0..4 {
                let value = setup.control.number(&format!("_TPW[0,{index}]"));
                if same {
                    setup.control.set(format!("_TP[0,{index}]"), value);
                }
            }
            mount(&mut setup, CALIBRATION.believed(500, 3, [0.1, 0.1, 0.0]), CALIBRATION.nose(3));
            let start = [0, 1].map(|axis| before(axis, -1.0));
            place(&mut setup, if variant < 100_000 { start } else { [middle(0), start[1]] });
            let values = [("_MA", axis), ("_MD", 1.0), ("_FA", 40.0)];
            let inputs = inputs(&setup, variant + digit, &values);
            let outcome = predict(inputs.cycle, &inputs, &setup);
            let steps = outcome.trace.entries.iter().map(|entry| entry.step.clone());
            let moved = |step: &Step| matches!(step, Step::Motion { .. });
            let moved: Vec<Step> = steps.filter(moved).collect();
            (moved, outcome.control.active_edge().cloned(), outcome.stop)
        };
        let wanted = run(10, 0.0, false);
        assert_eq!(wanted.2, None, "{variant}");
        assert_eq!(run(0, 1.0, true), wanted, "{variant}");
        // on the machine the way of the cycle is another one; an incremental one has none of its own
        let positioned = variant < 100_000;
        assert_eq!(run(0, 0.0, true).0 != wanted.0, positioned, "{variant}");
    }
}
