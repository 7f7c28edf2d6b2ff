#![allow(clippy::unwrap_used)]
use super::*;
use proptest::prelude::*;

/// Two triangles over the square from -10 to 10 at height 0.
fn plate() -> Mesh {
    let corner = |x: f64, y: f64| V3::new(x, y, 0.0);
    let corners = vec![corner(-10.0, -10.0), corner(10.0, -10.0), corner(10.0, 10.0), corner(-10.0, 10.0)];
    Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]])
}

fn way(from: [f64; 3], to: [f64; 3]) -> Path {
    Path::new(V3::from(from), V3::from(to))
}

// oracle: hand
#[test]
fn face_edge_and_corner() {
    let plate = plate();
    let Met { way: length, point, .. } = plate.first(&way([1.0, 2.0, 20.0], [1.0, 2.0, -20.0]), 3.0).unwrap();
    assert!((length - 17.0).abs() < 1e-12);
    assert!((point - V3::new(1.0, 2.0, 0.0)).norm() < 1e-12);
    // beside the edge by 1.8: the centre stops at the height sqrt(9 - 1.8 * 1.8) = 2.4
    let Met { way: length, point, .. } = plate.first(&way([11.8, 0.0, 20.0], [11.8, 0.0, -20.0]), 3.0).unwrap();
    assert!((length - 17.6).abs() < 1e-12);
    assert!((point - V3::new(10.0, 0.0, 0.0)).norm() < 1e-12);
    // beside the corner by 1 and 2: the height is 2
    let Met { way: length, point, .. } = plate.first(&way([11.0, 12.0, 20.0], [11.0, 12.0, -20.0]), 3.0).unwrap();
    assert!((length - 18.0).abs() < 1e-12);
    assert!((point - V3::new(10.0, 10.0, 0.0)).norm() < 1e-12);
    let beside = way([13.1, 0.0, 20.0], [13.1, 0.0, -20.0]);
    assert!(plate.first(&beside, 3.0).is_none());
    // from the side against the edge
    let Met { way: length, .. } = plate.first(&way([-30.0, 0.0, 0.0], [30.0, 0.0, 0.0]), 3.0).unwrap();
    assert!((length - 17.0).abs() < 1e-12);
}

// oracle: hand
#[test]
fn standing_pressed_and_inside() {
    let plate = plate();
    let stand = |from, to| plate.stand(&way(from, to), 3.0);
    assert_eq!(stand([0.0, 0.0, 3.1], [0.0, 0.0, 0.0]), Stand::Free);
    assert!(matches!(stand([0.0, 0.0, 3.0], [0.0, 0.0, 0.0]), Stand::Pressed(..)));
    assert_eq!(stand([0.0, 0.0, 3.0], [5.0, 0.0, 3.0]), Stand::Free);
    let Stand::Inside(_, out, depth) = stand([0.0, 0.0, 2.5], [0.0, 0.0, 9.0]) else { unreachable!() };
    assert_eq!((out, depth), (V3::z(), 0.5));
    assert!(plate.covers(&V3::new(0.0, 0.0, -1.0)));
    assert!(!plate.covers(&V3::new(0.0, 0.0, 1.0)));
    assert!(!plate.covers(&V3::new(11.0, 0.0, -1.0)));
}

// oracle: hand
#[test]
fn what_is_no_triangle_is_left_out() {
    let corners = vec![V3::zeros(), V3::x(), V3::x() * 2.0, V3::y()];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 1, 9], [0, 1, 3]]);
    assert_eq!(mesh.triangles(), [[0, 1, 3]]);
    assert!(Mesh::new(Vec::new(), Vec::new()).first(&way([0.0; 3], [1.0; 3]), 1.0).is_none());
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [-10.0..10.0, -10.0..10.0, -10.0..10.0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    // oracle: definition: at the contact the distance is the radius, before it greater; every triangle is asked
    #[test]
    fn a_ball_stops_where_the_nearest_triangle_is_its_radius_away(
        corners in prop::collection::vec(point(), 60), from in point(), to in point(), radius in 0.1..2.0,
    ) {
        let corners: Vec<V3> = corners.into_iter().map(V3::from).collect();
        let triangles = (0..20).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = Mesh::new(corners, triangles);
        let slow = |p: &V3| (0..mesh.triangles.len())
            .map(|index| (p - mesh.faces[index].foot(p, f64::INFINITY).unwrap()).norm())
            .fold(f64::INFINITY, f64::min);
        let path = way(from, to);
        let (_, near) = mesh.nearest(&path.from, f64::INFINITY).unwrap();
        prop_assert!((near - slow(&path.from)).abs() < 1e-12);
        if near > radius + 1e-6 {
            let found = mesh.first(&path, radius);
            let end = found.map_or(path.length, |met| met.way);
            if let Some(Met { way: length, point, .. }) = found {
                prop_assert!((slow(&path.at(length)) - radius).abs() < 1e-9);
                prop_assert!(((path.at(length) - point).norm() - radius).abs() < 1e-9);
            }
            for part in 0..50 {
                let p = path.at(end * f64::from(part) / 50.0);
                prop_assert!(slow(&p) >= radius - 2e-9);
            }
        }
    }
}
