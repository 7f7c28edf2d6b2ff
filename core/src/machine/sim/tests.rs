//! The simulated machine: touches, collisions, limits.
#![allow(clippy::unwrap_used, clippy::panic)]
use super::*;
use crate::control::{Frame, Plane};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::geometry::{Degrees, Dir, Mcs, Wcs};
use crate::workpiece::{ProbeBody, Shape, Solid, Touching};

/// A cube of 100 mm whose upper face is Z = 0 of the machine.
fn sim() -> Sim {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let block = Shape::Block { size: [100.0, 100.0, 100.0] };
    let solid = Solid::new(block, Mcs::default());
    setup.workpiece.solids.push(solid);
    setup.position = Mcs([0.0, 0.0, 20.0]);
    Sim::new(&setup)
}

#[test]
fn probing_latches_at_the_surface() {
    let mut sim = sim();
    sim.control.frames.insert(1, Frame::translation([0.0, 0.0, -5.0]));
    sim.control.activate(1);
    // oracle: hand: the ball centre stops 3 mm above the face; WCS is 5 mm below the machine zero
    let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0).unwrap().unwrap();
    assert!((latched[2] - 8.0).abs() < 1e-9, "{latched:?}");
    assert!((sim.position[2] - 3.0).abs() < 1e-9);
    assert!(sim.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Retract, 1000.0, true).is_ok());
}

#[test]
fn a_longer_probe_switches_earlier() {
    let mut sim = sim();
    sim.probe.length = 50.2;
    // oracle: hand
    let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0).unwrap().unwrap();
    assert!((latched[2] - 3.2).abs() < 1e-9, "{latched:?}");
}

#[test]
fn a_late_signal_lets_the_probe_go_back() {
    let mut sim = sim();
    sim.probe.pre_travel = (0.02, 0.0);
    let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0).unwrap().unwrap();
    assert!((latched[2] - 2.98).abs() < 1e-9, "{latched:?}");
    assert!(sim.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Retract, 1000.0, true).is_ok());
}

#[test]
fn a_watched_motion_stops_with_an_alarm() {
    let mut sim = sim();
    let stop = sim.travel(Wcs([0.0, 0.0, -1.0]), MotionKind::Positioning, 1000.0, true);
    // oracle: manual B:13743-13763
    assert_eq!(stop, Err(Stop::Alarm(Code::Alarm(61302))));
    assert!((sim.position[2] - 3.0).abs() < 1e-9);
}

#[test]
fn a_false_signal_comes_once_where_it_was_set() {
    let mut sim = sim();
    sim.probe.false_signal = Some(15.0);
    let mut watched = |to: f64| sim.travel(Wcs([0.0, 0.0, to]), MotionKind::Positioning, 1000.0, true);
    // oracle: hand: 10 mm down, then after 5 mm of the next watched way
    assert_eq!(watched(10.0), Ok(()));
    assert_eq!(watched(20.0), Err(Stop::Alarm(Code::Alarm(61302))));
    assert_eq!(sim.position, [0.0, 0.0, 15.0]);
    assert!(!sim.signal_stands());
    let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0);
    assert!((latched.unwrap().unwrap()[2] - 3.0).abs() < 1e-9);
    assert!(sim.signal_stands());
}

#[test]
fn no_axis_goes_beyond_its_limit() {
    let mut sim = sim();
    sim.control.limits.plus[0] = Some(10.0);
    // oracle: hand
    let stop = sim.travel(Wcs([10.5, 0.0, 20.0]), MotionKind::Rapid, 0.0, false);
    assert!(matches!(stop, Err(Stop::Fault(message)) if message.key == "run-limit"));
    assert_eq!(sim.position, [0.0, 0.0, 20.0]);
    assert!(sim.probe(Wcs([10.0, 0.0, 20.0]), 150.0).is_ok());
}

#[test]
fn an_unwatched_motion_crashes() {
    let mut sim = sim();
    let stop = sim.travel(Wcs([0.0, 0.0, -1.0]), MotionKind::Rapid, 0.0, false);
    assert!(matches!(stop, Err(Stop::Fault(message)) if message.key == "run-crash"));
    let last = sim.trace.entries.last().unwrap();
    let Step::Crash { point, .. } = last.step else { panic!("{last:?}") };
    assert!(point[2].abs() < 1e-9);
}

#[test]
fn other_tools_are_not_felt() {
    let mut sim = sim();
    sim.control.edge = 0;
    assert!(sim.travel(Wcs([0.0, 0.0, -1.0]), MotionKind::Rapid, 0.0, false).is_ok());
}

#[test]
fn a_full_trace_ends_the_run() {
    let mut sim = sim();
    (sim.trace_limit, sim.in_cycle) = (1, true);
    assert!(sim.travel(Wcs([0.0, 0.0, 30.0]), MotionKind::Rapid, 0.0, false).is_ok());
    let stop = sim.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Rapid, 0.0, false);
    assert!(matches!(stop, Err(Stop::Fault(message)) if message.key == "run-trace-limit"));
}

// oracle: hand: what a program does by itself is done whether it is recorded or not; what it wrote last is known
#[test]
fn a_program_goes_on_without_a_record() {
    let mut sim = sim();
    sim.own_limit = 1;
    for height in [30.0, 20.0, 25.0] {
        assert!(sim.travel(Wcs([0.0, 0.0, height]), MotionKind::Rapid, 0.0, false).is_ok());
    }
    for after in [1.0, 2.0] {
        sim.note(Step::Set { name: "R1".into(), before: 0.0, after });
    }
    assert_eq!((sim.position().0[2], sim.trace.entries.len(), sim.unrecorded), (25.0, 1, true));
    assert_eq!(sim.trace.later.get("R1"), Some(&2.0));
    sim.in_cycle = true;
    sim.note(Step::Set { name: "R1".into(), before: 2.0, after: 3.0 });
    assert_eq!((sim.trace.entries.len(), sim.trace.later.len()), (2, 0));
}

// oracle: hand: a stop of the program and its message are told where nothing else of it is
#[test]
fn messages_are_told_without_a_record() {
    let mut sim = sim();
    (sim.own_limit, sim.told_limit) = (0, 0);
    sim.note(Step::Set { name: "R1".into(), before: 0.0, after: 1.0 });
    for waits in [false, true] {
        sim.note(Step::Message { text: "OUT OF LIMIT".into(), waits });
    }
    assert_eq!((sim.trace.entries.len(), sim.unrecorded), (2, true));
}

/// Turns the table C by 90 degree with the ball here: how it ended, and where the table stands then.
fn turned(ball: [f64; 3]) -> (Sim, Result<(), Stop>) {
    let mut sim = sim();
    sim.position = Mcs(ball);
    let outcome = sim.turn_table(2, Degrees(90.0));
    (sim, outcome)
}

// oracle: hand: turned by a, a face 50 mm from the axis is 60·cos a - 50 from the ball's centre; edges stand 70.7 from
// it
#[test]
fn a_part_that_turns_may_meet_the_ball() {
    let crash = Err(Stop::Fault(Message::new("run-crash")));
    let (sim, outcome) = turned([0.0, -60.0, -10.0]);
    assert_eq!(outcome, crash);
    assert!((sim.part.distance(Mcs([0.0, -60.0, -10.0])) - 3.0).abs() < 1e-6);
    assert!((sim.control.rotary[2].0 - (53.0_f64 / 60.0).acos().to_degrees()).abs() < 1e-6);
    let entries = sim.trace.entries.to_vec();
    let [.., table, last] = &entries[..] else {
        panic!("{:?}", sim.trace);
    };
    assert!(matches!(table.step, Step::Table { to, .. } if to == sim.control.rotary[2]));
    let Step::Crash { point, .. } = last.step else {
        panic!("{last:?}");
    };
    assert!(sim.part.distance(point).abs() < 0.05, "{point:?}");
    for free in [[0.0, -75.0, -10.0], [0.0, -60.0, 3.1], [0.0, 0.0, 20.0]] {
        let (sim, outcome) = turned(free);
        assert_eq!((outcome, sim.control.rotary[2]), (Ok(()), Degrees(90.0)));
    }
}

// oracle: hand: the ball is below the cube, and the stylus beside it
#[test]
fn a_part_that_turns_may_meet_the_stylus() {
    let (sim, outcome) = turned([0.0, -60.0, -120.0]);
    let crash = Message::new("run-crash-stylus");
    assert_eq!(outcome, Err(Stop::Fault(crash)));
    let entries = sim.trace.entries.to_vec();
    let [.., last] = &entries[..] else {
        panic!("{:?}", sim.trace);
    };
    assert!(matches!(last.step, Step::Crash { point, .. } if (-100.0..=-70.0).contains(&point[2])));
    assert_eq!(turned([0.0, -60.0, -160.0]).1, Ok(())); // the spindle nose is below too
}

/// A plate that ends at X = 20, 10 mm thick, over the probe, which hangs beside it with its ball 20 mm lower.
fn under_a_plate(body: Option<ProbeBody>) -> Sim {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Block { size: [100.0, 100.0, 10.0] }, Mcs([70.0, 0.0, 0.0])));
    setup.probe.body = body;
    setup.position = Mcs([0.0, 0.0, -20.0]);
    Sim::new(&setup)
}

// oracle: hand: the plate is met when the axis of the stylus, radius 1.35 mm, is that far from it; the control believes
// that the ball, radius 3 mm, touched
#[test]
fn a_stylus_that_touches_switches_the_probe() {
    let mut sim = under_a_plate(None);
    let latched = sim.probe(Wcs([60.0, 0.0, -20.0]), 150.0).unwrap().unwrap();
    assert!((latched[0] - 18.65).abs() < 1e-9, "{latched:?}");
    let entries = sim.trace.entries.to_vec();
    let [.., touch, told] = &entries[..] else {
        panic!("{:?}", sim.trace);
    };
    let Step::Touch { by, normal, point, .. } = touch.step else {
        panic!("{touch:?}");
    };
    assert_eq!((by, normal), (Touching::Stylus, Dir::new([-1.0, 0.0, 0.0])));
    assert!((point[0] - 20.0).abs() < 1e-9);
    assert_eq!(told.step, Step::Decision { message: Message::new("run-stylus") });
    assert!(sim.stylus_touched() && !sim.stylus_touched());
    let back = sim.travel(Wcs([0.0, 0.0, -20.0]), MotionKind::Retract, 1000.0, true);
    assert_eq!(back, Ok(()));
}

// oracle: manual B:13743-13763 (any signal stops a watched motion), B:13766; hand: where
#[test]
fn a_stylus_on_its_way_is_an_alarm_or_a_crash() {
    let to = [60.0, 0.0, -20.0];
    let mut watched = under_a_plate(None);
    let stop = watched.travel(Wcs(to), MotionKind::Positioning, 1000.0, true);
    assert_eq!(stop, Err(Stop::Alarm(Code::Alarm(61302))));
    assert!((watched.position[0] - 18.65).abs() < 1e-9);
    assert!(!watched.stylus_touched(), "no measurement is spoilt");
    let mut unwatched = under_a_plate(None);
    let stop = unwatched.travel(Wcs(to), MotionKind::Rapid, 0.0, false);
    let crash = Message::new("run-crash-stylus");
    assert_eq!(stop, Err(Stop::Fault(crash)));
    // a quarter of a circle about [-30, 0]: the stylus meets the edge where X is 18.65
    let mut round = under_a_plate(None);
    round.position = Mcs([-30.0, -50.0, -20.0]);
    let around = Around { centre: Wcs([-30.0, 0.0, -20.0]), axis: Dir::new([0.0, 0.0, 1.0]), degrees: Degrees(90.0) };
    let end = [20.0, 0.0, -20.0];
    let stop = round.travel_around(Wcs(end), &around, MotionKind::Positioning, 1000.0, true);
    assert_eq!(stop, Err(Stop::Alarm(Code::Alarm(61302))));
    assert!((round.position[0] - 18.65).abs() < 1e-5, "{:?}", round.position);
}

// oracle: hand: a body of 20 mm, whose lower face is 15 mm above the ball, has its side 20 mm from the axis; nothing of
// it is deflected, so that no signal comes
#[test]
fn a_body_gives_no_signal() {
    let body = ProbeBody { radius: 19.0, distance: 15.0 };
    let crash = || Err(Stop::Fault(Message::new("run-crash-body")));
    let to = [60.0, 0.0, -20.0];
    let mut watched = under_a_plate(Some(body));
    assert_eq!(watched.travel(Wcs(to), MotionKind::Positioning, 1000.0, true), crash());
    assert!((watched.position[0] - 1.0).abs() < 1e-6, "{:?}", watched.position);
    let mut measuring = under_a_plate(Some(body));
    assert_eq!(measuring.probe(Wcs(to), 150.0).map(|_| ()), crash());
    assert!((measuring.position[0] - 1.0).abs() < 1e-6);
    let entries = measuring.trace.entries.to_vec();
    let [.., last] = &entries[..] else {
        panic!("{:?}", measuring.trace);
    };
    assert!(matches!(last.step, Step::Crash { by: Touching::Body, .. }));
}

// oracle: hand: a stylus of a billionth of a mm is a line; the balls that stand for it are a thousand at most
#[test]
fn a_stylus_like_a_hair_is_looked_at_in_a_thousand_places() {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.probe.stylus = Some(1e-9);
    let mut sim = Sim::new(&setup);
    assert_eq!(sim.turn_table(2, Degrees(90.0)), Ok(()));
    assert!(sim.effort() < 10_000);
    let stop = sim.turn_table(2, Degrees(f64::INFINITY));
    assert_eq!(stop, Err(Stop::Fault(Message::new("run-not-finite"))));
}

// oracle: hand: a position of a kilometre is the last that is computed to 1e-9 mm
#[test]
fn nothing_is_driven_beyond_what_can_be_computed() {
    for to in [[0.0, 0.0, 1.1e6], [1e300, 0.0, 20.0]] {
        let far = Err(Stop::Fault(Message::new("run-far").number("limit", 1e6)));
        assert_eq!(sim().travel(Wcs(to), MotionKind::Rapid, 0.0, false), far);
        assert_eq!(sim().probe(Wcs(to), 150.0).map(|_| ()), far);
    }
    let mut long = sim();
    long.correct("$TC_DP3[9,1]", 1e300);
    let stop = long.travel(Wcs([0.0; 3]), MotionKind::Rapid, 0.0, false);
    assert!(matches!(stop, Err(Stop::Fault(message)) if message.key == "run-far"));
}

#[test]
fn what_the_probe_takes_is_told_and_nothing_measured_changes() {
    // oracle: manual B:1184-1196 (axis of the example), hand (150 mm/min: 0.193 mm, 300 mm/min: 0.393 mm)
    let (mut plain, mut told) = (sim(), sim());
    let axis = [("MD10050", 0.004), ("MD10070", 4.0), ("MD32300", 1.0), ("MD32200", 1.0)];
    axis.iter().for_each(|(name, value)| told.control.set(*name, *value));
    told.control.deflection = Some(0.3);
    for feed in [150.0, 150.0, 300.0, 150.0, 300.0] {
        let latched = plain.probe(Wcs([0.0, 0.0, -10.0]), feed).unwrap();
        assert_eq!(told.probe(Wcs([0.0, 0.0, -10.0]), feed).unwrap(), latched);
        assert_eq!(told.position, plain.position);
        plain.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Retract, 1000.0, true).unwrap();
        told.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Retract, 1000.0, true).unwrap();
    }
    let decided = |sim: &Sim| -> Vec<String> {
        let messages = sim.trace.entries.iter().filter_map(|entry| match entry.step {
            Step::Decision { message } => Some(message.key.to_string()),
            _ => None,
        });
        messages.collect()
    };
    let lowest = |sim: &Sim| {
        let ends = sim.trace.entries.iter().filter_map(|entry| match entry.step {
            Step::Motion { to, .. } => Some(to[2]),
            _ => None,
        });
        ends.fold(f64::INFINITY, f64::min)
    };
    assert!((lowest(&plain) - lowest(&told) - 0.3925).abs() < 1e-9, "the axis goes on by its braking path");
    assert_eq!(decided(&plain), [""; 0]);
    assert_eq!(decided(&told), ["run-deflected", "run-deflected-too-far"]);
}
