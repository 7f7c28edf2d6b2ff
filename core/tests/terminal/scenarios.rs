//! `probewright test`.

use super::{HOLE, err, example_setup, file, out, probewright};
use probewright_core::app::{NoteRequest, noted};
use probewright_core::json::question;

/// The measured hole of the readme, with what comes of it; written into docs/ with PROBEWRIGHT_UPDATE=1.
fn example() -> String {
    let setup: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(example_setup()).unwrap()).unwrap();
    let run = serde_json::json!({ "control": "sinumerik", "text": HOLE, "setup": setup });
    let request = serde_json::json!({ "run": run, "name": "hole.mpf", "case": "0.03 mm too big" });
    let asked: NoteRequest = question(&request.to_string()).unwrap();
    serde_json::to_string_pretty(&noted(asked).unwrap()).unwrap() + "\n"
}

// oracle: self, hand (the radius of T20 D1 is 0.015 mm more)
#[test]
fn the_example_in_docs_holds() {
    let path = format!("{}/../docs/hole.scenario.json", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(&path, example()).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&path).unwrap(), example());
    let output = probewright(&["test", &path]);
    assert!(output.status.success(), "{}", err(&output));
    assert_eq!(out(&output), format!("ok  {path}: 0.03 mm too big\nPassed: 1 of 1\n"));

    let other = file("other.scenario.json", example().replace("132.03", "132.04").as_bytes());
    let output = probewright(&["test", &other, "--lang=de"]);
    assert_eq!(output.status.code(), Some(1));
    let told = out(&output);
    assert!(told.contains("_OVR[4] = 132.03. Erwartet: 132.04.\nBestanden: 0 von 1\n"), "{told}");
}

// oracle: hand
#[test]
fn a_folder_is_carried_out_whole_and_told_to_other_tools() {
    let cases = format!("{}/../tests/cases", env!("CARGO_MANIFEST_DIR"));
    let junit = file("result.xml", b"");
    let output = probewright(&["test", &cases, "--junit", &junit]);
    let told = out(&output);
    let count = told.lines().filter(|line| line.starts_with("ok  ")).count();
    assert!(output.status.success() && count >= 276, "{told}{}", err(&output));
    assert!(told.ends_with(&format!("Passed: {count} of {count}\n")), "{told}");
    let report = std::fs::read_to_string(junit).unwrap();
    assert_eq!(report.matches("<testcase ").count(), count);
    assert!(!report.contains("<failure"));
    assert!(report.contains(&format!("<testsuites tests=\"{count}\" failures=\"0\">")), "{}", &report[..200]);
}

// oracle: hand: the program that measures is missing, so that nothing is measured
#[test]
fn a_case_that_measures_nothing_says_so() {
    let scenario = |text: &str| {
        format!(
            r#"{{"program":{{"name":"sub.mpf","text":"{text}"}},"cases":[{{"id":"sub","expect":{{"calls":[]}}}}],
                "setup":{{"control":"sinumerik","probe":{{"radius":3,"length":50}}}}}}"#
        )
    };
    let junit = file("sub.xml", b"");
    let told = |text: &str| {
        out(&probewright(&["test", &file("sub.scenario.json", scenario(text).as_bytes()), "--junit", &junit]))
    };
    let without = told("G17 G54 G90\\nMEASURE\\nM30\\n");
    assert!(without.starts_with("ok  ") && without.contains("proves no measurement"), "{without}");
    assert!(without.contains("MEASURE (2)") && without.contains("Passed: 1 of 1"), "{without}");
    let empty = told("G17 G54 G90\\nM30\\n");
    assert!(empty.contains("proves no measurement") && !empty.contains("MEASURE"), "{empty}");
    let report = std::fs::read_to_string(junit).unwrap();
    assert!(report.contains("<system-out>") && report.contains("proves no measurement"), "{report}");
}

// oracle: hand: each difference of a case is told once
#[test]
fn what_stops_a_run_is_told_once() {
    let endless = r#"{"program":{"name":"a.mpf","text":"N10 WHILE TRUE\nN20 ENDWHILE\nM30\n"},
        "setup":{"control":"sinumerik","probe":{"radius":3,"length":50}},"cases":[{"id":"loop","expect":{}}]}"#;
    let endless = file("endless.scenario.json", endless.as_bytes());
    let junit = file("endless.xml", b"");
    let told = out(&probewright(&["test", &endless, "--junit", &junit]));
    for told in [told, std::fs::read_to_string(junit).unwrap()] {
        assert_eq!(told.matches("The program never ends").count(), 1, "{told}");
    }
}

// oracle: hand
#[test]
fn what_is_no_scenario_is_told_with_its_place() {
    for (text, told) in [
        ("{\n \"program\": 1 }", ":2:13: program: expected an object"),
        ("{\n \"progam\": 1 }", ":2:12: "),
        (r#"{"program":{"name":"a.nc"},"setup":{"control":"nct","probe":{}},"cases":[]}"#, ":1:61: setup.probe.radius"),
        (
            r#"{"program":{"name":"a.nc"},"setup":{"control":"nct","probe":{"radius":3,"length":50}},"cases":[]}"#,
            "a.nc: ",
        ),
        ("[", "ends"),
        (
            r#"{"program":{"name":"a.nc","text":"M30"},"setup":{"control":"nct","probe":{"radius":3,"length":50}},
                "cases":[]}"#,
            ":2:25: cases: the scenario has no case",
        ),
    ] {
        let wrong = file("wrong.scenario.json", text.as_bytes());
        let junit = file("wrong.xml", b"");
        let output = probewright(&["test", &wrong, "--junit", &junit]);
        let line = out(&output);
        assert_eq!(output.status.code(), Some(1), "{text}: {line}{}", err(&output));
        assert!(line.starts_with("FAILED  ") && line.contains(told), "{text}: {line}");
        assert!(line.ends_with("Passed: 0 of 1\n"), "{line}");
        let report = std::fs::read_to_string(junit).unwrap();
        assert!(report.contains("<failure message=") && report.contains("tests=\"1\" failures=\"1\""), "{report}");
    }
    let empty = std::env::temp_dir().join(format!("probewright-none-{}", std::process::id()));
    std::fs::create_dir_all(&empty).unwrap();
    let output = probewright(&["test", empty.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("no scenario.json"), "{}", err(&output));
}

// oracle: hand (a scenario that cannot fail proves nothing)
#[test]
fn a_scenario_that_proves_nothing_fails() {
    let with = |program: &str, expect: &str| {
        let setup = r#"{"control":"sinumerik","probe":{"radius":3,"length":50}}"#;
        format!(
            r#"{{"program":{{"name":"a.mpf","text":"{program}"}},"setup":{setup},
                "cases":[{{"id":"a","expect":{expect}}}]}}"#
        )
    };
    for (program, expect, told) in [
        ("R1=1\\nM30", r#"{"data":{"R1":1}}"#, None),
        ("M30", r#"{"data":{"_FOO[1]":0}}"#, Some("_FOO[1]")),
        ("M30", r#"{"data":{"_WP[999,77]":0}}"#, Some("_WP[999,77]")),
        ("M30", r#"{"data":{"$TC_FOO":0}}"#, Some("$TC_FOO")),
        ("M30", r#"{"tolerance":-1}"#, Some("cases[0].expect.tolerance")),
        ("G0 X[\\nM30", r#"{"alarms":[]}"#, Some("FAILED")),
    ] {
        let path = file("proves.scenario.json", with(program, expect).as_bytes());
        let output = probewright(&["test", &path]);
        let line = out(&output);
        assert_eq!(output.status.success(), told.is_none(), "{program} {expect}: {line}");
        assert!(told.is_none_or(|told| line.contains(told)), "{program} {expect}: {line}");
    }
}
