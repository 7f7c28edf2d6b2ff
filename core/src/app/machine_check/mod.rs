//! The check of a machine: what its control exports, held against what measuring needs, with the lines to change.

mod changes;
mod data;
mod elements;
mod fault;
mod feeds;
mod read;
#[cfg(test)]
mod tests;
mod user;
mod words;

pub use fault::{MachineFault, MachineLimit, MachinePlace};
pub use feeds::MachineAxis;
pub(super) use feeds::{FEEDS, of_jog};
pub(super) use user::TO_ENTER;

use super::Error;
use crate::control::needs::Use;
use crate::diagnostic::Severity;
use crate::message::Message;
pub(super) use elements::no_element;
pub(super) use fault::{Files, unread};
pub(super) use read::{Exported, Given, Place};
use serde::{Deserialize, Serialize};

/// What the control exported.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MachineCheckRequest {
    /// Its files, or what somebody typed, in their order.
    pub files: Vec<ExportedFile>,
    /// What this machine does not do.
    #[serde(default)]
    pub without: Vec<Use>,
    /// Whether the control is an NCU 3, for which the manual prints larger memories (B:12955, A:14218).
    #[serde(default)]
    pub large: bool,
    /// Deflection that the probe allows, mm: feeds with a longer braking path are told.
    pub deflection: Option<f64>,
}

/// A file that the control exported.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ExportedFile {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// What is wrong with a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MachineCheckView {
    /// What is wrong, the worst first, then in the order of the manual.
    pub faults: Vec<MachineFault>,
    /// How many data were compared and what came of it, in words.
    pub ending: Message,
    /// Data that a check held against something.
    pub read: usize,
    /// Machine data that measuring needs and that no file gives, as their control calls them.
    pub missing: Vec<String>,
    /// The lines to change, as a control reads them; empty: none.
    pub changes: String,
    /// The slowest axis, where the files say what its braking path follows from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<MachineAxis>,
}

/// Checks a machine by what its control exported.
///
/// # Errors
/// Nothing of what was given is a datum that measuring needs, or no probe allows such a deflection.
pub fn machine_check(asked: MachineCheckRequest) -> Result<MachineCheckView, Error> {
    if let Some(wrong) = asked.deflection.filter(|deflection| !(deflection.is_finite() && *deflection > 0.0)) {
        return Err(super::braking::refused("deflection", wrong));
    }
    let mut given = Exported::default();
    for (file, one) in asked.files.iter().enumerate() {
        given.add(file, &one.text);
    }
    if given.data.is_empty() && given.sizes.is_empty() && !given.any_unread() {
        return Err(Error::new("machine-check-nothing", crate::refused::Path::default()));
    }
    let files = Files { files: &asked.files };
    let mut faults = fault::odd(&given, &files);
    faults.extend(elements::faults(&given, &files));
    faults.extend(data::faults(&given, &files, &asked.without, asked.large));
    faults.extend(user::faults(&given, &files, &asked.without));
    faults.extend(feeds::impossible(&given, &files));
    let deflection = asked.deflection;
    deflection.iter().for_each(|most| feeds::limit(&mut faults, &given, *most));
    faults.extend(deflection.iter().flat_map(|most| feeds::faults(&given, &files, &asked.without, *most)));
    faults.extend(deflection.and_then(|_| feeds::unchecked(&given)));
    faults.extend(deflection.and_then(|_| feeds::metric(&given)));
    faults.sort_by_key(|fault| fault.severity); // stable: within a severity the order of the manual
    changes::together(&mut faults);
    let count = |severity| faults.iter().filter(|fault| fault.severity == severity).count() as f64;
    let read = given.data.keys().filter(|(name, channel)| elements::is_compared(&given, name, *channel)).count();
    let ending = Message::new("machine-check-ending")
        .number("read", read as f64)
        .number("others", (given.others + given.data.len() - read) as f64)
        .number("errors", count(Severity::Error))
        .number("warnings", count(Severity::Warning))
        .number("notes", count(Severity::Note));
    let changes = changes::lines(&faults);
    let mut missing = data::missing(&given, &asked.without, asked.large);
    missing.extend(deflection.iter().flat_map(|_| feeds::missing(&given)));
    Ok(MachineCheckView { ending, read, missing, changes, faults, axis: feeds::axis(&given) })
}
