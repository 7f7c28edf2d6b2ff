//! User data against the arrays, the machine data and each other.

use super::elements::{MOST, Room, probes};
use super::fault::{Files, MachineFault};
use super::read::{Exported, shown};
use crate::control::arrays::stem;
use crate::control::delivery::factor;
use crate::control::gud::{Element, Gud, Initial, Kind, Unit};
use crate::control::needs::Use;
use crate::control::{BASIC_SYSTEM, CALIBRATED, Units, Value, gud};
use crate::diagnostic::Severity;
use crate::form::machine::has_effect;
use crate::message::Message;
use Severity::{Error, Note, Warning};
use std::collections::{BTreeMap, BTreeSet};

/// Counts of the fields, and the array of each (B:13345-13348, B:2316-2321); the alarm where they differ.
pub const COUNTS: [(&str, &str, u32, &str); 6] = [
    ("_CVAL[0]", "_TP", 61416, "B:13345;A:15935"),
    ("_CVAL[1]", "_WP", 61416, "B:13346;A:15935"),
    ("_CVAL[2]", "_KB", 61416, "B:13347;A:15935"),
    ("_CVAL[3]", "_TPW", 61416, "B:13348;A:15935"),
    ("_EVMVNUM[0]", "_EV", 0, "B:2316-2321;B:13711-13718"),
    ("_EVMVNUM[1]", "_MV", 0, "B:2316-2321;B:13711-13718"),
];

/// Data of a field, which an array needs in its second dimension (B:13115-13121).
const FIELDS: [&str; 4] = ["_TP", "_TPW", "_WP", "_KB"];

/// Sizes of a tool probe that somebody has to enter before measuring in JOG (B:14294-14296).
pub const TO_ENTER: [&str; 2] = ["E_MESS_MT_DL", "E_MESS_MT_DR"];

/// Numbers of probes for measuring in JOG (B:14324-14325): what counts these, and their array.
const NUMBERS: [(&str, &str, &str); 2] = [("_JM_I[1]", "_CVAL[1]", "_WP"), ("_JM_I[2]", "_CVAL[0]", "_TP")];

/// Tables of user-defined corrections (B:13805-13821).
const TABLES: [&str; 2] = ["_MT_EC_R", "_MT_EC_L"];

/// Depth for measuring a radius as delivered, mm (B:13369).
const DEPTH: f64 = 2.0;

/// A switch that does nothing without another: the switch, what the other has to be, how bad it is, its place.
const NEEDED: [(&str, &str, f64, Severity, &str); 5] = [
    ("_CHBIT[18]", "_CHBIT[11]", 0.0, Warning, "B:13968-13971"),
    ("_CHBIT[18]", "_CHBIT[10]", 1.0, Warning, "B:13968-13971"),
    ("_CBIT[1]", "_CBIT[0]", 1.0, Note, "B:13576-13580"),
    ("_CHBIT[16]", "_CHBIT[2]", 1.0, Note, "B:14005-14007"),
    ("_CHBIT[14]", "_CHBIT[13]", 1.0, Note, "B:13869"),
];

/// What is wrong with the user data.
pub fn faults(given: &Exported, files: &Files, without: &[Use]) -> Vec<MachineFault> {
    let mut found = Vec::new();
    found.extend(sizes(given, files));
    for channel in given.channels() {
        let one = Channel { given, files, channel };
        one.units(&mut found);
        one.switches(&mut found);
        if !without.contains(&Use::ToolProbe) {
            one.tool_probe(&mut found);
        }
        if !without.contains(&Use::Jog) {
            one.measuring_in_jog(&mut found);
        }
        if !without.contains(&Use::Log) {
            one.log(&mut found);
        }
        one.simulation(&mut found);
    }
    found.extend(ranges(given, files, without));
    unique(found)
}

/// Each fault once: what the control has is seen by every channel. A datum may have two causes that are said alike.
fn unique(found: Vec<MachineFault>) -> Vec<MachineFault> {
    let mut seen: BTreeMap<(String, Option<u32>), Vec<Message>> = BTreeMap::new();
    let mut is_new = |fault: &MachineFault| {
        let told = seen.entry((fault.name.clone(), fault.channel)).or_default();
        let new = !told.contains(&fault.message);
        told.push(fault.message.clone());
        new
    };
    found.into_iter().filter(|fault| is_new(fault)).collect()
}

/// Sizes of arrays against what counts their fields, and against what a field holds.
fn sizes(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let mut found = Vec::new();
    for (count, array, alarm, source) in COUNTS {
        let defined = given.sizes.get(array).map(|(sizes, place)| (sizes.first().copied().unwrap_or(0) as f64, place));
        let (key, (size, place)) = match (defined, given.removed.get(array)) {
            (Some(defined), _) => ("machine-check-count", defined),
            (None, Some(place)) => ("machine-check-no-array", (0.0, place)),
            (None, None) => continue,
        };
        for channel in given.seeing(gud::named(count).is_some_and(|gud| gud.channel)) {
            let Some(number) = given.number(count, channel).filter(|number| *number != size) else { continue };
            let message = Message::new(key).text("array", array).number("size", size);
            let fault = MachineFault::new(Error, count, message, source).channel(channel).value(number.to_string());
            let fault = fault.at(Some(files.told(*place))).alarm(alarm);
            let countable = gud::place(count).and_then(|(gud, at)| gud.element(&at)).is_some_and(|one| one.takes(size));
            found.push(if countable { fault.mended(size) } else { fault });
        }
    }
    for array in FIELDS {
        let (Some((sizes, place)), Some(gud)) = (given.sizes.get(array), gud::find(array)) else { continue };
        let want = gud.sizes.get(1).copied().unwrap_or(0);
        if sizes.get(1) != Some(&want) {
            let message = Message::new("machine-check-fields").number("size", want as f64);
            let fault = MachineFault::new(Error, array, message, "B:13115-13121");
            found.push(fault.at(Some(files.told(*place))));
        }
    }
    found
}

/// Values outside of what the tables allow.
fn ranges(given: &Exported, files: &Files, without: &[Use]) -> Vec<MachineFault> {
    let mut found = Vec::new();
    let behind = given.behind_lists().map(|(name, ..)| name);
    let names: BTreeSet<String> = given.data.keys().map(|(name, _)| name.clone()).chain(behind).collect();
    for name in &names {
        let own = gud::find(stem(name)).filter(|gud| !unused(gud, without));
        for channel in given.seeing(own.is_some_and(|gud| gud.channel)) {
            found.extend(own.and_then(|gud| range(given, files, gud, (name, channel))));
        }
    }
    found
}

/// What is wrong with a value by itself.
fn range(given: &Exported, files: &Files, gud: &Gud, (name, channel): (&str, u32)) -> Option<MachineFault> {
    let Room::Inside(at) = Room::of(given, gud, name, channel) else { return None };
    let datum = given.get(name, channel)?;
    let (element, Value::Number(value)) = (gud.element(&at)?, &datum.value) else { return None };
    let switch = |switch: &str| given.number(switch, channel);
    let broken = matches!(gud.kind, Kind::Integer | Kind::Bool) && value.fract() != 0.0;
    if element.internal || element.takes(*value) && !broken || !has_effect(name, switch) {
        return None;
    }
    let above_zero = has_to_be_above_zero(gud, &at, switch);
    let message = match above_zero {
        _ if broken => Message::new("machine-check-whole").number("value", *value),
        Some(_) => Message::new("machine-check-above").number("value", *value).number("min", 0.0),
        None => allowed(element, *value),
    };
    let alarm = above_zero.or_else(|| alarm(gud, &at, *value)).unwrap_or(0);
    let fault = MachineFault::new(Error, name, message, element.source)
        .channel(channel)
        .value(value.to_string())
        .at(Some(files.told(datum.place)))
        .alarm(alarm);
    let right = right(gud, element).filter(|right| most_probes(given, name, channel).is_none_or(|most| *right <= most));
    Some(match right {
        Some(right) => fault.mended(in_basic(right / factor(element.unit, basic(given, channel)))),
        None => fault,
    })
}

/// The alarm of a datum with which nothing can be measured unless it is above 0 (A:15841, A:15891, A:15892).
fn has_to_be_above_zero(gud: &Gud, at: &[usize], number: impl Fn(&str) -> Option<f64>) -> Option<u32> {
    match (gud.name, at) {
        ("_TP" | "_TPW", [_, 9]) => Some(61349),
        ("_MFS", [0 | 1]) if number("_CBIT[12]") == Some(1.0) => Some(61350),
        (name, _) if TO_ENTER.contains(&name) => Some(61230),
        _ => None,
    }
}

/// The alarm of a value outside of its range (A:15848, A:15879, A:15880, A:15910).
fn alarm(gud: &Gud, at: &[usize], value: f64) -> Option<u32> {
    match (gud.name, at) {
        ("_SPEED", [0]) if value < 0.0 => Some(61339), // above 100 there is none
        ("_SPEED", [1 | 2]) => Some(61338),
        ("_CM", [5]) => Some(61366),
        ("_TP" | "_TPW", [_, 8]) => Some(61309),
        _ => None,
    }
}

/// The value as delivered, if it is right on other machines too: no count of fields, which is that of the arrays,
/// nothing that calibration writes, and no size, feed or speed of which 0 says that nobody has entered it.
fn right(gud: &Gud, element: &Element) -> Option<f64> {
    let Initial::Number(initial) = element.initial else { return None };
    let counts = COUNTS.iter().any(|(count, ..)| stem(count) == gud.name);
    let entered = element.unit == Unit::None || initial != 0.0;
    let calibrated = gud.name == CALIBRATED;
    Some(initial).filter(|initial| entered && !counts && !calibrated && element.takes(*initial))
}

/// The highest number of a probe that a datum of measuring in JOG may have; none: it is no number of a probe, or
/// nothing says how many there are.
fn most_probes(given: &Exported, name: &str, channel: u32) -> Option<f64> {
    let (_, count, array) = NUMBERS.iter().find(|(one, ..)| *one == name)?;
    probes(given, count, array, channel).map(|most| most as f64)
}

/// The basic system of the control; none is given: metric.
fn basic(given: &Exported, channel: u32) -> Units {
    if given.number(BASIC_SYSTEM, channel) == Some(0.0) { Units::Inch } else { Units::Metric }
}

/// As a fitter types it.
fn in_basic(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// Whether what a datum is for is not used on this machine.
fn unused(gud: &Gud, without: &[Use]) -> bool {
    let of_jog = gud.name.starts_with("E_MESS") || gud.name.starts_with("_JM_");
    let of_probe = ["_TP", "_TPW", "_CM", "_MFS", "_MT_COMP", "_TP_CF", "_MT_EC_R", "_MT_EC_L"].contains(&gud.name);
    of_jog && without.contains(&Use::Jog) || of_probe && without.contains(&Use::ToolProbe)
}

/// That a value is none of those that are allowed.
fn allowed(element: &Element, value: f64) -> Message {
    let range = element.range;
    let message = match element.choices {
        [] if range.max.is_finite() => Message::new("machine-check-range"),
        [] if range.min_included => Message::new("machine-check-from"),
        [] => Message::new("machine-check-above"),
        choices => {
            let list: Vec<String> = choices.iter().map(i64::to_string).collect();
            Message::new("machine-check-choice").text("choices", list.join(", "))
        }
    };
    let end = |end: f64| if end.is_finite() { end } else { 0.0 };
    message.number("value", value).number("min", end(range.min)).number("max", end(range.max))
}

/// The data as one channel sees them.
struct Channel<'a> {
    given: &'a Exported,
    files: &'a Files<'a>,
    channel: u32,
}

impl Channel<'_> {
    fn number(&self, name: &str) -> Option<f64> {
        self.given.number(name, self.channel)
    }

    /// A datum with what is wrong, in the channel where it stands.
    fn fault(&self, severity: Severity, name: &str, message: Message, source: &'static str) -> MachineFault {
        let datum = self.given.get(name, self.channel);
        let own = gud::named(name).is_some_and(|gud| gud.channel);
        MachineFault::new(severity, name, message, source)
            .channel(if own { self.channel } else { 0 })
            .value(datum.map_or_else(String::new, |datum| shown(&datum.value)))
            .at(datum.map(|datum| self.files.told(datum.place)))
    }

    /// How many probes there are.
    fn probes(&self, count: &str, array: &str) -> Option<usize> {
        probes(self.given, count, array, self.channel)
    }

    fn told(&self, severity: Severity, name: &str, key: &'static str, source: &'static str) -> MachineFault {
        self.fault(severity, name, Message::new(key), source)
    }

    /// The basic system, which the data follow (B:13594-13598, B:14059-14061).
    fn units(&self, found: &mut Vec<MachineFault>) {
        let Some(metric) = self.number(BASIC_SYSTEM).filter(|metric| [0.0, 1.0].contains(metric)) else { return };
        for (name, source) in
            [("_CBIT[3]", "B:13594-13598;A:14731-14737"), ("_CHBIT[24]", "B:14059-14061;A:15217-15219")]
        {
            if self.number(name).is_some_and(|switch| switch != metric) {
                let message = Message::new("machine-check-units").number("metric", metric);
                found.push(self.fault(Error, name, message, source).mended(metric));
            }
        }
    }

    fn switches(&self, found: &mut Vec<MachineFault>) {
        for (name, other, want, severity, source) in NEEDED {
            if self.number(name) == Some(1.0) && self.number(other).is_some_and(|value| value != want) {
                let message = Message::new("machine-check-needs").text("other", other).number("value", want);
                found.push(self.fault(severity, name, message, source));
            }
        }
        if self.number("_CBIT[13]") == Some(1.0) {
            found.push(self.told(Warning, "_CBIT[13]", "machine-check-erases", "B:13643-13644").mended(0.0));
        }
        if let Some(Value::Text(version)) = self.given.get("_SI[1]", self.channel).map(|given| &given.value) {
            let first = version.trim().chars().next().and_then(|digit| digit.to_digit(10));
            if first.is_none_or(|digit| digit < 3) {
                let fault = self.told(Error, "_SI[1]", "machine-check-version", "B:15252-15262;A:15883");
                found.push(fault.alarm(61342));
            }
        }
        let probes = self.probes("_CVAL[1]", "_WP").unwrap_or(0);
        for k in 0..probes {
            let points: Vec<Option<f64>> = (0..=6).map(|i| self.number(&format!("_WP[{k},{i}]"))).collect();
            if points.iter().all(|point| *point == Some(0.0)) {
                let name = format!("_WP[{k},0]");
                found.push(self.told(Warning, &name, "machine-check-uncalibrated", "B:5148;A:15882").alarm(61341));
            }
        }
    }

    fn tool_probe(&self, found: &mut Vec<MachineFault>) {
        for (array, count) in [("_TP", "_CVAL[0]"), ("_TPW", "_CVAL[3]")] {
            let probes = self.probes(count, array).unwrap_or(MOST);
            for k in 0..probes {
                let of = |i: usize| format!("{array}[{k},{i}]");
                if self.number(&of(9)) == Some(0.0) {
                    let fault = self.told(Error, &of(9), "machine-check-depth", "B:13369;A:15891");
                    let depth = in_basic(DEPTH / basic(self.given, self.channel).factor());
                    found.push(fault.alarm(61349).mended(depth));
                }
                let axes = self.number(&of(7)).filter(|axes| (0.0..1000.0).contains(axes)).unwrap_or(0.0) as u32;
                if [axes % 10, axes / 10 % 10, axes / 100].iter().any(|digit| *digit > 3) {
                    found.push(self.told(Warning, &of(7), "machine-check-axes", "B:13364;B:4720-4735"));
                }
                if self.number(&of(6)) == Some(0.0) {
                    found.push(self.told(Warning, &of(6), "machine-check-size", "B:13363"));
                }
            }
        }
        if self.number("_CBIT[12]") == Some(1.0) {
            for name in ["_MFS[0]", "_MFS[1]"] {
                if self.number(name) == Some(0.0) {
                    found.push(self.told(Error, name, "machine-check-own-speed", "A:15892;B:13515-13516").alarm(61350));
                }
            }
        }
        if self.number("_MT_COMP") == Some(1.0) && self.number("_TP_CF") == Some(0.0) {
            found.push(self.told(Warning, "_MT_COMP", "machine-check-no-make", "B:13797-13805"));
        }
        let without: Vec<&str> = TABLES.into_iter().filter(|table| !self.fills(table)).collect();
        if self.number("_MT_COMP") == Some(2.0) && !without.is_empty() {
            let message = Message::new("machine-check-no-table").text("tables", without.join(", "));
            found.push(self.fault(Warning, "_MT_COMP", message, "B:13805-13821"));
        }
    }

    /// Whether a table of corrections has its four sizes and five speeds in ascending order (B:13807-13808).
    fn fills(&self, table: &str) -> bool {
        let ascends = |names: Vec<String>| {
            let values: Vec<Option<f64>> = names.iter().map(|name| self.number(name)).collect();
            values.first() > Some(&Some(0.0)) && values.windows(2).all(|pair| pair[0] < pair[1])
        };
        let sizes = (1..=4).map(|i| format!("{table}[0,{i}]")).collect();
        let speeds = (1..=5).map(|i| format!("{table}[{i},0]")).collect();
        ascends(sizes) && ascends(speeds)
    }

    fn measuring_in_jog(&self, found: &mut Vec<MachineFault>) {
        let defined = |name: &str| self.given.sizes.get(name).and_then(|(sizes, _)| sizes.first().copied());
        let each = |name: &'static str| (0..defined(name).unwrap_or(MOST)).map(move |k| format!("{name}[{k}]"));
        for name in TO_ENTER.into_iter().flat_map(each) {
            if self.number(&name) == Some(0.0) {
                let fault = self.told(Error, &name, "machine-check-assign", "B:14294-14296;A:15406-15408");
                found.push(fault.alarm(61230));
            }
        }
        for (name, other) in [("_CHBIT[0]", "E_MESS_MS_IN"), ("_CHBIT[1]", "E_MESS_MT_IN")] {
            let (Some(input), Some(in_jog)) = (self.number(name), self.number(other)) else { continue };
            if input != in_jog {
                let message = Message::new("machine-check-inputs").text("other", other).number("value", in_jog);
                found.push(self.fault(Warning, name, message, "B:13888-13898;B:14251-14252"));
            }
        }
        for (name, count, _) in NUMBERS {
            let most = most_probes(self.given, name, self.channel);
            let (Some(probe), Some(most)) = (self.number(name), most) else { continue };
            if probe > most {
                let message = Message::new("machine-check-probe").text("other", count).number("most", most);
                let fault = self.fault(Error, name, message, "B:14324-14325").alarm(61313);
                found.push(if most > 0.0 { fault.mended(most) } else { fault });
            }
        }
    }

    fn log(&self, found: &mut Vec<MachineFault>) {
        for (name, most, alarm, source) in
            [("_PROTFORM[1]", 200.0, 62310, "A:15947"), ("_PROTFORM[4]", 4.0, 61363, "A:15907")]
        {
            if self.number(name).is_some_and(|value| value > most) {
                let message = Message::new("machine-check-most").number("most", most);
                found.push(self.fault(Error, name, message, source).alarm(alarm).mended(most));
            }
        }
        let lines: Vec<_> = (0..=5).filter_map(|i| self.given.get(&format!("_PROTVAL[{i}]"), self.channel)).collect();
        let empty = |value: &Value| matches!(value, Value::Text(text) if text.trim().is_empty());
        if lines.len() == 6 && lines.iter().all(|given| empty(&given.value)) {
            found.push(self.told(Error, "_PROTVAL[0]", "machine-check-no-lines", "A:15914").alarm(61370));
        }
    }

    fn simulation(&self, found: &mut Vec<MachineFault>) {
        if self.number("_MC_SIMSIM") == Some(0.0) {
            found.push(self.told(Note, "_MC_SIMSIM", "machine-check-skipped", "B:682-694"));
        }
        let probes = self.probes("_CVAL[1]", "_WP").unwrap_or(0) as f64;
        if let Some((sizes, place)) = self.given.sizes.get("_MC_MTL") {
            let size = sizes.first().copied().unwrap_or(0) as f64;
            if size < probes {
                let message = Message::new("machine-check-ratios").number("size", size).number("probes", probes);
                let fault = MachineFault::new(Note, "_MC_MTL", message, "B:13240-13244");
                found.push(fault.at(Some(self.files.told(*place))));
            }
        }
    }
}
