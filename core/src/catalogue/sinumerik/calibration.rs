//! What a calibration found: the results, the comparison with what is stored, the new data (B:5134, B:5090-5118).

use super::{calibrated_as, correct, tolerance};
use crate::catalogue::prelude::*;
use crate::evaluate::Write;
use crate::evaluate::tolerance::exceeds;

/// A trigger value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trigger {
    /// 0 abscissa, 1 ordinate, 2 applicate.
    pub axis: usize,
    /// Direction of probing, +1 or -1.
    pub sign: f64,
    /// Position at switching minus surface, mm.
    pub value: f64,
}

/// What was found, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Calibration {
    /// In the order of probing.
    pub triggers: Vec<Trigger>,
    /// Active ball diameter.
    pub ball: Option<f64>,
    /// Ball centre minus spindle axis, abscissa and ordinate, where they were determined.
    pub skew: [Option<f64>; 2],
    /// Centre of the hole in the WCS, abscissa and ordinate.
    pub centre: Option<[f64; 2]>,
    /// By how much the length of the probe along the applicate is too short: L1, on a turning machine L3.
    pub length: Option<f64>,
}

/// Where in `_WP[k,0..8]` things stand (B:13441-13449).
const BALL: usize = 0;
const TRIGGERS: usize = 1;
const SKEW: [usize; 2] = [7, 8];

impl Trigger {
    /// 0 to 5: by axis, minus before plus.
    fn index(&self) -> usize {
        2 * self.axis + usize::from(self.sign > 0.0)
    }
}

/// A datum of the probe.
fn datum(inputs: &Inputs, field: usize) -> String {
    format!("_WP[{},{field}]", inputs.integer(names::PRNUM) % 100 - 1)
}

/// A datum of the probe as stored, mm.
fn stored(control: &Control, inputs: &Inputs, field: usize) -> f64 {
    control.basic_length(&datum(inputs, field))
}

/// The skew as stored, mm.
pub fn skew(control: &Control, inputs: &Inputs) -> [f64; 2] {
    SKEW.map(|field| stored(control, inputs, field))
}

/// Reports, compares the trigger values with the safe area, and stores what was found. `_TSA` watches trigger values
/// only: it may be smaller than a ball that was never measured (B:5148), and the length does not count (B:5509).
pub fn store(machine: &mut dyn Machine, inputs: &Inputs, found: &Calibration, repetition: u32) -> Result<Next, Stop> {
    let differences = report(machine, inputs, found);
    let next = tolerance::safe(machine, inputs, &differences, repetition)?;
    if next == Next::Again {
        return Ok(next);
    }
    // what goes into the tool is the diameter as stored (B:13656): where that stays, the radius does
    let before = stored(machine.control(), inputs, BALL);
    let ball = found.ball.filter(|ball| exceeds((ball - before).abs(), inputs.number(names::TZL)));
    renew(machine, inputs, fields(found).into_iter().map(|(field, value)| (datum(inputs, field), value)).collect());
    let milling = inputs.cycle.purpose.machine == MachineSort::Milling;
    let into_tool = milling && machine.control().bit("_CBIT[15]");
    if let Some(ball) = ball.filter(|_| into_tool) {
        set_tool(machine, RADIUS, |_| ball / 2.0); // in CYCLE976
    }
    calibrated_as::note(machine, inputs);
    if let Some(length) = found.length {
        let control = machine.control();
        let along = control.active_edge().map_or(0, |edge| control.length_along_applicate(edge));
        let length = set_tool(machine, LENGTHS[along], |before| before + length);
        results::length(machine, 22, length);
    }
    Ok(next)
}

/// Results; the differences of the trigger values, mm.
fn report(machine: &mut dyn Machine, inputs: &Inputs, found: &Calibration) -> Vec<f64> {
    if let Some(ball) = found.ball {
        let before = stored(machine.control(), inputs, BALL);
        results::length(machine, 4, ball);
        results::length(machine, 5, ball - before);
    }
    let centre = found.centre.map_or([None; 2], |centre| centre.map(Some));
    for (index, value) in [6, 7, 20, 21].into_iter().zip(centre.into_iter().chain(found.skew)) {
        if let Some(value) = value {
            results::length(machine, index, value);
        }
    }
    let mut differences = Vec::new();
    for trigger in &found.triggers {
        let difference = trigger.value - stored(machine.control(), inputs, TRIGGERS + trigger.index());
        let first = 8 + 2 * trigger.index();
        results::length(machine, first, trigger.value);
        results::length(machine, first + 1, difference);
        differences.push(difference);
    }
    differences
}

/// Stores lengths (mm) that differ by more than `_TZL` from the data, and tells what is kept (B:5134, B:4324-4326).
pub fn renew(machine: &mut dyn Machine, inputs: &Inputs, found: Vec<(String, f64)>) {
    let limit = inputs.number(names::TZL);
    let per = machine.control().basic_factor();
    let mut kept = Vec::new();
    for (name, value) in found {
        let difference = value - machine.control().basic_length(&name);
        if exceeds(difference.abs(), limit) {
            results::set(machine, &name, value / per);
        } else {
            kept.push(name);
        }
    }
    if !kept.is_empty() {
        let message = Message::new("evaluate-kept").number("limit", limit);
        machine.record(Step::Decision { message: message.text("data", kept.join(", ")) });
    }
}

/// What was found by its place in `_WP[k,0..8]`.
fn fields(found: &Calibration) -> Vec<(usize, f64)> {
    let mut fields: Vec<(usize, f64)> = found.ball.map(|ball| (BALL, ball)).into_iter().collect();
    fields.extend(found.triggers.iter().map(|trigger| (TRIGGERS + trigger.index(), trigger.value)));
    fields.extend(SKEW.into_iter().zip(found.skew).filter_map(|(field, value)| Some((field, value?))));
    fields
}

/// Geometry of L1, L2 and L3 and of the radius in the tool memory.
const LENGTHS: [&str; 3] = ["$TC_DP3", "$TC_DP4", "$TC_DP5"];
const RADIUS: &str = "$TC_DP6";

/// Writes a geometry value of the probe in use; the new one, mm.
fn set_tool(machine: &mut dyn Machine, part: &str, change: impl Fn(f64) -> f64) -> f64 {
    let control = machine.control();
    let name = format!("{part}[{},{}]", control.tool, control.edge);
    let value = change(control.variable(&name).unwrap_or(0.0));
    correct::write(machine, &[Write { name, value }]);
    value
}
