//! What is active along calls, branches and levels.

use super::{COMPENSATION, EDGE, HOLE, LEVEL, OPEN, OUTSIDE, PLANE, SPINDLE, called, found, tells};
use probewright_core::diagnostic::Code::Alarm;
use probewright_core::program::change::apply;

// oracle: manual B:654-656, hand (a call takes the state of the caller along)
#[test]
fn what_is_in_force_follows_the_calls() {
    let hole = |main: &str| called(main, HOLE);
    for call in [
        "L5",
        "L5 P3",
        "PCALL L5",
        "PCALL /_N_WKS_DIR/_N_PART_WPD/_N_L5_SPF",
        "CALL \"L5\"",
        "CALL \"_N_L5_SPF\"",
        "MCALL L5",
    ] {
        let right = hole(&format!("G17 G40 G54 T9 D1\n{call}"));
        for code in [COMPENSATION, PLANE, EDGE, SPINDLE] {
            assert!(!tells(&right, code), "{right}");
        }
        for (state, code) in [
            ("G17 G41 T9 D1", COMPENSATION),
            ("T9 D1", PLANE),
            ("G17 T9", EDGE),
            ("G17 T9 D1 M3", SPINDLE),
            ("G17 T9 D0", Alarm(61311)),
        ] {
            let text = hole(&format!("{state}\n{call}"));
            assert!(tells(&text, code), "{text}");
        }
    }
    // The order of the text is not that of the run.
    let behind = "G17 G40 T9 D1\nL5\nG41 G1 X10";
    assert!(!tells(&hole(behind), COMPENSATION));
    let each = "G17 G40 T9 D1\nL5\nG41 G1 X10\nL5";
    assert!(tells(&hole(each), COMPENSATION));
    let twice = "G17 G41 T9 D1\nL5\nG18\nL5";
    let all = found(&hole(twice));
    assert_eq!(all.iter().filter(|one| one.code == COMPENSATION).count(), 1);
    let back = called(&format!("G17 T9 D1\nL5\n{HOLE}"), "G41");
    assert!(tells(&back, COMPENSATION));
    let saved = format!("%_N_MAIN_MPF\nG17 G40 T9 D1\nL5\n{HOLE}M30\n%_N_L5_SPF\nPROC L5 SAVE\nG41\nM17\n");
    assert!(!tells(&saved, COMPENSATION));
    let ended = format!("%_N_MAIN_MPF\nG17 G40 T9 D1\nL5\n{HOLE}M30\n%_N_L5_SPF\nG41\nM30\n");
    assert!(tells(&ended, COMPENSATION), "M30 ends a subprogram like M17");
}

// oracle: hand (what the text does not tell gets no warning)
#[test]
fn what_depends_on_the_run_is_not_warned_about() {
    for way in [
        "IF R1>0\nG41\nENDIF",
        "IF R1>0\nG40\nELSE\nG41\nENDIF",
        "IF R1>0 GOTOF OVER\nG41\nOVER:",
        "WHILE R1>0\nG41\nENDWHILE",
        "/G41",
        "G41\nL77",
        "G41\nUNKNOWN_PREPARATION(1)",
        "G41\nCALL \"FAR\"",
    ] {
        let text = format!("G17 G40 T9 D1\n{way}\n{HOLE}M30\n");
        assert!(!tells(&text, COMPENSATION), "{text}");
    }
    for way in [
        "IF R1>0\nG41\nELSE\nG41\nENDIF",
        "IF R1>0\nG40\nM30\nENDIF\nG41",
        "LOOP\nG41\nENDLOOP",
        "GOTOF OVER\nG40\nOVER: G41",
        "G41\nSTOPRE",
        "G41\nCYCLE81(10,0,2,-5)",
        "G41\nCUT2D\nSETMS(1)\nTRAFOOF",
    ] {
        let text = format!("G17 T9 D1\n{way}\n{HOLE}M30\n");
        assert!(tells(&text, COMPENSATION), "{text}");
    }
    let text = format!("G17 G41 T9 D1\nIF R1>0 GOTOF END\nM30\nEND: G40\n{HOLE}");
    assert!(!tells(&text, COMPENSATION));
}

// oracle: hand (what another memory holds, no text tells)
#[test]
fn programs_of_another_memory_are_told_once() {
    let told = |calls: &str| {
        let text = called(&format!("G17 G40 T9 D1\n{calls}\n{HOLE}"), "G0 X1");
        let all = found(&text);
        let all = all.iter().filter(|one| one.code == OUTSIDE);
        let words = probewright_core::words::Words::english();
        all.map(|one| words.text(&one.message)).collect::<Vec<_>>()
    };
    for here in [
        "EXTCALL \"L5\"",
        "EXTCALL(\"L5\")",
        "EXTCALL \"/_N_WKS_DIR/_N_PART_WPD/_N_L5_SPF\"",
        "EXTCALL \"L5.SPF\"",
        "EXTCALL(\"l5_spf\")",
        "EXTCALL \"C:\\PART\\L5.MPF\"",
    ] {
        assert!(told(here).is_empty(), "{here}");
    }
    let far = told("EXTCALL \"FAR.SPF\"\nEXTCALL(\"_N_FAR_SPF\")\nEXTCALL \"NEXT\"");
    assert_eq!(far, ["Not found, so the effect is not known: FAR, NEXT. The run skips such calls."]);
}

// oracle: hand
#[test]
fn programs_without_an_end_are_followed_to_an_end() {
    for (main, sub) in [
        ("G17 G41 T9 D1\nL5", format!("L5\n{HOLE}")),
        ("G17 G41 T9 D1\nL5\nL6", format!("{HOLE}M17\n%_N_L6_SPF\nL5\nL6")),
    ] {
        let text = called(main, &sub);
        assert!(tells(&text, COMPENSATION), "{text}");
    }
    let circle = format!("%_N_L1_SPF\nL2\n{HOLE}M17\n%_N_L2_SPF\nL1\nM17\n");
    assert!(!tells(&circle, COMPENSATION));
    let many: String = (1..400).map(|n| format!("%_N_L{n}_SPF\nL{}\nL{}\nM17\n", n + 1, n + 2)).collect();
    assert!(!found(&format!("G17 G40 T9 D1\nL1\nM30\n{many}{HOLE}")).is_empty());
}

// oracle: manual B:656 (not deeper than the fifth level)
#[test]
fn every_way_to_call_counts_as_a_level() {
    for way in [
        "L#",
        "L# P2",
        "PCALL L#",
        "PCALL /_N_WKS_DIR/_N_PART_WPD/_N_L#_SPF",
        "PCALL/_N_SPF_DIR/L#",
        "CALL \"L#\"",
        "CALL \"/_N_SPF_DIR/_N_L#_SPF\"",
        "MCALL L#",
    ] {
        let chain = |deepest: usize| {
            let name = |n: usize| way.replace('#', &n.to_string());
            let subs: String = (2..deepest).map(|n| format!("%_N_L{n}_SPF\n{}\nM17\n", name(n + 1))).collect();
            let main = format!("%_N_M_MPF\nG17 G40 T9 D1\n{}\nM30\n", name(2));
            format!("{main}{subs}%_N_L{deepest}_SPF\n{HOLE}M17\n")
        };
        assert!(!tells(&chain(5), LEVEL), "{way}");
        assert!(tells(&chain(6), LEVEL), "{way}");
    }
}

// oracle: hand: what takes the state away stands between the values and the call, so the remedy stands behind it
#[test]
fn a_cure_stands_where_it_counts_at_the_call() {
    let begin = "G17 G40 G54 T9 D1 M6\n_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\n";
    for (between, code, cure) in [
        ("D0\n_TSA=1\n", Alarm(61311), "D0\nD1\n_TSA=1\n"),
        ("G41 G0 X5\n", COMPENSATION, "G41 G0 X5\nG40\n"),
        ("IF R1==1\n_TSA=1\nD0\nENDIF\nS500 M3\n", SPINDLE, "IF R1==1\n_TSA=1\nD0\nENDIF\nS500 M3\nM5\n"),
        ("D0\nIF R1==1\nGOTOF A\nENDIF\nA: ", Alarm(61311), "D0\nIF R1==1\nGOTOF A\nENDIF\nA: D1\n"),
    ] {
        let text = format!("{begin}{between}CYCLE977\nM30\n");
        let found = found(&text);
        let finding = found.iter().find(|finding| finding.code == code).unwrap();
        let edits = &finding.cure.as_ref().unwrap().edits;
        let cured = String::from_utf8(apply(text.as_bytes(), edits)).unwrap();
        assert_eq!(cured, format!("{begin}{cure}CYCLE977\nM30\n"));
        assert!(!tells(&cured, code), "{cured}");
    }
}

// oracle: hand (behind REPEAT stand labels, behind CALL a variable or a cycle may stand, PROC and DEFINE declare)
#[test]
fn labels_variables_and_declarations_are_no_programs() {
    for lines in [
        "BEG: G0 X1\nLAST:\nREPEAT BEG LAST P=2",
        "BEG: G0 X1\nREPEATB BEG P=2",
        "DEF STRING[9] NEXT=\"L5\"\nCALL NEXT",
        "CALL \"CYCLE977\"",
        "DEFINE RAPID AS G0",
        "EXTERN FAR(INT, REAL)",
        "CYCLE83(1,2,3)",
        "GROUP_BEGIN(0,\"A\",0,0)",
    ] {
        let text = called(&format!("G17 G40 T9 D1\n{lines}\n{HOLE}"), "G0 X1");
        assert!(!tells(&text, OUTSIDE), "{lines}");
    }
    assert!(tells(&called(&format!("G17 G40 T9 D1\nFAR\n{HOLE}"), ""), OUTSIDE));
    assert!(tells("G0 X1\nCYCLE987\nM30", OUTSIDE), "no cycle of the control");
}

// oracle: hand (a cycle that only drills leaves what is active; one that nobody knows may change it)
#[test]
fn behind_an_unknown_cycle_nothing_is_known() {
    let open = |cycle: &str| tells(&format!("%_N_A_MPF\nG17 G40 G54 T9 D1\n{cycle}\n{HOLE}M30"), OPEN);
    assert!(!open("CYCLE83(1,2,3)"));
    assert!(open("CYCLE987"));
}
