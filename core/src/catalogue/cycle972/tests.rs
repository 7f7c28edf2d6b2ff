//! The checks of CYCLE972 on a control with probe and tools of the manual's example (B:9044-9053).

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::CYCLE972;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, Edge, Plane, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::geometry::Rpy;

/// Probe 1; the turning tool T3 D1 in use, in the plane of a lathe.
fn control() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G18;
    for (index, value) in [220.0, 200.0, 400.0, 380.0].into_iter().enumerate() {
        control.set(format!("_TP[0,{index}]"), value);
    }
    let edge = Edge { kind: 500, tip: 3, length: [100.654, 60.321, 0.0], radius: 2.0, ..Edge::default() };
    control.tools.entry(3).or_default().edges.insert(1, edge);
    (control.tool, control.edge) = (3, 1);
    control
}

/// Findings of a call like the example's with these values.
fn found(values: &[(&str, &str)], change: impl Fn(&mut Control)) -> Vec<(Severity, Code)> {
    let typed: Typed = changed(&CYCLE972, values);
    let mut control = control();
    change(&mut control);
    let found = check(&CYCLE972, &typed, &control).diagnostics;
    found.iter().map(|one| (one.severity, one.code)).collect()
}

fn edge(control: &mut Control) -> &mut Edge {
    control.edge_of_mut(3, 1).unwrap()
}

fn alarm(number: u32) -> Vec<(Severity, Code)> {
    vec![(Severity::Error, Code::Alarm(number))]
}

const CALIBRATE: &[(&str, &str)] = &[("_MVAR", "0")];

#[test]
fn the_calls_of_the_manual_are_right() {
    // oracle: manual B:9053 (its calls name CYCLE982, whose variants 0 and 1 are those of CYCLE972, B:8766-8771)
    for variant in ["0", "1"] {
        for axis in ["1", "2"] {
            assert_eq!(found(&[("_MVAR", variant), ("_MA", axis)], |_| ()), []);
        }
    }
}

#[test]
fn variants_and_axes_that_do_not_exist_are_refused() {
    // oracle: manual B:1854, B:8766-8771; tests/data/variants_invalid.tsv; A:15866
    for number in ["2", "10", "11", "100000", "100001", "-1"] {
        assert_eq!(found(&[("_MVAR", number)], |_| ()), alarm(61307), "{number}");
    }
    for axis in ["0", "3", "102"] {
        assert_eq!(found(&[("_MA", axis)], |_| ()), alarm(61325), "{axis}");
    }
    for path in ["0", "-2"] {
        assert!(found(&[("_FA", path)], |_| ()).contains(&(Severity::Error, Code::Alarm(61308))));
    }
}

#[test]
fn tool_type_and_cutting_edge_position() {
    // oracle: manual B:8834-8839, B:9000-9002, A:15855-15856
    assert_eq!(found(&[], |control| edge(control).kind = 120), alarm(61314));
    let probe = |control: &mut Control| edge(control).kind = 710;
    assert_eq!(found(&[], probe), [(Severity::Warning, Code::Alarm(61314))]);
    for tip in 0..=9 {
        let set = |control: &mut Control| edge(control).tip = tip;
        let calibrating = if tip == 3 { vec![] } else { alarm(61315) };
        assert_eq!(found(CALIBRATE, set), calibrating, "{tip}");
        for axis in [1, 2] {
            // oracle: hand: 5 and 7 lie along the abscissa, 6 and 8 along the ordinate (B:4152, B:9702)
            let expected = match (tip, axis) {
                (0 | 9, _) => alarm(61315),
                (5 | 7, 2) | (6 | 8, 1) => alarm(61325),
                _ => vec![],
            };
            assert_eq!(found(&[("_MA", &axis.to_string())], set), expected, "{tip} {axis}");
        }
    }
}

#[test]
fn probe_and_machine_are_looked_at() {
    // oracle: manual B:8848-8850, B:13345, A:15852, A:15873, A:15879
    assert_eq!(
        found(&[("_PRNUM", "3")], |control| control.set("_CVAL[0]", 2.0))[0],
        (Severity::Error, Code::Alarm(61313))
    );
    let turned = |control: &mut Control| control.active.rotation = Rpy([0.0, 30.0, 0.0]);
    assert_eq!(found(&[], turned), alarm(61330));
    assert_eq!(found(&[], |control| control.set("_SPEED[1]", 0.0)), alarm(61338));
    let exchanged = |control: &mut Control| control.set("_TP[0,3]", 420.0);
    assert_eq!(found(&[], exchanged), [(Severity::Warning, Code::Own(62))]);
    let empty = |control: &mut Control| (0..4).for_each(|i| control.set(format!("_TP[0,{i}]"), 0.0));
    assert_eq!(found(&[], empty), [(Severity::Warning, Code::Own(61))]);
}
