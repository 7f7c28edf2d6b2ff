//! Errors and warnings of CYCLE974, and what its form and its pictures follow.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod simulation;

use super::CYCLE974;
use crate::catalogue::lathe::testing;
use crate::catalogue::lathe::testing::{call, found, lathe};
use crate::control::{Control, Frame, Plane, Transverse};
use crate::diagnostic::{Code, Severity};
use crate::form::{draw, fields};
use crate::geometry::Rpy;
use crate::picture::{Picture, ShapeKind};
use crate::workpiece::Shape;

const ERROR: Severity = Severity::Error;
const WARNING: Severity = Severity::Warning;

#[test]
fn mistakes_are_told() {
    // oracle: manual B:10413-10447, B:10784, A:15846-15916 for the alarms, hand for the rest
    let (alarm, own) = (Code::Alarm, Code::Own);
    let reversal = ("_MVAR", "1000");
    for (changes, wanted) in [
        (&[][..], None),
        (&[reversal, ("_STA1", "0")], None),
        (&[reversal], Some((ERROR, own(1), "_STA1"))),
        (&[reversal, ("_STA1", "361")], Some((ERROR, own(5), "_STA1"))),
        (&[("_MVAR", "10")], Some((ERROR, alarm(61307), "_MVAR"))),
        (&[("_MA", "4")], Some((ERROR, alarm(61325), "_MA"))),
        (&[("_PRNUM", "4")], Some((ERROR, alarm(61313), "_PRNUM"))),
        (&[("_KNUM", "5001")], Some((ERROR, alarm(61322), "_KNUM"))),
        (&[("_TNUM", "")], Some((ERROR, own(1), "_TNUM"))),
        (&[("_K", "0")], Some((ERROR, alarm(61318), "_K"))),
        (&[("_TUL", "-0.02")], Some((ERROR, own(22), "_TUL"))),
        // more than the measuring path switches the monitoring off, B:6486
        (&[("_TSA", "99999")], None),
    ] {
        let found = found(&CYCLE974, changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn probe_and_coordinate_system_have_to_suit() {
    // oracle: manual B:8708, A:15848, A:15856, A:15873, A:15916
    let with = |prepare: fn(&mut Control)| found(&CYCLE974, &[], prepare);
    let edge = |kind, tip| {
        found(&CYCLE974, &[], |control: &mut Control| {
            let edge = control.edge_of_mut(9, 1).unwrap();
            (edge.kind, edge.tip) = (kind, tip);
        })
    };
    assert_eq!(edge(580, 5), []);
    assert_eq!(edge(500, 3), [(ERROR, Code::Alarm(61315), "_PRNUM")]);
    assert_eq!(edge(200, 0), [(ERROR, Code::Alarm(61309), "_PRNUM")]);
    assert_eq!(edge(710, 0), [(WARNING, Code::Alarm(61309), "_PRNUM")]);
    assert_eq!(edge(0, 0), [], "nothing is known about the tool");
    let turned = with(|control| {
        control.program_frame = Frame { rotation: Rpy([0.0, 10.0, 0.0]), ..Frame::default() };
    });
    assert_eq!(turned, [(ERROR, Code::Alarm(61330), "")]);
    let reversal = [("_MVAR", "1000"), ("_STA1", "90")];
    let fixed = found(&CYCLE974, &reversal, |control| control.spindle_positions = false);
    assert_eq!(fixed, [(ERROR, Code::Alarm(61372), "_MVAR")]);
}

#[test]
fn the_setpoint_is_a_diameter_across_the_axis_of_rotation() {
    // oracle: manual B:10623, B:14023-14027 (Y counts like X with _CHBIT[19] in G18)
    let label = |plane, axis: &str, bit: f64| {
        let mut control = lathe();
        control.plane = plane;
        control.set("_CHBIT[19]", bit);
        let fields = fields(&CYCLE974, &call(&CYCLE974, &[("_MA", axis)]), &control);
        let setpoint = fields.into_iter().find(|field| field.name == "_SETVAL");
        setpoint.unwrap().label.key.into_owned()
    };
    let diameter = "param-setval-turned-diameter";
    let position = "param-setval-turned-position";
    for (plane, axis, bit, wanted) in [
        (Plane::G18, "2", 0.0, diameter),
        (Plane::G18, "1", 0.0, position),
        (Plane::G18, "3", 0.0, position),
        (Plane::G18, "3", 1.0, diameter),
        (Plane::G17, "1", 0.0, diameter),
        (Plane::G19, "3", 0.0, diameter),
        (Plane::G17, "2", 1.0, position),
    ] {
        assert_eq!(label(plane, axis, bit), wanted, "{plane:?} {axis} {bit}");
    }
}

#[test]
fn the_picture_follows_axis_and_sign() {
    // oracle: self: another place is measured, so another picture is drawn
    let picture = |changes: &[(&str, &str)]| draw(&CYCLE974, &call(&CYCLE974, changes), &lathe()).unwrap();
    let pictures = [
        picture(&[]),
        picture(&[("_SETVAL", "-45")]),
        picture(&[("_MA", "1")]),
        picture(&[("_MA", "1"), ("_SETVAL", "-45")]),
        picture(&[("_MA", "3")]),
    ];
    for (index, one) in pictures.iter().enumerate() {
        assert!(!pictures[..index].contains(one), "{index}");
    }
}

#[test]
fn the_probe_is_drawn_as_its_cutting_edge_position_says() {
    // oracle: self (another body, another picture); which side: manual B:4152, B:13474-13481
    let picture = |tip: i64| {
        let mut control = lathe();
        control.edge_of_mut(9, 1).unwrap().tip = tip;
        draw(&CYCLE974, &call(&CYCLE974, &[]), &control).unwrap()
    };
    let pictures = [5, 6, 7, 8].map(picture);
    for (index, one) in pictures.iter().enumerate() {
        assert!(!pictures[..index].contains(one), "{index}");
    }
    // of position 7 the body lies to the right of the ball, of 8 above it
    let body = |picture: &Picture| {
        let mut probe = picture.shapes.iter().filter(|shape| shape.kind == ShapeKind::Probe);
        let body = probe.next_back().unwrap().points.iter();
        body.fold([0.0; 2], |[x, y], point| [x + point[0] / 4.0, y + point[1] / 4.0])
    };
    let [_, _, seven, eight] = pictures.each_ref().map(body);
    assert!(seven[0] > eight[0] && eight[1] > seven[1], "{seven:?} {eight:?}");
}

#[test]
fn a_turned_part_is_held_by_a_chuck() {
    // oracle: hand: the part of 60 mm reaches 8 mm into the chuck, which stands out by 20 mm around it
    let setup = testing::setup(Plane::G18, Transverse::Diameter);
    let inputs = testing::inputs("CYCLE974", Plane::G18, &[("_MVAR", 0.0), ("_MA", 2.0), ("_SETVAL", 45.0)]);
    let proposal = (CYCLE974.work().unwrap().propose)(&inputs, &setup.control);
    let (part, chuck) = (&proposal.workpiece.solids[0], &proposal.fixture[0]);
    assert!((chuck.at[2] - (part.at[2] - 52.0)).abs() < 1e-9);
    let size = Shape::Chuck { diameter: 45.0 + 40.0, length: 30.0, grip: 45.0 };
    assert_eq!(chuck.shape, size);
}
