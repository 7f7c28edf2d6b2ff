//! Feeds of the data against the deflection that the probe allows.

use super::fault::{Files, MachineFault, identified};
use super::read::{Exported, Given, shown};
use crate::control::braking::{self, Braking};
use crate::control::needs::Use;
use crate::control::units::INCH;
use crate::control::{BASIC_SYSTEM, Value, arrays, gud};
use crate::diagnostic::Severity;
use crate::message::Message;
use serde::Serialize;

/// Feeds at which the probe may touch: the datum, the switch without which it does not, as delivered, and the place.
/// With collision monitoring a touch on the way stops the axes too (B:13751-13763).
pub const FEEDS: [(&str, &str, f64, &str); 7] = [
    ("_SPEED[1]", "_CHBIT[2]", 1.0, "B:13751-13763;B:1143-1161"),
    ("_SPEED[2]", "_CHBIT[2]", 1.0, "B:13751-13763;B:1143-1161"),
    ("_SPEED[3]", "_CHBIT[17]", 0.0, "B:13772;B:14013;B:1143-1161"),
    ("E_MESS_FM", "", 1.0, "B:14178;B:1143-1161"),
    ("E_MESS_F", "", 1.0, "B:14179;B:1143-1161"),
    ("E_MESS_FZ", "", 1.0, "B:14180;B:1143-1161"),
    ("E_MESS_MT_FM", "", 1.0, "B:14198;B:1143-1161"),
];

/// Whether it is a feed of measuring in JOG, which is metric in every system of units (B:14250).
pub fn of_jog(name: &str) -> bool {
    name.starts_with("E_MESS")
}

/// What the export says of the slowest axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineAxis {
    /// From the signal to the braking command, s.
    pub delay: f64,
    /// Lowest deceleration, m/s².
    pub acceleration: f64,
    /// Lowest servo gain, (m/min)/mm.
    pub gain: f64,
}

/// The slowest axis of the export; none: something of it is not given, or no axis has it.
pub fn axis(given: &Exported) -> Option<MachineAxis> {
    let lowest = |number: &str| {
        let all = given.data.iter().filter(|((name, _), _)| arrays::stem(name) == number && moves(given, name));
        let numbers =
            all.filter_map(|(_, given)| if let Value::Number(value) = given.value { Some(value) } else { None });
        numbers.min_by(f64::total_cmp).filter(|lowest| *lowest > 0.0)
    };
    let [clock, ratio, acceleration, gain] = braking::DATA.map(lowest);
    let axis = MachineAxis { delay: clock? * ratio?, acceleration: acceleration?, gain: gain? };
    of_axis(axis).impossible().is_none().then_some(axis)
}

fn of_axis(axis: MachineAxis) -> Braking {
    Braking { delay: axis.delay, acceleration: axis.acceleration, gain: axis.gain }
}

/// Whether a datum is that of an axis that measuring moves: a rotary one or a spindle (MD30300, A:15872) stands still
/// while the probe touches, and its deceleration is no m/s².
fn moves(given: &Exported, name: &str) -> bool {
    let index = name.strip_suffix(']').and_then(|name| name.rsplit(['[', ',']).next());
    index.is_none_or(|axis| given.number(&format!("{ROTARY}[{axis}]"), 0) != Some(1.0))
}

/// Whether an axis is rotary.
const ROTARY: &str = "MD30300";

/// Numbers of the data of the axis that no file gives.
fn absent(given: &Exported) -> impl Iterator<Item = &'static str> {
    let there = |number: &str| {
        let mut names = given.data.keys().map(|(name, _)| name).filter(|name| arrays::stem(name) == number);
        names.any(|name| moves(given, name))
    };
    braking::DATA.into_iter().filter(move |number| !there(number))
}

/// Data of the axis that no file gives.
pub fn missing(given: &Exported) -> Vec<String> {
    absent(given).map(identified).collect()
}

/// That no feed is held against the deflection, because the files do not say how an axis stops.
pub fn unchecked(given: &Exported) -> Option<MachineFault> {
    let all: Vec<&str> = absent(given).collect();
    let message = Message::new("machine-check-no-axis").text("data", all.join(", "));
    Some(MachineFault::new(Severity::Warning, *all.first()?, message, "B:1149-1161;A:1095-1115"))
}

/// In which units the data of the axis count, where the control is one in inch: the manual prints them metric only.
pub fn metric(given: &Exported) -> Option<MachineFault> {
    let basic = given.channels().into_iter().find_map(|channel| given.number(BASIC_SYSTEM, channel));
    let message = Message::new("machine-check-axis-metric");
    let told = MachineFault::new(Severity::Note, "MD32300", message, "B:1149-1161;A:1095-1115");
    (basic == Some(0.0) && axis(given).is_some()).then_some(told)
}

/// Data of axes that no axis has: no braking path follows from them.
pub fn impossible(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let of_axis = |name: &str| braking::DATA.contains(&arrays::stem(name));
    let fault = |((name, channel), datum): (&(String, u32), &Given)| {
        let Value::Number(value) = datum.value else { return None };
        let message = Message::new("machine-check-positive").number("value", value);
        let fault = MachineFault::new(Severity::Warning, name, message, "B:1149-1161;A:1095-1115");
        let fault = fault.channel(*channel).value(shown(&datum.value)).at(Some(files.told(datum.place)));
        (of_axis(name) && value <= 0.0).then_some(fault)
    };
    given.data.iter().filter_map(fault).collect()
}

/// A feed of the data as a channel has it.
struct Touching<'a> {
    /// As its file has it.
    datum: &'a Given,
    feed: f64,
    /// Its unit in mm/min.
    unit: f64,
    source: &'static str,
}

impl Touching<'_> {
    /// The largest feed that the deflection allows, in the unit of the datum.
    fn largest(&self, braking: &Braking, deflection: f64) -> f64 {
        let step = if self.unit == 1.0 { 1.0 } else { 10.0 };
        (braking.feed(deflection) / self.unit * step).floor() / step
    }
}

/// A feed at which the probe may touch; none: it does not, or nothing is given.
fn touching<'a>(given: &'a Exported, name: &str, channel: u32) -> Option<Touching<'a>> {
    let (_, switch, as_delivered, source) = *FEEDS.iter().find(|(feed, ..)| *feed == name)?;
    // what is neither 0 nor 1 gets a line to change with the value as delivered
    let switch = given.number(switch, channel).filter(|value| [0.0, 1.0].contains(value)).unwrap_or(as_delivered);
    let watched = switch == 1.0;
    let (datum, feed) = (given.get(name, channel)?, given.number(name, channel)?);
    let inch = !of_jog(name) && given.number(BASIC_SYSTEM, channel) == Some(0.0);
    watched.then_some(Touching { datum, feed, unit: if inch { INCH } else { 1.0 }, source })
}

/// Takes no more for a feed out of its range than the deflection allows.
pub fn limit(faults: &mut [MachineFault], given: &Exported, deflection: f64) {
    let Some(braking) = axis(given).map(of_axis) else { return };
    for fault in faults {
        let Some(touching) = touching(given, &fault.name, fault.channel.unwrap_or(0)) else { continue };
        let largest = touching.largest(&braking, deflection);
        if fault.mended.as_ref().is_some_and(|mended| largest > 0.0 && mended.value > largest) {
            fault.mend(largest);
        }
    }
}

/// Feeds whose braking path is longer than the deflection, mm.
pub fn faults(given: &Exported, files: &Files, without: &[Use], deflection: f64) -> Vec<MachineFault> {
    let Some(braking) = axis(given).map(of_axis) else { return Vec::new() };
    let mut found: Vec<MachineFault> = Vec::new();
    for channel in given.channels() {
        for (name, ..) in FEEDS {
            let Some(touching) = touching(given, name, channel) else { continue };
            let path = braking.parts(touching.feed * touching.unit).sum();
            if of_jog(name) && without.contains(&Use::Jog) || path.is_nan() || path <= deflection {
                continue;
            }
            let largest = touching.largest(&braking, deflection);
            let message = Message::new("machine-check-braking")
                .number("feed", touching.feed)
                .number("path", (path * 1000.0).round() / 1000.0)
                .number("deflection", deflection)
                .number("largest", largest);
            let own = gud::named(name).is_some_and(|gud| gud.channel);
            let fault = MachineFault::new(Severity::Warning, name, message, touching.source)
                .channel(if own { channel } else { 0 })
                .value(shown(&touching.datum.value))
                .at(Some(files.told(touching.datum.place)));
            let fault = if largest > 0.0 { fault.mended(largest) } else { fault };
            if !found.contains(&fault) {
                found.push(fault);
            }
        }
    }
    found
}
