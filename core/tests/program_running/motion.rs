//! Motion, units, limit switches and arcs: where a program ends.

use super::running::machine;
use super::{clean, go, near};
use probewright_core::dialect::Dialect;
use probewright_core::machine::Stop;
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;

#[test]
fn motion_ends_where_it_says() {
    // oracle: hand
    let outcome = clean("N10 G0 G90 X10 Y-20.5 Z100\nN20 G91 X5 Z=-10\nN30 G90 G1 Y=IC(0.5) Z=AC(7) F500\nM30");
    near(outcome.end().0, [15.0, -20.0, 7.0]);
    let kinds: Vec<_> = outcome
        .trace
        .entries
        .iter()
        .filter_map(|entry| match entry.step {
            Step::Motion { kind, feed, .. } => Some((entry.line, kind, feed)),
            _ => None,
        })
        .collect();
    let expected = [
        (Some(0), MotionKind::Rapid, 0.0),
        (Some(1), MotionKind::Rapid, 0.0),
        (Some(2), MotionKind::Positioning, 500.0),
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn inches_are_converted() {
    // oracle: hand (25.4 mm in an inch; F follows only G700)
    near(clean("G70 G0 X1 Y2 Z0.5").end().0, [25.4, 50.8, 12.7]);
    let feed = |text: &str| match clean(text).trace.entries.last().unwrap().step {
        Step::Motion { feed, .. } => feed,
        _ => panic!("no motion"),
    };
    assert_eq!(feed("G70 G1 X1 F10"), 10.0);
    assert_eq!(feed("G700 G1 X1 F10"), 254.0);
}

#[test]
fn limit_switches_end_a_program() {
    let mut setup = machine();
    setup.control.limits.plus[0] = Some(100.0);
    let program = read(Dialect::Sinumerik, b"G0 X100\nX101");
    let outcome = run(&program, &setup, Limits::default());
    // oracle: hand
    assert!(matches!(outcome.stop, Some(Stop::Fault(message)) if message.key == "run-limit"));
    assert_eq!(outcome.position[0], 100.0);
}

#[test]
fn arcs_end_at_their_end() {
    // oracle: hand: a quarter about X0 Y0 passes 45 degrees
    let outcome = clean("G0 X10 Y0\nG3 X0 Y10 I-10 J0 F100");
    near(outcome.end().0, [0.0, 10.0, 500.0]);
    let entries = outcome.trace.entries.to_vec();
    let [.., last] = &entries[..] else {
        panic!("nothing moves");
    };
    let Step::Motion { from, to, around: Some(around), .. } = last.step else {
        panic!("{last:?}");
    };
    let half = 0.5_f64.sqrt() * 10.0;
    near(around.at(from, to, 0.5).0, [half, half, 500.0]);
    near(clean("G0 X10 Y0\nG2 X0 Y10 CR=-10 F100").end().0, [0.0, 10.0, 500.0]);
    let outcome = go("G0 X10 Y0\nG3 X0 Y20 I-10 J0 F100");
    assert!(matches!(outcome.stop, Some(Stop::Fault(message)) if message.key == "run-arc"));
}
