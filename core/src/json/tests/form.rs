//! A form: fields, picture, units, the control's own support, the other control.

use super::request;
use crate::catalogue::CYCLES;
use crate::catalogue::example::example;
use crate::dialect::Dialect;
use crate::entry::{Inputs, Style};
use crate::json::asked::*;
use crate::json::*;
use serde_json::json;

// oracle: hand
#[test]
fn a_form_without_values_has_fields_and_a_picture() {
    for cycle in crate::catalogue::CYCLES {
        let request = json!({ "control": cycle.dialect, "cycle": cycle.name }).to_string();
        let view = form(&request).unwrap();
        let blank = view["fields"].as_array().unwrap().is_empty();
        assert_eq!(blank, cycle.params.is_empty(), "{}", cycle.name);
        assert_eq!(view["outcome"], Value::Null);
    }
}

// oracle: hand (the core's own machine has a calibrated probe; a ball larger by 0.05 mm is none that its data know)
#[test]
fn a_form_says_whether_the_calibration_data_are_those_of_its_probe() {
    for cycle in crate::catalogue::CYCLES {
        for (sliders, fits) in [(json!({}), true), (json!({ "radius": 0.05 }), false)] {
            let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
            asked["errors"]["probe"] = sliders;
            let view = form(&asked.to_string()).unwrap();
            let carried_out = cycle.work().is_some();
            assert_eq!(view["calibrated"], json!(fits || !carried_out), "{}", cycle.name);
        }
    }
}

// oracle: self (the outcome of the form in which the value stands)
#[test]
fn an_outcome_counts_with_what_is_assumed_where_the_form_knows_no_value() {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut asked: Value = serde_json::from_str(&request(cycle)).unwrap();
    let known = form(&asked.to_string()).unwrap();
    assert_eq!(known["unknown"], Value::Null);
    let value = asked["values"]["_SETVAL"].take();
    asked["values"]["_SETVAL"] = json!("_DIA");
    let open = form(&asked.to_string()).unwrap();
    assert_eq!((&open["outcome"], &open["unknown"]), (&Value::Null, &json!(["_SETVAL"])));
    asked["assumed"] = json!({ "_SETVAL": value });
    let assumed = form(&asked.to_string()).unwrap();
    assert_eq!(assumed["outcome"], known["outcome"]);
    assert_eq!(assumed["snippet"], open["snippet"], "the program keeps its own");
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
    assert_eq!(view["outcome"]["trace"]["solids"][0]["size"][0], json!(50.8));
    assert_eq!(view["setup"]["active"]["units"], "G70");
    let text = view["snippet"].as_str().unwrap();
    let read = |machine: Value| json!({ "control": "sinumerik", "text": text, "setup": machine });
    let calls = super::read(&read(json!({ "own": { "units": "G70" } })).to_string()).unwrap();
    assert_eq!(calls["calls"][0]["units"], "G70");
}

// oracle: manual B:12501-12506, B:12518-12532; hand (what the call writes is not the machine's own)
#[test]
fn a_form_as_on_the_control_has_its_fields_and_code() {
    let ask = |data: &Value| {
        let request = json!({
            "control": "sinumerik", "cycle": "CYCLE977", "setup": {"own": {"data": data}}, "predict": true,
            "values": {"_MVAR": "1", "_SETVAL": "100", "_KNUM": "2001", "_TNUM": "1", "_VMS": "200", "_EVNUM": "3",
                "_TUL": "0.06", "_TLL": "-0.06"},
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
    assert!(text.contains("_CHBIT[4]=0") && text.contains("CYCLE_977_979A(977"), "{text}");
    assert_eq!(view["setup"]["data"]["_CHBIT[4]"], 1.0);
    assert_eq!(view["setup"]["data"]["PW-FORMS"], 1.0);
}

// oracle: hand: the same bore in the other language, with what both say in the active unit
#[test]
fn the_same_task_on_the_other_control_stands_beside_the_form() {
    let mut request = json!({
        "control": "nct", "cycle": "G110", "twin": true,
        "values": { "D": "50", "S": "1", "Q": "3" },
    });
    let view = form(&request.to_string()).unwrap();
    let twin = &view["twins"][0];
    assert_eq!(twin["cycle"], "CYCLE977");
    assert_eq!(twin["task"]["key"], "task-bore");
    assert!(twin["snippet"].as_str().unwrap().contains("_SETVAL=50"));
    let shared: Vec<_> = twin["shared"].as_array().unwrap().iter().collect();
    assert_eq!(shared[0]["value"], 50.0);
    request["cycle"] = "G101".into();
    request["values"] = json!({ "X": "1" });
    assert_eq!(form(&request.to_string()).unwrap()["twins"], json!([]));
    request["twin"] = false.into();
    let view = form(&request.to_string()).unwrap();
    assert!(view.get("twins").is_none());
}

// oracle: hand: 2 is the minus direction: the probe starts beyond the face; what only newer controls have is told
#[test]
fn the_start_of_a_list_follows_its_direction() {
    let ask = |cycle: &str, values: Value| {
        let request = json!({ "control": "sinumerik", "cycle": cycle, "written": "operate", "predict": true,
            "values": values });
        form(&request.to_string()).unwrap()
    };
    let told = |view: &Value| -> Vec<String> {
        let all = view["diagnostics"].as_array().unwrap().iter();
        let own = all.filter(|one| one["code"] == "PW203");
        own.map(|one| one["param"].as_str().unwrap_or_default().to_owned()).collect()
    };
    for (direction, side) in [("1", -1.0), ("2", 1.0)] {
        let face = json!({ "_MVAR": "100", "_SETVAL": "12", "_MA": "1", "_KNUM": "1", "_PRNUM": "1", "_FA": "2",
            "_TSA": "5", "_NMSP": "1", "S_MD": direction });
        let view = ask("CYCLE978", face);
        assert_eq!(told(&view), [""; 0], "{direction}");
        let start = view["setup"]["position"][0].as_f64().unwrap();
        assert!((start - 12.0) * side > 0.0, "{direction}: {start}");
        assert!(view["outcome"].is_object());
    }
    // an edge at an angle, measured along the ordinate; 998 has the same numbers (CamHelper cd6e996)
    for (direction, side) in [("1", -1.0), ("2", 1.0)] {
        let edge = json!({ "_MVAR": "105", "_SETVAL": "12", "_MA": "102", "_STA1": "0", "_ID": "40", "_KNUM": "1",
            "_RA": "0", "_PRNUM": "1", "_FA": "10", "_TSA": "5", "_NMSP": "1", "S_MD": direction });
        let view = ask("CYCLE998", edge);
        assert_eq!(told(&view), [""; 0], "{direction}");
        let start = view["setup"]["position"][1].as_f64().unwrap();
        assert!((start - 12.0) * side > 0.0, "{direction}: {start}");
        assert_eq!(view["outcome"]["alarms"], json!([]), "{direction}");
    }
    // from above a face is measured downwards only
    let up = json!({ "_MVAR": "100", "_SETVAL": "12", "_MA": "3", "_KNUM": "1", "_PRNUM": "1", "_FA": "2", "_TSA": "5",
        "_NMSP": "1", "S_MD": "1" });
    let up = ask("CYCLE978", up);
    assert_eq!(told(&up), ["S_MD"]);
    assert!(up["outcome"].is_null(), "measured downwards, it would look as if the call did so");
    let hole = json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1", "_FA": "2", "S_STA1": "30", "S_XM": "5" });
    assert_eq!(told(&ask("CYCLE977", hole)), ["S_STA1", "S_XM"]);
    for infeed in ["16", "-16"] {
        let boss = json!({ "_MVAR": "102", "_SETVAL": "50", "_KNUM": "1", "_PRNUM": "1", "_FA": "2", "_TSA": "5",
            "_NMSP": "1", "_ID": infeed });
        let boss = ask("CYCLE977", boss);
        assert_eq!(told(&boss), ["_ID"]);
        assert!(boss["outcome"].is_null(), "which sign leads down is not published");
    }
}

// oracle: peer (published lists: 10001 is G54 coarse; digits of CYCLE979 are not published); hand
#[test]
fn a_call_in_a_list_has_the_numbers_of_that_list() {
    let ask = |cycle: &str, style: &str, values: Value| {
        let request = json!({ "control": "sinumerik", "cycle": cycle, "written": "operate", "style": style,
            "values": values });
        form(&request.to_string()).unwrap()
    };
    let entry = |view: &Value, name: &str| {
        let fields = view["fields"].as_array().unwrap();
        fields.iter().find(|field| field["name"] == name).unwrap().clone()
    };
    let choices = |entry: &Value| -> Vec<i64> {
        let all = entry["choices"].as_array().unwrap().iter();
        all.map(|one| one["value"].as_i64().unwrap()).collect()
    };
    let hole = ask("CYCLE977", "operate", json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "10001", "_FA": "2" }));
    assert_eq!(hole["mvar"], 101);
    let offsets = choices(&entry(&hole, "_KNUM"));
    assert!([0, 1, 10_001, 9000, 19_999].iter().all(|code| offsets.contains(code)), "{offsets:?}");
    assert!(![1000, 1011, 1051, 2000].iter().any(|code| offsets.contains(code)), "{offsets:?}");
    assert!(choices(&entry(&hole, "_MVAR")).contains(&1101));
    let edge = ask("CYCLE998", "operate", json!({ "_MVAR": "105", "_SETVAL": "50", "_KNUM": "1", "_FA": "2" }));
    assert_eq!(choices(&entry(&edge, "_MVAR")), [105], "one angle, positioning at an angle");
    // what is not published is neither named nor drawn nor written otherwise
    let open = json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1", "_FA": "2" });
    for style in ["operate", "direct", "indirect"] {
        let view = ask("CYCLE979", style, open.clone());
        assert_eq!((&view["mvar"], &view["snippet"]), (&Value::Null, &json!("")), "{style}");
        assert!(view.get("picture").is_none() && !view["snippetFindings"].as_array().unwrap().is_empty());
        assert_eq!(entry(&view, "_MVAR")["kind"], "integer");
        assert_eq!(view["preset"], "operate");
    }
}

// oracle: peer (the published list of CYCLE977: no argument for _VMS and _TNUM; argument 2 takes zero offsets, hundreds
// 0 of argument 1 measures only, argument 4 is a probe from 1 to 12; an omitted argument is 0)
#[test]
fn a_form_in_a_list_says_what_the_list_says() {
    let ask = |written: bool, values: Value| {
        let mut request = json!({ "control": "sinumerik", "cycle": "CYCLE977", "values": values });
        match written {
            true => request["written"] = "operate".into(),
            false => {
                request["setup"] = json!({ "control": "sinumerik", "probe": { "radius": 3, "length": 50 },
                    "data": { "PW-GENERATION": 3 } });
            }
        }
        form(&request.to_string()).unwrap()
    };
    let field = |view: &Value, name: &str| {
        view["fields"].as_array().unwrap().iter().find(|one| one["name"] == name).cloned().unwrap_or_default()
    };
    for written in [true, false] {
        // what a program omits is 0, what a new call omits is written as the form shows it
        let short = json!({ "_MVAR": "1", "_SETVAL": "50" });
        assert_eq!(ask(written, short.clone())["complete"], !written);
        let whole = json!({ "_MVAR": "1", "_SETVAL": "50", "_PRNUM": "1", "_FA": "2", "_TSA": "5", "_NMSP": "1",
            "_TZL": "0", "_TDIF": "1.01", "_TUL": "1.01", "_TLL": "-1.01" });
        let view = ask(written, if written { whole } else { short });
        assert_eq!(field(&view, "_FA")["required"], written);
        assert_eq!(view["title"]["key"], "cycle977-hole-measured");
        assert_eq!(view["complete"], true, "{}", view["diagnostics"]);
        assert!(["_VMS", "_TNUM", "_TNAME"].iter().all(|name| field(&view, name)["topic"] != "tool"), "{view}");
        assert_eq!((&field(&view, "_VMS"), &field(&view, "_TNUM")), (&Value::Null, &Value::Null));
        assert_eq!(field(&view, "_KNUM")["label"]["key"], "argument-zero");
        assert_eq!(field(&view, "_PRNUM")["kind"], "integer");
        assert_eq!(field(&view, "_PRNUM")["range"]["max"], 12.0);
        let reason = if written { "need-omitted" } else { "need-listed" };
        assert_eq!(field(&view, "_TSA")["reason"]["key"], reason);
        assert_eq!(field(&view, "_TMV")["reason"]["key"], "need-omitted", "it belongs to a correction");
        let zero = ask(written, json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1" }));
        assert_eq!(zero["title"], Value::Null, "the name of the variant fits");
        let limit = if written { "_TUL" } else { "S_TUL" };
        assert_eq!(field(&zero, limit)["topic"], "list", "{limit}");
    }
    let text = |values: Value| ask(false, values)["snippet"].as_str().unwrap().to_owned();
    let with_own = json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1", "S_TUL": "0.3", "S_TNAME": "MILL" });
    assert!(text(with_own).contains(",1,\"MILL\",,0,1.01,0.3,-1.01,"), "a value of the list's own section is written");
    let measured = text(json!({ "_MVAR": "1", "_SETVAL": "50", "_TUL": "0.1", "_TLL": "-0.1" }));
    assert!(measured.starts_with("CYCLE977(1,,,1,50,") && measured.ends_with("0.1,-0.1,,,,,1,1)\n"), "{measured}");
    // what the list has no place for is kept and told at its field
    let lost = ask(false, json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1", "_VMS": "200" }));
    let told = lost["diagnostics"].as_array().unwrap().iter().find(|one| one["param"] == "_VMS").cloned();
    assert_eq!(told.unwrap()["message"]["key"], "write-lost");
    assert_eq!(field(&lost, "_VMS")["value"], "200");
}

// oracle: hand (a machine of generation 3 takes lists; the digits of CYCLE961's are not published)
#[test]
fn a_cycle_without_list_says_why_it_is_assigned() {
    let told = |generation: i32, cycle: &str| -> bool {
        let setup = json!({ "control": "sinumerik", "probe": { "radius": 3, "length": 50 },
            "data": { "PW-GENERATION": generation } });
        let request = json!({ "control": "sinumerik", "cycle": cycle, "values": {}, "setup": setup });
        let view = form(&request.to_string()).unwrap();
        view["diagnostics"].as_array().unwrap().iter().any(|one| one["code"] == "PW231")
    };
    assert!(told(3, "CYCLE961") && !told(1, "CYCLE961") && !told(3, "CYCLE977") && !told(3, "CYCLE116"));
    for cycle in CYCLES.iter().filter(|one| one.dialect == Dialect::Sinumerik) {
        let list = cycle.lists.iter().find(|list| list.style == Style::Operate);
        assert_eq!(told(3, cycle.name), list.is_some_and(|list| !list.is_written()), "{}", cycle.name);
    }
}

// oracle: hand (a form opens with the worked measurement: it is written as it stands, or the form says why not)
#[test]
fn a_form_of_a_list_starts_with_values_that_the_list_takes() {
    let setup =
        json!({ "control": "sinumerik", "probe": { "radius": 3, "length": 50 }, "data": { "PW-GENERATION": 3 } });
    for cycle in CYCLES.iter().filter(|one| one.dialect == Dialect::Sinumerik) {
        let Some(list) = cycle.lists.iter().find(|list| list.style == Style::Operate && list.is_written()) else {
            continue;
        };
        for variant in cycle.variants {
            let values = example(cycle, variant);
            let ask = |style: &str| {
                let request = json!({ "control": "sinumerik", "cycle": cycle.name, "values": values, "setup": setup,
                    "style": style });
                form(&request.to_string()).unwrap()
            };
            let view = ask("operate");
            let what = format!("{} {}", cycle.name, variant.number);
            let errors =
                view["diagnostics"].as_array().unwrap().iter().filter(|one| one["severity"] == "error").count();
            assert_eq!(view["complete"], errors == 0, "{what}");
            assert_eq!(view["snippet"] != "", errors == 0, "{what}: {}", view["diagnostics"]);
            let inputs = Inputs::new(cycle, variant.number);
            assert_eq!(errors == 0, list.when.holds(&inputs), "{what}: {}", view["diagnostics"]);
            let fields = view["fields"].as_array().unwrap();
            let target = fields.iter().find(|field| field["name"] == "_KNUM").map(|field| field["value"].clone());
            assert_ne!(target, Some(json!("2001")), "{what}");
            let said = ask("direct")["diagnostics"].as_array().unwrap().iter().any(|one| one["code"] == "PW197");
            assert!(said, "{what}: a machine of generation 3 takes no assignments");
        }
    }
}

// oracle: hand (each argument of the program's call, also those that the older control does not use in its variant)
#[test]
fn the_text_of_a_call_in_a_list_has_all_its_arguments() {
    for call in [
        "CYCLE977(101,10001,,1,50,,,7,5,11,-16,5,,,1,\"BOHRER\",2,0.005,1.01,1.01,-1.01,0.34,3,7,,1,1)",
        "CYCLE978(100,1,,1,10,10,5,1,2,1,\"T\",2,0.1,1.01,1.01,-1.01,0.34,1,3,,1,1)",
    ] {
        let program = crate::syntax::read(Dialect::Sinumerik, format!("{call}\nM30\n").as_bytes());
        let site = crate::program::calls::calls(&program).remove(0);
        let request = json!({ "control": "sinumerik", "cycle": site.cycle.name, "values": site.values,
            "expressions": site.expressions, "written": "operate" });
        let view = form(&request.to_string()).unwrap();
        assert_eq!(view["snippet"].as_str().unwrap().trim_end(), call);
    }
}

// oracle: hand: the limits are set value plus tolerance; a zero offset is a datum; TNC 320 9/2016 p. 396 for the rest
#[test]
fn the_same_task_stands_beside_the_form_as_other_controls_write_it() {
    let on_tnc = |cycle: &str, values: Value| {
        let request = json!({ "control": "sinumerik", "cycle": cycle, "twin": true, "values": values });
        let view = form(&request.to_string()).unwrap();
        let twins = view["twins"].as_array().unwrap().clone();
        let tnc: Vec<Value> = twins.into_iter().filter(|one| one["control"] == "HEIDENHAIN TNC").collect();
        tnc.first().cloned().unwrap_or_default()
    };
    let hole = json!({ "_MVAR": "1", "_SETVAL": "20", "_TUL": "0.1", "_TLL": "-0.3", "_TNUM": "7", "_KNUM": "2001" });
    let tnc = on_tnc("CYCLE977", hole);
    assert_eq!(tnc["cycle"], "TCH PROBE 421");
    let text = tnc["snippet"].as_str().unwrap();
    for line in ["Q262=+19.9 ;", "Q275=+20.1 ;", "Q276=+19.7 ;", "Q330=+7 ;TOOL NUMBER\n", "Q273=+0 ;"] {
        assert!(text.contains(line), "{line} {text}");
    }
    let keys: Vec<&str> = tnc["differences"].as_array().unwrap().iter().filter_map(|one| one["key"].as_str()).collect();
    assert!(keys.starts_with(&["foreign-place", "foreign-usual", "tnc-results"]), "{keys:?}");
    let zero = on_tnc("CYCLE977", json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "1" }));
    assert_eq!(zero["cycle"], "TCH PROBE 412");
    assert_eq!(zero["differences"][0]["key"], "foreign-zero-active");
    assert_eq!(zero["differences"][3]["key"], "foreign-datum");
    let said: Vec<&str> =
        zero["shared"].as_array().unwrap().iter().filter_map(|one| one["label"]["key"].as_str()).collect();
    assert_eq!(said, ["meaning-nominal"], "the call sets the active datum, whichever that is");
    // a boss is described, and its page not published: it is not written
    let boss = on_tnc("CYCLE977", json!({ "_MVAR": "2", "_SETVAL": "50", "_ID": "-30" }));
    assert_eq!((&boss["cycle"], &boss["snippet"]), (&json!("TCH PROBE 422"), &json!("")));
    assert_eq!(boss["refused"]["key"], "foreign-unwritten-values");
    assert_eq!(boss["refused"]["args"], json!({ "cycle": "TCH PROBE 422", "names": "Q277, Q278" }));
    // 10001 is the coarse part of G54, and a number that no other control has is told
    let coarse = on_tnc("CYCLE977", json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "10001" }));
    assert_eq!((&coarse["cycle"], &coarse["differences"][0]["key"]), (&json!("TCH PROBE 412"), &json!("twin-coarse")));
    let lost = on_tnc("CYCLE977", json!({ "_MVAR": "101", "_SETVAL": "50", "_KNUM": "19999" }));
    assert_eq!(lost["cycle"], "TCH PROBE 421");
    assert_eq!(lost["differences"][0]["key"], "foreign-zero-lost");
    let usual = lost["differences"].as_array().unwrap().iter().find(|one| one["key"] == "foreign-usual");
    assert!(usual.unwrap()["args"]["names"].as_str().unwrap().contains("Q275, Q276"), "{lost}");
    // a corner and an angle have their cycle there too, and the reason why it is not written
    let corner = on_tnc("CYCLE961", json!({ "_MVAR": "106", "_KNUM": "1" }));
    assert_eq!((&corner["cycle"], &corner["snippet"]), (&json!("TCH PROBE 415"), &json!("")));
    assert_eq!(corner["refused"]["key"], "foreign-unwritten-nothing");
    for (zero, cycle) in [("0", "TCH PROBE 420"), ("1", "TCH PROBE 400")] {
        let angle = on_tnc("CYCLE998", json!({ "_MVAR": "105", "_KNUM": zero }));
        assert_eq!((&angle["cycle"], &angle["snippet"]), (&json!(cycle), &json!("")));
        assert_eq!(angle["refused"]["key"], "foreign-unwritten-values");
    }
    assert_eq!(boss["values"]["Q261"], "-10");
    // a rectangle has two sizes with one tolerance
    let inside =
        json!({ "_MVAR": "5", "_SETV[0]": "60", "_SETV[1]": "40", "_TUL": "0.2", "_TLL": "-0.1", "_KNUM": "0" });
    let inside = on_tnc("CYCLE977", inside);
    let text = inside["snippet"].as_str().unwrap();
    for line in [
        "TCH PROBE 423 ", "Q282=+60.05 ;", "Q283=+40.05 ;", "Q284=+60.2 ;", "Q285=+59.9 ;", "Q286=+40.2 ;",
        "Q287=+39.9 ;",
    ] {
        assert!(text.contains(line), "{line} {text}");
    }
    assert_eq!(inside["task"]["key"], "task-rectangle");
    let island = json!({ "_MVAR": "106", "_SETV[0]": "60", "_SETV[1]": "40", "_ID": "-30", "_KNUM": "1" });
    let island = on_tnc("CYCLE977", island);
    assert_eq!((&island["cycle"], &island["values"]["Q324"]), (&json!("TCH PROBE 411"), &json!("40")));
    assert_eq!(island["values"]["Q261"], "-10");
    let wall = on_tnc("CYCLE978", json!({ "_MVAR": "0", "_SETVAL": "-12", "_MA": "2" }));
    let text = wall["snippet"].as_str().unwrap();
    for line in ["TCH PROBE 427 ", "Q263=+0 ;", "Q264=-12 ;", "Q272=+2 ;", "Q267=-1 ;"] {
        assert!(text.contains(line), "{line} {text}");
    }
    // of the length of a probe it has no cycle
    assert_eq!(on_tnc("CYCLE976", json!({ "_MVAR": "0", "_SETVAL": "0", "_MA": "3" })), Value::Null);
}

// oracle: self: in every plane the example that the catalogue has for it is complete and chooses its variant, and so
// does any depth of a web
#[test]
fn examples_of_macros_fit_their_plane() {
    let catalogue = catalogue();
    let cycles = catalogue["cycles"].as_array().unwrap().iter();
    for cycle in cycles.filter(|one| one["control"] == "nct" && one["purpose"]["probe"] == "workpiece") {
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
