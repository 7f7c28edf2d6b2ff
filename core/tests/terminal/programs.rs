//! Calls written, programs checked, read and run.

use super::{HOLE, err, example_setup, file, out, probewright};

// oracle: hand
#[test]
fn write_gives_assignments_and_the_call() {
    let output = probewright(&["write", "CYCLE977", "_MVAR=1", "_SETVAL=132,5", "_KNUM=2001", "_TNUM=20"]);
    assert!(output.status.success(), "{}", err(&output));
    assert_eq!(out(&output), "_MVAR=1 _SETVAL=132.5 _KNUM=2001 _TNUM=20\nCYCLE977\n");
}

// oracle: manual A:15840-15948 (numbers)
#[test]
fn write_tells_every_problem_and_fails() {
    let output = probewright(&["write", "CYCLE977", "_MVAR=1", "_KNUM=2000", "_FA=0"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(err(&output).contains("_SETVAL"), "{}", err(&output));
    assert!(err(&output).contains("61308"), "{}", err(&output));
    assert!(err(&output).contains("61328"), "{}", err(&output));
    assert_eq!(out(&output), "");
}

// oracle: peer (61328 on a newer control: argument 2 of a list takes no tool target)
#[test]
fn write_refuses_a_tool_target_in_the_list_of_newer_controls() {
    let values = ["_MVAR=1", "_SETVAL=132", "_KNUM=2001", "_TNUM=20"];
    let asked = ["write", "--style", "operate", "CYCLE977"].into_iter();
    let output = probewright(&asked.chain(values).collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(1));
    assert!(err(&output).contains("PW189"), "{}", err(&output));
    assert!(err(&output).contains("S_KNUM1"), "{}", err(&output));
    assert_eq!(out(&output), "");
}

// oracle: peer (calls of machine users: arguments 2, 9, 13, 19, 21 and 22 of CYCLE978; digits of other lists are not
// published)
#[test]
fn write_takes_the_arguments_of_newer_controls_by_name() {
    let write = |values: &[&str]| probewright(&[&["write", "--style", "operate"], values].concat());
    let values = ["S_MVAR=100", "S_SETV=-55", "_FA=15", "_MA=1", "S_MD=2", "S_TZL=0.02", "_AMODE=11"];
    for zero in ["10001", "9000", "9999", "19999", "1"] {
        let zero = format!("S_KNUM={zero}");
        let output = write(&[&["CYCLE978"], &values[..], &[&zero]].concat());
        assert!(output.status.success(), "{}", err(&output));
        let call = format!("CYCLE978(100,{},,1,-55,15,2,1,2,1,", zero.trim_start_matches("S_KNUM="));
        assert!(out(&output).starts_with(&call), "{}", out(&output));
        assert!(out(&output).contains(",0.02,") && out(&output).ends_with(",1,11)\n"), "{}", out(&output));
    }
    for (asked, said) in [
        (&["CYCLE978", "S_MD=7"][..], "S_MD has no value 7"),
        (&["CYCLE977", "S_KNUM1=3"], "S_KNUM1 is not written: its digits are not published"),
        (&["CYCLE979", "_MVAR=1"], "the digits of argument 1 are not published"),
        (&["CYCLE998", "_MVAR=106"], "Variant 106 of CYCLE998"),
        (&["CYCLE996"], "older controls have no such cycle"),
        (&["TCH PROBE 430"], "no published page shows Q281, Q309, Q330 of this cycle and their order"),
        (&["TCH PROBE 416"], "no public document that was found has its values"),
    ] {
        let output = write(asked);
        assert!(!output.status.success() && err(&output).contains(said), "{asked:?} {}", err(&output));
    }
}

// oracle: peer (newer controls take lists); hand (a style that is asked for is written, and told)
#[test]
fn write_follows_the_generation_of_the_machine() {
    let machine = |generation: &str| {
        let data = format!("\"data\": {{ \"PW-GENERATION\": {generation}, ");
        let setup = include_str!("../../../docs/setup.example.json");
        file(&format!("generation{generation}.json"), setup.replacen("\"data\": {", &data, 1).as_bytes())
    };
    let values = ["_MVAR=101", "_SETVAL=50", "_KNUM=1"];
    let write = |cycle: &str, generation: &str, style: &[&str]| {
        let machine = machine(generation);
        probewright(&[&["write", cycle, "--setup", &machine], style, &values[..]].concat())
    };
    let list = write("CYCLE977", "3", &[]);
    assert!(out(&list).starts_with("CYCLE977(101,1,,1,50,"), "{}{}", out(&list), err(&list));
    for (generation, style, told) in [
        ("1", &[][..], ""),
        ("2", &[], ""),
        ("3", &["--style", "direct"], "PW197"),
        ("1", &["--style", "operate"], "PW197"),
    ] {
        let output = write("CYCLE977", generation, style);
        assert_eq!(out(&output).contains("CYCLE977("), style.contains(&"operate"), "{generation} {style:?}");
        assert_eq!(err(&output).contains("PW197"), told == "PW197", "{generation} {style:?} {}", err(&output));
    }
    let corner = probewright(&["write", "CYCLE961", "--setup", &machine("3"), "_MVAR=105", "_KNUM=1"]);
    assert!(err(&corner).contains("PW231"), "{}", err(&corner));
}

// oracle: peer (the published lists of CYCLE995 and CYCLE996)
#[test]
fn read_lists_calls_that_have_no_form() {
    let text = b"CYCLE996(1,,1,24.99)\nCYCLE977(101,1,,1,50,,,2,5)\nCYCLE150(1,,2,,3)\n";
    let told = out(&probewright(&["read", &file("alone.mpf", text)]));
    let lines: Vec<&str> = told.lines().filter(|line| !line.starts_with(' ')).collect();
    assert_eq!(lines.len(), 3, "{told}");
    assert!(
        lines[0].contains(":1: CYCLE996: Measures the kinematics") && lines[2].contains(":3: CYCLE150: "),
        "{told}"
    );
    assert!(told.contains("    S_MVAR=1\n    S_PRNUM=1\n    S_SETV=24.99\n"), "{told}");
}

// oracle: issue text
#[test]
fn check_names_file_line_and_column() {
    let path = file("wrong.mpf", b"G54 G17\r\n_MVAR=7 _SETVAL=10 _KNUM=0\r\nCYCLE977\r\n");
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).contains(&format!("{path}:2:7: error[61307]:")), "{}", out(&output));
    let path = file("right.mpf", HOLE.as_bytes());
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(0), "{}", out(&output));
}

// oracle: manual B:4147-4152 (a probe is of type 710 or 1x0, not a drill)
#[test]
fn check_holds_a_program_against_the_machine_it_is_for() {
    let path = file("mill.mpf", HOLE.replace("T9", "T20").as_bytes());
    let machine = include_str!("../../../docs/setup.example.json");
    let with_drill = machine.replace("\"type\": 120", "\"type\": 200");
    let machine = file("drill.json", with_drill.as_bytes());
    let output = probewright(&["check", &path, "--setup", &machine]);
    assert!(out(&output).contains("error[61309]"), "{}", out(&output));
    assert_eq!(output.status.code(), Some(1));
    let output = probewright(&["check", &path, "--setup", &path]);
    assert!(!output.status.success());
    assert!(err(&output).contains("mill.mpf"), "{}", err(&output));
}

// oracle: hand
#[test]
fn read_finds_the_call_with_its_values() {
    let path = file("read.mpf", HOLE.as_bytes());
    let view: serde_json::Value = serde_json::from_str(&out(&probewright(&["read", &path, "--json"]))).unwrap();
    let call = &view["calls"][0];
    assert_eq!(call["cycle"], "CYCLE977");
    assert_eq!(call["lastLine"], 8);
    assert_eq!(call["values"]["_SETVAL"], "132");
    assert_eq!(call["values"]["_TSA"], "1");
}

// oracle: hand. 0.03 mm too big lies between _TMV and _TUL: corrected by all of it, half of it in the radius.
#[test]
fn run_measures_the_hole_and_corrects_the_radius() {
    let path = file("run.mpf", HOLE.as_bytes());
    let output = probewright(&["run", &path, "--setup", &example_setup(), "--json"]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    let view: serde_json::Value = serde_json::from_str(&out(&output)).unwrap();
    let changes = view["changes"].as_array().unwrap();
    let radius = changes.iter().find(|change| change["name"] == "$TC_DP15[20,1]").unwrap();
    assert!((radius["after"].as_f64().unwrap() - 0.015).abs() < 1e-9, "{radius}");
    let said = out(&probewright(&["run", &path, "--setup", &example_setup()]));
    for line in [
        ":8: CYCLE977", ":8: CYCLE977: ", // what it decided
        "  _OVR[4] = 132.03 mm  ", "  _OVR[16] = 0.03 mm  ",
    ] {
        assert!(said.contains(line), "{said}");
    }
}

// oracle: hand: one refusal that says what it is; in conversational text and in DIN/ISO, whatever machine is named
#[test]
fn a_program_of_another_maker_is_not_run() {
    let conversational =
        b"0 BEGIN PGM A MM\n1 TOOL CALL 30 Z\n2 TCH PROBE 427 MEASURE COORDINATE ~\n  Q263=+1\n3 M30\n";
    let iso = b"%A G71 *\nN10 T30 G17 *\nN20 G427 Q263=+1 *\nN30 M30 *\n";
    for (name, text) in [("A.H", &conversational[..]), ("A.I", &iso[..])] {
        let path = file(name, text);
        let setup = example_setup();
        for more in [&[][..], &["--setup", &setup], &["--control", "nct"], &["--program", "A"], &["--arg", "X=1"]] {
            let output = probewright(&[&["run", &path], more].concat());
            assert_eq!(output.status.code(), Some(1), "{}", err(&output));
            let told = out(&output);
            let first = format!("{path}:1:1: error[PW388]: Program of HEIDENHAIN TNC, probe cycles: 1.");
            assert!(told.starts_with(&first), "{more:?} {told}");
            assert_eq!(told.lines().count(), 2, "{more:?} {told}");
            assert!(told.ends_with("The program stopped in line 1.\n"), "{told}");
        }
        let checked = out(&probewright(&["check", &path]));
        assert!(checked.contains("PW199") && checked.contains("PW201") && !checked.contains("PW100"), "{checked}");
    }
    let output = probewright(&["write", "G427", "Q263=1"]);
    assert!(err(&output).contains("Write TCH PROBE 427 instead."), "{}", err(&output));
    assert_eq!(output.status.code(), Some(2));
}

// oracle: hand. The run goes to its end, but a word of it was not carried out.
#[test]
fn a_run_with_an_unknown_word_fails() {
    let path = file("unknown.mpf", b"G0 X1\nG987\nM2\n");
    let output = probewright(&["run", &path, "--setup", &example_setup()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).contains(":2:1: error[PW300]"), "{}", out(&output));
}

// oracle: hand (the end of a run is its last line; what was not carried out stands in it)
#[test]
fn the_last_line_of_a_run_names_what_it_passed_over() {
    for (text, last, finished, passed) in [
        ("G0 X1\nM2\n", "The program ran to its end.", true, 0),
        (
            "G0 X1\nL105\nM2\n",
            "The program ran to its end, but without: L105 (2). Line numbers are in brackets.",
            true,
            1,
        ),
        (
            "_FA=1e-09\nR1=_FA\nM2\n",
            "The program stopped in line 2; skipped before that: _FA=1e-09 (1). Line numbers are in brackets.",
            false,
            1,
        ),
    ] {
        let path = file("ending.mpf", text.as_bytes());
        let run = ["run", &path, "--setup", &example_setup()];
        assert_eq!(out(&probewright(&run)).lines().last(), Some(last), "{text}");
        let json = probewright(&[&run[..], &["--json"]].concat());
        let view: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
        assert_eq!(view["finished"], finished, "{text}");
        assert_eq!(view["passedOver"].as_array().unwrap().len(), passed, "{text}");
        assert!(view["ending"]["key"].is_string(), "{text}");
    }
}

/// A program in another encoding, with words beside its comments, and the same in UTF-8.
fn twice(language: &str, encoding: &str) -> [String; 2] {
    let folder = format!("{}/../tests/encodings/{language}", env!("CARGO_MANIFEST_DIR"));
    [encoding, "utf-8"].map(|encoding| format!("{folder}.{encoding}.mpf"))
}

// oracle: peer (the files were written by the codecs of Python, which their names tell)
#[test]
fn a_program_says_the_same_in_every_encoding() {
    for (language, encoding) in [
        ("zh", "gbk"),
        ("zh4", "gb18030"),
        ("zh", "utf-16le"),
        ("zh", "utf-16be-marked"),
        ("zh", "utf-8-marked"),
        ("ja", "shift_jis"),
        ("de", "windows-1252"),
    ] {
        let [one, other] = twice(language, encoding);
        for command in ["check", "read"] {
            let [told, wanted] = [&one, &other].map(|path| out(&probewright(&[command, path])));
            assert_eq!(told.replace(&one, &other), wanted, "{encoding}");
        }
        assert!(out(&probewright(&["read", &one])).contains("CYCLE977"));
    }
    // 测量 in GBK, where a word of the program should stand
    let path = file("gbk.mpf", b"N10 G0 \xb2\xe2\xc1\xbf=1\r\nM30\r\n");
    let same = file("utf8.mpf", "N10 G0 测量=1\r\nM30\r\n".as_bytes());
    let [told, wanted] = [&path, &same].map(|path| out(&probewright(&["check", path])));
    assert_eq!(told.replace("gbk.mpf", "utf8.mpf"), wanted);
    assert!(wanted.contains("utf8.mpf:1:"));
}

/// Every object with a key, wherever it stands.
fn keyed(document: &serde_json::Value, found: &mut Vec<serde_json::Value>) {
    match document {
        serde_json::Value::Array(list) => list.iter().for_each(|one| keyed(one, found)),
        serde_json::Value::Object(members) => {
            members.values().for_each(|one| keyed(one, found));
            found.extend(members.contains_key("key").then(|| document.clone()));
        }
        _ => {}
    }
}

// oracle: hand (a sentence is what stands under the key in the message files of the language)
#[test]
fn json_carries_the_sentence_beside_every_key() {
    let wrong = file("spoken.mpf", b"_MVAR=7 _SETVAL=10\nCYCLE977\nM30\n");
    let right = file("spoken_run.mpf", HOLE.as_bytes());
    let setup = example_setup();
    let broken = file("spoken.json", b"{ \"control\": \"nct\" }");
    for (arguments, least) in [
        (&["cycles", "--json"][..], 1000),
        (&["alarms", "--json"], 100),
        (&["alarms", "61341", "--json"], 1),
        (&["read", &wrong, "--json"], 1),
        (&["check", &wrong, "--json"], 1),
        (&["run", &right, "--setup", &setup, "--json"], 10),
        (&["run", &right, "--setup", &broken, "--json"], 1),
    ] {
        for language in ["en", "zh"] {
            let output = probewright(&[arguments, &["--lang", language]].concat());
            let view: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            let mut found = Vec::new();
            keyed(&view, &mut found);
            assert!(found.len() >= least, "{arguments:?}: {}", found.len());
            for one in found {
                let text = one["text"].as_str().unwrap_or_else(|| panic!("{arguments:?}: {one}"));
                assert!(text != one["key"] && !text.contains("{$"), "{one}");
            }
        }
    }
    let view: serde_json::Value = serde_json::from_str(&out(&probewright(&["check", &wrong, "--json"]))).unwrap();
    let finding = &view[0]["diagnostics"][0];
    assert_eq!((finding["code"].as_str(), finding["line"].as_u64()), (Some("61307"), Some(1)));
    assert_eq!(finding["message"]["text"], "CYCLE977 has no measuring variant 7.");
    let chinese = out(&probewright(&["run", &right, "--setup", &broken, "--json", "--lang", "zh"]));
    let view: serde_json::Value = serde_json::from_str(&chinese).unwrap();
    assert_eq!((&view["refused"]["text"], &view["refused"]["line"]), (&"缺少 probe。".into(), &1.into()));
    let alarm = out(&probewright(&["alarms", "61341", "--json"]));
    assert!(alarm.contains("\"cure\": \"Calibrate"), "{alarm}");
}

// oracle: hand: the probe stands in the middle of a hole of 132 mm at X180 Y130 when the call comes; what was assumed
// is a setup file with which the same comes out
#[test]
fn a_program_runs_without_a_setup_and_what_is_assumed_is_told() {
    let text = HOLE.replace("T9 D1", "T=\"TASTER\" D1");
    let path = file("assumed.mpf", text.as_bytes());
    let output = probewright(&["run", &path]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    for part in [
        "No machine was specified. Assumed: a milling machine with a SINUMERIK control",
        "T1 \"TASTER\" D1 is not known. Assumed: a calibrated probe with L1 50\u{a0}mm, radius 3\u{a0}mm.",
        "T20 D1 is not known. Assumed: an end mill",
        "Line 8, CYCLE977: the part described by the values is at X180 Y130 Z",
        "_OVR[4] = 132 mm",
    ] {
        assert!(out(&output).contains(part), "{part}: {}", out(&output));
    }
    let chinese = out(&probewright(&["run", &path, "--lang", "zh"]));
    assert!(chinese.starts_with("未给出机床。假定为带 SINUMERIK 数控系统的铣床"), "{chinese}");
    let view: serde_json::Value = serde_json::from_str(&out(&probewright(&["run", &path, "--json"]))).unwrap();
    let told = view["assumed"]["messages"].as_array().unwrap();
    assert_eq!(told.len(), 4);
    assert!(told.iter().all(|one| one["text"].is_string() && one["key"].as_str().unwrap().starts_with("assumed-")));
    let setup = file("assumed.json", view["assumed"]["setup"].to_string().as_bytes());
    let again = probewright(&["run", &path, "--setup", &setup, "--json"]);
    let again: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!(again["results"], view["results"]);
    assert!(again["assumed"].is_null());
}

// oracle: hand: parts of two calls that overlap do not get into each other's way, a face is measured from either side,
// a tool probe stands where the control believes it, and a register of NCT holds the probe
#[test]
fn what_is_assumed_fits_every_call() {
    let face = "_MVAR=100 _MA=1 _SETVAL=100 _KNUM=0 _PRNUM=1 _FA=2 _TSA=1\nCYCLE978\n";
    let hole = "_MVAR=101 _SETVAL=40 _KNUM=0 _PRNUM=1 _FA=2 _TSA=1\nCYCLE977\n";
    let program = format!(
        "G17 G54 G90 T5 D1 M6\nG0 X120 Y10\nZ-10\n{face}G0 Z50\nX80\nZ-10\n{face}G0 Z50\nX0 Y0\nZ-10\n{hole}G0 Z50\n\
            X30\n\
         Z-10\n{hole}G0 Z50\nT=\"MILL_10\" D1 M6\nG0 Z200\n_MVAR=1 _MA=3 _PRNUM=1 _FA=5 _TSA=3\nG0 X39 Y31 Z110\nM30\n"
    );
    let sinumerik = file("fits.mpf", program.as_bytes());
    let nct = file("fits.nc", b"O1\nG54 G17 G90\nT5\nG43 Z100 H5\nG101 Z-10 F1000\nG110 D50. Q2\nM30\n");
    for (path, parts) in [(&sinumerik, 4), (&nct, 1)] {
        let output = probewright(&["run", path]);
        assert!(output.status.success(), "{}{}", out(&output), err(&output));
        assert_eq!(out(&output).matches("the part described by the values is at").count(), parts, "{}", out(&output));
    }
}

// oracle: hand: what is found in a file is told there, with its own lines; the value comes from the command line
#[test]
fn files_named_with_a_program_belong_to_it() {
    let main = file("with_main.mpf", b"PROC MAIN(REAL DEPTH)\nG0 X=LIMIT+DEPTH\nDEEPER(2)\nM30\n");
    let gud = file("WITH_GUD4.DEF", b"DEF NCK REAL LIMIT=10\nDEF NCK WRONG\nM17\n");
    let sub = file("DEEPER.SPF", b"PROC DEEPER(REAL W)\nR1=W\nFROBNICATE\nM17\n");
    let output = probewright(&["run", &main, "--arg", "depth=5", "--with", &gud, &sub]);
    let text = out(&output);
    assert!(text.contains(&format!("{gud}:2:9: error[PW329]")), "{text}");
    assert!(text.contains(&format!("{sub}:3:1: note[PW310]")), "{text}");
    assert!(text.contains(&format!("FROBNICATE ({sub}:3)")) && text.contains("ran to its end"), "{text}");
    let strict = out(&probewright(&["run", &main, "--strict", "--arg", "depth=5", "--with", &gud, &sub]));
    assert!(strict.contains(&format!("stopped in {sub}, line 3.")), "{strict}");
    let checked = out(&probewright(&["check", &main, "--with", &gud, &sub]));
    assert!(checked.contains(&format!("{gud}:2:9: error[PW329]")), "{checked}");
    let alone = probewright(&["run", &main, "--strict", "--arg", "DEPTH=5"]);
    assert_eq!(alone.status.code(), Some(1));
    assert!(out(&alone).contains("LIMIT"), "{}", out(&alone));
    let wrong = probewright(&["run", &main, "--arg", "DEPTH"]);
    assert_eq!(wrong.status.code(), Some(2));
}

// oracle: hand: a count that scripts give ends the run, none does not
#[test]
fn a_run_is_given_up_after_the_blocks_that_are_named() {
    let path = file("counting.mpf", b"WHILE R1<120000\nR1=R1+1\nENDWHILE\nM30\n");
    let limited = probewright(&["run", &path, "--max-blocks", "1000"]);
    assert_eq!(limited.status.code(), Some(1));
    assert!(out(&limited).contains("No end after 1000 blocks"), "{}", out(&limited));
    let whole = probewright(&["run", &path]);
    assert_eq!((whole.status.code(), &*whole.stderr), (Some(0), &b""[..]), "{}", out(&whole));
    let wrong = probewright(&["run", &path, "--max-blocks", "many"]);
    assert_eq!(wrong.status.code(), Some(2));
}

// oracle: hand
#[test]
fn what_was_assumed_for_the_machine_ends_the_run() {
    let path = file("inputs.mpf", b"R1=$A_IN[1]\nR2=$A_IN[2]\nM30\n");
    let text = out(&probewright(&["run", &path]));
    assert!(text.contains("\nMachine values that were assumed: $A_IN[1] = 0 (1), $A_IN[2] = 0 (2)."), "{text}");
    let json: serde_json::Value = serde_json::from_str(&out(&probewright(&["run", &path, "--json"]))).unwrap();
    assert_eq!(json["machineValues"][1], serde_json::json!({ "name": "$A_IN[2]", "value": 0.0, "line": 2 }));
}

// oracle: hand: a folder has every program below it; what a program writes is shown, and saved where that is asked for
#[test]
fn a_folder_is_beside_a_program_and_takes_its_files() {
    let main =
        file("writes.mpf", b"DEF INT F\nG0 X=LIMIT\nDEEP\nWRITE(F,\"/_N_MPF_DIR/_N_LOG_MPF\",\"X \"<<R1)\nM30\n");
    let folder = std::path::Path::new(&main).with_file_name("folder_beside");
    let below = folder.join("below");
    std::fs::create_dir_all(&below).unwrap();
    std::fs::write(folder.join("UGUD.DEF"), "DEF NCK REAL LIMIT=10\nM17\n").unwrap();
    std::fs::write(below.join("DEEP.SPF"), "R1=4\nM17\n").unwrap();
    std::fs::write(folder.join("picture.png"), [0, 1, 2]).unwrap();
    let beside = folder.to_string_lossy().into_owned();
    let shown = probewright(&["run", &main, "--with", &beside]);
    assert!(shown.status.success(), "{}{}", out(&shown), err(&shown));
    assert!(out(&shown).contains("File LOG.MPF, lines: 1"), "{}", out(&shown));
    let written = folder.with_file_name("folder_written");
    _ = std::fs::remove_dir_all(&written);
    let saved = probewright(&["run", &main, "--with", &beside, "--log", &written.to_string_lossy()]);
    assert!(saved.status.success(), "{}{}", out(&saved), err(&saved));
    assert_eq!(std::fs::read_to_string(written.join("LOG.MPF")).unwrap(), "X 4\n");
    let json: serde_json::Value =
        serde_json::from_str(&out(&probewright(&["run", &main, "--with", &beside, "--json"]))).unwrap();
    assert_eq!(json["written"][0]["lines"], serde_json::json!(["X 4"]));
}

// oracle: hand
#[test]
fn one_program_of_an_archive_is_run() {
    let path = file("two.arc", b"%_N_ONE_MPF\nR1=1\nM30\n%_N_TWO_MPF\nR1=2\nM30\n");
    for (name, worth) in [("ONE", 1.0), ("two", 2.0)] {
        let json = out(&probewright(&["run", &path, "--program", name, "--json"]));
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        let result = &json["results"][0];
        assert_eq!((&result["name"], &result["value"]), (&"R1".into(), &worth.into()), "{name}");
    }
    let none = probewright(&["run", &path, "--program", "THREE"]);
    assert_eq!(none.status.code(), Some(1));
    assert!(
        out(&none).contains("There is no program “THREE” in this text. Programs in it: ONE, TWO."),
        "{}",
        out(&none)
    );
}

// oracle: JCGM 100, eq. 10: two touches and two of the calibration: u = 2σ; the hole of the readme is 0.03 mm
// too large, far within its limits of 0.1 mm
#[test]
fn the_certainty_of_a_program_is_told_for_each_call() {
    let program = file("certain.mpf", HOLE.as_bytes());
    let mut setup: serde_json::Value = serde_json::from_slice(&std::fs::read(example_setup()).unwrap()).unwrap();
    setup["probe"]["repeatability"] = serde_json::json!([0.001, 1]);
    let path = file("certain.setup.json", setup.to_string().as_bytes());
    let asked = ["series", &program, "--setup", &path, "--certainty"];
    let text = out(&probewright(&asked));
    assert!(text.contains("certain.mpf:8: CYCLE977\n  _OVR[4] = 132.0") && text.contains("(k = 2)"), "{text}");
    assert!(
        text.contains("Proven good.  good > 99.9 %, rework < 0.1 %") && text.ends_with("From 400 runs.\n"),
        "{text}"
    );
    let output = probewright(&[&asked[..], &["--json", "--runs", "1000"]].concat());
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let size = &document["calls"][0]["figures"][0];
    assert!((size["expanded"].as_f64().unwrap() / 0.004 - 1.0).abs() < 0.12, "{size}");
    let output = probewright(&["series", &program, "--setup", &example_setup(), "--certainty"]);
    assert!(output.status.code() == Some(1) && out(&output).contains("Nothing spreads"), "{}", out(&output));
}

// oracle: hand: the hole of the readme is 0.03 mm too large; its size varies by 0.01 mm
#[test]
fn a_series_tells_how_results_spread() {
    let program = file("series.mpf", HOLE.as_bytes());
    let setup = std::fs::read_to_string(example_setup()).unwrap();
    let vary = r#"{ "what": "workpiece[0].errors.size", "sigma": 0.01 }"#;
    let with = |vary: &str| setup.replacen('{', &format!(r#"{{ "series": {{ "vary": [{vary}] }},"#), 1);
    let path = file("series.setup.json", with(vary).as_bytes());
    let asked = ["series", &program, "--setup", &path, "--runs", "200", "--seed", "5"];
    let output = probewright(&asked);
    let text = out(&output);
    assert!(output.status.success() && text.starts_with("200 runs, 200 to the end, seed 5\n"), "{text}");
    assert!(text.contains("series.mpf:8: CYCLE977") && text.contains("Cpk") && text.contains("No alarm"), "{text}");
    assert_eq!(text, out(&probewright(&asked)), "the same seed gives the same bytes");
    let table = std::env::temp_dir().join(format!("probewright-{}", std::process::id())).join("series.csv");
    let output = probewright(&[&asked[..], &["--json", "--csv", table.to_str().unwrap()]].concat());
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let size = &document["calls"][0]["measured"][0];
    let off = (size["mean"].as_f64().unwrap() - 132.03).abs();
    assert!(off < 4.0 * size["meanError"].as_f64().unwrap(), "{size}");
    assert_eq!(std::fs::read_to_string(table).unwrap().lines().count(), 201);
    for (wrong, place) in [(vary.replace("[0]", "[9]"), "series.vary[0].what"), (vary.replace("0.01", "-1"), "sigma")] {
        let path = file("series.wrong.json", with(&wrong).as_bytes());
        let output = probewright(&["series", &program, "--setup", &path]);
        assert!(output.status.code() == Some(2) && err(&output).contains(place), "{}", err(&output));
    }
}

// oracle: manual A:16128-16737 (R19 of a hole with a protection zone is printed beside two parameters)
#[test]
fn a_program_of_the_840c_is_converted_once_it_is_clear() {
    let folder = std::env::temp_dir().join(format!("probewright-older-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("old.mpf");
    let path = file.to_str().unwrap();
    // a comment in a code page: its bytes stay
    std::fs::write(&file, b"R23=1101 R19=-20 R31=0 ; Bohrung \xfc\r\nL977\r\n").unwrap();
    let asked = probewright(&["older", path]);
    assert_eq!((asked.status.code(), out(&asked).as_str()), (Some(1), ""));
    assert!(err(&asked).contains("PW211") && err(&asked).contains("_SZA"), "{}", err(&asked));
    let done = probewright(&["older", path, "--answer", "r19=_id"]);
    assert_eq!(done.status.code(), Some(0));
    assert_eq!(done.stdout, b"_MVAR=1101 _ID=-20 ; Bohrung \xfc\r\nCYCLE977\r\n");
    assert!(err(&done).contains("R31=0"), "{}", err(&done));
    let told = out(&probewright(&["older", path, "--explain"]));
    assert!(told.starts_with("2: L977 → CYCLE977\n") && told.contains("R19=-20  _ID: "), "{told}");
    let view: serde_json::Value = serde_json::from_str(&out(&probewright(&["older", path, "--json"]))).unwrap();
    assert_eq!(view["calls"][0]["parameters"].as_array().unwrap().len(), 3);
    assert_eq!(probewright(&["older", path, "--answer", "R19=_FA"]).status.code(), Some(2));
    for [first, second] in [["R19=_ID", "R19=_SZA"], ["R19=_ID", "r19=_SZA"], ["R32=_SETVAL", "R42=_SETVAL"]] {
        let refused = probewright(&["older", path, "--answer", first, "--answer", second]);
        assert_eq!((refused.status.code(), out(&refused).as_str()), (Some(2), ""), "{first} {second}");
        assert!(err(&refused).contains(first), "{}", err(&refused));
    }
    let idle = probewright(&["older", path, "--answer", "R19=_ID", "--answer", "R31=_MD"]);
    assert!(idle.status.success() && err(&idle).contains("PW240"), "{}", err(&idle));
    // what cannot be read: which call stays, where, and why
    std::fs::write(&file, "R23=100 R32=(80 R22=1\nL978\n").unwrap();
    let unread = probewright(&["older", path]);
    assert_eq!((unread.status.code(), out(&unread).as_str()), (Some(1), ""));
    assert!(err(&unread).contains("PW235") && err(&unread).contains("PW100"), "{}", err(&unread));
    std::fs::write(&file, "G0 X1\n").unwrap();
    assert_eq!(probewright(&["older", path]).status.code(), Some(2));
    std::fs::remove_dir_all(&folder).unwrap();
}

// oracle: manual B:1696 (values of an earlier call count on), DESIGN.md (what is left open is listed, calls are told)
#[test]
fn a_program_of_the_840c_is_converted_with_its_subprograms() {
    let folder = std::env::temp_dir().join(format!("probewright-older-with-{}", std::process::id()));
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    std::fs::create_dir_all(&folder).unwrap();
    let (main, sub, into) = (path("main.mpf"), path("L100.SPF"), path("today"));
    // no line end behind the last line
    std::fs::write(&main, "R23=1 R22=1 ; \u{fc}\nL100\nL977\nM30").unwrap();
    std::fs::write(&sub, "R32=80\nM17\n").unwrap();
    let alone = probewright(&["older", &main]);
    assert_eq!(out(&alone), "_MVAR=1 _PRNUM=1 ; \u{fc}\nL100\nCYCLE977\nM30");
    assert!(err(&alone).contains("PW310") && err(&alone).contains("L100"), "{}", err(&alone));
    assert!(err(&alone).contains("PW217") && err(&alone).contains("R27 (_NMSP=1)"), "{}", err(&alone));
    assert!(!err(&alone).contains("PW210"), "{}", err(&alone));
    let told = out(&probewright(&["older", &main, "--explain"]));
    assert!(told.contains("R27  _NMSP: ") && !told.contains("R32"), "{told}");
    let told = out(&probewright(&["older", &main, "--explain", "--with", &sub]));
    assert!(told.starts_with("3: L977 → CYCLE977\n") && told.contains("R32=80  _SETVAL: "), "{told}");
    // both change: nothing of it without a place for both
    let both = probewright(&["older", &main, "--with", &sub]);
    assert_eq!((both.status.code(), out(&both).as_str()), (Some(1), ""));
    assert!(err(&both).contains("--into") && err(&both).contains("L100.SPF") && !err(&both).contains("PW310"));
    let same = probewright(&["older", &main, "--with", &sub, "--into", folder.to_str().unwrap()]);
    assert_eq!(same.status.code(), Some(2), "{}", err(&same));
    let done = probewright(&["older", &main, "--with", &sub, "--into", &into]);
    assert_eq!(done.status.code(), Some(0), "{}", err(&done));
    let text = |name: &str| std::fs::read_to_string(folder.join("today").join(name)).unwrap();
    assert_eq!(text("main.mpf"), "_MVAR=1 _PRNUM=1 ; \u{fc}\nL100\nCYCLE977\nM30");
    assert_eq!(text("L100.SPF"), "_SETVAL=80\nM17\n");
    assert_eq!(std::fs::read_to_string(&sub).unwrap(), "R32=80\nM17\n");
    std::fs::remove_dir_all(&folder).unwrap();
}

// oracle: manual B:13276-13288 (lines of the example), self (what is saved in a setup is read from it)
#[test]
fn definition_files_are_read_and_written() {
    let folder = std::env::temp_dir().join(format!("probewright-definitions-{}", std::process::id()));
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("GUD6.DEF"), "N10 DEF NCK INT _CVAL[4]=(2,2,0,0)\n_CBIT[14]=1\n").unwrap();
    let (file, setup, saved, into) = (path("GUD6.DEF"), example_setup(), path("saved.json"), path("lines"));
    let asked = ["definitions", &file, "--setup", &setup, "--save", &saved, "--into", &into, "--channels", "2"];
    let done = probewright(&asked);
    assert_eq!(done.status.code(), Some(0), "{}", err(&done));
    let lines = std::fs::read_to_string(folder.join("lines/GUD6-lines.txt")).unwrap();
    assert!(
        lines.starts_with("N10 DEF NCK INT _CVAL[4]=(2,2,0,0)\n") && lines.contains(";N13 DEF NCK REAL _KB"),
        "{lines}"
    );
    assert!(out(&done).contains("MD18150") && out(&done).contains("_TP[2,10]"), "{}", out(&done));
    let again = probewright(&["definitions", "--setup", &saved]);
    assert!(out(&again).contains("N10 DEF NCK INT _CVAL[4]=(2,2,0,0)"), "{}", out(&again));
    std::fs::write(folder.join("x.mpf"), "G0 X1\n").unwrap();
    assert_eq!(probewright(&["definitions", &path("x.mpf")]).status.code(), Some(2)); // no datum of a machine
    // an export in inch: the setup that is saved is a machine in inch, whose files say so
    std::fs::write(folder.join("INCH.INI"), "CHANDATA(1)\nMD10240=0\n_SPEED[1]=40\n").unwrap();
    let done = probewright(&["definitions", &path("INCH.INI"), "--save", &saved]);
    assert!(err(&done).starts_with("2 values read, 2 changed, 0 not accepted."), "{}", err(&done));
    let setup: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&saved).unwrap()).unwrap();
    assert_eq!((&setup["units"], &setup["data"]), (&"inch".into(), &serde_json::json!({ "_SPEED[1]": 40.0 })));
    let again = probewright(&["definitions", "--setup", &saved]);
    assert!(out(&again).contains("_CBIT[3]=0") && out(&again).contains("_SPEED[1]=40 "), "{}", out(&again));
    // without a machine the core's own begins, and what is saved is one: of a newer control, with the lines read
    let newer = path("A.TEA");
    let lines = "N54600 $SNS_MEA_WP_BALL_DIAM[0]=5.9\nCHANDATA(1)\nN55634 $SCS_MEA_FEED_PLANE_VALUE=700\n";
    std::fs::write(&newer, lines).unwrap();
    let done = probewright(&["definitions", &newer, "--save", &saved]);
    assert_eq!((done.status.code(), err(&done).lines().count()), (Some(0), 2), "{}", err(&done));
    assert!(err(&done).starts_with("2 values read, 2 changed, 0 not accepted."), "{}", err(&done));
    let again = probewright(&["definitions", "--setup", &saved]);
    assert_eq!(out(&again), format!("; PW_MEAS.TEA\n{lines}\n"));
    let call = super::file("newer-control.mpf", b"G54 G17 T1 D1 M6\n_MVAR=1 _SETVAL=9\nCYCLE977\nM30\n");
    assert!(out(&probewright(&["check", &call, "--setup", &saved])).contains("PW197"));
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A setup file of an NCT mill on which G120 calls O9019.
fn renumbered() -> String {
    let setup = br#"{ "control": "nct", "data": { "P9050": 120, "PW-MACRO-LEVELS": 3 },
        "probe": { "radius": 3, "length": 50 } }"#;
    file("renumbered.json", setup)
}

// oracle: manual C:58 (parameter 9050 holds the number of the function that calls O9019)
#[test]
fn read_and_write_follow_the_functions_of_the_machine() {
    let machine = renumbered();
    let path = file("renumbered.nc", b"O0100\nM19\nT98\nG120 D50 S1\nM30\n");
    let on_it = out(&probewright(&["read", &path, "--setup", &machine]));
    assert!(on_it.contains("G110") && on_it.contains("D=50"), "{on_it}");
    assert!(!out(&probewright(&["read", &path, "--control", "nct"])).contains("D=50"));
    let json = out(&probewright(&["read", &path, "--setup", &machine, "--json"]));
    let view: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(view["calls"][0]["cycle"], "G110", "{json}");
    for name in ["G110", "G120"] {
        let written = out(&probewright(&["write", name, "D=50", "S=1", "--setup", &machine]));
        assert!(written.contains("G120") && written.contains("D50"), "{written}");
    }
    let refused = probewright(&["write", "CYCLE977", "--setup", &machine]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains("CYCLE977"), "{}", err(&refused));
}

// oracle: manual C:58 (a number calls one macro; parameters are whole numbers up to 999)
#[test]
fn a_number_that_two_macros_have_is_not_written_for_the_second() {
    let machine = |number: &str| {
        let probe = r#""probe": { "radius": 3, "length": 50 }"#;
        let text = format!(r#"{{ "control": "nct", "data": {{ "P9050": {number} }}, {probe} }}"#);
        file(&format!("function{number}.json"), text.as_bytes())
    };
    let write = |number: &str| probewright(&["write", "G110", "D=40", "S=1", "--setup", &machine(number)]);
    let written = out(&write("109"));
    assert!(written.contains("G65 P9019 ") && !written.contains("G109"), "{written}");
    for wrong in ["-3", "120.5", "1000"] {
        let refused = write(wrong);
        assert_eq!(refused.status.code(), Some(2), "{wrong}");
        assert!(err(&refused).contains("P9050") && err(&refused).contains("999"), "{}", err(&refused));
    }
}

// oracle: hand (a name of the catalogue is the same macro on every machine; the message has the name that was written)
#[test]
fn write_takes_a_name_of_the_catalogue_for_its_macro() {
    let text =
        br#"{ "control": "nct", "data": { "P9049": 110, "P9050": 109 }, "probe": { "radius": 3, "length": 50 } }"#;
    let swapped = file("swapped.json", text);
    let written = out(&probewright(&["write", "G110", "D=50", "S=1", "--setup", &swapped]));
    assert!(written.contains("G109") && written.contains("D50"), "{written}");
    let refused = err(&probewright(&["write", "G120", "NONE=50", "--setup", &renumbered()]));
    assert!(refused.contains("G120") && refused.contains("NONE"), "{refused}");
}

// oracle: hand (the program is what is asked for; that the simulated probe does not switch is beside it)
#[test]
fn a_probe_test_is_printed_whatever_its_touches_come_to() {
    for text in ["--function", "--program"] {
        let done = probewright(&["repeat", text, "--from", "0", "--to", "0.1"]);
        assert_eq!(done.status.code(), Some(0), "{text}: {}", err(&done));
        assert!(out(&done).contains("MEAS"), "{}", out(&done));
    }
    let negative = err(&probewright(&["repeat", "--parameters", "-1"]));
    assert!(negative.contains("10,000") || negative.contains("10000"), "{negative}");
}

// oracle: manual B:13064-13069 (MD11420 is 1 to 1000000)
#[test]
fn a_setup_with_a_value_outside_of_its_limits_is_told() {
    let text = br#"{ "control": "sinumerik", "data": { "MD11420": 0, "_MT_COMP": 9 },
        "probe": { "radius": 3, "length": 50 } }"#;
    let setup = file("outside.json", text);
    let path = file("outside.mpf", b"G0 X1\nM30\n");
    let done = probewright(&["run", &path, "--setup", &setup]);
    assert_eq!(done.status.code(), Some(0), "{}", err(&done));
    assert!(err(&done).contains("warning: MD11420") && err(&done).contains("warning: _MT_COMP"), "{}", err(&done));
    let fine = probewright(&["run", &path, "--setup", &example_setup()]);
    assert!(!err(&fine).contains("warning"), "{}", err(&fine));
}

// oracle: hand (a search ends somewhere)
#[test]
fn a_block_search_asks_for_its_target() {
    let path = file("search.mpf", b"G0 X1\nM30\n");
    for wrong in [&["--mode", "block-search"][..], &["--mode", "block-search", "--target", "0"]] {
        let refused = probewright(&[&["run", &path], wrong].concat());
        assert_eq!(refused.status.code(), Some(2), "{wrong:?}");
        assert!(err(&refused).contains("--target"), "{}", err(&refused));
    }
    assert_eq!(probewright(&["run", &path, "--target", "2"]).status.code(), Some(0));
}

// oracle: manual C:1157 (2 levels of macros below G110)
#[test]
fn check_counts_the_levels_of_macros() {
    let text = b"O0100\nG65 P200\nM30\nO0200\nM19\nG120 D50 S1\nM99\n";
    let path = file("levels.nc", text);
    let told = out(&probewright(&["check", &path, "--setup", &renumbered()]));
    assert!(told.contains(":6:1: error[PW223]"), "{told}");
}

// oracle: manual B:2482-2508 (CYCLE198 runs before the measurement, at the label of the cycle)
#[test]
fn read_and_run_say_what_the_user_runs_around_a_call() {
    let own = file("CYCLE198.SPF", b"PROC CYCLE198\n_M977:\nM8\nM17\n");
    let path = file("around.mpf", HOLE.as_bytes());
    for command in [&["read", &path, "--with", &own][..], &["run", &path, "--setup", &example_setup(), "--with", &own]]
    {
        let output = probewright(command);
        assert!(out(&output).contains("CYCLE198 runs before this call, from _M977 (line 2)"), "{}", out(&output));
    }
}

// oracle: hand (a value that the variant does not use is no value of the call)
#[test]
fn write_names_values_that_it_does_not_write() {
    let values =
        ["_MVAR=101", "_SETVAL=50", "_KNUM=1", "_FA=8", "_TSA=5", "_ID=-10", "_TZL=0.5", "_EVNUM=3", "_TNAME=X"];
    for style in ["direct", "operate"] {
        let asked = ["write", "CYCLE977", "--style", style].into_iter().chain(values);
        let output = probewright(&asked.collect::<Vec<_>>());
        assert!(output.status.success(), "{}", err(&output));
        for name in ["_ID=-10", "_TZL=0.5", "_EVNUM=3", "_TNAME=X"] {
            assert!(err(&output).contains(name) && err(&output).contains("PW232"), "{style} {name}: {}", err(&output));
        }
    }
    let own =
        ["write", "CYCLE977", "--style", "operate", "_MVAR=101", "_SETVAL=50", "_KNUM=1", "S_ID=-10", "S_EVNUM=3"];
    let output = probewright(&own);
    assert!(out(&output).contains(",-10,") && !err(&output).contains("PW232"), "{} {}", out(&output), err(&output));
}

// oracle: peer (CamHelper cd6e996 writes 6 as the rotary axis of CYCLE998)
#[test]
fn write_takes_the_rotary_axis_that_programs_have() {
    let values = ["_MVAR=105", "_SETVAL=1", "_MA=102", "_STA1=0", "_ID=40", "_KNUM=1", "_FA=10", "_TSA=5", "S_MD=1"];
    for (axis, written, noted) in [("6", true, false), ("4", true, true), ("0", true, false), ("7", false, true)] {
        let axis = format!("_RA={axis}");
        let asked = ["write", "CYCLE998", "--style", "operate", &axis].into_iter().chain(values);
        let output = probewright(&asked.collect::<Vec<_>>());
        assert_eq!(output.status.success(), written, "{axis} {}", err(&output));
        assert_eq!(err(&output).contains("PW188"), noted, "{axis} {}", err(&output));
    }
}

// oracle: hand (elsewhere the file is what it was, byte for byte)
#[test]
fn convert_writes_a_program_in_another_style() {
    let text = b"; Ma\xdf\r\n_MVAR=101 _SETVAL=50 _KNUM=1 _FA=10 _TSA=5 _CORA=1\r\nCYCLE977 ; bore\r\nX=_FA\r\nM30\r\n";
    let path = file("convert.mpf", text);
    let output = probewright(&["convert", &path, "--style", "operate"]);
    assert!(output.status.success(), "{}", err(&output));
    for said in [":3:1: ", "_CORA=1", "PW221", "_FA (4)"] {
        assert!(err(&output).contains(said), "{said}: {}", err(&output));
    }
    assert!(output.stdout.starts_with(b"; Ma\xdf\r\n_FA=10\r\nCYCLE977(101,1,"));
    assert!(output.stdout.ends_with(b") ; bore\r\nX=_FA\r\nM30\r\n"));
    assert_eq!(std::fs::read(&path).unwrap(), text);
    let same = probewright(&["convert", &path, "--style", "direct"]);
    assert_eq!((same.status.code(), out(&same).as_str()), (Some(1), ""));
    let none = probewright(&["convert", &path, "--style", "operate", "--line", "2"]);
    assert_eq!(none.status.code(), Some(2), "{}", err(&none));
    let done = probewright(&["convert", &path, "--style", "operate", "--line", "3", "--write"]);
    assert!(done.status.success() && out(&done).contains("calls converted: 1"), "{}", out(&done));
    assert_eq!(std::fs::read(&path).unwrap(), output.stdout);
    let tool = file("tool.mpf", b"CYCLE977(101,1,2001,1,50,,,10,5)\nM30\n");
    let refused = probewright(&["convert", &tool, "--style", "direct"]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(err(&refused).contains("tool.mpf:1:1: error[PW188]"), "{}", err(&refused));
    let wide: Vec<u8> =
        [0xff, 0xfe].into_iter().chain("CYCLE978\r\n".encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let wide = file("wide.mpf", &wide);
    let unchanged = probewright(&["convert", &wide, "--style", "indirect", "--write"]);
    assert!(!unchanged.status.success(), "{}", err(&unchanged));
}
