//! The tool before the first side that it touches.

use super::{PROBE, Scene, Tool, Touch, at};
use crate::catalogue::names;
use crate::form::figures::{circle, dimension, polygon};
use crate::form::picture::{PictureShape, ShapeKind};

/// Radius of the calibration tool, mm.
const BALL: f64 = 5.0;
/// Radius of the nose of a turning tool, mm.
const NOSE: f64 = 1.5;
/// Radius of milling tool and drill, mm.
const CUTTER: f64 = 6.0;
/// Radius of a disc and of its shank, mm: the shank passes the probe while the disc touches its middle (B:9779).
const DISC: f64 = 16.0;
const SHANK: f64 = 3.0;
/// Width of a disc, mm.
const WIDTH: f64 = 5.0;
/// From the tip to the tool carrier, mm.
const LENGTH: f64 = 30.0;

/// The tool, its measuring point one measuring path before the side.
pub fn shapes(scene: &Scene, touch: &Touch) -> Vec<PictureShape> {
    let out = PROBE + scene.path;
    let along_axis = touch.axis == scene.along;
    match scene.tool {
        Tool::Ball => nosed(touch, out, BALL, BALL_SHANK),
        Tool::Insert => nosed(touch, out, NOSE, INSERT),
        Tool::Drill if along_axis => vec![body(touch, out, DRILL_TIP)],
        Tool::Cutter if along_axis => tip_first(touch, out),
        Tool::Cutter | Tool::Drill => from_the_side(touch, out),
        Tool::Disc if along_axis => disc_behind(touch, out),
        Tool::Disc => disc_from_the_side(touch, out),
    }
}

/// Outlines, mm: outwards from the measuring point, and across.
type Outline = &'static [[f64; 2]];

const BALL_SHANK: Outline = &[
    [1.5, 4.0],
    [4.0, 1.5],
    [LENGTH, 16.0],
    [LENGTH, LENGTH],
    [16.0, LENGTH],
];
const INSERT: Outline = &[
    [-1.5, 0.3],
    [0.3, -1.5],
    [12.0, 2.0],
    [LENGTH, 14.0],
    [LENGTH, LENGTH],
    [14.0, LENGTH],
    [2.0, 12.0],
];
const DRILL_TIP: Outline = &[
    [0.0, 0.0],
    [4.0, -CUTTER],
    [LENGTH, -CUTTER],
    [LENGTH, CUTTER],
    [4.0, CUTTER],
];

fn body(touch: &Touch, out: f64, outline: &[[f64; 2]]) -> PictureShape {
    let place = |[away, beside]: &[f64; 2]| at(touch, out + away, *beside);
    polygon(ShapeKind::Probe, outline.iter().map(place).collect()).of(names::MVAR)
}

/// A tool that ends in a nose: the outline starts from its centre.
fn nosed(touch: &Touch, out: f64, radius: f64, outline: Outline) -> Vec<PictureShape> {
    let centre = at(touch, out + radius, 0.0);
    vec![
        body(touch, out + radius, outline),
        circle(ShapeKind::Probe, centre, radius).of(names::MVAR),
    ]
}

/// A milling tool with its end to the probe: the edge stands before the middle of the probe, the axis beside it.
fn tip_first(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let outline = [
        [0.0, 0.0],
        [LENGTH, 0.0],
        [LENGTH, 2.0 * CUTTER],
        [0.0, 2.0 * CUTTER],
    ];
    vec![body(touch, out, &outline), radius(touch, out + 8.0, CUTTER)]
}

/// A milling tool or drill with its side to the probe.
fn from_the_side(touch: &Touch, out: f64) -> Vec<PictureShape> {
    let outline = [
        [0.0, -4.0],
        [0.0, LENGTH],
        [2.0 * CUTTER, LENGTH],
        [2.0 * CUTTER, -4.0],
    ];
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
    vec![
        body(touch, out, &outline),
        radius(touch, out + WIDTH + 3.0, DISC),
    ]
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
    PictureShape {
        text: Some("R".to_owned()),
        ..dimension(names::MVAR, from, to)
    }
}
