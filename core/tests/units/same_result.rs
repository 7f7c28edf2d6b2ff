//! Every variant measures the same in all units.

use super::call::measure;
use super::{BASIC, Errors, Physical};
use probewright_core::catalogue::find;
use probewright_core::control::Units;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, factor};
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use proptest::prelude::*;

/// Everything that can be compared, in mm, mm/min and degree.
fn physical(cycle: &'static Cycle, outcome: &Outcome) -> Vec<(String, f64)> {
    let mut list = Vec::new();
    for (field, value) in outcome.results(cycle) {
        list.push((field.name.to_owned(), value * factor(field.unit, &outcome.control)));
    }
    for change in outcome.changes() {
        list.push((change.name, change.after - change.before));
    }
    for entry in &outcome.trace.entries {
        if let Step::Motion { to, feed, .. } = &entry.step {
            list.extend(to.iter().chain([feed]).map(|value| ("motion".to_owned(), *value)));
        }
    }
    list
}

fn same(cycle: &'static Cycle, a: &Outcome, b: &Outcome, what: &str) {
    let (a, b) = (physical(cycle, a), physical(cycle, b));
    assert!(a.iter().any(|(_, value)| *value != 0.0));
    assert_eq!(a.len(), b.len(), "{what}: {a:?} {b:?}");
    for ((name, one), (other_name, other)) in a.iter().zip(&b) {
        assert_eq!(name, other_name, "{what}");
        assert!((one - other).abs() < 1e-8, "{what} {name}: {one} is not {other}");
    }
}

/// Values for any variant of the workpiece cycles; a form leaves out what a variant does not use.
fn workpiece(variant: i64, axis: i64) -> Physical {
    let zone = if variant % 2 == 1 { [20.0, 25.0] } else { [110.0, 120.0] };
    let knum = if variant % 1000 >= 100 { 1.0 } else { 2001.0 };
    vec![
        ("_MVAR", variant as f64),
        ("_SETVAL", 60.0),
        ("_SETV[0]", 60.0),
        ("_SETV[1]", 70.0),
        ("_ID", -25.0),
        ("_SZA", zone[0]),
        ("_SZO", zone[1]),
        ("_MA", axis as f64),
        ("_KNUM", knum),
        ("_TNUM", 20.0),
        ("_EVNUM", 10.0),
        ("_TSA", 1.5),
        ("_TUL", 0.5),
        ("_TLL", -0.4),
        ("_TDIF", 1.4),
        ("_TMV", 0.2),
        ("_TZL", 0.005),
        ("_K", 3.0),
        ("_VMS", 240.0),
        ("_FA", 3.0),
    ]
}

/// Values for any variant of the cycles of turning machines.
fn turned(variant: i64, axis: i64) -> Physical {
    let values = workpiece(variant, axis);
    let mut values: Physical = values.into_iter().filter(|(name, _)| *name != "_KNUM").collect();
    values.extend([("_KNUM", 1.0), ("_STA1", 30.0), ("_CALNUM", 1.0), ("_MD", 1.0)]);
    values
}

/// Values for any variant of the cycles at a tool probe. The radius of a cutter lies across its axis (B:9279).
fn before_a_tool_probe(variant: i64, axis: i64) -> Physical {
    let digit = |place: u32| variant / 10_i64.pow(place - 1) % 10;
    let axis = match (digit(4), digit(5)) {
        (1 | 2, 0) => 2,
        (1 | 2, _) => 1,
        _ => axis,
    };
    vec![
        ("_MVAR", variant as f64),
        ("_MA", axis as f64),
        ("_MD", 1.0),
        ("_ID", 0.0),
        ("_STA1", 20.0),
        ("_CORA", 2.0),
        ("_PRNUM", 1.0),
        ("_EVNUM", 10.0),
        ("_TSA", 1.5),
        ("_TDIF", 1.4),
        ("_TZL", 0.005),
        ("_FA", 3.0),
    ]
}

fn used(cycle: &Cycle, values: Physical) -> Physical {
    let has = |name: &str| cycle.params.iter().any(|param| param.name == name);
    values.into_iter().filter(|(name, _)| has(name)).collect()
}

fn all_units_agree(cycle: &'static Cycle, values: &Physical, codes: &[u16], errors: Errors) {
    let metric = measure(cycle, values, Units::Metric, codes[0], errors);
    for basic in BASIC {
        for code in codes {
            let other = measure(cycle, values, basic, *code, errors);
            same(cycle, &metric, &other, &format!("{} {values:?} {basic:?} G{code}", cycle.name));
        }
    }
}

fn errors() -> impl Strategy<Value = Errors> {
    let place = prop::array::uniform3(-0.3..0.3);
    (place, -0.35..0.35)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: self (the four units of the program on both machines against a metric program on a metric machine)
    #[test]
    fn cycle977_in_all_units(index in 0_usize..24, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        let mut values = used(cycle, workpiece(variant, axis));
        if variant % 10 >= 5 {
            values.retain(|(name, _)| *name != "_SETVAL");
        }
        all_units_agree(cycle, &values, &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above
    #[test]
    fn cycle978_in_all_units(index in 0_usize..4, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
        let variant = cycle.variants[index].number;
        all_units_agree(cycle, &used(cycle, workpiece(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, on a turning machine with X as diameter
    #[test]
    fn turning_in_all_units(name in prop::sample::select(vec!["CYCLE973", "CYCLE974", "CYCLE994"]),
    index in 0_usize..12, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        // the walls of the groove of position 7 lie in the ordinate, of its base there is one direction
        let axis = if variant % 100 == 13 { 2 } else { axis };
        all_units_agree(cycle, &used(cycle, turned(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, with tools before a tool probe
    #[test]
    fn tool_probes_in_all_units(name in prop::sample::select(vec!["CYCLE971", "CYCLE972", "CYCLE982"]),
    index in 0_usize..68, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        all_units_agree(cycle, &used(cycle, before_a_tool_probe(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, with the two units of the other control
    #[test]
    fn g110_in_all_units(boss in any::<bool>(), errors in errors()) {
        let cycle = find(Dialect::Nct, "G110").unwrap();
        let mut values = vec![("D", 50.0), ("R", 6.0), ("Q", 8.0), ("S", 2.0), ("M", 3.0), ("H", 0.1), ("U", 0.2)];
        if boss {
            values.push(("Z", -12.0));
        }
        all_units_agree(cycle, &values, &[21, 20], errors);
    }
}
