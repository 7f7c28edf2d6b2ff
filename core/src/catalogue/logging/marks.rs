//! Which results exceed a limit, so that the log marks them (B:11439-11441).

use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::tolerance;
use crate::evaluate::tolerance::{RESOLUTION, exceeds};
use std::collections::BTreeSet;

/// Places in `_OVR[]` of the upper limits, and of the differences to which they belong, one behind the other
/// (B:5681-5685).
const UPPER: usize = 8;
const DIFFERENCES: usize = 16;
/// The result that repeats `_TDIF`.
const LIMIT: &str = "result-dimensional-difference";

/// Actual values and their differences of this call that exceed `_TSA`, `_TDIF`, `_TUL` or `_TLL`.
pub fn marked(control: &Control, inputs: &Inputs) -> BTreeSet<&'static str> {
    let found = pairs(inputs).into_iter().filter(|(_, difference)| out(control, inputs, difference));
    found.flat_map(|(actual, difference)| actual.into_iter().chain([difference])).map(|field| field.name).collect()
}

/// The differences that a call leaves, with the actual values to which they belong.
pub fn pairs(inputs: &Inputs) -> Vec<(Option<&'static ResultField>, &'static ResultField)> {
    let used = || inputs.cycle.results.iter().filter(|field| field.when.holds(inputs));
    let differences = used().filter(|field| field.key.contains("difference") && field.key != LIMIT);
    let pair = |difference: &'static ResultField| {
        let key = actual(difference.key);
        (used().find(|field| field.key == key), difference)
    };
    differences.map(pair).collect()
}

/// Key of the actual value to a difference.
fn actual(difference: &str) -> String {
    match difference {
        "result-ball-difference" => "result-ball-diameter".to_owned(),
        _ => match difference.strip_suffix("-difference") {
            Some(key) => key.to_owned(),
            None => difference.replace("-difference-", "-actual-"),
        },
    }
}

fn out(control: &Control, inputs: &Inputs, field: &ResultField) -> bool {
    let factor = if field.unit == Unit::Degree { 1.0 } else { control.active_factor() };
    let difference = control.number(field.name) * factor;
    let of_tool = inputs.cycle.purpose.probe == ProbeUse::Tool;
    // a tool is beyond a limit that it reaches (B:4937), a workpiece behind it (B:6123)
    let beyond = |value: f64, limit: f64| {
        if of_tool { limit > 0.0 && value >= limit - RESOLUTION } else { exceeds(value, limit) }
    };
    let limit = |name: Name| {
        let same = inputs.is_angle(name) == (field.unit == Unit::Degree);
        inputs.any(name).filter(|_| same).map(|limit| limit.abs())
    };
    let band = has_tolerance(inputs, field).then(|| tolerance::middle(inputs, 0.0));
    let counted = difference - band.map_or(0.0, |_| tolerance::empirical(control, inputs));
    if limit(names::TSA).is_some_and(|limit| beyond(counted.abs(), limit)) {
        return true;
    }
    if (band.is_some() || of_tool) && limit(names::TDIF).is_some_and(|limit| beyond(counted.abs(), limit)) {
        return true;
    }
    band.is_some_and(|band| exceeds(counted, band.upper) || exceeds(-counted, -band.lower))
}

/// Whether the tolerance applies to this difference: its limits are results too.
fn has_tolerance(inputs: &Inputs, difference: &ResultField) -> bool {
    let place = difference.name.strip_prefix("_OVR[").and_then(|rest| rest.strip_suffix(']')?.parse::<usize>().ok());
    let Some(place) = place.and_then(|place| place.checked_sub(DIFFERENCES)) else { return false };
    let name = format!("_OVR[{}]", UPPER + place);
    let mut results = inputs.cycle.results.iter();
    results.any(|field| field.name == name && field.key.starts_with("result-upper") && field.when.holds(inputs))
}
