//! The braking path as a calculator: the path of a feed, and the largest feed of a deflection.

use super::Error;
use super::machine_check::{FEEDS, of_jog};
use crate::check;
use crate::control::Control;
use crate::control::braking::Braking;
use crate::diagnostic::Diagnostic;
use crate::refused::Path;
use serde::{Deserialize, Serialize};

/// An axis, and what is asked of it.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct BrakingRequest {
    /// From the signal to the braking command, s.
    pub delay: f64,
    /// Deceleration, m/s².
    pub acceleration: f64,
    /// Servo gain, (m/min)/mm.
    pub gain: f64,
    /// Feed whose path is asked for, mm/min.
    pub feed: Option<f64>,
    /// Deflection whose largest feed is asked for, mm.
    pub deflection: Option<f64>,
}

/// What an axis needs to stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct BrakingView {
    /// Path of the feed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<BrakingPath>,
    /// Largest feed of the deflection, mm/min.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<f64>,
}

/// The parts of a braking path, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct BrakingPath {
    /// Until the command to brake.
    pub delay: f64,
    /// While the set speed falls to zero.
    pub braking: f64,
    /// What the axis lags behind its set position.
    pub following: f64,
    /// All of it.
    pub sum: f64,
}

/// Answers what an axis needs to stop.
///
/// # Errors
/// There is no such axis: which value is at fault.
pub fn braking(asked: BrakingRequest) -> Result<BrakingView, Error> {
    let BrakingRequest { delay, acceleration, gain, feed, deflection } = asked;
    let axis = Braking { delay, acceleration, gain };
    let wrong = |(name, value): (&'static str, Option<f64>)| {
        value.filter(|value| !(value.is_finite() && *value > 0.0)).map(|value| (name, value))
    };
    let asked = || [("feed", feed), ("deflection", deflection)].into_iter().find_map(wrong);
    if let Some((name, value)) = axis.impossible().or_else(asked) {
        return Err(refused(name, value));
    }
    let path = feed.map(|feed| axis.parts(feed)).map(|parts| BrakingPath {
        delay: parts.delay,
        braking: parts.braking,
        following: parts.following,
        sum: parts.sum(),
    });
    Ok(BrakingView { path, feed: deflection.map(|deflection| axis.feed(deflection)) })
}

/// Why a value cannot be.
pub(super) fn refused(name: &'static str, value: f64) -> Error {
    Error::new("braking-value", Path::of(&[name])).number("value", value).text("name", name)
}

/// What is said of a datum of the machine that is a feed at which the probe may touch: the same as the check of a
/// machine says of it.
pub(super) fn of_datum(control: &Control, name: &str) -> Option<Diagnostic> {
    let (_, switch, ..) = FEEDS.iter().find(|(feed, ..)| *feed == name)?;
    let may_touch = switch.is_empty() || control.bit(switch);
    may_touch.then(|| check::braking::of_datum(control, name, of_jog(name)))?
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::app::{ExportedFile, MachineCheckRequest, machine_check};
    use crate::control::{Units, delivery_in};
    use crate::dialect::Dialect;
    use crate::message::Message;
    use std::collections::BTreeMap;

    /// A machine with an axis as in the manual's example (B:1184-1187), what its files say of it, and these data.
    fn machine(units: Units, data: &[(&str, f64)]) -> (Control, String) {
        let mut control = delivery_in(Dialect::Sinumerik, units);
        let metric = f64::from(u8::from(units == Units::Metric));
        let axis = [("MD10050", 0.004), ("MD10070", 4.0), ("MD32300", 1.0), ("MD32200", 1.0), ("MD10240", metric)];
        axis.iter().chain(data).for_each(|(name, value)| control.set(*name, *value));
        let feeds = FEEDS.iter().flat_map(|(feed, switch, ..)| [*feed, *switch]).filter(|name| !name.is_empty());
        let names = axis.iter().map(|(name, _)| *name).chain(feeds);
        let text = names.map(|name| format!("{name}={}\n", control.number(name))).collect();
        (control, text)
    }

    /// Feed, path and largest feed by datum.
    fn figures<'a>(told: impl Iterator<Item = (String, [&'a Message; 2])>) -> BTreeMap<String, String> {
        let figure = |message: &Message, name: &str| {
            let found = message.args.iter().find(|(known, _)| *known == name).map(|(_, arg)| format!("{arg:?}"));
            found.unwrap_or_default()
        };
        let all = |[said, hint]: [&Message; 2]| {
            [figure(said, "feed"), figure(said, "deflection"), figure(hint, "largest")].join(" ")
        };
        told.map(|(name, messages)| (name, all(messages))).collect()
    }

    // oracle: self (the form of the machine data and the check of a machine tell the same feeds with the same figures)
    #[test]
    fn form_and_check_of_a_machine_tell_the_same_feeds() {
        for units in [Units::Metric, Units::Inch] {
            for switches in [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]] {
                for (deflection, share) in [(0.1, 1.0), (0.5, 1.0), (1.3, 1.0), (0.5, 0.2), (3.2, 1.0)] {
                    let [watched, twice] = switches;
                    let (delivered, _) = machine(units, &[]);
                    let mut data = vec![("_CHBIT[2]", watched), ("_CHBIT[17]", twice)];
                    data.extend(
                        FEEDS.iter().map(|(feed, ..)| (*feed, (delivered.number(feed) * share * 10.0).round() / 10.0)),
                    );
                    let (mut control, text) = machine(units, &data);
                    control.deflection = Some(deflection);
                    let form: Vec<_> =
                        FEEDS.iter().filter_map(|(feed, ..)| Some((*feed, of_datum(&control, feed)?))).collect();
                    let form = figures(
                        form.iter()
                            .map(|(feed, said)| ((*feed).to_owned(), [&said.message, said.hint.as_ref().unwrap()])),
                    );
                    let file = ExportedFile { name: "INITIAL.INI".to_owned(), text };
                    let asked = MachineCheckRequest {
                        files: vec![file],
                        without: Vec::new(),
                        large: false,
                        deflection: Some(deflection),
                    };
                    let view = machine_check(asked).unwrap();
                    let braking = view.faults.iter().filter(|fault| fault.message.key == "machine-check-braking");
                    let check = figures(braking.map(|fault| (fault.name.clone(), [&fault.message, &fault.message])));
                    assert_eq!(form, check, "{units:?} {switches:?} {deflection} {share}");
                }
            }
        }
    }

    // oracle: hand (the path of 300 mm/min is 0.3925 mm, 900: 1.2525, 1000: 1.4056, 2000: 3.0889), B:13751-13763 and
    // B:13772 (without its switch none of these feeds is one at which the probe touches), B:14250 (JOG is metric)
    #[test]
    fn a_feed_of_the_machine_is_told_where_the_probe_may_touch() {
        let told = |units, deflection, data: &[(&str, f64)]| {
            let (mut control, _) = machine(units, data);
            control.deflection = deflection;
            let told = FEEDS.iter().filter(|(feed, ..)| of_datum(&control, feed).is_some());
            told.map(|(feed, ..)| *feed).collect::<Vec<_>>()
        };
        let jog = ["E_MESS_F", "E_MESS_FZ"];
        for units in [Units::Metric, Units::Inch] {
            let ways = ["_SPEED[1]", "_SPEED[2]", "E_MESS_F", "E_MESS_FZ"];
            assert_eq!(told(units, Some(0.5), &[]), ways);
            assert_eq!(told(units, Some(0.5), &[("_CHBIT[2]", 0.0)]), jog);
            let twice = told(units, Some(0.5), &[("_CHBIT[17]", 1.0), ("_CHBIT[2]", 0.0)]);
            assert_eq!(twice, ["_SPEED[3]", "E_MESS_F", "E_MESS_FZ"]);
            assert_eq!(told(units, Some(1.42), &[]), jog);
            assert_eq!(told(units, Some(3.1), &[]), [""; 0]);
            assert_eq!(told(units, None, &[("E_MESS_FM", 9000.0)]), [""; 0]);
        }
        let (mut control, _) = machine(Units::Inch, &[]);
        control.deflection = Some(0.39);
        let said = of_datum(&control, "E_MESS_FM").unwrap();
        assert_eq!(said.message.word("unit"), Some("\u{a0}mm/min"));
        assert!(of_datum(&control, "_VMS").is_none() && of_datum(&control, "_SPEED[0]").is_none());
    }

    // oracle: hand (no axis stops without deceleration or gain, no probe allows less than nothing)
    #[test]
    fn values_that_cannot_be_are_named() {
        let fine = BrakingRequest { delay: 0.0, acceleration: 1.0, gain: 1.0, feed: None, deflection: None };
        assert!(braking(fine).is_ok());
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            for (name, asked) in [
                ("acceleration", BrakingRequest { acceleration: wrong, ..fine }),
                ("gain", BrakingRequest { gain: wrong, ..fine }),
                ("feed", BrakingRequest { feed: Some(wrong), ..fine }),
                ("deflection", BrakingRequest { deflection: Some(wrong), ..fine }),
            ] {
                let told = braking(asked).err().and_then(|error| error.message.word("name").map(str::to_owned));
                assert_eq!(told.as_deref(), Some(name), "{wrong}");
            }
        }
    }
}
