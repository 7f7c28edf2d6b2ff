//! What is different after a run, with words for the names that a program would use.

use crate::control::rotary::is_angle;
use crate::control::{Control, Units, gud, machine_data, nct_data};
use crate::message::Message;
use crate::run;
use serde::Serialize;

/// A quantity that is different after a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Change {
    /// As a program would name it: `$TC_DP15[20,1]`, `$P_UIFR[1,X,FI]`, `_MV[9]`.
    pub name: String,
    /// In words.
    pub label: Message,
    /// Before, in its unit.
    pub before: f64,
    /// After.
    pub after: f64,
    /// A length has that of the basic system of the machine.
    pub unit: &'static str,
}

/// Tools, frames and memories before and after, lengths in the unit of the basic system.
pub fn changes(outcome: &run::Outcome) -> Vec<Change> {
    let changes = outcome.changes().into_iter();
    changes.map(|one| Change::of(&outcome.control, one.name, one.before, one.after)).collect()
}

impl Change {
    /// What changed of a control, lengths given in mm.
    pub(super) fn of(control: &Control, name: String, before: f64, after: f64) -> Change {
        let basic = control.basic_units;
        let (factor, unit) = match is_angle(&name) {
            true => (1.0, "deg"),
            false if is_number(&name) => (1.0, metric(&name)),
            false => (basic.factor(), basic.name()),
        };
        let (label, name) = (label(control, &name), control.setting_of(&name).unwrap_or(name));
        Change { label, before: before / factor, after: after / factor, unit, name }
    }
}

/// Whether a name is none of a length in the basic system: lengths are those of frames, of cutting edges but for type
/// and position, calibrated ones and registers.
fn is_number(name: &str) -> bool {
    let stem = name.split('[').next().unwrap_or(name);
    match name.chars().next() {
        _ if is_factor(name) || ["$TC_DP1", "$TC_DP2"].contains(&stem) => true,
        _ if gud::named(name).is_some() => !run::is_length(name),
        Some('$') => !stem.starts_with("$P_") && !machine_data::of_edge(stem),
        Some('#') => false,
        _ => nct_data::find(name).is_none(),
    }
}

/// The unit of a datum that is metric on any machine, as those of JOG are (B:14170-14172).
fn metric(name: &str) -> &'static str {
    let element = gud::place(name).and_then(|(gud, at)| gud.element(&at));
    match element.map(|element| element.unit) {
        Some(gud::Unit::Length(gud::System::Metric)) => Units::Metric.name(),
        _ => "",
    }
}

/// Whether a name is a scale factor or a mirror of a frame.
fn is_factor(name: &str) -> bool {
    name.ends_with(",SC]") || name.ends_with(",MI]")
}

/// In words: which quantity of which tool, frame or memory. A name that has no words of its own stands for itself.
fn label(control: &Control, name: &str) -> Message {
    let (stem, rest) = name.split_once('[').unwrap_or((name, ""));
    let index: Vec<&str> = rest.trim_end_matches(']').split(',').collect();
    let known = match (stem, index.as_slice()) {
        ("_MV", [memory]) => memory_label("change-mean", memory),
        ("_EV", [memory]) => memory_label("change-empirical", memory),
        ("_WP", [probe, field]) => probe_label(probe, field),
        ("$P_UIFR", [frame, axis, part]) => {
            frame.parse().ok().and_then(|number| frame_label(control.make().settable_name(number), axis, part))
        }
        ("$P_SETFR", [axis, part]) => frame_label(stem.to_owned(), axis, part),
        (_, [frame, axis, part]) => frame_label(format!("{stem}[{frame}]"), axis, part),
        (_, [tool, edge]) => {
            stem.strip_prefix("$TC_").and_then(quantity).map(|text| text.text("tool", *tool).text("edge", *edge))
        }
        _ => register(name),
    };
    let words = known.or_else(|| datum(name));
    words.unwrap_or_else(|| Message::new("change-other").text("name", name))
}

/// A datum of the machine by the words of its table.
fn datum(name: &str) -> Option<Message> {
    if let Some(datum) = nct_data::find(name) {
        return Some(Message::new(datum.key()));
    }
    let (gud, at) = gud::place(name)?;
    Some(Message::new(gud.key(gud.element(&at)?)))
}

/// Memories are counted from 1 on the control's screens, from 0 in the program.
fn memory_label(key: &'static str, index: &str) -> Option<Message> {
    let index: f64 = index.parse().ok()?;
    Some(Message::new(key).number("memory", index + 1.0))
}

/// Ball, trigger values and skew of a probe by their place in `_WP[k,0..8]` (B:13441-13450).
const PROBE: [&str; 9] = [
    "change-probe-ball",
    "change-trigger-abscissa-minus",
    "change-trigger-abscissa-plus",
    "change-trigger-ordinate-minus",
    "change-trigger-ordinate-plus",
    "change-trigger-applicate-minus",
    "change-trigger-applicate-plus",
    "change-skew-abscissa",
    "change-skew-ordinate",
];

/// Probes are counted from 1 in `_PRNUM`, from 0 in the data.
fn probe_label(index: &str, field: &str) -> Option<Message> {
    let (index, field): (f64, usize) = (index.parse().ok()?, field.parse().ok()?);
    let key = *PROBE.get(field)?;
    Some(Message::new(key).number("probe", index + 1.0))
}

/// Scale factors and mirrors, which no cycle corrects, stand for themselves.
fn frame_label(frame: String, axis: &str, part: &str) -> Option<Message> {
    let key = match part {
        "FI" => "change-fine",
        "RT" => "change-rotation",
        "TR" => "change-coarse",
        _ => return None,
    };
    Some(Message::new(key).text("frame", frame).text("axis", axis))
}

/// Tool data: 3 to 5 lengths, 6 radius, 12 to 14 wear of the lengths, 15 wear of the radius; `SCP` and `ECP` are
/// followed by the DL number and one of 3 to 6.
fn quantity(name: &str) -> Option<Message> {
    if let Some(number) = name.strip_prefix("DP") {
        let number: u32 = number.parse().ok()?;
        return Some(match number {
            3..=5 => length("change-length", number - 2),
            6 => Message::new("change-radius"),
            12..=14 => length("change-length-wear", number - 11),
            15 => Message::new("change-radius-wear"),
            _ => return None,
        });
    }
    let offset: u32 = name.strip_prefix("SCP").or(name.strip_prefix("ECP"))?.parse().ok()?;
    let text = match offset % 10 {
        3..=5 => length("change-length-offset", offset % 10 - 2),
        6 => Message::new("change-radius-offset"),
        _ => return None,
    };
    Some(text.number("offset", f64::from(offset / 10)))
}

fn length(key: &'static str, number: u32) -> Message {
    Message::new(key).number("length", f64::from(number))
}

/// NCT: work offsets `G54 X`, and registers with their wear `H98`, `HW98`, `D98`, `DW98`.
fn register(name: &str) -> Option<Message> {
    if let Some((frame, axis)) = name.split_once(' ') {
        let offset = Message::new("change-offset");
        return Some(offset.text("frame", frame).text("axis", axis));
    }
    let digits = name.find(|c: char| c.is_ascii_digit())?;
    let (letters, register) = name.split_at(digits);
    let key = match letters {
        "H" => "change-register-length",
        "HW" => "change-register-length-wear",
        "D" => "change-register-radius",
        "DW" => "change-register-radius-wear",
        _ => return None,
    };
    Some(Message::new(key).text("register", register))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::words::Words;

    // oracle: manual B:16259-16269 (tool data), B:1899-1990 (frames), C:304-307 (registers)
    #[test]
    fn names_are_put_into_words() {
        for (dialect, name, words) in [
            (Dialect::Sinumerik, "$TC_DP15[20,1]", "T20 D1, radius wear"),
            (Dialect::Sinumerik, "$TC_DP12[7,2]", "T7 D2, wear of length 1"),
            (Dialect::Sinumerik, "$TC_SCP26[7,2]", "T7 D2, radius, DL2"),
            (Dialect::Sinumerik, "$P_UIFR[1,X,FI]", "G54, X fine"),
            (Dialect::Sinumerik, "$P_UIFR[5,Z,RT]", "G505, rotation about Z"),
            (Dialect::Sinumerik, "$P_CHBFR[0,Y,TR]", "$P_CHBFR[0], Y coarse"),
            (Dialect::Sinumerik, "$P_UIFR[1,X,SC]", "$P_UIFR[1,X,SC]"),
            (Dialect::Sinumerik, "_MV[9]", "Mean value memory 10"),
            (Dialect::Sinumerik, "_WP[2,4]", "Probe 3, trigger point ordinate plus"),
            (Dialect::Sinumerik, "_TPW[0,3]", "Trigger point, 2nd axis plus"),
            (Dialect::Nct, "G54 X", "G54, X"),
            (Dialect::Nct, "DW12", "Register 12, radius wear"),
        ] {
            let text = label(&delivery(dialect), name);
            assert_eq!(Words::english().text(&text), words, "{name}");
        }
    }
}
