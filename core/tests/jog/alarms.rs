//! Each alarm of the chapter is raised by a session.

use super::{block, machine, open, stand};
use probewright_core::diagnostic::Code;
use probewright_core::jog::practice::{self, Piece};
use probewright_core::jog::{Input, Session, State, help, masks};
use probewright_core::machine::{Setup, Stop};
use probewright_core::workpiece::Shape;

/// Presses NC start; the alarm that comes, and its state.
fn alarm(session: &mut Session) -> u32 {
    session.carry_out(Input::Start).unwrap();
    assert_eq!(session.state(), State::Alarm);
    let Some(Stop::Alarm(code @ Code::Alarm(number))) = session.stopped() else { panic!("{:?}", session.stopped()) };
    let mask = session.mask().unwrap();
    assert!(help::alarms(mask).contains(code), "the help of {} does not name {number}", mask.name);
    *number
}

/// Set edge in X from so far before the left face of the block, on a machine that was changed.
fn edge(change: impl Fn(&mut Setup), x: f64) -> u32 {
    let mut setup = block();
    change(&mut setup);
    let mut session = Session::new(&setup);
    open(&mut session, "set_edge", &[]);
    stand(&mut session, [x, 40.0, -5.0]);
    alarm(&mut session)
}

// oracle: manual A:15840-15921, B:13669
#[test]
fn an_edge_raises_each() {
    let set = |name: &'static str, value: f64| move |setup: &mut Setup| setup.control.set(name, value);
    assert_eq!(edge(|_| {}, -200.0), 61301);
    // the way on which the skew is driven out
    let early = |setup: &mut Setup| {
        setup.control.set("_WP[0,8]", 0.5);
        setup.probe.false_signal = Some(0.01);
    };
    assert_eq!(edge(early, -20.0), 61302);
    assert_eq!(edge(set("MD28082", 1.0), -20.0), 61016);
    assert_eq!(edge(|setup| setup.control.edge = 0, -20.0), 61311);
    assert_eq!(edge(|setup| assert!(setup.control.set_variable("$TC_DP1[9,1]", 500.0)), -20.0), 61309);
    assert_eq!(edge(set("_JM_I[1]", 9.0), -20.0), 61313);
    assert_eq!(edge(|setup| setup.control.stored.system.scale = [2.0; 3], -20.0), 61310);
    assert_eq!(edge(set("_WP[0,9]", 18.0), -20.0), 61341);
    assert_eq!(edge(set("_WP[0,2]", 3.0), -20.0), 61341);
    assert_eq!(edge(|setup| setup.control.limits.plus[0] = Some(-10.0), -20.0), 61401);
    // A:15878, A:15883, A:15935: a geometry axis without channel axis, the software of the control, the size of _WP[]
    assert_eq!(edge(set("MD20050[1]", 0.0), -20.0), 61336);
    assert_eq!(edge(|setup| drop(setup.control.data.remove("_SI[1]")), -20.0), 61342);
    assert_eq!(edge(set("_CVAL[1]", 4.0), -20.0), 61416);
    let mono = |setup: &mut Setup| {
        setup.control.set("_JM_I[1]", 101.0);
        setup.control.spindle_positions = false;
    };
    assert_eq!(edge(mono, -20.0), 61373);
}

// oracle: manual A:15844, A:15921: in a hole the way to the wall is watched too
#[test]
fn ways_between_the_points_are_watched() {
    let mut session = Session::new(&machine(Shape::Hole { diameter: 30.0, depth: 30.0 }, [0.0; 3]));
    open(&mut session, "hole_1", &[("diameter", "200")]);
    stand(&mut session, [0.0, 0.0, -10.0]);
    assert_eq!(alarm(&mut session), 61302);
    // a way beside a spigot that a limit switch shortens, and a collision behind it
    let mut setup = machine(Shape::Shaft { diameter: 60.0, height: 40.0 }, [0.0; 3]);
    setup.control.limits.plus[0] = Some(31.0);
    let mut session = Session::new(&setup);
    open(&mut session, "spigot_1", &[("diameter", "60"), ("dz", "10")]);
    stand(&mut session, [0.0, 0.0, 5.0]);
    assert_eq!(alarm(&mut session), 61402);
}

// oracle: manual B:5241, A:15916, A:15917
#[test]
fn calibrating_a_radius_turns_the_spindle() {
    for (number, probe) in [(61372, 1.0), (61373, 101.0)] {
        let mut setup = machine(Shape::Hole { diameter: 50.0, depth: 30.0 }, [0.0; 3]);
        setup.control.spindle_positions = false;
        setup.control.set("_JM_I[1]", probe);
        let mut session = Session::new(&setup);
        open(&mut session, "cal_radius", &[("d", "50")]);
        stand(&mut session, [0.0, 0.0, -10.0]);
        assert_eq!(alarm(&mut session), number);
    }
}

// oracle: manual A:15841, A:15875, A:15855
#[test]
fn tools_raise_their_own() {
    let tool = |change: &dyn Fn(&mut Setup), mask: &str, at: [f64; 3]| {
        let mut setup = block();
        for (name, value) in [("$TC_DP1[1,1]", 120.0), ("$TC_DP3[1,1]", 70.0), ("$TC_DP6[1,1]", 5.0)] {
            setup.control.set_variable(name, value);
        }
        setup.control.set("E_MESS_MT_DL[0]", 20.0);
        setup.control.set("E_MESS_MT_DR[0]", 20.0);
        change(&mut setup);
        let mut session = Session::new(&setup);
        session.take_tool(1, 1).unwrap();
        open(&mut session, mask, &[]);
        stand(&mut session, at);
        alarm(&mut session)
    };
    let nothing = |_: &mut Setup| {};
    let small = |setup: &mut Setup| setup.control.set("E_MESS_MT_DL[0]", 0.0);
    assert_eq!(tool(&small, "tool_length", [300.0, 300.0, 100.0]), 61230);
    assert_eq!(tool(&|setup| setup.control.set("E_MESS_MT_DR[0]", 0.0), "tool_radius", [300.0, 300.0, 100.0]), 61230);
    assert_eq!(tool(&nothing, "tool_length", [300.0, 300.0, -1000.0]), 61332);
    assert_eq!(tool(&nothing, "tool_radius", [-300.0, 300.0, 100.0]), 61332);
    assert_eq!(tool(&nothing, "tool_cal", [300.0, 300.0, 500.0]), 61301);
    assert_eq!(tool(&|setup| setup.control.set("_JM_I[2]", 9.0), "tool_cal", [0.0, 0.0, 500.0]), 61313);
    // A:15892: data that make no feed
    let still = |setup: &mut Setup| setup.control.set("E_MESS_MAX_S", 0.0);
    assert_eq!(tool(&still, "tool_radius", [300.0, 300.0, 100.0]), 61350);
    let probe = |setup: &mut Setup| assert!(setup.control.set_variable("$TC_DP1[1,1]", 710.0));
    assert_eq!(tool(&probe, "tool_cal", [0.0, 0.0, 500.0]), 61314);
}

/// Presses Calculate; the key of what is told, and nothing is lost.
fn told(session: &mut Session) -> String {
    assert_eq!(session.state(), State::Ready);
    let told = session.press(Input::Calculate).unwrap_err();
    assert_eq!(session.state(), State::Ready);
    assert!(session.points().iter().all(Option::is_some));
    let known = help::alarms(session.mask().unwrap());
    let named = |number: &str| known.iter().any(|code| code.to_string() == number);
    assert!(told.key.strip_prefix("alarm-").is_none_or(named), "{}", told.key);
    told.key.into_owned()
}

// oracle: manual A:15857, A:15911, A:15912; hand (where the manual has no alarm: points of an edge and of a plane)
#[test]
fn points_that_make_nothing_are_told() {
    let measured = |setup: &Setup, mask: &str, values: &[(&str, &str)], starts: &[[f64; 3]]| {
        let mut session = Session::new(setup);
        open(&mut session, mask, values);
        for start in starts {
            stand(&mut session, *start);
            session.carry_out(Input::Start).unwrap();
            assert_ne!(session.state(), State::Alarm, "{:?}", session.stopped());
        }
        session
    };
    let left = [-20.0, 40.0, -5.0];
    let mut same = measured(&block(), "align_edge", &[("ref_axis", "Y")], &[left, left]);
    assert_eq!(told(&mut same), "jog-same-place");
    let front = [30.0, -20.0, -5.0];
    let mut same = measured(&block(), "corner_right", &[], &[front, front, left]);
    assert_eq!(told(&mut same), "alarm-61367");
    let line = [[10.0, 10.0, 20.0], [30.0, 30.0, 20.0], [60.0, 60.0, 20.0]];
    assert_eq!(told(&mut measured(&block(), "align_plane", &[], &line)), "jog-in-line");
    let mut setup = block();
    setup.workpiece.solids.clear();
    let hole = |x: f64, y: f64| {
        let shape = Shape::Hole { diameter: 20.0, depth: 30.0 };
        probewright_core::workpiece::Solid::new(shape, probewright_core::geometry::Mcs([x, y, 0.0]))
    };
    let places = [[0.0, 0.0, -10.0], [100.0, 0.0, -10.0], [200.0, 0.0, -10.0], [300.0, 0.0, -10.0]];
    setup.workpiece.solids.extend(places.iter().map(|[x, y, _]| hole(*x, *y)));
    let diameter = [("diameter", "20")];
    assert_eq!(told(&mut measured(&setup, "holes_3", &diameter, &places[..3])), "alarm-61316");
    assert_eq!(told(&mut measured(&setup, "holes_4", &diameter, &places)), "alarm-61368");
    assert_eq!(told(&mut measured(&setup, "holes_2", &diameter, &[places[0], places[0]])), "jog-same-centres");
}

// oracle: hand: what does not fit is told before anything moves
#[test]
fn a_ball_that_does_not_fit_is_told() {
    let mut session = Session::new(&machine(Shape::Hole { diameter: 30.0, depth: 30.0 }, [0.0; 3]));
    open(&mut session, "hole_1", &[("diameter", "5")]);
    stand(&mut session, [0.0, 0.0, -10.0]);
    session.carry_out(Input::Start).unwrap();
    let Some(Stop::Fault(message)) = session.stopped() else { panic!("{:?}", session.stopped()) };
    assert_eq!(message.key, "jog-ball");
}

// oracle: self: each alarm that the help of a mask names is raised in this file
#[test]
fn every_alarm_that_can_come_is_raised() {
    let raised = include_str!("alarms.rs");
    for mask in masks::all() {
        for code in help::alarms(mask) {
            assert!(raised.contains(&code.to_string()), "{} {code}", mask.name);
        }
    }
}

// oracle: manual B:3938-3945: a mill of type 120 calibrates the tool probe, also where the machine has no probe of type
// 710, without which it would be the workpiece probe, and nobody told what of it cuts
#[test]
fn the_tool_that_is_measured_is_no_probe() {
    let mut setup = practice::machine(Piece::Probe);
    setup.control.tools.retain(|_, tool| tool.edges.values().all(|edge| edge.kind != 710));
    setup.real_tools.clear();
    let mut session = Session::new(&setup);
    open(&mut session, "tool_cal", &[]);
    session.sim.position[2] = 60.0; // 10 mm above the tool probe
    session.carry_out(Input::Start).unwrap();
    assert_eq!((session.state(), session.stopped()), (State::Mask, None));
}

// oracle: manual B:744, A:15849; hand: G54 multiplies, whether it is active or not, so no zero point comes of what was
// measured without it
#[test]
fn a_zero_offset_with_a_scale_factor_is_not_corrected() {
    for measuring in [0.0, 1.0] {
        let scaled = |setup: &mut Setup| {
            setup.control.frames.entry(1).or_default().scale = [2.0, 1.0, 1.0];
            setup.control.set("_JM_I[4]", measuring);
        };
        let mut setup = block();
        scaled(&mut setup);
        let mut session = Session::new(&setup);
        open(&mut session, "set_edge", &[("zo", "G54"), ("x0", "10")]);
        stand(&mut session, [-20.0, 40.0, -5.0]);
        assert_eq!(alarm(&mut session), 61310);
        assert_eq!(session.sim.control.frames[&1].coarse, [0.0; 3]);
    }
    // chosen behind the points
    let mut setup = block();
    setup.control.frames.entry(1).or_default().scale = [2.0, 1.0, 1.0];
    let mut session = Session::new(&setup);
    open(&mut session, "align_edge", &[("zo", "none"), ("axis", "X"), ("ref_axis", "Y")]);
    for y in [20.0, 60.0] {
        stand(&mut session, [-20.0, y, -5.0]);
        session.carry_out(Input::Start).unwrap();
    }
    session.press(Input::Field("zo", "G54")).unwrap();
    assert_eq!(told(&mut session), "alarm-61310");
    session.press(Input::Field("zo", "G55")).unwrap();
    session.press(Input::Calculate).unwrap();
}
