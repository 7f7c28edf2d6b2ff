//! A surface of many triangles, and a moving ball against it.
//!
//! The triangles lie in a tree of boxes, so that a ball is held only against those that it can reach.

mod face;
mod tree;

use super::{Path, TOLERANCE, V3};
use tree::Tree;

/// Cosine between way and normal up to which a ball passes by: it would press in by less than 2e-9 of its radius.
const GRAZING: f64 = -3e-5;

/// A surface of triangles; both of its sides can be touched.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    corners: Vec<V3>,
    /// Indices of corners, in the order of the tree.
    triangles: Vec<[u32; 3]>,
    tree: Tree,
}

/// How a ball stands at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stand {
    /// Nothing is touched.
    Free,
    /// It reaches into the surface: nearest point, direction out, how deep, mm.
    Inside(V3, V3, f64),
    /// It touches and is to move into the surface: point and direction out.
    Pressed(V3, V3),
}

impl Mesh {
    /// A surface of these triangles, counter-clockwise seen from outside; those without area and those that name no
    /// corner are left out.
    pub fn new(corners: Vec<V3>, mut triangles: Vec<[u32; 3]>) -> Mesh {
        triangles.retain(|triangle| {
            corners_of(&corners, triangle).is_some_and(|corners| face::normal(&corners).is_some())
        });
        let tree = Tree::build(&mut triangles, |triangle| {
            corners_of(&corners, triangle).unwrap_or_default()
        });
        Mesh {
            corners,
            triangles,
            tree,
        }
    }

    /// Corners, mm.
    pub fn corners(&self) -> &[V3] {
        &self.corners
    }

    /// Three corners a triangle, by their place in [`Mesh::corners`].
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Nearest point of the surface and its distance, where that is at most `within` mm.
    pub fn nearest(&self, p: &V3, within: f64) -> Option<(V3, f64)> {
        let mut found: Option<(V3, f64)> = None;
        self.tree.near(p, within, |index, limit| {
            let foot = face::foot(&self.at(index), p);
            let distance = (p - foot).norm();
            if distance <= limit && found.is_none_or(|(_, least)| distance < least) {
                found = Some((foot, distance));
                return distance;
            }
            limit
        });
        found
    }

    /// Whether a point lies under the surface: of what is straight above it, the lowest triangle faces up.
    pub fn covers(&self, p: &V3) -> bool {
        let mut lowest: Option<(f64, bool)> = None;
        self.tree.above(p, |index| {
            let corners = self.at(index);
            let Some(height) = face::height_at(&corners, p) else {
                return;
            };
            if height > p.z && lowest.is_none_or(|(least, _)| height < least) {
                let up = face::normal(&corners).is_some_and(|normal| normal.z > 0.0);
                lowest = Some((height, up));
            }
        });
        lowest.is_some_and(|(_, up)| up)
    }

    /// How a ball of this radius stands that is about to move along the path.
    pub fn stand(&self, path: &Path, radius: f64) -> Stand {
        let Some((point, distance)) = self.nearest(&path.from, radius + TOLERANCE) else {
            return Stand::Free;
        };
        let out = |point: V3| {
            let away = (path.from - point).try_normalize(0.0);
            away.unwrap_or_else(V3::z)
        };
        if distance < radius - TOLERANCE {
            return Stand::Inside(point, out(point), radius - distance);
        }
        let mut pressed = Stand::Free;
        self.tree
            .near(&path.from, radius + TOLERANCE, |index, limit| {
                let point = face::foot(&self.at(index), &path.from);
                let normal = out(point);
                let touched = (path.from - point).norm() <= radius + TOLERANCE;
                if touched && normal.dot(&path.direction) < GRAZING {
                    pressed = Stand::Pressed(point, normal);
                }
                limit
            });
        pressed
    }

    /// Length after which a ball of this radius that was free begins to touch the surface, and the point touched.
    pub fn first(&self, path: &Path, radius: f64) -> Option<(f64, V3)> {
        let mut found: Option<(f64, V3)> = None;
        let (low, high) = swept(path, radius);
        // a ball that goes s mm touches nothing that is farther away than that and its radius
        let reach = radius + path.length;
        self.tree
            .near_in(&path.from, reach, &low, &high, |index, limit| {
                let corners = self.at(index);
                let Some(length) = face::first(&corners, path, radius) else {
                    return limit;
                };
                if found.is_some_and(|(before, _)| length >= before) {
                    return limit;
                }
                let ball = path.at(length);
                let point = face::foot(&corners, &ball);
                if (ball - point).dot(&path.direction) >= GRAZING * radius {
                    return limit;
                }
                found = Some((length, point));
                radius + length
            });
        found
    }

    fn at(&self, index: usize) -> [V3; 3] {
        let triangle = self.triangles.get(index);
        triangle
            .and_then(|triangle| corners_of(&self.corners, triangle))
            .unwrap_or_default()
    }
}

/// Box around all that a ball reaches on a path.
fn swept(path: &Path, radius: f64) -> (V3, V3) {
    let end = path.at(path.length);
    let room = V3::repeat(radius + TOLERANCE);
    (path.from.inf(&end) - room, path.from.sup(&end) + room)
}

fn corners_of(corners: &[V3], triangle: &[u32; 3]) -> Option<[V3; 3]> {
    let [a, b, c] = triangle.map(|index| corners.get(index as usize).copied());
    Some([a?, b?, c?])
}

#[cfg(test)]
mod tests;
