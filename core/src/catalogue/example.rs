//! The worked measurement of each variant.

use crate::catalogue::prelude::*;
use crate::check;
use crate::control::delivery;

/// Values as typed: of the cycle's example what the variant knows, what chooses it, and what it needs beside that.
pub fn example(cycle: &'static Cycle, variant: &Variant) -> Typed {
    let mut values = worked(cycle);
    values.extend(choosing(cycle, variant.number));
    let inputs = check::read(cycle, &values, &delivery(cycle.dialect), &mut Vec::new());
    for (_, more) in cycle.examples.iter().filter(|(when, _)| when.holds(&inputs)) {
        values.extend(typed(more.iter().copied()));
    }
    known(cycle, &mut values);
    values
}

/// Leaves out what the variant does not know. An address that chooses a variant says something by standing there.
fn known(cycle: &'static Cycle, values: &mut Typed) {
    if cycle.variant_param().is_none() {
        return;
    }
    let mut control = delivery(cycle.dialect);
    let inputs = [Plane::G17, Plane::G18, Plane::G19].map(|plane| {
        control.plane = plane;
        check::read(cycle, values, &control, &mut Vec::new())
    });
    let needs = |name: &str| {
        let param = cycle.param(name);
        param.is_none_or(|param| inputs.iter().any(|inputs| param.need(inputs).is_some()))
    };
    values.retain(|name, _| needs(name));
}

/// Values, as typed, that choose a variant: its number, or the address whose presence makes it.
/// An address that does so in one plane only is in the plane of a control as delivered.
pub fn choosing(cycle: &'static Cycle, number: i64) -> Typed {
    let first = |param: &crate::entry::Param| {
        let typed = param.chooses.first()?.typed;
        Some((param.name.to_string(), typed.to_owned()))
    };
    let given = cycle.params.iter().filter_map(first).collect();
    let given = check::read(cycle, &given, &delivery(cycle.dialect), &mut Vec::new());
    let value = |param: &crate::entry::Param| {
        if matches!(param.kind, crate::entry::Kind::Variant(_)) {
            return Some((param.name.to_string(), number.to_string()));
        }
        let mut choices = param.chooses.iter().filter(|one| one.when.holds(&given));
        choices.clone().next()?;
        let typed = choices.find(|one| one.variant == number).map_or("", |one| one.typed);
        Some((param.name.to_string(), typed.to_owned()))
    };
    cycle.params.iter().filter_map(value).collect()
}

/// Values of G17 in another plane: an address that names an axis is that of the axis with the same part in the plane,
/// where the cycle has all of these addresses.
pub fn turned(cycle: &Cycle, values: &Typed, plane: Plane) -> Typed {
    let axes = plane.axes();
    let turn = |name: &str| {
        let same = |names: [&str; 3]| {
            let part = names.iter().position(|one| *one == name)?;
            Some(names[axes[part]].to_owned())
        };
        same(["X", "Y", "Z"]).or_else(|| same(["I", "J", "K"])).unwrap_or_else(|| name.to_owned())
    };
    let has = |name: &String| cycle.params.iter().any(|param| param.name == name.as_str());
    if !values.keys().all(|name| has(&turn(name))) {
        return values.clone();
    }
    values.iter().map(|(name, value)| (turn(name), value.clone())).collect()
}

/// The worked measurement as it is in the entry.
pub fn worked(cycle: &Cycle) -> Typed {
    typed(cycle.example())
}

/// An example with some values changed, for tests.
#[cfg(test)]
pub fn changed(cycle: &Cycle, changes: &[(&str, &str)]) -> Typed {
    let mut values = worked(cycle);
    values.extend(changes.iter().map(|(name, value)| (name.to_string(), value.to_string())));
    values
}

fn typed(pairs: impl Iterator<Item = (Name, &'static str)>) -> Typed {
    pairs.map(|(name, value)| (name.to_string(), value.to_owned())).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::{CYCLES, find};
    use crate::dialect::Dialect;

    // oracle: manual B:5641-5667 (a zero offset knows no tool and no tolerance band)
    #[test]
    fn the_example_of_a_variant_holds_nothing_of_another_one() {
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        let of = |number: i64| {
            let mut variants = cycle.variants.iter();
            example(cycle, variants.find(|one| one.number == number).unwrap())
        };
        assert_eq!(of(1)["_TNUM"], "20");
        for name in ["_TNUM", "_TZL", "_TMV", "_TDIF"] {
            assert_eq!(of(101).get(name), None, "{name}");
        }
        // It stays complete: what is left out, the check does not ask for.
        for cycle in CYCLES {
            for variant in cycle.variants {
                let values = example(cycle, variant);
                let control = delivery(cycle.dialect);
                let inputs = check::read(cycle, &values, &control, &mut Vec::new());
                assert_eq!(inputs.variant, variant.number, "{} {values:?}", cycle.name);
            }
        }
    }
}
