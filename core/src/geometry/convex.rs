//! First contact of two convex bodies, of which one moves along a straight way without turning.
//!
//! A body is known by the point that lies farthest in a direction. Where two bodies are apart, the plane across their
//! shortest distance parts them; the moving one reaches the other not before that plane is passed. So the way may be
//! gone up to the plane, and each further distance is a fraction of the square of the one before.

use super::{Path, V3};

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
    /// Its point that lies farthest in a direction of any length.
    fn farthest(&self, direction: &V3) -> V3;
}

/// Where the moving body meets the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Length of the way until then, mm; 0 where they touch at the start already.
    pub way: f64,
    /// Point of the other body that is touched.
    pub point: V3,
    /// Unit normal there, from the other body to the moving one; against the way where they touch at the start.
    pub normal: V3,
}

/// A plane that parts two bodies: how wide the gap across it is, mm, what is nearest to it on the second body, and its
/// normal towards the first. The gap is the distance, to the square of the distance; none where the bodies touch or overlap.
fn parted(moving: &impl Convex, other: &impl Convex, moved: &V3) -> Option<(f64, V3, V3)> {
    let mut corners: Vec<Corner> = Vec::with_capacity(4);
    let mut nearest = Corner::of(moving, other, moved, &V3::x());
    let mut widest: Option<(f64, V3, V3)> = None;
    for _ in 0..STEPS {
        let distance = nearest.gap.norm();
        if distance <= CONTACT {
            return None;
        }
        let normal = across(&corners, nearest.gap / distance);
        let next = Corner::of(moving, other, moved, &-normal);
        let gap = normal.dot(&next.gap);
        if widest.is_none_or(|(before, ..)| gap > before) {
            widest = Some((gap, nearest.point, normal));
        }
        let exact = distance - gap <= EXACT.max(1e-3 * distance * distance);
        if exact || corners.iter().any(|corner| corner.gap == next.gap) {
            break;
        }
        corners.push(next);
        (nearest, corners) = nearest_of(&corners)?;
    }
    widest.filter(|(gap, ..)| *gap > 0.0)
}

/// First contact of a body that moves along the path, from where it stands; the path tells direction and length only.
pub fn first(moving: &impl Convex, other: &impl Convex, path: &Path) -> Option<Meeting> {
    let mut way = 0.0;
    let mut met: Option<(V3, V3)> = None;
    for _ in 0..STEPS {
        let Some((gap, point, normal)) = parted(moving, other, &(path.direction * way)) else {
            break;
        };
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
    Some(Meeting { way, point, normal })
}

/// The direction from the origin to what lies between corners. The rough one is a small difference of large numbers; what
/// stands across an edge or a triangle does not suffer from that.
fn across(corners: &[Corner], rough: V3) -> V3 {
    let sharp = match corners {
        [a, b] => (b.gap - a.gap)
            .try_normalize(0.0)
            .map(|edge| rough - edge * rough.dot(&edge)),
        [a, b, c] => {
            let normal = (b.gap - a.gap).cross(&(c.gap - a.gap));
            Some(normal * normal.dot(&rough).signum())
        }
        _ => None,
    };
    sharp
        .and_then(|normal| normal.try_normalize(1e-12))
        .unwrap_or(rough)
}

/// A point of the difference of both bodies.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// Point of the moving body minus point of the other.
    gap: V3,
    /// Point of the other body.
    point: V3,
}

impl Corner {
    /// The farthest one in a direction.
    fn of(moving: &impl Convex, other: &impl Convex, moved: &V3, direction: &V3) -> Corner {
        let point = other.farthest(&-direction);
        Corner {
            gap: moving.farthest(direction) + moved - point,
            point,
        }
    }
}

/// The point of the body between the corners that is nearest to the origin, and the corners between which it lies; none
/// where the origin lies inside of four.
fn nearest_of(corners: &[Corner]) -> Option<(Corner, Vec<Corner>)> {
    let mut found: Option<(Corner, Vec<Corner>)> = None;
    for choice in 1..1_usize << corners.len() {
        let chosen = corners.iter().enumerate();
        let chosen: Vec<Corner> = chosen
            .filter(|(index, _)| choice >> index & 1 == 1)
            .map(|(_, corner)| *corner)
            .collect();
        let Some(weights) = weights(&chosen) else {
            continue;
        };
        if chosen.len() == 4 {
            return None;
        }
        let weighted = chosen.iter().zip(weights);
        let (gap, point) = weighted
            .fold((V3::zeros(), V3::zeros()), |(gap, point), (corner, w)| {
                (gap + corner.gap * w, point + corner.point * w)
            });
        let nearer = |(best, _): &(Corner, Vec<Corner>)| gap.norm() < best.gap.norm();
        if found.as_ref().is_none_or(nearer) {
            found = Some((Corner { gap, point }, chosen));
        }
    }
    found
}

/// Weights of corners with which they give the foot of the origin on what they span; none where the foot lies beside
/// them, or where they span less than they should.
fn weights(corners: &[Corner]) -> Option<Vec<f64>> {
    let (first, rest) = corners.split_first()?;
    let sides: Vec<V3> = rest.iter().map(|corner| corner.gap - first.gap).collect();
    let parts = match sides[..] {
        [] => Vec::new(),
        [a] => vec![-first.gap.dot(&a) / a.norm_squared()],
        [a, b] => {
            let normal = a.cross(&b);
            let size = normal.norm_squared();
            vec![
                b.cross(&normal).dot(&first.gap) / -size,
                normal.cross(&a).dot(&first.gap) / -size,
            ]
        }
        [a, b, c] => {
            let volume = a.cross(&b).dot(&c);
            let part = |p: V3, q: V3| -p.cross(&q).dot(&first.gap) / volume;
            vec![part(b, c), part(c, a), part(a, b)]
        }
        _ => return None,
    };
    let mut weights = vec![1.0 - parts.iter().sum::<f64>()];
    weights.extend(parts);
    let inside = weights
        .iter()
        .all(|weight| *weight >= 0.0 && weight.is_finite());
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

    fn meeting(from: [f64; 3], to: [f64; 3], radius: f64) -> Option<Meeting> {
        let path = Path::new(from.into(), to.into());
        first(&Ball(path.from, radius), &Cube(10.0), &path)
    }

    #[test]
    fn a_ball_meets_face_edge_and_corner() {
        // oracle: hand: the ball of 5 mm stands off a face by its radius; before an edge or a corner its centre is 5 mm away
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
            assert!(
                (found.way - (50.0 - along)).abs() < 1e-9,
                "{found:?} {along}"
            );
        }
    }
}
