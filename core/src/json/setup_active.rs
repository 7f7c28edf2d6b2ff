//! What is in force at the start, in the setup file: plane, units, tool, frame, diameters.

use super::Error;
use crate::control::{Control, Plane, Transverse, Units};
use crate::refused::Path;
use serde::Deserialize;

#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
pub(super) enum UnitsName {
    #[default]
    #[serde(rename = "mm")]
    Millimetre,
    #[serde(rename = "inch")]
    Inch,
}

/// Working plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
pub(super) enum PlaneName {
    #[default]
    G17,
    G18,
    G19,
}

/// What is in force at the start.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, default)]
pub(super) struct ActiveFile {
    /// T number in the spindle, 0 none.
    tool: i64,
    /// D number (NCT: H), 0 none.
    edge: i64,
    /// Settable frame, for example `G54`.
    frame: String,
    /// G function of units: `G70`, `G71`, `G700`, `G710` (NCT `G20`, `G21`); none: that of the basic system.
    units: String,
    /// How positions of X are given.
    transverse: TransverseName,
    /// Position of the spindle, degree, positive as M3 turns it.
    spindle: f64,
    /// Where the rotary axes A B C stand, machine, degree.
    rotary: [f64; 3],
}

/// How positions of the transverse axis X of a lathe are given: radii, diameters, diameters where they are absolute.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "UPPERCASE")]
pub(super) enum TransverseName {
    #[default]
    Diamof,
    Diamon,
    Diam90,
}

pub(super) fn activate(control: &mut Control, file: &ActiveFile) -> Result<(), Error> {
    control.tool = file.tool;
    control.edge = file.edge;
    control.transverse = transverse(file.transverse);
    control.spindle = file.spindle;
    control.rotary = file.rotary;
    if !file.frame.is_empty() {
        let unknown = || Error::new("setup-frame", Path::of(&["active", "frame"])).text("name", &file.frame);
        control.settable = control.settable_named(&file.frame).ok_or_else(unknown)?;
    }
    control.activate(control.settable);
    if !file.units.is_empty() {
        choose_units(control, &file.units)?;
    }
    Ok(())
}

/// Makes a G function of units the one in force, by its name: `G70`.
pub(super) fn choose_units(control: &mut Control, name: &str) -> Result<(), Error> {
    let number = name.strip_prefix('G').and_then(|digits| digits.parse().ok());
    if number.is_some_and(|number| control.choose_units(number)) {
        return Ok(());
    }
    Err(Error::new("setup-units", Path::of(&["active", "units"])).text("name", name))
}

/// The basic system with this name.
pub(super) fn units(name: UnitsName) -> Units {
    match name {
        UnitsName::Millimetre => Units::Metric,
        UnitsName::Inch => Units::Inch,
    }
}

/// Name of a basic system.
pub(super) fn units_of(basic: Units) -> &'static str {
    match basic {
        Units::Metric => "mm",
        Units::Inch => "inch",
    }
}

/// The plane with this name.
pub(super) fn plane(name: PlaneName) -> Plane {
    match name {
        PlaneName::G17 => Plane::G17,
        PlaneName::G18 => Plane::G18,
        PlaneName::G19 => Plane::G19,
    }
}

/// What this function says of the transverse axis.
pub(super) fn transverse(name: TransverseName) -> Transverse {
    match name {
        TransverseName::Diamof => Transverse::Radius,
        TransverseName::Diamon => Transverse::Diameter,
        TransverseName::Diam90 => Transverse::AbsoluteDiameter,
    }
}
