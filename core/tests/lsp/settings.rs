//! The setting `probewright`: setup file, files beside the program, control.

use crate::client::{Client, able};
use serde_json::{Value, json};
use std::path::PathBuf;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("probewright-lsp-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn codes(found: &[Value]) -> Vec<&str> {
    found.iter().map(|one| one["code"].as_str().unwrap()).collect()
}

// oracle: hand (a name that only the definition file knows)
#[test]
fn files_beside_the_program_count() {
    let folder = folder("beside");
    std::fs::write(folder.join("GUD4.DEF"), "DEF NCK REAL SIZE\nM17\n").unwrap();
    std::fs::write(folder.join("L10.SPF"), "_MVAR=1,5\nM17\n").unwrap();
    let uri = format!("file://{}/a.mpf", folder.display());
    let sub = format!("file://{}/L10.SPF", folder.display());
    let text = "R1=SIZE\nL10\nM30\n";
    let mut client = Client::session(able(), "en", json!({ "with": [folder] }));
    client.open(&uri, text);
    let places = client.at("textDocument/definition", &uri, text, "L10", 1);
    assert_eq!(places[0]["uri"], sub);
    assert_eq!(places[0]["range"]["start"], json!({ "line": 0, "character": 0 }));
    let of_sub = |client: &mut Client| loop {
        let message = client.receive();
        if message["params"]["uri"] == sub {
            return message["params"]["diagnostics"].as_array().unwrap().len();
        }
    };
    // what is wrong there is told there; its text in the editor counts, not that of the file
    let told = client.told.iter().any(|one| one["params"]["uri"] == sub);
    assert!(told || of_sub(&mut client) > 0);
    client.open(&sub, "M17\n");
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": sub, "version": 2 },
        "contentChanges": [{ "text": "M17\n" }] }),
    );
    assert!(client.findings(&sub, 2).is_empty());
}

// oracle: peer (`probewright check --setup`)
#[test]
fn the_machine_of_a_setup_file_counts() {
    let setup = format!("{}/../docs/setup.example.json", env!("CARGO_MANIFEST_DIR"));
    let path = format!("{}/../tests/wrong/tool_of_another_type.mpf", env!("CARGO_MANIFEST_DIR"));
    let text = &std::fs::read_to_string(&path).unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_probewright"));
    let command = command.env("LC_ALL", "C").args(["check", "--json", "--setup", &setup, &path]);
    let document: Value = serde_json::from_slice(&command.output().unwrap().stdout).unwrap();
    let wanted = document[0]["diagnostics"].as_array().unwrap();
    let uri = "file:///parts/a.mpf";
    let mut client = Client::session(able(), "en", Value::Null);
    let without = client.open(uri, text);
    client.tell("workspace/didChangeConfiguration", json!({ "settings": { "probewright": { "setup": setup } } }));
    let found = client.findings(uri, 1);
    assert_eq!(codes(&found), codes(wanted));
    assert_ne!(found, without, "the machine makes a difference");
    for none in [json!({}), Value::Null] {
        client.tell("workspace/didChangeConfiguration", json!({ "settings": none }));
    }
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": uri, "version": 2 },
        "contentChanges": [{ "text": text }] }),
    );
    assert_eq!(client.findings(uri, 2), found, "no setting is not another one");
}

// oracle: self (words of the settings)
#[test]
fn a_setting_that_cannot_count_is_told() {
    for (setting, said) in [
        (json!({ "setup": "/none/such.json" }), "such.json"),
        (json!({ "set": 1 }), "set"),
        (json!({ "control": "other" }), "control"),
        (json!([]), "list"),
    ] {
        let mut client = Client::session(able(), "en", setting.clone());
        let found = client.open("file:///parts/a.mpf", "M30\n");
        assert!(found.is_empty(), "{found:?}");
        let told = client.told.iter().find(|one| one["method"] == "window/showMessage").expect("a message");
        let text = told["params"]["message"].as_str().unwrap();
        assert!(text.starts_with("setting “probewright”: ") && text.contains(said), "{setting}: {text}");
    }
}

// oracle: hand
#[test]
fn a_control_that_is_set_is_that_of_every_program() {
    let text = "G102 D50.\nM30\n";
    let mut client = Client::session(able(), "en", json!({ "control": "nct" }));
    client.open("file:///parts/a.nc", text);
    let told = client.at("textDocument/hover", "file:///parts/a.nc", text, "G102", 1);
    assert!(told["contents"]["value"].as_str().unwrap().contains("G102"), "{told}");
}
