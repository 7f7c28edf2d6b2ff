//! What the page's functions do with questions that no page asks: an error or an answer, never a panic.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_core::{app, json};
use serde_json::{Value, json as document};

fn form(question: &str) -> Result<String, json::Error> {
    json::answer(question, app::form)
}

fn read(question: &str) -> Result<String, json::Error> {
    json::answer(question, |asked| app::read(asked, &mut |_| {}))
}

fn change(question: &str) -> Result<String, json::Error> {
    json::answer(question, app::change)
}

fn run(question: &str) -> Result<app::Run, json::Error> {
    app::Run::new(json::question(question)?)
}

// oracle: hand
#[test]
fn a_question_of_another_shape_is_an_error() {
    for question in ["", "{", "null", "[]", "7", "\"form\"", "{}", "{\"control\":7}", &"[".repeat(100_000)] {
        assert!(form(question).is_err(), "form");
        assert!(read(question).is_err(), "read");
        assert!(change(question).is_err(), "change");
        assert!(run(question).is_err(), "run");
    }
    let unknown = document!({ "control": "fanuc", "cycle": "CYCLE977", "text": "", "values": {} }).to_string();
    assert!(form(&unknown).is_err() && read(&unknown).is_err() && run(&unknown).is_err());
    let call = document!({ "control": "sinumerik", "text": "M30", "call": 3, "name": "_FA", "value": "1" });
    assert!(change(&call.to_string()).is_err());
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
                let control = cycle.dialect;
                let question = document!({ "control": control, "cycle": cycle.name, "values": typed, "predict": true });
                let answer = form(&question.to_string());
                let view = answer.unwrap_or_else(|error| panic!("{} {value}: {error}", cycle.name));
                let view: Value = serde_json::from_str(&view.to_string()).unwrap();
                assert!(view["fields"].is_array(), "{}", cycle.name);
                assert!(view["picture"]["shapes"].is_array(), "{}", cycle.name);
            }
        }
    }
}
