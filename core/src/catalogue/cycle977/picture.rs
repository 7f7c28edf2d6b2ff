//! CYCLE977 drawn: the element from above, and beside it the section with the infeed where there is one.
//! Missing values are drawn as in the manual's examples. Short distances (`_FA`, tolerances) are drawn longer than they
//! are, so that they can be seen beside the element.

use super::params::{OUTSIDE, RECTANGLE, TOOL, WIDTH, ZONE};
use crate::control::variables::AXES;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{circle, corners, dimension, frame, line, polygon, rectangle, round};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// How wide a forbidden area around an element is drawn, as a share of the whole.
const WALL: f64 = 0.08;

/// What is drawn, mm.
struct Scene {
    outside: bool,
    round: bool,
    /// Size in abscissa and ordinate; the free direction of a groove or web is its length.
    size: [f64; 2],
    /// The same of the protection zone.
    zone: Option<[f64; 2]>,
    /// Axes that are measured: 0 abscissa, 1 ordinate.
    axes: &'static [usize],
    rectangle: bool,
    /// Letters of abscissa and ordinate.
    names: [&'static str; 2],
    ball: f64,
    path: f64,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let scene = scene(inputs);
    let mut shapes = part(&scene);
    axes(&scene, TOOL.holds(inputs), &mut shapes);
    zone(&scene, &mut shapes);
    for axis in scene.axes {
        measure(&scene, *axis, &mut shapes);
    }
    sizes(&scene, &mut shapes);
    bands(&scene, TOOL.holds(inputs), &mut shapes);
    shapes.push(circle(ShapeKind::Probe, [0.0; 2], scene.ball).of(names::PRNUM));
    if scene.outside || scene.zone.is_some() {
        section(&scene, &mut shapes);
    }
    Picture { view: View::Plane, shapes }
}

fn scene(inputs: &Inputs) -> Scene {
    let outside = OUTSIDE.holds(inputs);
    let rectangle = RECTANGLE.holds(inputs);
    let width = WIDTH.holds(inputs);
    let across = usize::from(inputs.integer(names::MA) == 2);
    let set = inputs.positive(names::SETVAL, 132.0);
    let mut size = [set; 2];
    if rectangle {
        size = [inputs.positive(names::SETV0, 100.0), inputs.positive(names::SETV1, 200.0)];
    } else if width {
        size[1 - across] = set * 1.4;
    }
    let beside = |size: f64| if outside { size * 1.5 } else { size * 0.4 };
    let zone = ZONE.holds(inputs).then(|| {
        let first = inputs.positive(names::SZA, beside(if rectangle { size[0] } else { set }));
        let mut zone = [first; 2];
        if rectangle {
            zone[1] = inputs.positive(names::SZO, beside(size[1]));
        } else if width {
            zone[1 - across] = size[1 - across];
        }
        zone
    });
    let least = size[0].min(size[1]);
    Scene {
        outside,
        round: !rectangle && !width,
        size,
        zone,
        axes: match (width, across) {
            (true, 0) => &[0],
            (true, _) => &[1],
            _ => &[0, 1],
        },
        rectangle,
        names: [0, 1].map(|axis| AXES[inputs.plane.axes()[axis]]),
        ball: least * 0.045,
        path: inputs.positive(names::FA, 2.0).clamp(least * 0.1, least * 0.25),
    }
}

fn largest(scene: &Scene) -> f64 {
    let zone = scene.zone.unwrap_or([0.0; 2]);
    scene.size[0].max(scene.size[1]).max(zone[0]).max(zone[1])
}

fn part(scene: &Scene) -> Vec<PictureShape> {
    let outline = if scene.round { round([0.0; 2], scene.size[0] / 2.0) } else { corners([0.0; 2], scene.size) };
    let field = if scene.rectangle { names::SETV0 } else { names::SETVAL };
    let edge = polygon(ShapeKind::Edge, outline.clone()).of(field);
    if scene.outside {
        return vec![polygon(ShapeKind::Material, outline), edge];
    }
    let mut block = [scene.size[0] * 1.3, scene.size[1] * 1.3];
    if let [axis] = scene.axes {
        block[1 - axis] = scene.size[1 - axis]; // a groove is open at its ends
    }
    vec![polygon(ShapeKind::Material, frame(corners([0.0; 2], block), outline)), edge]
}

/// The axes through the centre; a zero offset moves them there.
fn axes(scene: &Scene, tool: bool, shapes: &mut Vec<PictureShape>) {
    for axis in 0..2 {
        let reach = reach(scene, axis);
        let mut shape = line(ShapeKind::Axis, vec![along(axis, reach), along(axis, -reach)]).text(scene.names[axis]);
        if scene.axes == [axis] {
            shape = shape.of(names::MA);
        } else if !tool {
            shape = shape.of(names::KNUM);
        }
        shapes.push(shape);
    }
}

/// Half the length of an axis, mm.
fn reach(scene: &Scene, axis: usize) -> f64 {
    let before = if scene.outside { 2.0 * scene.ball + scene.path } else { 0.0 };
    scene.size[axis] * 0.64 + before
}

/// A point on an axis.
fn along(axis: usize, value: f64) -> [f64; 2] {
    let mut point = [0.0; 2];
    point[axis] = value;
    point
}

fn zone(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let Some(zone) = scene.zone else { return };
    let wall = if scene.outside { largest(scene) * WALL } else { 0.0 };
    let contour = |wider: f64| {
        if scene.round {
            round([0.0; 2], zone[0] / 2.0 + wider)
        } else {
            corners([0.0; 2], zone.map(|size| size + 2.0 * wider))
        }
    };
    let area = if scene.outside {
        frame(contour(wall), contour(0.0)) // what is beyond is forbidden
    } else {
        contour(0.0)
    };
    shapes.push(polygon(ShapeKind::Zone, area).of(names::SZA));
    let first = scene.axes.first().copied().unwrap_or(0);
    let span = |axis: usize, at: f64| {
        let (mut from, mut to) = (along(axis, -zone[axis] / 2.0), along(axis, zone[axis] / 2.0));
        (from[1 - axis], to[1 - axis]) = (at, at);
        (from, to)
    };
    let (from, to) = span(first, zone[1 - first] * 0.2);
    shapes.push(dimension(names::SZA, from, to));
    if scene.rectangle {
        let (from, to) = span(1, zone[0] * 0.2);
        shapes.push(dimension(names::SZO, from, to));
    }
}

/// Both touches in an axis: start of the measuring block, way, point. The plus side comes first (B:5773).
fn measure(scene: &Scene, axis: usize, shapes: &mut Vec<PictureShape>) {
    for (side, order) in [(1.0, 1), (-1.0, 2)] {
        let number = order + if scene.axes.len() == 2 { 2 * axis } else { 0 };
        let away = if scene.outside { 1.0 } else { -1.0 };
        let touch = side * scene.size[axis] / 2.0;
        let switching = touch + side * away * scene.ball;
        let start = switching + side * away * scene.path;
        shapes.push(line(ShapeKind::Path, vec![along(axis, start), along(axis, switching)]).of(names::FA));
        shapes.push(circle(ShapeKind::Probe, along(axis, start), scene.ball).of(names::PRNUM));
        shapes.push(
            circle(ShapeKind::Touch, along(axis, touch), scene.ball * 0.3).text(number.to_string()).of(names::NMSP),
        );
    }
}

fn sizes(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    for (index, axis) in scene.axes.iter().copied().enumerate() {
        let field = match (scene.rectangle, axis) {
            (true, 0) => names::SETV0,
            (true, _) => names::SETV1,
            _ => names::SETVAL,
        };
        if index == 1 && scene.round {
            break; // one diameter
        }
        let half = scene.size[axis] / 2.0;
        let (mut from, mut to) = (along(axis, -half), along(axis, half));
        let beside = -scene.size[1 - axis] * if scene.outside { 0.62 } else { 0.2 };
        (from[1 - axis], to[1 - axis]) = (beside, beside);
        shapes.push(dimension(field, from, to));
    }
    let axis = scene.axes.first().copied().unwrap_or(0);
    let sign = if scene.outside { 1.0 } else { -1.0 };
    let switching = scene.size[axis] / 2.0 + sign * scene.ball;
    let (mut from, mut to) = (along(axis, switching + sign * scene.path), along(axis, switching));
    (from[1 - axis], to[1 - axis]) = (scene.ball * 2.0, scene.ball * 2.0);
    shapes.push(dimension(names::FA, from, to));
}

/// Tolerance bands along the contour, or the safe area of the centre; wider than they are.
fn bands(scene: &Scene, tool: bool, shapes: &mut Vec<PictureShape>) {
    let unit = scene.size[0].min(scene.size[1]) * 0.025;
    if !tool {
        let area = rectangle(ShapeKind::Tolerance, [0.0; 2], [8.0 * unit; 2]);
        shapes.push(area.of(names::TSA));
        return;
    }
    let contour = |wider: f64| {
        let size = scene.size.map(|size| size + 2.0 * wider * unit);
        if scene.round { round([0.0; 2], size[0] / 2.0) } else { corners([0.0; 2], size) }
    };
    for (from, to, field) in
        [(-2.6, 2.6, names::TSA), (-1.8, 1.8, names::TDIF), (0.0, 1.0, names::TUL), (-1.0, 0.0, names::TLL)]
    {
        let band = frame(contour(to), contour(from));
        shapes.push(polygon(ShapeKind::Tolerance, band).of(field));
    }
}

/// Section through the measuring axis, beside the view from above: start height, infeed, measuring height. The upper
/// face stands at the height of the centre of that view.
fn section(scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let axis = scene.axes.first().copied().unwrap_or(0);
    let (width, all) = (scene.size[axis], largest(scene));
    let middle = seen_from_above(scene) + half_section(scene, width, all) + all * 0.12;
    let depth = all * 0.32;
    let block = |kind, (from, to): (f64, f64), height: f64| {
        let (left, right) = (middle + from, middle + to);
        let corners = [[left, -depth], [right, -depth], [right, height - depth], [left, height - depth]];
        polygon(kind, corners.to_vec())
    };
    let walls = if scene.outside {
        vec![(-width / 2.0, width / 2.0)]
    } else {
        vec![(-width * 0.65, -width / 2.0), (width / 2.0, width * 0.65)]
    };
    shapes.extend(walls.into_iter().map(|wall| block(ShapeKind::Cut, wall, depth)));
    if let Some(zone) = scene.zone {
        let pieces = section_zone(scene.outside, zone[axis], all);
        shapes.extend(pieces.into_iter().map(|piece| block(ShapeKind::Zone, piece, depth).of(names::SZA)));
    }
    infeed(scene, width, depth, middle, shapes);
}

/// The way from above the element down to the measuring height.
fn infeed(scene: &Scene, width: f64, depth: f64, middle: f64, shapes: &mut Vec<PictureShape>) {
    let away = if scene.outside { 1.0 } else { -1.0 };
    let start = middle + width / 2.0 + away * (scene.ball + scene.path);
    let (high, low) = (depth * 0.6, -depth * 0.5);
    let way = vec![[middle, high], [start, high], [start, low]];
    shapes.push(line(ShapeKind::Path, way).of(names::ID));
    shapes.push(circle(ShapeKind::Probe, [middle, high], scene.ball).of(names::ID));
    shapes.push(circle(ShapeKind::Probe, [start, low], scene.ball).of(names::ID));
    let beside = start + away * scene.ball * 2.0;
    shapes.push(dimension(names::ID, [beside, high], [beside, low]));
}

/// How far the view from above reaches to the right, mm.
fn seen_from_above(scene: &Scene) -> f64 {
    let zone = scene.zone.map_or(0.0, |zone| zone[0] / 2.0 + largest(scene) * WALL);
    reach(scene, 0).max(if scene.outside { zone } else { scene.size[0] * 0.65 })
}

/// How far the section reaches to both sides, mm.
fn half_section(scene: &Scene, width: f64, all: f64) -> f64 {
    match (scene.outside, scene.zone) {
        (true, Some(zone)) => zone[scene.axes.first().copied().unwrap_or(0)] / 2.0 + all * WALL,
        _ => width * 0.65,
    }
}

/// Where the zone is cut: one piece in the middle, or two outside of the free room.
fn section_zone(outside: bool, zone: f64, all: f64) -> Vec<(f64, f64)> {
    if outside {
        let wall = zone / 2.0 + all * WALL;
        vec![(-wall, -zone / 2.0), (zone / 2.0, wall)]
    } else {
        vec![(-zone / 2.0, zone / 2.0)]
    }
}
