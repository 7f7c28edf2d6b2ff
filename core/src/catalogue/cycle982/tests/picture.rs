//! The pictures of CYCLE972 and CYCLE982 for every cutting edge position: which side of the probe is touched, and on
//! which side of it the tool stands.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::cycle972::CYCLE972;
use crate::catalogue::cycle982::CYCLE982;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Edge, Plane, delivery};
use crate::dialect::Dialect;
use crate::entry::{Cycle, names};
use crate::form::draw;
use crate::picture::{PictureShape, ShapeKind};

/// Direction in which the tips of cutting edge positions 1 to 8 point, abscissa and ordinate (B:4152, B:9441,
/// B:13474-13481).
const TIPS: [[f64; 2]; 8] =
    [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

/// What is drawn of a call with a turning tool of this position in use; `mirrored`: `_CHBIT[23]`.
fn drawn(cycle: &'static Cycle, position: i64, mirrored: bool, values: &[(&str, &str)]) -> Vec<PictureShape> {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G18;
    control.set("_CHBIT[23]", f64::from(u8::from(mirrored)));
    for (index, value) in [220.0, 200.0, 400.0, 380.0].into_iter().enumerate() {
        control.set(format!("_TP[0,{index}]"), value);
    }
    let edge = Edge { kind: 500, tip: position, length: [60.0, 40.0, 0.0], radius: 0.8, ..Edge::default() };
    control.tools.entry(3).or_default().edges.insert(1, edge);
    (control.tool, control.edge) = (3, 1);
    let typed = changed(cycle, values);
    let inputs = check(cycle, &typed, &control).inputs;
    assert!(inputs.is_some(), "{} {position} {values:?}", cycle.name);
    draw(cycle, &typed, &control).expect("drawn").shapes
}

/// The touched points in their order.
fn touched(shapes: &[PictureShape]) -> Vec<[f64; 2]> {
    let touches = shapes.iter().filter(|shape| shape.kind == ShapeKind::Touch);
    touches.filter_map(|shape| shape.circle.map(|(centre, _)| centre)).collect()
}

/// Middle of what is drawn of the tool.
fn tool(shapes: &[PictureShape]) -> [f64; 2] {
    let probes = shapes.iter().filter(|shape| shape.kind == ShapeKind::Probe);
    let corners: Vec<_> = probes.flat_map(|shape| &shape.points).collect();
    [0, 1].map(|axis| {
        let along = corners.iter().map(|point| point[axis]);
        (along.clone().fold(f64::INFINITY, f64::min) + along.fold(f64::NEG_INFINITY, f64::max)) / 2.0
    })
}

/// The calls that touch in one axis, in the direction of the tip; the first one knows no mirrored positions.
fn calls(tip: f64) -> [(&'static Cycle, &'static str, &'static str); 3] {
    let towards = if tip > 0.0 { "0" } else { "1" };
    [(&CYCLE972, "1", towards), (&CYCLE982, "1", towards), (&CYCLE982, "100001", towards)]
}

#[test]
fn the_side_that_faces_the_tip_is_touched_and_the_tool_stands_behind_it() {
    // oracle: manual B:9441 (position 3 comes from plus), B:4152, B:14049-14051 (mirrored: 1-4, 2-3, 6-8), B:13882
    // (CYCLE982)
    for (position, mirrored) in (1..=8).flat_map(|position| [(position, false), (position, true)]) {
        let [abscissa, ordinate] = TIPS[usize::try_from(position - 1).unwrap()];
        let turned = [abscissa, if mirrored { -ordinate } else { ordinate }];
        for axis in 0..2 {
            if turned[axis] == 0.0 {
                continue;
            }
            for (cycle, variant, towards) in calls(turned[axis]) {
                let tip = match cycle.name {
                    "CYCLE972" => [abscissa, ordinate],
                    _ => turned,
                };
                let ma = (axis + 1).to_string();
                let mut values = vec![("_MVAR", variant), ("_MA", &*ma)];
                if variant == "100001" {
                    values.push(("_MD", towards));
                }
                let shapes = drawn(cycle, position, mirrored, &values);
                let told = format!("{} {position} {mirrored} {variant} {axis}", cycle.name);
                let mut face = [0.0; 2];
                face[axis] = -10.0 * tip[axis];
                assert_eq!(touched(&shapes), [face], "{told}");
                let body = tool(&shapes);
                assert!(body[axis] * -tip[axis] > 15.0, "{told} {body:?}");
                match tip[1 - axis] {
                    0.0 => assert!(body[1 - axis].abs() < 1e-9, "{told} {body:?}"),
                    other => assert!(body[1 - axis] * -other > 5.0, "{told} {body:?}"),
                }
            }
        }
    }
}

#[test]
fn automatic_measurement_touches_where_there_is_a_tip() {
    // oracle: manual B:9702, B:9738: abscissa first; positions 5 and 7 have L2 only, 6 and 8 L1 only
    for position in 1..=8 {
        let tip = TIPS[usize::try_from(position - 1).unwrap()];
        let shapes = drawn(&CYCLE982, position, false, &[(names::MVAR.as_str(), "2")]);
        let wanted: Vec<[f64; 2]> = [[1.0, 0.0], [0.0, 1.0]]
            .into_iter()
            .zip(tip)
            .filter(|(_, side)| *side != 0.0)
            .map(|(unit, side)| unit.map(|part| part * side * -10.0))
            .collect();
        let touched = touched(&shapes);
        let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9;
        let same = touched.len() == wanted.len() && touched.iter().zip(&wanted).all(|(a, b)| near(a, b));
        assert!(same, "{position}: {touched:?} {wanted:?}");
    }
}
