//! The macro language of NCT: variables, expressions, jumps and loops, calls of programs with and without arguments.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "running/nct_block.rs"]
mod nct_block;

use nct_block::over_a_block;
use probewright_core::control::Plane;
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::trace::Step;
use probewright_core::machine::{Setup, Stop};
use probewright_core::message::Message;
use probewright_core::program::calls::calls;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::position::Positions;
use probewright_core::syntax::read;

fn go(text: &str) -> Outcome {
    let program = read(Dialect::Nct, text.as_bytes());
    let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    run(&program, &setup, Limits::default())
}

/// A common variable after a run without any finding.
fn number(text: &str, name: &str) -> f64 {
    let outcome = go(text);
    assert_eq!(outcome.diagnostics, [], "{text}");
    assert_eq!(outcome.stop, None, "{text}");
    outcome.control.number(name)
}

/// Key of the fault that ends a run, with line and column of its finding.
fn fault(text: &str) -> (String, (u32, u32)) {
    let outcome = go(text);
    let Some(Stop::Fault(message)) = &outcome.stop else {
        panic!("{text}: {:?} {:?}", outcome.stop, outcome.diagnostics);
    };
    let mut findings = outcome.diagnostics.iter();
    let finding = findings.find(|finding| finding.message.key == message.key);
    let span = finding.unwrap().span.unwrap();
    let place = Positions::new(text.as_bytes()).line_column(span.start);
    (message.key.to_string(), place)
}

// oracle: hand
#[test]
fn expressions_are_worked_out() {
    for (expression, expected) in [
        ("1+2*3", 7.0),
        ("[1+2]*3", 9.0),
        ("-#100+5", 5.0),
        ("10/4", 2.5),
        ("7 MOD 4", 3.0),
        ("6 AND 3", 2.0),
        ("6 OR 3", 7.0),
        ("6 XOR 3", 5.0),
        ("[2 GT 1] AND [1 LE 1]", 1.0),
        ("SQRT[9]+ABS[-2]", 5.0),
        ("SIN[30]", 0.5),
        ("ATAN[1]/[1]", 45.0),
        ("FIX[2.7]+FUP[2.1]", 5.0),
        ("ROUND[2.5]", 3.0),
        ("NOT[0]", -1.0),
        ("[3 EQ 3]+[3 NE 3]", 1.0),
    ] {
        let found = number(&format!("#600={expression}\nM30"), "#600");
        assert!((found - expected).abs() < 1e-12, "{expression}: {found}");
    }
}

// oracle: hand; a vacant variable is 0 in arithmetic, unlike 0 for EQ and NE, and its address is not written
#[test]
fn a_variable_to_which_nothing_was_written_is_vacant() {
    for (text, expected) in [
        ("#600=#1+1", 1.0),
        ("#600=[#1 EQ #0]", 1.0),
        ("#600=[#1 EQ 0]", 0.0),
        ("#600=[#1 NE 0]", 1.0),
        ("#600=[#1 GE 0]", 1.0),
        ("#1=4\n#1=#0\n#600=[#1 EQ #0]", 1.0),
        ("#600=7\n#600=#0\n#600=[#600 EQ #0]", 1.0),
    ] {
        assert_eq!(number(text, "#600"), expected, "{text}");
    }
    let outcome = go("G0 X5 Y6\nX#1 Y7\nM30");
    assert_eq!(outcome.position[..2], [5.0, 7.0]);
}

// oracle: hand
#[test]
fn variables_are_reached_by_their_number() {
    for text in ["#0600=3", "#1=600\n#[#1]=3", "#1=599\n#[#1+1]=3", "#1=600\n##1=3", "#2=3\n#1=2\n#600=##1"] {
        assert_eq!(number(text, "#600"), 3.0, "{text}");
    }
}

// oracle: hand
#[test]
fn jumps_and_loops() {
    for (text, expected) in [
        ("IF[1 EQ 1]GOTO 10\n#600=9\nN10 #600=#600+1", 1.0),
        ("#600=0\nN5 #600=#600+1\nIF[#600 LT 4]GOTO 5", 4.0),
        ("#1=20\nGOTO #1\n#600=9\nN0020 #600=#600+2", 2.0),
        ("GOTO[10*2]\n#600=9\nN20 #600=#600+2", 2.0),
        // N 188: the target may be a variable or a formula, with brackets or without
        ("#1=300\nGOTO #1+1\nN300 #600=9\nN301 #600=#600+2", 2.0),
        ("GOTO #4+300\n#600=9\nN300 #600=#600+2", 2.0),
        ("#1=2\nIF[#1 EQ 2]GOTO #1*10+3\nN2 #600=9\nN20 #600=#600+9\nN23 #600=#600+1", 1.0),
        ("#1=2\nIF[#1 EQ 2]GOTO 20+#1(ON)\nN20 #600=9\nN22 #600=#600+1", 1.0),
        ("#1=7\n#2=0.1\nGOTO #1*#2*10\nN7 #600=3", 3.0),
        ("IF[#1 EQ #0]THEN #600=8", 8.0),
        ("IF[#1 NE #0]THEN #600=8", 0.0),
        ("#1=0\nWHILE[#1 LT 5]DO1\n#1=#1+1\n#600=#600+#1\nEND1", 15.0),
        ("#1=0\nWHILE[#1 LT 3]DO1\n#2=0\nWHILE[#2 LT 2]DO2\n#600=#600+1\n#2=#2+1\nEND2\n#1=#1+1\nEND1", 6.0),
        ("DO1\n#600=#600+1\nIF[#600 EQ 7]GOTO 9\nEND1\nN9 M30", 7.0),
        ("WHILE[0]DO1\n#600=5\nEND1", 0.0),
    ] {
        assert_eq!(number(text, "#600"), expected, "{text}");
    }
}

// oracle: hand
#[test]
fn programs_are_called_with_the_variables_of_the_caller() {
    for (text, expected) in [
        ("O1\n#1=2\nM98 P20\n#600=#1\nM30\nO20\n#1=#1*10\nM99", 20.0),
        ("O1\nM98 P20 L3\nM30\nO0020\n#600=#600+1\nM99", 3.0),
        ("%O1\nM98 P20\n#600=#600+1\nM30\n%O20\n#600=4\nM99\n%", 5.0),
        ("%\nO1 (MAIN)\nM98 P20\nM30\n:20\n#600=6\nM99\n%", 6.0),
        ("O1\nM98 P20\n#600=9\nN7 #600=#600+1\nM30\nO20\nM99 P7", 1.0),
        ("O1\nM98 P20\nM30\nO20\nM98 P30\n#600=#600+1\nM99\nO30\n#600=1\nM99", 2.0),
    ] {
        assert_eq!(number(text, "#600"), expected, "{text}");
    }
}

// oracle: hand
#[test]
fn programs_are_called_with_arguments() {
    for (text, expected) in [
        ("G65 P20 A1 B20 Z300", 321.0),
        ("#1=7\nG65 P20 A1\n#600=#600+#1", 8.0),
        ("G65 P20 A1 L2", 1.0),
        ("G65 P20 I100 J20 K3", 123.0),
        ("G65 P20 I1 I10 J4", 15.0),
    ] {
        let called = "O20\n#600=#1+#2+#26+#4+#5+#6+#7+#8\n#1=99\nM99";
        let text = format!("O1\n{text}\nM30\n{called}");
        assert_eq!(number(&text, "#600"), expected, "{text}");
    }
    let vacant = "O1\nG65 P20 A1\nM30\nO20\n#600=[#2 EQ #0]\nM99";
    assert_eq!(number(vacant, "#600"), 1.0);
}

// oracle: hand: the main program begins anew with M99, until a jump leaves it
#[test]
fn the_main_program_may_begin_anew() {
    let text = "O1\n#600=#600+1\nIF[#600 EQ 3]GOTO 9\nM99\nN9 M30";
    assert_eq!(number(text, "#600"), 3.0);
    let text = "#600=0\nN3 #600=#600+1\nIF[#600 EQ 3]GOTO 9\nM99 P3\nN9 M30";
    assert_eq!(number(text, "#600"), 3.0);
}

// oracle: hand: what is not known, or never ends, is reported at its place
#[test]
fn wrong_programs_stop_at_their_place() {
    for (text, key, place) in [
        ("G0 X1\n#400=1", "run-unknown-variable", (2, 1)),
        ("#600=#9345", "run-unknown-variable", (1, 6)),
        ("#600=#[1000000000000]", "run-unknown-variable", (1, 6)),
        ("#600=#[-1]", "run-unknown-variable", (1, 6)),
        ("#0=1", "run-read-only", (1, 1)),
        ("#1003=1", "run-read-only", (1, 1)),
        ("#5001=1", "run-read-only", (1, 1)),
        ("#600=#5004", "run-unknown-variable", (1, 6)),
        ("#5341=1", "run-unknown-variable", (1, 1)),
        ("#600=#4004", "run-unknown-variable", (1, 6)),
        ("#5061=1", "run-read-only", (1, 1)),
        ("#600=#2001", "run-offset-variable", (1, 6)),
        ("#13005=1", "run-offset-variable", (1, 1)),
        ("G0 X1\n#3000=12(PART MISSING)", "run-set-alarm", (2, 1)),
        ("#600=1/#1", "run-division", (1, 8)),
        ("GOTO 5", "run-label", (1, 1)),
        ("GOTO #4", "run-not-a-number", (1, 6)),
        // a part of a formula decides nothing: the whole word is not read
        ("#1=5\nIF #1-5 GOTO 5\nN5 M30", "run-unread-way", (2, 1)),
        ("#1=5\nIF[#1 EQ 5]-1 GOTO 5\nN5 M30", "run-unread-way", (2, 1)),
        ("#1=5\nWHILE[#1 LT 5]+1 DO1\nEND1\nM30", "run-unread-way", (2, 1)),
        ("#1=5\nWHILE #1 LT 5 DO1\nEND1\nM30", "run-unread-way", (2, 1)),
        ("M98 P20\nM30\nO20\nM99 P4", "run-label", (4, 1)),
        ("WHILE[1]DO1\nEND2", "run-unmatched", (1, 1)),
        ("END1", "run-unmatched", (1, 1)),
        ("N1 GOTO 1", "run-endless", (1, 1)),
        ("DO1\nEND1", "run-endless", (2, 1)),
        ("#600=1\nM99", "run-endless", (2, 1)),
        ("M98", "run-no-program", (1, 1)),
        ("G65 A1", "run-no-program", (1, 1)),
        ("M98 P20 L-1", "run-range", (1, 9)),
        ("O1\nM98 P1", "run-depth", (2, 5)),
        ("O1\nG65 P1", "run-depth", (2, 5)),
        ("M30\nO2\nM99", "", (0, 0)),
    ] {
        if key.is_empty() {
            assert_eq!(go(text).stop, None, "{text}");
            continue;
        }
        let (found, at) = fault(text);
        assert_eq!(found, key, "{text}");
        assert_eq!(at, place, "{text}");
    }
    let groups = "I1".repeat(11);
    let text = format!("G65 P20 {groups}\nM30\nO20\nM99");
    assert_eq!(fault(&text).0, "run-arguments");
    let Some(Stop::Fault(message)) = go(&text).stop else { panic!("{text}") };
    assert_eq!(message.word("word"), Some("G65"));
}

// oracle: hand (G103 limits the look-ahead on controls with other macros; an address that the macro knows makes it a
// call)
#[test]
fn a_function_of_another_control_is_no_call_of_a_macro() {
    for text in ["G103 P1\nM30", "G103\nM30", "G0 X1\nG103 P0\nG0 X2\nM30"] {
        let program = read(Dialect::Nct, text.as_bytes());
        let foreign = text.contains('P');
        let found = probewright_core::program::findings(&program);
        let note = |one: &probewright_core::diagnostic::Diagnostic| {
            one.severity == Severity::Note && one.message.key == "nct-foreign"
        };
        assert_eq!(found.iter().any(note), foreign, "{text}: {found:?}");
        assert_eq!(calls(&program).is_empty(), foreign, "{text}");
        if foreign {
            let outcome = go(text);
            assert!(outcome.finished() && outcome.diagnostics.iter().all(note), "{text}");
            assert_eq!(outcome.passed_over[0].word, "G103");
        }
    }
    let mistaken = read(Dialect::Nct, b"G110 D50 E3");
    assert_eq!(calls(&mistaken).len(), 1);
}

// oracle: hand (an argument that cannot be read is no argument)
#[test]
fn a_macro_with_an_address_that_cannot_be_read_does_not_measure() {
    for text in ["G110 D50,5 Q1", "G110 D50 Q[1", "#1=5,5\nG110 D#1", "#500=[1\n#1=#500"] {
        assert_eq!(fault(text).0, "run-unread-value", "{text}");
    }
    let outcome = go("#1=5,5\n#1=6\nM30");
    assert!(outcome.finished());
    assert_eq!(outcome.passed_over.len(), 1);
}

// oracle: hand: a run goes on behind what it does not know, and says so
#[test]
fn unknown_words_and_programs_are_told() {
    for (text, key) in [
        ("M98 P999", "run-subprogram"),
        ("G65 P999 A1", "run-subprogram"),
        ("G65 P1.5", "run-subprogram"),
        ("G777", "run-unknown-word"),
        ("(A\nG0 X0", "syntax-comment"),
        ("M77", "run-machine-function"),
        ("Q5", "run-passed"),
        ("O1\nG65 P2 ,C1\nM30\nO2\nM99", "run-unknown-word"),
        ("HALLO", "syntax-unknown"),
        ("X1,5", "syntax-comma"),
        ("#1=1E-3", "syntax-no-exponent"),
    ] {
        let outcome = go(text);
        assert_eq!(outcome.stop, None, "{text}");
        let keys: Vec<_> = outcome.diagnostics.iter().map(|d| &*d.message.key).collect();
        assert_eq!(keys, [key], "{text}");
    }
}

// oracle: hand
#[test]
fn the_control_tells_what_is_in_force() {
    for (text, expected) in [
        ("G1 F100\n#600=#4001", 1.0),
        ("G18\n#600=#4002", 18.0),
        ("G91\n#600=#4003", 91.0),
        ("#600=#4005", 94.0),
        ("G20\n#600=#4006", 20.0),
        ("#600=#4007", 40.0),
        ("G49\n#600=#4008", 49.0),
        ("G59\n#600=#4014", 59.0),
        ("D7\n#600=#4107", 7.0),
        ("F250\n#600=#4109", 250.0),
        ("S1200\n#600=#4119", 1200.0),
    ] {
        assert_eq!(number(text, "#600"), expected, "{text}");
    }
}

// oracle: hand: the tip is where the program moved it, the spindle nose stands above it by the active length
#[test]
fn the_control_tells_where_it_stands() {
    let moved = "G90 G0 X12 Y34 Z56\n";
    for (read, expected) in [("#5001", 12.0), ("#5002", 34.0), ("#5003", 56.0)] {
        let found = number(&format!("{moved}#600={read}"), "#600");
        assert!((found - expected).abs() < 1e-9, "{read}: {found}");
    }
    for closed in ["#5043-#5003-#5083", "#5041-#5001", "#5023-#5043-#5203-#5223"] {
        let found = number(&format!("{moved}#600={closed}"), "#600");
        assert!(found.abs() < 1e-9, "{closed}: {found}");
    }
    let inch = number(&format!("{moved}G20\n#600=#5001*25.4"), "#600");
    assert!((inch - 12.0).abs() < 1e-9);
}

// oracle: programmer's manual N 183: the tip in the work offset at the signal, with the length taken into account; the
// end of the motion where none came
#[test]
fn the_control_tells_where_the_signal_came() {
    for (text, expected) in [
        ("G31 Z-5 F100\n#600=#5063", 0.0),
        ("G31 Z-5 F100\n#600=#5003-#5063", 0.0),
        ("G31 Z5 F100\n#600=#5063", 5.0),
        ("G31 Z-5 F100\nG0 Z30\n#600=#5063", 0.0),
        ("G31 Z-5 F100\nG0 X7 Z30\n#600=#5061", 0.0),
        ("G20 G31 Z.5 F4\n#600=#5063", 0.5),
        ("#600=[#5063 EQ #0]", 1.0),
    ] {
        let program = read(Dialect::Nct, text.as_bytes());
        let outcome = run(&program, &over_a_block(), Limits::default());
        assert_eq!((outcome.stop, outcome.diagnostics), (None, vec![]), "{text}");
        let found = outcome.control.number("#600");
        assert!((found - expected).abs() < 1e-9, "{text}: {found}");
    }
    let key = go("G31 Z-5").diagnostics[0].message.key.clone();
    assert_eq!(key, "run-no-feed");
}

// oracle: hand: what an operator would do changes nothing here, and is read as it was written
#[test]
fn single_blocks_and_overrides_are_taken_and_read() {
    assert_eq!(number("#3003=1\n#3004=6\n#600=#3003*10+#3004", "#600"), 16.0);
    assert_eq!(number("#3002=2\n#600=FIX[#3002]", "#600"), 2.0);
}

// oracle: hand: a work offset that the program writes counts at once where it is active
#[test]
fn a_program_writes_work_offsets() {
    let text = "G54 G0 X10\n#1=#5021\n#5221=#5221+5\nX10\n#600=#5021-#1";
    assert!((number(text, "#600") - 5.0).abs() < 1e-9);
    let text = "G54 G0 X10\n#1=#5021\n#5201=#5201-2\nX10\n#600=#5021-#1";
    assert!((number(text, "#600") + 2.0).abs() < 1e-9);
    let text = "G54 G0 X10\n#1=#5021\n#5321=7\nX10\n#600=#5021-#1+#5321";
    assert!((number(text, "#600") - 7.0).abs() < 1e-9);
    let control = go("G20\n#5321=1").control;
    assert_eq!(control.variable("G59 X"), Some(25.4));
}

// oracle: manual C:90 names the clock; hand: it goes on with the program and starts where it is set
#[test]
fn the_clock_goes_on() {
    let text = "#3001=0\nWHILE[#3001 LT 50]DO1\n#600=#600+1\nEND1";
    let rounds = number(text, "#600");
    assert!((10.0..=50.0).contains(&rounds), "{rounds}");
}

// oracle: hand
#[test]
fn a_program_stops_with_its_own_text() {
    let outcome = go("#3006=1 (CLEAN THE BALL)\nM30");
    assert_eq!(outcome.stop, None);
    let shown = Step::Message { text: "CLEAN THE BALL".to_owned(), waits: true };
    assert!(outcome.trace.entries.iter().any(|entry| entry.step == shown));
    let outcome = go("#3000=12 (PART MISSING)\nM30");
    let Some(Stop::Fault(message)) = outcome.stop else {
        panic!("{:?}", outcome.stop);
    };
    let expected = Message::new("run-set-alarm").number("number", 12.0).text("text", "PART MISSING");
    assert_eq!(message, expected);
}

// oracle: hand: the radius of register D1 beside the contour, that of D2 from the block in which it is called
#[test]
fn the_radius_is_that_of_the_register() {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    setup.control.edge_made(0, 1).radius = 5.0;
    setup.control.edge_made(0, 2).radius_wear = 4.0;
    setup.position = Mcs([0.0; 3]);
    let text = "G17 G90 G41 D1 G1 X20. Y0 F100\nX40.\nX60. D2\nX80.\nG40 X100.\nM30";
    let program = read(Dialect::Nct, text.as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]));
    let steps = outcome.trace.entries.iter();
    let ends = steps.filter_map(|entry| match entry.step {
        Step::Motion { to, .. } => Some((to[0], to[1])),
        _ => None,
    });
    let expected = [(20.0, 5.0), (40.0, 5.0), (60.0, 4.0), (80.0, 4.0), (100.0, 0.0)];
    assert_eq!(ends.collect::<Vec<_>>(), expected);
}
