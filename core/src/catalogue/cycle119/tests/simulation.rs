//! CYCLE119 called by programs with variables of their own, which copy what they get into R parameters.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::sinumerik::testing::random_parts;
use crate::control::{Control, Frame, Plane};
use crate::dialect::Dialect;
use crate::geometry::{Rpy, V3, Wcs, rigid};
use crate::machine::Setup;
use crate::run::{Limits, Outcome, run};
use crate::syntax::read;
use proptest::prelude::*;

type Triangle = [[f64; 3]; 3];

/// The reference triangle of the manual's example, larger.
const SET: Triangle = [[100.0, 0.0, 0.0], [0.0, 200.0, 0.0], [0.0, 0.0, 300.0]];

/// A machine with something in every frame of the chain, G54 active.
fn setup() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let frame = |x: f64, turn: [f64; 3]| Frame {
        coarse: [x, 2.0 * x, 3.0],
        fine: [0.01, 0.0, 0.02],
        rotation: Rpy(turn),
        ..Frame::default()
    };
    setup.control.stored.system = Frame::translation([1.0, 2.0, 3.0]);
    setup.control.stored.channel.insert(0, frame(10.0, [5.0, 0.0, 0.0]));
    setup.control.frames.insert(1, frame(100.0, [1.0, -2.0, 20.0]));
    setup.control.activate(1);
    setup
}

/// Runs a call; R1 is the alarm number, R2 the distortion; `behind` stands between call and end.
fn called(setup: &Setup, before: &str, set: &Triangle, measured: &Triangle, last: &str, behind: &str) -> Outcome {
    let list = |points: &Triangle| {
        let all: Vec<String> = points.concat().iter().map(f64::to_string).collect();
        all.join(",")
    };
    let text = format!(
        "DEF REAL SOLL[3,3]=SET({}), IST[3,3]=SET({}), RES\nDEF INT FAULT\nDEF FRAME WAY\nG17 G54 {before}\n\
        CYCLE119(SOLL,IST,FAULT,RES,WAY,{last})\nR1=FAULT R2=RES\n{behind}\nM30\n",
        list(set),
        list(measured)
    );
    let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), setup, Limits::default());
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    outcome
}

/// The triangle as a part that stands elsewhere has it.
fn moved(at: [f64; 3], turn: [f64; 3]) -> Triangle {
    SET.map(|point| (rigid::rotation(Rpy(turn)) * V3::from(point) + V3::from(at)).into())
}

/// Whether measured points have the set coordinates in the frame of this control.
fn stands_right(before: &Control, after: &Control, measured: &Triangle) -> Result<(), TestCaseError> {
    for (set, point) in SET.iter().zip(measured) {
        let seen = after.to_workpiece(before.to_machine(Wcs(*point)));
        for axis in 0..3 {
            prop_assert!((seen[axis] - set[axis]).abs() < 1e-9, "{:?} {:?}", seen, set);
        }
    }
    Ok(())
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    [-3.0..3.0_f64, -3.0..3.0_f64, -3.0..3.0_f64]
}

proptest! {
    #![proptest_config(random_parts(1))]

    // oracle: manual B:8566-8592 (afterwards the measured triangle has the setpoint position; active when called again)
    #[test]
    fn a_corrected_frame_brings_the_triangle_to_its_place(at in place(), turn in place(), target in 0..4_usize) {
        let setup = setup();
        let code = ["1", "9999", "1011", "2000"][target];
        let measured = moved(at, turn);
        let outcome = called(&setup, "", &SET, &measured, &format!("{code},0.001"), "R3=$AA_IW[X]");
        prop_assert_eq!(outcome.control.number("R1"), 0.0);
        prop_assert!(outcome.control.number("R2").abs() < 1e-9);
        // not in the cycle, 9999 included
        let still = setup.control.to_workpiece(setup.position);
        prop_assert!((outcome.control.number("R3") - still[0]).abs() < 1e-9);
        let mut after = outcome.control.clone();
        after.activate(1);
        stands_right(&setup.control, &after, &measured)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    // oracle: manual B:8584 (the result frame chained to the active one gives the setpoint position), in mm and in inch
    #[test]
    fn the_result_frame_may_be_chained_by_the_program(at in place(), turn in place(), inch in any::<bool>()) {
        let setup = setup();
        let measured = moved(at, turn);
        let unit = if inch { 25.4 } else { 1.0 };
        let in_unit = |points: &Triangle| points.map(|point| point.map(|value| value / unit));
        let before = if inch { "G700" } else { "G710" };
        let outcome = called(
            &setup, before, &in_unit(&SET), &in_unit(&measured), "0,0", "$P_UIFR[1]=$P_UIFR[1]:WAY\nG54\nR3=WAY[X,TR]",
        );
        prop_assert_eq!(outcome.control.number("R1"), 0.0);
        prop_assert!((outcome.control.number("R3") - at[0] / unit).abs() < 1e-9);
        stands_right(&setup.control, &outcome.control, &measured)?;
    }
}

#[test]
fn a_distortion_is_the_sum_of_what_is_left() {
    // oracle: hand. Isosceles, the tip 3 mm too high: the best motion moves by 1 mm, so that the tip is 2 mm off and
    // the ends of the base 1 mm each. In mm in a program in inches too, as its limit (B:8573, B:8583)
    let inches = |triangle: &Triangle| triangle.map(|point| point.map(|value| value / 25.4));
    let mm = [[-50.0, 0.0, 0.0], [50.0, 0.0, 0.0], [0.0, 80.0, 0.0]];
    let mut high = mm;
    high[2][1] += 3.0;
    let limits = [("4.1", 0.0), ("3.9", 61414.0)];
    for (units, (limit, alarm)) in ["", "G70", "G700"].into_iter().flat_map(|units| limits.map(|limit| (units, limit)))
    {
        let (set, measured) = match units {
            "" => (mm, high),
            _ => (inches(&mm), inches(&high)),
        };
        let before = setup();
        let outcome = called(&before, units, &set, &measured, &format!("1,{limit}"), "");
        assert_eq!(outcome.control.number("R1"), alarm);
        assert!((outcome.control.number("R2") - 4.0).abs() < 1e-9);
        assert_eq!(outcome.control.frames == before.control.frames, alarm != 0.0);
    }
}

#[test]
fn what_is_wrong_is_handed_back() {
    // oracle: manual B:8579-8590, A:15930-15933, B:1971; scale: B:8588, the number is ours
    let line = [[0.0; 3], [10.0, 0.0, 0.0], [20.0, 0.0, 0.0]];
    let plain = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    for (before, set, last, alarm, computed) in [
        ("", &line, "0,0", 61411.0, false),
        ("", &SET, "1000,1", 61412.0, true),
        ("", &SET, "1051,1", 61321.0, true),
        ("", &SET, "1,0", 61414.0, true),
        ("\nSCALE X2 Y2\n", &SET, "1,1", 61411.0, true),
        ("\nMIRROR X0\n", &SET, "1,1", 61411.0, true),
    ] {
        let outcome = called(&plain, before, set, &SET, last, "");
        assert_eq!(outcome.control.number("R1"), alarm, "{last}");
        assert_eq!(outcome.control.number("R2") >= 0.0, computed, "{last}");
        assert_eq!(outcome.control.frames, plain.control.frames, "{last}");
    }
}
