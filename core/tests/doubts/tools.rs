//! The tool in use, and whether its probe is calibrated.

use super::{CALIBRATION, EDGE, HOLE, LENGTH, TURNED, called, found, tells};
use probewright_core::catalogue::Dialect;
use probewright_core::control::delivery;
use probewright_core::diagnostic::Code::{self, Alarm};
use probewright_core::program::{findings_on, read};

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
        let told: Vec<Code> = codes
            .filter(|code| matches!(code, Alarm(61309 | 61314 | 61315 | 61351)))
            .collect();
        assert_eq!(told, Vec::from_iter(wrong), "{text}");
    }
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
            called(
                &format!("{tools}T{one} D1 M6\nL5\nT{other} D1 M6\nL5"),
                call,
            )
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
    assert!(!tells(
        &called(&format!("{begin}L5\n{HOLE}"), ring),
        CALIBRATION
    ));
    assert!(tells(
        &called(&format!("{begin}{HOLE}L5"), ring),
        CALIBRATION
    ));
}

// oracle: hand (trigger values that are no longer those of the delivery were determined by a calibration, B:5010-5060)
#[test]
fn a_probe_that_was_calibrated_on_the_machine_is_not_doubted() {
    let text = format!("G17 G40 G54 T9 D1\n{HOLE}M30\n");
    let doubted = |name: &str, value: f64| {
        let mut control = delivery(Dialect::Sinumerik);
        control.set(name, value);
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let found = findings_on(&program, control);
        found.iter().any(|finding| finding.code == CALIBRATION)
    };
    assert!(!doubted("_WP[0,1]", 2.98));
    assert!(!doubted("_WP[0,4]", -2.98));
    assert!(doubted("_WP[0,1]", 3.0), "as delivered");
    assert!(doubted("_WP[0,7]", 0.01), "skew alone");
    assert!(doubted("_WP[1,1]", 2.98), "another probe");
}
