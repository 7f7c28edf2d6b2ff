//! Free surfaces: examples of ours, a grid of heights, or the triangles of a user's file.

mod coarse;
mod example;
mod heights;
mod stl;

pub use example::{EXAMPLES, Example};
pub use heights::Heights;
pub use stl::triangles as stl_triangles;

use crate::geometry::{Extent, Mesh, V3};
use crate::refused;
use std::collections::HashMap;

/// Most triangles of a surface.
pub const TRIANGLES: usize = 500_000;
/// Largest coordinate, mm: contact is computed to 1e-9 mm, which f64 holds up to here.
pub const LARGEST: f64 = 1e6;

/// Why a surface is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// It has no triangle with an area.
    Empty,
    /// More than [`TRIANGLES`].
    TooMany(usize),
    /// A number that is none, or larger than [`LARGEST`].
    NoNumber,
    /// Heights that are no grid.
    NoGrid,
    /// A file that is no STL, and the key of why.
    NoStl(&'static str),
}

impl From<Refused> for refused::Refused {
    fn from(why: Refused) -> refused::Refused {
        let told = |key: &'static str| refused::Refused::new(key, refused::Path::default());
        match why {
            Refused::Empty => told("surface-empty"),
            Refused::TooMany(count) => {
                told("surface-triangles").number("count", count as f64).number("most", TRIANGLES as f64)
            }
            Refused::NoNumber => told("surface-number").number("min", -LARGEST).number("max", LARGEST),
            Refused::NoGrid => told("surface-grid"),
            Refused::NoStl(why) => told("surface-stl").text("why", why),
        }
    }
}

/// A surface that can be touched from both sides. Its own frame: X and Y along the part, Z up.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeSurface {
    /// What it was made of, where that is a grid of heights.
    pub heights: Option<Heights>,
    /// Its triangles.
    pub mesh: Mesh,
}

impl FreeSurface {
    /// Of heights over a grid; each cell is halved from its first corner to the opposite one.
    ///
    /// # Errors
    /// The heights are no grid, or not numbers.
    pub fn from_heights(heights: Heights) -> Result<FreeSurface, Refused> {
        heights.check()?;
        let mesh = Mesh::new(heights.corners(), heights.triangles());
        Ok(FreeSurface { heights: Some(heights), mesh })
    }

    /// Of single triangles. Corners at the same place become one.
    ///
    /// # Errors
    /// There are none or too many triangles, or not numbers.
    pub fn from_triangles(triangles: &[[[f64; 3]; 3]]) -> Result<FreeSurface, Refused> {
        check_count(triangles.len())?;
        let mut corners = Vec::new();
        let mut known: HashMap<[u64; 3], u32> = HashMap::new();
        let mut indices = Vec::with_capacity(triangles.len());
        for triangle in triangles {
            if triangle.as_flattened().iter().any(|value| !fits(*value)) {
                return Err(Refused::NoNumber);
            }
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
            return Err(Refused::Empty);
        }
        Ok(FreeSurface { heights: None, mesh })
    }

    /// The triangles one by one.
    pub fn triangles(&self) -> impl Iterator<Item = [[f64; 3]; 3]> + '_ {
        let corners = self.mesh.corners();
        let at = move |index: u32| corners.get(index as usize).copied().unwrap_or_default();
        let triangles = self.mesh.triangles().iter();
        triangles.map(move |triangle| triangle.map(|index| at(index).into()))
    }

    /// Lowest and highest coordinate along each axis, mm.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let Extent { low, high } = Extent::of(self.mesh.corners().iter().copied());
        [low.into(), high.into()]
    }
}

fn check_count(triangles: usize) -> Result<(), Refused> {
    match triangles {
        0 => Err(Refused::Empty),
        1..=TRIANGLES => Ok(()),
        _ => Err(Refused::TooMany(triangles)),
    }
}

/// Whether something can be reckoned with a coordinate.
fn fits(value: f64) -> bool {
    value.abs() <= LARGEST
}

#[cfg(test)]
mod tests;
