//! The ways of CYCLE971, and how its spindle turns.

#![allow(clippy::unwrap_used)]

use super::bench::{call, measured, real, setup};
use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, MEASURING_FEED, PLANE_FEED, lettered, same_lettered};
use crate::catalogue::sinumerik::testing::{at, called, close, motions, stopped};
use crate::control::Plane;
use crate::geometry::{Degrees, Mcs};
use crate::machine::{MotionKind, Setup, Sim, Step};
use crate::workpiece::Cutter;

/// The machine with the probe of the manual's examples, at feeds that tell axes apart; the tool at a position of the
/// plane.
fn machine(inputs: &crate::entry::Inputs, from: [f64; 3]) -> Setup {
    let mut setup = setup(inputs);
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    setup.position = Mcs(at(inputs.plane, from));
    setup
}

/// A table of ways in G17: `p` in the plane, `d` along the applicate, `m` measuring, `r` and `s` back.
fn ways(variant: i64, values: &[(&'static str, f64)], from: [f64; 3], wanted: &[(char, [f64; 3])]) -> Sim {
    let inputs = call(variant, Plane::G17, values);
    let sim = measured(&machine(&inputs, from), &inputs);
    same_lettered(&lettered(&sim, Plane::G17), wanted, &format!("{variant} {values:?}"));
    sim
}

#[test]
fn a_side_is_reached_beside_the_probe_and_touched_below_its_edge() {
    // oracle: manual B:4573 (Y to the centre, X to the start of the block, down, 2·_FA, back), B:4611
    ways(
        0,
        &[("_MA", 1.0), ("_FA", 6.0)],
        [70.0, 90.0, 100.0],
        &[
            ('p', [70.0, 31.0, 100.0]),
            ('p', [61.0, 31.0, 100.0]),
            ('d', [61.0, 31.0, 76.0]),
            ('m', [55.0, 31.0, 76.0]),
            ('r', [61.0, 31.0, 76.0]),
        ],
    );
}

#[test]
fn the_middle_is_found_before_the_measuring_axis() {
    // oracle: manual B:4605-4607 (order and height are ours, see DESIGN.md)
    ways(
        0,
        &[("_MA", 102.0), ("_FA", 6.0)],
        [70.0, 90.0, 100.0],
        &[
            ('p', [70.0, 31.0, 100.0]),
            ('p', [61.0, 31.0, 100.0]),
            ('d', [61.0, 31.0, 76.0]),
            ('m', [55.0, 31.0, 76.0]),
            ('r', [61.0, 31.0, 76.0]),
            ('d', [61.0, 31.0, 100.0]),
            ('p', [17.0, 31.0, 100.0]),
            ('d', [17.0, 31.0, 76.0]),
            ('m', [23.0, 31.0, 76.0]),
            ('r', [17.0, 31.0, 76.0]),
            ('d', [17.0, 31.0, 100.0]),
            ('p', [39.0, 31.0, 100.0]),
            ('p', [39.0, 53.0, 100.0]),
            ('d', [39.0, 53.0, 76.0]),
            ('m', [39.0, 47.0, 76.0]),
            ('r', [39.0, 53.0, 76.0]),
        ],
    );
}

#[test]
fn the_upper_side_is_touched_over_the_middle_or_beside_it() {
    // oracle: manual B:4593-4599; the side of the offset is that of the start (ours)
    let above = |x: f64, y: f64| [('p', [x, y, 100.0]), ('d', [x, y, 86.0]), ('m', [x, y, 80.0]), ('s', [x, y, 86.0])];
    let from = [70.0, 90.0, 100.0];
    for number in [3.0, 103.0, 203.0] {
        ways(0, &[("_MA", number), ("_FA", 6.0)], from, &above(39.0, 31.0));
    }
    for (number, x, y) in [(3.0, 54.8, 31.0), (103.0, 54.8, 31.0), (203.0, 39.0, 46.8)] {
        let values = [("_MA", number), ("_FA", 6.0), ("_ID", 2.2)];
        let inputs = call(1, Plane::G17, &values);
        let mut setup = machine(&inputs, from);
        setup.control.edge_of_mut(3, 1).unwrap().radius = 18.0;
        let sim = measured(&setup, &inputs);
        same_lettered(&lettered(&sim, Plane::G17), &above(x, y), "wide");
        // a drill is measured over the middle however wide it is
        setup.control.edge_of_mut(3, 1).unwrap().kind = 200;
        let sim = measured(&setup, &inputs);
        same_lettered(&lettered(&sim, Plane::G17), &above(39.0, 31.0), "drill");
    }
}

#[test]
fn automatic_calibration_touches_in_the_printed_order() {
    // oracle: manual B:4686-4743: -Z, +X, -X, +Y, -Y, -Z; before +X the middle in Y
    let inputs = call(100_000, Plane::G17, &[("_FA", 6.0)]);
    let sim = measured(&machine(&inputs, [39.0, 31.0, 120.0]), &inputs);
    let found = lettered(&sim, Plane::G17);
    let touched: Vec<_> = found.iter().filter(|(letter, _)| *letter == 'm').map(|(_, to)| *to).collect();
    let wanted = [
        [39.0, 31.0, 80.0],
        [39.0, 15.0, 76.0],
        [39.0, 47.0, 76.0],
        [23.0, 31.0, 76.0],
        [55.0, 31.0, 76.0],
        [39.0, 15.0, 76.0],
        [39.0, 47.0, 76.0],
        [39.0, 31.0, 80.0],
    ];
    assert_eq!(touched.len(), wanted.len(), "{touched:?}");
    for (found, wanted) in touched.iter().zip(wanted) {
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9), "{touched:?}");
    }
    assert_eq!(found[0].1, [39.0, 31.0, 86.0]);
    assert!(sim.position.iter().zip([39.0, 31.0, 86.0]).all(|(a, b)| (a - b).abs() < 1e-9));
}

#[test]
fn a_tool_with_a_higher_edge_goes_lower() {
    // oracle: manual B:4849 (`_ID` from the end to the widest place; read as measured upwards)
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        let inputs = call(1, plane, &[("_MA", 2.0), ("_ID", 2.4)]);
        let mut setup = setup(&inputs);
        let cutter = Cutter { chamfer: [1.0, 2.4], ..Cutter::smooth(5.3) };
        real(&mut setup, 70.0, cutter);
        let sim = measured(&setup, &inputs);
        close(&sim, "_OVR[10]", 5.3);
        let [_, _, applicate] = plane.axes();
        let lowest = motions(&sim, Plane::G17, [0.0; 3]).into_iter().map(|(_, to, _)| to[applicate]);
        let top = setup.control.number(&format!("_TP[0,{}]", 2 * applicate));
        assert!((lowest.fold(f64::INFINITY, f64::min) - (top - 6.4)).abs() < 1e-9);
    }
}

/// Speeds and feeds of the probings of a measurement with the spindle turning.
fn probings(values: &[(&'static str, f64)], data: &[(&str, f64)]) -> (Vec<f64>, Vec<f64>, Sim) {
    let mut all = vec![("_MA", 1.0), ("_ID", 0.0)];
    all.extend(values);
    let inputs = call(2, Plane::G17, &all);
    let mut setup = setup(&inputs);
    for (name, value) in data {
        setup.control.set(*name, *value);
    }
    let sim = measured(&setup, &inputs);
    let entries = sim.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    let speeds = steps.clone().filter_map(|step| match step {
        Step::Spin { speed } => Some(*speed),
        _ => None,
    });
    let feeds = steps.filter_map(|step| match step {
        Step::Motion { kind: MotionKind::Measuring, feed, .. } => Some(*feed),
        _ => None,
    });
    (speeds.collect(), feeds.collect(), sim.clone())
}

fn near(found: &[f64], wanted: &[f64]) {
    let same = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(found.len() == wanted.len() && same, "{found:?} {wanted:?}");
}

#[test]
fn speeds_and_feeds_follow_from_the_limits() {
    // oracle: manual B:4284-4310 (90 m/min at 5 mm: 2865/min, 14 mm/min at 0.005 mm), B:4789-4803
    let ninety = [("_CM[0]", 90.0), ("_CM[1]", 5000.0), ("_CM[4]", 500.0), ("_CM[6]", 0.0)];
    let (speeds, feeds, _) = probings(&[], &ninety);
    let n = 90.0 / (0.01 * std::f64::consts::PI);
    assert!((n - 2865.0).abs() < 0.3);
    near(&speeds, &[-n, 0.0]);
    near(&feeds, &[n * 0.005]);
    let (speeds, feeds, _) = probings(&[], &[]);
    near(&speeds, &[-1000.0, 0.0]); // limited by _CM[1]
    near(&feeds, &[20.0, 5.0]); // 10 times 5 mm/min, limited by _CM[4]; then 5
    let (_, feeds, _) = probings(&[], &[("_CM[7]", 2.0), ("_CM[4]", 100.0)]);
    near(&feeds, &[50.0, 10.0, 5.0]);
    let (_, feeds, _) = probings(&[], &[("_CM[2]", 8.0), ("_CM[6]", 0.0)]);
    near(&feeds, &[8.0]);
    let (speeds, _, _) = probings(&[], &[("_CM[5]", 3.0)]);
    near(&speeds, &[1000.0, 0.0]);
    let (_, feeds, _) = probings(&[("_NMSP", 3.0)], &[]);
    near(&feeds, &[20.0, 5.0, 5.0, 5.0]);
}

#[test]
fn own_speeds_and_feeds() {
    // oracle: manual B:4779-4787
    let own = |values: &[f64]| {
        let mut data = vec![("_CBIT[12]".to_owned(), 1.0)];
        data.extend(values.iter().enumerate().map(|(index, value)| (format!("_MFS[{index}]"), *value)));
        let data: Vec<_> = data.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let (speeds, feeds, _) = probings(&[], &data);
        (speeds, feeds)
    };
    let (speeds, feeds) = own(&[500.0, 20.0]);
    near(&speeds, &[-500.0, 0.0]);
    near(&feeds, &[20.0]);
    let (speeds, feeds) = own(&[500.0, 20.0, 300.0, 9.0, 200.0, 4.0]);
    near(&speeds, &[-500.0, -300.0, -200.0, 0.0]);
    near(&feeds, &[20.0, 9.0, 4.0]);
    let (_, feeds) = own(&[500.0, 20.0, 0.0, 9.0, 200.0, 4.0]);
    near(&feeds, &[20.0]);
}

#[test]
fn a_spindle_that_turns_goes_on_in_its_direction() {
    // oracle: manual B:4783, B:4807
    let inputs = call(2, Plane::G17, &[("_MA", 1.0), ("_ID", 0.0)]);
    let mut setup = setup(&inputs);
    setup.control.spindle_speed = 700.0;
    let sim = measured(&setup, &inputs);
    assert_eq!(sim.control.spindle_speed, 1000.0);
    setup.control.set("_CM[5]", 5.0);
    assert!(called(&setup, &inputs).1.is_ok());
    setup.control.spindle_speed = 0.0;
    assert_eq!(stopped(called(&setup, &inputs).1), 61366);
    for (name, value) in [("_CBIT[12]", 1.0), ("_MFS[0]", 500.0), ("_MFS[1]", 20.0)] {
        setup.control.set(name, value);
    }
    assert_eq!(stopped(called(&setup, &inputs).1), 61366);
}

#[test]
fn the_highest_edge_counts_when_the_spindle_turns() {
    // oracle: hand: 0.03 mm runout towards the tooth at 0 degree; the tooth
    // at 0 degree reaches the probe with the spindle at 180
    let cutter = Cutter { teeth: 2, runout: [0.03, 0.02], ..Cutter::smooth(5.0) };
    for (variant, number, result, wanted) in [(2, 1.0, 10, 5.03), (2, 3.0, 8, 70.02), (1, 1.0, 10, 5.03)] {
        let inputs = call(variant, Plane::G17, &[("_MA", number), ("_ID", 0.0)]);
        let mut setup = setup(&inputs);
        setup.control.spindle = Degrees(if variant == 1 { 180.0 } else { 33.0 });
        real(&mut setup, 70.0, cutter.clone());
        let sim = measured(&setup, &inputs);
        close(&sim, &format!("_OVR[{result}]"), wanted);
    }
}

#[test]
fn the_table_takes_off_the_entry_below() {
    // oracle: manual B:4383 (next lower speed and radius; radius and length each by their own table)
    let mut data: Vec<(String, f64)> = vec![("_MT_COMP".to_owned(), 2.0)];
    for (table, scale) in [("_MT_EC_R", 1.0), ("_MT_EC_L", 10.0)] {
        for column in 1..=4 {
            data.push((format!("{table}[0,{column}]"), 2.0 * f64::from(column)));
        }
        for row in 1..=5 {
            data.push((format!("{table}[{row},0]"), 10.0 * f64::from(row)));
            for column in 1..=4 {
                let entry = scale * 0.001 * f64::from(10 * row + column);
                data.push((format!("{table}[{row},{column}]"), entry));
            }
        }
    }
    let with: Vec<_> = data.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    // 1000/min at 5 mm: 31.4 m/min is above the third speed, 5 mm above the second radius
    let (.., sim) = probings(&[], &with);
    close(&sim, "_OVR[10]", 5.0 - 0.032);
    let (.., sim) = probings(&[("_MA", 3.0)], &with);
    close(&sim, "_OVR[8]", 70.0 - 0.32);
    let mut low = with.clone();
    low.push(("_CM[1]", 100.0)); // 3 m/min is below the first speed
    let (.., sim) = probings(&[], &low);
    close(&sim, "_OVR[10]", 5.0);
    let (.., sim) = probings(&[], &[("_MT_COMP", 1.0), ("_TP_CF", 1.0)]);
    close(&sim, "_OVR[10]", 5.0);
    let told = |entry: crate::machine::trace::Entry| {
        matches!(&entry.step,
        Step::Decision { message } if message.key == "evaluate-compensation-make")
    };
    assert!(sim.trace.entries.iter().any(told));
}

#[test]
fn a_start_without_a_side_and_a_tool_of_another_sort_are_refused() {
    // oracle: manual A:15855, A:15875; feeds as in every cycle: 300 mm/min above _FA = 1 (B:2166-2170)
    let inputs = call(0, Plane::G17, &[("_MA", 1.0)]);
    let setup = machine(&inputs, [39.0, 90.0, 100.0]);
    assert_eq!(stopped(called(&setup, &inputs).1), 61332);
    let mut setup = machine(&inputs, [70.0, 90.0, 100.0]);
    setup.control.edge_of_mut(3, 1).unwrap().kind = 710;
    assert_eq!(stopped(called(&setup, &inputs).1), 61314);
    let sim = measured(&machine(&inputs, [70.0, 90.0, 100.0]), &inputs);
    assert!(
        motions(&sim, Plane::G17, [0.0; 3])
            .iter()
            .any(|(kind, _, feed)| *kind == MotionKind::Measuring && *feed == MEASURING_FEED)
    );
}
