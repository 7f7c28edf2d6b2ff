//! Free surfaces in the setup file.

use super::{Error, object};
use crate::refused::Path;
use crate::workpiece::Shape;
use crate::workpiece::free::{EXAMPLES, FreeSurface, Heights, LARGEST};
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;

/// Free surface of a solid; its own X and Y along the part, Z up, lengths in mm.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(super) enum SurfaceFile {
    /// One of ours; it is written as heights.
    Example {
        /// `dome`, `waves`, `saddle`, `step`.
        name: String,
        /// X, Y, and how far the lowest point lies below 0.
        size: [f64; 3],
    },
    /// Heights over a grid; its middle is the origin.
    Heights {
        /// Heights a row.
        columns: usize,
        /// Distance of neighbours along X and along Y.
        step: [f64; 2],
        /// Rows along X, the first at the least Y.
        values: Vec<f64>,
    },
    /// Single triangles, three corners X Y Z each, counter-clockwise seen from outside.
    Triangles(Vec<[[f64; 3]; 3]>),
}

/// The surface as something that can be touched.
pub(super) fn shape(path: &Path, file: SurfaceFile) -> Result<Shape, Error> {
    let surface = match file {
        SurfaceFile::Example { name, size } => Ok(example(path, &name, size)?),
        SurfaceFile::Heights { columns, step, values } => Heights { columns, step, values }.surface(),
        SurfaceFile::Triangles(triangles) => FreeSurface::from_triangles(&triangles),
    }
    .map_err(|refused| Error { path: path.clone(), ..refused.into() })?;
    Ok(Shape::Free(Arc::new(surface)))
}

/// One of our surfaces.
pub(crate) fn example(path: &Path, name: &str, size: [f64; 3]) -> Result<FreeSurface, Error> {
    let known = EXAMPLES.iter().find(|(known, _)| *known == name);
    let unknown = || Error::new("surface-example", path.clone()).text("name", name);
    let (_, example) = known.ok_or_else(unknown)?;
    let [x, y, height] = size;
    for value in size {
        if !(value > 0.0 && value <= LARGEST) {
            let refused = Error::new("setup-above", path.member("size")).number("value", value);
            return Err(refused.number("min", 0.0).number("max", LARGEST));
        }
    }
    Ok(example.heights([x, y], height).surface()?)
}

/// As the setup file has it.
pub(super) fn view(surface: &FreeSurface) -> Value {
    let Some(heights) = &surface.heights else {
        let triangles: Value = surface.triangles().map(triangle).collect();
        return object([("triangles", triangles)]);
    };
    let heights = object([
        ("columns", heights.columns.into()),
        ("step", heights.step.into()),
        ("values", heights.values.as_slice().into()),
    ]);
    object([("heights", heights)])
}

fn triangle(corners: [[f64; 3]; 3]) -> Value {
    corners.into_iter().map(Value::from).collect()
}
