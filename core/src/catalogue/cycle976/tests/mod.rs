//! Errors and warnings of CYCLE976, and which results it returns.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod motion;
mod simulate;
mod store;

use super::CYCLE976;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, delivery};
use crate::diagnostic::{Code, Severity};
use crate::entry::{Typed, names};
use crate::form::fields;

/// The worked example with some values changed.
fn values(changes: &[(&str, &str)]) -> Typed {
    changed(&CYCLE976, changes)
}

/// Everything found, on a control that was changed.
fn found(changes: &[(&str, &str)], prepare: impl Fn(&mut Control)) -> Vec<(Severity, Code, &'static str)> {
    let mut control = delivery(CYCLE976.dialect);
    prepare(&mut control);
    let found = check(&CYCLE976, &values(changes), &control).diagnostics;
    found.into_iter().map(|one| (one.severity, one.code, one.param.unwrap().as_str())).collect()
}

#[test]
fn mistakes_are_told() {
    // oracle: manual B:5134, B:5148, B:5222-5256, B:5366, B:5498, A:15842-15917 for the alarms, hand for the rest
    let (error, warning, note) = (Severity::Error, Severity::Warning, Severity::Note);
    let (alarm, own) = (Code::Alarm, Code::Own);
    let surface = |axis, direction| [("_MVAR", "0"), ("_SETVAL", "-20"), ("_MA", axis), ("_MD", direction)];
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_MVAR", "10008"), ("_FA", "55")], None),
        (&[("_SETVAL", "0")], Some((error, own(5), "_SETVAL"))),
        (&[("_SETVAL", "6")], Some((error, own(30), "_SETVAL"))),
        (&[("_SETVAL", "50"), ("_FA", "44")], Some((error, alarm(61302), "_FA"))),
        (&[("_TZL", "1")], Some((error, own(40), "_TZL"))),
        (&[("_MVAR", "8")], Some((note, own(41), "_MVAR"))),
        (&[("_MVAR", "11001")], Some((error, alarm(61307), "_MVAR"))),
        (&[("_MVAR", "2001")], Some((error, own(1), "_MA"))),
        (&[("_MVAR", "2001"), ("_MA", "3")], Some((error, alarm(61325), "_MA"))),
        (&[("_MVAR", "1001"), ("_MA", "1"), ("_MD", "2")], Some((error, alarm(61326), "_MD"))),
        (&[("_MVAR", "100001")], Some((error, own(1), "_STA1"))),
        (&surface("3", "1"), None),
        (&surface("1", "0"), None),
        (&surface("3", "0"), Some((warning, own(42), "_MD"))),
        (&[("_MVAR", "10000"), ("_MA", "2"), ("_MD", "1")], Some((error, alarm(61325), "_MA"))),
    ] {
        let found = found(changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn the_first_calibration_needs_a_wide_safe_area() {
    // oracle: manual B:5148, B:5583
    let erase = |control: &mut Control| {
        (0..7).for_each(|field| control.set(format!("_WP[2,{field}]"), 0.0));
    };
    let narrow = (Severity::Error, Code::Alarm(61303), "_TSA");
    assert_eq!(found(&[], erase), [narrow]);
    assert_eq!(found(&[("_TSA", "3.1")], erase), []);
    let length = [("_MVAR", "10000"), ("_MA", "3"), ("_MD", "1")];
    assert_eq!(found(&length, erase), [narrow]);
    let to_circumference = |control: &mut Control| {
        erase(control);
        control.set("_CBIT[14]", 1.0);
    };
    assert_eq!(found(&length, to_circumference), []);
}

#[test]
fn an_unknown_centre_needs_a_spindle_that_turns() {
    // oracle: manual B:5241, A:15916
    let fixed = |control: &mut Control| control.spindle_positions = false;
    let turned = (Severity::Error, Code::Alarm(61372), "_MVAR");
    assert_eq!(found(&[("_MVAR", "10108")], fixed), [turned]);
    assert_eq!(found(&[], fixed), []);
}

#[test]
fn mirrored_coordinates_are_refused() {
    // oracle: manual B:4153-4154
    let mut control = delivery(CYCLE976.dialect);
    control.active.mirror[1] = true;
    let found = check(&CYCLE976, &values(&[]), &control);
    assert!(found.inputs.is_none());
    let codes: Vec<Code> = found.diagnostics.iter().map(|one| one.code).collect();
    assert_eq!(codes, [Code::Own(144)]);
}

#[test]
fn fields_follow_the_variant() {
    // oracle: manual B:5154-5166, B:5364-5373
    let of = |changes: &[(&str, &str)]| -> Vec<String> {
        let control = delivery(CYCLE976.dialect);
        let all = fields(&CYCLE976, &values(changes), &control);
        all.into_iter().map(|field| field.label.key.into()).collect()
    };
    let known = of(&[]);
    assert_eq!(known[1], "param-setval-ring");
    assert!(!known.iter().any(|label| label.starts_with("param-ma")));
    let one = of(&[("_MVAR", "101001")]);
    for label in ["param-ma-calibrated", "param-md", "param-sta1-calibration"] {
        assert!(one.iter().any(|other| other == label), "{label}");
    }
    let length = of(&[("_MVAR", "10000")]);
    assert_eq!(length[1], "param-setval-surface");
    assert!(length.iter().any(|label| label == "param-fa-length"));
}

/// Indices of the trigger points that a call leaves.
fn triggers(variant: i64, axis: f64, direction: f64) -> Vec<usize> {
    let mut inputs = crate::entry::Inputs::new(&CYCLE976, variant);
    inputs.numbers.extend([(names::MA, axis), (names::MD, direction)]);
    let set = |index: &usize| {
        let name = format!("_OVR[{index}]");
        let mut fields = CYCLE976.results.iter();
        fields.any(|field| field.name == name && field.when.holds(&inputs))
    };
    (8..20).filter(set).collect()
}

#[test]
fn only_calibrated_directions_have_results() {
    // oracle: manual B:5096-5107 with B:5156-5159
    for variant in [1, 10_101, 110_008] {
        assert_eq!(triggers(variant, 0.0, 0.0), Vec::from_iter(8..16));
    }
    assert_eq!(triggers(2101, 1.0, 0.0), [8, 9, 10, 11]);
    assert_eq!(triggers(102_001, 2.0, 0.0), [12, 13, 14, 15]);
    assert_eq!(triggers(1001, 1.0, 0.0), [10, 11]);
    assert_eq!(triggers(1001, 2.0, 1.0), [12, 13]);
    assert_eq!(triggers(0, 3.0, 1.0), [16, 17]);
    assert_eq!(triggers(0, 1.0, 1.0), [8, 9]);
    assert_eq!(triggers(10_000, 3.0, 0.0), [18, 19]);
}
