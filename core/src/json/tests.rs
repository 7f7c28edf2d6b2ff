#![allow(clippy::unwrap_used)]
use super::*;
use crate::catalogue::ProbeUse;
use crate::check::Typed;
use crate::control::Plane;
use crate::run::setup::Setup;
use serde_json::json;
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
    assert_eq!(
        setup.control.transverse,
        crate::control::Transverse::Diameter
    );
    assert_eq!(setup.probe.false_signal, Some(12.5));
    let again = setup_from_json(&setup_to_json(&setup).to_string()).unwrap();
    assert_eq!(setup, again);
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

fn request(cycle: &crate::catalogue::Cycle) -> String {
    let values = cycle.example.iter();
    asked(
        cycle,
        &values
            .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()))
            .collect(),
    )
}

fn asked(cycle: &crate::catalogue::Cycle, values: &Typed) -> String {
    json!({
        "control": dialect_name(cycle.dialect),
        "cycle": cycle.name,
        "values": values,
        "predict": true,
        "errors": { "part": { "size": 0.03 } },
    })
    .to_string()
}

// oracle: hand: three spheres turned together by 0.1 degree about Z, and nothing else, about the first one
#[test]
fn solids_of_one_part_are_tilted_together() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE997").unwrap();
    let mut document: Value = serde_json::from_str(&request(cycle)).unwrap();
    document["errors"] = json!({ "part": { "tilt": 0.1 } });
    let view = form(&document.to_string()).unwrap();
    let changes = view["outcome"]["changes"].as_array().unwrap();
    let turned = changes
        .iter()
        .filter(|change| change["unit"] == "deg")
        .collect::<Vec<_>>();
    assert_eq!(turned.len(), 1, "{changes:?}");
    assert_eq!(turned[0]["name"], "$P_UIFR[1,Z,RT]");
    assert!((turned[0]["after"].as_f64().unwrap() - 0.1).abs() < 1e-9);
}

// oracle: hand
#[test]
fn every_worked_example_is_complete_and_reaches_its_end() {
    for cycle in crate::catalogue::CYCLES {
        let view = form(&request(cycle)).unwrap();
        assert_eq!(
            view["complete"], true,
            "{}: {}",
            cycle.name, view["diagnostics"]
        );
        if cycle.simulation.is_none() {
            assert_eq!(view["outcome"], Value::Null, "{}", cycle.name);
            continue;
        }
        for variant in cycle.variants {
            reaches_its_end(cycle, variant);
        }
    }
}

fn reaches_its_end(cycle: &'static crate::catalogue::Cycle, variant: &crate::catalogue::Variant) {
    let what = format!("{} {}", cycle.name, variant.number);
    let values = crate::catalogue::example::example(cycle, variant);
    let view = form(&asked(cycle, &values)).unwrap();
    assert_eq!(view["complete"], true, "{what}: {}", view["diagnostics"]);
    let alarms = view["outcome"]["alarms"].as_array().unwrap();
    assert!(
        alarms.iter().all(|alarm| alarm["stops"] == false),
        "{what}: {alarms:?}"
    );
    let entries = view["outcome"]["trace"]["entries"].as_array().unwrap();
    let moves = entries.iter().any(|entry| entry["step"] == "motion");
    assert_eq!(moves, cycle.purpose.probe != ProbeUse::None, "{what}");
    assert!(
        setup_from_json(&view["setup"].to_string()).is_ok(),
        "{what}"
    );
    let shapes = view["picture"]["shapes"].as_array().unwrap();
    assert!(!shapes.is_empty(), "{what}");
}

// oracle: hand
#[test]
fn a_form_without_values_has_fields_and_a_picture() {
    for cycle in crate::catalogue::CYCLES {
        let request =
            json!({ "control": dialect_name(cycle.dialect), "cycle": cycle.name }).to_string();
        let view = form(&request).unwrap();
        let blank = view["fields"].as_array().unwrap().is_empty();
        assert_eq!(blank, cycle.params.is_empty(), "{}", cycle.name);
        assert_eq!(view["outcome"], Value::Null);
    }
}

// oracle: manual B:762-817 (the applicate of G18 is Y, of G19 X; the tool stands along it)
#[test]
fn the_stylus_stands_along_the_applicate() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    for (plane, axis) in [
        ("G17", [0.0, 0.0, 1.0]),
        ("G18", [0.0, 1.0, 0.0]),
        ("G19", [1.0, 0.0, 0.0]),
    ] {
        asked["setup"] = json!({ "own": { "plane": plane } });
        let view = form(&asked.to_string()).unwrap();
        let probe = &view["outcome"]["trace"]["tools"][0];
        assert_eq!(probe["ball"], json!(axis), "{plane}");
        assert_eq!(view["setup"]["plane"], json!(plane));
    }
}

// oracle: manual B:4152, B:13474-13481 (in G18 position 7 lies along Z and points in minus direction, 8 along X)
#[test]
fn the_stylus_of_a_turning_machine_lies_as_its_cutting_edge_position_says() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE974").unwrap();
    for (tip, axis) in [
        (5, [0.0, 0.0, -1.0]),
        (6, [-1.0, 0.0, 0.0]),
        (7, [0.0, 0.0, 1.0]),
        (8, [1.0, 0.0, 0.0]),
    ] {
        let mut setup = Setup::for_variant(cycle, 0, Plane::G18);
        let edge = setup.control.edge_of_mut(9, 1).unwrap();
        edge.tip = tip;
        let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
        asked["setup"] = setup_to_json(&setup);
        let view = form(&asked.to_string()).unwrap();
        assert_eq!(
            view["outcome"]["trace"]["tools"][0]["ball"],
            json!(axis),
            "{tip}"
        );
    }
}

// oracle: manual B:1787-1795 (set values count in the active system, _FA always in mm)
#[test]
fn the_chosen_units_decide_what_a_value_means() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["setup"] = json!({ "own": { "units": "G70" } });
    asked["values"]["_SETVAL"] = json!("2");
    let view = form(&asked.to_string()).unwrap();
    let unit = |name: &str| {
        let fields = view["fields"].as_array().unwrap();
        let field = fields.iter().find(|field| field["name"] == name).unwrap();
        field["unit"].clone()
    };
    assert_eq!((unit("_SETVAL"), unit("_FA")), (json!("inch"), json!("mm")));
    assert_eq!(
        view["outcome"]["trace"]["solids"][0]["size"][0],
        json!(50.8)
    );
    assert_eq!(view["setup"]["active"]["units"], "G70");
    let text = view["snippet"].as_str().unwrap();
    let read = |machine: Value| json!({ "control": "sinumerik", "text": text, "setup": machine });
    let calls = super::read(&read(json!({ "own": { "units": "G70" } })).to_string()).unwrap();
    assert_eq!(calls["calls"][0]["units"], "G70");
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
    assert_eq!(
        (&part["shape"], &post["shape"]),
        (&json!("hole"), &json!("shaft"))
    );
    assert_eq!(
        (&part["errors"]["size"], &post["errors"]["size"]),
        (&json!(0.03), &json!(0.0))
    );
    assert_eq!(trace["zones"][0]["size"][0], json!(60.0));
    assert!(post["size"][0].as_f64() < Some(60.0), "{post}");
}

// oracle: hand: G500 is in force and G54 is corrected, by a rotation alone: both are drawn, the second before and after
#[test]
fn a_corrected_frame_is_drawn_before_and_after() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE998").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    asked["values"]["_RA"] = json!("0");
    asked["errors"] = json!({ "part": { "tilt": 1.0 } });
    let trace = form(&asked.to_string()).unwrap()["outcome"]["trace"].take();
    let frames = trace["frames"].as_array().unwrap();
    let names: Vec<&str> = frames
        .iter()
        .map(|frame| frame["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["WCS G500", "WCS G54", "WCS G54′"]);
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
    assert_eq!(
        (&shown[0]["errors"]["size"], &shown[1]["errors"]["size"]),
        (&limits[0]["low"], &limits[0]["high"])
    );
}

/// An inch machine as the page would import it.
fn inch_machine() -> Value {
    json!({
        "control": "sinumerik",
        "units": "inch",
        "active": { "tool": 9, "edge": 1 },
        "environments": { "ROUGH": { "tool": 20, "edge": 1, "plane": "G18" } },
        "tools": { "9": { "edges": { "1": { "type": 710, "length": [50, 0, 0], "radius": 3 } } } },
        "probe": { "radius": 3, "length": 50 },
    })
}

// oracle: manual B:13596 (data converted), B:1787-1795 (units of the fields)
#[test]
fn an_inch_machine_goes_over_the_wire() {
    let setup = setup_from_json(&inch_machine().to_string()).unwrap();
    assert_eq!(setup.control.basic_length("_WP[0,0]"), 6.0);
    assert_eq!(setup.control.unit_function(), 70);
    let written = setup_to_json(&setup);
    assert_eq!(
        (&written["units"], &written["active"]["units"]),
        (&json!("inch"), &json!("G70"))
    );
    let again = setup_from_json(&written.to_string()).unwrap().control;
    assert_eq!(
        (again.basic_units, again.unit_function()),
        (setup.control.basic_units, 70)
    );
    assert_eq!(again.environments, setup.control.environments);
    assert_eq!(again.environments["ROUGH"].tool, 20);
    for (name, value) in setup.control.data.iter() {
        let read = again.number(name);
        assert!(
            (read - setup.control.number(name)).abs() < 1e-12,
            "{name}: {value:?} {read}"
        );
    }

    let ask = |units: &str| {
        let request = json!({ "control": "sinumerik", "cycle": "CYCLE978", "values": { "_MVAR": "0" }, "setup": inch_machine(), "units": units });
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
    let unit =
        |name: &str| fields.iter().find(|field| field["name"] == name).unwrap()["unit"].clone();
    assert_eq!(
        (unit("_SETVAL"), unit("_TSA")),
        (json!("mm"), json!("inch"))
    );
    assert_eq!(view["setup"]["units"], "inch");
    assert_eq!(view["setup"]["active"]["units"], "G71");
    assert_eq!(view["outcome"]["alarms"], json!([]));
}

// oracle: hand
#[test]
fn a_call_says_in_which_units_and_plane_it_stands() {
    let text = "G18 G700\n_SETVAL=2 _MVAR=0\nCYCLE978\nG17 G71\nCYCLE978\n";
    let request = json!({ "control": "sinumerik", "text": text, "setup": inch_machine() });
    let view = read(&request.to_string()).unwrap();
    let state = |index: usize| {
        let call = &view["calls"][index];
        (call["plane"].clone(), call["units"].clone())
    };
    assert_eq!(state(0), (json!("G18"), json!("G700")));
    assert_eq!(state(1), (json!("G17"), json!("G71")));
    let unknown = json!({ "control": "sinumerik", "cycle": "CYCLE978", "units": "G20" });
    assert!(
        form(&unknown.to_string())
            .unwrap_err()
            .to_string()
            .contains("G20")
    );
}

// oracle: hand
#[test]
fn a_call_is_converted_with_places_of_the_page() {
    let text = "; Ø\n_MVAR=0 _SETVAL=5 _MA=1 _KNUM=0\nCYCLE978\n";
    let request = json!({ "control": "sinumerik", "text": text, "call": 0, "style": "indirect" });
    let answer = convert(&request.to_string()).unwrap();
    let mut now: Vec<u16> = text.encode_utf16().collect();
    for edit in answer["edits"].as_array().unwrap().iter().rev() {
        let place = |name: &str| edit[name].as_u64().unwrap() as usize;
        let insert = edit["insert"].as_str().unwrap().encode_utf16();
        now.splice(place("from")..place("to"), insert);
    }
    let after = String::from_utf16(&now).unwrap();
    assert_eq!(after, "; Ø\nCYCLE_978(0,5,1,,,0)\n");
    let read = read(&json!({ "control": "sinumerik", "text": after }).to_string()).unwrap();
    assert_eq!(read["calls"][0]["style"], "indirect");
    let wrong = json!({ "control": "sinumerik", "text": text, "call": 0, "style": "spoken" });
    assert!(convert(&wrong.to_string()).is_err());
}

// oracle: manual B:12414-12423 (the comment with the settings), B:13594-13596 (an inch machine counts in inches)
#[test]
fn a_call_is_converted_on_the_machine_of_the_request() {
    let ask = |own: Value| {
        let request = json!({
            "control": "sinumerik", "text": "_MVAR=0 _SETVAL=5 _MA=1 _KNUM=0\nCYCLE978\n", "call": 0,
            "style": "indirect", "setup": { "own": own },
        });
        let edits = convert(&request.to_string()).unwrap()["edits"].to_string();
        (edits.contains("; _MZ_MASK="), edits)
    };
    let (marked, plain) = ask(json!({}));
    assert!(!marked, "{plain}");
    let forms = json!({ "PW-FORMS": 1 });
    let (marked, metric) = ask(json!({ "data": forms }));
    assert!(marked, "{metric}");
    let (marked, inch) = ask(json!({ "basic": "inch", "data": forms }));
    assert!(marked && inch != metric, "{inch}");
}

// oracle: manual B:654 (the cycles measure workpieces), B:12497 (direct), B:11640-12133 (parameterizing calls); C has neither
#[test]
fn the_catalogue_says_where_a_cycle_belongs_and_how_it_is_written() {
    let catalogue = catalogue();
    let cycle = |name: &str| {
        let all = catalogue["cycles"].as_array().unwrap();
        all.iter().find(|one| one["cycle"] == name).unwrap().clone()
    };
    let purpose = |machine: &str, probe: &str, calibrates: bool| {
        let plane = match machine {
            "turning" => "G18",
            _ => "G17",
        };
        json!({ "machine": machine, "plane": plane, "probe": probe, "calibrates": calibrates })
    };
    for (name, wanted) in [
        ("CYCLE977", purpose("milling", "workpiece", false)),
        ("CYCLE976", purpose("milling", "workpiece", true)),
        ("CYCLE971", purpose("milling", "tool", false)),
        ("CYCLE974", purpose("turning", "workpiece", false)),
        ("G110", purpose("milling", "workpiece", false)),
    ] {
        assert_eq!(cycle(name)["purpose"], wanted, "{name}");
    }
    assert_eq!(
        cycle("CYCLE977")["styles"],
        json!(["direct", "indirect", "operate"])
    );
    assert_eq!(cycle("G110")["styles"], json!(["direct"]));
}

// oracle: hand
#[test]
fn a_call_whose_variant_does_not_exist_has_no_variant() {
    let text = "_MVAR=77777\nCYCLE977\n_MVAR=2\nCYCLE977\n";
    let request = json!({ "control": "sinumerik", "text": text }).to_string();
    let calls = read(&request).unwrap()["calls"].clone();
    assert_eq!(calls[0]["mvar"], Value::Null);
    assert_eq!(calls[1]["mvar"], 2);
}

// oracle: manual B:12501-12506, B:12518-12532; hand (what the call writes is not the machine's own)
#[test]
fn a_form_as_on_the_control_has_its_fields_and_code() {
    let ask = |data: &Value| {
        let request = json!({
            "control": "sinumerik", "cycle": "CYCLE977", "setup": {"own": {"data": data}}, "predict": true,
            "values": {"_MVAR": "1", "_SETVAL": "100", "_KNUM": "2001", "_TNUM": "1", "_VMS": "200", "_EVNUM": "3", "_TUL": "0.06", "_TLL": "-0.06"},
        });
        form(&request.to_string()).unwrap()
    };
    let has = |view: &Value, name: &str| {
        let fields = view["fields"].as_array().unwrap().iter();
        fields.into_iter().any(|field| field["name"] == name)
    };
    let all = ask(&json!({ "_MZ_MASK[0]": 0 }));
    assert!(has(&all, "_VMS") && all["preset"] == "direct");
    let view = ask(&json!({ "PW-FORMS": 1, "_MZ_MASK[0]": 0, "_CHBIT[4]": 1 }));
    assert!(!has(&view, "_VMS") && !has(&view, "_EVNUM") && has(&view, "_TUL"));
    assert_eq!(view["preset"], "indirect");
    let text = view["snippet"].as_str().unwrap();
    assert!(
        text.contains("_CHBIT[4]=0") && text.contains("CYCLE_977_979A(977"),
        "{text}"
    );
    assert_eq!(view["setup"]["data"]["_CHBIT[4]"], 1.0);
    assert_eq!(view["setup"]["data"]["PW-FORMS"], 1.0);
}

// oracle: self: the page of a variant as the browser shows it
#[test]
fn help_is_asked_by_variant() {
    let ask = |cycle: &str, mvar: i64| {
        help(&json!({"control": "sinumerik", "cycle": cycle, "mvar": mvar}).to_string()).unwrap()
    };
    let hole = ask("CYCLE977", 1);
    let headings = |page: &Value, names: [&str; 5]| {
        let sections = page["sections"].as_array().unwrap().iter();
        let label = |section: &Value| section["label"]["key"].as_str().unwrap().to_owned();
        let labels: Vec<String> = sections.map(label).collect();
        assert_eq!(labels, names.map(|name| format!("help-section-{name}")));
    };
    headings(&hole, ["measures", "before", "order", "corrects", "wrong"]);
    let first = &hole["sections"][0]["lines"][0];
    assert_eq!(first["message"]["key"], "help-cycle977-measures-hole");
    assert_eq!(hole["required"], json!(["_SETVAL", "_KNUM"]));
    assert_eq!(hole["alarms"][0]["key"], "alarm-61016");
    let diameter = json!({"name": "_OVR[4]", "key": "result-actual-size"});
    assert!(hole["results"].as_array().unwrap().contains(&diameter));
    let tool = ["measures", "before-tool", "order", "corrects", "wrong"];
    headings(&ask("CYCLE971", 1), tool);
    let computing = ["does", "before-call", "order", "leaves", "wrong"];
    headings(&ask("CYCLE116", 0), computing);
    assert!(help(r#"{"control": "nct", "cycle": "CYCLE977", "mvar": 1}"#).is_err());
}

// oracle: hand: the same bore in the other language, with what both say in the active unit
#[test]
fn the_same_task_on_the_other_control_stands_beside_the_form() {
    let mut request = json!({
        "control": "nct", "cycle": "G110", "twin": true,
        "values": { "D": "50", "S": "1", "Q": "3" },
    });
    let view = form(&request.to_string()).unwrap();
    let twin = &view["twin"];
    assert_eq!(twin["cycle"], "CYCLE977");
    assert_eq!(twin["task"]["key"], "task-bore");
    assert!(twin["snippet"].as_str().unwrap().contains("_SETVAL=50"));
    let shared: Vec<_> = twin["shared"].as_array().unwrap().iter().collect();
    assert_eq!(shared[0]["value"], 50.0);
    request["cycle"] = "G101".into();
    request["values"] = json!({ "X": "1" });
    assert_eq!(form(&request.to_string()).unwrap()["twin"], Value::Null);
    request["twin"] = false.into();
    let view = form(&request.to_string()).unwrap();
    assert!(view.get("twin").is_none());
}

// oracle: self: in every plane the example that the catalogue has for it is complete and chooses its variant, and so does
// any depth of a web
#[test]
fn examples_of_macros_fit_their_plane() {
    let cycles = super::catalogue::cycles();
    let cycles = cycles.as_array().unwrap().iter();
    for cycle in
        cycles.filter(|one| one["control"] == "nct" && one["purpose"]["probe"] == "workpiece")
    {
        for variant in cycle["variants"].as_array().unwrap() {
            for plane in ["G17", "G18", "G19"] {
                let there = &variant["planes"][plane];
                let here = if there.is_null() { variant } else { there };
                let asked = |values: &Value| {
                    let request = json!({
                        "control": "nct", "cycle": cycle["cycle"], "plane": plane, "values": values,
                    });
                    form(&request.to_string()).unwrap()
                };
                let view = asked(&here["example"]);
                let what = format!("{} {plane} {}", cycle["cycle"], here["example"]);
                assert_eq!(view["complete"], true, "{what}: {}", view["diagnostics"]);
                assert_eq!(view["mvar"], variant["mvar"], "{what}");
                let mut deeper = here["example"].clone();
                for (name, typed) in here["values"].as_object().unwrap() {
                    if typed == "0" {
                        deeper[name] = "-7.5".into();
                    }
                }
                assert_eq!(asked(&deeper)["mvar"], variant["mvar"], "{what}");
            }
        }
    }
}
