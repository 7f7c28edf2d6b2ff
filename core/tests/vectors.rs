//! The figures collected from the manual (`../shared/spec/common/vectors.json`), where that folder is present.
//! The key figures stand in the tests of `evaluate` as well.

#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::evaluate::tolerance::{Bands, chain};
use probewright_core::evaluate::{knum, mean, symmetry};
use serde_json::Value;

fn vectors() -> Option<Value> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/spec/common/vectors.json");
    let text = std::fs::read_to_string(path).ok()?;
    Some(serde_json::from_str(&text).unwrap())
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn mean_values() {
    // oracle: manual B:1265-1284, recomputed where the table carries a misprint on
    let Some(vectors) = vectors() else { return };
    let table = &vectors["mean_value_table_1_2"];
    for series in list(&table["series"]) {
        let mut old = 0.0;
        for (difference, expected) in list(&table["D"]).iter().zip(list(&series["recomputed"])) {
            old = mean::next(old, number(difference), number(&series["k"])).unwrap();
            assert!((old - number(expected)).abs() < 1e-4);
            if old.abs() > number(&table["TZL"]) {
                old = 0.0;
            }
        }
    }
}

#[test]
fn symmetrising() {
    // oracle: manual B:2211
    let Some(vectors) = vectors() else { return };
    for case in list(&vectors["symmetrise"]) {
        let setpoint = number(&case["_SETVAL"]);
        let found = symmetry::symmetric(setpoint, number(&case["_TUL"]), number(&case["_TLL"]));
        assert!((found.setpoint - number(&case["_OVR[0]"])).abs() < 1e-9);
        assert!((found.upper - number(&case["_OVR[8]"])).abs() < 1e-9);
        assert!((found.lower - number(&case["_OVR[12]"])).abs() < 1e-9);
    }
}

#[test]
fn digits_of_the_correction_target() {
    // oracle: manual B:1928, B:2104-2158
    let Some(vectors) = vectors() else { return };
    for (name, five) in [("knum_tool", false), ("knum_tool_9digit_derived", true)] {
        for case in list(&vectors[name]) {
            let code = case["_KNUM"].as_i64().unwrap();
            let found = knum::digits(code, five);
            let digit = |name: &str| case["decode"][name].as_i64().unwrap();
            assert_eq!(found.edge, digit("D"));
            assert_eq!(found.kind, digit("corr"));
            assert_eq!(found.inverted, digit("invert"));
            assert_eq!(found.quantity, digit("target"));
            assert_eq!(found.mode, digit("mode"));
            assert!(knum::tool(code, five).is_ok(), "{code}");
        }
    }
    for case in list(&vectors["knum_zo"]) {
        let code = case["_KNUM"].as_i64().unwrap();
        assert_eq!(knum::zero(code).unwrap().is_none(), case["target"].is_null(), "{code}");
    }
}

#[test]
fn memories() {
    // oracle: manual B:2303-2342
    let Some(vectors) = vectors() else { return };
    for case in list(&vectors["evnum"]) {
        let found = mean::memories(case["_EVNUM"].as_i64().unwrap());
        assert_eq!(found.empirical, case["EV"].as_i64().unwrap_or(0));
        assert_eq!(found.mean, case["MV"].as_i64().unwrap_or(0));
    }
}

#[test]
fn tolerance_chain() {
    // oracle: manual B:6103-6135
    let Some(vectors) = vectors() else { return };
    let example = &vectors["chain_cycle977_example"];
    let band = |name: &str| number(&example["params"][name]);
    let bands = Bands {
        safe_area: band("TSA"),
        difference: band("TDIF"),
        upper: band("TUL"),
        lower: band("TLL"),
        mean: band("TMV"),
        zero_offset: band("TZL"),
        weight: band("K"),
    };
    for case in list(&example["cases"]) {
        let found = chain(&[number(&case["D"])], &bands, number(&case["MVold"]));
        assert_eq!(found.branch.alarm().map(u64::from), case["alarm"].as_u64(), "{case}");
        let half = case["offset"].as_f64().unwrap_or(0.0);
        assert!((found.correction / 2.0 - half).abs() < 1e-6, "{case}");
        assert!((found.memory - number(&case["mv"])).abs() < 1e-6, "{case}");
    }
}
