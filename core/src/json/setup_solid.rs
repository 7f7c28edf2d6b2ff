//! A solid of the part in the setup file.

use super::Error;
use super::setup_surface::{self, SurfaceFile};
use crate::workpiece::{PartErrors, Shape, Solid};
use serde::Deserialize;

/// A solid.
#[derive(Deserialize)]
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

#[derive(Clone, Copy, Debug, Deserialize)]
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

/// Errors of a solid. All zero: none.
#[derive(Default, Deserialize)]
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

pub(super) fn solid(file: SolidFile) -> Result<Solid, Error> {
    let shape = match (file.shape, file.surface) {
        (ShapeName::Surface, Some(surface)) if file.size.is_empty() => setup_surface::shape(surface)?,
        (ShapeName::Surface, _) | (_, Some(_)) => {
            return Err(Error::Unknown {
                what: "shape",
                name: format!("{:?} with {} sizes", file.shape, file.size.len()),
            });
        }
        (shape, None) => sized(shape, &file.size)?,
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
fn sized(shape: ShapeName, size: &[f64]) -> Result<Shape, Error> {
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
            return Err(Error::Unknown { what: "shape", name: format!("{shape:?} with {} sizes", size.len()) });
        }
    })
}
