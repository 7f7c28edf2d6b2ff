//! A call as the mask that does the same: its fields by the table the other way round, and what has no place in them.

use super::word;
use super::{Counterpart, Holds, Layout, Source, TABLE};
use crate::catalogue::in_jog::corner_edges;
use crate::check;
use crate::control::{AXES, Control, ROTARY};
use crate::entry::{Cycle, Inputs, Typed, names};
use crate::jog::mask::{Field, Kind, Least, Mask};
use crate::jog::values::ROTATION;
use crate::jog::{masks, offset};
use crate::message::Message;

/// A mask that is opened for a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Masked {
    /// The mask.
    pub mask: &'static str,
    /// What opens it and fills it in, as a script has it.
    pub lines: Vec<String>,
    /// What of the call has no place in it.
    pub told: Vec<Message>,
}

/// The mask that measures what a call measures; none: there is none.
pub fn masked(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<Masked> {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let counterpart = of(&inputs)?;
    let mask = masks::alike(control, counterpart.mask)?;
    let outside = |name: &str, words: &[&str]| name == "corner" && words.contains(&"outside");
    let lost = counterpart.when.iter().any(|holds| match holds {
        Holds::Word(name, words) => mask.field(name).is_none() && !outside(name, words),
        Holds::Zero(name, zero) => mask.field(name).is_none() && !zero,
        Holds::Wide(_) => false,
    });
    if lost {
        return None; // up to SW 6.2 there is no such field
    }
    let mut back = Back { inputs: &inputs, control, counterpart, mask, filled: Vec::new(), said: Vec::new() };
    back.choices();
    back.numbers();
    let fields = back.filled.iter().map(|(name, text)| format!("{name} = {text}"));
    let lines = std::iter::once(format!("mask {}", mask.name)).chain(fields).collect();
    Some(Masked { mask: mask.name, told: back.told(typed), lines })
}

/// The row of the table that a call is; one of its own variant before one that has it beside.
fn of(inputs: &Inputs) -> Option<&'static Counterpart> {
    let meant = |one: &&Counterpart| {
        let axis = inputs.cycle.param(names::MA.as_str()).map_or(0, |_| inputs.integer(names::MA) % 10);
        one.cycle == inputs.cycle.name && (one.axis.is_empty() || one.axis.contains(&axis))
    };
    let own = TABLE.iter().filter(meant).find(|one| one.variant == inputs.variant);
    own.or_else(|| TABLE.iter().filter(meant).find(|one| one.also.contains(&inputs.variant)))
}

struct Back<'a> {
    inputs: &'a Inputs,
    control: &'a Control,
    counterpart: &'static Counterpart,
    mask: &'static Mask,
    /// Fields and what is entered, in the order of the mask.
    filled: Vec<(&'static str, String)>,
    /// Parameters that have their place, or follow from it.
    said: Vec<crate::name::Name>,
}

impl Back<'_> {
    fn fill(&mut self, name: &'static str, text: String) {
        if self.mask.field(name).is_some() && !self.filled.iter().any(|(known, _)| *known == name) {
            self.filled.push((name, text));
        }
    }

    /// What the row says of the mask, and what follows from axes and directions.
    fn choices(&mut self) {
        for holds in self.counterpart.when {
            if let Holds::Word(name, [word]) = holds {
                self.fill(name, (*word).to_owned());
            }
        }
        match self.counterpart.layout {
            Layout::Opposite | Layout::Points { .. } => {
                let position = self.position();
                self.fill("pos", position.to_string());
            }
            Layout::Middle { .. } => {
                self.fill("direction", "+".to_owned());
                self.fill("direction_2", "-".to_owned());
            }
            _ => {}
        }
    }

    /// The numbers of the call, each in the field from which it would come.
    fn numbers(&mut self) {
        for (name, source) in self.counterpart.values {
            if self.inputs.given(*name).is_none() && !matches!(source, Source::Number(_)) {
                continue;
            }
            let value = self.inputs.value(*name);
            match source {
                Source::Field(field) | Source::Size(field) => self.enter(field, value),
                Source::Minus(field) => self.enter(field, -value),
                Source::Axis(field) => self.axis(field, value as i64 % 10),
                Source::Axes(offset, measuring) => {
                    self.axis(measuring, value as i64 % 10);
                    self.axis(offset, value as i64 / 100);
                }
                Source::Direction(field) => self.fill(field, if value == 0.0 { "+" } else { "-" }.to_owned()),
                Source::Target => self.target(value as i64),
                Source::Rotary(field) => {
                    let axis = self.control.rotary_channel_axis(value as i64);
                    self.fill(field, axis.map_or(ROTATION, |axis| ROTARY[axis]).to_owned());
                }
                Source::Laid(_) if self.placed() => {}
                Source::Number(_) => {}
                _ => continue,
            }
            self.said.push(*name);
        }
    }

    /// Whether the places of the call say which corner it is.
    fn placed(&self) -> bool {
        matches!(self.counterpart.layout, Layout::Opposite)
    }

    /// A number that the field takes.
    fn enter(&mut self, name: &'static str, value: f64) {
        let least = self.mask.field(name).map(|field| field.kind);
        let fits = match least {
            Some(Kind::Length(Least::Above)) => value > 0.0,
            Some(Kind::Length(Least::Zero)) => value >= 0.0,
            _ => true,
        };
        if fits {
            self.fill(name, super::value::plain(value));
        }
    }

    fn axis(&mut self, name: &'static str, part: i64) {
        let place = usize::try_from(part - 1).ok().and_then(|place| self.control.plane.axes().get(place).copied());
        if let Some(axis) = place {
            self.fill(name, AXES[axis].to_owned());
        }
    }

    /// The zero offset; a variant that corrects a tool measures only.
    fn target(&mut self, code: i64) {
        let Some(Field { kind: Kind::Offset { turned }, .. }) = self.mask.field("zo") else { return };
        let zero = self.inputs.variant / 100 % 10 == 1;
        let word = word(self.control, code, *turned).filter(|_| zero);
        self.fill("zo", word.unwrap_or_else(|| offset::NONE.to_owned()));
    }

    /// The corner, 1 to 4 counter-clockwise from the lower left: by where the edges lead from it, or where the points
    /// lie.
    fn position(&self) -> usize {
        let of = |name| self.inputs.value(name);
        let (left, lower) = if self.placed() {
            let edges = corner_edges(self.inputs, self.control);
            let [(sine, cosine), (rise, run)] = edges.map(|angle| angle.to_radians().sin_cos());
            (cosine + run > 0.0, sine + rise > 0.0)
        } else {
            let pair = |one, two| (of(one) + of(two)) / 2.0;
            let first = [pair(names::SETV0, names::SETV2), pair(names::SETV1, names::SETV3)];
            let second = [pair(names::SETV4, names::SETV6), pair(names::SETV5, names::SETV7)];
            (second[0] < first[0], first[1] < second[1])
        };
        match (left, lower) {
            (true, true) => 1,
            (false, true) => 2,
            (false, false) => 3,
            (true, false) => 4,
        }
    }

    /// What has no place: values of the call that the mask does not ask for, and what it has to be told besides.
    fn told(&self, typed: &Typed) -> Vec<Message> {
        let mut told = Vec::new();
        let variant = self.inputs.cycle.variant_param();
        let without = self.inputs.cycle.params.iter().filter(|param| {
            let written = typed.get(param.name.as_str()).is_some_and(|text| !text.trim().is_empty());
            written && Some(param.name) != variant && !self.said.contains(&param.name)
        });
        let without: Vec<&str> =
            without.filter(|param| param.need(self.inputs).is_some()).map(|one| one.name.as_str()).collect();
        if self.mask.task.corrects() && self.inputs.variant / 100 % 10 != 1 {
            told.push(Message::new("jog-back-tool"));
        }
        if !without.is_empty() {
            told.push(Message::new("jog-back-without").text("names", without.join(", ")));
        }
        let filled = |name: &str| self.filled.iter().any(|(known, _)| *known == name);
        if self.mask.field("direction").is_some() && !filled("direction") {
            told.push(Message::new("jog-back-direction"));
        }
        if matches!(self.counterpart.layout, Layout::Set | Layout::Middle { .. }) {
            told.push(Message::new("jog-back-position"));
        }
        told
    }
}
