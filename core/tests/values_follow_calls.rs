//! Values of measuring calls along the calls of subprograms, past branches and through loops, and where a change goes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::entry::names;
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::change::{apply, change};
use probewright_core::program::variables::variables;
use probewright_core::program::{arrivals, findings};
use probewright_core::syntax::{Program, read};
use probewright_core::words::Words;

const BEGIN: &str = "%_N_MAIN_MPF\nG17 G40 G54 T9 D1\n";
const REST: &str = "_MVAR=1 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\n";

fn sites(text: &str) -> (Program, Vec<CallSite>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let sites = calls(&program);
    (program, sites)
}

fn setpoint(site: &CallSite) -> &str {
    site.values.get("_SETVAL").map_or("", String::as_str)
}

/// What is said beside the setpoint of a call.
fn said(text: &str, call: usize) -> String {
    let (program, sites) = sites(text);
    let notes = arrivals(&program, &sites[call]);
    let note = notes.into_iter().find(|note| note.param == Some(names::SETVAL));
    note.map_or(String::new(), |note| Words::english().text(&note.message))
}

fn changed(text: &str, call: usize, name: &str, value: &str) -> String {
    let (program, sites) = sites(text);
    let edits = change(&program, &sites[call], name, value);
    String::from_utf8(apply(&program.source, &edits)).unwrap()
}

/// A main program, and subprograms `NAME` with their blocks.
fn whole(main: &str, subs: &[(&str, &str)]) -> String {
    let subs = subs.iter();
    let subs: String = subs.map(|(name, blocks)| format!("%_N_{name}_SPF\n{blocks}M17\n")).collect();
    format!("{BEGIN}{main}M30\n{subs}")
}

// oracle: hand (data of the channel: what a subprogram writes counts behind it)
#[test]
fn a_call_behind_a_subprogram_has_the_values_that_it_left() {
    let sub = [("VALUES", "_SETVAL=60\n_VMS=0\n")];
    let text = whole(&format!("{REST}_SETVAL=132\nVALUES\nCYCLE977\n"), &sub);
    let (_, found) = sites(&text);
    assert_eq!(setpoint(&found[0]), "60");
    assert_eq!(found[0].values["_FA"], "2");
    assert_eq!(said(&text, 0), "Written in line 9.");
    assert_eq!(changed(&text, 0, "_SETVAL", "61"), text.replace("=60", "=61"));
    assert_eq!(changed(&text, 0, "_FA", "3"), text.replace("_FA=2", "_FA=3"));
    // What is new stands behind the subprogram, which may write it too.
    assert_eq!(changed(&text, 0, "_ID", "-5"), text.replace("\nCYCLE977", "\n_ID=-5\nCYCLE977"));
    // Written again for the call, nothing comes from there.
    let again = text.replace("\nCYCLE977", "\n_SETVAL=70\nCYCLE977");
    assert_eq!(setpoint(&sites(&again).1[0]), "70");
    assert_eq!(said(&again, 0), "");
}

// oracle: hand
#[test]
fn the_order_of_the_text_is_not_that_of_the_run() {
    let sub = format!("%_N_VALUES_SPF\n{REST}_SETVAL=60\nM17\n");
    let main = "%_N_MAIN_MPF\nG17 T9 D1\n_SETVAL=132\nVALUES\nCYCLE977\nM30\n";
    for text in [format!("{sub}{main}"), format!("{main}{sub}")] {
        assert_eq!(setpoint(&sites(&text).1[0]), "60", "{text}");
        assert_eq!(changed(&text, 0, "_SETVAL", "61"), text.replace("=60", "=61"));
    }
}

/// A subprogram that measures a hole of the diameter that its caller gives.
const MEASURE: &str = "PROC MEASURE(REAL _D)\n_SETVAL=_D _MVAR=1 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\n";

// oracle: hand
#[test]
fn an_argument_arrives_in_the_subprogram_and_is_changed_at_its_call() {
    let text = whole("MEASURE(40)\n", &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    assert_eq!(said(&text, 0), "Written in line 3.");
    assert_eq!(changed(&text, 0, "_SETVAL", "45.5"), text.replace("(40)", "(45.5)"));
    assert_eq!(changed(&text, 0, "_SETVAL", ""), text, "no argument is taken away");
    assert_eq!(changed(&text, 0, "_FA", "4"), text.replace("_FA=2", "_FA=4"));
    // The same through another program.
    let deep = [("MEASURE", MEASURE), ("OUTER", "PROC OUTER(REAL _X)\nMEASURE(_X)\n")];
    let text = whole("OUTER(40)\n", &deep);
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text.replace("(40)", "(41)"));
    // A default of the PROC, and an expression that no text tells.
    let default = MEASURE.replace("REAL _D", "REAL _D=12");
    let text = whole("MEASURE\n", &[("MEASURE", &default)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "12");
    let text = whole("MEASURE(R7)\n", &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "_D");
}

// oracle: hand
#[test]
fn several_calls_with_the_same_value_show_it_and_with_others_say_so() {
    let text = whole("MEASURE(40)\nG0 X9\nMEASURE(40)\n", &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    assert_eq!(said(&text, 0), "Written in lines 3, 5.");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text.replace("(40)", "(41)"));
    let text = whole("MEASURE(40)\nMEASURE(50)\n", &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "_D");
    assert_eq!(said(&text, 0), "Depends on the path to this call: 40 (3), 50 (4).");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text, "which of them, nobody knows");
    // Data that each caller writes: there is no text that says both.
    let hole = format!("{REST}CYCLE977\n");
    let main = "_SETVAL=40\nHOLE\n_SETVAL=50\nHOLE\n";
    let text = whole(main, &[("HOLE", &hole)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "_SETVAL");
    assert_eq!(said(&text, 0), "Depends on the path to this call: 40 (3), 50 (5).");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text);
}

// oracle: manual (Fundamentals 10.2004, p. 2-15: leading zeroes are ignored in variables with numeric extensions)
#[test]
fn a_variable_is_the_same_with_leading_zeroes() {
    for (written, read) in [("R02", "R2"), ("R2", "R02"), ("R[2]", "R002"), ("R02", "R[2]")] {
        let text = whole(&format!("{REST}{written}=40\n_SETVAL={read}\nCYCLE977\n"), &[]);
        let (program, sites) = sites(&text);
        let found = variables(&program, &sites[0], "_SETVAL", "41");
        assert_eq!((found.len(), &*found[0].name, &found[0].assigned[..]), (1, "R2", &[4][..]), "{text}");
        let change = found[0].change.as_ref().unwrap();
        let after = apply(text.as_bytes(), std::slice::from_ref(&change.edit));
        assert_eq!(String::from_utf8(after).unwrap(), text.replace("=40", "=41"));
    }
}

// oracle: hand (more calls than are told apart: no change for some of them)
#[test]
fn of_many_calls_none_is_changed_alone() {
    let main: String = (0..40).map(|_| "MEASURE(40)\n").collect();
    let text = whole(&main, &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text);
    let main: String = (0..40).map(|n| format!("MEASURE({n})\n")).collect();
    let text = whole(&main, &[("MEASURE", MEASURE)]);
    assert_eq!(setpoint(&sites(&text).1[0]), "_D");
    // The last of them alone gives another probe.
    let probe = MEASURE.replace("REAL _D", "REAL _D,INT _P").replace("_PRNUM=1", "_PRNUM=_P");
    let main: String = (10..50).map(|n| format!("MEASURE({n},1)\n")).collect();
    let program = |last: &str| whole(&format!("{main}{last}"), &[("MEASURE", &probe)]);
    let shown = |text: &str| sites(text).1[0].values["_PRNUM"].clone();
    assert_eq!(shown(&program("")), "1");
    assert_eq!(shown(&program("MEASURE(50,2)\n")), "_P");
    assert_eq!(changed(&program(""), 0, "_PRNUM", "3"), program(""));
}

// oracle: hand
#[test]
fn values_of_the_caller_that_a_subprogram_leaves_alone_stay() {
    let many: String = (1..30).map(|n| format!("R1={n}\nOTHER\n")).collect();
    let main = format!("{REST}_SETVAL=132\n{many}CYCLE977\n");
    let text = whole(&main, &[("OTHER", "PROC OTHER\nDEF REAL _LOCAL=R1\n_LOCAL=_LOCAL+1\n")]);
    let (_, found) = sites(&text);
    assert_eq!(setpoint(&found[0]), "132");
    assert!(found[0].origins.is_empty());
    // What a program declares is its own; what it takes by reference is its caller's.
    let own = ("OWN", "DEF REAL SIZE=5\nSIZE=6\n");
    let text = whole(&format!("DEF REAL SIZE=40\n{REST}OWN\n_SETVAL=SIZE\nCYCLE977\n"), &[own]);
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    let given = ("GIVEN", "PROC GIVEN(VAR REAL _OUT)\n_OUT=45\n");
    let main = format!("DEF REAL SIZE=40\n{REST}GIVEN(SIZE)\n_SETVAL=SIZE\nCYCLE977\n");
    assert_eq!(setpoint(&sites(&whole(&main, &[given])).1[0]), "45");
}

// oracle: hand (who measures first with a value owns it)
#[test]
fn a_value_that_another_call_took_before_is_written_anew() {
    let main = format!("{REST}_SETVAL=40\nCYCLE977\nHOLE\n");
    let text = whole(&main, &[("HOLE", "G0 X5\nCYCLE977\n")]);
    assert_eq!(setpoint(&sites(&text).1[1]), "40");
    assert_eq!(changed(&text, 1, "_SETVAL", "41"), text.replace("G0 X5\nCYCLE977", "G0 X5\n_SETVAL=41\nCYCLE977"));
}

// oracle: hand
#[test]
fn what_a_branch_decides_is_told() {
    let way = |one: &str, other: &str| {
        let choice = format!("IF R1>0\n_SETVAL={one}\nELSE\n_SETVAL={other}\nENDIF\n");
        whole(&format!("{REST}{choice}CYCLE977\n"), &[])
    };
    let text = way("40", "50");
    assert_eq!(setpoint(&sites(&text).1[0]), "_SETVAL");
    assert_eq!(said(&text, 0), "Depends on the path to this call: 40 (5), 50 (7).");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text);
    let text = way("40", "40");
    assert_eq!(setpoint(&sites(&text).1[0]), "40");
    assert_eq!(changed(&text, 0, "_SETVAL", "41"), text.replace("=40", "=41"));
    // Only one of the ways ends.
    let left = whole(&format!("{REST}_SETVAL=40\nIF R1>0\n_SETVAL=50\nM30\nENDIF\nCYCLE977\n"), &[]);
    assert_eq!(setpoint(&sites(&left).1[0]), "40");
    let jumped = format!("{REST}_SETVAL=40\nIF R1>0 GOTOF OVER\n_SETVAL=50\nOVER:\nCYCLE977\n");
    assert_eq!(setpoint(&sites(&whole(&jumped, &[])).1[0]), "_SETVAL");
}

// oracle: hand
#[test]
fn a_loop_brings_back_what_its_end_leaves() {
    let around =
        |begin: &str, end: &str| whole(&format!("{REST}_SETVAL=40\n{begin}\nCYCLE977\n_SETVAL=50\n{end}\n"), &[]);
    for (begin, end) in [
        ("LOOP", "ENDLOOP"),
        ("WHILE R1<5", "ENDWHILE"),
        ("FOR R1=1 TO 5", "ENDFOR"),
        ("REPEAT", "UNTIL R1>5"),
        ("AGAIN:", "IF R1<5 GOTOB AGAIN"),
    ] {
        let text = around(begin, end);
        assert_eq!(said(&text, 0), "Depends on the path to this call: 40 (4), 50 (7).", "{text}");
    }
    let counted = whole(&format!("{REST}FOR R1=1 TO 3\n_SETVAL=R1*10\nCYCLE977\nENDFOR\n"), &[]);
    assert_eq!(setpoint(&sites(&counted).1[0]), "R1*10");
}

// oracle: hand (each way is checked with its own values)
#[test]
fn a_wrong_value_of_one_call_is_told_where_it_is_written() {
    let text = whole("MEASURE(40)\nMEASURE(-5)\n", &[("MEASURE", MEASURE)]);
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let all = findings(&program);
    let wrong = all.iter().filter(|one| one.param == Some(names::SETVAL));
    let places: Vec<&[u8]> = wrong.map(|one| program.text(one.span.unwrap())).collect();
    assert_eq!(places, [b"-5"]);
}

// oracle: hand
#[test]
fn what_does_not_reach_its_call_is_told_with_a_cure() {
    let text = whole(&format!("{REST}_SETVAL=132\nVALUES\nCYCLE977\n"), &[("VALUES", "_SETVAL=60\n")]);
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let all = findings(&program);
    let told = all.iter().find(|one| one.code == Code::Own(150)).unwrap();
    let mended = apply(&program.source, &told.cure.as_ref().unwrap().edits);
    let mended = String::from_utf8(mended).unwrap();
    assert_eq!(mended, text.replace("\nCYCLE977", "\n_SETVAL=132\nCYCLE977"));
    assert_eq!(setpoint(&sites(&mended).1[0]), "132");
    assert!(findings(&read(Dialect::Sinumerik, mended.as_bytes())).iter().all(|one| one.code != Code::Own(150)));
}

// oracle: hand (a jump from a later structure back into a loop that has ended: its end then belongs to no loop that
// began before it; the value of the later structure arrives all the same)
#[test]
fn a_jump_back_into_a_loop_that_has_ended_is_followed() {
    let text = "G17\n_MVAR=1 _SETVAL=10\nFOR R1=1 TO 2\nIF R2==1\nINSIDE: G0 X1\nENDIF\nENDFOR\nG0 X2\nREPEAT\n\
        _SETVAL=20\nIF R9<11 GOTOB INSIDE\nUNTIL R3==1\nCYCLE977\nM30\n";
    let (_, sites) = sites(text);
    assert_eq!(sites.len(), 1);
    assert_eq!(setpoint(&sites[0]), "20");
}
