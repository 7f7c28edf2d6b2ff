//! Tool radius compensation: G41 and G42, corners, the blocks between, where it begins and ends.

use super::running::{clean_on, go_on};
use super::{fault, findings, near, setup, turning};
use probewright_core::machine::Setup;
use probewright_core::machine::route::Route;
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use std::f64::consts::TAU;

/// Radius of the mill of these tests, mm.
const R: f64 = 10.0;

/// The mill in the spindle; part programs go on behind these lines.
pub const BEGIN: &str = "G17 G90 G40 T20 M6\nD1 F500\n";

/// Motions with their lines.
pub fn routes(outcome: &Outcome) -> Vec<(u32, Route)> {
    let entries = outcome.trace.entries.iter();
    entries
        .filter_map(|entry| match entry.step {
            Step::Motion { from, to, around, .. } => Some((entry.line.unwrap(), Route { from, to, around })),
            _ => None,
        })
        .collect()
}

/// Ends of the motions of a clean run of blocks with the mill, from line 2 on, with their lines.
fn ends(text: &str) -> Vec<(u32, [f64; 3])> {
    let outcome = clean_on(&setup(), &format!("{BEGIN}{text}"));
    let found = routes(&outcome);
    found.into_iter().map(|(line, route)| (line - 1, route.to.0)).filter(|(line, _)| *line > 0).collect()
}

fn goes(text: &str, expected: &[(u32, [f64; 2])]) {
    let found = ends(text);
    assert_eq!(found.len(), expected.len(), "{text}: {found:?}");
    for ((line, to), (of, [x, y])) in found.iter().zip(expected) {
        assert_eq!(line, of, "{text}: {found:?}");
        near(to[0], *x, &format!("{text}: {found:?}"));
        near(to[1], *y, &format!("{text}: {found:?}"));
    }
}

/// A square of 100 mm, its lower left corner at the zero, from the middle of its left edge round it.
const SQUARE: &str = "X0 Y100\nX100\nY0\nX0\nY50\n";

// oracle: hand
#[test]
fn outside_of_a_square_the_corners_are_rounded_or_met() {
    let begin = "G0 X-50 Y50\nG41 G1 X0 Y50\n";
    let end = "G40 X-50\nM30";
    let rounded = [
        (1, [-50.0, 50.0]),
        (2, [-R, 50.0]),
        (3, [-R, 100.0]),
        (4, [0.0, 100.0 + R]),
        (4, [100.0, 100.0 + R]),
        (5, [100.0 + R, 100.0]),
        (5, [100.0 + R, 0.0]),
        (6, [100.0, -R]),
        (6, [0.0, -R]),
        (7, [-R, 0.0]),
        (7, [-R, 50.0]),
        (8, [-50.0, 50.0]),
    ];
    goes(&format!("{begin}{SQUARE}{end}"), &rounded);
    let met = [
        (1, [-50.0, 50.0]),
        (2, [-R, 50.0]),
        (3, [-R, 100.0 + R]),
        (4, [100.0 + R, 100.0 + R]),
        (5, [100.0 + R, -R]),
        (6, [-R, -R]),
        (7, [-R, 50.0]),
        (8, [-50.0, 50.0]),
    ];
    goes(&format!("G451 {begin}{SQUARE}{end}"), &met);
    let inside = [
        (1, [50.0, 50.0]),
        (2, [R, 50.0]),
        (3, [R, 100.0 - R]),
        (4, [100.0 - R, 100.0 - R]),
        (5, [100.0 - R, R]),
        (6, [R, R]),
        (7, [R, 50.0]),
        (8, [50.0, 50.0]),
    ];
    let begin = "G0 X50 Y50\nG42 G1 X0 Y50\n";
    for style in ["", "G451 "] {
        let end = "G40 X50\nM30";
        goes(&format!("{style}{begin}{SQUARE}{end}"), &inside);
    }
}

// oracle: hand: approach and departure are at right angles to the contour, wherever the tool comes from
#[test]
fn the_contour_begins_and_ends_at_right_angles() {
    goes(
        "G41 X20 Y0\nX60\nG40 X80 Y30\nX90\nM30",
        &[(1, [20.0, R]), (2, [60.0, R]), (3, [80.0, 30.0]), (4, [90.0, 30.0])],
    );
    // nothing follows: at right angles to the block itself
    goes("G41 X20 Y0\nM30", &[(1, [20.0, R])]);
    // the end of the program, and a block without motion that takes compensation off
    goes("G42 X20 Y0\nX60\n", &[(1, [20.0, -R]), (2, [60.0, -R])]);
    goes("G42 X20 Y0\nX60\nG40\nX70", &[(1, [20.0, -R]), (2, [60.0, -R]), (4, [70.0, 0.0])]);
}

// oracle: hand: the other side begins anew
#[test]
fn the_side_changes_without_g40() {
    goes(
        "G41 X20 Y0\nX60\nG42 X80\nX100\nG40 X120",
        &[(1, [20.0, R]), (2, [60.0, R]), (3, [80.0, -R]), (4, [100.0, -R]), (5, [120.0, 0.0])],
    );
}

// oracle: hand: a step between two levels is driven where the block before ends, with the corner that follows
#[test]
fn what_only_rises_or_falls_waits_with_its_block() {
    let text = "G0 X-50 Y50 Z5\nG41 G1 X0 Y50\nX0 Y100\nZ-5\nM8\nX100 Z-6\nG40 Y150\nM30";
    let found = ends(text);
    let heights: Vec<f64> = found.iter().map(|(_, to)| to[2]).collect();
    assert_eq!(heights, [5.0, 5.0, 5.0, -5.0, -5.0, -6.0, -6.0]);
    let lines: Vec<u32> = found.iter().map(|(line, _)| *line).collect();
    assert_eq!(lines, [1, 2, 3, 4, 6, 6, 7]);
    near(found[3].1[0], -R, text);
    near(found[3].1[1], 100.0, text);
}

// oracle: hand: records stand between the motions between which they are programmed
#[test]
fn what_a_program_records_stays_in_order() {
    let text = format!("{BEGIN}G41 X20 Y0\nR1=1\nX60\nMSG(\"A\") R2=2\nX60 Y60\nR3=3\nG40 X90\nM30");
    let outcome = clean_on(&setup(), &text);
    let told: Vec<String> = outcome
        .trace
        .entries
        .iter()
        .filter_map(|entry| match &entry.step {
            Step::Motion { .. } => Some(format!("{}", entry.line.unwrap())),
            Step::Set { name, .. } => Some(name.clone()),
            Step::Message { text, .. } => Some(text.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(told, ["2", "R1", "4", "R2", "A", "6", "R3", "8"]);
}

// oracle: hand: what asks for the real position has the block before end at right angles
#[test]
fn the_real_position_is_there_for_who_asks() {
    let begin = "G41 X20 Y0\nX60\n";
    for ask in ["STOPRE", "R1=$AA_IW[Y]"] {
        let after = format!("{begin}{ask}\nX60 Y60\nG40 X100\nM30");
        goes(
            &after,
            &[(1, [20.0, R]), (2, [60.0, R]), (4, [60.0 - R, 0.0]), (4, [60.0 - R, 60.0]), (5, [100.0, 60.0])],
        );
    }
    let remark = format!("{begin}R1=1 ; no STOPRE\nX60 Y60\nG40 X100\nM30");
    let inside = [60.0 - R, R];
    goes(&remark, &[(1, [20.0, R]), (2, inside), (4, [60.0 - R, 60.0]), (5, [100.0, 60.0])]);
    let text = format!("{BEGIN}{begin}R1=$AA_IW[X] R2=$AA_IW[Y] R3=$P_EP[Y]\nM30");
    let control = clean_on(&setup(), &text).control;
    near(control.number("R1"), 60.0, &text);
    near(control.number("R2"), R, &text);
    near(control.number("R3"), 0.0, &text);
}

// oracle: hand
#[test]
fn increments_and_axes_that_are_not_written_count_from_the_contour() {
    goes(
        "G41 X20 Y0\nX=IC(40)\nY-30\nG91 X-40\nG90 G40 Y20",
        &[
            (1, [20.0, R]),
            (2, [60.0, R]),
            (3, [60.0 + R, 0.0]),
            (3, [60.0 + R, -30.0]),
            (4, [60.0, -30.0 - R]),
            (4, [20.0, -30.0 - R]),
            (5, [20.0, 20.0]),
        ],
    );
}

// oracle: hand: wear and OFFN count with the radius, over the block in which they change; D0 has no radius
#[test]
fn the_radius_is_that_of_the_block() {
    goes("$TC_DP15[20,1]=-0.5\nG41 X20 Y0\nX60\nG40 X90", &[(2, [20.0, 9.5]), (3, [60.0, 9.5]), (4, [90.0, 0.0])]);
    goes("OFFN=2\nG41 X20 Y0\nX60\nG40 X90", &[(2, [20.0, 12.0]), (3, [60.0, 12.0]), (4, [90.0, 0.0])]);
    goes(
        "G41 X20 Y0\nX60\nOFFN=1 X80\nX100\nG40 X120",
        &[(1, [20.0, R]), (2, [60.0, R]), (3, [80.0, R + 1.0]), (4, [100.0, R + 1.0]), (5, [120.0, 0.0])],
    );
    let found = ends("G41 X20 Y0\nX60\nD0 X80\nX100\nG40 X120\nM30");
    let across: Vec<f64> = found.iter().map(|(_, to)| to[1]).collect();
    assert_eq!(across, [R, R, 0.0, 0.0, 0.0]);
    // the probe before is 50 mm long, the mill 80 mm, and the spindle nose stays
    near(found[1].1[2], -30.0, "before D0");
    near(found[3].1[2], 50.0, "behind D0");
}

// oracle: hand
#[test]
fn arcs_go_on_round_their_centre() {
    // a bore of 50 mm from its centre
    let text = "G0 X0 Y0\nG41 G1 X25\nG3 X25 Y0 I-25 J0\nG40 G1 X0";
    goes(text, &[(1, [0.0, 0.0]), (2, [15.0, 0.0]), (3, [15.0, 0.0]), (4, [0.0, 0.0])]);
    // a pin of it from outside, down by 5 on the way
    let outcome = clean_on(&setup(), &format!("{BEGIN}G0 X60 Y0\nG41 G1 X25\nG2 X25 Y0 I-25 J0 Z-5\nG40 G1 X60"));
    let found = routes(&outcome);
    let round = found[2].1;
    assert_eq!(round.around.unwrap().degrees.0, -360.0);
    near(round.to[2], -5.0, "helix");
    for part in [0.1, 0.4, 0.9] {
        let [x, y, _] = round.at(part).0;
        near(x.hypot(y), 25.0 + R, "pin");
    }
}

// oracle: hand: an inner arc as small as the tool is a corner for its centre
#[test]
fn an_inner_arc_of_the_radius_of_the_tool_is_passed() {
    goes(
        "G0 X50 Y50\nG41 G1 X0 Y50\nY10\nG3 X10 Y0 CR=10\nG1 X50\nG40 Y50",
        &[(1, [50.0, 50.0]), (2, [R, 50.0]), (3, [R, R]), (5, [50.0, R]), (6, [50.0, 50.0])],
    );
}

// oracle: hand; the numbers of the alarms are those of the control, which this module names in its words only
#[test]
fn what_the_control_refuses_stops_with_a_reason() {
    for (blocks, key) in [
        ("G41 G2 X20 Y0 I10 J0", "run-contour-begin"),
        ("G41 G1 X20\nX40\nG40 G2 X60 Y0 I10 J0", "run-contour-end"),
        ("G41 G1 X20\nX40\nG18\nX60", "run-contour-plane"),
        ("G41 G1 X20\nX40\nROT Y30\nX60", "run-contour-plane"),
        // arcs and grooves that are narrower than the tool
        ("G41 G1 X20\nG3 X20 Y16 CR=8", "run-contour-narrow"),
        ("G41 G1 X20\nX40\nY15\nX20\nG40 Y0", "run-contour-narrow"),
    ] {
        assert_eq!(fault(&format!("{BEGIN}{blocks}\nM30")), key, "{blocks}");
    }
    assert_eq!(fault("T0 M6 G41 G1 X20 F100\nX40"), "run-contour-tool");
}

// oracle: hand: each at the block that is driven as programmed
#[test]
fn what_is_driven_without_compensation_is_told() {
    // without frames an axis that is not written stays where it is, in a measurement it goes to the contour
    for (blocks, across) in [("SUPA X80", R), ("G153 X80", R), ("MEAS=1 X80", 0.0)] {
        let text = format!("{BEGIN}G41 G1 X20 Y0\nX60\n{blocks}\nX100 Y0\nX120\nG40 X140");
        assert_eq!(findings(&text), ["run-radius-compensation"], "{blocks}");
        let outcome = go_on(&setup(), &text);
        let found = routes(&outcome);
        near(found[1].1.to[1], R, blocks);
        near(found[2].1.to[0], 80.0, blocks);
        near(found[2].1.to[1], across, blocks);
        near(found[4].1.to[1], R, blocks);
    }
    let kont = format!("{BEGIN}KONT G41 G1 X20 Y0\nX60\nG40 X80");
    assert_eq!(findings(&kont), ["run-contour-approach"]);
    let disc = format!("{BEGIN}DISC=50 G41 G1 X20 Y0\nX60\nG40 X80");
    assert_eq!(findings(&disc), ["run-not-simulated"]);
}

// oracle: hand: a turning tool of 0.8 mm with cutting edge position 3: the centre of its nose keeps the radius from the
// contour, and its point P is nearer to the axis and to the chuck by the radius
#[test]
fn the_nose_of_a_turning_tool_keeps_its_radius() {
    use probewright_core::control::{Plane, Units};
    let mut setup = Setup::turning_in(Plane::G18, Units::Metric);
    setup.control.tools.insert(7, turning::tool(0.8));
    let text = "G18 G90 DIAMOF T7 D1\nG0 X20 Z10\nG42 G1 X10 Z0 F100\nZ-20\nX15 Z-25\nG40 X25\nM30";
    let outcome = clean_on(&setup, text);
    let found = routes(&outcome);
    // along Z the diameter is cut where P stands; on the cone of 45 degree it is off
    near(found[1].1.to[0], 10.0, "P in X");
    near(found[1].1.to[2], -0.8, "P in Z: the centre stands over the start");
    near(found[2].1.to[0], 10.0, "P in X");
    let corner = -20.0 + 0.8 * (TAU / 16.0).tan();
    near(found[2].1.to[2], corner - 0.8, "P in Z: the centre where both paths meet");
}
