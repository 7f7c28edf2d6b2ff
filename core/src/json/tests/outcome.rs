//! What a form foretells: the run, the scene, the largest errors.

use super::{asked, request};
use crate::catalogue::example::{example, turned};
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::json::asked::*;
use crate::json::*;
use crate::machine::Setup;
use serde_json::json;

// oracle: hand: three spheres turned together by 0.1 degree about Z, and nothing else, about the first one
#[test]
fn solids_of_one_part_are_tilted_together() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE997").unwrap();
    let mut document: Value = serde_json::from_str(&request(cycle)).unwrap();
    document["errors"] = json!({ "part": { "tilt": 0.1 } });
    let view = form(&document.to_string()).unwrap();
    let changes = view["outcome"]["changes"].as_array().unwrap();
    let turned = changes.iter().filter(|change| change["unit"] == "deg").collect::<Vec<_>>();
    assert_eq!(turned.len(), 1, "{changes:?}");
    assert_eq!(turned[0]["name"], "$P_UIFR[1,Z,RT]");
    assert!((turned[0]["after"].as_f64().unwrap() - 0.1).abs() < 1e-9);
}

// oracle: hand: a hole that is smaller than its error has no wall, a ball of 3 mm less 5 no surface
#[test]
fn errors_that_leave_nothing_are_told() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    for errors in [
        json!({ "part": { "size": -500 } }),
        json!({ "part": { "dx": -6e114 } }),
        json!({ "part": { "taper": 1e308 } }),
        json!({ "part": { "outOfRound": 90 } }),
        json!({ "probe": { "radius": -5 } }),
    ] {
        let mut document: Value = serde_json::from_str(&request(cycle)).unwrap();
        document["errors"] = errors.clone();
        let view = form(&document.to_string()).unwrap();
        let alarms = &view["outcome"]["alarms"];
        assert_eq!(alarms[0]["message"]["key"], "run-errors", "{errors}");
    }
}

// oracle: hand: nobody measures a thousand times at a keystroke
#[test]
fn a_call_that_measures_without_end_is_given_up() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE978").unwrap();
    let mut document: Value = serde_json::from_str(&request(cycle)).unwrap();
    document["values"]["_NMSP"] = "999999".into();
    let view = form(&document.to_string()).unwrap();
    let alarms = &view["outcome"]["alarms"];
    assert_eq!(alarms[0]["message"]["key"], "run-trace-limit");
    let entries = view["outcome"]["trace"]["entries"].as_array().unwrap();
    assert!(entries.len() <= 5000);
}

// oracle: hand
#[test]
fn every_worked_example_is_complete_and_reaches_its_end() {
    for cycle in crate::catalogue::CYCLES {
        let view = form(&request(cycle)).unwrap();
        assert_eq!(view["complete"], true, "{}: {}", cycle.name, view["diagnostics"]);
        if cycle.simulation.is_none() {
            assert_eq!(view["outcome"], Value::Null, "{}", cycle.name);
            continue;
        }
        for variant in cycle.variants {
            for plane in [Plane::G17, Plane::G18, Plane::G19] {
                reaches_its_end(cycle, variant, plane);
            }
        }
    }
}

fn reaches_its_end(cycle: &'static crate::entry::Cycle, variant: &crate::entry::Variant, plane: Plane) {
    let what = format!("{} {} {plane:?}", cycle.name, variant.number);
    let values = turned(cycle, &example(cycle, variant), plane);
    let mut document: Value = serde_json::from_str(&asked(cycle, &values)).unwrap();
    document["setup"] = json!({ "own": { "plane": plane } });
    let view = form(&document.to_string()).unwrap();
    assert_eq!(view["complete"], true, "{what}: {}", view["diagnostics"]);
    let alarms = view["outcome"]["alarms"].as_array().unwrap();
    assert!(alarms.iter().all(|alarm| alarm["stops"] == false), "{what}: {alarms:?}");
    let entries = view["outcome"]["trace"]["entries"].as_array().unwrap();
    let moves = entries.iter().any(|entry| entry["step"] == "motion");
    assert_eq!(moves, cycle.purpose.probe.measures(), "{what}");
    assert!(setup_from_json(&view["setup"].to_string()).is_ok(), "{what}");
    let shapes = view["picture"]["shapes"].as_array().unwrap();
    assert!(!shapes.is_empty(), "{what}");
}

// oracle: manual B:762-817 (the applicate of G18 is Y, of G19 X; the tool stands along it)
#[test]
fn the_stylus_stands_along_the_applicate() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    for (plane, axis) in [("G17", [0.0, 0.0, 1.0]), ("G18", [0.0, 1.0, 0.0]), ("G19", [1.0, 0.0, 0.0])] {
        asked["setup"] = json!({ "own": { "plane": plane } });
        let view = form(&asked.to_string()).unwrap();
        let probe = &view["outcome"]["trace"]["tools"][0];
        assert_eq!(probe["ball"], json!(axis), "{plane}");
        assert_eq!(view["setup"]["plane"], json!(plane));
    }
}

// oracle: manual B:4148-4152 (with SD 42950 = 2 the probe stands on G17 and on G19; nothing stands on G18, 61309)
#[test]
fn a_turning_machine_measures_with_a_probe_that_stands_on_the_plane_of_the_call() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["setup"] = json!({ "own": { "plane": "G17", "data": { "SD42950": 2.0 } } });
    for (plane, axis, alarms) in [("G17", [0.0, 0.0, 1.0], 0), ("G19", [1.0, 0.0, 0.0], 0), ("G18", [0.0, 0.0, 1.0], 1)]
    {
        asked["plane"] = json!(plane);
        let view = form(&asked.to_string()).unwrap();
        let outcome = &view["outcome"];
        assert_eq!(outcome["trace"]["tools"][0]["ball"], json!(axis), "{plane}");
        assert_eq!(outcome["alarms"].as_array().unwrap().len(), alarms, "{plane} {outcome}");
    }
}

// oracle: manual B:4152, B:13474-13481 (in G18 position 7 lies along Z and points in minus direction, 8 along X)
#[test]
fn the_stylus_of_a_turning_machine_lies_as_its_cutting_edge_position_says() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE974").unwrap();
    for (tip, axis) in [(5, [0.0, 0.0, -1.0]), (6, [-1.0, 0.0, 0.0]), (7, [0.0, 0.0, 1.0]), (8, [1.0, 0.0, 0.0])] {
        let mut setup = Setup::for_variant(cycle, 0, Plane::G18);
        let edge = setup.control.edge_of_mut(9, 1).unwrap();
        edge.tip = tip;
        let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
        asked["setup"] = document(&setup);
        let view = form(&asked.to_string()).unwrap();
        assert_eq!(view["outcome"]["trace"]["tools"][0]["ball"], json!(axis), "{tip}");
    }
}

// oracle: hand (errors belong to the part; a post stands in the zone, which is drawn)
#[test]
fn what_stands_in_a_protection_zone_has_no_errors() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    for (name, value) in [("_MVAR", "1001"), ("_SZA", "60"), ("_ID", "-20")] {
        asked["values"][name] = json!(value);
    }
    let trace = form(&asked.to_string()).unwrap()["outcome"]["trace"].take();
    let [part, post] = trace["solids"].as_array().unwrap().as_slice() else {
        unreachable!("{}", trace["solids"]);
    };
    assert_eq!((&part["shape"], &post["shape"]), (&json!("hole"), &json!("shaft")));
    assert_eq!((&part["errors"]["size"], &post["errors"]["size"]), (&json!(0.03), &json!(0.0)));
    assert_eq!(trace["zones"][0]["size"][0], json!(60.0));
    assert!(post["size"][0].as_f64() < Some(60.0), "{post}");
}

// oracle: hand: G500 is active and G54 is corrected, by a rotation alone: both are drawn, the second before and after
#[test]
fn a_corrected_frame_is_drawn_before_and_after() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE998").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["values"]["_RA"] = json!("0");
    asked["errors"] = json!({ "part": { "tilt": 1.0 } });
    let trace = form(&asked.to_string()).unwrap()["outcome"]["trace"].take();
    let frames = trace["frames"].as_array().unwrap();
    let told = |frame: &Value| json!([frame["name"], frame["moved"]]);
    let told: Vec<Value> = frames.iter().map(told).collect();
    let expected = json!([["G500", null], ["G54", "before"], ["G54", "after"]]);
    assert_eq!(json!(told), expected);
    assert_eq!(frames[1]["at"], frames[2]["at"]);
    assert_ne!(frames[1]["axes"], frames[2]["axes"]);
}

// oracle: self (the limits that are told: measured there it comes to its end, a little beyond it does not)
#[test]
fn the_largest_errors_are_those_that_still_come_to_an_end() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["limits"] = json!(true);
    let view = form(&asked.to_string()).unwrap();
    let limits = view["outcome"]["limits"].as_array().unwrap();
    let names: Vec<&Value> = limits.iter().map(|limit| &limit["error"]).collect();
    assert_eq!(names, ["size", "dx", "dy", "dz"]);
    for limit in limits.iter().take(3) {
        let name = limit["error"].as_str().unwrap();
        for (side, out) in [("low", -0.01), ("high", 0.01)] {
            let error = limit[side].as_f64().unwrap();
            let stopped = |error: f64| {
                let mut asked = asked.clone();
                asked["limits"] = json!(false);
                asked["errors"]["part"][name] = json!(error);
                let view = form(&asked.to_string()).unwrap();
                let alarms = view["outcome"]["alarms"].as_array().unwrap().clone();
                alarms.iter().any(|alarm| alarm["stops"] == json!(true))
            };
            assert!(!stopped(error), "{name} {error}");
            assert!(stopped(error + out), "{name} {error}");
        }
    }
    let shown = view["outcome"]["trace"]["limits"].as_array().unwrap();
    assert_eq!((&shown[0]["errors"]["size"], &shown[1]["errors"]["size"]), (&limits[0]["low"], &limits[0]["high"]));
}

/// A program carried out to its end.
fn done(request: &Value) -> Value {
    run(&request.to_string()).unwrap()
}

/// A ring that is calibrated in, and a hole that is measured, on one machine.
fn two_calls() -> Value {
    let hole = |diameter: f64, x: f64| json!({ "shape": "hole", "size": [diameter, 40], "at": [x, 0, 0] });
    let edge = json!({ "type": 710, "length": [50, 0, 0], "radius": 3 });
    json!({
        "control": "sinumerik",
        "active": { "tool": 9, "edge": 1, "frame": "G54" },
        "tools": { "9": { "edges": { "1": edge } } },
        "probe": { "radius": 3, "length": 50 },
        "workpiece": [hole(80.0, 0.0), hole(60.0, 200.0)],
        "position": [0, 0, -10],
    })
}

// oracle: manual B:5675, B:15997-16010 (of a hole _OVR[0] is the diameter, of a calibration _OVR[12] a trigger point)
#[test]
fn results_of_a_program_name_the_call_that_left_them() {
    let text = "G17 G54 G90 T9 D1\nM6\n_PRNUM=1 _FA=4 _TSA=2 _TZL=0 _NMSP=1 _VMS=0\n\
        _MVAR=10101 _SETVAL=80\nCYCLE976\nG0 Z50\nX200\nZ-10\n_MVAR=101 _SETVAL=60 _KNUM=0\nCYCLE977\n\
        Z50\nX0\nZ-10\n_SETVAL=80\nCYCLE977\nM30\n";
    let request = json!({ "control": "sinumerik", "text": text, "setup": two_calls() });
    let view = done(&request);
    assert_eq!(view["diagnostics"], json!([]));
    let results = view["results"].as_array().unwrap();
    let found = |name: &str, line: Value| {
        let mut found = results.iter();
        let one = found.find(|one| one["name"] == name && one["line"] == line);
        one.cloned().unwrap_or_default()
    };
    let trigger = found("_OVR[12]", json!(5));
    assert_eq!(trigger["label"]["key"], "result-trigger-minus-ordinate");
    assert_eq!(trigger["cycle"], "CYCLE976");
    for (line, set) in [(10, 60.0), (15, 80.0)] {
        let size = found("_OVR[0]", json!(line));
        assert_eq!(size["label"]["key"], "result-set-size");
        assert_eq!((&size["cycle"], &size["unit"]), (&json!("CYCLE977"), &json!("mm")));
        assert_eq!(size["value"], json!(set), "each call its own");
    }
    let own = found("_SETVAL", Value::Null);
    assert_eq!(own["label"], Value::Null, "the program set it");
    let decided = view["decisions"].as_array().unwrap();
    assert!(decided.iter().all(|one| one["cycle"].is_string()), "{decided:?}");
}

// oracle: manual B:5675-5701 (_OVR[20] with tool offset only), B:1696 (data keep their values); hand (lines as written)
#[test]
fn what_an_earlier_call_left_is_told_as_that_of_its_line() {
    let text = "G17 G54 G90 T9 D1\nM6\n_PRNUM=1 _FA=4 _TSA=2 _TZL=0 _NMSP=1 _VMS=0 _SETVAL=79.98 _TNUM=20\n\
        _MVAR=1 _TUL=0.01 _TLL=-0.01 _TDIF=1 _K=1 _EVNUM=0 _TMV=0.5 _KNUM=2001 CYCLE977\n_MVAR=101 _KNUM=1\nCYCLE977\n\
        M30\n";
    let mut setup = two_calls();
    setup["tools"]["20"] = json!({ "edges": { "1": { "type": 120, "length": [60, 0, 0], "radius": 8 } } });
    let view = done(&json!({ "control": "sinumerik", "text": text, "setup": setup }));
    assert_eq!(view["finished"], true, "{}", view["diagnostics"]);
    let all = view["results"].as_array().unwrap();
    let lines = |name: &str| -> Vec<&Value> {
        let own = all.iter().filter(|one| one["name"] == name);
        own.map(|one| &one["line"]).collect()
    };
    // the second call leaves no amount of a tool, so that this one is the first call's alone
    assert_eq!(lines("_OVR[20]"), [&json!(4)], "{all:?}");
    assert_eq!(lines("_OVR[4]"), [&json!(4), &json!(6)]);
    assert_eq!(lines("_OVI[11]"), [&json!(6)]);
    let amount = all.iter().find(|one| one["name"] == "_OVR[20]").unwrap();
    assert_ne!(amount["value"], 0.0);
    assert_eq!(amount["label"]["key"], "result-compensation");
    // in a form: the probe meets nothing, so that no size was written
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["errors"] = json!({ "part": { "dx": 45.0 } });
    let outcome = form(&asked.to_string()).unwrap()["outcome"].take();
    let results = outcome["results"].as_array().unwrap();
    let named = |name: &str| results.iter().find(|one| one["name"] == name).unwrap();
    assert_eq!(named("_OVR[4]")["earlier"], 0, "{outcome}");
    assert_eq!(named("_OVI[2]")["earlier"], Value::Null);
}

// oracle: self (the place of the call, and the remedy of the alarm as `probewright alarms` tells it)
#[test]
fn an_alarm_of_a_program_is_told_at_its_call_with_what_to_do() {
    let text = "G17 G54 G90 T9 D1\nM6\n_MVAR=101 _SETVAL=90 _KNUM=0 _PRNUM=1 _FA=4 _TSA=2\n  CYCLE977\nM30\n";
    let request = json!({ "control": "sinumerik", "text": text, "setup": two_calls() });
    let view = done(&request);
    let told = view["diagnostics"].as_array().unwrap();
    let alarm = told.iter().find(|one| one["code"] == "61302").unwrap();
    assert_eq!((&alarm["line"], &alarm["column"]), (&json!(4), &json!(3)));
    assert_eq!(alarm["hint"]["key"], "alarm-61302.cure");
    let raised = &view["alarms"][0];
    assert_eq!((&raised["code"], &raised["line"], &raised["cycle"]), (&json!("61302"), &json!(4), &json!("CYCLE977")));
}
