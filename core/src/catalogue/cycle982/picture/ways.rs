//! The way of the measuring point to the first side, and from side to side round the probe.

use super::super::params::{OPPOSITE, UPPER};
use super::{PROBE, Scene, Tool, Touch, at};
use crate::entry::{Inputs, names};
use crate::picture::figures::{circle, line};
use crate::picture::{PictureShape, ShapeKind};

/// Distance of the start position from the centre of the probe in both axes, mm.
const FAR: f64 = 34.0;

/// The ways, the start position marked. An upper edge starts behind the probe, where it touches; where its length is
/// measured against the approach, in front of it, and the probe is crossed first (B:9762-9793).
pub fn between(inputs: &Inputs, scene: &Scene) -> Vec<PictureShape> {
    let (upper, opposite) = (UPPER.holds(inputs), OPPOSITE.holds(inputs));
    let start_side = if upper && !opposite { -1.0 } else { 1.0 };
    let round_side = if opposite { -1.0 } else { 1.0 };
    let Some(first) = scene.touches.first() else {
        return Vec::new();
    };
    let mut start = [FAR; 2];
    start[scene.along] = start_side * FAR;
    let pointed = inputs.nose.filter(|_| scene.tool == Tool::Insert);
    if let Some(across) = pointed.and_then(|nose| nose.iter().position(|side| *side == 0.0)) {
        start[across] = 0.0;
    }
    let mut way = vec![start];
    way.extend(approach(first, start));
    way.push(at(first, PROBE + scene.path, 0.0));
    let mut shapes =
        vec![line(ShapeKind::Path, way).of(names::MVAR), circle(ShapeKind::Path, start, 1.2).of(names::MVAR)];
    for pair in scene.touches.windows(2) {
        if let [from, to] = pair {
            let way = round(from, to, PROBE + scene.path, round_side);
            shapes.push(line(ShapeKind::Path, way).of(names::MVAR));
        }
    }
    shapes
}

/// First across the measuring axis, then along it; from the other side of the probe first past it.
fn approach(first: &Touch, start: [f64; 2]) -> Vec<[f64; 2]> {
    let mut across = start;
    across[first.axis] = first.side * FAR;
    vec![across, at(first, FAR, 0.0)]
}

/// From one side to the next: round one corner, or past a third side to the opposite one.
fn round(from: &Touch, to: &Touch, out: f64, side: f64) -> Vec<[f64; 2]> {
    let (start, end) = (at(from, out, 0.0), at(to, out, 0.0));
    let corners = if from.axis == to.axis {
        vec![at(from, out, side * out), at(to, out, side * out)]
    } else {
        vec![at(from, out, to.side * out)]
    };
    [vec![start], corners, vec![end]].concat()
}
