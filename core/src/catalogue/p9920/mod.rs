//! G65 P9920: the tool probe of NCT controls: calibrating it with a reference tool, measuring length and diameter of
//! tools (C:1185-1258).

mod params;
mod picture;
mod propose;
mod simulate;
#[cfg(test)]
mod tests;
mod touch;

use super::nct;
use super::nct::{params::length, ring};
use super::tool_probe;
use crate::catalogue::prelude::*;

/// A reference tool calibrates the probe: T0.
pub const CALIBRATE: i64 = 0;
/// The length is measured.
pub const LENGTH: i64 = 1;
/// Length and diameter are measured: K is given.
pub const DIAMETER: i64 = 2;

const AT_CALIBRATION: When = When::Variant(&[CALIBRATE]);
const AT_MEASUREMENT: When = When::Variant(&[LENGTH, DIAMETER]);
const AT_DIAMETER: When = When::Variant(&[DIAMETER]);

/// The probe does not say that it is ready (C:1204).
pub const MEASURING_DEVICE: Code = Code::Nct("MEASURING DEVICE?");
/// The probe is pressed before the measurement (C:1204).
pub const DEPRESSED: Code = Code::Nct("DEPRESSED?");
/// The tool hits the disk while it sinks beside it (C:1224, C:1245).
pub const TOO_SMALL: Code = Code::Nct("D TOO SMALL!");
/// The tool does not reach the disk (C:1224, C:1245).
pub const INCORRECT: Code = Code::Nct("INCORRECT PROBING!");

/// The macro. Example: a mill of 12 mm, as the block format has it (C:1234).
pub static P9920: Cycle = Cycle {
    name: "G65 P9920",
    key: "p9920",
    variants: &[
        Variant { number: CALIBRATE, key: "p9920-calibrate", source: "C:1208-1228" },
        Variant { number: LENGTH, key: "p9920-length", source: "C:1232-1258" },
        Variant { number: DIAMETER, key: "p9920-diameter", source: "C:1232-1258" },
    ],
    params: params::PARAMS,
    purpose: Purpose { probe: ProbeUse::Tool, calibrates: AT_CALIBRATION, ..Purpose::MILLING },
    results: &[
        calibrated("#506", "result-p9920-z", "C:1193"),
        calibrated("#507", "result-p9920-x", "C:1194"),
        calibrated("#508", "result-p9920-y", "C:1195"),
        calibrated("#509", "result-p9920-disk", "C:1196;C:1202"),
        calibrated("#513", "result-p9920-reference", "C:1200"),
        ResultField { when: AT_MEASUREMENT, ..length("LENGTH", "result-p9920-length", "C:1245") },
        ResultField { when: AT_DIAMETER, ..length("DIAMETER", "result-p9920-diameter", "C:1245") },
    ],
    alarms: &[&[MEASURING_DEVICE, DEPRESSED, TOO_SMALL, INCORRECT]],
    checks,
    help: Help::new(&[&[
        measures(AT_CALIBRATION, "help-p9920-measures-probe", "C:1191-1202"),
        measures(When::Variant(&[LENGTH]), "help-p9920-measures-length", "C:1232-1245"),
        measures(AT_DIAMETER, "help-p9920-measures-both", "C:1232-1245"),
        before(When::Always, "help-p9920-before-reference", "C:1204-1206"),
        before(AT_CALIBRATION, "help-p9920-before-centre", "C:1214"),
        before(AT_MEASUREMENT, "help-p9920-before-above", "C:1234"),
        order(AT_CALIBRATION, "help-p9920-order-rim", "C:1224"),
        order(AT_CALIBRATION, "help-p9920-order-face", "C:1224"),
        order(AT_MEASUREMENT, "help-p9920-order-length", "C:1245"),
        order(AT_DIAMETER, "help-p9920-order-diameter", "C:1245"),
        corrects(AT_CALIBRATION, "help-p9920-corrects-probe", "C:1191-1202"),
        corrects(AT_MEASUREMENT, "help-p9920-corrects-length", "C:1239"),
        corrects(AT_DIAMETER, "help-p9920-corrects-radius", "C:1239"),
        wrong(When::Always, "help-p9920-wrong-length", "C:1254"),
        wrong(AT_MEASUREMENT, "help-p9920-wrong-turning", "C:1251"),
        wrong(AT_DIAMETER, "help-p9920-wrong-lift", "C:1252"),
        wrong(AT_CALIBRATION, "help-p9920-wrong-disk", "C:1202"),
    ]]),
    picture: Drawing::staged(picture::stage, picture::marks),
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(AT_CALIBRATION, Element::Probe), (When::Always, Element::Tool)],
        corrects: &[(AT_CALIBRATION, Corrects::Setter, &[]), (When::Not(&AT_CALIBRATION), Corrects::Tool, &[])],
        options: &[
            (When::Variant(&[LENGTH]), "aim-measured", "p9920-length"),
            (AT_DIAMETER, "aim-measured", "p9920-diameter"),
        ],
    },
    source: "C:1185-1258",
    ..nct::MACRO
};

const fn calibrated(name: &'static str, key: &'static str, source: &'static str) -> ResultField {
    ResultField { when: AT_CALIBRATION, ..ring::value(name, key, source) }
}

/// What is contradictory or dangerous over several addresses.
fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    if diameter(inputs, control) == 0.0 && inputs.variant != LENGTH {
        // beside the disk the path is calculated with it
        findings.push(own::P9920_NO_DIAMETER.finding().at(address::D));
    }
    if inputs.variant != CALIBRATE && matches!(inputs.integer(address::M), 3 | 4) {
        // it comes down on the disk
        findings.push(own::P9920_TURNING_LENGTH.finding().at(address::M));
    }
    tool_probe::checks::radius(control, findings);
    let beside = matches!(inputs.variant, CALIBRATE | DIAMETER);
    if beside && inputs.given(address::E) == Some(0.0) {
        // the tool sinks along the wall of the disk
        findings.push(own::P9920_NO_CLEARANCE.finding().at(address::E));
    }
}

/// Diameter with which the paths are calculated, mm: D, or that of the register (C:1238).
fn diameter(inputs: &Inputs, control: &Control) -> f64 {
    let register = inputs.integer(address::T);
    let stored = || 2.0 * control.register(register).total_radius();
    inputs.given(address::D).unwrap_or_else(stored)
}
