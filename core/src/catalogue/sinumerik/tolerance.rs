//! Safe area, tolerance chain and repetition as the workpiece cycles use them (B:1286-1390, B:6123-6137).

use super::correct;
use crate::catalogue::prelude::*;
use crate::evaluate::mean;
use crate::evaluate::symmetry::{Symmetric, symmetric};
use crate::evaluate::tolerance::{Bands, Branch, Decision, chain, exceeds};
use crate::evaluate::tool_offset::Target as Tool;

/// Repetitions after a violated limit (B:13572-13574).
const REPETITIONS: u32 = 4;

/// What a measurement with tool offset found.
#[derive(Clone, Debug, PartialEq)]
pub struct Sizes {
    /// Actual sizes minus middle of the tolerance band, mm; two for a rectangle.
    pub differences: Vec<f64>,
    /// Part of a difference that goes into the tool: 1/2 for a diameter or width, 1 for a position (B:6130-6134).
    pub factor: f64,
    /// Sign of a correction of the radius.
    pub radius_sign: f64,
}

/// Setpoint in the middle of the tolerance band (B:2203-2211).
pub fn middle(inputs: &Inputs, setpoint: f64) -> Symmetric {
    symmetric(setpoint, inputs.number(names::TUL), inputs.number(names::TLL))
}

/// Empirical value with its sign as subtracted from the actual value, mm (B:13924-13926).
pub fn empirical(control: &Control, inputs: &Inputs) -> f64 {
    memorized(control, inputs, |name| control.basic_length(name))
}

/// Empirical value of an angle, with the sign of [`empirical`], degree.
pub fn empirical_angle(control: &Control, inputs: &Inputs) -> f64 {
    memorized(control, inputs, |name| control.number(name))
}

fn memorized(control: &Control, inputs: &Inputs, read: impl Fn(&str) -> f64) -> f64 {
    let number = mean::memories(inputs.number(names::EVNUM) as i64).empirical;
    if number == 0 {
        return 0.0;
    }
    let value = read(&format!("_EV[{}]", number - 1));
    if control.bit("_CHBIT[5]") { -value } else { value }
}

/// Name of the mean value memory in use: none without `_EVNUM` or with `_CHBIT[4]` = 0 (B:13917-13920).
fn memory(control: &Control, inputs: &Inputs) -> Option<String> {
    let number = mean::memories(inputs.integer(names::EVNUM)).mean;
    (number > 0 && control.bit("_CHBIT[4]")).then(|| format!("_MV[{}]", number - 1))
}

/// Checks before the first motion that belong to tool offset: `_K` (A:15859) and the target.
pub fn prepare(machine: &mut dyn Machine, inputs: &Inputs, axis: Option<usize>) -> Result<Option<Tool>, Stop> {
    if inputs.number(names::K) == 0.0 {
        return Err(alarm(machine, 61318));
    }
    correct::tool_target(machine, inputs, axis)
}

/// Runs the chain, records the decision, corrects the tool.
pub fn decide(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    sizes: &Sizes,
    target: Option<&Tool>,
    repetition: u32,
) -> Result<Next, Stop> {
    let control = machine.control();
    let offset = empirical(control, inputs);
    let memory = memory(control, inputs);
    let old = memory.as_deref().map_or(0.0, |name| control.basic_length(name));
    let differences: Vec<f64> = sizes.differences.iter().map(|difference| difference - offset).collect();
    let decision = chain(&differences, &bands(inputs), old);
    report(machine, inputs, target, &decision);
    let message = explain(machine, &decision, &differences, target);
    machine.record(Step::Decision { message });
    let announced = match decision.branch {
        Branch::SafeArea => Some(62303),
        Branch::Difference => Some(62306),
        _ => None,
    };
    if announced.is_some_and(|number| repeat(machine, number, repetition)) {
        return Ok(Next::Again);
    }
    if decision.branch == Branch::SafeArea {
        return Err(alarm(machine, 61303));
    }
    inform(machine, decision.branch.alarm());
    if let Some(name) = memory {
        let value = decision.memory / machine.control().basic_factor();
        if decision.branch.corrects() {
            machine.record(Step::Decision { message: Message::new("evaluate-restarts").text("name", &name) });
        }
        results::set(machine, &name, value);
    }
    let amount = match target {
        Some(target) if decision.correction != 0.0 => correct::tool(machine, target, sizes, decision.correction),
        _ => 0.0,
    };
    results::length(machine, 20, amount);
    Ok(Next::Done)
}

/// The bands as parameters give them.
fn bands(inputs: &Inputs) -> Bands {
    let Symmetric { upper, lower, .. } = middle(inputs, 0.0);
    Bands {
        safe_area: inputs.number(names::TSA),
        difference: inputs.number(names::TDIF),
        upper,
        lower,
        mean: inputs.number(names::TMV),
        zero_offset: inputs.number(names::TZL),
        weight: inputs.number(names::K),
    }
}

/// Results that exist only with tool offset (footnote 1 of B:5675-5701).
fn report(machine: &mut dyn Machine, inputs: &Inputs, target: Option<&Tool>, decision: &Decision) {
    let memories = mean::memories(inputs.integer(names::EVNUM));
    results::length(machine, 20, 0.0);
    results::length(machine, 27, inputs.number(names::TZL));
    results::length(machine, 29, inputs.number(names::TDIF));
    report_empirical(machine, inputs);
    results::length(machine, 31, decision.mean);
    results::integer(machine, 0, target.map_or(0, |target| target.edge));
    results::integer(machine, 4, inputs.integer(names::K));
    results::integer(machine, 6, memories.mean);
    results::integer(machine, 7, memories.empirical);
    results::integer(machine, 8, target.map_or(0, |target| target.tool));
    if inputs.cycle.results.iter().any(|field| field.name == "_OVI[13]") {
        results::integer(machine, 13, target.and_then(|target| target.location).unwrap_or(0));
    }
}

/// The empirical value as stored, whichever way `_CHBIT[5]` calculates it (B:6359).
pub fn report_empirical(machine: &mut dyn Machine, inputs: &Inputs) {
    let control = machine.control();
    let value = empirical(control, inputs);
    let stored = if control.bit("_CHBIT[5]") { -value } else { value };
    results::length(machine, 30, stored);
}

/// Whether to measure again: `_CBIT[0]`, at most four times; with `_CBIT[1]` an alarm that informs and a programmed
/// stop before (B:13572-13580).
pub fn repeat(machine: &mut dyn Machine, number: u32, repetition: u32) -> bool {
    if !machine.control().bit("_CBIT[0]") || repetition >= REPETITIONS {
        return false;
    }
    if machine.control().bit("_CBIT[1]") {
        machine.record(Step::Alarm(Code::Alarm(number)));
        machine.record(Step::Decision { message: Message::new("evaluate-halt") });
    }
    let count = f64::from(repetition) + 1.0;
    machine.record(Step::Decision { message: Message::new("evaluate-repeat").number("count", count) });
    true
}

/// The alarm that lets the program go on; with `_CBIT[2]` a programmed stop (B:13584-13586).
pub fn inform(machine: &mut dyn Machine, alarm: Option<u32>) {
    if let Some(number) = alarm {
        results::integer(machine, 9, i64::from(number));
        machine.record(Step::Alarm(Code::Alarm(number)));
        if machine.control().bit("_CBIT[2]") {
            machine.record(Step::Decision { message: Message::new("evaluate-halt") });
        }
    }
}

/// The decision in words. Its difference is the one that decided: the worst, for the mean value the mean of all.
fn explain(machine: &dyn Machine, decision: &Decision, differences: &[f64], target: Option<&Tool>) -> Message {
    let difference = match decision.branch {
        Branch::Mean | Branch::Small => differences.iter().sum::<f64>() / differences.len().max(1) as f64,
        _ => differences.iter().copied().fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a }),
    };
    let message = Message::new(decision.branch.key()).number("difference", difference).number("mean", decision.mean);
    match decision.branch.corrects() {
        true if target.is_some() && !machine.corrects() => message.text("follows", "evaluate-corrects-simulated"),
        true => message.text("follows", corrected(decision, differences.len(), target)),
        false => message,
    }
}

/// Key of what is corrected where the chain demands it, for so many differences.
fn corrected(decision: &Decision, count: usize, target: Option<&Tool>) -> &'static str {
    match (target, decision.branch) {
        (None, _) => "evaluate-corrects-nothing",
        (_, Branch::Mean) => "evaluate-corrects-mean",
        _ if count < 2 => "evaluate-corrects-whole",
        _ if decision.correction == 0.0 => "evaluate-corrects-zero",
        _ => "evaluate-corrects-both",
    }
}

/// Zero offset variants watch only the safe area, each difference for itself (B:6221, B:6276).
pub fn safe(machine: &mut dyn Machine, inputs: &Inputs, differences: &[f64], repetition: u32) -> Result<Next, Stop> {
    let limit = inputs.value(names::TSA);
    let Some(worst) = differences.iter().copied().find(|difference| exceeds(difference.abs(), limit)) else {
        return Ok(Next::Done);
    };
    let key = if inputs.is_angle(names::TSA) { "evaluate-safe-area-angle" } else { "evaluate-safe-area" };
    let message = Message::new(key).number("difference", worst).number("mean", 0.0);
    machine.record(Step::Decision { message });
    if repeat(machine, 62303, repetition) {
        return Ok(Next::Again);
    }
    Err(alarm(machine, 61303))
}
