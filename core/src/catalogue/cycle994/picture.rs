//! CYCLE994 drawn: both points with the way between them, around the protection zone. The second variant is drawn
//! twice, outside with the zone and inside without it. Built with the measuring axis upwards, then laid into the plane.

use super::params::INSIDE_ZONE;
use crate::catalogue::lathe::figures::{self, ENDS, MEASURED, RADIUS, Touch};
use crate::catalogue::lathe::params::DIAMETER;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arrow, dimension, line, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Where both points lie along the part, mm.
const PLACE: f64 = -14.0;
/// How far the zone reaches beyond the part, mm.
const BEYOND: f64 = 26.0;
/// Distance between two drawings, mm.
const BESIDE: f64 = 124.0;

/// One of the ways to measure.
#[derive(Clone, Copy, PartialEq)]
enum Task {
    Outside,
    InsideZone,
    InsideFree,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let tasks: &[Task] =
        if INSIDE_ZONE.holds(inputs) { &[Task::InsideZone] } else { &[Task::Outside, Task::InsideFree] };
    let axis = inputs.integer(names::MA).clamp(1, 3);
    let mut shapes = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        let shift = BESIDE * index as f64;
        let mut drawn = drawing(inputs, *task, axis);
        drawn.iter_mut().for_each(|shape| lay(shape, axis == 1, shift));
        shapes.extend(drawn);
    }
    Picture { view: if axis == 3 { View::Section } else { View::Plane }, shapes }
}

/// Lays a figure so that the measuring axis is the abscissa where it has to be, and beside the drawing before it.
fn lay(shape: &mut PictureShape, abscissa: bool, shift: f64) {
    let place = |[x, y]: [f64; 2]| {
        if abscissa { [y + shift, x] } else { [x + shift, y] }
    };
    for point in &mut shape.points {
        *point = place(*point);
    }
    if let Some((centre, _)) = &mut shape.circle {
        *centre = place(*centre);
    }
}

fn drawing(inputs: &Inputs, task: Task, axis: i64) -> Vec<PictureShape> {
    let path = figures::path(inputs).min(8.0);
    let touches = [(1, 1.0), (2, -1.0)].map(|(number, side)| Touch {
        at: [PLACE, side * RADIUS],
        out: [0.0, if task == Task::Outside { side } else { -side }],
        number,
    });
    let mut shapes = part(task, axis);
    shapes.extend(axes(inputs, axis));
    if task != Task::InsideFree {
        shapes.extend(zone(inputs, half_zone(task), axis));
    }
    let [first, second] = &touches;
    let face = [[ENDS[0], RADIUS], [ENDS[1], RADIUS]];
    shapes.extend(figures::bands(inputs, MEASURED, face, first.out));
    shapes.extend(way(task, [first.start(path), second.start(path)], axis));
    for touch in &touches {
        shapes.extend(figures::touch(touch, path));
    }
    shapes.push(figures::path_dimension(first, path));
    let from = if DIAMETER.holds(inputs) { -RADIUS } else { 0.0 };
    shapes.push(dimension(names::SETVAL, [-32.0, from], [-32.0, RADIUS]));
    shapes
}

/// Part seen from outside, or its walls; in its chuck where it turns about the drawn axis.
fn part(task: Task, axis: i64) -> Vec<PictureShape> {
    let [left, right] = ENDS;
    let (middle, length) = ((left + right) / 2.0, right - left);
    let mut shapes = Vec::new();
    if task == Task::Outside {
        let body = [length, 2.0 * RADIUS];
        shapes.push(rectangle(ShapeKind::Material, [middle, 0.0], body));
    } else {
        for side in [1.0, -1.0] {
            let wall = [middle, side * (RADIUS + 6.0)];
            shapes.push(rectangle(ShapeKind::Cut, wall, [length, 12.0]));
        }
    }
    for side in [1.0, -1.0] {
        let edge = vec![[left, side * RADIUS], [right, side * RADIUS]];
        shapes.push(line(ShapeKind::Edge, edge).of(names::SETVAL));
    }
    if axis != 1 {
        let chuck = [10.0, 3.2 * RADIUS];
        shapes.push(rectangle(ShapeKind::Cut, [left - 5.0, 0.0], chuck));
    }
    shapes
}

/// The measuring axis through both points, and the one along which the zone is passed.
fn axes(inputs: &Inputs, axis: i64) -> Vec<PictureShape> {
    let index = axis as usize - 1;
    let [measured, letter] = figures::axis(inputs, index, [[PLACE, -44.0], [PLACE, 44.0]]);
    let mut shapes = vec![measured.of(names::MA), letter];
    let along = usize::from(axis == 1);
    shapes.extend(figures::axis(inputs, along, [[-66.0, 0.0], [44.0, 0.0]]));
    let zero = vec![[ENDS[0], 46.0], [ENDS[0], -46.0]];
    shapes.push(line(ShapeKind::Axis, zero).text("0"));
    shapes
}

/// Half the size of the drawn zone in the measuring axis, mm.
fn half_zone(task: Task) -> f64 {
    if task == Task::Outside { 38.0 } else { 7.0 }
}

/// Parameters of the zone: in the measuring axis, and along the part (B:10986-11001).
fn fields(axis: i64) -> [&'static str; 2] {
    if axis == 1 { [names::SZA, names::SZO] } else { [names::SZO, names::SZA] }
}

/// The zone with its dimensions.
fn zone(inputs: &Inputs, half: f64, axis: i64) -> [PictureShape; 3] {
    let [across, along] = fields(axis);
    let left = ENDS[0];
    let centre = [(left + BEYOND) / 2.0, 0.0];
    let from = if DIAMETER.holds(inputs) { -half } else { 0.0 };
    [
        rectangle(ShapeKind::Zone, centre, [BEYOND - left, 2.0 * half]).of(across),
        dimension(across, [BEYOND + 8.0, from], [BEYOND + 8.0, half]),
        dimension(along, [left, -42.0], [BEYOND, -42.0]),
    ]
}

/// The way from the first point to the second: around the zone on its border, or straight.
fn way(task: Task, [start, end]: [[f64; 2]; 2], axis: i64) -> Vec<PictureShape> {
    let half = half_zone(task);
    let corners = match task {
        Task::InsideFree => vec![start, end],
        _ => vec![start, [PLACE, half], [BEYOND, half], [BEYOND, -half], [PLACE, -half], end],
    };
    let field = if task == Task::InsideFree { names::MVAR } else { fields(axis)[1] };
    let mut shapes = Vec::new();
    if let [.., from, tip] = corners[..] {
        shapes.push(arrow(ShapeKind::Path, from, tip, 4.0).of(field));
    }
    shapes.push(line(ShapeKind::Path, corners).of(field));
    shapes
}
