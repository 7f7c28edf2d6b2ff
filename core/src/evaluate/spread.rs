//! How much of the scatter of one measured point is left in what follows from several of them: standard deviations, as
//! multiples of that of one point. All points scatter alike and independently of each other; to first order, as scatter
//! is small against every distance. DESIGN.md says what is reported.

use crate::geometry::{Degrees, V3};
use nalgebra::{Matrix3, MatrixXx3, RowVector3, Vector2};

/// Length over which the uncertainty of a direction is told, mm.
pub const LENGTH: f64 = 100.0;
/// More than this is reported: a decimal place of what the probe can do is lost.
pub const MOST_SPREAD: f64 = 10.0;
/// Sine of an angle between lines that do not meet.
const PARALLEL: f64 = 1e-9;

type V2 = Vector2<f64>;

/// A point of a line as it is touched: place in the plane, mm, and the unit vector along which it scatters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touched {
    /// Abscissa and ordinate.
    pub at: [f64; 2],
    /// Direction of probing; its sense does not matter.
    pub towards: [f64; 2],
}

/// What is uncertain of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Abscissa and ordinate of the centre.
    pub centre: [f64; 2],
    /// Diameter.
    pub diameter: f64,
}

impl Circle {
    /// The worse of both coordinates of the centre.
    pub fn worse(&self) -> f64 {
        self.centre[0].max(self.centre[1])
    }
}

/// A factor as it is told: two digits, or one decimal.
pub fn told(factor: f64) -> f64 {
    if factor < 10.0 {
        return (factor * 10.0).round() / 10.0;
    }
    let place = 10_f64.powf(factor.log10().floor() - 1.0).round();
    (factor / place).round() * place
}

/// A circle through points in these directions from its centre, touched along them: the covariance is (AᵀA)⁻¹,
/// the rows of A (cos, sin, 1). None where the points do not determine it.
pub fn circle(directions: &[Degrees]) -> Option<Circle> {
    let turned = directions.iter().map(|direction| direction.sin_cos());
    let rows: Vec<_> = turned.map(|(sine, cosine)| RowVector3::new(cosine, sine, 1.0)).collect();
    if rows.len() < 3 {
        return None;
    }
    // by singular values, which tell points that lie very close together from such that determine nothing
    let found = MatrixXx3::from_rows(&rows).svd(false, true);
    let (along, sizes) = (found.v_t?, found.singular_values);
    let share = |i: usize| sizes.iter().enumerate().map(|(k, size)| (along[(k, i)] / size).powi(2)).sum::<f64>();
    let [x, y, radius] = [0, 1, 2].map(|i| share(i).sqrt());
    (x + y + radius).is_finite().then_some(Circle { centre: [x, y], diameter: 2.0 * radius })
}

/// A straight line through two points.
struct Line {
    from: V2,
    along: V2,
    /// Between the points, mm.
    length: f64,
}

impl Line {
    fn through([one, two]: [Touched; 2]) -> Option<Line> {
        let way = V2::from(two.at) - V2::from(one.at);
        let length = way.norm();
        (length > 0.0).then(|| Line { from: one.at.into(), along: way / length, length })
    }

    /// How far the line moves across itself at a point that is displaced by one in the direction of probing.
    fn moves(&self, touched: Touched) -> f64 {
        self.along.perp(&V2::from(touched.towards))
    }
}

/// The direction of a line through two points: how far it is off after [`LENGTH`]. None where they are one.
pub fn line(touched: [Touched; 2]) -> Option<f64> {
    let line = Line::through(touched)?;
    let [one, two] = touched.map(|touched| line.moves(touched));
    Some(one.hypot(two) * LENGTH / line.length)
}

/// The corner where two lines meet: the first through two points, the second through two others or upright on the first
/// through one. The worse of abscissa and ordinate. None where the lines do not meet.
pub fn corner(touched: &[Touched]) -> Option<f64> {
    let (&[a, b, c], rest) = touched.split_first_chunk::<3>()?;
    let first = Line::through([a, b])?;
    let second = match rest.first() {
        Some(d) => Line::through([c, *d])?,
        None => Line { from: c.at.into(), along: V2::new(-first.along.y, first.along.x), length: 1.0 },
    };
    let sine = first.along.perp(&second.along);
    if sine.abs() < PARALLEL {
        return None;
    }
    let between = second.from - first.from;
    let ahead = between.perp(&second.along) / sine / first.length;
    let across = between.perp(&first.along) / sine / second.length;
    // by how much the lines move across themselves at the corner, point by point
    let [of_a, of_b] = [a, b].map(|touched| first.moves(touched));
    let of_c = second.moves(c);
    let moved = match rest.first() {
        Some(d) => vec![
            [(1.0 - ahead) * of_a, 0.0],
            [ahead * of_b, 0.0],
            [0.0, (1.0 - across) * of_c],
            [0.0, across * second.moves(*d)],
        ],
        None => vec![
            // turned with the first line, the second one turns about its own point
            [(1.0 - ahead) * of_a, -across * of_a / first.length],
            [ahead * of_b, across * of_b / first.length],
            [0.0, of_c],
        ],
    };
    let squares = moved.into_iter().map(|[one, two]| {
        let corner = (second.along * one - first.along * two) / sine;
        corner.component_mul(&corner)
    });
    Some(squares.sum::<V2>().max().sqrt())
}

/// The rotation of a frame from three points: how far it is off at [`LENGTH`] from the line nearest to them.
pub fn turn(points: [V3; 3]) -> Option<f64> {
    let middle = points.iter().sum::<V3>() / 3.0;
    let from_middle = points.map(|point| point - middle);
    let inertia = from_middle.map(|p| Matrix3::from_diagonal_element(p.norm_squared()) - p * p.transpose());
    let least = inertia.iter().sum::<Matrix3<f64>>().symmetric_eigenvalues().min();
    (least > 0.0).then(|| LENGTH / least.sqrt())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::evaluate::position::position;
    use crate::geometry::{fit, rigid};

    /// By how much each result changes with each of the numbers from which it is calculated, summed up as scatter is:
    /// central differences.
    fn differences<const N: usize>(count: usize, reckon: impl Fn(&[f64]) -> [f64; N]) -> [f64; N] {
        const STEP: f64 = 1e-4;
        let mut squares = [0.0; N];
        for index in 0..count {
            let moved = |by: f64| {
                let mut moves = vec![0.0; count];
                moves[index] = by;
                reckon(&moves)
            };
            let (more, less) = (moved(STEP), moved(-STEP));
            for i in 0..N {
                squares[i] += ((more[i] - less[i]) / (2.0 * STEP)).powi(2);
            }
        }
        squares.map(f64::sqrt)
    }

    fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
        assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found}, expected {expected}");
    }

    // oracle: hand: n points evenly around: sums of cos², sin² are n/2, all others 0; points at -a, 0, a: see DESIGN.md
    #[test]
    fn circles_by_hand() {
        for count in [3, 4] {
            let n = f64::from(count);
            let directions: Vec<Degrees> = (0..count).map(|i| Degrees(10.0 + 360.0 / n * f64::from(i))).collect();
            let found = circle(&directions).unwrap();
            near(found.diameter, 2.0 / n.sqrt(), 1e-12, "diameter");
            near(found.worse(), (2.0 / n).sqrt(), 1e-12, "centre");
        }
        for step in [20_f64, 45.0, 80.0] {
            let found = circle(&[-step, 0.0, step].map(Degrees)).unwrap();
            let cosine = step.to_radians().cos();
            let radius = (0.5 + cosine * cosine).sqrt() / (1.0 - cosine);
            near(found.diameter, 2.0 * radius, 1e-9, "diameter");
            near(found.centre[0], 1.5_f64.sqrt() / (1.0 - cosine), 1e-9, "abscissa");
            near(found.centre[1], 0.5_f64.sqrt() / step.to_radians().sin(), 1e-9, "ordinate");
        }
        assert!(circle(&[0.0, 1e-3, 2e-3].map(Degrees)).unwrap().diameter > 1e9);
        assert_eq!(circle(&[5.0, 90.0].map(Degrees)), None);
        assert_eq!(circle(&[Degrees(0.0); 3]), None);
    }

    // oracle: peer: 400,000 draws of another program (numpy): 0°, 20°, 40°: diameter 38.92 ± 0.04; 15°, 95°, 175° of
    // B:7092:
    // diameter 1.7585 ± 0.0020, abscissa 0.7270 ± 0.0008, ordinate 1.4741 ± 0.0017
    #[test]
    fn circles_by_draws() {
        near(circle(&[0.0, 20.0, 40.0].map(Degrees)).unwrap().diameter, 38.92, 0.004, "short");
        let example = circle(&[15.0, 95.0, 175.0].map(Degrees)).unwrap();
        near(example.diameter, 1.7585, 0.004, "diameter");
        near(example.centre[0], 0.7270, 0.004, "abscissa");
        near(example.centre[1], 1.4741, 0.004, "ordinate");
    }

    // oracle: self: by how much the fit that the cycles use changes with each of its points
    #[test]
    fn circles_as_they_are_fitted() {
        for directions in [vec![0.0, 20.0, 40.0], vec![15.0, 95.0, 175.0], vec![-30.0, 10.0, 50.0, 90.0]] {
            let directions: Vec<Degrees> = directions.into_iter().map(Degrees).collect();
            let fitted = differences(directions.len(), |moves| {
                let points: Vec<[f64; 2]> = directions
                    .iter()
                    .zip(moves)
                    .map(|(direction, by)| {
                        let (sine, cosine) = direction.sin_cos();
                        [3.0 + (40.0 + by) * cosine, -7.0 + (40.0 + by) * sine]
                    })
                    .collect();
                let ([x, y], radius) = fit::circle(&points).unwrap();
                [x, y, 2.0 * radius]
            });
            let found = circle(&directions).unwrap();
            for (one, other) in [found.centre[0], found.centre[1], found.diameter].iter().zip(fitted) {
                near(*one, other, 1e-6, "fit");
            }
        }
    }

    const ALONG_X: [f64; 2] = [1.0, 0.0];
    const ALONG_Y: [f64; 2] = [0.0, 1.0];

    fn touched(at: [f64; 2], towards: [f64; 2]) -> Touched {
        Touched { at, towards }
    }

    // oracle: hand: heights h1, h2 at the distance d make atan((h2 - h1) / d), whose derivative is cos² / d for each
    #[test]
    fn a_line_by_hand() {
        for angle in [0.0_f64, 20.0, -40.0] {
            let rise = 40.0 * angle.to_radians().tan();
            let found = line([touched([5.0, 1.0], ALONG_Y), touched([45.0, 1.0 + rise], ALONG_Y)]);
            let radian = 2_f64.sqrt() * angle.to_radians().cos().powi(2) / 40.0;
            near(found.unwrap(), 100.0 * radian, 1e-12, "line");
        }
        assert_eq!(line([touched([1.0, 2.0], ALONG_X); 2]), None);
    }

    // oracle: hand: with places at half and the whole distance the corner is twice the near point less the far one
    #[test]
    fn a_right_corner_by_hand() {
        for distance in [10.0, 80.0] {
            let edge = |x: f64, y: f64, towards| {
                [0.5, 1.0].map(|part| touched([x * distance * part, y * distance * part], towards))
            };
            let all = [edge(1.0, 0.0, ALONG_Y), edge(0.0, 1.0, ALONG_X)].concat();
            near(corner(&all).unwrap(), 5_f64.sqrt(), 1e-12, "corner");
        }
    }

    // oracle: hand: where the two lines meet, calculated anew with each point displaced along its direction of probing
    #[test]
    fn any_corner_by_differences() {
        let places = [[50.0, 20.0], [150.0, 24.0], [15.0, 40.0], [21.0, 80.0]];
        let towards = [ALONG_Y, ALONG_Y, ALONG_X, ALONG_X];
        for count in [3, 4] {
            let all: Vec<Touched> = (0..count).map(|i| touched(places[i], towards[i])).collect();
            let expected = differences(count, |moves| {
                let at = |i: usize| V2::from(places[i]) + V2::from(towards[i]) * moves[i];
                let one = at(1) - at(0);
                let two = if count == 4 { at(3) - at(2) } else { V2::new(-one.y, one.x) };
                let share = (at(2) - at(0)).perp(&two) / one.perp(&two);
                let corner = at(0) + one * share;
                [corner.x, corner.y]
            });
            near(corner(&all).unwrap(), expected[0].max(expected[1]), 1e-6, "corner");
        }
        let parallel = [[0.0, 0.0], [9.0, 0.0], [0.0, 5.0], [9.0, 5.0]].map(|at| touched(at, ALONG_Y));
        assert_eq!(corner(&parallel), None);
    }

    // oracle: self: by how much the rotation that three points give changes with each of their coordinates; hand: two
    // points beside the line of the third's height h: h·sqrt(2/3)
    #[test]
    fn a_rotation_by_differences() {
        for height in [5.0, 60.0] {
            let points = [V3::zeros(), V3::x() * 300.0, V3::new(150.0, height, 0.0)];
            let expected = differences(9, |moves| {
                let moved = [0, 1, 2].map(|i| points[i] + V3::from_column_slice(&moves[3 * i..3 * i + 3]));
                rigid::angles(&position(&points, &moved).unwrap().motion.rotation).map(f64::to_radians)
            });
            let found = turn(points).unwrap();
            near(found, 100.0 * expected[0], 1e-5, "about the line");
            near(found, 100.0 / (height * (2.0_f64 / 3.0).sqrt()), 1e-9, "by hand");
        }
        assert_eq!(turn([V3::x(); 3]), None);
    }

    // oracle: hand
    #[test]
    fn two_digits_are_told() {
        for (factor, expected) in
            [(38.97, 39.0), (39.001, 39.0), (10.01, 10.0), (4.21, 4.2), (123.0, 120.0), (9.96, 10.0)]
        {
            assert!((told(factor) - expected).abs() < 1e-9, "{factor}: {}", told(factor));
        }
    }
}
