#![allow(clippy::unwrap_used)]
use super::*;
use std::path::PathBuf;

fn docs(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(name)
}

// oracle: self
#[test]
fn a_setup_written_and_read_is_the_same() {
    let text = std::fs::read_to_string(docs("setup.example.json")).unwrap();
    let setup = setup_from_json(&text).unwrap();
    let again = setup_from_json(&setup_to_json(&setup).unwrap().to_string()).unwrap();
    assert_eq!(setup, again);
    assert_eq!(setup.control.tools[&20].edges[&1].radius, 66.0);
    assert_eq!(setup.workpiece.solids[0].errors.size, 0.03);
}

// oracle: hand
#[test]
fn a_slip_in_a_setup_is_told() {
    for (text, part) in [
        ("", "expected"),
        (
            "{\"control\":\"fanuc\",\"probe\":{\"radius\":3,\"length\":50}}",
            "fanuc",
        ),
        ("{\"control\":\"nct\",\"prope\":1}", "prope"),
        (
            "{\"control\":\"nct\",\"probe\":{\"radius\":3,\"length\":50},\"frames\":{\"G12\":{\"coarse\":[0,0,0]}}}",
            "G12",
        ),
        (
            "{\"control\":\"nct\",\"probe\":{\"radius\":3,\"length\":50},\"workpiece\":[{\"shape\":\"hole\",\"size\":[1],\"at\":[0,0,0]}]}",
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
    let schema = format!(
        "{}\n",
        serde_json::to_string_pretty(&setup_schema()).unwrap()
    );
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(docs("setup.schema.json"), &schema).unwrap();
    }
    assert_eq!(
        std::fs::read_to_string(docs("setup.schema.json")).unwrap(),
        schema
    );
}
