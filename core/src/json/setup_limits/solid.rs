//! What a solid of a setup file may be.

use super::{LIMIT, bound, small};
use crate::geometry::rigid::sin_cos;
use crate::json::Error;
use crate::workpiece::{PartErrors, Shape, Solid};

/// Most lobes of a round wall.
const LOBES: u32 = 100;

/// A solid that can exist: sizes above 0, also where its errors make it smaller.
pub(in crate::json) fn solid(name: &str, solid: &Solid) -> Result<(), Error> {
    let errors = &solid.errors;
    small(&format!("{name}.at"), &solid.at)?;
    small(&format!("{name}.rotation"), &solid.rotation)?;
    small(&format!("{name}.errors.shift"), &errors.shift)?;
    small(&format!("{name}.errors.tilt"), &errors.tilt)?;
    if let Shape::Free(_) = solid.shape {
        return Ok(()); // looked at where it was made; no error changes its size
    }
    nominal(name, &solid.shape)?;
    with_errors(name, &solid.shape, errors)
}

/// Sizes as on the drawing.
fn nominal(name: &str, shape: &Shape) -> Result<(), Error> {
    if let Some(angle) = opening(shape) {
        let holds = (1.0..=179.0).contains(&angle);
        bound(&format!("{name}.size"), angle, holds, "an angle of 1 to 179 degrees")?;
    }
    let (across, deep) = sizes(shape);
    for size in across.iter().chain([&deep]) {
        bound(&format!("{name}.size"), *size, *size > 0.0 && *size <= LIMIT, "more than 0, and at most 1000000 mm")?;
    }
    if let Shape::Turned { diameter, length, bore: [bore, depth] } = *shape {
        let holds = bore == 0.0 || bore < diameter && depth > 0.0 && depth < length;
        let what = format!("{name}.size: bore");
        bound(&what, bore, holds, "0, or less than the part")?;
    }
    Ok(())
}

/// What the errors leave of the sizes.
fn with_errors(name: &str, shape: &Shape, errors: &PartErrors) -> Result<(), Error> {
    let (across, deep) = sizes(shape);
    let (amplitude, lobes) = errors.out_of_round;
    bound(&format!("{name}.errors.outOfRound"), f64::from(lobes), lobes <= LOBES, "at most 100 lobes")?;
    let least = across.iter().copied().fold(f64::INFINITY, f64::min) + errors.size - 2.0 * amplitude.abs();
    bound(&format!("{name}: size less size error and amplitude"), least, least > 0.0 && least <= LIMIT, "more than 0")?;
    let bottom = least + errors.taper * deep;
    bound(&format!("{name}: size at the bottom"), bottom, bottom > 0.0 && bottom <= LIMIT, "more than 0")
}

/// Angle between the edges of a corner, degree.
fn opening(shape: &Shape) -> Option<f64> {
    match *shape {
        Shape::OuterCorner { angle, .. } | Shape::InnerCorner { angle, .. } => Some(angle),
        _ => None,
    }
}

/// Sizes across, to which errors add, and the depth.
fn sizes(shape: &Shape) -> (Vec<f64>, f64) {
    match *shape {
        Shape::Hole { diameter, depth } => (vec![diameter], depth),
        Shape::Shaft { diameter, height } => (vec![diameter], height),
        Shape::Groove { width, depth, length } => (vec![width, length], depth),
        Shape::Web { width, height, length } => (vec![width, length], height),
        Shape::Pocket { length, depth } => (length.to_vec(), depth),
        Shape::Island { length, height } => (length.to_vec(), height),
        Shape::Block { size: [x, y, z] } => (vec![x, y], z),
        Shape::OuterCorner { angle, length, height: deep } | Shape::InnerCorner { angle, length, depth: deep } => {
            (length.map(|l| l * sin_cos(angle).0).to_vec(), deep)
        }
        Shape::Turned { diameter, length, bore: [bore, _] } => match bore == 0.0 {
            true => (vec![diameter], length),
            false => (vec![diameter, bore], length),
        },
        Shape::Chuck { diameter, length, grip } => (vec![diameter, grip], length),
        Shape::Sphere { diameter } => (vec![diameter], diameter),
        Shape::Free(_) => (Vec::new(), 0.0),
    }
}
