//! What several values of CYCLE997 say together.

use super::params::{ANGLE, DIAMETER, FOUR_POINTS, THREE, TURNED};
use super::points::{CENTRES, sides};
use crate::catalogue::prelude::*;
use crate::catalogue::{circle, spread};
use crate::evaluate::spread::Circle;
use crate::geometry::{V3, fit};
use crate::own::Own;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    shared_checks::mirror(control, found);
    shared_checks::multi_probe(inputs, found);
    let ball = place::ball_radius(inputs, control);
    small(inputs, ball, found);
    if ANGLE.holds(inputs) {
        circle::ball_known(inputs, control, found);
        circle::angles(inputs, FOUR_POINTS.holds(inputs), found);
        around(inputs, found);
    }
    if TURNED.holds(inputs) {
        shared_checks::takes_rotation(names::KNUM, inputs, found);
    }
    if THREE.holds(inputs) {
        triangle(inputs, ball, found);
    }
}

/// The sphere has to be much larger than the ball (B:8229; the factor of two is ours).
fn small(inputs: &Inputs, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(size) = inputs.given(names::SETVAL) else { return };
    if size < 4.0 * ball {
        found.push(own::SPHERE_SMALL.finding().number("size", size).number("ball", 2.0 * ball).at(names::SETVAL));
    }
}

/// The circle of points at an angle; the diameter follows from its centre and one more point in the abscissa (B:8371).
fn around(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let Some(circle) = circle::spread(inputs, FOUR_POINTS.holds(inputs), found) else { return };
    let finding = if DIAMETER.holds(inputs) {
        let diameter = 2.0 * circle.centre[0].hypot(1.0);
        spread::circle(Circle { diameter, ..circle }, names::INCA)
    } else {
        spread::centre(circle, names::INCA)
    };
    found.extend(finding);
}

/// The set centres, where all three are given.
fn centres(inputs: &Inputs) -> Option<[V3; 3]> {
    let [first, second, third] = CENTRES.map(|names| {
        let [x, y, z] = names.map(|name| inputs.given(name));
        Some(V3::new(x?, y?, z?))
    });
    Some([first?, second?, third?])
}

/// A finding about two spheres, which are counted from 0 here.
fn about(sentence: Own, one: usize, other: usize) -> Diagnostic {
    sentence.finding().number("one", (one + 1) as f64).number("other", (other + 1) as f64)
}

/// Three spheres: apart from each other, not on one line, with room for the ball.
fn triangle(inputs: &Inputs, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some((centres, size)) = centres(inputs).zip(inputs.given(names::SETVAL)) else { return };
    for (one, other) in [(0, 1), (0, 2), (1, 2)] {
        let distance = (centres[other] - centres[one]).norm();
        if distance < size {
            let finding = about(own::SPHERES_OVERLAP, one, other).number("distance", distance);
            found.push(finding.hint_number("size", size).at(CENTRES[other][0]));
            return;
        }
    }
    let [.., [third, ..]] = CENTRES;
    if TURNED.holds(inputs) && fit::in_line(centres) {
        found.push(refused(61411, "check-spheres-line", third));
    } else if TURNED.holds(inputs) {
        found.extend(spread::triangle(centres, third));
    }
    found.extend(beside(inputs, &centres, size / 2.0 + ball));
}

/// No measuring block may begin where the ball, whose centre is so far from that of its sphere when it touches, meets
/// another sphere (B:8429, B:8449).
fn beside(inputs: &Inputs, centres: &[V3; 3], touching: f64) -> Option<Diagnostic> {
    let path = inputs.given(names::FA)?;
    let starts = sides(inputs).into_iter().map(|side| {
        let (sin, cos) = side.sin_cos();
        V3::new(cos, sin, 0.0) * (touching + path)
    });
    let starts: Vec<V3> = starts.collect();
    let meets = |one: usize, other: usize| {
        one != other && starts.iter().any(|start| (centres[one] + start - centres[other]).norm() < touching)
    };
    let pairs = (0..3).flat_map(|one| (0..3).map(move |other| (one, other)));
    let (one, other) = pairs.into_iter().find(|(one, other)| meets(*one, *other))?;
    Some(about(own::SPHERES_CLOSE, one, other).at(names::FA))
}
