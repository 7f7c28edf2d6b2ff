//! The pictograms of the start screen: for each element the nominal part of a worked measurement, seen from above at an
//! angle, with the faces that are touched and what touches them. Written to `www/src/start/pictograms.json`.

#![allow(clippy::unwrap_used)]

mod canvas;

use super::*;
use crate::catalogue::CYCLES;
use crate::catalogue::example::choosing;
use crate::control::{MachineSort, Plane, delivery};
use crate::dialect::Dialect;
use crate::entry::{Aim, Cycle, Element, How, ProbeUse, Variant};
use crate::picture::ShapeKind;
use crate::scene::mesh::Mesh;
use crate::scene::solid::figure;
use crate::workpiece::{PartErrors, Shape, Solid};
use canvas::{Canvas, SIZE as DOTS};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Free dots around what is drawn.
const MARGIN: f64 = 26.0;
/// Most dots for a mm, so that a small part does not fill everything.
const LARGEST: f64 = 9.0;
/// Towards the eye; abscissa, ordinate, applicate: from where the touched faces are seen best, the first one else.
const EYES: [[f64; 3]; 6] = [
    [1.0, -1.35, 0.95],
    [-1.0, -1.35, 0.95],
    [1.0, 1.35, 0.95],
    [-1.0, 1.35, 0.95],
    [-1.6, -0.5, 0.95],
    [1.6, -0.5, 0.95],
];
/// Radius of a way and of a line that is drawn, mm.
const ROD: f64 = 1.1;
/// Size of a figure that is laid on a plate, mm.
const LAID: f64 = 100.0;
/// Half of the section of a probe from its ball on: distance from the axis and height, in radii of the ball.
const STYLUS: [[f64; 2]; 2] = [[0.36, 0.8], [0.36, 6.0]];
const BODY: [[f64; 2]; 4] = [[0.36, 6.0], [1.5, 7.0], [1.5, 12.5], [0.0, 12.5]];
const RING: [[f64; 2]; 2] = [[1.56, 8.6], [1.56, 9.8]];

/// What a face is made of, which the page gives a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Matter {
    Part,
    Touched,
    Ball,
    Stylus,
    Body,
    Ring,
    Tool,
    Path,
}

/// A face: triangles that are one area of one colour.
struct Face {
    class: String,
    triangles: Vec<[V3; 3]>,
}

/// What is drawn, in machine coordinates.
#[derive(Default)]
struct Sight {
    faces: Vec<Face>,
    axes: [V3; 3],
    eye: [f64; 3],
}

impl Sight {
    fn of(axes: [V3; 3]) -> Sight {
        Sight { faces: Vec::new(), axes, eye: EYES[0] }
    }

    /// Direction of what is given along abscissa, ordinate and applicate.
    fn way(&self, [x, y, z]: [f64; 3]) -> V3 {
        self.axes[0] * x + self.axes[1] * y + self.axes[2] * z
    }

    /// To the right, upwards, towards the eye.
    fn paper(&self) -> [V3; 3] {
        let eye = self.way(self.eye).normalize();
        let right = self.axes[2].cross(&eye).normalize();
        [right, eye.cross(&right), eye]
    }

    /// The side of a flat face: by how it looks upwards and to the right.
    fn side(&self, normal: V3) -> &'static str {
        let [right, ..] = self.paper();
        match (normal.dot(&self.axes[2]), normal.dot(&right)) {
            (up, _) if up > 0.6 => "top",
            (_, across) if across > 0.0 => "right",
            _ => "left",
        }
    }

    /// Adds the triangles of a mesh: those of a plane are one face, and those that bend.
    fn mesh(&mut self, mesh: &Mesh, matter: Matter, touches: &[V3]) {
        let mut groups: BTreeMap<[i64; 4], (V3, Vec<[V3; 3]>)> = BTreeMap::new();
        let middle = mesh.vertices.iter().map(|[at, _]| at).sum::<V3>() / mesh.vertices.len().max(1) as f64;
        for corners in &mesh.corners {
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
            let flat = (a[1] - b[1]).norm() < 1e-6 && (a[1] - c[1]).norm() < 1e-6;
            let [x, y, z]: [f64; 3] = a[1].into();
            let key =
                if flat { [x, y, z, a[1].dot(&a[0]) / 10.0].map(|part| (part * 100.0).round() as i64) } else { [0; 4] };
            let group = groups.entry(key).or_insert((if flat { a[1] } else { V3::zeros() }, Vec::new()));
            group.1.push([a[0], b[0], c[0]]);
            if !flat {
                let hollow = (a[1] + b[1] + c[1]).dot(&(a[0] + b[0] + c[0] - middle * 3.0)) < 0.0;
                group.0 += if hollow { V3::zeros() } else { V3::repeat(1.0) };
            }
        }
        for (key, (normal, triangles)) in groups {
            let touched = touches.iter().any(|touch| triangles.iter().any(|one| near(one, *touch)));
            let matter = if touched && matter == Matter::Part { Matter::Touched } else { matter };
            let side = match key {
                [0, 0, 0, 0] if normal == V3::zeros() => "hollow",
                [0, 0, 0, 0] => "round",
                _ => self.side(normal),
            };
            self.faces.push(Face { class: class(matter, side), triangles });
        }
    }

    /// A rod from one point to another.
    fn rod(&mut self, from: V3, to: V3, matter: Matter) {
        let way = to - from;
        if way.norm() > 1e-6 {
            let before = self.faces.len();
            self.round(&[[0.0, 0.0], [ROD, 0.0], [ROD, way.norm()], [0.0, way.norm()]], way.normalize(), from, matter);
            self.join(before);
        }
    }

    fn ball(&mut self, at: V3, radius: f64, matter: Matter) {
        let half = |piece: i32| {
            let (sine, cosine) = (TAU / 2.0 * f64::from(piece) / 16.0).sin_cos();
            [radius * sine, -radius * cosine]
        };
        let before = self.faces.len();
        self.round(&(0..=16).map(half).collect::<Vec<_>>(), V3::z(), at, matter);
        self.join(before);
    }

    /// A body of revolution, as one face.
    fn round(&mut self, outline: &[[f64; 2]], axis: V3, at: V3, matter: Matter) {
        let across = if axis.z.abs() < 0.9 { axis.cross(&V3::z()) } else { axis.cross(&V3::x()) }.normalize();
        let other = axis.cross(&across);
        let point = |[out, up]: [f64; 2], turn: usize| {
            let (sine, cosine) = (TAU * turn as f64 / 48.0).sin_cos();
            at + axis * up + (across * cosine + other * sine) * out
        };
        for ends in outline.windows(2) {
            let [low, high] = [ends[0], ends[1]];
            let turns = (0..48).flat_map(|turn| {
                let [a, b, c, d] = [point(low, turn), point(low, turn + 1), point(high, turn + 1), point(high, turn)];
                [[a, b, c], [a, c, d]]
            });
            let flat = low[1] == high[1];
            let side = if flat { self.side(axis) } else { "round" };
            self.faces.push(Face { class: class(matter, side), triangles: turns.collect() });
        }
    }

    /// A probe whose ball is there; `sought`: it is what is measured.
    fn probe(&mut self, at: V3, ball: f64, along: V3, sought: bool) {
        let sized =
            |outline: &[[f64; 2]]| outline.iter().map(|place| place.map(|part| part * ball)).collect::<Vec<_>>();
        self.ball(at, ball, if sought { Matter::Touched } else { Matter::Ball });
        for (outline, matter) in [(&STYLUS[..], Matter::Stylus), (&BODY[..], Matter::Body), (&RING[..], Matter::Ring)] {
            self.round(&sized(outline), along, at, matter);
        }
    }

    /// Makes one face of those from there on.
    fn join(&mut self, first: usize) {
        let rest = self.faces.split_off(first + 1);
        self.faces[first].triangles.extend(rest.into_iter().flat_map(|face| face.triangles));
    }
}

fn class(matter: Matter, side: &str) -> String {
    format!("{} {side}", format!("{matter:?}").to_lowercase())
}

/// Whether a point lies on a triangle.
fn near([a, b, c]: &[V3; 3], point: V3) -> bool {
    let normal = (b - a).cross(&(c - a));
    let length = normal.norm();
    if length < 1e-9 || ((point - a).dot(&normal) / length).abs() > 0.3 {
        return false;
    }
    let inside = |p: &V3, q: &V3| (q - p).cross(&(point - p)).dot(&normal) / length > -0.5 * (q - p).norm();
    inside(a, b) && inside(b, c) && inside(c, a)
}

/// The variant that stands for an element, with what is left to choose there: the first that measures it; of a corner
/// the outer one, since an inner one looks like a pocket.
fn shown(element: Element) -> Option<(Inputs, Aim)> {
    let all = CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |variant| (*cycle, variant)));
    let of = |(cycle, variant): (&'static Cycle, &'static Variant)| {
        let chosen = check::read(cycle, &choosing(cycle, variant.number), &delivery(cycle.dialect), &mut Vec::new());
        let aim = cycle.aim(&chosen)?;
        let mut control = delivery(cycle.dialect);
        control.plane = cycle.purpose.machine.plane().unwrap_or(Plane::G17);
        let inputs = check::read(cycle, &example(cycle, variant), &control, &mut Vec::new());
        (aim.element == element).then_some((inputs, aim))
    };
    let least = |(inputs, aim): &(Inputs, Aim)| {
        let purpose = &inputs.cycle.purpose;
        let inner = aim.options.contains(&["aim-side", "aim-inside"]);
        (purpose.probe != ProbeUse::Workpiece, purpose.machine == MachineSort::Turning, inner)
    };
    all.filter_map(of).min_by_key(least)
}

/// What is seen of the worked measurement.
fn sight(inputs: &Inputs) -> Sight {
    let How::Staged(staged) = inputs.cycle.picture.how() else { return flat(inputs) };
    let all: Vec<Performed> = tasks(inputs, staged).iter().map(Performed::of).collect();
    let Some(done) = all.first() else { return Sight::default() };
    let mut sight = Sight::of(done.axes);
    let out = |touch: &Touch| (touch.ball - touch.at).try_normalize(1e-9).unwrap_or_else(V3::zeros);
    let seen = |eye: &[f64; 3]| {
        let eye = sight.way(*eye);
        done.touches.iter().map(|touch| out(touch).dot(&eye).max(0.0)).sum::<f64>()
    };
    let best = EYES.iter().map(seen).fold(0.0, f64::max);
    sight.eye = EYES.into_iter().find(|eye| seen(eye) > best - 0.1).unwrap_or(EYES[0]);
    let calibrates = inputs.cycle.purpose.calibrates.holds(inputs);
    let points: Vec<V3> = done.touches.iter().filter(|_| !calibrates).map(|touch| touch.at).collect();
    let held = done.proposal.fixture.iter().filter(|holds| matches!(holds.shape, Shape::Chuck { .. }));
    for solid in done.solids().chain(held) {
        sight.mesh(&placed(solid), Matter::Part, &points);
    }
    for touch in &done.touches {
        sight.rod(touch.start, touch.ball, Matter::Path);
    }
    let eye = sight.paper()[2];
    let nearest = done.touches.iter().max_by(|one, other| out(one).dot(&eye).total_cmp(&out(other).dot(&eye)));
    let Some(touch) = nearest else { return sight };
    if inputs.cycle.purpose.probe == ProbeUse::Tool {
        for piece in &done.tool {
            tool(&mut sight, piece, touch.start);
        }
    } else {
        let along = sight.axes[2];
        sight.probe(touch.ball, done.staging.ball * 1.25, along, calibrates);
    }
    sight
}

/// A piece of a tool that stands here.
fn tool(sight: &mut Sight, piece: &Drawn, stands: V3) {
    match piece {
        Drawn::Round { outline, axis, at } => sight.round(outline, *axis, stands + at, Matter::Tool),
        Drawn::Plate { corners, thick, .. } => {
            let mut mesh = Mesh::default();
            let corners: Vec<V3> = corners.iter().map(|corner| corner + stands).collect();
            let other: Vec<V3> = corners.iter().map(|corner| corner + thick).collect();
            mesh.flat(&corners, -thick.normalize());
            mesh.flat(&other, thick.normalize());
            for (index, corner) in corners.iter().enumerate() {
                let next = (index + 1) % corners.len();
                let normal = (corners[next] - corner).cross(thick).normalize();
                mesh.flat(&[*corner, corners[next], other[next], other[index]], normal);
            }
            sight.mesh(&mesh, Matter::Tool, &[]);
        }
    }
}

/// A solid where it stands.
fn placed(solid: &Solid) -> Mesh {
    let place = solid.place();
    let mut mesh = Mesh::default();
    let own = figure(solid);
    for part in [&own.mesh, &own.cut] {
        mesh.append(part, |[at, normal]| [place.transform_point(&(*at).into()).coords, place.rotation * normal]);
    }
    mesh
}

/// The figures of a help picture on a plate, of a cycle that touches nothing.
fn flat(inputs: &Inputs) -> Sight {
    let mut sight = Sight::of([V3::x(), V3::y(), V3::z()]);
    let How::Own(draw) = inputs.cycle.picture.how() else { return sight };
    let drawn = |shape: &PictureShape| !matches!(shape.kind, ShapeKind::Dimension | ShapeKind::Axis);
    let shapes: Vec<PictureShape> = draw(inputs).shapes.into_iter().filter(drawn).collect();
    let [low, high] = extent(&shapes);
    let scale = LAID / (high[0] - low[0]).max(high[1] - low[1]);
    let place =
        |[x, y]: [f64; 2]| V3::new((x - (low[0] + high[0]) / 2.0) * scale, (y - (low[1] + high[1]) / 2.0) * scale, ROD);
    let size = [0, 1].map(|axis| (high[axis] - low[axis]) * scale * 1.3);
    block(&mut sight, V3::zeros(), [size[0], size[1], 0.1 * LAID]);
    for shape in &shapes {
        let matter = if shape.kind == ShapeKind::Touch { Matter::Touched } else { Matter::Path };
        match shape.circle {
            Some((centre, radius)) if radius * scale < 0.2 * LAID => {
                sight.ball(place(centre), (radius * scale).max(4.0), matter)
            }
            Some((centre, radius)) => {
                let turn = |turn: i32| {
                    let (sine, cosine) = (TAU * f64::from(turn) / 48.0).sin_cos();
                    place([centre[0] + radius * cosine, centre[1] + radius * sine])
                };
                let before = sight.faces.len();
                (0..48).for_each(|piece| sight.rod(turn(piece), turn(piece + 1), matter));
                sight.join(before);
            }
            None if matches!(shape.kind, ShapeKind::Cut | ShapeKind::Material) => {
                let [low, high] = extent(std::slice::from_ref(shape));
                let [width, length] = [0, 1].map(|axis| (high[axis] - low[axis]) * scale);
                let middle = place([0, 1].map(|axis| (low[axis] + high[axis]) / 2.0));
                block(&mut sight, V3::new(middle.x, middle.y, 0.2 * LAID), [width, length, 0.2 * LAID]);
            }
            None => shape.points.windows(2).for_each(|ends| sight.rod(place(ends[0]), place(ends[1]), matter)),
        }
    }
    sight
}

/// A block under a point.
fn block(sight: &mut Sight, top: V3, size: [f64; 3]) {
    let at = crate::geometry::Mcs(top.into());
    let rotation = crate::geometry::Rpy::default();
    let solid = Solid { shape: Shape::Block { size }, at, rotation, errors: PartErrors::default() };
    sight.mesh(&placed(&solid), Matter::Part, &[]);
}

/// The areas of a pictogram, from the back to the front: what each is and its outline.
fn drawn_areas(sight: &Sight) -> Vec<Value> {
    let [right, up, eye] = sight.paper();
    let corners = sight.faces.iter().flat_map(|face| face.triangles.iter().flatten());
    let flat: Vec<[f64; 2]> = corners.map(|corner| [corner.dot(&right), -corner.dot(&up)]).collect();
    let [(left, end), (top, bottom)] = crate::entry::stage::ends(&flat);
    let room = [0, 1].map(|axis| DOTS[axis] as f64 - 2.0 * MARGIN);
    let scale = (room[0] / (end - left)).min(room[1] / (bottom - top)).min(LARGEST);
    let dot = |corner: &V3| {
        let x = (corner.dot(&right) - (left + end) / 2.0) * scale + DOTS[0] as f64 / 2.0;
        let y = (-corner.dot(&up) - (top + bottom) / 2.0) * scale + DOTS[1] as f64 / 2.0;
        V3::new(x, y, corner.dot(&eye))
    };
    let mut canvas = Canvas::new();
    for (index, face) in sight.faces.iter().enumerate() {
        for triangle in &face.triangles {
            canvas.triangle([0, 1, 2].map(|corner| dot(&triangle[corner])), index as u16 + 1);
        }
    }
    let outlines = canvas.outlines();
    outlines.into_iter().map(|(number, path)| json!([sight.faces[number as usize - 1].class, path])).collect()
}

/// The controls that measure an element.
fn controls(element: Element) -> Vec<Dialect> {
    let has = |control: &Dialect| {
        let own = CYCLES.iter().filter(|cycle| cycle.dialect == *control);
        let inputs = |cycle: &'static Cycle, variant: &Variant| {
            check::read(cycle, &choosing(cycle, variant.number), &delivery(cycle.dialect), &mut Vec::new())
        };
        own.flat_map(|cycle| cycle.variants.iter().filter_map(move |variant| cycle.aim(&inputs(cycle, variant))))
            .any(|aim| aim.element == element)
    };
    [Dialect::Sinumerik, Dialect::Nct].into_iter().filter(has).collect()
}

fn all() -> String {
    let mut text = String::from("[\n");
    let one = |element: Element| {
        let shown = shown(element);
        let areas = shown.as_ref().map(|(inputs, _)| drawn_areas(&sight(inputs))).unwrap_or_default();
        let options = shown.map(|(_, aim)| aim.options.iter().map(|[key, answer]| (*key, *answer)).collect());
        let options: BTreeMap<&str, &str> = options.unwrap_or_default();
        let mut one = Map::new();
        one.insert("element".into(), json!(element));
        one.insert("keys".into(), json!(element.keys()));
        one.insert("controls".into(), json!(controls(element)));
        one.insert("options".into(), json!(options));
        one.insert("areas".into(), Value::Array(areas));
        Value::Object(one).to_string()
    };
    text += &Element::ALL.map(one).join(",\n");
    text + "\n]\n"
}

// oracle: self (drawn from the worked measurements; seen)
#[test]
fn pictograms_are_those_of_the_page() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../www/src/start/pictograms.json");
    let text = all();
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert!(text.len() < 40_000, "{}", text.len());
    assert_eq!(std::fs::read_to_string(path).unwrap(), text);
}
