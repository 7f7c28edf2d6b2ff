//! First contact of a moving ball with the part, to 1e-9 mm.

use super::Workpiece;
use super::body::Body;
use crate::geometry::extent::Extent;
use crate::geometry::feature::{first as first_on, foot};
use crate::geometry::mesh::{Mesh, Stand};
use crate::geometry::{Path, TOLERANCE, V3};

/// What a ball meets on a straight way. Machine coordinates, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Nothing.
    None,
    /// It already reaches into the part at the start.
    Already {
        /// Nearest point of the surface.
        point: [f64; 3],
        /// Outward unit normal there.
        normal: [f64; 3],
        /// How deep the ball reaches into the part.
        depth: f64,
    },
    /// It begins to touch. A ball that touches at the start and moves into the part hits at 0;
    /// one that moves away or along the surface is free.
    Hit {
        /// Part of the way, 0 to 1.
        t: f64,
        /// Centre of the ball.
        ball: [f64; 3],
        /// Point touched.
        point: [f64; 3],
        /// Outward unit normal of the part there.
        normal: [f64; 3],
    },
}

/// A part taken apart into what a ball can touch: made once, asked for every motion.
#[derive(Clone, Debug)]
pub struct Boundary {
    pub(super) bodies: Vec<Body>,
}

impl Boundary {
    /// That of a part.
    pub fn of(workpiece: &Workpiece) -> Boundary {
        Boundary { bodies: workpiece.solids.iter().map(Body::new).collect() }
    }

    /// First contact of a ball whose centre moves from `from` to `to`.
    pub fn first(&self, ball_radius: f64, from: [f64; 3], to: [f64; 3]) -> Contact {
        let way = Path::new(V3::from(from), V3::from(to));
        let mut nearest: Option<(f64, V3, V3)> = None;
        for body in &self.bodies {
            let own = Path {
                from: body.place.inverse_transform_point(&way.from.into()).coords,
                direction: body.place.rotation.inverse() * way.direction,
                length: way.length,
            };
            match start(body, &own, ball_radius) {
                Start::Already(point, normal, depth) => {
                    let point = body.place.transform_point(&point.into()).coords;
                    let normal = body.place.rotation * normal;
                    return Contact::Already { point: point.into(), normal: normal.into(), depth };
                }
                Start::Pressed(point, normal) => nearest = Some(placed(body, 0.0, point, normal)),
                Start::Free => {
                    let limit = nearest.map_or(f64::INFINITY, |(s, ..)| s);
                    if let Some((s, point, normal)) = hit(body, &own, ball_radius)
                        && s < limit
                    {
                        nearest = Some(placed(body, s, point, normal));
                    }
                }
            }
        }
        nearest.map_or(Contact::None, |(s, point, normal)| Contact::Hit {
            t: if way.length > 0.0 { s / way.length } else { 0.0 },
            ball: way.at(s).into(),
            point: point.into(),
            normal: normal.into(),
        })
    }

    /// Distance of a point from the surface of the nearest solid, mm, negative inside; infinite where there is none.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        self.bodies.iter().fold(f64::INFINITY, |least, body| {
            let own = body.place.inverse_transform_point(&V3::from(p).into()).coords;
            let distance = surface(body, &own, f64::INFINITY);
            let distance = distance.map_or(f64::INFINITY, |(_, distance)| distance);
            least.min(if body.inside(&own) { -distance } else { distance })
        })
    }
}

enum Start {
    Free,
    Already(V3, V3, f64),
    Pressed(V3, V3),
}

/// How the ball stands at the start of the way.
fn start(body: &Body, path: &Path, radius: f64) -> Start {
    if let Some(free) = &body.free {
        return start_at_mesh(&free.mesh, path, radius);
    }
    let inside = body.inside(&path.from);
    let reach = if inside { f64::INFINITY } else { radius + TOLERANCE };
    let Some((point, distance)) = surface(body, &path.from, reach) else {
        return Start::Free;
    };
    let depth = if inside { radius + distance } else { radius - distance };
    if depth > TOLERANCE {
        let away = path.from - point;
        let normal = if inside { -away } else { away };
        return Start::Already(point, normal.try_normalize(0.0).unwrap_or_else(V3::z), depth);
    }
    if depth < -TOLERANCE {
        return Start::Free;
    }
    for feature in &body.features {
        let Some(point) = foot(feature, &path.from) else {
            continue;
        };
        let away = path.from - point;
        let normal = away.try_normalize(0.0).unwrap_or_else(V3::z);
        if away.norm() <= radius + TOLERANCE && normal.dot(&path.direction) < -1e-12 {
            return Start::Pressed(point, normal);
        }
    }
    Start::Free
}

/// The same at a surface of triangles. A ball that stands is inside also where it is altogether under the surface.
fn start_at_mesh(mesh: &Mesh, path: &Path, radius: f64) -> Start {
    match mesh.stand(path, radius) {
        Stand::Inside(point, normal, depth) => Start::Already(point, normal, depth),
        Stand::Pressed(point, normal) => Start::Pressed(point, normal),
        Stand::Free if path.length == 0.0 && mesh.covers(&path.from) => Start::Already(path.from, V3::z(), radius),
        Stand::Free => Start::Free,
    }
}

/// Nearest point of the surface, and its distance; none beyond `reach`, mm.
fn surface(body: &Body, p: &V3, reach: f64) -> Option<(V3, f64)> {
    if let Some(free) = &body.free {
        return free.mesh.nearest(p, reach);
    }
    let mut nearest = None;
    let mut limit = reach;
    for (feature, extent) in body.features.iter().zip(&body.extents) {
        if extent.distance(p) > limit || feature.is_beyond(p, limit) {
            continue;
        }
        let Some(point) = foot(feature, p) else {
            continue;
        };
        let distance = (p - point).norm();
        if distance <= limit && nearest.is_none_or(|(_, before)| distance < before) {
            limit = distance;
            nearest = Some((point, distance));
        }
    }
    nearest
}

/// First contact with the boundary of a solid; faces win over their own edges.
fn hit(body: &Body, path: &Path, radius: f64) -> Option<(f64, V3, V3)> {
    if let Some(free) = &body.free {
        let (s, point) = free.mesh.first(path, radius)?;
        return Some((s, point, (path.at(s) - point).try_normalize(0.0)?));
    }
    let mut nearest: Option<(f64, V3, V3)> = None;
    let swept = Extent::of([path.from, path.at(path.length)]).wider(radius);
    for (feature, extent) in body.features.iter().zip(&body.extents) {
        if !extent.meets(&swept) {
            continue;
        }
        let Some(s) = first_on(feature, path, radius) else {
            continue;
        };
        if nearest.is_some_and(|(before, ..)| s > before - 1e-11) {
            continue;
        }
        let ball = path.at(s);
        let Some(point) = foot(feature, &ball) else {
            continue;
        };
        let normal = (ball - point).try_normalize(0.0).unwrap_or(-path.direction);
        nearest = Some((s, point, normal));
    }
    nearest
}

fn placed(body: &Body, s: f64, point: V3, normal: V3) -> (f64, V3, V3) {
    (s, body.place.transform_point(&point.into()).coords, body.place.rotation * normal)
}
