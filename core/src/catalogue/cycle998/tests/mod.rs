//! Errors and warnings of CYCLE998, and how its calls are written.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod motion;
mod proposal;
mod simulation;

use super::CYCLE998;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, delivery};
use crate::diagnostic::{Code, Severity};
use crate::entry::{Style, Typed};
use crate::form::fields;
use crate::geometry::Degrees;
use crate::program::write::snippet;

/// The worked example with some values changed.
fn values(changes: &[(&str, &str)]) -> Typed {
    changed(&CYCLE998, changes)
}

/// Everything found, on a control that was changed.
fn found(changes: &[(&str, &str)], prepare: impl Fn(&mut Control)) -> Vec<(Severity, Code, &'static str)> {
    let mut control = delivery(CYCLE998.dialect);
    prepare(&mut control);
    let found = check(&CYCLE998, &values(changes), &control).diagnostics;
    found.into_iter().map(|one| (one.severity, one.code, one.param.unwrap().as_str())).collect()
}

/// The oblique plane of B:7624-7694, whose program leaves the setpoint position to an earlier call.
const PLANE: &[(&str, &str)] = &[
    ("_MVAR", "106"),
    ("_SETVAL", "30"),
    ("_ID", "40"),
    ("_SETV[0]", "30"),
    ("_STA1", "8"),
    ("_INCA", "12"),
    ("_FA", "5"),
];

#[test]
fn a_rotary_axis_that_turns_otherwise_is_warned_about() {
    // oracle: hand (a table C turns about Z, so it takes angles between X and Y only; carried by a table A at 90 degree
    // it turns about Y, and those between X and Z)
    use crate::control::Plane::{G17, G18, G19};
    let warned = |plane, axes: &str, tilted: f64| {
        let mut control = delivery(CYCLE998.dialect);
        control.plane = plane;
        control.rotary[0] = Degrees(tilted);
        let found = check(&CYCLE998, &values(&[("_MA", axes), ("_RA", "4")]), &control);
        found.diagnostics.iter().any(|one| one.code == Code::Own(155))
    };
    let across = [(G17, "103"), (G17, "203"), (G18, "102"), (G19, "201")];
    let alike = [(G17, "102"), (G17, "201"), (G18, "203"), (G19, "103")];
    assert!(across.iter().all(|(plane, axes)| warned(*plane, axes, 0.0)));
    assert!(!alike.iter().any(|(plane, axes)| warned(*plane, axes, 0.0)));
    assert!(warned(G17, "102", 90.0) && !warned(G17, "103", 90.0));
}

#[test]
fn mirrored_axes_are_warned_about_where_the_machine_mirrors_otherwise() {
    // oracle: manual B:4154, B:8709
    let warned = |datum: f64, mirrored: bool| {
        let mut control = delivery(CYCLE998.dialect);
        control.set("MD10610", datum);
        control.program_frame.mirror[0] = mirrored;
        let found = check(&CYCLE998, &values(&[]), &control).diagnostics;
        found.iter().any(|one| one.code == Code::Own(154))
    };
    assert!(warned(1.0, true));
    assert!(!warned(0.0, true) && !warned(1.0, false));
}

#[test]
fn mistakes_are_told() {
    // oracle: manual B:7297-7308, B:7403-7412, B:7582, A:15866-15874, A:15908 for the alarms, hand for the rest
    let (error, warning) = (Severity::Error, Severity::Warning);
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_RA", "0")], None),
        (&[("_RA", "2")], Some((error, alarm(61329), "_RA"))),
        (&[("_RA", "5")], Some((error, alarm(61329), "_RA"))),
        (&[("_RA", "-1")], Some((error, alarm(61329), "_RA"))),
        (&[("_RA", "")], Some((error, own(1), "_RA"))),
        (&[("_STA1", "45.5")], Some((error, alarm(61331), "_STA1"))),
        (&[("_ID", "0")], Some((error, alarm(61364), "_ID"))),
        (&[("_MA", "2")], Some((error, alarm(61325), "_MA"))),
        (&[("_MA", "101")], Some((error, alarm(61325), "_MA"))),
        (&[("_MA", "203"), ("_RA", "0")], None),
        (&[("_KNUM", "1051")], Some((error, alarm(61321), "_KNUM"))),
        (&[("_SETVAL", "")], Some((error, own(1), "_SETVAL"))),
        (&[("_EVNUM", "21")], Some((error, own(21), "_EVNUM"))),
        (&[("_EVNUM", "210001")], None), // no mean value (B:1307)
        (&[("_TSA", "31"), ("_FA", "50")], Some((warning, own(7), "_TSA"))),
        (&[("_MVAR", "1105")], None),
        (&[("_MVAR", "1105"), ("_MA", "203"), ("_RA", "0")], Some((error, alarm(61325), "_MA"))),
        (&[("_MVAR", "1105"), ("_PRNUM", "101")], Some((error, alarm(61313), "_PRNUM"))),
        (&[("_MVAR", "100105")], Some((error, own(1), "_MD"))),
        (&[("_MVAR", "100105"), ("_MD", "2")], Some((error, own(5), "_MD"))),
        (&[("_MVAR", "100105"), ("_MD", "0"), ("_SETVAL", "")], None),
        (&[("_MVAR", "106"), ("_INCA", "0")], Some((error, own(1), "_SETV[0]"))),
        (&[("_MVAR", "106"), ("_SETV[0]", "30")], Some((error, own(1), "_INCA"))),
    ] {
        let found = found(changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn points_are_far_enough_apart_for_an_angle() {
    // oracle: hand. Over 100 mm sqrt(2)·100/15 = 9.4 times one point, sqrt(2)·100/14 = 10.1 times; at 40 degree 0.59 of
    // it
    let warned = (Severity::Warning, Code::Own(172), "_ID");
    let unusual = (Severity::Warning, Code::Own(7), "_ID");
    assert_eq!(found(&[("_ID", "15")], |_| ()), []);
    assert_eq!(found(&[("_ID", "14")], |_| ()), [warned]);
    assert_eq!(found(&[("_ID", "14"), ("_STA1", "40")], |_| ()), []);
    assert_eq!(found(&[("_ID", "2")], |_| ()), [unusual, warned]);
}

#[test]
fn the_measuring_path_has_to_bridge_the_safe_area() {
    // oracle: hand. On 40 mm the probe keeps away by 40·tan 5° = 3.50 mm; 5° the other way the surface lies 7.00 mm
    // ahead
    let (error, warning, note) = (Severity::Error, Severity::Warning, Severity::Note);
    for (changes, wanted) in [
        (&[("_FA", "7")][..], None), // 6.9991 mm, advised as 7
        (&[("_FA", "6.99")], Some((note, Code::Own(82), "_FA"))),
        (&[("_FA", "3.51")], Some((note, Code::Own(82), "_FA"))),
        (&[("_FA", "3.49")], Some((warning, Code::Own(81), "_FA"))),
        (&[("_STA1", "-40"), ("_TSA", "30"), ("_FA", "90")], Some((note, Code::Own(82), "_FA"))),
        (&[("_STA1", "-45"), ("_TSA", "45")], Some((warning, Code::Own(7), "_TSA"))),
    ] {
        let found = found(changes, |_| ());
        assert_eq!(found.first().copied(), wanted, "{changes:?}");
    }
    let steep = found(&[("_STA1", "-45"), ("_TSA", "45")], |_| ());
    assert_eq!(steep[1], (error, Code::Own(80), "_TSA"));
    let paraxial = |path| {
        let values = [("_MVAR", "100105"), ("_MD", "0"), ("_STA1", "20"), ("_FA", path)];
        found(&values, |_| ())
    };
    // 40·tan 20° = 14.56 mm
    assert_eq!(paraxial("7.29"), []);
    assert_eq!(paraxial("7.27"), [(warning, Code::Own(83), "_FA")]);
}

#[test]
fn the_oblique_plane_of_the_manual() {
    // oracle: manual B:7670-7674; its path does not reach P2 when the plane is steeper by all of _TSA
    let doubt = (Severity::Note, Code::Own(82), "_FA");
    assert_eq!(found(PLANE, |_| ()), [doubt]);
    let typed = values(PLANE);
    let shown: Vec<&str> =
        fields(&CYCLE998, &typed, &delivery(CYCLE998.dialect)).into_iter().map(|field| field.name.as_str()).collect();
    assert_eq!(
        shown,
        [
            "_MVAR", "_SETVAL", "_ID", "_SETV[0]", "_STA1", "_INCA", "_KNUM", "_PRNUM", "_FA", "_TSA", "_VMS", "_NMSP",
            "_EVNUM"
        ]
    );
}

#[test]
fn labels_follow_the_variant() {
    // oracle: manual B:1307, B:7538-7540, B:7554
    let labels = |changes: &[(&str, &str)]| -> Vec<_> {
        let all = fields(&CYCLE998, &values(changes), &delivery(CYCLE998.dialect));
        all.into_iter().map(|field| field.label.key).collect()
    };
    for (variant, path) in [("105", "param-fa"), ("100105", "param-fa-paraxial"), ("100106", "param-fa-paraxial")] {
        let shown = labels(&[("_MVAR", variant)]);
        assert!(shown.iter().any(|label| label == path), "{variant}");
        assert!(shown.iter().any(|label| label == "param-evnum-tool"), "{variant}");
    }
}

#[test]
fn the_machine_decides() {
    // oracle: manual B:7301-7302, B:7526-7527, A:15916
    let fixed = found(&[("_MVAR", "1105")], |control| {
        control.spindle_positions = false;
    });
    assert_eq!(fixed, [(Severity::Error, Code::Alarm(61372), "_MVAR")]);
    let lathe = |bit: f64| {
        found(&[], |control| {
            control.set("_CBIT[14]", bit);
            (control.tool, control.edge) = (9, 1);
            let edges = &mut control.tools.entry(9).or_default().edges;
            edges.entry(1).or_default().kind = 580;
        })
    };
    assert_eq!(lathe(0.0), []);
    assert_eq!(lathe(1.0), [(Severity::Warning, Code::Own(85), "_PRNUM")]);
}

#[test]
fn lists_are_written() {
    // oracle: manual B:12008-12015; peer (argument order of newer controls)
    let written = |changes: &[(&str, &str)], style| {
        let control = delivery(CYCLE998.dialect);
        snippet(&CYCLE998, &values(changes), &control, style, None).text
    };
    let indirect = written(&[], Style::Indirect);
    assert!(indirect.ends_with("\nCYCLE_998(105,-18,40,4,102,1,0,1)\n"), "{indirect}");
    assert_eq!(written(&[], Style::Operate), "CYCLE998(105,1,4,1,-18,0,,8,5,102,,40,,,,,1,0,1)\n");
    assert_eq!(written(PLANE, Style::Operate), "");
}
