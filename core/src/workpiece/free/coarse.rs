//! A surface with fewer triangles, to look at it.

use super::{FreeSurface, Heights};
use crate::geometry::V3;
use std::collections::HashMap;

impl FreeSurface {
    /// A copy with about `most` triangles: a grid of fewer heights, or near corners put together; none: it has no more.
    pub fn coarser(&self, most: usize) -> Option<FreeSurface> {
        let triangles = self.mesh.triangles().len();
        if triangles <= most || most == 0 {
            return None;
        }
        let every = (triangles as f64 / most as f64).sqrt().ceil() as usize;
        match &self.heights {
            Some(heights) => heights.every(every).surface().ok(),
            None => self.joined(most),
        }
    }

    fn joined(&self, most: usize) -> Option<FreeSurface> {
        let [low, high] = self.bounds().map(V3::from);
        let size = high - low;
        // of a surface over a rectangle each cell has two triangles; over a closed body there are more cells
        let area = size.x * size.y + size.y * size.z + size.z * size.x;
        let cell = (2.0 * area / most as f64).sqrt().max(1e-9);
        let mut corners: HashMap<[i64; 3], V3> = HashMap::new();
        let mut placed = |corner: [f64; 3]| -> [f64; 3] {
            let corner = V3::from(corner);
            let key = ((corner - low) / cell).map(|part| part.round() as i64).into();
            (*corners.entry(key).or_insert(corner)).into()
        };
        let triangles: Vec<_> = self.triangles().map(|corners| corners.map(&mut placed)).collect();
        FreeSurface::from_triangles(&triangles).ok()
    }
}

impl Heights {
    /// Every so many columns and rows; the border stays where it is.
    fn every(&self, every: usize) -> Heights {
        let count = [self.columns, self.rows()];
        let cells = count.map(|count| (count - 1).div_ceil(every).max(1));
        let size = [0, 1].map(|axis| (count[axis] - 1) as f64 * self.step[axis]);
        let place = |part: f64, axis: usize| ((part / size[axis] + 0.5) * (count[axis] - 1) as f64).round() as usize;
        Heights::over(size, cells, |x, y| {
            let index = place(y, 1) * self.columns + place(x, 0);
            self.values.get(index).copied().unwrap_or(0.0)
        })
    }
}
