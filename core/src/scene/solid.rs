//! A solid as triangles and edges: each piece of the boundary that can be touched, in the solid's own frame.

use super::crease::creased;
use super::mesh::{Mesh, Vertex};
use crate::geometry::{Feature, LobedWall, Lobes, Quad, Segment, Trim, V3};
use crate::workpiece::{Body, Column, Columns, Form, FreeSurface, Heights, Shape, Solid, chuck};
use std::f64::consts::TAU;

/// How far a triangle lies from the surface that it stands for at most, mm. Its corners lie on it.
pub const CHORD: f64 = 0.02;

/// Into how many pieces the longest face of a body is cut: faces that are drawn one over the other in the order of
/// their distance are small ones, as long ones have no one distance.
const PIECES: f64 = 8.0;

/// What is drawn of a solid, in its own frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Boundary of the solid.
    pub mesh: Mesh,
    /// Faces where it is cut open to show what is inside; nothing touches them.
    pub cut: Mesh,
    /// Edges of the solid, from and to.
    pub edges: Vec<[V3; 2]>,
}

/// How many straight pieces stand for a whole turn about an axis where the curve bends like a circle of this radius,
/// mm: a multiple of 8, so that the corners of a square around it lie on rays through points of it.
pub fn turns(bend: f64, chord: f64) -> usize {
    let least = TAU * (bend / (8.0 * chord)).sqrt();
    (8 * (least / 8.0).ceil() as usize).clamp(24, 1024)
}

/// A solid. A turned part with a bore is drawn in half section, the half on the side of +Y taken away, so that the bore
/// is seen; of a chuck the jaws, which sweep what can be touched of it.
pub fn figure(solid: &Solid) -> Figure {
    match solid.shape {
        Shape::Chuck { .. } => together(&chuck::seen(solid)),
        _ => draw(&Body::new(solid), |_| true),
    }
}

/// The walls of a protection zone alone, as a shaft, web or island has them, with their edges.
pub fn zone(solid: &Solid) -> Figure {
    let form = match solid.form() {
        Form::Columns(columns) => Form::Columns(Columns { plate: false, ..columns }),
        other => other,
    };
    draw(&Body::of(solid.place(), form), |face| face.normal().z.abs() < 0.5)
}

/// Bodies that are in the frame of a solid.
fn together(bodies: &[Body]) -> Figure {
    let mut all = Figure::default();
    for body in bodies {
        let (own, place) = (draw(body, |_| true), body.place);
        let point = |at: V3| place.transform_point(&at.into()).coords;
        all.mesh.append(&own.mesh, |[at, normal]| [point(*at), place.rotation * normal]);
        all.edges.extend(own.edges.iter().map(|ends| ends.map(point)));
    }
    all
}

/// All of a body; of its flat faces those that are shown.
fn draw(body: &Body, shown: impl Fn(&Quad) -> bool) -> Figure {
    if let Some(free) = &body.free {
        return surface(free);
    }
    let halved = match (&body.material[..], &body.cavity) {
        ([Column::Round(outer, length)], Some(Column::Round(bore, depth))) => Some(((outer, *length), (bore, *depth))),
        _ => None,
    };
    let mut drawn = Drawing::of(body, halved.is_some());
    for feature in &body.features {
        match feature {
            Feature::Quad(quad) if shown(quad) => drawn.face(quad),
            Feature::Segment(Segment { a, b }) => drawn.figure.edges.push([*a, *b]),
            Feature::Ball(_, radius) if *radius > 0.0 => drawn.ball(*radius),
            _ => {} // a column brings its walls and rims
        }
    }
    let walls = body.material.iter().map(|column| (column, 1.0)).chain(body.cavity.iter().map(|column| (column, -1.0)));
    for (column, side) in walls {
        if let Column::Round(curve, depth) = column {
            drawn.wall(curve, *depth, side);
        }
    }
    if let Some((outer, bore)) = halved {
        drawn.section(outer, bore);
    }
    drawn.figure
}

struct Drawing {
    /// Angles about its axis, radian: all around, or those of a half section.
    angles: Vec<f64>,
    closed: bool,
    /// Length of a piece of a face, mm.
    piece: f64,
    figure: Figure,
}

impl Drawing {
    fn of(body: &Body, halved: bool) -> Drawing {
        let count = body.features.iter().map(bend).fold(0, |most, bend| most.max(turns(bend, CHORD)));
        let shown = if halved { count / 2..=count } else { 0..=count - 1 };
        let angles = shown.map(|i| TAU * i as f64 / count as f64).collect();
        let piece = (body.extent.high - body.extent.low).max() / PIECES;
        Drawing { angles, closed: !halved, piece, figure: Figure::default() }
    }

    fn pieces(&self, length: f64) -> usize {
        ((length / self.piece).ceil() as usize).clamp(1, PIECES as usize)
    }

    fn curve(&self, curve: &Lobes, z: f64) -> Vec<V3> {
        self.angles.iter().map(|angle| curve.point(*angle, z)).collect()
    }

    /// A cylinder or cone, round or not, from Z = 0 downwards, with its rims; `side`: 1 from outside, -1 from inside.
    fn wall(&mut self, curve: &Lobes, depth: f64, side: f64) {
        let pieces = self.pieces(depth);
        let row = |piece: usize| {
            let z = -depth * piece as f64 / pieces as f64;
            let vertex = |angle: &f64| [curve.point(*angle, z), curve.normal(*angle, z) * side];
            self.angles.iter().map(vertex).collect()
        };
        let rows: Vec<Vec<Vertex>> = (0..=pieces).map(row).collect();
        self.figure.mesh.sheet(&rows, self.closed);
        for z in [0.0, -depth] {
            let rim = self.curve(curve, z);
            self.chain(&rim);
        }
    }

    /// Edges from point to point.
    fn chain(&mut self, points: &[V3]) {
        self.figure.edges.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
        if let ([first, .., last], true) = (points, self.closed) {
            self.figure.edges.push([*last, *first]);
        }
    }

    fn face(&mut self, quad: &Quad) {
        let [a, b, c, d] = quad.corners;
        let z = a.z;
        let Trim { inner, outer } = &quad.trim;
        let rows = match (inner, outer) {
            (None, None) => return self.whole(quad),
            (None, Some(curve)) => vec![vec![V3::new(0.0, 0.0, z); self.angles.len()], self.curve(curve, z)],
            (Some(inner), Some(outer)) => vec![self.curve(inner, z), self.curve(outer, z)],
            (Some(curve), None) => {
                let half = a.sup(&b).sup(&c).sup(&d);
                let rim = self.curve(curve, z);
                let border = rim.iter().map(|point| {
                    let out = (half.x / point.x.abs().max(1e-12)).min(half.y / point.y.abs().max(1e-12));
                    V3::new(point.x * out, point.y * out, z)
                });
                vec![rim.clone(), border.collect()]
            }
        };
        let normal = quad.normal();
        let rows: Vec<Vec<Vertex>> = rows.iter().map(|row| row.iter().map(|at| [*at, normal]).collect()).collect();
        self.figure.mesh.sheet(&rows, self.closed);
    }

    fn whole(&mut self, quad: &Quad) {
        let [a, b, c, d] = quad.corners;
        let normal = quad.normal();
        let across = self.pieces((b - a).norm().max((c - d).norm()));
        let along = self.pieces((d - a).norm().max((c - b).norm()));
        let row = |piece: usize| {
            let part = piece as f64 / along as f64;
            let (from, to) = (a.lerp(&d, part), b.lerp(&c, part));
            (0..=across).map(|piece| [from.lerp(&to, piece as f64 / across as f64), normal]).collect()
        };
        let rows: Vec<Vec<Vertex>> = (0..=along).map(row).collect();
        self.figure.mesh.sheet(&rows, false);
    }

    /// A sphere about the origin, with its equator as edge.
    fn ball(&mut self, radius: f64) {
        let equator = self.curve(&Lobes { radius, slope: 0.0, amplitude: 0.0, count: 0 }, 0.0);
        self.figure.mesh.sheet(&ball(radius, self.angles.len()), true);
        self.chain(&equator);
    }

    /// The faces of a half section, on both sides of the axis: from the bore to the outside, behind it from the axis.
    fn section(&mut self, (outer, length): (&Lobes, f64), (bore, depth): (&Lobes, f64)) {
        for angle in [self.angles.first(), self.angles.last()].into_iter().flatten().copied() {
            let [out, within] = [outer, bore].map(|curve| move |z: f64| curve.point(angle, z));
            let axis = |z: f64| V3::new(0.0, 0.0, z);
            for (from, to) in [(0.0, -depth), (-depth, -length)] {
                let pieces = self.pieces(from - to);
                let row = |piece: usize| {
                    let z = from + (to - from) * piece as f64 / pieces as f64;
                    let begin = if from < 0.0 { axis(z) } else { within(z) };
                    vec![[begin, V3::y()], [out(z), V3::y()]]
                };
                let rows: Vec<Vec<Vertex>> = (0..=pieces).map(row).collect();
                self.figure.cut.sheet(&rows, false);
            }
            let edges = [[within(0.0), out(0.0)], [out(0.0), out(-length)], [out(-length), axis(-length)]];
            self.figure.edges.extend(edges);
            self.figure.edges.extend([[axis(-depth), within(-depth)], [within(-depth), within(0.0)]]);
        }
    }
}

/// Radius of the circle that bends like a piece of a boundary, mm; straight: 0. A ball bends along and across.
fn bend(feature: &Feature) -> f64 {
    let round = |lobes: &Lobes, depth: f64| {
        let waves = f64::from(lobes.count) + 1.0;
        lobes.widest(depth) + lobes.amplitude.abs() * (waves * waves - 1.0)
    };
    match feature {
        Feature::Wall(wall) => round(&wall.lobes(), wall.depth),
        Feature::Lobed(LobedWall { lobes, depth }) => round(lobes, *depth),
        Feature::Ball(_, radius) => 2.0 * radius,
        _ => 0.0,
    }
}

/// Rows of a ball about the origin from its upper to its lower pole.
pub fn ball(radius: f64, around: usize) -> Vec<Vec<Vertex>> {
    let rows = around / 2;
    let angles: Vec<(f64, f64)> = (0..around).map(|i| (TAU * i as f64 / around as f64).sin_cos()).collect();
    let row = |row: usize| {
        let (down, up) = angles[row];
        let out = if row.is_multiple_of(rows) { 0.0 } else { down };
        let vertex = |(sine, cosine): &(f64, f64)| {
            let normal = V3::new(out * cosine, out * sine, up);
            [normal * radius, normal]
        };
        angles.iter().map(vertex).collect()
    };
    (0..=rows).map(row).collect()
}

/// A free surface: heights over a grid shaded smoothly, with their border; other triangles as [`creased`] finds them.
fn surface(free: &FreeSurface) -> Figure {
    let mut drawn = Figure::default();
    let corners = free.mesh.corners();
    let Some(heights) = &free.heights else {
        (drawn.mesh, drawn.edges) = creased(corners, free.mesh.triangles());
        return drawn;
    };
    let Heights { columns, step, values } = heights;
    let rows = corners.len() / columns;
    let height = |column: usize, row: usize| values[row.min(rows - 1) * columns + column.min(columns - 1)];
    let normal = |index: usize| {
        let (column, row) = (index % columns, index / columns);
        let along = height(column.saturating_sub(1), row) - height(column + 1, row);
        let up = height(column, row.saturating_sub(1)) - height(column, row + 1);
        V3::new(along / (2.0 * step[0]), up / (2.0 * step[1]), 1.0).normalize()
    };
    drawn.mesh.vertices = corners.iter().enumerate().map(|(index, at)| [*at, normal(index)]).collect();
    drawn.mesh.corners = free.mesh.triangles().to_vec();
    let mut chain = |places: Vec<usize>| {
        drawn.edges.extend(places.windows(2).map(|ends| [corners[ends[0]], corners[ends[1]]]));
    };
    for row in [0, rows - 1] {
        chain((0..*columns).map(|column| row * columns + column).collect());
    }
    for column in [0, columns - 1] {
        chain((0..rows).map(|row| row * columns + column).collect());
    }
    drawn
}
