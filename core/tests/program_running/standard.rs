//! Standard cycles in a run: holes, patterns of positions, and what is left out.

use super::{clean, go, near, number, only_note};
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::run::Outcome;
use proptest::prelude::*;

/// Ends of the motions of a run, machine coordinates.
fn ends(outcome: &Outcome) -> Vec<[f64; 3]> {
    let motions = outcome.trace.entries.iter().filter_map(|entry| match entry.step {
        Step::Motion { to, .. } => Some(to.0),
        _ => None,
    });
    motions.collect()
}

/// Heights behind the first block, with how they are reached.
fn heights(call: &str) -> Vec<(MotionKind, f64)> {
    let outcome = clean(&format!("G17 G90 G0 X5 Y6 Z50 S100 F200\n{call}\nM30"));
    let entries = outcome.trace.entries.iter().skip(1).filter_map(|entry| match entry.step {
        Step::Motion { kind, to, .. } => {
            near([to[0], to[1], 0.0], [5.0, 6.0, 0.0]);
            Some((kind, to[2]))
        }
        _ => None,
    });
    entries.collect()
}

// oracle: hand, from memory of the field, not held against the guide (rapid traverse to the reference plane less the
// safety clearance, feed to the depth, back to the retraction plane)
#[test]
fn a_hole_is_drilled_between_its_planes() {
    use MotionKind::{Positioning as Feed, Rapid};
    let plain = [(Rapid, 2.0), (Feed, -20.0), (Rapid, 40.0)];
    for call in [
        "CYCLE81(40,0,2,-20)",
        "CYCLE81(40,0,-2,,20)",
        "CYCLE81(40,0,2,-99,20)",
        "CYCLE82(40,0,2,-20,,1)",
        "CYCLE86(40,0,2,-20,,1,3,0,0,0,45)",
        "CYCLE87(40,0,2,-20,,3)",
        "CYCLE88(40,0,2,,20,0,4)",
        "MCALL CYCLE81(40,0,2,-20)\nX5\nMCALL",
        // newer editions have more arguments
        "CYCLE81(40,0,2,,20,0.6,0,1,11)",
        "CYCLE83(40,0,2,-20,,-20,,0,0,0,1,1)",
    ] {
        let mut found = heights(call);
        found.retain(|(_, height)| *height != 50.0);
        assert_eq!(found, plain, "{call}");
    }
    let reamed = [(Rapid, 2.0), (Feed, -20.0), (Feed, 2.0), (Rapid, 40.0)];
    for call in [
        "CYCLE85(40,0,2,-20,,0,100,300)",
        "CYCLE89(40,0,2,-20)",
        "CYCLE84(40,0,2,-20,,0,5,,1,0,300,300)",
        "CYCLE84(40,0,2,-20,,0,5,8,,0,300,300)",
        "CYCLE840(40,0,2,-20,,0,4,3,1,,1)",
    ] {
        assert_eq!(heights(call), reamed, "{call}");
    }
    // chip breaking by 1 mm; swarf removal with 0.6 mm before the last depth; 10, then less by 4, at least 4
    let broken =
        [(Rapid, 2.0), (Feed, -10.0), (Feed, -9.0), (Feed, -16.0), (Feed, -15.0), (Feed, -20.0), (Rapid, 40.0)];
    assert_eq!(heights("CYCLE83(40,0,2,-20,,-10,,4,0,0,1,0)"), broken);
    let removed = heights("CYCLE83(40,0,2,-20,,,10,4,0,0,1,1)");
    assert_eq!(removed[2..4], [(Rapid, 2.0), (Rapid, -9.4)]);
    // what is left of less than two smallest steps is halved
    let depths: Vec<_> = heights("CYCLE83(40,0,2,-23,,-10,,5,0,0,1,0)").iter().map(|(_, z)| *z).collect();
    assert_eq!(depths, [2.0, -10.0, -9.0, -15.0, -14.0, -19.0, -18.0, -23.0, 40.0]);
}

// oracle: hand (lead 1.25 mm of M8 at 300 a minute; a feed of the call)
#[test]
fn feeds_of_threads_and_reamers() {
    let feeds = |call: &str| {
        let outcome = clean(&format!("G17 G90 G0 Z50 F200\n{call}\nM30"));
        let steps = outcome.trace.entries.iter();
        let feeds =
            steps.filter_map(|entry| if let Step::Motion { feed, .. } = entry.step { Some(feed) } else { None });
        feeds.filter(|feed| *feed > 0.0).collect::<Vec<_>>()
    };
    assert_eq!(feeds("G95\nCYCLE84(40,0,2,-20,,0,5,8,,0,300,300)"), [375.0; 2]);
    assert_eq!(feeds("CYCLE84(40,0,2,-20,,0,5,,20,0,100,100,3,2)"), [127.0; 2]);
    assert_eq!(feeds("CYCLE85(40,0,2,-20,,0,100,300)"), [100.0, 300.0]);
    assert_eq!(feeds("CYCLE85(40,0,2,-20)"), [200.0; 2]);
}

/// A row of three, a circle of four and a grid of four with the same points by hand.
const PATTERNS: [(&str, &str); 4] = [
    ("HOLES1(10*U,20*U,90,5*U,8*U,3)", "A=10*U B=25*U\nA=10*U B=33*U\nA=10*U B=41*U"),
    ("HOLES2(30*U,-20*U,15*U,0,90,4)", "A=45*U B=-20*U\nA=30*U B=-5*U\nA=15*U B=-20*U\nA=30*U B=-35*U"),
    ("HOLES2(30*U,-20*U,15*U,90,0,2)", "A=30*U B=-5*U\nA=30*U B=-35*U"),
    ("CYCLE801(5*U,5*U,0,10*U,7*U,2,2)", "A=5*U B=5*U\nA=15*U B=5*U\nA=15*U B=12*U\nA=5*U B=12*U"),
];

/// Abscissa, ordinate and what makes lengths of a program millimetres.
fn written(text: &str, [a, o]: [&str; 2], unit: &str) -> String {
    text.replace("A=", &format!("{a}=")).replace("B=", &format!("{o}=")).replace('U', unit)
}

// oracle: peer (the points written by hand, in each plane, in inch, turned and mirrored)
#[test]
fn a_pattern_is_its_points_written_by_hand() {
    for (plane, axes, up) in [("G17", ["X", "Y"], "Z"), ("G18", ["Z", "X"], "Y"), ("G19", ["Y", "Z"], "X")] {
        for (units, unit) in [("G71", "1"), ("G70", "(1/25.4)"), ("G700", "(1/25.4)")] {
            for frame in ["", "MIRROR X0", "ROT Z30", "TRANS X7 Y8 Z9", "DIAMON"] {
                if frame == "DIAMON" && up == "X" {
                    continue; // the depth is as it is written
                }
                for (pattern, points) in PATTERNS {
                    let ask = |body: &str| {
                        let call = "MCALL CYCLE82(40*U,0,2*U,-15*U)";
                        let text = format!(
                            "{plane} {units} G90 G0 {up}=60*U F500\n{frame}\nG0 A=0 B=0\n{call}\n{body}\nMCALL\nM30"
                        );
                        ends(&clean(&written(&text, axes, unit)))
                    };
                    let off = if frame == "DIAMON" { "DIAMOF" } else { "" };
                    let by_cycle = ask(pattern);
                    // written by hand a diameter would be twice as large
                    let by_hand = ask(&format!("{off}\n{points}"));
                    assert_eq!(by_cycle.len(), by_hand.len(), "{pattern} {plane} {units} {frame}");
                    by_cycle.iter().zip(&by_hand).for_each(|(one, other)| near(*one, *other));
                }
            }
        }
    }
}

// oracle: hand (a row begins at the end where the tool stands; the last position is where it ends)
#[test]
fn a_row_begins_at_its_nearer_end() {
    let end = |from: &str| clean(&format!("G17 G0 {from} Z50\nHOLES1(0,0,0,10,20,3)\nM30")).end().0;
    near(end("X0 Y0"), [50.0, 0.0, 50.0]);
    near(end("X99 Y0"), [10.0, 0.0, 50.0]);
}

// oracle: hand (the program of the modal call runs at each position, then the next block)
#[test]
fn a_modal_program_runs_at_each_position() {
    let sub = "M30\nPROC COUNT\nR1=R1+1\nR[R1+1]=$AA_IM[X]\nM17";
    for (pattern, count) in [("HOLES2(0,0,10,0,0,6)", 6.0), ("HOLES1(0,0,0,0,5,3)\nHOLES1(0,0,0,0,5,4)", 7.0)] {
        let text = format!("G17 G0 X0 Y0 Z50\nMCALL COUNT\n{pattern}\nMCALL\nX7\n{sub}");
        assert_eq!(number(&text, "R1"), count, "{pattern}");
        near(clean(&text).end().0, [7.0, clean(&text).end()[1], 50.0]);
    }
    let text = format!("G17 G0 Z50\nMCALL COUNT\nHOLES2(0,0,10,0,0,4)\n{sub}");
    assert!((number(&text, "R2") - 10.0).abs() < 1e-9 && (number(&text, "R4") + 10.0).abs() < 1e-9);
}

// oracle: hand (each once, in one note; the run goes on, whatever the arguments name)
#[test]
fn cycles_without_motion_here_are_one_note() {
    let text = "G17 G0 Z50\nCYCLE72(\"A:E\",NOTHING,,0)\nMCALL POCKET3(50,0,1,-5,40,30)\nX1\nX2\nMCALL\n\
        CYCLE95(\"PART\",1,0,0,0,1)\nCYCLE81(50)\nLONGHOLE(1,2,3,4,,3,1,2,3,4,5,6,7)\nCYCLE97()\nCYCLE72\nX9\nM30";
    let outcome = go(text);
    let listed = "CYCLE72, POCKET3, CYCLE95, CYCLE81, LONGHOLE, CYCLE97";
    only_note(&outcome, "run-standard", listed);
    assert_eq!(outcome.passed_over.len(), 6);
    near(outcome.end().0, [9.0, 0.0, 50.0]);
}

// oracle: hand (each once, in one note, whatever the arguments name; G code between them is driven)
#[test]
fn steps_of_shopmill_are_one_note() {
    let text = "E_HEAD(,1,-10,10,100,100,1,,,,,,)\nE_MI_PL(\"MILL\",,NOTHING,1)\nE_PO_CIR(\"A\",\"\",2)\nG0 X9 Z50\n\
        E_PO_CIR(\"A\",\"\",3)\nE_END(0,1,0)\nM30";
    let outcome = go(text);
    let listed = "E_HEAD, E_MI_PL, E_PO_CIR, E_END";
    only_note(&outcome, "run-step", listed);
    near(outcome.end().0, [9.0, 0.0, 50.0]);
    assert_eq!(number("F_OWN(5)\nM30\nPROC F_OWN(REAL A)\nR1=A\nM17", "R1"), 5.0);
}

// oracle: hand (a program of the text is called where it has the name of such a cycle)
#[test]
fn a_program_of_the_user_hides_a_standard_cycle() {
    assert_eq!(number("POCKET3(5)\nM30\nPROC POCKET3(REAL A)\nR1=A\nM17", "R1"), 5.0);
    assert_eq!(number("HOLES2(5)\nM30\nPROC HOLES2(REAL A)\nR1=A\nM17", "R1"), 5.0);
}

proptest! {
    // oracle: self (any numbers: the run ends at the retraction plane, or says why not)
    #[test]
    fn any_hole_ends_at_its_retraction_plane(values in proptest::collection::vec(-50.0..50.0_f64, 12), vari in 0..3) {
        let rest: Vec<_> = values.iter().map(|value| format!("{value:.2}")).collect();
        let text = format!("G17 G0 X0 Y0 Z50 F100 S100\nCYCLE83({},{vari},3,{})\nM30", rest[..11].join(","), rest[11]);
        let outcome = clean(&text);
        prop_assert!((outcome.end()[2] - rest[0].parse::<f64>().unwrap()).abs() < 1e-9, "{text}");
        let deepest = ends(&outcome).len();
        prop_assert!(deepest < 6000, "{text} {deepest}");
    }
}
