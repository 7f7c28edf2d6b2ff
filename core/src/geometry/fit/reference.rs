//! The fits against reference pairs: those of NIST (`tests/data/nist_fits.tsv`), and sets whose nearest element is
//! known without calculating it.
//!
//! The latter are points of an element, each moved off it by an amount. Where the sum of these amounts is 0, and the
//! sums of amounts times every way in which the element can be moved, nothing is left to move (the derivative of the
//! sum of squares is 0): the element is the nearest one, exactly.
#![allow(clippy::unwrap_used)]

use super::{circle, nearest};
use crate::geometry::V3;
use crate::test_data::{Row, data, rows};
use nalgebra::{Isometry3, Rotation3};

/// Digits of a coordinate: four times the last one that f64 holds at a metre.
const PLACE: f64 = 1e-12;

/// Points and fit of the reference pairs of NIST for an element, with their names.
fn references(element: &str) -> Vec<(&'static str, Vec<V3>, Vec<f64>)> {
    let numbers = |cell: &str| -> Vec<f64> { cell.split(' ').map(|word| word.parse().unwrap()).collect() };
    let rows: Vec<Row> = rows(data!("nist_fits.tsv")).into_iter().filter(|row| row[1] == element).collect();
    assert!(!rows.is_empty(), "{element}");
    rows.iter().map(|row| (row[0], numbers(row[3]).chunks(3).map(vector).collect(), numbers(row[2]))).collect()
}

fn vector(numbers: &[f64]) -> V3 {
    V3::from_column_slice(numbers)
}

// oracle: NIST reference pairs for least-squares fits (centre, normal of the plane, diameter)
#[test]
fn circles_are_those_of_the_reference_pairs() {
    for (name, points, fit) in references("circle") {
        let (centre, normal) = (vector(&fit[..3]), vector(&fit[3..6]));
        let along = normal.cross(&V3::y()).normalize();
        let across = normal.cross(&along).normalize();
        let flat: Vec<[f64; 2]> =
            points.iter().map(|p| [(p - centre).dot(&along), (p - centre).dot(&across)]).collect();
        let ([x, y], radius) = circle(&flat).unwrap();
        assert!(x.hypot(y) < PLACE, "{name}: {x} {y}");
        assert!((2.0 * radius - fit[6]).abs() < PLACE, "{name}: {radius}");
    }
}

// oracle: NIST reference pairs for least-squares fits (centre, diameter)
#[test]
fn the_sphere_is_that_of_the_reference_pair() {
    for (name, points, fit) in references("sphere") {
        let (centre, radius) = nearest(&points, false).unwrap();
        assert!((centre - vector(&fit[..3])).norm() < PLACE, "{name}: {centre}");
        assert!((2.0 * radius - fit[3]).abs() < PLACE, "{name}: {radius}");
    }
}

/// Where the sets stand: near, and as far from the zero of a machine as its axes reach, turned by every angle.
fn places() -> impl Iterator<Item = Isometry3<f64>> {
    let turns = (0..12).map(f64::from);
    turns.map(|turn| {
        let rotation = Rotation3::from_euler_angles(turn, 0.7 * turn, -1.3 * turn);
        let far = if turn > 6.0 { 1000.0 } else { 1.0 };
        Isometry3::from_parts((V3::new(0.3, -0.7, 0.2) * far).into(), rotation.into())
    })
}

// oracle: hand: amounts cos(2·angle), cos(3·angle), cos(4·angle) at eight equal steps: orthogonal to 1, cos and sin
#[test]
fn a_circle_through_points_that_are_out_of_round() {
    for lobes in [2.0, 3.0, 4.0] {
        for centre in [[0.3, -0.2], [830.0, -1240.0]] {
            let points: Vec<[f64; 2]> = (0..8)
                .map(|step| f64::from(step) * std::f64::consts::FRAC_PI_4)
                .map(|angle| (angle.sin_cos(), 30.0 + 0.05 * (lobes * angle).cos()))
                .map(|((sin, cos), radius)| [centre[0] + radius * cos, centre[1] + radius * sin])
                .collect();
            let ([x, y], radius) = circle(&points).unwrap();
            assert!((x - centre[0]).hypot(y - centre[1]) < PLACE, "{lobes}: {x} {y}");
            assert!((radius - 30.0).abs() < PLACE, "{lobes}: {radius}");
        }
    }
}

// oracle: hand: amounts of the sign of x·y·z at the corners of a cube: orthogonal to 1, x, y and z
#[test]
fn a_sphere_through_points_above_and_below() {
    let signs = [-1.0, 1.0];
    for place in places() {
        let corners = signs.iter().flat_map(|x| signs.iter().flat_map(move |y| signs.map(|z| (*x, *y, z))));
        let points: Vec<V3> = corners
            .map(|(x, y, z)| V3::new(x, y, z).normalize() * (12.5 + 0.02 * x * y * z))
            .map(|point| place.rotation * point + place.translation.vector)
            .collect();
        let (centre, radius) = nearest(&points, false).unwrap();
        let off = (centre - place.translation.vector).norm();
        assert!(off < PLACE && (radius - 12.5).abs() < PLACE, "{off}");
    }
}
