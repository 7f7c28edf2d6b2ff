//! Corners between lines: rounded and chamfered; feeds by time and by turns; axes that the setup does not name.

use super::{clean, go, near, number, only_note};
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use proptest::prelude::*;

/// Ends of the motions of a run, whether each is an arc, and its feed.
fn motions(outcome: &Outcome) -> Vec<([f64; 3], bool, f64)> {
    let motions = outcome.trace.entries.iter().filter_map(|entry| match &entry.step {
        Step::Motion { to, around, feed, .. } => Some((to.0, around.is_some(), *feed)),
        _ => None,
    });
    motions.collect()
}

/// Runs both texts behind the same begin; the same motions come out.
fn alike(before: &str, one: &str, other: &str) {
    let [one_way, other_way] = [one, other].map(|text| motions(&clean(&format!("{before}\n{text}\nM30"))));
    assert_eq!(one_way.len(), other_way.len(), "{before} {one} {one_way:?} {other_way:?}");
    for (a, b) in one_way.iter().zip(&other_way) {
        near(a.0, b.0);
        assert_eq!(a.1, b.1, "{before} {one}");
        assert!((a.2 - b.2).abs() < 1e-6, "{before} {one}");
    }
}

// oracle: peer (the arcs and lines written by hand, in other frames, with compensation, in inch and in diameters)
#[test]
fn a_corner_is_its_arc_or_line_written_by_hand() {
    let pairs = [
        ("X20 RND=5\nY20", "X15\nG3 X20 Y5 CR=5\nG1 Y20"),
        ("X20 RND=5\nN2 ; nothing moves here\nM8\nY-20", "X15\nG2 X20 Y-5 CR=5\nG1 Y-20"),
        ("X20 CHR=4\nY20", "X16\nX20 Y4\nY20"),
        ("X20 CHF=4*SQRT(2)\nY20", "X16\nX20 Y4\nY20"),
        ("RNDM=3\nX20\nY20\nX0 RNDM=0\nY0\nX5", "X17\nG3 X20 Y3 CR=3\nG1 Y17\nG3 X17 Y20 CR=3\nG1 X0\nY0\nX5"),
        // increments count from the corner itself
        ("X20 RND=5\nG91 Y20\nX5\nG90", "X15\nG3 X20 Y5 CR=5\nG1 Y20\nX25"),
        ("X20 RND=5\nY=IC(20)", "X15\nG3 X20 Y5 CR=5\nG1 Y20"),
        // its own feed
        ("X20 RND=5 FRC=50\nY20", "X15\nG3 X20 Y5 CR=5 F50\nG1 Y20 F100"),
        ("FRCM=40\nX20 CHR=4\nY20", "X16\nX20 Y4 F40\nY20 F100"),
        // straight on, or the last block of all: nothing to round
        ("RNDM=5\nX20\nX30\nG0 Y5", "X20\nX30\nG0 Y5"),
        // what is too large is made as small as the lines are
        ("X20 CHR=50\nY8", "X12\nX20 Y8\nY8"),
    ];
    for before in [
        "G17 G90 G1 F100 X0 Y0 Z50",
        "G17 G90 G1 F100 X0 Y0 Z50\nROT Z25\nATRANS X3",
        "G17 G0 Z50\nMIRROR X0\nG1 F100 X0 Y0",
        "G17 G70 G1 F100 X0 Y0 Z2",
        "G17 T20 D1 M6\nG1 F100 X0 Y0 Z50",
    ] {
        for (one, other) in pairs {
            alike(before, one, other);
        }
    }
    // beside the contour a point of no length is none: the tool of 10 mm goes as by hand
    alike(
        "G17 T20 D1 M6\nG1 F100 X-30 Y0 Z50\nG42 X0",
        "X40 RND=15\nY40\nG40 X90",
        "X25\nG3 X40 Y15 CR=15\nG1 Y40\nG40 X90",
    );
    alike("G18 G1 F100 Z0 X0 DIAMON", "Z20 RND=5\nX40", "Z15\nG3 Z20 X10 CR=5\nG1 X40");
}

// oracle: hand (what is not driven is told, and the corner stays)
#[test]
fn a_corner_that_is_not_driven_is_told() {
    for (text, word) in [("G1 X20 RND=5\nG2 X30 Y10 CR=10", "RND"), ("G1 X20 CHF=5\nIF R1==0\nY9\nENDIF", "CHF")] {
        let outcome = go(&format!("G17 G90 G1 X0 Y0 Z50 F100\n{text}\nM30"));
        let told: Vec<_> =
            outcome.diagnostics.iter().map(|one| (&*one.message.key, one.message.word("word"))).collect();
        assert_eq!(told, [("run-not-simulated", Some(word))], "{text}");
        assert!(motions(&outcome).iter().any(|(to, ..)| *to == [20.0, 0.0, 50.0]), "{text}");
    }
}

// oracle: hand (F is 1 by minutes: 2 by 30 seconds; arcs by their length)
#[test]
fn inverse_time_is_a_feed_by_the_length() {
    let feeds = |text: &str| {
        let found = motions(&clean(&format!("G17 G90 G0 X0 Y0 Z50\n{text}\nM30")));
        found.iter().map(|(.., feed)| *feed).filter(|feed| *feed > 0.0).collect::<Vec<_>>()
    };
    assert_eq!(feeds("G93 G1 X10 F2\nX110 F2\nG94 X0 F300"), [20.0, 200.0, 300.0]);
    assert_eq!(feeds("G70\nG93 G1 X1 F2"), [50.8]);
    let arc = feeds("G93 G3 X20 Y0 CR=10 F1");
    assert!((arc[0] - 10.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(feeds("S500 G95 G1 X10 F0.2\nG94 X0 F70\nG97 S100 X5 F1"), [100.0, 70.0, 100.0]);
    assert_eq!(feeds("G961 S100 G1 X10 F80\nG971 X0 F90"), [80.0, 90.0]);
}

// oracle: hand (one note; positions absolute, by increments and in inch; the run goes on)
#[test]
fn axes_without_a_setup_are_taken_into_the_machine() {
    let text = "G0 V10 W=AC(5)\nG91 V2\nG90 W=IC(-1)\nA=DC(90)\nX1=7 B30\nPOS[U]=4\nR1=$AA_IM[V] R2=$P_EP[W]\n\
        R3=$AA_IW[A] R4=$AA_IM[X1] R5=$AA_IM[U]\nX9\nM30";
    let outcome = go(text);
    only_note(&outcome, "run-axes", "V, W, A, X1, B, U");
    let found = ["R1", "R2", "R3", "R4", "R5"].map(|name| outcome.control.number(name));
    assert_eq!(found, [12.0, 4.0, 90.0, 7.0, 4.0]);
    assert_eq!(outcome.passed_over, []);
    assert_eq!(go("G70\nG0 V1\nR1=$AA_IM[V]").control.number("R1"), 25.4);
    // a loop that waits for such an axis is not endless
    assert_eq!(go("G91\nWHILE $AA_IM[V]<100\nG0 V1\nENDWHILE\nM30").stop, None);
    assert_eq!(number("DEF REAL V\nV=5\nR1=V", "R1"), 5.0);
}

proptest! {
    // oracle: self (a rounded corner ends where the sharp one does, touches its arc tangentially, and is no longer)
    #[test]
    fn any_corner_ends_where_its_block_says(
        points in proptest::collection::vec((-90..90_i32, -90..90_i32), 2..8), size in 0.0..40.0_f64, kind in 0..3_usize
    ) {
        let word = ["RND", "CHF", "CHR"][kind];
        let lines = |corner: &str| {
            let blocks: Vec<_> = points.iter().map(|(x, y)| format!("X{x} Y{y} {corner}")).collect();
            let text = format!("G17 G90 G1 X0 Y0 Z50 F100\n{}\nX0 Y0\nM30", blocks.join("\n"));
            go(&text)
        };
        let length = |outcome: &Outcome| {
            let ways = outcome.trace.entries.iter().filter_map(|entry| match &entry.step {
                Step::Motion { from, to, around, .. } => Some(match around {
                    Some(around) => around.length(*from, *to),
                    None => (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt(),
                }),
                _ => None,
            });
            ways.sum::<f64>()
        };
        let (sharp, round) = (lines(""), lines(&format!("{word}={size:.3}")));
        prop_assert_eq!(&round.stop, &None);
        near(round.end().0, sharp.end().0);
        prop_assert!(length(&round) <= length(&sharp) + 1e-6);
    }
}
