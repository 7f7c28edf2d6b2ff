//! Which probe a call measured with, and whence its calibration.

use crate::control::MachineSort;
use crate::entry::{Inputs, ProbeUse, names};
use crate::machine::Setup;
use crate::machine::calibrated::ProbeInCall;
use crate::message::Message;
use serde::Serialize;
use std::collections::BTreeMap;

/// The probe of a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ProbeOfCall {
    /// Number of its data field, from 1.
    pub number: i64,
    /// Whether it is a tool probe.
    pub tool: bool,
    /// Both in words.
    pub name: Message,
    /// Whence its calibration.
    pub state: CalibrationState,
    /// The same in words.
    pub calibration: Message,
    /// Line of the call that calibrated it in this run, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
}

/// Whence the calibration of a probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum CalibrationState {
    /// This call calibrates.
    Calibrates,
    /// A call of the same run calibrated it before.
    Run,
    /// The control had the data before the run.
    Stored,
    /// The control had the data before the run, and they are not those of the probe.
    Differs,
}

impl CalibrationState {
    fn key(self) -> &'static str {
        match self {
            CalibrationState::Calibrates => "record-calibrates",
            CalibrationState::Run => "record-calibrated-run",
            CalibrationState::Stored => "record-calibrated-stored",
            CalibrationState::Differs => "record-calibrated-differs",
        }
    }
}

/// The workpiece probe of a call, probe 1 where it uses none; in a turret a mono probe is used as a multi probe
/// (B:2277).
pub fn probe_of(inputs: &Inputs) -> ProbeInCall {
    let purpose = &inputs.cycle.purpose;
    let measures = purpose.probe == ProbeUse::Workpiece;
    let number = inputs.any(names::PRNUM).filter(|_| measures).unwrap_or(1.0) as i64;
    let mono = purpose.machine == MachineSort::Milling && number / 100 % 10 == 1;
    ProbeInCall { field: number % 100, mono, measures }
}

/// The probe of a call on a real machine: of its ball nothing is known that its data could be held against.
pub fn of_machine(probe: ProbeOfCall) -> ProbeOfCall {
    if probe.state != CalibrationState::Differs {
        return probe;
    }
    let state = CalibrationState::Stored;
    ProbeOfCall { state, calibration: Message::new(state.key()), ..probe }
}

/// The probes of a run, call by call.
pub struct Probes<'a> {
    setup: &'a Setup,
    /// Line of the last calibration of each probe.
    calibrated: BTreeMap<(bool, i64), Option<u32>>,
    /// Whether the data at the beginning are those of the probe, by its field and whether it is a mono probe.
    fit: BTreeMap<(i64, bool), bool>,
}

impl<'a> Probes<'a> {
    /// Before the first call.
    pub fn new(setup: &'a Setup) -> Probes<'a> {
        Probes { setup, calibrated: BTreeMap::new(), fit: BTreeMap::new() }
    }

    /// The probe of the next call, which stands in this line. `ended`: whether the call came to its end.
    pub fn of(&mut self, inputs: &Inputs, line: Option<u32>, ended: bool) -> ProbeOfCall {
        let tool = inputs.cycle.purpose.probe == ProbeUse::Tool;
        let used = probe_of(inputs);
        let number = match inputs.any(names::PRNUM) {
            Some(number) if tool => number as i64,
            _ => used.field,
        };
        self.next(used, (tool, number), inputs.cycle.purpose.calibrates.holds(inputs), line, ended)
    }

    /// The probe of the next measurement: whether it is a tool probe, and its number. `calibrates`: whether that is
    /// what the measurement does.
    pub fn next(
        &mut self,
        used: ProbeInCall,
        (tool, number): (bool, i64),
        calibrates: bool,
        line: Option<u32>,
        ended: bool,
    ) -> ProbeOfCall {
        let before = self.calibrated.get(&(tool, number)).copied();
        let (state, of) = match before {
            _ if calibrates => (CalibrationState::Calibrates, None),
            Some(line) => (CalibrationState::Run, line),
            None if !tool && !self.fits(used) => (CalibrationState::Differs, None),
            None => (CalibrationState::Stored, None),
        };
        if calibrates && ended {
            self.calibrated.insert((tool, number), line);
        }
        let name = if tool { "record-tool-probe" } else { "record-workpiece-probe" };
        let name = Message::new(name).number("number", number as f64);
        ProbeOfCall { number, tool, name, state, calibration: Message::new(state.key()), line: of }
    }

    /// The tool of the call is not that of the beginning: its length is not compared.
    fn fits(&mut self, probe: ProbeInCall) -> bool {
        let setup = self.setup;
        let compared = ProbeInCall { measures: false, ..probe };
        *self.fit.entry((probe.field, probe.mono)).or_insert_with(|| setup.calibration_fits(compared))
    }
}
