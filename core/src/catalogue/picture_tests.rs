//! The pictures of all cycles: each variant has its own, and it shows what the form asks for.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::*;
use crate::check::{check, read};
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Param, Typed, Unit, Variant, names};
use crate::form::{draw, fields};
use crate::name::Name;
use crate::picture::Picture;

/// The worked example in this variant, with every other value that it asks for.
fn typed(cycle: &'static Cycle, variant: &Variant, number: &str) -> Typed {
    let control = delivery(cycle.dialect);
    let mut typed = example::worked(cycle);
    typed.extend(example::choosing(cycle, variant.number));
    let inputs = read(cycle, &typed, &control, &mut Vec::new());
    for param in cycle.params.iter().filter(|param| param.need(&inputs).is_some()) {
        let value = match param.kind.choices(&inputs) {
            Some([(first, _), ..]) => first.to_string(),
            _ => number.to_owned(),
        };
        typed.entry(param.name.to_string()).or_insert(value);
    }
    typed
}

fn drawn() -> impl Iterator<Item = &'static Cycle> {
    let all = CYCLES.iter().copied();
    all.filter(|cycle| cycle.dialect == Dialect::Sinumerik)
}

/// Whether a picture can show the parameter: places, sizes, angles, directions; not areas of a deviation.
fn geometric(param: &Param) -> bool {
    let shown = matches!(param.unit, Unit::ActiveLength | Unit::Millimetre | Unit::Degree);
    let direction = [names::MA, names::MD].contains(&param.name);
    (shown || direction) && param.name != names::CORA
}

#[test]
fn pictures_show_what_the_form_asks_for() {
    // oracle: self (the parameters that the entry needs)
    for cycle in drawn() {
        for variant in cycle.variants {
            let control = delivery(cycle.dialect);
            let typed = typed(cycle, variant, "7");
            let inputs = read(cycle, &typed, &control, &mut Vec::new());
            let picture = draw(cycle, &typed, &control).unwrap();
            let needed = cycle.params.iter().filter(|param| geometric(param));
            for param in needed.filter(|param| param.need(&inputs).is_some()) {
                let shown = picture.explains(param.name);
                assert!(shown, "{} {} {}", cycle.name, variant.number, param.name);
            }
        }
    }
}

/// Every field has a place in the picture that stands out while it has the focus.
#[test]
fn pictures_follow_every_field() {
    // oracle: self (the fields of the form)
    for cycle in CYCLES {
        for variant in cycle.variants {
            let control = delivery(cycle.dialect);
            for typed in [typed(cycle, variant, "7"), example::example(cycle, variant)] {
                let picture = draw(cycle, &typed, &control).unwrap();
                let also: Vec<Name> = picture.shapes.iter().flat_map(|one| one.also.clone()).collect();
                for field in fields(cycle, &typed, &control) {
                    let shown = picture.explains(field.name) || also.contains(&field.name);
                    assert!(shown, "{} {} {}", cycle.name, variant.number, field.name);
                }
            }
        }
    }
}

/// Two numbers of one variant: CYCLE973 takes 13 for 1013 (A:11504).
const SAME: &[(&str, i64, i64)] = &[("CYCLE973", 13, 1013)];

#[test]
fn each_variant_has_its_own_picture() {
    // oracle: self
    for cycle in drawn() {
        let control = delivery(cycle.dialect);
        let pictures: Vec<(i64, Picture)> = cycle
            .variants
            .iter()
            .map(|one| {
                let mut picture = draw(cycle, &typed(cycle, one, "7"), &control).unwrap();
                picture.shapes.iter_mut().for_each(|shape| shape.also.clear());
                (one.number, picture)
            })
            .collect();
        for (index, (number, picture)) in pictures.iter().enumerate() {
            let same = pictures[..index].iter().find(|(_, other)| other == picture);
            let excused = SAME.iter().find(|(name, _, again)| (*name, again) == (cycle.name, number));
            assert_eq!(same.map(|(first, _)| *first), excused.map(|(_, first, _)| *first), "{} {number}", cycle.name,);
        }
    }
}

#[test]
fn pictures_stay_on_the_paper() {
    // oracle: self: the largest number that the check lets through is 1e9
    for cycle in drawn() {
        let control = delivery(cycle.dialect);
        for variant in cycle.variants {
            for number in ["0", "-1", "1e-9", "1e9", "-1e9", "x"] {
                let mut values = typed(cycle, variant, number);
                for param in cycle.params.iter().filter(|param| geometric(param)) {
                    values.insert(param.name.to_string(), number.to_owned());
                }
                check(cycle, &values, &control);
                let shapes = draw(cycle, &values, &control).unwrap().shapes;
                let points = shapes.iter().flat_map(|shape| &shape.points);
                let centres = shapes.iter().filter_map(|shape| shape.circle.as_ref());
                let mut all = points.chain(centres.map(|(centre, _)| centre)).flatten();
                let good = all.all(|value| value.is_finite() && value.abs() < 1e11);
                assert!(good, "{} {} {number}", cycle.name, variant.number);
            }
        }
    }
}
