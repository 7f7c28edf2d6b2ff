//! The machine as a form: its data with what they mean, and what was typed written into them.

use super::Error;
use super::finding::Finding;
use super::start::{Machine, start};
use crate::control::{Control, Units, Value, more_fields, rebuilt};
use crate::diagnostic::{Diagnostic, Severity};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::form::machine::{Entry, Group, Refusal, Setting, accept, doubt, doubts, groups};
use crate::message::Message;
use crate::own;
use crate::program::write::machine::assignments;
use crate::program::write::setting_data;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Which machine, and what is typed into its form.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MachineRequest {
    /// Control.
    pub control: Dialect,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Basic system that it is to be built for from now on; the data keep their sizes.
    pub basic: Option<Units>,
    /// Typed values by name; an empty one goes back to what is delivered.
    #[serde(default)]
    pub values: Typed,
}

/// What is set once per machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineView {
    /// Machine data by subject.
    pub groups: Vec<MachineGroup>,
    /// Basic system of the machine now.
    pub basic: Units,
    /// What differs from delivery now, for the setup.
    pub data: BTreeMap<String, Value>,
    /// Values that were not taken.
    pub problems: Vec<MachineProblem>,
    /// What differs, as blocks of a part program.
    pub assignments: String,
}

/// A typed value that is not taken.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineProblem {
    /// Name of the datum.
    pub name: String,
    /// What is wrong, and the cure.
    #[serde(flatten)]
    pub refusal: Refusal,
}

/// Data of one subject.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineGroup {
    /// The subject.
    pub label: Message,
    /// Data of the group.
    pub fields: Vec<MachineField>,
}

/// A datum of the machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MachineField {
    /// What is set.
    #[serde(flatten)]
    pub setting: Setting,
    /// Which field of data it belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<Message>,
    /// As typed; empty: as delivered.
    pub value: String,
    /// As delivered; empty: not known.
    pub fallback: String,
    /// What is to be said of its value as it counts; absent: nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub warned: Option<Finding>,
}

/// The machine with what was typed.
///
/// # Errors
/// The machine has no such G function of units.
pub fn machine(asked: MachineRequest) -> Result<MachineView, Error> {
    view(asked.control, asked.setup, asked.basic, &[asked.values])
}

/// A SINUMERIK machine with values, one group after the other.
pub(super) fn with_values(
    setup: Option<Machine>,
    basic: Option<Units>,
    groups: &[Typed],
) -> Result<MachineView, Error> {
    view(Dialect::Sinumerik, setup, basic, groups)
}

/// The machine with these groups of values; the problems are those of the last one.
fn view(dialect: Dialect, setup: Option<Machine>, basic: Option<Units>, typed: &[Typed]) -> Result<MachineView, Error> {
    let setup = start(dialect, setup)?.setup;
    let basic = basic.or_else(|| typed.iter().find_map(chosen));
    let mut control = match basic {
        Some(basic) if basic != setup.control.basic_units => rebuilt(&setup.control, basic),
        _ => setup.control,
    };
    let mut delivered = control.delivered_alike(control.basic_units);
    let mut problems = None;
    for typed in typed {
        problems = Some(write(&mut control, &delivered, typed));
        control.take_setting_data(); // they count what others there are
        control.fill_fields();
        for (name, value) in more_fields(&control, control.basic_units) {
            delivered.data.insert(name, value);
        }
    }
    Ok(MachineView {
        groups: groups(&control).into_iter().map(|one| group(one, &control, &delivered)).collect(),
        basic: control.basic_units,
        data: data(&control, &delivered),
        problems: problems.unwrap_or_default(),
        assignments: match control.has_setting_data() {
            true => setting_data::assignments(&control, &delivered),
            false => assignments(&control, &delivered),
        },
    })
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
fn write(control: &mut Control, delivered: &Control, typed: &Typed) -> Vec<MachineProblem> {
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
            Ok(value) => drop(control.data.insert(name.clone(), value)),
            Err(refusal) => problems.push(MachineProblem { name: name.clone(), refusal }),
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

/// What differs from delivery, as the setup file has it.
fn data(control: &Control, delivered: &Control) -> BTreeMap<String, Value> {
    // a setting datum that the machine no longer has: fewer probes, another generation
    let gone = |name: &str| control.has_setting_data() && control.instead_of(name).is_some();
    let differs = control.data.iter().filter(|(name, value)| {
        if gone(name) {
            return false;
        }
        let zero = **value == Value::Number(0.0);
        match delivered.data.get(name) {
            Some(other) => other != *value,
            None => !zero || without_delivery(name),
        }
    });
    differs.map(|(name, value)| (name.clone(), value.clone())).collect()
}

/// Whether a datum that the core does not deliver stands for "not known" until it is typed: machine and setting data.
fn without_delivery(name: &str) -> bool {
    name.starts_with("MD") || name.starts_with("SD")
}

fn group(group: Group, control: &Control, delivered: &Control) -> MachineGroup {
    let fields = group.settings.into_iter();
    MachineGroup { label: Message::new(group.key), fields: fields.map(|one| field(one, control, delivered)).collect() }
}

fn field(setting: Setting, control: &Control, delivered: &Control) -> MachineField {
    let (fallback, value) = (shown(delivered, &setting), shown(control, &setting));
    let set = setting.field.map(|(array, number)| {
        let key = array.trim_matches('_').to_lowercase().replace('_', "-");
        Message::new(format!("machine-field-{key}")).number("number", number as f64)
    });
    let outside = || doubt(control, &setting).map(|(_, refusal)| outside(refusal));
    let warned = super::braking::of_datum(control, &setting.name).or_else(outside).map(|found| Finding::of(&found));
    MachineField { setting, set, value: if value == fallback { String::new() } else { value }, fallback, warned }
}

/// A value outside of what is allowed, which a setup file or a program gave.
fn outside(refusal: Refusal) -> Diagnostic {
    Diagnostic::new(Severity::Warning, own::RANGE.code(), refusal.message).hint(refusal.hint)
}

/// The data of a machine that are none of the values that they can have.
pub fn machine_doubts(control: &Control) -> Vec<MachineProblem> {
    doubts(control).into_iter().map(|(name, refusal)| MachineProblem { name, refusal }).collect()
}

/// A datum as it would be typed; empty where nothing is known of it.
fn shown(control: &Control, setting: &Setting) -> String {
    let older = || control.setting_value(&setting.name);
    match control.data.get(&setting.name).or_else(older) {
        Some(Value::Number(value)) => value.to_string(),
        Some(Value::Text(text)) => text.clone(),
        None if setting.entry == Entry::Text || without_delivery(&setting.name) => String::new(),
        None => "0".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::json::asked::machine;
    use crate::message::Message;
    use crate::words::Words;
    use serde_json::{Value, json};

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

    // oracle: manual B:13064-13069 (MD11420 1 to 1000000), B:13594 (MD10240 0 or 1), self (the form refuses the same)
    #[test]
    fn a_value_that_a_setup_has_outside_of_its_limits_is_told() {
        let data =
            json!({ "MD11420": 0, "_MT_COMP": 9, "_SPEED[0]": 120, "_SPEED[1]": 0, "_CHBIT[2]": 0, "MD10132": 1.5 });
        let warned = |data: &Value| {
            let view = ask(&own(data), &json!({}));
            let groups = view["groups"].as_array().unwrap().clone();
            let fields = groups.iter().flat_map(|group| group["fields"].as_array().unwrap().clone());
            fields.filter(|one| one["warned"].is_object()).map(|one| one["name"].as_str().unwrap().to_owned()).collect()
        };
        let told: Vec<String> = warned(&data);
        assert_eq!(told.len(), 3, "{told:?}");
        assert!(["MD11420", "_MT_COMP", "_SPEED[0]"].iter().all(|name| told.iter().any(|one| one == name)), "{told:?}");
        for (name, wrong) in
            [("MD11420", -1.0), ("MD11420", 1.5), ("MD10240", 5.0), ("_CBIT[0]", 2.0), ("MD13200[0]", 2.0)]
        {
            assert_eq!(warned(&json!({ name: wrong })), [name]);
            let typed = ask(&own(&json!({})), &json!({ name: wrong.to_string() }));
            assert_eq!(typed["problems"][0]["name"], name);
        }
    }

    // oracle: self (what is delivered is within the limits of its tables)
    #[test]
    fn a_machine_as_delivered_has_nothing_outside_of_its_limits() {
        use crate::control::{Units, delivery_in};
        use crate::dialect::Dialect;
        for (dialect, units) in
            [(Dialect::Sinumerik, Units::Metric), (Dialect::Sinumerik, Units::Inch), (Dialect::Nct, Units::Metric)]
        {
            assert_eq!(super::machine_doubts(&delivery_in(dialect, units)), [], "{dialect:?} {units:?}");
        }
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

    // oracle: peer (newer controls have these in setting data); hand: one value stands in one field
    #[test]
    fn a_newer_machine_has_each_value_once() {
        for (generation, plane) in [(2, "SD55631"), (3, "SD55634")] {
            let data = json!({ "PW-GENERATION": generation, "_WP[0,0]": 5.9, "SD54600[11]": 4.0, "SD55613": 1 });
            let view = ask(&own(&data), &json!({}));
            for name in ["_WP[0,0]", "_SPEED[0]", "_CVAL[1]", "_TP[0,6]", "_CM[0]"] {
                assert!(field(&view, name).is_none(), "{name}");
            }
            assert_eq!(field(&view, "SD54600[0]").unwrap()["value"], "5.9");
            assert_eq!(field(&view, "SD54600[0]").unwrap()["also"], "$SNS_MEA_WP_BALL_DIAM _WP[k,0]");
            assert_eq!(field(&view, "SD54600[11]").unwrap()["value"], "4");
            assert!(field(&view, "SD54600[12]").is_none() && field(&view, "SD54625[6]").is_none());
            assert!(field(&view, plane).is_some() && field(&view, "SD54625[5]").is_some());
            // fewer probes: what is left can be read again
            let view = ask(&own(&view["data"]), &json!({ "MD51600": "2", plane: "700" }));
            assert_eq!(view["problems"], json!([]));
            assert_eq!((&view["data"]["SD54600[11]"], &view["data"]["_SPEED[1]"]), (&Value::Null, &json!(700.0)));
            let again = ask(&own(&view["data"]), &json!({}));
            assert_eq!(again["data"], view["data"]);
        }
        let refused = |name: &str, generation: i64| {
            let setup = own(&json!({ "PW-GENERATION": generation, name: 6 }));
            let request = json!({ "control": "sinumerik", "setup": setup, "values": {} });
            machine(&request.to_string()).is_err()
        };
        assert!(refused("SD54600[12]", 3) && refused("SD54600", 3) && refused("SD55634[0]", 3));
        assert!(refused("SD55634", 2) && !refused("SD55634", 3) && !refused("SD42950", 3));
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
