//! What a run cannot read, or does not do: it is named at the end, and nothing is measured with an older value.

use super::{go, number, running};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect::Sinumerik;
use probewright_core::machine::Stop;
use probewright_core::program::change::apply;
use probewright_core::program::findings;
use probewright_core::run::Outcome;
use probewright_core::syntax::read;
use probewright_core::words::Words;
use proptest::prelude::*;

const BEFORE: &str = "G17 G40 G54 G90 T9 D1 M6\nG0 X0 Y0 Z10\n_MVAR=0 _SETVAL=0 _MA=3 _KNUM=0 _PRNUM=1 _FA=20 _TSA=9\n";

fn passed(outcome: &Outcome) -> Vec<(&str, u32)> {
    let passed = outcome.passed_over.iter();
    passed.map(|one| (one.word.as_str(), one.line)).collect()
}

fn stop(outcome: &Outcome) -> Option<&str> {
    match &outcome.stop {
        Some(Stop::Fault(message)) => Some(&*message.key),
        _ => None,
    }
}

// oracle: hand (where an unknown function leaves the axes nobody knows)
#[test]
fn the_axes_of_an_unknown_function_stay() {
    let outcome = go("G0 X5 Y5 Z40\nG987 X1 Y2 Z3\nM30");
    super::near(outcome.end().0, [5.0, 5.0, 40.0]);
    assert_eq!(stop(&measured("G987 X0")), Some("run-unread-value"));
    assert_eq!(measured("G987 X0\nG0 X0").stop, None);
}

/// Measures the upper face of a block behind these lines.
fn measured(lines: &str) -> Outcome {
    let text = format!("{BEFORE}{lines}\nCYCLE978\nM30");
    running::go_on(&super::block_setup(), &text)
}

// oracle: hand (a value that could not be read is not known; what is written anew is)
#[test]
fn no_call_measures_with_a_value_that_could_not_be_read() {
    assert_eq!(measured("").stop, None);
    for lines in [
        "_FA=1e-9",
        "_FA=2,5",
        "_TSA=1e0",
        "_FA = (2",
        "R1=1e1\n_FA=R1",
        "R [1]=1e1\n_FA=2+R[1]",
        "DEF REAL LEN=1e1\n_FA=LEN",
        "_CHBIT[10]=1e0",
        "X1e1",
        "G1 F100 Z1,5",
        "D1,5",
        "X0+5",
        "_FA=20%",
        "G54\u{a0}G18",
        "G91.5.5",
        "_MA=3\u{2212}1",
        "DIAMONA[X",
        "DIAMONB[X]\nX0",
        "DIAMONA[Y]\nY0 X0",
        "DIAMON\nDIAMCHANA[Y]\nX0",
        "DIAMONA[Y]\nDIAMON\nDIAMCHAN\nX0",
        "DIAMONA[X\nDIAMOF\nX0",
    ] {
        let outcome = measured(lines);
        assert_eq!(stop(&outcome), Some("run-unread-value"), "{lines}");
        assert_eq!(outcome.passed_over.len(), 1, "{lines}");
        assert!(outcome.written().keys().all(|name| !name.starts_with("_OVR")));
    }
    for lines in [
        "_FA=1e-9\n_FA=20", "_SZA=1e0", "R1=1e1", "X1e1\nX0 D1", "R1=1e1\nR[1]=2\n_FA=R1", "F1e3", "G17,5\nG17",
        "G54\u{200b}\nG54", "DIAMONA[X\nDIAMOFA[X]", "DIAMONA[X\nDIAMCHAN", "DIAMONA[Y]\nDIAMOFA[Y]",
        "DIAMONA[Y]\nDIAMCHAN", "DIAMONA[U]",
    ] {
        let outcome = measured(lines);
        assert_eq!(outcome.stop, None, "{lines} {:?}", outcome.diagnostics);
        assert_eq!(outcome.passed_over.len(), 1, "{lines}");
    }
}

// oracle: hand (an unread condition is neither true nor false)
#[test]
fn no_way_is_gone_that_a_word_decides_which_could_not_be_read() {
    for text in [
        "IF R1==1e-9 GOTOF OUT\nR2=1\nOUT: M30",
        "IF R1==1e-9\nR2=1\nENDIF\nM30",
        "WHILE R1<1e1\nR1=R1+1\nENDWHILE\nM30",
        "FOR R1=1 TO 1e1\nR2=1\nENDFOR\nM30",
        "CASE R1 OF 1e0 GOTOF OUT DEFAULT GOTOF OUT\nOUT: M30",
    ] {
        assert_eq!(stop(&go(text)), Some("run-unread-way"), "{text}");
    }
}

// oracle: hand (each sort of word that a run goes on without)
#[test]
fn what_is_passed_over_is_named_with_its_line() {
    let text = "TCARR=1\nM77\nH3\nG331 Z-5 K1\nG987\nWHEN $AA_IW[Z]>10 DO M8\nL77\nNAME(1)\nCYCLE83(1)\nWRTPR(\"A\")\n\
        $A_OUT[1]=1\nR1=1e1\nG0 X5\nL77\nM30";
    let outcome = go(text);
    let expected = [
        ("TCARR", 1),
        ("M77", 2),
        ("H3", 3),
        ("G331", 4),
        ("G987", 5),
        ("WHEN", 6),
        ("L77", 7),
        ("NAME", 8),
        ("CYCLE83", 9),
        ("WRTPR", 10),
        ("$A_OUT[1]", 11),
        ("R1=1e1", 12),
    ];
    assert_eq!(passed(&outcome), expected);
    assert!(outcome.finished());
    let said = Words::english().text(&outcome.ending(|line| (None, line)));
    for (word, line) in expected {
        assert!(said.contains(&format!("{word} ({line})")), "{said}");
    }
    let clean = go("G0 X5\nM30");
    assert_eq!(&*clean.ending(|line| (None, line)).key, "run-ended");
    assert_eq!(&*go("R1=1/0").ending(|line| (None, line)).key, "run-ended-early");
}

// oracle: hand (the spelling of a call tells nothing about what is called)
#[test]
fn each_way_to_call_a_program_that_is_not_here_is_told_alike() {
    for (lines, name) in [
        ("L105", "L105"),
        ("L105 P2", "L105"),
        ("NAME", "NAME"),
        ("name(5)", "NAME"),
        ("EXTERN NAME(INT)\nNAME(5)", "NAME"),
        ("PCALL NAME(1)", "NAME"),
        ("PCALL /_N_SPF_DIR/NAME", "NAME"),
        ("CALL \"NAME\"", "NAME"),
        ("EXTCALL \"NAME.SPF\"", "NAME"),
        ("EXTCALL(\"_N_NAME_SPF\")", "NAME"),
        ("MCALL NAME\nX1\nMCALL", "NAME"),
        ("CYCLE987", "CYCLE987"),
    ] {
        let text = format!("G0 X0\n{lines}\nM30");
        let outcome = go(&text);
        let checked = findings(&read(Sinumerik, text.as_bytes()));
        let told = [&checked, &outcome.diagnostics].map(|found| {
            let told = found.iter().map(|one| {
                let line = text[..one.span.unwrap().start as usize].matches('\n').count();
                (one.severity, one.code, one.message.clone(), one.hint.clone(), line)
            });
            told.collect::<Vec<_>>()
        });
        assert_eq!(told[0].len(), 1, "{text}: {:?}", told[0]);
        let [checked, ran] = told.map(|mut told| told.remove(0));
        if !lines.starts_with("MCALL") {
            assert_eq!(checked, ran, "{text}"); // it is carried out behind a motion
        }
        assert_eq!((ran.0, ran.2.word("word")), (Severity::Note, Some(name)));
        assert_eq!(outcome.passed_over.len(), 1, "{text}");
        assert_eq!(outcome.passed_over[0].word, name);
        assert_eq!(outcome.stop, None, "{text}");
    }
}

// oracle: hand (a call finds a program by its file)
#[test]
fn the_name_of_the_file_counts() {
    let behind = |call: &str| format!("{call}\nM30\n%_N_FILE_SPF\nPROC OTHER\nR1=R1+1\nRET");
    let outcome = go(&behind("FILE\nOTHER"));
    assert_eq!(passed(&outcome), [("OTHER", 2)]);
    assert_eq!(outcome.control.number("R1"), 1.0);
    // Without a header its PROC is all that is known of a program.
    assert_eq!(number("OTHER\nM30\nPROC OTHER\nR1=5\nRET", "R1"), 5.0);
}

// oracle: hand
#[test]
fn a_parameter_of_the_program_that_is_run_is_told_as_one() {
    for use_it in ["R1=DEPTH", "DEPTH=DEPTH+5", "G0 Z=DEPTH"] {
        let outcome = go(&format!("PROC BORE(INT N=3, REAL DEPTH)\n{use_it}\nM30"));
        let said = Words::english().text(&outcome.diagnostics[0].message);
        let wanted = "DEPTH is a parameter of PROC BORE and has no value here.";
        assert_eq!(said, wanted, "{use_it}");
    }
    assert_eq!(number("PROC BORE(INT N=3, REAL DEPTH)\nR1=N\nM30", "R1"), 3.0);
    // Its caller gives it one.
    let called = "%_N_A_MPF\nBORE(1,2)\nM30\n%_N_BORE_SPF\nPROC BORE(INT N, REAL DEPTH)\nR1=DEPTH\nRET";
    assert_eq!(number(called, "R1"), 2.0);
}

// oracle: hand
#[test]
fn a_tool_that_is_not_there_is_told_as_that_whatever_is_asked_of_it() {
    let said = |text: &str| {
        let outcome = go(text);
        assert!(outcome.diagnostics[0].hint.is_some(), "{text}");
        Words::english().text(&outcome.diagnostics[0].message)
    };
    for text in [
        "R1=$TC_DP1[5,1]", "R1=$TC_DP6[5,1]", "R1=$TC_DP15[5,2]", "DEF STRING[20] N=$TC_TP2[5]", "T5 M6", "T5 D1 M6",
        "T=\"5\" M6",
    ] {
        assert_eq!(said(text), "Tool 5 does not exist.", "{text}");
    }
    assert_eq!(said("R1=$TC_DP6[9,7]"), "Tool 9 has no D7.");
    assert_eq!(said("T9 D7 M6"), "Tool 9 has no D7.");
}

// oracle: hand (blanks, a Ctrl-Z)
#[test]
fn blanks_before_an_index_and_the_end_of_a_file() {
    assert_eq!(number("R [1] = 5\nR2=R\t[1]+1\nM30", "R2"), 6.0);
    assert_eq!(number("DEF REAL A [3]\nA [1]=4\nR1=A [1]\nM30", "R1"), 4.0);
    assert_eq!(number("_SETV [2]=7\nM30", "_SETV[2]"), 7.0);
    assert_eq!(number("R1=2\nM30\n\u{1a}\u{1a}\r\n", "R1"), 2.0);
    let text = "R1=2\n\u{1a}R1=3";
    assert_eq!(go(text).control.number("R1"), 2.0);
    let found = findings(&read(Sinumerik, text.as_bytes()));
    assert!(matches!(&found[..], [one] if one.severity == Severity::Note));
}

proptest! {
    // oracle: peer (Rust's own reading of the number)
    #[test]
    fn numbers_of_other_languages_are_told_with_their_cure(
        whole in 0..1_000_000_u32, power in -20..20_i32, plus: bool, letter in prop::sample::select(vec!['e', 'E']),
        before in prop::sample::select(vec!["R1=", "R1=+", "R1 = 0+", "R1=ABS("]),
    ) {
        let plus = if plus && power >= 0 { "+" } else { "" };
        let foreign = format!("{}.{}{letter}{plus}{power}", whole / 1000, whole % 1000);
        let close = if before.ends_with('(') { ")" } else { "" };
        let text = format!("{before}{foreign}{close}\nM30");
        let found = findings(&read(Sinumerik, text.as_bytes()));
        prop_assert_eq!(found.len(), 1, "{}", &text);
        let mended = apply(text.as_bytes(), &found[0].cure.as_ref().unwrap().edits);
        let outcome = go(&String::from_utf8(mended).unwrap());
        prop_assert_eq!(outcome.control.number("R1"), foreign.parse::<f64>().unwrap());
    }
}
