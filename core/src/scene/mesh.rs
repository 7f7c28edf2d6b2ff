//! Triangles with the normals of the surface that they stand for.

use crate::geometry::V3;

/// A place, mm, and the outward unit normal of the surface there.
pub type Vertex = [V3; 2];

/// Triangles over shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Places and normals.
    pub vertices: Vec<Vertex>,
    /// Three vertices a triangle, counter-clockwise seen from where their normals point.
    pub corners: Vec<[u32; 3]>,
}

impl Mesh {
    /// Adds a surface through rows of as many vertices. `closed`: the last of each row is a neighbour of its first.
    pub fn sheet(&mut self, rows: &[Vec<Vertex>], closed: bool) {
        let first = self.vertices.len();
        let count = rows.first().map_or(0, Vec::len);
        self.corners.reserve(2 * count * rows.len());
        rows.iter().for_each(|row| self.vertices.extend_from_slice(row));
        for row in 1..rows.len() {
            for column in 0..(if closed { count } else { count.saturating_sub(1) }) {
                let next = (column + 1) % count;
                let [a, b] = [column, next].map(|place| first + (row - 1) * count + place);
                self.face([a, b, b + count]);
                self.face([a, b + count, a + count]);
            }
        }
    }

    /// Adds a flat convex face with one normal.
    pub fn flat(&mut self, corners: &[V3], normal: V3) {
        let first = self.vertices.len();
        self.vertices.extend(corners.iter().map(|corner| [*corner, normal]));
        for last in 2..corners.len() {
            self.face([first, first + last - 1, first + last]);
        }
    }

    /// Adds another mesh as `place` moves its vertices.
    pub fn append(&mut self, other: &Mesh, place: impl Fn(&Vertex) -> Vertex) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(other.vertices.iter().map(place));
        self.corners.extend(other.corners.iter().map(|corners| corners.map(|corner| first + corner)));
    }

    /// Joins three vertices in the order that faces where their normals point; three in a line are nothing.
    fn face(&mut self, corners: [usize; 3]) {
        let [[a, na], [b, nb], [c, nc]] = corners.map(|corner| &self.vertices[corner]);
        let across = (b - a).cross(&(c - a));
        if across == V3::zeros() {
            return;
        }
        let [first, second, third] = corners.map(|corner| corner as u32);
        let outside = across.dot(&(na + nb + nc)) >= 0.0;
        self.corners.push(if outside { [first, second, third] } else { [first, third, second] });
    }
}
