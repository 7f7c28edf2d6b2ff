//! A turned part as a drawing has it.
#![allow(clippy::unwrap_used)]
use crate::json::asked::form;
use serde_json::{Value, json};

/// The drawing of a call of CYCLE974 about a part of 45 mm with these errors of the sliders.
fn drawn(part: Value) -> Value {
    let values = json!({
        "_MVAR": "0", "_MA": "2", "_SETVAL": "45", "_FA": "3", "_TSA": "3", "_TUL": "2", "_TLL": "-2", "_KNUM": "0",
    });
    let asked = json!({
        "control": "sinumerik", "cycle": "CYCLE974", "values": values, "predict": true,
        "setup": { "own": { "plane": "G18", "units": "G71" } }, "errors": { "part": part },
    });
    form(&asked.to_string()).unwrap()["outcome"]["trace"]["drawing"].clone()
}

fn close(value: &Value, wanted: f64) {
    assert!((value.as_f64().unwrap() - wanted).abs() < 1e-9, "{value} {wanted}");
}

#[test]
fn a_step_has_its_diameter_and_where_it_was_touched_too() {
    // oracle: hand: 45 mm and 0.2 more; touched at its plus side, 0.1 mm further out by the displacement
    let drawing = drawn(json!({ "size": 0.2, "dx": 0.1 }));
    let [diameter] = &drawing["diameters"].as_array().unwrap()[..] else {
        unreachable!("{drawing}");
    };
    close(&diameter["set"], 45.0);
    close(&diameter["real"], 45.2);
    let [low, high] = [0, 1].map(|end| &diameter["ends"][end][0]);
    close(low, 0.1 - 22.6);
    close(high, 0.1 + 22.6);
    let touched = drawing["touched"].as_array().unwrap();
    assert!(!touched.is_empty());
    for touch in touched {
        close(&touch["diameter"], 45.4);
    }
    assert_eq!(drawing["reading"]["diameter"], true);
}

#[test]
fn a_cone_has_two_diameters() {
    // oracle: hand: 0.01 mm each mm over 60 mm of length
    let drawing = drawn(json!({ "taper": 0.01 }));
    let real = |index: usize| &drawing["diameters"][index]["real"];
    close(real(0), 45.0);
    close(real(1), 45.6);
}

#[test]
fn a_milling_machine_has_no_such_drawing() {
    let asked = json!({
        "control": "sinumerik", "cycle": "CYCLE977", "values": { "_MVAR": "1", "_SETVAL": "40" }, "predict": true,
    });
    let view = form(&asked.to_string()).unwrap();
    assert_eq!(view["outcome"]["trace"]["drawing"], Value::Null);
}
