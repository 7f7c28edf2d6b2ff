//! The limits of a form, which a deviation is held against, as bars over one scale that can be drawn wider and
//! narrower.

use super::Field;
use crate::control::Control;
use crate::entry::{Inputs, Topic, address, factor, names};
use crate::evaluate::symmetry::symmetric;
use crate::message::Message;
use crate::name::Name;
use serde::Serialize;

/// The limits of a form. Places are mm, or degrees where the limits are angles, from the setpoint.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Chain {
    /// The scale reaches so far on both sides.
    pub end: f64,
    /// Up to about here the scale is even, beyond it ever closer: the widest limit may be a hundred times the
    /// narrowest.
    pub bend: f64,
    /// A bar each, in the order in which a deviation is compared: the widest first.
    pub bars: Vec<Bar>,
}

/// A bar between two limits, or of one limit to both sides.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ChainBar"))]
pub struct Bar {
    /// Place from which its limits count.
    pub zero: f64,
    /// One that counts to both sides, or the lower and the upper one.
    pub limits: Vec<Limit>,
}

/// An end of a bar. Its figures are in the unit of its field.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ChainLimit", optional_fields))]
pub struct Limit {
    /// Parameter.
    pub name: Name,
    /// Its name in words.
    pub label: Message,
    /// Unit of its field.
    pub unit: &'static str,
    /// mm in one of that unit.
    pub per: f64,
    /// What it is: what was entered, else what counts then.
    pub value: f64,
    /// Least value that keeps the order of the limits.
    pub least: f64,
    /// Greatest one; none: any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// Smallest difference that matters.
    pub step: f64,
}

/// The scale reaches beyond the widest limit by this factor.
const BEYOND: f64 = 1.3;
/// Smallest difference of a limit, mm or degree; an inch is long.
const STEP: f64 = 0.001;
const STEP_INCH: f64 = 0.0001;

/// The chain of the limits that a form asks for; none where it has none whose value is known.
pub fn chain(fields: &[Field], inputs: &Inputs, control: &Control) -> Option<Chain> {
    let limits = Limits { fields, inputs, control };
    let mut bars: Vec<Bar> = Vec::new();
    let band = limits.band();
    let middle = band.map_or(0.0, |[lower, upper]| rounded(symmetric(0.0, upper, lower).setpoint));
    let both = |name| limits.both(name, middle);
    bars.extend([names::TSA, names::TDIF].into_iter().filter_map(both));
    bars.extend(band.and_then(|band| limits.tolerances(band)));
    bars.extend([names::TMV, names::TZL, address::U, address::H].into_iter().filter_map(both));
    let place = |bar: &Bar, limit: &Limit| bar.zero.abs() + (limit.value * limit.per).abs();
    let all = bars.iter().flat_map(|bar| bar.limits.iter().map(move |limit| place(bar, limit)));
    let widest = all.fold(0.0, f64::max);
    let half = band.map(|[lower, upper]| (upper - lower) / 2.0).filter(|half| *half > 0.0);
    let bend = half.unwrap_or(widest) / 2.0;
    (widest > 0.0 && widest.is_finite()).then_some(Chain { end: BEYOND * widest, bend, bars })
}

struct Limits<'a> {
    fields: &'a [Field],
    inputs: &'a Inputs,
    control: &'a Control,
}

impl Limits<'_> {
    /// What a limit is worth, mm or degree, where the form asks for it.
    fn worth(&self, name: Name) -> Option<f64> {
        let asked = self.fields.iter().any(|field| field.name == name && field.topic == Topic::Tolerances);
        self.inputs.any(name).filter(|value| asked && value.is_finite())
    }

    /// The lower and the upper tolerance.
    fn band(&self) -> Option<[f64; 2]> {
        Some([self.worth(names::TLL)?, self.worth(names::TUL)?])
    }

    /// A limit of the form between two places, mm; none: as far as one likes.
    fn limit(&self, name: Name, least: f64, most: Option<f64>) -> Option<Limit> {
        let field = self.fields.iter().find(|field| field.name == name)?;
        let param = self.inputs.cycle.param(name.as_str())?;
        let per = factor(param.unit_with(self.inputs), self.control);
        let value = self.worth(name)?;
        Some(Limit {
            name,
            label: field.label.clone(),
            unit: field.unit,
            per,
            value: rounded(value / per),
            // one that is out of order already stays there until it is drawn
            least: rounded(least.min(value) / per),
            most: most.map(|most| rounded(most.max(value) / per)),
            step: if field.unit == "inch" { STEP_INCH } else { STEP },
        })
    }

    /// A limit to both sides, within what is wider and around what is narrower (B:1310-1394).
    fn both(&self, name: Name, middle: f64) -> Option<Bar> {
        let half = self.band().map(|[lower, upper]| (upper - lower) / 2.0);
        let worth = |name| self.worth(name);
        let (narrower, wider) = if name == names::TSA {
            (worth(names::TDIF).or(half), None)
        } else if name == names::TDIF {
            (half, worth(names::TSA))
        } else if name == names::TMV {
            (worth(names::TZL), half)
        } else if name == names::TZL {
            (None, worth(names::TMV).or(worth(names::TDIF)))
        } else {
            (None, None)
        };
        let open = self.inputs.cycle.param(name.as_str()).is_some_and(|param| !param.range.contains(0.0));
        let least = narrower.unwrap_or(0.0).max(if open { STEP } else { 0.0 });
        Some(Bar { zero: middle, limits: vec![self.limit(name, least, wider)?] })
    }

    /// Both tolerances: the upper above the lower, the band between them within the difference.
    fn tolerances(&self, [lower, upper]: [f64; 2]) -> Option<Bar> {
        let widest = self.worth(names::TDIF).or(self.worth(names::TSA)).map(|value| 2.0 * value);
        let below = self.limit(names::TLL, widest.map_or(f64::MIN, |widest| upper - widest), Some(upper))?;
        let above = self.limit(names::TUL, lower, widest.map(|widest| lower + widest))?;
        Some(Bar { zero: 0.0, limits: vec![below, above] })
    }
}

/// Without what a conversion of units leaves in the last digits.
fn rounded(value: f64) -> f64 {
    const DIGITS: f64 = 1e9;
    if value.abs() < 1e6 { (value * DIGITS).round() / DIGITS } else { value }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::catalogue::find;
    use crate::check;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::entry::Typed;
    use crate::form::fields;

    fn of(dialect: Dialect, cycle: &str, values: &[(&str, &str)]) -> Option<Chain> {
        let cycle = find(dialect, cycle).unwrap();
        let typed: Typed = values.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        let control = delivery(dialect);
        let inputs = check::read(cycle, &typed, &control, &mut Vec::new());
        chain(&fields(cycle, &typed, &control), &inputs, &control)
    }

    /// Name, value, least and most.
    type Told<'a> = (&'a str, f64, f64, Option<f64>);

    fn told(chain: &Chain) -> Vec<(f64, Vec<Told<'_>>)> {
        let limit = |limit: &Limit| (limit.name, limit.value, limit.least, limit.most);
        let bars = chain.bars.iter().map(|bar| (bar.zero, bar.limits.iter().map(limit)));
        bars.map(|(zero, all)| (zero, all.map(|(name, v, a, b)| (name.as_str(), v, a, b)).collect())).collect()
    }

    const TOOL: [(&str, &str); 4] = [("_MVAR", "1"), ("_SETVAL", "50"), ("_TSA", "1"), ("_TDIF", "0.06")];

    // oracle: manual B:1310-1394 (the order of the limits), B:2205 (they count from the middle of the tolerances)
    #[test]
    fn the_limits_of_a_tool_offset_are_a_chain() {
        let mut values = TOOL.to_vec();
        values.extend([("_TUL", "0.03"), ("_TLL", "-0.01"), ("_TMV", "0.015"), ("_TZL", "0.01")]);
        let chain = of(Dialect::Sinumerik, "CYCLE977", &values).unwrap();
        assert_eq!(
            told(&chain),
            [
                (0.01, vec![("_TSA", 1.0, 0.06, None)]),
                (0.01, vec![("_TDIF", 0.06, 0.02, Some(1.0))]),
                (0.0, vec![("_TLL", -0.01, -0.09, Some(0.03)), ("_TUL", 0.03, -0.01, Some(0.11))]),
                (0.01, vec![("_TMV", 0.015, 0.01, Some(0.02))]),
                (0.01, vec![("_TZL", 0.01, 0.0, Some(0.015))]),
            ]
        );
        assert!((chain.bend - 0.01).abs() < 1e-9 && (chain.end - 1.313).abs() < 1e-9);
    }

    // oracle: hand (what is delivered counts while nothing is typed; what is out of order stays until it is drawn)
    #[test]
    fn what_is_not_typed_counts_as_delivered() {
        let chain = of(Dialect::Sinumerik, "CYCLE977", &[("_MVAR", "1"), ("_TUL", "3")]).unwrap();
        let [_, difference, tolerances, ..] = &told(&chain)[..] else { unreachable!() };
        assert_eq!(difference.1, [("_TDIF", 1.2, 1.2, Some(2.0))]);
        assert_eq!(tolerances.1, [("_TLL", -1.0, -1.0, Some(3.0)), ("_TUL", 3.0, -1.0, Some(3.0))]);
    }

    // oracle: hand (a zero offset has the safe area alone, a macro its own limits, an expression no place)
    #[test]
    fn a_form_has_the_limits_that_it_asks_for() {
        let zero = of(Dialect::Sinumerik, "CYCLE977", &[("_MVAR", "101"), ("_TSA", "0.5")]).unwrap();
        assert_eq!(told(&zero), [(0.0, vec![("_TSA", 0.5, 0.001, None)])]);
        assert_eq!(of(Dialect::Sinumerik, "CYCLE977", &[("_MVAR", "101"), ("_TSA", "R5")]), None);
        let nct = of(Dialect::Nct, "G105", &[("H", "0.1")]).unwrap();
        assert_eq!(told(&nct), [(0.0, vec![("H", 0.1, 0.0, None)])]);
    }
}
