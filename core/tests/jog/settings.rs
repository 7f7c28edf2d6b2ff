//! What each datum of the set-up does (B:14157-14368).

use super::{block, near, open, stand};
use probewright_core::control::Plane;
use probewright_core::geometry::{Mcs, Wcs};
use probewright_core::jog::{Input, Session, State};
use probewright_core::machine::{MotionKind, Setup, Step};
use probewright_core::message::Arg;

/// Set edge in X before the left face of the block, on a machine with these data.
fn measured(data: &[(&str, f64)]) -> Session {
    let mut setup: Setup = block();
    data.iter().for_each(|(name, value)| setup.control.set(*name, *value));
    let mut session = Session::new(&setup);
    open(&mut session, "set_edge", &[]);
    stand(&mut session, [-20.0, 40.0, -5.0]);
    session.carry_out(Input::Start).unwrap();
    session
}

/// Kind and feed of each motion, and how long it was, mm.
fn motions(session: &Session) -> Vec<(MotionKind, f64, f64)> {
    let steps = session.sim.trace.entries.iter().map(|entry| entry.step);
    let motions = steps.filter_map(|step| match step {
        Step::Motion { kind, from, to, feed, .. } => {
            let way: f64 = (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum();
            Some((kind, feed, way.sqrt()))
        }
        _ => None,
    });
    motions.collect()
}

// oracle: manual B:14257, B:14359-14364, B:14254, B:14356-14358
#[test]
fn feeds_paths_and_attempts_are_those_of_the_set_up() {
    use MotionKind::{Measuring, Retract};
    assert_eq!(motions(&measured(&[])), [(Measuring, 300.0, 17.0), (Retract, 2000.0, 17.0)]);
    assert_eq!(motions(&measured(&[("E_MESS_FM", 150.0)]))[0].1, 150.0);
    assert_eq!(motions(&measured(&[("E_MESS_F", 1500.0)]))[1].1, 1500.0);
    assert_eq!(motions(&measured(&[("_JM_B[2]", 1.0)]))[1].1, 0.0);
    let fast = motions(&measured(&[("_JM_B[3]", 1.0), ("_SPEED[3]", 800.0)]));
    let wanted = [(Measuring, 800.0, 17.0), (Retract, 2000.0, 2.0), (Measuring, 300.0, 2.0), (Retract, 2000.0, 17.0)];
    assert_eq!(fast, wanted);
    // the wall lies beyond twice the path
    let short = measured(&[("E_MESS_D_M", 5.0), ("_JM_B[1]", 0.0)]);
    assert_eq!(short.state(), State::Alarm);
    let ways = motions(&short).into_iter().filter(|(kind, ..)| *kind == Measuring);
    assert_eq!(ways.map(|(.., way)| way).collect::<Vec<_>>(), [10.0; 5]);
    assert_eq!(motions(&measured(&[("E_MESS_D_M", 5.0), ("_JM_B[1]", 1.0)])).len(), 2);
}

// oracle: manual B:14321-14334
#[test]
fn probe_plane_and_zero_offset_are_those_of_the_set_up() {
    let session = measured(&[("_JM_I[1]", 2.0), ("_WP[1,0]", 6.0), ("_WP[1,1]", 3.0), ("_WP[1,2]", -2.5)]);
    near(session.outcome().results[0].1, -0.5, "trigger value of the second probe");
    let session = measured(&[("_JM_I[0]", 1.0), ("_JM_I[1]", 3.0)]);
    near(session.outcome().results[0].1, 0.0, "first probe by the plane");
    // in G19 the probe stands along X, and Y is the abscissa
    let mut setup = block();
    setup.control.plane = Plane::G19;
    for (name, value) in [("_JM_I[3]", 19.0), ("_WP[0,2]", -2.0), ("_WP[0,4]", -1.0)] {
        setup.control.set(name, value);
    }
    let mut session = Session::new(&setup);
    open(&mut session, "set_edge", &[("axis", "Y")]);
    stand(&mut session, [95.0, -20.0, -5.0]);
    session.carry_out(Input::Start).unwrap();
    assert_eq!((session.sim.control.plane, session.state()), (Plane::G19, State::Mask));
    near(session.outcome().results[0].1, -1.0, "trigger value of the abscissa");
    let session = measured(&[("_JM_I[3]", 0.0)]);
    assert_eq!(session.sim.control.plane, Plane::G17);
    for (number, settable) in [(0.0, 0), (3.0, 3), (100.0, 0)] {
        assert_eq!(measured(&[("_JM_I[4]", number)]).sim.control.settable, settable);
    }
}

// oracle: manual B:14335-14336, B:2762-2781, B:1971
#[test]
fn the_choices_of_the_zero_offset_follow_the_set_up() {
    let offered = |mask: &str, all: f64| {
        let mut setup = block();
        setup.control.set("_JM_I[5]", all);
        setup.control.stored.channel.insert(0, Default::default());
        setup.control.stored.global.insert(0, Default::default());
        let mut session = Session::new(&setup);
        open(&mut session, mask, &[("zo", "G54"), ("zo", "G599"), ("zo", "none"), ("zo", "$P_SETFR")]);
        ["$P_CHBFR[0]", "$P_NCBFR[0]"].map(|name| session.press(Input::Field("zo", name)).is_ok())
    };
    assert_eq!(offered("set_edge", 0.0), [false, false]);
    assert_eq!(offered("set_edge", 1.0), [true, true]);
    assert_eq!(offered("align_edge", 1.0), [true, false]);
}

// oracle: manual B:2897-2900
#[test]
fn calibration_pieces_are_preset() {
    let mut setup = block();
    for (name, value) in [("E_MESS_CAL_D[1]", 50.02), ("E_MESS_CAL_L[1]", 20.5), ("_JM_I[1]", 2.0)] {
        setup.control.set(name, value);
    }
    let mut session = Session::new(&setup);
    open(&mut session, "cal_radius", &[]);
    assert_eq!(session.values().number("d"), 50.02);
    session.press(Input::Back).unwrap();
    open(&mut session, "cal_length", &[]);
    assert_eq!(session.values().number("z0"), 20.5);
}

// oracle: manual B:14304: with 0 the spindle follows a rotation of the WCS, with 1 it stays
#[test]
fn the_spindle_follows_a_rotation() {
    for (stays, spindle) in [(0.0, 330.0), (1.0, 0.0)] {
        let mut setup = block();
        setup.control.set("E_MESS_SETT[0]", stays);
        setup.control.set("_JM_I[4]", 1.0);
        setup.control.frames.entry(1).or_default().rotation[2] = 30.0;
        setup.workpiece.solids[0].rotation[2] = 30.0;
        setup.workpiece.solids[0].at = probewright_core::geometry::Mcs([0.0; 3]);
        let mut session = Session::new(&setup);
        open(&mut session, "set_edge", &[]);
        let position = session.sim.control.clone();
        let mut position = position;
        position.activate(1);
        session.sim.position = position.to_machine(probewright_core::geometry::Wcs([-80.0, 0.0, -5.0]));
        session.carry_out(Input::Start).unwrap();
        assert_eq!(session.state(), State::Mask, "{:?}", session.stopped());
        near(session.outcome().results[0].1, -50.0, "edge");
        near(session.sim.control.spindle.0, spindle, "spindle");
    }
}

// oracle: manual B:14304 (no limit, other than B:13979-13981 for the cycles); hand: the WCS is turned by 3 degree about
// the spindle, then by 10 about its ordinate; of the skew of 0.2 mm along the abscissa 0.4 mm * sin 5 is left, and
// 0.2 mm * (1 - cos 10) of it along the abscissa
#[test]
fn the_spindle_follows_a_tilted_wcs_and_what_is_left_is_told() {
    for (lean, left) in [(0.0, None), (10.0, Some(0.0349))] {
        let mut setup = block();
        setup.control.set("_JM_I[4]", 1.0);
        setup.control.frames.entry(1).or_default().rotation.0 = [0.0, lean, 3.0];
        setup.workpiece.solids[0].rotation.0 = [0.0, lean, 3.0];
        setup.workpiece.solids[0].at = Mcs([0.0; 3]);
        setup.probe.skew = [0.2, -0.1];
        setup.probe.stylus = Some(0.0);
        for (place, value) in [(1, 2.8), (2, -3.2), (3, 3.1), (4, -2.9), (7, 0.2), (8, -0.1)] {
            setup.control.set(format!("_WP[0,{place}]"), value);
        }
        let mut session = Session::new(&setup);
        open(&mut session, "set_edge", &[]);
        let mut active = session.sim.control.clone();
        active.activate(1);
        session.sim.position = active.to_machine(Wcs([-80.0, 0.0, -15.0]));
        session.carry_out(Input::Start).unwrap();
        assert_eq!(session.state(), State::Mask, "{:?}", session.stopped());
        near(session.sim.control.spindle.0, 357.0, "spindle");
        let off = (session.outcome().results[0].1 + 50.0).abs();
        assert!(off < 0.2 * (1.0 - f64::cos(lean.to_radians())) + 1e-6, "{lean}: {off}");
        let told = session.sim.trace.entries.iter().find_map(|entry| match entry.step {
            Step::Decision { message } if message.key == "jog-skew-tilted" => Some(message.args),
            _ => None,
        });
        assert_eq!(told, left.map(|left| vec![("value", Arg::Number(left))]), "{lean}");
    }
}
