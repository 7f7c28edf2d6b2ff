//! A machine, parts and calls for the tests of the workpiece cycles.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::{find, place};
use crate::control::Plane;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::{Inputs, ProbeUse};
use crate::geometry::Mcs;
use crate::machine::{MotionKind, Setup, Sim, Step, Stop};
use crate::workpiece::{PartErrors, Shape, Solid};
use nalgebra::{Matrix3, Rotation3};
use proptest::test_runner::{Config, RngSeed};

/// Parts by which each cycle shows that it finds what is there.
const PARTS: u32 = 2000;

/// Random parts, thousands a cycle where each case measures so many of them, and always the same ones.
pub fn random_parts(each: usize) -> Config {
    Config {
        rng_seed: RngSeed::Fixed(977),
        failure_persistence: None,
        ..Config::with_cases(PARTS.div_ceil(each as u32))
    }
}

/// A calibrated machine in this plane with a mill in the magazine; the probe stands 100 mm above the origin.
pub fn setup(plane: Plane) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, plane);
    for (name, value) in [("$TC_DP1[20,1]", 120.0), ("$TC_DP3[20,1]", 80.0), ("$TC_DP6[20,1]", 10.0)] {
        assert!(setup.control.set_variable(name, value));
    }
    setup.control.activate(1);
    setup
}

/// A point from abscissa, ordinate, applicate.
pub fn at(plane: Plane, point: [f64; 3]) -> [f64; 3] {
    let mut place = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(point) {
        place[axis] = value;
    }
    place
}

/// A part whose depth lies along the applicate and whose X lies along the abscissa, or with `across` along the
/// ordinate.
pub fn solid(plane: Plane, shape: Shape, place: [f64; 3], across: bool) -> Solid {
    let unit = |axis: usize| {
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        unit
    };
    let [abscissa, ordinate, applicate] = plane.axes().map(unit);
    let columns = match across {
        false => [abscissa, ordinate, applicate],
        true => [ordinate, abscissa.map(|x| -x), applicate],
    };
    let matrix = Matrix3::from_columns(&columns.map(Into::into));
    Solid {
        shape,
        at: Mcs(at(plane, place)),
        rotation: crate::geometry::rigid::angles(&Rotation3::from_matrix_unchecked(matrix)),
        errors: PartErrors::default(),
    }
}

/// What the last digit of a variant names, of this size.
pub fn element(variant: i64, length: [f64; 2]) -> Shape {
    place::element(variant % 10, length, 40.0)
}

/// Bands so wide that errors of some mm are corrected, at once and without a mean value.
pub const WIDE_BANDS: [(&str, f64); 6] =
    [("_TSA", 3.0), ("_TDIF", 2.5), ("_TUL", 2.4), ("_TLL", -2.4), ("_TMV", 2.0), ("_TZL", 0.0)];

/// A call: default values of all parameters, then these.
pub fn call(name: &str, variant: i64, values: &[(&'static str, f64)]) -> Inputs {
    let cycle = find(Dialect::Sinumerik, name).unwrap();
    let mut inputs = Inputs::new(cycle, variant);
    for param in cycle.params {
        if let Some(default) = param.default {
            inputs.numbers.insert(param.name, default);
        }
    }
    for (name, value) in values {
        put(&mut inputs, name, *value);
    }
    inputs
}

/// Gives a parameter, which the cycle has to have, this number.
pub fn put(inputs: &mut Inputs, name: &str, value: f64) {
    let param = inputs.cycle.param(name).unwrap_or_else(|| panic!("{} {name}", inputs.cycle.name));
    inputs.numbers.insert(param.name, value);
}

/// Runs a call on a machine as it is.
pub fn run(sim: &mut Sim, inputs: &Inputs) -> Result<(), Stop> {
    let purpose = &inputs.cycle.purpose;
    sim.measuring = (purpose.probe == ProbeUse::Workpiece).then_some(purpose.machine);
    (inputs.cycle.work().unwrap().simulate)(sim, inputs)
}

/// Runs a call on a new machine: what became of it, and how it ended.
pub fn called(setup: &Setup, inputs: &Inputs) -> (Sim, Result<(), Stop>) {
    let mut sim = Sim::new(setup);
    let outcome = run(&mut sim, inputs);
    (sim, outcome)
}

/// The alarm that stopped a call.
pub fn stopped(outcome: Result<(), Stop>) -> u32 {
    match outcome {
        Err(Stop::Alarm(Code::Alarm(number))) => number,
        other => panic!("{other:?}"),
    }
}

/// What some steps of a trace tell, in order.
fn told<T>(sim: &Sim, tell: impl Fn(&Step) -> Option<T>) -> Vec<T> {
    let entries = sim.trace.entries.iter();
    entries.filter_map(|entry| tell(&entry.step)).collect()
}

/// Alarms that a trace shows, in order.
pub fn alarms(sim: &Sim) -> Vec<u32> {
    told(sim, |step| match step {
        Step::Alarm(Code::Alarm(number)) => Some(*number),
        _ => None,
    })
}

/// Angles to which the spindle was turned, in order.
pub fn turns(sim: &Sim) -> Vec<f64> {
    told(sim, |step| match step {
        Step::Orient { angle } => Some(angle.0),
        _ => None,
    })
}

/// Where the probe switched, machine, in order.
pub fn touches(sim: &Sim) -> Vec<[f64; 3]> {
    told(sim, |step| match step {
        Step::Touch { latched, .. } => Some(latched.0),
        _ => None,
    })
}

/// A datum is what was expected, to 1e-9.
pub fn close(sim: &Sim, name: &str, value: f64) {
    let found = sim.control.number(name);
    assert!((found - value).abs() < 1e-9, "{name} = {found}, expected {value}");
}

/// A motion: kind, end as abscissa, ordinate, applicate from an origin, feed.
pub type Motion = (MotionKind, [f64; 3], f64);

/// Motions of a trace, from a machine position.
pub fn motions(sim: &Sim, plane: Plane, origin: [f64; 3]) -> Vec<Motion> {
    told(sim, |step| match step {
        Step::Motion { kind, to, feed, .. } => Some((*kind, plane.axes().map(|i| to[i] - origin[i]), *feed)),
        _ => None,
    })
}

/// Motions are those that were expected, to 1e-9 mm.
pub fn same(found: &[Motion], expected: &[Motion], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}: {found:#?}");
    for (is, wanted) in found.iter().zip(expected) {
        assert_eq!((is.0, is.2), (wanted.0, wanted.2), "{what}: {is:?} {wanted:?}");
        for (a, b) in is.1.iter().zip(wanted.1) {
            assert!((a - b).abs() < 1e-9, "{what}: {is:?} {wanted:?}");
        }
    }
}
