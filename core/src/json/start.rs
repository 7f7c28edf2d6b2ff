//! The machine of a request: the core's own, or one that the user described.

use super::setup::{DatumFile, from_value, read_data};
use super::setup_active::{PlaneName, UnitsName, choose_units, plane, units};
use super::{Error, shape};
use crate::SIMULATES;
use crate::dialect::Dialect;
use crate::machine::setup::Setup;
use crate::refused::Path;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// What the core's own machine begins with.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct OwnMachine {
    /// Basic system of units.
    basic: UnitsName,
    /// Working plane.
    plane: PlaneName,
    /// G function of units, `G70`, `G71`, `G700`, `G710` (NCT `G20`, `G21`); none: that of the basic system.
    units: Option<String>,
    /// User and machine data that differ.
    data: BTreeMap<String, DatumFile>,
}

/// The machine of a request.
pub(super) struct Start {
    /// What is there.
    pub setup: Setup,
    /// Whether the user described it; else it is the core's own.
    pub described: bool,
}

/// The machine of a request: a setup that the user described, or the core's own, as it is or with what was chosen for
/// it (`{ "own": { "basic": "inch", "plane": "G18", "units": "G70" } }`).
pub(super) fn start(dialect: Dialect, machine: Option<Value>) -> Result<Start, Error> {
    let own = match machine {
        Some(mut machine) => match machine.get_mut("own") {
            Some(own) => shape::read(own.take())?,
            None => return described(machine),
        },
        None => OwnMachine::default(),
    };
    let mut setup = Setup::calibrated_in(dialect, plane(own.plane), units(own.basic));
    if let Some(name) = &own.units {
        choose_units(&mut setup.control, name)?;
    }
    read_data(&mut setup.control, own.data);
    setup.possible()?;
    Ok(Start { setup, described: false })
}

/// What it takes to read a description is only in builds that also simulate on it.
fn described(machine: Value) -> Result<Start, Error> {
    if !SIMULATES {
        return Err(Error::new("document-no-setup", Path::default()));
    }
    Ok(Start { setup: from_value(machine)?, described: true })
}
