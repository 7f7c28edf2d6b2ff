//! The machine as a form: its data with what they mean, and what was typed written into them.

use super::setup_active::{UnitsName, units, units_of};
use super::start::{Start, start};
use super::{Error, dialect, message, object, put};
use crate::control::{Control, Units, Value as Datum, delivery_in, rebuilt};
use crate::entry::Typed;
use crate::form::machine::{Entry, Group, Refusal, Setting, accept, groups};
use crate::message::Message;
use crate::program::write::machine::{assignments, definitions};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
struct Request {
    control: String,
    #[serde(default)]
    setup: Option<Value>,
    /// Basic system that the machine is to be built for from now on.
    #[serde(default)]
    basic: Option<UnitsName>,
    /// Typed values by name; an empty one goes back to what is delivered.
    #[serde(default)]
    values: Typed,
}

/// Answers a `MachineRequest` with a `MachineView`.
pub fn machine(request: &str) -> Result<Value, Error> {
    let request: Request = super::request(request)?;
    let dialect = dialect(&request.control)?;
    let Start { setup, .. } = start(dialect, request.setup)?;
    let asked = request.basic.map(units).or_else(|| chosen(&request.values));
    let mut control = match asked {
        Some(basic) if basic != setup.control.basic_units => rebuilt(&setup.control, basic),
        _ => setup.control,
    };
    let delivered = delivery_in(dialect, control.basic_units);
    let problems = write(&mut control, &delivered, &request.values);
    let groups = groups(&control);
    Ok(object([
        ("groups", groups.iter().map(|one| group(one, &control, &delivered)).collect()),
        ("basic", units_of(control.basic_units).into()),
        ("data", data(&control, &delivered)),
        ("problems", problems.into()),
        ("assignments", assignments(&control, &delivered).into()),
        ("definitions", definitions(&control, &delivered).into()),
    ]))
}

/// The basic system that a typed MD10240 stands for (B:13594): 1 metric, 0 inch.
fn chosen(typed: &Typed) -> Option<Units> {
    match typed.get("MD10240")?.trim() {
        "1" => Some(Units::Metric),
        "0" => Some(Units::Inch),
        _ => None,
    }
}

/// Writes what was typed; gives what cannot be taken.
fn write(control: &mut Control, delivered: &Control, typed: &Typed) -> Vec<Value> {
    let settings: Vec<Setting> = groups(control).into_iter().flat_map(|group| group.settings).collect();
    let mut problems = Vec::new();
    for (name, text) in typed {
        let Some(setting) = settings.iter().find(|one| one.name == *name) else {
            continue; // its array became smaller
        };
        if text.trim().is_empty() {
            reset(control, delivered, name);
            continue;
        }
        match accept(setting, text) {
            Ok(value) => {
                control.data.insert(name.clone(), value);
            }
            Err(refusal) => problems.push(problem(name, refusal)),
        }
    }
    problems
}

fn reset(control: &mut Control, delivered: &Control, name: &str) {
    match delivered.data.get(name) {
        Some(value) => control.data.insert(name.to_owned(), value.clone()),
        None => control.data.remove(name),
    };
}

/// A finding at a datum.
fn problem(name: &str, refusal: Refusal) -> Value {
    object([("name", name.into()), ("message", message(&refusal.message)), ("hint", message(&refusal.hint))])
}

/// What differs from delivery, as the setup file has it.
fn data(control: &Control, delivered: &Control) -> Value {
    let differs = control.data.iter().filter(|(name, value)| {
        let zero = **value == Datum::Number(0.0);
        match delivered.data.get(name) {
            Some(other) => other != *value,
            None => !zero || without_delivery(name),
        }
    });
    object(differs.map(|(name, value)| (name.as_str(), super::setup_write::datum(value))))
}

/// Whether a datum that the core does not deliver stands for "not known" until it is typed: machine and setting data.
fn without_delivery(name: &str) -> bool {
    name.starts_with("MD") || name.starts_with("SD")
}

fn group(group: &Group, control: &Control, delivered: &Control) -> Value {
    let fields = group.settings.iter();
    object([
        ("label", message(&Message::new(group.key.clone()))),
        ("fields", fields.map(|one| field(one, control, delivered)).collect()),
    ])
}

fn field(setting: &Setting, control: &Control, delivered: &Control) -> Value {
    let fallback = shown(delivered, setting);
    let value = shown(control, setting);
    let mut view = object([
        ("name", setting.name.as_str().into()),
        ("key", setting.key.as_str().into()),
        ("value", if value == fallback { "" } else { &value }.into()),
        ("fallback", fallback.as_str().into()),
        ("unit", setting.unit.into()),
        ("range", super::form::range(setting.range)),
        ("source", setting.source.into()),
    ]);
    if let Some((array, number)) = setting.field {
        let key = array.trim_matches('_').to_lowercase().replace('_', "-");
        let title = Message::new(format!("machine-field-{key}")).number("number", number as f64);
        put(&mut view, "set", message(&title));
    }
    let kind = match setting.entry {
        Entry::Real => "real",
        Entry::Integer => "integer",
        Entry::Text => "text",
        Entry::Choice(choices) => {
            put(&mut view, "choices", choices.to_vec());
            "choice"
        }
    };
    put(&mut view, "kind", kind);
    view
}

/// A datum as it would be typed; empty where nothing is known of it.
fn shown(control: &Control, setting: &Setting) -> String {
    match control.data.get(&setting.name) {
        Some(Datum::Number(value)) => value.to_string(),
        Some(Datum::Text(text)) => text.clone(),
        None if setting.entry == Entry::Text || without_delivery(&setting.name) => String::new(),
        None => "0".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::words::Words;
    use serde_json::json;

    fn ask(setup: &Value, values: &Value) -> Value {
        let request = json!({ "control": "sinumerik", "setup": setup, "values": values });
        machine(&request.to_string()).unwrap()
    }

    fn field<'a>(view: &'a Value, name: &str) -> Option<&'a Value> {
        let groups = view["groups"].as_array().unwrap().iter();
        let mut fields = groups.flat_map(|group| group["fields"].as_array().unwrap());
        fields.find(|field| field["name"] == name)
    }

    fn own(data: &Value) -> Value {
        json!({ "own": { "data": data } })
    }

    // oracle: hand
    #[test]
    fn what_is_typed_stands_in_the_data_and_reads_back() {
        let typed = json!({ "_WP[0,0]": "5,99", "_CBIT[2]": "1", "MD28082": "20H", "_PROTNAME[1]": "LOG" });
        let view = ask(&own(&json!({})), &typed);
        let data = json!({ "_WP[0,0]": 5.99, "_CBIT[2]": 1.0, "MD28082": 32.0, "_PROTNAME[1]": "LOG" });
        assert_eq!(view["data"], data);
        assert_eq!(view["problems"], json!([]));
        let again = ask(&own(&data), &json!({}));
        assert_eq!(again["data"], data);
        assert_eq!(field(&again, "_WP[0,0]").unwrap()["value"], "5.99");
        assert_eq!(field(&again, "_WP[0,0]").unwrap()["fallback"], "6");
        let back = ask(&own(&data), &json!({ "_WP[0,0]": "", "_CBIT[2]": "0", "MD28082": "", "_PROTNAME[1]": " " }));
        assert_eq!(back["data"], json!({}));
    }

    // oracle: manual B:828, B:10100 (2 in most cases, 0 for a drill): neither is delivered, so that 0 is said too
    #[test]
    fn a_zero_that_is_typed_is_not_the_same_as_nothing() {
        let view = ask(&own(&json!({})), &json!({ "SD42950": "0" }));
        assert_eq!(view["data"], json!({ "SD42950": 0.0 }));
        assert_eq!(field(&view, "SD42950").unwrap()["value"], "0");
        assert_eq!(field(&view, "SD42950").unwrap()["fallback"], "");
        let view = ask(&own(&view["data"]), &json!({ "SD42950": "" }));
        assert_eq!(view["data"], json!({}));
    }

    // oracle: manual C:60, C:74, C:1193-1202
    #[test]
    fn the_variables_of_nct_are_its_machine() {
        let ask = |data: &Value, values: &Value| {
            let setup = json!({ "own": { "data": data } });
            let request = json!({ "control": "nct", "setup": setup, "values": values });
            machine(&request.to_string()).unwrap()
        };
        let typed = json!({ "#510": "19", "#509": "39.8", "P9143": "0", "#1003": "0" });
        let view = ask(&json!({}), &typed);
        let data = view["data"].clone();
        for (name, value) in [("#509", 39.8), ("#510", 19.0), ("P9143", 0.0), ("#1003", 0.0)] {
            assert_eq!(data[name], value, "{name}");
        }
        assert_eq!(view["problems"], json!([]));
        let written = view["assignments"].as_str().unwrap();
        assert!(written.contains("#509=39.8\n") && written.contains("#510=19\n"));
        assert!(!written.contains("P9143") && !written.contains("#1003"));
        let again = ask(&data, &json!({}));
        assert_eq!(again["data"], data);
        let disk = field(&again, "#509").unwrap();
        assert_eq!((&disk["fallback"], &disk["unit"]), (&json!("40"), &json!("mm")));
        let wrong = ask(&json!({}), &json!({ "#509": "-1", "#510": "1.5", "P9143": "3" }));
        assert_eq!(wrong["problems"].as_array().unwrap().len(), 3);
        let words = Words::english();
        for group in again["groups"].as_array().unwrap() {
            for field in group["fields"].as_array().unwrap() {
                let key = field["key"].as_str().unwrap();
                for key in [key.to_owned(), format!("{key}.help")] {
                    assert!(words.find(&Message::new(key.clone())).is_some(), "{key}");
                }
            }
        }
    }

    // oracle: hand
    #[test]
    fn a_described_machine_keeps_its_other_data() {
        let mut setup: Value = serde_json::from_str(include_str!("../../../docs/setup.example.json")).unwrap();
        setup["data"] = json!({ "R10": 4, "_CHBIT[4]": 1 });
        let view = ask(&setup, &json!({ "_DIGIT": "4" }));
        assert_eq!(view["data"], json!({ "R10": 4.0, "_CHBIT[4]": 1.0, "_DIGIT": 4.0 }));
    }

    // oracle: manual B:13345-13348, B:13717
    #[test]
    fn counts_decide_how_many_fields_there_are() {
        let view = ask(&own(&json!({ "_CVAL[1]": 1, "_EVMVNUM[0]": 30, "_CVAL[2]": 0 })), &json!({}));
        for (name, there) in [
            ("_WP[0,10]", true),
            ("_WP[1,0]", false),
            ("_EV[29]", true),
            ("_EV[30]", false),
            ("_MV[19]", true),
            ("_KB[0,0]", false),
        ] {
            assert_eq!(field(&view, name).is_some(), there, "{name}");
        }
        let own = own(&json!({ "_CVAL[1]": 1 }));
        let view = ask(&own, &json!({ "_WP[2,0]": "5", "_CVAL[1]": "3" }));
        assert!(field(&view, "_WP[2,0]").is_some());
    }

    // oracle: manual B:13726-13734, B:13534 (ranges)
    #[test]
    fn what_cannot_be_is_told_with_its_cure_and_not_taken() {
        let typed =
            json!({ "_SPEED[0]": "120", "_SPEED[1]": "0", "_CBIT[0]": "2", "_DIGIT": "2.5", "_WP[0,1]": "wide" });
        let view = ask(&own(&json!({})), &typed);
        assert_eq!(view["data"], json!({}));
        let problems = view["problems"].as_array().unwrap();
        assert_eq!(problems.len(), 5);
        let words = Words::english();
        for problem in problems {
            for part in ["message", "hint"] {
                let key = problem[part]["key"].as_str().unwrap().to_owned();
                assert!(words.find(&Message::new(key)).is_some(), "{problem}");
            }
        }
    }

    // oracle: manual B:13498 (feet/min), B:13596
    #[test]
    fn an_inch_machine_shows_inch() {
        let view = ask(&json!({ "own": { "basic": "inch" } }), &json!({}));
        assert_eq!(field(&view, "_WP[0,0]").unwrap()["unit"], "inch");
        assert_eq!(field(&view, "_CM[0]").unwrap()["unit"], "ft/min");
        assert_eq!(view["data"], json!({}));
    }

    // oracle: manual B:13594-13596 (MD10240 decides, the data are converted)
    #[test]
    fn the_basic_system_is_chosen_and_the_data_keep_their_sizes() {
        let metric = own(&json!({ "_WP[0,0]": 5.08 }));
        let ask_for = |request: Value| machine(&request.to_string()).unwrap();
        let chosen = ask_for(json!({ "control": "sinumerik", "setup": metric, "basic": "inch" }));
        let typed = ask(&metric, &json!({ "MD10240": "0" }));
        for view in [&chosen, &typed] {
            assert_eq!((&view["basic"], &view["data"]), (&json!("inch"), &json!({ "_WP[0,0]": 0.2 })));
            assert_eq!(field(view, "_WP[0,0]").unwrap()["unit"], "inch");
        }
        let inch = json!({ "own": { "basic": "inch", "data": chosen["data"] } });
        let back = ask_for(json!({ "control": "sinumerik", "setup": inch, "basic": "mm" }));
        assert_eq!((&back["basic"], &back["data"]), (&json!("mm"), &json!({ "_WP[0,0]": 5.08 })));
    }

    // oracle: self
    #[test]
    fn every_part_of_the_form_has_words() {
        let view = ask(&own(&json!({})), &json!({}));
        let words = Words::english();
        for group in view["groups"].as_array().unwrap() {
            for field in group["fields"].as_array().unwrap() {
                let set = field["set"]["key"].as_str().map(str::to_owned);
                for key in set.into_iter().chain([field["key"].as_str().unwrap().to_owned()]) {
                    assert!(words.find(&Message::new(key.clone())).is_some(), "{key}");
                }
            }
        }
    }
}
