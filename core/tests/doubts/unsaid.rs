//! What nothing in the text says, and its remedy.

use super::{COMPENSATION_LATER, DIAMETER, HOLE, NO_TOOL, OPEN, PLANE, RADIUS, called, found, tells};
use probewright_core::control::{Control, Edge, delivery};
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::program::change::apply;
use probewright_core::program::findings_on;
use probewright_core::syntax::read;

/// The program fixed by the remedy of the first finding with this code.
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
    assert_eq!(mended(&text, &control, OPEN), text.replace("_MVAR", "G40 G17\n_MVAR"));
    let text = "G18 DIAMOF T8 D1\nG0 X60\n_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2 _MA=2\nCYCLE974\nM30\n";
    let around = text.replace("_MVAR", "DIAMON\n_MVAR").replace("\nM30", "\nDIAMOF\nM30");
    assert_eq!(mended(text, &control, RADIUS), around);
    // The tool table has one probe.
    for (number, kind) in [(3, 120), (9, 710)] {
        let edge = Edge { kind, ..Edge::default() };
        control.tools.entry(number).or_default().edges.insert(1, edge);
    }
    let text = format!("G17 G40 G54\nG0 X0\n{HOLE}M30\n");
    assert_eq!(mended(&text, &control, NO_TOOL), text.replace("_MVAR", "T9 D1\n_MVAR"));
    let changes = text.replace("M30", "T3 D1 M6\nM30");
    assert_eq!(mended(&changes, &control, NO_TOOL), changes.replace("_MVAR", "T9 D1 M6\n_MVAR"));
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
    assert!(!tells(&main("G17 G40 T9 D1", "G41 G1 X10"), COMPENSATION_LATER));
    assert!(!tells(&main("G17 G54 T9 D1", "G41 G1 X10\nG40 X0"), COMPENSATION_LATER));
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
    assert!(!tells(HOLE, OPEN) && !tells(HOLE, NO_TOOL), "a piece of a program");
}

// oracle: manual B:10975 (diameters with DIAMON, else radii)
#[test]
fn a_setpoint_that_counts_as_a_radius_is_told_as_a_diameter() {
    let turned = |mode: &str, axis: i64| {
        let call = "_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2";
        format!("G18 G54 {mode} T8 D1\nG0 X60\n{call} _MA={axis}\nCYCLE974\nM30\n")
    };
    assert!(tells(&turned("DIAMOF", 2), RADIUS));
    assert!(!tells(&turned("DIAMOF", 1), RADIUS), "along Z there is no diameter");
    assert!(!tells(&turned("DIAMON", 2), RADIUS));
    assert!(!tells(&turned("", 2), RADIUS) && tells(&turned("", 2), DIAMETER));
    // The plane of the caller decides which axis is transverse.
    let call = "_MVAR=100 _SETVAL=55 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2 _MA=2\nCYCLE974";
    assert!(tells(&called("G18 G40 DIAMOF T8 D1\nL5\nG17", call), RADIUS));
}
