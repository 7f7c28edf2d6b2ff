//! A parameter of an entry: what can be entered, in which unit and range, when it is needed.

use super::{Inputs, When};
use crate::name::Name;
use crate::range::Range;

/// A parameter of a cycle.
pub struct Param {
    /// As the manual writes it: `_SETVAL`, `_SETV[0]`, `D`.
    pub name: Name,
    /// Stem of its message keys: `setval` → `param-setval` and `param-setval-help`; see [`Param::labels`].
    pub key: &'static str,
    /// What can be entered.
    pub kind: Kind,
    /// Unit and in which unit system it counts.
    pub unit: Unit,
    /// Value when it is not written; `None`: it has to be.
    pub default: Option<f64>,
    /// Default in inch, where the manual gives a round value of its own (NCT: 5 mm or 0.2 inch, C:94).
    pub default_inch: Option<f64>,
    /// Outside of this the control alarms (or the call makes no sense).
    pub range: Range,
    /// Outside of this a colleague would ask.
    pub usual: Range,
    /// It only watches a deviation: what is larger than any machine switches that off.
    pub watches: bool,
    /// Alarm (or message) for a value outside `range` or missing.
    pub alarm: Option<crate::diagnostic::Code>,
    /// First rule that holds decides; none: not used.
    pub needs: &'static [Need],
    /// Variants that are chosen by giving it (even 0), in a cycle that has no parameter for the variant (NCT: the
    /// address of the tool axis makes a boss out of a bore). The first that holds counts.
    pub chooses: &'static [Chooses],
    /// Wording that differs by variant: stem of the first that holds, else [`Param::key`].
    pub labels: &'static [(When, &'static str)],
    /// As typed in a worked measurement of the cycle; empty: not given there.
    pub example: &'static str,
    /// How a text is read that lists columns; none: it is no such list.
    pub columns: Option<super::ReadColumns>,
    /// Place in the manual.
    pub source: &'static str,
}

/// A variant that an address chooses.
pub struct Chooses {
    /// Where it does so.
    pub when: When,
    /// Number of the variant.
    pub variant: i64,
    /// A value as typed that does it.
    pub typed: &'static str,
}

/// What can be entered.
pub enum Kind {
    /// Real number.
    Real,
    /// Whole number.
    Integer,
    /// One of these numbers, each with the key of its name.
    Choice(&'static [(i64, &'static str)]),
    /// A choice that other values decide: the first list whose condition holds.
    ChoiceBy(&'static [(When, &'static [(i64, &'static str)])]),
    /// One of these numbers, without a unit, in the variants for which the condition holds; else a real number.
    ChoiceIf(When, &'static [(i64, &'static str)]),
    /// The measuring variant: choices are the cycle's variants; where its digits are choices of their own, the groups.
    Variant(&'static [DigitGroup]),
    /// A number whose digits are choices of their own.
    Digits(&'static [DigitGroup]),
    /// Correction target `_KNUM`: a tool offset code or a zero offset code, decided by the variant.
    Knum,
    /// Text of at most this many characters.
    Text(usize),
}

/// A group of digits of a coded number.
pub struct DigitGroup {
    /// Key of its name.
    pub key: &'static str,
    /// Value of its lowest digit: 1, 10, 100, …
    pub place: i64,
    /// How many digits.
    pub digits: u32,
    /// Named values; empty: any number of that many digits.
    pub choices: &'static [(i64, &'static str)],
    /// Other names of a value where a condition holds: the first that holds.
    pub renamed: &'static [(When, i64, &'static str)],
    /// Where the digits have an effect: they are asked for there alone.
    pub when: When,
}

impl DigitGroup {
    /// One digit with a name for each number that it can be.
    pub const fn one(key: &'static str, place: i64, choices: &'static [(i64, &'static str)]) -> DigitGroup {
        DigitGroup { choices, ..DigitGroup::number(key, place, 1) }
    }

    /// A number of so many digits.
    pub const fn number(key: &'static str, place: i64, digits: u32) -> DigitGroup {
        DigitGroup { key, place, digits, choices: &[], renamed: &[], when: When::Always }
    }

    /// What the group is in a number.
    pub fn value(&self, number: i64) -> i64 {
        number / self.place % 10_i64.pow(self.digits)
    }

    /// Key of the choice that it is there; none where no choice has a name.
    pub fn choice(&self, number: i64) -> Option<&'static str> {
        let value = self.value(number);
        self.choices.iter().find(|(choice, _)| *choice == value).map(|(_, key)| *key)
    }

    /// Its named values with these inputs, each with the key of its name.
    pub fn choices_with(&self, inputs: &Inputs) -> Vec<(i64, &'static str)> {
        let named = |value: i64| self.renamed.iter().find(|(when, of, _)| *of == value && when.holds(inputs));
        let name = |(value, key): &(i64, &'static str)| (*value, named(*value).map_or(*key, |(_, _, other)| *other));
        self.choices.iter().map(name).collect()
    }
}

/// Unit of a parameter and the system it counts in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Unit {
    /// No unit.
    #[serde(rename = "")]
    None,
    /// mm or inch by the active G70/G71/G700/G710 (NCT: G20/G21).
    #[serde(rename = "active length")]
    ActiveLength,
    /// mm or inch by the basic system of the machine.
    #[serde(rename = "basic length")]
    BasicLength,
    /// Always mm, also on an inch machine (`_FA`).
    #[serde(rename = "mm")]
    Millimetre,
    /// Degree.
    #[serde(rename = "deg")]
    Degree,
    /// mm/min or inch/min by the basic system (NCT: active system).
    #[serde(rename = "basic feed")]
    BasicFeed,
}

/// Whether a parameter is needed, under a condition.
pub struct Need {
    /// Condition.
    pub when: When,
    /// Consequence.
    pub level: Level,
    /// Key of the reason, shown at the field (`need-tool-offset`).
    pub reason: &'static str,
}

/// How much a parameter is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Has to be given.
    Required,
    /// May be given.
    Optional,
}

/// Third digit of `_PRNUM`.
pub const PROBE_TYPE: DigitGroup = DigitGroup::one("prnum-type", 100, &[(0, "prnum-multi"), (1, "prnum-mono")]);
