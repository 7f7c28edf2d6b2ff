//! What the page's functions do with questions that no page asks: an error or an answer, never a panic.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_core::json;
use serde_json::{Value, json as document};

// oracle: hand
#[test]
fn a_question_of_another_shape_is_an_error() {
    for question in ["", "{", "null", "[]", "7", "\"form\"", "{}", "{\"control\":7}", &"[".repeat(100_000)] {
        assert!(json::form(question).is_err(), "form");
        assert!(json::read(question).is_err(), "read");
        assert!(json::change(question).is_err(), "change");
        assert!(json::Run::new(question).is_err(), "run");
    }
    let unknown = document!({ "control": "fanuc", "cycle": "CYCLE977", "text": "", "values": {} }).to_string();
    assert!(json::form(&unknown).is_err() && json::read(&unknown).is_err() && json::Run::new(&unknown).is_err());
    let call = document!({ "control": "sinumerik", "text": "M30", "call": 3, "name": "_FA", "value": "1" });
    assert!(json::change(&call.to_string()).is_err());
}

// oracle: hand (whatever is typed into every field of every variant, the form has its fields and its picture)
#[test]
fn absurd_values_of_every_variant_give_a_form() {
    let values = ["1e6", "1e-9", "-1", "0", "1,5", "999999", "1e308", "NaN", "٣", "R1", "1e9", ""];
    for cycle in CYCLES {
        for variant in cycle.variants {
            for value in values {
                let typed: serde_json::Map<String, Value> = cycle
                    .params
                    .iter()
                    .map(|param| {
                        let chosen = if param.name == "_MVAR" { variant.number.to_string() } else { value.to_owned() };
                        (param.name.to_string(), document!(chosen))
                    })
                    .collect();
                let control = json::dialect_name(cycle.dialect);
                let question = document!({ "control": control, "cycle": cycle.name, "values": typed, "predict": true });
                let answer = json::form(&question.to_string());
                let view = answer.unwrap_or_else(|error| panic!("{} {value}: {error}", cycle.name));
                let view: Value = serde_json::from_str(&view.to_string()).unwrap();
                assert!(view["fields"].is_array(), "{}", cycle.name);
                assert!(view["picture"]["shapes"].is_array(), "{}", cycle.name);
            }
        }
    }
}
