//! User data that definition files add to the control (MGUD, UGUD, SGUD, GUD4 to GUD9): names, types, sizes, first
//! values. Their values are with all others in [`super::Control::data`], as far as one was given or written.

use super::Value;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Type of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// REAL.
    Real,
    /// Whole number of 32 bits.
    Int,
    /// BOOL.
    Bool,
    /// One character, by its code 0..255.
    Char,
    /// Text of at most this many characters.
    Text(usize),
    /// AXIS.
    Axis,
    /// FRAME.
    Frame,
}

/// Longest text that can be declared, characters.
pub const LONGEST: usize = 200;

impl Type {
    /// The type with this name; a `STRING` has the length behind it.
    pub fn named(name: &str, length: Option<f64>) -> Option<Type> {
        Some(match name {
            "REAL" => Type::Real,
            "INT" => Type::Int,
            "BOOL" => Type::Bool,
            "CHAR" => Type::Char,
            "STRING" => Type::Text(length.map_or(LONGEST, |length| (length as usize).min(LONGEST))),
            "AXIS" => Type::Axis,
            "FRAME" => Type::Frame,
            _ => return None,
        })
    }
}

/// Most elements of a datum.
pub const ELEMENTS: usize = 100_000;

/// A datum that a definition file adds.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// Whether every channel has its own (`CHAN`); else there is one for the control (`NCK`).
    pub channel: bool,
    /// What it holds.
    pub kind: Type,
    /// Sizes of an array; empty for a single value.
    pub sizes: Vec<usize>,
    /// What its elements begin with.
    pub first: First,
    /// Attributes: physical unit, limits, protection levels, stop of the preprocessing (`PHU` 24, `APR` 7, `SYNR`).
    pub attributes: Vec<(String, Option<f64>)>,
}

/// First values of a datum.
#[derive(Clone, Debug, PartialEq)]
pub enum First {
    /// Of its elements in their order; what is omitted or not there has none.
    Each(Vec<Option<Value>>),
    /// One for so many elements (`REP`).
    Same(Value, usize),
}

impl First {
    /// The value of an element; none: it has none.
    pub fn begins(&self, element: usize) -> Option<&Value> {
        match self {
            First::Each(values) => values.get(element)?.as_ref(),
            First::Same(value, count) => (element < *count).then_some(value),
        }
    }

    /// How many values are written; none: one is for all elements that there are.
    pub fn counted(&self) -> Option<usize> {
        Some(self.count()).filter(|count| matches!(self, First::Each(_)) || *count < ELEMENTS)
    }

    /// For how many elements it stands.
    pub fn count(&self) -> usize {
        match self {
            First::Each(values) => values.len(),
            First::Same(_, count) => *count,
        }
    }
}

impl Definition {
    /// The value that an element begins with; none: that of its type.
    pub fn begins(&self, element: usize) -> Option<&Value> {
        self.first.begins(element)
    }

    /// How many elements it has.
    pub fn elements(&self) -> usize {
        self.sizes.iter().product()
    }

    /// Whether a text stands for its values in data: `AXIS` has the name of one.
    pub fn text(&self) -> bool {
        matches!(self.kind, Type::Text(_) | Type::Axis)
    }
}

/// Texts that names stand for (`DEFINE NAME AS …`), by name in upper case.
pub type Macros = BTreeMap<String, Vec<u8>>;

/// All of them, and the lines that say so.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Definitions {
    /// The lines with `DEF`, `REDEF` and `DEFINE`, as they are written, without block numbers.
    pub lines: Vec<String>,
    /// By name in upper case.
    pub data: BTreeMap<String, Definition>,
    /// Sizes of arrays of the measuring cycles, which are on every control, as the lines have them.
    pub sizes: BTreeMap<String, Vec<usize>>,
    /// The macros.
    pub macros: Arc<Macros>,
}

impl Definitions {
    /// A datum by its name without index, in upper case.
    pub fn find(&self, name: &str) -> Option<&Definition> {
        self.data.get(name)
    }

    /// Takes others too. One of the same name takes the place of the earlier one.
    pub fn extend(&mut self, other: Definitions) {
        self.lines.extend(other.lines);
        self.data.extend(other.data);
        self.sizes.extend(other.sizes);
        if !other.macros.is_empty() {
            let own = other.macros.iter().map(|(name, text)| (name.clone(), text.clone()));
            Arc::make_mut(&mut self.macros).extend(own);
        }
    }

    /// Takes those of a file that may be there already: the same line is there once.
    pub fn add(&mut self, mut other: Definitions) {
        other.lines.retain(|line| !self.lines.contains(line));
        self.extend(other);
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }
}
