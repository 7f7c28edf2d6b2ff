//! Free surfaces: examples of ours, a grid of heights, or the triangles of a user's file.

mod coarse;
mod example;
mod heights;
mod stl;

pub use example::{EXAMPLES, Example};
pub use heights::Heights;
pub(crate) use stl::triangles as stl_triangles;

use crate::geometry::{Extent, Mesh, V3};
use crate::refused::{Path, Refused};
use std::collections::HashMap;

/// Most triangles of a surface.
pub const TRIANGLES: usize = 500_000;
/// Largest coordinate, mm: contact is computed to 1e-9 mm, which f64 holds up to here.
pub const LARGEST: f64 = 1e6;

/// A surface that can be touched from both sides. Its own frame: X and Y along the part, Z up.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeSurface {
    /// What it was made of, where that is a grid of heights.
    pub heights: Option<Heights>,
    /// Triangles of the surface.
    pub mesh: Mesh,
}

impl FreeSurface {
    /// Of single triangles. Corners at the same place become one.
    pub(crate) fn from_triangles(triangles: &[[[f64; 3]; 3]]) -> Result<FreeSurface, Refused> {
        check_count(triangles.len())?;
        let mut corners = Vec::new();
        let mut known: HashMap<[u64; 3], u32> = HashMap::new();
        let mut indices = Vec::with_capacity(triangles.len());
        for triangle in triangles {
            numbers(triangle.as_flattened())?;
            indices.push(triangle.map(|corner| {
                let place = corner.map(|value| (value + 0.0).to_bits()); // -0 is 0
                *known.entry(place).or_insert_with(|| {
                    corners.push(V3::from(corner));
                    corners.len() as u32 - 1
                })
            }));
        }
        let mesh = Mesh::new(corners, indices);
        if mesh.triangles().is_empty() {
            return Err(refused("surface-empty"));
        }
        Ok(FreeSurface { heights: None, mesh })
    }

    /// The triangles one by one.
    pub fn triangles(&self) -> impl Iterator<Item = [[f64; 3]; 3]> + '_ {
        let corners = self.mesh.corners();
        let at = move |index: u32| corners.get(index as usize).copied().unwrap_or_default();
        self.mesh.triangles().iter().map(move |triangle| triangle.map(|index| at(index).into()))
    }

    /// Lowest and highest coordinate along each axis, mm.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let Extent { low, high } = Extent::of(self.mesh.corners().iter().copied());
        [low.into(), high.into()]
    }
}

fn refused(key: &'static str) -> Refused {
    Refused::new(key, Path::default())
}

fn check_count(triangles: usize) -> Result<(), Refused> {
    let count = triangles as f64;
    match triangles {
        0 => Err(refused("surface-empty")),
        1..=TRIANGLES => Ok(()),
        _ => Err(refused("surface-triangles").number("count", count).number("most", TRIANGLES as f64)),
    }
}

/// Refuses coordinates with which nothing can be calculated.
fn numbers<'a>(values: impl IntoIterator<Item = &'a f64>) -> Result<(), Refused> {
    match values.into_iter().all(|value| value.abs() <= LARGEST) {
        true => Ok(()),
        false => Err(refused("surface-number").number("min", -LARGEST).number("max", LARGEST)),
    }
}

#[cfg(test)]
mod tests;
