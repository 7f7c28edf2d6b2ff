//! The generation of the control: what counts where the machine says it, how a list is written and carried out there.

use super::newer::{as_list, lists, valid};
use super::{first_example, written};
use probewright_core::control::{Control, GENERATION, Plane, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Inputs, Style};
use probewright_core::geometry::Mcs;
use probewright_core::machine::{Setup, Stop};
use probewright_core::name::Name;
use probewright_core::program::findings_on;
use probewright_core::run::{Limits, Outcome, assumed, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{Shape, Solid};

fn of_generation(number: f64) -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.set(GENERATION, number);
    control
}

/// Keys of what is said of the generation.
fn said(text: &str, generation: f64) -> Vec<String> {
    let found = findings_on(&read(Dialect::Sinumerik, text.as_bytes()), of_generation(generation));
    found.into_iter().map(|one| one.message.key.to_string()).filter(|key| key.starts_with("generation")).collect()
}

// oracle: peer (remedies of alarms separate three generations: lists only from 840D sl 2.7, 828D 4.4); hand: one
// finding
#[test]
fn a_program_of_another_generation_is_told_once() {
    let lists = "CYCLE977(101,1,,1,132,,,2,1)\nCYCLE977(101,2,,1,132,,,2,1)\n";
    let assigned = "_MVAR=101 _KNUM=1 _SETVAL=132 _PRNUM=1 _FA=2\nCYCLE977\n_KNUM=2\nCYCLE977\n";
    let no_counterpart = "CYCLE996(3,1,1,25,,,,,,,,,5,3,1,,1,1)\n";
    for (text, wanted) in [
        (lists, ["", "generation-list", "generation-list", ""]),
        (no_counterpart, ["", "generation-list", "generation-list", ""]),
        (assigned, ["", "", "", "generation-assigned"]),
        ("G0 X1\nCYCLE116\n", ["", "", "", ""]),
        ("$SNS_MEA_WP_BALL_DIAM[0]=6\nR1=$SCS_MEA_FEED_PLANE_VALUE\n", ["", "generation-setting-data", "", ""]),
        ("_WP[0,0]=6\n_SPEED[1]=500\n", ["", "", "generation-user-data", "generation-user-data"]),
        ("R1=_TP[0,6]*2\n", ["", "", "generation-user-data", "generation-user-data"]),
        ("DEF REAL _WP[3,11]\n_WP[0,0]=6\n", ["", "", "", ""]),
        ("R1=_OVR[4]\n", ["", "", "", ""]),
    ] {
        for (generation, wanted) in wanted.into_iter().enumerate() {
            let wanted: Vec<&str> = Some(wanted).filter(|key| !key.is_empty()).into_iter().collect();
            assert_eq!(said(text, generation as f64), wanted, "{generation} {text}");
        }
    }
}

// oracle: peer (what machine users write where nothing is to be said; 11 where the centre is given); hand
#[test]
fn a_list_is_written_as_machines_have_it() {
    let mut values = first_example("CYCLE978");
    for (name, value) in [("_MVAR", "100"), ("_KNUM", "2"), ("S_MD", "2")] {
        values.insert(name.into(), value.into());
    }
    values.retain(|name, _| !["_TZL", "_TUL", "_TLL", "_TDIF", "_TMV", "_K", "_EVNUM"].contains(&name.as_str()));
    let edge = written("CYCLE978", &values, Style::Operate);
    assert!(edge.text.contains(",1,2,1,\"\",,0,") && edge.text.ends_with(",0,,1,1)\n"), "{}", edge.text);
    let keys = |written: &probewright_core::program::write::Written| -> Vec<String> {
        written.findings.iter().map(|one| one.message.key.to_string()).collect()
    };
    assert_eq!(keys(&edge), Vec::<String>::new());
    values.remove("S_MD");
    let open = written("CYCLE978", &values, Style::Operate);
    assert_eq!(keys(&open), ["write-direction"], "the older call does not know it");
    let mut hole = first_example("CYCLE977");
    for (name, value) in [("_MVAR", "1101"), ("_KNUM", "1"), ("_ID", "-16"), ("_SZA", "60"), ("S_XM", "-3")] {
        hole.insert(name.into(), value.into());
    }
    let hole = written("CYCLE977", &hole, Style::Operate);
    assert!(hole.text.contains(",-16,60,") && hole.text.ends_with(",1,11,-3)\n"), "{}", hole.text);
    assert_eq!(keys(&hole), ["write-infeed"], "its sign stays, and that is told");
}

fn go(text: &str) -> Outcome {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Block { size: [100.0, 100.0, 50.0] }, Mcs::default()));
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

// oracle: peer (1 to 99 is the fine offset, 10000 more the coarse one); hand: the edge is half a millimetre nearer
#[test]
fn fine_and_coarse_are_told_by_the_number() {
    let with = |code: &str| {
        let call = format!("CYCLE978(100,{code},,1,50.5,5,5,1,2,1,\"\",,0,1,1,-1,,,0,,1,1)");
        let outcome = go(&format!("G17 G54 T9 D1 M6\nG0 X60 Y0 Z20\nZ-10\n{call}\nM30\n"));
        assert_eq!((outcome.stop, outcome.diagnostics), (None, Vec::new()), "{call}");
        let frame = &outcome.control.frames[&1];
        [frame.fine[0], frame.coarse[0]].map(|shift| (shift * 1e6).round() / 1e6)
    };
    assert_eq!(with("1"), [-0.5, 0.0]);
    assert_eq!(with("10001"), [0.0, -0.5]);
}

// oracle: peer (S_MD: 1 plus, 2 minus); hand: measured the other way, the face would be another one
#[test]
fn a_direction_that_leads_away_from_the_setpoint_stops_the_run() {
    for (face, start, towards) in [(50.5, 60, "2"), (-50.5, -60, "1")] {
        for direction in ["", "1", "2"] {
            let call = format!("CYCLE978(100,1,,1,{face},5,5,1,{direction},1)");
            let outcome = go(&format!("G17 G54 T9 D1 M6\nG0 X{start} Y0 Z20\nZ-10\n{call}\nM30\n"));
            let away = !["", towards].contains(&direction);
            assert_eq!(outcome.stop.is_some(), away, "{call}");
            assert_eq!(outcome.diagnostics.iter().any(|one| one.message.key == "newer-away"), away, "{call}");
            assert_eq!(outcome.control.frames.get(&1).is_none_or(|frame| frame.fine[0] == 0.0), away, "{call}");
        }
    }
}

// oracle: peer (the digits of their variants are not published; CYCLE150 shows results and measures nothing)
#[test]
fn a_run_stops_at_a_call_that_is_not_understood() {
    for call in
        ["CYCLE979(101,1,,1,132,2,1,0,0,0,90)", "CYCLE996(3,1,1,25,,,,,,,,,5,3,1,,1,1)", "CYCLE995(1,1,1,9,5,3)"]
    {
        let outcome = go(&format!("G17 G54 T9 D1 M6\n{call}\nG0 X1\nM30\n"));
        let Some(Stop::Fault(message)) = outcome.stop else { panic!("{call}") };
        assert_eq!(&*message.key, "run-no-simulation", "{call}");
    }
    // calls of machine users, one into a target of which nothing is published, one with an infeed of unknown sense
    for (call, why) in [
        ("CYCLE977(101,9000,,1,32,,,10,5,0,1,1,,,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)", "newer-unsimulated"),
        ("CYCLE977(1101,10001,,1,32,,,7,5,11,16,5,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,11,-3,15)", "newer-infeed"),
    ] {
        let outcome = go(&format!("G17 G54 T9 D1 M6\n{call}\nM30\n"));
        let keys: Vec<&str> = outcome.diagnostics.iter().map(|one| &*one.message.key).collect();
        assert!(keys.contains(&why) && keys.contains(&"run-no-simulation"), "{keys:?}");
    }
    // what is not sure of a call that is understood: nothing moves, nothing is corrected
    let hole = |start: &str, angle: &str, infeed: &str, tail: &str| {
        let arguments = format!("10,5,{angle},{infeed},20,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,{tail}");
        format!("G17 G54 T9 D1 M6\n{start}\nCYCLE977(1101,2,,1,50,,,{arguments})\nM30\n")
    };
    for (text, why) in [
        (hole("", "0", "-20", "1,1"), "newer-infeed"),
        (hole("", "0", "20", "1,1"), "newer-infeed"),
        (hole("", "30", "0", "1,1"), "newer-unsimulated"),
        (hole("", "0", "0", "1,11,180,130"), "newer-unsimulated"),
        (hole("", "0", "0", "1,1,,,1"), "newer-unsimulated"),
        (hole("G18", "0", "0", "1,1"), "newer-unsimulated"),
        (
            hole("", "0", "0", "1,1")
                .replace("(1101,2", "(101,10002")
                .replace("\nCYCLE", "\n$P_UIFR[2,X,FI]=0.1\nCYCLE"),
            "newer-fine",
        ),
        (hole("", "0", "0", "1,1").replace(",10,5,0", ",10,,0"), "newer-omitted"),
    ] {
        let outcome = go(&text);
        let keys: Vec<&str> = outcome.diagnostics.iter().map(|one| &*one.message.key).collect();
        assert!(keys.contains(&why) && keys.contains(&"run-no-simulation"), "{text} {keys:?}");
        assert!(matches!(outcome.stop, Some(Stop::Fault(_))), "{text}");
        let corrected = outcome.control.frames.get(&2).is_some_and(|frame| frame.coarse != [0.0; 3]);
        assert!(!corrected, "{text}");
    }
    for call in ["CYCLE150(1,,1001)", "CYCLE150(10,,1,,\"\")", "CYCLE150()", "CYCLE150"] {
        let outcome = go(&format!("G17 G54 T9 D1 M6\n{call}\n{call}\nG0 X1\nM30\n"));
        assert_eq!(outcome.stop, None);
        let keys: Vec<&str> = outcome.diagnostics.iter().map(|one| &*one.message.key).collect();
        assert_eq!(keys, ["run-result-screen"], "{call}");
    }
}

// oracle: peer (remedies of 61313 and 61416: workpiece probes 1 to 12, tool probes 1 to 6)
#[test]
fn newer_controls_have_more_probes() {
    let refused = |text: &str, generation: f64| {
        let found = findings_on(&read(Dialect::Sinumerik, text.as_bytes()), of_generation(generation));
        found.iter().any(|one| one.message.key == "check-probe-number")
    };
    for number in 1..=14 {
        let assigned = format!("_MVAR=101 _KNUM=1 _SETVAL=132 _PRNUM={number} _FA=2\nCYCLE977\n");
        for (generation, most) in [(0.0, 3), (1.0, 3), (2.0, 12), (3.0, 12)] {
            assert_eq!(refused(&assigned, generation), number > most, "{number} {generation}");
        }
        let list = format!("CYCLE977(101,1,,{number},132,,,2,1)\n");
        assert_eq!(refused(&list, 3.0), number > 12, "{number}");
        let tool = format!("_MVAR=1 _MA=3 _PRNUM={number} _FA=2\nCYCLE971\n");
        assert_eq!(refused(&tool, 2.0), number > 6, "{number}");
    }
}

// oracle: hand (a setting datum that is written is the one that is read, and what measures reads)
#[test]
fn a_program_writes_and_reads_setting_data() {
    let text = "$SNS_MEA_WP_BALL_DIAM[4]=6.5\n$SCS_MEA_FEED_RAPID_IN_PERCENT=40\n$SNS_MEA_FUNCTION_MASK=5\n\
        R1=$SNS_MEA_WP_BALL_DIAM[4]\nR2=$SNS_MEA_WP_BALL_DIAM[0]\nR3=$SNS_MEA_FUNCTION_MASK\nM30\n";
    for generation in [1.0, 2.0, 3.0] {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.control.set(GENERATION, generation);
        let ball = setup.control.number("_WP[0,0]");
        let go = |text: &str| run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default());
        let absent = |text: &str| {
            let Some(Stop::Fault(message)) = go(text).stop else { return false };
            message.key == "run-setting-absent"
        };
        assert_eq!(absent(text), generation == 1.0, "{generation}");
        assert!(absent("R1=$SNS_MEA_WP_BALL_DIAM[12]\nM30\n"), "{generation}");
        if generation > 1.0 {
            let Outcome { control, stop, .. } = go(text);
            assert_eq!(stop, None);
            let names = ["R1", "R2", "R3", "_WP[4,0]", "_SPEED[0]", "SD54740"];
            assert_eq!(names.map(|name| control.number(name)), [6.5, ball, 5.0, 6.5, 40.0, 5.0], "{generation}");
        }
    }
}

// oracle: self (`docs/generations.md` says of each variant whether it is written and simulated: by this condition)
#[test]
fn what_the_page_says_of_each_variant_is_what_is_done() {
    let plain = vec![(false, 1); 40];
    for (cycle, list) in lists() {
        for variant in cycle.variants {
            let mut values = valid(cycle, variant.number, &plain);
            if cycle.name == "CYCLE998" {
                values.insert("_ID".into(), "40".into());
            }
            let known = list.when.holds(&Inputs::new(cycle, variant.number));
            let there = written(cycle.name, &values, Style::Operate);
            assert_eq!(there.text.is_empty(), !known, "{} {}", cycle.name, variant.number);
            assert!(known || !there.findings.is_empty(), "why not is told");
            let call = if known { there.text } else { as_list(list, &values) };
            let program = read(Dialect::Sinumerik, format!("G17 G54\n{call}M30\n").as_bytes());
            let outcome = assumed::run(&program, Limits::default()).outcome;
            // which sign of an infeed leads down is not published
            let infeed = cycle.name != "CYCLE998" && Inputs::new(cycle, variant.number).uses(Name::new("_ID"));
            let simulated = known && !infeed;
            match &outcome.stop {
                Some(Stop::Fault(why)) => assert!(!simulated && why.key == "run-no-simulation", "{call} {why:?}"),
                other => assert!(simulated && other.is_none(), "{call} {other:?}"),
            }
        }
    }
}

// oracle: hand (form, call and fields of a machine that takes lists)
#[cfg(feature = "json")]
#[test]
fn the_form_of_a_machine_with_lists_writes_them() {
    use probewright_core::{app, json};
    use serde_json::json;
    let machine = |generation: i32| {
        let data = json!({ "PW-GENERATION": generation });
        json!({ "control": "sinumerik", "probe": { "radius": 3, "length": 50 }, "data": data })
    };
    let ask = |cycle: &str, generation: i32, direction: &str| {
        let values = json!({ "_MVAR": "100", "_KNUM": "10001", "_SETVAL": "50", "_MA": "1", "_PRNUM": "1", "_FA": "2",
            "_TSA": "1", "S_MD": direction });
        let asked = json!({ "control": "sinumerik", "cycle": cycle, "values": values,
            "setup": machine(generation) });
        let view = app::form(json::question(&asked.to_string()).unwrap()).unwrap();
        serde_json::to_value(&view).unwrap()
    };
    let view = ask("CYCLE978", 3, "2");
    assert_eq!(view["preset"], "operate");
    let snippet = view["snippet"].as_str().unwrap();
    assert!(snippet.starts_with("CYCLE978(100,10001,,1,50,2,1,1,2,1,"), "{snippet}");
    let field = |view: &serde_json::Value| {
        let fields = view["fields"].as_array().unwrap();
        fields.iter().find(|field| field["name"] == "S_MD").cloned()
    };
    assert_eq!(field(&view).unwrap()["value"], "2");
    let mode = json!({ "control": "sinumerik", "cycle": "CYCLE978", "written": "operate",
        "values": { "_MVAR": "100", "_KNUM": "1", "_SETVAL": "50", "_MA": "1", "_PRNUM": "1", "_DMODE": "1" } });
    let written = app::form(json::question(&mode.to_string()).unwrap()).unwrap();
    assert_eq!(written.preset, Style::Operate, "a program tells its generation by what it writes");
    let unit = |name: &str| written.fields.iter().find(|field| field.name == name).map(|field| field.unit);
    assert_eq!([unit("_DMODE"), unit("S_MD")], [Some(""), Some("")]);
    let older = ask("CYCLE978", 1, "2");
    assert_eq!(older["preset"], "direct");
    assert!(field(&older).is_none());
}
