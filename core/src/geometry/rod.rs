//! The side of a moving round rod against a piece of a boundary; the rod does not turn. What its ends touch, balls
//! tell.
//!
//! A rod meets a flat or hollow face with an end before its side does, unless it lies along the face; then its side
//! meets the border of the face at the same time. So edges, corners and walls that bulge are all that is left to the
//! side. Where a rod stands across an edge or along a line of a cone, the plane through both directions parts them: its
//! distance changes evenly along the way, and the contact is exact.

use super::{Circle, Extent, Feature, LobedWall, Met, Path, Segment, V3, Wall, earliest};
use nalgebra::IsometryMatrix3;
use std::f64::consts::TAU;

/// Sine of an angle below which two directions are one, so that only ends can tell where they meet.
const PARALLEL: f64 = 1e-9;
/// How fast a rod in contact has to close, mm per mm of its way, to press into what it touches.
const CLOSING: f64 = 1e-9;
/// Directions in which a round edge is looked at that stands askew to the rod; between them the first is closed in. An
/// edge that is grazed by less than the sagitta, 0.00015 of its radius, may be missed.
const AROUND: usize = 180;
/// How many of them lie between one and the next: an early contact is soon found, which shortens the others' way.
const APART: usize = 77;
/// Steps of closing in: 0.618^40 of two directions.
const STEPS: usize = 40;
/// Difference of two ways, mm, that three times one behind the other is none.
const LEVEL: f64 = 1e-12;
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A straight round rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod {
    /// One end of its axis, where it stands before it moves.
    pub foot: V3,
    /// Unit vector from there to the other end.
    pub up: V3,
    /// Length of its axis, mm.
    pub length: f64,
    /// Radius, mm.
    pub radius: f64,
}

impl Rod {
    /// The other end of its axis.
    pub fn top(&self) -> V3 {
        self.foot + self.up * self.length
    }

    /// All that it reaches on a way, its ends round.
    pub fn swept(&self, path: &Path) -> Extent {
        let gone = path.direction * path.length;
        let ends = [self.foot, self.top()].into_iter().flat_map(|end| [end, end + gone]);
        Extent::of(ends).wider(self.radius)
    }

    /// As seen from a system that stands at `place`.
    pub fn seen(&self, place: &IsometryMatrix3<f64>) -> Rod {
        let foot = place.inverse_transform_point(&self.foot.into()).coords;
        Rod { foot, up: place.rotation.inverse() * self.up, ..*self }
    }

    /// Whether a place is beside it, and not beyond one of its ends; so high above its foot.
    fn beside(&self, height: f64) -> bool {
        (0.0..=self.length).contains(&height)
    }

    fn across(&self, vector: &V3) -> V3 {
        vector - self.up * vector.dot(&self.up)
    }
}

/// First contact of the side with a piece of a boundary. Of the path direction and length count. A rod that touches at
/// the start touches at once where it moves into the piece; where it leaves, or goes along it, it is free.
pub fn first(feature: &Feature, rod: &Rod, path: &Path) -> Option<Met> {
    match feature {
        Feature::Quad(_) => None,
        Feature::Segment(Segment { a, b }) => at_edge(a, b, rod, path),
        Feature::Ball(centre, radius) => at_point(centre, *radius, rod, path),
        Feature::Wall(wall) => at_wall(wall, rod, path),
        Feature::Circle(circle) => at_circle(circle, rod, path),
        Feature::Lobed(wall) => at_lobes(wall, rod, path),
    }
}

/// First contact of the side with the edges and corners of a triangle.
pub fn first_on_triangle([a, b, c]: &[V3; 3], rod: &Rod, path: &Path) -> Option<Met> {
    let edges = [(a, b), (b, c), (c, a)].into_iter().filter_map(|(a, b)| at_edge(a, b, rod, path));
    let corners = [a, b, c].into_iter().filter_map(|corner| at_point(corner, 0.0, rod, path));
    earliest(edges.chain(corners))
}

/// With a point, or a ball of this radius about it.
fn at_point(centre: &V3, radius: f64, rod: &Rod, path: &Path) -> Option<Met> {
    let from = rod.across(&(rod.foot - centre));
    let way = rod.across(&path.direction);
    let reach = rod.radius + radius;
    let speed = way.norm_squared();
    let closing = -from.dot(&way);
    if speed < PARALLEL * PARALLEL || closing <= CLOSING * from.norm() {
        return None;
    }
    let closest = closing / speed;
    let left = reach * reach - (from + way * closest).norm_squared();
    if left < 0.0 {
        return None;
    }
    let reached = (closest - (left / speed).sqrt()).max(0.0);
    let axis = rod.foot + path.direction * reached;
    let height = (centre - axis).dot(&rod.up);
    if reached > path.length || !rod.beside(height) {
        return None;
    }
    let away = axis + rod.up * height - centre;
    let normal = away.try_normalize(0.0).unwrap_or(-path.direction);
    Some(Met { way: reached, point: centre + normal * radius, normal })
}

/// With a straight edge; the rod stands across it.
fn at_edge(a: &V3, b: &V3, rod: &Rod, path: &Path) -> Option<Met> {
    let across = (b - a).cross(&rod.up);
    let size = across.norm();
    if size < PARALLEL * (b - a).norm() {
        return None;
    }
    let normal = across / size;
    let normal = normal * (rod.foot - a).dot(&normal).signum();
    at_line(a, b, &normal, rod, path)
}

/// With a line whose normal towards the rod stands across both. The rod comes from the side of the normal.
fn at_line(a: &V3, b: &V3, normal: &V3, rod: &Rod, path: &Path) -> Option<Met> {
    let gap = (rod.foot - a).dot(normal);
    let closing = -path.direction.dot(normal);
    if closing <= CLOSING || gap < 0.0 {
        return None;
    }
    let reached = ((gap - rod.radius) / closing).max(0.0);
    if reached > path.length {
        return None;
    }
    let edge = b - a;
    let away = rod.foot + path.direction * reached - a;
    let span = edge.cross(&rod.up).dot(normal);
    let part = away.cross(&rod.up).dot(normal) / span;
    let height = away.cross(&edge).dot(normal) / span;
    let crossed = (0.0..=1.0).contains(&part) && rod.beside(height);
    crossed.then(|| Met { way: reached, point: a + edge * part, normal: *normal })
}

/// With a cylinder or cone from outside: along one of the two lines whose normals stand across the rod.
fn at_wall(wall: &Wall, rod: &Rod, path: &Path) -> Option<Met> {
    let tilt = rod.up.xy().norm();
    if wall.inner || tilt < PARALLEL {
        return None;
    }
    let half = (-wall.slope * rod.up.z / tilt).acos(); // NaN, which meets nothing, for a rod steeper than the cone
    let towards = rod.up.y.atan2(rod.up.x);
    let lines = [towards + half, towards - half].into_iter();
    earliest(lines.filter_map(|angle| {
        let out = V3::new(angle.cos(), angle.sin(), 0.0);
        let normal = (out + V3::z() * wall.slope).normalize();
        let top = out * wall.radius;
        let bottom = top + (out * wall.slope - V3::z()) * wall.depth;
        at_line(&top, &bottom, &normal, rod, path)
    }))
}

/// With a round edge, from inside or outside.
fn at_circle(circle: &Circle, rod: &Rod, path: &Path) -> Option<Met> {
    let on = |angle: f64| circle.point(angle);
    if rod.up.xy().norm() >= PARALLEL {
        let first = |angle: f64, path: &Path| at_point(&on(angle), 0.0, rod, path);
        return around(path, circle.radius, first);
    }
    let from = rod.foot.xy();
    if from.norm() > circle.radius {
        let centre = V3::z() * circle.z;
        return at_point(&centre, circle.radius, rod, path);
    }
    let room = circle.radius - rod.radius;
    let way = path.direction.xy();
    let (speed, outward) = (way.norm_squared(), from.dot(&way));
    if speed < PARALLEL * PARALLEL {
        return None;
    }
    let left = outward * outward - speed * (from.norm_squared() - room.abs() * room);
    let reached = ((left.max(0.0).sqrt() - outward) / speed).max(0.0);
    let axis = rod.foot + path.direction * reached;
    let leaving = axis.xy().dot(&way) > CLOSING * circle.radius;
    let height = (circle.z - axis.z) * rod.up.z;
    if reached > path.length || !leaving || !rod.beside(height) {
        return None;
    }
    let point = on(axis.y.atan2(axis.x));
    let normal = (axis.xy() - point.xy()).try_normalize(0.0)?;
    Some(Met { way: reached, point, normal: V3::new(normal.x, normal.y, 0.0) })
}

/// With a wall that is out of round: its lines from rim to rim, and the ends of those.
fn at_lobes(LobedWall { lobes, depth }: &LobedWall, rod: &Rod, path: &Path) -> Option<Met> {
    around(path, lobes.radius, |angle, path| {
        let [top, bottom] = [0.0, -depth].map(|z| lobes.point(angle, z));
        let edge = at_edge(&top, &bottom, rod, path);
        let ends = [top, bottom].into_iter().filter_map(|end| at_point(&end, 0.0, rod, path));
        earliest(edge.into_iter().chain(ends))
    })
}

/// How far beyond the end of the path [`around`] follows what stands so far from the axis, mm.
pub fn overrun(radius: f64) -> f64 {
    TAU / AROUND as f64 * radius
}

/// The earliest contact with what is in all directions about an axis, `radius` mm from it, by its angle in radians.
/// Between two directions it comes sooner than in them: these are followed so far beyond the end of the path, and
/// beyond the earliest contact so far, as they are apart.
pub fn around(path: &Path, radius: f64, first: impl Fn(f64, &Path) -> Option<Met>) -> Option<Met> {
    let pitch = TAU / AROUND as f64;
    let within = |length: f64| Path { length: length.min(path.length) + overrun(radius), ..*path };
    let mut beyond = within(f64::INFINITY);
    let mut found: Option<(f64, Met)> = None;
    let spread = (0..AROUND).map(|step| (step * APART) % AROUND);
    for angle in spread.map(|step| step as f64 * pitch) {
        let Some(met) = first(angle, &beyond) else { continue };
        if found.is_none_or(|(_, before)| met.way < before.way) {
            found = Some((angle, met));
            beyond = within(met.way);
        }
    }
    let (angle, best) = found?;
    let met = closed_in(best, [angle - pitch, angle + pitch], |angle| first(angle, &beyond));
    (met.way <= path.length).then_some(met)
}

/// The earliest contact between two directions, by golden section.
fn closed_in(mut best: Met, [mut low, mut high]: [f64; 2], first: impl Fn(f64) -> Option<Met>) -> Met {
    let mut look = |angle: f64| {
        let met = first(angle);
        let way = met.map_or(f64::INFINITY, |met| met.way);
        best = met.filter(|met| met.way < best.way).unwrap_or(best);
        way
    };
    let step = GOLDEN * (high - low);
    let [mut left, mut right] = [high - step, low + step];
    let [mut at_left, mut at_right] = [look(left), look(right)];
    let mut level = 0;
    for _ in 0..STEPS {
        level = if (at_left - at_right).abs() < LEVEL { level + 1 } else { 0 };
        if level == 3 {
            break;
        }
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = look(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = look(right);
        }
    }
    best
}

/// First contact of the foot, which is flat, with what stands out from a boundary below it.
pub fn first_below(feature: &Feature, rod: &Rod, path: &Path) -> Option<Met> {
    let closing = -path.direction.dot(&rod.up);
    if closing <= CLOSING {
        return None;
    }
    let below = |point: V3, path: &Path| {
        let gap = (rod.foot - point).dot(&rod.up);
        let reached = gap / closing;
        let axis = rod.foot + path.direction * reached;
        let within = rod.across(&(point - axis)).norm() <= rod.radius;
        (gap >= 0.0 && reached <= path.length && within).then_some(Met { way: reached, point, normal: rod.up })
    };
    let turned = |radius: f64, on: &dyn Fn(f64) -> V3| around(path, radius, |angle, path| below(on(angle), path));
    match feature {
        Feature::Quad(_) | Feature::Wall(_) => None,
        Feature::Segment(Segment { a, b }) => {
            let parts = (0..=AROUND).map(|step| step as f64 / AROUND as f64);
            earliest(parts.filter_map(|part| below(a + (b - a) * part, path)))
        }
        Feature::Ball(centre, radius) => below(centre + rod.up * *radius, path),
        Feature::Circle(circle) => turned(circle.radius, &|angle| circle.point(angle)),
        Feature::Lobed(LobedWall { lobes, depth }) => {
            let rims = [0.0, -depth].map(|z| turned(lobes.radius, &|angle| lobes.point(angle, z)));
            earliest(rims.into_iter().flatten())
        }
    }
}
