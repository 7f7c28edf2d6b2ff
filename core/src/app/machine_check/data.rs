//! Machine data against what measuring needs of them.

use super::elements;
use super::fault::{Files, MachineFault, MachineLimit, identified, machine_datum, written};
use super::read::{Exported, GEOMETRY_NAMES, Given, of_channel};
use crate::control::needs::{GUD_MEMORY, GUD_MEMORY_SOURCE, GUD_VALUES, Limit, NEEDS, Need, Test, Use, When, mask};
use crate::control::{BASIC_SYSTEM, Value, arrays, braking};
use crate::diagnostic::Severity;
use crate::manual::Cited;
use crate::message::Message;
use std::collections::BTreeSet;

/// What is wrong, in the order of the needs.
pub fn faults(given: &Exported, files: &Files, without: &[Use], large: bool) -> Vec<MachineFault> {
    let limits = |need: &Need| limits(need, given, without, large);
    let of_need = |need: &'static Need| {
        let limits = limits(need);
        let own = machine_datum(need.number).is_some_and(of_channel);
        let names = given.data.keys().map(|(name, _)| name).filter(|name| arrays::stem(name) == need.number);
        let names: BTreeSet<&String> = names.filter(|name| elements::exists(name)).collect();
        let seen = names.into_iter().flat_map(|name| given.seeing(own).into_iter().map(move |channel| (name, channel)));
        let faults = seen.filter(|(_, channel)| counts(need, given, *channel)).filter_map(|(name, channel)| {
            let fault = fault(need, &limits, (name, channel), given.get(name, channel)?, files)?;
            Some(if need.by_place { placed(fault, given, channel) } else { fault })
        });
        faults.collect::<Vec<_>>()
    };
    NEEDS.iter().flat_map(of_need).chain(unnamed(given, files)).collect()
}

/// Machine data that need a value and that no file gives.
pub fn missing(given: &Exported, without: &[Use], large: bool) -> Vec<String> {
    let there = |number: &str| given.data.keys().any(|(name, _)| arrays::stem(name) == number);
    let error = |need: &Need| limits(need, given, without, large).iter().any(|one| one.severity == Severity::Error);
    let needed = NEEDS.iter().filter(|need| error(need) && !there(need.number));
    let mut names: Vec<String> = needed.map(|need| identified(need.number)).collect();
    names.dedup();
    names
}

/// Whether something is needed of a machine datum. Names and sorts of the channel axes (MD20080, MD30300) have to fit
/// `_RA` of a call (A:15872), which no export has.
pub fn is_needed(number: &str) -> bool {
    let other = [BASIC_SYSTEM, GEOMETRY_NAMES].into_iter().chain(braking::DATA);
    NEEDS.iter().map(|need| need.number).chain(other).any(|one| one == number)
}

/// Geometry axes without a name, of those that an axis of the channel is (A:15878).
fn unnamed(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let empty = |given: &Given| matches!(&given.value, Value::Text(text) if text.trim().is_empty());
    let of_axes = given.data.iter().filter(|((name, _), one)| arrays::stem(name) == GEOMETRY_NAMES && empty(one));
    let used = |name: &str, channel: u32| {
        let axis = name.replace(GEOMETRY_NAMES, GEOMETRY_AXES);
        given.number(&axis, channel) != Some(0.0)
    };
    let fault = |((name, channel), one): (&(String, u32), &Given)| {
        let fault = MachineFault::new(Severity::Error, name, Message::new("machine-check-unnamed"), "A:15878");
        let fault = fault.channel(*channel).alarm(61336).at(Some(files.told(one.place)));
        used(name, *channel).then_some(fault)
    };
    of_axes.filter_map(fault).collect()
}

/// Which axes of the channel are geometry axes.
const GEOMETRY_AXES: &str = "MD20050";

/// An element whose value is its place, from 1, where no other element has it: two geometry axes would be one axis of
/// the channel (B:14084-14093).
fn placed(fault: MachineFault, given: &Exported, channel: u32) -> MachineFault {
    let fault = MachineFault { change: String::new(), mended: None, ..fault };
    let Some((stem, index)) = arrays::split(&fault.name) else { return fault };
    let [at] = index[..] else { return fault };
    let own = (at + 1) as f64;
    let elements = machine_datum(stem).map_or(0, |datum| datum.elements);
    let mut others = (0..elements).filter_map(|other| given.number(&format!("{stem}[{other}]"), channel));
    if others.any(|value| value == own) { fault } else { fault.mended(own) }
}

/// The limits that count on this machine, as they are.
fn limits(need: &Need, given: &Exported, without: &[Use], large: bool) -> Vec<Limit> {
    let counting = need.limits.iter().filter(|limit| !without.contains(&limit.of));
    let mut limits: Vec<Limit> =
        counting.map(|limit| Limit { value: if large { limit.large } else { limit.value }, ..*limit }).collect();
    if need.number == GUD_VALUES {
        let channels = given.channels().len() as f64;
        let [control, channel, jog] = GUD_MEMORY;
        let each = if without.contains(&Use::Jog) { channel } else { channel + jog };
        let value = control + channels * each;
        let (severity, of) = (Severity::Error, Use::Cycles);
        limits.insert(0, Limit { severity, of, value, large: value, source: GUD_MEMORY_SOURCE });
    }
    // the largest of a severity satisfies all; what is smaller than an error is no warning
    let largest = |severity| {
        let of_it = limits.iter().filter(|limit| limit.severity == severity);
        of_it.max_by(|one, other| one.value.total_cmp(&other.value)).copied()
    };
    [Severity::Error, Severity::Warning, Severity::Note].into_iter().filter_map(largest).collect()
}

/// Whether a condition counts. A bit that another condition sets counts as set: the lines to change set it.
fn counts(need: &Need, given: &Exported, channel: u32) -> bool {
    let When::Bit(number, bit) = need.when else { return true };
    let has = |value: f64| value as u32 >> bit & 1 == 1;
    let sets = |one: &Need| one.number == number && one.test == Test::Set && one.changed;
    let set = NEEDS.iter().any(|one| sets(one) && one.limits.iter().any(|limit| has(limit.value)));
    given.number(number, channel).is_some_and(|value| set || has(value))
}

fn fault(
    need: &Need,
    limits: &[Limit],
    (name, channel): (&str, u32),
    datum: &Given,
    files: &Files,
) -> Option<MachineFault> {
    let place = Some(files.told(datum.place));
    let Value::Number(value) = datum.value else { return None }; // a text is told where it is read
    let missed = limits.iter().find(|limit| !need.test.holds(value, limit.value))?;
    let best = limits.iter().fold(value, |value, limit| need.test.mended(value, limit.value));
    let told = |limit: &Limit| MachineLimit {
        severity: limit.severity,
        value: match need.test {
            Test::UpTo => format!("1..{}", limit.value),
            Test::AtMost => format!("≤ {}", limit.value),
            Test::Clear => format!("{} = 0", written(name, limit.value)),
            _ => written(name, limit.value),
        },
        source: Cited(limit.source),
    };
    let fault = MachineFault::new(missed.severity, name, said(need.test, value, missed.value), missed.source)
        .channel(channel)
        .value(written(name, value))
        .at(place)
        .spelled(&datum.spelled)
        .effect(effect(need, limits, missed))
        .alarm(need.alarm);
    let limits: Vec<MachineLimit> = limits.iter().map(told).collect();
    let fault = MachineFault { limits, ..fault };
    Some(match need.test {
        _ if !need.changed => fault,
        Test::Set => fault.bits(best, [missed.value as u32, 0]),
        Test::Clear => fault.bits(best, [0, missed.value as u32]),
        _ => fault.mended(best),
    })
}

/// What follows: where only the larger figure of the manual is missed, the cycles alone have enough.
fn effect(need: &Need, limits: &[Limit], missed: &Limit) -> &'static str {
    let enough = limits.iter().any(|limit| limit.severity == Severity::Error) && missed.severity != Severity::Error;
    if enough && missed.of != Use::Log { "reserve" } else { need.effect }
}

/// What is wrong with a value.
fn said(test: Test, value: f64, limit: f64) -> Message {
    let (have, want) = (mask(value), limit as u32);
    let (key, bits) = match test {
        Test::AtLeast => ("machine-check-low", 0),
        Test::AtMost => ("machine-check-high", 0),
        Test::Equal => ("machine-check-not", 0),
        Test::UpTo => ("machine-check-between", 0),
        Test::Set => ("machine-check-bits-missing", want & !have.unwrap_or(0)),
        Test::Clear => ("machine-check-bits-set", want & have.unwrap_or(want)),
    };
    let numbers: Vec<String> = (0..32).filter(|bit| bits >> bit & 1 == 1).map(|bit: u32| bit.to_string()).collect();
    Message::new(key).number("value", value).number("limit", limit).text("bits", numbers.join(", "))
}
