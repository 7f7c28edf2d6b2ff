//! Heights over a grid.

use super::{FreeSurface, LARGEST, check_count, numbers, refused};
use crate::geometry::{Mesh, V3};
use crate::refused::Refused;

/// Heights in rows along X, the first row at the least Y. The middle of the grid is the origin.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Heights {
    /// Heights a row.
    pub columns: usize,
    /// Distance of neighbours along X and Y, mm.
    pub step: [f64; 2],
    /// All heights Z, row by row, mm.
    pub values: Vec<f64>,
}

impl Heights {
    /// A grid of so many cells over a rectangle X × Y, mm; `height` is asked for at each of its points.
    pub fn over(size: [f64; 2], cells: [usize; 2], height: impl Fn(f64, f64) -> f64) -> Heights {
        let cells = cells.map(|count| count.max(1));
        let step = [size[0] / cells[0] as f64, size[1] / cells[1] as f64];
        let at = |index: usize, axis: usize| index as f64 * step[axis] - size[axis] / 2.0;
        let rows = 0..=cells[1];
        let values = rows.flat_map(|row| {
            let y = at(row, 1);
            let height = &height;
            (0..=cells[0]).map(move |column| height(at(column, 0), y))
        });
        Heights { columns: cells[0] + 1, step, values: values.collect() }
    }

    /// Of the grey values of a picture, row by row from above, as a relief: white is 0, black lies `depth` mm deeper.
    /// The picture covers a rectangle X × Y, mm. A picture that is too large is taken at fewer places.
    pub(crate) fn from_greys(greys: &[u8], columns: usize, size: [f64; 2], depth: f64) -> Result<Heights, Refused> {
        let rows = greys.len().checked_div(columns).unwrap_or(0);
        if columns < 2 || rows < 2 || greys.len() != columns * rows {
            return Err(refused("surface-grid"));
        }
        let most = super::TRIANGLES as f64 / 2.0;
        let coarser = ((columns * rows) as f64 / most).sqrt().max(1.0);
        let cells = [columns, rows].map(|count| (((count - 1) as f64 / coarser) as usize).max(1));
        let pixel = |part: f64, count: usize| (part * (count - 1) as f64).round() as usize;
        Ok(Heights::over(size, cells, |x, y| {
            let column = pixel(x / size[0] + 0.5, columns);
            let row = rows - 1 - pixel(y / size[1] + 0.5, rows).min(rows - 1);
            let grey = greys.get(row * columns + column.min(columns - 1));
            (f64::from(grey.copied().unwrap_or(0)) / 255.0 - 1.0) * depth
        }))
    }

    /// A surface of them; each cell is halved from its first corner to the opposite one.
    pub(crate) fn surface(self) -> Result<FreeSurface, Refused> {
        self.check()?;
        let mesh = Mesh::new(self.corners(), self.triangles());
        Ok(FreeSurface { heights: Some(self), mesh })
    }

    pub(super) fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    pub(super) fn check(&self) -> Result<(), Refused> {
        let rows = self.rows();
        let steps = self.step.iter().all(|step| *step > 0.0 && *step <= LARGEST);
        if self.columns < 2 || rows < 2 || rows * self.columns != self.values.len() || !steps {
            return Err(refused("surface-grid"));
        }
        check_count(2 * (rows - 1) * (self.columns - 1))?;
        let ends = [self.columns as f64 * self.step[0], rows as f64 * self.step[1]];
        numbers(ends.iter().chain(&self.values))
    }

    fn corners(&self) -> Vec<V3> {
        let half = [self.columns, self.rows()].map(|count| (count - 1) as f64 / 2.0);
        let corners = self.values.iter().enumerate().map(|(index, height)| {
            let (column, row) = (index % self.columns, index / self.columns);
            let x = (column as f64 - half[0]) * self.step[0];
            let y = (row as f64 - half[1]) * self.step[1];
            V3::new(x, y, *height)
        });
        corners.collect()
    }

    fn triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(2 * self.values.len());
        for row in 1..self.rows() {
            for column in 1..self.columns {
                let last = (row * self.columns + column) as u32;
                let below = last - self.columns as u32;
                triangles.push([below - 1, below, last]);
                triangles.push([below - 1, last, last - 1]);
            }
        }
        triangles
    }
}
