//! Doubts about whole programs: what is in force at a call, along the calls of subprograms and past branches.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::Dialect;
use probewright_core::control::{Control, Edge, delivery};
use probewright_core::diagnostic::Code::{self, Alarm, Own};
use probewright_core::diagnostic::Diagnostic;
use probewright_core::program::change::apply;
use probewright_core::program::{findings, findings_on, read};

/// A hole that is only measured, and its call.
const HOLE: &str = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\n";
/// The same at the tool probe: length of the tool in use.
const LENGTH: &str = "_MVAR=1 _MA=3 _ID=20 _PRNUM=1 _FA=10 _TSA=5\nCYCLE971\n";
/// A turning tool is measured.
const TURNED: &str = "_MVAR=1 _MA=1 _PRNUM=1 _FA=10 _TSA=5\nCYCLE972\n";

const COMPENSATION: Code = Own(130);
const PLANE: Code = Own(131);
const EDGE: Code = Own(133);
const SPINDLE: Code = Own(134);
const CALIBRATION: Code = Own(135);
const DIAMETER: Code = Own(132);
const FRAME: Code = Own(137);
const INHERITED: Code = Own(136);
const LEVEL: Code = Own(138);
const OPEN: Code = Own(145);
const COMPENSATION_LATER: Code = Own(146);
const NO_TOOL: Code = Own(147);
const RADIUS: Code = Own(148);
const OVERWRITTEN: Code = Own(150);
const OUTSIDE: Code = Own(152);

fn found(text: &str) -> Vec<Diagnostic> {
    findings(&read(Dialect::Sinumerik, text.as_bytes()))
}

fn tells(text: &str, code: Code) -> bool {
    found(text).iter().any(|finding| finding.code == code)
}

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

/// A main program and a subprogram `L5` with the call of the hole, or what is given.
fn called(main: &str, sub: &str) -> String {
    format!("%_N_MAIN_MPF\n{main}\nM30\n%_N_L5_SPF\n{sub}\nM17\n")
}

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
    let saved =
        format!("%_N_MAIN_MPF\nG17 G40 T9 D1\nL5\n{HOLE}M30\n%_N_L5_SPF\nPROC L5 SAVE\nG41\nM17\n");
    assert!(!tells(&saved, COMPENSATION));
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

// oracle: hand (what the text does not tell is not doubted)
#[test]
fn what_depends_on_the_run_is_not_doubted() {
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

// oracle: hand (what the end of a pass leaves, the next one finds)
#[test]
fn a_loop_is_followed_with_what_its_end_leaves() {
    let loops = [
        ("LOOP", "ENDLOOP"),
        ("WHILE R1<5", "ENDWHILE"),
        ("FOR R1=1 TO 5", "ENDFOR"),
        ("REPEAT", "UNTIL R1>5"),
        ("AGAIN:", "IF R1<5 GOTOB AGAIN"),
        ("N100 G0 X0", "GOTOB N100"),
    ];
    for (begin, end) in loops {
        let program = |body: &str| format!("G17 G40 G54 T9 D1\n{begin}\n{body}{end}\nM30\n");
        let milled = "G41 G1 X10\n";
        assert!(
            tells(&program(&format!("{HOLE}{milled}")), COMPENSATION),
            "{begin}"
        );
        assert!(
            tells(&program(&format!("{HOLE}S500 M3\n")), SPINDLE),
            "{begin}"
        );
        assert!(
            tells(&program(&format!("{HOLE}D0\n")), Alarm(61311)),
            "{begin}"
        );
        // Each of these comes back as it was, or leaves it to the run.
        for right in [
            format!("{HOLE}{milled}G40 X0\n"),
            format!("G40\n{HOLE}{milled}"),
            format!("{HOLE}IF R2>1\n{milled}ENDIF\n"),
            format!("{HOLE}{milled}L77\n"),
            format!("{HOLE}{milled}M30\n"),
        ] {
            assert!(!tells(&program(&right), COMPENSATION), "{begin} {right}");
        }
        // In a subprogram, and around one.
        let inside = called(
            "G17 G40 T9 D1\nL5",
            &format!("{begin}\n{HOLE}{milled}{end}"),
        );
        assert!(tells(&inside, COMPENSATION), "{begin}");
        let around = called(
            &format!("G17 G40 T9 D1\n{begin}\nL5\n{end}"),
            &format!("{HOLE}{milled}"),
        );
        assert!(tells(&around, COMPENSATION), "{begin}");
    }
}

// oracle: hand (a loop that may not run at all, and one that surely does)
#[test]
fn what_holds_behind_a_loop() {
    let behind = |begin: &str, end: &str| {
        let text = format!("G17 G40 G54 T9 D1\n{begin}\nG41 G1 X10\n{end}\n{HOLE}M30\n");
        tells(&text, COMPENSATION)
    };
    assert!(behind("FOR R1=1 TO 3", "ENDFOR"));
    assert!(behind("REPEAT", "UNTIL R1>5"));
    assert!(behind("AGAIN:", "IF R1<5 GOTOB AGAIN"));
    assert!(!behind("FOR R1=1 TO R2", "ENDFOR"));
    assert!(!behind("FOR R1=1 TO 0", "ENDFOR"));
    assert!(!behind("WHILE R1<5", "ENDWHILE"));
    // Out of the first pass or out of the second one.
    let text = "AGAIN:\nIF R1>3\nG41 G1 X5\nGOTOB AGAIN\nENDIF\n";
    assert!(!tells(
        &format!("G17 G40 T9 D1\n{text}{HOLE}M30\n"),
        COMPENSATION
    ));
}

// oracle: self (each body a few times, however deep it stands)
#[test]
fn loops_in_loops_come_to_an_end() {
    let depth = 200;
    let begin: String = (0..depth)
        .map(|n| format!("WHILE R{n}<5\nG{}\n", 17 + n % 3))
        .collect();
    let end: String = (0..depth)
        .map(|n| format!("G{}\nENDWHILE\n", 40 + n % 3))
        .collect();
    assert!(!found(&format!("T9 D1\n{begin}{HOLE}{end}M30\n")).is_empty());
    let labels: String = (0..400)
        .map(|n| format!("A{n}: G{}\n", 17 + n % 3))
        .collect();
    let jumps: String = (0..400)
        .map(|n| format!("IF R1<{n} GOTOB A{n}\n"))
        .collect();
    assert!(!found(&format!("D1\n{labels}{HOLE}{jumps}M30\n")).is_empty());
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
    assert_eq!(
        far,
        ["Not in this text: FAR, NEXT. What they leave is not known."]
    );
}

/// The program mended by the cure of the first finding with this code.
fn mended(text: &str, control: &Control, code: Code) -> String {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let all = findings_on(&program, control.clone());
    let one = all.iter().find(|one| one.code == code).unwrap();
    let edits = &one.cure.as_ref().unwrap().edits;
    String::from_utf8(apply(text.as_bytes(), edits)).unwrap()
}

// oracle: hand
#[test]
fn what_is_not_said_is_inserted_where_it_can_be_known() {
    let mut control = delivery(Dialect::Sinumerik);
    let text = format!("%_N_L5_SPF\n{HOLE}M17\n");
    assert_eq!(
        mended(&text, &control, OPEN),
        text.replace("_MVAR", "G40 G17\n_MVAR")
    );
    let text = "G18 DIAMOF T8 D1\nG0 X60\n_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2 _MA=2\nCYCLE974\nM30\n";
    let around = text
        .replace("_MVAR", "DIAMON\n_MVAR")
        .replace("\nM30", "\nDIAMOF\nM30");
    assert_eq!(mended(text, &control, RADIUS), around);
    // The tool table has one probe.
    for (number, kind) in [(3, 120), (9, 710)] {
        let edge = Edge {
            kind,
            ..Edge::default()
        };
        control
            .tools
            .entry(number)
            .or_default()
            .edges
            .insert(1, edge);
    }
    let text = format!("G17 G40 G54\nG0 X0\n{HOLE}M30\n");
    assert_eq!(
        mended(&text, &control, NO_TOOL),
        text.replace("_MVAR", "T9 D1\n_MVAR")
    );
    let changes = text.replace("M30", "T3 D1 M6\nM30");
    assert_eq!(
        mended(&changes, &control, NO_TOOL),
        changes.replace("_MVAR", "T9 D1 M6\n_MVAR")
    );
}

// oracle: hand
#[test]
fn programs_without_an_end_are_followed_to_an_end() {
    for (main, sub) in [
        ("G17 G41 T9 D1\nL5", format!("L5\n{HOLE}")),
        (
            "G17 G41 T9 D1\nL5\nL6",
            format!("{HOLE}M17\n%_N_L6_SPF\nL5\nL6"),
        ),
    ] {
        let text = called(main, &sub);
        assert!(tells(&text, COMPENSATION), "{text}");
    }
    let circle = format!("%_N_L1_SPF\nL2\n{HOLE}M17\n%_N_L2_SPF\nL1\nM17\n");
    assert!(!tells(&circle, COMPENSATION));
    let many: String = (1..400)
        .map(|n| format!("%_N_L{n}_SPF\nL{}\nL{}\nM17\n", n + 1, n + 2))
        .collect();
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
            let subs: String = (2..deepest)
                .map(|n| format!("%_N_L{n}_SPF\n{}\nM17\n", name(n + 1)))
                .collect();
            let main = format!("%_N_M_MPF\nG17 G40 T9 D1\n{}\nM30\n", name(2));
            format!("{main}{subs}%_N_L{deepest}_SPF\n{HOLE}M17\n")
        };
        assert!(!tells(&chain(5), LEVEL), "{way}");
        assert!(tells(&chain(6), LEVEL), "{way}");
    }
}

/// The hole corrects a zero offset, then the program goes on.
fn corrected(active: &str, knum: i64, behind: &str) -> String {
    let hole = HOLE
        .replace("_MVAR=1", "_MVAR=101")
        .replace("_KNUM=0", &format!("_KNUM={knum}"));
    format!("G17 G40 {active} T9 D1\n{hole}{behind}\nM30\n")
}

// oracle: manual B:1930-1969 (who puts a corrected frame in effect), hand
#[test]
fn a_corrected_frame_is_taken_before_the_program_goes_on_in_it() {
    let forgotten = [
        ("G54", 1, "G0 Z160"),
        ("G54", 1, "G1 X=R5"),
        ("G54", 1, "CYCLE81(10,0,2,-5)"),
        ("G505", 5, "G0 Z160"),
        ("G54", 2, "G54\nG0 X0"),
        ("G500", 1, "G55\nG0 X0"),
        ("G54", 1000, "G0 Z160"),
        ("G500", 1011, "G0 Z160"),
        ("G54", 1051, "G0 Z160"),
        ("G54", 2000, "G0 Z160"),
    ];
    for (active, knum, behind) in forgotten {
        let text = corrected(active, knum, behind);
        assert!(tells(&text, FRAME), "{text}");
    }
    let right = [
        ("G54", 1, "G54\nG0 Z160"),
        ("G54", 1, "G0 Z160\nG54"),
        ("G54", 1, "G54 G0 X0"),
        ("G54", 1, "G55\nG0 X0"),
        ("G54", 1, "SUPA G0 Z160"),
        ("G54", 1, "G53 G0 Z160"),
        ("G54", 1, "G75 Z=0"),
        ("G54", 1, "L77\nG0 X0"),
        ("G54", 1, "MSG(\"DONE\")"),
        ("G54", 1, "IF R1>0\nG54\nENDIF\nG0 Z160\nG54"),
        ("G54", 1, "IF R1>0 GOTOF OVER\nG0 Z160\nOVER: G54"),
        ("G54", 9999, "G0 Z160"),
        ("G54", 2, "G0 Z160"),
        ("G54", 2, "G55\nG0 X0"),
        ("G500", 1, "G500\nG0 X0"),
        ("G54", 1000, "G500\nG0 X0"),
        ("G54", 1011, "G54\nG0 X0"),
        ("G54", 2000, "G500\nG0 X0"),
        ("G54", 1, "$P_IFRAME=$P_UIFR[1]\nG0 X0"),
    ];
    for (active, knum, behind) in right {
        let text = corrected(active, knum, behind);
        assert!(!tells(&text, FRAME), "{text}");
    }
}

// oracle: hand (in X and in Y one after the other: the old frame is meant in between)
#[test]
fn two_calls_may_correct_one_frame_together() {
    let axis = |axis: i64, knum: i64| {
        format!("_MVAR=100 _SETVAL=0 _MA={axis} _KNUM={knum} _PRNUM=1 _FA=2 _TSA=2\nCYCLE978\n")
    };
    let program = |second: i64, behind: &str| {
        format!(
            "G17 G40 G54 T9 D1\n{}G0 X5 Y5\n{}{behind}\nM30\n",
            axis(1, 1),
            axis(2, second)
        )
    };
    assert!(!tells(&program(1, ""), FRAME));
    assert!(!tells(&program(1, "G54\nG0 X0"), FRAME));
    let all = found(&program(1, "G0 X0"));
    assert_eq!(all.iter().filter(|one| one.code == FRAME).count(), 1);
    assert!(tells(&program(0, "G0 X0"), FRAME));
}

// oracle: hand
#[test]
fn a_corrected_frame_is_followed_through_the_calls() {
    let hole = HOLE
        .replace("_MVAR=1", "_MVAR=101")
        .replace("_KNUM=0", "_KNUM=1");
    let begin = "G17 G40 G54 T9 D1\nL5";
    assert!(tells(&called(&format!("{begin}\nG0 X5"), &hole), FRAME));
    assert!(!tells(
        &called(&format!("{begin}\nG54\nG0 X5"), &hole),
        FRAME
    ));
    assert!(!tells(&called(begin, &format!("{hole}G54")), FRAME));
    // Who calls a subprogram may take the frame behind it.
    assert!(!tells(
        &format!("%_N_L5_SPF\nG54\n{hole}G0 X5\nM17\n"),
        FRAME
    ));
}

// oracle: hand (what a setter asks, and what the manual's own programs leave to the reset)
#[test]
fn what_nothing_in_the_text_says_is_asked_once() {
    let main = |before: &str, behind: &str| format!("{before}\n{HOLE}{behind}\nG0 Z100\nM30\n");
    let plain = main("G17 G54 T9 D1", "");
    for code in [OPEN, COMPENSATION_LATER, NO_TOOL, RADIUS, DIAMETER, PLANE] {
        assert!(!tells(&plain, code), "{code:?}");
    }
    assert!(tells(&main("G17 G54", ""), NO_TOOL));
    assert!(tells(&main("G17 G54 D1", ""), NO_TOOL));
    let later = main("G17 G54 T9 D1", "G41 G1 X10");
    assert!(tells(&later, COMPENSATION_LATER));
    assert!(!tells(
        &main("G17 G40 T9 D1", "G41 G1 X10"),
        COMPENSATION_LATER
    ));
    assert!(!tells(
        &main("G17 G54 T9 D1", "G41 G1 X10\nG40 X0"),
        COMPENSATION_LATER
    ));
    let sub = format!("%_N_L5_SPF\n{HOLE}{HOLE}M17\n");
    let all = found(&sub);
    let open: Vec<_> = all.iter().filter(|one| one.code == OPEN).collect();
    assert_eq!(open.len(), 1);
    let said = probewright_core::words::Words::english().text(&open[0].message);
    assert!(said.contains("G40, G17, T, D"), "{said}");
    let procedure = format!("PROC MEASURE(REAL SIZE)\n{HOLE}RET\n");
    assert!(tells(&procedure, OPEN));
    assert!(!tells(&main("G17 G40 G54 T=R5 D1", ""), OPEN));
    let prepared = format!("%_N_L5_SPF\nG17 G40 T9 D1\n{HOLE}M17\n");
    assert!(!tells(&prepared, OPEN));
    assert!(
        !tells(HOLE, OPEN) && !tells(HOLE, NO_TOOL),
        "a piece of a program"
    );
}

// oracle: manual B:10975 (diameters with DIAMON, else radii)
#[test]
fn a_setpoint_that_counts_as_a_radius_is_told_as_a_diameter() {
    let turned = |mode: &str, axis: i64| {
        let call = "_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2";
        format!("G18 G54 {mode} T8 D1\nG0 X60\n{call} _MA={axis}\nCYCLE974\nM30\n")
    };
    assert!(tells(&turned("DIAMOF", 2), RADIUS));
    assert!(
        !tells(&turned("DIAMOF", 1), RADIUS),
        "along Z there is no diameter"
    );
    assert!(!tells(&turned("DIAMON", 2), RADIUS));
    assert!(!tells(&turned("", 2), RADIUS) && tells(&turned("", 2), DIAMETER));
    // The plane of the caller decides which axis is transverse.
    let call = "_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2 _MA=2\nCYCLE974";
    assert!(tells(
        &called("G18 G40 DIAMOF T8 D1\nL5\nG17", call),
        RADIUS
    ));
}

/// Parameters about which a program raises the doubt that an earlier call left them.
fn inherited(text: &str) -> Vec<&'static str> {
    let all = found(text);
    let doubts = all.iter().filter(|finding| finding.code == INHERITED);
    doubts.filter_map(|finding| finding.param).collect()
}

// oracle: hand (labels, units and choices of both calls)
#[test]
fn a_value_that_means_something_else_at_a_later_call_is_doubted() {
    let hole = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=2 _FA=4 _TSA=2 _VMS=200 _EVNUM=7\nCYCLE977\n";
    let edge = hole
        .replace("_MVAR=1 ", "_MVAR=100 _MA=1 ")
        .replace("977", "978")
        .replace("=132", "=0");
    for (program, expected) in [
        // diameter, position
        (format!("{hole}_MVAR=0 _MA=1\nCYCLE978\n"), vec!["_SETVAL"]),
        (format!("{hole}_MVAR=0 _MA=1 _SETVAL=0\nCYCLE978\n"), vec![]),
        // hole, groove
        (format!("{hole}_MVAR=3 _MA=1\nCYCLE977\n"), vec!["_SETVAL"]),
        // both a diameter; path, safe area, feed and probe are meant to stay
        (format!("{hole}_MVAR=2 _ID=-5\nCYCLE977\n"), vec![]),
        (
            format!("{hole}_MVAR=1 _CPA=1 _CPO=1 _STA1=0 _INCA=60 _RF=500\nCYCLE979\n"),
            vec![],
        ),
        // the number of a variant of another cycle
        (format!("{hole}_MA=1 _SETVAL=0\nCYCLE978\n"), vec!["_MVAR"]),
        // a zero offset, the length of tool edge 1
        (
            edge.replace("_KNUM=0", "_KNUM=1") + "_MVAR=0 _SETVAL=5 _TNUM=3\nCYCLE978\n",
            vec!["_KNUM"],
        ),
        (format!("{edge}_MVAR=0 _SETVAL=5\nCYCLE978\n"), vec![]),
        // degrees out of millimetres
        (
            format!("{edge}_MVAR=105 _SETVAL=0 _MA=102 _ID=60 _RA=0 _STA1=0\nCYCLE998\n"),
            vec!["_TSA"],
        ),
        // the probe and the memory of workpieces
        (
            format!("{hole}_MVAR=1 _MA=3 _ID=20 _TSA=5 _FA=10\nCYCLE971\n"),
            vec!["_EVNUM", "_PRNUM"],
        ),
        (
            format!("{hole}_MVAR=1 _MA=3 _ID=20 _TSA=5 _FA=10 _PRNUM=1 _EVNUM=0\nCYCLE971\n"),
            vec![],
        ),
    ] {
        let mut told = inherited(&program);
        told.sort_unstable();
        assert_eq!(told, expected, "{program}");
    }
}

// oracle: self (every example of the catalogue, written in full after every other one, inherits nothing)
#[test]
fn a_call_that_is_written_in_full_inherits_nothing() {
    use probewright_core::catalogue::{CYCLES, Style};
    use probewright_core::check::Typed;
    use probewright_core::control::delivery;
    use probewright_core::program::write::snippet;
    let control = delivery(Dialect::Sinumerik);
    let examples = CYCLES
        .iter()
        .filter(|cycle| cycle.dialect == Dialect::Sinumerik);
    let texts: Vec<String> = examples
        .map(|cycle| {
            let mut typed: Typed = cycle
                .example
                .iter()
                .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()))
                .collect();
            for param in cycle.params {
                let delivered = param.fallback(&control).map(|value| value.to_string());
                typed
                    .entry(param.name.to_owned())
                    .or_insert(delivered.unwrap_or_default());
            }
            snippet(cycle, &typed, &control, Style::Direct, None).text
        })
        .collect();
    for first in &texts {
        for second in &texts {
            let program = format!("{first}\n{second}\n");
            assert_eq!(inherited(&program), [""; 0], "{program}");
        }
    }
}

// oracle: hand (parameters are data of the channel: what a subprogram writes counts behind it)
#[test]
fn a_value_that_a_subprogram_writes_anew_is_doubted() {
    let begin = "G17 G40 G54 T9 D1\n";
    let values = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\n";
    for (main, sub, doubted) in [
        ("L5\nCYCLE977", "_SETVAL=4", true),
        ("L5\nCYCLE977", "_SETVAL=R1", true),
        ("L5\nCYCLE977", "_SETVAL=132 _FA=2", false),
        ("L5\nCYCLE977", "R5=4", false),
        ("L5\n_SETVAL=132\nCYCLE977", "_SETVAL=4", false),
        ("CYCLE977\nL5", "_SETVAL=4", false),
        ("L5\nCYCLE977", "L6\nM17\n%_N_L6_SPF\n_SETVAL=4", true),
    ] {
        let text = called(&format!("{begin}{values}{main}"), sub);
        assert_eq!(tells(&text, OVERWRITTEN), doubted, "{text}");
    }
}
