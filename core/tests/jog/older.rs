//! The masks up to measuring cycles SW 6.2: what they measure has its set position once the zero offset is active, and
//! no screen asks for it; the basic frame is right with G500.

use super::{machine, near, open, stand};
use nalgebra::Rotation3;
use probewright_core::control::{Frame, Store};
use probewright_core::geometry::{Degrees, Rpy, V3, Wcs, rigid};
use probewright_core::jog::counterpart::{call, masked};
use probewright_core::jog::{Input, Session, State};
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

/// Where the middle of the part lies, and how it is turned about Z.
const MIDDLE: [f64; 3] = [61.3, 37.2, 4.0];
const TURNED: f64 = 3.0;

/// A part that lies somewhere, a probe that is off centre, the masks up to SW 6.2, G55 active while measuring.
fn crooked(shape: Shape, turned: f64) -> Setup {
    let mut setup = machine(shape, MIDDLE);
    setup.workpiece.solids[0].rotation = Rpy([0.0, 0.0, turned]);
    setup.probe.skew = [0.03, -0.02];
    for (name, value) in [("PW-JOG", 1.0), ("_JM_I[4]", 2.0), ("_WP[0,7]", 0.03), ("_WP[0,8]", -0.02)] {
        setup.control.set(name, value);
    }
    for (name, skew) in [("_WP[0,1]", 0.03), ("_WP[0,2]", 0.03), ("_WP[0,3]", -0.02), ("_WP[0,4]", -0.02)] {
        let ideal = setup.control.number(name);
        setup.control.set(name, ideal - skew);
    }
    setup.control.frames.insert(2, Frame { rotation: Rpy([0.0, 0.0, 1.5]), ..Frame::translation([5.0, -3.0, 2.0]) });
    setup
}

/// A place of the part in the machine.
fn place([x, y, z]: [f64; 3], turned: f64) -> [f64; 3] {
    let turn: Rotation3<f64> = rigid::rotation(Rpy::about(2, Degrees(turned)));
    let at: [f64; 3] = (turn * V3::new(x, y, z)).into();
    std::array::from_fn(|axis| at[axis] + MIDDLE[axis])
}

/// Measures from places of the part, storing each point where the user does; then calculates.
fn measured(session: &mut Session, starts: &[[f64; 3]], turned: f64) {
    for (number, start) in starts.iter().enumerate() {
        stand(session, place(*start, turned));
        session.carry_out(Input::Start).unwrap();
        assert_eq!(session.state(), State::Mask, "{:?}", session.stopped());
        if starts.len() > 1 {
            assert!(session.waits() && session.activation().is_none());
            session.press(Input::Point(number + 1)).unwrap();
        }
    }
    if starts.len() > 1 {
        session.press(Input::Calculate).unwrap();
    }
    assert_eq!((session.state(), session.activation()), (State::Mask, None), "no screen asks");
}

type Case =
    (&'static str, &'static [(&'static str, &'static str)], Shape, Vec<[f64; 3]>, &'static [(&'static str, f64)]);

fn cases() -> Vec<Case> {
    let block = Shape::Block { size: [100.0, 80.0, 40.0] };
    let corner = vec![[-20.0, -60.0, -8.0], [30.0, -60.0, -8.0], [-70.0, -10.0, -8.0], [-70.0, 20.0, -8.0]];
    let set: &[(&str, &str)] = &[("x0", "3"), ("y0", "-2")];
    let found: &[(&str, f64)] = &[("meas_x0", 3.0), ("meas_y0", -2.0)];
    let turned: &[(&str, f64)] = &[("meas_x0", 3.0), ("meas_y0", -2.0), ("alpha", 0.0)];
    vec![
        (
            "old_edge",
            &[("x0", "3"), ("axis", "Z"), ("direction", "-")],
            block.clone(),
            vec![[0.0, 0.0, 20.0]],
            &found[..1],
        ),
        ("old_corner", set, block.clone(), corner[..3].to_vec(), turned),
        ("old_corner", set, block, corner, turned),
        (
            "old_hole",
            &[("diameter", "40"), ("x0", "3"), ("y0", "-2")],
            Shape::Hole { diameter: 40.0, depth: 30.0 },
            vec![[0.4, -0.3, -10.0]],
            found,
        ),
        ("old_hole", set, Shape::Hole { diameter: 40.0, depth: 30.0 }, vec![[0.4, -0.3, -10.0]], found),
        (
            "old_spigot",
            &[("diameter", "30"), ("dz", "12"), ("x0", "3"), ("y0", "-2")],
            Shape::Shaft { diameter: 30.0, height: 40.0 },
            vec![[0.4, -0.3, 5.0]],
            found,
        ),
    ]
}

// oracle: manual A:3036-3124, A:3194, A:3245, A:3298 (what was measured has its set position): in a settable frame, in
// the last basic frame as soon as G500 is active (A:2948), in the system frame with G500 active while measuring
// (A:2950)
#[test]
fn measured_again_everything_has_its_set_position() {
    for (mask, values, shape, starts, wanted) in cases() {
        for (zo, measuring, then) in
            [("G54", 2.0, 1.0), ("G55", 2.0, 2.0), ("$P_CHBFR[1]", 2.0, 0.0), ("$P_SETFR", 0.0, 0.0)]
        {
            let what = format!("{mask} {zo}");
            let mut setup = crooked(shape.clone(), TURNED);
            setup.control.set("MD28081", 2.0);
            setup.control.stored.channel.insert(1, Frame::translation([0.5, 0.0, 1.0]));
            setup.control.set("_JM_I[4]", measuring);
            setup.control.set("_JM_B[4]", f64::from(u8::from(zo == "$P_SETFR")));
            let mut session = Session::new(&setup);
            open(&mut session, mask, values);
            session.press(Input::Field("zo", zo)).unwrap_or_else(|why| panic!("{what}: {why:?}"));
            // a signal on an edge that leans comes in two runs to where it belongs
            for pass in 0..2 {
                measured(&mut session, &starts, TURNED);
                assert!(!session.outcome().results.is_empty(), "{what} {pass}");
                session.sim.control.set("_JM_I[4]", then);
            }
            measured(&mut session, &starts, TURNED);
            for (name, value) in wanted {
                let found = session.outcome().results.iter().find(|(known, _)| known == name).unwrap().1;
                near(found, *value, &format!("{what} {name}"));
            }
        }
    }
}

// oracle: manual A:2943-2954: off, settable frames, the basic frame or the basis; from SW 6.3 the list is another one
#[test]
fn the_choices_are_those_of_the_version() {
    for (reference, basic) in [(0.0, "$P_CHBFR[1]"), (1.0, "$P_SETFR")] {
        let mut setup = crooked(Shape::Hole { diameter: 40.0, depth: 30.0 }, 0.0);
        setup.control.set("_JM_B[4]", reference);
        setup.control.set("MD28081", 2.0);
        let choices = probewright_core::jog::offset::choices(&setup.control, false);
        assert_eq!(choices, ["none", "G54", "G55", "G56", "G57", basic]);
    }
}

// oracle: manual A:2950-2952: G500 must be active while measuring
#[test]
fn the_basis_needs_g500() {
    let mut setup = crooked(Shape::Hole { diameter: 40.0, depth: 30.0 }, 0.0);
    setup.control.set("_JM_B[4]", 1.0);
    let mut session = Session::new(&setup);
    open(&mut session, "old_hole", &[("diameter", "40"), ("zo", "$P_SETFR")]);
    stand(&mut session, place([0.4, -0.3, -10.0], 0.0));
    assert_eq!(session.press(Input::Start).unwrap_err().key, "jog-older-g500");
    session.sim.control.set("_JM_I[4]", 0.0);
    session.carry_out(Input::Start).unwrap();
    let stored = session.sim.control.stored_frame(Store::System).coarse;
    near(stored[0], MIDDLE[0], "X");
    near(stored[1], MIDDLE[1], "Y");
}

// oracle: hand (sequence of the manual's section 4.2 against 4.3): a version has its own masks, and no others
#[test]
fn each_version_opens_its_own_masks() {
    let mut session = Session::new(&crooked(Shape::Hole { diameter: 40.0, depth: 30.0 }, 0.0));
    assert_eq!(session.press(Input::Function("hole_1")).unwrap_err().key, "jog-no-function");
    open(&mut session, "tool_length", &[]);
    session.press(Input::Back).unwrap();
    open(&mut session, "old_hole", &[]);
    // the datum is changed: the mask is not there any more
    session.sim.control.set("PW-JOG", 0.0);
    session.settle();
    assert_eq!((session.state(), session.mask().is_none()), (State::Menu, true));
    assert_eq!(session.press(Input::Function("old_hole")).unwrap_err().key, "jog-no-function");
}

// oracle: manual A:3061-3079, A:3030-3047
#[test]
fn the_probe_is_calibrated() {
    let mut setup = crooked(Shape::Hole { diameter: 40.0, depth: 30.0 }, 0.0);
    setup.control.set("_JM_I[4]", 100.0);
    let before = setup.control.clone();
    for name in ["_WP[0,1]", "_WP[0,2]", "_WP[0,3]", "_WP[0,4]", "_WP[0,7]", "_WP[0,8]", "$TC_DP3[9,1]"] {
        let value = setup.control.variable(name).unwrap_or_else(|| setup.control.number(name));
        if !setup.control.set_variable(name, value + 0.2) {
            setup.control.set(name, value + 0.2);
        }
    }
    let mut session = Session::new(&setup);
    open(&mut session, "old_cal_length", &[("z0", "4")]);
    stand(&mut session, [MIDDLE[0] + 30.0, MIDDLE[1], 24.0]);
    session.carry_out(Input::Start).unwrap();
    session.press(Input::Back).unwrap();
    open(&mut session, "old_cal_radius", &[("d", "40")]);
    stand(&mut session, place([0.3, 0.2, -8.0], 0.0));
    session.carry_out(Input::Start).unwrap();
    for name in ["_WP[0,1]", "_WP[0,2]", "_WP[0,3]", "_WP[0,4]", "_WP[0,7]", "_WP[0,8]"] {
        near(session.sim.control.number(name), before.number(name), name);
    }
    let length = |control: &probewright_core::control::Control| control.variable("$TC_DP3[9,1]").unwrap();
    near(length(&session.sim.control), length(&before), "L1");
}

// oracle: self: the automatic cycle of the newer mask that measures alike, which opens the older one again
#[test]
fn they_are_calls_as_the_newer_ones() {
    for (mask, values, shape, starts, _) in cases() {
        let mut session = Session::new(&crooked(shape, 0.0));
        open(&mut session, mask, values);
        let single = starts.len() == 1;
        stand(&mut session, place(starts[0], 0.0));
        if !single {
            measured(&mut session, &starts, 0.0);
        }
        let made = call(&session).unwrap_or_else(|why| panic!("{mask}: {why:?}"));
        let back = masked(made.cycle, &made.values, &session.sim.control).unwrap_or_else(|| panic!("{mask}"));
        assert_eq!(back.mask, mask);
        let right: Wcs = made.start;
        assert!(right.0.iter().all(|value| value.is_finite()), "{mask}");
    }
}
