//! A task on both controls: what is shared survives the way there and back.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::example::example;
use super::twin::{Measurement, Twin, measured, other, twin};
use super::{CYCLES, find};
use crate::check;
use crate::control::{Control, Plane, Units, delivery_in};
use crate::diagnostic::Severity;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Task, Typed};
use crate::message::Arg;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// The tasks that both controls have.
const TASKS: [Task; 10] = [
    Task::Bore,
    Task::Boss,
    Task::Pocket,
    Task::Web,
    Task::Wall,
    Task::Face,
    Task::InnerCorner,
    Task::OuterCorner,
    Task::Ball,
    Task::Length,
];

fn control(dialect: Dialect, plane: Plane, units: Units) -> Control {
    let mut control = delivery_in(dialect, units);
    control.plane = plane;
    control
}

fn typed(values: &[(&str, &str)]) -> Typed {
    let pairs = values.iter();
    pairs.map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
}

fn cycle(dialect: Dialect, name: &str) -> &'static Cycle {
    find(dialect, name).unwrap()
}

/// What a call means.
fn meaning(cycle: &'static Cycle, values: &Typed, control: &Control) -> Measurement {
    let inputs = check::read(cycle, values, control, &mut Vec::new());
    measured(&inputs, control).unwrap().1
}

/// The call on the other control.
fn over(cycle: &'static Cycle, values: &Typed, plane: Plane, units: Units) -> Twin {
    let here = control(cycle.dialect, plane, units);
    twin(cycle, values, &here).unwrap_or_else(|| panic!("{} {values:?}", cycle.name))
}

/// Whether everything that one says stands in the other too; it may say more, as the defaults of its control do.
fn says(whole: &Measurement, part: &Measurement) -> bool {
    let near = |one: Option<f64>, other: Option<f64>| match (one, other) {
        (_, None) => true,
        (Some(one), Some(other)) => (one - other).abs() < 1e-6,
        (None, Some(_)) => false,
    };
    let same = |one: Option<i64>, other: Option<i64>| other.is_none() || one == other;
    whole.task == part.task
        && whole.corrects_tool == part.corrects_tool
        && (part.axis.is_none() || whole.axis == part.axis)
        && near(whole.nominal, part.nominal)
        && near(whole.depth, part.depth)
        && near(whole.corner.map(|at| at[0]), part.corner.map(|at| at[0]))
        && near(whole.corner.map(|at| at[1]), part.corner.map(|at| at[1]))
        && near(whole.half, part.half)
        && near(whole.limit, part.limit)
        && near(whole.reach, part.reach)
        && same(whole.zero, part.zero)
        && same(whole.tool, part.tool)
}

/// Every variant with a task, with its worked measurement.
fn all() -> impl Iterator<Item = (&'static Cycle, Typed)> {
    let examples = CYCLES.iter().flat_map(|cycle| {
        let variants = cycle.variants.iter();
        variants.map(move |variant| (*cycle, example(cycle, variant)))
    });
    examples.filter(|(cycle, values)| {
        let here = control(cycle.dialect, Plane::G17, Units::Metric);
        let inputs = check::read(cycle, values, &here, &mut Vec::new());
        measured(&inputs, &here).is_some_and(|(_, there)| TASKS.contains(&there.task))
    })
}

// oracle: issue (every task that both controls can do)
#[test]
fn both_controls_have_every_task() {
    for dialect in [Dialect::Sinumerik, Dialect::Nct] {
        let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == dialect);
        let tasks: BTreeSet<_> = cycles.flat_map(|cycle| cycle.purpose.tasks).map(|shared| shared.task).collect();
        let alone: BTreeSet<_> = tasks.difference(&TASKS.into()).copied().collect();
        // a macro of NCT measures a width, and none a rectangle or an angle
        let only = [Task::Rectangle, Task::Island, Task::Angle].into_iter();
        assert_eq!(alone, only.filter(|_| dialect == Dialect::Sinumerik).collect(), "{dialect:?}");
        assert!(tasks.is_superset(&TASKS.into()), "{dialect:?}");
    }
    assert_eq!(other(other(Dialect::Nct)), Dialect::Nct);
}

// oracle: self: the parameters that an entry names are its own
#[test]
fn tasks_name_parameters_and_variants_of_their_cycle() {
    for cycle in CYCLES {
        for shared in cycle.purpose.tasks {
            let numbers: Vec<i64> = cycle.variants.iter().map(|one| one.number).collect();
            assert!(numbers.contains(&shared.variant), "{}", cycle.name);
            for (name, _) in shared.values {
                assert!(cycle.param(name).is_some(), "{} {name}", cycle.name);
            }
        }
    }
}

// oracle: self: there and back says the same, and there again changes nothing
#[test]
fn what_is_shared_survives_the_way_there_and_back() {
    let mut seen = 0;
    for (cycle, values) in all() {
        for units in [Units::Metric, Units::Inch] {
            let there = over(cycle, &values, Plane::G17, units);
            let back = over(there.cycle, &there.values, Plane::G17, units);
            let name = format!("{} {values:?} {:?}", cycle.name, there.values);
            assert!(says(&back.measurement, &there.measurement), "{name}");
            let last = control(cycle.dialect, Plane::G17, units);
            let last = meaning(back.cycle, &back.values, &last);
            assert!(says(&last, &back.measurement), "{name} {:?}", back.values);
            seen += 1;
        }
    }
    assert!(seen > 50, "{seen}");
}

// oracle: self: a twin of a complete call lacks nothing but what the differences name
#[test]
fn the_twin_of_a_worked_measurement_is_complete() {
    for (cycle, values) in all() {
        let there = over(cycle, &values, Plane::G17, Units::Metric);
        let machine = control(there.cycle.dialect, Plane::G17, Units::Metric);
        let found = check::check(there.cycle, &there.values, &machine).diagnostics;
        let errors: Vec<_> = found.iter().filter(|one| one.severity == Severity::Error).collect();
        assert!(errors.is_empty(), "{} {:?} {errors:?}", there.cycle.name, there.values);
    }
}

// oracle: manual C:500, C:934: 20.0 +0.1/-0.3 is nominal 19.9 with H0.2
#[test]
fn unequal_limits_become_a_middle_and_a_half() {
    let values = typed(&[
        ("_MVAR", "1"),
        ("_SETVAL", "20"),
        ("_TUL", "0.1"),
        ("_TLL", "-0.3"),
        ("_TDIF", "1"),
        ("_TNUM", "7"),
        ("_KNUM", "2001"),
    ]);
    let bore = cycle(Dialect::Sinumerik, "CYCLE977");
    let there = over(bore, &values, Plane::G17, Units::Metric);
    assert_eq!(there.cycle.name, "G110");
    let expected = typed(&[("D", "19.9"), ("H", "0.2"), ("U", "1"), ("T", "7"), ("Q", "2")]);
    assert_eq!(there.values, expected);
    let keys: Vec<&str> = there.differences.iter().map(|one| &*one.key).collect();
    assert_eq!(keys[0], "twin-middle");
}

// oracle: hand: a bore whose centre becomes the zero of G54, in both languages
#[test]
fn measure_a_bore_and_set_the_zero_offset() {
    let macro_call = typed(&[("D", "50"), ("S", "1"), ("U", "0.5"), ("Q", "3")]);
    let bore = cycle(Dialect::Nct, "G110");
    let there = over(bore, &macro_call, Plane::G18, Units::Metric);
    assert_eq!(there.cycle.name, "CYCLE977");
    let expected = [("_MVAR", "101"), ("_SETVAL", "50"), ("_KNUM", "1"), ("_TSA", "0.5"), ("_FA", "3")];
    for (name, value) in expected {
        assert_eq!(there.values[name], value, "{name}");
    }
}

// oracle: manual B:7929-7935 (the zero lies so far from the corner), C:723 (coordinates that the corner gets)
#[test]
fn a_corner_gets_the_same_coordinates() {
    let corner = cycle(Dialect::Sinumerik, "CYCLE961");
    for (beside, x, y) in [
        (&[("_SETV[4]", "1")][..], "0", "0"),
        (&[("_SETV[4]", "2"), ("_SETV[2]", "-8")], "8", "0"),
        (&[("_SETV[4]", "3"), ("_SETV[2]", "-8"), ("_SETV[3]", "5")], "8", "-5"),
        (&[("_SETV[4]", "4"), ("_SETV[3]", "5")], "0", "-5"),
    ] {
        let mut values = typed(&[("_MVAR", "106"), ("_STA1", "0"), ("_KNUM", "1")]);
        values.extend(typed(beside));
        for (plane, axes) in [(Plane::G17, ["X", "Y"]), (Plane::G19, ["Y", "Z"])] {
            let there = over(corner, &values, plane, Units::Metric);
            assert_eq!(there.cycle.name, "G108");
            let found = axes.map(|axis| there.values[axis].as_str());
            assert_eq!(found, [x, y], "{beside:?}");
        }
    }
    let inside = typed(&[("X", "100"), ("Y", "-80"), ("S", "1")]);
    let there = over(cycle(Dialect::Nct, "G107"), &inside, Plane::G17, Units::Metric);
    for (name, value) in [("_STA1", "0"), ("_SETV[4]", "3"), ("_SETV[2]", "-100"), ("_SETV[3]", "80")] {
        assert_eq!(there.values[name], value, "{name}");
    }
}

// oracle: hand: from the height that is told down to the coordinate
#[test]
fn a_depth_is_measured_from_the_start() {
    let boss = typed(&[("D", "40"), ("Z", "-12"), ("S", "1")]);
    let there = over(cycle(Dialect::Nct, "G110"), &boss, Plane::G17, Units::Metric);
    assert_eq!(there.values["_ID"], "-32");
    let told = there.differences.iter().find(|one| one.key == "twin-depth");
    assert_eq!(told.unwrap().args[1].1, Arg::Number(20.0));
    let inch = over(cycle(Dialect::Nct, "G110"), &boss, Plane::G17, Units::Inch);
    assert_eq!(inch.values["_ID"], "-12.8");
    let web = typed(&[("_MVAR", "104"), ("_SETVAL", "30"), ("_MA", "2"), ("_ID", "-25"), ("_KNUM", "1")]);
    let there = over(cycle(Dialect::Sinumerik, "CYCLE977"), &web, Plane::G17, Units::Metric);
    assert_eq!((&*there.values["Y"], &*there.values["Z"]), ("30", "-5"));
    let above = typed(&[("D", "40"), ("Z", "25")]);
    let there = over(cycle(Dialect::Nct, "G110"), &above, Plane::G17, Units::Metric);
    let example = there.differences.iter().find(|one| one.key == "twin-example");
    assert!(example.is_some(), "{:?}", there.differences);
}

// oracle: definition of the planes: the first axis of the plane is the abscissa of `_MA`
#[test]
fn the_address_of_an_axis_follows_the_plane() {
    let wall = typed(&[("_MVAR", "100"), ("_SETVAL", "12"), ("_MA", "1"), ("_KNUM", "2")]);
    let surface = cycle(Dialect::Sinumerik, "CYCLE978");
    for (plane, axis) in [(Plane::G17, "X"), (Plane::G18, "Z"), (Plane::G19, "Y")] {
        let there = over(surface, &wall, plane, Units::Metric);
        assert_eq!((there.cycle.name, &*there.values[axis]), ("G105", "12"));
        let mut face = wall.clone();
        face.insert("_MA".into(), "3".into());
        let there = over(surface, &face, plane, Units::Metric);
        let axis = super::nct::bench::TOOL_AXIS.iter().find(|(of, _)| *of == plane);
        assert_eq!((there.cycle.name, &*there.values[axis.unwrap().1]), ("G106", "12"));
    }
}

// oracle: hand: offsets that only one control has are told
#[test]
fn a_zero_offset_without_counterpart_is_told() {
    for (name, values, told) in [
        ("CYCLE977", typed(&[("_MVAR", "101"), ("_SETVAL", "9"), ("_KNUM", "1000")]), true),
        ("CYCLE977", typed(&[("_MVAR", "101"), ("_SETVAL", "9"), ("_KNUM", "0")]), false),
        ("G110", typed(&[("D", "9"), ("S", "0")]), true),
        ("G110", typed(&[("D", "9")]), false),
    ] {
        let dialect = if name == "G110" { Dialect::Nct } else { Dialect::Sinumerik };
        let there = over(cycle(dialect, name), &values, Plane::G17, Units::Metric);
        let keys: Vec<&str> = there.differences.iter().map(|one| &*one.key).collect();
        assert_eq!(keys.contains(&"twin-no-zero"), told, "{name} {keys:?}");
        assert!(!keys.contains(&"twin-at-once"), "{name}");
    }
}

proptest! {
    // oracle: self
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn random_values_survive(nominal in 1.0..500.0_f64, half in 0.001..2.0_f64, limit in 0.01..5.0_f64,
    reach in 0.1..20.0_f64, zero in 1..=6_i64, which in 0..4_usize) {
        let (name, axis) = [("G110", "D"), ("G109", "X"), ("G105", "Y"), ("G106", "Z")][which];
        let mut values = Typed::new();
        for (address, value) in [(axis, nominal), ("U", limit), ("Q", reach), ("S", zero as f64)] {
            values.insert(address.into(), value.to_string());
        }
        let first = cycle(Dialect::Nct, name);
        let there = over(first, &values, Plane::G17, Units::Metric);
        let back = over(there.cycle, &there.values, Plane::G17, Units::Metric);
        prop_assert!(says(&back.measurement, &there.measurement));
        values.remove("S");
        for (address, value) in [("H", half), ("T", zero as f64)] {
            values.insert(address.into(), value.to_string());
        }
        let there = over(first, &values, Plane::G17, Units::Metric);
        let back = over(there.cycle, &there.values, Plane::G17, Units::Metric);
        prop_assert!(says(&back.measurement, &there.measurement));
        prop_assert_eq!(back.cycle.name, name);
    }
}
