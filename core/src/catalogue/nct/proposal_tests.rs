#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! The worked measurement of every macro runs on its own part, and finds what is wrong with it.

use super::bench::{along, machine, near};
use crate::catalogue::CYCLES;
use crate::catalogue::example::{example, turned};
use crate::check::{check, read};
use crate::control::{Control, Plane};
use crate::dialect::Dialect;
use crate::entry::{Cycle, ProbeUse, Variant};
use crate::form::draw;
use crate::run::predict;

const SHIFT: [f64; 3] = [0.21, -0.13, 0.17];
const SIZE: f64 = 0.01;

/// Macros that measure a part, in the active plane.
fn macros() -> impl Iterator<Item = (&'static Cycle, &'static Variant)> {
    let all = CYCLES.iter().copied();
    all.filter(|cycle| cycle.dialect == Dialect::Nct && cycle.purpose.probe == ProbeUse::Workpiece)
        .flat_map(|cycle| cycle.variants.iter().map(move |variant| (cycle, variant)))
}

/// What a macro finds on its proposed part with errors.
fn found(cycle: &'static Cycle, variant: &Variant, plane: Plane) -> Control {
    let mut setup = machine(plane, false);
    let typed = turned(cycle, &example(cycle, variant), plane);
    let checked = check(cycle, &typed, &setup.control);
    let inputs = checked.inputs.unwrap_or_else(|| panic!("{} {:?}", cycle.name, checked.diagnostics));
    assert_eq!(inputs.variant, variant.number, "{} {typed:?}", cycle.name);
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        solid.errors.shift = along(plane, SHIFT);
        solid.errors.size = SIZE;
    }
    setup.position = setup.control.to_machine(proposal.start);
    let outcome = predict(cycle, &inputs, &setup);
    assert_eq!(outcome.stop, None, "{} {} {plane:?}", cycle.name, variant.number);
    outcome.control
}

// oracle: hand (errors of the part)
#[test]
fn every_macro_measures_its_own_part() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for (cycle, variant) in macros() {
            let control = found(cycle, variant, plane);
            let expected: &[(&str, f64)] = match cycle.name {
                "G101" => &[],
                // the start is taken for the axis of the hole, which the spindle is said to have bored
                "G102" => &[("#504", -SHIFT[0]), ("#505", -SHIFT[1])],
                "G103" => {
                    let radius = 3.0 - SIZE / 2.0; // a ring that is larger than it is said to be
                    &[("#500", radius), ("#501", radius), ("#502", radius), ("#503", radius)]
                }
                "G65 P9969" => &[], // its own tests hold it against surfaces
                "G104" => &[("DEVIATION", SHIFT[2]), ("LENGTH", 53.0 + SHIFT[2])],
                "G105" => &[("DEVIATION", SHIFT[0] + SIZE / 2.0)],
                "G106" => &[("DEVIATION", SHIFT[2])],
                "G107" => &[("SHIFT_1", SHIFT[0] + SIZE / 2.0), ("SHIFT_2", SHIFT[1] + SIZE / 2.0)],
                "G108" => &[("SHIFT_1", SHIFT[0] - SIZE / 2.0), ("SHIFT_2", SHIFT[1] - SIZE / 2.0)],
                "G109" => &[("DEVIATION", SIZE), ("SHIFT", SHIFT[0])],
                "G110" => &[("DEVIATION", SIZE), ("SHIFT_1", SHIFT[0]), ("SHIFT_2", SHIFT[1])],
                other => panic!("{other} has no expectation"),
            };
            for (name, value) in expected {
                near(control.number(name), *value);
            }
        }
    }
}

// oracle: self: whatever is typed, a picture stays on the paper and shows each length of the call
#[test]
fn pictures_show_the_call_and_stay_on_the_paper() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        let control = machine(plane, false).control;
        for (cycle, variant) in macros() {
            let typed = turned(cycle, &example(cycle, variant), plane);
            let inputs = read(cycle, &typed, &control, &mut Vec::new());
            let picture = draw(cycle, &typed, &control).unwrap();
            let lengths = typed
                .iter()
                .filter(|(name, value)| !value.is_empty() && !["S", "T", "M", "V", "W"].contains(&name.as_str()));
            for (name, _) in lengths.filter(|_| cycle.name != "G101") {
                let mut fields = picture.shapes.iter().filter_map(|shape| shape.field);
                let axial = super::axis_name(plane.axes()[2]) == name.as_str() && cycle.name == "G110";
                assert!(axial || fields.any(|field| field == name.as_str()), "{} {name}", cycle.name);
            }
            for number in ["0", "-1", "1e-9", "1e6", "-1e6", "x"] {
                let values = inputs.numbers.keys();
                let values = values.map(|name| (name.to_string(), number.to_owned()));
                let shapes = draw(cycle, &values.collect(), &control).unwrap().shapes;
                let points = shapes.iter().flat_map(|shape| &shape.points);
                let centres = shapes.iter().filter_map(|shape| shape.circle.as_ref());
                let mut all = points.chain(centres.map(|(centre, _)| centre)).flatten();
                assert!(all.all(|value| value.is_finite() && value.abs() < 1e9), "{}", cycle.name);
            }
        }
    }
}
