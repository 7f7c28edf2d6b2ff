//! What is drawn of tools, and of what carries them.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;
use crate::control::tools::side;
use crate::workpiece::Cutter;

/// Corners of the insert and of the shank in abscissa and ordinate from P, in G18.
fn plates(position: i64, carrier: V3) -> [Vec<[f64; 2]>; 2] {
    let nose = Nose { radius: 0.8, side: side(position, false) };
    let (drawn, _) = turning_tool(&nose, carrier, Plane::G18);
    [0, 1].map(|index| match &drawn[index] {
        Drawn::Plate { corners, .. } => corners.iter().map(|p| [p.z, p.x]).collect(),
        Drawn::Round { .. } => panic!("an insert is flat"),
    })
}

#[test]
fn an_insert_ends_where_its_edge_touches() {
    // oracle: manual B:9441, B:13474-13481: P lies at the end of the nose in the directions of its position
    for position in 1..=8 {
        let sides = side(position, false);
        let [insert, shank] = plates(position, V3::new(60.0, 0.0, 40.0));
        for axis in 0..2 {
            if sides[axis] == 0.0 {
                continue;
            }
            let reach = |corners: &[[f64; 2]]| {
                let ends = corners.iter().map(|corner| corner[axis] * sides[axis]);
                ends.fold(f64::NEG_INFINITY, f64::max)
            };
            let ahead = reach(&insert);
            assert!((-0.01..=1e-9).contains(&ahead), "{position} {axis} {ahead}");
            assert!(reach(&shank) < -3.0, "{position} {axis}: the shank is clear");
        }
    }
}

#[test]
fn a_shank_leads_to_where_the_tool_is_held() {
    // oracle: hand: a tool that is long in X stands across, one that is long in Z is a boring bar
    for (position, carrier, axis) in [
        (3, [60.0, 40.0], 1),
        (3, [20.0, 120.0], 0),
        (2, [20.0, 120.0], 0),
        (2, [60.0, 40.0], 0), // its nose points towards +X, where no shank can lie
        (8, [60.0, 140.0], 1),
        (7, [60.0, 40.0], 0),
    ] {
        let [_, shank] = plates(position, V3::new(carrier[0], 0.0, carrier[1]));
        let reach = shank.iter().map(|corner| corner[axis]).fold(0.0, f64::max);
        let wanted = carrier[1 - axis];
        assert!((reach - wanted).abs() < 1.0, "{position} {carrier:?} {reach}");
    }
}

#[test]
fn a_groove_mill_hangs_on_a_shank_that_leads_to_its_holder() {
    // oracle: manual B:9779: the upper edge touches, its shank passes the probe
    let mill =
        Tool { length: [40.0, 60.0, 0.0], cut: Cut::Cutter(Cutter { axis: 0, disc: 5.0, ..Cutter::smooth(20.0) }) };
    let carrier = V3::new(40.0, 0.0, 60.0);
    let (drawn, along) = tool(&mill, carrier, Plane::G18, None);
    let [Drawn::Round { axis, outline, .. }, Drawn::Round { axis: shank, outline: neck, .. }] = &drawn[..] else {
        panic!("{drawn:?}");
    };
    assert_eq!((*axis, *shank, along), (-V3::z(), V3::z(), V3::z()));
    let high = |outline: &[[f64; 2]]| outline.iter().map(|at| at[1]).fold(0.0, f64::max);
    assert_eq!((high(outline), high(neck)), (5.0, 60.0));
    assert!(neck.iter().all(|at| at[0] < 5.0), "thinner than the disc");
    let held = turret(&Turret::default(), carrier, along);
    let Drawn::Plate { corners, .. } = &held[0] else {
        panic!("{held:?}");
    };
    let lowest = corners.iter().map(|at| at.z).fold(f64::INFINITY, f64::min);
    assert_eq!(lowest, 44.0, "the holder begins where the shank ends");
}

#[test]
fn a_holder_joins_tool_and_disc() {
    // oracle: hand: the disc stands behind the place where the tool is held, seen from the part
    let carrier = V3::new(60.0, 0.0, 40.0);
    let drawn = turret(&Turret::default(), carrier, V3::x());
    let [Drawn::Plate { corners, .. }, Drawn::Round { at, axis, .. }] = &drawn[..] else {
        panic!("{drawn:?}");
    };
    let ends = |axis: usize| {
        let along = corners.iter().map(|corner| corner[axis]);
        (along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max))
    };
    assert_eq!(ends(0), (44.0, 76.0));
    assert_eq!(ends(2), (-16.0, 56.0));
    assert_eq!((at.z, *axis), (56.0, V3::z()));
    let [short, long] = [100.0, 30.0].map(|length| adapter(length, carrier, V3::z()));
    assert_eq!(short, None, "the probe itself reaches to its holder");
    let Some(Drawn::Round { outline, .. }) = long else {
        panic!("40 mm to the holder, and a probe of 30 mm");
    };
    assert_eq!((outline[0], outline[3]), ([0.0, 27.0], [0.0, 40.0]));
    let none = Turret { diameter: 0.0, ..Turret::default() };
    assert_eq!(turret(&none, carrier, V3::x()), []);
}
