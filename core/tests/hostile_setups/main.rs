//! Machines, parts, tools and values of which each may be what nobody thinks of, under every cycle of both controls: an
//! answer, or why there is none; never a panic, and no number that is none. `PROBEWRIGHT_HOSTILE=20000` looks at so
//! many instead of a few; a case is made from its number alone, and what fails tells it.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod case;
mod draw;
mod setup;

use case::Case;
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Cases of a usual test run.
const CASES: u64 = 250;

/// Members that are null where there is nothing: the variant of wrong values, the limits of an error that has none, a
/// machine without limit switches, and what a task of the other control leaves open.
const OPEN: [&str; 4] = ["mvar", "limits", "limitsMinus", "limitsPlus"];

/// Where a document has no value; a number that is none becomes that.
fn nulls(value: &Value, path: &str) -> Vec<String> {
    let below = |name: &str, one: &Value| nulls(one, &format!("{path}/{name}"));
    match value {
        Value::Null => vec![path.to_owned()],
        Value::Array(list) => {
            let all = list.iter().enumerate();
            all.flat_map(|(index, one)| below(&index.to_string(), one)).collect()
        }
        Value::Object(members) => {
            let known = members.iter().filter(|(name, _)| !OPEN.contains(&&***name));
            known.flat_map(|(name, one)| below(name, one)).collect()
        }
        _ => Vec::new(),
    }
}

fn held(made: fn(u64) -> Case) {
    let told = std::env::var("PROBEWRIGHT_HOSTILE").ok();
    let count = told.map_or(CASES, |text| text.parse().unwrap());
    let mut answered = 0;
    for number in 0..count {
        let outcome = catch_unwind(AssertUnwindSafe(|| {
            let case = made(number);
            let answer = case.answer();
            (case, answer)
        }));
        let Ok((case, answer)) = outcome else {
            panic!("case {number} panicked");
        };
        let Ok(view) = answer else { continue };
        answered += 1;
        let nulls = nulls(&view, "");
        assert!(nulls.is_empty(), "case {number}, {}: {nulls:?}", case.name);
    }
    assert!(answered > count / 2, "{answered} of {count}");
}

// oracle: hand
#[test]
fn whatever_is_asked_is_answered_with_numbers() {
    held(Case::new);
}

// oracle: hand
#[test]
fn whatever_is_wrong_with_part_and_probe_is_answered_with_numbers() {
    held(Case::heavy);
}
