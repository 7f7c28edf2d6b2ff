//! A measurement as such a control does it.

use super::{Aim, Foreign, ForeignCycle, Value};
use crate::catalogue::twin::Measurement;
use crate::catalogue::twin_place::{has_depth, start};
use crate::control::Units;
use crate::entry::{Meaning, Task};

/// A measurement as a call of such a control. Lengths in mm.
pub struct OfTask {
    /// The cycle.
    pub cycle: &'static ForeignCycle,
    /// Its values, in its order; of one that is not written those that are known.
    pub values: Vec<(&'static str, f64)>,
    /// Places that the call does not tell, assumed as for a start at the zero point.
    pub assumed: Vec<&'static str>,
    /// What the call does not tell, with what is usual.
    pub usual: Vec<&'static str>,
    /// Height of measuring.
    pub height: f64,
    /// Height at which nothing is in the way.
    pub clearance: f64,
    /// What of the measurement has its place there.
    pub carried: &'static [Meaning],
}

/// What of a measurement these cycles say.
const CARRIED: &[Meaning] = &[
    Meaning::Nominal,
    Meaning::NominalInAxis,
    Meaning::FirstSide,
    Meaning::SecondSide,
    Meaning::Axis,
    Meaning::Infeed,
    Meaning::Upper,
    Meaning::Lower,
    Meaning::Half,
    Meaning::Zero,
    Meaning::Tool,
];

impl OfTask {
    fn without_values(cycle: &'static ForeignCycle) -> OfTask {
        let (values, assumed, usual) = (Vec::new(), Vec::new(), Vec::new());
        OfTask { cycle, values, assumed, usual, height: 0.0, clearance: 0.0, carried: CARRIED }
    }
}

/// A measurement on such a control; none: it has no cycle for it, or no set value is known.
pub fn of_task(control: &Foreign, measurement: &Measurement, units: Units) -> Option<OfTask> {
    let aim = if measurement.zero.is_some() { Aim::Datum } else { Aim::Measure };
    let cycle = control.cycles.iter().find(|cycle| cycle.tasks.contains(&(measurement.task, aim)))?;
    let clearance = start(units);
    let Some(sizes) = measurement.sides.or(measurement.nominal.map(|nominal| [nominal; 2])) else {
        // a corner or an angle has no size, and nothing of it is written
        return (!cycle.is_written()).then(|| OfTask::without_values(cycle));
    };
    let [nominal, _] = sizes;
    let above = measurement.task == Task::Face;
    // a hole is measured where the probe stands: half of the start's height below the zero point
    let height = if above { nominal } else { measurement.depth.unwrap_or(-clearance / 2.0) };
    let axis = if above { 2 } else { measurement.axis.unwrap_or(0) };
    let half = measurement.half;
    let (mut values, mut assumed, mut usual) = (Vec::new(), Vec::new(), Vec::new());
    for parameter in cycle.parameters {
        let mut common = |value: f64| {
            usual.push(parameter.name);
            value
        };
        let mut assume = |value: f64| {
            assumed.push(parameter.name);
            value
        };
        let value = match parameter.value {
            Value::Centre(_) => assume(0.0),
            Value::Point(at) if at == axis => nominal,
            Value::Point(_) => assume(0.0),
            Value::Nominal(side) => sizes[side.min(1)],
            Value::Maximum(side) => half.map_or_else(|| common(0.0), |half| sizes[side.min(1)] + half),
            Value::Minimum(side) => half.map_or_else(|| common(0.0), |half| sizes[side.min(1)] - half),
            Value::Axis => axis as f64 + 1.0,
            Value::Direction => assume(if above || nominal < 0.0 { -1.0 } else { 1.0 }),
            Value::Height if above || has_depth(measurement.task) && measurement.depth.is_some() => height,
            Value::Height => assume(height),
            Value::Clearance => assume(clearance),
            Value::Tool => measurement.tool.map_or_else(|| common(0.0), |tool| tool as f64),
            Value::Usual(value) => common(value),
            Value::Own => continue,
        };
        values.push((parameter.name, value));
    }
    Some(OfTask { cycle, values, assumed, usual, height, clearance, carried: CARRIED })
}
