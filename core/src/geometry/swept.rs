//! What a ball or a round rod reaches on a stretch of its way, and what it surely does not touch there.
//!
//! Two convex bodies are apart where a direction parts them; a body that goes round an axis and what is round about the
//! same axis are held against each other by distance from it and height. Both bounds are exact for level arcs, so that
//! a whole circle is told free at once unless it comes nearer than the tolerance.

use super::{Circle, Extent, Feature, LobedWall, Lobes, Quad, Segment, Stretch, TOLERANCE, Trim, V3};
use nalgebra::IsometryMatrix3;

/// A ball or a rod on its way; it does not turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swept {
    /// Way of the centre of the ball, or of the foot of the rod.
    pub way: Stretch,
    /// From the foot of the rod to its other end; of a ball zero.
    pub rise: V3,
    /// Radius, mm.
    pub radius: f64,
    /// Whether the rod ends flat; else round.
    pub flat: bool,
}

impl Swept {
    /// As seen from a system that stands at `place`.
    pub fn seen(&self, place: &IsometryMatrix3<f64>) -> Swept {
        Swept { way: self.way.seen(place), rise: place.rotation.inverse() * self.rise, ..*self }
    }

    /// The box along the axes that holds it.
    pub fn extent(&self) -> Extent {
        let [x, y, z] = [V3::x(), V3::y(), V3::z()].map(|axis| self.along(&axis));
        Extent { low: V3::new(x[0], y[0], z[0]), high: V3::new(x[1], y[1], z[1]) }
    }

    /// Whether it surely stays clear of a piece of a boundary that is round about the Z axis, or flat, or straight.
    pub fn clears(&self, feature: &Feature) -> bool {
        match feature {
            Feature::Quad(quad) => self.clears_face(quad),
            Feature::Wall(wall) => self.profile().clears_wall(&wall.lobes(), wall.depth),
            Feature::Lobed(wall) => {
                let LobedWall { lobes, depth } = wall;
                self.profile().clears_wall(lobes, *depth) || self.is_far_from(&wall.foot(&self.middle()))
            }
            Feature::Circle(Circle { radius, z }) => self.profile().clears_ring([*radius; 2], *z),
            Feature::Segment(segment) => self.clears_edge(segment),
            Feature::Ball(centre, size) => self.clears_ball(centre, *size),
        }
    }

    /// Between which values a position times a direction stays, a unit vector.
    fn along(&self, direction: &V3) -> [f64; 2] {
        let [low, high] = self.way.along(direction);
        let rise = self.rise.dot(direction);
        let length = self.rise.norm();
        let thick = match self.flat && length > 0.0 {
            true => self.radius * (1.0 - (rise / length).powi(2)).max(0.0).sqrt(),
            false => self.radius,
        };
        [low + rise.min(0.0) - thick, high + rise.max(0.0) + thick]
    }

    fn clears_face(&self, face: &Quad) -> bool {
        let normal = face.normal();
        let level = face.corners[0].dot(&normal);
        let [low, high] = self.along(&normal);
        if low >= level - TOLERANCE || high <= level + TOLERANCE {
            return true;
        }
        let z = face.corners[0].z;
        let least = face.trim.inner.map_or(0.0, |curve| reach(&curve, z)[0]);
        let most = face.trim.outer.map_or(f64::INFINITY, |curve| reach(&curve, z)[1]);
        face.trim != Trim::default() && self.profile().clears_ring([least, most], z)
    }

    fn clears_edge(&self, Segment { a, b }: &Segment) -> bool {
        let edge = b - a;
        let Some(along) = edge.try_normalize(0.0) else { return self.clears_ball(a, 0.0) };
        if self.way.goes_about(&along) && self.rise.cross(&along).norm() <= TOLERANCE {
            return self.way.from_axis(a)[0] >= self.radius - TOLERANCE;
        }
        let part = ((self.middle() - a).dot(&along) / edge.norm()).clamp(0.0, 1.0);
        let towards = if self.rise == V3::zeros() { self.middle() - (a + edge * part) } else { edge.cross(&self.rise) };
        self.parts(&towards, &[*a, *b], 0.0)
    }

    fn clears_ball(&self, centre: &V3, size: f64) -> bool {
        let reach = self.radius + size - TOLERANCE;
        let apart = match self.rise == V3::zeros() {
            true => self.way.from_point(centre) >= reach,
            false => self.way.goes_about(&self.rise.normalize()) && self.way.from_axis(centre)[0] >= reach,
        };
        apart || self.parts(&(self.middle() - centre), &[*centre], size)
    }

    /// Whether a plane across a direction parts it from balls of this radius about points.
    fn parts(&self, direction: &V3, points: &[V3], size: f64) -> bool {
        let Some(direction) = direction.try_normalize(0.0) else { return false };
        let [low, high] = self.along(&direction);
        let levels = points.iter().map(|point| point.dot(&direction));
        let (least, most) =
            levels.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), level| (least.min(level), most.max(level)));
        low >= most + size - TOLERANCE || high <= least - size + TOLERANCE
    }

    /// Whether no place of it comes as near as its radius to what lies there nearest to its middle; of a ball only.
    fn is_far_from(&self, nearest: &V3) -> bool {
        let reach = self.way.half() + self.radius - TOLERANCE;
        self.rise == V3::zeros() && (self.middle() - nearest).norm() >= reach
    }

    fn middle(&self) -> V3 {
        self.way.at(0.5) + self.rise / 2.0
    }

    /// Distance from the Z axis, and height.
    fn profile(&self) -> Profile {
        let away = if self.way.goes_about(&V3::z()) { self.way.from_axis(&V3::zeros()) } else { self.away() };
        let [low, high] = self.way.along(&V3::z());
        let aside = self.rise.xy().norm();
        let disc = self.flat && aside <= TOLERANCE;
        let wide = aside + if disc { self.radius } else { 0.0 };
        Profile {
            away: [(away[0] - wide).max(0.0), away[1] + wide],
            height: [low + self.rise.z.min(0.0), high + self.rise.z.max(0.0)],
            radius: if disc { 0.0 } else { self.radius },
        }
    }

    /// Least and greatest distance of the way from the Z axis, where it goes round another one: by how far it goes
    /// along the direction from that axis to its middle, and across.
    fn away(&self) -> [f64; 2] {
        let out = self.way.at(0.5).xy();
        let Some(out) = out.try_normalize(0.0) else { return [0.0, self.way.half()] };
        let [low, high] = self.way.along(&V3::new(out.x, out.y, 0.0));
        let [left, right] = self.way.along(&V3::new(-out.y, out.x, 0.0));
        let aside = left.abs().max(right.abs());
        [low.max(0.0), high.max(-low).hypot(aside)]
    }
}

/// Least and greatest radius of a curve at a height.
fn reach(curve: &Lobes, z: f64) -> [f64; 2] {
    let (mean, by) = (curve.radius - curve.slope * z, curve.amplitude.abs());
    [mean - by, mean + by]
}

/// A rectangle of distances from the Z axis and heights, and how thick the line about it is; mm.
struct Profile {
    away: [f64; 2],
    height: [f64; 2],
    radius: f64,
}

impl Profile {
    /// Clear of the ring between two distances at a height.
    fn clears_ring(&self, [inner, outer]: [f64; 2], z: f64) -> bool {
        let aside = (self.away[0] - outer).max(inner - self.away[1]).max(0.0);
        let above = (self.height[0] - z).max(z - self.height[1]).max(0.0);
        aside.hypot(above) >= self.radius - TOLERANCE
    }

    /// Clear of a wall from Z = 0 downwards, of which an endless cone is looked at.
    fn clears_wall(&self, lobes: &Lobes, depth: f64) -> bool {
        let rise = self.height.map(|z| lobes.slope * z.clamp(-depth, 0.0));
        let (least, most) = (rise[0].min(rise[1]), rise[0].max(rise[1]));
        let beyond = lobes.radius + lobes.amplitude.abs();
        let within = lobes.radius - lobes.amplitude.abs();
        let gap = (self.away[0] + least - beyond).max(within - self.away[1] - most);
        gap / lobes.slope.hypot(1.0) >= self.radius - TOLERANCE
    }
}
