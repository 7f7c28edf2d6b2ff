//! CYCLE997 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use crate::catalogue::find;
use crate::catalogue::sinumerik::testing::{at, call, random_parts, run, setup, solid};
use crate::check::check;
use crate::control::{Frame, Plane, Units};
use crate::dialect::Dialect;
use crate::entry::{Inputs, Typed, names};
use crate::geometry::{Dir, Rpy, V3, Wcs, fit, rigid};
use crate::machine::Setup;
use crate::machine::sim::Sim;
use crate::machine::trace::Step;
use crate::name::Name;
use crate::workpiece::Shape;
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Setpoint centres: abscissa, ordinate, applicate.
pub(super) const CENTRES: [[f64; 3]; 3] = [[100.0, 60.0, 20.0], [260.0, 90.0, 20.0], [180.0, 240.0, 20.0]];
/// Setpoint diameter.
const SIZE: f64 = 50.0;
/// Radius of the ball.
const BALL: f64 = 3.0;

/// A call of a variant about the setpoint centres.
pub(super) fn inputs(variant: i64) -> Inputs {
    let mut values =
        vec![("_SETVAL", SIZE), ("_STA1", 0.0), ("_INCA", 90.0), ("_RF", 900.0), ("_FA", 5.0), ("_TSA", 8.0)];
    let names =
        ["_SETV[0]", "_SETV[1]", "_SETV[2]", "_SETV[3]", "_SETV[4]", "_SETV[5]", "_SETV[6]", "_SETV[7]", "_SETV[8]"];
    values.extend(names.into_iter().zip(CENTRES.concat()));
    call("CYCLE997", variant, &values)
}

/// Inputs of a variant with a target.
pub(super) fn corrected(variant: i64, target: f64) -> Inputs {
    let mut inputs = inputs(variant);
    inputs.numbers.insert(names::KNUM, target);
    inputs
}

/// How many spheres a variant measures.
fn count(variant: i64) -> usize {
    if variant / 10_000 % 10 == 1 { 3 } else { 1 }
}

/// Spheres at their setpoint centres in the active frame, and the probe 60 mm above the first one.
pub(super) fn ready(plane: Plane, variant: i64) -> Setup {
    spheres(setup(plane), plane, variant)
}

fn spheres(mut setup: Setup, plane: Plane, variant: i64) -> Setup {
    for centre in &CENTRES[..count(variant)] {
        let mut sphere = solid(plane, Shape::Sphere { diameter: SIZE }, *centre, false);
        sphere.at = setup.control.to_machine(Wcs(sphere.at.0));
        setup.workpiece.solids.push(sphere);
    }
    setup.probe.stylus = Some(0.0); // frames are turned in space here, and the tool stays upright
    start(&mut setup, plane);
    setup
}

fn start(setup: &mut Setup, plane: Plane) {
    let [x, y, z] = CENTRES[0];
    setup.position = setup.control.to_machine(Wcs(at(plane, [x, y, z + 60.0])));
}

fn close(sim: &Sim, name: &str, value: f64) -> Result<(), TestCaseError> {
    let found = sim.control.number(name);
    prop_assert!((found - value).abs() < 1e-9, "{} = {}, expected {}", name, found, value);
    Ok(())
}

/// Diameter that is found, and how far the applicate of the centre is off, with a sphere larger than expected: the
/// centre is looked for half the diameter below the top, and there the ball meets the sphere beside its equator.
fn determined(variant: i64, real: f64) -> (f64, f64) {
    let once = |expected: f64| {
        let beside = real / 2.0 - expected / 2.0;
        2.0 * ((real / 2.0 + BALL).powi(2) - beside.powi(2)).sqrt() - 2.0 * BALL
    };
    let diameter = match (variant / 1_000_000, variant / 10 % 10) {
        (0, _) => SIZE,
        (_, 0) => once(SIZE),
        _ => once(once(SIZE)),
    };
    (diameter, (real - diameter) / 2.0)
}

proptest! {
    #![proptest_config(random_parts(VARIANTS.len()))]

    /// Each sphere is found where it is, in every variant, plane and system of units.
    #[test]
    fn part_errors_are_recovered(
        shifts in prop::array::uniform3([-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64]),
        grown in -1.0..1.0_f64, first in -120.0..120.0_f64, step in prop_oneof![-80.0..-20.0_f64, 20.0..80.0_f64],
        plane in 0..3_usize, inch in any::<bool>(),
    ) {
        let plane = PLANES[plane];
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            let mut setup = ready(plane, variant);
            let unit = if inch { 25.4 } else { 1.0 };
            if inch {
                setup.control.active_units = Units::Inch;
            }
            for (solid, shift) in setup.workpiece.solids.iter_mut().zip(shifts) {
                solid.errors.shift = at(plane, shift);
                solid.errors.size = grown;
            }
            let mut inputs = inputs(variant);
            inputs.numbers.extend([(names::STA1, first), (names::INCA, step)]);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()), "variant {}", variant);
            // oracle: hand (the spheres as they were made)
            let (diameter, high) = determined(variant, SIZE + grown);
            let mut last = [0.0; 3];
            for index in 0..count(variant) {
                let set = [SIZE, CENTRES[index][0], CENTRES[index][1], CENTRES[index][2]];
                let [x, y, z] = std::array::from_fn(|i| CENTRES[index][i] + shifts[index][i]);
                let actual = [diameter, x, y, z + high];
                for i in 0..4 {
                    close(&sim, &format!("_OVR[{}]", 4 + 8 * index + i), actual[i] / unit)?;
                    close(&sim, &format!("_OVR[{}]", 8 + 8 * index + i), (actual[i] - set[i]) / unit)?;
                    close(&sim, &format!("_OVR[{i}]"), [SIZE, 100.0, 60.0, 20.0][i] / unit)?;
                }
                last = [x, y, CENTRES[0][2] + 60.0];
            }
            // oracle: manual B:8475 (ends above the last sphere at the height of the start)
            for (is, wanted) in sim.position.iter().zip(at(plane, last)) {
                prop_assert!((is - wanted).abs() < 1e-9, "{:?}", sim.position);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    /// What a skewed probe latches is the same place, as long as triggers, skew and ball come from one calibration. A
    /// signal that comes late along the way is one of paraxial measurement only: at an angle the ball meets the sphere
    /// beside its way where the sphere is off.
    #[test]
    fn a_calibrated_skewed_probe_measures_right(
        skew in [-0.5..0.5_f64, -0.5..0.5_f64], late in 0.0..0.05_f64, tip in any::<bool>(), shift in [-1.0..1.0_f64,
        -1.0..1.0_f64, -1.0..1.0_f64],
    ) {
        for variant in [109, 1109, 101_109] {
            let mut setup = ready(Plane::G17, variant);
            setup.workpiece.solids[0].errors.shift = shift;
            setup.probe.skew = skew;
            let late = if variant == 109 { late } else { 0.0 };
            setup.probe.pre_travel.0 = late;
            // oracle: hand: triggers and skew as B:13441-13463; L1 up to the circumference of the ball with _CBIT[14]
            let (ball, [x, y]) = (BALL - late, skew);
            let top = if tip { -late } else { ball };
            let data = [2.0 * ball, ball - x, -ball - x, ball - y, -ball - y, top, -ball, x, y];
            (0..9).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), data[i]));
            if tip {
                setup.control.set("_CBIT[14]", 1.0);
                prop_assert!(setup.control.set_variable("$TC_DP3[9,1]", 50.0 + BALL));
            }
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs(variant)), Ok(()), "variant {}", variant);
            for (i, wanted) in shift.into_iter().enumerate() {
                close(&sim, &format!("_OVR[{}]", 9 + i), wanted)?;
            }
        }
    }
}

/// A frame in each place of the chain, all of them active.
fn framed(plane: Plane) -> Setup {
    let mut setup = setup(plane);
    let control = &mut setup.control;
    let frame = |x: f64, turn: [f64; 3]| Frame {
        coarse: [x, 2.0 * x, 3.0],
        fine: [0.01, 0.0, 0.02],
        rotation: Rpy(turn),
        ..Frame::default()
    };
    control.stored.system = Frame::translation([1.0, 2.0, 3.0]);
    control.stored.channel.insert(0, frame(10.0, [0.0; 3]));
    control.frames.insert(1, frame(100.0, [0.4, -0.7, 20.0]));
    control.activate(1);
    setup
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// Where frame and part stand together on the machine decides nothing; and the points that were really touched lie
    /// on the sphere that is told.
    #[test]
    fn the_place_on_the_machine_decides_nothing(
        at_x in [-400.0..400.0_f64, -400.0..400.0_f64, -400.0..400.0_f64],
        turn in [-180.0..180.0_f64, -80.0..80.0_f64, -180.0..180.0_f64],
        shift in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], plane in 0..3_usize,
    ) {
        let plane = PLANES[plane];
        for variant in [109, 1_000_119, 1109, 101_119, 1_101_109, 10_109, 1_011_109] {
            let mut results = Vec::new();
            for frame in [Frame::default(), Frame { coarse: at_x, rotation: Rpy(turn), ..Frame::default() }] {
                let mut setup = setup(plane);
                setup.control.frames.insert(1, frame);
                setup.control.activate(1);
                let mut setup = spheres(setup, plane, variant);
                let away = setup.control.direction_to_machine(Dir::new(at(plane, shift))).0;
                setup.workpiece.solids[0].errors.shift = away;
                let mut sim = Sim::new(&setup);
                prop_assert_eq!(run(&mut sim, &inputs(variant)), Ok(()), "variant {}", variant);
                results.push((0..28).map(|i| sim.control.number(&format!("_OVR[{i}]"))).collect::<Vec<_>>());
                touched(&sim, variant, plane)?;
            }
            for (one, other) in results[0].iter().zip(&results[1]) {
                prop_assert!((one - other).abs() < 1e-9, "{}: {} {}", variant, one, other);
            }
        }
    }
}

/// Holds the last sphere against the one through the points that the ball touched of it.
fn touched(sim: &Sim, variant: i64, plane: Plane) -> Result<(), TestCaseError> {
    let steps = sim.trace.entries.iter();
    let points: Vec<V3> = steps
        .filter_map(|entry| match entry.step {
            Step::Touch { point, .. } => Some(V3::from(sim.control.to_workpiece(point))),
            _ => None,
        })
        .collect();
    let each = points.len() / count(variant);
    let (centre, radius) = fit::nearest(&points[points.len() - each..], false).unwrap();
    let last = 4 + 8 * (count(variant) - 1);
    close(sim, &format!("_OVR[{last}]"), 2.0 * radius)?;
    for (i, axis) in plane.axes().into_iter().enumerate() {
        close(sim, &format!("_OVR[{}]", last + 1 + i), centre[axis])?;
    }
    Ok(())
}

/// Names of frame data that a run wrote.
pub(super) fn written(sim: &Sim) -> Vec<&str> {
    let steps = sim.trace.entries.others();
    steps
        .filter_map(|entry| match entry.step {
            Step::Set { name, .. } if name.starts_with('$') => Some(name.as_str()),
            _ => None,
        })
        .collect()
}

const TARGETS: [f64; 4] = [1.0, 9999.0, 1011.0, 2000.0];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5))]

    /// A frame that was corrected and activated leaves nothing to correct, whichever it is.
    #[test]
    fn a_corrected_zero_offset_measures_zero(
        shift in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], turn in [-0.4..0.4_f64, -0.4..0.4_f64, -0.4..0.4_f64],
        plane in 0..3_usize, target in 0..4_usize, coarse in any::<bool>(),
    ) {
        let plane = PLANES[plane];
        for variant in [109, 1119, 10_109, 111_119] {
            let mut setup = framed(plane);
            setup.control.set("_CHBIT[21]", f64::from(u8::from(coarse)));
            setup = spheres(setup, plane, variant);
            // the part stands turned and moved, about the first sphere
            let about = V3::from(setup.workpiece.solids[0].at);
            for solid in &mut setup.workpiece.solids {
                let away = V3::from(solid.at) - about;
                let there = about + rigid::rotation(Rpy(turn)) * away + V3::from(shift);
                solid.at = there.into();
            }
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &corrected(variant, TARGETS[target])), Ok(()), "variant {}", variant);
            // oracle: manual B:8383-8413 (three spheres: rotation too, always coarse)
            let turned = written(&sim).iter().any(|name| name.ends_with(",RT]"));
            prop_assert_eq!(turned, count(variant) == 3);
            setup.control = sim.control.clone();
            setup.control.activate(1);
            start(&mut setup, plane);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs(variant)), Ok(()), "variant {}", variant);
            for index in 0..count(variant) {
                for i in 1..4 {
                    close(&sim, &format!("_OVR[{}]", 8 + 8 * index + i), 0.0)?;
                }
            }
        }
    }
}

/// Results in mm and the corrected frame of a call whose values are typed in the unit of the machine.
fn typed_in(units: Units, variant: i64) -> (Vec<f64>, Frame) {
    let mut setup = Setup::calibrated_in(Dialect::Sinumerik, Plane::G17, units);
    let unit = units.factor();
    setup.control.active_units = units;
    setup.control.activate(1);
    let mut setup = spheres(setup, Plane::G17, variant);
    for (solid, shift) in setup.workpiece.solids.iter_mut().zip([[0.5, -0.2, 0.3], [0.4, -0.1, 0.3], [0.5, -0.3, 0.2]])
    {
        solid.errors.shift = shift;
    }
    let inputs = corrected(variant, 1.0);
    let lengths = |name: &str| name.starts_with("_SETV") || ["_TSA", "_TNVL", "_RF"].contains(&name);
    let text = |(name, value): (&Name, &f64)| {
        let value = if lengths(name) { value / unit } else { *value };
        (name.to_string(), value.to_string())
    };
    let mut typed: Typed = inputs.numbers.iter().map(text).collect();
    typed.insert("_MVAR".into(), variant.to_string());
    let cycle = find(Dialect::Sinumerik, "CYCLE997").unwrap();
    let checked = check(cycle, &typed, &setup.control);
    let mut sim = Sim::new(&setup);
    let inputs = checked.inputs.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    assert_eq!(run(&mut sim, &inputs), Ok(()));
    let results = (0..29).map(|i| sim.control.number(&format!("_OVR[{i}]")) * unit);
    (results.collect(), sim.control.frames[&1])
}

#[test]
fn an_inch_machine_finds_the_same() {
    // oracle: hand (the same part on a machine that counts in inch; _FA stays in mm, B:2245)
    for variant in [109, 11_109] {
        let ((metric, in_mm), (inch, in_inch)) = (typed_in(Units::Metric, variant), typed_in(Units::Inch, variant));
        for (one, other) in metric.iter().zip(&inch) {
            assert!((one - other).abs() < 1e-9, "{variant}: {one} {other}");
        }
        for axis in 0..3 {
            assert!((in_mm.origin()[axis] - in_inch.origin()[axis]).abs() < 1e-9);
            assert!((in_mm.rotation[axis] - in_inch.rotation[axis]).abs() < 1e-9);
        }
        assert!(in_mm.origin()[0] > 0.3);
    }
}
