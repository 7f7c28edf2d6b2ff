//! The setup file: written, read, and its schema.

use crate::json::*;
use std::path::PathBuf;

fn docs(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name)
}

// oracle: self
#[test]
fn a_setup_written_and_read_is_the_same() {
    let text = std::fs::read_to_string(docs("setup.example.json")).unwrap();
    let setup = setup_from_json(&text).unwrap();
    let again = setup_from_json(&setup_to_json(&setup).to_string()).unwrap();
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
    let again = setup_from_json(&setup_to_json(&setup).to_string()).unwrap();
    assert_eq!(setup, again);
}

// oracle: hand
#[test]
fn a_slip_in_a_setup_is_told() {
    for (text, part) in [
        ("", "expected"),
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
        let told = setup_from_json(text).unwrap_err().to_string();
        assert!(told.contains(part), "{told}");
    }
}

// oracle: self. With PROBEWRIGHT_UPDATE=1 the file is written instead.
#[cfg(feature = "cli")]
#[test]
fn the_schema_in_docs_is_the_one_of_the_code() {
    let schema = format!("{}\n", serde_json::to_string_pretty(&setup_schema()).unwrap());
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(docs("setup.schema.json"), &schema).unwrap();
    }
    assert_eq!(std::fs::read_to_string(docs("setup.schema.json")).unwrap(), schema);
}
