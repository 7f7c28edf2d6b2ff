#![allow(clippy::unwrap_used)]
use super::*;
use proptest::prelude::*;
use std::sync::Arc;

const TEXT: &str = "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1e1 0 -2.5\nVERTEX 0 10 0\n\
    endloop\nendfacet\nendsolid";

/// Key of why a surface is refused.
fn why<T: std::fmt::Debug>(refused: Result<T, Refused>) -> String {
    refused.unwrap_err().message.key.into_owned()
}

fn binary(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut file = b"solid, though it is binary".to_vec();
    file.resize(HEAD_BYTES, 0);
    file.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        file.extend([0; 12]);
        let numbers = triangle.as_flattened().iter();
        file.extend(numbers.flat_map(|number| number.to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}
const HEAD_BYTES: usize = 80;

// oracle: the format as published: facets of three vertices; 80 bytes, count, 50 bytes a triangle, little-endian
#[test]
fn both_sorts_of_stl_are_read() {
    let expected = vec![[[0.0, 0.0, 0.0], [10.0, 0.0, -2.5], [0.0, 10.0, 0.0]]];
    assert_eq!(stl_triangles(TEXT.as_bytes()).unwrap(), expected);
    let file = binary(&[[[0.0, 0.0, 0.0], [10.0, 0.0, -2.5], [0.0, 10.0, 0.0]]]);
    assert_eq!(stl_triangles(&file).unwrap(), expected);
}

// oracle: hand
#[test]
fn what_is_no_stl_is_refused() {
    for file in ["", "solid", "{}", "\u{ff}\u{fe}", "vertex 0 0 0"] {
        assert!(stl_triangles(file.as_bytes()).is_err(), "{file:?}");
    }
    for (part, other) in
        [("1e1", "one"), ("1e1", "NaN"), ("1e1", "inf"), ("1e1", "1e7"), ("VERTEX 0 10 0", ""), ("10 0\nendloop", "10")]
    {
        let file = TEXT.replace(part, other);
        assert!(stl_triangles(file.as_bytes()).is_err(), "{other:?}");
    }
    let corner = |x| [[x, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0]];
    for x in [f32::NAN, f32::INFINITY, 1e30] {
        assert_eq!(why(stl_triangles(&binary(&[corner(x)]))), "surface-number");
    }
    let mut short = binary(&[corner(0.0)]);
    short.pop();
    assert!(stl_triangles(&short).is_err());
    let mut many = binary(&[]);
    many[HEAD_BYTES..].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(stl_triangles(&many).is_err());
}

// oracle: hand
#[test]
fn triangles_share_their_corners() {
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, -0.0]];
    let surface = FreeSurface::from_triangles(&[[a, b, c], [a, c, d]]).unwrap();
    assert_eq!(surface.mesh.corners().len(), 4);
    assert_eq!(surface.bounds(), [[0.0; 3], [1.0, 1.0, 0.0]]);
    assert_eq!(why(FreeSurface::from_triangles(&[[a, b, b]])), "surface-empty");
    assert_eq!(why(FreeSurface::from_triangles(&[])), "surface-empty");
    let far = [[f64::NAN, 0.0, 0.0], b, c];
    assert_eq!(why(FreeSurface::from_triangles(&[far])), "surface-number");
}

// oracle: hand
#[test]
fn heights_must_be_a_grid() {
    let grid = |columns, step, values: &[f64]| {
        let heights = Heights { columns, step, values: values.to_vec() };
        heights.surface().map(|surface| surface.bounds())
    };
    let flat = grid(2, [3.0, 4.0], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(flat, Ok([[-1.5, -4.0, 0.0], [1.5, 4.0, 5.0]]));
    assert_eq!(why(grid(0, [1.0; 2], &[])), "surface-grid");
    assert_eq!(why(grid(1, [1.0; 2], &[0.0; 4])), "surface-grid");
    assert_eq!(why(grid(2, [1.0; 2], &[0.0; 5])), "surface-grid");
    assert_eq!(why(grid(2, [0.0, 1.0], &[0.0; 4])), "surface-grid");
    assert_eq!(why(grid(2, [f64::NAN, 1.0], &[0.0; 4])), "surface-grid");
    let bad = grid(2, [1.0; 2], &[0.0, f64::NAN, 0.0, 0.0]);
    assert_eq!(why(bad), "surface-number");
    let many = grid(1000, [1.0; 2], &vec![0.0; 1_000_000]).unwrap_err();
    let count = refused("surface-triangles").number("count", f64::from(999 * 999 * 2)).number("most", TRIANGLES as f64);
    assert_eq!(many, count);
}

// oracle: hand
#[test]
fn a_picture_is_a_relief() {
    let picture = [0, 255, 51, 102, 0, 0]; // two columns, three rows from above
    let heights = Heights::from_greys(&picture, 2, [10.0, 8.0], 5.0).unwrap();
    assert_eq!((heights.columns, heights.step), (2, [10.0, 4.0]));
    assert_eq!(heights.values, [-5.0, -5.0, -4.0, -3.0, -5.0, 0.0]);
    assert!(Heights::from_greys(&picture, 4, [1.0; 2], 1.0).is_err());
    assert!(Heights::from_greys(&[], 0, [1.0; 2], 1.0).is_err());
    let large = vec![7; 2000 * 1000];
    let heights = Heights::from_greys(&large, 2000, [10.0; 2], 5.0).unwrap();
    assert_eq!(heights.check(), Ok(()));
}

// oracle: hand: the formulas say how high and how low each is
#[test]
fn examples_are_as_high_as_asked_for() {
    for (name, example) in EXAMPLES {
        let surface = example.heights([72.0, 36.0], 8.0).surface().unwrap();
        let [low, high] = surface.bounds();
        assert_eq!((low[0], high[1]), (-36.0, 18.0), "{name}");
        assert!(high[2].abs() < 1e-9 && (low[2] + 8.0).abs() < 1e-9, "{name}: {low:?} {high:?}");
    }
}

// oracle: hand
#[test]
fn an_example_is_made_once() {
    let [one, same, other] = [8.0, 8.0, 9.0].map(|height| Example::Waves.surface([72.0, 36.0], height).unwrap());
    assert!(Arc::ptr_eq(&one, &same));
    assert_eq!(other, Arc::new(Example::Waves.heights([72.0, 36.0], 9.0).surface().unwrap()));
}

// oracle: hand: the border stays, nothing is outside of it
#[test]
fn a_coarser_surface_looks_the_same() {
    let fine = Example::Waves.heights([60.0, 40.0], 8.0).surface().unwrap();
    let triangles: Vec<_> = fine.triangles().collect();
    let single = FreeSurface::from_triangles(&triangles).unwrap();
    for surface in [fine, single] {
        let count = surface.mesh.triangles().len();
        assert!(surface.coarser(count).is_none());
        let coarse = surface.coarser(1000).unwrap();
        assert!(coarse.mesh.triangles().len() < 1500);
        let [low, high] = coarse.bounds();
        for axis in 0..2 {
            assert!((low[axis] - surface.bounds()[0][axis]).abs() < 1.5);
            assert!((high[axis] - surface.bounds()[1][axis]).abs() < 1.5);
        }
        for corner in coarse.mesh.corners() {
            assert!(surface.mesh.nearest(corner, 1.0).is_some());
        }
    }
}

proptest! {
    // oracle: definition: any bytes are triangles or a refusal
    #[test]
    fn any_bytes_are_read_without_harm(mut bytes in prop::collection::vec(any::<u8>(), 0..300),
    solid in any::<bool>()) {
        if solid {
            bytes.splice(0..0, b"solid \nvertex 1 2 ".iter().copied());
        }
        if let Ok(triangles) = stl_triangles(&bytes) {
            prop_assert!(FreeSurface::from_triangles(&triangles).is_ok() || !triangles.is_empty());
        }
    }
}
