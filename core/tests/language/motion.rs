//! Lines, arcs, feeds, measuring blocks.

use super::running::{block, go_on};
use super::{at, clean, end, fault, feed, findings, go, near, number, setup};
use probewright_core::geometry::Mcs;
use probewright_core::json::setup_from_json;
use probewright_core::machine::Stop;
use probewright_core::machine::route::Route;
use probewright_core::machine::trace::{MotionKind, Step};

/// Places that a clean run passes: a hundred on each motion, its end the last.
fn points(text: &str) -> Vec<[f64; 3]> {
    let outcome = clean(text);
    let steps = outcome.trace.entries.iter();
    steps
        .filter_map(|entry| match entry.step {
            Step::Motion { from, to, around, .. } => Some(Route { from, to, around }),
            _ => None,
        })
        .flat_map(|route| (1..=100).map(move |part| route.at(f64::from(part) / 100.0).0))
        .collect()
}

// oracle: hand: a circle about X10 Y0 from the origin
#[test]
fn arcs_keep_to_their_circle() {
    for text in [
        "G2 X20 Y0 I10 J0 F100",
        "G2 X20 Y0 I=AC(10) J=AC(0) F100",
        "G2 X20 Y0 CR=10 F100",
        "G2 X20 Y0 CR=-10 F100",
        "G2 X20 Y0 AR=180 F100",
        "G2 AR=180 I10 J0 F100",
        "G91 G2 X20 I10 F100",
        "CIP X20 Y0 I1=10 J1=10 F100",
        "G3 X20 Y0 I10 J0 TURN=2 F100",
    ] {
        let found = points(text);
        for [x, y, _] in &found {
            near((x - 10.0).hypot(*y), 10.0, text);
        }
        let upper = found.iter().filter(|[_, y, _]| *y > 1.0).count();
        let lower = found.iter().filter(|[_, y, _]| *y < -1.0).count();
        assert!(upper > 0, "{text}");
        assert_eq!(lower > 0, text.contains("TURN"), "{text}");
    }
    at("G2 AR=90 I10 J0 F100", [10.0, 10.0, 0.0]);
    assert_eq!(fault("G2 X20 Y0 I10 J0 TURN=1000 F100"), "run-range");
}

// oracle: hand (from X10 along X or Z, a circle of 10; a spline or an arc before has its own tangent)
#[test]
fn a_tangent_and_an_end_give_an_arc() {
    let round = |text: &str, [x, y]: [f64; 2]| {
        let found: Vec<_> = points(text).into_iter().filter(|[at, ..]| *at > 10.0 + 1e-9).collect();
        assert!(found.len() > 5, "{text}");
        for [at, up, _] in found {
            near((at - x).hypot(up - y), 10.0, text);
        }
    };
    for (text, centre, end) in [
        ("G1 X10 F100\nCT X20 Y10", [10.0, 10.0], [20.0, 10.0, 0.0]),
        ("G1 X10 F100\nCT X20 Y-10", [10.0, -10.0], [20.0, -10.0, 0.0]),
        ("G0 X10\nCT X20 Y10 F100\nM8\nX10 Y20", [10.0, 10.0], [10.0, 20.0, 0.0]),
        ("G1 X10 F100\nCT X20 Y10 Z5", [10.0, 10.0], [20.0, 10.0, 5.0]),
        ("G1 X10 F100\nG91 CT X10 Y10", [10.0, 10.0], [20.0, 10.0, 0.0]),
        ("G1 X10 F100\nX10\nTRANS X5 Y5\nCT X15 Y5", [10.0, 10.0], [20.0, 10.0, 0.0]),
        ("G3 X10 Y10 I0 J10 F100\nCT X20 Y20", [20.0, 10.0], [20.0, 20.0, 0.0]),
    ] {
        round(text, centre);
        at(text, end);
    }
    // a new frame takes the direction with it
    at("G1 X10 F100\nROT Z90\nCT X10 Y0 F100\nROT", [0.0, 10.0, 0.0]);
    for [x, y, _] in points("G1 X10 F100\nROT Z90\nCT X10 Y0").into_iter().filter(|[_, y, _]| *y > 0.0) {
        near(x.hypot(y), 10.0, "ROT");
    }
    at("G18\nG0 X0 Y0 Z0\nG1 Z10 F100\nCT Z20 X10\nG1 X12", [12.0, 0.0, 20.0]);
    at("G1 X10 F100\nCT X30\nX40", [40.0, 0.0, 0.0]);
    assert!(points("G1 X10 F100\nCT X30\nX40").iter().all(|[_, y, _]| y.abs() < 1e-9), "straight on");
    assert_eq!(number("G1 X10 F100\nCT X20 Y10\nR1=$P_GG[1]\nG1 X0 Y0\nR2=$P_GG[1]\nR1=R1+R2/10", "R1"), 15.2);
    for text in
        ["CT X10 Y10 F100", "G1 Z10 F100\nCT X10 Y5", "G1 X10 F100\nPOS[Y]=5\nCT X20 Y9", "SUPA G0 X5\nCT X9 Y9 F100"]
    {
        assert_eq!(fault(text), "run-not-simulated", "{text}");
    }
    for text in ["G1 X10 F100\nCT X0", "G1 X10 F100\nCT X20 TURN=1"] {
        assert_eq!(fault(text), "run-arc", "{text}");
    }
}

// oracle: hand
#[test]
fn arcs_stand_in_the_working_plane() {
    // G18: Z is the abscissa, X the ordinate
    at("G18\nG0 X0 Y0 Z0\nG3 Z0 X20 I10 K0 F100", [20.0, 0.0, 0.0]);
    let text = "G19\nG0 X0 Y0 Z0\nG2 Y20 Z0 X6 J10 K0 F100";
    for [x, y, z] in points(text).into_iter().skip(100) {
        near((y - 10.0).hypot(z), 10.0, text);
        assert!((0.0..=6.0).contains(&x));
    }
    at("MIRROR X0\nG1 X0 Y0 F100\nG2 X20 Y0 I10 J0\n", [-20.0, 0.0, 0.0]);
}

// oracle: hand
#[test]
fn what_is_no_arc_is_told() {
    for text in [
        "G2 X20 F100",
        "G2 X20 Y0 I7 J0 F100",
        "G2 X20 Y0 CR=9 F100",
        "G2 X0 Y0 CR=9 F100",
        "CIP X20 I1=10 F100",
        "G2 X20 AR=360 F100",
        "SCALE X2\nG2 X20 Y0 I10 J0 F100",
        "G2 X20 Y0 I10 J0 AR=90 F100",
    ] {
        assert_eq!(fault(text), "run-arc", "{text}");
    }
}

// oracle: hand (mm a revolution times revolutions a minute)
#[test]
fn feeds_count_a_minute_or_a_revolution() {
    assert_eq!(feed("G94 F200 S500 G1 X1"), 200.0);
    assert_eq!(feed("G95 F0.2 S500 M3 G1 X1"), 100.0);
    assert_eq!(feed("G95 F0.2 S1=500\nG94 F80 G1 X1"), 80.0);
    assert_eq!(findings("G95 F0.2 G1 X1"), ["run-no-feed"]);
    assert_eq!(findings("G1 X1"), ["run-no-feed"]);
    assert_eq!(feed("F100\nG1 X1 FB=30"), 30.0);
    assert_eq!(feed("F100\nG1 X1 FB=30\nX2"), 100.0);
}

// oracle: hand: the transverse axis by diameter (DIAMON), by diameter where it is absolute (DIAM90)
#[test]
fn diameters_are_halved() {
    at("DIAMON\nG0 X20 Z5\nX=IC(4)", [12.0, 0.0, 5.0]);
    at("DIAM90\nG0 X20\nX=IC(4)", [14.0, 0.0, 0.0]);
    at("DIAMON\nDIAMOF\nG0 X20", [20.0, 0.0, 0.0]);
    let arc = "G18 DIAMON\nG0 X20 Z0\nG2 X20 Z20 I=AC(20) K=AC(10) F100\nG0 X0 Z-50";
    assert_eq!(go(arc).stop, None, "an absolute centre is a diameter too");
    assert_eq!(number("DIAMON\nG0 X20\nR1=$AA_IW[X]", "R1"), 20.0);
}

// oracle: hand
#[test]
fn a_spline_passes_its_points_and_says_that_it_is_none() {
    assert_eq!(findings("BSPLINE SD=2 F100\nX10 Y20 PW=2\nG1 X0"), ["run-spline"]);
    let outcome = go("ASPLINE BNAT ETAN F100\nX70 Y30");
    assert_eq!(outcome.position, [70.0, 30.0, 0.0]);
}

// oracle: hand: the ball (radius 3) meets the face X=-50; MEAS stops there, MEAW goes on
#[test]
fn measuring_blocks_latch_and_stop_or_go_on() {
    for (word, stands) in [("MEAS", -53.0), ("MEAW", -45.0)] {
        let mut setup = setup();
        setup.position = Mcs([-100.0, 0.0, -10.0]);
        setup.workpiece.solids.push(block());
        let text = format!(
            "TRANS X5\n{word}=1 G1 X-50 F300\nSTOPRE\nR1=$AC_MEA[1] R2=$AA_MW[X] R3=$AA_MM[Z] R4=$AA_IB[X]\n\
                G0 X=IC(-50)\nG0 Z20"
        );
        let outcome = go_on(&setup, &text);
        assert_eq!(outcome.stop, None, "{word}");
        let found = ["R1", "R2", "R3", "R4"].map(|name| outcome.control.number(name));
        for (found, expected) in found.into_iter().zip([1.0, -58.0, 40.0, stands]) {
            near(found, expected, word);
        }
        let probed = outcome.trace.entries.iter();
        let probed = probed.filter(|entry| matches!(entry.step, Step::Motion { kind: MotionKind::Measuring, .. }));
        assert_eq!(probed.count(), if word == "MEAS" { 1 } else { 2 });
    }
}

// oracle: hand: the corner of the block, 71 mm from the table's axis, comes round to the ball 60 mm from it
#[test]
fn a_table_that_turns_the_part_into_the_probe_crashes() {
    let run = |way: &str| {
        let mut setup = setup();
        setup.workpiece.solids.push(block());
        setup.control.rotary_centre = setup.workpiece.solids[0].at;
        let [x, y, _] = setup.control.rotary_centre.0;
        setup.position = Mcs([x, y - 60.0, 40.0]);
        go_on(&setup, way)
    };
    let outcome = run("G0 Z-10\nC90\nX0");
    assert!(matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == "run-crash"));
    let place = outcome.diagnostics[0].span.unwrap();
    assert_eq!((place.start, place.end), (8, 11));
    assert_eq!(run("G0 Z20\nC90").stop, None);
}

// oracle: hand: the axis by itself comes before the channel until it follows that; DIAMCYCOF is of the channel
#[test]
fn the_transverse_axis_has_a_mode_of_its_own() {
    for (text, x) in [
        ("DIAMONA[X]\nG0 X20\nX=IC(4)", 12.0),
        ("DIAM90A[X]\nG0 X20\nX=IC(4)", 14.0),
        ("DIAMON\nDIAMOFA[X] G0 X20", 20.0),
        ("DIAMON\nDIAMOFA[X]\nDIAMON\nG0 X20", 20.0),
        ("DIAMONA[X]\nDIAMOF\nG0 X20", 10.0),
        ("DIAMONA[X]\nDIAMOF\nDIAMCHANA[X]\nG0 X20", 20.0),
        ("DIAMOFA[X]\nDIAMON\nDIAMCHAN\nG0 X20", 10.0),
        ("DIAMON\nDIAMCHAN\nG0 X20", 10.0),
        ("DIAMON\nDIAMCYCOF\nG0 X20", 20.0),
        ("DIAMON\nDIAMCYCOF\nDIAM90\nG0 X20", 10.0),
        ("DIAMONA[X]\nDIAMCYCOF\nG0 X20", 10.0),
        ("DEF AXIS WAY=(X)\nDIAMONA[WAY]\nG0 X20", 10.0),
        ("G[29]=2\nG0 X20", 10.0),
        ("G[29]=4\nG0 X20", 20.0),
        ("DIAMOFA[Y] DIAMOFA[U]\nG0 X20", 20.0),
        ("UP\nG0 X20\nM30\n%_N_UP_SPF\nPROC UP SAVE\nDIAMONA[X]\nM17", 20.0),
        ("DIAMONA[X]\nUP\nG0 X20\nM30\n%_N_UP_SPF\nPROC UP SAVE\nDIAMCHAN\nM17", 10.0),
    ] {
        at(text, [x, 0.0, 0.0]);
    }
    for (text, shown) in [
        ("DIAMONA[X]\nG0 X20\nR1=$AA_IW[X]", 20.0),
        ("G0 X20\nDIAMONA[X]\nR1=$P_EP[X]", 40.0),
        ("R1=$P_GG[29]", 1.0),
        ("DIAM90\nDIAMOFA[X]\nR1=$P_GG[29]", 3.0),
        ("DIAMONA[X]\nR1=$P_GG[29]", 1.0),
        ("DIAMON\nDIAMCYCOF\nR1=$P_GG[29]", 4.0),
        ("DIAMCYCOF\nDIAMON\nR1=$P_GG[29]", 2.0),
    ] {
        near(number(text, "R1"), shown, text);
    }
    assert_eq!(fault("DIAMONA[X,Z]"), "run-function");
}

// oracle: hand: a diameter or a radius in one block, whatever is active; the next block is written as before
#[test]
fn a_dimension_is_a_diameter_or_a_radius_in_its_block_alone() {
    for (text, x) in [
        ("G0 X=DAC(20)", 10.0),
        ("G0 X20\nX=DIC(4)", 22.0),
        ("G0 X=DAC(20)\nX=IC(3)", 13.0),
        ("DIAMON\nG0 X=RAC(20)", 20.0),
        ("DIAMON\nG0 X20\nX=RIC(4)", 14.0),
        ("DIAMON\nG0 X=RAC(20)\nX8", 4.0),
        ("G91\nG0 X5\nX=DAC(20)", 10.0),
        ("DIAM90\nG0 X20\nX=DIC(4)", 12.0),
        ("G18 G1 F100 DIAMON\nX=RAC(10) Z0\nG2 X=RAC(20) Z-10 CR=10", 20.0),
    ] {
        near(end(text)[0], x, text);
    }
    let moved = go("G0 POS[X]=DAC(20)");
    assert_eq!((moved.stop.is_none(), moved.position.0[0]), (true, 10.0));
    for text in ["Z=DAC(5)", "Y=RIC(5)", "C=DAC(5)", "U=RAC(5)", "I=DAC(5)"] {
        assert_eq!(fault(text), "run-not-simulated", "{text}");
    }
}

/// A part of diameter 60.24 mm in a lathe with a calibrated probe.
const TURNED: &str = r#"{
    "control": "sinumerik", "plane": "G18", "active": { "tool": 8, "edge": 1, "frame": "G54" },
    "tools": {
        "8": { "edges": { "1": { "type": 580, "tip": 7, "length": [40, 100, 0], "radius": 3 } } },
        "7": { "edges": { "1": { "type": 500, "tip": 3, "length": [60, 40, 0], "radius": 0.8 } } }
    },
    "frames": { "G54": { "coarse": [0, 0, 200] } }, "data": { "MD18600": 1 },
    "probe": { "radius": 3, "length": 0 }, "position": [200, 0, 400],
    "workpiece": [{ "shape": "turned", "size": [60.24, 60, 0, 0], "at": [0, 0, 260] }]
}"#;

// oracle: manual B:10975 (diameters with DIAMON, else radii), hand: whichever word says so; the part is 0.24 mm large
#[test]
fn a_cycle_measures_with_what_counts_for_the_transverse_axis() {
    let setup = setup_from_json(TURNED).unwrap();
    for (mode, per) in [
        ("DIAMON", 2.0),
        ("DIAMOF\nDIAMONA[X]", 2.0),
        ("DIAMOFA[X]\nDIAMON\nDIAMCHAN", 2.0),
        ("DIAMONA[X]\nDIAMCYCOF", 2.0),
        ("DIAMOF", 1.0),
        ("DIAMON\nDIAMOFA[X]", 1.0),
        ("DIAMON\nDIAMCYCOF", 1.0),
    ] {
        let text = format!(
            "G18 G54 T8 D1 G90\n{mode}\nG0 Z30 X=DAC(80)\n_MVAR=0 _MA=2 _TNUM=7 _KNUM=1 _TUL=0.5 _TLL=-0.5 _TMV=0.01 \
             _TDIF=1 _TZL=0 _TSA=1 _K=1 _VMS=0 _NMSP=1 _FA=3 _PRNUM=1 _EVNUM=0 _SETVAL={}\nCYCLE974\nM30",
            30.0 * per
        );
        let outcome = go_on(&setup, &text);
        assert_eq!(outcome.stop, None, "{mode}");
        near(outcome.control.number("_OVR[4]"), 30.12 * per, mode);
        near(outcome.control.number("_OVR[16]"), 0.12 * per, mode);
    }
}
