//! Values at random.

use super::{control, cycle, found};
use crate::catalogue::example::worked;
use crate::check::check;
use crate::diagnostic::Severity;
use crate::entry::Typed;

/// Deterministic numbers for properties (xorshift).
struct Random(u64);

impl Random {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        from + (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * (to - from)
    }

    fn one<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.between(0.0, list.len() as f64) as usize % list.len()]
    }
}

/// Random values in range for a variant.
fn values(random: &mut Random, name: &str, variant: i64) -> Typed {
    let (zero, outside) = (variant / 100 % 10 == 1, variant % 2 == 0);
    let size = random.between(30.0, 300.0);
    let other = random.between(30.0, 300.0);
    let zone = |size: f64| {
        if outside { size * 1.5 + 13.0 } else { (size - 13.0) * 0.9 }
    };
    let lower = random.between(-1.0, 0.5);
    let pairs = [
        ("_MVAR", variant.to_string()),
        ("_SETVAL", if name == "CYCLE978" { random.between(-500.0, 500.0) } else { size }.to_string()),
        ("_SETV[0]", size.to_string().replace('.', ",")),
        ("_SETV[1]", other.to_string()),
        ("_ID", random.between(-90.0, -1.0).to_string()),
        ("_SZA", zone(size).to_string()),
        ("_SZO", zone(other).to_string()),
        ("_MA", random.one(&["1", "2"]).to_owned()),
        (
            "_KNUM",
            if zero {
                random.one(&["0", "1", "99", "1000", "1011", "1066", "2000", "9999"])
            } else {
                random.one(&["0", "3", "2001", "12003", "0100002", "3001002"])
            }
            .to_owned(),
        ),
        ("_TNUM", random.one(&["1", "20", "4711"]).to_owned()),
        ("_TNAME", random.one(&["", "CUTTER 10"]).to_owned()),
        ("_DLNUM", random.one(&["0", "6"]).to_owned()),
        ("_TENV", "WZUMG1".to_owned()),
        ("_PRNUM", if variant >= 1000 && name == "CYCLE978" { "2" } else { random.one(&["1", "3", "103"]) }.to_owned()),
        ("_FA", random.between(0.1, 20.0).to_string()),
        ("_TSA", random.between(0.1, 20.0).to_string()),
        ("_VMS", random.between(0.0, 2000.0).to_string()),
        ("_NMSP", random.one(&["1", "5"]).to_owned()),
        ("_CORA", random.between(0.0, 359.5).to_string()),
        ("_EVNUM", random.one(&["0", "20", "200001"]).to_owned()),
        ("_K", random.one(&["1", "9"]).to_owned()),
        ("_TZL", random.between(0.0, 0.1).to_string()),
        ("_TMV", random.between(0.1, 0.2).to_string()),
        ("_TUL", (lower + random.between(0.0, 1.0)).to_string()),
        ("_TLL", lower.to_string()),
        ("_TDIF", random.between(0.1, 2.0).to_string()),
    ];
    pairs.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

#[test]
fn values_in_range_have_no_errors() {
    // oracle: self, ranges of tests/data/parameters.tsv
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for cycle in ["CYCLE977", "CYCLE978"].map(cycle) {
        for variant in cycle.variants {
            for _ in 0..40 {
                let values = values(&mut random, cycle.name, variant.number);
                let checked = check(cycle, &values, &control());
                assert_eq!(found(&checked, Severity::Error), [], "{values:?}");
                let inputs = checked.inputs.unwrap();
                assert_eq!(inputs.variant, variant.number);
                for param in cycle.params.iter().filter(|param| param.need(&inputs).is_none()) {
                    assert!(inputs.given(param.name).is_none() || param.name == "_MVAR", "{}", param.name);
                }
            }
        }
    }
}

#[test]
fn nothing_typed_breaks_a_check() {
    // oracle: self
    let cycle = cycle("CYCLE977");
    let strange = ["", " ", "-", "1e999", "-0", "9e8", "\u{0}", "\"", "💥", "1/0", "_X[", "0x10", "٣٤", "--1"];
    for param in cycle.params {
        for text in strange {
            for variant in ["1", "106", "1001", "1105"] {
                let mut values = worked(cycle);
                values.insert("_MVAR".into(), variant.into());
                values.insert(param.name.into(), text.into());
                let checked = check(cycle, &values, &control());
                let stopped = checked.diagnostics.iter().any(|other| other.severity == Severity::Error);
                assert!(!stopped || checked.inputs.is_none(), "{} {text}", param.name);
                let picture = crate::form::draw(cycle, &values, &control()).unwrap();
                let finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
                assert!(picture.shapes.len() > 5, "{} {text}", param.name);
                assert!(picture.shapes.iter().flat_map(|shape| &shape.points).all(finite), "{} {text}", param.name);
            }
        }
    }
}
