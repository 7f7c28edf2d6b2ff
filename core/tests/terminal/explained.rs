//! What there is: cycles, alarms, data, in the language of the user.

use super::{err, file, out, probewright};
use std::process::Command;

// oracle: issue text
#[test]
fn cycles_as_json_have_the_agreed_shape() {
    let output = probewright(&["cycles", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&out(&output)).unwrap();
    let hole = list.as_array().unwrap().iter().find(|entry| entry["cycle"] == "CYCLE977").unwrap();
    assert_eq!(hole["control"], "sinumerik");
    assert_eq!(hole["variants"].as_array().unwrap().len(), 24);
    assert_eq!(hole["variants"][0]["mvar"], 1);
    assert!(hole["parameters"].as_array().unwrap().iter().any(|param| param["name"] == "_SETVAL"));
    assert!(hole["results"].as_array().unwrap().iter().any(|result| result["name"] == "_OVR[4]"));
}

// oracle: manual A:15882 (who raises it, what stops), A:15941; our own words
#[test]
fn alarms_explains_one_and_lists_all() {
    let one = out(&probewright(&["alarms", "61341"]));
    assert!(one.starts_with("61341: The probe is not calibrated"), "{one}");
    for part in ["remedy     Calibrate", "NC RESET", "CYCLE978, CYCLE979", "Measuring Cycles 10/2004, 11"] {
        assert!(one.contains(part), "{part}: {one}");
    }
    let message = out(&probewright(&["alarms", "probe fail"]));
    assert!(message.contains("raised by  G102, G103"), "{message}");
    let all = out(&probewright(&["alarms"]));
    assert!(all.lines().count() > 100, "{all}");
    let list = out(&probewright(&["alarms", "--json"]));
    let list: serde_json::Value = serde_json::from_str(&list).unwrap();
    let oversize = list.as_array().unwrap().iter().find(|one| one["code"] == "62304");
    assert_eq!(oversize.unwrap()["stops"], false);
    let unknown = probewright(&["alarms", "4711"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(err(&unknown).contains("4711"));
}

// oracle: manual B:5645-5651 (variants), B:7546 (alarm), A:15882; the words are our own
#[test]
fn explain_knows_cycles_variants_data_and_alarms() {
    let explained = |arguments: &[&str]| {
        let output = probewright(&[&["explain"], arguments].concat());
        assert!(output.status.success(), "{}", err(&output));
        out(&output)
    };
    // oracle: peer (the published lists and remedies of newer controls)
    for (name, said) in [
        ("S_KNUM1", "CYCLE977 (3)"),
        ("cycle996", "   4  S_SETV: Diameter of the calibration ball\n"),
        ("61444", "calibrate with it"),
        ("SD54600", "On older controls: _WP[k,0]\n"),
        ("$SNS_MEA_WP_BALL_DIAM", "SD54600 $SNS_MEA_WP_BALL_DIAM: "),
        ("G430", "TCH PROBE 430 (HEIDENHAIN TNC): "),
        ("TCH PROBE 415", "TCH PROBE 415 is not published"),
        ("PW-GENERATION", "PW-GENERATION: "),
        ("pw-jog", "PW-JOG: "),
    ] {
        let told = explained(&[name]);
        assert!(told.contains(said), "{told}");
    }
    let cycle = explained(&["cycle977"]);
    assert!(cycle.contains("     101  Hole: correct a zero offset\n"), "{cycle}");
    let variant = explained(&["CYCLE977", "101"]);
    for part in [
        "CYCLE977 101: Hole: correct a zero offset\n",
        "\nStart position of the probe\n  ",
        "Inputs: _SETVAL, _KNUM.\n",
        "(Measuring Cycles 04/2006, 5.4.2.3)\n",
    ] {
        assert!(variant.contains(part), "{part}: {variant}");
    }
    let chinese = explained(&["CYCLE100", "--lang", "zh"]);
    assert!(chinese.contains("\n执行顺序\n  "), "{chinese}");
    let zone = explained(&["_sza"]);
    assert!(zone.starts_with("_SZA: ") && zone.contains("CYCLE977, "), "{zone}");
    let result = explained(&["_OVR[4]"]);
    assert!(result.contains("CYCLE977") && !result.contains("_OVR[5]"), "{result}");
    let finding = explained(&["pw135"]);
    assert!(
        finding.starts_with("PW135: This program does not calibrate probe … before this call: ")
            && finding.contains("\n  Calibrate the probe on this machine first"),
        "{finding}"
    );
    let both = explained(&["PW137"]);
    assert_eq!(both.matches("PW137: ").count(), 3, "{both}");
    assert!(explained(&["PW317", "--lang", "zh"]).starts_with("PW317: "));
    assert!(explained(&["_CBIT[12]"]).starts_with("_CBIT[12]: "));
    assert!(explained(&["MD18102"]).contains("MM_TYPE_OF_CUTTING_EDGE"));
    assert_eq!(explained(&["61341"]), out(&probewright(&["alarms", "61341"])));
    for wrong in [["CYCLE977", "7"], ["_NONE", "1"], ["PW399", "1"]] {
        let output = probewright(&["explain", wrong[0], wrong[1]]);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains(wrong[0]), "{}", err(&output));
    }
}

// oracle: hand
#[test]
fn the_language_is_asked_for_or_taken_from_the_environment() {
    let chinese = |text: &str| text.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c));
    assert!(chinese(&out(&probewright(&["--lang", "zh", "cycles"]))));
    assert!(!chinese(&out(&probewright(&["cycles"]))));
    let environment =
        Command::new(env!("CARGO_BIN_EXE_probewright")).env("LC_ALL", "zh_CN.UTF-8").arg("cycles").output().unwrap();
    assert!(chinese(&out(&environment)));
    let unknown = probewright(&["cycles", "--lang", "xx"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&unknown.stderr).contains("en, zh"));
}

// oracle: manual A:14245 and B:16186 (70 and 80 names), B:12976-12983 (bit 5), A:15840
#[test]
fn machine_checks_what_a_control_exported() {
    let export = file("check.tea", b"CHANDATA(1)\r\nN18170 $MN_MM_NUM_MAX_FUNC_NAMES=40\r\nMD28082=1\r\n\xff\r\n");
    let lines = format!("{export}.changed");
    let output = probewright(&["machine", &export, "--changes", &lines]);
    assert_eq!(output.status.code(), Some(1), "{}", err(&output));
    let told = out(&output);
    assert!(told.contains(":2: error: MD18170 MM_NUM_MAX_FUNC_NAMES: 40 is too low; at least 70."), "{told}");
    assert!(told.contains(":3: error[61016]: MD28082 MM_SYSTEM_FRAME_MASK (channel 1): "), "{told}");
    assert!(told.contains("required: 80 (Measuring Cycles 10/2004"), "{told}");
    let changed = std::fs::read_to_string(&lines).unwrap();
    assert!(changed.contains("N28082 $MC_MM_SYSTEM_FRAME_MASK='H21'\n"), "{changed}");
    let again = probewright(&["machine", &export, &lines, "--json"]);
    let view: serde_json::Value = serde_json::from_str(&out(&again)).unwrap();
    let left: Vec<_> =
        view["faults"].as_array().unwrap().iter().map(|fault| fault["message"]["key"].as_str()).collect();
    assert!(left.iter().all(|key| *key == Some("machine-check-twice")), "{left:?}");
    assert_eq!((again.status.code(), view["changes"].as_str()), (Some(0), Some("")));
    let archive = file("check.arc", b"\x00\x01\x02\xfe\x00\r\nMD18118=7\r\n\x00\x00\x7f\x00");
    assert_eq!(probewright(&["machine", &archive]).status.code(), Some(0));
    let nothing = probewright(&["machine", &file("check.nc", b"N10 G0 X1\n")]);
    assert_eq!(nothing.status.code(), Some(2));
}

// oracle: manual B:1184-1196 (12.6 mm), hand (the largest feed for 2 mm)
#[test]
fn braking_tells_path_and_feed() {
    let axis = ["braking", "--delay", "0.016", "--acceleration", "1", "--gain", "1"];
    let asked = |more: &[&str]| probewright(&[&axis, more].concat());
    let told = out(&asked(&["--feed", "6000", "--deflection", "2"]));
    assert!(told.contains("12.6\u{a0}mm: 1.6\u{a0}mm until") && told.contains("1372.4\u{a0}mm/min"), "{told}");
    let view: serde_json::Value = serde_json::from_str(&out(&asked(&["--feed", "6000", "--json"]))).unwrap();
    assert!((view["path"]["sum"].as_f64().unwrap() - 12.6).abs() < 1e-9 && view["feed"].is_null());
    let nothing = asked(&[]);
    assert_eq!((nothing.status.code(), out(&nothing)), (Some(2), String::new()));
    assert!(err(&nothing).contains("--feed") && err(&nothing).contains("--deflection"), "{}", err(&nothing));
    for name in ["--feed", "--deflection"] {
        let negative = err(&asked(&[name, "-100"]));
        assert!(negative.contains("-100") && !negative.contains("-1 "), "{negative}");
    }
    for wrong in ["--feed=-1", "--deflection=-2", "--deflection=0"] {
        assert_eq!(asked(&[wrong]).status.code(), Some(2), "{wrong}");
    }
    let export = file("axis.ini", b"MD18118=7\nMD32300[X1]=-1\nMD32200[X1]=0\n");
    for wrong in ["--deflection=-2", "--deflection=0"] {
        assert_eq!(probewright(&["machine", &export, wrong]).status.code(), Some(2), "{wrong}");
    }
    let told = out(&probewright(&["machine", &export, "--deflection", "2"]));
    assert!(told.contains("warning: MD32300[X1]") && told.contains("warning: MD32200[X1]"), "{told}");
}

// oracle: hand (what somebody types), manual B:12697
#[test]
fn connections_and_idle_data_are_explained() {
    let told = |name: &str| out(&probewright(&["explain", name]));
    for name in ["distributor", "cable distributor", "Cable distributor on 810D, 840D powerline, 840Di"] {
        assert!(told(name).contains("X11"), "{name}");
    }
    assert!(told("NCT: stylus").starts_with("NCT: stylus: "), "{}", told("NCT: stylus"));
    for name in ["MD13200", "MD13200[0]", "MD18116"] {
        assert!(told(name).contains("No effect in the simulation"), "{name}: {}", told(name));
    }
}

// oracle: manual A:16452, A:16479 (R19 is printed beside _ID and _SZA), A:16018-16041
#[test]
fn programs_of_older_versions_are_explained() {
    let told = |name: &str| out(&probewright(&["explain", name]));
    let parameter = told("r19");
    assert!(parameter.contains("_ID: CYCLE961") && parameter.contains("_SZA: CYCLE977, CYCLE994"), "{parameter}");
    let call = told("L977");
    assert!(call.contains("CYCLE977") && call.contains("R42  _SETVAL: ") && !call.contains("R20"), "{call}");
    assert!(told("CYCLE103").contains("A:15977") || told("CYCLE103").contains("SW 3.2"), "{}", told("CYCLE103"));
    assert_eq!(probewright(&["explain", "R14"]).status.code(), Some(2));
    // B:2247-2251: the factor of the measuring path
    assert!(told("R28").contains("factor of the measuring path"), "{}", told("R28"));
}

// oracle: manual B:12145-12406, A:13964-13968
#[test]
fn where_a_form_is_and_which_versions_work_together_are_told() {
    let variant = out(&probewright(&["explain", "CYCLE977", "4"]));
    assert!(variant.contains("Measurem. milling > Workpiece measure > Slot or web"), "{variant}");
    let versions = out(&probewright(&["commissioning", "compatibility"]));
    assert!(versions.contains("NCU SW 6.2\n  Cycles SW 5.3/5.4: yes; Cycles from SW 6.2: no"), "{versions}");
}

// oracle: self: the lines that guides give for the terminal are ones that it takes; their files are the reader's
#[test]
fn guides_are_listed_and_their_lines_are_commands() {
    let list = out(&probewright(&["explain", "guides"]));
    for guide in probewright_core::app::terms().guides {
        assert!(list.contains(guide.id), "{list}");
        let told = probewright(&["explain", guide.id]);
        assert!(told.status.success() && out(&told).contains(guide.terminal[0]), "{}", guide.id);
        for line in &guide.terminal {
            let words: Vec<&str> = line.split_whitespace().skip(1).chain(["--help"]).collect();
            let asked = probewright(&words);
            assert!(asked.status.success(), "{line}: {}", err(&asked));
        }
    }
    let word = out(&probewright(&["--lang", "de", "explain", "Messunsicherheit"]));
    assert!(word.starts_with("Wie sicher eine Messung ist\n"), "{word}");
}

// oracle: manual B:12816-12823 (bits of the probes), B:12697 (distributor), B:3260-3295 (softkeys), A:13966
#[test]
fn connections_and_softkeys_are_explained() {
    let bits = out(&probewright(&["explain", "DBX107"]));
    assert!(bits.contains("DB10 DBX107.0") && bits.contains("DB10 DBX107.1"), "{bits}");
    assert!(out(&probewright(&["explain", "X121"])).contains("X121.9"), "all pins have their plug");
    let mask = out(&probewright(&["explain", "hole_1"]));
    assert!(mask.contains("Measure workpiece > Pocket/hole > 1 hole"), "{mask}");
    let machine = include_str!("../../../docs/setup.example.json").replace("\"_CHBIT[4]\": 1", "\"_SI[1]\": \"6\"");
    let machine = file("software.json", machine.as_bytes());
    let versions = out(&probewright(&["commissioning", "compatibility", "--setup", &machine]));
    assert!(versions.contains("NCU SW 6.3 (this machine)"), "{versions}");
}
