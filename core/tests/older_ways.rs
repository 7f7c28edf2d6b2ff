//! Programs of the 840C with whatever leads to a call, run before and after their conversion: the same values arrive at
//! every measuring call, and at whatever else reads an R parameter. What cannot be followed is not converted.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::machine::trace::Step;
use probewright_core::program::change::apply;
use probewright_core::program::r_parameters::{Answers, edits, find};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::programs::programs;
use probewright_core::syntax::read;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;

/// Lines of a program that are followed. A jump back counts R1 first, so that it comes to an end.
const FOLLOWED: [&str; 27] = [
    "R32=80", "R32=81", "R32=82", "R32=R32+1", "R10=5", "R10=R32", "R23=101", "R7=R32", "R32=R7", "/R32=83",
    "/GOTOF A2", "L977", "L977", "L977 P2", "N20 L977", "L100", "L300", "G0 X1", "X=2 Y=R32", "MSG(\"S\"<<R32)",
    "A1: R32=85", "A2:", "A2: L977", "GOTOF A2", "IF R1==0 GOTOF A2", "R1=R1+1\nIF R1<4 GOTOB A1", "M17",
];

/// Lines that lead somewhere in other ways.
const OTHERS: [&str; 24] = [
    "L100 P1",
    "L100 P2",
    "L100 P=R1",
    "L200(R32)",
    "MCALL L977",
    "MCALL L100",
    "MCALL",
    "ENDLABEL:",
    "B1:",
    "A1:",
    "REPEAT A1",
    "REPEAT A1 P=2",
    "REPEAT A1 B1 P=2",
    "REPEATB A1 P=2",
    "REPEATB N20",
    "N20 R32=84",
    "IF R32>81 GOTOF A2 ELSE GOTOF A1",
    "R1=R1+1\nIF R1<4 GOTO A1",
    "R1=R1+1\nIF R1<4 GOTOC A1",
    "R1=R1+1\nIF R1<4 GOTOB \"A\"<<1",
    "R1=R1+1\nIF R1<4 GOTOS",
    "R1=R1+1\nCASE R1 OF 1 GOTOB A1 2 GOTOF A2 DEFAULT GOTOF A2",
    "EXECSTRING(\"R32=90\")",
    "CALL BLOCK A1 TO B1",
];

/// A measuring call: what arrives at it is shown.
fn measured(names: &str) -> String {
    let shown = names.split(' ').map(|name| format!("<<\"/\"<<{name}")).collect::<String>();
    format!("%_N_MESS_SPF\nMSG(\"M\"{shown})\nM17\n")
}

/// What a program shows, with how it ended.
fn shown(text: &str, call: &str, names: &str) -> (Vec<String>, bool) {
    let text = format!("{}{}", text.replace(call, "MESS"), measured(names));
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let limits = Limits { steps: Some(4000), ..Limits::default() };
    let outcome: Outcome = run(&program, &Setup::calibrated(Dialect::Sinumerik, Plane::G17), limits);
    let texts = outcome.trace.entries.others().filter_map(|other| match other.step {
        Step::Message { text, .. } if !text.is_empty() => Some(text.clone()),
        _ => None,
    });
    let ended = outcome.stop.is_none();
    let position = ended.then(|| format!("{:?}", outcome.position));
    (texts.chain(position).collect(), ended)
}

/// The program with the names of today; none: it is refused.
fn converted(text: &str) -> Option<String> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let older = find(&program, &programs(&program), &Answers::new());
    let edits = edits(&program, &older);
    (!edits.is_empty()).then(|| String::from_utf8(apply(text.as_bytes(), &edits)).unwrap())
}

fn lines() -> impl Strategy<Value = String> {
    let line = prop_oneof![
        24 => prop::sample::select(&FOLLOWED[..]),
        1 => prop::sample::select(&OTHERS[..]),
    ];
    let line = line.prop_map(|line| format!("{line}\n"));
    let block = |inner: BoxedStrategy<String>| prop::collection::vec(inner, 1..5).prop_map(|lines| lines.concat());
    line.prop_recursive(3, 16, 5, move |inner| {
        let body = block(inner.boxed()).boxed();
        prop_oneof![
            body.clone(),
            (body.clone(), body.clone()).prop_map(|(one, other)| format!("IF R1==0\n{one}ELSE\n{other}ENDIF\n")),
            body.clone().prop_map(|body| format!("IF R1<2\n{body}ENDIF\n")),
            body.clone().prop_map(|body| format!("R3=0\nWHILE R3<2\nR3=R3+1\n{body}ENDWHILE\n")),
            body.clone().prop_map(|body| format!("R4=0\nREPEAT\nR4=R4+1\n{body}UNTIL R4>1\n")),
            body.prop_map(|body| format!("FOR R5=1 TO 2\n{body}ENDFOR\n")),
        ]
    })
}

fn texts() -> impl Strategy<Value = String> {
    let begin = prop_oneof![Just(""), Just("A1: R11=0\n"), Just("MSG(\"B\"<<R32)\n")];
    let end = prop_oneof![Just(""), Just("A2:\n")];
    let many = || prop::collection::vec(lines(), 0..5).prop_map(|lines| lines.concat());
    (begin, end, many(), many(), many()).prop_map(|(begin, end, main, one, other)| {
        format!(
            "%_N_MAIN_MPF\n{begin}A1: R23=1 R32=79 R10=0\n{main}{end}L977\nM30\n%_N_L100_SPF\nA1: {one}{end}M17\n\
             %_N_L200_SPF\nPROC L200(VAR REAL WERT)\nWERT=WERT+1\nM17\n%_N_L300_SPF\nA1: {other}{end}M17\n"
        )
    })
}

// oracle: self (a program against its conversion)
#[test]
fn the_same_values_arrive_after_the_conversion() {
    let cases = std::env::var("PROBEWRIGHT_CASES").map_or(1, |many| many.parse().unwrap()) * 1500;
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let (done, refused) = (Cell::new(0), Cell::new(0));
    let outcome = runner.run(&texts(), |text| {
        let Some(today) = converted(&text) else {
            refused.set(refused.get() + 1);
            return Ok(());
        };
        done.set(done.get() + 1);
        let (mut before, ended) = shown(&text, "L977", "R23 R32 R10");
        let (mut after, ends) = shown(&today, "CYCLE977", "_MVAR _SETVAL _KNUM");
        if !ended || !ends {
            // it has no end, or comes to a label that is not there: lines that are gone counted as work
            let both = before.len().min(after.len());
            before.truncate(both);
            after.truncate(both);
        }
        prop_assert_eq!(before, after, "{}\n{}", text, today);
        Ok(())
    });
    if let Err(failed) = outcome {
        panic!("{failed}");
    }
    assert!(done.get() > cases / 10 && refused.get() > cases / 20, "{} {}", done.get(), refused.get());
}

/// What a tester found: each was converted, and measured with another value.
// oracle: hand (the second call measures with another value than the text's order gives)
#[test]
fn calls_on_other_ways_are_refused_with_their_line() {
    let values = "R23=1 R32=80\n";
    for (text, at) in [
        (format!("{values}A1: R11=0\nL977\nR32=82\nREPEAT A1 P=1\nM30\n"), "REPEAT A1 P=1"),
        (format!("{values}A1: R32=R32+1\nL977\nB1:\nREPEAT A1 B1 P=2\nM30\n"), "REPEAT A1 B1 P=2"),
        (format!("{values}A1: L977\nR32=82\nREPEATB A1\nM30\n"), "REPEATB A1"),
        (format!("{values}A1: L977\nENDLABEL:\nR32=82\nREPEAT A1\nM30\n"), "REPEAT A1"),
        (format!("{values}N20 L977\nR32=82\nREPEATB N20\nM30\n"), "REPEATB N20"),
        (format!("{values}L100 P2\nM30\n%_N_L100_SPF\nL977\nR32=82\nM17\n"), "P2"),
        (format!("{values}L100 P3\nM30\n%_N_L100_SPF\nR32=R32+1\nL977\nM17\n"), "P3"),
        (format!("{values}MCALL L977\nX1\nR32=90\nX2\nMCALL\nM30\n"), "MCALL L977"),
        (format!("{values}L977\nR32=7\nGOTOS\n"), "GOTOS"),
        (format!("{values}A1: L977\nR32=7\nGOTOB \"A\"<<1\n"), "GOTOB \"A\"<<1"),
        (format!("{values}A1: L977\nR32=7\nGOTOC A1\n"), "GOTOC A1"),
        (format!("{values}A1: L977\nB1: R32=7\nCALL BLOCK A1 TO B1\nM30\n"), "BLOCK A1 TO B1"),
        (format!("{values}L977\nEXECSTRING(\"R32=7\")\nL977\nM30\n"), "EXECSTRING(\"R32=7\")"),
        (format!("{values}L200(R32)\nL977\nM30\n%_N_L200_SPF\nPROC L200(VAR REAL A)\nA=7\nM17\n"), "L200(R32)"),
        (format!("{values}SETINT(1) PRIO=1 L100\nL977\nM30\n%_N_L100_SPF\nR32=7\nM17\n"), "SETINT(1) PRIO=1 L100"),
        (format!("{values}L977\nIF R1<3 GOTOB A ELSE GOTOF B\nA:\nB:\nM30\n"), "GOTOB A ELSE GOTOF B"),
        (format!("{values}WHEN $AA_IM[X]>5 DO R32=7\nL977\nM30\n"), "DO R32=7"),
        (format!("{values}L100\nM30\n%_N_L100_SPF\nL977\nR32=7\nIF R1<3\nL100\nENDIF\nM17\n"), "L100"),
    ] {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let older = find(&program, &programs(&program), &Answers::new());
        let places: Vec<String> = older.ways.iter().map(|place| program.written(*place)).collect();
        assert_eq!(places, [at], "{text}");
        assert_eq!(converted(&text), None, "{text}");
    }
}

// oracle: hand (nothing of an R parameter is in what is repeated, or it goes where the text goes)
#[test]
fn what_has_nothing_to_do_with_r_parameters_keeps_nothing_back() {
    let values = "R23=1 R32=80\n";
    for text in [
        format!("{values}A1: X1\nX2\nB1:\nREPEAT A1 B1 P=2\nL977\nM30\n"),
        format!("{values}A1: X1\nREPEATB A1 P=3\nL977\nM30\n"),
        format!("{values}L50 P3\nL977\nM30\n%_N_L50_SPF\nX1\nX2\nM17\n"),
        format!("{values}MCALL L50\nX5\nMCALL\nL977\nM30\n%_N_L50_SPF\nZ1\nZ2\nM17\n"),
        format!("{values}L977 P2\nM30\n"),
        format!("{values}L100 P1\nM30\n%_N_L100_SPF\nL977\nM17\n"),
        format!("{values}GOTOC A1\nR32=7\nA1: L977\nM30\n"),
        format!("{values}A1: L977\nR1=R1+1\nIF R1<3 GOTO A1\nM30\n"),
        format!("{values}L200(R32)\nL977\nM30\n%_N_L200_SPF\nPROC L200(REAL A)\nX=A\nM17\n"),
        format!("{values}CALL \"L50\"\nL977\nM30\n%_N_L50_SPF\nX1\nM17\n"),
    ] {
        assert!(converted(&text).is_some(), "{text}");
    }
}
