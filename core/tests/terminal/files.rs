//! What a run takes from files and writes into them: surfaces, scans, print-outs.

use super::{HOLE, err, example_setup, file, out, probewright};
use std::process::Output;

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
    let [program, sent, surface] = ["sent.nc", "sent.xyz", "surface.xyz"].map(|name| file(name, b""));
    let files = ["--scan-nc", &program, "--scan-xyz", &sent, "--scan-surface", &surface];
    let output = scan("scan", &files);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    assert!(out(&output).contains("POINTS: 0 -> 105") || out(&output).contains("105"));
    for path in [&sent, &surface] {
        let points = points(path);
        assert_eq!(points.len(), 105);
        assert!(points.iter().all(|[x, y, z]| x.abs() <= 10.0 && y.abs() <= 10.0 && z.abs() < 0.002));
    }
    let text = std::fs::read_to_string(&program).unwrap();
    assert!(text.starts_with("%\nO1000\n") && text.ends_with("M30\n%\n"), "{text}");
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

// oracle: hand: an STL keeps its size, its upper side lies where that of the setup does; white lies at 0; the dome is 0
// at its top
#[test]
fn a_run_takes_surfaces_of_the_user() {
    let triangle = "solid s\nvertex -90 -90 7\nvertex 90 -90 7\nvertex 0 120 7\nendsolid";
    let stl = file("flat.stl", triangle.as_bytes());
    let png = file("slope.png", &picture());
    for (surface, level) in [(stl.as_str(), true), (&png, false), ("dome", false)] {
        let xyz = file("taken.xyz", b"");
        let output = scan("taken", &["--surface", surface, "--scan-xyz", &xyz]);
        assert!(output.status.success(), "{surface}: {}{}", out(&output), err(&output));
        let heights: Vec<f64> = points(&xyz).iter().map(|point| point[2]).collect();
        let same = heights.iter().all(|height| (height - heights[0]).abs() < 1e-9);
        assert_eq!(same, level, "{surface}: {heights:?}");
    }
    for surface in ["/no/such/file.stl", "moon", &file("text.png", b"no picture")] {
        let output = scan("refused", &["--surface", surface]);
        assert_eq!(output.status.code(), Some(2), "{surface}");
        assert_eq!(err(&output).lines().count(), 1, "{}", err(&output));
    }
    let hole = file("hole.mpf", HOLE.as_bytes());
    let without = probewright(&["run", &hole, "--setup", &example_setup(), "--surface", "dome"]);
    assert!(err(&without).contains("no free surface"), "{}", err(&without));
}

// oracle: manual C:1103-1116: header and data line of the printed dimension
#[test]
fn a_run_writes_what_is_printed_into_a_file() {
    let text = OVER_A_SURFACE.replace(
        r#""shape": "surface", "at": [0, 0, 0], "surface": { "heights": {
        "columns": 2, "step": [60, 40], "values": [0, 0, 0, 0] } }"#,
        r#""shape": "hole", "size": [50, 40], "at": [0, 0, 0], "errors": { "size": 0.02 }"#,
    );
    let setup = file("print.json", text.replace("[-10, -10, 10]", "[0, 0, -10]").as_bytes());
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

// oracle: manual B:11192-11232 (the file and its name), hand (which files are written where, and that none is replaced)
#[test]
fn a_run_writes_its_logs_into_a_folder() {
    let program = file(
        "logging.mpf",
        b"_PROTNAME[1]=\"LOG_1\" _CBIT[6]=1 _CBIT[11]=1 _PROTFORM[3]=1 _HEADLINE[0]=\"HEAD\"\n\
          _PROTVAL[0]=\"T\" _PROTVAL[2]=\"R1,_TIME\" R1=1.5\nCYCLE100\nCYCLE106(2)\nCYCLE101\nM30\n",
    );
    let told = probewright(&["run", &program]);
    assert!(told.status.success(), "{}{}", out(&told), err(&told));
    assert!(out(&told).contains("LOG_1.MPF, lines: 2"), "{}", out(&told));
    let folder = std::path::Path::new(&program).with_extension("logs");
    drop(std::fs::remove_dir_all(&folder));
    let asked = ["run", &program, "--log", folder.to_str().unwrap()];
    let written = probewright(&asked);
    assert!(written.status.success(), "{}{}", out(&written), err(&written));
    let log = folder.join("LOG_1.MPF");
    assert_eq!(std::fs::read_to_string(&log).unwrap(), "HEAD\n1.500       ; 00:00:00\n");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
    std::fs::write(&log, "of another part").unwrap();
    let again = probewright(&asked);
    assert_eq!(again.status.code(), Some(1));
    assert!(err(&again).contains("LOG_1.MPF exists already"), "{}", err(&again));
    assert_eq!(std::fs::read_to_string(&log).unwrap(), "of another part");
    let two =
        b"DEF INT F\nWRITE(F,\"/_N_MPF_DIR/_N_LOG_1_MPF\",\"A\")\nWRITE(F,\"/_N_MPF_DIR/_N_LOG_2_MPF\",\"B\")\nM30\n";
    let both = probewright(&["run", &file("two_files.mpf", two), "--log", folder.to_str().unwrap()]);
    assert!(err(&both).contains("LOG_1.MPF exists already") && !err(&both).contains("LOG_2"), "{}", err(&both));
    assert!(out(&both).contains("LOG_2.MPF"), "{}", out(&both));
    let text = out(&probewright(&["run", &program, "--json"]));
    let view: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(view["written"][0]["name"], "LOG_1.MPF");
    assert_eq!(view["written"][0]["lines"][1], "1.500       ; 00:00:00");
    assert_eq!(view["written"][0]["at"].as_array().unwrap().len(), 2);
}

/// The measured hole with its record in this file.
fn recorded(name: &str, more: &[&str]) -> (Output, String) {
    let (program, path) = (file("hole.mpf", HOLE.as_bytes()), file(name, b"before"));
    let setup = example_setup();
    let mut arguments = vec!["run", &program, "--setup", &setup, "--record", &path];
    arguments.extend(more);
    (probewright(&arguments), std::fs::read_to_string(&path).unwrap())
}

// oracle: hand: the hole is 0.03 mm too large of 0.1 mm that are permitted
#[test]
fn a_run_writes_its_record() {
    let (output, text) = recorded("hole.csv", &[]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][..3], ["\u{feff}Number", "Line", "Cycle"]);
    assert_eq!(rows[1][..3], ["1", "8", "CYCLE977"], "{text}");
    assert_eq!(rows[1][5..12], ["132", "-0.1", "0.1", "132.03", "0.03", "0.3", "mm"], "{text}");
    let (_, german) = recorded("loch.csv", &["--lang", "de"]);
    assert!(german.contains(";132;-0,1;0,1;132,03;0,03;0,3;mm;"), "{german}");
    let (output, text) = recorded("hole.json", &["--json"]);
    assert!(output.status.success() && out(&output).starts_with('{'), "{}", err(&output));
    let record: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&record["format"], &record["program"]), (&1.into(), &"hole.mpf".into()));
    let call = &record["calls"][0];
    assert_eq!((&call["line"], &call["verdict"]), (&8.into(), &"within".into()), "{call}");
    let used = call["figures"][0]["limits"]["used"].as_f64().unwrap();
    assert!((used - 0.3).abs() < 1e-6 && call["feature"]["text"] == "Hole", "{call}");
}

// oracle: hand: another ending is refused before anything is run, and the file stays as it was
#[test]
fn a_record_has_an_ending_that_says_how_it_is_written() {
    for name in ["hole.xlsx", "hole"] {
        let (output, text) = recorded(name, &[]);
        assert_eq!((output.status.code(), text.as_str()), (Some(2), "before"), "{}", err(&output));
        assert!(err(&output).contains(name) && err(&output).contains(".csv"), "{}", err(&output));
    }
}

// oracle: self, and tests/e2e/record.spec.mjs holds the page against the same files. With PROBEWRIGHT_UPDATE=1 they are
// written instead.
#[test]
fn the_records_in_docs_are_what_a_run_writes() {
    for name in ["hole.record.csv", "hole.record.json"] {
        let (output, text) = recorded(name, &[]);
        assert!(output.status.success(), "{}", err(&output));
        let path = format!("{}/../docs/{name}", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
            std::fs::write(&path, &text).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&path).unwrap(), text, "{name}");
    }
}

/// The hole with a protocol of this text, its record in another file.
fn measured(name: &str, protocol: &str, more: &[&str]) -> (Output, String) {
    let protocol = file(&format!("{name}.txt"), protocol.as_bytes());
    recorded(&format!("{name}.csv"), &[&["--measured", &protocol], more].concat())
}

// oracle: hand: what the machine measured stands in the record, judged by the limits of the call
#[test]
fn a_protocol_of_the_machine_becomes_the_record() {
    let (output, text) = measured("real", "Date: 28/11/26\nHole, 132, 132.12*, 0.12\n", &[]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    let row: Vec<&str> = text.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(row[5..12], ["132", "-0.1", "0.1", "132.12", "0.12", "1.2", "mm"], "{text}");
    assert_eq!(row[12..14], ["beyond", "Scrap"], "{text}");
    assert!(text.lines().count() == 2 && row[14].is_empty(), "{text}");
    assert!(out(&output).contains("real.txt:1: No setpoint with an actual value"), "{}", out(&output));
    assert!(out(&output).contains("1 line of the protocol fits"), "{}", out(&output));
    // the record that comes of it is a protocol too
    let (_, again) = measured("again", &text, &[]);
    assert_eq!(again, text);
}

// oracle: hand
#[test]
fn columns_of_a_protocol_are_named() {
    let table = "Merkmal;Ist;Soll\nBohrung;132,02;132\n";
    let (output, text) = measured("columns", table, &["--columns", "actual=ist", "nominal=3"]);
    assert!(output.status.success(), "{}{}", out(&output), err(&output));
    assert!(text.contains(",132.02,0.02,0.2,mm,"), "{text}");
    for (columns, told) in [
        (vec!["actual=Istwert"], "Merkmal | Ist | Soll"),
        (vec!["nominal=Soll"], "actual value"),
        (vec!["actual"], "actual=3"),
        (vec!["value=Ist"], "value=Ist"),
    ] {
        let arguments = [vec!["--columns"], columns].concat();
        let (output, text) = measured("refused", table, &arguments);
        assert_eq!((output.status.code(), text.as_str()), (Some(2), "before"), "{}", out(&output));
        assert!(err(&output).contains(told), "{}", err(&output));
    }
    let (output, _) = measured("binary", "\0\u{1}\u{2}\0\0", &[]);
    assert!(err(&output).contains("contains no text"), "{}", err(&output));
    let (output, _) = measured("nothing", "no numbers at all\n", &[]);
    assert_eq!(output.status.code(), Some(1), "nothing of it fits");
}
