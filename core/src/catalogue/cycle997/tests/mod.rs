//! Errors and warnings of CYCLE997, what it asks for, and where it touches.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod motion;
mod refusal;
mod simulation;

use super::{CYCLE997, points};
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, delivery};
use crate::diagnostic::{Code, Severity};
use crate::entry::{Inputs, Typed, names};
use crate::form::fields;

/// The worked example with some values changed.
fn values(changes: &[(&str, &str)]) -> Typed {
    changed(&CYCLE997, changes)
}

/// Everything found, on a control that was changed.
fn found(changes: &[(&str, &str)], prepare: impl Fn(&mut Control)) -> Vec<(Severity, Code, &'static str)> {
    let mut control = delivery(CYCLE997.dialect);
    prepare(&mut control);
    let found = check(&CYCLE997, &values(changes), &control).diagnostics;
    found.into_iter().map(|one| (one.severity, one.code, one.param.unwrap().as_str())).collect()
}

/// One sphere at an angle: number of the variant, indexing angle.
fn at_angle(variant: &'static str, step: &'static str) -> [(&'static str, &'static str); 4] {
    [("_MVAR", variant), ("_STA1", "10"), ("_INCA", step), ("_RF", "500")]
}

#[test]
fn mistakes_are_told() {
    // oracle: manual B:8199, B:8229, B:8311-8337, B:8415, B:8471, A:15930-15933, hand for the rest
    let (error, warning) = (Severity::Error, Severity::Warning);
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_MVAR", "1111119"), ("_STA1", "0"), ("_RF", "500")], Some((error, own(1), "_INCA"))),
        (&at_angle("1109", "120"), None),
        (&at_angle("101109", "-90"), None),
        (&at_angle("101109", "100"), Some((warning, own(53), "_INCA"))),
        (&at_angle("101109", "120"), Some((error, own(52), "_INCA"))),
        (&at_angle("1109", "180"), Some((error, alarm(61316), "_INCA"))),
        (&[("_SETVAL", "0")], Some((error, alarm(61413), "_SETVAL"))),
        (&[("_SETVAL", "11")], Some((warning, own(93), "_SETVAL"))),
        (&[("_PRNUM", "101")], Some((error, alarm(61313), "_PRNUM"))),
        (&[("_FA", "1")], None),
        (&[("_KNUM", "1051")], Some((error, alarm(61321), "_KNUM"))),
        (&[("_KNUM", "1051"), ("_MVAR", "109")], None),
        (&[("_KNUM", "99999")], Some((error, alarm(61321), "_KNUM"))),
        (&[("_TNVL", "0")], Some((error, own(5), "_TNVL"))),
        (&[("_SETV[3]", "")], Some((error, own(1), "_SETV[3]"))),
        (&[("_SETV[3]", "149")], Some((error, own(94), "_SETV[3]"))),
        (&[("_SETV[6]", "600"), ("_SETV[7]", "140")], Some((error, own(94), "_SETV[6]"))),
        (&[("_SETV[3]", "155")], Some((warning, own(95), "_FA"))),
        // as close, but no point lies towards the other sphere
        (&[("_SETV[3]", "155"), ("_MVAR", "11109"), ("_STA1", "60"), ("_INCA", "30"), ("_RF", "500")], None),
    ] {
        let found = found(changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn three_spheres_on_a_line_do_not_turn_a_frame() {
    // oracle: manual A:15930, hand
    let line = [("_SETV[7]", "100")];
    let refused = (Severity::Error, Code::Alarm(61411), "_SETV[6]");
    assert_eq!(found(&line, |_| ()), [refused]);
    let measured_only = [("_SETV[7]", "100"), ("_KNUM", "0"), ("_TNVL", "")];
    assert_eq!(found(&measured_only, |_| ()), []);
}

#[test]
fn at_an_angle_the_ball_diameter_has_to_be_known() {
    // oracle: manual B:8221
    let unknown = |control: &mut Control| control.set("_WP[0,0]", 0.0);
    let doubt = (Severity::Warning, Code::Own(51), "_PRNUM");
    assert_eq!(found(&at_angle("1109", "120"), unknown), [doubt]);
    assert_eq!(found(&[], unknown), []);
}

/// Names of the fields of a form.
fn form(changes: &[(&str, &str)]) -> Vec<&'static str> {
    let all = fields(&CYCLE997, &values(changes), &delivery(CYCLE997.dialect));
    all.into_iter().map(|field| field.name.as_str()).collect()
}

#[test]
fn fields_follow_the_variant() {
    // oracle: manual B:8309-8333
    let three = form(&[]);
    assert!(three.contains(&"_SETV[8]") && three.contains(&"_TNVL"));
    assert!(!three.contains(&"_STA1"));
    assert!(!form(&[("_KNUM", "0")]).contains(&"_TNVL"));
    let one = form(&at_angle("1109", "90"));
    assert!(!one.contains(&"_SETV[3]") && !one.contains(&"_TNVL"));
    for name in ["_STA1", "_INCA", "_RF"] {
        assert!(one.contains(&name), "{name}");
    }
}

#[test]
fn points_lie_where_the_variant_says() {
    // oracle: manual B:8371, B:8437-8457
    let of = |variant: i64| {
        let mut inputs = Inputs::new(&CYCLE997, variant);
        inputs.numbers.extend([(names::STA1, 10.0), (names::INCA, -60.0)]);
        points::sides(&inputs).into_iter().map(|side| side.0).collect::<Vec<_>>()
    };
    assert_eq!(of(109), [0.0, 180.0, 90.0, 270.0]);
    assert_eq!(of(1_000_109), [0.0, 180.0, 90.0, 270.0]);
    assert_eq!(of(1109), [10.0, -50.0, -110.0]);
    assert_eq!(of(1_101_119), [10.0, -50.0, -110.0, -170.0, 180.0]);
}
