//! The scenarios of `tests/cases`, as `probewright test` runs them: worked measurements and figures of the manuals as
//! programs, and closed loops, which calibrate, correct and measure again.
//! The truth of each case stands in its `oracle`. Written in the manner in which manuals print programs they have to
//! give the same.

#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod manner;
mod planes;

use probewright_core::app::{Scenario, ScenarioRequest, noted, scenario};
use probewright_core::dialect::Dialect;
use probewright_core::json::question;
use probewright_core::setup_file::SetupFile;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The scenarios with the text of their programs, by name, sorted.
fn scenarios() -> Vec<(String, Scenario)> {
    let all = std::fs::read_dir(root().join("tests/cases")).expect("folder tests/cases");
    let mut scenarios: Vec<_> = all.map(|folder| read(&folder.unwrap().path())).collect();
    scenarios.sort_by(|(one, _), (other, _)| one.cmp(other));
    scenarios
}

fn read(folder: &Path) -> (String, Scenario) {
    let name = folder.file_name().unwrap().to_string_lossy().into_owned();
    let text = std::fs::read_to_string(folder.join("scenario.json")).unwrap();
    let mut scenario: Scenario = question(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    scenario.program.text = Some(std::fs::read_to_string(folder.join(&scenario.program.name)).unwrap());
    for case in &scenario.cases {
        assert!(!case.oracle.is_empty(), "{name} {}: no oracle", case.id);
    }
    (name, scenario)
}

/// Every case of a scenario comes to what it must; how many there are.
fn holds(name: &str, scenario_now: Scenario) -> usize {
    let view = scenario(ScenarioRequest { scenario: scenario_now, beside: None });
    let cases = view.unwrap_or_else(|error| panic!("{name}: {error}")).cases;
    for case in &cases {
        assert_eq!(case.differences, [], "{name} {}", case.id);
    }
    cases.len()
}

#[test]
fn own_programs() {
    let count: usize = scenarios().into_iter().map(|(name, scenario)| holds(&name, scenario)).sum();
    assert!(count >= 276, "only {count} cases found");
}

// oracle: the cases themselves; manuals print their programs in this manner
#[test]
fn programs_as_manuals_print_them() {
    for (name, mut scenario) in scenarios() {
        let control = scenario.setup.control();
        let printed = |text: &String| manner::printed(control, &name, text);
        for case in &mut scenario.cases {
            // what is replaced stands in the text as it was written
            let replaced = |text: String, (old, new): &(String, String)| text.replace(old, new);
            case.replace = match case.replace.is_empty() {
                true => Vec::new(),
                false => {
                    let text = scenario.program.text.clone().unwrap();
                    vec![(printed(&text), printed(&case.replace.iter().fold(text, replaced)))]
                }
            };
        }
        scenario.program.text = scenario.program.text.as_ref().map(printed);
        holds(&name, scenario);
    }
}

// oracle: self (each figure of every expectation is compared: with any of them changed the case no longer holds)
#[test]
fn whatever_is_expected_otherwise_is_told() {
    for (name, scenario_now) in scenarios() {
        let case = &scenario_now.cases[0];
        let document = serde_json::to_value(&case.expect).unwrap();
        for (member, _) in document.as_object().unwrap() {
            let mut other = document.clone();
            if !spoil(&mut other[member]) {
                continue;
            }
            let mut spoilt = scenario_now.clone();
            spoilt.cases.truncate(1);
            spoilt.cases[0].expect = question(&other.to_string()).unwrap();
            let view = scenario(ScenarioRequest { scenario: spoilt, beside: None }).unwrap();
            assert_ne!(view.cases[0].differences, [], "{name} {}: {member}", case.id);
        }
    }
}

// oracle: self (what is noted of a run is what comes of it again)
#[test]
fn what_is_noted_of_a_run_holds() {
    for (name, scenario) in scenarios() {
        let case = &scenario.cases[0];
        let program = scenario.program.text.clone().unwrap();
        let text = case.replace.iter().fold(program, |text, (old, new)| text.replace(old, new));
        let setup = SetupFile::from(&scenario.machine(case).unwrap());
        let run = serde_json::json!({ "control": scenario.setup.control(), "text": text, "setup": setup });
        let request = serde_json::json!({ "run": run, "name": name, "case": case.id });
        let written = serde_json::to_string(&noted(question(&request.to_string()).unwrap()).unwrap()).unwrap();
        holds(&name, question(&written).unwrap());
    }
}

// oracle: manual B:660-668 (a dry run skips the measuring cycles): what is noted in a mode is carried out in it
#[test]
fn a_mode_is_noted_and_carried_out() {
    let corrects = |(_, one): &(String, Scenario)| {
        let changes = one.cases[0].expect.changes.as_ref().is_some_and(|changes| !changes.is_empty());
        changes && one.setup.control() == Dialect::Sinumerik && one.cases[0].expect.stop.is_none()
    };
    let (name, scenario) = scenarios().into_iter().find(corrects).unwrap();
    let case = &scenario.cases[0];
    let program = scenario.program.text.clone().unwrap();
    let text = case.replace.iter().fold(program, |text, (old, new)| text.replace(old, new));
    let setup = SetupFile::from(&scenario.machine(case).unwrap());
    let run = serde_json::json!({ "control": "sinumerik", "text": text, "setup": setup, "mode": "dry-run" });
    let request = serde_json::json!({ "run": run, "name": name, "case": case.id });
    let written = serde_json::to_string(&noted(question(&request.to_string()).unwrap()).unwrap()).unwrap();
    assert!(written.contains(r#""mode":"dry-run""#), "{written}");
    holds(&name, question(&written).unwrap());
    let automatic = written.replace(r#""mode":"dry-run","#, "");
    let view =
        probewright_core::app::scenario(ScenarioRequest { scenario: question(&automatic).unwrap(), beside: None });
    assert_ne!(view.unwrap().cases[0].differences, [], "{name}: in AUTOMATIC it measures");
}

/// Changes the last figure below a value; false: there is none.
fn spoil(value: &mut serde_json::Value) -> bool {
    if let Some(number) = value.as_f64() {
        *value = (number + 0.5).into();
        return true;
    }
    match value {
        serde_json::Value::Array(all) => all.last_mut().is_some_and(spoil),
        serde_json::Value::Object(all) => all.values_mut().next_back().is_some_and(spoil),
        _ => false,
    }
}
