#![allow(clippy::unwrap_used)]
//! Directions out of the surface from scattered neighbours, where they are known exactly.

use super::*;
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::geometry::V3;
use proptest::prelude::*;

fn layout() -> Layout {
    Layout { radius: 3.0, ..Layout::of(&delivery(Dialect::Nct), 0, 1) }
}

/// Lines back and forth with uneven steps; `height` of the ball centre.
fn cloud(uneven: f64, lines: usize, height: impl Fn(f64, f64) -> f64) -> Cloud {
    let mut cloud = Cloud::default();
    for line in 0..lines {
        let y = 2.0 * line as f64 - lines as f64;
        for place in 0..12 {
            let place = if line % 2 == 0 { place } else { 11 - place } as f64;
            let x = place - 6.0 + uneven * (3.1 * place + line as f64).sin();
            cloud.push(Scanned { line, at: [x, y, height(x, y) - 3.0] });
        }
    }
    cloud
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    // oracle: hand: gradient of the plane; centre of the sphere
    #[test]
    fn planes_and_spheres_have_their_exact_normals(
        uneven in -0.4..0.4_f64, (u, v) in (-2.0..2.0_f64, -2.0..2.0_f64), size in 15.0..90.0_f64, lines in 3_usize..8,
    ) {
        let plane = cloud(uneven, lines, |x, y| u * x + v * y);
        let sphere = cloud(uneven, lines, |x, y| (size * size - x * x - y * y).sqrt());
        let upright = V3::new(-u, -v, 1.0).normalize();
        for index in 0..plane.points().len() {
            prop_assert!((plane.normal(&layout(), index) - upright).norm() < 1e-9);
            let centre = V3::from(sphere.points()[index]) + V3::z() * 3.0;
            prop_assert!((sphere.normal(&layout(), index) - centre / size).norm() < 1e-8);
            prop_assert!((sphere.surface(&layout(), index).norm() - (size - 3.0)).abs() < 1e-7);
        }
    }
}

// oracle: hand
#[test]
fn few_points_have_a_normal_too() {
    let mut cloud = Cloud::default();
    assert_eq!(cloud.normal(&layout(), 0), V3::z());
    cloud.push(Scanned { line: 0, at: [0.0; 3] });
    assert_eq!(cloud.normal(&layout(), 0), V3::z());
    assert_eq!(cloud.surface(&layout(), 0), V3::zeros());
    cloud.push(Scanned { line: 0, at: [4.0, 0.0, 3.0] });
    let rises = V3::new(-0.6, 0.0, 0.8);
    assert!((cloud.normal(&layout(), 0) - rises).norm() < 1e-12);
    cloud.push(Scanned { line: 3, at: [4.0, 2.0, 3.0] });
    assert!((cloud.normal(&layout(), 1) - rises).norm() < 1e-12);
    assert_eq!(cloud.lines(), 2);
    assert_eq!(cloud.extent(2), [0.0, 3.0]);
    // the same place twice is no direction
    cloud.push(Scanned { line: 3, at: [4.0, 2.0, 3.0] });
    assert!(cloud.normal(&layout(), 3).norm() > 0.9);
}
