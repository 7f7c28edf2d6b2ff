//! First contact of a moving ball with the part, to 1e-9 mm.

use super::{Body, Obstacle, Touching, Workpiece};
use crate::geometry::feature::{first as first_on, foot};
use crate::geometry::{Dir, Extent, Mcs, Met, Path, Stand, TOLERANCE, V3, earliest};

/// What a ball meets on a straight way of its centre. Machine coordinates, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Nothing.
    None,
    /// It already reaches into the part at the start, so deep; the point is the nearest one of the surface.
    Already(Obstacle, f64),
    /// It begins to touch; at 0 where it touches at the start and moves into the part, not along or away.
    Hit(Obstacle),
}

impl Contact {
    /// What is met on a way of this length, mm; at once what the ball reaches into.
    pub(super) fn met(&self, length: f64) -> Option<Met> {
        let (Contact::Already(met, _) | Contact::Hit(met)) = self else { return None };
        Some(Met { way: met.part * length, point: met.point.into(), normal: met.normal.into() })
    }
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

    /// Whether there is nothing to touch.
    pub fn is_nothing(&self) -> bool {
        self.bodies.is_empty()
    }

    /// First contact of a ball whose centre moves from `from` to `to`.
    pub fn first(&self, ball_radius: f64, from: Mcs, to: Mcs) -> Contact {
        let way = Path::new(V3::from(from), V3::from(to));
        let mut nearest: Option<Met> = None;
        for body in &self.bodies {
            let own = way.seen(&body.place);
            let met = match stand(body, &own, ball_radius) {
                Stand::Inside(point, normal, depth) => {
                    let met = Met { way: 0.0, point, normal }.placed(&body.place);
                    return Contact::Already(Obstacle::on(&way, &met, Touching::Ball), depth);
                }
                Stand::Pressed(point, normal) => Some(Met { way: 0.0, point, normal }),
                Stand::Free => hit(body, &own, ball_radius),
            };
            nearest = earliest(nearest.into_iter().chain(met.map(|met| met.placed(&body.place))));
        }
        nearest.map_or(Contact::None, |met| Contact::Hit(Obstacle::on(&way, &met, Touching::Ball)))
    }

    /// How far the part reaches in a direction, by the boxes around its solids, mm; minus infinity where there is none.
    pub fn farthest(&self, direction: Dir<Mcs>) -> f64 {
        self.bodies.iter().map(|body| body.farthest(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Distance of a point from the surface of the nearest solid, mm, negative inside; infinite where there is none.
    pub fn distance(&self, p: Mcs) -> f64 {
        self.bodies.iter().fold(f64::INFINITY, |least, body| {
            let own = body.place.inverse_transform_point(&V3::from(p).into()).coords;
            let distance = surface(body, &own, f64::INFINITY);
            let distance = distance.map_or(f64::INFINITY, |(_, distance)| distance);
            least.min(if body.inside(&own) { -distance } else { distance })
        })
    }
}

/// How the ball stands at the start; without a way also below a surface of triangles it is inside.
fn stand(body: &Body, path: &Path, radius: f64) -> Stand {
    if let Some(free) = &body.free {
        return match free.mesh.stand(path, radius) {
            Stand::Free if path.length == 0.0 && free.mesh.covers(&path.from) => {
                Stand::Inside(path.from, V3::z(), radius)
            }
            stand => stand,
        };
    }
    let inside = body.inside(&path.from);
    let reach = if inside { f64::INFINITY } else { radius + TOLERANCE };
    let Some((point, distance)) = surface(body, &path.from, reach) else { return Stand::Free };
    let depth = if inside { radius + distance } else { radius - distance };
    if depth > TOLERANCE {
        let away = path.from - point;
        let normal = if inside { -away } else { away };
        return Stand::Inside(point, normal.try_normalize(0.0).unwrap_or_else(V3::z), depth);
    }
    if depth < -TOLERANCE {
        return Stand::Free;
    }
    let mut pressed = body.features.iter().filter_map(|feature| {
        let point = foot(feature, &path.from)?;
        let away = path.from - point;
        let normal = away.try_normalize(0.0).unwrap_or_else(V3::z);
        let moves_in = away.norm() <= radius + TOLERANCE && normal.dot(&path.direction) < -1e-12;
        moves_in.then_some(Stand::Pressed(point, normal))
    });
    pressed.next().unwrap_or(Stand::Free)
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
        let Some(point) = foot(feature, p) else { continue };
        let distance = (p - point).norm();
        if distance <= limit && nearest.is_none_or(|(_, before)| distance < before) {
            limit = distance;
            nearest = Some((point, distance));
        }
    }
    nearest
}

/// First contact with the boundary of a solid; faces win over their own edges.
fn hit(body: &Body, path: &Path, radius: f64) -> Option<Met> {
    if let Some(free) = &body.free {
        return free.mesh.first(path, radius);
    }
    let mut nearest: Option<Met> = None;
    let swept = Extent::of([path.from, path.at(path.length)]).wider(radius);
    for (feature, extent) in body.features.iter().zip(&body.extents) {
        if !extent.meets(&swept) {
            continue;
        }
        let sooner = |way: &f64| nearest.is_none_or(|before| *way <= before.way - 1e-11);
        let Some(way) = first_on(feature, path, radius).filter(sooner) else { continue };
        let ball = path.at(way);
        let Some(point) = foot(feature, &ball) else { continue };
        let normal = (ball - point).try_normalize(0.0).unwrap_or(-path.direction);
        nearest = Some(Met { way, point, normal });
    }
    nearest
}
