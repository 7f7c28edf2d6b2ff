#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! G110 on the simulated machine.

use super::{BORE, BOSS, G110};
use crate::catalogue::g101::G101;
use crate::catalogue::nct;
use crate::catalogue::nct::bench;
use crate::catalogue::nct::bench::{call, near, typed};
use crate::check::check;
use crate::control::{Frame, Plane};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::geometry::{Rpy, Wcs};
use crate::machine::{Setup, Stop};
use crate::workpiece::{PartErrors, Shape, Solid};
use proptest::prelude::*;

fn codes(values: &[(&str, &str)], plane: Plane) -> Vec<Code> {
    bench::codes(&G110, values, plane)
}

/// G59 at some place of the machine; a bore of 50 (or a boss) displaced in Z-X, the stylus at X120 Z200 Y-10.
fn example(errors: PartErrors, shape: Shape, height: f64) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G18);
    setup.control.frames.insert(6, Frame::translation([11.0, 22.0, 33.0]));
    setup.control.activate(6);
    let at = setup.control.to_machine(Wcs([120.0, 0.0, 200.0]));
    setup.workpiece.solids = vec![Solid { shape, at, rotation: Rpy([0.0, -90.0, -90.0]), errors }];
    setup.position = setup.control.to_machine(Wcs([120.0, height, 200.0]));
    setup
}

fn bore(errors: PartErrors) -> Setup {
    example(errors, Shape::Hole { diameter: 50.0, depth: 30.0 }, -10.0)
}

// oracle: manual C:1159-1176 (first call of the example): G59 moves by centre − (X120, Z200); zero after a second call
#[test]
fn bore_sets_the_work_offset() {
    let setup = bore(PartErrors { shift: [0.3, 0.0, -0.4], size: 0.03, ..PartErrors::default() });
    let outcome = call(&G110, &[("D", "50"), ("S", "6")], &setup);
    assert_eq!(outcome.stop, None);
    near(outcome.control.variable("G59 X").unwrap(), 11.3);
    near(outcome.control.variable("G59 Y").unwrap(), 22.0);
    near(outcome.control.variable("G59 Z").unwrap(), 32.6);
    near(outcome.control.number("DEVIATION"), 0.03);
    near(outcome.control.number("SHIFT_1"), -0.4); // first axis of G18 is Z
    assert_eq!(outcome.position, setup.position);
    let mut again = Setup { control: outcome.control, ..setup };
    again.position = again.control.to_machine(Wcs([120.0, -10.0, 200.0]));
    let second = call(&G110, &[("D", "50"), ("S", "6")], &again);
    near(second.control.number("SHIFT_1"), 0.0);
    near(second.control.number("SHIFT_2"), 0.0);
    near(second.control.variable("G59 X").unwrap(), 11.3);
}

// oracle: manual C:1177-1183 (second call): D1 takes the difference; H0.3 is exceeded by 0.4
#[test]
fn bore_corrects_the_tool() {
    let mut setup = bore(PartErrors { size: -0.4, ..PartErrors::default() });
    setup.control.edge_made(0, 1).radius = 10.0;
    let outcome = call(&G110, &[("D", "50"), ("T", "1"), ("H", "0.3"), ("M", "2")], &setup);
    assert_eq!(outcome.alarms(), vec![nct::OUT_OF_TOLERANCE]);
    near(outcome.control.register(1).total_radius(), 9.8); // metal left: a smaller register cuts more
    near(outcome.control.variable("D2").unwrap(), 0.4); // metal on is positive, C:1093
    assert_eq!(outcome.control.variable("G59 X"), Some(11.0));
    // oracle: self: the bore cut again with the corrected register has its size, and nothing is corrected any more
    let cut = bore(PartErrors { size: -0.4 + 2.0 * 0.2, ..PartErrors::default() });
    let after = call(&G110, &[("D", "50"), ("T", "1"), ("H", "0.3")], &Setup { control: outcome.control, ..cut });
    near(after.control.register(1).total_radius(), 9.8);
    assert!(after.alarms().is_empty());
}

// oracle: manual C:1099, C:1143-1144
#[test]
fn operator_messages() {
    let mut setup = bore(PartErrors { size: 0.6, shift: [0.1, 0.0, 0.0], ..PartErrors::default() });
    let outcome = call(&G110, &[("D", "50"), ("S", "6"), ("U", "0.5")], &setup);
    assert_eq!(outcome.alarms(), vec![nct::UPPER_TOLERANCE]);
    assert_eq!(outcome.control.variable("G59 X"), Some(11.0));
    setup.control.edge_made(0, 1).radius = 24.9;
    let outcome = call(&G110, &[("D", "50"), ("T", "1")], &setup);
    assert_eq!(outcome.alarms(), vec![nct::TOOL_TOO_LARGE]);
    near(outcome.control.register(1).total_radius(), 25.2);
}

// oracle: manual C:1123-1137, and the checks of the worked example
#[test]
fn format_errors() {
    assert_eq!(codes(&[("S", "6")], Plane::G18), vec![nct::FORMAT_ERROR]);
    for wrong in [("S", "7"), ("S", "-1"), ("T", "100"), ("M", "0")] {
        assert_eq!(codes(&[("D", "50"), wrong], Plane::G18), vec![nct::FORMAT_ERROR], "{wrong:?}");
    }
    assert_eq!(codes(&[("D", "50"), ("S", "1"), ("T", "1")], Plane::G18), vec![nct::FORMAT_ERROR]);
    assert!(codes(&[("D", "50"), ("S", "0")], Plane::G17).is_empty());
}

// oracle: manual C:1076: the address of the tool axis of the plane makes a boss, also at 0
#[test]
fn the_tool_axis_makes_a_boss() {
    for (plane, name) in nct::bench::TOOL_AXIS {
        let control = Setup::calibrated(Dialect::Nct, plane).control;
        let variant = |values: &[(&str, &str)]| check(&G110, &typed(values), &control).inputs.unwrap().variant;
        assert_eq!(variant(&[("D", "50")]), BORE);
        assert_eq!(variant(&[("D", "50"), (name, "0")]), BOSS);
        let other = if name == "Z" { "X" } else { "Z" };
        assert_eq!(variant(&[("D", "50"), (other, "-5")]), BORE);
    }
}

// oracle: manual C:1076-1078: R 5 beside the boss, contact at Y-10
#[test]
fn boss_is_touched_from_outside() {
    let errors = PartErrors { shift: [0.2, 0.0, 0.1], size: 0.05, ..PartErrors::default() };
    let setup = example(errors, Shape::Shaft { diameter: 50.0, height: 30.0 }, 20.0);
    let outcome = call(&G110, &[("D", "50"), ("Y", "-10"), ("S", "6"), ("M", "3")], &setup);
    assert_eq!(outcome.stop, None);
    near(outcome.control.variable("G59 X").unwrap(), 11.2);
    near(outcome.control.variable("G59 Z").unwrap(), 33.1);
    near(outcome.control.number("DIAMETER"), 50.05);
    near(outcome.control.variable("D3").unwrap(), 0.05); // a boss too large: metal on
    assert_eq!(outcome.position, setup.position);
}

// oracle: manual C:1130-1137, C:118-123
#[test]
fn errors_stop_the_macro() {
    let stop = |setup: &Setup| call(&G110, &[("D", "50"), ("S", "6")], setup).stop;
    let mut setup = bore(PartErrors::default());
    setup.control.edge = 0;
    assert_eq!(stop(&setup), Some(Stop::Alarm(nct::NO_TOOL_LENGTH)));
    let mut setup = bore(PartErrors::default());
    setup.position[0] += 24.0;
    assert_eq!(stop(&setup), Some(Stop::Alarm(nct::STYLUS_IN_CONTACT)));
    let mut setup = bore(PartErrors::default());
    setup.workpiece.solids.clear();
    assert_eq!(stop(&setup), Some(Stop::Alarm(nct::PROBE_FAIL)));
    let setup = bore(PartErrors { size: 20.1, ..PartErrors::default() });
    assert_eq!(stop(&setup), Some(Stop::Alarm(nct::PROBE_FAIL)));
    let setup = bore(PartErrors { size: 19.9, ..PartErrors::default() });
    assert_eq!(stop(&setup), None);
}

// oracle: manual C:117-123
#[test]
fn a_blocked_positioning_bars_measuring_until_the_next_one() {
    let setup = bore(PartErrors::default());
    let blocked = call(&G101, &[("X", "160")], &setup);
    assert_eq!(blocked.stop, Some(Stop::Alarm(nct::PATH_OBSTRUCTED)));
    let mut setup = Setup { control: blocked.control, ..setup };
    let barred = call(&G110, &[("D", "50")], &setup);
    assert_eq!(barred.stop, Some(Stop::Alarm(nct::OUT_OF_POSITION)));
    let free = call(&G101, &[("X", "121"), ("F", "800")], &setup);
    assert_eq!(free.stop, None);
    near(free.position[0] - setup.position[0], 1.0);
    setup.control = free.control;
    assert_eq!(call(&G110, &[("D", "50")], &setup).stop, None);
}

// oracle: manual C:94: in inches 0.4 inch of overtravel (10.16 mm)
#[test]
fn inch_defaults() {
    let mut setup = bore(PartErrors { size: 20.2, ..PartErrors::default() });
    setup.control.active_units = crate::control::Units::Inch;
    let inches = format!("{}", 50.0 / 25.4);
    let outcome = call(&G110, &[("D", inches.as_str())], &setup);
    assert_eq!(outcome.stop, None);
    near(outcome.control.number("DIAMETER"), 70.2 / 25.4);
}

// oracle: manual C:1103-1116 (columns)
#[test]
fn print_out() {
    let setup = bore(PartErrors { shift: [0.0016, 0.0, -0.0006], size: -0.014, ..PartErrors::default() });
    let values = [("D", "50"), ("S", "6"), ("H", "0.02"), ("V", "2"), ("W", "1")];
    let outcome = call(&G110, &values, &setup);
    assert_eq!(
        outcome.log(),
        [
            "TOOL       NOMINAL    TOLERANCE  DEVIATION",
            "OFFSET NO  DIMENSION             FROM NOMINAL",
            "           50.0000    .0200      - .0140",
            "6          Z 200.0000 - .0006",
            "6          X 120.0000 .0016",
        ]
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: definition: what is put into the part comes out; a calibrated stylus with errors of its own included
    #[test]
    fn errors_of_the_part_are_recovered(
        x in -3.0..3.0, z in -3.0..3.0, size in -1.0..1.0, boss: bool, skew in [-0.2..0.2, -0.2..0.2]
    ) {
        let errors = PartErrors { shift: [x, 0.0, z], size, ..PartErrors::default() };
        let (shape, height) = if boss {
            (Shape::Shaft { diameter: 50.0, height: 30.0 }, 20.0)
        } else {
            (Shape::Hole { diameter: 50.0, depth: 30.0 }, -10.0)
        };
        let mut setup = example(errors, shape, height);
        setup.probe.skew = skew;
        setup.control.set("#504", skew[0]);
        setup.control.set("#505", skew[1]);
        let depth = if boss { "-10" } else { "" };
        let outcome = call(&G110, &[("D", "50"), ("Y", depth)], &setup);
        prop_assert_eq!(&outcome.stop, &None);
        let result = |name: &str| outcome.control.number(name);
        prop_assert!((result("SHIFT_1") - z).abs() < 1e-9, "{}", result("SHIFT_1"));
        prop_assert!((result("SHIFT_2") - x).abs() < 1e-9, "{}", result("SHIFT_2"));
        prop_assert!((result("DEVIATION") - size).abs() < 1e-9, "{} {}", result("DEVIATION"), size);
    }
}

// oracle: manual C:58 (parameter 9050 holds the function that calls O9019), self (the same measurement by its own name)
#[test]
fn a_machine_calls_the_bore_by_another_function() {
    use crate::entry::Style;
    use crate::program::{calls::calls_on, findings_on, write::snippet};
    use crate::run::{Limits, run};
    let delivered = bore(PartErrors { size: 0.03, ..PartErrors::default() });
    let mut other = delivered.clone();
    other.control.set("P9050", 120.0);
    let written = |setup: &Setup| snippet(&G110, &typed(&[("D", "50")]), &setup.control, Style::Direct, None).text;
    assert_eq!((written(&delivered).as_str(), written(&other).as_str()), ("G110 D50\n", "G120 D50\n"));
    let read = |text: &str| crate::syntax::read(Dialect::Nct, text.as_bytes());
    let deviation = |text: &str, setup: &Setup| run(&read(text), setup, Limits::default()).control.number("DEVIATION");
    near(deviation("G59 G18 G120 D50\nM30\n", &other), 0.03);
    near(deviation("G59 G18 G65 P9019 D50\nM30\n", &other), 0.03);
    near(deviation("G59 G18 G110 D50\nM30\n", &other), 0.0);
    let found = calls_on(&read("G120 D50\nG110 D40\n"), other.control.clone());
    let sizes: Vec<_> = found.iter().map(|site| (site.cycle.name, site.values["D"].as_str())).collect();
    assert_eq!(sizes, [("G110", "50")]);
    let told = findings_on(&read("G120 D50\nG110 D40\n"), other.control.clone());
    let mut keys = told.iter().map(|one| one.message.key.as_ref());
    assert_eq!(keys.find(|key| key.starts_with("nct-")), Some("nct-elsewhere"));
}
