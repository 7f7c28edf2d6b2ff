//! The checks of CYCLE971 on a control with the probe and the tool of the manual's example (B:4433-4446, B:4872-4888).

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::cycle971::CYCLE971;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, Edge, Plane, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::Typed;

/// Probe 1 in the machine and in the workpiece system; T3 D1 in the spindle, an end mill of 36 mm.
fn control() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    for (index, value) in [(0, 50.0), (1, 28.0), (2, 42.0), (3, 20.0), (4, 80.0), (6, 20.0), (9, 4.0)] {
        control.set(format!("_TP[0,{index}]"), value);
        control.set(format!("_TPW[0,{index}]"), value);
    }
    let edge = Edge { kind: 123, length: [70.0, 0.0, 0.0], radius: 18.0, ..Edge::default() };
    control.tools.entry(3).or_default().edges.insert(1, edge);
    (control.tool, control.edge) = (3, 1);
    control
}

fn edge(control: &mut Control) -> &mut Edge {
    control.edge_of_mut(3, 1).unwrap()
}

/// Findings of a call like the example's with these values.
fn found(values: &[(&str, &str)], change: impl Fn(&mut Control)) -> Vec<(Severity, Code)> {
    let mut typed: Typed = changed(&CYCLE971, values);
    typed.retain(|_, value| value != "-");
    let mut control = control();
    change(&mut control);
    let found = check(&CYCLE971, &typed, &control).diagnostics;
    found.iter().map(|one| (one.severity, one.code)).collect()
}

fn alarm(number: u32) -> Vec<(Severity, Code)> {
    vec![(Severity::Error, Code::Alarm(number))]
}

fn doubt(number: u16) -> Vec<(Severity, Code)> {
    vec![(Severity::Warning, Code::Own(number))]
}

const RADIUS: &[(&str, &str)] = &[("_MA", "1")];
const CALIBRATE: &[(&str, &str)] = &[("_MVAR", "0"), ("_MA", "1")];
const AUTOMATIC: &[(&str, &str)] = &[("_MVAR", "100000")];
const ROTATING: &[(&str, &str)] = &[("_MVAR", "2"), ("_MA", "1")];

#[test]
fn the_calls_of_the_manual_are_right() {
    // oracle: manual B:4451-4505, B:4552-4560, B:4686-4700, B:4893-4924, B:4977-5000
    let incremental = &[("_MVAR", "10000"), ("_MA", "2"), ("_FA", "-6")][..];
    let calibrating = |control: &mut Control| edge(control).radius = 5.0;
    for call in [
        &[("_MVAR", "0"), ("_MA", "102"), ("_FA", "6"), ("_TSA", "5")][..],
        &[("_MVAR", "0"), ("_MA", "3"), ("_ID", "-"), ("_FA", "6"), ("_TSA", "5")],
        &[("_MVAR", "10"), ("_MA", "1"), ("_FA", "6"), ("_TSA", "5")],
        &[("_MVAR", "100000"), ("_MA", "-"), ("_FA", "6"), ("_TSA", "5")],
        incremental,
    ] {
        assert_eq!(found(call, calibrating), [], "{call:?}");
    }
    assert_eq!(found(&[], |_| ()), []);
    assert_eq!(found(&[("_ID", "2.4"), ("_MA", "1"), ("_MVAR", "2")], |_| ()), []);
    assert_eq!(found(&[("_ID", "0"), ("_MA", "1"), ("_MVAR", "12")], |_| ()), []);
}

#[test]
fn variants_and_axes_that_do_not_exist_are_refused() {
    // oracle: manual B:1854, B:4420, B:4842-4846; tests/data/variants_invalid.tsv (61325 is proposed there)
    for number in ["3", "20", "100", "10001", "10002", "20000", "100001", "110000", "-1"] {
        assert_eq!(found(&[("_MVAR", number)], |_| ()), alarm(61307), "{number}");
    }
    for variant in ["10000", "10010"] {
        for axis in ["102", "103", "201", "203"] {
            let call = [("_MVAR", variant), ("_MA", axis), ("_FA", "6")];
            assert_eq!(found(&call, |_| ()), alarm(61325), "{call:?}");
        }
    }
    for variant in ["1", "2", "11", "12"] {
        for axis in ["102", "201", "0", "4"] {
            let call = [("_MVAR", variant), ("_MA", axis)];
            assert_eq!(found(&call, |_| ()), alarm(61325), "{call:?}");
        }
    }
}

#[test]
fn the_measuring_path_has_a_sign_only_at_incremental_calibration() {
    // oracle: manual B:4421-4424, A:15847
    for path in ["0", "-3"] {
        assert_eq!(found(&[("_FA", path)], |_| ()), alarm(61308));
    }
    let incremental = |path| found(&[("_MVAR", "10000"), ("_MA", "1"), ("_FA", path)], |_| ());
    assert_eq!(incremental("0"), alarm(61308));
    assert_eq!(incremental("-3"), []);
    assert_eq!(incremental("3"), []);
}

#[test]
fn the_data_of_the_probe_are_looked_at() {
    // oracle: manual B:4397, B:4720-4741, B:13345-13369, A:15848-15852, A:15891, A:15934
    assert_eq!(
        found(&[("_PRNUM", "4")], |control| (0..10).for_each(|index| {
            let value = control.number(&format!("_TP[0,{index}]"));
            control.set(format!("_TP[3,{index}]"), value);
        })),
        alarm(61313)
    );
    assert_eq!(found(&[], |control| control.set("_TP[0,8]", 7.0)), alarm(61309));
    assert_eq!(found(&[], |control| control.set("_TP[0,8]", 201.0)), alarm(61415));
    let disc = |control: &mut Control| {
        control.set("_TP[0,8]", 201.0);
        control.set("_TP[0,5]", -10.0);
        control.plane = Plane::G18;
    };
    assert_eq!(found(&[], disc), []);
    assert_eq!(found(RADIUS, |control| control.set("_TP[0,9]", 0.0)), alarm(61349));
    assert_eq!(found(CALIBRATE, |control| control.set("_TP[0,9]", 0.0)), doubt(63));
    for code in [33.0, 233.0, 143.0, 1133.0] {
        let set = |control: &mut Control| control.set("_TP[0,7]", code);
        assert_eq!(found(AUTOMATIC, set), alarm(61309), "{code}");
    }
    assert_eq!(found(AUTOMATIC, |control| control.set("_TP[0,7]", 123.0)), []);
    let empty = |control: &mut Control| (0..4).for_each(|i| control.set(format!("_TP[0,{i}]"), 0.0));
    assert_eq!(found(&[], empty), doubt(61));
    assert_eq!(found(&[], |control| control.set("_TP[0,1]", 60.0)), doubt(62));
}

#[test]
fn the_tool_in_use_is_looked_at() {
    // oracle: manual B:4157-4175 (milling tools and drills; radius of milling tools), A:15855, A:15893
    let probe = |control: &mut Control| edge(control).kind = 710;
    assert_eq!(found(&[], probe), [(Severity::Warning, Code::Alarm(61314))]);
    for kind in [500, 400] {
        assert_eq!(found(&[], |control| edge(control).kind = kind), alarm(61314));
    }
    let drill = |control: &mut Control| edge(control).kind = 200;
    assert_eq!(found(&[], drill), []);
    assert_eq!(found(RADIUS, drill), alarm(61314));
    let short = |control: &mut Control| edge(control).length[0] = 0.0;
    assert_eq!(found(&[], short), alarm(61351));
    assert_eq!(found(RADIUS, short), []);
    let thin = |control: &mut Control| edge(control).radius = 0.0;
    assert_eq!(found(RADIUS, thin), alarm(61351));
    assert_eq!(found(&[], |control| control.tool = 0), []);
    // oracle: hand: less than no radius cannot be simulated
    let worn = |control: &mut Control| edge(control).radius_wear = -18.01;
    assert!(found(&[], worn).contains(&(Severity::Warning, Code::Own(175))));
}

#[test]
fn a_wide_tool_is_offset() {
    // oracle: manual B:4593-4599 (a tool of 36 mm on a probe of 20 mm)
    let calibrate = |axis| [("_MVAR", "0"), ("_MA", axis), ("_ID", "-")];
    let missing = vec![(Severity::Error, crate::own::MISSING.code())];
    assert_eq!(found(&calibrate("3"), |_| ()), missing);
    assert_eq!(found(&calibrate("203"), |_| ()), missing);
    assert_eq!(found(&calibrate("1"), |_| ()), []);
    assert_eq!(found(&calibrate("3"), |control| edge(control).radius = 9.0), []);
    assert_eq!(found(&[("_ID", "19")], |_| ()), doubt(64));
    let told = vec![(Severity::Note, Code::Own(65))];
    assert_eq!(found(&[("_MA", "3")], |_| ()), told);
    // oracle: manual B:4844-4846: a drill is measured at the centre, an offset is for milling tools
    let drill = |control: &mut Control| edge(control).kind = 200;
    assert_eq!(found(&[("_ID", "19")], drill), []);
    assert_eq!(found(&[("_MA", "3")], drill), []);
    // oracle: manual B:4593-4599: a calibration tool is offset whatever its type
    assert_eq!(found(&calibrate("3"), drill), missing);
}

#[test]
fn speeds_and_limits_of_a_turning_spindle() {
    // oracle: manual B:4776-4807, A:15892, A:15910
    let own = |values: &'static [(usize, f64)]| {
        found(ROTATING, |control| {
            control.set("_CBIT[12]", 1.0);
            values.iter().for_each(|(i, value)| control.set(format!("_MFS[{i}]"), *value));
        })
    };
    assert_eq!(own(&[(0, 500.0), (1, 20.0)]), []);
    assert_eq!(own(&[(0, 500.0)]), alarm(61350));
    assert_eq!(own(&[(0, 500.0), (1, 20.0), (2, 300.0)]), alarm(61350));
    assert_eq!(own(&[(0, 500.0), (1, 20.0), (4, 300.0), (5, 5.0)]), doubt(66));
    let three = &[(0, 500.0), (1, 20.0), (2, 300.0), (3, 9.0), (4, 200.0)];
    assert_eq!(own(three), alarm(61350));
    let limit = |name: &'static str, value| found(ROTATING, |control| control.set(name, value));
    assert_eq!(limit("_CM[5]", 5.0), alarm(61366));
    assert_eq!(limit("_CM[3]", 0.0), vec![(Severity::Error, Code::Own(67))]);
    assert_eq!(limit("_CM[6]", 0.5), doubt(68));
    assert_eq!(limit("_CM[7]", 10.0), doubt(69));
    assert_eq!(limit("_CM[7]", 5.0), []);
    assert_eq!(found(RADIUS, |control| control.set("_CM[5]", 5.0)), []);
}

#[test]
fn the_second_feed_factor_counts_behind_the_first_only() {
    // oracle: manual B:4796 (0 in _CM[6]: one probing), B:4800 (_CM[7] only active when _CM[6]>0)
    let factors = |first, second| {
        found(ROTATING, |control| {
            control.set("_CM[6]", first);
            control.set("_CM[7]", second);
        })
    };
    assert_eq!(factors(0.0, 10.0), []);
    assert_eq!(factors(1.0, 1.0), doubt(69));
    assert_eq!(factors(2.0, 1.0), []);
}

#[test]
fn a_spindle_that_stands_needs_a_direction() {
    // oracle: manual B:4783 (also with speeds of the user), B:4807 (one that rotates keeps its direction)
    for own in [0.0, 1.0] {
        let turning_at = |speed: f64| {
            found(ROTATING, |control| {
                control.set("_CBIT[12]", own);
                control.set("_MFS[0]", 500.0);
                control.set("_MFS[1]", 20.0);
                control.set("_CM[5]", 0.0);
                control.spindle_speed = speed;
            })
        };
        assert_eq!(turning_at(0.0), alarm(61366), "{own}");
        assert_eq!(turning_at(700.0), [], "{own}");
        assert_eq!(turning_at(-700.0), [], "{own}");
    }
}

#[test]
fn compensation_needs_its_table() {
    // oracle: manual B:4334-4383
    let with = |table: &'static str, call: &[(&str, &str)]| {
        found(call, |control| {
            control.set("_MT_COMP", 2.0);
            (1..=4).for_each(|i| control.set(format!("{table}[0,{i}]"), f64::from(i) * 5.0));
            (1..=5).for_each(|i| control.set(format!("{table}[{i},0]"), f64::from(i) * 20.0));
        })
    };
    assert_eq!(with("_MT_EC_R", ROTATING), []);
    assert_eq!(with("_MT_EC_L", ROTATING), doubt(71));
    assert_eq!(with("_MT_EC_L", &[("_MVAR", "2")]), []);
    assert_eq!(found(ROTATING, |control| control.set("_MT_COMP", 1.0)), doubt(70));
    let made = |control: &mut Control| {
        control.set("_MT_COMP", 1.0);
        control.set("_TP_CF", 2.0);
    };
    // the table of a make is in no manual, which is reported
    assert_eq!(found(ROTATING, made), vec![(Severity::Note, Code::Own(149))]);
    assert_eq!(found(RADIUS, made), []);
}

#[test]
fn limits_memories_and_positioning() {
    // oracle: manual B:4324-4326, B:13717, B:13726-13733, A:15879-15880
    assert_eq!(found(&[("_TDIF", "2")], |_| ()), doubt(60));
    assert_eq!(found(&[("_TZL", "1.7")], |_| ()), doubt(60));
    assert_eq!(found(&[("_EVNUM", "21")], |_| ()), vec![(Severity::Error, Code::Own(59))]);
    assert_eq!(found(&[("_EVNUM", "990020")], |_| ()), []);
    assert_eq!(found(&[], |control| control.set("_SPEED[0]", -1.0)), alarm(61339));
    assert_eq!(found(&[], |control| control.set("_SPEED[2]", 0.0)), alarm(61338));
    let unmonitored = |control: &mut Control| {
        control.set("_SPEED[2]", 0.0);
        control.set("_CHBIT[2]", 0.0);
    };
    assert_eq!(found(&[], unmonitored), []);
}
