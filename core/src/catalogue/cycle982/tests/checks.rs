//! The checks of CYCLE982 on a control with probe and tools of the manual's examples (B:9378-9441, B:9526-9580).

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::cycle982::CYCLE982;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, Edge, Plane, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::Typed;

type Values = &'static [(&'static str, &'static str)];
type Found = Vec<(Severity, Code)>;

/// Probe 1, machine and workpiece; the end mill T3 D1 in use, in the plane of a lathe.
fn control() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G18;
    control.set("SD42950", 2.0);
    for (index, value) in [220.0, 200.0, 400.0, 380.0].into_iter().enumerate() {
        control.set(format!("_TP[0,{index}]"), value);
        control.set(format!("_TPW[0,{index}]"), value);
    }
    let edge = Edge { kind: 120, length: [60.0, 10.0, 0.0], radius: 14.0, ..Edge::default() };
    control.tools.entry(3).or_default().edges.insert(1, edge);
    (control.tool, control.edge) = (3, 1);
    control
}

fn edge(control: &mut Control) -> &mut Edge {
    control.edge_of_mut(3, 1).unwrap()
}

fn turning(control: &mut Control) {
    (edge(control).kind, edge(control).tip) = (500, 3);
}

fn drill(control: &mut Control) {
    edge(control).kind = 200;
}

fn spindle_stays(control: &mut Control) {
    control.set("_CHBIT[20]", 1.0);
}

/// Findings of a call like the example's with these values.
fn found(values: &[(&str, &str)], change: impl Fn(&mut Control)) -> Found {
    let typed: Typed = changed(&CYCLE982, values);
    let mut control = control();
    change(&mut control);
    let found = check(&CYCLE982, &typed, &control).diagnostics;
    found.iter().map(|one| (one.severity, one.code)).collect()
}

/// Findings of a variant, measured in the axis that it allows.
fn of_variant(variant: i64, axis: &str, change: impl Fn(&mut Control)) -> Found {
    let number = variant.to_string();
    let call = [("_MVAR", &*number), ("_MA", axis), ("_MD", "1"), ("_CORA", "0")];
    found(&call, change)
}

fn alarm(number: u32) -> Found {
    vec![(Severity::Error, Code::Alarm(number))]
}

fn doubt(number: u16) -> Found {
    vec![(Severity::Warning, Code::Own(number))]
}

fn digit(variant: i64, place: u32) -> i64 {
    variant / 10_i64.pow(place - 1) % 10
}

/// The axis in which the radius of the variant lies, or the ordinate.
fn axis_of(variant: i64) -> &'static str {
    let radial = digit(variant, 4) > 0 && digit(variant, 5) == 1;
    if radial { "1" } else { "2" }
}

#[test]
fn the_calls_of_the_manual_are_right() {
    // oracle: manual B:9400-9430, B:9545-9570, B:9866-9871, A:10087-10118, A:11210-11234
    assert_eq!(found(&[], |_| ()), []);
    let calibrating: Values = &[("_MVAR", "10"), ("_TSA", "5"), ("_FA", "6")];
    for axis in ["1", "2"] {
        let call = [calibrating, &[("_MA", axis)]].concat();
        assert_eq!(found(&call, turning), []);
    }
    for variant in [100_000, 100_001] {
        assert_eq!(of_variant(variant, "2", turning), [], "{variant}");
    }
    assert_eq!(of_variant(1, "2", turning), []);
}

#[test]
fn every_variant_measures_a_milling_tool_but_calibration() {
    // oracle: manual B:9224-9279, B:9330-9338
    for variant in CYCLE982.variants {
        let expected = if variant.number % 10 == 0 { alarm(61314) } else { vec![] };
        let number = variant.number;
        assert_eq!(of_variant(number, axis_of(number), |_| ()), expected, "{number}");
        let driven = |control: &mut Control| edge(control).kind = 720;
        assert_eq!(of_variant(number, axis_of(number), driven), expected, "{number}");
    }
}

#[test]
fn combinations_of_digits_that_do_not_exist_are_refused() {
    // oracle: manual B:9273, A:10287-10316; tests/data/variants_invalid.tsv
    let automatic_in_increments = [100_002, 100_012, 110_102, 103_002];
    let length_and_radius_in_increments = [102_001, 112_011, 102_101];
    let automatic_of_one = [1002, 2002, 11_112, 12_102];
    let one_of_automatic = [3001, 4001, 13_011, 14_101];
    let calibration_of_a_cutter = [100, 1000, 10_000, 110_010, 4010];
    let without_meaning = [3, 21, 201, 5001, 20_001, 200_001, 1_000_001];
    for number in automatic_in_increments
        .into_iter()
        .chain(length_and_radius_in_increments)
        .chain(automatic_of_one)
        .chain(one_of_automatic)
        .chain(calibration_of_a_cutter)
        .chain(without_meaning)
    {
        let call = [("_MVAR", &*number.to_string())];
        let codes = found(&call, |control| control.tool = 0);
        assert_eq!(codes, alarm(61307), "{number}");
    }
}

#[test]
fn the_radius_lies_in_one_axis_only() {
    // oracle: manual B:9279, B:9255-9265 (axial: ordinate, radial: abscissa); 61325 is ours
    for variant in CYCLE982.variants.iter().map(|one| one.number) {
        let radius = digit(variant, 1) == 1 && digit(variant, 4) > 0;
        for axis in ["1", "2"] {
            let right = !radius || axis == axis_of(variant);
            let expected = if right { vec![] } else { alarm(61325) };
            let no_tool = |control: &mut Control| control.tool = 0;
            assert_eq!(of_variant(variant, axis, no_tool), expected, "{variant} {axis}");
        }
    }
    assert_eq!(of_variant(1, "3", |_| ()), alarm(61325));
}

#[test]
fn a_spindle_that_stays_allows_one_point_without_reversal() {
    // oracle: manual B:9275-9277, B:10088-10090: xxx0x1 with x = 0 or 1
    for variant in CYCLE982.variants.iter().map(|one| one.number) {
        if variant % 10 == 0 {
            continue;
        }
        let allowed = digit(variant, 1) == 1 && digit(variant, 3) == 0 && digit(variant, 4) < 2;
        let expected = if allowed { vec![] } else { alarm(61307) };
        let codes = of_variant(variant, axis_of(variant), spindle_stays);
        assert_eq!(codes, expected, "{variant}");
    }
    // oracle: manual B:10092, A:15916
    let fixed = |control: &mut Control| control.spindle_positions = false;
    assert_eq!(found(&[], fixed), alarm(61372));
    // oracle: manual B:9194 (a stationary spindle is positioned at the start angle), B:9610 (one that rotates measures)
    let rotating = |control: &mut Control| {
        fixed(control);
        control.spindle_speed = -200.0;
    };
    assert_eq!(found(&[], rotating), []);
    let both = |control: &mut Control| {
        fixed(control);
        spindle_stays(control);
    };
    assert_eq!(of_variant(1001, "2", both), []);
}

#[test]
fn reversal_needs_a_stationary_spindle_that_can_be_positioned() {
    // oracle: manual B:9600 (the second edge is turned to the probe), B:9604 (a rotating spindle has no certain edge);
    // what the simulation raises in `edges`
    let rotating = |control: &mut Control| control.spindle_speed = 200.0;
    for variant in CYCLE982.variants.iter().map(|one| one.number).filter(|number| digit(*number, 3) == 1) {
        assert_eq!(of_variant(variant, axis_of(variant), rotating), alarm(61307), "{variant}");
        if digit(variant, 4) > 0 {
            continue;
        }
        for change in [rotating, spindle_stays, |control: &mut Control| control.spindle_positions = false] {
            let drill = |control: &mut Control| {
                edge(control).kind = 200;
                change(control);
            };
            assert_eq!(of_variant(variant, axis_of(variant), drill), alarm(61307), "{variant}");
        }
    }
}

#[test]
fn drills_have_no_radius() {
    // oracle: manual B:9136, B:9703; 61314 is ours
    for variant in CYCLE982.variants.iter().map(|one| one.number) {
        if variant % 10 == 0 {
            continue;
        }
        let expected = if digit(variant, 4) > 0 { alarm(61314) } else { vec![] };
        let codes = of_variant(variant, axis_of(variant), drill);
        assert_eq!(codes, expected, "{variant}");
    }
}

#[test]
fn a_tool_touching_with_its_side_needs_its_radius() {
    // oracle: manual B:9206-9208, B:9637; 61351 is ours. Along its axis it needs none (B:9622, B:9628)
    for kind in [120, 200] {
        let thin = |control: &mut Control| (edge(control).kind, edge(control).radius) = (kind, 0.0);
        assert_eq!(of_variant(1, "2", thin), alarm(61351));
        assert_eq!(of_variant(10_001, "1", thin), alarm(61351));
        assert_eq!(of_variant(1, "1", thin), []);
        assert_eq!(of_variant(10_001, "2", thin), []);
    }
    // oracle: manual B:9636: the length has to be known for the radius
    let short = |control: &mut Control| edge(control).length[0] = 0.0;
    assert_eq!(of_variant(1101, "2", short), doubt(76));
    assert_eq!(of_variant(11_101, "1", short), []);
}

#[test]
fn drills_with_their_length_along_the_applicate() {
    // oracle: manual B:10096-10122; 61314 is ours
    for (plane, possible) in [(Plane::G17, true), (Plane::G18, false), (Plane::G19, true)] {
        for variant in CYCLE982.variants.iter().map(|one| one.number) {
            let special = |control: &mut Control| {
                drill(control);
                control.set("SD42950", 0.0);
                control.plane = plane;
            };
            let length = digit(variant, 1) == 1 && digit(variant, 3) == 0 && digit(variant, 4) == 0;
            let expected = if possible && length { vec![] } else { alarm(61314) };
            let codes = of_variant(variant, axis_of(variant), special);
            assert_eq!(codes, expected, "{plane:?} {variant}");
        }
    }
    // oracle: manual B:9507
    let as_milling = |control: &mut Control| control.set("SD42950", 0.0);
    assert_eq!(found(&[], as_milling), [(Severity::Error, Code::Own(75))]);
}

#[test]
fn turning_tools_are_looked_at() {
    // oracle: manual B:4152, B:9702, B:9820-9822, A:15855-15856
    let tip = |tip: i64| {
        move |control: &mut Control| {
            turning(control);
            edge(control).tip = tip;
        }
    };
    assert_eq!(of_variant(0, "1", tip(4)), alarm(61315));
    assert_eq!(of_variant(2, "1", tip(9)), alarm(61315));
    assert_eq!(of_variant(1, "2", tip(7)), alarm(61325));
    assert_eq!(of_variant(2, "2", tip(7)), []);
    assert_eq!(of_variant(1, "1", |control| edge(control).kind = 400), alarm(61314));
    let probe = |control: &mut Control| edge(control).kind = 710;
    assert_eq!(of_variant(1, "1", probe), [(Severity::Warning, Code::Alarm(61314))]);
    // oracle: manual B:9224-9260: digits 3 to 5 count for milling tools
    assert_eq!(of_variant(10_101, "1", turning), doubt(73));
}

#[test]
fn incremental_measurement_goes_the_way_the_tip_points() {
    // oracle: hand, from the sides on which the tips lie (B:4152, B:9441); B:14049-14051 mirrors 1-4, 2-3, 6-8
    let minus = [[2, 3, 7], [3, 4, 8]];
    let plus = [[1, 4, 5], [1, 2, 6]];
    for (index, axis) in ["1", "2"].into_iter().enumerate() {
        for (direction, right, wrong) in [("1", minus, plus), ("0", plus, minus)] {
            let call = |tip: i64, mirrored: f64| {
                let values = [("_MVAR", "100001"), ("_MA", axis), ("_MD", direction)];
                found(&values, |control| {
                    turning(control);
                    edge(control).tip = tip;
                    control.set("_CHBIT[23]", mirrored);
                })
            };
            for tip in right[index] {
                assert_eq!(call(tip, 0.0), [], "{axis} {direction} {tip}");
            }
            for tip in wrong[index] {
                assert_eq!(call(tip, 0.0), doubt(74), "{axis} {direction} {tip}");
                let turned = if axis == "2" { vec![] } else { doubt(74) };
                assert_eq!(call(tip, 1.0), turned, "{axis} {direction} {tip}");
            }
        }
    }
}

#[test]
fn incremental_variants_do_not_look_at_the_stored_probe() {
    // oracle: manual B:9811, B:9909
    let empty = |control: &mut Control| {
        turning(control);
        (0..4).for_each(|i| control.set(format!("_TP[0,{i}]"), 0.0));
    };
    assert_eq!(of_variant(100_000, "1", empty), []);
    assert_eq!(of_variant(0, "1", empty), doubt(61));
    // oracle: manual B:9838, A:15867; 61326 is ours
    let wrong = [("_MVAR", "100001"), ("_MA", "1"), ("_MD", "2")];
    assert_eq!(found(&wrong, turning), alarm(61326));
}

#[test]
fn probe_and_machine_are_looked_at() {
    // oracle: manual B:13345-13348, A:15852, A:15879, B:13602-13608
    let few = |name: &'static str| move |control: &mut Control| control.set(name, 2.0);
    let third: Values = &[("_PRNUM", "3")];
    assert_eq!(found(third, few("_CVAL[0]"))[0], (Severity::Error, Code::Alarm(61313)));
    let workpiece = [third, &[("_MVAR", "12011")]].concat();
    assert_eq!(found(&workpiece, few("_CVAL[3]"))[0], (Severity::Error, Code::Alarm(61313)));
    assert_eq!(found(&[], |control| control.set("_SPEED[1]", 0.0)), alarm(61338));
    let old = |control: &mut Control| control.set("_CBIT[5]", 1.0);
    assert_eq!(found(&[], old), [(Severity::Note, Code::Own(72))]);
    assert_eq!(found(&[("_MVAR", "12011")], old), []);
}
