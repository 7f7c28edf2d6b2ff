//! Machines of their own: inches.

use super::inch_machine;
use crate::json::asked::*;
use crate::json::*;
use serde_json::json;

// oracle: manual B:13596 (data converted), B:1787-1795 (units of the fields)
#[test]
fn an_inch_machine_goes_over_the_wire() {
    let setup = setup_from_json(&inch_machine().to_string()).unwrap();
    assert_eq!(setup.control.basic_length("_WP[0,0]"), 6.0);
    assert_eq!(setup.control.unit_function() as u16, 70);
    let written = document(&setup);
    assert_eq!((&written["units"], &written["active"]["units"]), (&json!("inch"), &json!("G70")));
    let again = setup_from_json(&written.to_string()).unwrap().control;
    assert_eq!((again.basic_units, again.unit_function() as u16), (setup.control.basic_units, 70));
    assert_eq!(again.environments, setup.control.environments);
    assert_eq!(again.environments["ROUGH"].tool, 20);
    for (name, value) in setup.control.data.iter() {
        let read = again.number(name);
        assert!((read - setup.control.number(name)).abs() < 1e-12, "{name}: {value:?} {read}");
    }

    let ask = |units: &str| {
        let request = json!({ "control": "sinumerik", "cycle": "CYCLE978", "values": { "_MVAR": "0" },
            "setup": inch_machine(), "units": units });
        let view = form(&request.to_string()).unwrap();
        let fields = view["fields"].as_array().unwrap().clone();
        ["_SETVAL", "_TSA", "_FA"]
            .map(|name| fields.iter().find(|field| field["name"] == name).unwrap()["unit"].clone())
    };
    assert_eq!(ask("G700"), ["inch", "inch", "mm"]);
    assert_eq!(ask("G71"), ["mm", "inch", "mm"]);
}

// oracle: manual B:1787-1795, B:13596: the core's own machine may be an inch machine, and may begin in mm
#[test]
fn the_own_machine_may_be_built_for_inches() {
    let request = json!({
        "control": "sinumerik",
        "cycle": "CYCLE978",
        "values": { "_MVAR": "100", "_SETVAL": "0", "_MA": "1", "_KNUM": "0" },
        "setup": { "own": { "basic": "inch", "units": "G71" } },
        "predict": true,
    });
    let view = form(&request.to_string()).unwrap();
    let fields = view["fields"].as_array().unwrap();
    let unit = |name: &str| fields.iter().find(|field| field["name"] == name).unwrap()["unit"].clone();
    assert_eq!((unit("_SETVAL"), unit("_TSA")), (json!("mm"), json!("inch")));
    assert_eq!(view["setup"]["units"], "inch");
    assert_eq!(view["setup"]["active"]["units"], "G71");
    assert_eq!(view["outcome"]["alarms"], json!([]));
}
