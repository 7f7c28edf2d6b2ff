//! A surface of many triangles, and a moving ball against it.
//!
//! The triangles lie in a tree of boxes, so that a ball is held only against those that it can reach.

mod face;
mod tree;

use super::extent::Extent;
use super::met::{Met, Stand, earliest};
use super::rod::{self, Rod};
use super::{Path, TOLERANCE, V3};
use face::Face;
use tree::Tree;

/// Cosine between way and normal up to which a ball passes by: it would press in by less than 2e-9 of its radius.
const GRAZING: f64 = -3e-5;

/// A surface of triangles; both of its sides can be touched.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    corners: Vec<V3>,
    /// Indices of corners, in the order of the tree.
    triangles: Vec<[u32; 3]>,
    /// Triangles, ready to be held against a ball.
    faces: Vec<Face>,
    tree: Tree,
}

impl Mesh {
    /// A surface of triangles, counter-clockwise seen from outside, less those without area or with unknown corners.
    pub fn new(corners: Vec<V3>, mut triangles: Vec<[u32; 3]>) -> Mesh {
        let area = |triangle: &[u32; 3]| face::normal(&corners_of(&corners, triangle)?);
        triangles.retain(|triangle| area(triangle).is_some());
        let tree = Tree::build(&mut triangles, |triangle| corners_of(&corners, triangle).unwrap_or_default());
        let face = |triangle: &[u32; 3]| Face::new(corners_of(&corners, triangle)?);
        let faces = triangles.iter().filter_map(face).collect();
        Mesh { corners, triangles, faces, tree }
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
        self.near(p, within, |face, limit| {
            let Some(foot) = face.foot(p, limit) else { return limit };
            let distance = (p - foot).norm();
            found = Some((foot, distance));
            distance
        });
        found
    }

    /// Whether a point lies under the surface: of what is straight above it, the lowest triangle faces up.
    pub fn covers(&self, p: &V3) -> bool {
        let mut lowest: Option<(f64, bool)> = None;
        self.tree.above(p, |indices, top| {
            for face in self.faces.get(indices).unwrap_or_default() {
                let height = face.height_at(p).filter(|height| *height > p.z);
                if let Some(height) = height
                    && lowest.is_none_or(|(least, _)| height < least)
                {
                    lowest = Some((height, face.normal.z > 0.0));
                }
            }
            lowest.map_or(top, |(height, _)| height)
        });
        lowest.is_some_and(|(_, up)| up)
    }

    /// How a ball of this radius stands that is about to move along the path.
    pub fn stand(&self, path: &Path, radius: f64) -> Stand {
        let mut nearest: Option<(V3, f64)> = None;
        let mut pressed = Stand::Free;
        let out = |point: V3| (path.from - point).try_normalize(0.0).unwrap_or_else(V3::z);
        self.near(&path.from, radius + TOLERANCE, |face, limit| {
            let Some(point) = face.foot(&path.from, limit) else { return limit };
            let distance = (path.from - point).norm();
            if nearest.is_none_or(|(_, least)| distance < least) {
                nearest = Some((point, distance));
            }
            let normal = out(point);
            if normal.dot(&path.direction) < GRAZING {
                pressed = Stand::Pressed(point, normal);
            }
            limit
        });
        match nearest {
            Some((point, distance)) if distance < radius - TOLERANCE => {
                Stand::Inside(point, out(point), radius - distance)
            }
            _ => pressed,
        }
    }

    /// Where a ball of this radius that was free begins to touch the surface.
    pub fn first(&self, path: &Path, radius: f64) -> Option<Met> {
        let mut found: Option<Met> = None;
        let room = radius + TOLERANCE;
        // a ball that goes s mm touches nothing that is farther away than that and its radius
        let reach = radius + path.length;
        self.tree.near_ahead(path, room, reach, |indices, mut limit| {
            for face in self.faces.get(indices).unwrap_or_default() {
                let before = found.map_or(path.length, |met| met.way);
                let met = face.first(path, radius, before);
                let sooner = |length: &f64| found.is_none() || *length < before;
                let Some(way) = met.filter(sooner) else { continue };
                let ball = path.at(way);
                let Some(point) = face.foot(&ball, f64::INFINITY) else { continue };
                if (ball - point).dot(&path.direction) < GRAZING * radius {
                    let normal = (ball - point).try_normalize(0.0).unwrap_or(-path.direction);
                    found = Some(Met { way, point, normal });
                    limit = radius + way;
                }
            }
            limit
        });
        found
    }

    /// Tells the triangles that may lie within `limit` of a point, near ones first. What is answered is the new limit.
    fn near(&self, p: &V3, limit: f64, mut tell: impl FnMut(&Face, f64) -> f64) {
        self.tree.near(p, limit, |indices, limit| {
            self.faces.get(indices).unwrap_or_default().iter().fold(limit, |limit, face| tell(face, limit))
        });
    }

    /// Whether triangles may lie within a box.
    pub fn reaches_into(&self, extent: &Extent) -> bool {
        let mut any = false;
        self.tree.within(extent, |_| any = true);
        any
    }

    /// First contact of the side of a rod, which may come from either side of the surface.
    pub fn first_of_rod(&self, rod: &Rod, path: &Path) -> Option<Met> {
        let mut found: Option<Met> = None;
        self.tree.within(&rod.swept(path), |indices| {
            let faces = self.faces.get(indices).unwrap_or_default().iter();
            let met = faces.filter_map(|face| rod::first_on_triangle(&face.corners, rod, path));
            found = earliest(met.chain(found));
        });
        found
    }
}

fn corners_of(corners: &[V3], triangle: &[u32; 3]) -> Option<[V3; 3]> {
    let [a, b, c] = triangle.map(|index| corners.get(index as usize).copied());
    Some([a?, b?, c?])
}

#[cfg(test)]
mod tests;
