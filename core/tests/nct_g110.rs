//! The manual's programs with G101 and G110 (C:1159-1183), run from the text.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::nct;
use probewright_core::control::{Frame, Plane};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, Rpy};
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax;
use probewright_core::workpiece::{PartErrors, Shape, Solid};

/// Repaired where the scan is not readable: program number and comments.
const EXAMPLE: &str = "%O0110 (BORE)\r
G59 G18 G90 G40\r
(PROGRAM BLOCKS)\r
M19\r
T98\r
G43 Y100 H98\r
G101 X120 Z200 (NOMINAL CENTER OF BORE)\r
G101 Y-10\r
G110 D50 S6\r
G0 Y100\r
G41 D1 (MACHINING OF BORE)\r
G40\r
M19\r
T98\r
G43 Y100 H98\r
G101 X120 Z200\r
G101 Y-10\r
G110 D50 T1 H0.3\r
G0 Y100\r
M30\r
%\r
";

/// G59 somewhere; a bore of 50 with its upper face at Y0 of G59, off its nominal place X120 Z200 by `shift`.
fn setup(shift: [f64; 3], size: f64) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G18);
    setup.control.frames.insert(6, Frame::translation([300.0, 200.0, 100.0]));
    setup.control.edge_made(0, 1).radius = 8.0;
    let errors = PartErrors { shift, size, ..PartErrors::default() };
    let shape = Shape::Hole { diameter: 50.0, depth: 30.0 };
    let solid = Solid { shape, at: Mcs([420.0, 200.0, 300.0]), rotation: Rpy([0.0, -90.0, -90.0]), errors };
    setup.workpiece.solids.push(solid);
    setup
}

fn go(text: &str, setup: &Setup) -> Outcome {
    let program = syntax::read(Dialect::Nct, text.as_bytes());
    run(&program, setup, Limits::default())
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}

// oracle: manual C:1159-1183: the first call sets G59 to the centre, the second corrects register 1 by the diameter
#[test]
fn example_as_printed() {
    let outcome = go(EXAMPLE, &setup([0.25, 0.0, -0.15], 0.06));
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    let value = |name: &str| outcome.control.variable(name).unwrap();
    near(value("G59 X"), 300.25);
    near(value("G59 Y"), 200.0);
    near(value("G59 Z"), 99.85);
    near(value("DW1"), 0.03); // bore too large: metal off, the register grows
    // the second call starts from the corrected zero and finds the centre where it should be
    near(outcome.control.number("SHIFT_1"), 0.0);
    near(outcome.control.number("SHIFT_2"), 0.0);
    near(outcome.control.number("DEVIATION"), 0.06);
    assert!(outcome.alarms().is_empty());
    assert_eq!(outcome.diagnostics, []);
}

// oracle: manual C:1178 (H0.3), C:1142
#[test]
fn out_of_tolerance_informs() {
    let outcome = go(EXAMPLE, &setup([0.0; 3], 0.31));
    assert_eq!(outcome.stop, None);
    assert_eq!(outcome.alarms(), [nct::OUT_OF_TOLERANCE]);
    assert!(go(EXAMPLE, &setup([0.0; 3], 0.29)).alarms().is_empty());
}

// oracle: manual C:96-98: three steps a wall, four walls a call, two calls
#[test]
fn every_wall_is_touched_in_three_steps() {
    let outcome = go(EXAMPLE, &setup([0.1, 0.0, 0.1], 0.0));
    let entries = outcome.trace.entries.to_vec();
    let steps: Vec<&Step> = entries.iter().map(|entry| &entry.step).collect();
    let count = |kind: MotionKind| {
        steps.iter().filter(|step| matches!(step, Step::Motion { kind: other, .. } if *other == kind)).count()
    };
    assert_eq!(count(MotionKind::Measuring), 16);
    assert_eq!(count(MotionKind::Retract), 8);
    assert_eq!(steps.iter().filter(|step| matches!(step, Step::Touch { .. })).count(), 16);
}

// oracle: manual C:1123-1137
#[test]
fn a_block_without_d_is_refused() {
    let text = EXAMPLE.replace("G110 D50 S6", "G110 S6");
    assert_eq!(go(&text, &setup([0.0; 3], 0.0)).stop, Some(Stop::Alarm(nct::FORMAT_ERROR)));
    let text = EXAMPLE.replace("D50 S6", "D50 S6 T1");
    assert_eq!(go(&text, &setup([0.0; 3], 0.0)).stop, Some(Stop::Alarm(nct::FORMAT_ERROR)));
}

// oracle: manual C:121-125: beside the bore the way down is blocked
#[test]
fn a_blocked_way_stops_the_program() {
    let text = EXAMPLE.replace("G101 X120 Z200 (", "G101 X150 Z200 (");
    assert_eq!(go(&text, &setup([0.0; 3], 0.0)).stop, Some(Stop::Alarm(nct::PATH_OBSTRUCTED)));
}

// oracle: manual C:113: incremental values are ways
#[test]
fn incremental_positioning() {
    let text = EXAMPLE.replace("G101 X120 Z200 (", "G101 X100 Z200\r\nG91 G101 X20\r\nG90 (");
    let outcome = go(&text, &setup([0.25, 0.0, -0.15], 0.06));
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    near(outcome.control.variable("G59 X").unwrap(), 300.25);
}
