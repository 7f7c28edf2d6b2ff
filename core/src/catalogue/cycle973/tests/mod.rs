//! Errors and warnings of CYCLE973, which results it returns, and how it is called indirectly.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod simulation;

use super::CYCLE973;
use crate::catalogue::lathe::testing::{call, found, lathe};
use crate::control::Control;
use crate::diagnostic::{Code, Severity};
use crate::entry::{Inputs, Style, names};
use crate::form::draw;
use crate::program::write::snippet;

const ERROR: Severity = Severity::Error;
const WARNING: Severity = Severity::Warning;

/// The groove of the manual's example (B:10281) and one for a probe with position 8 of the same width.
fn grooves(control: &mut Control) {
    for (index, value) in [60.123, 50.054, 15.021, 40.0, 29.931, 25.0, 20.0].iter().enumerate() {
        control.set(format!("_KB[0,{index}]"), *value);
    }
}

/// A call in the groove.
fn groove<'a>(variant: &'a str, axis: &'a str, direction: &'a str) -> [(&'a str, &'a str); 4] {
    [("_MVAR", variant), ("_MA", axis), ("_MD", direction), ("_CALNUM", "1")]
}

#[test]
fn a_surface_and_its_mistakes() {
    // oracle: manual B:10341-10364, A:15846-15876 for the alarms, hand for the rest
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_MA", "3"), ("_MD", "0")], None),
        (&[("_MVAR", "1113")], Some((ERROR, alarm(61307), "_MVAR"))),
        (&[("_SETVAL", "")], Some((ERROR, own(1), "_SETVAL"))),
        (&[("_MD", "2")], Some((ERROR, alarm(61326), "_MD"))),
        (&[("_MD", "0")], Some((WARNING, own(45), "_MD"))),
        (&[("_MA", "2"), ("_MD", "0")], None),
        (&[("_MA", "4")], Some((ERROR, alarm(61325), "_MA"))),
        (&[("_TZL", "1")], Some((ERROR, own(40), "_TZL"))),
        (&[("_PRNUM", "4"), ("_TSA", "4")], Some((ERROR, alarm(61313), "_PRNUM"))),
    ] {
        let found = found(&CYCLE973, changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn a_groove_and_its_mistakes() {
    // oracle: manual B:10145, B:10237-10255, B:13473-13482 (base in minus direction only), A:15856-15876 for the
    // alarms; hand: 10.069 mm wide, ball 6 mm, so 4.069 mm of way
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (tip, changes, wanted) in [
        (7, groove("13", "1", "1"), None),
        (7, groove("1013", "2", "0"), None),
        (7, groove("2013", "2", ""), None),
        (7, groove("12113", "2", ""), None),
        (7, groove("2013", "1", ""), Some((ERROR, alarm(61326), "_MA"))),
        (7, groove("13", "1", "0"), Some((ERROR, alarm(61326), "_MD"))),
        (8, groove("2113", "1", ""), None),
        (8, groove("12013", "2", ""), Some((ERROR, alarm(61326), "_MA"))),
        (8, groove("1013", "2", "0"), Some((ERROR, alarm(61326), "_MD"))),
        (7, groove("2013", "3", ""), Some((ERROR, alarm(61325), "_MA"))),
        (7, groove("1013", "2", ""), Some((ERROR, own(1), "_MD"))),
        (5, groove("13", "1", "1"), Some((ERROR, alarm(61315), "_PRNUM"))),
        (3, groove("13", "1", "1"), Some((ERROR, alarm(61315), "_PRNUM"))),
    ] {
        let found = found(&CYCLE973, &changes, |control| {
            grooves(control);
            control.edge_of_mut(9, 1).unwrap().tip = tip;
        });
        assert_eq!(found, Vec::from_iter(wanted), "{tip} {changes:?}");
    }
    let wide = [&groove("2013", "2", "")[..], &[("_FA", "4.07")]].concat();
    assert_eq!(found(&CYCLE973, &wide, grooves), [(ERROR, alarm(61302), "_FA")]);
}

#[test]
fn the_data_of_the_groove_are_looked_at() {
    // oracle: manual B:10281, B:13347, B:13473-13482, A:15876
    let with = |prepare: fn(&mut Control)| {
        found(&CYCLE973, &groove("13", "1", "1"), |control| {
            grooves(control);
            prepare(control);
        })
    };
    let at = |severity, code| vec![(severity, code, "_CALNUM")];
    assert_eq!(with(|_| ()), []);
    let empty = |control: &mut Control| (0..3).for_each(|i| control.set(format!("_KB[0,{i}]"), 0.0));
    assert_eq!(with(empty), at(WARNING, Code::Own(43)));
    assert_eq!(with(|control| control.set("_KB[0,0]", 50.0)), at(ERROR, Code::Own(44)));
    assert_eq!(with(|control| control.set("_KB[0,0]", 56.0)), at(ERROR, Code::Own(30)));
    assert_eq!(with(|control| control.set("_CVAL[2]", 0.0)), at(ERROR, Code::Alarm(61333)));
}

#[test]
fn the_first_calibration_needs_a_wide_safe_area() {
    // oracle: manual B:10360
    let erase = |control: &mut Control| (0..7).for_each(|i| control.set(format!("_WP[0,{i}]"), 0.0));
    assert_eq!(found(&CYCLE973, &[], erase), [(ERROR, Code::Alarm(61303), "_TSA")]);
    assert_eq!(found(&CYCLE973, &[("_TSA", "3.1")], erase), []);
}

/// Indices of the trigger points and skews that a call leaves.
fn triggers(variant: i64, axis: f64, direction: f64) -> Vec<usize> {
    let mut inputs = Inputs::new(&CYCLE973, variant);
    inputs.numbers.extend([(names::MA, axis), (names::MD, direction)]);
    let set = |index: &usize| {
        let name = format!("_OVR[{index}]");
        let mut fields = CYCLE973.results.iter();
        fields.any(|field| field.name == name && field.when.holds(&inputs))
    };
    (4..22).filter(set).collect()
}

#[test]
fn only_what_was_calibrated_has_results() {
    // oracle: manual B:10189-10200 with B:10250
    assert_eq!(triggers(13, 1.0, 1.0), [8, 9]);
    assert_eq!(triggers(1013, 2.0, 0.0), [14, 15]);
    assert_eq!(triggers(2013, 2.0, 0.0), [12, 13, 14, 15]);
    assert_eq!(triggers(12_113, 1.0, 0.0), [4, 5, 8, 9, 10, 11, 20]);
    assert_eq!(triggers(12_013, 2.0, 0.0), [12, 13, 14, 15, 21]);
    assert_eq!(triggers(0, 3.0, 1.0), [16, 17]);
}

#[test]
fn surface_and_groove_have_calls_of_their_own() {
    // oracle: manual B:11784-11821
    let text = |changes: &[(&str, &str)]| {
        let values = call(&CYCLE973, changes);
        let written = snippet(&CYCLE973, &values, &lathe(), Style::Indirect, None);
        written.text.lines().last().unwrap_or_default().to_owned()
    };
    assert_eq!(text(&[]), "CYCLE_CAL_PROBE(973,-18,1,1,1,0)");
    assert_eq!(text(&groove("12113", "2", "")), "CYCLE_973(,1,2,1,2,,1,1)");
    assert_eq!(text(&groove("13", "1", "1")), "", "the call has no such selection");
}

#[test]
fn both_directions_of_the_abscissa_are_drawn_in_the_other_groove() {
    // oracle: manual B:13473-13482
    let tips = |axis| {
        let picture = draw(&CYCLE973, &call(&CYCLE973, &groove("2013", axis, "")), &lathe()).unwrap();
        let mut texts = picture.shapes.into_iter().filter_map(|shape| shape.text);
        texts.find(|text| text.starts_with("SL"))
    };
    assert_eq!(tips("2").as_deref(), Some("SL 7"));
    assert_eq!(tips("1").as_deref(), Some("SL 8"));
}

#[test]
fn one_direction_is_drawn_in_the_groove_of_the_probe_in_use() {
    // oracle: manual B:13473-13482
    let tips = |tip| {
        let mut control = lathe();
        control.edge_of_mut(9, 1).unwrap().tip = tip;
        let call = call(&CYCLE973, &groove("1013", "1", "1"));
        let picture = draw(&CYCLE973, &call, &control).unwrap();
        let mut texts = picture.shapes.into_iter().filter_map(|shape| shape.text);
        texts.find(|text| text.starts_with("SL"))
    };
    assert_eq!(tips(7).as_deref(), Some("SL 7"));
    assert_eq!(tips(8).as_deref(), Some("SL 8"));
}
