//! Calls of a program, the catalogue, the help of a variant.

use super::inch_machine;
use crate::json::asked::*;
use crate::json::*;
use serde_json::json;

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
    assert!(form(&unknown.to_string()).unwrap_err().to_string().contains("G20"));
}

// oracle: manual B:10975, B:10983-10984 (DIAMOF: a radius dimension); hand: the part proposed for a radius of 22.5 mm
// is as wide as that for a diameter of 45 mm
#[test]
fn a_call_says_whether_its_setpoint_is_a_diameter() {
    let with = |function: &str, set: &str| {
        let text = format!(
            "G18 {function}\n_MVAR=1 _MA=2 _SETVAL={set} _SZA=60 _SZO={set}/2 _KNUM=0 _FA=2 _TSA=1 _PRNUM=1\nCYCLE994\n\
                M30\n"
        );
        let text = text.replace(&format!("{set}/2"), if set == "45" { "30" } else { "15" });
        let read = json!({ "control": "sinumerik", "text": text });
        let call = read_view(&read)["calls"][0].clone();
        let asked = json!({
            "control": "sinumerik", "cycle": "CYCLE994", "values": call["values"], "plane": call["plane"],
            "units": call["units"], "transverse": call["transverse"], "predict": true,
        });
        let view = form(&asked.to_string()).unwrap();
        let fields = view["fields"].as_array().unwrap();
        let set = fields.iter().find(|field| field["name"] == "_SETVAL");
        let results = view["outcome"]["results"].as_array().unwrap();
        let actual = results.iter().find(|one| one["name"] == "_OVR[4]").unwrap();
        (
            call["transverse"].clone(),
            set.unwrap()["label"]["key"].clone(),
            actual["value"].clone(),
            view["setup"]["workpiece"][0]["size"][0].clone(),
        )
    };
    let diameter = "param-setval-two-diameter";
    let radius = "param-setval-two-radius";
    for (function, set, told, label) in [
        ("DIAMON", "45", "DIAMON", diameter),
        ("DIAM90", "45", "DIAM90", diameter),
        ("", "45", "DIAMON", diameter),
        ("DIAMOF", "22.5", "DIAMOF", radius),
    ] {
        let (transverse, key, actual, size) = with(function, set);
        assert_eq!((transverse, key), (json!(told), json!(label)), "{function}");
        let actual = actual.as_f64().unwrap() - set.parse::<f64>().unwrap();
        assert!(actual.abs() < 1e-9, "{function}: {actual}");
        assert_eq!(size, with("DIAMON", "45").3, "{function}");
    }
}

fn read_view(request: &serde_json::Value) -> serde_json::Value {
    read(&request.to_string()).unwrap()
}

// oracle: hand (a note at the field of each value that comes from another program, and none of them among the findings)
#[test]
fn a_call_says_which_values_come_from_elsewhere() {
    let sub = "%_N_HOLE_SPF\nPROC HOLE(REAL _D)\n_SETVAL=_D _MVAR=1 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\nM17\n";
    let ask = |main: &str| {
        let text = format!("%_N_MAIN_MPF\nG17 G40 T9 D1\n{main}M30\n{sub}");
        let view = read(&json!({ "control": "sinumerik", "text": text }).to_string()).unwrap();
        let found = view["diagnostics"].as_array().unwrap();
        assert!(found.iter().all(|one| one["code"] != "PW151"));
        view["calls"][0].clone()
    };
    let same = ask("HOLE(40)\n");
    assert_eq!(same["values"]["_SETVAL"], "40");
    let notes = same["arrivals"].as_array().unwrap();
    assert_eq!(notes.len(), 1);
    let note = &notes[0];
    assert_eq!((&note["param"], &note["severity"]), (&json!("_SETVAL"), &json!("note")));
    assert_eq!(note["message"]["args"]["lines"], "3");
    let differs = ask("HOLE(40)\nHOLE(50)\n");
    assert_eq!(differs["values"]["_SETVAL"], "_D");
    assert_eq!(differs["arrivals"][0]["message"]["args"]["values"], "40 (3), 50 (4)");
    assert_eq!(same["first"], json!({}));
    assert_eq!(differs["first"], json!({ "_SETVAL": { "value": "40", "line": 3 } }));
}

// oracle: hand (what the first pass finds in R1, and in the counter)
#[test]
fn a_call_in_a_loop_says_what_arrives_first() {
    let first = |begin: &str, end: &str| {
        let rest = "_MVAR=1 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2";
        let text = format!("G17 G40 T9 D1\n{begin}\n{rest} _SETVAL=R1*2\nCYCLE977\n{end}\n");
        let view = read(&json!({ "control": "sinumerik", "text": text }).to_string()).unwrap();
        view["calls"][0]["first"].clone()
    };
    let at = |value: &str, line: u32| json!({ "_SETVAL": { "value": value, "line": line } });
    assert_eq!(first("R1=60\nLOOP", "R1=R1-5\nENDLOOP"), at("120", 4));
    assert_eq!(first("FOR R1=20 TO 30", "ENDFOR"), at("40", 3));
    assert_eq!(first("R1=$AA_IW[X]\nLOOP", "R1=2\nENDLOOP"), json!({}));
    assert_eq!(first("R1=60", "R1=50"), json!({}), "no pass but one");
}

// oracle: hand (the expression beside what it is worth; the form's text keeps it, and a line of another program is
// told)
#[test]
fn an_expression_travels_with_its_worth() {
    let text = "R2=50.02\n_MVAR=1 _SETVAL=R2 _PRNUM=1 _FA=2\nCYCLE977\n";
    let view = read(&json!({ "control": "sinumerik", "text": text }).to_string()).unwrap();
    let call = &view["calls"][0];
    assert_eq!(call["values"]["_SETVAL"], "50.02");
    assert_eq!(call["expressions"], json!({ "_SETVAL": "R2" }));
    let form = form(
        &json!({ "control": "sinumerik", "cycle": "CYCLE977", "values": call["values"],
        "expressions": call["expressions"] })
        .to_string(),
    )
    .unwrap();
    let fields = form["fields"].as_array().unwrap();
    let field = fields.iter().find(|one| one["name"] == "_SETVAL").unwrap();
    assert_eq!((&field["value"], &field["expression"]), (&json!("50.02"), &json!("R2")));
    assert!(form["snippet"].as_str().unwrap().contains("_SETVAL=R2"));
}

// oracle: hand
#[test]
fn a_change_tells_what_it_does_elsewhere_and_what_leaves_the_call() {
    let ask = |text: &str, name: &str, value: &str| {
        let request = json!({ "control": "sinumerik", "text": text, "call": 0, "name": name, "value": value });
        change(&request.to_string()).unwrap()
    };
    let sub = "%_N_HOLE_SPF\nPROC HOLE(REAL _D)\n_SETVAL=_D _MVAR=1\nCYCLE977\nM17\n";
    let text = format!("%_N_MAIN_MPF\nHOLE(40)\nM30\n{sub}");
    let changed = ask(&text, "_SETVAL", "41");
    let line = json!([{ "line": 2, "before": "HOLE(40)", "after": "HOLE(41)" }]);
    assert_eq!(changed["elsewhere"], line);
    assert_eq!(changed["steps"].as_array().unwrap().len(), 1);
    let own = ask("_MVAR=1 _KNUM=1 _SETVAL=40 _TZL=0.1\nCYCLE977\n", "_MVAR", "101");
    assert_eq!(own["elsewhere"], json!([]));
    assert_eq!(own["taken"], json!(["_KNUM", "_TZL"]));
    let unfit = json!([{ "name": "_KNUM", "value": "1", "before": "param-knum-tool" }]);
    assert_eq!(own["unfit"], unfit);
    assert_eq!(own["steps"].as_array().unwrap().len(), 2);
}

// oracle: hand
#[test]
fn of_a_file_that_is_no_program_only_so_much_is_told() {
    let text = format!("{}G17 G40 T9 D1\nCYCLE977\n", "!\n".repeat(10_500));
    let view = read(&json!({ "control": "sinumerik", "text": text }).to_string()).unwrap();
    assert_eq!(view["diagnostics"].as_array().unwrap().len(), 10_000);
    assert_eq!(view["calls"].as_array().unwrap().len(), 1);
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

// oracle: manual B:654 (the cycles measure workpieces), B:12497 (direct), B:11640-12133 (parameterizing calls); C has
// neither
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
    assert_eq!(cycle("CYCLE977")["styles"], json!(["direct", "indirect", "operate"]));
    assert_eq!(cycle("G110")["styles"], json!(["direct"]));
    assert_eq!([&cycle("CYCLE977")["numbered"], &cycle("G110")["numbered"]], [true, false]);
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

// oracle: peer (calls of published programs for newer controls; 61328 on such a control: argument 2 takes no tool
// target)
#[test]
fn a_list_of_a_newer_control_keeps_its_rules_on_the_page() {
    let calls =
        ["CYCLE977(1101,10001,,1,32,,,7,5,11,16,5,,,1)", "CYCLE978(0,,,1,-55,15,5,1,2,1,\"\",,0,1.01,1.01,-1.01)"];
    for call in calls {
        let text = format!("{call}\nM30\n");
        let asked = json!({ "control": "sinumerik", "text": text });
        let read = read(&asked.to_string()).unwrap();
        let opened = &read["calls"][0];
        let mut asked = json!({ "control": "sinumerik", "cycle": opened["cycle"], "predict": true,
            "values": opened["values"] });
        let complete = |asked: &Value| form(&asked.to_string()).unwrap()["complete"].clone();
        assert_eq!(complete(&asked), json!(false), "as the older control takes it: {call}");
        asked["written"] = opened["style"].clone();
        assert_eq!(complete(&asked), json!(true), "{call}");
    }
    let asked = json!({ "control": "sinumerik", "call": 0, "style": "operate",
        "text": "_MVAR=1 _SETVAL=132 _KNUM=2001 _TNUM=20\nCYCLE977\n" });
    let answer = convert(&asked.to_string()).unwrap();
    assert_eq!(answer["edits"], json!([]));
    assert_eq!(answer["findings"][0]["message"]["key"], "write-newer-tool");
    let styles = |name: &str| {
        let view: Value = serde_json::from_str(&catalogue().to_string()).unwrap();
        let cycles = view["cycles"].as_array().unwrap();
        cycles.iter().find(|one| one["cycle"] == name).unwrap()["styles"].clone()
    };
    assert_eq!(styles("CYCLE977"), json!(["direct", "indirect", "operate"]));
    assert_eq!(styles("CYCLE979"), json!(["direct", "indirect"]), "its list is only read");
}
