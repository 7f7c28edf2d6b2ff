//! Bore or boss from above, with clearance, overtravel and tolerance. The limits are drawn wider than they are.

use super::BOSS;
use crate::entry::Inputs;
use crate::picture::figures::{circle, corners, dimension, frame, line, polygon, ring, round};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

const CENTRE: [f64; 2] = [0.0; 2];
/// Ways to the four walls.
const DIRECTIONS: [[f64; 2]; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

/// What is drawn, mm. `side` +1: the ball comes from outside.
struct Scene {
    side: f64,
    radius: f64,
    ball: f64,
    /// Distance of the ball centre from the centre at contact and where measuring begins.
    contact: f64,
    start: f64,
    /// Distance of the wall at which the search ends.
    limit: f64,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = part(&scene);
    limits(&scene, inputs, &mut shapes);
    let Scene { radius, start, contact, limit, ball, side } = scene;
    for [x, y] in DIRECTIONS {
        let way = vec![[x * start, y * start], [x * contact, y * contact]];
        shapes.push(line(ShapeKind::Path, way));
        shapes.push(circle(ShapeKind::Probe, [x * start, y * start], ball));
        shapes.push(circle(ShapeKind::Touch, [x * radius, y * radius], ball * 0.3));
    }
    shapes.push(dimension("D", [-radius, -radius * 0.45], [radius, -radius * 0.45]));
    shapes.push(dimension("Q", [radius, radius * 0.3], [limit, radius * 0.3]));
    if scene.side > 0.0 {
        shapes.push(dimension("R", [contact, -radius * 0.25], [start, -radius * 0.25]));
    }
    if side < 0.0 {
        shapes.push(circle(ShapeKind::Probe, CENTRE, ball));
    }
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let given = |name: &str, otherwise: f64| inputs.given(name).unwrap_or(otherwise).abs();
    let radius = given("D", 50.0).max(1.0) / 2.0;
    let side = if inputs.variant == BOSS { 1.0 } else { -1.0 };
    let ball = radius * 0.11;
    let contact = radius + side * ball;
    let short = |length: f64| length.clamp(radius * 0.2, radius * 0.6);
    Scene {
        side,
        radius,
        ball,
        contact,
        start: if side > 0.0 { contact + short(given("R", 5.0)) } else { 0.0 },
        limit: radius - side * short(given("Q", 10.0)),
    }
}

fn part(scene: &Scene) -> Vec<PictureShape> {
    let wall = round(CENTRE, scene.radius);
    let material =
        if scene.side > 0.0 { wall.clone() } else { frame(corners(CENTRE, [scene.radius * 3.4; 2]), wall.clone()) };
    let reach = scene.radius * 1.8;
    let axis = |x: f64, y: f64| line(ShapeKind::Axis, vec![[-x, -y], [x, y]]);
    vec![
        polygon(ShapeKind::Material, material),
        polygon(ShapeKind::Edge, wall).of("D"),
        axis(reach, 0.0),
        axis(0.0, reach),
        ring(ShapeKind::Zone, CENTRE, scene.limit.min(scene.radius), scene.limit.max(scene.radius)).of("Q"),
    ]
}

/// Tolerance and upper limit, where they are given.
fn limits(scene: &Scene, inputs: &Inputs, shapes: &mut Vec<PictureShape>) {
    for (name, share) in [("U", 0.09), ("H", 0.05)] {
        if inputs.given(name).is_some() {
            let half = scene.radius * share;
            let band = ring(ShapeKind::Tolerance, CENTRE, scene.radius - half, scene.radius + half);
            shapes.push(band.of(name));
        }
    }
}
