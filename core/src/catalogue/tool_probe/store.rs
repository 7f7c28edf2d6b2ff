//! What calibrating a tool probe found: the results, the comparison with what is stored, the new data (B:4324-4326).

use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::{calibration, tolerance};

/// A trigger point.
#[derive(Clone, Debug, PartialEq)]
pub struct Trigger {
    /// Datum of the trigger point: `_TP[0,4]`.
    pub name: String,
    /// Index of the field in `_OVR[]` that takes it; the difference follows in the next.
    pub result: usize,
    /// As found, mm.
    pub value: f64,
}

/// What every call tells about itself, with the number that the name of its cycle has (B:4216-4221, B:4231-4241).
pub fn begin(machine: &mut dyn Machine, inputs: &Inputs) {
    let number = inputs.cycle.name.trim_start_matches("CYCLE").parse();
    results::begin(machine, inputs, number.unwrap_or_default());
    results::integer(machine, 3, inputs.variant);
    results::length(machine, 27, inputs.number(names::TZL));
}

/// Reports, compares with the safe area, and stores what differs by more than `_TZL`; `beside`: differences that count
/// for the safe area and are not stored, mm.
pub fn store(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    found: &[Trigger],
    beside: &[f64],
    repetition: u32,
) -> Result<Next, Stop> {
    let differences = [beside, &report(machine, found)].concat();
    let next = tolerance::safe(machine, inputs, &differences, repetition)?;
    if next == Next::Done {
        let named = found.iter().map(|one| (one.name.clone(), one.value));
        calibration::renew(machine, inputs, named.collect());
    }
    Ok(next)
}

/// Reports and stores without any comparison, as incremental calibration does (B:4432).
pub fn store_always(machine: &mut dyn Machine, found: &Trigger) -> Next {
    report(machine, std::slice::from_ref(found));
    let per = machine.control().basic_factor();
    results::set(machine, &found.name, found.value / per);
    Next::Done
}

/// Results; the differences, mm.
fn report(machine: &mut dyn Machine, found: &[Trigger]) -> Vec<f64> {
    let report = |one: &Trigger| {
        let difference = one.value - machine.control().basic_length(&one.name);
        results::length(machine, one.result, one.value);
        results::length(machine, one.result + 1, difference);
        difference
    };
    found.iter().map(report).collect()
}
