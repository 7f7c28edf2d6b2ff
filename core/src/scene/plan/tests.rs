//! Pictures that follow from the work of a cycle: what they show is carried out, and touched where it is drawn.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::solid::meets;
use super::*;
use crate::catalogue::example::turned;
use crate::catalogue::{CYCLES, find};
use crate::control::{MachineSort, Plane, Transverse, delivery};
use crate::dialect::Dialect;
use crate::entry::{Cycle, How};
use crate::picture::ShapeKind;

/// The worked example of each variant of each cycle whose picture follows from its work, in the usual plane.
fn staged() -> impl Iterator<Item = (Inputs, &'static Staged)> {
    let usual = |cycle: &Cycle| if cycle.purpose.machine == MachineSort::Turning { Plane::G18 } else { Plane::G17 };
    in_planes().filter(move |(inputs, _)| inputs.plane == usual(inputs.cycle))
}

/// The worked examples in every plane, turned parts with diameters.
fn in_planes() -> impl Iterator<Item = (Inputs, &'static Staged)> {
    let all = CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |variant| (*cycle, variant)));
    let all = all.flat_map(|each| [Plane::G17, Plane::G18, Plane::G19].map(|plane| (each, plane)));
    all.filter_map(|((cycle, variant), plane)| {
        let How::Staged(staged) = cycle.picture.how() else { return None };
        let mut control = delivery(cycle.dialect);
        control.plane = plane;
        if cycle.purpose.machine == MachineSort::Turning {
            control.transverse = Transverse::Diameter;
        }
        let values = turned(cycle, &example(cycle, variant), plane);
        Some((check::read(cycle, &values, &control, &mut Vec::new()), staged))
    })
}

// oracle: self (the simulation itself says whether it came to its end)
#[test]
fn every_worked_example_is_carried_out_for_its_picture() {
    for (inputs, staged) in in_planes() {
        for one in tasks(&inputs, staged).iter().map(Performed::of) {
            let told = format!("{} {} {:?}", inputs.cycle.name, inputs.variant, inputs.plane);
            assert!(one.complete && !one.touches.is_empty(), "{told}");
        }
    }
}

// oracle: hand: what touches the side of a part in the plane touches a line of its outline from above
#[test]
fn a_touch_lies_on_an_edge_that_is_drawn() {
    for (inputs, staged) in staged() {
        for one in tasks(&inputs, staged).iter().map(Performed::of) {
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

fn with(inputs: &Inputs, name: Name, value: f64) -> Inputs {
    let mut changed = inputs.clone();
    changed.numbers.insert(name, value);
    changed
}

// oracle: self (a picture that is made anew)
#[test]
fn a_kept_view_shows_what_a_new_one_shows() {
    for (inputs, staged) in staged().filter(|(inputs, _)| inputs.variant == inputs.cycle.variants[0].number) {
        for (name, value) in inputs.numbers.clone() {
            let changed = with(&inputs, name, value * 1.25 + 1.0);
            let kept = [&inputs, &changed, &inputs].map(|inputs| draw(inputs, staged));
            MADE.take();
            assert_eq!(kept[1], draw(&changed, staged), "{} {name}", inputs.cycle.name);
            MADE.take();
            assert_eq!(kept[2], draw(&inputs, staged), "{} {name}", inputs.cycle.name);
        }
    }
}

// oracle: hand: a picture is drawn with a target, limits and a memory of its own
#[test]
fn a_value_that_no_picture_shows_makes_nothing_anew() {
    for (inputs, staged) in staged().filter(|(inputs, _)| inputs.cycle.name == "CYCLE977") {
        let before = Views::of(&inputs, staged);
        for name in [names::KNUM, names::TSA, names::TZL, names::EVNUM] {
            assert!(Rc::ptr_eq(&before, &Views::of(&with(&inputs, name, 0.25), staged)), "{name}");
        }
        assert!(!Rc::ptr_eq(&before, &Views::of(&Inputs { plane: Plane::G18, ..inputs }, staged)));
    }
}

// oracle: hand: a bore of any size has one size on paper
#[test]
fn a_size_that_is_drawn_as_one_makes_nothing_anew() {
    for (inputs, staged) in staged().filter(|(inputs, _)| inputs.cycle.name == "G103") {
        let [one, other] = [30.0, 31.0].map(|size| Views::of(&with(&inputs, address::D, size), staged));
        assert!(Rc::ptr_eq(&one, &other));
    }
}
