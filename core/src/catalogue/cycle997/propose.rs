//! Nominal spheres for CYCLE997 at their set centres, each on a post.

use super::points::centres;
use crate::catalogue::prelude::*;
use crate::workpiece::{Shape, Workpiece};

/// Diameter of a post as a part of that of the sphere.
const POST: f64 = 0.4;
/// Where a post begins inside of its sphere, as a part of the diameter below the centre.
const INSIDE: f64 = 0.3;
/// How far a post reaches below its sphere, and how far the start is above what the cycle needs, mm.
const ROOM: f64 = 10.0;

/// Spheres, and a start above the first one from which all can be reached (B:8346, B:8421).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let size = inputs.number(names::SETVAL);
    let places = centres(inputs);
    let upright = |shape, at| place::solid(control, shape, at, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let sphere = |at: &[f64; 3]| upright(Shape::Sphere { diameter: size }, *at);
    let height = (0.5 - INSIDE) * size + ROOM;
    let post =
        |[x, y, z]: &[f64; 3]| upright(Shape::Shaft { diameter: POST * size, height }, [*x, *y, z - INSIDE * size]);
    let highest = places.iter().map(|[_, _, z]| *z).fold(f64::NEG_INFINITY, f64::max);
    let above = size / 2.0 + 2.0 * place::ball_radius(inputs, control) + inputs.number(names::FA);
    let [x, y, _] = places[0];
    Proposal {
        workpiece: Workpiece { solids: places.iter().map(sphere).collect() },
        fixture: places.iter().map(post).collect(),
        start: Wcs(place::in_plane(control, [x, y, highest + above + ROOM])),
        ..Proposal::default()
    }
}
