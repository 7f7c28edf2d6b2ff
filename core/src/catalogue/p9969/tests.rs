#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! Surfaces whose shape is known: what is sent, what is calculated of it, and how far the ball is from the part.

use super::P9969;
use crate::catalogue::nct;
use crate::catalogue::nct::bench::{PLANES, call, codes, machine, near, stand};
use crate::catalogue::nct::part;
use crate::check::check;
use crate::control::Plane;
use crate::diagnostic::Code;
use crate::geometry::Mcs;
use crate::machine::trace::Step;
use crate::machine::{Setup, Stop};
use crate::run::Outcome;
use crate::run::scanning::Session;
use crate::workpiece::Shape;
use crate::workpiece::contact::Boundary;
use crate::workpiece::free::{FreeSurface, Heights};
use proptest::prelude::*;
use std::sync::Arc;

/// So slow that what the control reads is the position itself.
const EXACT: &str = "0.000001";

/// A machine with a surface under the rectangle from the zero to 30 × 12, its own middle there; the stylus 20 mm above.
fn over(surface: FreeSurface, plane: Plane) -> Setup {
    let mut setup = machine(plane, false);
    let middle = [15.0, 6.0, 0.0];
    let shape = Shape::Free(Arc::new(surface));
    let solid = part::in_plane(shape, middle, &setup.control);
    setup.workpiece.solids.push(solid);
    stand(&mut setup, [0.0, 0.0, 20.0]);
    setup
}

fn relief(height: impl Fn(f64, f64) -> f64) -> FreeSurface {
    Heights::over([60.0, 40.0], [60, 40], height).surface().unwrap()
}

/// Values along the axes of the plane, as addresses.
fn rectangle(plane: Plane, feed: &str, extra: &[(&str, &str)]) -> Vec<(String, String)> {
    let axes = plane.axes();
    let mut values = vec![
        (nct::axis_name(axes[0]).to_string(), "30".to_owned()),
        (nct::axis_name(axes[1]).to_string(), "12".to_owned()),
        (nct::axis_name(axes[2]).to_string(), "-30".to_owned()),
        (super::addresses::letter(axes[1]).to_string(), "3".to_owned()),
    ];
    let others = [("R", "1.5"), ("Q", "2"), ("F", feed)];
    values.extend(others.iter().chain(extra).map(|(name, value)| ((*name).into(), (*value).into())));
    values
}

fn session(setup: &Setup, values: &[(String, String)]) -> Session {
    let typed = values.iter().cloned().collect();
    let inputs = check(&P9969, &typed, &setup.control).inputs.unwrap();
    Session::new(&inputs, setup).unwrap().unwrap()
}

fn scanned(setup: &Setup, values: &[(String, String)]) -> Session {
    let mut session = session(setup, values);
    while !session.advance(100) {}
    assert_eq!(session.stop, None);
    session
}

fn outcome(setup: &Setup, values: &[(String, String)]) -> Outcome {
    let values: Vec<(&str, &str)> = values.iter().map(|(n, v)| (n.as_str(), v.as_str())).collect();
    call(&P9969, &values, setup)
}

// oracle: hand: on a plane that rises by 3 in 4 along the lines the end of the ball stands (5/4 - 1) of the radius
// above it; the middle of the rectangle is 15 along
#[test]
fn an_inclined_plane_is_scanned_and_taken_out() {
    for plane in PLANES {
        let setup = over(relief(|x, _| 0.75 * x), plane);
        let session = scanned(&setup, &rectangle(plane, EXACT, &[]));
        let axes = plane.axes();
        for (index, point) in session.cloud.points().iter().enumerate() {
            near(point[axes[2]], 0.75 * (point[axes[0]] - 15.0) + 0.25 * 3.0);
            let under = session.cloud.surface(session.layout(), index);
            assert!((under[axes[2]] - 0.75 * (under[axes[0]] - 15.0)).abs() < 1e-8, "{plane:?}");
        }
        assert_eq!(session.cloud.lines(), 5);
        assert!((session.deviation(0).greatest - 0.6).abs() < 1e-6); // 0.75 across the plane
        assert!(session.deviation(1).greatest < 1e-6);
    }
}

// oracle: hand: points R apart along the tangent, from one end of each line to the other, lines 3 apart
#[test]
fn lines_go_back_and_forth_at_their_distances() {
    let plane = Plane::G17;
    let setup = over(relief(|_, _| 0.0), plane);
    let session = scanned(&setup, &rectangle(plane, EXACT, &[]));
    let points = session.cloud.points();
    assert_eq!(points.len(), 5 * 21);
    for (index, point) in points.iter().enumerate() {
        let (line, place) = (index / 21, index % 21);
        let x = if line % 2 == 0 { place } else { 20 - place } as f64 * 1.5;
        near(point[0], x);
        near(point[1], 3.0 * line as f64);
        near(point[2], 0.0);
    }
    let steep = over(relief(|x, _| 0.75 * x), plane);
    let session = scanned(&steep, &rectangle(plane, EXACT, &[]));
    let [_, second, third, ..] = session.cloud.points() else { panic!() };
    near(third[0] - second[0], 1.5 * 0.8);
}

// oracle: hand: the ball centre keeps radius plus radius away from the centre of the sphere; its triangles have their
// corners on it, so that they lie within it by less than 0.02 mm
#[test]
fn a_sphere_is_recovered() {
    let size = 40.0_f64;
    let dome = relief(|x, y| (size * size - x * x - y * y).sqrt() - size);
    let setup = over(dome, Plane::G17);
    let session = scanned(&setup, &rectangle(Plane::G17, EXACT, &[]));
    for index in 0..session.cloud.points().len() {
        let [x, y, z]: [f64; 3] = session.cloud.surface(session.layout(), index).into();
        let away = ((x - 15.0).powi(2) + (y - 6.0).powi(2) + (z + size).powi(2)).sqrt();
        assert!((away - size).abs() < 0.02, "{index}: {away}");
    }
    assert!(session.deviation(0).greatest > 0.1);
    assert!(session.deviation(1).greatest < 0.02);
}

// oracle: hand: a point is wrong by 0.01 mm at most (C:1320), a direction then by that over 2 mm, at both ends
#[test]
fn points_that_lie_close_together_do_not_spoil_the_directions() {
    let flat = Heights::over([60.0, 40.0], [1, 1], |x, _| 0.5 * x).surface().unwrap();
    let setup = over(flat, Plane::G17);
    let mut values = rectangle(Plane::G17, "120", &[]);
    values[3].1 = "0.5".into();
    values[4].1 = "0.07".into();
    let session = scanned(&setup, &values);
    assert!(session.deviation(1).greatest < 0.06, "{:?}", session.deviation(1));
    assert!(session.deviation(1).greatest < session.deviation(0).greatest / 4.0);
}

// oracle: manual C:1318-1321
#[test]
fn the_feed_decides_over_the_accuracy() {
    let setup = over(relief(|x, y| (0.3 * x).sin() + (0.2 * y).cos()), Plane::G17);
    let exact = scanned(&setup, &rectangle(Plane::G17, EXACT, &[]));
    for (feed, accuracy) in [("12", 0.001), ("120", 0.01), ("1200", 0.1)] {
        let session = scanned(&setup, &rectangle(Plane::G17, feed, &[]));
        let first = |session: &Session| session.cloud.points()[0][2];
        let error = first(&exact) - first(&session);
        assert!((0.0..=accuracy).contains(&error), "F{feed}: {error}");
        let worst = session.deviation(0).greatest - exact.deviation(0).greatest;
        assert!(worst.abs() <= accuracy + 1e-6, "F{feed}: {worst}");
    }
}

// oracle: manual C:1280: below the deepest position nothing is looked for; a step is a wall on the way up
#[test]
fn nothing_deeper_than_the_deepest_position_and_walls_upwards() {
    let plane = Plane::G17;
    let step = |x: f64, _: f64| if x < 0.5 { -20.0 } else { 0.0 };
    let setup = over(relief(step), plane);
    let mut values = rectangle(plane, EXACT, &[]);
    values[2].1 = "-10".into();
    let session = scanned(&setup, &values);
    let points = session.cloud.points();
    assert!(points.iter().all(|point| point[2] > -10.0 - 1e-9));
    // the wall stands at 15.0 to 15.5 (a cell); the ball touches it from the side with its radius
    let wall: Vec<_> = points.iter().filter(|point| point[2] < -3.0 && point[1] == 0.0).collect();
    assert!(wall.len() >= 4, "{wall:?}");
    assert!(wall.iter().all(|point| (11.0..13.0).contains(&point[0])), "{wall:?}");
    assert!(points.iter().any(|point| point[0] == 30.0 && point[2].abs() < 1e-9));
    let empty = over(relief(|_, _| -100.0), plane);
    let nothing = outcome(&empty, &values);
    assert_eq!(nothing.stop, None);
    assert_eq!(nothing.control.number("POINTS"), 0.0);
}

// oracle: manual C:1330-1333
#[test]
fn one_spacing_of_the_plane() {
    let both = [("X", "1"), ("Y", "1"), ("Z", "-1"), ("I", "1"), ("J", "1"), ("R", "1"), ("Q", "1")];
    assert_eq!(codes(&P9969, &both, Plane::G17), [nct::FORMAT_ERROR]);
    let without = |name: &str| -> Vec<Code> {
        let values: Vec<_> = both.into_iter().filter(|(one, _)| *one != name && *one != "I").collect();
        codes(&P9969, &values, Plane::G17)
    };
    assert_eq!(without("I"), []);
    for name in ["X", "Y", "Z", "J", "R", "Q"] {
        assert_eq!(without(name), [nct::FORMAT_ERROR], "{name}");
    }
}

// oracle: manual C:1286-1307, the table of axes
#[test]
fn the_letter_says_which_axis_is_stepped_along() {
    for (plane, letter, axis_along) in [
        (Plane::G17, "J", 0),
        (Plane::G17, "I", 1),
        (Plane::G18, "I", 2),
        (Plane::G18, "K", 0),
        (Plane::G19, "K", 1),
        (Plane::G19, "J", 2),
    ] {
        let setup = over(relief(|_, _| 0.0), plane);
        let mut values = rectangle(plane, EXACT, &[]);
        values[3].0 = letter.into();
        let session = scanned(&setup, &values);
        assert_eq!(session.layout().axes[0], axis_along, "{plane:?} {letter}");
        let [first, second, ..] = session.cloud.points() else { panic!() };
        near((second[axis_along] - first[axis_along]).abs(), 1.5);
    }
}

// oracle: self: the program that is sent drives through the points that were scanned
#[test]
fn the_program_that_is_sent_runs_through_the_points() {
    let setup = over(relief(|x, y| 0.2 * x + (0.3 * y).sin()), Plane::G17);
    let session = scanned(&setup, &rectangle(Plane::G17, "60", &[("S", "1234")]));
    let all = session.cloud.points().len();
    let form = crate::scan::text::Form::Program;
    let text = crate::scan::text::piece(&session.cloud, session.layout(), form, 0..all);
    assert!(text.starts_with("%\nO1234\n"), "{text}");
    let program = crate::syntax::read(crate::dialect::Dialect::Nct, text.as_bytes());
    let mut empty = setup.clone();
    empty.workpiece.solids.clear();
    let run = crate::run::run(&program, &empty, crate::run::Limits::default());
    assert_eq!((run.stop, run.diagnostics), (None, Vec::new()));
    let ends: Vec<[f64; 3]> = run
        .trace
        .entries
        .iter()
        .filter_map(|entry| match entry.step {
            Step::Motion { to, feed, .. } if feed > 0.0 => Some(setup.control.to_workpiece(to).0),
            _ => None,
        })
        .collect();
    assert_eq!(ends.len(), all);
    for (end, point) in ends.iter().zip(session.cloud.points()) {
        assert!((0..3).all(|axis| (end[axis] - point[axis]).abs() <= 0.0005 + 1e-9));
    }
    let pieces: String = (0..all)
        .step_by(7)
        .map(|from| crate::scan::text::piece(&session.cloud, session.layout(), form, from..from + 7))
        .collect();
    assert_eq!(pieces, text);
}

// oracle: hand
#[test]
fn a_long_scan_is_told_in_part_and_has_a_limit() {
    let flat = Heights::over([60.0, 40.0], [1, 1], |_, _| 0.0);
    let setup = over(flat.surface().unwrap(), Plane::G17);
    let mut values = rectangle(Plane::G17, "1200", &[]);
    values[4].1 = "0.2".into();
    let run = outcome(&setup, &values);
    assert_eq!(run.stop, None);
    assert_eq!(run.control.number("POINTS"), 5.0 * 151.0);
    let says = |run: &Outcome, key: &str| run.decisions().iter().any(|message| message.key == key);
    assert!(says(&run, "decision-p9969-told"));
    assert!(run.log().len() < 600);
    values[4].1 = "0.005".into();
    let run = outcome(&setup, &values);
    assert_eq!(run.stop, None, "a form follows a part, and nothing is wrong with the call");
    assert!(says(&run, "decision-p9969-form"));
    assert_eq!(run.control.number("POINTS"), 0.0, "nobody knows how many");
    assert!(run.log().len() < 600, "only the first blocks");
}

// oracle: manual C:1335-1337
#[test]
fn what_it_looks_at_first() {
    let start = |change: fn(&mut Setup)| {
        let mut setup = over(relief(|_, _| 0.0), Plane::G17);
        change(&mut setup);
        outcome(&setup, &rectangle(Plane::G17, EXACT, &[])).stop
    };
    assert_eq!(start(|_| ()), None);
    let code = |code| Some(Stop::Alarm(code));
    assert_eq!(start(|setup| setup.control.edge = 0), code(nct::NO_TOOL_LENGTH));
    assert_eq!(start(|setup| stand(setup, [0.0, 0.0, -1.0])), code(nct::STYLUS_IN_CONTACT));
    assert_eq!(start(|setup| stand(setup, [0.0, 0.0, -40.0])), code(nct::STYLUS_IN_CONTACT));
    // a flank across the lines that rises by more than Q from one to the next (C:1337)
    let setup = over(relief(|_, y| 3.0 * y), Plane::G17);
    let mut values = rectangle(Plane::G17, EXACT, &[]);
    values[2].1 = "-60".into();
    assert_eq!(outcome(&setup, &values).stop, code(nct::STYLUS_IN_CONTACT));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    // oracle: definition: a ball that touches a surface is its radius away from it, and never nearer
    #[test]
    fn the_ball_never_enters_the_surface(
        (a, b, c) in (0.05..0.5_f64, 0.05..0.5_f64, 0.0..3.0_f64), steep in 0.5..6.0_f64, retract in 0.5..4.0_f64,
        raster in 0.7..3.0_f64,
    ) {
        let setup = over(relief(|x, y| steep * ((a * x + c).sin() + (b * y).cos())), Plane::G17);
        let mut values = rectangle(Plane::G17, "120", &[]);
        values[4].1 = raster.to_string();
        values[5].1 = retract.to_string();
        let run = outcome(&setup, &values);
        let part = Boundary::of(&setup.workpiece);
        for entry in &run.trace.entries {
            if let Step::Touch { ball, .. } = entry.step {
                prop_assert!((part.distance(ball) - 3.0).abs() < 1e-7);
            }
            if let Step::Motion { from, to, .. } = entry.step {
                for share in 0..=4 {
                    let at = |axis: usize| from[axis] + (to[axis] - from[axis]) * f64::from(share) / 4.0;
                    prop_assert!(part.distance(Mcs([at(0), at(1), at(2) + 3.0])) > 3.0 - 1e-7);
                }
            }
        }
        // A flank may rise by more than Q over one spacing, and a valley be narrower than the ball (C:1337-1338).
        let cramped = [nct::STYLUS_IN_CONTACT, nct::SCANNING_OBSTRUCTED].map(|code| Some(Stop::Alarm(code)));
        prop_assert!(run.stop.is_none() || cramped.contains(&run.stop), "{:?}", run.stop);
    }
}
