//! Position in space from three points: what CYCLE119 computes, and CYCLE997 for three spheres (B:8541-8592).

use super::zero_offset::{Store, Target, rigid};
use crate::control::Control;
use crate::geometry::{V3, fit, triangle};
use nalgebra::IsometryMatrix3;

/// Set points cannot be brought onto measured ones (A:15930).
pub const NO_FRAME: u32 = 61411;
/// The frame takes no rotation (B:1971, B:8415).
const NO_ROTATION: u32 = 61321;
/// The measured triangle is not the set one (A:15933).
const DISTORTED: u32 = 61414;

/// How three points lie in space, seen from where they should lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// Takes set points to measured ones.
    pub motion: IsometryMatrix3<f64>,
    /// Sum of the distances that are left between them, mm (B:8581-8583).
    pub distortion: f64,
}

/// Refuses a frame that cannot be brought into position: a global basic frame, or one with a mirror or a scale factor,
/// its own or of the frames in effect (B:8405-8415, B:8588). Error: number of the alarm.
pub(crate) fn correctable(control: &Control, target: &Target) -> Result<(), u32> {
    match target.store {
        Store::GlobalBasic(_) => Err(NO_ROTATION),
        _ if rigid(control, target) => Ok(()),
        _ => Err(NO_FRAME),
    }
}

/// The nearest motion from set to measured points. Error: number of the alarm.
pub(crate) fn position(set: &[V3; 3], measured: &[V3; 3]) -> Result<Position, u32> {
    if fit::in_line(*set) || fit::in_line(*measured) {
        return Err(NO_FRAME);
    }
    let motion = triangle::laid(set, measured).ok_or(NO_FRAME)?;
    let left = |(set, measured): (&V3, &V3)| (motion.transform_point(&(*set).into()).coords - measured).norm();
    Ok(Position { motion, distortion: set.iter().zip(measured).map(left).sum() })
}

impl Position {
    /// Refuses a distortion that is not below this limit, mm (B:8409, B:8573). Error: number of the alarm.
    pub(crate) fn within(&self, limit: f64) -> Result<(), u32> {
        if self.distortion < limit { Ok(()) } else { Err(DISTORTED) }
    }
}
