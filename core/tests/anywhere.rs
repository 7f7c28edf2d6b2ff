//! Results do not depend on where the part stands on the machine: zero offset, part, probe and start moved and turned
//! together give the same results, in every variant of every workpiece cycle of milling, plane and with every error of
//! the part that the cycle survives.
// oracle: self (a rigid motion of everything is only another choice of coordinates)
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::check::check;
use probewright_core::control::{Control, Frame, MachineSort, Plane};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Inputs, ProbeUse, Typed, Variant};
use probewright_core::geometry::{Dir, Rpy};
use probewright_core::machine::Setup;
use probewright_core::run::{Outcome, predict};
use probewright_core::workpiece::PartErrors;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Results in machine coordinates, by cycle (B:16033-16057).
const OF_THE_MACHINE: [(&str, &[usize]); 1] = [("CYCLE961", &[20, 21, 22])];
/// Set angles that are told in machine coordinates (B:7858, B:15364).
const ANGLES: [(&str, &str); 1] = [("CYCLE961", "_STA1")];

/// Where the zero offset stands: the same for part and probe.
#[derive(Clone, Copy, Debug)]
struct Place {
    at: [f64; 3],
    /// About the applicate, degree.
    turn: f64,
}

/// What is wrong with the part, in abscissa, ordinate, applicate.
#[derive(Clone, Copy, Debug)]
struct Wrong {
    shift: [f64; 3],
    size: f64,
    tilt: f64,
}

fn places() -> impl Strategy<Value = Place> {
    let at = prop::array::uniform3(-1500.0..1500.0_f64);
    (at, -180.0..180.0_f64).prop_map(|(at, turn)| Place { at, turn })
}

fn wrongs() -> impl Strategy<Value = Wrong> {
    let shift = prop::array::uniform3(-0.3..0.3_f64);
    (shift, -0.3..0.3_f64, -0.4..0.4_f64).prop_map(|(shift, size, tilt)| Wrong { shift, size, tilt })
}

/// Abscissa, ordinate and applicate as X Y Z.
fn seen(plane: Plane, values: [f64; 3]) -> [f64; 3] {
    let mut point = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(values) {
        point[axis] = value;
    }
    point
}

/// The machine with the zero offset there, the proposed part on it and the probe before it.
fn stands(
    cycle: &'static Cycle,
    variant: &Variant,
    plane: Plane,
    place: Place,
    wrong: Wrong,
) -> Option<(Setup, Inputs)> {
    let mut setup = Setup::for_cycle(cycle, plane);
    let frame = Frame { coarse: place.at, rotation: Rpy(seen(plane, [0.0, 0.0, place.turn])), ..Frame::default() };
    setup.control.frames.insert(1, frame);
    setup.control.activate(1);
    let inputs = inputs(cycle, variant, &setup.control, place.turn)?;
    let proposal = (cycle.work()?.propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    let shift = setup.control.direction_to_machine(Dir::new(seen(plane, wrong.shift))).0;
    for solid in &mut setup.workpiece.solids {
        solid.errors = PartErrors {
            shift,
            size: wrong.size,
            tilt: Rpy(seen(plane, [0.0, 0.0, wrong.tilt])),
            ..PartErrors::default()
        };
    }
    setup.workpiece.solids.extend(proposal.fixture);
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.name = proposed.name;
        tool.edges.entry(proposed.edge).or_insert(proposed.data);
    }
    setup.position = setup.control.to_machine(proposal.start);
    Some((setup, inputs))
}

/// The worked measurement of a variant; none where the cycle refuses it in this plane.
fn inputs(cycle: &'static Cycle, variant: &Variant, control: &Control, turn: f64) -> Option<Inputs> {
    let mut typed: Typed = example(cycle, variant);
    for (_, name) in ANGLES.iter().filter(|(known, _)| *known == cycle.name) {
        let angle: f64 = typed.get(*name).map_or(0.0, |text| text.parse().unwrap());
        let turned = (angle + turn + 180.0).rem_euclid(360.0) - 180.0;
        typed.insert((*name).to_owned(), turned.to_string());
    }
    check(cycle, &typed, control).inputs
}

/// Everything that a cycle tells and corrects in a tool.
fn told(cycle: &Cycle, outcome: &Outcome) -> Vec<(String, f64)> {
    let machine = OF_THE_MACHINE.iter().filter(|(name, _)| *name == cycle.name);
    let machine: Vec<usize> = machine.flat_map(|(_, fields)| fields.iter().copied()).collect();
    let ovr = (0..32).filter(|index| !machine.contains(index));
    let names = ovr.map(|index| format!("_OVR[{index}]"));
    let names = names.chain((0..14).map(|index| format!("_OVI[{index}]")));
    let names = names.chain((0..9).map(|index| format!("_WP[0,{index}]")));
    let mut told: Vec<(String, f64)> = names.map(|name| (name.clone(), outcome.control.number(&name))).collect();
    for change in outcome.changes() {
        if change.name.starts_with("$TC") {
            told.push((change.name, change.after));
        }
    }
    told
}

/// One variant with one error of the part, at home and elsewhere; whether it could be measured.
fn same(
    cycle: &'static Cycle,
    variant: &Variant,
    plane: Plane,
    place: Place,
    wrong: Wrong,
) -> Result<bool, TestCaseError> {
    let home = Place { at: [0.0; 3], turn: 0.0 };
    let there = stands(cycle, variant, plane, place, wrong);
    let (Some((here, inputs)), Some((there, moved))) = (stands(cycle, variant, plane, home, wrong), there) else {
        return Ok(false);
    };
    let (here, there) = (predict(cycle, &inputs, &here), predict(cycle, &moved, &there));
    let what = format!("{} {} {plane:?}", cycle.name, variant.number);
    prop_assert_eq!(&here.stop, &there.stop, "{}", what);
    for (a, b) in told(cycle, &here).into_iter().zip(told(cycle, &there)) {
        prop_assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-9, "{}: {:?} {:?}", what, a, b);
    }
    Ok(here.stop.is_none())
}

#[test]
fn the_place_on_the_machine_changes_nothing() {
    let milling = CYCLES.iter().filter(|cycle| {
        cycle.dialect == Dialect::Sinumerik
            && cycle.purpose.machine == MachineSort::Milling
            && cycle.purpose.probe == ProbeUse::Workpiece
            && cycle.work().is_some()
    });
    let mut names = Vec::new();
    for cycle in milling {
        for variant in cycle.variants {
            let measured = std::cell::Cell::new(0);
            let config = Config { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Config::with_cases(12) };
            let cases = (places(), wrongs(), 0..3_usize);
            let outcome = TestRunner::new(config).run(&cases, |(place, wrong, plane)| {
                let finished = same(cycle, variant, PLANES[plane], place, wrong)?;
                measured.set(measured.get() + usize::from(finished));
                Ok(())
            });
            outcome.unwrap_or_else(|problem| panic!("{problem}"));
            assert!(measured.get() > 6, "{} {}", cycle.name, variant.number);
        }
        names.push(cycle.name);
    }
    names.sort_unstable();
    assert_eq!(names, ["CYCLE961", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979", "CYCLE997", "CYCLE998"]);
}
