//! Errors and warnings of CYCLE994, and what its picture shows.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod simulation;

use super::CYCLE994;
use crate::catalogue::lathe::testing::{call, found, lathe};
use crate::control::Transverse;
use crate::diagnostic::{Code, Severity};
use crate::form::draw;
use crate::picture::ShapeKind;

const ERROR: Severity = Severity::Error;
const WARNING: Severity = Severity::Warning;

#[test]
fn mistakes_are_told() {
    // oracle: manual B:10887-10933, A:15846-15898 for the alarms; hand: ball radius 3 mm on both sides of the diameter
    let (alarm, own) = (Code::Alarm, Code::Own);
    let inside = ("_MVAR", "1");
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_MVAR", "3")], Some((ERROR, alarm(61307), "_MVAR"))),
        (&[("_MA", "0")], Some((ERROR, alarm(61325), "_MA"))),
        (&[("_SETVAL", "0")], Some((WARNING, own(46), "_SETVAL"))),
        (&[("_SETVAL", "-45")], Some((WARNING, own(46), "_SETVAL"))),
        (&[("_SZO", "51")], None),
        (&[("_SZO", "50.9")], Some((WARNING, alarm(61334), "_SZO"))),
        (&[("_SZA", "")], Some((WARNING, own(49), "_SZA"))),
        (&[("_SZO", "")], Some((WARNING, own(49), "_SZO"))),
        (&[inside, ("_SZO", "39")], None),
        (&[inside, ("_SZO", "39.1")], Some((ERROR, alarm(61334), "_SZO"))),
        (&[inside, ("_SZO", "20"), ("_SZA", "")], Some((ERROR, own(1), "_SZA"))),
        (&[inside, ("_SZO", "2"), ("_SETVAL", "6")], Some((ERROR, own(30), "_SETVAL"))),
        // in the abscissa the zone _SZA lies in the measuring axis, and dimensions are radii
        (&[("_MA", "1"), ("_SZA", "48")], None),
        (&[("_MA", "1"), ("_SZA", "47.9")], Some((WARNING, alarm(61334), "_SZA"))),
        (&[inside, ("_MA", "1"), ("_SZA", "42")], None),
        (&[inside, ("_MA", "1"), ("_SZA", "42.1")], Some((ERROR, alarm(61334), "_SZA"))),
    ] {
        let found = found(&CYCLE994, changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn without_diameters_the_ball_takes_its_radius() {
    // oracle: manual B:10975, B:10983-10984, hand: with a ball of 6 mm a radius of 22.5 mm is passed at 25.5 and 19.5
    // mm
    let alarm = Code::Alarm;
    for (changes, wanted) in [
        (vec![("_SZO", "25.5")], None),
        (vec![("_SZO", "25.4")], Some((WARNING, alarm(61334), "_SZO"))),
        (vec![("_MVAR", "1"), ("_SZO", "19.5")], None),
        (vec![("_MVAR", "1"), ("_SZO", "19.6")], Some((ERROR, alarm(61334), "_SZO"))),
    ] {
        let mut all = vec![("_SETVAL", "22.5")];
        all.extend(changes);
        let found = found(&CYCLE994, &all, |control| control.transverse = Transverse::Radius);
        assert_eq!(found, Vec::from_iter(wanted), "{all:?}");
    }
}

#[test]
fn inside_no_zone_is_right() {
    // oracle: manual B:10933, B:11134-11142
    let found = found(&CYCLE994, &[("_SZA", ""), ("_SZO", "")], |_| ());
    assert_eq!(found, [(Severity::Note, Code::Own(48), "")]);
}

#[test]
fn without_calibration_the_ball_diameter_has_to_be_known() {
    // oracle: manual B:10901-10906
    let with = |bit, diameter| {
        found(&CYCLE994, &[("_PRNUM", "2")], |control| {
            control.set("_CHBIT[7]", bit);
            control.set("_WP[1,0]", diameter);
        })
    };
    assert_eq!(with(0.0, 0.0), []);
    assert_eq!(with(1.0, 6.0), []);
    assert_eq!(with(1.0, 0.0), [(ERROR, Code::Own(47), "_PRNUM")]);
}

#[test]
fn y_counts_like_x_where_it_is_told_to() {
    // oracle: manual B:11001, B:14023-14027: _SZO of 50 mm passes a radius of 45 mm, not a diameter of 45 mm
    let with = |bit| {
        let changes = [("_MA", "3"), ("_SZO", "50")];
        found(&CYCLE994, &changes, |control| control.set("_CHBIT[19]", bit))
    };
    assert_eq!(with(0.0), []);
    assert_eq!(with(1.0), [(WARNING, Code::Alarm(61334), "_SZO")]);
}

#[test]
fn the_second_variant_is_drawn_outside_with_and_inside_without_zone() {
    // oracle: manual B:10933
    let zones = |changes: &[(&str, &str)]| {
        let picture = draw(&CYCLE994, &call(&CYCLE994, changes), &lathe()).unwrap();
        let of = |kind| picture.shapes.iter().filter(|shape| shape.kind == kind).count();
        (of(ShapeKind::Zone), of(ShapeKind::Touch))
    };
    assert_eq!(zones(&[]), (1, 4));
    assert_eq!(zones(&[("_MVAR", "1")]), (1, 2));
}
