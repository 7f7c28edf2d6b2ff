//! What one element of a datum means, or a row of them.

use crate::range::Range;

/// Where the system of units of a length comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// Active G70, G71, G700 or G710.
    Active,
    /// Basic system of the machine (B:1787-1795).
    Basic,
    /// Always metric.
    Metric,
}

/// Unit of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// No unit, or a code.
    None,
    /// mm or inch.
    Length(System),
    /// mm/min or inch/min.
    Feed(System),
    /// m/min or feet/min (B:13498).
    Speed(System),
    /// Degree.
    Degree,
    /// Revolutions a minute.
    Rpm,
    /// Percent.
    Percent,
}

/// A length in the active system.
pub(super) const ACTIVE: Unit = Unit::Length(System::Active);
/// A length in the basic system.
pub(in crate::control) const LENGTH: Unit = Unit::Length(System::Basic);
/// A feed in the basic system.
pub(in crate::control) const FEED: Unit = Unit::Feed(System::Basic);
/// A cutting speed in the basic system.
pub(super) const SPEED: Unit = Unit::Speed(System::Basic);
pub(super) const MM: Unit = Unit::Length(System::Metric);
pub(super) const MM_MIN: Unit = Unit::Feed(System::Metric);
pub(super) const M_MIN: Unit = Unit::Speed(System::Metric);

/// Value as delivered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Initial {
    /// In metric units, whatever the basic system is.
    Number(f64),
    /// A text.
    Text(&'static str),
}

/// One element of a datum, or a row of elements that mean the same.
#[derive(Clone, Copy, Debug)]
pub struct Element {
    /// Indices as the manual prints them: `k,0` (any field, second index 0), `1..5,0`; empty for a single value.
    pub index: &'static str,
    /// The same, read.
    indices: [Option<Index>; DIMENSIONS],
    /// Value as delivered. Parameters of a call have theirs in the catalogue.
    pub initial: Initial,
    /// Unit.
    pub unit: Unit,
    /// What is allowed.
    pub range: Range,
    /// Values that can be chosen, where there is nothing between them; their words are attributes `.v` and the value.
    pub choices: &'static [i64],
    /// Whether the cycles keep it for themselves, or nothing uses it.
    pub internal: bool,
    /// Place in the manual.
    pub source: &'static str,
}

/// Most indices of an array.
const DIMENSIONS: usize = 2;

/// One index of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Index {
    /// Every one: the number of a field.
    Any,
    /// From here to there.
    At(usize, usize),
}

pub(in crate::control) const fn element(index: &'static str, source: &'static str) -> Element {
    Element {
        index,
        indices: indices(index),
        initial: Initial::Number(0.0),
        unit: Unit::None,
        range: Range::ANY,
        choices: &[],
        internal: false,
        source,
    }
}

/// Indices as the manual prints them, read while this is compiled: data are looked up by them at every keystroke.
const fn indices(printed: &str) -> [Option<Index>; DIMENSIONS] {
    let text = printed.as_bytes();
    let mut read = [None; DIMENSIONS];
    let (mut dimension, mut at) = (0, 0);
    while at < text.len() {
        let (from, behind) = number(text, at);
        let (to, end) = match (behind < text.len() && text[behind] == b'.', from) {
            (true, Some(_)) => number(text, behind + "..".len()),
            _ => (from, behind),
        };
        read[dimension] = match (from, to) {
            (Some(from), Some(to)) => Some(Index::At(from, to)),
            _ => Some(Index::Any),
        };
        dimension += 1;
        at = end + ",".len();
    }
    read
}

/// The number from this place on, and where it ends; none: a letter, which stands for every number.
const fn number(text: &[u8], mut at: usize) -> (Option<usize>, usize) {
    if !text[at].is_ascii_digit() {
        return (None, at + 1);
    }
    let mut number = 0;
    while at < text.len() && text[at].is_ascii_digit() {
        number = number * 10 + (text[at] - b'0') as usize;
        at += 1;
    }
    (Some(number), at)
}

impl Element {
    /// Whether it may have this value.
    pub fn takes(&self, value: f64) -> bool {
        let chosen = self.choices.is_empty() || self.choices.iter().any(|choice| *choice as f64 == value);
        self.range.contains(value) && chosen
    }

    pub(in crate::control) const fn initial(self, value: f64) -> Element {
        Element { initial: Initial::Number(value), ..self }
    }

    pub(super) const fn text(self, value: &'static str) -> Element {
        Element { initial: Initial::Text(value), ..self }
    }

    pub(in crate::control) const fn unit(self, unit: Unit) -> Element {
        Element { unit, ..self }
    }

    pub(in crate::control) const fn between(self, min: f64, max: f64) -> Element {
        Element { range: Range::closed(min, max), ..self }
    }

    pub(in crate::control) const fn positive(self) -> Element {
        Element { range: Range::POSITIVE, ..self }
    }

    pub(super) const fn not_negative(self) -> Element {
        Element { range: Range::NOT_NEGATIVE, ..self }
    }

    pub(in crate::control) const fn choices(self, choices: &'static [i64]) -> Element {
        Element { choices, ..self }
    }

    pub(in crate::control) const fn switch(self) -> Element {
        self.choices(&[0, 1])
    }

    pub(super) const fn internal(self) -> Element {
        Element { internal: true, ..self }
    }

    pub(super) fn indices(&self) -> impl Iterator<Item = Index> {
        self.indices.into_iter().flatten()
    }

    /// Whether it stands for the element at these indices.
    pub(super) fn covers(&self, at: &[usize]) -> bool {
        let fits = |(index, i): (Index, &usize)| match index {
            Index::Any => true,
            Index::At(from, to) => (from..=to).contains(i),
        };
        self.indices().count() == at.len() && self.indices().zip(at).all(fits)
    }
}
