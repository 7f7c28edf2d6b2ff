//! CYCLE976 drawn: the hole from above with the directions in their order, beside it the stylus with skew and ball
//! diameter where they are determined; or the surface with the direction.

use super::directions::{angle, directions};
use super::params::{ANGLE, BALL, FOUR, HOLE, LENGTH, ONE, SKEW, UNKNOWN};
use crate::catalogue::prelude::*;
use crate::entry::stage::SIZE;
use crate::picture::figures::{arrow, polar, turn};

/// From the zero point to a surface, mm.
const SET: f64 = 60.0;

/// The hole, or the surface on its side of the zero point.
pub fn stage(inputs: &Inputs) -> Staging {
    if HOLE.holds(inputs) {
        let look = Look { called: !UNKNOWN.holds(inputs), ..Look::ABOVE };
        return Staging::new(look, Fields::CYCLE)
            .sized(inputs, &[names::SETVAL])
            .short(inputs, names::FA, [0.1 * SIZE, 0.25 * SIZE])
            .angle(inputs, names::STA1);
    }
    let look = if upright(inputs) { Look::section(0) } else { Look::ABOVE };
    let set = SET.copysign(inputs.number(names::SETVAL));
    Staging::new(look, Fields::CYCLE).ball(4.0).with(names::SETVAL, set).short(inputs, names::FA, [10.0, 24.0])
}

/// Whether the applicate is measured.
fn upright(inputs: &Inputs) -> bool {
    LENGTH.holds(inputs) || inputs.integer(names::MA) == 3
}

/// Size or position, directions, and what is determined about the probe.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen] = looks else { return Vec::new() };
    if !HOLE.holds(inputs) {
        return surface(inputs, seen);
    }
    let mut shapes = axes(inputs, seen);
    shapes.push(seen.size(names::SETVAL, 0));
    shapes.extend(seen.path(names::FA, 0, 2.0));
    if UNKNOWN.holds(inputs) {
        shapes.extend(unknown(seen));
    }
    if BALL.holds(inputs) || SKEW.holds(inputs) {
        shapes.extend(stylus(inputs));
    }
    shapes
}

/// The axes of the plane, those of calibration where they are turned, the measuring axis and its direction.
fn axes(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let (angle, reach) = (angle(inputs).within_turn().0, 0.75 * SIZE);
    let through = |direction: f64, field| {
        let ends = [180.0, 0.0].map(|turn| polar(angle + direction + turn, reach));
        line(ShapeKind::Axis, ends.to_vec()).of(field)
    };
    let mut shapes = seen.axes(seen.middle(), [None; 2]).to_vec();
    if ANGLE.holds(inputs) {
        shapes.extend([0.0, 90.0].map(|direction| through(direction, names::STA1)));
        shapes.extend(seen.angle(names::STA1, [0.0; 2], 0.58 * SIZE, [0.0, angle]));
    }
    if !FOUR.holds(inputs) {
        shapes.push(through(if inputs.integer(names::MA) == 2 { 90.0 } else { 0.0 }, names::MA));
    }
    for direction in directions(inputs).into_iter().map(|direction| direction.degrees().0).filter(|_| ONE.holds(inputs))
    {
        let tip = polar(angle + direction, 0.5 * SIZE - 2.0 * seen.ball);
        shapes.push(arrow(ShapeKind::Path, [0.0; 2], tip, 1.6 * seen.ball).of(names::MD));
    }
    shapes
}

/// A start beside the centre, with the two runs that find it.
fn unknown(seen: &Seen) -> Vec<PictureShape> {
    let at = [-0.13 * SIZE, 0.1 * SIZE];
    let [tip, way] = turn(names::MVAR, at, 1.8 * seen.ball, [200.0, 380.0], seen.ball);
    vec![
        line(ShapeKind::Touch, vec![[0.0; 2]]).of(names::MVAR),
        line(ShapeKind::Path, vec![at, [0.0; 2]]).of(names::FA),
        circle(ShapeKind::Probe, at, seen.ball).of(names::PRNUM),
        line(ShapeKind::Label, vec![add(at, [0.0, 0.1 * SIZE])]).text("180° / 0°").of(names::MVAR),
        tip,
        way,
    ]
}

/// The stylus from the side, beside the hole: ball diameter, and the skew against the spindle's axis. Of its own, as
/// the probe of the picture has no skew.
fn stylus(inputs: &Inputs) -> Vec<PictureShape> {
    let (axis, top, low, radius) = (SIZE, 0.55 * SIZE, -0.35 * SIZE, 0.13 * SIZE);
    let skewed = SKEW.holds(inputs);
    let ball = axis + if skewed { 0.16 * SIZE } else { 0.0 };
    let mut shapes = vec![
        rectangle(ShapeKind::Material, [axis, top], [0.3 * SIZE, 0.12 * SIZE]),
        line(ShapeKind::Axis, vec![[axis, top], [axis, low - 0.3 * SIZE]]).of(names::MVAR),
        line(ShapeKind::Path, vec![[axis, top - 0.06 * SIZE], [ball, low]]).of(names::PRNUM),
        circle(ShapeKind::Probe, [ball, low], radius).of(names::PRNUM),
    ];
    let named = |text: &str, ends: [[f64; 2]; 2]| line(ShapeKind::Dimension, ends.to_vec()).text(text).of(names::MVAR);
    if skewed {
        let under = low - 0.24 * SIZE;
        shapes.push(named("s", [[axis, under], [ball, under]]));
        shapes.push(line(ShapeKind::Axis, vec![[ball, low], [ball, under - 0.05 * SIZE]]).of(names::MVAR));
    }
    if BALL.holds(inputs) {
        let beside = low + 1.35 * radius;
        shapes.push(named("Ø", [[ball - radius, beside], [ball + radius, beside]]));
    }
    shapes
}

/// A surface with its position, the direction, and the stylus above it.
fn surface(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let axis = usize::from(upright(inputs) || inputs.integer(names::MA) == 2);
    let mut shapes = seen.position(names::SETVAL, axis, None);
    shapes.extend(seen.measuring_axis(names::MA, axis));
    let Some(touch) = seen.touches.first() else { return shapes };
    shapes.extend(seen.arrows(names::MD, seen.ball));
    shapes.extend(seen.path(names::FA, 0, 2.0));
    if LENGTH.holds(inputs) {
        // the path may be used up behind the set position as well
        let way = [touch.ball[0] - touch.start[0], touch.ball[1] - touch.start[1]];
        let aside = [2.0 * seen.ball, 0.0];
        shapes.push(dimension(names::FA, add(touch.ball, aside), add(add(touch.ball, way), aside)));
    }
    if upright(inputs) {
        shapes.extend(above(inputs, seen, touch.start, touch.out()[1]));
    }
    shapes
}

/// Stylus and spindle above the ball, with the length that is determined: to the ball's centre, or with `_CBIT[14]` to
/// its circumference (B:5471-5472). `up`: 1, or -1 where the surface is touched from below.
fn above(inputs: &Inputs, seen: &Seen, ball: [f64; 2], up: f64) -> Vec<PictureShape> {
    let nose = add(ball, [0.0, 30.0 * up]);
    let mut shapes = vec![
        line(ShapeKind::Path, vec![ball, nose]).of(names::PRNUM),
        rectangle(ShapeKind::Material, add(nose, [0.0, 4.0 * up]), [20.0, 8.0]),
    ];
    if LENGTH.holds(inputs) {
        let around = inputs.settings.get("_CBIT[14]") == Some(&1.0);
        let tip = add(ball, [-14.0, if around { -seen.ball * up } else { 0.0 }]);
        shapes.push(line(ShapeKind::Dimension, vec![[tip[0], nose[1]], tip]).text("L1").of(names::MVAR));
        shapes.push(line(ShapeKind::Axis, vec![add(tip, [-4.0, 0.0]), [ball[0], tip[1]]]).of(names::MVAR));
    }
    shapes
}
