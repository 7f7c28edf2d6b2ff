//! Errors and warnings of CYCLE961, and how its calls are written and read.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bench;
mod motion;
mod proposal;
mod simulation;

use super::{CYCLE961, VARIANTS};
use crate::catalogue::example::example;
use crate::check::check;
use crate::control::{Control, Units, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::{Style, Typed, Variant, names};
use crate::form::{Entry, draw, fields};
use crate::name::Name;
use crate::picture::ShapeKind;
use crate::program::calls::calls;
use crate::program::change;
use crate::program::convert::convert;
use crate::program::write::snippet;
use crate::syntax::read;

/// The worked example of the variant that is chosen, else of an outside corner with any angle, with some values
/// changed.
fn typed(changes: &[(&str, &str)]) -> Typed {
    let changes = changes.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
    let changes: Typed = changes.collect();
    let chosen = |variant: &&Variant| changes.get("_MVAR") == Some(&variant.number.to_string());
    let usual = VARIANTS.iter().find(|variant| variant.number == 108);
    let variant = VARIANTS.iter().find(chosen).or(usual);
    let mut typed = example(&CYCLE961, variant.unwrap());
    typed.extend(changes);
    typed
}

/// Everything found in the worked example with some values changed.
fn found(changes: &[(&str, &str)]) -> Vec<(Severity, Code, &'static str)> {
    let found = check(&CYCLE961, &typed(changes), &delivery(CYCLE961.dialect)).diagnostics;
    found.into_iter().map(|one| (one.severity, one.code, one.param.unwrap().as_str())).collect()
}

/// The four places of B:8090-8124.
const POINTS: &[(&str, &str)] = &[("_MVAR", "118")];

/// A corner of a rectangle as the zero point.
const RECTANGLE: &[(&str, &str)] = &[("_MVAR", "106")];

fn with<'a>(base: &[(&'a str, &'a str)], changes: &[(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    [base, changes].concat()
}

#[test]
fn mistakes_with_distances_are_told() {
    // oracle: manual B:7846-7848, B:7917-7935, A:15889-15890 for the alarms, hand for the rest
    let (error, warning) = (Severity::Error, Severity::Warning);
    let (alarm, own) = (Code::Alarm, Code::Own);
    let rectangle = |changes: &[(&'static str, &'static str)]| with(RECTANGLE, changes);
    for (changes, wanted) in [
        (vec![], None),
        (vec![("_ID", "0")], None),
        (vec![("_ID", "-1")], Some((error, own(91), "_ID"))),
        (vec![("_ID", "")], Some((error, own(1), "_ID"))),
        (vec![("_MVAR", "107"), ("_ID", "")], None),
        (vec![("_INCA", "0")], Some((error, alarm(61347), "_INCA"))),
        (vec![("_INCA", "180")], Some((error, own(5), "_INCA"))),
        (vec![("_SETV[0]", "0")], Some((error, alarm(61346), "_SETV[0]"))),
        (vec![("_SETV[1]", "-5")], Some((error, alarm(61346), "_SETV[1]"))),
        (vec![("_PRNUM", "101")], Some((error, alarm(61313), "_PRNUM"))),
        (vec![("_KNUM", "1051")], Some((error, alarm(61321), "_KNUM"))),
        (vec![("_MVAR", "109")], Some((error, alarm(61307), "_MVAR"))),
        (rectangle(&[]), None),
        (rectangle(&[("_INCA", "-101")]), Some((warning, own(90), "_INCA"))),
        (rectangle(&[("_SETV[4]", "")]), Some((error, own(1), "_SETV[4]"))),
        (rectangle(&[("_SETV[4]", "5")]), Some((error, own(5), "_SETV[4]"))),
        (rectangle(&[("_SETV[4]", "1.5")]), Some((error, own(5), "_SETV[4]"))),
        (rectangle(&[("_SETV[4]", "2")]), Some((error, own(1), "_SETV[2]"))),
        (rectangle(&[("_SETV[4]", "4")]), Some((error, own(1), "_SETV[3]"))),
        (rectangle(&[("_SETV[4]", "3"), ("_SETV[2]", "-8"), ("_SETV[3]", "5")]), None),
    ] {
        assert_eq!(found(&changes), Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn mistakes_with_points_are_told() {
    // oracle: manual B:8138-8140, A:15911-15913, hand: the lines of the example meet at 15, 20
    let (error, warning, note) = (Severity::Error, Severity::Warning, Severity::Note);
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_ID", "5")], Some((warning, own(27), "_ID"))),
        (&[("_SETV[2]", "50")], Some((error, alarm(61367), "_SETV[2]"))),
        (&[("_SETV[7]", "40")], Some((error, alarm(61367), "_SETV[6]"))),
        (&[("_SETV[6]", "90"), ("_SETV[7]", "40")], Some((error, alarm(61368), "_SETV[6]"))),
        (&[("_SETV[0]", "10")], Some((error, alarm(61369), "_SETV[0]"))),
        (&[("_SETV[5]", "-40")], Some((error, alarm(61369), "_SETV[4]"))),
        (&[("_SETV[0]", "150"), ("_SETV[2]", "50")], Some((note, own(92), "_SETV[2]"))),
    ] {
        let changes = with(POINTS, changes);
        assert_eq!(found(&changes), Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn a_selection_has_no_unit_but_a_coordinate_has() {
    // oracle: manual B:7931-7935, B:8063
    let mut control: Control = delivery(CYCLE961.dialect);
    control.active_units = Units::Inch;
    let entry = |changes: &[(&str, &str)]| {
        let fields = fields(&CYCLE961, &typed(changes), &control);
        let field = fields.into_iter().find(|one| one.name == "_SETV[4]");
        field.map(|field| (matches!(field.entry, Entry::Choice { .. }), field.unit))
    };
    assert_eq!(entry(RECTANGLE), Some((true, "")));
    assert_eq!(entry(POINTS), Some((false, "inch")));
    assert_eq!(entry(&[]), None);
    let value = |changes: &[(&str, &str)]| {
        let inputs = check(&CYCLE961, &typed(changes), &control).inputs;
        inputs.unwrap().number(names::SETV4)
    };
    assert_eq!(value(&with(RECTANGLE, &[("_SETV[4]", "4"), ("_SETV[3]", "1")])), 4.0);
    assert_eq!(value(&with(POINTS, &[("_ID", "-2")])), 15.0 * 25.4);
}

#[test]
fn places_are_asked_for_in_their_order() {
    // oracle: manual B:8059-8066, B:7929-7935
    for changes in [POINTS, RECTANGLE] {
        let fields = fields(&CYCLE961, &typed(changes), &delivery(CYCLE961.dialect));
        let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
        let setpoints: Vec<&str> = names.into_iter().filter(|name| name.starts_with("_SETV[")).collect();
        let mut sorted = setpoints.clone();
        sorted.sort_unstable();
        assert_eq!(setpoints, sorted);
    }
}

/// Where the dimension line of each coordinate of a place is drawn, from and to.
fn drawn(places: [[f64; 2]; 4]) -> Vec<[[f64; 2]; 2]> {
    let mut values = typed(POINTS);
    for (names, place) in super::params::PLACES.into_iter().zip(places) {
        for (name, value) in names.into_iter().zip(place) {
            values.insert(name.to_string(), value.to_string());
        }
    }
    let control = delivery(CYCLE961.dialect);
    assert!(check(&CYCLE961, &values, &control).inputs.is_some());
    let shapes = draw(&CYCLE961, &values, &control).unwrap().shapes;
    let places = |field: Option<Name>| field.is_some_and(|field| field.starts_with("_SETV["));
    shapes
        .into_iter()
        .filter(|shape| shape.kind == ShapeKind::Dimension && places(shape.field))
        .map(|shape| [shape.points[0], shape.points[1]])
        .collect()
}

#[test]
fn no_two_coordinates_of_the_places_are_drawn_upon_each_other() {
    // oracle: hand (two lines along one axis lie apart, or beside each other)
    for places in [
        [[50.0, 20.0], [150.0, 20.0], [15.0, 40.0], [15.0, 80.0]],
        [[-50.0, -20.0], [-150.0, -20.0], [-15.0, -40.0], [-15.0, -80.0]],
        [[-30.0, 40.0], [-30.0, 140.0], [20.0, -25.0], [100.0, -25.0]],
        [[500.0, 300.0], [620.0, 302.0], [470.0, 340.0], [472.0, 420.0]],
    ] {
        let lines = drawn(places);
        assert_eq!(lines.len(), 8);
        let all = lines.concat();
        let wide = |axis: usize| {
            let values = all.iter().map(|point| point[axis]);
            values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
        };
        let near = wide(0).max(wide(1)) / 20.0;
        for (index, one) in lines.iter().enumerate() {
            for other in &lines[..index] {
                let along = |line: &[[f64; 2]; 2]| usize::from(line[0][0] == line[1][0]);
                let axis = along(one);
                let ends = |line: &[[f64; 2]; 2]| {
                    let [a, b] = line.map(|point| point[axis]);
                    (a.min(b), a.max(b))
                };
                let apart = (one[0][1 - axis] - other[0][1 - axis]).abs() > near;
                let beside = ends(one).1 <= ends(other).0 || ends(other).1 <= ends(one).0;
                assert!(axis != along(other) || apart || beside, "{one:?} {other:?}");
            }
        }
    }
}

#[test]
fn parameterizing_calls() {
    // oracle: manual B:12033-12052, B:12066-12078: the infeed to the points has no sign there
    let written = |changes: &[(&str, &str)]| {
        let control = delivery(CYCLE961.dialect);
        let text = snippet(&CYCLE961, &typed(changes), &control, Style::Indirect, None).text;
        text.lines().last().unwrap().to_owned()
    };
    assert_eq!(written(&[]), "CYCLE_961_W(1,4,100,100,30,-35,80,2,,,,1)");
    let points = "CYCLE_961_P(1,60,50,20,150,20,15,40,15,80,2,1)";
    assert_eq!(written(POINTS), points);
    let program = read(Dialect::Sinumerik, points.as_bytes());
    let site = &calls(&program)[0];
    assert_eq!(site.values["_MVAR"], "118");
    assert_eq!(site.values["_ID"], "-60");
    let applied = |edits: &[change::Edit]| String::from_utf8(change::apply(points.as_bytes(), edits)).unwrap();
    let deeper = applied(&change::change(&program, site, "_ID", "-7.5"));
    assert_eq!(deeper, points.replace("60", "7.5"));
    let direct = applied(&convert(&program, 0, Style::Direct, &delivery(CYCLE961.dialect)).edits);
    assert!(direct.contains("_ID=-60"), "{direct}");
    let computed = "CYCLE_961_P(0,R1,50,20,150,20,15,40,15,80,2,1)";
    let site = &calls(&read(Dialect::Sinumerik, computed.as_bytes()))[0];
    assert_eq!(site.values["_ID"], "-(R1)");
}
