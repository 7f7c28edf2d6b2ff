//! The tables of the machine: what is typed into a field stands in the setup file, and comes back from it.
#![allow(clippy::unwrap_used)]

use crate::json::asked::equip;
use crate::json::{document, setup_from_json};
use serde_json::{Value, json};

fn ask(control: &str, setup: Option<&Value>, change: &Value) -> Value {
    let mut asked = json!({ "control": control });
    if !change.is_null() {
        asked["change"] = change.clone();
    }
    if let Some(setup) = setup {
        asked["setup"] = setup.clone();
    }
    let view = equip(&asked.to_string()).unwrap();
    let again = setup_from_json(&view["setup"].to_string()).unwrap();
    assert_eq!(document(&again), view["setup"], "{change}");
    view
}

fn rows<'a>(view: &'a Value, table: &str) -> &'a Vec<Value> {
    let tables = view["tables"].as_array().unwrap();
    tables.iter().find(|one| one["table"] == table).unwrap()["rows"].as_array().unwrap()
}

fn cells<'a>(view: &'a Value, table: &str, row: &str) -> Vec<&'a Value> {
    let row = rows(view, table).iter().find(|one| one["id"] == row).unwrap();
    row["cells"].as_array().unwrap().iter().collect()
}

/// Another value that a field takes.
fn other(cell: &Value) -> String {
    let value = cell["value"].as_str().unwrap();
    match cell["kind"].as_str().unwrap() {
        "text" if cell["key"] == "equip-clock" => "2026-05-31T08:00:00".to_owned(),
        "text" => "PROBE_7".to_owned(),
        "choice" => {
            let all: Vec<String> = cell["choices"].as_array().unwrap().iter().map(Value::to_string).collect();
            all.iter().find(|one| *one != value).unwrap().clone()
        }
        "integer" => if value == "5" { "6" } else { "5" }.to_owned(),
        _ => match cell["key"].as_str().unwrap() {
            "equip-bore" => "20".to_owned(),
            "equip-bore-depth" | "equip-scatter" => "0.5".to_owned(),
            _ => "12.5".to_owned(),
        },
    }
}

/// Every field of every row takes another value and shows it.
fn every_field_takes(control: &str, view: &Value) {
    for table in ["machine", "tools", "offsets", "probe", "toolprobes", "part"] {
        for row in rows(view, table) {
            let id = row["id"].as_str().unwrap();
            for cell in cells(view, table, id) {
                let (key, text) = (cell["key"].as_str().unwrap(), other(cell));
                let set = json!({ "set": { "table": table, "row": id, "cell": key, "text": text } });
                let after = ask(control, Some(&view["setup"]), &set);
                if key == "equip-bore" {
                    assert!(after["problem"].is_object(), "a bore needs its depth");
                    continue;
                }
                assert_eq!(after["problem"], Value::Null, "{set}");
                let now = cells(&after, table, after["row"].as_str().unwrap());
                let shown = now.iter().find(|one| one["key"] == key).unwrap();
                assert_eq!(shown["value"], text, "{set}");
            }
        }
    }
}

// oracle: self
#[test]
fn every_field_of_every_table_comes_back_from_the_setup_file() {
    for control in ["sinumerik", "nct"] {
        let mut view = ask(control, None, &Value::Null);
        let adds = view["tables"].as_array().unwrap().clone();
        for table in &adds {
            for sort in table["adds"].as_array().unwrap() {
                let add = json!({ "add": { "table": table["table"], "row": sort } });
                let before = rows(&view, table["table"].as_str().unwrap()).len();
                view = ask(control, Some(&view["setup"]), &add);
                let now = rows(&view, table["table"].as_str().unwrap());
                assert!(now.iter().any(|row| row["id"] == view["row"]), "{add}");
                assert_eq!(now.len(), before + 1, "{add}");
            }
        }
        assert_eq!(rows(&view, "part").len(), 12);
        every_field_takes(control, &view);
    }
}

// oracle: hand
#[test]
fn rows_are_copied_moved_used_and_taken_away() {
    let part = |row: &str| json!({ "table": "part", "row": row });
    let hole = ask("sinumerik", None, &json!({ "add": part("setup-shape-hole") }));
    let both = ask("sinumerik", Some(&hole["setup"]), &json!({ "add": part("setup-shape-sphere") }));
    let shapes = |view: &Value| -> Vec<String> {
        let solids = view["setup"]["workpiece"].as_array().unwrap().iter();
        solids.map(|one| one["shape"].as_str().unwrap().to_owned()).collect()
    };
    let moved = ask("sinumerik", Some(&both["setup"]), &json!({ "earlier": part("1") }));
    assert_eq!((shapes(&moved), &moved["row"]), (vec!["sphere".to_owned(), "hole".to_owned()], &json!("0")));
    let copied = ask("sinumerik", Some(&moved["setup"]), &json!({ "copy": part("1") }));
    assert_eq!(shapes(&copied), ["sphere", "hole", "hole"]);
    let less = ask("sinumerik", Some(&copied["setup"]), &json!({ "remove": part("0") }));
    assert_eq!(shapes(&less), ["hole", "hole"]);

    let tool = ask("sinumerik", None, &json!({ "add": { "table": "tools", "row": "" } }));
    let row = tool["row"].as_str().unwrap();
    let used = ask("sinumerik", Some(&tool["setup"]), &json!({ "use": { "table": "tools", "row": row } }));
    assert_eq!(used["setup"]["active"]["tool"], 1);
    let offset = json!({ "use": { "table": "offsets", "row": "G55" } });
    assert_eq!(ask("sinumerik", None, &offset)["setup"]["active"]["frame"], "G55");
    let gone = ask("sinumerik", Some(&used["setup"]), &json!({ "remove": { "table": "tools", "row": row } }));
    assert_eq!((&gone["problem"], &gone["setup"]["active"]["tool"]), (&Value::Null, &json!(0)));
}

// oracle: hand
#[test]
fn what_cannot_be_is_refused_at_its_field_and_changes_nothing() {
    let own = ask("sinumerik", None, &Value::Null);
    for (table, row, cell, text) in [
        ("tools", "9/1", "equip-t", "0"),
        ("tools", "9/1", "equip-d", "1.5"),
        ("tools", "9/1", "equip-l1", "long"),
        ("tools", "9/1", "equip-l1", "1e12"),
        ("tools", "9/1", "equip-type", "4711"),
        ("tools", "9/1", "equip-tool-name", "A\"B"),
        ("tools", "8/1", "equip-l1", "1"),
        ("probe", "1", "equip-ball", "0"),
        ("probe", "1", "equip-ball", "-6"),
        ("offsets", "G54", "equip-x", "x"),
    ] {
        let set = json!({ "set": { "table": table, "row": row, "cell": cell, "text": text } });
        let view = ask("sinumerik", None, &set);
        assert!(view["problem"]["message"]["key"].is_string(), "{set}");
        assert_eq!(view["setup"], own["setup"], "{set}");
    }
    let two = ask("sinumerik", None, &json!({ "add": { "table": "tools", "row": "" } }));
    let taken = json!({ "set": { "table": "tools", "row": "1/1", "cell": "equip-t", "text": "9" } });
    assert_eq!(ask("sinumerik", Some(&two["setup"]), &taken)["problem"]["message"]["key"], "equip-taken");
}

// oracle: hand (1 inch = 25.4 mm)
#[test]
fn an_inch_machine_has_its_lengths_in_inch() {
    let own = json!({ "own": { "basic": "inch", "plane": "G17", "units": "G70" } });
    let view = ask("sinumerik", Some(&own), &json!({ "add": { "table": "tools", "row": "" } }));
    let set = json!({ "set": { "table": "tools", "row": view["row"], "cell": "equip-l1", "text": "2" } });
    let view = ask("sinumerik", Some(&view["setup"]), &set);
    assert_eq!(view["setup"]["tools"]["1"]["edges"]["1"]["length"][0], 50.8);
    let cell = cells(&view, "tools", "1/1").into_iter().find(|one| one["key"] == "equip-l1").unwrap();
    assert_eq!((&cell["value"], &cell["unit"]), (&json!("2"), &json!("inch")));
}

// oracle: self
#[test]
fn the_part_of_the_open_call_becomes_part_of_the_machine() {
    let call = json!({ "control": "sinumerik", "cycle": "CYCLE977", "values": { "_MVAR": "1", "_SETVAL": "50",
        "_KNUM": "0", "_FA": "2", "_TSA": "1", "_PRNUM": "1", "_NMSP": "1", "_VMS": "0" } });
    let asked = json!({ "control": "sinumerik", "change": "measured", "call": call });
    let view = equip(&asked.to_string()).unwrap();
    assert_eq!(view["setup"]["workpiece"][0]["shape"], "hole");
    assert_eq!(view["setup"]["workpiece"][0]["size"][0], 50.0);
}
