//! A mask as the automatic cycle that does the same: what JOG writes and what the program writes, on the same machine
//! with a part at random, are one. PROBEWRIGHT_CASES=50 draws fifty times as many parts, PROBEWRIGHT_SEED=7 others.

use super::loops::{
    BESIDE, BLOCK, HOLE, ISLAND, POCKET, SPIGOT, TARGETS, at, environment, lies, machine, measure, spread,
};
use probewright_core::app::call_text as text;
use probewright_core::control::{AXES, Control, Frame, Plane, Store, gud};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, Rpy, V3, Wcs, rigid};
use probewright_core::jog::counterpart::{Call, call, masked};
use probewright_core::jog::{Input, Session, State, masks};
use probewright_core::machine::{Setup, Step};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{Noise, Shape, Solid, Tool, ToolProbe};
use std::collections::BTreeSet;

/// Cases of each mask in a test run.
const CASES: u64 = 2;
/// Above all that stands on the table, mm.
const HIGH: f64 = 150.0;

/// A mask with its values, on a part, from places in coordinates of the part; `feature` is the place of the part that
/// gets the set position.
struct Case {
    mask: &'static str,
    cycle: &'static str,
    values: &'static [(&'static str, &'static str)],
    shape: Shape,
    starts: Vec<[f64; 3]>,
    feature: [f64; 3],
    set: [f64; 3],
    /// Whether the rotation is corrected.
    turns: bool,
}

fn case(
    mask: &'static str,
    cycle: &'static str,
    values: &'static [(&'static str, &'static str)],
    starts: &[[f64; 3]],
) -> Case {
    let starts = starts.to_vec();
    Case { mask, cycle, values, shape: BLOCK, starts, feature: [0.0; 3], set: [0.0; 3], turns: false }
}

/// An element whose centre gets X 3, Y -2: the probe stands at the set centre, as the program begins there.
fn element(
    mask: &'static str,
    cycle: &'static str,
    values: &'static [(&'static str, &'static str)],
    shape: Shape,
    height: f64,
) -> Case {
    Case { shape, set: [3.0, -2.0, 0.0], ..case(mask, cycle, values, &[[0.0, 0.0, height]]) }
}

fn edges() -> Vec<Case> {
    let beside = |places: &[usize]| places.iter().map(|place| BESIDE[*place]).collect::<Vec<_>>();
    let edge = |values, place: usize, feature: [f64; 3], set: [f64; 3]| Case {
        feature,
        set,
        ..case("set_edge", "CYCLE978", values, &[BESIDE[place]])
    };
    let along =
        |values, places: &[usize]| Case { turns: true, ..case("align_edge", "CYCLE998", values, &beside(places)) };
    let middle = |values, shape, starts: &[[f64; 3]]| Case {
        shape,
        set: [12.5, 0.0, 0.0],
        ..case("distance", "CYCLE977", values, starts)
    };
    vec![
        edge(&[("x0", "12.5"), ("axis", "X")], 0, [-50.0, 0.0, 0.0], [12.5, 0.0, 0.0]),
        edge(&[("x0", "-7"), ("axis", "X"), ("direction", "-")], 2, [50.0, 0.0, 0.0], [-7.0, 0.0, 0.0]),
        edge(&[("x0", "12.5"), ("axis", "Y")], 3, [0.0, -40.0, 0.0], [0.0, 12.5, 0.0]),
        edge(&[("x0", "0.5"), ("axis", "Z"), ("direction", "-")], 5, [0.0; 3], [0.0, 0.0, 0.5]),
        along(&[("axis", "Y"), ("ref_axis", "X"), ("spec_angle", "1.5")], &[3, 4]),
        along(&[("axis", "X"), ("ref_axis", "Y"), ("spec_angle", "-0.5")], &[1, 0]),
        middle(&[("x0", "12.5"), ("axis", "X"), ("direction_2", "-")], BLOCK, &[[-70.0, 5.0, -8.0], [70.0, 5.0, -8.0]]),
        middle(
            &[("x0", "12.5"), ("axis", "X"), ("direction_2", "-")],
            POCKET,
            &[[12.0, 5.0, -10.0], [-12.0, 5.0, -10.0]],
        ),
    ]
}

fn corners() -> Vec<Case> {
    let outside = |pos: usize| -> Vec<[f64; 3]> {
        let (x, y) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][pos];
        [[-30.0, -60.0], [30.0, -60.0], [-70.0, -20.0], [-70.0, 20.0]].map(|at| [x * at[0], y * at[1], -8.0]).to_vec()
    };
    let inside = |pos: usize| -> Vec<[f64; 3]> {
        let (x, y) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][pos];
        [[-14.0, -14.0], [14.0, -14.0], [-20.0, -5.0], [-20.0, 12.0]].map(|at| [x * at[0], y * at[1], -10.0]).to_vec()
    };
    let corner = |mask, values, shape, starts: Vec<[f64; 3]>, points: usize| Case {
        shape,
        turns: true,
        ..case(mask, "CYCLE961", values, &starts[..points])
    };
    vec![
        corner("corner_right", &[("x0", "3"), ("y0", "-2")], BLOCK, outside(0), 3),
        corner("corner_right", &[("pos", "2")], BLOCK, outside(1), 3),
        corner("corner_right", &[("pos", "3")], BLOCK, outside(2), 3),
        corner("corner_right", &[("pos", "4"), ("x0", "3"), ("y0", "-2")], BLOCK, outside(3), 3),
        corner("corner_right", &[("corner", "inside"), ("x0", "3"), ("y0", "-2")], POCKET, inside(0), 3),
        corner("corner_right", &[("corner", "inside"), ("pos", "3")], POCKET, inside(2), 3),
        corner("corner_any", &[], BLOCK, outside(0), 4),
        corner("corner_any", &[("pos", "3")], BLOCK, outside(2), 4),
        corner("corner_any", &[("corner", "inside"), ("pos", "2")], POCKET, inside(1), 4),
        Case {
            turns: true,
            ..case("align_plane", "CYCLE998", &[], &[[-40.0, -30.0, 25.0], [40.0, -25.0, 25.0], [0.0, 30.0, 25.0]])
        },
    ]
}

fn elements() -> Vec<Case> {
    vec![
        element("pocket_rect", "CYCLE977", &[("l", "60"), ("w", "44"), ("x0", "3"), ("y0", "-2")], POCKET, -10.0),
        element("hole_1", "CYCLE977", &[("diameter", "40"), ("x0", "3"), ("y0", "-2")], HOLE, -10.0),
        element(
            "hole_1",
            "CYCLE979",
            &[("diameter", "40"), ("contact_angle", "25"), ("x0", "3"), ("y0", "-2")],
            HOLE,
            -10.0,
        ),
        element(
            "spigot_rect",
            "CYCLE977",
            &[("l", "50"), ("w", "36"), ("dz", "12"), ("x0", "3"), ("y0", "-2")],
            ISLAND,
            5.0,
        ),
        element("spigot_1", "CYCLE977", &[("diameter", "30"), ("dz", "12"), ("x0", "3"), ("y0", "-2")], SPIGOT, 5.0),
        element(
            "spigot_1",
            "CYCLE979",
            &[("diameter", "30"), ("dz", "12"), ("contact_angle", "-40"), ("x0", "3"), ("y0", "-2")],
            SPIGOT,
            5.0,
        ),
    ]
}

/// A machine with the part about where its WCS has it, and the places in the machine from which is measured.
fn stands(case: &Case, noise: &mut Noise, measuring: f64, plane: Plane, mirrored: bool) -> (Setup, Vec<Mcs>) {
    let mut setup = machine(noise, measuring, plane);
    if !case.turns {
        let control = &mut setup.control;
        let rotation = control.stored_frame(Store::Settable(measuring as usize)).rotation;
        control.frames.values_mut().for_each(|frame| frame.rotation = rotation);
    }
    if mirrored {
        let [abscissa, ..] = plane.axes();
        setup.control.frames.values_mut().for_each(|frame| frame.mirror[abscissa] = true);
    }
    setup.control.activate(measuring as usize);
    setup.control.set("_CHBIT[13]", 1.0); // the spindle follows the WCS in the cycle, too
    let seen = |[x, y, z]: [f64; 3]| V3::new(if mirrored { -x } else { x }, y, z);
    let turn = rigid::rotation(setup.control.total_frame().unwrap().rotation) * lies(plane);
    let tilt = if case.mask == "align_plane" { 2.0 } else { 0.0 };
    let lean = rigid::rotation(Rpy([spread(noise, tilt), spread(noise, tilt), spread(noise, 2.0)]));
    // where the middle of the part lies in the WCS, off by some mm
    let middle: [f64; 3] = std::array::from_fn(|axis| case.set[axis] - case.feature[axis] + spread(noise, 2.0));
    let origin = V3::from(setup.control.to_machine(Wcs(at(plane, middle))));
    let mut solid = Solid::new(case.shape.clone(), origin.into());
    solid.rotation = rigid::angles(&(turn * lean));
    solid.errors.size = spread(noise, 0.3);
    setup.workpiece.solids = vec![solid];
    let element = case.set != [0.0; 3] && case.feature == [0.0; 3] && case.starts.len() == 1;
    let place = |start: &[f64; 3]| match element {
        true => setup.control.to_machine(Wcs(at(plane, [case.set[0], case.set[1], middle[2] + start[2]]))),
        false => (origin + turn * seen(*start)).into(),
    };
    let starts = case.starts.iter().map(place).collect();
    (setup, starts)
}

fn opened(setup: &Setup, case: &Case, zo: &str, plane: Plane) -> Session {
    let mut session = Session::new(setup);
    session.press(Input::Function(case.mask)).unwrap();
    for (name, value) in case.values.iter().copied().chain([("zo", zo)]) {
        let axis = ["axis", "ref_axis"].contains(&name).then(|| AXES.iter().position(|axis| *axis == value)).flatten();
        let value = axis.map_or(value, |axis| AXES[plane.axes()[axis]]);
        session.press(Input::Field(name, value)).unwrap_or_else(|why| panic!("{} {name}: {why:?}", case.mask));
    }
    session
}

/// Runs a call on a machine, the probe above its start first.
fn carried_out(setup: &Setup, call: &Call, text: &str, what: &str) -> Outcome {
    let mut setup = setup.clone();
    let mut above = call.start;
    above[call.control.plane.axes()[2]] += HIGH;
    setup.position = call.control.to_machine(above);
    let program = read(Dialect::Sinumerik, format!("{text}M30\n").as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!(outcome.stop, None, "{what}\n{text}{:?}", outcome.diagnostics);
    outcome
}

/// The call opens the mask again with its values, but for what a call does not say: the direction towards one edge, and
/// where the set position is the place of the probe.
fn comes_back(case: &Case, call: &Call, session: &Session, what: &str) {
    let back = masked(call.cycle, &call.values, &call.control).unwrap();
    let four = [117, 118].contains(&call.variant);
    assert_eq!(back.mask, if four { "corner_any" } else { case.mask }, "{what}");
    let mut again = session.clone();
    again.press(Input::Back).unwrap();
    for line in &back.lines {
        match line.split_once(" = ") {
            Some((name, value)) => {
                again.press(Input::Field(name, value)).unwrap_or_else(|why| panic!("{line}: {why:?}"))
            }
            None => again.press(Input::Function(line.trim_start_matches("mask "))).unwrap(),
        }
    }
    let told = |key: &str| back.told.iter().any(|one| one.key == key);
    let lost: &[&str] = match (told("jog-back-direction"), told("jog-back-position")) {
        (true, _) => &["direction"],
        (_, true) => &["x0", "y0"],
        _ => &[],
    };
    for field in masks::find(case.mask).unwrap().fields.iter().filter(|field| !lost.contains(&field.name)) {
        assert_eq!(again.values().get(field.name), session.values().get(field.name), "{what} {}", field.name);
    }
}

/// How far two frames are from each other: translation in mm, rotation by its matrix.
fn apart(one: &Frame, other: &Frame) -> (f64, f64) {
    let whole =
        |frame: &Frame| V3::from(std::array::from_fn::<f64, 3, _>(|axis| frame.coarse[axis] + frame.fine[axis]));
    let turned = rigid::rotation(one.rotation).matrix() - rigid::rotation(other.rotation).matrix();
    ((whole(one) - whole(other)).norm(), turned.norm())
}

fn store(control: &Control, zo: &str) -> Store {
    match zo {
        "$P_SETFR" => Store::System,
        "$P_CHBFR[0]" => Store::ChannelBasic(0),
        _ => Store::Settable(control.make().settable_named(zo).unwrap()),
    }
}

/// An edge that leans is touched at the same place: with all digits of it, and for one edge with the skew of the probe
/// driven out, which JOG does and the cycle does not, as is told (B:2740).
fn across(case: &Case, call: &mut Call, from: Mcs, what: &str) {
    let skewed = call.differs.iter().any(|one| one.key == "jog-differs-skew");
    assert_eq!(skewed, case.mask == "set_edge", "{what}");
    if !skewed && case.mask != "distance" {
        return;
    }
    let exact = call.control.to_workpiece(from);
    let axes = call.control.plane.axes();
    let measuring = call.values["_MA"].parse::<usize>().unwrap() - 1;
    for place in (0..2).filter(|place| *place != measuring) {
        let sense = if call.control.mirrored(axes[place]) { -1.0 } else { 1.0 };
        let skew = sense * call.control.number(&format!("_WP[0,{}]", 7 + place));
        call.start[axes[place]] = exact[axes[place]] - if skewed { skew } else { 0.0 };
    }
}

/// How far the same frame of two controls is from itself.
fn differ(one: &Control, other: &Control, store: Store) -> (f64, f64) {
    apart(&one.stored_frame(store), &other.stored_frame(store))
}

fn agree(case: &Case, number: usize, seed: u64) {
    let (zo, measuring) = TARGETS[(seed % TARGETS.len() as u64) as usize];
    let plane = Plane::ALL[(seed / TARGETS.len() as u64 % 3) as usize];
    let what = format!("{} {number} {plane:?} {zo} {measuring} {seed}", case.mask);
    let mut noise = Noise::new(seed);
    let (setup, starts) = stands(case, &mut noise, measuring, plane, seed.is_multiple_of(3));
    let mut session = opened(&setup, case, zo, plane);
    session.sim.position = starts[0];
    let before = (starts.len() == 1).then(|| call(&session).unwrap_or_else(|why| panic!("{what}: {why:?}")));
    let touched = measured(&mut session, &starts, &what);
    let mut made = before.or(touched).unwrap();
    assert_eq!(made.cycle.name, case.cycle, "{what}");
    across(case, &mut made, starts[0], &what);
    comes_back(case, &made, &session, &what);
    let written = carried_out(&setup, &made, &text(&made), &what).control;
    let jog = session.sim.control.clone();
    let store = store(&jog, zo);
    let wrong = differ(&jog, &setup.control, store);
    assert!(wrong.0 + wrong.1 > 1e-4, "{what}: nothing was wrong");
    let (moved, turned) = differ(&written, &jog, store);
    // CYCLE979 touches on lines that lead beside the centre, where a late signal is a trifle longer
    let near = if case.cycle == "CYCLE979" { 1e-4 } else { 1e-6 };
    assert!(moved < near && turned < 1e-8, "{what}: {moved} mm, {turned}\n{}{:?}", text(&made), made.values);
    if case.mask.ends_with("_rect") {
        return; // one that leans is touched on other lines from its set centre, as is told
    }
    // and once it is written, the program finds nothing to correct
    let mut again = call(&session).unwrap();
    across(case, &mut again, starts[0], &what);
    let after = Setup { control: jog.clone(), ..setup.clone() };
    let written = carried_out(&after, &again, &text(&again), &what).control;
    let (moved, turned) = differ(&written, &jog, store);
    let near = if case.turns { 1e-4 } else { 1e-6 };
    assert!(moved < 2.0 * near && turned < near, "{what} again: {moved} mm, {turned}\n{}", text(&again));
}

/// Measures, and what the mask means as a program once all points are stored; then calculates and activates.
fn measured(session: &mut Session, starts: &[Mcs], what: &str) -> Option<Call> {
    let [starts @ .., last] = starts else { return None };
    for start in starts {
        session.sim.position = *start;
        session.carry_out(Input::Start).unwrap();
        assert_ne!(session.state(), State::Alarm, "{what}: {:?}", session.stopped());
    }
    session.sim.position = *last;
    session.carry_out(Input::Start).unwrap();
    let ready =
        (session.state() == State::Ready).then(|| call(session).unwrap_or_else(|why| panic!("{what}: {why:?}")));
    measure(session, &[], what);
    ready
}

// oracle: self (JOG against the automatic cycle, each by its own formulas)
#[test]
fn the_program_writes_what_jog_writes() {
    let (more, first) = (environment("PROBEWRIGHT_CASES", 1), environment("PROBEWRIGHT_SEED", 0));
    let all = edges().into_iter().chain(corners()).chain(elements());
    for (number, case) in all.enumerate() {
        for seed in 0..CASES * more {
            agree(&case, number, first * 1_000_003 + number as u64 * 100_003 + seed);
        }
    }
}

// oracle: hand (chapter 4 beside chapters 5 and 6): what has a counterpart, and why the others have none
#[test]
fn a_mask_without_a_counterpart_says_why() {
    let mut session = Session::new(&super::block());
    for (mask, key) in [
        ("holes_2", "jog-program-centres"),
        ("spigots_4", "jog-program-centres"),
        ("align_edge", "jog-program-points"),
        ("corner_any", "jog-program-points"),
        ("align_plane", "jog-program-points"),
    ] {
        super::open(
            &mut session,
            mask,
            &if mask.starts_with("spigots") { vec![("diameter", "30"), ("dz", "5")] } else { vec![] },
        );
        assert_eq!(call(&session).unwrap_err().key, key, "{mask}");
        session.press(Input::Back).unwrap();
    }
    super::open(&mut session, "distance", &[("axis", "X")]);
    for x in [-30.0, -20.0] {
        super::stand(&mut session, [x, 40.0, -8.0]);
        session.carry_out(Input::Start).unwrap();
    }
    assert_eq!(call(&session).unwrap_err().key, "jog-program-step");
    session.press(Input::Back).unwrap();
    assert_eq!(call(&session).unwrap_err().key, "jog-no-mask");
}

/// Switches of the cycles and of JOG, those that a manual explains; the unit of the data is what the machine has
/// (B:13594-13596).
fn switches() -> impl Iterator<Item = String> {
    let of = |array: &'static str, count: usize| (0..count).map(move |index| format!("{array}[{index}]"));
    let all = of("_CBIT", 17).chain(of("_CHBIT", 25)).chain(of("_JM_B", 4)).chain(of("E_MESS_SETT", 1));
    let means = |name: &String| {
        let (gud, at) = gud::place(name).unwrap();
        gud.element(&at).is_some_and(|element| !element.internal)
    };
    // and what both take alike: the length of the probe, and which way a spindle turns if it follows
    let not = ["_CBIT[3]", "_CHBIT[24]", "_CBIT[14]", "_CHBIT[14]"];
    all.filter(means).filter(move |name| !not.contains(&name.as_str()))
}

/// What is told of a call, what its program does and what JOG does, by the trace and by what stopped it.
fn done(setup: &Setup, mask: &str, values: &[(&str, &str)], start: [f64; 3]) -> [String; 3] {
    let mut session = Session::new(setup);
    super::open(&mut session, mask, values);
    session.sim.position = Mcs(start);
    let made = call(&session).unwrap();
    let mut setup = setup.clone();
    setup.position = made.control.to_machine(made.start);
    let program = read(Dialect::Sinumerik, format!("{}M30\n", text(&made)).as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    let before = session.sim.trace.entries.len();
    session.carry_out(Input::Start).unwrap();
    let steps: Vec<Step> = session.sim.trace.entries.behind(before).map(|entry| entry.step).collect();
    let (there, here) = ((&outcome.trace, &outcome.stop), (steps, session.stopped()));
    [format!("{:?}", made.differs), format!("{there:?}"), format!("{here:?}")]
}

// oracle: self (JOG against the automatic cycle): a switch that changes what one of them does and not the other is told
// with one of its values
#[test]
fn a_switch_that_only_one_obeys_is_told() {
    let mut setup = machine(&mut Noise::new(3), 1.0, Plane::G17);
    setup.control.frames.values_mut().for_each(|frame| frame.rotation = Rpy([0.0, 0.0, 30.0]));
    setup.control.activate(1);
    let near: &[(&str, &str)] = &[("axis", "Z"), ("direction", "-"), ("zo", "G54")];
    let hole: &[(&str, &str)] = &[("diameter", "40"), ("zo", "G54")];
    let places = [
        ("set_edge", Some(BLOCK), near, [0.0, 0.0, 20.0]),
        ("set_edge", None, near, [0.0, 0.0, 20.0]), // there is no part
        ("hole_1", Some(HOLE), hole, [1.0, -1.0, -10.0]),
        ("cal_radius", Some(HOLE), &[("d", "40")][..], [1.0, -1.0, -10.0]),
    ];
    let (mut acts, mut untold) = (BTreeSet::new(), Vec::new());
    for (mask, shape, values, start) in places {
        let nothing = shape.is_none();
        setup.workpiece.solids = shape.into_iter().map(|shape| Solid::new(shape, Mcs([0.0; 3]))).collect();
        for other in [0.0, 18.0] {
            setup.control.set("_WP[0,9]", other); // calibrated in this plane, or in another one
            for switch in switches() {
                let [off, on] = [0.0, 1.0].map(|value| {
                    let mut setup = setup.clone();
                    setup.control.set(switch.as_str(), value);
                    done(&setup, mask, values, start)
                });
                let [told, there, here] = std::array::from_fn(|one| off[one] != on[one]);
                if there != here {
                    if !told {
                        untold.push(format!("{mask} {nothing} {other} {switch}: there {there}, here {here}"));
                    }
                    acts.insert(switch);
                }
            }
        }
    }
    assert_eq!(untold, Vec::<String>::new());
    for switch in ["_CHBIT[2]", "_CHBIT[13]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]", "_CBIT[13]", "_CBIT[16]"] {
        assert!(acts.contains(switch), "{switch} acts nowhere here");
    }
}

/// Data that both leave, on the same machine.
fn same(session: &Session, outcome: &Outcome, names: &[String], what: &str) {
    for name in names {
        let of = |control: &Control| control.variable(name).unwrap_or_else(|| control.number(name));
        let (jog, program) = (of(&session.sim.control), of(&outcome.control));
        assert!((jog - program).abs() < 1e-6, "{what} {name}: {jog} {program}");
    }
}

// oracle: self (JOG against the automatic cycle)
#[test]
fn the_program_calibrates_as_jog_does() {
    for seed in 0..4 {
        let mut noise = Noise::new(seed);
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.probe.skew = [spread(&mut noise, 0.05), spread(&mut noise, 0.05)];
        setup.probe.pre_travel.0 = 0.01 * noise.uniform();
        setup.probe.length += spread(&mut noise, 0.3);
        setup.workpiece.solids.push(Solid::new(HOLE, Mcs([5.0, -7.0, 0.0])));
        for (mask, field, value, start) in
            [("cal_length", "z0", "0", [45.0, -7.0, 20.0]), ("cal_radius", "d", "40", [5.3, -7.2, -10.0])]
        {
            let mut session = Session::new(&setup);
            super::open(&mut session, mask, &[(field, value)]);
            super::stand(&mut session, start);
            let made = call(&session).unwrap();
            assert_eq!(masked(made.cycle, &made.values, &made.control).unwrap().mask, mask);
            session.carry_out(Input::Start).unwrap();
            assert_eq!(session.state(), State::Mask, "{mask}: {:?}", session.stopped());
            let outcome = carried_out(&setup, &made, &text(&made), mask);
            let mut names: Vec<String> = (0..9).map(|place| format!("_WP[0,{place}]")).collect();
            names.push("$TC_DP3[9,1]".to_owned());
            same(&session, &outcome, &names, mask);
        }
    }
}

// oracle: self (JOG against the automatic cycle, with the data of the tool probe alike)
#[test]
fn the_program_measures_tools_as_jog_does() {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let cube = Solid::new(Shape::Block { size: [20.0, 20.0, 30.0] }, Mcs([200.3, 100.2, 50.0]));
    setup.tool_probes.push(ToolProbe::ideal(cube));
    for (tool, [length, radius]) in [(1, [70.0, 5.0]), (2, [80.0, 6.0]), (3, [80.0, 15.0])] {
        for (name, value) in [("$TC_DP1", 120.0), ("$TC_DP3", length), ("$TC_DP6", radius)] {
            setup.control.set_variable(&format!("{name}[{tool},1]"), value);
        }
        let edge = setup.control.edge_of(tool, 1).unwrap().clone();
        setup.real_tools.insert((tool, 1), Tool::nominal(&edge, &setup.control));
        // what the control believes of those that are measured is wrong
        if tool > 1 {
            setup.control.set_variable(&format!("$TC_DP3[{tool},1]"), length - 0.2);
            setup.control.set_variable(&format!("$TC_DP6[{tool},1]"), radius - 0.07);
        }
    }
    let sides = [210.0, 190.0, 110.0, 90.0, 50.0];
    for (place, value) in sides.into_iter().chain([0.0, 20.0, 133.0, 0.0, 4.0]).enumerate() {
        setup.control.set(format!("_TP[0,{place}]"), value);
    }
    for name in ["E_MESS_MT_DL[0]", "E_MESS_MT_DR[0]"] {
        setup.control.set(name, 20.0);
    }
    setup.control.set("_CHBIT[3]", 0.0);
    setup.control.set("_JM_B[0]", 0.0);
    /// Mask, T number, choices, where it stands, variant of the cycle.
    type Case = (&'static str, i64, &'static [(&'static str, &'static str)], [f64; 3], i64);
    let cases: [Case; 5] = [
        ("tool_cal", 1, &[("cal_kind", "length")], [200.0, 100.0, 60.0], 0),
        ("tool_cal", 1, &[("cal_kind", "length_and_diameter")], [200.0, 100.0, 60.0], 100_000),
        ("tool_length", 2, &[], [201.0, 101.0, 60.0], 1),
        ("tool_length", 3, &[("v", "1")], [201.0, 101.0, 60.0], 2),
        ("tool_radius", 3, &[("v", "1")], [230.0, 101.0, 60.0], 2),
    ];
    for (mask, tool, values, start, variant) in cases {
        let mut session = Session::new(&setup);
        session.take_tool(tool, 1).unwrap();
        super::open(&mut session, mask, values);
        super::stand(&mut session, start);
        let made = call(&session).unwrap();
        let what = format!("{mask} T{tool} {:?}", made.values);
        assert_eq!(made.variant, variant, "{what}");
        assert_eq!(masked(made.cycle, &made.values, &made.control).unwrap().mask, mask, "{what}");
        let before = Setup { control: session.sim.control.clone(), ..setup.clone() };
        session.carry_out(Input::Start).unwrap();
        assert_eq!(session.state(), State::Mask, "{what}: {:?}", session.stopped());
        let outcome = carried_out(&before, &made, &text(&made), &what);
        let names = (0..5).map(|place| format!("_TP[0,{place}]"));
        let of_tool = ["$TC_DP3", "$TC_DP6", "$TC_DP12", "$TC_DP15"].map(|name| format!("{name}[{tool},1]"));
        same(&session, &outcome, &names.chain(of_tool).collect::<Vec<_>>(), &what);
    }
}

// oracle: self (JOG against the automatic cycle): corners of all positions, inside and outside, whose points lie
// anywhere on their edges, from anywhere before them
#[test]
fn a_corner_is_found_wherever_it_was_touched() {
    let (more, first) = (environment("PROBEWRIGHT_CASES", 1), environment("PROBEWRIGHT_SEED", 0));
    for seed in 0..48 * more {
        let mut noise = Noise::new(first * 1_000_003 + 900 + seed);
        let mut between = |low: f64, high: f64| low + (high - low) * noise.uniform();
        let (position, inside, any) = (seed as usize % 4, seed / 4 % 2 == 1, seed / 8 % 3 == 2);
        let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][position];
        let length = [120.0, 90.0];
        let shape = match inside {
            true => Shape::Pocket { length, depth: 30.0 },
            false => Shape::Block { size: [120.0, 90.0, 40.0] },
        };
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.control.set("_CHBIT[21]", 1.0);
        let mut solid = Solid::new(shape, Mcs([between(-20.0, 20.0), between(-20.0, 20.0), 0.0]));
        solid.rotation[2] = between(-8.0, 8.0);
        let (turn, origin) = (rigid::rotation(solid.rotation), V3::from(solid.at));
        setup.workpiece.solids.push(solid);
        let beside = |far: f64| if inside { far } else { -far };
        let near = between(14.0, 30.0);
        let mut points = vec![
            [near, beside(between(5.0, 35.0))],
            [near + between(20.0, 60.0), beside(between(5.0, 35.0))],
            [beside(between(5.0, 35.0)), between(14.0, 50.0)],
        ];
        if any {
            points.push([beside(between(5.0, 35.0)), between(55.0, 70.0)]);
        }
        let mask = if any { "corner_any" } else { "corner_right" };
        let (corner, pos) = (if inside { "inside" } else { "outside" }, (position + 1).to_string());
        let what = format!("{mask} {corner} {pos} {seed} {points:?}");
        let mut session = Session::new(&setup);
        super::open(&mut session, mask, &[("zo", "G54"), ("corner", corner), ("pos", &pos)]);
        for [along, up] in points {
            let place = V3::new(x * (along - 60.0), y * (up - 45.0), -10.0);
            session.sim.position = Mcs::from(origin + turn * place);
            session.carry_out(Input::Start).unwrap();
            assert!(session.stopped().is_none(), "{what}: {:?}", session.stopped());
        }
        let made = call(&session).unwrap_or_else(|why| panic!("{what}: {why:?}"));
        session.press(Input::Calculate).unwrap();
        let written = carried_out(&setup, &made, &text(&made), &what).control;
        let (moved, turned) = differ(&written, &session.sim.control, Store::Settable(1));
        assert!(moved < 1e-5 && turned < 1e-8, "{what}: {moved} {turned}\n{}", text(&made));
    }
}
