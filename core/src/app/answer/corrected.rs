//! What a call corrected: frame or tool, and each of its values by how much.

use super::is_corrected;
use crate::control::Control;
use crate::control::rotary::is_angle;
use crate::machine::{Entry, Step};
use crate::message::Message;
use serde::Serialize;
use std::collections::BTreeMap;

/// A frame, tool, register or probe that was corrected.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Correction {
    /// What it is.
    pub target: Message,
    /// By how much; none: its data are new.
    pub parts: Vec<Part>,
}

/// A value of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Part {
    /// Axis, length or radius: `X`, `L1`, `R`.
    pub name: String,
    /// After minus before, in its unit.
    pub by: f64,
    /// Unit of the basic system of the machine, or degree.
    pub unit: &'static str,
}

/// Where a datum belongs.
struct Place {
    /// What is corrected; `fine`: whether the datum is the fine part of it.
    target: Message,
    /// Axis, length or radius.
    part: String,
    angle: bool,
    fine: bool,
}

/// What is smaller has no meaning, mm and degree.
const SMALLEST: f64 = 1e-9;

/// What the steps of a call corrected.
pub fn corrected(entries: &[Entry], control: &Control) -> Vec<Correction> {
    let mut all: Vec<(Message, Vec<(Part, bool)>)> = Vec::new();
    for (name, by) in changes(entries) {
        let Some(place) = place(control, name) else { continue };
        let by = if place.angle { turn(by) } else { by / control.basic_factor() };
        let unit = if place.angle { "deg" } else { control.basic_units.name() };
        let at = all.iter().position(|(target, _)| *target == place.target).unwrap_or_else(|| {
            all.push((place.target.clone(), Vec::new()));
            all.len() - 1
        });
        let parts = &mut all[at].1;
        match parts.iter_mut().find(|(part, _)| (&part.name, part.unit) == (&place.part, unit)) {
            Some((part, fine)) => {
                part.by += by;
                *fine &= place.fine;
            }
            None => parts.push((Part { name: place.part, by, unit }, place.fine)),
        }
    }
    all.into_iter().filter_map(|(target, parts)| made(target, parts)).chain(probe(entries)).collect()
}

/// A datum that a call corrected, in mm.
pub struct CorrectedDatum {
    /// Its name: `$TC_DP15[20,1]`.
    pub variable: String,
    /// What is corrected.
    pub target: Message,
    /// Axis, length or radius.
    pub part: String,
    /// Whether it is a frame.
    pub frame: bool,
    /// After minus before, mm.
    pub by: f64,
}

/// The lengths that the steps of a call corrected, each by its name.
pub fn corrected_data(entries: &[Entry], control: &Control) -> Vec<CorrectedDatum> {
    let datum = |(name, by): (&str, f64)| {
        let Place { target, part, angle, .. } = place(control, name)?;
        let frame = target.key == "answer-frame";
        (!angle).then(|| CorrectedDatum { variable: name.to_owned(), target, part, frame, by })
    };
    changes(entries).into_iter().filter_map(datum).collect()
}

/// A frame of which only the fine part changed says so.
fn made(target: Message, parts: Vec<(Part, bool)>) -> Option<Correction> {
    let fine = parts.iter().all(|(_, fine)| *fine);
    let mut parts: Vec<Part> = parts.into_iter().map(|(part, _)| part).collect();
    parts.retain(|part| part.by.abs() > SMALLEST);
    parts.sort_by(|a, b| (a.unit == "deg", &a.name).cmp(&(b.unit == "deg", &b.name)));
    let named = fine && target.key == "answer-frame";
    let target = if named { Message { key: "answer-frame-fine".into(), ..target } } else { target };
    (!parts.is_empty()).then_some(Correction { target, parts })
}

/// Each datum that was written by its name, after minus before.
fn changes(entries: &[Entry]) -> BTreeMap<&str, f64> {
    let mut ends: BTreeMap<&str, (f64, f64)> = BTreeMap::new();
    for entry in entries {
        if let Step::Set { name, before, after } = &entry.step {
            ends.entry(name).and_modify(|(_, last)| *last = *after).or_insert((*before, *after));
        }
    }
    ends.into_iter().map(|(name, (before, after))| (name, after - before)).collect()
}

/// The shortest way from one angle to another, degree.
fn turn(by: f64) -> f64 {
    by - 360.0 * (by / 360.0).round()
}

fn place(control: &Control, name: &str) -> Option<Place> {
    if !is_corrected(control, name) {
        return None;
    }
    let (stem, rest) = name.split_once('[').unwrap_or((name, ""));
    let index: Vec<&str> = rest.trim_end_matches(']').split(',').collect();
    let of_frame = |frame: String, axis: &str, part: &str| {
        let fine = matches!(part, "FI" | "RT");
        let target = Message::new("answer-frame").text("frame", frame);
        let place = Place { target, part: axis.to_owned(), angle: is_angle(name), fine };
        ["TR", "FI", "RT"].contains(&part).then_some(place)
    };
    match (stem, &index[..]) {
        ("$P_UIFR", [frame, axis, part]) => of_frame(control.make().settable_name(frame.parse().ok()?), axis, part),
        ("$P_SETFR", [axis, part]) => of_frame(stem.to_owned(), axis, part),
        (_, [frame, axis, part]) => of_frame(format!("{stem}[{frame}]"), axis, part),
        (_, [tool, edge]) => tool_part(stem.strip_prefix("$TC_")?, tool, edge),
        _ => register(name),
    }
}

/// Geometry 3 to 6 and wear 12 to 15 of `$TC_DP`; `SCP` and `ECP` with the DL number before one of 3 to 6
/// (B:16259-16269).
fn tool_part(name: &str, tool: &str, edge: &str) -> Option<Place> {
    let (number, offset) = match name.strip_prefix("DP") {
        Some(number) => (number.parse::<u32>().ok()?, None),
        None => {
            let number: u32 = name.strip_prefix("SCP").or(name.strip_prefix("ECP"))?.parse().ok()?;
            (number % 10, Some(number / 10))
        }
    };
    let part = match number {
        3..=5 => format!("L{}", number - 2),
        12..=14 => format!("L{}", number - 11),
        6 | 15 => "R".to_owned(),
        _ => return None,
    };
    let key = if offset.is_some() { "answer-tool-offset" } else { "answer-tool" };
    let target = Message::new(key).text("tool", tool).text("edge", edge);
    let target = offset.into_iter().fold(target, |target, offset| target.number("offset", f64::from(offset)));
    Some(Place { target, part, angle: false, fine: false })
}

/// NCT: work offsets `G54 X`, registers with their wear `H98`, `HW98`, `D98`, `DW98`.
fn register(name: &str) -> Option<Place> {
    if let Some((frame, axis)) = name.split_once(' ') {
        let target = Message::new("answer-frame").text("frame", frame);
        return Some(Place { target, part: axis.to_owned(), angle: false, fine: false });
    }
    let digits = name.find(|letter: char| letter.is_ascii_digit())?;
    let (letters, register) = name.split_at(digits);
    let target = Message::new("answer-register").text("register", register);
    Some(Place { target, part: letters.chars().next()?.to_string(), angle: false, fine: false })
}

/// Data of probes, which a calibration renews (`_WP`, `_TP`, `_TPW`: B:13441-13450; NCT #500 to #513: C:92-94).
fn probe(entries: &[Entry]) -> Option<Correction> {
    let data = ["_WP[", "_TP[", "_TPW["];
    let of_probe =
        |name: &str| data.iter().any(|stem| name.starts_with(stem)) || crate::control::nct_data::find(name).is_some();
    let mut names = changes(entries).into_iter().filter(|(name, by)| of_probe(name) && by.abs() > SMALLEST);
    names.next().map(|_| Correction { target: Message::new("answer-probe"), parts: Vec::new() })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Units, delivery};
    use crate::dialect::Dialect;

    // oracle: manual B:1899-1990: TR and FI of an axis of rotation are angles, which no unit of lengths changes
    #[test]
    fn an_axis_of_rotation_is_corrected_in_degrees() {
        let mut control = delivery(Dialect::Sinumerik);
        control.basic_units = Units::Inch;
        let set = |name: &str, after: f64| Entry {
            line: None,
            step: Step::Set { name: name.to_owned(), before: 0.0, after },
            in_use: 0,
        };
        let entries = [set("$P_UIFR[1,C,TR]", 2.54), set("$P_UIFR[1,X,TR]", 2.54), set("$P_UIFR[1,Z,RT]", 3.0)];
        let parts = corrected(&entries, &control).remove(0).parts;
        let found: Vec<_> = parts.iter().map(|part| (&*part.name, part.by, part.unit)).collect();
        assert_eq!(found, [("X", 0.1, "inch"), ("C", 2.54, "deg"), ("Z", 3.0, "deg")]);
        let lengths = corrected_data(&entries, &control);
        assert_eq!(lengths.iter().map(|one| &*one.variable).collect::<Vec<_>>(), ["$P_UIFR[1,X,TR]"]);
    }
}
