//! CYCLE998 drawn: the surface along the offset axis with its points; of two angles both sections beside each other.

use super::angles::ways;
use super::params::{AT_ANGLE, DIFFERENTIAL, ONE, TWO};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, SIZE, Seen, Staging, Touched, add};
use crate::picture::figures::{arc, circle, dimension, line, polar, polygon, ray};

/// Steepest angle that is drawn, degree.
const STEEP: f64 = 40.0;
/// From the zero point to the first point, mm.
const SET: f64 = 55.0;

/// A view with one axis of the plane to the right and another one up.
fn look(right: usize, up: usize) -> Look {
    let directions = [right, up].map(place::unit);
    Look { right: directions[0], up: directions[1], cut: up == 2, axes: [right, up], ..Look::ABOVE }.ways(names::MVAR)
}

/// The axes of `_MA` from 0: offset axis and measuring axis.
fn axes(inputs: &Inputs) -> [usize; 2] {
    let axes = inputs.integer(names::MA).clamp(101, 303) as usize;
    [axes / 100 - 1, (axes % 10).clamp(1, 3) - 1]
}

/// The surface at its angles, so steep at most that all of it is seen.
pub fn stage(inputs: &Inputs) -> Staging {
    let [offset, measuring] = axes(inputs);
    let steep = |name| inputs.degrees(name).0.clamp(-STEEP, STEEP);
    let set = SET.copysign(inputs.number(names::SETVAL));
    let looks = match TWO.holds(inputs) {
        true => vec![look(0, 2).touching(0b11), look(1, 2).touching(0b101)],
        false => vec![look(offset.min(measuring), offset.max(measuring))],
    };
    let fields = Fields { edges: &ways(inputs)[0][..1], mark: Some("P"), ..Fields::CYCLE };
    let distances: Vec<Name> = ways(inputs).iter().map(|[_, distance]| *distance).collect();
    let variant = DIFFERENTIAL.holds(inputs).then_some(inputs.variant - 1000);
    let stage = Staging { looks, variant, ..Staging::new(Look::ABOVE, fields) }
        .sized(inputs, &distances)
        .short(inputs, names::FA, [15.0, 30.0])
        .with(names::SETVAL, set)
        .with(names::STA1, steep(names::STA1))
        .with(names::INCA, steep(names::INCA))
        .with(names::RA, 0.0);
    if AT_ANGLE.holds(inputs) {
        return stage.with(names::TSA, inputs.positive(names::TSA, 2.0).clamp(4.0, 20.0));
    }
    let rise = SIZE * steep(names::STA1).to_radians().tan().abs();
    stage.with(names::FA, 15.0 + rise / 2.0)
}

/// Set position, angles with their safe area, distances.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [offset, measuring] = axes(inputs);
    let along = usize::from(offset > measuring);
    let legs = looks.iter().zip(ways(inputs));
    let mut shapes: Vec<_> = legs.flat_map(|(seen, names)| leg(inputs, seen, along, *names)).collect();
    let Some(seen) = looks.first() else { return shapes };
    if DIFFERENTIAL.holds(inputs) {
        let turned = |touch: &Touched| circle(ShapeKind::Axis, touch.start, seen.ball * 1.8).text("180°/0°");
        shapes.extend(seen.touches.first().map(|touch| turned(touch).of(names::MVAR)));
    }
    if AT_ANGLE.holds(inputs) {
        shapes.extend(seen.position(names::SETVAL, 1 - along, None));
    }
    if ONE.holds(inputs) {
        shapes.extend(corrected(inputs, seen));
    }
    shapes
}

/// A way from the first point to the other one, along an axis of the paper: its angle with the safe area, its length.
fn leg(inputs: &Inputs, seen: &Seen, along: usize, [angle, distance]: [Name; 2]) -> Vec<PictureShape> {
    let [first, second] = seen.touches[..] else { return Vec::new() };
    let base = [0.0, 90.0][along];
    let way = [second.at[0] - first.at[0], second.at[1] - first.at[1]];
    let drawn = way[1].atan2(way[0]).to_degrees();
    let (reach, area) = (way[0].hypot(way[1]) * 1.25, inputs.positive(names::TSA, 2.0).clamp(4.0, 20.0));
    let mut wedge = vec![first.at];
    wedge.extend(arc(first.at, reach, drawn - area, drawn + area));
    let mut shapes = vec![
        polygon(ShapeKind::Tolerance, wedge).of(names::TSA),
        line(ShapeKind::Axis, vec![first.at, add(first.at, polar(base, reach * 1.1))]).of(names::MA),
    ];
    shapes.extend(seen.angle(angle, first.at, reach * 0.9, [base, drawn]));
    let out = first.out();
    let away = |touch: &Touched| touch.start[1 - along] * out[1 - along].signum();
    let level = (away(&first).max(away(&second)) + 4.0 * seen.ball) * out[1 - along].signum();
    shapes.push(seen.along(distance, along, [first.start, second.start], level));
    shapes.extend(seen.arrows(names::MD, seen.ball));
    let mut aside = [0.0; 2];
    aside[along] = -3.0 * seen.ball;
    shapes.push(dimension(names::FA, add(first.start, aside), add(first.ball, aside)));
    shapes
}

/// What takes the angle: the rotary table around the part, or the axes that turn with the surface.
fn corrected(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let [first, second] = seen.touches[..] else { return Vec::new() };
    if inputs.integer(names::RA) > 0 {
        let [low, high] = seen.part;
        let middle = seen.middle();
        let reach = 0.6 * (high[0] - low[0]).hypot(high[1] - low[1]);
        return vec![circle(ShapeKind::Axis, middle, reach).of(names::RA)];
    }
    let along = (second.at[1] - first.at[1]).atan2(second.at[0] - first.at[0]).to_degrees();
    let tips = [0.0, 90.0].map(|turn| add(first.at, polar(along + turn, 6.0 * seen.ball)));
    tips.into_iter().flat_map(|tip| ray(names::RA, first.at, tip, seen.ball)).collect()
}
