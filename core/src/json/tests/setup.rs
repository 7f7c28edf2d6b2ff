//! The setup file: written, read, and its schema.

use crate::json::*;
use crate::words::Words;
use std::path::PathBuf;

fn docs(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name)
}

// oracle: self
#[test]
fn a_setup_written_and_read_is_the_same() {
    let text = std::fs::read_to_string(docs("setup.example.json")).unwrap();
    let setup = setup_from_json(&text).unwrap();
    let again = setup_from_json(&document(&setup).to_string()).unwrap();
    assert_eq!(setup, again);
    assert_eq!(setup.control.tools[&20].edges[&1].radius, 66.0);
    assert_eq!(setup.workpiece.solids[0].errors.size, 0.03);
}

// oracle: hand
#[test]
fn what_the_machine_can_do_is_read_and_written() {
    let text = r#"{
        "control": "sinumerik",
        "machine": {"limitsMinus": [null, null, -100], "limitsPlus": [400, null, null], "spindlePositions": false},
        "frames": {"G54": {"coarse": [0, 0, 0], "scale": [2, 2, 1]}},
        "active": {"frame": "G54", "transverse": "DIAMON"},
        "probe": {"radius": 3, "length": 50, "falseSignal": 12.5}
    }"#;
    let setup = setup_from_json(text).unwrap();
    assert_eq!(setup.control.limits.minus, [None, None, Some(-100.0)]);
    assert_eq!(setup.control.limits.plus, [Some(400.0), None, None]);
    assert!(!setup.control.spindle_positions);
    assert_eq!(setup.control.active.scale, [2.0, 2.0, 1.0]);
    assert_eq!(setup.control.transverse, crate::control::Transverse::Diameter);
    assert_eq!(setup.probe.false_signal, Some(12.5));
    let again = setup_from_json(&document(&setup).to_string()).unwrap();
    assert_eq!(setup, again);
}

// oracle: hand
#[test]
fn the_clock_is_read_and_written() {
    let text = |clock: &str| format!(r#"{{"control": "sinumerik", {clock} "probe": {{"radius": 3, "length": 50}}}}"#);
    let setup = setup_from_json(&text(r#""clock": "1998-11-15T10:05:30","#)).unwrap();
    assert_eq!(setup.clock.date(), "98/11/15");
    assert_eq!(setup_from_json(&document(&setup).to_string()).unwrap(), setup);
    let without = setup_from_json(&text("")).unwrap();
    assert_eq!(without.clock.to_string(), "2000-01-01T00:00:00");
    assert!(document(&without).get("clock").is_none());
    let wrong = setup_from_json(&text(r#""clock": "15.11.1998","#)).unwrap_err();
    assert_eq!(Words::english().text(&wrong.message).split(':').next(), Some("clock"));
}

// oracle: hand
#[test]
fn a_slip_in_a_setup_is_told() {
    for (text, part) in [
        ("", "ends before the JSON is complete"),
        ("{\"control\":\"fanuc\",\"probe\":{\"radius\":3,\"length\":50}}", "fanuc"),
        ("{\"control\":\"nct\",\"prope\":1}", "prope"),
        (
            "{\"control\":\"nct\",\"probe\":{\"radius\":3,\"length\":50},\"frames\":{\"G12\":{\"coarse\":[0,0,0]}}}",
            "G12",
        ),
        (
            "{\"control\":\"nct\",\"probe\":{\"radius\":3,\"length\":50},\
             \"workpiece\":[{\"shape\":\"hole\",\"size\":[1],\"at\":[0,0,0]}]}",
            "Hole",
        ),
    ] {
        let told = Words::english().text(&setup_from_json(text).unwrap_err().message);
        assert!(told.contains(part), "{told}");
    }
}

/// A setup file with an error in line 3.
fn wrong(line: &str) -> String {
    format!("{{\n\"control\": \"nct\",\n{line}\n\"probe\": {{\"radius\": 3, \"length\": 50}}\n}}")
}

// oracle: hand
#[test]
fn an_error_of_a_setup_names_the_member_and_its_place() {
    for (line, path, column, english, chinese) in [
        (r#""position": [0, "x", 0],"#, "position[1]", 17, "expected a number, found a text", "应为数字，而不是文本"),
        (r#""position": [0, 0],"#, "position", 13, "position: 2; expected: 3", "有 2 个值"),
        (
            r#""prope": 1,"#,
            "prope",
            10,
            "Member prope does not exist; known members: control, name, units",
            "没有成员 prope",
        ),
        (
            r#""tools": {"0": {"edges": {}}, "x": {}},"#,
            "tools.x",
            36,
            "member names must be whole numbers",
            "名称必须是整数",
        ),
        (r#""tools": {"0": {"edges": {"1": {}}}},"#, "tools.0.edges.1.type", 32, "is missing", "缺少"),
        (
            r#""tools": {"0": {"edges": {"1": {"type": 1.5}}}},"#,
            "tools.0.edges.1.type",
            41,
            "a whole number",
            "应为整数",
        ),
        (
            r#""skip": [1, 300],"#,
            "skip[1]",
            13,
            "is 300; permitted: whole numbers from 0 to 255",
            "允许 0 到 255 的整数",
        ),
        (r#""plane": "G20","#, "plane", 10, "“G20”; permitted: G17, G18, G19", "允许：G17, G18, G19"),
        (r##""data": {"#500": true},"##, "data.#500", 18, "a number or a text", "数字或文本"),
        (
            r#""workpiece": [{"shape": "web", "size": [1, 2], "at": [0, 0, 0]}],"#,
            "workpiece[0].size",
            40,
            "sizes for Web: 2; expected: 3",
            "凸台需要 3",
        ),
        (
            r#""position": [0, 2e6, 0],"#,
            "position",
            13,
            "2000000; permitted: -1000000 to 1000000",
            "允许：-1000000 到 1000000",
        ),
        (
            r#""workpiece": [{"shape": "hole", "size": [10, 5], "at": [0, 0, 0], "errors": {"size": 1e6}}],"#,
            "workpiece[0]",
            15,
            "amplitude is 1000010; permitted: more than 0, at most 1000000",
            "1000010；允许：大于 0，不超过 1000000",
        ),
        (
            r#""workpiece": [{"shape": "hole", "size": [10, 5], "at": [0, 0, 0], "errors": {"taper": 1e6}}],"#,
            "workpiece[0]",
            15,
            "bottom is 5000010; permitted: more than 0, at most 1000000",
            "5000010；允许：大于 0，不超过 1000000",
        ),
        (r#""units": "mm", "名": 1, "units": "mm","#, "units", 30, "occurs twice", "出现了两次"),
    ] {
        let refused = setup_from_json(&wrong(line)).unwrap_err();
        assert_eq!((refused.path.to_string().as_str(), refused.position), (path, Some((3, column))), "{line}");
        for (code, part) in [("en", english), ("zh", chinese)] {
            let told = Words::of(code).unwrap().text(&refused.message);
            assert!(told.contains(part) && told.contains(path), "{told}");
        }
    }
    for (text, position, part) in
        [("{\n", (2, 1), "ends"), ("{\"control\": nct}", (1, 14), "not valid JSON"), ("[]", (1, 1), "an object")]
    {
        let refused = setup_from_json(text).unwrap_err();
        assert_eq!(refused.position, Some(position), "{text}");
        assert!(Words::english().text(&refused.message).contains(part), "{refused}");
    }
}

// oracle: self. With PROBEWRIGHT_UPDATE=1 the files are written instead.
#[cfg(feature = "cli")]
#[test]
fn the_schemas_in_docs_are_those_of_the_code() {
    use crate::setup_file::{SetupFile, schema};
    for (name, schema) in [
        ("setup.schema.json", schema::<SetupFile>()),
        ("scenario.schema.json", schema::<crate::app::Scenario>()),
        ("record.schema.json", schema::<crate::app::Record>()),
    ] {
        let schema = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
        if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
            std::fs::write(docs(name), &schema).unwrap();
        }
        assert_eq!(std::fs::read_to_string(docs(name)).unwrap(), schema);
    }
}
