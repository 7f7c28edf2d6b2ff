//! Tool probes and tools as they really are in the setup file.

use crate::json::{document, setup_from_json};
use serde_json::{Value, json};

fn setup() -> Value {
    json!({
        "control": "sinumerik",
        "probe": { "radius": 3.0, "length": 50.0 },
        "tools": { "3": { "edges": {
            "1": {
                "type": 120, "length": [70.0, 0.0, 0.0], "radius": 18.0,
                "real": { "length": [70.85, 0.0, 0.0], "cut": { "cutter": {
                    "radius": 18.6, "corner": 1.0, "chamfer": [0.5, 2.4], "teeth": 3, "angle": 15.0,
                    "runout": [0.02, 0.01], "runoutAngle": 30.0, "axis": 1, "disc": 5.0
                } } }
            },
            "2": {
                "type": 500, "tip": 3, "length": [70.0, 40.0, 0.0], "radius": 0.8,
                "real": { "length": [70.1, 40.2, 0.0], "cut": { "nose": { "radius": 0.79, "side": [-1.0, -1.0] } } }
            }
        } } },
        "toolProbes": [
            { "solid": { "shape": "block", "size": [20.0, 20.0, 15.0], "at": [39.0, 31.0, 80.0] },
                "preTravel": 0.01 },
            { "solid": { "shape": "turned", "size": [20.0, 15.0, 0.0, 0.0], "at": [139.0, 31.0, 80.0] },
              "delay": 0.001, "repeatability": [0.001, 7] }
        ]
    })
}

#[test]
fn tools_and_tool_probes_read_back_as_written() {
    // oracle: self: reading what was written gives the same setup
    let read = setup_from_json(&setup().to_string()).unwrap();
    assert_eq!((read.tool_probes.len(), read.real_tools.len()), (2, 2));
    let again = setup_from_json(&document(&read).to_string()).unwrap();
    assert_eq!(again, read);
}

#[test]
fn what_cannot_be_is_refused() {
    // oracle: hand
    for (place, wrong) in [
        ("/toolProbes/0/solid/shape", json!("sphere")),
        ("/toolProbes/1/solid/size", json!([20.0, 15.0, 8.0, 5.0])),
        ("/tools/3/edges/1/real/cut/cutter/radius", json!(-1.0)),
        ("/tools/3/edges/1/real/cut/cutter/corner", json!(30.0)),
        ("/tools/3/edges/1/real/cut/cutter/teeth", json!(1000)),
        ("/tools/3/edges/1/real/cut/cutter/axis", json!(3)),
        ("/tools/3/edges/2/real/cut/nose/side", json!([0.5, 0.0])),
    ] {
        let mut setup = setup();
        *setup.pointer_mut(place).unwrap() = wrong;
        assert!(setup_from_json(&setup.to_string()).is_err(), "{place}");
    }
}
