//! The tool before the first side that it touches.

use super::{PROBE, Scene, Tool, Touch, at};
use crate::catalogue::tool_probe::figures;
use crate::catalogue::tool_probe::figures::{LENGTH, nose_radius};
use crate::entry::{Inputs, names};
use crate::picture::figures::{dimension, polygon};
use crate::picture::{PictureShape, ShapeKind};

/// Radius of milling tool and drill, mm.
const CUTTER: f64 = 6.0;
/// Radius of a disc and of its shank, mm: the shank passes the probe while the disc touches its middle (B:9779).
const DISC: f64 = 16.0;
const SHANK: f64 = 3.0;
/// Width of a disc, mm.
const WIDTH: f64 = 5.0;

/// The tool, its measuring point one measuring path before the side.
pub fn shapes(inputs: &Inputs, scene: &Scene, touch: &Touch) -> Vec<PictureShape> {
    let out = PROBE + scene.path;
    let along_axis = touch.axis == scene.along;
    match scene.tool {
        Tool::Ball => nosed(inputs, touch, out, true),
        Tool::Insert => nosed(inputs, touch, out, false),
        Tool::Drill if along_axis => vec![body(touch, out, DRILL_TIP)],
        Tool::Cutter if along_axis => tip_first(touch, out),
        Tool::Cutter | Tool::Drill => from_the_side(touch, out),
        Tool::Disc if along_axis => disc_behind(touch, out),
        Tool::Disc => disc_from_the_side(touch, out),
    }
}

/// Outlines, mm: outwards from the measuring point, and across.
type Outline = &'static [[f64; 2]];

const DRILL_TIP: Outline = &[[0.0, 0.0], [4.0, -CUTTER], [LENGTH, -CUTTER], [LENGTH, CUTTER], [4.0, CUTTER]];

fn body(touch: &Touch, out: f64, outline: &[[f64; 2]]) -> PictureShape {
    let place = |[away, beside]: &[f64; 2]| at(touch, out + away, *beside);
    polygon(ShapeKind::Probe, outline.iter().map(place).collect()).of(names::MVAR)
}

/// A tool that ends in a nose, whose centre stands over the middle of the probe.
fn nosed(inputs: &Inputs, touch: &Touch, out: f64, calibrates: bool) -> Vec<PictureShape> {
    let centre = at(touch, out + nose_radius(calibrates), 0.0);
    let mut away = [1.0; 2];
    away[touch.axis] = touch.side;
    figures::nosed(inputs, calibrates, centre, away).to_vec()
}

/// A milling tool with its end to the probe: the edge stands before the middle of the probe, the axis beside it.
fn tip_first(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let outline = [[0.0, 0.0], [LENGTH, 0.0], [LENGTH, 2.0 * CUTTER], [0.0, 2.0 * CUTTER]];
    vec![body(touch, out, &outline), radius(touch, out + 8.0, CUTTER)]
}

/// A milling tool or drill with its side to the probe.
fn from_the_side(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let outline = [[0.0, -4.0], [0.0, LENGTH], [2.0 * CUTTER, LENGTH], [2.0 * CUTTER, -4.0]];
    let ends = [out, out + CUTTER].map(|out| at(touch, out, LENGTH - 4.0));
    vec![body(touch, out, &outline), marked(ends)]
}

/// A disc behind the probe, its edge at the shank before the middle of the probe.
fn disc_behind(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let outline = [
        [0.0, 0.0],
        [WIDTH, 0.0],
        [WIDTH, 2.0 * DISC],
        [0.0, 2.0 * DISC],
        [0.0, DISC + SHANK],
        [-2.0 * LENGTH, DISC + SHANK],
        [-2.0 * LENGTH, DISC - SHANK],
        [0.0, DISC - SHANK],
    ];
    vec![body(touch, out, &outline), radius(touch, out + WIDTH + 3.0, DISC)]
}

/// A disc with its circumference to the probe.
fn disc_from_the_side(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let half = WIDTH / 2.0;
    let outline = [
        [0.0, -half],
        [2.0 * DISC, -half],
        [2.0 * DISC, half],
        [DISC + SHANK, half],
        [DISC + SHANK, LENGTH],
        [DISC - SHANK, LENGTH],
        [DISC - SHANK, half],
        [0.0, half],
    ];
    let ends = [out, out + DISC].map(|out| at(touch, out, -half - 3.0));
    vec![body(touch, out, &outline), marked(ends)]
}

/// The radius of a tool whose axis stands beside the middle of the probe.
fn radius(touch: &Touch, out: f64, radius: f64) -> PictureShape {
    marked([at(touch, out, 0.0), at(touch, out, radius)])
}

fn marked(ends: [[f64; 2]; 2]) -> PictureShape {
    let [from, to] = ends;
    PictureShape { text: Some("R".to_owned()), ..dimension(names::MVAR, from, to) }
}
