//! What is written beside what is drawn: keys of messages with their arguments, where they stand, and when.

use super::frames::Frame;
use crate::control::{Control, Transverse, Units};
use crate::geometry::{Dir, Mcs, V3};
use crate::machine::{Entries, Entry, Step};
use crate::message::Message;
use crate::name::Name;
use crate::workpiece::Touching;
use serde::Serialize;

/// Diameters that differ by less than this, mm, are the same on a drawing.
const EXACT: f64 = 5e-4;

/// What a label tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LabelKind"))]
pub enum Kind {
    /// Names of the coordinate systems at a place.
    Frame,
    /// A diameter of a turned part as it is, at an end of its dimension line.
    Diameter,
    /// A diameter as it should be, and how far it is off, below that.
    Nominal,
    /// The diameter at a touched point as the control reads it.
    Touched,
    /// A touch that measures: its number in the call, and the coordinate of the touched point.
    Touch,
    /// What must not touch and did.
    Collision,
    /// A dimension of the part that a parameter gives, by its name.
    Size,
    /// Another dimension that a parameter gives, by its name.
    Anchor,
}

/// Words at a place.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SceneLabel", optional_fields))]
pub struct Label {
    /// What it tells.
    pub kind: Kind,
    /// Where, machine coordinates, mm.
    pub at: [f64; 3],
    /// What is said, one after the other; nothing: the name of the parameter.
    pub text: Vec<Message>,
    /// Whether it stands at the upper end of a dimension line: neighbours have their words at different ends.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub upper: bool,
    /// Which touch of its call it is, from 1 on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub number: Option<usize>,
    /// Parameter that the dimension explains, where a form asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<Name>,
    /// Entry of the trace with which it comes; none: it is always there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<usize>,
    /// Entry with which it goes again.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to: Option<usize>,
}

impl Label {
    fn new(kind: Kind, at: [f64; 3], text: Message) -> Label {
        Label { kind, at, text: vec![text], upper: false, number: None, field: None, from: None, to: None }
    }
}

/// Coordinate systems by the names of their zero offsets, those at one place together.
pub fn frames(frames: &[Frame]) -> Vec<Label> {
    let mut labels: Vec<(&Frame, Label)> = Vec::new();
    for frame in frames {
        let text = match (frame.name.as_str(), frame.moved) {
            ("", _) => Message::new("frame-machine"),
            (name, moved) => Message::new(format!("frame-{}", moved.unwrap_or("now"))).text("name", name),
        };
        match labels.iter_mut().find(|(known, _)| (known.at, known.axes) == (frame.at, frame.axes)) {
            Some((_, label)) => label.text.push(text),
            None => labels.push((frame, Label::new(Kind::Frame, frame.at, text))),
        }
    }
    labels.into_iter().map(|(_, label)| label).collect()
}

/// A length, mm, as the control shows it: to a thousandth of a millimetre, or a ten-thousandth of an inch.
fn figure(length: f64, units: Units) -> String {
    let digits = if units == Units::Inch { 4 } else { 3 };
    format!("{:.digits$}", length / units.factor())
}

/// A diameter at an end of its dimension line: as it is, and below as it should be; mm. `field`: what explains it.
pub fn dimension(at: [f64; 3], upper: bool, [set, real]: [f64; 2], field: Option<Name>, units: Units) -> [Label; 2] {
    let figure = |length| figure(length, units);
    let label = |kind, text: Message| Label { upper, field, ..Label::new(kind, at, text) };
    let off = real - set;
    let sign = if off < 0.0 { '−' } else { '+' };
    let nominal = match off.abs() < EXACT {
        true => Message::new("diameter-exact"),
        false => Message::new("diameter-off").text("off", format!("{sign}{}", figure(off.abs()))),
    };
    [
        label(Kind::Diameter, Message::new("diameter-real").text("diameter", figure(real))),
        label(Kind::Nominal, nominal.text("diameter", figure(set))),
    ]
}

/// The name of a parameter at its dimension, mm; `own`: a dimension of the part.
pub fn anchor(at: V3, field: Name, own: bool) -> Label {
    let kind = if own { Kind::Size } else { Kind::Anchor };
    Label {
        kind,
        at: at.into(),
        text: Vec::new(),
        upper: false,
        number: None,
        field: Some(field),
        from: None,
        to: None,
    }
}

/// The diameter at a touched point, from the touch on until that point is touched again.
pub fn touched(at: [f64; 3], diameter: f64, [from, to]: [Option<usize>; 2], units: Units) -> Label {
    let text = Message::new("diameter-real").text("diameter", figure(diameter, units));
    Label { from, to, ..Label::new(Kind::Touched, at, text) }
}

/// Crashes, touches of stylus or body, and touches that end in an alarm, which is told then.
pub fn collisions(entries: &Entries) -> Vec<Label> {
    let mut known: Vec<Label> = Vec::new();
    let found = entries.others().filter_map(|one| {
        let (point, by, text) = match one.step {
            Step::Crash { point, by, .. } => (point, by, Message::new("collision-crash")),
            Step::Touch { point, by, .. } => match raised(entries.behind(one.at + 1)) {
                Some(alarm) => (point, by, Message::new("collision-alarm").text("code", alarm)),
                None if by.measures() => return None,
                None => (point, by, Message::new("collision-first")),
            },
            _ => return None,
        };
        let what = match by {
            Touching::Ball => "collision-ball",
            Touching::Stylus => "collision-stylus",
            Touching::Body => "collision-body",
            Touching::Tool | Touching::Cutter => "collision-tool",
        };
        Some(Label { from: Some(one.at), ..Label::new(Kind::Collision, point.0, text.text("what", what)) })
    });
    for label in found {
        // who runs against the same place again is told it once
        let again = |one: &Label| one.text == label.text && (V3::from(one.at) - V3::from(label.at)).norm() < SAME;
        if !known.iter().any(again) {
            known.push(label);
        }
    }
    known
}

/// Code of the alarm that comes before anything moves again.
fn raised(mut later: impl Iterator<Item = Entry>) -> Option<String> {
    let next = later.find(|one| matches!(one.step, Step::Alarm(_) | Step::Motion { .. } | Step::CallBegin { .. }))?;
    let Step::Alarm(code) = next.step else { return None };
    Some(code.to_string())
}

/// Which parameter explains a diameter: that of the first touched place on it. `edges`: parameters in the order of the
/// touches, the last for the rest; `touches`: points in their order.
pub fn explained(edges: &[Name], touches: &[[f64; 3]], middle: V3, axis: V3, diameter: f64) -> Option<Name> {
    const NEAR: f64 = 1.0; // mm, within which a point is one of a diameter
    let across = |point: &[f64; 3]| 2.0 * (V3::from(*point) - middle).cross(&axis).norm();
    let first = touches.iter().position(|point| (across(point) - diameter).abs() < NEAR)?;
    edges.get(first).or(edges.last()).copied()
}

/// Points that are nearer to each other, mm, are the same.
const SAME: f64 = 1.0;

/// The coordinate of each touched point along which was measured, in the workpiece coordinate system that was active
/// first and in these units, and the direction; until the point is touched again or the next cycle begins.
pub fn touches(control: &Control, units: Units, entries: &Entries) -> Vec<Label> {
    let mut found: Vec<Label> = Vec::new();
    let mut first = 0; // of the present call
    for other in entries.others() {
        let index = other.at;
        let label = match other.step {
            Step::CallBegin { .. } => {
                found[first..].iter_mut().filter(|label| label.to.is_none()).for_each(|label| label.to = Some(index));
                first = found.len();
                continue;
            }
            Step::Touch { point, normal, by, .. } if by.measures() => touch(control, units, *point, *normal),
            _ => continue,
        };
        let number = found.len() - first + 1;
        for before in found[first..].iter_mut().filter(|before| before.to.is_none()) {
            if (V3::from(before.at) - V3::from(label.at)).norm() < SAME {
                before.to = Some(index);
            }
        }
        found.push(Label { number: Some(number), from: Some(index), ..label });
    }
    found
}

/// The coordinate of a touched point, a diameter where X counts so, and in which direction it was touched.
fn touch(control: &Control, units: Units, point: Mcs, normal: Dir<Mcs>) -> Label {
    const AXES: [&str; 3] = ["X", "Y", "Z"];
    let [along, at] = [control.direction_to_workpiece(normal).0, control.to_workpiece(point).0];
    let axis = (0..3).max_by(|a, b| along[*a].abs().total_cmp(&along[*b].abs())).unwrap_or_default();
    let diameter = axis == 0 && control.transverse != Transverse::Radius;
    let value = if diameter { 2.0 * at[0] } else { at[axis] };
    let direction = format!("{}{}", AXES[axis], if along[axis] > 0.0 { '−' } else { '+' });
    let value = figure(value, units).replace('-', "−");
    let text = Message::new("touch-value").text("axis", direction).text("value", value);
    Label::new(Kind::Touch, point.0, text)
}
