//! What several values of CYCLE961 say together.

use super::corner::PARALLEL;
use super::lines::{Point, away, shares};
use super::params::{DISTANCES, PASSES, PLACES, POINTS, RECTANGLE};
use super::propose::touched;
use crate::catalogue::prelude::*;
use crate::catalogue::spread;
use crate::diagnostic::Severity;

/// How exactly the angles have to be known, degree (B:7923-7924).
const TOLERANCE: f64 = 10.0;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    shared_checks::mirror(control, found);
    shared_checks::multi_probe(inputs, found);
    shared_checks::takes_rotation(names::KNUM, inputs, found);
    shared_checks::lathe_length(inputs, control, found);
    if DISTANCES.holds(inputs) {
        distances(inputs, found);
        directions(inputs, found);
    }
    if PASSES.holds(inputs) {
        passing(inputs, control, found);
    }
    if POINTS.holds(inputs) {
        shared_checks::infeed(inputs, control, found);
        points(inputs, found);
    }
    spreads(inputs, control, found);
}

/// Edges that are touched in places too near to each other, or too far from the corner, for what follows from them.
fn spreads(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let (needed, second): (&[Name], _) = match DISTANCES.holds(inputs) {
        true => (&[names::STA1, names::INCA, names::SETV0, names::SETV1], names::SETV0),
        false => (PLACES.as_flattened(), names::SETV2),
    };
    let wrong = found.iter().any(|one| one.severity == Severity::Error);
    if wrong || needed.iter().any(|name| inputs.given(*name).is_none()) {
        return;
    }
    let touched = touched(inputs, control);
    if let Some(reference) = touched.first_chunk::<2>() {
        found.extend(spread::angle(*reference, second));
    }
    found.extend(spread::corner(&touched, second));
}

/// The points lie in the directions of the edges, so that distances have no sign (A:15889).
fn distances(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    for name in [names::SETV0, names::SETV1] {
        if let Some(distance) = inputs.given(name).filter(|distance| *distance <= 0.0) {
            found.push(refused(61346, "check-corner-distance", name).text("param", name).number("distance", distance));
        }
    }
}

/// Two edges are not one (A:15890), and those of a rectangle stand upright on each other.
fn directions(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let Some(angle) = inputs.given(names::INCA) else { return };
    if angle == 0.0 {
        found.push(refused(61347, "check-corner-straight", names::INCA));
    } else if RECTANGLE.holds(inputs) && (angle.abs() - 90.0).abs() > TOLERANCE {
        found.push(own::CORNER_RECTANGLE.finding().number("angle", angle).at(names::INCA));
    }
}

/// Over the corner the probe rises; 0 leads around it (B:8006-8012).
fn passing(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let down = |lift: &f64| lift * place::side(control) < 0.0;
    if let Some(lift) = inputs.given(names::ID).filter(down) {
        found.push(own::CORNER_LIFT.finding().number("lift", lift).at(names::ID));
    }
}

/// The points P1 to P4 where all are given.
fn given(inputs: &Inputs) -> Option<[Point; 4]> {
    let [p1, p2, p3, p4] = PLACES.map(|[abscissa, ordinate]| inputs.given(abscissa).zip(inputs.given(ordinate)));
    Some([p1?, p2?, p3?, p4?].map(Point::from))
}

/// The four points have to make two lines that meet outside of them (A:15911-15913).
fn points(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let Some([p1, p2, p3, p4]) = given(inputs) else { return };
    for (one, other, at) in [(p1, p2, names::SETV2), (p3, p4, names::SETV6)] {
        if one == other {
            found.push(refused(61367, "check-corner-same", at));
            return;
        }
    }
    let between = |share: f64| (0.0..=1.0).contains(&share);
    found.extend(match shares([p1, p3], [away(p1, p2), away(p3, p4)], PARALLEL) {
        None => Some(refused(61368, "check-corner-parallel", names::SETV6)),
        Some([share, _]) if between(share) => Some(refused(61369, "check-corner-between", names::SETV0)),
        Some([_, share]) if between(share) => Some(refused(61369, "check-corner-between", names::SETV4)),
        Some(_) => None,
    });
    if p2[0] < p1[0] {
        found.push(own::CORNER_TURNED.finding().at(names::SETV2));
    }
}
