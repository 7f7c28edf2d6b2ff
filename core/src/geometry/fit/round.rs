//! The circle and the sphere nearest to points; whether points make a triangle.
//!
//! Not every set of points has one. What is asked of them is derived in DESIGN.md ("Formulas that the manuals do not
//! give").

use crate::geometry::V3;
use nalgebra::{DMatrix, DVector, Matrix3xX};

/// Points that lie within this part of their extent on a line (of a sphere: in a plane) determine nothing: where a
/// position is known to 1e-9 mm, three digits of a radius are right from here on.
const LOW: f64 = 1e-6;
/// Steps towards the least squares; four at most are needed where points lie near a circle.
const STEPS: usize = 50;
/// Halvings of a step that does not come nearer.
const HALVINGS: usize = 30;
/// Steps shorter than this part of the extent are close to the end.
const CLOSE: f64 = 1e-6;
/// A step that is shorter than this part of the extent changes nothing any more.
const STILL: f64 = 1e-15;
/// Nothing comes nearer by any way where the gradient is this part of what is left.
const LEVEL: f64 = 1e-6;
/// Rounding of a distance, as part of the radius, a few bits.
const ROUNDING: f64 = 1e-14;

/// Centre and radius of the circle through three points, of the nearest one to more: least squares of the distances.
/// None where the points lie in a line or upon each other, or as near to a line as to any circle.
pub fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let flat: Vec<V3> = points.iter().map(|[x, y]| V3::new(*x, *y, 0.0)).collect();
    let (centre, radius) = nearest(&flat, true)?;
    Some(([centre.x, centre.y], radius))
}

/// The sphere nearest to points, or with `plane`, where all have Z = 0, the circle.
pub fn nearest(points: &[V3], plane: bool) -> Option<(V3, f64)> {
    let least = if plane { 3 } else { 4 };
    if points.len() < least {
        return None;
    }
    // about the middle and as large as 1, so that the size of the numbers decides nothing
    let Extent { middle, farthest, sizes, .. } = extent(points)?;
    let across = sizes[least - 2];
    if across <= LOW * sizes[0] {
        return None;
    }
    let points: Vec<V3> = points.iter().map(|p| (p - middle) / farthest).collect();
    let fit = Fit { points: &points, unknown: least };
    let round = fit.search(fit.algebraic()?)?;
    // a line (a plane) is the other end of all circles: it has to be further off
    let bent = 2.0 * fit.left(&round) < across * across;
    let found = (middle + round.centre * farthest, round.radius * farthest);
    (bent && found.1.is_finite()).then_some(found)
}

/// How far points lie from their mean.
struct Extent {
    middle: V3,
    /// Distance of the farthest one, mm.
    farthest: f64,
    /// Roots of the sums of squares along the directions in which they extend, the longest first, in parts of
    /// `farthest`.
    sizes: [f64; 3],
}

fn extent(points: &[V3]) -> Option<Extent> {
    let middle = points.iter().sum::<V3>() / points.len() as f64;
    let away: Vec<V3> = points.iter().map(|point| point - middle).collect();
    let farthest = away.iter().map(V3::norm).fold(0.0, f64::max);
    if !farthest.is_finite() || farthest == 0.0 {
        return None;
    }
    // never fewer columns than rows, as large as 1
    let columns: Vec<V3> = away.into_iter().map(|away| away / farthest).chain([V3::zeros(); 3]).collect();
    let sizes = Matrix3xX::from_columns(&columns).svd(false, false).singular_values;
    Some(Extent { middle, farthest, sizes: [0, 1, 2].map(|i| sizes[i]) })
}

#[derive(Clone, Copy)]
struct Round {
    centre: V3,
    radius: f64,
}

struct Fit<'a> {
    points: &'a [V3],
    /// Number of unknowns: in the plane the third coordinate of the centre stays 0.
    unknown: usize,
}

impl Fit<'_> {
    /// Where the search begins: least squares of p² = 2·p·centre + rest.
    fn algebraic(&self) -> Option<Round> {
        let solution = self.solved(|p| (2.0 * p, p.norm_squared()))?;
        let radius = (solution.radius + solution.centre.norm_squared()).sqrt();
        let round = Round { radius, ..solution };
        radius.is_finite().then_some(round)
    }

    /// Steps of Gauss and Newton, halved until they come nearer. Close to the end rounding hides what one gains: then
    /// it is taken as it is, for as long as steps become shorter.
    fn search(&self, mut round: Round) -> Option<Round> {
        let mut last = CLOSE;
        for _ in 0..STEPS {
            let Some(step) = self.solved(|p| self.row(p, &round)) else { break };
            let length = step.centre.norm().max(step.radius.abs());
            let left = self.left(&round);
            let halves = (0..HALVINGS).map(|halving| 0.5_f64.powi(halving as i32));
            let mut shorter = halves.map(|part| round.moved(&step, part));
            let whole = (length < last).then(|| round.moved(&step, 1.0));
            let nearer = || shorter.find(|next| self.left(next) < left);
            let Some(next) = whole.or_else(nearer) else { break };
            last = last.min(length);
            round = next;
            if length < STILL {
                break;
            }
        }
        self.level(&round).then_some(round)
    }

    /// How a point's distance changes with the centre, and the distance.
    fn row(&self, p: &V3, round: &Round) -> (V3, f64) {
        let away = p - round.centre;
        let out = away.try_normalize(0.0).unwrap_or_else(V3::zeros);
        (out, away.norm() - round.radius)
    }

    /// Whether no way to change centre and radius takes anything away from what is left.
    fn level(&self, round: &Round) -> bool {
        let (mut slope, mut rest) = (nalgebra::Vector4::zeros(), 0.0);
        for p in self.points {
            let (out, distance) = self.row(p, round);
            slope += out.push(1.0) * distance;
            rest += distance.powi(2);
        }
        let rounding = ROUNDING * (1.0 + round.radius) * self.points.len() as f64;
        slope.norm() <= LEVEL * rest.sqrt() + rounding
    }

    /// Sum of the squares of the distances.
    fn left(&self, round: &Round) -> f64 {
        self.points.iter().map(|p| self.row(p, round).1).map(|distance| distance.powi(2)).sum()
    }

    /// Least squares of linear equations: factors of the centre, 1 of the radius, and the right side.
    fn solved(&self, row: impl Fn(&V3) -> (V3, f64)) -> Option<Round> {
        let rows: Vec<(V3, f64)> = self.points.iter().map(row).collect();
        let last = self.unknown - 1;
        let matrix = DMatrix::from_fn(rows.len(), self.unknown, |i, j| match j {
            _ if j == last => 1.0,
            _ => rows[i].0[j],
        });
        let right = DVector::from_iterator(rows.len(), rows.iter().map(|(_, value)| *value));
        let solution = matrix.svd(true, true).solve(&right, f64::MIN_POSITIVE).ok()?;
        let coordinate = |axis: usize| if axis < last { solution[axis] } else { 0.0 };
        Some(Round { centre: V3::new(coordinate(0), coordinate(1), coordinate(2)), radius: solution[last] })
    }
}

impl Round {
    fn moved(&self, step: &Round, part: f64) -> Round {
        Round { centre: self.centre + step.centre * part, radius: self.radius + step.radius * part }
    }
}

/// Whether three points lie on one line or upon each other: their triangle is lower than `LOW` of its longest side.
pub fn in_line(points: [V3; 3]) -> bool {
    height(points).is_none_or(|height| height <= LOW)
}

/// Height of a triangle in parts of its longest side; none where all three points are the same.
fn height([a, b, c]: [V3; 3]) -> Option<f64> {
    let sides = [b - a, c - a, c - b].map(|side| side.norm());
    let longest = sides.into_iter().fold(0.0, f64::max);
    let height = (b - a).cross(&(c - a)).norm() / (longest * longest);
    height.is_finite().then_some(height)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    // oracle: manual B:2456-2466 (three points of a circle of radius 10 about the zero)
    #[test]
    fn three_points_determine_a_circle() {
        let (centre, radius) = circle(&[[0.0, 10.0], [-10.0, 0.0], [0.0, -10.0]]).unwrap();
        assert!(centre[0].abs() < 1e-12 && centre[1].abs() < 1e-12 && (radius - 10.0).abs() < 1e-12);
    }

    // oracle: hand (four points of a circle of radius 5 about 1003, -2)
    #[test]
    fn four_points_far_from_the_zero_are_as_good() {
        let points = [[1008.0, -2.0], [1006.0, 2.0], [1003.0, 3.0], [999.0, -5.0]];
        let (centre, radius) = circle(&points).unwrap();
        assert!((centre[0] - 1003.0).abs() < 1e-9 && (centre[1] + 2.0).abs() < 1e-9);
        assert!((radius - 5.0).abs() < 1e-9);
    }

    // oracle: hand
    #[test]
    fn points_in_line_or_upon_each_other_determine_none() {
        for points in [
            [[0.0, 0.0], [1.0, 1.0], [7.0, 7.0]],
            [[1.0, 2.0], [1.0, 2.0], [5.0, 0.0]],
            [[3.0, 3.0]; 3],
            [[f64::INFINITY, 0.0], [0.0, 1.0], [1.0, 0.0]],
        ] {
            assert_eq!(circle(&points), None, "{points:?}");
        }
    }

    // oracle: hand: a row that goes up and down in turn bends nowhere: amounts a, -a, -a, a of a parabola sum up to 0
    // over 0, h, 0, h, so that every circle leaves more than the line
    #[test]
    fn points_beside_a_line_in_turn_have_no_circle() {
        for height in [1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1] {
            for (place, size) in [(0.0, 1.0), (1000.0, 1.0), (0.0, 200.0)] {
                let points = [[0.0, 0.0], [1.0, height], [2.0, 0.0], [3.0, height]];
                let points = points.map(|point| point.map(|value| place + size * value));
                assert_eq!(circle(&points), None, "{height} {place} {size}");
            }
        }
    }

    // oracle: hand: a sagitta h over half a chord of 1 makes the radius (1 + h²) / 2h, to as many digits as the points
    // have
    #[test]
    fn a_flat_arc_has_its_radius_or_none() {
        for exponent in 1..9 {
            let height = 0.1_f64.powi(exponent);
            let arc = |along: f64, radius: f64| [along, (radius * radius - along * along).sqrt() - radius + height];
            let radius = (1.0 + height * height) / (2.0 * height);
            let points = [-1.0, -0.3, 0.4, 1.0].map(|along| arc(along, radius));
            let three = circle(&points[1..]).map(|(_, radius)| radius);
            let four = circle(&points).map(|(_, radius)| radius);
            for found in [three, four] {
                match found {
                    Some(found) => assert!((found / radius - 1.0).abs() < 1e-3, "{height} {found}"),
                    None => assert!(height < 1e-5, "{height}"),
                }
            }
        }
    }

    // oracle: hand (the definition: no line is as near, and no circle nearby is nearer), over points in no order at all
    #[test]
    fn an_answer_is_the_nearest_and_nearer_than_a_line() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 / f64::from(u32::MAX) * 2.0 - 0.5
        };
        let mut answered = 0;
        for turn in 0..2000 {
            let low = 0.1_f64.powi(turn % 8);
            let points: Vec<[f64; 2]> = (0..4).map(|_| [random() * 10.0, random() * low]).collect();
            let Some(([x, y], radius)) = circle(&points) else { continue };
            answered += 1;
            let off = |x: f64, y: f64, radius: f64| -> f64 {
                let distance = |[a, b]: &[f64; 2]| (a - x).hypot(b - y) - radius;
                points.iter().map(|point| distance(point).powi(2)).sum()
            };
            let best = off(x, y, radius);
            let middle = points.iter().map(|point| Vector2::from(*point)).sum::<Vector2<f64>>() / 4.0;
            let away = points.iter().map(|point| Vector2::from(*point) - middle);
            let beside_line = away.map(|p| p * p.transpose()).sum::<Matrix2<f64>>().symmetric_eigenvalues().min();
            assert!(best < beside_line, "{points:?}");
            for [dx, dy, dr] in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]] {
                let step = 1e-4 * radius;
                for sign in [-step, step] {
                    let near = off(x + sign * dx, y + sign * dy, radius + sign * dr);
                    let rounding = 4e-15 * radius;
                    assert!(near.sqrt() > best.sqrt() - rounding, "{points:?} {best} {near}");
                }
            }
        }
        assert!(answered > 500, "{answered}");
    }

    // oracle: definition: no circle near to it leaves less
    #[test]
    fn four_points_beside_a_circle_have_the_nearest_one() {
        let points = [[10.4, 0.0], [0.0, 9.7], [-10.0, 0.3], [1.0, -11.0]];
        let ([x, y], radius) = circle(&points).unwrap();
        let left = |x: f64, y: f64, radius: f64| -> f64 {
            let distance = |[a, b]: &[f64; 2]| (a - x).hypot(b - y) - radius;
            points.iter().map(|point| distance(point).powi(2)).sum()
        };
        let best = left(x, y, radius);
        for [dx, dy, dr] in [[1e-4, 0.0, 0.0], [0.0, 1e-4, 0.0], [0.0, 0.0, 1e-4], [1e-4, -1e-4, 1e-4]] {
            assert!(left(x + dx, y + dy, radius + dr) > best);
            assert!(left(x - dx, y - dy, radius - dr) > best);
        }
    }
}
