//! Files that the log leaves: pages, columns, follow-up files, texts that are handed back.

use crate::control::{Plane, Value};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::machine::{Setup, Step, Stop};
use crate::run::{Limits, Outcome, run};
use crate::syntax::read;

/// What every program here begins with: a log of its own R parameters, without name and variant.
const BEGIN: &str = "_PROTNAME[1]=\"LOG_1\" _CBIT[6]=1 _CBIT[11]=1 _PROTFORM[3]=1 _HEADLINE[0]=\"HEAD\"\n\
    _PROTSYM[0]=\",\" _PROTVAL[0]=\"TITLE\" _PROTVAL[2]=\"R1,R2\" _PROTFORM[0]=0\n";

fn setup() -> Setup {
    Setup::calibrated(Dialect::Sinumerik, Plane::G17)
}

fn carried_out(text: &str, setup: &Setup) -> Outcome {
    run(&read(Dialect::Sinumerik, format!("{BEGIN}{text}\nM30\n").as_bytes()), setup, Limits::default())
}

fn ended(text: &str) -> Outcome {
    let outcome = carried_out(text, &setup());
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    outcome
}

fn names(outcome: &Outcome) -> Vec<&str> {
    outcome.files.iter().map(|(name, _)| name).collect()
}

fn lines<'a>(outcome: &'a Outcome, name: &str) -> &'a [String] {
    outcome.files.lines(name).unwrap()
}

// oracle: manual B:11227-11253, B:11521-11528 (two empty lines between blocks), hand (the header of the user)
#[test]
fn a_log_of_a_program_that_measures_nothing() {
    let outcome = ended("CYCLE100\nR1=1/3 R2=-2\nCYCLE106(2)\nR1=12345678.9\nCYCLE105(0)\nCYCLE101");
    let expected = ["HEAD", "0.333       , -2.000", "", "", "12345678.900, -2.000"];
    assert_eq!(lines(&outcome, "LOG_1.MPF"), expected);
    assert!(!outcome.control.bit("_CBIT[9]"));
    assert_eq!(outcome.alarms(), []);
    let written = outcome.trace.entries.iter().filter(|entry| matches!(entry.step, Step::File { .. }));
    assert_eq!(written.count(), 1 + expected.len(), "the file that is made, and its lines");
}

// oracle: manual B:11229 (a file of this name is deleted)
#[test]
fn switched_on_again_it_begins_anew() {
    let outcome = ended("CYCLE100\nCYCLE106(2)\nCYCLE101\nR1=7\nCYCLE100\nCYCLE106(2)\nCYCLE101");
    assert_eq!(lines(&outcome, "LOG_1.MPF"), ["HEAD", "7.000       , 0.000"]);
    assert_eq!(told(&outcome), ["run-log-deleted"]);
    let other = "CYCLE100\nCYCLE106(2)\nCYCLE101\n_PROTNAME[1]=\"LOG_2\"\nCYCLE100\nCYCLE106(2)\nCYCLE101";
    assert_eq!(told(&ended(other)), [""; 0], "each has its own name");
}

/// Keys of what a run tells.
fn told(outcome: &Outcome) -> Vec<String> {
    outcome.diagnostics.iter().map(|one| one.message.key.to_string()).collect()
}

// oracle: manual B:11435 (a header after so many lines; 0: only at the beginning), hand (a block is not torn)
#[test]
fn pages_have_their_lines() {
    let block = "CYCLE106(2)\n".repeat(4);
    let outcome = ended(&format!("_PROTFORM[0]=6\nCYCLE100\n{block}CYCLE101"));
    let value = "0.000       , 0.000";
    assert_eq!(lines(&outcome, "LOG_1.MPF"), ["HEAD", value, "", "", value, "HEAD", value, "", "", value]);
    let outcome = ended(&format!("CYCLE100\n{block}CYCLE101"));
    assert_eq!(lines(&outcome, "LOG_1.MPF").iter().filter(|line| *line == "HEAD").count(), 1);
}

// oracle: manual B:11425, B:11456 (the first page number, and those that follow)
#[test]
fn pages_are_counted() {
    let outcome =
        ended("_CBIT[11]=0 _PROTFORM[2]=7 _PROTFORM[0]=12\nCYCLE100\nCYCLE106(2)\nCYCLE106(2)\nCYCLE106(1)\nCYCLE101");
    let first = |line: &&String| line.starts_with("Date: ");
    let pages: Vec<&str> = lines(&outcome, "LOG_1.MPF").iter().filter(first).map(|line| &line[48..]).collect();
    assert_eq!(pages, ["Page: 7", "Page: 8", "Page: 9"]);
}

// oracle: manual B:11437 (widths of the title; a value has priority), A:15944-15948
#[test]
fn columns_are_as_wide_as_said() {
    let outcome = ended("_PROTFORM[5]=0 _PROTVAL[0]=\"Value   ,Second\"\nCYCLE100\nR1=1\nCYCLE106(2)\nCYCLE101");
    assert_eq!(lines(&outcome, "LOG_1.MPF")[1], "1.000   , 0.000");
    assert_eq!(outcome.alarms(), []);
    let outcome = ended("_PROTFORM[5]=4 _PROTVAL[2]=\"R1,R2,a\"\nCYCLE100\nCYCLE106(2)\nCYCLE101");
    assert_eq!(lines(&outcome, "LOG_1.MPF")[1], "0.000,0.000, a");
    assert_eq!(outcome.alarms(), [Code::Alarm(62309)]);
    let outcome = ended("_PROTFORM[1]=13 _PROTFORM[5]=4 _PROTVAL[2]=\"R1,R2,a\"\nCYCLE100\nCYCLE106(2)\nCYCLE101");
    assert_eq!(outcome.alarms(), [Code::Alarm(62309), Code::Alarm(62311)]);
    assert_eq!(outcome.control.number("_PROTFORM[1]"), 14.0);
}

/// A program that logs so many blocks of 100 characters.
fn long(blocks: usize) -> String {
    format!("_PROTVAL[2]=\"{}\"\nCYCLE100\n{}CYCLE101", "x".repeat(99), "CYCLE106(2)\n".repeat(blocks))
}

// oracle: manual B:11194-11198 (a new file with a digit, a message)
#[test]
fn a_full_log_goes_on_in_the_next_file() {
    let outcome = ended(&long(25));
    assert_eq!(names(&outcome), ["LOG_1.MPF", "LOG_1_1.MPF", "LOG_1_2.MPF"]);
    for name in names(&outcome) {
        let file = lines(&outcome, name);
        assert_eq!(file[0], "HEAD");
        assert!(outcome.files.size(name) <= 1024, "{name}");
    }
    let blocks = outcome.files.iter().flat_map(|(_, lines)| lines).filter(|line| line.starts_with('x')).count();
    assert_eq!(blocks, 25);
    let told =
        outcome.trace.entries.iter().filter(
            |entry| matches!(&entry.step, Step::Message { text, .. } if text == "New log file has been created"),
        );
    assert_eq!(told.count(), 2);
    let mut setup = setup();
    setup.control.set("MD11420", 5.0);
    let outcome = carried_out(&long(25), &setup);
    assert_eq!(names(&outcome), ["LOG_1.MPF"]);
}

// oracle: manual B:11198-11202 (up to nine files follow, then another name is wanted, and the program goes on)
#[test]
fn after_the_tenth_file_another_name_is_wanted() {
    let outcome = ended(&format!("{}\nR9=1", long(110)));
    assert_eq!(names(&outcome).len(), 10);
    assert_eq!(names(&outcome).last(), Some(&"LOG_1_9.MPF"));
    assert_eq!(outcome.control.number("R9"), 1.0);
    let said = |key: &str| outcome.decisions().iter().filter(|one| one.key == key).count();
    let blocks = outcome.files.iter().flat_map(|(_, lines)| lines).filter(|line| line.starts_with('x')).count();
    assert_eq!(blocks, 100, "ten in each file");
    assert_eq!(said("evaluate-log-full"), 1, "once, at the first block that is left out");
    let of_run = told(&outcome).into_iter().filter(|key| key.starts_with("run-")).collect::<Vec<_>>();
    assert_eq!(of_run, ["run-log-full"]);
    let waits = outcome.trace.entries.iter().filter(|one| matches!(one.step, Step::Message { waits: true, .. }));
    assert_eq!(waits.count(), 1, "for another name, once");
    let text = long(110).replace("CYCLE101", "_PROTNAME[1]=\"LOG_2\"\nCYCLE106(2)\nCYCLE101");
    let outcome = ended(&text);
    assert_eq!(lines(&outcome, "LOG_2.MPF").len(), 2, "header and block");
}

// oracle: manual B:11229 (follow-up files of an earlier log stay until their name is needed)
#[test]
fn old_follow_up_files_stay() {
    let again = "_PROTVAL[2]=\"R1\"\nCYCLE100\nCYCLE106(2)\nCYCLE101";
    let outcome = ended(&format!("{}\n{again}", long(15)));
    assert_eq!(names(&outcome), ["LOG_1.MPF", "LOG_1_1.MPF"]);
    assert_eq!(lines(&outcome, "LOG_1.MPF"), ["HEAD", "0.000"]);
    assert!(lines(&outcome, "LOG_1_1.MPF").len() > 2);
}

// oracle: manual A:15894 (61352), hand (what is wrong is told once, and the run stops)
#[test]
fn a_name_that_is_refused_is_told_once() {
    let outcome = carried_out("_PROTNAME[1]=\"/X/LOG\"\nCYCLE100", &setup());
    assert_eq!(outcome.alarms(), [Code::Alarm(61352)]);
    let told = outcome.diagnostics.iter().filter(|one| one.code == Code::Alarm(61352));
    assert_eq!(told.count(), 1, "{:?}", outcome.diagnostics);
}

// oracle: manual B:11209, B:11233 (without CYCLE101 the log stays on)
#[test]
fn a_log_that_stays_on_is_told() {
    let outcome = ended("CYCLE100");
    assert_eq!(told(&outcome), ["run-log-on"]);
    assert!(outcome.control.bit("_CBIT[9]"));
    assert_eq!(told(&ended("CYCLE100\nCYCLE101")), [""; 0]);
}

// oracle: manual B:11255-11260, B:11296-11320 (both examples; the second one as A:12644-12650 has it)
#[test]
fn texts_are_handed_back() {
    let text = "DEF STRING[10] DAY, CLOCK\nDEF STRING[12] TEXTVAR, THIRD\n\
        CYCLE113(1,DAY)\nCYCLE113(2,CLOCK)\nCYCLE118(100/$PI,2,TEXTVAR)\n\
        R11=0.1/$PI R12=1/$PI R13=10/$PI\nCYCLE118(0,_DIGIT,THIRD,3,11)\n\
        _TXT[20]=DAY _TXT[21]=CLOCK _TXT[22]=TEXTVAR _TXT[23]=THIRD";
    let mut setup = setup();
    setup.clock = "1998-09-15T10:05:30".parse().unwrap();
    let outcome = carried_out(text, &setup);
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    let texts = [20, 21, 22, 23, 0, 1, 2].map(|at| outcome.control.text(&format!("_TXT[{at}]")).to_owned());
    assert_eq!(texts, ["98/09/15", "10:05:30", "31.83", "3.183", "0.032", "0.318", "3.183"]);
}

// oracle: hand (1000 mm at 500 mm/min are two minutes; rapid traverse of 10 m takes a minute)
#[test]
fn the_clock_goes_on_with_the_motions() {
    let outcome = ended(
        "_PROTVAL[2]=\"_TIME\"\nG0 X0 Y0 Z100\nCYCLE100\nCYCLE105(0)\nG1 F500 X1000\nCYCLE105(0)\n\
         G0 X11000\nCYCLE105(0)\nCYCLE101",
    );
    let times = lines(&outcome, "LOG_1.MPF").iter().filter(|line| line.contains(':'));
    let seconds = |line: &String| {
        let parts: Vec<i32> = line.split(':').map(|part| part.parse().unwrap()).collect();
        parts[0] * 3600 + parts[1] * 60 + parts[2]
    };
    let seconds: Vec<i32> = times.map(seconds).collect();
    assert!((seconds[1] - seconds[0] - 120).abs() <= 1 && (seconds[2] - seconds[1] - 60).abs() <= 1, "{seconds:?}");
}

// oracle: manual A:15903 (a datum that cannot be logged stops the measurement that would log it)
#[test]
fn a_measurement_stops_where_its_block_cannot_be_printed() {
    let mut setup = super::marked::hole(40.02);
    setup.control.data.insert("_PROTVAL[3]".into(), Value::Text("_OVI[0]".into()));
    let text = format!("CYCLE100\n_PROTFORM[4]=2\n{}R8=1", super::marked::CALL);
    let outcome = carried_out(&text, &setup);
    assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(61361))));
    assert_eq!(outcome.control.number("R8"), 0.0);
}

// oracle: manual B:11288-11292 (any REAL number, decimals from 0 on, R parameters for several numbers), B:11258-11259
// (date or time), hand: halves are rounded away from 0
#[test]
fn numbers_of_any_size_become_texts_and_wrong_calls_are_told() {
    let called = |call: &str| carried_out(&format!("DEF STRING[12] T\n{call}\n_TXT[20]=T"), &setup());
    for (call, text) in [
        ("CYCLE118(2000000,3,T)", "2000000.000"),
        ("R1=1234567.5\nCYCLE118(R1,0,T)", "1234568"),
        ("CYCLE118(-1234567.25,2,T)", "-1234567.25"),
        ("CYCLE118(2.5,0,T)", "3"),
    ] {
        let outcome = called(call);
        assert_eq!((&outcome.stop, outcome.control.text("_TXT[20]")), (&None, text), "{:?}", outcome.diagnostics);
    }
    for call in ["CYCLE118(0,-1,T)", "CYCLE118(0,3,T,3)", "CYCLE113(3,T)"] {
        let outcome = called(call);
        assert!(matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == "run-call"), "{call}");
        assert!(outcome.diagnostics.iter().any(|one| one.message.key.starts_with("check-")), "{call}");
    }
    assert_eq!(called("CYCLE118(0,3,T,11,1)").stop, Some(Stop::Alarm(Code::Alarm(61362))));
}
