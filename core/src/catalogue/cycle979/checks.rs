//! What several values of CYCLE979 say together.

use super::params::{FOUR_POINTS, OUTSIDE, ROUND, WEB};
use crate::catalogue::prelude::*;
use crate::catalogue::{circle, spread};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::measuring(inputs, control, found);
    circle::ball_known(inputs, control, found);
    let ball = place::ball_radius(inputs, control);
    if ROUND.holds(inputs) {
        let four = FOUR_POINTS.holds(inputs);
        circle::angles(inputs, four, found);
        let spread = circle::spread(inputs, four, found);
        found.extend(spread.and_then(|circle| spread::circle(circle, names::INCA)));
    } else if FOUR_POINTS.holds(inputs) {
        found.push(own::POINTS_UNUSED.finding().at(names::PRNUM));
    }
    if !OUTSIDE.holds(inputs) {
        inside(inputs, ball, found);
    }
    if WEB.holds(inputs) {
        lift(inputs, control, ball, found);
    }
}

/// In a hole or groove the ball has to fit and to have its way; in a hole it goes round between centre and wall.
fn inside(inputs: &Inputs, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(size) = inputs.given(names::SETVAL) else { return };
    if !shared_checks::fits(names::SETVAL, size, ball, found) {
        return;
    }
    let (free, path) = (size / 2.0 - ball, inputs.given(names::FA));
    let beyond = |path: f64| (free..2.0 * free).contains(&path);
    if ROUND.holds(inputs) && path.is_some_and(beyond) {
        found.push(own::PATH_CENTRE.finding().hint_number("free", free).at(names::FA));
    }
    shared_checks::across(inputs, names::SETVAL, size, ball, found);
}

/// The way over a web (B:6921-6929).
fn lift(inputs: &Inputs, control: &Control, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(lift) = inputs.given(names::ID) else { return };
    let lift = lift * place::side(control);
    if lift <= 0.0 {
        found.push(own::LIFT.finding().at(names::ID));
    } else if lift <= ball && !control.bit("_CBIT[14]") {
        found.push(own::LIFT_BALL.finding().number("ball", ball).at(names::ID));
    }
}
