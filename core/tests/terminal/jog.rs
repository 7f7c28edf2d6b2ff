//! `probewright jog`.

use super::{err, file, out, probewright};
use std::process::Output;

/// A block whose corner lies at X 0, Y 0, Z 0 of the machine; G54 is wrong.
const SETUP: &str = r#"{
  "control": "sinumerik",
  "active": { "tool": 9, "edge": 1 },
  "tools": { "9": { "name": "PROBE", "edges": { "1": { "type": 710, "length": [50, 0, 0], "radius": 3 } } } },
  "frames": { "G54": { "coarse": [10, 20, 5], "fine": [0.1, 0, 0] } },
  "probe": { "radius": 3, "length": 50 },
  "workpiece": [{ "shape": "block", "size": [100, 80, 40], "at": [50, 40, 0] }],
  "position": [0, 0, 300]
}"#;

const CORNER: &str = "; the corner, then the upper face\nmask corner_right\nzo = G54\n\
    move X20 Y-25 Z-8\nstart\nmove X80\nstart\nmove X-30\nmove Y30\nstart\ncalculate\nactivate\n\
    mask set_edge\naxis = Z\ndirection = -\nmove Z40\nmove X40 Y40\nstart\n";

fn jog(name: &str, script: &str, more: &[&str]) -> (String, Output) {
    let script = file(name, script.as_bytes());
    let setup = file("jog.json", SETUP.as_bytes());
    let output = probewright(&[&["jog", &script, "--setup", &setup], more].concat());
    (script, output)
}

// oracle: hand (the block lies at the zero of the machine)
#[test]
fn a_session_prints_points_results_and_offsets() {
    let (script, output) = jog("corner.jog", CORNER, &[]);
    let told = out(&output);
    assert!(output.status.success(), "{told}{}", err(&output));
    let at = |line: u32, text: &str| assert!(told.contains(&format!("{script}:{line}: {text}\n")), "{text}: {told}");
    at(5, "P1: X 20.0000, Y -3.0000, Z -8.0000");
    at(11, "Measured X0 = 0.0000 mm");
    at(11, "Angle α = 0.0000°");
    at(11, "$P_UIFR[1,X,TR]: 10.0000 -> 0.0000 mm");
    at(11, "$P_UIFR[1,X,FI]: 0.1000 -> 0.0000 mm");
    at(11, "G54 was corrected, but it is not active.");
    at(18, "Measured Z0 = -5.0000 mm"); // G54 is active from line 12 on
    at(18, "$P_UIFR[1,Z,TR]: 5.0000 -> 0.0000 mm");
    assert!(told.ends_with("Active: G54\nThe mask Set edge is open.\n"), "{told}");
}

// oracle: hand: what the session printed, a row for each result, with what was written
#[test]
fn a_session_has_a_record() {
    let record = file("corner.csv", b"");
    let (_, output) = jog("recorded.jog", CORNER, &["--record", &record]);
    assert!(output.status.success(), "{}", err(&output));
    let text = std::fs::read_to_string(&record).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().any(|row| row[1] == "11" && row[4] == "Measured X0" && row[8] == "0"), "{text}");
    assert!(rows.iter().any(|row| row[1] == "18" && row[4] == "Measured Z0" && row[8] == "-5"), "{text}");
    assert!(rows.iter().all(|row| row[13] == "Measured" && row[15] == "workpiece probe 1"), "{text}");
    assert!(rows[0][14..].join(",").contains("G54 X -10"), "{text}");
}

// oracle: hand (docs/setup.example.json: a hole of 132.03 mm at X 180, Y 130, its upper face at Z 30)
#[test]
fn the_example_in_docs_sets_the_hole() {
    let docs = format!("{}/../docs", env!("CARGO_MANIFEST_DIR"));
    let output =
        probewright(&["jog", &format!("{docs}/jog.example.jog"), "--setup", &format!("{docs}/setup.example.json")]);
    let told = out(&output);
    assert!(output.status.success(), "{told}{}", err(&output));
    for text in [
        "Measured diameter = 132.0300 mm",
        "$P_UIFR[1,X,TR]: 0.0000 -> 180.0000",
        "$P_UIFR[1,Y,TR]: 0.0000 -> 130.0000",
        "$P_UIFR[1,Z,TR]: 0.0000 -> 30.0000",
    ] {
        assert!(told.contains(text), "{text}: {told}");
    }
}

// oracle: hand: the part that chance moved is found where it is, its angle in the plane to its tilt
#[test]
fn chance_puts_the_part_and_tells_where() {
    let (_, output) = jog("random.jog", CORNER, &["--random", "7", "--lang", "de"]);
    let told = out(&output);
    assert!(output.status.success(), "{told}{}", err(&output));
    assert!(told.contains("Das Werkstück liegt nach Startwert 7: verschoben um X "), "{told}");
    assert_eq!(told, out(&jog("random.jog", CORNER, &["--random", "7", "--lang", "de"]).1));
    assert_ne!(told, out(&jog("random.jog", CORNER, &["--random", "8", "--lang", "de"]).1));
}

// oracle: hand
#[test]
fn wrong_lines_alarms_and_refused_keys_end_with_their_status() {
    for (name, script, status, told) in [
        ("wrong.jog", "mask set_edge\ngo\n", 2, ":2: There is no command “go”. Use one of: mask, move, "),
        ("refused.jog", "mask set_edge\ncalculate\nstart\n", 1, ":2: This mask measures and calculates with NC start"),
        ("alarm.jog", "mask set_edge\nmove X-200 Z-8\nstart\n", 1, ":3: alarm 61301: "),
        ("crash.jog", "mask set_edge\nmove X20 Y20\nmove Z-8\njog Z+20\n", 1, ":3: The probe hit the part"),
        ("menu.jog", "start\n", 1, ":1: No mask is open. Open one first, for example with “mask set_edge”."),
        ("field.jog", "mask hole_1\ndiameter = -4\n", 1, ":2: diameter cannot be -4. Enter 0 or a value above 0."),
    ] {
        let (_, output) = jog(name, script, &[]);
        let (out, err) = (out(&output), err(&output));
        assert_eq!(output.status.code(), Some(status), "{name}: {out}{err}");
        assert!((out + &err).contains(told), "{name}: {told}");
    }
}

// oracle: hand: lines that say something behind the one that is refused, comments and empty lines not counted
#[test]
fn what_was_left_out_is_told() {
    let script = "mask set_edge\ncalculate ; not here\n\n; the rest\nstart\nreset\n<<\n";
    let told = |more: &[&str]| {
        let (_, output) = jog("left.jog", script, more);
        assert_eq!(output.status.code(), Some(1), "{more:?}");
        out(&output)
    };
    let left = "The session ends at line 2. 3 further lines of the script were not carried out.\n";
    assert!(told(&[]).contains(&format!("\n{left}")), "{}", told(&[]));
    assert!(told(&["--as-program"]).contains(&format!("; {left}")), "{}", told(&["--as-program"]));
    let json: serde_json::Value = serde_json::from_str(&told(&["--json"])).unwrap();
    assert_eq!(json["left"], 3);
    let (_, output) = jog("last.jog", "mask set_edge\ncalculate\n", &[]);
    assert!(!out(&output).contains("The session ends"), "{}", out(&output));
}

// oracle: manual B:3826-3846, B:3880-3883: four decimals of mm and degrees, five of inches (specification, P-UNITS)
#[test]
fn figures_have_the_decimals_of_the_control() {
    let inch = SETUP.replacen("\"sinumerik\",", "\"sinumerik\", \"units\": \"inch\",", 1);
    let script = file("decimals.jog", CORNER.as_bytes());
    let told = out(&probewright(&["jog", &script, "--setup", &file("inches.json", inch.as_bytes())]));
    assert!(told.contains("Measured X0 = 0.0000 mm\n"), "{told}");
    assert!(told.contains("$P_UIFR[1,X,TR]: 0.39370 -> 0.00000 inch\n"), "{told}");
}

// oracle: hand
#[test]
fn a_session_as_json_has_each_line_and_the_machine() {
    let (_, output) = jog("json.jog", CORNER, &["--json", "--random", "3"]);
    let told: serde_json::Value = serde_json::from_str(&out(&output)).unwrap();
    let lines = told["lines"].as_array().unwrap();
    assert_eq!(lines.len(), 17);
    assert_eq!((&lines[9]["line"], &lines[9]["state"]), (&11.into(), &"activate".into()));
    assert_eq!(lines[9]["results"][2]["name"], "alpha");
    assert_eq!(told["truth"]["seed"], 3);
    assert_eq!(told["setup"]["active"]["frame"], "G54");
}

// oracle: hand: the corner of the block at X 0, Y 0, touched from 22 and 27 mm before its edges, at 80 and 30 mm from
// it; the start is at most a third of these away. G54 is active then, Z of it still 5 mm off.
#[test]
fn a_session_prints_what_it_means_as_a_program() {
    let corner = CORNER.split("mask set_edge").next().unwrap();
    let (_, output) = jog("program.jog", corner, &["--as-program"]);
    let told = out(&output);
    assert!(output.status.success(), "{told}{}", err(&output));
    assert!(told.starts_with("; The cycle travels between its points by itself"), "{told}");
    assert!(told.contains("\nG17 G54\nG0 X-26.667 Y-10\nZ-13\n_MVAR=106 "), "{told}");
    assert!(told.ends_with("\nCYCLE961\n"), "{told}");
    let (_, output) = jog("program.jog", "mask holes_4\n", &["--as-program"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).starts_with("No cycle measures several holes or spigots"), "{}", out(&output));
}

// oracle: hand
#[test]
fn masks_are_listed_with_what_their_fields_take() {
    let told = out(&probewright(&["jog", "--masks"]));
    assert!(told.contains("\nspigot_1       1 circular spigot\n"), "{told}");
    assert!(told.contains("Infeed DZ (dz)\n"), "{told}");
    assert!(told.contains("Corner (corner): outside, inside\n"), "{told}");
    assert!(!told.contains("jog-"), "{told}");
}

// oracle: hand: the upper face lies at Z -5 of G54, which is active by then
#[test]
fn what_the_next_key_would_do_is_told() {
    let script = CORNER.strip_suffix("start\n").unwrap();
    let told = out(&jog("ahead.jog", script, &["--what-if"]).1);
    assert!(told.contains("\nNC start would\n  touch at X 40.0000, Y 40.0000, Z "), "{told}");
    assert!(
        told.contains("\n  show Measured Z0 = -5.0000 mm\n  write $P_UIFR[1,Z,TR]: 5.0000 → 0.0000 mm\n"),
        "{told}"
    );
    assert!(!out(&jog("ahead.jog", script, &[]).1).contains("NC start would"));
    let told = out(&jog("ahead.jog", "mask set_edge\nmove X-200 Z-8\n", &["--what-if"]).1);
    assert!(told.contains("NC start would\n  raise alarm 61301: "), "{told}");
    let told = out(&jog("ahead.jog", "", &["--what-if"]).1);
    assert!(told.ends_with("There is nothing that NC start or Calculate would measure now.\n"), "{told}");
}

// oracle: hand (B:3015)
#[test]
fn a_mask_is_explained() {
    let told = out(&probewright(&["explain", "set_edge"]));
    assert!(told.starts_with("set_edge: Set edge\n\nWhat it measures\n  The position of a paraxial edge"), "{told}");
    assert!(told.contains("\n  Possible alarms: 61016, "), "{told}");
}

// oracle: hand: what is pending is named in the end, and a machine in inches says once that JOG is metric
#[test]
fn the_end_names_what_is_pending() {
    let (_, output) = jog("pending.jog", "mask set_edge\nmove X-200 Z-8\nstart\n", &[]);
    assert!(out(&output).ends_with("Alarm 61301 is pending. Press RESET.\n"), "{}", out(&output));
    let body = SETUP.replace("\"length\": 50 }", "\"length\": 50, \"body\": { \"radius\": 20, \"distance\": 25 } }");
    let script = file("body.jog", b"mask set_edge\nmove X-30 Y40 Z-35\nstart\n");
    let told = out(&probewright(&["jog", &script, "--setup", &file("body.json", body.as_bytes())]));
    assert_eq!(told.matches(":3: The probe body hit the part.").count(), 1, "{told}");
    assert!(told.contains("Press RESET. Then move the axis back"), "{told}");
    assert!(told.contains("\nThe machine has stopped. The probe body hit the part."), "{told}");
    let inch = SETUP.replacen("\"sinumerik\",", "\"sinumerik\", \"units\": \"inch\",", 1);
    let script = file("inch.jog", b"mask set_edge\n");
    let told = out(&probewright(&["jog", &script, "--setup", &file("inch.json", inch.as_bytes())]));
    assert_eq!(told.matches("are in mm.").count(), 1, "{told}");
    assert!(told.starts_with("This machine measures in inches."), "{told}");
    assert!(!out(&jog("mm.jog", "mask set_edge\n", &[]).1).contains("are in mm."));
}
