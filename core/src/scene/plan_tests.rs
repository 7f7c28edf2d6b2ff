//! Pictures that follow from the work of a cycle: what they show is carried out, and touched where it is drawn.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;
use crate::catalogue::{CYCLES, find};
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::entry::How;

/// The worked example of each variant of each cycle whose picture follows from its work.
fn staged() -> impl Iterator<Item = (Inputs, &'static Staged)> {
    let all = CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |variant| (*cycle, variant)));
    all.filter_map(|(cycle, variant)| {
        let Some(How::Staged(staged)) = cycle.picture.how() else { return None };
        let mut control = delivery(cycle.dialect);
        if cycle.purpose.machine == MachineSort::Turning {
            (control.plane, control.transverse) = (Plane::G18, Transverse::Diameter);
        }
        Some((check::read(cycle, &example(cycle, variant), &control, &mut Vec::new()), staged))
    })
}

// oracle: self (the simulation itself says whether it came to its end)
#[test]
fn every_worked_example_is_carried_out_for_its_picture() {
    for (inputs, staged) in staged() {
        for one in performed(&inputs, staged) {
            let told = format!("{} {}", inputs.cycle.name, inputs.variant);
            assert!(one.complete && !one.touches.is_empty(), "{told}");
        }
    }
}

// oracle: hand: what touches the side of a part in the plane touches a line of its outline from above
#[test]
fn a_touch_lies_on_an_edge_that_is_drawn() {
    for (inputs, staged) in staged() {
        for one in performed(&inputs, staged) {
            for look in one.staging.looks.iter().filter(|look| look.up[2] == 0.0 && !look.flat) {
                let (_, seen) = one.view(look);
                for touch in &seen.touches {
                    let met = seen.edges.iter().any(|edge| meets(edge, touch.at));
                    assert!(met, "{} {} {touch:?}", inputs.cycle.name, inputs.variant);
                }
            }
        }
    }
}

// oracle: hand: a hole of any size is drawn with a diameter of 100 mm, and the ball touches inside of it
#[test]
fn a_circle_stays_a_circle() {
    let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
    for (inputs, staged) in staged().filter(|(inputs, _)| inputs.cycle.name == cycle.name && inputs.variant == 1) {
        let picture = draw(&inputs, staged);
        let of = |kind| picture.shapes.iter().find(move |shape| shape.kind == kind).unwrap();
        assert_eq!(of(ShapeKind::Edge).circle, Some(([0.0; 2], SIZE / 2.0)));
        assert_eq!(of(ShapeKind::Material).opening, Some(([0.0; 2], SIZE / 2.0)));
    }
}
