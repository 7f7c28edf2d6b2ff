//! A corrected zero offset, activated, leaves nothing to correct, in whatever frame the correction was put.

use super::bench::{PLANES, Values, at, inputs, near, place, result, run, with};
use probewright_core::control::{Frame, Plane, Units};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Dir, Rpy};
use probewright_core::machine::Setup;
use probewright_core::workpiece::PartErrors;

/// What the cycle is told to correct, and what has to be active for it.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    code: f64,
    /// Settable frame in use: 0 for G500.
    pub settable: usize,
    /// Where it is kept.
    name: &'static str,
}

/// Every sort of `_KNUM` (B:1930-1969): settable frames, channel and global basic frames, the system frame, the active
/// frame with and without a settable one.
pub const TARGETS: [Target; 8] = [
    target(1.0, 1, "$P_UIFR[1]"),
    target(5.0, 5, "$P_UIFR[5]"),
    target(1011.0, 1, "$P_CHBFR[0]"),
    target(1051.0, 1, "$P_NCBFR[0]"),
    target(2000.0, 1, "$P_SETFR"),
    target(9999.0, 1, "$P_UIFR[1]"),
    target(9999.0, 0, "$P_CHBFR[1]"),
    target(1000.0, 0, "$P_CHBFR[1]"),
];

const fn target(code: f64, settable: usize, name: &'static str) -> Target {
    Target { code, settable, name }
}

/// How far the part stands beside its place, abscissa, ordinate, applicate.
const SHIFT: [f64; 3] = [0.4, -0.3, 0.2];
/// How it is turned where an angle is measured, about abscissa, ordinate, applicate, degree.
const TILT: [f64; 3] = [0.3, -0.2, 0.5];

/// A frame that moves and turns.
fn frame(origin: [f64; 3], rotation: [f64; 3]) -> Frame {
    Frame { fine: [0.01, 0.02, -0.01], rotation: Rpy(rotation), ..Frame::translation(origin) }
}

/// A machine with every sort of frame in its chain, most of them turned.
fn machine(plane: Plane, units: Units, settable: usize) -> Setup {
    let mut setup = Setup::calibrated_in(Dialect::Sinumerik, plane, units);
    let control = &mut setup.control;
    control.stored.system = frame([1.0, -2.0, 3.0], [0.0, 0.0, 4.0]);
    control.stored.global.insert(0, Frame::translation([5.0, 6.0, -7.0]));
    control.stored.channel.insert(0, frame([10.0, 0.0, 2.0], [-3.0, 0.0, 20.0]));
    control.stored.channel.insert(1, frame([0.0, 8.0, 1.0], [0.0, 7.0, 0.0]));
    control.frames.insert(0, frame([7.0, -9.0, 4.0], [0.0, 0.0, 6.0])); // of G500
    control.frames.insert(1, frame([40.0, 30.0, 20.0], [0.0, 5.0, -15.0]));
    control.frames.insert(5, frame([-60.0, 15.0, 9.0], [2.0, 0.0, 33.0]));
    control.program_frame = Frame { rotation: Rpy([0.0, 0.0, 10.0]), ..Frame::translation([3.0, 2.0, 1.0]) };
    control.activate(settable);
    setup.probe.stylus = Some(0.0); // the part leans by some degree, and a straight one would meet it above the ball
    setup
}

/// A call, and which results are differences to be zero afterwards.
pub type Call = (&'static str, Values, &'static [usize]);

/// Every sort of measurement that corrects a place or an angle.
fn calls() -> Vec<Call> {
    let mut calls = places();
    calls.extend(spheres());
    calls.extend(angles());
    calls
}

/// One sphere, and three, which turn the frame too.
fn spheres() -> Vec<Call> {
    let centres = [
        ("_SETV[0]", 10.0),
        ("_SETV[1]", 20.0),
        ("_SETV[2]", -5.0),
        ("_SETV[3]", 170.0),
        ("_SETV[4]", 40.0),
        ("_SETV[5]", -5.0),
        ("_SETV[6]", 80.0),
        ("_SETV[7]", 190.0),
        ("_SETV[8]", -5.0),
    ];
    let common = [("_SETVAL", 40.0), ("_FA", 5.0), ("_TSA", 5.0)];
    let values =
        |variant: f64, of: &[(&'static str, f64)]| -> Values { with(&with(&common, &[("_MVAR", variant)]), of) };
    vec![
        ("CYCLE997", values(109.0, &centres[..3]), &[9, 10, 11]),
        ("CYCLE997", values(10_109.0, &centres), &[9, 10, 11, 17, 18, 19, 25, 26, 27]),
    ]
}

/// An edge, and an oblique plane.
fn angles() -> Vec<Call> {
    let common = [("_MA", 102.0), ("_ID", 40.0), ("_FA", 12.0), ("_TSA", 3.0)];
    let edge = [("_MVAR", 105.0), ("_SETVAL", -18.0), ("_STA1", 5.0), ("_RA", 0.0)];
    let plane =
        [("_MVAR", 106.0), ("_SETVAL", 30.0), ("_SETV[0]", 30.0), ("_STA1", 8.0), ("_INCA", 12.0), ("_MD", 1.0)];
    vec![("CYCLE998", with(&common, &edge), &[16]), ("CYCLE998", with(&common, &plane), &[16, 17])]
}

/// Elements and faces.
fn places() -> Vec<Call> {
    let common = vec![
        ("_SETVAL", 60.0),
        ("_SETV[0]", 60.0),
        ("_SETV[1]", 44.0),
        ("_ID", -25.0),
        ("_FA", 5.0),
        ("_TSA", 3.0),
        ("_CPA", 12.0),
        ("_CPO", -7.0),
        ("_STA1", 25.0),
        ("_INCA", 80.0),
        ("_RF", 900.0),
    ];
    let mut calls = Vec::new();
    for (variant, axis) in [(101, 1), (102, 1), (103, 2), (104, 1), (106, 1)] {
        let values = with(&common, &[("_MVAR", f64::from(variant)), ("_MA", f64::from(axis))]);
        let differences: &[usize] = if variant > 104 { &[18, 19] } else { &[17, 18] };
        calls.push(("CYCLE977", values, differences));
    }
    for axis in 1..=3 {
        let values = with(&common, &[("_MVAR", 100.0), ("_MA", f64::from(axis))]);
        calls.push(("CYCLE978", values, &[16]));
    }
    for variant in [101, 104] {
        let values = with(&common, &[("_MVAR", f64::from(variant)), ("_ID", 25.0)]);
        calls.push(("CYCLE979", values, &[17, 18]));
    }
    calls
}

/// Measures and corrects, makes the frame active and measures again from the same place of the workpiece system.
pub fn closed(mut setup: Setup, target: Target, (name, values, differences): &Call) -> Setup {
    let what = format!("{target:?} {name} {values:?}");
    let plane = setup.control.plane;
    let tilt = if *name == "CYCLE998" { TILT } else { [0.0; 3] };
    let inputs = inputs(&setup, name, &with(values, &[("_KNUM", target.code)]));
    let errors = PartErrors {
        shift: setup.control.direction_to_machine(Dir::new(at(plane, SHIFT))).0,
        tilt: Rpy(setup.control.direction_to_machine(Dir::new(at(plane, tilt))).0),
        ..PartErrors::default()
    };
    place(&mut setup, &inputs, errors);
    let start = setup.control.to_workpiece(setup.position);
    let first = run(&mut setup, &inputs);
    let changes = first.changes();
    assert!(!changes.is_empty(), "{what}");
    for change in changes {
        let stem = target.name.trim_end_matches(']');
        assert!(change.name.starts_with(stem), "{what} {}", change.name);
    }
    let found: f64 = differences.iter().map(|i| result(&setup, *i).abs()).sum();
    assert!(found > 0.1, "{what}: nothing was wrong");
    if target.code != 9999.0 {
        setup.control.activate(target.settable);
    }
    setup.position = setup.control.to_machine(start);
    run(&mut setup, &inputs);
    for index in *differences {
        near(result(&setup, *index), 0.0, 1e-9, &what);
    }
    setup
}

// oracle: hand (manual B:6153: afterwards the measured point has the set coordinates). Each plane has its turn with a
// third of the calls.
#[test]
fn measured_again_nothing_is_wrong() {
    for (index, plane) in PLANES.into_iter().enumerate() {
        for (number, target) in TARGETS.into_iter().enumerate() {
            let turn = (index + number) % PLANES.len();
            for call in calls().into_iter().skip(turn).step_by(PLANES.len()) {
                let rotates = call.0 == "CYCLE998" || call.1.contains(&("_MVAR", 10_109.0));
                if rotates && target.name.starts_with("$P_NCBFR") {
                    continue; // global basic frames take no rotation, B:1971
                }
                let units = [Units::Metric, Units::Inch][index % 2];
                closed(machine(plane, units, target.settable), target, &call);
            }
        }
    }
}

// oracle: manual B:1990-2003, B:14039 (fine part; coarse part with the fine one taken into it on demand, without fine
// parts on the machine, and in the system frame)
#[test]
fn fine_or_coarse_the_correction_is_the_same() {
    let call = &calls()[0];
    for target in TARGETS {
        let mut seen = Vec::new();
        for (datum, value) in [("", 0.0), ("_CHBIT[21]", 1.0), ("MD18600", 0.0)] {
            let mut setup = machine(Plane::G17, Units::Metric, target.settable);
            if !datum.is_empty() {
                setup.control.set(datum, value);
            }
            let setup = closed(setup, target, call);
            let component = |part: &str| setup.control.variable(&component_name(target.name, part));
            let (coarse, fine) = (component("TR").unwrap(), component("FI").unwrap());
            let into_coarse = !datum.is_empty() || target.code == 2000.0;
            assert_eq!(fine == 0.0, into_coarse, "{target:?} {datum}");
            seen.push(coarse + fine);
        }
        near(seen[1], seen[0], 1e-9, "coarse");
        near(seen[2], seen[0], 1e-9, "without fine parts");
    }
}

/// `$P_UIFR[1,X,TR]`, `$P_SETFR[X,TR]`.
fn component_name(frame: &str, part: &str) -> String {
    match frame.strip_suffix(']') {
        Some(stem) => format!("{stem},X,{part}]"),
        None => format!("{frame}[X,{part}]"),
    }
}
