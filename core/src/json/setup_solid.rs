//! A solid of the part in the setup file.

use super::setup_surface::SurfaceFile;
use super::{Error, setup_surface};
use crate::refused::Path;
use crate::workpiece::{PartErrors, Shape, Solid};
use serde::Deserialize;

/// A solid.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
pub(super) struct SolidFile {
    /// Element.
    shape: ShapeName,
    /// hole: diameter, depth; shaft: diameter, height; groove and web: width, depth, length; pocket and island:
    /// X, Y, depth; block: X, Y, Z; turned: diameter, length, diameter and depth of the bore (0: none); chuck:
    /// diameter, length, diameter that it grips; sphere: diameter; outerCorner and innerCorner: angle between the edges
    /// in degree, lengths of the edge along X and of the other one, depth; surface: none.
    #[serde(default)]
    size: Vec<f64>,
    /// What a surface looks like, of this shape only.
    #[serde(default)]
    surface: Option<SurfaceFile>,
    /// Centre of the element at its upper face, of a sphere its centre, of a corner the corner, machine coordinates X Y
    /// Z.
    at: [f64; 3],
    /// Orientation about X Y Z (RPY), degree.
    #[serde(default)]
    rotation: [f64; 3],
    /// What is wrong with it.
    #[serde(default)]
    errors: ErrorsFile,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "camelCase")]
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
    fn refused(self, key: &'static str, path: &Path, count: usize) -> Error {
        let (name, wanted) = self.told();
        let refused = Error::new(key, path.member("size")).text("shape", name);
        refused.number("count", count as f64).number("wanted", wanted as f64)
    }
}

/// Errors of a solid. All zero: none.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
struct ErrorsFile {
    /// Displacement X Y Z, machine axes.
    shift: [f64; 3],
    /// Added to every diameter, width and length.
    size: f64,
    /// Turned about X Y Z about the origin of the solid, degree.
    tilt: [f64; 3],
    /// Growth of the diameter per mm of depth.
    taper: f64,
    /// Amplitude of the radius, number of lobes.
    out_of_round: (f64, u32),
}

/// A solid that stands at this place of the file.
pub(super) fn solid(path: &Path, file: SolidFile) -> Result<Solid, Error> {
    let shape = match (file.shape, file.surface) {
        (ShapeName::Surface, Some(surface)) if file.size.is_empty() => {
            setup_surface::shape(&path.member("surface"), surface)?
        }
        (ShapeName::Surface, _) | (_, Some(_)) => {
            return Err(file.shape.refused("setup-surface", path, file.size.len()));
        }
        (shape, None) => sized(path, shape, &file.size)?,
    };
    let errors = PartErrors {
        shift: file.errors.shift,
        size: file.errors.size,
        tilt: file.errors.tilt,
        taper: file.errors.taper,
        out_of_round: file.errors.out_of_round,
    };
    Ok(Solid { shape, at: file.at, rotation: file.rotation, errors })
}

/// A shape that its sizes tell.
fn sized(path: &Path, shape: ShapeName, size: &[f64]) -> Result<Shape, Error> {
    Ok(match (shape, size) {
        (ShapeName::Hole, &[diameter, depth]) => Shape::Hole { diameter, depth },
        (ShapeName::Shaft, &[diameter, height]) => Shape::Shaft { diameter, height },
        (ShapeName::Groove, &[width, depth, length]) => Shape::Groove { width, depth, length },
        (ShapeName::Web, &[width, height, length]) => Shape::Web { width, height, length },
        (ShapeName::Pocket, &[x, y, depth]) => Shape::Pocket { length: [x, y], depth },
        (ShapeName::Island, &[x, y, height]) => Shape::Island { length: [x, y], height },
        (ShapeName::Block, &[x, y, z]) => Shape::Block { size: [x, y, z] },
        (ShapeName::OuterCorner, &[angle, x, y, height]) => Shape::OuterCorner { angle, length: [x, y], height },
        (ShapeName::InnerCorner, &[angle, x, y, depth]) => Shape::InnerCorner { angle, length: [x, y], depth },
        (ShapeName::Turned, &[diameter, length, bore, depth]) => {
            Shape::Turned { diameter, length, bore: [bore, depth] }
        }
        (ShapeName::Chuck, &[diameter, length, grip]) => Shape::Chuck { diameter, length, grip },
        (ShapeName::Sphere, &[diameter]) => Shape::Sphere { diameter },
        (shape, size) => {
            return Err(shape.refused("setup-shape", path, size.len()));
        }
    })
}
