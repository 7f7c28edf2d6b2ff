//! Frames and tool environments in the setup file.

use super::Error;
use super::setup_active::{PlaneName, plane};
use crate::control::{Control, Environment, Frame};
use crate::refused::Path;
use serde::Deserialize;

/// A stored tool environment.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
pub(super) struct EnvironmentFile {
    /// T number.
    tool: i64,
    /// D number.
    edge: i64,
    /// DL number, 0 none.
    #[serde(default)]
    location: i64,
    /// Working plane.
    #[serde(default)]
    plane: PlaneName,
}

/// A frame.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub(super) struct FrameFile {
    /// Coarse translation X Y Z.
    coarse: [f64; 3],
    /// Fine translation X Y Z.
    #[serde(default)]
    fine: [f64; 3],
    /// Rotation about X Y Z (RPY), degree.
    #[serde(default)]
    rotation: [f64; 3],
    /// Coarse translation of the rotary axes A B C, degree.
    #[serde(default)]
    rotary: [f64; 3],
    /// Fine translation of the rotary axes A B C, degree.
    #[serde(default)]
    rotary_fine: [f64; 3],
    /// Scale factors along its own X Y Z; 1: none. Measuring does not work with any other.
    #[serde(default = "no_scale")]
    scale: [f64; 3],
    /// Whether the direction of X Y Z is reversed.
    #[serde(default)]
    mirror: [bool; 3],
}

fn no_scale() -> [f64; 3] {
    Frame::default().scale
}

pub(super) fn environment(file: &EnvironmentFile) -> Environment {
    Environment { tool: file.tool, edge: file.edge, location: file.location, plane: plane(file.plane) }
}

pub(super) fn place_frame(control: &mut Control, name: &str, file: &FrameFile) -> Result<(), Error> {
    let frame = Frame {
        coarse: file.coarse,
        fine: file.fine,
        rotation: file.rotation,
        rotary: file.rotary,
        rotary_fine: file.rotary_fine,
        scale: file.scale,
        mirror: file.mirror,
    };
    let index = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.strip_suffix(']')?.parse().ok() };
    if name == "$P_SETFR" {
        control.system = frame;
    } else if let Some(number) = index("$P_CHBFR[") {
        control.channel_basic.insert(number, frame);
    } else if let Some(number) = index("$P_NCBFR[") {
        control.global_basic.insert(number, frame);
    } else {
        let unknown = || Error::new("setup-frame", Path::of(&["frames", name])).text("name", name);
        control.frames.insert(control.settable_named(name).ok_or_else(unknown)?, frame);
    }
    Ok(())
}
