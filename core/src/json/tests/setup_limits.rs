//! What a setup file may ask for: a machine, a probe and a part that can exist, and names that the control knows.

use crate::words::Words;
use serde_json::{Value, json};

fn example() -> Value {
    serde_json::from_str(include_str!("../../../../docs/setup.example.json")).unwrap()
}

fn refused(path: &str, value: Value) -> String {
    let mut file = example();
    *file.pointer_mut(path).unwrap() = value;
    match crate::json::setup_from_json(&file.to_string()) {
        Ok(_) => String::new(),
        Err(error) => Words::english().text(&error.message),
    }
}

// oracle: hand
#[test]
fn a_bore_lies_within_its_part() {
    let turned = |size: [f64; 4]| {
        let part = json!({ "shape": "turned", "size": size, "at": [0, 0, 0] });
        refused("/workpiece/0", part)
    };
    assert_eq!(turned([60.0, 80.0, 0.0, 0.0]), "");
    assert_eq!(turned([60.0, 80.0, 40.0, 30.0]), "");
    for size in [[60.0, 80.0, 60.0, 30.0], [60.0, 80.0, 40.0, 80.0], [60.0, 80.0, 40.0, 0.0]] {
        assert!(turned(size).contains("bore"), "{size:?}");
    }
    assert!(turned([60.0, 80.0, -40.0, 30.0]).contains("workpiece[0].size"));
}

// oracle: hand
#[test]
fn what_cannot_be_is_refused_by_name() {
    let solid = example()["workpiece"][0].clone();
    for (path, value, told) in [
        ("/probe/radius", json!(0), "probe.radius"),
        ("/workpiece/0/shape", json!("surface"), "Surface"),
        (
            "/workpiece/0",
            json!({ "shape": "hole", "size": [1, 1], "at": [0, 0, 0], "surface": { "triangles": [] } }),
            "Hole",
        ),
        (
            "/workpiece/0",
            json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "triangles": [] } }),
            "no triangles",
        ),
        (
            "/workpiece/0",
            json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "heights": { "columns": 0, "step": [1, 1],
                "values": [] } } }),
            "grid",
        ),
        (
            "/workpiece/0",
            json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "moon", "size": [1, 1,
                1] } } }),
            "moon",
        ),
        (
            "/workpiece/0",
            json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "dome", "size": [1, 0,
                1] } } }),
            "surface.size",
        ),
        ("/probe/radius", json!(-3), "probe.radius"),
        ("/probe/length", json!(1e300), "probe.length"),
        ("/position", json!([0, 1e7, 0]), "position"),
        ("/frames/G54/coarse", json!([1e308, 0, 0]), "G54"),
        ("/frames", json!({ "$P_CHBFR[16]": { "coarse": [0, 0, 0] } }), "$P_CHBFR"),
        ("/frames", json!({ "G999": { "coarse": [0, 0, 0] } }), "G999"),
        ("/tools/20/edges/1/radius", json!(-1e9), "tool 20, edge 1"),
        ("/active/tool", json!(77), "T77 D1"),
        ("/active/edge", json!(5), "T9 D5"),
        ("/data", json!({ "_NOTHING": 1 }), "_NOTHING"),
        ("/data", json!({ "_WP[0]": 1 }), "_WP[0]"),
        ("/data", json!({ "_WP[99,0]": 1 }), "_WP[99,0]"),
        ("/data", json!({ "R1000": 1 }), "R1000"),
        ("/data", json!({ "_FA": "wide" }), "_FA"),
        ("/data", json!({ "": 1 }), "data item"),
        ("/workpiece", json!(vec![solid; 51]), "51"),
        ("/workpiece/0/size", json!([0, 40]), "workpiece[0].size"),
        ("/workpiece/0/size", json!([132, -40]), "workpiece[0].size"),
        ("/workpiece/0/errors", json!({ "size": -200 }), "-68"),
        ("/workpiece/0/errors", json!({ "taper": -10 }), "bottom"),
        ("/workpiece/0/errors", json!({ "outOfRound": [0.1, 4_294_967_295_u32] }), "lobes"),
        ("/workpiece/0/errors", json!({ "outOfRound": [70, 3] }), "amplitude"),
        ("/workpiece/0/errors", json!({ "tilt": [0, 1e300, 0] }), "tilt"),
    ] {
        let error = refused(path, value.clone());
        assert!(error.contains(told), "{path} {value}: {error:?}");
    }
}

// oracle: hand
#[test]
fn what_can_be_is_taken() {
    for (path, value) in [
        ("/data", json!({ "_WP[98,10]": 1, "R999": 2, "MD18600": 0, "_TNAME": "MILL", "_PROTNAME[1]": "LOG" })),
        ("/data", json!({ "TOOLENV[ENV,T]": 20 })),
        ("/active", json!({ "tool": 0, "edge": 0 })),
        ("/workpiece/0/errors", json!({ "outOfRound": [0.1, 5], "size": -1, "taper": 0.01 })),
        (
            "/workpiece/0",
            json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "dome", "size": [60, 40,
                10] } } }),
        ),
    ] {
        assert_eq!(refused(path, value.clone()), "", "{path} {value}");
    }
}
