//! What a zero offset is corrected by is gone when it is measured again.
#![allow(clippy::unwrap_used)]

use crate::json::asked::{catalogue, form, run, story};
use serde_json::{Value, json};

/// How far the part lies from where it should, mm.
const SHIFT: f64 = 0.25;

/// The variants of both controls that measure a hole, each with what is asked of its form; the way back to the start is
/// free in it.
fn holes() -> Vec<Value> {
    let catalogue = catalogue();
    let mut all = Vec::new();
    for cycle in catalogue["cycles"].as_array().unwrap() {
        let variants = cycle["variants"].as_array().unwrap().iter();
        for variant in variants.filter(|variant| variant["aim"]["element"] == "hole") {
            let mut values = variant["values"].as_object().cloned().unwrap_or_default();
            values.extend(variant["example"].as_object().cloned().unwrap());
            all.push(json!({ "control": cycle["control"], "cycle": cycle["cycle"], "values": values, "predict": true,
                "plane": cycle["purpose"]["plane"],
                "errors": { "part": { "dx": SHIFT, "dy": 0.1 } } }));
        }
    }
    all
}

// oracle: self (a closed loop: measure, correct, activate, measure again)
#[test]
fn what_was_corrected_is_measured_as_nothing() {
    let mut told = [0, 0];
    for asked in holes() {
        let text = story(&asked.to_string()).unwrap()["text"].as_str().unwrap().to_owned();
        if text.is_empty() {
            continue;
        }
        let setup = form(&asked.to_string()).unwrap()["setup"].clone();
        let view = run(&json!({ "control": asked["control"], "text": text, "setup": setup }).to_string()).unwrap();
        let name = format!("{} {}", asked["cycle"], asked["values"]);
        assert_eq!(view["finished"], true, "{name}: {text}{}", view["ending"]);
        let [before, after] = &view["answers"].as_array().unwrap()[..] else { unreachable!("{name}") };
        assert!(!before["corrected"].as_array().unwrap().is_empty(), "{name}");
        let left: Vec<f64> = after["corrected"]
            .as_array()
            .unwrap()
            .iter()
            .flat_map(|one| one["parts"].as_array().unwrap().clone())
            .map(|part| part["by"].as_f64().unwrap())
            .collect();
        assert!(left.iter().all(|by| by.abs() < 0.002), "{name}: {left:?}\n{text}");
        told[usize::from(asked["control"] == "nct")] += 1;
    }
    assert!(told[0] > 1 && told[1] > 0, "{told:?}");
}
