//! G functions of NCT that a run does not drive: none is an error, and what they leave unknown no measurement uses,
//! neither in a run nor in what check says.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "running/nct_block.rs"]
mod nct_block;

use nct_block::over_a_block;
use probewright_core::diagnostic::{Code, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Stop;
use probewright_core::program::findings;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;

fn go(text: &str) -> Outcome {
    run(&read(Dialect::Nct, text.as_bytes()), &over_a_block(), Limits::default())
}

/// The key of the fault that ends a run.
fn stopped(outcome: &Outcome) -> Option<&str> {
    match &outcome.stop {
        Some(Stop::Fault(message)) => Some(&message.key),
        _ => None,
    }
}

/// The words at which check says that it is not known where a call measures, with their lines.
fn told(text: &str) -> Vec<(String, f64)> {
    let found = findings(&read(Dialect::Nct, text.as_bytes()));
    let of_places = found.iter().filter(|one| one.code == Code::Own(246));
    let words = of_places.map(|one| {
        assert_eq!(one.severity, Severity::Warning);
        (one.message.word("word").unwrap().to_owned(), one.message.args.iter().find_map(line).unwrap())
    });
    words.collect()
}

fn line((name, arg): &(&'static str, probewright_core::message::Arg)) -> Option<f64> {
    match arg {
        probewright_core::message::Arg::Number(line) if *name == "line" => Some(*line),
        _ => None,
    }
}

/// All G words of a milling control with this language.
const WORDS: [&str; 96] = [
    "G0", "G1", "G2", "G3", "G4", "G5.1", "G7.1", "G8", "G9", "G10", "G11", "G12.1", "G13.1", "G15", "G16", "G17",
    "G18", "G19", "G20", "G21", "G22", "G23", "G27", "G28", "G29", "G30", "G31", "G33", "G37", "G38", "G39", "G40",
    "G41", "G42", "G43", "G44", "G45", "G46", "G47", "G48", "G49", "G50", "G50.1", "G51", "G51.1", "G52", "G53", "G54",
    "G54.1", "G55", "G56", "G57", "G58", "G59", "G60", "G61", "G62", "G63", "G64", "G66", "G66.1", "G67", "G68", "G69",
    "G73", "G74", "G76", "G80", "G81", "G82", "G83", "G84", "G84.2", "G84.3", "G85", "G86", "G87", "G88", "G89", "G90",
    "G91", "G92", "G93", "G94", "G95", "G96", "G97", "G98", "G99", "G05.1", "G010", "G028", "G068", "G081", "G00",
    "G03",
];

// oracle: hand (each word of the language is known, and what is passed over is no error)
#[test]
fn every_g_word_is_known() {
    for word in WORDS {
        let text = format!("{word}\nM30");
        let outcome = go(&text);
        let errors: Vec<_> = outcome.diagnostics.iter().filter(|one| one.severity != Severity::Note).collect();
        assert!(errors.is_empty() && outcome.stop.is_none(), "{text}: {errors:?} {:?}", outcome.stop);
        assert_eq!(findings(&read(Dialect::Nct, text.as_bytes())), [], "{text}");
    }
    // oracle: self: one note lists them
    let outcome = go("G28 X0\nG33 Z1 F1\nG81 Z-5 R2\nG80\nG28 Y0\nM30");
    let notes: Vec<_> = outcome.diagnostics.iter().map(|one| (&*one.message.key, one.message.word("word"))).collect();
    assert_eq!(notes, [("run-passed", Some("G28, G33, G81"))]);
}

const MEASURES: &str = "G106 Z0\n";

/// What stands before a measurement, and the word that check names with its line; none: it is known where it measures.
const BEFORE: [(&str, Option<(&str, f64)>); 43] = [
    ("G68 X0 Y0 R90", Some(("G68", 3.0))),
    ("G68 X0 Y0 R90\nG0 X1 Y1\nG0 Z20", Some(("G68", 3.0))),
    ("G68 X0 Y0 R90\nG69", None),
    ("G68 X0 Y0 R90\nG0 Z20\nG69", None),
    ("G68 X0 Y0 R90\nG0 X1\nG69", Some(("X1", 4.0))),
    ("G68 X0 Y0 R90\nG0 X1\nG69\nG0 X0", Some(("X1", 4.0))),
    ("G68 X0 Y0 R90\nG0 X1\nG69\nG0 X0 Y0", None),
    ("G10 L2 P1 X12", Some(("G10", 3.0))),
    ("G10 L2 P1 X12\nG54\nG0 X0 Y0 Z20", Some(("G10", 3.0))),
    ("G52 X2 Y0", Some(("G52", 3.0))),
    ("G52 X2 Y0\nG52 X0 Y0", None),
    ("G52 X2 Y0\nG0 Y1\nG52 X0 Y0", None),
    ("G52 X2 Y1\nG52 X0", Some(("G52", 3.0))),
    ("G92 X90", Some(("G92", 3.0))),
    ("G92 S2000", None),
    ("G51 X0 Y0 I0.5 J0.5", Some(("G51", 3.0))),
    ("G51 X0 Y0 I0.5 J0.5\nG50", None),
    ("G51.1 X0 Y0", Some(("G51.1", 3.0))),
    ("G51.1 X0 Y0\nG50.1 X0", Some(("G51.1", 3.0))),
    ("G51.1 X0 Y0\nG50.1 X0 Y0", None),
    ("G51.1 X0 Y0\nG50.1", None),
    ("G54.1 P1", Some(("G54.1", 3.0))),
    ("G54.1 P1\nG0 X0 Y0\nG54", Some(("X0", 4.0))),
    ("G54.1 P1\nG54\nG0 X0 Y0", None),
    ("G16", Some(("G16", 3.0))),
    ("G16\nG15", None),
    ("G44 H1", Some(("G44", 3.0))),
    ("G44 H1\nG43 H98", None),
    ("G28 Z0", Some(("Z0", 3.0))),
    ("G91 G28 Z0\nG90", Some(("Z0", 3.0))),
    ("G91 G28 Z0\nG90 G0 X0 Y0\nG43 Z20 H98", None),
    ("G91 G28 Z0\nG0 Z5\nG90", Some(("Z0", 3.0))),
    ("G28 X0 Y0 Z0\nG0 X0 Y0", Some(("Z0", 3.0))),
    ("G68 X0 Y0 R90\nG53 G0 Z60\nG69", None),
    ("G81 X5 Y5 Z-5 R2 F100\nG80", Some(("X5", 3.0))),
    ("G81 X5 Y5 Z-5 R2 F100\nX9\nG80\nG0 X0 Y0\nZ20", None),
    ("G81 X5 Y5 Z-5 R2 F100\nG0 X0 Y0 Z20", None),
    ("G81 X5 Y5 Z-5 R2 F100\nG80\nX0 Y0", Some(("Z-5", 3.0))),
    ("G98 G82 X5 Y5 Z-5 R2 P1.5 F100\nG80\nG0 X0 Y0 Z20", None),
    ("G22 X100 Y100 Z50 I-100 J-100 K-50\nG23", None),
    ("G4 P1.5\nG62\nG63\nG64\nG93\nG94", None),
    ("M98 P2\nM30\nO2\nG68 X0 Y0 R90\nM99", None),
    ("#1=1\nIF[#1 EQ 1]GOTO 5\nG68 X0 Y0 R9\nN5 G0 X0", None),
];

// oracle: hand: what is not driven leaves a place unknown until something says it anew; there a measurement stops
// (PW359), and check says so where it is certain
#[test]
fn nothing_is_measured_where_the_place_is_not_known() {
    for (before, word) in BEFORE {
        let text = format!("M19\nT98 G43 H98\n{before}\n{MEASURES}M30");
        let outcome = go(&text);
        let stop = word.is_some().then_some("run-unread-value");
        assert_eq!(stopped(&outcome), stop, "{text}: {:?} {:?}", outcome.stop, outcome.diagnostics);
        assert!(word.is_some() || outcome.stop.is_none(), "{text}: {:?}", outcome.stop);
        let found: Vec<_> = word.into_iter().map(|(word, line)| (word.to_owned(), line)).collect();
        // what else is unknown is told by a word of its own
        assert_eq!(told(&text).first(), found.first(), "{text}");
    }
}

// oracle: hand: a program that the text calls leaves and needs what it does in place of its call
#[test]
fn check_follows_into_called_programs() {
    let text = "M19\nT98 G43 H98\nG68 X0 Y0 R90\nM98 P2\nG69\nM98 P2\nM30\nO2\nG106 Z0\nM99";
    assert_eq!(told(text), [("G68".to_owned(), 3.0)]);
    assert_eq!(stopped(&go(text)), Some("run-unread-value"));
    let text = "M19\nT98 G43 H98\nM98 P2\nG106 Z0\nM30\nO2\nG68 X0 Y0 R90\nM99";
    assert_eq!(told(text), [("G68".to_owned(), 7.0)]);
    assert_eq!(stopped(&go(text)), Some("run-unread-value"));
}

// oracle: hand: positions are read where they are known only
#[test]
fn no_position_is_read_where_it_is_not_known() {
    for (before, variable, known) in [
        ("G28 Z0", "#5003", false),
        ("G28 Z0", "#5023", false),
        ("G28 Z0", "#5001", true),
        ("G28 Z0\nG90 Z20", "#5003", true),
        ("G68 X0 Y0 R90", "#5001", false),
        ("G68 X0 Y0 R90", "#5021", true),
        ("G68 X0 Y0 R90\nX1", "#5022", false),
        ("G10 L2 P1 X12", "#5221", false),
        ("G10 L2 P1 X12", "#5022", true),
        ("G54.1 P1", "#4014", false),
        ("G81 X1 Z-5 R2\nG80", "#5001", false),
        ("G81 X1 Z-5 R2\nG80", "#5002", true),
    ] {
        let text = format!("{before}\n#600={variable}\nM30");
        assert_eq!(stopped(&go(&text)).is_none(), known, "{text}");
    }
}

// oracle: hand: the axes do not move where they are not driven to, and nothing is hit from where they may not stand
#[test]
fn what_is_not_driven_moves_nothing() {
    for (text, expected) in [
        ("G0 X7\nG28 X0\nM30", 7.0),
        ("G0 X7\nG68 X0 Y0 R90\nG0 X9\nM30", 7.0),
        ("G0 X7\nG68 X0 Y0 R90\nG0 X9\nG69\nG0 X8 Y0\nM30", 8.0),
        ("G0 X7\nG52 Y3\nG0 X9\nM30", 9.0),
        ("G0 X7\nG81 X9 Z-5 R2 F100\nX11\nM30", 7.0),
        ("G0 X7\nG22 X100 I-100\nM30", 7.0),
        ("G0 X7\nG4 X2\nM30", 7.0),
        // where the retracted tool stands nobody knows: no crash is told on the way
        ("G0 X50\nZ-10\nG91 G28 Z0\nG90 G0 X-50\nG0 Z20\nM30", -50.0),
    ] {
        let outcome = go(text);
        assert_eq!(outcome.stop, None, "{text}");
        let setup = over_a_block();
        let at = setup.control.to_workpiece(Mcs(outcome.position.0));
        assert!((at[0] - expected).abs() < 1e-9, "{text}: {at:?}");
    }
}

// oracle: hand: after each block that moves, up to G67, in its own program, with arguments anew each time
#[test]
fn a_modal_macro_is_called_after_each_motion() {
    for (text, expected) in [
        ("G66 P4 A10\nG0 X1\nG0 Y2\n#1=3\nG67\nG0 Z21", 20.0),
        ("G66 P4 A10\nX1\nX2 Y3\nM30", 20.0),
        ("G66 P4 A10 L2\nX1\nG67\nX2", 20.0),
        ("G66 P4 A10\nM98 P5\nG67", 0.0),
        ("G66 P4 A10\nG66 P4 A1\nX1\nG67", 1.0),
        ("G66 P4 A10\nG4 P1\nF100\nG67", 0.0),
        ("G66 P4 A10\nG28 Z0\nG67", 10.0),
    ] {
        let text = format!("#600=0\n{text}\nM30\nO4\n#600=#600+#1\nG0 X3\nM99\nO5\nG0 X9\nM99");
        let outcome = go(&text);
        assert_eq!(outcome.stop, None, "{text}");
        assert_eq!(outcome.control.number("#600"), expected, "{text}: {:?}", outcome.diagnostics);
        let outside = findings(&read(Dialect::Nct, text.as_bytes()));
        assert_eq!(outside, [], "{text}");
    }
    // G106 by its program number measures the upper face, 0, at two places
    let outcome = go("M19\nT98 G43 H98\nG66 P9015 Z0\nG0 X5\nG0 X9\nG67\nX0\nM30");
    assert_eq!((outcome.stop, outcome.called.len()), (None, 2));
}
