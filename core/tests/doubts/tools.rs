//! The tool in use, and whether its probe is calibrated.

use super::{CALIBRATION, EDGE, HOLE, LENGTH, PLANE, TURNED, called, found, tells};
use probewright_core::control::{Control, Edge, TOOL_LENGTH_TYPE, delivery};
use probewright_core::diagnostic::Code::Alarm;
use probewright_core::diagnostic::{Code, Diagnostic, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::program::findings_on;
use probewright_core::syntax::read;

// oracle: manual A:15848, A:15855, B:4147-4152 (types of probes and of tools)
#[test]
fn the_type_that_the_program_enters_is_the_type_of_its_tool() {
    let tool = |kind: i64, call: &str| {
        let g = if call == TURNED { "G18" } else { "G17" };
        format!("$TC_DP1[7,1]={kind}\n{g} G40 G54 DIAMON\nT7 D1\n{call}M30\n")
    };
    for (kind, call, wrong) in [
        (710, HOLE, None),
        (120, HOLE, None),
        (500, HOLE, Some(Alarm(61309))),
        (220, HOLE, Some(Alarm(61309))),
        (120, LENGTH, None),
        (200, LENGTH, None),
        (500, LENGTH, Some(Alarm(61314))),
        (710, LENGTH, Some(Alarm(61314))),
        (500, TURNED, None),
        (120, TURNED, Some(Alarm(61314))),
        (710, TURNED, Some(Alarm(61314))),
    ] {
        let text = tool(kind, call);
        let all = found(&text);
        let codes = all.iter().map(|finding| finding.code);
        let told: Vec<Code> = codes.filter(|code| matches!(code, Alarm(61309 | 61314 | 61315 | 61351))).collect();
        assert_eq!(told, Vec::from_iter(wrong), "{text}");
    }
}

/// A milling cycle with a tool of this type and cutting edge position, on a machine with this assignment of lengths.
fn milled(kind: i64, tip: i64, assignment: Option<f64>, g: &str) -> Vec<Diagnostic> {
    let mut control = delivery(Dialect::Sinumerik);
    if let Some(value) = assignment {
        control.set("SD42950", value);
    }
    let data = format!("$TC_DP1[7,1]={kind} $TC_DP2[7,1]={tip} $TC_DP5[7,1]=50");
    let text = format!("{data}\n{g} G40 G54\nT7 D1\n{HOLE}M30\n");
    findings_on(&read(Dialect::Sinumerik, text.as_bytes()), control)
}

// oracle: manual B:4147-4152, A:15848: each of the conditions; what the text does not tell is a warning, and so is 1xy,
// which B:906-910 takes for a probe
#[test]
fn the_probe_of_a_turning_machine_is_held_against_the_conditions_of_the_call() {
    let (error, warning) = (Severity::Error, Severity::Warning);
    let lathe = Some(2.0);
    for (kind, tip, assignment, g, expected) in [
        (580, 7, lathe, "G17", None),
        (500, 5, lathe, "G17", None),
        (580, 8, lathe, "G19", None),
        (580, 6, lathe, "G19", None),
        (580, 8, lathe, "G17", Some((error, "advice-tool-plane"))),
        (580, 7, lathe, "G19", Some((error, "advice-tool-plane"))),
        (580, 7, lathe, "G18", Some((error, "advice-tool-plane"))),
        (580, 7, lathe, "", None),
        (580, 8, lathe, "", Some((warning, "advice-tool-plane"))),
        (580, 3, lathe, "G17", Some((error, "advice-tool-position"))),
        (580, 0, lathe, "G17", None),
        (580, 7, Some(0.0), "G17", Some((error, "advice-tool-assignment"))),
        (580, 7, None, "G17", Some((warning, "advice-tool-assignment"))),
        (580, 7, None, "$SC_TOOL_LENGTH_TYPE=2\nG17", None),
        (145, 0, None, "G17", Some((warning, "advice-tool-digit"))),
        (140, 0, None, "G17", None),
        (220, 0, None, "G17", Some((error, "advice-tool"))),
    ] {
        let found = milled(kind, tip, assignment, g);
        let told = found.iter().find(|one| one.code == Alarm(61309));
        let told = told.map(|one| (one.severity, one.message.key.as_ref()));
        assert_eq!(told, expected, "{kind} {tip} {assignment:?} {g}");
    }
}

// oracle: manual B:4152 (8 measures in G19), B:10623 against B:5358-5363 (no diameters in chapter 5), B:974-985 (L1 in
// X and L2 in Z with G18: none along the applicate of another plane)
#[test]
fn plane_diameters_and_lengths_of_such_a_probe_are_asked_for() {
    let program = |data: &str, g: &str| {
        let text = format!("$SC_TOOL_LENGTH_TYPE=2\n$TC_DP1[7,1]=580 {data}\n{g} G40 G54 T7 D1\n{HOLE}M30\n");
        found(&text)
    };
    let plane = program("$TC_DP2[7,1]=8", "");
    let plane = plane.iter().find(|one| one.code == PLANE).unwrap();
    assert_eq!(plane.cure.as_ref().unwrap().edits[0].insert.trim(), "G19");
    let asks = |data: &str, g: &str, code: u16| program(data, g).iter().any(|one| one.code == Code::Own(code));
    let probe = "$TC_DP2[7,1]=7";
    assert!(asks(probe, "G17 DIAMON", 165));
    assert!(asks(probe, "G17 DIAM90", 165));
    assert!(!asks(probe, "G17 DIAMOF", 165));
    assert!(!asks("$TC_DP1[7,1]=710", "G17 DIAMON", 165));
    let across = format!("{probe} $TC_DP3[7,1]=40 $TC_DP4[7,1]=100");
    assert!(asks(&across, "G17", 166));
    assert!(!asks(&format!("{across} $TC_DP5[7,1]=50"), "G17", 166));
    assert!(!asks(probe, "G17", 166), "the machine may know its lengths");
}

// oracle: hand (T prepares where M6 changes)
#[test]
fn a_tool_that_is_only_prepared_is_not_in_use() {
    let tools = "$TC_DP1[9,1]=710 $TC_DP1[7,1]=500\nG17 G40 G54\n";
    let wrong = |order: &str| tells(&format!("{tools}{order}{HOLE}M30\n"), Alarm(61309));
    assert!(!wrong("T9 M6\nD1\nT7\n"));
    assert!(!wrong("M6 T9 D1\nT7\n"));
    assert!(wrong("T7 M6\nD1\nT9\n"));
    assert!(wrong("T7 D1\n"));
    assert!(!tells(&format!("{tools}T9 D1\nM6\nT7\n{HOLE}M30\n"), EDGE));
    assert!(tells(&format!("{tools}T9 M6\nT7\n{HOLE}M30\n"), EDGE));
}

// oracle: manual A:15855, B:4147-4152
#[test]
fn each_tool_with_which_a_subprogram_is_called_counts() {
    let tools = "$TC_DP1[1,1]=120 $TC_DP1[2,1]=500 $TC_DP1[9,1]=710\nG17 G40 G54\n";
    for (call, good, bad, alarm) in [(LENGTH, 1, 2, 61314), (HOLE, 9, 2, 61309)] {
        let main = |tools_in_turn: [i64; 2]| {
            let [one, other] = tools_in_turn;
            called(&format!("{tools}T{one} D1 M6\nL5\nT{other} D1 M6\nL5"), call)
        };
        assert!(!tells(&main([good, good]), Alarm(alarm)));
        assert!(tells(&main([good, bad]), Alarm(alarm)));
        assert!(tells(&main([bad, good]), Alarm(alarm)));
    }
}

// oracle: hand
#[test]
fn a_probe_that_a_subprogram_calibrates_is_calibrated() {
    let ring = "_MVAR=1 _SETVAL=50 _PRNUM=1 _FA=2 _TSA=2\nCYCLE976";
    let begin = "G17 G40 G54 T9 D1\n";
    assert!(!tells(&called(&format!("{begin}L5\n{HOLE}"), ring), CALIBRATION));
    assert!(tells(&called(&format!("{begin}{HOLE}L5"), ring), CALIBRATION));
}

// oracle: hand (trigger points other than the default ones were determined by a calibration, B:5010-5060)
#[test]
fn a_probe_that_was_calibrated_on_the_machine_is_not_warned_about() {
    let text = format!("G17 G40 G54 T9 D1\n{HOLE}M30\n");
    let warned = |name: &str, value: f64| {
        let mut control = delivery(Dialect::Sinumerik);
        control.set(name, value);
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let found = findings_on(&program, control);
        found.iter().any(|finding| finding.code == CALIBRATION)
    };
    assert!(!warned("_WP[0,1]", 2.98));
    assert!(!warned("_WP[0,4]", -2.98));
    assert!(warned("_WP[1,1]", 2.98), "another probe is, this one is not");
    // Of a machine that nothing is known of nothing is said: every right program would get a warning.
    assert!(!warned("_WP[0,1]", 3.0), "as delivered");
    assert!(!warned("_WP[0,7]", 0.01), "skew alone");
}

/// Whether a check of this program on a machine, before whose calls the spindle is as `spindle` says, tells this alarm.
fn stops(control: &Control, spindle: &str, call: &str, alarm: u32) -> bool {
    let text = format!("G17 G40 G54\nT7 D1\n{spindle}\n{call}M30\n");
    let found = findings_on(&read(Dialect::Sinumerik, text.as_bytes()), control.clone());
    found.iter().any(|one| one.code == Alarm(alarm))
}

// oracle: manual B:4783, B:4807 (CYCLE971), B:9194 (CYCLE982)
#[test]
fn only_a_spindle_that_stands_is_asked_for_its_direction_or_turned() {
    let mut control = delivery(Dialect::Sinumerik);
    control.set("_CM[5]", 0.0);
    control.set(TOOL_LENGTH_TYPE, 2.0);
    control.spindle_positions = false;
    let edge = Edge { kind: 120, length: [60.0, 10.0, 0.0], radius: 4.0, ..Edge::default() };
    control.tools.entry(7).or_default().edges.insert(1, edge);
    let turning = "_MVAR=2 _MA=1 _ID=0 _PRNUM=1 _FA=10 _TSA=5\nCYCLE971\n";
    let standing = "_MVAR=1 _MA=1 _STA1=0 _PRNUM=1 _FA=10 _TSA=5\nCYCLE982\n";
    for (call, alarm) in [(turning, 61366), (standing, 61372)] {
        for (spindle, expected) in [
            ("", true),
            ("M3 S500", false),
            ("M4 S500", false),
            ("M3 S500\nM5", true),
            ("M3 S500\nSPOS=0", true),
            // the text does not tell
            ("IF R1==1\nM3 S500\nENDIF", false),
        ] {
            assert_eq!(stops(&control, spindle, call, alarm), expected, "{spindle} {call}");
        }
    }
}
