//! A corrected frame that is not taken.

use super::{FRAME, HOLE, called, found, tells};

/// The hole corrects a zero offset, then the program goes on.
fn corrected(active: &str, knum: i64, behind: &str) -> String {
    let hole = HOLE.replace("_MVAR=1", "_MVAR=101").replace("_KNUM=0", &format!("_KNUM={knum}"));
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
    let axis =
        |axis: i64, knum: i64| format!("_MVAR=100 _SETVAL=0 _MA={axis} _KNUM={knum} _PRNUM=1 _FA=2 _TSA=2\nCYCLE978\n");
    let program = |second: i64, behind: &str| {
        format!("G17 G40 G54 T9 D1\n{}G0 X5 Y5\n{}{behind}\nM30\n", axis(1, 1), axis(2, second))
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
    let hole = HOLE.replace("_MVAR=1", "_MVAR=101").replace("_KNUM=0", "_KNUM=1");
    let begin = "G17 G40 G54 T9 D1\nL5";
    assert!(tells(&called(&format!("{begin}\nG0 X5"), &hole), FRAME));
    assert!(!tells(&called(&format!("{begin}\nG54\nG0 X5"), &hole), FRAME));
    assert!(!tells(&called(begin, &format!("{hole}G54")), FRAME));
    // Who calls a subprogram may take the frame behind it.
    assert!(!tells(&format!("%_N_L5_SPF\nG54\n{hole}G0 X5\nM17\n"), FRAME));
}
