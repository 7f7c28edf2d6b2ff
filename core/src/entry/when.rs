//! A condition on the values of a call, and whether it holds.

use super::{Kind, Level, Param, Unit};
use crate::control::{Control, Units, gud};
use crate::entry::{Inputs, delivered_factor};
use crate::name::Name;

/// A condition on the values of a call. Data, so that docs can print it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// Always.
    Always,
    /// The measuring variant is one of these.
    Variant(&'static [i64]),
    /// The number of this parameter, divided by `place` (whole), modulo 10, is one of these.
    Digit {
        /// Parameter.
        param: Name,
        /// 1, 10, 100, …
        place: i64,
        /// Accepted digits.
        is: &'static [i64],
    },
    /// The parameter is given and not zero (a text: not empty).
    Given(Name),
    /// The number of this parameter is one of these.
    Number {
        /// Parameter.
        param: Name,
        /// Accepted numbers.
        is: &'static [f64],
    },
    /// The number of this parameter is larger.
    Above {
        /// Parameter.
        param: Name,
        /// Than this.
        than: f64,
    },
    /// A datum of the machine, one of [`Cycle::settings`](super::Cycle::settings), has one of these values; unset data
    /// are 0.
    Setting {
        /// Datum.
        name: &'static str,
        /// Accepted numbers.
        is: &'static [f64],
    },
    /// The type of the tool in use (`$TC_DP1`) lies between these numbers, both included.
    ToolType(i64, i64),
    /// The working plane is this one.
    Plane(crate::control::Plane),
    /// Positions of X are diameters at the call (DIAMON, DIAM90).
    Diameters,
    /// All of these.
    All(&'static [When]),
    /// One of these.
    Any(&'static [When]),
    /// Not this.
    Not(&'static When),
}

/// A condition that does not hold.
pub const NEVER: When = When::Any(&[]);

impl When {
    /// Whether it holds. A number that is not given counts as 0.
    pub fn holds(&self, inputs: &Inputs) -> bool {
        match self {
            When::Always => true,
            When::Variant(numbers) => numbers.contains(&inputs.variant),
            When::Digit { param, place, is } => is.contains(&digit(inputs, *param, *place)),
            When::Given(param) => inputs.value(*param) != 0.0 || !inputs.text(*param).is_empty(),
            When::Number { param, is } => is.contains(&inputs.value(*param)),
            When::Above { param, than } => inputs.value(*param) > *than,
            When::Setting { name, is } => is.contains(&inputs.settings.get(name).copied().unwrap_or(0.0)),
            When::ToolType(from, to) => (*from..=*to).contains(&inputs.tool_type),
            When::Plane(plane) => inputs.plane == *plane,
            When::Diameters => inputs.diameters,
            When::All(conditions) => conditions.iter().all(|when| when.holds(inputs)),
            When::Any(conditions) => conditions.iter().any(|when| when.holds(inputs)),
            When::Not(when) => !when.holds(inputs),
        }
    }

    /// What the variant alone says about it; none where it depends on other values.
    pub fn of_variant(&self, inputs: &Inputs) -> Option<bool> {
        match self {
            When::Always | When::Variant(_) => Some(self.holds(inputs)),
            When::Digit { param, .. } if inputs.cycle.variant_param() == Some(*param) => Some(self.holds(inputs)),
            When::All(conditions) => decided(conditions, inputs, false),
            When::Any(conditions) => decided(conditions, inputs, true),
            When::Not(when) => when.of_variant(inputs).map(|holds| !holds),
            _ => None,
        }
    }
}

/// One that is `decisive` decides; else all have to be known.
fn decided(conditions: &[When], inputs: &Inputs, decisive: bool) -> Option<bool> {
    let mut known = Some(!decisive);
    for when in conditions {
        match when.of_variant(inputs) {
            Some(holds) if holds == decisive => return Some(decisive),
            Some(_) => {}
            None => known = None,
        }
    }
    known
}

/// One digit; those of `_KNUM` above its D number move by two where D numbers take five digits (B:2009).
fn digit(inputs: &Inputs, name: Name, place: i64) -> i64 {
    let kind = inputs.cycle.params.iter().find(|param| param.name == name).map(|param| &param.kind);
    let number = inputs.number(name) as i64;
    match kind {
        Some(Kind::Variant(_)) => inputs.variant / place % 10,
        Some(Kind::Knum) if inputs.five_digit_edges && place >= 1000 => number / (place * 100) % 10,
        _ => number / place % 10,
    }
}

impl Kind {
    /// The numbers that can be chosen with these values, each with the key of its name; none where any can be entered.
    pub fn choices(&self, inputs: &Inputs) -> Option<&'static [(i64, &'static str)]> {
        match self {
            Kind::Choice(choices) => Some(choices),
            Kind::ChoiceBy(lists) => {
                let list = lists.iter().find(|(when, _)| when.holds(inputs));
                Some(list.map_or(&[], |(_, choices)| choices))
            }
            Kind::ChoiceIf(when, choices) => when.holds(inputs).then_some(*choices),
            _ => None,
        }
    }
}

impl Param {
    /// Whether it is needed with these values, and why; none: not used.
    pub fn need(&self, inputs: &Inputs) -> Option<(Level, &'static str)> {
        self.needs.iter().find(|need| need.when.holds(inputs)).map(|need| (need.level, need.reason))
    }

    /// Whether the variant asks for it, on some machine, with some tool and some other values.
    pub fn is_known(&self, inputs: &Inputs) -> bool {
        self.needs.iter().any(|need| need.when.of_variant(inputs) != Some(false))
    }

    /// Unit with these values: a selection has none.
    pub fn unit_with(&self, inputs: &Inputs) -> Unit {
        match &self.kind {
            Kind::ChoiceIf(when, _) if when.holds(inputs) => Unit::None,
            _ => self.unit,
        }
    }

    /// Whether it is in the data of the machine, and a call may write it there (`_MFS[0]`).
    pub fn is_machine_datum(&self) -> bool {
        gud::named(self.name.as_str()).is_some_and(gud::Gud::of_machine)
    }

    /// Value when it is not written, as it would be typed on this control.
    pub fn fallback(&self, control: &Control) -> Option<f64> {
        let number = !matches!(self.kind, Kind::Text(_));
        if number && self.default.is_none() && self.is_machine_datum() {
            return Some(control.number(self.name.as_str()));
        }
        if control.active_units == Units::Inch && self.default_inch.is_some() {
            return self.default_inch;
        }
        Some(self.default? / delivered_factor(self.unit, control))
    }

    /// Stem of its message keys with these values.
    pub fn label(&self, inputs: &Inputs) -> &'static str {
        self.labels.iter().find(|(when, _)| when.holds(inputs)).map_or(self.key, |(_, key)| key)
    }
}
