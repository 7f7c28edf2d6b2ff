//! The terminal program as a user runs it.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::process::{Command, Output};

fn probewright(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "C")
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn file(name: &str, text: &[u8]) -> String {
    let folder = std::env::temp_dir().join(format!("probewright-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn example_setup() -> String {
    format!("{}/../docs/setup.example.json", env!("CARGO_MANIFEST_DIR"))
}

/// The measured hole of the readme: 0.03 mm too big, radius of T20 D1 to be corrected.
const HOLE: &str = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X180 Y130\nN40 Z20\nN50 _CHBIT[4]=1\n\
    N60 _TUL=0.1 _TLL=-0.1 _TZL=0.001 _TMV=0.02 _TDIF=0.2 _TSA=1 _FA=2\n\
    N61 _MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\nN70 CYCLE977\nN80 G0 Z160\nN90 M2\n";

// oracle: issue text
#[test]
fn cycles_as_json_have_the_agreed_shape() {
    let output = probewright(&["cycles", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&out(&output)).unwrap();
    let hole = list
        .as_array()
        .unwrap()
        .iter()
        .find(|entry| entry["cycle"] == "CYCLE977")
        .unwrap();
    assert_eq!(hole["control"], "sinumerik");
    assert_eq!(hole["variants"].as_array().unwrap().len(), 24);
    assert_eq!(hole["variants"][0]["mvar"], 1);
    assert!(
        hole["parameters"]
            .as_array()
            .unwrap()
            .iter()
            .any(|param| param["name"] == "_SETVAL")
    );
    assert!(
        hole["results"]
            .as_array()
            .unwrap()
            .iter()
            .any(|result| result["name"] == "_OVR[4]")
    );
}

// oracle: manual A:15882 (who raises it, what stops), A:15941; our own words
#[test]
fn alarms_explains_one_and_lists_all() {
    let one = out(&probewright(&["alarms", "61341"]));
    assert!(
        one.starts_with("61341: The probe is not calibrated"),
        "{one}"
    );
    for part in [
        "cure       Calibrate",
        "NC RESET",
        "CYCLE978, CYCLE979",
        "A:15882",
    ] {
        assert!(one.contains(part), "{part}: {one}");
    }
    let message = out(&probewright(&["alarms", "probe fail"]));
    assert!(message.contains("raised by  G102, G103"), "{message}");
    let all = out(&probewright(&["alarms"]));
    assert!(all.lines().count() > 100, "{all}");
    let list = out(&probewright(&["alarms", "--json"]));
    let list: serde_json::Value = serde_json::from_str(&list).unwrap();
    let oversize = list
        .as_array()
        .unwrap()
        .iter()
        .find(|one| one["code"] == "62304");
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
    let cycle = explained(&["cycle977"]);
    assert!(
        cycle.contains("     101  Hole: correct a zero offset\n"),
        "{cycle}"
    );
    let variant = explained(&["CYCLE977", "101"]);
    for part in [
        "CYCLE977 101: Hole: correct a zero offset\n",
        "\nWhere the probe stands before\n  ",
        "To be given: _SETVAL, _KNUM.\n",
        "(B:5773-5799)\n",
    ] {
        assert!(variant.contains(part), "{part}: {variant}");
    }
    let chinese = explained(&["CYCLE100", "--lang", "zh"]);
    assert!(chinese.contains("\n执行顺序\n  "), "{chinese}");
    let zone = explained(&["_sza"]);
    assert!(
        zone.starts_with("_SZA: ") && zone.contains("CYCLE977, "),
        "{zone}"
    );
    let result = explained(&["_OVR[4]"]);
    assert!(
        result.contains("CYCLE977") && !result.contains("_OVR[5]"),
        "{result}"
    );
    let finding = explained(&["pw135"]);
    assert!(
        finding.starts_with("PW135: No call of this program calibrates probe …: ")
            && finding.contains("\n  Check that the probe was calibrated"),
        "{finding}"
    );
    let both = explained(&["PW137"]);
    assert_eq!(both.matches("PW137: ").count(), 3, "{both}");
    assert!(explained(&["PW317", "--lang", "zh"]).starts_with("PW317: "));
    assert!(explained(&["_CBIT[12]"]).starts_with("_CBIT[12]: "));
    assert!(explained(&["MD18102"]).contains("MM_TYPE_OF_CUTTING_EDGE"));
    assert_eq!(
        explained(&["61341"]),
        out(&probewright(&["alarms", "61341"]))
    );
    for wrong in [["CYCLE977", "7"], ["_NONE", "1"], ["PW399", "1"]] {
        let output = probewright(&["explain", wrong[0], wrong[1]]);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains(wrong[0]), "{}", err(&output));
    }
}

// oracle: hand
#[test]
fn write_gives_assignments_and_the_call() {
    let output = probewright(&[
        "write",
        "CYCLE977",
        "_MVAR=1",
        "_SETVAL=132,5",
        "_KNUM=2001",
        "_TNUM=20",
    ]);
    assert!(output.status.success(), "{}", err(&output));
    assert_eq!(
        out(&output),
        "_MVAR=1 _SETVAL=132.5 _KNUM=2001 _TNUM=20\nCYCLE977\n"
    );
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

// oracle: issue text
#[test]
fn check_names_file_line_and_column() {
    let path = file(
        "wrong.mpf",
        b"G54 G17\r\n_MVAR=7 _SETVAL=10 _KNUM=0\r\nCYCLE977\r\n",
    );
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        out(&output).contains(&format!("{path}:2:7: error[61307]:")),
        "{}",
        out(&output)
    );
    let path = file("right.mpf", HOLE.as_bytes());
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(0), "{}", out(&output));
}

// oracle: manual B:4147-4152 (a probe is of type 710 or 1x0, not a drill)
#[test]
fn check_holds_a_program_against_the_machine_it_is_for() {
    let path = file("mill.mpf", HOLE.replace("T9", "T20").as_bytes());
    let machine = include_str!("../../docs/setup.example.json");
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
    let view: serde_json::Value =
        serde_json::from_str(&out(&probewright(&["read", &path, "--json"]))).unwrap();
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
    let radius = changes
        .iter()
        .find(|change| change["name"] == "$TC_DP15[20,1]")
        .unwrap();
    assert!(
        (radius["after"].as_f64().unwrap() - 0.015).abs() < 1e-9,
        "{radius}"
    );
}

/// A milling machine with an NCT control, its stylus 10 mm above the middle of a level surface of 60 × 40.
const OVER_A_SURFACE: &str = r##"{
    "control": "nct", "plane": "G17",
    "active": { "tool": 98, "edge": 98, "frame": "G54" },
    "tools": { "0": { "edges": { "98": { "type": 710, "length": [53, 0, 0], "radius": 3 } } } },
    "data": { "#500": 3, "#501": 3, "#502": 3, "#503": 3 },
    "probe": { "radius": 3, "length": 50 },
    "workpiece": [ { "shape": "surface", "at": [0, 0, 0], "surface": { "heights": {
        "columns": 2, "step": [60, 40], "values": [0, 0, 0, 0] } } } ],
    "position": [-10, -10, 10]
}"##;

/// The same machine with nothing on its table.
fn json_without_part(setup: &str) -> String {
    let mut setup: serde_json::Value = serde_json::from_str(setup).unwrap();
    setup["workpiece"] = serde_json::json!([]);
    setup.to_string()
}

/// 21 points a line, 1 mm apart, on 5 lines.
const SCAN: &str = "O1\nG65 P9969 X10 Y10 Z-15 J5 R1 Q2 F12 S1000\nM30\n";

fn scan(name: &str, more: &[&str]) -> Output {
    let setup = file(&format!("{name}.json"), OVER_A_SURFACE.as_bytes());
    let program = file(&format!("{name}.nc"), SCAN.as_bytes());
    let mut arguments = vec!["run", &program, "--setup", &setup];
    arguments.extend(more);
    probewright(&arguments)
}

/// The coordinates of a file of lines X Y Z.
fn points(path: &str) -> Vec<[f64; 3]> {
    let text = std::fs::read_to_string(path).unwrap();
    let numbers = |line: &str| {
        let found: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        <[f64; 3]>::try_from(found).unwrap()
    };
    text.lines().map(numbers).collect()
}

// oracle: hand: 5 lines of 21 points on the level 0; what is sent is a program that ends, and runs on the control again
#[test]
fn a_run_scans_a_surface_into_files() {
    let [program, sent, surface] =
        ["sent.nc", "sent.xyz", "surface.xyz"].map(|name| file(name, b""));
    let files = [
        "--scan-nc",
        &program,
        "--scan-xyz",
        &sent,
        "--scan-surface",
        &surface,
    ];
    let output = scan("scan", &files);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    assert!(out(&output).contains("POINTS: 0 -> 105") || out(&output).contains("105"));
    for path in [&sent, &surface] {
        let points = points(path);
        assert_eq!(points.len(), 105);
        assert!(
            points
                .iter()
                .all(|[x, y, z]| x.abs() <= 10.0 && y.abs() <= 10.0 && z.abs() < 0.002)
        );
    }
    let text = std::fs::read_to_string(&program).unwrap();
    assert!(
        text.starts_with("%\nO1000\n") && text.ends_with("M30\n%\n"),
        "{text}"
    );
    let air = json_without_part(OVER_A_SURFACE);
    let setup = file("again.json", air.as_bytes());
    let again = probewright(&["run", &program, "--setup", &setup]);
    assert!(again.status.success(), "{}{}", out(&again), err(&again));
}

/// A picture of 2 × 2 pixels as PNG: black on the left, white on the right.
fn picture() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&[0, 255, 0, 255]).unwrap();
    writer.finish().unwrap();
    bytes
}

// oracle: hand: an STL keeps its size, its upper side lies where that of the setup does; white lies at 0; the dome is 0 at
// its top
#[test]
fn a_run_takes_surfaces_of_the_user() {
    let triangle = "solid s\nvertex -90 -90 7\nvertex 90 -90 7\nvertex 0 120 7\nendsolid";
    let stl = file("flat.stl", triangle.as_bytes());
    let png = file("slope.png", &picture());
    for (surface, level) in [(stl.as_str(), true), (&png, false), ("dome", false)] {
        let xyz = file("taken.xyz", b"");
        let output = scan("taken", &["--surface", surface, "--scan-xyz", &xyz]);
        assert!(
            output.status.success(),
            "{surface}: {}{}",
            out(&output),
            err(&output)
        );
        let heights: Vec<f64> = points(&xyz).iter().map(|point| point[2]).collect();
        let same = heights
            .iter()
            .all(|height| (height - heights[0]).abs() < 1e-9);
        assert_eq!(same, level, "{surface}: {heights:?}");
    }
    for surface in [
        "/no/such/file.stl",
        "moon",
        &file("text.png", b"no picture"),
    ] {
        let output = scan("refused", &["--surface", surface]);
        assert_eq!(output.status.code(), Some(2), "{surface}");
        assert_eq!(err(&output).lines().count(), 1, "{}", err(&output));
    }
    let hole = file("hole.mpf", HOLE.as_bytes());
    let without = probewright(&[
        "run",
        &hole,
        "--setup",
        &example_setup(),
        "--surface",
        "dome",
    ]);
    assert!(
        err(&without).contains("no free surface"),
        "{}",
        err(&without)
    );
}

// oracle: manual C:1103-1116: header and data line of the printed dimension
#[test]
fn a_run_writes_what_is_printed_into_a_file() {
    let text = OVER_A_SURFACE.replace(
        r#""shape": "surface", "at": [0, 0, 0], "surface": { "heights": {
        "columns": 2, "step": [60, 40], "values": [0, 0, 0, 0] } }"#,
        r#""shape": "hole", "size": [50, 40], "at": [0, 0, 0], "errors": { "size": 0.02 }"#,
    );
    let setup = file(
        "print.json",
        text.replace("[-10, -10, 10]", "[0, 0, -10]").as_bytes(),
    );
    let program = file("print.nc", b"O1\nG110 D50. T4 H.1 V2\nM30\n");
    let print = file("print.txt", b"");
    let output = probewright(&["run", &program, "--setup", &setup, "--print", &print]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    let printed = std::fs::read_to_string(&print).unwrap();
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!(
        lines,
        [
            "TOOL       NOMINAL    TOLERANCE  DEVIATION",
            "OFFSET NO  DIMENSION             FROM NOMINAL",
            "D 4        50.0000    .1000      .0200",
        ]
    );
}

// oracle: hand
#[test]
fn wrong_use_is_told_in_a_line() {
    for arguments in [
        &["write", "CYCLE1234"][..],
        &["write", "CYCLE977", "_NOTHING=1"],
        &["write", "CYCLE977", "_MVAR"],
        &["write", "CYCLE977", "_MVAR=1", "_mvar=2"],
        &["read", "/no/such/file"],
        &["run", "/no/such/file", "--setup", "/no/such/setup"],
    ] {
        let output = probewright(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert_eq!(
            err(&output).trim_end().lines().count(),
            1,
            "{}",
            err(&output)
        );
    }
}

// oracle: hand. Each unreadable thing is named, the other files are checked all the same.
#[test]
fn what_is_no_program_is_told_and_the_rest_is_checked() {
    let wrong = file("wrong2.mpf", b"\n  _MVAR=7\nCYCLE977\n");
    let folder = std::env::temp_dir().to_str().unwrap().to_owned();
    let output = probewright(&["check", &folder, "/no/such/file", &wrong]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(err(&output).lines().count(), 2, "{}", err(&output));
    assert!(err(&output).contains(&folder) && err(&output).contains("/no/such/file"));
    assert!(
        out(&output).contains(":2:9: error[61307]: _MVAR"),
        "{}",
        out(&output)
    );
    let endless = probewright(&["read", "/dev/zero"]);
    assert_eq!(endless.status.code(), Some(2));
    assert!(
        err(&endless).contains("/dev/zero: larger than"),
        "{}",
        err(&endless)
    );
}

// oracle: hand
#[test]
fn binary_and_huge_lines_give_short_clean_messages() {
    let path = file(
        "binary.mpf",
        &[b"R1=(\x00\x1b[2J\xff\xfe", &b"x"[..], &vec![b'('; 200_000]].concat(),
    );
    for arguments in [
        &["check", &path][..],
        &["run", &path, "--setup", &example_setup()],
    ] {
        let output = probewright(arguments);
        assert_eq!(output.status.code(), Some(1), "{}", out(&output));
        assert!(out(&output).lines().all(|line| line.chars().count() < 400));
        assert!(!out(&output).chars().any(|c| c.is_control() && c != '\n'));
    }
    let noise: Vec<u8> = (0..100_000u32)
        .map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8)
        .collect();
    let path = file("noise.mpf", &noise);
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).lines().count() <= 201 && out(&output).contains("more findings"));
}

// oracle: hand
#[test]
fn a_closed_pipe_ends_the_output_quietly() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "C")
        .args(["cycles", "--json"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        (output.status.code(), err(&output)),
        (Some(0), String::new())
    );
}

// oracle: hand. The run goes to its end, but a word of it was not carried out.
#[test]
fn a_run_with_an_unknown_word_fails() {
    let path = file("unknown.mpf", b"G0 X1\nWHATEVER(1)\nM2\n");
    let output = probewright(&["run", &path, "--setup", &example_setup()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        out(&output).contains(":2:1: error[PW300]"),
        "{}",
        out(&output)
    );
}

// oracle: hand
#[test]
fn the_language_is_asked_for_or_taken_from_the_environment() {
    let chinese = |text: &str| text.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c));
    assert!(chinese(&out(&probewright(&["--lang", "zh", "cycles"]))));
    assert!(!chinese(&out(&probewright(&["cycles"]))));
    let environment = Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "zh_CN.UTF-8")
        .arg("cycles")
        .output()
        .unwrap();
    assert!(chinese(&out(&environment)));
    let unknown = probewright(&["cycles", "--lang", "xx"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&unknown.stderr).contains("en, zh"));
}
