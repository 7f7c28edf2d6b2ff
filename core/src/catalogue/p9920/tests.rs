//! G65 P9920: a calibrated probe finds every tool again, and each way to fail is reported.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::{CALIBRATE, DEPRESSED, DIAMETER, INCORRECT, LENGTH, MEASURING_DEVICE, P9920, TOO_SMALL};
use crate::catalogue::nct::bench::{PLANES, call, length, near};
use crate::control::{Edge, Plane, Units};
use crate::diagnostic::Code;
use crate::geometry::{Degrees, Mcs, Rpy};
use crate::machine::{MotionKind, Setup, Step, Stop};
use crate::run::Outcome;
use crate::workpiece::{Cut, Cutter, PartErrors, Shape, Solid, Tool, ToolProbe};
use proptest::prelude::*;

/// Centre of the disk and its upper side, machine coordinates, mm.
const DISK: [f64; 3] = [310.0, -45.0, 120.0];
/// Register of the reference tool, and of the tool that is measured.
const REFERENCE: i64 = 99;
const TOOL: i64 = 7;

fn cutter(radius: f64, length: f64) -> Tool {
    Tool { length: [length, 0.0, 0.0], cut: Cut::Cutter(Cutter::smooth(radius)) }
}

/// A machine whose disk of 40 mm stands elsewhere than its data say, the reference tool of 20 by 100 mm above it.
fn machine(plane: Plane) -> Setup {
    let mut setup = Setup::for_cycle(&P9920, plane);
    setup.tool_probes = vec![ToolProbe::ideal(Solid {
        shape: Shape::Turned { diameter: 40.0, length: 15.0, bore: [0.0; 2] },
        at: Mcs(DISK),
        rotation: Rpy::default(),
        errors: PartErrors { size: 0.8, ..PartErrors::default() },
    })];
    *setup.control.edge_made(0, REFERENCE) = Edge { length: [100.0, 0.0, 0.0], radius: 10.0, ..Edge::default() };
    over(&mut setup, REFERENCE, 100.0, [0.0; 2]);
    setup
}

/// With this register active, its tool of this length 4 mm above the disk and beside the centre by so much.
fn over(setup: &mut Setup, register: i64, long: f64, aside: [f64; 2]) {
    setup.control.edge = register;
    let length = setup.control.active_length();
    let nose = [DISK[0] + aside[0], DISK[1] + aside[1], DISK[2] + 4.0 + long];
    setup.position = Mcs(std::array::from_fn(|i| nose[i] - length[i]));
}

/// The machine afterwards, which stands in G49.
fn after(setup: &Setup, outcome: Outcome) -> Setup {
    assert_eq!(outcome.stop, None);
    assert_eq!(outcome.control.edge, 0, "G49 (C:1258)");
    assert_eq!(outcome.control.plane, setup.control.plane);
    Setup { control: outcome.control, position: outcome.position, ..setup.clone() }
}

fn calibrated(setup: &Setup) -> Setup {
    let [z, d, h] = [-8.0, 20.0, 100.0].map(|value| length(setup, value));
    let outcome = call(&P9920, &[("Z", &z), ("D", &d), ("H", &h), ("T", "0")], setup);
    after(setup, outcome)
}

/// A tool in the spindle that is as told; what its register says is another matter.
fn with_tool(setup: &Setup, tool: Tool) -> Setup {
    let mut setup = setup.clone();
    setup.control.edge_made(0, TOOL);
    let long = tool.length[0];
    setup.real_tools.insert((0, TOOL), tool);
    over(&mut setup, TOOL, long, [3.0, -2.0]);
    setup
}

fn measured(setup: &Setup, more: &[(&str, &str)]) -> Outcome {
    let values = [&[("Z", "-8"), ("T", "7")], more].concat();
    call(&P9920, &values, setup)
}

fn stop(setup: &Setup, values: &[(&str, &str)]) -> Option<Stop> {
    let outcome = call(&P9920, values, setup);
    let start = setup.position;
    let length = setup.control.active_length();
    let ends: [f64; 3] = std::array::from_fn(|i| outcome.position[i] - start[i] - length[i]);
    near(ends.into_iter().map(f64::abs).fold(0.0, f64::max), 0.0);
    outcome.stop
}

// oracle: hand (where the disk stands); manual C:1193-1200
#[test]
fn the_place_and_size_of_the_disk_are_found() {
    for plane in PLANES {
        for units in [Units::Metric, Units::Inch] {
            let mut setup = machine(plane);
            setup.control.active_units = units;
            let aside = [0.7, -0.4];
            over(&mut setup, REFERENCE, 100.0, aside);
            let found = calibrated(&setup).control;
            near(found.number("#506"), DISK[2] + 100.0);
            near(found.number("#507"), DISK[0]);
            near(found.number("#508"), DISK[1]);
            near(found.number("#509"), 40.8);
            near(found.number("#513"), 100.0);
        }
    }
}

// oracle: manual C:1224: +X, −X, +Y, −Y, then from above; hand: (20 + 40) / 2 + 2 mm beside, 8 mm down
#[test]
fn the_reference_tool_goes_round_the_disk() {
    let mut setup = machine(Plane::G17);
    setup.tool_probes[0].solid.errors = PartErrors::default();
    let [z, d] = ["-8", "20"];
    let outcome = call(&P9920, &[("Z", z), ("D", d), ("T", "0")], &setup);
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    let begins: Vec<[f64; 3]> = steps
        .filter_map(|step| match step {
            Step::Motion { kind: MotionKind::Measuring, from, feed, .. } if *feed == 750.0 => Some(from.0),
            _ => None,
        })
        .collect();
    let out = [[32.0, 0.0], [-32.0, 0.0], [0.0, 32.0], [0.0, -32.0]];
    assert_eq!(begins.len(), 5, "{begins:?}");
    for (begin, [x, y]) in begins.iter().zip(out) {
        near(begin[0], DISK[0] + x);
        near(begin[1], DISK[1] + y);
        near(begin[2], DISK[2] + 4.0 - 8.0);
    }
    near(begins[4][2], DISK[2] + 4.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    // oracle: hand (the tool as it is); what is corrected is measured again as it stands
    #[test]
    fn a_calibrated_probe_finds_every_tool(long in 20.0..160.0_f64, radius in 2.0..18.0_f64, wrong in -1.0..1.0_f64) {
        let probe = calibrated(&machine(Plane::G17));
        let setup = with_tool(&probe, cutter(radius, long));
        let about = format!("{}", 2.0 * radius + wrong);
        let values = [("K", "4"), ("D", &*about), ("E", "3")];
        let once = measured(&setup, &values);
        prop_assert_eq!(&once.stop, &None);
        for outcome in [once.clone(), measured(&with_tool(&after(&setup, once), cutter(radius, long)), &values)] {
            let register = outcome.control.register(TOOL);
            prop_assert!((register.total_length(0) - long).abs() < 1e-9);
            prop_assert!((register.total_radius() - radius).abs() < 1e-9);
            prop_assert!((outcome.control.number("DIAMETER") - 2.0 * radius).abs() < 1e-9);
        }
    }
}

// oracle: manual C:1240, C:1251: the highest of two teeth comes by where the tool turns; standing, it may not
#[test]
fn a_turning_tool_shows_its_widest_edge() {
    let probe = calibrated(&machine(Plane::G17));
    let two = |angle: f64| {
        let cutter = Cutter { teeth: 2, angle: Degrees(angle), ..Cutter::smooth(6.0) };
        Tool { cut: Cut::Cutter(cutter), ..self::cutter(6.0, 90.0) }
    };
    let setup = with_tool(&probe, two(90.0));
    for (turning, widest) in [("13", true), ("14", true), ("3", true), ("5", false)] {
        let values = [("K", "4"), ("D", "12"), ("M", turning)];
        let outcome = measured(&setup, &values);
        let found = outcome.control.number("DIAMETER");
        assert_eq!((found - 12.0).abs() < 1e-9, widest, "M{turning} {found}");
        assert_eq!(outcome.control.spindle_speed, 0.0);
    }
}

// oracle: manual C:1256: feed by speed where the tool turns, so that a revolution is 0.1 mm and 1 µm
#[test]
fn the_feed_of_a_turning_tool_follows_its_speed() {
    let probe = calibrated(&machine(Plane::G17));
    let setup = with_tool(&probe, cutter(6.0, 90.0));
    let values = [("K", "4"), ("D", "12"), ("M", "13"), ("S", "2000")];
    let outcome = measured(&setup, &values);
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    let feeds: Vec<f64> = steps
        .filter_map(|step| match step {
            Step::Motion { kind: MotionKind::Measuring, feed, .. } => Some(*feed),
            _ => None,
        })
        .collect();
    assert_eq!(feeds, [750.0, 30.0, 200.0, 2.0]);
    assert_eq!(outcome.control.number("#511"), 2000.0);
}

// oracle: manual C:1252-1256: without K only the length; D0 touches with the centre, so that a drill's point does
#[test]
fn the_length_alone() {
    let probe = calibrated(&machine(Plane::G17));
    let drill = Tool { cut: Cut::Cutter(Cutter { chamfer: [5.0, 3.0], ..Cutter::smooth(5.0) }), ..cutter(5.0, 110.0) };
    let setup = with_tool(&probe, drill);
    let outcome = measured(&setup, &[("D", "0")]);
    near(outcome.control.number("LENGTH"), 110.0);
    assert_eq!(outcome.control.register(TOOL).radius, 0.0);
}

// oracle: manual C:1204: RDY at #1003, TSIG at #1002. That TSIG is 1 while the disk is pressed is an assumption
// (DESIGN.md, P9920, signals): C:1204 has the alarm come "unless the TSIG signal arrives", which would make it 0.
#[test]
fn the_signals_of_the_device_count() {
    for (name, value, expected) in [
        ("#1003", 0.0, Some(MEASURING_DEVICE)),
        ("#1003", 1.0, None),
        ("#1002", 1.0, Some(DEPRESSED)),
        ("#1002", 0.0, None),
    ] {
        let mut setup = machine(Plane::G17);
        setup.control.set(name, value);
        let found = call(&P9920, &[("Z", "-8"), ("D", "20"), ("T", "0")], &setup).stop;
        assert_eq!(found, expected.map(Stop::Alarm), "{name} {value}");
    }
}

// oracle: manual C:1224, C:1245: back to the start with its message
#[test]
fn what_goes_wrong_ends_at_the_start() {
    let alarm = |code: Code| Some(Stop::Alarm(code));
    let setup = machine(Plane::G17);
    let thin = [("Z", "-8"), ("D", "12"), ("E", "0"), ("T", "0")];
    assert_eq!(stop(&setup, &thin), alarm(TOO_SMALL));
    let high = [("Z", "-3"), ("D", "20"), ("T", "0")];
    assert_eq!(stop(&setup, &high), alarm(INCORRECT));
    let probe = calibrated(&setup);
    let setup = with_tool(&probe, cutter(6.0, 90.0));
    let short = [("Z", "-3"), ("T", "7"), ("D", "12")];
    assert_eq!(stop(&setup, &short), alarm(INCORRECT));
    let thick = [("Z", "-8"), ("T", "7"), ("D", "6"), ("K", "4"), ("E", "1")];
    assert_eq!(stop(&setup, &thick), alarm(TOO_SMALL));
    let mut narrow = setup.clone();
    narrow.tool_probes[0].solid.at[0] -= 15.0;
    narrow.tool_probes[0].solid.shape = Shape::Turned { diameter: 29.0, length: 2.0, bore: [0.0; 2] };
    let deep = [("Z", "-8"), ("T", "7"), ("D", "0"), ("K", "4")];
    assert_eq!(super::super::nct::bench::codes(&P9920, &deep, Plane::G17).len(), 1);
    let missed = [("Z", "-8"), ("T", "7"), ("D", "12"), ("K", "4")];
    assert_eq!(stop(&narrow, &missed), alarm(INCORRECT));
}

// oracle: manual C:1219, C:1239, C:1252: T and K decide what is done
#[test]
fn t_and_k_choose_the_variant() {
    use crate::catalogue::nct::bench::typed;
    for (values, variant) in [
        (&[("T", "0")][..], CALIBRATE),
        (&[("T", "0"), ("K", "3")], CALIBRATE),
        (&[("T", "8")], LENGTH),
        (&[("T", "8"), ("K", "3")], DIAMETER),
    ] {
        let control = machine(Plane::G17).control;
        let inputs = crate::check::read(&P9920, &typed(values), &control, &mut Vec::new());
        assert_eq!(inputs.variant, variant, "{values:?}");
    }
}
