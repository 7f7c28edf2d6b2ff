//! Polar coordinates, constant cutting speed, calls after each motion.

use super::{at, clean, fault, feed, findings, near, number};
use probewright_core::machine::trace::Step;

// oracle: hand: 20 mm at 30 degree are 17.32 and 10
#[test]
fn a_point_is_told_by_pole_angle_and_distance() {
    let (x, y) = (300.0_f64.sqrt(), 10.0);
    at("G0 AP=30 RP=20", [x, y, 0.0]);
    at("G111 X100 Y50\nG0 AP=30 RP=20 Z7", [100.0 + x, 50.0 + y, 7.0]);
    at("G0 X5 Y6\nG110 X1\nG0 AP=90 RP=4", [6.0, 10.0, 0.0]);
    at("G111 X5 Y6\nG112 X1 Y1\nG0 AP=180 RP=2", [4.0, 7.0, 0.0]);
    at("G111 AP=90 RP=10\nG0 AP=0 RP=3", [3.0, 10.0, 0.0]);
    at("G0 AP=30 RP=20\nAP=IC(60)\nRP=IC(-5)", [0.0, 15.0, 0.0]);
    at("G0 AP=30 RP=20\nAP=120", [-y, x, 0.0]);
    at("TRANS X10\nG0 AP=0 RP=5", [15.0, 0.0, 0.0]);
    at("G70 G0 AP=90 RP=1", [0.0, 25.4, 0.0]);
    // the plane decides which axes: in G18 the angle counts from Z
    at("G18\nG0 Y0 AP=90 RP=5", [5.0, 0.0, 0.0]);
}

// oracle: hand: a line at 45 degrees, one at 135 degrees, and in G18 from Z
#[test]
fn a_line_is_told_by_its_angle() {
    at("G0 X1 Y2\nG1 X11 ANG=45 F100", [11.0, 12.0, 0.0]);
    at("G1 Y10 ANG=135 F100", [-10.0, 10.0, 0.0]);
    at("G1 Y10 ANG=90 F100", [0.0, 10.0, 0.0]);
    at("G0 X5\nG91 G1 Y=IC(3) ANG=45 F100", [8.0, 3.0, 0.0]);
    at("G18\nG0 X0 Y0 Z0\nG1 Z10 ANG=45 F100", [10.0, 0.0, 10.0]);
    for text in ["G1 X5 Y5 ANG=45 F100", "G1 Z5 ANG=45 F100", "G1 Y5 ANG=0 F100"] {
        assert_eq!(fault(text), "run-not-simulated", "{text}");
    }
}

// oracle: hand: a quarter round the pole passes 45 degree
#[test]
fn an_arc_goes_round_the_pole() {
    let text = "G111 X10 Y0\nG0 AP=0 RP=10\nG3 AP=90 RP=10 F100";
    let outcome = clean(text);
    let Some(Step::Motion { from, to, around: Some(around), .. }) =
        outcome.trace.entries.last().map(|entry| entry.step)
    else {
        panic!("no arc");
    };
    let [x, y, _] = around.at(from, to, 0.5).0;
    near(x, 10.0 + 50.0_f64.sqrt(), text);
    near(y, 50.0_f64.sqrt(), text);
    at(text, [10.0, 10.0, 0.0]);
    assert_eq!(fault("G111 X10 Y0\nG0 AP=0 RP=10\nG3 AP=90 RP=12 F100"), "run-arc");
}

// oracle: hand: 100 m/min at X50 (diameter 100) are 1000000 / (2 π 50) revolutions a minute
#[test]
fn a_cutting_speed_makes_the_spindle_faster_inside() {
    let turns = |radius: f64| 100_000.0 / (2.0 * std::f64::consts::PI * radius);
    let text = "G96 S100 F0.2 M3 G1 X50";
    near(feed(text), 0.2 * turns(50.0), text);
    let text = "LIMS=2000\nG96 S100 F0.2 G1 X50\nX1";
    near(feed(text), 0.2 * 2000.0, text);
    let text = "G96 S100 F0.2 G1 X50\nG97 S500 X10";
    near(feed(text), 0.2 * 500.0, text);
    let text = "G96 S100 F0.2 G1 X50\nG97 X10";
    near(feed(text), 0.2 * turns(50.0), "G97 keeps the speed of the spindle");
    let text = "G0 X50\nG96 S100 M3";
    near(clean(text).control.spindle_speed, turns(50.0), text);
    assert_eq!(findings("G96 S100 F0.2 G1 X50\nX0"), ["run-no-feed"]);
}

// oracle: hand: the program runs after X1, Y2 and Z3, not after R2=1 and not for its own motion
#[test]
fn a_modal_call_follows_each_motion() {
    let drill = "PROC DRILL(REAL DEEP)\nR1=R1+DEEP\nZ=IC(-1)\nZ=IC(1)\nM17";
    for (text, sum) in [
        ("MCALL DRILL(2)\nG0 X1\nR2=1\nY2\nG111 X5\nMCALL\nX9", 4.0),
        ("MCALL DRILL(2)\nG0 X1\nMCALL DRILL(5)\nY2\nMCALL\nX3", 7.0),
        ("G0 X1\nPCALL DRILL(3)\nX2", 3.0),
        ("G0 X1\nPCALL /_N_WKS_DIR/_N_PART_WPD/DRILL(3)\nX2", 3.0),
    ] {
        near(number(&format!("{text}\nM30\n{drill}"), "R1"), sum, text);
    }
    let call = "EXTCALL(\"DRILLS\")\nM30\nPROC DRILLS\nR1=8\nM17";
    near(number(call, "R1"), 8.0, call);
    assert_eq!(findings("MCALL CYCLE83(1)\nG0 X1\nX2"), ["run-standard"]);
}
