//! Each capability, asked of the real process.

use crate::client::{Client, able, done, within};
use crate::{HOLE, WRONG};
use serde_json::{Value, json};
use std::process::Command;

const URI: &str = "file:///parts/hole.mpf";

/// Findings of `probewright check` for a text.
fn checked(name: &str, text: &str) -> Vec<Value> {
    let path = std::env::temp_dir().join(format!("probewright-lsp-{}-{name}", std::process::id()));
    std::fs::write(&path, text).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "C")
        .args(["check", "--json", path.to_str().unwrap()])
        .output()
        .unwrap();
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    document[0]["diagnostics"].as_array().unwrap().clone()
}

// oracle: peer (`probewright check`)
#[test]
fn findings_are_those_of_check() {
    for (name, text) in [("hole", HOLE.to_owned()), ("wrong", WRONG.to_owned()), ("crlf", WRONG.replace('\n', "\r\n"))]
    {
        let mut client = Client::english();
        let found = client.open(URI, &text);
        let wanted = checked(name, &text);
        assert!(!wanted.is_empty(), "{name}");
        assert_eq!(found.len(), wanted.len(), "{name}");
        for (one, other) in found.iter().zip(&wanted) {
            assert_eq!(one["code"], other["code"]);
            assert_eq!(one["range"]["start"]["line"].as_u64().unwrap() + 1, other["line"].as_u64().unwrap());
            let severity = ["error", "warning", "note"][one["severity"].as_u64().unwrap() as usize - 1];
            assert_eq!(severity, other["severity"]);
            let cause = other["message"]["text"].as_str().unwrap();
            assert!(one["message"].as_str().unwrap().contains(cause), "{one}");
        }
        assert!(client.end().success());
    }
}

// oracle: hand
#[test]
fn a_finding_names_the_call_that_it_is_about() {
    let mut client = Client::english();
    let text = HOLE.replace("_KNUM=1\n", "\n"); // that of the program before, a tool offset
    let found = client.open(URI, &text);
    let one = found.iter().find(|one| one["code"] == "61321").unwrap();
    assert_eq!(within(&text, &one["relatedInformation"][0]["location"]["range"]), "CYCLE977");
}

// oracle: manual B:1902-1926 (digits of _KNUM), B:2448 (alarms)
#[test]
fn hovering_explains_values_digits_calls_alarms_and_data() {
    let mut client = Client::english();
    client.open(URI, HOLE);
    for (word, into, said) in [
        ("_KNUM=2001", 0, "**\\_KNUM: Tool offset to be corrected**"),
        ("_KNUM=2001", 6, "→ What is corrected: 2: Radius"),
        ("_KNUM=2001", 9, "→ D number: 1"),
        ("_SETVAL=R2", 9, "Diameter from the drawing"),
        ("N70 CYCLE977", 6, "**CYCLE977 1: Hole: correct a tool**"),
        ("61303", 1, "safe area"),
        ("PW135", 4, "does not calibrate"),
        ("_CHBIT[4]", 7, "Mean value with automatic tool offset"),
    ] {
        let told = client.at("textDocument/hover", URI, HOLE, word, into);
        let text = told["contents"]["value"].as_str().unwrap_or_default();
        assert!(text.contains(said), "{word} {into}: {text}");
        assert_eq!(told["contents"]["kind"], "markdown");
    }
    assert!(client.at("textDocument/hover", URI, HOLE, "Maß", 1).is_null());
}

// oracle: peer (the published list of CYCLE978: S_FA is its 6th argument, S_MD its 9th)
#[test]
fn hovering_explains_an_argument_of_a_newer_list() {
    const EDGE: &str = "G17 G54 T9 D1 M6\nCYCLE978(0,,,1,-55,15,7,1,2,1)\nCYCLE996(3,1,1,25)\nM30\n";
    let mut client = Client::english();
    client.open(URI, EDGE);
    for (word, into, said) in [
        (",15,", 2, "Argument 6 of CYCLE978"),
        (",15,", 2, "On the screen: DFA"),
        (",2,1)", 1, "1: plus; 2: minus."),
        (",25)", 1, "Diameter of the calibration ball"),
    ] {
        let told = client.at("textDocument/hover", URI, EDGE, word, into);
        let text = told["contents"]["value"].as_str().unwrap_or_default();
        assert!(text.contains(said), "{word} {into}: {text}");
    }
}

// oracle: peer (published lists: argument 2 takes zero offsets, hundreds 0 of argument 1 only measures; the digits of
// CYCLE979 and of the hundred-thousands of CYCLE998 are not published)
#[test]
fn a_list_is_not_explained_as_a_call_of_the_older_control() {
    const LISTS: &str =
        "G17 G54 T9 D1 M6\nCYCLE979(1,1001,,1,50)\nCYCLE977(1,,,1,50,,,2,5)\nCYCLE998(100105,1,,1,1,0,,10)\nM30\n";
    let mut client = Client::english();
    client.open(URI, LISTS);
    for (word, into, said) in [
        ("CYCLE977(1", 3, "**CYCLE977 1: Hole: measure only**"),
        ("CYCLE979(1", 3, "Argument list of CYCLE979"),
        ("(1,,,1", 1, "Hole: measure only"),
    ] {
        let told = client.at("textDocument/hover", URI, LISTS, word, into);
        let text = told["contents"]["value"].as_str().unwrap_or_default();
        assert!(text.contains(said), "{word} {into}: {text}");
    }
    for (word, into) in [("(1,1001", 1), ("1001,", 1), ("(1,,,1", 1), ("(100105", 2), ("CYCLE979", 1)] {
        let told = client.at("textDocument/hover", URI, LISTS, word, into);
        let text = told["contents"]["value"].as_str().unwrap_or_default();
        for older in ["D number", "Tool offset", "1: Hole\n", "along the axis", "correct a tool"] {
            assert!(!text.is_empty() && !text.contains(older), "{word} {into}: {text}");
        }
    }
    let outline = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": URI } }));
    let details: Vec<&str> = outline.as_array().unwrap().iter().filter_map(|one| one["detail"].as_str()).collect();
    assert_eq!(details, ["Hole, shaft, groove, web at an angle", "Hole: measure only", "Angle of a surface"]);
}

// oracle: hand
#[test]
fn words_are_in_the_language_of_the_client() {
    for (locale, said) in [("de-DE", "Werkzeugkorrektur"), ("zh-cn", "刀具"), ("fr", "Tool offset")] {
        let mut client = Client::session(able(), locale, Value::Null);
        client.open(URI, HOLE);
        let told = client.at("textDocument/hover", URI, HOLE, "_KNUM=2001", 0);
        assert!(told["contents"]["value"].as_str().unwrap().contains(said), "{locale}: {told}");
    }
}

fn labels(answer: &Value) -> Vec<&str> {
    answer["items"].as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect()
}

// oracle: manual B:5593-5700 (variants of CYCLE977)
#[test]
fn completion_offers_parameters_variants_and_cycles() {
    let mut client = Client::english();
    let text = "N10 _MVAR=1 _SETVAL=20 _KNUM=2001 _T\nN20 CYCLE977\nN30 _MVAR=\nM30 ; _T\n";
    client.open(URI, text);
    let names = client.at("textDocument/completion", URI, text, "_T\n", 2);
    let all = labels(&names);
    assert!(all.contains(&"_TNUM") && all.contains(&"_TSA") && all.contains(&"CYCLE977"), "{all:?}");
    let place = |name: &str| all.iter().position(|one| *one == name);
    assert!(place("_TNUM") < place("_SETVAL"), "what is missing comes first: {all:?}");
    let item = &names["items"][place("_TNUM").unwrap()];
    assert_eq!(item["textEdit"]["newText"], "_TNUM=");
    assert_eq!(within(text, &item["textEdit"]["range"]), "_T");
    let variants = client.at("textDocument/completion", URI, text, "_MVAR=1 ", 7);
    assert!(labels(&variants).contains(&"101"), "{variants}");
    let any = client.at("textDocument/completion", URI, text, "_MVAR=\n", 6);
    let of_974 = any["items"].as_array().unwrap().iter().any(|item| item["detail"].to_string().contains("CYCLE974"));
    assert!(of_974, "before any call, those of every cycle");
    assert!(labels(&client.at("textDocument/completion", URI, text, "; _T", 4)).is_empty(), "a comment");
}

// oracle: peer (the published lists: S_MD is argument 9 of CYCLE978, 1 plus, 2 minus; CYCLE996 is one of them)
#[test]
fn completion_knows_the_lists_of_newer_controls() {
    let text = "G54 T9 D1 M6\nCYCLE978(0,,,1,-55,15,7,1,,1)\nCY\nM30\n";
    let mut client = Client::english();
    client.open(URI, text);
    assert_eq!(labels(&client.at("textDocument/completion", URI, text, "1,,1)", 2)), ["1", "2"]);
    assert_eq!(labels(&client.at("textDocument/completion", URI, text, "(0,", 2)), ["0", "100"]);
    let all = client.at("textDocument/completion", URI, text, "CY\n", 2);
    let of_996 = all["items"].as_array().unwrap().iter().filter(|item| item["label"] == "CYCLE996");
    assert_eq!(of_996.count(), 1, "{all}");
    let params = json!({ "textDocument": { "uri": URI } });
    let outline = client.ask("textDocument/documentSymbol", params);
    assert_eq!(outline[0]["name"], "CYCLE978");
    let other = "G0 X0\nCYCLE996(3,1,1,25)\nM30\n";
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": URI, "version": 2 },
        "contentChanges": [{ "text": other }] }),
    );
    let outline = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": URI } }));
    assert_eq!(outline[0]["name"], "CYCLE996");
    let told = client.at("textDocument/hover", URI, other, "CYCLE996", 3);
    assert!(told["contents"]["value"].as_str().unwrap().contains("CYCLE996"), "{told}");
    // in a bracket that is still open the call behind it says nothing
    let open = "G0 X0\nCYCLE978(\nCYCLE977(101,1,,1,50)\nM30\n";
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": URI, "version": 3 },
        "contentChanges": [{ "text": open }] }),
    );
    assert_eq!(labels(&client.at("textDocument/completion", URI, open, "CYCLE978(", 9)), ["0", "100"]);
}

// oracle: manual (TNC 320 9/2016, p. 396: cycle 423 and its parameters), hand
#[test]
fn a_program_that_is_not_run_is_told_completed_and_outlined() {
    const TNC: &str = "0 BEGIN PGM A MM\n1 TCH PROBE 423 MEAS. RECTAN. INSIDE ~\n  Q273=+0 ;CENTER IN 1ST AXIS ~\n  Q\n\
        2 TC\n3 END PGM A MM\n";
    let mut client = Client::english();
    let found = client.open("file:///a.h", TNC);
    let codes: Vec<&str> = found.iter().filter_map(|one| one["code"].as_str()).collect();
    assert!(codes.iter().all(|code| ["PW199", "PW201"].contains(code)) && codes.len() == 3, "{codes:?}");
    let mut ask = |method: &str, word: &str, into: usize| client.at(method, "file:///a.h", TNC, word, into);
    let missing = ask("textDocument/completion", "  Q\n", 3);
    let all = labels(&missing);
    assert!(all.contains(&"Q274") && !all.contains(&"Q273") && !all.contains(&"CYCLE977"), "{all:?}");
    let item = &missing["items"][0];
    assert_eq!((item["textEdit"]["newText"].as_str(), within(TNC, &item["textEdit"]["range"])), (Some("Q274="), "Q"));
    let cycles = ask("textDocument/completion", "2 TC", 4);
    assert!(labels(&cycles).contains(&"TCH PROBE 412"), "{cycles}");
    assert_eq!(within(TNC, &cycles["items"][0]["textEdit"]["range"]), "TC");
    assert!(!labels(&cycles).contains(&"TCH PROBE 414"), "nothing is published of it");
    let told = ask("textDocument/hover", "PROBE 423", 2);
    assert!(told["contents"]["value"].as_str().unwrap().contains("rectangular pocket"), "{told}");
    let told = ask("textDocument/hover", "Q273=", 2);
    assert!(told["contents"]["value"].as_str().unwrap().contains("Centre, 1st axis"), "{told}");
    let outline = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": "file:///a.h" } }));
    let names: Vec<_> = outline.as_array().unwrap().iter().map(|one| one["name"].as_str()).collect();
    assert_eq!(names, [Some("TCH PROBE 423")], "{outline}");
}

// oracle: manual C:1159 (NCT programs), hand
#[test]
fn nct_programs_have_their_macros_and_addresses() {
    let text = "O0110\nG102 D50. I10. \nM30\n";
    let mut client = Client::english();
    client.open(URI, text);
    let names = client.at("textDocument/completion", URI, text, " \nM30", 1);
    let all = labels(&names);
    assert!(all.contains(&"G102") && !all.contains(&"CYCLE977"), "{all:?}");
    assert!(!all.contains(&"D"), "it is given");
    let told = client.at("textDocument/hover", URI, text, "D50.", 2);
    assert!(told["contents"]["value"].as_str().unwrap().starts_with("**D: "), "{told}");
}

// oracle: hand
#[test]
fn from_a_name_to_what_gives_it_its_meaning() {
    let mut client = Client::english();
    client.open(URI, HOLE);
    let mut go = |method: &str, word: &str, into: usize| -> Vec<String> {
        let places = client.at(method, URI, HOLE, word, into);
        let text = |place: &Value| within(HOLE, &place["range"]).to_owned();
        places.as_array().unwrap().iter().map(text).collect()
    };
    let definition = "textDocument/definition";
    assert_eq!(go(definition, "R2+2", 1), ["R2=130"]);
    assert_eq!(go(definition, "GOTOF START", 8), ["START"]);
    assert_eq!(go(definition, "N75 L10", 5), ["_MVAR=101 _SETVAL=5 _KNUM=1"]);
    let reach = go(definition, "N70 CYCLE977", 6);
    assert!(reach.contains(&"_KNUM=2001".to_owned()) && reach.contains(&"_TUL=0.1".to_owned()), "{reach:?}");
    assert!(!reach.contains(&"_SETVAL=5".to_owned()), "that of another call");
    assert_eq!(go("textDocument/references", "_TUL=0.1", 2), ["CYCLE977", "CYCLE977"]);
    assert_eq!(go("textDocument/references", "_SETVAL=R2", 2), ["CYCLE977"]);
}

// oracle: hand
#[test]
fn the_outline_has_programs_labels_and_calls() {
    let mut client = Client::english();
    client.open(URI, HOLE);
    let params = json!({ "textDocument": { "uri": URI } });
    let outline = client.ask("textDocument/documentSymbol", params.clone());
    let names = |list: &Value| -> Vec<String> {
        list.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names(&outline), ["Program", "L10"]);
    assert_eq!(names(&outline[0]["children"]), ["START", "CYCLE977", "L10"]);
    assert_eq!(outline[0]["children"][1]["detail"], "Hole: correct a tool");
    let lines = within(HOLE, &outline[0]["children"][1]["range"]);
    assert!(lines.starts_with("N60") && lines.ends_with("CYCLE977"), "with its assignments: {lines}");
    let mut plain = Client::session(json!({}), "en", Value::Null);
    plain.open(URI, HOLE);
    let flat = plain.ask("textDocument/documentSymbol", params);
    assert!(flat.as_array().unwrap().len() == 6 && flat[1]["location"]["uri"] == URI, "{flat}");
}

// oracle: peer (`probewright read`: the call has the same values in each style), self (findings are gone)
#[test]
fn actions_cure_findings_and_convert_calls() {
    let mut client = Client::english();
    let found = client.open(URI, WRONG);
    let actions = client.actions(URI, WRONG, "_MVAR=1,5");
    let cure = actions.iter().find(|action| action["kind"] == "quickfix").unwrap();
    let told = &cure["diagnostics"][0];
    assert!(found.contains(told), "{told}");
    let mut after = Client::english();
    let left = after.open(URI, &done(WRONG, cure));
    assert!(!left.iter().any(|one| one["message"] == told["message"]), "{left:?}");

    client.open("file:///parts/b.mpf", HOLE);
    let actions = client.actions("file:///parts/b.mpf", HOLE, "CYCLE977");
    let convert = actions.iter().find(|action| action["kind"] == "refactor.rewrite").unwrap();
    assert_eq!(convert["edit"]["documentChanges"][0]["textDocument"]["version"], 1);
    let text = done(HOLE, convert);
    assert!(text.contains("CYCLE_PARA("), "{text}");
    let values = |text: &str| {
        let path = std::env::temp_dir().join(format!("probewright-lsp-{}-converted", std::process::id()));
        std::fs::write(&path, text).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_probewright"));
        let output = command.args(["read", "--json", path.to_str().unwrap()]).output().unwrap();
        let view: Value = serde_json::from_slice(&output.stdout).unwrap();
        view["calls"].as_array().unwrap().iter().map(|call| call["values"]["_KNUM"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(values(&text), values(HOLE));
}

// oracle: hand
#[test]
fn all_findings_of_a_kind_are_cured_at_once() {
    let text = "N10 _MVAR=1,5\nN20 _SETVAL=1,5\nN30 M2\n";
    let mut client = Client::english();
    client.open(URI, text);
    let actions = client.actions(URI, text, "_MVAR=1,5");
    let all = actions.iter().find(|one| one["title"].as_str().unwrap().contains("all of this kind: 2")).unwrap();
    assert_eq!(done(text, all), "N10 _MVAR=1.5\nN20 _SETVAL=1.5\nN30 M2\n");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 9 } });
    let context = json!({ "diagnostics": [], "only": ["refactor"] });
    let params = json!({ "textDocument": { "uri": URI }, "range": range, "context": context });
    let none = client.ask("textDocument/codeAction", params);
    assert!(none.as_array().unwrap().is_empty(), "only what was asked for: {none}");
}

/// Conversions that are offered at a call, by their titles.
fn conversions(client: &mut Client, text: &str, word: &str) -> Vec<Value> {
    client.open(URI, text);
    let actions = client.actions(URI, text, word);
    actions.into_iter().filter(|action| action["kind"] == "refactor.rewrite").collect()
}

// oracle: hand (all remarks in words; a conversion that is refused with its reason)
#[test]
fn a_conversion_tells_all_that_it_loses_or_why_there_is_none() {
    let list = "CYCLE977(101,1,,1,50,,,10,5,11,16,20,,,1,\"BOHRER\",2,0.005,0.2,0.1,-0.1,0.34,1,3,,1,1)\nM30\n";
    let mut client = Client::english();
    let direct = &conversions(&mut client, list, "CYCLE977")[0];
    let title = direct["title"].as_str().unwrap();
    for said in ["assignments and call – ", "S_ID=16", "S_TNAME=BOHRER", "S_EVNUM=3", "S_STA1 = 11"] {
        assert!(title.contains(said), "{title}");
    }
    let tool = "CYCLE977(101,1,2001,1,50,,,10,5)\nM30\n";
    let mut able = able();
    able["textDocument"]["codeAction"] = json!({ "disabledSupport": true });
    let mut other = Client::session(able, "en", Value::Null);
    let refused = &conversions(&mut other, tool, "CYCLE977")[0];
    let reason = refused["disabled"]["reason"].as_str().unwrap();
    assert!(reason.contains("S_KNUM1 = 2001") && refused["edit"].is_null(), "{refused}");
    // a client without such actions gets the reason as a message
    let mut plain = Client::english();
    let refused = &conversions(&mut plain, tool, "CYCLE977")[0];
    assert!(refused["edit"].is_null() && refused["title"].as_str().unwrap().contains(reason), "{refused}");
    let command = &refused["command"];
    let params = json!({ "command": command["command"], "arguments": command["arguments"] });
    plain.told.clear();
    plain.ask("workspace/executeCommand", params);
    let shown = plain.told.iter().find(|one| one["method"] == "window/showMessage").cloned();
    let shown = shown.unwrap_or_else(|| plain.receive());
    assert_eq!(shown["params"]["message"].as_str(), Some(reason));
}
