//! A solid of the part in the setup file: its shape by name and sizes, or a free surface.

use crate::geometry::{Degrees, Mcs, Rpy};
use crate::refused::{Path, Refused};
use crate::workpiece::free::{EXAMPLES, LARGEST};
use crate::workpiece::{FreeSurface, Heights, PartErrors, Shape, Solid};
use serde::{Deserialize, Serialize, Serializer};
use std::sync::Arc;

/// A solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Solid", optional_fields))]
pub struct SolidFile {
    /// Element.
    shape: ShapeName,
    /// hole: diameter, depth; shaft: diameter, height; groove and web: width, depth, length; pocket and island:
    /// X, Y, depth; block: X, Y, Z; turned: diameter, length, diameter and depth of the bore (0: none); chuck:
    /// diameter, length, diameter that it grips; sphere: diameter; outerCorner and innerCorner: angle between the edges
    /// in degree, lengths of the edge along X and of the other one, depth; surface: none.
    #[serde(default)]
    size: Vec<f64>,
    /// What a surface looks like, of this shape only.
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<SurfaceFile>,
    /// Centre of the element at its upper face, of a sphere its centre, of a corner the corner, machine coordinates X Y
    /// Z.
    at: [f64; 3],
    /// Orientation about X Y Z (RPY), degree.
    #[serde(default)]
    rotation: Rpy,
    /// What is wrong with it.
    #[serde(default)]
    errors: PartErrors,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
enum ShapeName {
    Hole,
    Shaft,
    Groove,
    Web,
    Pocket,
    Island,
    Block,
    Turned,
    Chuck,
    Sphere,
    OuterCorner,
    InnerCorner,
    Surface,
}

/// Free surface of a solid; its own X and Y along the part, Z up, lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Surface"))]
enum SurfaceFile {
    /// One of ours; it is written as heights.
    Example {
        /// `dome`, `waves`, `saddle`, `step`.
        name: String,
        /// X, Y, and how far the lowest point lies below 0.
        size: [f64; 3],
    },
    /// Heights over a grid; its middle is the origin.
    Heights(Heights),
    /// Single triangles, three corners X Y Z each, counter-clockwise seen from outside.
    Triangles(Vec<[[f64; 3]; 3]>),
}

impl ShapeName {
    /// Key of its name, and how many sizes it takes.
    fn told(self) -> (&'static str, usize) {
        match self {
            ShapeName::Hole => ("setup-shape-hole", 2),
            ShapeName::Shaft => ("setup-shape-shaft", 2),
            ShapeName::Groove => ("setup-shape-groove", 3),
            ShapeName::Web => ("setup-shape-web", 3),
            ShapeName::Pocket => ("setup-shape-pocket", 3),
            ShapeName::Island => ("setup-shape-island", 3),
            ShapeName::Block => ("setup-shape-block", 3),
            ShapeName::Turned => ("setup-shape-turned", 4),
            ShapeName::Chuck => ("setup-shape-chuck", 3),
            ShapeName::Sphere => ("setup-shape-sphere", 1),
            ShapeName::OuterCorner => ("setup-shape-outer-corner", 4),
            ShapeName::InnerCorner => ("setup-shape-inner-corner", 4),
            ShapeName::Surface => ("setup-shape-surface", 0),
        }
    }

    /// It cannot have so many sizes.
    fn refused(self, key: &'static str, path: &Path, count: usize) -> Refused {
        let (name, wanted) = self.told();
        let refused = Refused::new(key, path.member("size")).text("shape", name);
        refused.number("count", count as f64).number("wanted", wanted as f64)
    }

    /// The shape that its sizes tell; none: there are not so many, or it is a surface.
    fn sized(self, size: &[f64]) -> Option<Shape> {
        Some(match (self, size) {
            (ShapeName::Hole, &[diameter, depth]) => Shape::Hole { diameter, depth },
            (ShapeName::Shaft, &[diameter, height]) => Shape::Shaft { diameter, height },
            (ShapeName::Groove, &[width, depth, length]) => Shape::Groove { width, depth, length },
            (ShapeName::Web, &[width, height, length]) => Shape::Web { width, height, length },
            (ShapeName::Pocket, &[x, y, depth]) => Shape::Pocket { length: [x, y], depth },
            (ShapeName::Island, &[x, y, height]) => Shape::Island { length: [x, y], height },
            (ShapeName::Block, &[x, y, z]) => Shape::Block { size: [x, y, z] },
            (ShapeName::Turned, &[diameter, length, bore, depth]) => {
                Shape::Turned { diameter, length, bore: [bore, depth] }
            }
            (ShapeName::Chuck, &[diameter, length, grip]) => Shape::Chuck { diameter, length, grip },
            (ShapeName::Sphere, &[diameter]) => Shape::Sphere { diameter },
            (ShapeName::OuterCorner, &[angle, x, y, height]) => {
                Shape::OuterCorner { angle: Degrees(angle), length: [x, y], height }
            }
            (ShapeName::InnerCorner, &[angle, x, y, depth]) => {
                Shape::InnerCorner { angle: Degrees(angle), length: [x, y], depth }
            }
            _ => return None,
        })
    }

    /// The shape and its sizes.
    fn of(shape: &Shape) -> (ShapeName, Vec<f64>) {
        match *shape {
            Shape::Hole { diameter, depth } => (ShapeName::Hole, vec![diameter, depth]),
            Shape::Shaft { diameter, height } => (ShapeName::Shaft, vec![diameter, height]),
            Shape::Groove { width, depth, length } => (ShapeName::Groove, vec![width, depth, length]),
            Shape::Web { width, height, length } => (ShapeName::Web, vec![width, height, length]),
            Shape::Pocket { length: [x, y], depth } => (ShapeName::Pocket, vec![x, y, depth]),
            Shape::Island { length: [x, y], height } => (ShapeName::Island, vec![x, y, height]),
            Shape::Block { size } => (ShapeName::Block, size.to_vec()),
            Shape::Turned { diameter, length, bore: [bore, depth] } => {
                (ShapeName::Turned, vec![diameter, length, bore, depth])
            }
            Shape::Chuck { diameter, length, grip } => (ShapeName::Chuck, vec![diameter, length, grip]),
            Shape::Sphere { diameter } => (ShapeName::Sphere, vec![diameter]),
            Shape::OuterCorner { angle, length: [x, y], height } => {
                (ShapeName::OuterCorner, vec![angle.0, x, y, height])
            }
            Shape::InnerCorner { angle, length: [x, y], depth } => (ShapeName::InnerCorner, vec![angle.0, x, y, depth]),
            Shape::Free(_) => (ShapeName::Surface, Vec::new()),
        }
    }
}

impl SolidFile {
    /// The solid that stands at this place of the file.
    pub(super) fn solid(self, path: &Path) -> Result<Solid, Refused> {
        let SolidFile { shape, size, surface, at, rotation, errors } = self;
        let shape = match (shape, surface) {
            (ShapeName::Surface, Some(surface)) if size.is_empty() => surface.shape(&path.member("surface"))?,
            (ShapeName::Surface, _) | (_, Some(_)) => return Err(shape.refused("setup-surface", path, size.len())),
            (shape, None) => shape.sized(&size).ok_or_else(|| shape.refused("setup-shape", path, size.len()))?,
        };
        Ok(Solid { shape, at: Mcs(at), rotation, errors })
    }
}

impl From<&Solid> for SolidFile {
    fn from(solid: &Solid) -> SolidFile {
        let (shape, size) = ShapeName::of(&solid.shape);
        let surface = match &solid.shape {
            Shape::Free(surface) => Some(SurfaceFile::of(surface)),
            _ => None,
        };
        SolidFile { shape, size, surface, at: solid.at.0, rotation: solid.rotation, errors: solid.errors }
    }
}

/// As the setup file has it.
impl Serialize for Solid {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        SolidFile::from(self).serialize(to)
    }
}

impl SurfaceFile {
    /// The surface as something that can be touched.
    fn shape(self, path: &Path) -> Result<Shape, Refused> {
        let surface = match self {
            SurfaceFile::Example { name, size } => Ok(example(path, &name, size)?),
            SurfaceFile::Heights(heights) => heights.surface(),
            SurfaceFile::Triangles(triangles) => FreeSurface::from_triangles(&triangles),
        }
        .map_err(|refused| Refused { path: path.clone(), ..refused })?;
        Ok(Shape::Free(Arc::new(surface)))
    }

    fn of(surface: &FreeSurface) -> SurfaceFile {
        match &surface.heights {
            Some(heights) => SurfaceFile::Heights(heights.clone()),
            None => SurfaceFile::Triangles(surface.triangles().collect()),
        }
    }
}

/// One of our surfaces.
///
/// # Errors
/// There is none of this name, or none of this size.
pub fn example(path: &Path, name: &str, size: [f64; 3]) -> Result<FreeSurface, Refused> {
    let known = EXAMPLES.iter().find(|(known, _)| *known == name);
    let unknown = || Refused::new("surface-example", path.clone()).text("name", name);
    let (_, example) = known.ok_or_else(unknown)?;
    let [x, y, height] = size;
    for value in size {
        if !(value > 0.0 && value <= LARGEST) {
            let refused = Refused::new("setup-above", path.member("size")).number("value", value);
            return Err(refused.number("min", 0.0).number("max", LARGEST));
        }
    }
    example.heights([x, y], height).surface()
}
