//! What a machine lacks for a program is offered, and is no longer missing when it was given.
#![allow(clippy::unwrap_used)]

use crate::json::asked::{catalogue, equip, form, run};
use serde_json::{Value, json};

/// The worked measurement of each cycle of SINUMERIK, behind a tool change.
fn programs(tool: &str) -> Vec<(String, String)> {
    let all = catalogue();
    let cycles = all["cycles"].as_array().unwrap().iter().filter(|cycle| cycle["control"] == "sinumerik");
    let program = |cycle: &Value| {
        let name = cycle["cycle"].as_str().unwrap();
        let asked = json!({ "control": "sinumerik", "cycle": name, "values": cycle["example"] });
        let view = form(&asked.to_string()).unwrap();
        let text = format!("{tool} M6\nD1\nG54\n{}\nM30\n", view["snippet"].as_str().unwrap());
        (name.to_owned(), text)
    };
    cycles.map(program).collect()
}

fn ran(text: &str, setup: Option<&Value>) -> Value {
    let mut asked = json!({ "control": "sinumerik", "text": text });
    if let Some(setup) = setup {
        asked["setup"] = setup.clone();
    }
    run(&asked.to_string()).unwrap()
}

fn given(text: &str, setup: Option<&Value>, supply: &Value) -> Value {
    let mut asked = json!({ "control": "sinumerik", "text": text, "change": { "give": supply } });
    if let Some(setup) = setup {
        asked["setup"] = setup.clone();
    }
    equip(&asked.to_string()).unwrap()["setup"].clone()
}

/// The findings of a run that the machine lacks something.
fn lacking(view: &Value) -> Vec<&Value> {
    let found = view["diagnostics"].as_array().unwrap().iter();
    found.filter(|one| ["run-no-tool", "run-no-edge"].contains(&one["message"]["key"].as_str().unwrap())).collect()
}

// oracle: self
#[test]
fn the_tool_that_is_not_there_is_offered_and_is_there_then() {
    for tool in ["T=\"PROBE_3D\"", "T31"] {
        for (name, text) in programs(tool) {
            let before = ran(&text, None);
            let [found] = lacking(&before)[..] else { unreachable!("{name}: {}", before["diagnostics"]) };
            let offer = &found["offers"][0];
            let probe = offer["label"]["key"] == "supply-probe";
            let setup = given(&text, None, &offer["supply"]);
            assert!(lacking(&ran(&text, Some(&setup))).is_empty(), "{name}");
            let kind = offer["supply"]["tool"]["kind"].as_i64().unwrap();
            assert_eq!(probe, [710, 580].contains(&kind), "{name}");
            let all = given(&text, None, &found["offers"][1]["supply"]);
            assert!(lacking(&ran(&text, Some(&all))).is_empty(), "{name}");
        }
    }
}

// oracle: hand
#[test]
fn the_type_of_a_tool_follows_from_its_use() {
    for (name, text) in programs("T31") {
        let kind = lacking(&ran(&text, None))[0]["offers"][0]["supply"]["tool"]["kind"].as_i64().unwrap();
        let expected = match name.as_str() {
            "CYCLE976" | "CYCLE977" | "CYCLE978" | "CYCLE979" | "CYCLE961" | "CYCLE997" | "CYCLE998" => 710,
            "CYCLE973" | "CYCLE974" | "CYCLE994" => 580,
            "CYCLE972" | "CYCLE982" => 500,
            "CYCLE971" => 120,
            _ => continue,
        };
        assert_eq!(kind, expected, "{name}");
    }
}

// oracle: self
#[test]
fn where_nothing_is_touched_the_part_of_the_program_is_offered() {
    let text =
        "T=\"PROBE_3D\" M6\nD1\nG54\nG0 X0 Y0 Z-5\n_MVAR=1 _SETVAL=50 _KNUM=0 _FA=2 _TSA=1 _PRNUM=1\nCYCLE977\nM30\n";
    let tool = given(text, None, &json!({ "tool": { "tool": 0, "name": "PROBE_3D", "edge": 1, "kind": 710 } }));
    let before = ran(text, Some(&tool));
    let alarm = before["alarms"].as_array().unwrap().iter().find(|alarm| alarm["code"] == "61301").unwrap();
    assert_eq!(alarm["offers"][0]["supply"], "parts");
    for machine in [None, Some(&tool)] {
        let setup = given(text, machine, &json!("parts"));
        let after = ran(text, Some(&setup));
        assert_eq!((&after["alarms"], &after["finished"]), (&json!([]), &json!(true)), "{setup}");
    }
}

// oracle: self
#[test]
fn the_tool_that_a_call_corrects_is_offered_at_its_field() {
    let values = |name: &str, value: &str| {
        let mut values = json!({ "_MVAR": "1", "_SETVAL": "50", "_KNUM": "2001", "_FA": "2", "_TSA": "1", "_PRNUM": "1",
            "_TZL": "0.001", "_TDIF": "0.5", "_TMV": "0.1", "_TUL": "0.2", "_TLL": "-0.2", "_VMS": "0", "_NMSP": "1" });
        values[name] = json!(value);
        values
    };
    let setup = given("", None, &json!({ "tool": { "tool": 1, "name": "", "edge": 1, "kind": 710 } }));
    for (name, value) in [("_TNAME", "DRILL_8"), ("_TNUM", "44")] {
        let asked = |setup: &Value| {
            let asked = json!({ "control": "sinumerik", "cycle": "CYCLE977", "values": values(name, value),
                "setup": setup, "predict": true });
            form(&asked.to_string()).unwrap()
        };
        let view = asked(&setup);
        let found = view["diagnostics"].as_array().unwrap().iter().find(|one| one["offers"].is_array());
        let found = found.unwrap_or_else(|| unreachable!("{name}: {}", view["diagnostics"]));
        assert_eq!(found["param"], name);
        let after = asked(&given("", Some(&setup), &found["offers"][0]["supply"]));
        assert!(after["outcome"]["alarms"].as_array().unwrap().is_empty(), "{}", after["outcome"]["alarms"]);
    }
}
