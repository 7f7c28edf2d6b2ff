//! One edge at two points, two edges at one point each (B:3047-3149).

use crate::geometry::Degrees;

/// Angle of an edge against a reference axis: touched along `measuring` (X Y Z by index) at two points, each as the
/// coordinate measured and the place along `reference`. Ball, trigger value and skew are the same at both and fall out.
/// None: the points lie at the same place, or the axes are one.
pub fn angle(measuring: usize, reference: usize, points: [[f64; 2]; 2]) -> Option<Degrees> {
    let [[first, from], [second, to]] = points;
    let rise = (second - first) / (to - from);
    let sense = match (3 + measuring - reference) % 3 {
        1 => 1.0,
        2 => -1.0,
        _ => return None,
    };
    rise.is_finite().then(|| Degrees::of(sense * rise.atan()))
}

/// Distance of two edges, and the middle between them.
pub fn distance(first: f64, second: f64) -> (f64, f64) {
    ((second - first).abs(), (first + second) / 2.0)
}
