//! Right values give no errors, mistakes give the right ones.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod random;

use super::{Checked, check};
use crate::catalogue::example::worked;
use crate::catalogue::find;
use crate::control::{Control, Units, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Typed, names};
use crate::message::Message;
use crate::name::Name;

fn typed(values: &[(&str, &str)]) -> Typed {
    values.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

fn control() -> Control {
    delivery(Dialect::Sinumerik)
}

/// The worked example of a cycle with some values changed; an empty one is taken out.
fn changed(name: &str, changes: &[(&str, &str)]) -> Checked {
    let mut values = worked(cycle(name));
    values.extend(typed(changes));
    check(cycle(name), &values, &control())
}

fn found(checked: &Checked, severity: Severity) -> Vec<(Code, &'static str)> {
    let these = checked.diagnostics.iter().filter(|other| other.severity == severity);
    these.map(|other| (other.code, other.param.map_or("", Name::as_str))).collect()
}

#[test]
fn the_worked_examples_are_right() {
    // oracle: manual B:6101-6114, B:6676-6682
    for cycle in crate::catalogue::CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
        let checked = changed(cycle.name, &[]);
        assert_eq!(found(&checked, Severity::Error), [], "{}", cycle.name);
        assert!(checked.inputs.is_some());
    }
}

#[test]
fn mistakes_of_cycle977() {
    // oracle: manual A:15840-15948 for the alarms, hand for the rest
    let own = Code::Own;
    let alarm = Code::Alarm;
    for (changes, code, param) in [
        (&[("_MVAR", "107")][..], alarm(61307), "_MVAR"),
        (&[("_MVAR", "")], alarm(61307), "_MVAR"),
        (&[("_SETVAL", "")], own(1), "_SETVAL"),
        (&[("_SETVAL", "12x")], own(2), "_SETVAL"),
        (&[("_SETVAL", "NaN")], own(2), "_SETVAL"),
        (&[("_SETVAL", "inf")], own(2), "_SETVAL"),
        (&[("_SETVAL", "1e308")], own(5), "_SETVAL"),
        (&[("_SETVAL", "0")], own(5), "_SETVAL"),
        (&[("_SETVAL", "5,5")], own(30), "_SETVAL"),
        (&[("_FA", "0")], alarm(61308), "_FA"),
        (&[("_FA", "127")], alarm(61302), "_FA"),
        (&[("_K", "0")], alarm(61318), "_K"),
        (&[("_K", "1.5")], own(4), "_K"),
        (&[("_PRNUM", "4")], alarm(61313), "_PRNUM"),
        (&[("_PRNUM", "100")], alarm(61313), "_PRNUM"),
        (&[("_PRNUM", "301")], alarm(61313), "_PRNUM"),
        (&[("_EVNUM", "21")], own(21), "_EVNUM"),
        (&[("_EVNUM", "210001")], own(21), "_EVNUM"),
        (&[("_TUL", "-0,05")], own(22), "_TUL"),
        (&[("_KNUM", "3001")], alarm(61322), "_KNUM"),
        (&[("_KNUM", "22001")], alarm(61323), "_KNUM"),
        (&[("_KNUM", "500001")], alarm(61324), "_KNUM"),
        (&[("_KNUM", "4000001")], alarm(61407), "_KNUM"),
        (&[("_KNUM", "2000")], alarm(61328), "_KNUM"),
        (&[("_KNUM", "11")], alarm(61345), "_KNUM"),
        (&[("_KNUM", "9999")], alarm(61322), "_KNUM"),
        (&[("_MVAR", "101")], alarm(61321), "_KNUM"),
        (&[("_TNUM", "")], own(1), "_TNUM"),
        (&[("_KNUM", "1002001")], own(1), "_DLNUM"),
        (&[("_KNUM", "1002001"), ("_DLNUM", "7")], alarm(61406), "_DLNUM"),
        (&[("_MVAR", "3")], own(1), "_MA"),
        (&[("_MVAR", "3"), ("_MA", "3")], alarm(61325), "_MA"),
        (&[("_MVAR", "2")], own(1), "_ID"),
        (&[("_MVAR", "1001"), ("_ID", "-20"), ("_SZA", "132")], alarm(61334), "_SZA"),
        (&[("_MVAR", "1001"), ("_ID", "-20"), ("_SZA", "125")], alarm(61334), "_SZA"),
        (&[("_MVAR", "1002"), ("_ID", "-20"), ("_SZA", "100")], alarm(61334), "_SZA"),
        (&[("_MVAR", "1002"), ("_ID", "-20"), ("_SZA", "0")], alarm(61334), "_SZA"),
    ] {
        let checked = changed("CYCLE977", changes);
        assert_eq!(found(&checked, Severity::Error), [(code, param)], "{changes:?}");
        assert!(checked.inputs.is_none(), "{changes:?}");
        let cures = checked.diagnostics.iter().filter(|other| other.severity == Severity::Error);
        assert!(cures.clone().all(|other| other.hint.is_some()), "{changes:?}");
    }
}

#[test]
fn mistakes_of_cycle978() {
    // oracle: manual B:6308, B:6418 (alarms are our proposal)
    let differential = [("_MVAR", "1000"), ("_PRNUM", "101")];
    let checked = changed("CYCLE978", &differential);
    assert_eq!(found(&checked, Severity::Error), [(Code::Alarm(61313), "_PRNUM")]);
    let checked = changed("CYCLE978", &[("_MVAR", "1100"), ("_KNUM", "1"), ("_MA", "3")]);
    assert_eq!(found(&checked, Severity::Error), [(Code::Alarm(61325), "_MA")]);
    let checked = changed("CYCLE978", &[("_MVAR", "100"), ("_KNUM", "2001")]);
    assert_eq!(found(&checked, Severity::Error), [(Code::Alarm(61321), "_KNUM")]);
}

#[test]
fn what_the_machine_lacks_is_told_at_the_field() {
    // oracle: manual A:15916-15917, A:15927-15928, B:1984
    let case = |name: &str, changes: &[(&str, &str)], lack: fn(&mut Control)| {
        let mut control = control();
        lack(&mut control);
        let mut values = worked(cycle(name));
        values.extend(typed(changes));
        found(&check(cycle(name), &values, &control), Severity::Error)
    };
    let alarm = Code::Alarm;
    let spindle: fn(&mut Control) = |control| control.spindle_positions = false;
    let mono = case("CYCLE977", &[("_PRNUM", "101"), ("_CORA", "0")], spindle);
    assert_eq!(mono, [(alarm(61373), "_PRNUM")]);
    let differential = case("CYCLE978", &[("_MVAR", "1000")], spindle);
    assert_eq!(differential, [(alarm(61372), "_MVAR")]);
    let additive = [("_KNUM", "1002001"), ("_DLNUM", "1")];
    let found = case("CYCLE977", &additive, |control| control.set("MD18080", 0.0));
    assert_eq!(found, [(alarm(61408), "_KNUM")]);
    let found = case("CYCLE977", &additive, |control| {
        control.set("MD18112", 0.0);
        control.set("_CHBIT[6]", 1.0);
    });
    assert_eq!(found, [(alarm(61409), "_KNUM")]);
    let system = [("_MVAR", "101"), ("_KNUM", "2000")];
    let found = case("CYCLE977", &system, |control| control.set("MD28082", 32.0));
    assert_eq!(found, [(alarm(61321), "_KNUM")]);
}

// oracle: manual B:6486 ("should not be monitored. Therefore _TSA > _FA is set"), B:2201 (any value)
#[test]
fn a_safe_area_beyond_the_measuring_path_switches_the_monitoring_off() {
    for (name, area) in [
        ("CYCLE977", "6"),
        ("CYCLE978", "6"),
        ("CYCLE979", "500"),
        ("CYCLE977", "9999999999"),
        ("CYCLE997", "9999999999"),
    ] {
        let checked = changed(name, &[("_TSA", area)]);
        for severity in [Severity::Error, Severity::Warning] {
            assert_eq!(found(&checked, severity), [], "{name} {area}");
        }
        let inputs = checked.inputs.unwrap();
        assert_eq!(inputs.number(names::TSA), area.parse::<f64>().unwrap());
    }
    // what is driven stays within the machine
    let checked = changed("CYCLE977", &[("_FA", "9999999999")]);
    assert_eq!(found(&checked, Severity::Error), [(Code::Own(5), "_FA")]);
}

// oracle: hand (what nobody wrote is nobody's mistake)
#[test]
fn the_delivered_dimension_difference_is_not_warned_about() {
    let warned = |changes: &[(&str, &str)]| {
        let checked = changed("CYCLE977", changes);
        checked.diagnostics.iter().any(|one| one.code == Code::Own(25))
    };
    assert!(!warned(&[("_TDIF", ""), ("_TSA", "1")]));
    assert!(warned(&[("_TDIF", "1.2"), ("_TSA", "1")]));
}

#[test]
fn doubts() {
    // oracle: manual B:1310-1394, B:5801-5809, B:15629
    for (name, changes, code, param) in [
        ("CYCLE977", &[("_TDIF", "0.02"), ("_TMV", "0.02")][..], 23, "_TDIF"),
        ("CYCLE977", &[("_TZL", "0.5")], 24, "_TMV"),
        ("CYCLE977", &[("_TDIF", "1.5")], 25, "_TSA"),
        ("CYCLE977", &[("_MVAR", "2"), ("_ID", "20")], 27, "_ID"),
        ("CYCLE977", &[("_PRNUM", "101")], 8, "_CORA"),
        ("CYCLE977", &[("_FA", "0.5"), ("_TSA", "0.9")], 7, "_FA"),
        ("CYCLE977", &[("_MVAR", "1001"), ("_ID", "-20"), ("_SZA", "119")], 31, "_FA"),
    ] {
        let checked = changed(name, changes);
        assert_eq!(found(&checked, Severity::Warning), [(Code::Own(code), param)], "{changes:?}");
        assert!(checked.inputs.is_some());
    }
}

#[test]
fn units_are_converted_once() {
    // oracle: manual B:1787-1795
    let mut control = control();
    (control.active_units, control.basic_units) = (Units::Inch, Units::Inch);
    control.set("_WP[0,0]", 0.25); // ball, inch
    let values = typed(&[("_MVAR", "1"), ("_SETVAL", "2"), ("_KNUM", "0"), ("_FA", "3"), ("_VMS", "10")]);
    let inputs = check(cycle("CYCLE977"), &values, &control).inputs.unwrap();
    assert_eq!(inputs.number(names::SETVAL), 50.8);
    assert_eq!(inputs.number(names::FA), 3.0);
    assert_eq!(inputs.number(names::VMS), 254.0);
    control.basic_units = Units::Metric;
    let inputs = check(cycle("CYCLE977"), &values, &control).inputs.unwrap();
    assert_eq!(inputs.number(names::VMS), 10.0);
    assert_eq!(inputs.number(names::SETVAL), 50.8);
}

#[test]
fn expressions_are_left_to_the_run() {
    // oracle: hand
    let checked = changed("CYCLE977", &[("_SETVAL", "R10*2")]);
    assert_eq!(found(&checked, Severity::Error), []);
    assert!(checked.inputs.is_none());
}

#[test]
fn a_wrong_variant_names_those_close_to_it() {
    // oracle: hand (B:5066-5084: one direction cannot tell the skew)
    let hint = |variant: &str| {
        let found = changed("CYCLE976", &[("_MVAR", variant)]).diagnostics;
        found[0].hint.clone().unwrap()
    };
    let near = |text: &str| Message::new("check-variant-near-hint").text("near", text);
    assert_eq!(hint("11001"), near("1001, 10001, 12001"));
    assert_eq!(hint("10100"), near("10101, 10108, 10000"));
    for far in ["-1", "99999999"] {
        assert_eq!(hint(far), Message::new("check-variant-hint"), "{far}");
    }
}
