//! A probe that the control believes to be ideal measures wrong as theory says; calibrated with CYCLE976 it measures
//! right.
//!
//! Where the numbers come from: the control takes the default trigger points, 3 mm, and no skew. The ball of radius
//! `r` really switches `t` behind the contact, with the spindle `s` beside it. Between two walls that makes the size
//! `2·(3 - r + t)` larger inside and smaller outside, and the middle wrong by `-s`.

use super::bench::{PLANES, Values, at, call, near, result, with};
use probewright_core::control::{Plane, Units};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Rpy;
use probewright_core::machine::Setup;
use probewright_core::machine::calibrated::ProbeInCall;
use probewright_core::workpiece::{PartErrors, Probe};

const RADIUS: f64 = 2.96;
const SKEW: [f64; 2] = [0.05, -0.03];
const LATE: f64 = 0.02;
/// L1 is entered as 50.
const LENGTH: f64 = 50.04;
/// What the control believes the ball to be too large by, with the late signal.
const WRONG: f64 = 3.0 - RADIUS + LATE;
const SIZE: f64 = 60.0;
const WIDTH: f64 = 44.0;
const RING: f64 = 80.0;
/// What remains of a calibrated multi probe: late signals on a chord count as if the wall were further away, by
/// `t·s²/2ρ²` = 0.02·0.05²/(2·37²) = 2e-8 mm.
const REMAINS: f64 = 1e-7;

/// A machine with the probe in it.
#[derive(Clone, Copy, Debug)]
struct Rig {
    plane: Plane,
    units: Units,
    mono: bool,
}

/// All planes with both sorts of probe, and an inch machine.
fn rigs() -> Vec<Rig> {
    let metric = PLANES.map(|plane| (plane, Units::Metric));
    let all = metric.into_iter().chain([(Plane::G18, Units::Inch)]);
    all.flat_map(|(plane, units)| [false, true].map(|mono| Rig { plane, units, mono })).collect()
}

impl Rig {
    fn setup(self) -> Setup {
        let mut setup = Setup::calibrated_in(Dialect::Sinumerik, self.plane, self.units);
        setup.probe = Probe { radius: RADIUS, skew: SKEW, pre_travel: (LATE, 0.0), length: LENGTH, ..setup.probe };
        setup
    }

    /// Values of every call.
    fn common(self) -> Values {
        let probe = if self.mono { 101.0 } else { 1.0 };
        vec![("_PRNUM", probe), ("_FA", 4.0), ("_TSA", 2.0), ("_KNUM", 0.0)]
    }

    /// Ring, with skew and ball, which also goes into the tool.
    fn calibrate(self, setup: &mut Setup, variant: i64, start_angle: f64) {
        setup.control.set("_CBIT[15]", 1.0);
        let values = with(
            &self.common(),
            &[("_MVAR", variant as f64), ("_SETVAL", RING), ("_STA1", start_angle), ("_TZL", 0.0)],
        );
        let mut errors = PartErrors::default();
        if variant % 10 == 8 {
            errors.shift = at(self.plane, [0.3, -0.2, 0.0]);
        }
        call(setup, "CYCLE976", &values, errors);
    }

    /// How far from the middle of two walls the spindle stands when the probe switches, `size` apart: against a round
    /// wall a mono probe stands on a chord, as its skew turns with it.
    fn reach(self, size: f64, inside: bool, round: bool) -> f64 {
        let along = if self.mono { SKEW[0] } else { 0.0 };
        let across = if self.mono && round { SKEW[1] } else { 0.0 };
        let chord = |radius: f64| (radius * radius - across * across).sqrt();
        match inside {
            true => chord(size / 2.0 - RADIUS) + LATE - along,
            false => chord(size / 2.0 + RADIUS) - LATE + along,
        }
    }

    /// By how much a size is measured wrong with a ball that is taken to be so large.
    fn wrong(self, size: f64, inside: bool, round: bool, ball: f64) -> f64 {
        let sign = if inside { 1.0 } else { -1.0 };
        2.0 * (self.reach(size, inside, round) + sign * ball) - size
    }

    /// The ball that a calibration in the ring finds.
    fn ball(self) -> f64 {
        RING / 2.0 - self.reach(RING, true, true)
    }

    fn skew(self) -> [f64; 2] {
        if self.mono { [0.0; 2] } else { SKEW }
    }
}

/// An element of CYCLE977 or CYCLE979.
fn element(rig: Rig, variant: i64, more: &[(&'static str, f64)]) -> Values {
    let inside = variant % 2 == 1;
    let zone = if inside { 20.0 } else { 110.0 };
    let sizes = with(
        &rig.common(),
        &[
            ("_MVAR", variant as f64),
            ("_SETVAL", SIZE),
            ("_SETV[0]", SIZE),
            ("_SETV[1]", WIDTH),
            ("_ID", -25.0),
            ("_SZA", zone),
            ("_SZO", zone),
        ],
    );
    with(&sizes, more)
}

/// Measures every element along the axes and holds the errors against theory.
fn along_the_axes(rig: Rig, setup: &mut Setup, ball: f64, skew: [f64; 2], tolerance: f64) {
    for variant in [101, 102, 103, 104, 105, 106, 1101, 1106] {
        let (kind, inside) = (variant % 10, variant % 2 == 1);
        let single = matches!(kind, 3 | 4);
        for axis in [1, 2] {
            if axis == 2 && !single {
                continue;
            }
            let values = element(rig, variant, &[("_MA", f64::from(axis))]);
            call(setup, "CYCLE977", &values, PartErrors::default());
            let what = format!("{rig:?} CYCLE977 {variant} {axis}");
            let round = kind <= 2;
            let size = |set: f64| rig.wrong(set, inside, round, ball);
            near(result(setup, 16), size(SIZE), tolerance, &what);
            let centre = if kind >= 5 {
                near(result(setup, 17), size(WIDTH), tolerance, &what);
                18
            } else {
                17
            };
            for (index, skew) in skew.into_iter().enumerate() {
                let measured = !single || index as i32 + 1 == axis;
                let wrong = if measured { -skew } else { 0.0 };
                near(result(setup, centre + index), wrong, tolerance, &what);
            }
        }
    }
}

/// Measures round and flat elements at an angle.
fn at_an_angle(rig: Rig, setup: &mut Setup, ball: f64, skew: [f64; 2], tolerance: f64) {
    let (start, step) = (25.0_f64, 80.0);
    let (sine, cosine) = start.to_radians().sin_cos();
    for variant in [101, 102, 103, 104] {
        let round = variant % 10 <= 2;
        let more = [("_STA1", start), ("_INCA", step), ("_RF", 900.0), ("_CPA", 0.0), ("_CPO", 0.0), ("_ID", 25.0)];
        let values = element(rig, variant, &more);
        call(setup, "CYCLE979", &values, PartErrors::default());
        let what = format!("{rig:?} CYCLE979 {variant}");
        let size = rig.wrong(SIZE, variant % 2 == 1, round, ball);
        near(result(setup, 16), size, tolerance, &what);
        // a groove tells its middle only in the direction in which it was touched
        let along = skew[0] * cosine + skew[1] * sine;
        let flat = [along * cosine, along * sine];
        for (index, wrong) in if round { skew } else { flat }.into_iter().enumerate() {
            near(result(setup, 17 + index), -wrong, tolerance, &what);
        }
    }
}

/// Error of a face: along the axes in plus direction, from above, and by turning the spindle.
fn faces(rig: Rig, setup: &mut Setup, expected: [f64; 4], tolerance: f64) {
    for (axis, wrong) in [1.0, 2.0, 3.0].into_iter().zip(expected) {
        let values = face(rig, 100.0, axis);
        call(setup, "CYCLE978", &values, PartErrors::default());
        near(result(setup, 16), wrong, tolerance, &format!("{rig:?} {axis}"));
    }
    for axis in [1.0, 2.0] {
        if !rig.mono {
            let mut setup = setup.clone(); // it overwrites trigger point and skew
            call(&mut setup, "CYCLE978", &face(rig, 1100.0, axis), PartErrors::default());
            let what = format!("{rig:?} differential {axis}");
            near(result(&setup, 16), expected[3], tolerance, &what);
        }
    }
}

fn face(rig: Rig, variant: f64, axis: f64) -> Values {
    with(&rig.common(), &[("_MVAR", variant), ("_SETVAL", 20.0), ("_MA", axis)])
}

// oracle: hand (head of this file)
#[test]
fn an_uncalibrated_probe_is_wrong_as_theory_says() {
    for rig in rigs() {
        let mut setup = rig.setup();
        along_the_axes(rig, &mut setup, 3.0, rig.skew(), 1e-9);
        // at an angle the late signal does not lie square to the wall: t·s²/ρ²
        at_an_angle(rig, &mut setup, 3.0, rig.skew(), 1e-6);
        let [x, y] = if rig.mono { [SKEW[0]; 2] } else { SKEW };
        let above = LENGTH - 50.0 - WRONG;
        faces(rig, &mut setup, [WRONG - x, WRONG - y, above, WRONG], 1e-9);
    }
}

// oracle: hand: nothing is left but chords of a mono probe, which differ between ring and part
#[test]
fn a_calibrated_probe_is_right() {
    for rig in rigs() {
        for variant in [10_101, 10_108] {
            let mut setup = rig.setup();
            rig.calibrate(&mut setup, variant, 0.0);
            along_the_axes(rig, &mut setup, rig.ball(), [0.0; 2], REMAINS);
            at_an_angle(rig, &mut setup, rig.ball(), [0.0; 2], 1e-6);
            let left = rig.ball() - (RADIUS - LATE + if rig.mono { SKEW[0] } else { 0.0 });
            let values = with(&face(rig, 0.0, 3.0), &[("_MD", 1.0)]);
            call(&mut setup, "CYCLE976", &values, PartErrors::default());
            faces(rig, &mut setup, [left, left, 0.0, 0.0], REMAINS);
        }
    }
}

// oracle: hand (head of this file): each of the four deviations alone makes a size, a middle or a face wrong; a
// calibration finds all of them
#[test]
fn the_data_fit_a_probe_that_measures_right_and_no_other() {
    for rig in rigs() {
        let fits = |setup: &Setup| setup.calibration_fits(ProbeInCall { field: 1, mono: rig.mono, measures: true });
        let ideal = Setup::calibrated_in(Dialect::Sinumerik, rig.plane, rig.units);
        assert!(fits(&ideal), "{rig:?}");
        let probe = ideal.probe;
        for wrong in [
            Probe { radius: 2.99, ..probe },
            Probe { skew: [0.01, 0.0], ..probe },
            Probe { pre_travel: (0.01, 0.0), ..probe },
            Probe { length: LENGTH, ..probe },
        ] {
            assert!(!fits(&Setup { probe: wrong, ..ideal.clone() }), "{rig:?} {wrong:?}");
        }
        let mut setup = rig.setup();
        rig.calibrate(&mut setup, 10_108, 0.0);
        assert!(!fits(&setup), "{rig:?}: nothing was touched from above");
        let values = with(&face(rig, 0.0, 3.0), &[("_MD", 1.0)]);
        call(&mut setup, "CYCLE976", &values, PartErrors::default());
        assert!(fits(&setup), "{rig:?}");
        let another = ProbeInCall { field: 2, mono: rig.mono, measures: true };
        assert!(!setup.calibration_fits(another), "{rig:?}: of another probe nothing was found");
    }
}

// oracle: hand: with the ball known exactly the length is what the upper face tells
#[test]
fn a_probe_whose_length_was_found_is_right_from_above() {
    for rig in rigs() {
        let mut setup = rig.setup();
        rig.calibrate(&mut setup, 10_101, 0.0);
        let values = with(&face(rig, 10_000.0, 3.0), &[("_MD", 1.0)]);
        call(&mut setup, "CYCLE976", &values, PartErrors::default());
        let length = setup.control.active_length()[rig.plane.axes()[2]];
        let ball = rig.ball();
        near(length, LENGTH + RADIUS - LATE - ball, REMAINS, "L1");
        call(&mut setup, "CYCLE978", &face(rig, 100.0, 3.0), PartErrors::default());
        near(result(&setup, 16), 0.0, 1e-9, &format!("{rig:?}"));
    }
}

// oracle: hand: trigger points along the turned axes hold the skew along these; CYCLE979 takes ball and skew, which are
// the same whatever the angle
#[test]
fn calibrated_at_an_angle_the_probe_is_right_at_any_angle_and_along_the_turned_axes() {
    let angle = 30.0_f64;
    let (sine, cosine) = angle.to_radians().sin_cos();
    let turned = [SKEW[0] * cosine + SKEW[1] * sine, SKEW[1] * cosine - SKEW[0] * sine];
    for plane in PLANES {
        for variant in [110_101, 110_108] {
            let rig = Rig { plane, units: Units::Metric, mono: false };
            let mut setup = rig.setup();
            rig.calibrate(&mut setup, variant, angle);
            at_an_angle(rig, &mut setup, rig.ball(), [0.0; 2], 1e-6);
            let hole = element(rig, 101, &[]);
            call(&mut setup, "CYCLE977", &hole, PartErrors::default());
            for index in 0..2 {
                let wrong = turned[index] - SKEW[index];
                near(result(&setup, 17 + index), wrong, 1e-6, "along the axes");
            }
            // the stored skew, which counts along the axes that are not turned, leads the ball 0.03 beside the middle
            setup.control.program_frame.rotation = Rpy(at(plane, [0.0, 0.0, angle]));
            call(&mut setup, "CYCLE977", &hole, PartErrors::default());
            near(result(&setup, 16), 0.0, 1e-4, "size along the turned axes");
            for index in 0..2 {
                near(result(&setup, 17 + index), 0.0, REMAINS, "turned");
            }
        }
    }
}

// oracle: hand: a size is the difference of two touches, so is the ball, and each touch scatters by σ: together 2σ; the
// middle scatters by σ/√2 in the measurement and in the trigger points, together by σ
#[test]
fn what_remains_is_the_repeatability() {
    const SIGMA: f64 = 0.001;
    const LOOPS: u32 = 60;
    let rig = Rig { plane: Plane::G17, units: Units::Metric, mono: false };
    let mut squares = [0.0; 3];
    let mut setup = rig.setup();
    setup.probe.repeatability = (SIGMA, 1);
    for _ in 0..LOOPS {
        rig.calibrate(&mut setup, 10_101, 0.0);
        let hole = element(rig, 101, &[]);
        call(&mut setup, "CYCLE977", &hole, PartErrors::default());
        let wrong = [16, 17, 18].map(|index| result(&setup, index));
        (0..3).for_each(|i| squares[i] += wrong[i].powi(2));
    }
    let spread = squares.map(|sum| (sum / f64::from(LOOPS)).sqrt() / SIGMA);
    for (found, expected) in spread.into_iter().zip([2.0, 1.0, 1.0]) {
        assert!((found / expected - 1.0).abs() < 0.25, "{spread:?}");
    }
}
