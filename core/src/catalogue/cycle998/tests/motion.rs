//! Every motion of every variant of CYCLE998: order, positions, feeds.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, Lettered, PLANE_FEED, lettered, same_lettered};
use crate::catalogue::sinumerik::testing::{at, call, run, setup, solid, touches, turns};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::geometry::{Degrees, Mcs};
use crate::machine::Sim;
use crate::workpiece::Shape;

/// A straight block in the corner of the axes: its faces look to minus abscissa, minus ordinate and plus applicate, the
/// last one at 0, the others at 0 too.
fn machine(plane: Plane, start: [f64; 3]) -> Sim {
    let mut setup = setup(plane);
    let shape = Shape::Block { size: [100.0, 100.0, 100.0] };
    setup.workpiece.solids.push(solid(plane, shape, [50.0, 50.0, 0.0], false));
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    setup.position = Mcs(at(plane, start));
    Sim::new(&setup)
}

/// Ball of radius 3, `_FA` 8, 40 mm and 30 mm between the points; 40·tan 5° = 3.4995, 30·tan 5° = 2.6247,
/// 40·tan 8° = 5.6216, 30·tan 1° = 0.5237.
fn inputs(variant: i64, axes: i64, set: [f64; 2]) -> Inputs {
    call(
        "CYCLE998",
        variant,
        &[
            ("_SETVAL", 0.0),
            ("_MA", axes as f64),
            ("_MD", if axes % 10 == 3 { 1.0 } else { 0.0 }),
            ("_ID", 40.0),
            ("_SETV[0]", 30.0),
            ("_STA1", set[0]),
            ("_INCA", set[1]),
            ("_FA", 8.0),
            ("_TSA", 5.0),
        ],
    )
}

/// Variant, `_MA`, set angles, start, motions.
type Case = (i64, i64, [f64; 2], [f64; 3], Vec<Lettered>);

/// To a place before the face, a touch, back to the place, as far as there are letters.
fn touch(letters: &str, before: [f64; 3], contact: [f64; 3]) -> Vec<Lettered> {
    let end = |letter| if letter == 'm' { contact } else { before };
    letters.chars().map(|letter| (letter, end(letter))).collect()
}

#[test]
fn every_variant_moves_as_its_table_says() {
    // oracle: manual B:7530-7564, B:7788-7808 (order, ways, end), hand (figures)
    let (tan1, tan5) = (1.0_f64.to_radians().tan(), 5.0_f64.to_radians().tan());
    let away = 40.0 * tan5;
    let edge = [20.0, -20.0, -10.0];
    let top = [20.0, 20.0, 30.0];
    let cases: Vec<Case> = vec![
        // S1 is the ball 8 mm before the edge at 0; the way to P2 leads away by 5 degree
        (
            105,
            102,
            [0.0; 2],
            edge,
            [
                touch("pmr", [20.0, -11.0, -10.0], [20.0, -3.0, -10.0]),
                touch("pmr", [60.0, -11.0 - away, -10.0], [60.0, -3.0, -10.0]),
            ]
            .concat(),
        ),
        // the edge should rise by 4 degree: 1 degree away remains
        (
            105,
            102,
            [4.0, 0.0],
            edge,
            [
                touch("pmr", [20.0, -11.0, -10.0], [20.0, -3.0, -10.0]),
                touch("pmr", [60.0, -11.0 - 40.0 * tan1, -10.0], [60.0, -3.0, -10.0]),
            ]
            .concat(),
        ),
        // a positive angle about the applicate leads to minus abscissa
        (
            105,
            201,
            [4.0, 0.0],
            [-20.0, 20.0, -10.0],
            [
                touch("pmr", [-11.0, 20.0, -10.0], [-3.0, 20.0, -10.0]),
                touch("pmr", [-11.0 - 40.0 * 9.0_f64.to_radians().tan(), 60.0, -10.0], [-3.0, 60.0, -10.0]),
            ]
            .concat(),
        ),
        (
            105,
            103,
            [0.0; 2],
            top,
            [
                touch("dms", [20.0, 20.0, 11.0], [20.0, 20.0, 3.0]),
                touch("pms", [60.0, 20.0, 11.0 + away], [60.0, 20.0, 3.0]),
            ]
            .concat(),
        ),
        (
            1105,
            102,
            [0.0; 2],
            edge,
            [
                touch("pmr", [20.0, -11.0, -10.0], [20.0, -3.0, -10.0]),
                touch("mr", [20.0, -11.0, -10.0], [20.0, -3.0, -10.0]),
                touch("pmr", [60.0, -11.0 - away, -10.0], [60.0, -3.0, -10.0]),
            ]
            .concat(),
        ),
        // from where it stands, over 16 mm
        (
            100_105,
            102,
            [0.0; 2],
            [20.0, -18.0, -10.0],
            [
                touch("mr", [20.0, -18.0, -10.0], [20.0, -3.0, -10.0]),
                touch("pmr", [60.0, -18.0, -10.0], [60.0, -3.0, -10.0]),
            ]
            .concat(),
        ),
        // P2 along the abscissa, back, P3 along the ordinate
        (
            106,
            103,
            [0.0; 2],
            top,
            [
                touch("dms", [20.0, 20.0, 11.0], [20.0, 20.0, 3.0]),
                touch("pms", [60.0, 20.0, 11.0 + away], [60.0, 20.0, 3.0]),
                vec![('p', [20.0, 20.0, 11.0])],
                touch("pms", [20.0, 50.0, 11.0 + 30.0 * tan5], [20.0, 50.0, 3.0]),
            ]
            .concat(),
        ),
        // about the ordinate 4 degree fall along the abscissa, about the abscissa they rise along the ordinate
        (
            106,
            103,
            [-4.0, 4.0],
            top,
            [
                touch("dms", [20.0, 20.0, 11.0], [20.0, 20.0, 3.0]),
                touch("pms", [60.0, 20.0, 11.0 + 40.0 * tan1], [60.0, 20.0, 3.0]),
                vec![('p', [20.0, 20.0, 11.0])],
                touch("pms", [20.0, 50.0, 11.0 + 30.0 * tan1], [20.0, 50.0, 3.0]),
            ]
            .concat(),
        ),
        (
            100_106,
            103,
            [0.0; 2],
            [20.0, 20.0, 18.0],
            [
                touch("ms", [20.0, 20.0, 18.0], [20.0, 20.0, 3.0]),
                touch("pms", [60.0, 20.0, 18.0], [60.0, 20.0, 3.0]),
                vec![('p', [20.0, 20.0, 18.0])],
                touch("pms", [20.0, 50.0, 18.0], [20.0, 50.0, 3.0]),
            ]
            .concat(),
        ),
    ];
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for (variant, axes, set, start, wanted) in &cases {
            let mut sim = machine(plane, *start);
            let outcome = run(&mut sim, &inputs(*variant, *axes, *set));
            let what = format!("{variant} {axes} {set:?} {plane:?}");
            assert_eq!(outcome, Ok(()), "{what}");
            same_lettered(&lettered(&sim, plane), wanted, &what);
        }
    }
}

#[test]
fn measurements_at_the_same_place_are_repeated_at_each_point() {
    // oracle: manual B:2348-2356
    let mut inputs = inputs(106, 103, [0.0; 2]);
    inputs.numbers.insert(names::NMSP, 3.0);
    let mut sim = machine(Plane::G17, [20.0, 20.0, 30.0]);
    assert_eq!(run(&mut sim, &inputs), Ok(()));
    assert_eq!(touches(&sim).len(), 9);
}

#[test]
fn a_mono_probe_is_turned_and_a_differential_one_turns_back() {
    // oracle: manual B:864-871, B:7570-7576, B:13985 (the ordinate is 270 degree of the spindle)
    let turned = |inputs: &Inputs| {
        let mut sim = machine(Plane::G17, [20.0, -20.0, -10.0]);
        sim.control.spindle = Degrees(30.0);
        assert_eq!(run(&mut sim, inputs), Ok(()));
        turns(&sim)
    };
    let mut mono = inputs(105, 102, [0.0; 2]);
    mono.numbers.insert(names::PRNUM, 101.0);
    assert_eq!(turned(&mono), [270.0, 270.0]);
    assert_eq!(turned(&inputs(1105, 102, [0.0; 2])), [210.0, 30.0]);
}
