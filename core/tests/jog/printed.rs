//! The 49 figures that the manuals print in examples and masks of the chapter.

use super::{data, near, open};
use probewright_core::control::{Frame, Plane, Value as Datum};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Degrees, Dir, Mcs, Rpy, V3, rigid};

use probewright_core::jog::{Input, Session, State};
use probewright_core::machine::{Machine, Setup};
use probewright_core::workpiece::{Shape, Solid};
use serde_json::Value;
use std::collections::BTreeSet;

fn figures() -> Vec<Value> {
    let all: Value = serde_json::from_str(data!("jog_examples.json")).unwrap();
    all["manual"].as_array().unwrap().clone()
}

fn figure(id: &str) -> f64 {
    let figures = figures();
    let found = figures.iter().find(|one| one["id"] == id).unwrap_or_else(|| panic!("{id}"));
    found["value"].as_f64().unwrap()
}

/// As the control shows a value.
fn shown(value: f64) -> String {
    format!("{:.4}", value + 0.0)
}

/// Fields of masks whose value a sample prints.
const FIELDS: [(&str, &str, &str); 26] = [
    ("M-cal-z0", "cal_length", "z0"),
    ("M-cal-d", "cal_radius", "d"),
    ("M-pocket-l", "pocket_rect", "l"),
    ("M-pocket-w", "pocket_rect", "w"),
    ("M-rspigot-l", "spigot_rect", "l"),
    ("M-rspigot-w", "spigot_rect", "w"),
    ("M-rspigot-dz", "spigot_rect", "dz"),
    ("M-hole-d", "hole_1", "diameter"),
    ("M-hole-angle", "hole_1", "contact_angle"),
    ("M-spigot-d", "spigot_1", "diameter"),
    ("M-spigot-dz", "spigot_1", "dz"),
    ("M-2h-d", "holes_2", "diameter"),
    ("M-2s-d", "spigots_2", "diameter"),
    ("M-2s-dz", "spigots_2", "dz"),
    ("M-3h-d", "holes_3", "diameter"),
    ("M-3s-d", "spigots_3", "diameter"),
    ("M-3s-dz", "spigots_3", "dz"),
    ("M-4h-d", "holes_4", "diameter"),
    ("M-4s-d", "spigots_4", "diameter"),
    ("M-4s-dz", "spigots_4", "dz"),
    ("M-rej-b", "spigots_4", "diameter"),
    ("M-rej-bz", "spigots_4", "dz"),
    ("M-rej-a", "spigots_4", "diameter"),
    ("M-rej-az", "spigots_4", "dz"),
    ("M-tool-r", "tool_radius", "v"),
    ("M-tool-l", "tool_length", "v"),
];

// oracle: manual (tests/data/jog_examples.json has the line of each figure)
#[test]
fn masks_take_and_show_what_the_samples_print() {
    for (id, mask, field) in FIELDS {
        let mut session = Session::new(&Setup::calibrated(Dialect::Sinumerik, Plane::G17));
        open(&mut session, mask, &[(field, &shown(figure(id)))]);
        assert_eq!(shown(session.values().number(field)), shown(figure(id)), "{id}");
    }
}

/// Translations of the zero offset chosen, positions and the spindle, which a mask shows as they are.
const STATES: [&str; 14] = [
    "M-edge-x", "M-edge-y", "M-edge-z", "M-corner-x", "E1-px", "E1-py", "E1-pz", "E1-pa", "E1-pc", "E1-spindle",
    "M-rej-c", "M-calc-x", "M-calc-y", "M-plane-a",
];

// oracle: manual (tests/data/jog_examples.json): what stands on the machine is what the mask shows
#[test]
fn the_machine_stands_as_the_samples_print() {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.frames.insert(1, Frame::translation(["M-edge-x", "M-edge-y", "M-edge-z"].map(figure)));
    setup.control.spindle = Degrees(figure("E1-spindle"));
    setup.control.rotary = ["E1-pa", "E1-pc", "E1-pc"].map(|id| Degrees(figure(id)));
    setup.position = Mcs(["E1-px", "E1-py", "E1-pz"].map(figure));
    let mut session = Session::new(&setup);
    open(&mut session, "set_edge", &[("zo", "G54")]);
    let control = &session.sim.control;
    let g54 = control.frames[&1].origin();
    assert_eq!(g54.map(shown), ["10.8180", "100.0000", "-105.0000"]);
    assert_eq!(shown(figure("M-corner-x")), shown(g54[0]));
    assert_eq!(session.sim.position().map(shown), ["1.3232", "61.6800", "-55.0000"]);
    assert_eq!(
        [control.rotary[0].0, control.rotary[2].0, control.spindle.0].map(shown),
        ["11.0000", "0.0000", "11.0000"]
    );
    // the other samples: a rotary axis and the plane elsewhere
    session.sim.control.rotary = [figure("M-plane-a"), 0.0, figure("M-rej-c")].map(Degrees);
    session.sim.position = Mcs([figure("M-calc-x"), figure("M-calc-y"), 0.0]);
    assert_eq!([0, 2].map(|axis| shown(session.sim.control.rotary[axis].0)), ["82.2209", "7.5140"]);
    assert_eq!(session.sim.position().map(shown)[..2], ["-11.6210", "0.2190"]);
}

// oracle: manual B:3826-3846: four holes, measured in G500, the offset in G54
#[test]
fn example_1_comes_out_as_printed() {
    let (at, alpha) = ([figure("E1-x0"), figure("E1-y0")], Degrees(figure("E1-alpha")));
    let (sine, cosine) = alpha.sin_cos();
    let hole = |x: f64, y: f64| [at[0] + x * cosine - y * sine, at[1] + x * sine + y * cosine];
    let holes = [hole(-60.0, -50.0), hole(60.0, -50.0), hole(60.0, 50.0), hole(-60.0, 50.0)];
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    for [x, y] in holes {
        let shape = Shape::Hole { diameter: 50.0, depth: 30.0 };
        setup.workpiece.solids.push(Solid::new(shape, Mcs([x, y, 0.0])));
    }
    let mut session = Session::new(&setup);
    open(&mut session, "holes_4", &[("zo", "G54"), ("diameter", "50"), ("angle_offset", "yes")]);
    for [x, y] in holes {
        session.sim.position = Mcs([x + 0.3, y - 0.2, -10.0]);
        session.carry_out(Input::Start).unwrap();
    }
    assert_eq!(session.state(), State::Ready);
    session.press(Input::Calculate).unwrap();
    let results: Vec<String> = session.outcome().results.iter().map(|(_, value)| shown(*value)).collect();
    assert_eq!(results, ["8.6263", "22.5557", "52.9536"]);
    let rotation = session.sim.control.frames[&1].rotation;
    let printed = ["E1-rx", "E1-ry", "E1-rz"].map(figure);
    assert_eq!(rotation.map(shown), printed.map(shown));
    // the screen says so, and NC start moves no axis (B:3866)
    assert_eq!(session.state(), State::Activate);
    let activation = session.activation().unwrap();
    assert!(activation.reasons.inactive && !activation.reasons.tilts && activation.turned);
    let stood = session.sim.position;
    session.carry_out(Input::Start).unwrap();
    assert_eq!((session.sim.position, session.sim.control.settable), (stood, 1));
}

// oracle: manual B:3880-3883: a plane, the offset in an inactive zero offset
#[test]
fn example_2_comes_out_as_printed() {
    let printed = ["E2-rx", "E2-ry", "E2-rz"].map(figure);
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let mut part = Solid::new(Shape::Block { size: [200.0, 200.0, 40.0] }, Mcs([0.0; 3]));
    part.rotation = Rpy(printed);
    setup.workpiece.solids.push(part);
    setup.probe.stylus = Some(0.0); // the plane leans so far that a straight stylus would touch it
    let mut session = Session::new(&setup);
    open(&mut session, "align_plane", &[("zo", "G54")]);
    for [x, y] in [[0.0, 0.0], [60.0, 5.0], [10.0, 45.0]] {
        session.sim.position = Mcs([x, y, 40.0]);
        session.carry_out(Input::Start).unwrap();
    }
    session.press(Input::Calculate).unwrap();
    let rotation = session.sim.control.frames[&1].rotation;
    assert_eq!(rotation.map(shown), printed.map(shown));
    let results: Vec<String> = session.outcome().results.iter().map(|(_, value)| shown(*value)).collect();
    assert_eq!(results, [shown(printed[0]), shown(printed[1])]);
    assert!(session.activation().unwrap().reasons.tilts);
    let normal: Dir<Mcs> = (rigid::rotation(Rpy(printed)) * V3::z()).into();
    session.carry_out(Input::Start).unwrap();
    let seen = session.sim.control.direction_to_workpiece(normal);
    (0..3).for_each(|axis| near(seen[axis], f64::from(u8::from(axis == 2)), "normal in the new WCS"));
}

/// A machine with a swivel table of the axes A and B, a plane on it that leans as example 2 prints it.
fn on_a_swivel_table() -> (Setup, [[f64; 3]; 3]) {
    on_a_table(&["A", "B"])
}

/// The same with a table of these axes, beside C, the fourth axis as delivered.
fn on_a_table(axes: &[&str]) -> (Setup, [[f64; 3]; 3]) {
    let printed = ["E2-rx", "E2-ry", "E2-rz"].map(figure);
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let mut part = Solid::new(Shape::Block { size: [200.0, 200.0, 40.0] }, Mcs([30.0, -20.0, 10.0]));
    part.rotation = Rpy(printed);
    setup.workpiece.solids.push(part);
    setup.probe.stylus = Some(0.0);
    for (place, axis) in axes.iter().enumerate() {
        let named = Datum::Text((*axis).to_owned());
        setup.control.data.insert(format!("MD20080[{}]", 4 + place), named);
        setup.control.set(format!("MD30300[{}]", 4 + place), 1.0);
    }
    setup.control.rotary_centre = Mcs([0.0, 0.0, -80.0]);
    (setup, [[30.0, -20.0, 60.0], [90.0, -15.0, 60.0], [40.0, 25.0, 60.0]])
}

/// The plane is measured at these places, and its activation screen is open.
fn plane_measured(setup: &Setup, places: [[f64; 3]; 3]) -> Session {
    let mut session = Session::new(setup);
    open(&mut session, "align_plane", &[("zo", "G54")]);
    for place in places {
        session.sim.position = Mcs(place);
        session.carry_out(Input::Start).unwrap();
    }
    session.press(Input::Calculate).unwrap();
    session
}

// oracle: manual B:3880-3906: the fields and lines of the screen; the probe is retracted, the table swivels, and the
// plane lies across the probe: measured again it is level, from where the WCS has gone along
#[test]
fn the_probe_is_set_perpendicular_to_the_plane() {
    let (setup, places) = on_a_swivel_table();
    let mut session = plane_measured(&setup, places);
    let lines = |session: &Session| -> Vec<String> {
        let activation = session.activation().unwrap();
        activation.lines(&session.sim.control).iter().map(|line| line.key.to_string()).collect()
    };
    assert_eq!(session.activation().unwrap().fields(), ["activate", "orient", "retract"]);
    assert_eq!(lines(&session), ["jog-line-tilted", "jog-line-swivels", "jog-line-start"]);
    session.press(Input::Field("orient", "no")).unwrap();
    assert_eq!(session.activation().unwrap().fields(), ["activate", "orient"]);
    assert_eq!(lines(&session), ["jog-line-inactive", "jog-line-start"]);
    session.press(Input::Field("activate", "no")).unwrap();
    assert_eq!(session.activation().unwrap().fields(), ["activate"]);
    for name in ["activate", "orient"] {
        session.press(Input::Field(name, "yes")).unwrap();
    }
    let stood = session.sim.position;
    session.carry_out(Input::Start).unwrap();
    assert_eq!(session.state(), State::Mask, "{:?}", session.stopped());
    let control = &session.sim.control;
    let swivelled = control.rotary.map(|angle| shown(angle.0));
    assert_eq!(swivelled, ["E2-rx", "E2-ry", "E2-rz"].map(|id| shown(figure(id))));
    assert!(session.sim.position[2] > stood[2] && session.sim.position[..2] == stood[..2]);
    let up = control.direction_to_machine(V3::z().into());
    (0..3).for_each(|axis| near(up[axis], f64::from(u8::from(axis == 2)), "Z of the WCS"));
    // the WCS went along with the part
    let corner = V3::new(30.0, -20.0, 10.0) + rigid::rotation(Rpy(["E2-rx", "E2-ry", "E2-rz"].map(figure))) * V3::x();
    let centre = V3::from(setup.control.rotary_centre);
    let turn = rigid::rotation(Rpy(["E2-rx", "E2-ry", "E2-rz"].map(figure))).inverse();
    let before = {
        let mut active = setup.control.clone();
        active.frames.insert(1, control.frames[&1]);
        active.activate(1);
        active.to_workpiece(Mcs(corner.into()))
    };
    let now = control.to_workpiece(Mcs((turn * (corner - centre) + centre).into()));
    (0..3).for_each(|axis| near(now[axis], before[axis], "a point of the part"));
    for place in places {
        session.sim.position = Mcs(place);
        session.carry_out(Input::Start).unwrap();
        assert_ne!(session.state(), State::Alarm, "{:?}", session.stopped());
    }
    session.press(Input::Calculate).unwrap();
    session.outcome().results.iter().for_each(|(name, value)| near(*value, 0.0, name));
}

// oracle: hand: of A or B with C one leans the plane, the other turns it before, until it lies across the probe; the
// WCS keeps a turn about it, and measured again the plane is level
#[test]
fn a_table_of_two_axes_sets_the_probe_perpendicular() {
    for axis in ["A", "B"] {
        let (setup, places) = on_a_table(&[axis]);
        let mut session = plane_measured(&setup, places);
        assert_eq!(session.activation().unwrap().fields(), ["activate", "orient", "retract"], "{axis}");
        session.carry_out(Input::Start).unwrap();
        assert_eq!(session.state(), State::Mask, "{axis}: {:?}", session.stopped());
        let up = session.sim.control.direction_to_machine(V3::z().into());
        (0..3).for_each(|one| near(up[one], f64::from(u8::from(one == 2)), axis));
        for place in [[0.0, 0.0, 70.0], [30.0, 0.0, 70.0], [0.0, 30.0, 70.0]] {
            session.sim.position = Mcs(place);
            session.carry_out(Input::Start).unwrap();
            assert_ne!(session.state(), State::Alarm, "{axis}: {:?}", session.stopped());
        }
        session.press(Input::Calculate).unwrap();
        session.outcome().results.iter().for_each(|(name, value)| near(*value, 0.0, name));
    }
    // C alone leans nothing
    let (setup, places) = on_a_table(&[]);
    assert_eq!(plane_measured(&setup, places).activation().unwrap().fields(), ["activate"]);
}

// oracle: hand: what turns into the probe that was not retracted stops
#[test]
fn a_part_that_swivels_into_the_probe_stops() {
    let (setup, places) = on_a_swivel_table();
    let mut session = plane_measured(&setup, places);
    session.press(Input::Field("retract", "no")).unwrap();
    // beside the side that comes up
    session.sim.position = Mcs([118.0, -20.0, 25.0]);
    session.carry_out(Input::Start).unwrap();
    assert_eq!(session.state(), State::Alarm);
    assert!(session.stopped().is_some());
}

// oracle: self: no figure is left out
#[test]
fn every_figure_is_in_a_test() {
    let examples = ["E1-alpha", "E1-x0", "E1-y0", "E1-rx", "E1-ry", "E1-rz", "E2-rx", "E2-ry", "E2-rz"];
    let tested: BTreeSet<&str> = FIELDS.iter().map(|(id, ..)| *id).chain(STATES).chain(examples).collect();
    let figures = figures();
    let all: BTreeSet<&str> = figures.iter().map(|one| one["id"].as_str().unwrap()).collect();
    assert_eq!(all, tested);
    assert_eq!(all.len(), 49);
}
