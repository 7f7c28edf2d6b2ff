//! The tools and the probe by the steps in which they are in use, and the tool probes.
#![allow(clippy::unwrap_used)]
use crate::json::asked;
use crate::json::asked::form;
use serde_json::{Value, json};

/// What is drawn of a call of CYCLE971 with these errors of the sliders.
fn drawn(values: Value, errors: Value) -> Value {
    let asked = json!({
        "control": "sinumerik", "cycle": "CYCLE971", "values": values, "predict": true, "errors": errors,
    });
    form(&asked.to_string()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The trace of a program on this machine.
fn run(text: &str, setup: Value) -> Value {
    let asked = json!({ "control": "sinumerik", "text": text, "setup": setup });
    asked::run(&asked.to_string()).unwrap()["trace"].clone()
}

/// What is drawn at each motion of a trace.
fn at_motions(trace: &Value) -> Vec<&Value> {
    let in_use = trace["inUse"].as_array().unwrap();
    let entries = trace["entries"].as_array().unwrap().iter().enumerate();
    let motions = entries.filter(|(_, entry)| entry["step"] == "motion");
    let last = |index: usize| {
        let until = |one: &&Value| number(&one[0]) <= index as f64;
        in_use.iter().rfind(until).unwrap()[1].as_u64().unwrap()
    };
    motions.map(|(index, _)| &trace["tools"][last(index) as usize]).collect()
}

/// A milling machine with this cutter as T1, 70 mm long, above a tool probe.
fn milling(cutter: Value) -> Value {
    let real = json!({ "length": [70.5, 0.0, 0.0], "cut": { "cutter": cutter } });
    json!({
        "control": "sinumerik", "plane": "G17", "probe": { "radius": 3.0, "length": 50.0 },
        "tools": { "1": { "edges": { "1": { "type": 120, "length": [70.0, 0.0, 0.0], "radius": 8.0,
            "real": real } } } },
        "toolProbes": [{ "solid": { "shape": "block", "size": [20.0, 20.0, 20.0], "at": [0.0, 0.0, -100.0] } }],
        "workpiece": [], "position": [0.0, 0.0, 100.0],
    })
}

#[test]
fn each_motion_has_the_plane_in_which_it_was_made() {
    // oracle: hand: the tool stands along Z in G17, along Y in G18
    let text = "G17 T1 D1 M6\nG0 Z60\nG18\nG0 Y60\nG17\nG0 Z80\nM30\n";
    let trace = run(text, milling(json!({ "radius": 8.0 })));
    let axes: Vec<&Value> = at_motions(&trace).iter().map(|tool| &tool["pieces"][0]["axis"]).collect();
    let [along_y, along_z] = [json!([0.0, 1.0, 0.0]), json!([0.0, 0.0, 1.0])];
    assert_eq!(axes, [&along_z, &along_y, &along_z]);
}

#[test]
fn a_length_that_is_corrected_leaves_the_tool_where_it_stands() {
    // oracle: hand: the tool is 0.5 mm longer than its data, which then are put right
    let text = "G17 T1 D1 M6\nG0 Z60\n$TC_DP3[1,1]=70.5\nG0 X5\nM30\n";
    let trace = run(text, milling(json!({ "radius": 8.0 })));
    let motions = at_motions(&trace);
    let end = |tool: &Value| number(&tool["length"][2]) - number(&tool["tip"][2]);
    assert_eq!(number(&motions[0]["tip"][2]), -0.5);
    assert_eq!(number(&motions[1]["tip"][2]), 0.0);
    assert_eq!(end(motions[0]), end(motions[1]));
}

#[test]
fn a_cutter_shows_its_teeth_where_they_stand_and_sweeps_when_it_turns() {
    // oracle: hand: four teeth at 0, 90, 180 and 270 degree, turned by 30 as M3 turns, clockwise from above; the
    // one at 90 lies 0.02 mm further out
    let text = "G17 T1 D1 M6\nSPOS=30\nG0 Z60\nM3 S500\nG0 Z70\nM30\n";
    let cutter = json!({ "radius": 8.0, "teeth": 4, "runout": [0.02, 0.0], "runoutAngle": 90.0 });
    let trace = run(text, milling(cutter));
    let motions = at_motions(&trace);
    let [standing, turning] = [&motions[0]["pieces"], &motions[1]["pieces"]];
    let reach = |piece: &Value| {
        let corners = piece["corners"].as_array().unwrap().iter();
        let far = corners.map(|at| (number(&at[0]), number(&at[1])));
        far.max_by(|a, b| a.0.hypot(a.1).total_cmp(&b.0.hypot(b.1))).unwrap()
    };
    let (x, y) = reach(&standing[2]);
    let angle = y.atan2(x).to_degrees();
    assert!((angle - 60.0).abs() < 1e-9 && (x.hypot(y) - 8.02).abs() < 1e-9);
    assert_eq!(standing.as_array().unwrap().len(), 5, "core and teeth");
    let widest = turning.as_array().unwrap().iter().map(|piece| {
        let outline = piece["outline"].as_array().unwrap().iter();
        outline.map(|at| number(&at[0])).fold(0.0, f64::max)
    });
    assert!((widest.fold(0.0, f64::max) - 8.02).abs() < 1e-9);
}

#[test]
fn tool_and_probe_are_drawn_where_they_are() {
    // oracle: hand: a cylinder of 5 mm with its end at the position; the probe stands 0.2 mm beside its data
    let values = json!({ "_MVAR": "0", "_MA": "1", "_FA": "3", "_TSA": "1" });
    let view = drawn(values, json!({ "part": { "dx": 0.2 } }));
    let trace = &view["outcome"]["trace"];
    assert_eq!(trace["inUse"], json!([[0, 0]]));
    let mill = &trace["tools"][0]["pieces"][0];
    assert_eq!(mill["axis"], json!([0.0, 0.0, 1.0]));
    assert_eq!(mill["at"], json!([0.0, 0.0, 0.0]));
    let outline = mill["outline"].as_array().unwrap();
    assert!(outline.contains(&json!([5.0, 0.0])), "{outline:?}");
    assert_eq!(trace["toolProbes"][0]["errors"]["shift"][0], 0.2);
    let results = view["outcome"]["results"].as_array().unwrap();
    let difference = results.iter().find(|result| result["name"] == "_OVR[9]");
    assert!((number(&difference.unwrap()["value"]) - 0.2).abs() < 1e-9);
}

#[test]
fn a_wider_tool_is_measured_as_wide_as_the_slider_makes_it() {
    // oracle: hand: 5 mm in the data, 0.1 mm more in truth
    let values = json!({ "_MVAR": "1", "_MA": "1", "_ID": "0", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" });
    let view = drawn(values, json!({ "probe": { "radius": 0.1 } }));
    let results = view["outcome"]["results"].as_array().unwrap();
    let radius = results.iter().find(|result| result["name"] == "_OVR[10]");
    assert!((number(&radius.unwrap()["value"]) - 5.1).abs() < 1e-9);
}

#[test]
fn a_longer_tool_is_measured_as_long_as_the_slider_makes_it() {
    // oracle: hand: 70 mm in the data, 0.15 mm more in truth
    let values = json!({ "_MVAR": "1", "_MA": "3", "_ID": "0", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" });
    let view = drawn(values, json!({ "probe": { "skewX": 0.15 } }));
    let results = view["outcome"]["results"].as_array().unwrap();
    let length = results.iter().find(|result| result["name"] == "_OVR[8]");
    assert!((number(&length.unwrap()["value"]) - 70.15).abs() < 1e-9);
}

#[test]
fn the_probe_of_a_turret_lies_where_its_position_says_in_every_plane() {
    // oracle: manual B:4152, B:974-1022 (5 and 7 stand on G17, 6 and 8 on G19; 7 and 8 point in minus direction)
    for (tip, axis) in [(5, [0.0, 0.0, -1.0]), (6, [-1.0, 0.0, 0.0]), (7, [0.0, 0.0, 1.0]), (8, [1.0, 0.0, 0.0])] {
        let edge = json!({ "1": { "type": 580, "tip": tip, "length": [60.0, 40.0, 50.0], "radius": 3.0 } });
        let setup = json!({
            "control": "sinumerik", "plane": "G18", "probe": { "radius": 3.0, "length": 50.0 },
            "tools": { "8": { "edges": edge } }, "workpiece": [], "position": [100.0, 0.0, 100.0],
        });
        let trace = run("T8 D1\nG0 X100\nG17\nG0 X110\nG19\nG0 X120\nM30\n", setup);
        let motions = at_motions(&trace);
        assert_eq!(motions.len(), 3);
        for motion in motions {
            assert_eq!(motion["ball"], json!(axis), "{tip}");
        }
    }
}

#[test]
fn a_program_shows_what_it_takes_into_the_turret() {
    // oracle: hand: T8, a probe (B:974-985), then T1, a turning tool; X counts as a diameter
    let edge = |kind: i64, tip: i64| {
        json!({ "1": { "type": kind, "tip": tip, "length": [60.0, 40.0, 0.0],
        "radius": 0.8 } })
    };
    let trace = run(
        "G18 DIAMON\nT8 D1\nG0 X100 Z50\nT1 D1\nG0 X120 Z60\nM30\n",
        json!({
            "control": "sinumerik", "plane": "G18", "probe": { "radius": 3.0, "length": 50.0 },
            "tools": { "8": { "edges": edge(580, 7) }, "1": { "edges": edge(500, 3) } },
            "workpiece": [{ "shape": "turned", "size": [40.0, 60.0, 0.0, 0.0], "at": [0.0, 0.0, 0.0] }],
            "position": [100.0, 0.0, 100.0],
        }),
    );
    assert_eq!(trace["turning"], true);
    assert_eq!(trace["drawing"]["reading"]["diameter"], true);
    let shown: Vec<bool> = trace["tools"].as_array().unwrap().iter().map(|tool| tool["ball"].is_array()).collect();
    assert_eq!(shown, [true, false]);
    let entries = trace["entries"].as_array().unwrap();
    let in_use = trace["inUse"].as_array().unwrap();
    for (change, tool) in in_use.iter().zip([8, 1]) {
        let entry = &entries[change[0].as_u64().unwrap() as usize];
        assert_eq!((&entry["step"], &entry["tool"]), (&json!("tool"), &json!(tool)));
    }
}

#[test]
fn a_tool_that_is_measured_hangs_there_before_its_register_counts() {
    // oracle: hand: the tool of the register ends 80 mm below the spindle nose (C:1258: the macro works in G49)
    let asked = json!({
        "control": "nct", "cycle": "G65 P9920", "predict": true,
        "values": { "Z": "-8", "D": "12", "T": "1" },
    });
    let view = form(&asked.to_string()).unwrap();
    let tools = view["outcome"]["trace"]["tools"].as_array().unwrap();
    assert!(tools.len() > 1, "the register is selected on the way");
    for tool in tools {
        assert_eq!(tool["pieces"][0]["outline"][1], json!([6.0, 0.0]));
        assert_eq!(number(&tool["tip"][2]), -80.0 + number(&tool["length"][2]));
    }
}

#[test]
fn each_edge_position_brings_its_insert() {
    // oracle: hand: the nose of 2 mm of the tool that the call brings (B:9049) lies at its end in both axes
    let asked = json!({
        "control": "sinumerik", "cycle": "CYCLE972", "predict": true,
        "values": { "_MVAR": "1", "_MA": "1", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" },
        "setup": { "own": { "plane": "G18", "units": "G71" } },
    });
    let view = form(&asked.to_string()).unwrap();
    let tool = &view["outcome"]["trace"]["tools"][0];
    let pieces = tool["pieces"].as_array().unwrap();
    assert_eq!(pieces.len(), 2, "insert and shank");
    let lowest = |piece: &Value, axis: usize| {
        let corners = piece["corners"].as_array().unwrap().iter();
        corners.map(|corner| number(&corner[axis])).fold(f64::INFINITY, f64::min)
    };
    for axis in [0, 2] {
        assert!(lowest(&pieces[0], axis).abs() < 0.01, "{pieces:?}");
        assert!(lowest(&pieces[1], axis) > 2.0, "{pieces:?}");
    }
    assert_eq!(tool["carrier"].as_array().unwrap().len(), 2, "holder and disc");
}
