#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! G105 to G109: what is wrong with a part comes out, and after the correction nothing is left. With a stylus that is
//! calibrated first, in all planes, mm and inch.

use super::axis_name;
use super::bench::{PLANES, TOOL_AXIS, after, call, codes, length, machine, near, put, stand};
use crate::catalogue::g102::{G102, INDEX};
use crate::catalogue::g103::G103;
use crate::catalogue::g104::G104;
use crate::catalogue::g105::G105;
use crate::catalogue::g106::G106;
use crate::catalogue::g107::G107;
use crate::catalogue::g108::G108;
use crate::catalogue::g109::{G109, POCKET, WEB};
use crate::catalogue::nct;
use crate::check::check;
use crate::control::{Control, Frame, Plane};
use crate::entry::Cycle;
use crate::machine::Setup;
use crate::run::Outcome;
use crate::workpiece::Shape;
use proptest::prelude::*;

/// A machine with a stylus that stands beside the spindle, calibrated by the macros themselves; nothing to touch.
fn calibrated(plane: Plane, inch: bool, skew: [f64; 2]) -> Setup {
    let mut setup = machine(plane, inch);
    setup.probe.skew = skew;
    setup.probe.radius = 2.5;
    setup.control.set(INDEX, 20.0);
    let ring = Shape::Hole { diameter: 50.0, depth: 30.0 };
    put(&mut setup, ring, [0.0; 3], [0.4, -0.3, 0.0], 0.0);
    stand(&mut setup, [0.0, 0.0, -10.0]);
    for cycle in [&G102, &G103] {
        setup = go(&setup, cycle, &[("D", 50.0)], &[]).0;
    }
    setup.workpiece.solids.clear();
    let size = [100.0, 100.0, 60.0];
    put(&mut setup, Shape::Block { size }, [0.0; 3], [0.0; 3], 0.0);
    stand(&mut setup, [0.0, 0.0, 50.0]);
    let applicate = axis_name(plane.axes()[2]);
    setup = go(&setup, &G104, &[(applicate.as_str(), 0.0)], &[("T", "98")]).0;
    setup.workpiece.solids.clear();
    setup
}

/// A call with lengths in mm and other values; the machine afterwards, standing where it stood, and what happened.
fn go(
    setup: &Setup,
    cycle: &'static Cycle,
    lengths: &[(&'static str, f64)],
    others: &[(&'static str, &'static str)],
) -> (Setup, Outcome) {
    let lengths: Vec<(&str, String)> = lengths.iter().map(|(name, mm)| (*name, length(setup, *mm))).collect();
    let mut values: Vec<(&str, &str)> = lengths.iter().map(|(name, text)| (*name, text.as_str())).collect();
    values.extend(others);
    let outcome = call(cycle, &values, setup);
    assert_eq!(outcome.stop, None, "{} {values:?}", cycle.name);
    (after(setup, outcome.clone()), outcome)
}

/// A result in mm.
fn result(control: &Control, name: &str) -> f64 {
    control.number(name) * control.active_factor()
}

/// The part stands where it stood, and so does the stylus in the coordinates of the part.
fn again(setup: &Setup, at: [f64; 3]) -> Setup {
    let mut setup = setup.clone();
    stand(&mut setup, at);
    setup
}

const BLOCK: Shape = Shape::Block { size: [100.0, 100.0, 60.0] };

/// A wall at 50 in one axis of the plane, off by `shift`; the stylus above and beside it.
fn wall(setup: &Setup, index: usize, shift: f64) -> (Setup, &'static str, [f64; 3]) {
    let mut setup = setup.clone();
    let mut off = [0.0; 3];
    off[index] = shift;
    put(&mut setup, BLOCK, [0.0; 3], off, 0.0);
    let mut at = [0.0, 0.0, 20.0];
    at[index] = 75.0;
    stand(&mut setup, at);
    let name = axis_name(setup.control.plane.axes()[index]);
    (setup, name.as_str(), at)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: definition; manual C:472-497: G54 takes the deviation, then there is none
    #[test]
    fn a_wall_is_found_and_its_offset_closes(
        plane in 0..3_usize, inch: bool, index in 0..2_usize, shift in -3.0..3.0, skew in [-0.2..0.2, -0.2..0.2]
    ) {
        let setup = calibrated(PLANES[plane], inch, skew);
        let (setup, name, at) = wall(&setup, index, shift);
        let depth = axis_name(PLANES[plane].axes()[2]);
        let lengths = [(name, 50.0), (depth.as_str(), -10.0)];
        let (first, outcome) = go(&setup, &G105, &lengths, &[("S", "1"), ("M", "7")]);
        near(result(&outcome.control, "DEVIATION"), shift);
        near(result(&outcome.control, "POSITION"), 50.0 + shift);
        near(outcome.control.variable("D7").unwrap(), shift); // the wall stands towards the stylus: metal on
        prop_assert_eq!(outcome.position, setup.position);
        let (_, second) = go(&again(&first, at), &G105, &lengths, &[]);
        near(result(&second.control, "DEVIATION"), 0.0);
    }

    // oracle: definition; manual C:603-620, C:676-694
    #[test]
    fn a_face_is_found_and_its_offset_closes(
        plane in 0..3_usize, inch: bool, shift in -3.0..3.0, skew in [-0.2..0.2, -0.2..0.2]
    ) {
        let mut setup = calibrated(PLANES[plane], inch, skew);
        put(&mut setup, BLOCK, [0.0, 0.0, 5.0], [0.0, 0.0, shift], 0.0);
        stand(&mut setup, [0.0, 0.0, 40.0]);
        let name = axis_name(PLANES[plane].axes()[2]);
        let (first, outcome) = go(&setup, &G106, &[(name.as_str(), 5.0)], &[("S", "0"), ("M", "7")]);
        near(result(&outcome.control, "DEVIATION"), shift);
        near(outcome.control.variable("H7").unwrap(), shift);
        let common = outcome.control.variable(&format!("COMMON {name}")).unwrap();
        near(common, shift);
        let (_, second) = go(&again(&first, [0.0, 0.0, 40.0]), &G106, &[(name.as_str(), 5.0)], &[]);
        near(result(&second.control, "DEVIATION"), 0.0);
    }

    // oracle: definition; manual C:723-733, C:805-815: without S the work offset in use
    #[test]
    fn a_corner_is_found_and_its_offset_closes(
        plane in 0..3_usize, inch: bool, outside: bool, shift in [-3.0..3.0, -3.0..3.0],
        skew in [-0.2..0.2, -0.2..0.2]
    ) {
        let mut setup = calibrated(PLANES[plane], inch, skew);
        let (cycle, shape, into) = if outside {
            (&G108, Shape::Island { length: [80.0; 2], height: 30.0 }, 1.0)
        } else {
            (&G107, Shape::Pocket { length: [80.0; 2], depth: 30.0 }, -1.0)
        };
        let at = [100.0 + into * 40.0, 80.0 + into * 40.0, 0.0];
        put(&mut setup, shape, at, [shift[0], shift[1], 0.0], 0.0);
        let start = [80.0, 60.0, -10.0];
        stand(&mut setup, start);
        let [first, second, _] = PLANES[plane].axes().map(|axis| axis_name(axis).as_str());
        let lengths = [(first, 100.0), (second, 80.0)];
        let (corrected, outcome) = go(&setup, cycle, &lengths, &[]);
        near(result(&outcome.control, "CORNER_1"), 100.0 + shift[0]);
        near(result(&outcome.control, "CORNER_2"), 80.0 + shift[1]);
        prop_assert_eq!(outcome.position, setup.position);
        let (_, closed) = go(&again(&corrected, start), cycle, &lengths, &[]);
        near(result(&closed.control, "SHIFT_1"), 0.0);
        near(result(&closed.control, "SHIFT_2"), 0.0);
    }

    // oracle: definition; manual C:907-933
    #[test]
    fn a_pocket_or_web_is_found_and_its_offset_closes(
        plane in 0..3_usize, inch: bool, index in 0..2_usize, web: bool, shift in -3.0..3.0, size in -1.0..1.0,
        skew in [-0.2..0.2, -0.2..0.2]
    ) {
        let mut setup = calibrated(PLANES[plane], inch, skew);
        let mut lengths = [120.0; 2];
        lengths[index] = 80.0;
        let mut off = [0.0; 3];
        off[index] = shift;
        let axes = PLANES[plane].axes().map(|axis| axis_name(axis).as_str());
        let mut values = vec![(axes[index], 80.0)];
        let (shape, start) = if web {
            values.push((axes[2], -10.0));
            (Shape::Island { length: lengths, height: 30.0 }, [0.0, 0.0, 20.0])
        } else {
            (Shape::Pocket { length: lengths, depth: 30.0 }, [0.0, 0.0, -10.0])
        };
        put(&mut setup, shape, [0.0; 3], off, size);
        stand(&mut setup, start);
        let (corrected, outcome) = go(&setup, &G109, &values, &[("S", "1"), ("M", "7")]);
        near(result(&outcome.control, "DEVIATION"), size);
        near(result(&outcome.control, "SHIFT"), shift);
        near(outcome.control.variable("D7").unwrap(), if web { size } else { -size });
        prop_assert_eq!(outcome.position, setup.position);
        let (_, closed) = go(&again(&corrected, start), &G109, &values, &[]);
        near(result(&closed.control, "SHIFT"), 0.0);
    }
}

// oracle: manual C:776 ("moving zero position of corner to coordinate X100 Y80 in coordinate system G56"), C:481-489:
// what is measured coincides with its nominal place in the system that S names, whichever is in use; hand: G54 stands
// at 11, 22, 33
#[test]
fn another_work_offset_than_the_one_in_use_takes_the_nominal_place() {
    for plane in PLANES {
        for (index, shift) in [(0, 0.5), (1, -0.25), (0, 0.0)] {
            let setup = calibrated(plane, false, [0.1, -0.1]);
            let (mut setup, name, at) = wall(&setup, index, shift);
            let other = Frame::translation([100.0, 200.0, 300.0]);
            setup.control.frames.insert(2, other);
            let depth = axis_name(plane.axes()[2]);
            let lengths = [(name, 50.0), (depth.as_str(), -10.0)];
            let (mut corrected, outcome) = go(&setup, &G105, &lengths, &[("S", "2")]);
            for axis in 0..3 {
                let at = |system: &str| {
                    let name = format!("{system} {}", axis_name(axis));
                    outcome.control.variable(&name).unwrap()
                };
                let measured = axis == plane.axes()[index];
                near(at("G54"), [11.0, 22.0, 33.0][axis]);
                near(at("G55"), if measured { at("G54") + shift } else { other.coarse[axis] });
            }
            corrected.control.activate(2);
            let part = corrected.control.to_workpiece(setup.position);
            corrected.position = setup.position;
            near(part[plane.axes()[index]], at[index] - shift);
        }
    }
}

// oracle: manual C:491-497: metal left makes the register smaller, so that the next cut takes it away
#[test]
fn a_corrected_tool_cuts_to_size() {
    let setup = calibrated(Plane::G17, false, [0.0; 2]);
    let (mut setup, ..) = wall(&setup, 0, 0.12); // 0.12 too much metal
    setup.control.edge_made(0, 1).radius = 10.0;
    let (_, outcome) = go(&setup, &G105, &[("X", 50.0), ("Z", -10.0)], &[("T", "1")]);
    near(outcome.control.register(1).total_radius(), 9.88);
    let mut setup = calibrated(Plane::G17, false, [0.0; 2]);
    put(&mut setup, BLOCK, [0.0; 3], [0.0, 0.0, 0.2], 0.0);
    stand(&mut setup, [0.0, 0.0, 40.0]);
    setup.control.edge_made(0, 1).length[0] = 120.0;
    let (_, outcome) = go(&setup, &G106, &[("Z", 0.0)], &[("T", "1")]);
    near(outcome.control.register(1).total_length(0), 119.8);
    let web = Shape::Island { length: [80.0, 120.0], height: 30.0 };
    let mut setup = calibrated(Plane::G17, false, [0.0; 2]);
    put(&mut setup, web, [0.0; 3], [0.0; 3], 0.1);
    stand(&mut setup, [0.0, 0.0, 20.0]);
    let (_, outcome) = go(&setup, &G109, &[("X", 80.0), ("Z", -10.0)], &[("T", "1")]);
    near(outcome.control.register(1).total_radius(), -0.05); // each side was cut with it
}

// oracle: manual C:500-501: limits by size, whatever the sign; beyond U neither tool nor offset, but M
#[test]
fn limits() {
    for shift in [-0.4, 0.4] {
        let setup = calibrated(Plane::G17, false, [0.0; 2]);
        let (setup, ..) = wall(&setup, 0, shift);
        let lengths = |name, limit| [("X", 50.0), ("Z", -10.0), (name, limit)];
        let (_, outcome) = go(&setup, &G105, &lengths("H", 0.41), &[("S", "1")]);
        assert!(outcome.alarms().is_empty());
        let (_, outcome) = go(&setup, &G105, &lengths("H", 0.39), &[("S", "1")]);
        assert_eq!(outcome.alarms(), [nct::OUT_OF_TOLERANCE]);
        near(outcome.control.variable("G54 X").unwrap(), 11.0 + shift);
        let (_, outcome) = go(&setup, &G105, &lengths("U", 0.39), &[("S", "1"), ("M", "7")]);
        assert_eq!(outcome.alarms(), [nct::UPPER_TOLERANCE]);
        near(outcome.control.variable("G54 X").unwrap(), 11.0);
        near(outcome.control.variable("D7").unwrap(), shift);
    }
}

// oracle: manual C:506-509, C:948-955 (columns; the blank after the minus sign)
#[test]
fn print_out() {
    let setup = calibrated(Plane::G17, false, [0.0; 2]);
    let (setup, ..) = wall(&setup, 0, -0.781);
    let values = [("X", 50.0), ("Z", -10.0)];
    let (_, outcome) = go(&setup, &G105, &values, &[("S", "1"), ("W", "2")]);
    assert_eq!(
        outcome.log(),
        ["WORK       NOMINAL    DEVIATION", "OFFSET NO  POSITION   FROM NOMINAL", "1          50.0000    - .7810",]
    );
    let pocket = Shape::Pocket { length: [30.0, 120.0], depth: 30.0 };
    let mut setup = calibrated(Plane::G17, false, [0.0; 2]);
    put(&mut setup, pocket, [0.0; 3], [0.011, 0.0, 0.0], -0.77);
    stand(&mut setup, [0.0, 0.0, -10.0]);
    let others = [("S", "5"), ("V", "1"), ("W", "1")];
    let (_, outcome) = go(&setup, &G109, &[("X", 30.0)], &others);
    assert_eq!(outcome.log(), ["           30.0000               - .7700", "5          .0000      .0110",]);
    let mut silent = setup.clone();
    silent.control.set(nct::PRINT_ENABLED, 0.0); // C:60
    let (_, outcome) = go(&silent, &G109, &[("X", 30.0)], &others);
    assert!(outcome.log().is_empty());
}

// oracle: manual C:519-532, C:739-750, C:963-976
#[test]
fn format_errors() {
    let wrong = [nct::FORMAT_ERROR];
    for (plane, depth) in TOOL_AXIS {
        let [first, second, _] = plane.axes().map(|axis| axis_name(axis).as_str());
        for cycle in [&G105, &G109] {
            assert_eq!(codes(cycle, &[(depth, "-10")], plane), wrong);
            assert_eq!(codes(cycle, &[(first, "50"), (second, "50")], plane), wrong);
            assert_eq!(codes(cycle, &[(first, "50"), ("S", "1"), ("T", "1")], plane), wrong);
            for given in [("S", "7"), ("T", "100"), ("M", "0")] {
                assert_eq!(codes(cycle, &[(second, "50"), given], plane), wrong);
            }
            assert!(codes(cycle, &[(second, "50"), (depth, "0")], plane).is_empty());
        }
        for web in ["", "-10"] {
            assert_eq!(codes(&G109, &[(first, "0"), (depth, web)], plane), wrong);
            assert_eq!(codes(&G109, &[(second, "-8"), (depth, web)], plane), wrong);
        }
        for cycle in [&G107, &G108] {
            assert_eq!(codes(cycle, &[(first, "50")], plane), wrong);
            assert_eq!(codes(cycle, &[(second, "50"), (depth, "5")], plane), wrong);
            assert_eq!(codes(cycle, &[(first, "5"), (second, "5"), ("S", "7")], plane), wrong);
        }
        assert_eq!(codes(&G106, &[(first, "5")], plane), wrong);
        assert!(codes(&G106, &[(depth, "0"), ("S", "0")], plane).is_empty());
    }
}

// oracle: manual C:911: the tool axis makes a web, also at 0; an axis of the plane never does
#[test]
fn the_tool_axis_makes_a_web() {
    for (plane, depth) in TOOL_AXIS {
        let control = machine(plane, false).control;
        let variant = |values: &[(&str, &str)]| {
            let typed = super::bench::typed(values);
            check(&G109, &typed, &control).inputs.unwrap().variant
        };
        let name = axis_name(plane.axes()[0]);
        assert_eq!(variant(&[(name.as_str(), "50")]), POCKET);
        assert_eq!(variant(&[(name.as_str(), "50"), (depth, "0")]), WEB);
    }
}

// oracle: hand: a stylus that switches later in some directions; offset and radius together are right in each
#[test]
fn lobes_of_the_stylus_are_calibrated_away() {
    let mut setup = calibrated(Plane::G17, false, [0.0; 2]);
    setup.probe.pre_travel = (0.01, 0.004);
    let ring = Shape::Hole { diameter: 50.0, depth: 30.0 };
    put(&mut setup, ring, [0.0; 3], [0.0; 3], 0.0);
    stand(&mut setup, [0.0, 0.0, -10.0]);
    for cycle in [&G102, &G103] {
        setup = go(&setup, cycle, &[("D", 50.0)], &[]).0;
    }
    setup.workpiece.solids.clear();
    put(&mut setup, BLOCK, [0.0; 3], [0.0; 3], 0.0);
    for (start, name, nominal) in
        [([75.0, 0.0], "X", 50.0), ([-75.0, 0.0], "X", -50.0), ([0.0, 75.0], "Y", 50.0), ([0.0, -75.0], "Y", -50.0)]
    {
        stand(&mut setup, [start[0], start[1], -10.0]);
        let (_, outcome) = go(&setup, &G105, &[(name, nominal)], &[]);
        let deviation = outcome.control.number("DEVIATION");
        // the ring is touched beside its centre by the lobe: 0.004²/50 mm
        assert!(deviation.abs() < 1e-6, "{name}{nominal}: {deviation}");
    }
}
