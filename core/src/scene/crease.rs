//! Triangles of a surface whose shape is known by them alone: smooth, with edges where it bends.

use super::mesh::{Mesh, Vertex};
use crate::geometry::V3;

/// Cosine of the angle from which on a bend is an edge: 28°.
pub const CREASE: f64 = 0.882_947_592_858_927;

/// A surface with more edges than that is rough, and its edges tell nothing.
const MOST_EDGES: usize = 20_000;

/// Normals of the same direction but for rounding.
const SAME: f64 = 1.0 - 1e-9;

/// The surface, whose normals change where it is smooth and jump at its edges; and these.
pub fn creased(corners: &[V3], triangles: &[[u32; 3]]) -> (Mesh, Vec<[V3; 2]>) {
    let around = Around::of(corners.len(), triangles);
    let across: Vec<V3> = triangles.iter().map(|triangle| across(corners, *triangle)).collect();
    let normals: Vec<V3> = across.iter().map(|way| way.try_normalize(0.0).unwrap_or_else(V3::z)).collect();
    let mut vertices = Vertices { all: Vec::new(), made: vec![Vec::new(); corners.len()] };
    let mut faces = Vec::with_capacity(triangles.len());
    for (triangle, own) in triangles.iter().zip(&normals) {
        faces.push(triangle.map(|corner| {
            let smooth = around.at(corner).iter().map(|other| *other as usize);
            let sum: V3 = smooth.filter(|other| own.dot(&normals[*other]) > CREASE).map(|other| across[other]).sum();
            vertices.at(corner, [corners[corner as usize], sum.try_normalize(0.0).unwrap_or(*own)])
        }));
    }
    let edges = edges(corners, triangles, &normals, &around);
    (Mesh { vertices: vertices.all, corners: faces }, edges)
}

/// As long as twice the area of the triangle.
fn across(corners: &[V3], triangle: [u32; 3]) -> V3 {
    let [a, b, c] = triangle.map(|corner| corners[corner as usize]);
    (b - a).cross(&(c - a))
}

/// Vertices, one for all triangles that share a normal at a corner.
struct Vertices {
    all: Vec<Vertex>,
    /// By corner: normal and place of each vertex there.
    made: Vec<Vec<(V3, u32)>>,
}

impl Vertices {
    fn at(&mut self, corner: u32, vertex: Vertex) -> u32 {
        let there = &mut self.made[corner as usize];
        if let Some((_, known)) = there.iter().find(|(normal, _)| normal.dot(&vertex[1]) > SAME) {
            return *known;
        }
        let new = self.all.len() as u32;
        self.all.push(vertex);
        there.push((vertex[1], new));
        new
    }
}

/// The triangles around each corner, one corner after the other.
struct Around {
    begins: Vec<u32>,
    triangles: Vec<u32>,
}

impl Around {
    fn of(corners: usize, triangles: &[[u32; 3]]) -> Around {
        let mut begins = vec![0_u32; corners + 1];
        for corner in triangles.as_flattened() {
            begins[*corner as usize + 1] += 1;
        }
        for index in 0..corners {
            begins[index + 1] += begins[index];
        }
        let mut next = begins.clone();
        let mut listed = vec![0_u32; 3 * triangles.len()];
        for (index, triangle) in triangles.iter().enumerate() {
            for corner in triangle {
                let place = &mut next[*corner as usize];
                listed[*place as usize] = index as u32;
                *place += 1;
            }
        }
        Around { begins, triangles: listed }
    }

    fn at(&self, corner: u32) -> &[u32] {
        let [from, to] = [corner, corner + 1].map(|index| self.begins[index as usize] as usize);
        &self.triangles[from..to]
    }
}

/// Where the surface ends or bends; none of a rough one.
fn edges(corners: &[V3], triangles: &[[u32; 3]], normals: &[V3], around: &Around) -> Vec<[V3; 2]> {
    let mut found = Vec::new();
    for (index, [a, b, c]) in triangles.iter().enumerate() {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            let both = around.at(from).iter().filter(|other| triangles[**other as usize].contains(&to));
            let mut others = both.map(|other| *other as usize).filter(|other| *other != index).peekable();
            let border = others.peek().is_none();
            let mut first = true; // of the triangles at this edge
            let mut bends = false;
            for other in others {
                first &= index < other;
                bends |= normals[index].dot(&normals[other]) < CREASE;
            }
            if border || first && bends {
                found.push([corners[from as usize], corners[to as usize]]);
            }
        }
    }
    if found.len() > MOST_EDGES { Vec::new() } else { found }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A prism about Z with so many sides, without its ends.
    fn prism(sides: u32) -> (Vec<V3>, Vec<[u32; 3]>) {
        let ring = |z: f64| (0..sides).map(move |side| (TAU * f64::from(side) / f64::from(sides), z));
        let corners = ring(0.0).chain(ring(5.0)).map(|(angle, z)| V3::new(angle.cos(), angle.sin(), z)).collect();
        let walls = (0..sides).flat_map(|side| {
            let next = (side + 1) % sides;
            [[side, next, next + sides], [side, next + sides, side + sides]]
        });
        (corners, walls.collect())
    }

    // oracle: hand (24 sides bend by 15°, 8 by 45°; both rims are edges)
    #[test]
    fn a_surface_is_smooth_but_where_it_bends() {
        let (corners, triangles) = prism(24);
        let (round, edges) = creased(&corners, &triangles);
        assert_eq!((round.vertices.len(), edges.len()), (48, 48));
        for [at, normal] in &round.vertices {
            assert!(normal.dot(&V3::new(at.x, at.y, 0.0)) > 0.999, "{at:?} {normal:?}");
        }
        let (corners, triangles) = prism(8);
        let (angular, edges) = creased(&corners, &triangles);
        assert_eq!((angular.vertices.len(), edges.len()), (32, 24));
    }

    // oracle: hand
    #[test]
    fn the_angle_is_28_degrees() {
        assert!((CREASE.acos().to_degrees() - 28.0).abs() < 1e-9);
    }
}
