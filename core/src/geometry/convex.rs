//! First contact of two convex bodies, of which one moves along a straight way without turning.
//!
//! A body is known by the point that lies farthest in a direction. Where two bodies are apart, the plane across their
//! shortest distance parts them; the moving one reaches the other not before that plane is passed. So the way may be
//! gone up to the plane, and each further distance is a fraction of the square of the one before.

use super::{Met, Path, V3};

/// Gap that counts as contact, mm; far below [`super::TOLERANCE`].
const CONTACT: f64 = 1e-11;
/// How far the distance may be from the least one, mm.
const EXACT: f64 = 1e-12;
/// Steps after which a search is given up; a contact needs about five, a plane about twenty.
const STEPS: usize = 60;
/// Directions that close by less than this per mm do not meet.
const PARALLEL: f64 = 1e-13;

/// A convex body.
pub trait Convex {
    /// Point of the body that lies farthest in a direction of any length.
    fn farthest(&self, direction: &V3) -> V3;
}

/// A plane that parts two bodies: width of the gap across it, mm, nearest point of the second body, normal towards the
/// first. The gap is the distance, to the square of the distance; none where the bodies touch or overlap.
fn parted(moving: &impl Convex, other: &impl Convex, moved: &V3) -> Option<(f64, V3, V3)> {
    let mut simplex = Simplex::default();
    let mut nearest = Corner::of(moving, other, moved, &V3::x());
    let mut widest: Option<(f64, V3, V3)> = None;
    for _ in 0..STEPS {
        let distance = nearest.gap.norm();
        if distance <= CONTACT {
            return None;
        }
        let normal = across(simplex.corners(), nearest.gap / distance);
        let next = Corner::of(moving, other, moved, &-normal);
        let gap = normal.dot(&next.gap);
        if widest.is_none_or(|(before, ..)| gap > before) {
            widest = Some((gap, nearest.point, normal));
        }
        let exact = distance - gap <= EXACT.max(1e-3 * distance * distance);
        let mut known = simplex.corners().iter();
        if exact || known.any(|corner| corner.gap == next.gap) {
            break;
        }
        simplex.push(next);
        (nearest, simplex) = nearest_of(&simplex)?;
    }
    widest.filter(|(gap, ..)| *gap > 0.0)
}

/// Unit vector across the gap towards the first body, which is moved so far; none where they touch or overlap.
pub fn normal(moving: &impl Convex, other: &impl Convex, moved: &V3) -> Option<V3> {
    parted(moving, other, moved).map(|(.., normal)| normal)
}

/// First contact of a body that moves along the path, from where it stands; the path tells direction and length only.
/// Where both touch at the start, the normal is against the way.
pub fn first(moving: &impl Convex, other: &impl Convex, path: &Path) -> Option<Met> {
    let mut way = 0.0;
    let mut met: Option<(V3, V3)> = None;
    for _ in 0..STEPS {
        let Some((gap, point, normal)) = parted(moving, other, &(path.direction * way)) else { break };
        let closing = -normal.dot(&path.direction);
        if closing <= PARALLEL {
            return None;
        }
        met = Some((point, normal));
        way += gap / closing;
        if way > path.length {
            return None;
        }
        if gap <= CONTACT {
            break;
        }
    }
    let (point, normal) = met.unwrap_or_else(|| {
        let touched = other.farthest(&-path.direction);
        (touched, -path.direction)
    });
    Some(Met { way, point, normal })
}

/// The direction from the origin to what lies between corners, sharper than the rough one, a small difference of large
/// numbers: what stands across an edge or a triangle does not suffer from that.
fn across(corners: &[Corner], rough: V3) -> V3 {
    let sharp = match corners {
        [a, b] => (b.gap - a.gap).try_normalize(0.0).map(|edge| rough - edge * rough.dot(&edge)),
        [a, b, c] => {
            let normal = (b.gap - a.gap).cross(&(c.gap - a.gap));
            Some(normal * normal.dot(&rough).signum())
        }
        _ => None,
    };
    sharp.and_then(|normal| normal.try_normalize(1e-12)).unwrap_or(rough)
}

/// A point of the difference of both bodies.
#[derive(Clone, Copy, Debug, Default)]
struct Corner {
    /// Point of the moving body minus point of the other.
    gap: V3,
    /// Point of the other body.
    point: V3,
}

impl Corner {
    fn of(moving: &impl Convex, other: &impl Convex, moved: &V3, direction: &V3) -> Corner {
        let point = other.farthest(&-direction);
        Corner { gap: moving.farthest(direction) + moved - point, point }
    }
}

/// Up to four corners, kept where they are: a search makes hundreds of them.
#[derive(Clone, Copy, Debug, Default)]
struct Simplex {
    all: [Corner; 4],
    count: usize,
}

impl Simplex {
    fn corners(&self) -> &[Corner] {
        &self.all[..self.count]
    }

    /// One more; a fifth is left out.
    fn push(&mut self, corner: Corner) {
        if let Some(place) = self.all.get_mut(self.count) {
            *place = corner;
            self.count += 1;
        }
    }

    /// Corners whose bit is set.
    fn chosen(&self, bits: usize) -> impl Iterator<Item = &Corner> {
        self.corners().iter().enumerate().filter(move |(index, _)| bits >> index & 1 == 1).map(|(_, corner)| corner)
    }
}

/// The point nearest to the origin between the corners, and those that span it; none where it lies inside of four.
fn nearest_of(simplex: &Simplex) -> Option<(Corner, Simplex)> {
    let mut found: Option<(f64, Corner, usize)> = None;
    for bits in 1..1_usize << simplex.count {
        let mut gaps = [V3::zeros(); 4];
        let count = simplex.chosen(bits).zip(&mut gaps).map(|(corner, gap)| *gap = corner.gap).count();
        let Some(weights) = weights(&gaps[..count]) else { continue };
        if count == 4 {
            return None;
        }
        let mut nearest = Corner::default();
        for (corner, weight) in simplex.chosen(bits).zip(weights) {
            nearest.gap += corner.gap * weight;
            nearest.point += corner.point * weight;
        }
        let distance = nearest.gap.norm();
        if found.is_none_or(|(least, ..)| distance < least) {
            found = Some((distance, nearest, bits));
        }
    }
    let (_, nearest, bits) = found?;
    let mut chosen = Simplex::default();
    simplex.chosen(bits).for_each(|corner| chosen.push(*corner));
    Some((nearest, chosen))
}

/// Weights of points that give the foot of the origin on what they span; none: it lies beside, or they span less.
fn weights(points: &[V3]) -> Option<[f64; 4]> {
    let (first, rest) = points.split_first()?;
    let side = |index: usize| rest.get(index).map(|point| point - first);
    let parts = match [side(0), side(1), side(2)] {
        [Some(a), Some(b), Some(c)] => {
            let volume = a.cross(&b).dot(&c);
            let part = |p: V3, q: V3| -p.cross(&q).dot(first) / volume;
            [part(b, c), part(c, a), part(a, b)]
        }
        [Some(a), Some(b), None] => {
            let normal = a.cross(&b);
            let size = normal.norm_squared();
            let part = |across: V3| across.dot(first) / -size;
            [part(b.cross(&normal)), part(normal.cross(&a)), 0.0]
        }
        [Some(a), ..] => [-first.dot(&a) / a.norm_squared(), 0.0, 0.0],
        _ => [0.0; 3],
    };
    let [a, b, c] = parts;
    let weights = [1.0 - (a + b + c), a, b, c];
    let inside = weights.iter().all(|weight| *weight >= 0.0 && weight.is_finite());
    inside.then_some(weights)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    struct Ball(V3, f64);

    impl Convex for Ball {
        fn farthest(&self, direction: &V3) -> V3 {
            let Ball(centre, radius) = self;
            centre + direction.try_normalize(0.0).unwrap_or_else(V3::x) * *radius
        }
    }

    struct Cube(f64);

    impl Convex for Cube {
        fn farthest(&self, direction: &V3) -> V3 {
            direction.map(|part| self.0.copysign(part))
        }
    }

    fn meeting(from: [f64; 3], to: [f64; 3], radius: f64) -> Option<Met> {
        let path = Path::new(from.into(), to.into());
        first(&Ball(path.from, radius), &Cube(10.0), &path)
    }

    #[test]
    fn a_ball_meets_face_edge_and_corner() {
        // oracle: hand: the ball of 5 mm stands off a face by its radius; before an edge or a corner its centre is 5 mm
        // away
        let face = meeting([30.0, 2.0, 3.0], [0.0, 2.0, 3.0], 5.0).unwrap();
        assert!((face.way - 15.0).abs() < 1e-9, "{face:?}");
        assert!((face.normal - V3::x()).norm() < 1e-9);
        let edge = meeting([30.0, 13.0, 1.0], [0.0, 13.0, 1.0], 5.0).unwrap();
        assert!((edge.way - 16.0).abs() < 1e-9, "{edge:?}");
        assert!((edge.point - V3::new(10.0, 10.0, 1.0)).norm() < 1e-6);
        let corner = meeting([30.0, 12.0, 11.0], [0.0, 12.0, 11.0], 3.0).unwrap();
        assert!((corner.way - 18.0).abs() < 1e-9, "{corner:?}");
    }

    #[test]
    fn what_passes_or_leaves_does_not_meet() {
        // oracle: hand
        assert_eq!(meeting([30.0, 15.1, 0.0], [-30.0, 15.1, 0.0], 5.0), None);
        assert_eq!(meeting([20.0, 0.0, 0.0], [40.0, 0.0, 0.0], 5.0), None);
        assert_eq!(meeting([30.0, 0.0, 0.0], [15.1, 0.0, 0.0], 5.0), None);
        let inside = meeting([12.0, 0.0, 0.0], [40.0, 0.0, 0.0], 5.0).unwrap();
        assert_eq!(inside.way, 0.0);
    }

    #[test]
    fn two_balls_meet_where_their_centres_are_a_sum_of_radii_apart() {
        // oracle: hand: quadratic equation of the distance of the centres
        for (across, one, other) in [(0.3, 0.4, 20.0), (7.0, 5.0, 3.0), (22.0, 2.0, 20.5)] {
            let (from, to) = ([50.0, across, 0.5], [-50.0, across, 0.5]);
            let path = Path::new(from.into(), to.into());
            let found = first(&Ball(path.from, one), &Ball(V3::zeros(), other), &path).unwrap();
            let reach: f64 = one + other;
            let along = (reach * reach - across * across - 0.25).sqrt();
            assert!((found.way - (50.0 - along)).abs() < 1e-9, "{found:?} {along}");
        }
    }
}
