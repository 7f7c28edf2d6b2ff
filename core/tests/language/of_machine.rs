//! What a program needs of its machine: data of definition files, values that only the machine has, programs that are
//! not there, parameters that nothing calls with.

use super::{clean, fault, findings, go, messages, number, setup};
use probewright_core::control::Value;
use probewright_core::dialect::Dialect;
use probewright_core::json::setup_from_json;
use probewright_core::machine::Stop;
use probewright_core::run::{Limits, Outcome, Session};
use probewright_core::syntax::definitions::definitions;
use probewright_core::syntax::read;
use proptest::prelude::*;

/// A program behind a definition file in the same text.
fn with(definitions: &str, text: &str) -> String {
    format!("%_N_GUD4_DEF\n;$PATH=/_N_DEF_DIR\n{definitions}\nM17\n%_N_MAIN_MPF\n{text}\nM30\n")
}

fn started(text: &str, limits: Limits, arguments: &[(&str, Value)]) -> Outcome {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let arguments = arguments.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let mut session = Session::new(program, &setup(), limits).with_arguments(arguments);
    while !session.advance(u64::MAX) {}
    session.outcome()
}

fn strict(text: &str) -> Outcome {
    started(text, Limits { strict: true, ..Limits::default() }, &[])
}

fn key(outcome: &Outcome) -> Option<&str> {
    if let Some(Stop::Fault(message)) = &outcome.stop { Some(&message.key) } else { None }
}

// oracle: manual B:13269-13288 (form of the lines), Job planning (user data begin with 0 where no value stands)
#[test]
fn data_of_a_definition_file_are_there_with_their_first_values() {
    let lines = "N10 DEF NCK REAL APW 2 PHU 24 LLI -10 ULI 100 SAFE=12.5\nDEF CHAN INT PARTS[2,2]=SET(1,,3)\n\
        DEF CHAN BOOL ON[3]=REP(TRUE)\nDEF NCK CHAR LETTER=\"A\"\nREDEF SAFE APR 4";
    let text = with(lines, "R1=SAFE R2=PARTS[0,0]+PARTS[0,1]+10*PARTS[1,0] R3=ON[2] R4=(LETTER==\"A\")");
    let control = clean(&text).control;
    assert_eq!(["R1", "R2", "R3", "R4"].map(|name| control.number(name)), [12.5, 31.0, 1.0, 1.0]);
}

// oracle: hand: a whole number is rounded, a text keeps its length, a frame has components, an axis moves
#[test]
fn data_of_a_definition_file_hold_what_their_type_allows() {
    let lines = "DEF CHAN INT PARTS[3]\nDEF CHAN STRING[4] NAME=\"PART\"\nDEF NCK FRAME CLAMP[2]\nDEF NCK AXIS WAY=Y";
    let number = |text: &str, name: &str| clean(&with(lines, text)).control.number(name);
    assert_eq!(number("PARTS[1]=2.5 R1=PARTS[1]", "R1"), 3.0);
    assert_eq!(number("PARTS[0]=SET(1,2,3) R1=PARTS[0]+PARTS[1]*10+PARTS[2]*100", "R1"), 321.0);
    assert_eq!(number("PARTS[1]=REP(7) R1=PARTS[0]+PARTS[2]", "R1"), 7.0);
    assert_eq!(number("CLAMP[1]=CTRANS(X,10,Y,20) CLAMP[1,Z,TR]=5 R1=CLAMP[1,X,TR]+CLAMP[1,Z,TR]", "R1"), 15.0);
    assert_eq!(number("CLAMP[1]=CTRANS(X,10)\nR1=CLAMP[0,X,TR]", "R1"), 0.0);
    assert_eq!(clean(&with(lines, "G0 AX[WAY]=7")).end().0[1], 7.0);
    assert_eq!(messages(&with(lines, "NAME=\"LID\"\nMSG(NAME<<PARTS[0])")), ["LID0"]);
    for (text, key) in [
        ("NAME=\"HOUSING\"", "run-text-long"),
        ("PARTS[3]=1", "run-index"),
        ("R1=PARTS[0,0]", "run-index"),
        ("PARTS[0]=\"A\"", "run-type"),
        ("CLAMP[0]=1", "run-type"),
        ("CLAMP[0,X,QQ]=1", "run-unknown-variable"),
    ] {
        assert_eq!(fault(&with(lines, text)), key, "{text}");
    }
}

// oracle: hand: a subprogram sees the datum, changes it, gets it by reference; one of its own hides it
#[test]
fn all_programs_see_the_data_of_a_definition_file() {
    let text = "%_N_UGUD_DEF\nDEF CHAN REAL COUNT=1\nDEF CHAN REAL ROW[3]=SET(1,2,3)\n%_N_MAIN_MPF\nSUB\n\
        BY(COUNT,ROW)\n\
        R1=COUNT R2=ROW[2]\nHIDES\nR3=COUNT\nM30\n%_N_SUB_SPF\nCOUNT=COUNT+1\nM17\n\
        %_N_BY_SPF\nPROC BY(VAR REAL ONE, VAR REAL ALL[])\nONE=ONE*10\nALL[2]=9\nM17\n\
        %_N_HIDES_SPF\nDEF REAL COUNT\nCOUNT=500\nM17\n";
    let control = clean(text).control;
    assert_eq!(["R1", "R2", "R3", "COUNT"].map(|name| control.number(name)), [20.0, 9.0, 20.0, 20.0]);
}

// oracle: hand (the setup's list is that of the definition files; its data are the values)
#[test]
fn a_setup_holds_definitions_and_values() {
    let text = |definitions: &str, data: &str| {
        format!(
            "{{ \"control\": \"sinumerik\", \"definitions\": {definitions}, \"data\": {data}, \
             \"probe\": {{ \"radius\": 3, \"length\": 50 }} }}"
        )
    };
    let lines = r#"["DEF NCK REAL SAFE[2]=SET(1,2) ;first", "DEF CHAN STRING[9] NAME", "REDEF NAME APR 4"]"#;
    let setup = setup_from_json(&text(lines, r#"{ "SAFE[1]": 7.5, "NAME": "LID", "$A_IN[1]": 1 }"#)).unwrap();
    let program = read(Dialect::Sinumerik, b"R1=SAFE[0]+SAFE[1]+$A_IN[1]\nMSG(NAME)\nM30");
    let outcome = probewright_core::run::run(&program, &setup, Limits::default());
    assert_eq!((outcome.stop, outcome.diagnostics), (None, Vec::new()));
    assert_eq!(outcome.control.number("R1"), 9.5);
    let again = setup_from_json(&serde_json::to_string(&setup).unwrap()).unwrap();
    assert_eq!(again, setup);
    for (definitions, data) in [
        (r#"["DEF NCK SAFE"]"#, "{}"),
        (r#"["G0 X1"]"#, "{}"),
        (lines, r#"{ "SAFE[2]": 1 }"#),
        (lines, r#"{ "NAME": 1 }"#),
        (lines, r#"{ "$TC_DP3[1,1]": 1 }"#),
    ] {
        assert!(setup_from_json(&text(definitions, data)).is_err(), "{definitions} {data}");
    }
}

// oracle: hand: what nobody gives is 0 or an empty text, is told once an array, listed each; what is written stays
#[test]
fn values_of_the_machine_are_assumed_and_listed() {
    let text = "FOR R9=1 TO 5\nR1=R1+$A_IN[R9]+$AA_IM[V]\nENDFOR\n$A_DBW[2]=7\nR2=$A_DBW[2]\nR3=$MC_MAX_BLOCKS\n\
        IF $P_PROG[0]==\"\"\nR4=1\nENDIF\n$AC_TIMER[1]=4\nR5=ROUND($AC_TIMER[1])\nM30";
    let outcome = go(text);
    assert_eq!(outcome.stop, None);
    assert_eq!([1, 2, 3, 4, 5].map(|i| outcome.control.number(&format!("R{i}"))), [0.0, 7.0, 0.0, 1.0, 4.0]);
    let names: Vec<_> = outcome.machine_values.iter().map(|one| (&*one.name, one.line)).collect();
    let inputs = [1, 2, 3, 4, 5].map(|i| format!("$A_IN[{i}]"));
    let mut wanted: Vec<_> = inputs.iter().map(|name| (&**name, 2)).collect();
    wanted.extend([("$AA_IM[V]", 2), ("$MC_MAX_BLOCKS", 6), ("$P_PROG[0]", 7)]);
    assert_eq!(names, wanted);
    let told = outcome.diagnostics.iter().filter(|one| one.message.key == "run-machine-value").count();
    assert_eq!(told, 4);
    assert_eq!(key(&strict("R1=$A_IN[1]")), Some("run-system-variable"));
    assert_eq!(fault("R1=$QQ_NOBODY"), "run-system-variable");
}

// oracle: hand: a machine datum that the setup knows by its number is the one that a program calls by its identifier
#[test]
fn machine_data_have_one_value_under_both_names() {
    assert_eq!(number("$MN_MM_TYPE_OF_CUTTING_EDGE=3\nR1=$MN_MM_TYPE_OF_CUTTING_EDGE", "R1"), 3.0);
    assert_eq!(go("$MN_MM_TYPE_OF_CUTTING_EDGE=3").control.number("MD18102"), 3.0);
}

// oracle: hand: each word once, in one finding at the first place
#[test]
fn functions_of_the_machine_are_one_finding() {
    let outcome = go("G0 X1\nM80 M81\nM80\nH5\nM81\nG0 X2");
    let [finding] = &outcome.diagnostics[..] else { panic!("{:?}", outcome.diagnostics) };
    assert_eq!((&*finding.message.key, finding.message.word("word")), ("run-machine-function", Some("M80, M81, H5")));
    assert_eq!(finding.span.unwrap().start, 6);
    let passed: Vec<_> = outcome.passed_over.iter().map(|one| (&*one.word, one.line)).collect();
    assert_eq!(passed, [("M80", 2), ("M81", 2), ("H5", 4)]);
}

// oracle: hand: however it is written, the run goes on and names it once
#[test]
fn a_subprogram_that_is_not_there_is_passed_over_whatever_its_spelling() {
    for call in [
        "L105", "L105 P3", "EXTERN AWAY(REAL)\nAWAY(1)", "AWAY(1)", "AWAY", "PCALL AWAY(1)", "CALL \"AWAY\"",
        "EXTCALL(\"AWAY\")", "AWAY(R1,,\"A\")",
    ] {
        let text = format!("{call}\n{call}\nG0 X3");
        let outcome = go(&text);
        assert_eq!((outcome.stop, outcome.position[0]), (None, 3.0), "{call}");
        assert_eq!(findings(&text), ["run-subprogram"], "{call}");
        let stopped = strict(&text);
        assert_eq!(key(&stopped), Some("run-subprogram"), "{call}");
        assert_eq!(stopped.passed_over, [], "{call}");
    }
}

// oracle: hand: given, else its default, else the run says that it is a parameter; one that is written needs none
#[test]
fn parameters_of_the_program_itself_can_be_given() {
    let text = "PROC PART(REAL DEPTH, INT N=2, STRING[8] NAME)\nR1=DEPTH R2=N\nMSG(NAME)\nM30";
    let given = [("DEPTH", Value::Number(5.5)), ("NAME", Value::Text("LID".into()))];
    let outcome = started(text, Limits::default(), &given);
    assert_eq!((outcome.stop.as_ref(), outcome.control.number("R1"), outcome.control.number("R2")), (None, 5.5, 2.0));
    assert_eq!(key(&started(text, Limits::default(), &given[..1])), Some("run-parameter"));
    assert_eq!(key(&started(text, Limits::default(), &[("DEEP", Value::Number(1.0))])), Some("run-argument-unknown"));
    assert_eq!(key(&started(text, Limits::default(), &[("DEPTH", Value::Text("A".into()))])), Some("run-argument"));
    assert_eq!(number("PROC PART(REAL DEPTH, INT N=2)\nDEPTH=3 N=N+1\nR1=DEPTH+N\nM30", "R1"), 6.0);
}

/// A run of one program of a text.
fn one_of(text: &str, name: &str, arguments: &[(&str, Value)]) -> Outcome {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let arguments = arguments.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    Session::new(program, &setup(), Limits::default()).of_program(name).with_arguments(arguments).complete()
}

// oracle: hand: the second of two main programs calls the first; its parameters are its own
#[test]
fn a_program_of_a_text_is_run_that_is_named() {
    let text =
        "%_N_ONE_MPF\nPROC ONE(INT N=4)\nR1=R1+N\nM17\n%_N_TWO_MPF\nPROC TWO(REAL DEPTH)\nR1=DEPTH\nONE(1)\nM30\n";
    let depth = [("DEPTH", Value::Number(2.5))];
    for name in ["TWO", "two", "_N_TWO_MPF", "TWO.MPF"] {
        let outcome = one_of(text, name, &depth);
        assert_eq!((outcome.stop.as_ref(), outcome.control.number("R1")), (None, 3.5), "{name}");
    }
    let first = one_of(text, "ONE", &[]);
    assert_eq!((first.stop.as_ref(), first.control.number("R1"), first.line), (None, 4.0, Some(4)));
    let none = one_of(text, "THREE", &depth);
    let [found] = &none.diagnostics[..] else { unreachable!("{:?}", none.diagnostics) };
    assert_eq!((key(&none), found.message.word("names")), (Some("run-program-unknown"), Some("ONE, TWO")));
}

// oracle: self (what was read says the same again; nothing falls), hand (two ways to give the same lines)
#[test]
fn any_text_is_a_definition_file() {
    let piece = prop_oneof![
        3 => "DEF (NCK|CHAN) (REAL|INT|BOOL|CHAR|AXIS|FRAME|STRING\\[[0-9]{1,3}\\]) \
            [A-D]{1,2}(\\[[0-9]{1,4}\\])?(=.{0,12})?\n",
        1 => "(DEF|REDEF|LLI|APR|PHU|SET\\(|REP\\(|[\"\\[\\],=%-]|[0-9]{1,9}|[A-Z]{1,3}|\n| ){1,12}",
        1 => "\\PC{0,20}\n",
    ];
    let texts = proptest::collection::vec(piece, 0..20).prop_map(|pieces| pieces.concat());
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = proptest::test_runner::TestRunner::new(config);
    let outcome = runner.run(&texts, |text| {
        let found = definitions(text.as_bytes()).definitions;
        let again = definitions(found.lines.join("\n").as_bytes()).definitions;
        prop_assert_eq!(&again, &found);
        go(&with(&text, "R1=A B[1]=2 C=SET(1,2) D=REP(3)"));
        Ok(())
    });
    outcome.unwrap();
}

// oracle: hand: a program that waits for an input of its machine goes on there once the input changes
#[test]
fn a_loop_that_waits_for_the_machine_is_left() {
    for (text, waits) in [
        ("WHILE $A_IN[10]==0\nG4 F0.2\nENDWHILE\nR1=7", 1),
        ("WHILE ($A_IN[10]==0) OR ($A_IN[9]==1)\nG4 F0.2\nENDWHILE\nR1=7", 1),
        ("BACK:\nIF $A_DBB[4]<>1 GOTOB BACK\nR1=7", 1),
        ("REPEAT\nG4 F1\nUNTIL $A_IN[1]\nREPEAT\nG4 F1\nUNTIL NOT $A_IN[1]\nR1=7", 2),
        ("LOOP\nR2=R2+1\nIF $A_IN[1] GOTOF OUT\nR2=0\nENDLOOP\nOUT: R1=7", 1),
    ] {
        let outcome = started(&format!("{text}\nM30\n"), Limits::default(), &[]);
        assert_eq!((&outcome.stop, outcome.control.number("R1")), (&None, 7.0), "{text}");
        let told = outcome.diagnostics.iter().filter(|found| found.message.key == "run-waits").count();
        assert_eq!(told, waits, "{text}");
    }
}

// oracle: hand
#[test]
fn a_loop_that_waits_for_nothing_of_the_machine_never_ends() {
    for text in [
        "R1=$A_IN[1]\nLOOP\nG4 F1\nENDLOOP",
        "LOOP\nR1=$A_IN[1]\nENDLOOP",
        "WHILE $A_IN[1]<5\nG4 F1\nENDWHILE",
        "LOOP\nWHILE $A_IN[1]==0\nENDWHILE\nWHILE $A_IN[1]==1\nENDWHILE\nENDLOOP",
    ] {
        assert_eq!(key(&started(&format!("{text}\nM30\n"), Limits::default(), &[])), Some("run-endless"), "{text}");
    }
    assert_eq!(key(&strict("WHILE $A_IN[10]==0\nENDWHILE\nM30\n")), Some("run-system-variable"));
}

// oracle: manual (Job planning 03/2006: `$AC_TIMER[n]` counts seconds from what was written; a negative one stands
// still)
#[test]
fn a_clock_runs_while_axes_move_and_wait() {
    let number = |text: &str, name: &str| clean(text).control.number(name);
    let read = |text: &str| number(&format!("$AC_TIMER[1]=10\n{text}\nR1=$AC_TIMER[1]"), "R1");
    for (text, seconds) in [("", 10.0), ("G1 F60 X100", 110.0), ("G4 F5", 15.0), ("S120 M3\nG4 S6", 13.0)] {
        assert!((read(text) - seconds).abs() < 0.05, "{text}: {}", read(text));
    }
    assert_eq!(read("$AC_TIMER[1]=-1\nG4 F5"), -1.0);
    let passes = number("$AC_TIMER[2]=0\nWHILE $AC_TIMER[2]<2\nR6=R6+1\nG4 F0.1\nENDWHILE", "R6");
    assert!((18.0..=20.0).contains(&passes), "{passes}");
}
