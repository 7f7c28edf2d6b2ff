//! What several values of CYCLE997 say together.

use super::params::{ANGLE, DIAMETER, FOUR_POINTS, THREE, TURNED};
use super::points::{centres, sides};
use crate::catalogue::prelude::*;
use crate::catalogue::{circle, spread};
use crate::evaluate::spread::Circle;
use crate::geometry::{Degrees, fit};
use nalgebra::Vector3;

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

/// A sphere with its number, and the parameter at which something is said about it.
struct Sphere {
    number: f64,
    centre: Vector3<f64>,
    field: Name,
}

fn spheres(inputs: &Inputs) -> Vec<Sphere> {
    let all = centres(inputs).iter().zip([1.0, 2.0, 3.0]);
    all.filter_map(|([x, y, z], number)| {
        let centre = Vector3::new(inputs.given(*x)?, inputs.given(*y)?, inputs.given(*z)?);
        Some(Sphere { number, centre, field: *x })
    })
    .collect()
}

/// Three spheres: apart from each other, not on one line, with room for the ball.
fn triangle(inputs: &Inputs, ball: f64, found: &mut Vec<Diagnostic>) {
    let (spheres, size) = (spheres(inputs), inputs.given(names::SETVAL));
    let ([first, second, third], Some(size)) = (&spheres[..], size) else { return };
    for (one, other) in [(first, second), (first, third), (second, third)] {
        let distance = (other.centre - one.centre).norm();
        if distance < size {
            let finding = own::SPHERES_OVERLAP.finding().number("one", one.number).number("other", other.number);
            found.push(finding.number("distance", distance).hint_number("size", size).at(other.field));
            return;
        }
    }
    let centres = [first.centre, second.centre, third.centre];
    if TURNED.holds(inputs) && fit::in_line(centres) {
        found.push(refused(61411, "check-spheres-line", third.field));
    } else if TURNED.holds(inputs) {
        found.extend(spread::triangle(centres, third.field));
    }
    beside(inputs, &spheres, size / 2.0, ball, found);
}

/// No measuring block may begin inside of another sphere (B:8429, B:8449).
fn beside(inputs: &Inputs, spheres: &[Sphere], radius: f64, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(path) = inputs.given(names::FA) else { return };
    let starts = |sphere: &Sphere| {
        let centre = sphere.centre;
        sides(inputs).into_iter().map(move |side| {
            let (sin, cos) = Degrees(side).sin_cos();
            centre + Vector3::new(cos, sin, 0.0) * (radius + ball + path)
        })
    };
    for one in spheres {
        let hits = |other: &&Sphere| {
            other.number != one.number && starts(one).any(|start| (start - other.centre).norm() < radius + ball)
        };
        if let Some(other) = spheres.iter().find(hits) {
            let finding = own::SPHERES_CLOSE.finding().number("one", one.number).number("other", other.number);
            found.push(finding.at(names::FA));
            return;
        }
    }
}
