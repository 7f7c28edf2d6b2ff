//! Every row of the states is a test: from which state an input leads where, and what it does.

use super::{block, open, stand};
use probewright_core::jog::states::{Does, Key, ROWS};
use probewright_core::jog::{Input, Session, State};
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};
use probewright_core::{control::Store, geometry::Mcs};
use std::collections::BTreeSet;

/// The mask of two points along the left face of the block, none stored.
fn two_points(zo: &str) -> Session {
    let mut session = Session::new(&block());
    open(&mut session, "align_edge", &[("zo", zo), ("axis", "X"), ("ref_axis", "Y")]);
    stand(&mut session, [-20.0, 20.0, -5.0]);
    session
}

/// Presses NC start, and lets the measurement come to its end.
fn start(session: &mut Session) {
    session.carry_out(Input::Start).unwrap();
}

/// Both points stored.
fn ready(zo: &str) -> Session {
    let mut session = two_points(zo);
    start(&mut session);
    stand(&mut session, [-20.0, 60.0, -5.0]);
    start(&mut session);
    assert_eq!(session.state(), State::Ready);
    session
}

/// The activation screen: the offset went into a frame that is not active.
fn activating() -> Session {
    let mut session = ready("G54");
    session.press(Input::Calculate).unwrap();
    assert_eq!(session.state(), State::Activate);
    session
}

/// A measurement that finds nothing on its way.
fn failed() -> Session {
    let mut session = two_points("none");
    stand(&mut session, [-500.0, 20.0, -5.0]);
    start(&mut session);
    assert_eq!(session.state(), State::Alarm);
    session
}

fn black(session: &Session) -> Vec<bool> {
    session.points().iter().map(Option::is_some).collect()
}

/// The corner up to SW 6.2, so many points stored; the next one is touched and waits.
fn older_corner(stored: usize) -> Session {
    let mut setup = block();
    setup.control.set("PW-JOG", 1.0);
    let mut session = Session::new(&setup);
    open(&mut session, "old_corner", &[("zo", "G54"), ("x0", "2")]);
    let places = [[20.0, -20.0, -5.0], [80.0, -20.0, -5.0], [-20.0, 20.0, -5.0], [-20.0, 60.0, -5.0]];
    for (number, place) in places.into_iter().take(stored + 1).enumerate() {
        stand(&mut session, place);
        start(&mut session);
        if number < stored {
            session.press(Input::Point(number + 1)).unwrap();
        }
    }
    session
}

/// Carries out what a row describes; the state then, and whether it did what the row says.
fn carried_out(number: usize) -> (State, bool) {
    let row = &ROWS[number];
    let mut session = match row.from {
        State::Menu => Session::new(&block()),
        State::Mask => two_points("none"),
        State::Ready => ready("none"),
        State::Busy | State::Alarm => two_points("none"),
        State::Activate | State::Moving => activating(),
    };
    match (row.from, row.key, row.does) {
        (State::Menu, Key::Function, Does::Open) => {
            session.press(Input::Function("hole_1")).unwrap();
            let opened = session.mask().is_some_and(|mask| mask.name == "hole_1");
            (session.state(), opened && session.values().word("zo") == "none")
        }
        (State::Menu, Key::Mode, Does::Quit) => {
            session.press(Input::Mode).unwrap();
            (session.state(), session.mask().is_none())
        }
        (State::Mask, Key::Field, Does::Change) => {
            start(&mut session);
            session.press(Input::Field("spec_angle", "1,5")).unwrap();
            let kept = black(&session) == [true, false] && session.values().number("spec_angle") == 1.5;
            // what says how is touched rejects the points
            session.press(Input::Field("direction", "-")).unwrap();
            (session.state(), kept && black(&session) == [false, false])
        }
        (State::Ready, Key::Field, Does::Change) => {
            session.press(Input::Field("spec_angle", "2")).unwrap();
            let state = session.state();
            session.press(Input::Field("direction", "-")).unwrap();
            (state, session.state() == State::Mask && black(&session) == [false, false])
        }
        (State::Mask, Key::Start, Does::Measure) => {
            session.press(Input::Start).unwrap();
            (session.state(), black(&session) == [false, false])
        }
        (State::Busy, Key::Done, Does::Hold) => {
            let session = older_corner(0);
            (session.state(), session.waits() && black(&session) == [false; 4])
        }
        (State::Mask, Key::Point, Does::Keep) => {
            let mut session = older_corner(1);
            // in their order, and only what was touched
            session.press(Input::Point(1)).unwrap_err();
            session.press(Input::Point(3)).unwrap_err();
            session.press(Input::Point(2)).unwrap();
            session.press(Input::Point(3)).unwrap_err();
            (session.state(), !session.waits() && black(&session) == [true, true, false, false])
        }
        (State::Mask, Key::Calculate, Does::Write) => {
            let mut early = older_corner(2);
            early.press(Input::Calculate).unwrap_err();
            let mut session = older_corner(3);
            session.press(Input::Calculate).unwrap();
            let written = session.sim.control.stored_frame(Store::Settable(1)).coarse;
            let grey = black(&session) == [false; 4] && session.activation().is_none();
            (session.state(), grey && written == [-2.0, 0.0, 0.0] && session.sim.control.settable == 0)
        }
        (State::Busy, Key::Done, Does::Store) if row.to == State::Mask => {
            start(&mut session);
            let bits = session.plc();
            (session.state(), black(&session) == [true, false] && bits[4] && !bits[5])
        }
        (State::Busy, Key::Done, Does::Store) => {
            let session = ready("none");
            (session.state(), black(&session) == [true, true])
        }
        (State::Busy, Key::Done, Does::Write) => {
            let inactive = row.to == State::Activate;
            let mut session = Session::new(&block());
            open(&mut session, "set_edge", &[("zo", if inactive { "G54" } else { "none" }), ("x0", "5")]);
            stand(&mut session, [-20.0, 20.0, -5.0]);
            start(&mut session);
            let written = session.sim.control.stored_frame(Store::Settable(1)).coarse[0];
            let result = session.outcome().results == [("meas_x0", 0.0)];
            (session.state(), result && written == if inactive { -5.0 } else { 0.0 })
        }
        (State::Busy, Key::Reset, Does::Cancel) => {
            start(&mut session);
            session.press(Input::Start).unwrap();
            session.press(Input::Reset).unwrap();
            (session.state(), black(&session) == [true, false]) // points stored before stay
        }
        (State::Busy, Key::Failed, Does::Raise) => {
            let session = failed();
            (session.state(), session.stopped().is_some() && black(&session) == [false, false])
        }
        (State::Alarm, Key::Reset, Does::Acknowledge) => {
            let mut session = failed();
            session.press(Input::Reset).unwrap();
            (session.state(), session.stopped().is_none())
        }
        (State::Mask, Key::Point, Does::Reject) => {
            start(&mut session);
            session.press(Input::Point(1)).unwrap();
            (session.state(), black(&session) == [false, false])
        }
        (State::Ready, Key::Point, Does::Reject) => {
            // by the bit of the PLC, which is held until the point is grey
            session.press(Input::Plc(1, true)).unwrap();
            let bits = session.plc();
            session.press(Input::Plc(1, false)).unwrap();
            let handed = bits[0] && !bits[4] && !session.plc()[0];
            (session.state(), handed && black(&session) == [false, true])
        }
        (State::Ready, Key::Calculate, Does::Write) => {
            let inactive = row.to == State::Activate;
            let mut session = if inactive { ready("G54") } else { session };
            session.press(Input::Calculate).unwrap();
            let grey = black(&session) == [false, false];
            (session.state(), grey && session.activation().is_some() == inactive)
        }
        (State::Mask | State::Ready, Key::Back, Does::Leave) => {
            session.press(Input::Back).unwrap();
            (session.state(), session.mask().is_none() && session.points().is_empty())
        }
        (State::Activate, Key::Field, Does::Toggle) => {
            session.press(Input::Field("activate", "no")).unwrap();
            let says = session.activation().is_some_and(|activation| activation.says("activate"));
            (session.state(), !says)
        }
        (State::Activate, Key::Start, Does::Activate) => {
            session.press(Input::Start).unwrap();
            (session.state(), session.sim.control.settable == 0)
        }
        (State::Activate, Key::Back, Does::Close) => {
            let frames = session.sim.control.frames.clone();
            session.press(Input::Back).unwrap();
            let stays = session.sim.control.frames == frames && session.sim.control.settable == 0;
            (session.state(), stays && session.activation().is_none())
        }
        (State::Moving, Key::Done, Does::Offer) => {
            session.carry_out(Input::Start).unwrap();
            let offered = session.measuring() == 1 && session.values().word("zo") == "G54";
            (session.state(), offered && session.sim.control.settable == 1)
        }
        (State::Moving, Key::Failed, Does::Raise) => {
            let mut session = blocked_table();
            session.carry_out(Input::Start).unwrap();
            (session.state(), session.stopped().is_some())
        }
        (State::Moving, Key::Reset, Does::Cancel) => {
            session.press(Input::Start).unwrap();
            session.press(Input::Reset).unwrap();
            (session.state(), session.activation().is_none() && session.sim.control.settable == 0)
        }
        other => panic!("no test for {other:?}"),
    }
}

/// An activation whose rotary axis turns a part into the probe.
fn blocked_table() -> Session {
    let mut setup: Setup = block();
    setup.workpiece.solids.push(Solid::new(Shape::Block { size: [10.0, 10.0, 80.0] }, Mcs([-60.0, -30.0, 40.0])));
    let mut session = Session::new(&setup);
    let values = [("zo", "G54"), ("axis", "X"), ("ref_axis", "Y"), ("angle_offset", "C"), ("spec_angle", "40")];
    open(&mut session, "align_edge", &values);
    for y in [20.0, 60.0] {
        stand(&mut session, [-20.0, y, -5.0]);
        start(&mut session);
    }
    session.press(Input::Calculate).unwrap();
    stand(&mut session, [-46.6, -48.3, 10.0]); // where the block comes along
    session
}

// oracle: manual (each row has its line)
#[test]
fn each_row_does_what_it_says() {
    for (number, row) in ROWS.iter().enumerate() {
        let (state, did) = carried_out(number);
        assert_eq!(state, row.to, "{row:?}");
        assert!(did, "{row:?}");
    }
}

// oracle: manual B:3736 (only after leaving), B:3688 (every point is there)
#[test]
fn an_input_without_a_row_changes_nothing() {
    let mut session = ready("none");
    for input in [Input::Start, Input::Mode, Input::Function("hole_1"), Input::Reset, Input::Point(3)] {
        session.press(input).unwrap_err();
        assert_eq!((session.state(), black(&session)), (State::Ready, vec![true, true]), "{input:?}");
    }
    let mut session = two_points("none");
    session.press(Input::Calculate).unwrap_err();
    session.press(Input::Point(1)).unwrap_err();
    session.press(Input::Field("x0", "1")).unwrap_err();
    session.press(Input::Field("spec_angle", "about")).unwrap_err();
    assert_eq!(session.state(), State::Mask);
    let mut session = failed();
    session.press(Input::Start).unwrap_err();
    session.press(Input::Back).unwrap_err();
    assert_eq!(session.state(), State::Alarm);
}

// oracle: manual B:3684-3688: any number of times, NC start measures the lowest point that is missing
#[test]
fn a_rejected_point_is_measured_again() {
    let mut session = ready("none");
    for _ in 0..3 {
        session.press(Input::Point(1)).unwrap();
        assert_eq!(black(&session), [false, true]);
        stand(&mut session, [-20.0, 30.0, -5.0]);
        start(&mut session);
        assert_eq!(black(&session), [true, true]);
    }
    session.press(Input::Calculate).unwrap();
    assert_eq!(session.outcome().results, [("alpha", 0.0)]);
}

// oracle: hand: a mask keeps its values, of the zero offset the one that is active while measuring is offered
#[test]
fn a_mask_comes_back_with_its_last_values() {
    let mut session = two_points("G54");
    session.press(Input::Field("spec_angle", "12.5")).unwrap();
    session.press(Input::Back).unwrap();
    session.press(Input::Function("align_edge")).unwrap();
    assert_eq!((session.values().number("spec_angle"), session.values().word("axis")), (12.5, "X"));
    assert_eq!(session.values().word("zo"), "none");
}

/// Keys of the lines of the activation screen.
fn lines(session: &Session) -> Vec<String> {
    let activation = session.activation().unwrap();
    activation.lines(&session.sim.control).iter().map(|line| line.key.to_string()).collect()
}

// oracle: manual B:3802-3806, B:3837-3846, B:3889-3901
#[test]
fn the_activation_screen_says_why_it_is_there() {
    let mut session = activating();
    assert_eq!(lines(&session), ["jog-line-inactive", "jog-line-start"]);
    session.press(Input::Back).unwrap();
    // turned about the applicate, and in an offset that is not active
    session.press(Input::Field("spec_angle", "3")).unwrap();
    for y in [20.0, 60.0] {
        stand(&mut session, [-20.0, y, -5.0]);
        start(&mut session);
    }
    session.press(Input::Calculate).unwrap();
    assert_eq!(lines(&session), ["jog-line-inactive", "jog-line-turned", "jog-line-start"]);
    assert_eq!(session.activation().unwrap().fields(), ["activate"]);
    // a plane that leans, in the offset that is active
    let mut setup = block();
    setup.control.set("_JM_I[4]", 1.0);
    setup.workpiece.solids[0].errors.tilt[0] = 2.0;
    let mut session = Session::new(&setup);
    open(&mut session, "align_plane", &[]);
    for [x, y] in [[20.0, 20.0], [80.0, 20.0], [50.0, 60.0]] {
        stand(&mut session, [x, y, 20.0]);
        start(&mut session);
    }
    session.press(Input::Calculate).unwrap();
    assert_eq!(lines(&session), ["jog-line-tilted", "jog-line-no-swivel", "jog-line-start"]);
    // a rotary axis, which no offset turns
    let session = blocked_table();
    assert_eq!(lines(&session), ["jog-line-inactive", "jog-line-rotary", "jog-line-start"]);
    assert_eq!(session.activation().unwrap().fields(), ["activate", "position_axis"]);
    // an offset that is active and was only moved needs none (B:3796)
    let mut setup = block();
    setup.control.set("_JM_I[4]", 1.0);
    let mut session = Session::new(&setup);
    open(&mut session, "set_edge", &[("x0", "5")]);
    stand(&mut session, [-20.0, 20.0, -5.0]);
    start(&mut session);
    assert!(session.activation().is_none());
    assert_eq!(session.sim.control.active.coarse[0], -5.0);
}

// oracle: manual B:3100 (the difference between measured and desired angle), B:3092 (the screen comes up): an edge that
// has its set angle demands no other position, so the second time nothing is written and no axis is asked for
#[test]
fn an_edge_that_is_aligned_moves_no_rotary_axis() {
    let mut setup = block();
    setup.control.set("_JM_I[4]", 1.0);
    setup.workpiece.solids[0].errors.tilt[2] = 2.0;
    let mut session = Session::new(&setup);
    let measure = |session: &mut Session| {
        let values = [("zo", "G54"), ("axis", "X"), ("ref_axis", "Y"), ("angle_offset", "C")];
        open(session, "align_edge", &values);
        for y in [20.0, 60.0] {
            stand(session, [-25.0, y, -5.0]);
            start(session);
        }
        session.press(Input::Calculate).unwrap();
        (session.state(), session.sim.control.stored_frame(Store::Settable(1)).rotary[2].0)
    };
    let (state, first) = measure(&mut session);
    assert_eq!(state, State::Activate);
    assert_eq!(lines(&session), ["jog-line-rotary", "jog-line-start"]);
    assert!((first.abs() - 2.0).abs() < 1e-6, "{first}");
    start(&mut session);
    session.press(Input::Back).unwrap();
    let (state, second) = measure(&mut session);
    assert_eq!(state, State::Activate);
    assert_eq!(lines(&session), ["jog-line-aligned", "jog-line-start"]);
    assert_eq!(session.activation().unwrap().fields(), ["activate"]);
    assert!((second - first).abs() < 1e-9, "{first} {second}");
}

// oracle: self: no two rows of one state and key stand behind one that always counts
#[test]
fn no_row_is_hidden_by_another() {
    let mut closed = BTreeSet::new();
    for row in ROWS {
        let key = (format!("{:?}", row.from), format!("{:?}", row.key));
        assert!(!closed.contains(&key), "{row:?}");
        if format!("{:?}", row.when) == "Always" {
            closed.insert(key);
        }
    }
}
