//! A frame that is corrected while another one is active, tilted against it or mirrored: what was measured, at the
//! height at which it was touched, gets the set coordinates (B:6153-6155).

use super::bench::{PLANES, Values, at, inputs, near, place, result, run, with};
use probewright_core::control::{Control, Frame, Plane, Units};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Dir, Mcs, Rpy};
use probewright_core::machine::Setup;
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use probewright_core::workpiece::PartErrors;

/// How far the part stands beside its place, abscissa, ordinate, applicate.
const SHIFT: [f64; 3] = [0.4, -0.3, 0.2];

/// A coordinate of the plane that is measured: 0 abscissa, 1 ordinate, 2 applicate; results `_OVR[]` with the actual
/// value and the setpoint.
type Coordinate = (usize, usize, usize);

/// A call.
struct Call {
    name: &'static str,
    values: Values,
    measured: Vec<Coordinate>,
    /// Whether the part looks the same from both sides of what is measured, so that it has the same middle in a frame
    /// that is tilted.
    even: bool,
}

/// Holes, shafts, grooves and webs, faces, corners.
fn calls() -> Vec<Call> {
    let common = vec![
        ("_SETVAL", 60.0),
        ("_SETV[0]", 60.0),
        ("_SETV[1]", 44.0),
        ("_SZA", 20.0),
        ("_SZO", 20.0),
        ("_ID", -25.0),
        ("_FA", 9.0),
        ("_TSA", 3.0),
        ("_CPA", 12.0),
        ("_CPO", -7.0),
        ("_STA1", 25.0),
        ("_INCA", 80.0),
        ("_RF", 900.0),
    ];
    let call = |name, more: &[(&'static str, f64)], measured: &[Coordinate], even| Call {
        name,
        values: with(&common, more),
        measured: measured.to_vec(),
        even,
    };
    let both: &[Coordinate] = &[(0, 5, 1), (1, 6, 2)];
    let sides: &[Coordinate] = &[(0, 6, 2), (1, 7, 3)];
    let mut calls = Vec::new();
    for (variant, measured, even) in [
        (101.0, both, true),
        (1101.0, both, false), // what stands in the zone would be met from a tilted way
        (102.0, both, true),
        (106.0, sides, true),
    ] {
        calls.push(call("CYCLE977", &[("_MVAR", variant)], measured, even));
    }
    for (variant, axis, measured) in [(103.0, 1.0, both[0]), (104.0, 2.0, both[1])] {
        let values = [("_MVAR", variant), ("_MA", axis)];
        calls.push(call("CYCLE977", &values, &[measured], true));
    }
    for (variant, lift) in [(101.0, 0.0), (104.0, 25.0)] {
        calls.push(call("CYCLE979", &[("_MVAR", variant), ("_ID", lift)], both, false));
    }
    for axis in 1..=3 {
        let values = [("_MVAR", 100.0), ("_MA", f64::from(axis))];
        calls.push(call("CYCLE978", &values, &[(axis as usize - 1, 4, 0)], false));
    }
    let corner = [
        ("_MVAR", 118.0),
        ("_SETV[0]", 50.0),
        ("_SETV[1]", 20.0),
        ("_SETV[2]", 150.0),
        ("_SETV[3]", 20.0),
        ("_SETV[4]", 15.0),
        ("_SETV[5]", 40.0),
        ("_SETV[6]", 15.0),
        ("_SETV[7]", 80.0),
        ("_ID", -60.0),
        ("_FA", 60.0),
    ];
    calls.push(call("CYCLE961", &corner, &[(0, 5, 0), (1, 6, 0)], false));
    calls
}

/// What is corrected: `_KNUM`, and the settable frame with which it counts. In the last one the applicate runs
/// downwards.
const TARGETS: [(f64, usize); 4] = [(2.0, 2), (3.0, 3), (1000.0, 0), (4.0, 4)];

/// G54 moves, mirrored it turns an axis round; the other frames are tilted, and mirrored too.
fn machine(plane: Plane, mirror: [bool; 3]) -> Setup {
    let mut setup = Setup::calibrated_in(Dialect::Sinumerik, plane, Units::Metric);
    let mut put = |number: usize, rotation, mirrored: usize| {
        let mut frame =
            Frame { rotation: Rpy(at(plane, rotation)), ..Frame::translation([7.0 * number as f64, -9.0, 4.0]) };
        if let Some(axis) = plane.axes().get(mirrored) {
            frame.mirror[*axis] = true;
        }
        setup.control.frames.insert(number, frame);
    };
    put(0, [-6.0, 3.0, 20.0], 1);
    put(2, [10.0, -7.0, 15.0], 3);
    put(3, [5.0, 8.0, -20.0], 0);
    put(4, [5.0, 8.0, -20.0], 2);
    let active = Frame { mirror, ..Frame::translation([40.0, 30.0, 20.0]) };
    setup.control.frames.insert(1, active);
    let basic = Frame::translation([10.0, 0.0, 2.0]);
    setup.control.stored.channel.insert(0, basic);
    setup.control.activate(1);
    // the frame leans by some degree, and a straight one would meet the part above the ball
    setup.probe.stylus = Some(0.0);
    setup
}

/// A probe that stands beside the spindle axis and whose length ends at the lowest point of its ball, calibrated.
fn askew(setup: &mut Setup) {
    let skew = [0.3, -0.2];
    setup.probe.skew = skew;
    let control = &mut setup.control;
    control.set("_CBIT[14]", 1.0);
    assert!(control.set_variable("$TC_DP3[9,1]", 53.0));
    let data = [6.0, 3.0 - skew[0], -3.0 - skew[0], 3.0 - skew[1], -3.0 - skew[1], 0.0, -6.0, skew[0], skew[1]];
    for (index, value) in data.into_iter().enumerate() {
        control.set(format!("_WP[0,{index}]"), value);
    }
}

/// Puts the part of a call beside its place, and corrects.
fn corrected(setup: &mut Setup, call: &Call, code: f64) -> Outcome {
    let plane = setup.control.plane;
    let inputs = inputs(setup, call.name, &with(&call.values, &[("_KNUM", code)]));
    let errors =
        PartErrors { shift: setup.control.direction_to_machine(Dir::new(at(plane, SHIFT))).0, ..PartErrors::default() };
    place(setup, &inputs, errors);
    run(setup, &inputs)
}

/// Where the ball stood at the touches, their mean: machine. Of what is measured on one side alone, or from both.
fn balls(outcome: &Outcome) -> [f64; 3] {
    let entries = outcome.trace.entries.iter();
    let touched: Vec<[f64; 3]> = entries
        .filter_map(|entry| match entry.step {
            Step::Touch { ball, .. } => Some(ball.0),
            _ => None,
        })
        .collect();
    let sum = |axis: usize| touched.iter().map(|ball| ball[axis]).sum::<f64>();
    [0, 1, 2].map(|axis| sum(axis) / touched.len() as f64)
}

/// What was measured, machine: where the ball stood, in the measured axes what the cycle found. Read in the WCS that
/// was active.
fn found(setup: &Setup, call: &Call, control: &Control, outcome: &Outcome) -> [f64; 3] {
    let mut point = control.to_workpiece(Mcs(balls(outcome)));
    for (axis, actual, _) in &call.measured {
        point[setup.control.plane.axes()[*axis]] = result(setup, *actual);
    }
    control.to_machine(point).0
}

fn what(plane: Plane, mirror: [bool; 3], code: f64, call: &Call) -> String {
    format!("{plane:?} {mirror:?} _KNUM={code} {} {:?}", call.name, call.values)
}

const MIRRORS: [[bool; 3]; 3] = [[false; 3], [true, false, false], [false, true, true]];

// oracle: hand: the ball as it stood at the touches gives the coordinates that were not measured; B:6153-6155 what has
// to be
#[test]
fn the_measured_point_has_the_set_coordinates_in_any_frame() {
    for (plane, mirror) in PLANES.into_iter().flat_map(|plane| MIRRORS.map(|m| (plane, m))) {
        for (code, settable) in TARGETS {
            for call in calls() {
                let what = what(plane, mirror, code, &call);
                let mut setup = machine(plane, mirror);
                askew(&mut setup);
                let control = setup.control.clone();
                let outcome = corrected(&mut setup, &call, code);
                let point = found(&setup, &call, &control, &outcome);
                let sets: Vec<f64> = match call.name {
                    "CYCLE961" => vec![0.0, 0.0],
                    _ => call.measured.iter().map(|(_, _, set)| result(&setup, *set)).collect(),
                };
                setup.control.activate(settable);
                let seen = setup.control.to_workpiece(Mcs(point));
                for ((axis, ..), set) in call.measured.iter().zip(sets) {
                    near(seen[plane.axes()[*axis]], set, 1e-9, &what);
                }
            }
        }
    }
}

// oracle: hand: an even part has one middle, from whatever side it is touched: measured again about the point that was
// measured, with the corrected frame active, nothing is wrong
#[test]
fn measured_again_in_the_tilted_frame_nothing_is_wrong() {
    for plane in PLANES {
        for (code, settable) in TARGETS.into_iter().take(3) {
            for call in calls().iter().filter(|call| call.even) {
                let what = what(plane, [false; 3], code, call);
                let mut setup = machine(plane, [false; 3]);
                let control = setup.control.clone();
                let outcome = corrected(&mut setup, call, code);
                let point = found(&setup, call, &control, &outcome);
                setup.control.activate(settable);
                let axes = plane.axes();
                let mut start = setup.control.to_workpiece(Mcs(point));
                for (axis, _, set) in &call.measured {
                    near(start[axes[*axis]], result(&setup, *set), 1e-9, &what);
                }
                let inputs = inputs(&setup, call.name, &with(&call.values, &[("_KNUM", code)]));
                start[axes[2]] -= if inputs.variant % 2 == 1 { 0.0 } else { -25.0 };
                setup.position = setup.control.to_machine(start);
                run(&mut setup, &inputs);
                for (_, actual, set) in &call.measured {
                    near(result(&setup, *actual), result(&setup, *set), 1e-9, &what);
                }
            }
        }
    }
}

// oracle: hand, as above; in the turret the ball stands beside the place to which the tool lengths lead, too. A
// diameter is twice the coordinate X
#[test]
fn on_a_lathe_the_place_of_the_ball_counts_as_well() {
    for (axis, set) in [(1.0, -10.0), (2.0, 40.0)] {
        let mut setup = Setup::turning(Plane::G18);
        let skew = [0.3, -0.2];
        setup.probe.skew = skew;
        for (index, value) in [
            (1, 3.0 - skew[0]),
            (2, -3.0 - skew[0]),
            (3, 3.0 - skew[1]),
            (4, -3.0 - skew[1]),
            (7, skew[0]),
            (8, skew[1]),
        ] {
            setup.control.set(format!("_WP[0,{index}]"), value);
        }
        let frame = |origin, rotation| Frame { rotation: Rpy(rotation), ..Frame::translation(origin) };
        let frames = &mut setup.control.frames;
        frames.insert(1, frame([0.0, 0.0, 20.0], [0.0; 3]));
        frames.insert(2, frame([1.0, 0.0, -5.0], [0.0, 3.0, 0.0]));
        setup.control.activate(1);
        let values = vec![("_MVAR", 100.0), ("_MA", axis), ("_SETVAL", set), ("_FA", 5.0), ("_TSA", 3.0)];
        let call = Call { name: "CYCLE974", values, measured: Vec::new(), even: false };
        let control = setup.control.clone();
        let outcome = corrected(&mut setup, &call, 2.0);
        let geometry = Plane::G18.axes()[axis as usize - 1];
        let per = if geometry == 0 { 2.0 } else { 1.0 };
        let mut point = control.to_workpiece(Mcs(balls(&outcome)));
        point[geometry] = result(&setup, 4) / per;
        assert!(result(&setup, 16).abs() > 0.1, "nothing was wrong");
        let point = control.to_machine(point);
        setup.control.activate(2);
        near(setup.control.to_workpiece(point)[geometry], set / per, 1e-9, "lathe");
    }
}

// oracle: hand: measured 10 mm below the zero of G54. Seen from G55, which is turned by 10 degree about Y, that point
// lies at X 10·sin 10° = 1.736; to be at 0, G55 goes there along its own X, whose share of the X of G54 is cos 10°
#[test]
fn the_height_of_the_touches_counts_not_that_of_the_start() {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let tilted = Frame { rotation: Rpy([0.0, 10.0, 0.0]), ..Frame::default() };
    setup.control.frames.insert(2, tilted);
    setup.control.activate(1);
    let values = [("_MVAR", 102.0), ("_SETVAL", 60.0), ("_ID", -40.0), ("_FA", 5.0), ("_KNUM", 2.0)];
    let inputs = inputs(&setup, "CYCLE977", &values);
    place(&mut setup, &inputs, PartErrors::default());
    setup.position = Mcs([0.0, 0.0, 30.0]);
    run(&mut setup, &inputs);
    let origin = |axis: usize| setup.control.frames[&2].origin()[axis];
    let (sine, cosine) = 10_f64.to_radians().sin_cos();
    near(origin(0), 10.0 * sine * cosine, 1e-9, "X");
    near(origin(0), 1.710, 5e-4, "X, as far as the finding told it");
    near(origin(2), -10.0 * sine * sine, 1e-9, "Z");
}
