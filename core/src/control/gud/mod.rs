//! User data of a SINUMERIK control with measuring cycles: one table, a file a subject. Names, sizes, delivered values,
//! units and ranges are read from here by everything else (B:1744-1838, B:13097-13247, B:14170-14305).

mod element;
mod jog;
mod logging;
mod parameters;
mod probes;
mod settings;
mod switches;
#[cfg(test)]
mod tests;

use super::arrays;
use Kind::{Bool, Frame, Integer, Real, Text};
use element::{ACTIVE, Index, M_MIN, MM, MM_MIN, SPEED};
pub use element::{Element, Initial, System, Unit};
pub(super) use element::{FEED, LENGTH, element};
use std::sync::OnceLock;

/// Data block in which a datum is defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Block {
    /// Parameters and results of a call.
    Gud5,
    /// Settings of the machine builder.
    Gud6,
    /// Measuring in JOG.
    Gud7,
}

/// What a datum holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// REAL.
    Real,
    /// INT.
    Integer,
    /// BOOL.
    Bool,
    /// STRING or CHAR.
    Text,
    /// FRAME.
    Frame,
}

impl Kind {
    /// As a program defines it.
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Real => "REAL",
            Kind::Integer => "INT",
            Kind::Bool => "BOOL",
            Kind::Text => "STRING",
            Kind::Frame => "FRAME",
        }
    }
}

/// A datum of the blocks GUD5, GUD6 and GUD7.
pub struct Gud {
    /// Name without index.
    pub name: &'static str,
    /// Block.
    pub block: Block,
    /// Whether every channel has its own (CHAN); else there is one for the control (NCK).
    pub channel: bool,
    /// What it holds.
    pub kind: Kind,
    /// Sizes of the array, the largest that the manual allows; empty for a single value.
    pub sizes: &'static [usize],
    /// The datum that tells how many elements there are really in the first dimension; empty: as `sizes` says.
    pub counted: &'static str,
    /// What its elements mean.
    pub elements: &'static [Element],
}

/// Data of one subject.
pub struct Subject<D: 'static = Gud> {
    /// Key of its name in the message files: `machine-group-` and this.
    pub key: &'static str,
    /// Data of the subject.
    pub data: &'static [D],
}

pub(super) const fn subject<D>(key: &'static str, data: &'static [D]) -> Subject<D> {
    Subject { key, data }
}

/// Key of the subject of the support in the program editor.
pub const MASKS: &str = "masks";
/// Key of the subject with the data of measuring in JOG.
pub const JOG: &str = "jog";

/// Everything, in the order in which it is shown.
pub const SUBJECTS: &[Subject] = &[
    subject("fields", probes::FIELDS),
    subject("workpiece-probes", probes::OF_WORKPIECES),
    subject("tool-probes", probes::OF_TOOLS),
    subject("switches", switches::DATA),
    subject("channel-switches", switches::OF_CHANNEL),
    subject("speeds", settings::SPEEDS),
    subject("tool-measuring", settings::TOOL_MEASURING),
    subject("memories", settings::MEMORIES),
    subject(MASKS, settings::MASKS),
    subject("logging", logging::DATA),
    subject("simulation", settings::SIMULATION),
    subject(JOG, jog::DATA),
    subject("jog-settings", jog::SETTINGS),
    subject("parameters", parameters::DATA),
    subject("results", parameters::RESULTS),
];

const fn gud(block: Block, channel: bool, name: &'static str, kind: Kind, sizes: &'static [usize]) -> Gud {
    Gud { name, block, channel, kind, sizes, counted: "", elements: &[] }
}

const fn gud5(name: &'static str, kind: Kind, sizes: &'static [usize]) -> Gud {
    gud(Block::Gud5, true, name, kind, sizes)
}

const fn gud6(name: &'static str, kind: Kind, sizes: &'static [usize]) -> Gud {
    gud(Block::Gud6, false, name, kind, sizes)
}

const fn gud7(name: &'static str, kind: Kind, sizes: &'static [usize]) -> Gud {
    gud(Block::Gud7, true, name, kind, sizes)
}

impl Gud {
    const fn channel(self) -> Gud {
        Gud { channel: true, ..self }
    }

    const fn counted(self, counted: &'static str) -> Gud {
        Gud { counted, ..self }
    }

    const fn elements(self, elements: &'static [Element]) -> Gud {
        Gud { elements, ..self }
    }

    /// Whether it belongs to the machine and not to a call: settings, and the memories of block GUD5.
    pub fn of_machine(&self) -> bool {
        self.block != Block::Gud5 || !self.counted.is_empty()
    }

    /// Whether it holds text.
    pub fn text(&self) -> bool {
        self.kind == Kind::Text
    }

    /// The element at these indices.
    pub fn element(&self, at: &[usize]) -> Option<&'static Element> {
        self.elements.iter().find(|one| one.covers(at))
    }

    /// Key of the words for an element: `_WP[k,0]` has `datum-wp-0`, a range of elements that of its first.
    pub fn key(&self, element: &Element) -> String {
        let stem = self.name.trim_matches('_').to_lowercase().replace('_', "-");
        let numbers =
            element.indices().filter_map(|index| if let Index::At(from, _) = index { Some(from) } else { None });
        numbers.fold(format!("datum-{stem}"), |key, number| format!("{key}-{number}"))
    }

    /// Name of an element as a program writes it.
    pub fn spelled(&self, at: &[usize]) -> String {
        if at.is_empty() { self.name.to_owned() } else { arrays::spelled(self.name, at) }
    }

    /// Every place that an element stands for, with `first` fields in the first dimension where these are counted.
    pub fn places(&self, element: &Element, first: usize) -> Vec<Vec<usize>> {
        let mut places = vec![Vec::new()];
        for (dimension, (index, size)) in element.indices().zip(self.sizes).enumerate() {
            let most = match dimension {
                0 if !self.counted.is_empty() => first.min(*size),
                _ => *size,
            };
            let (from, to) = match index {
                Index::Any => (0, most),
                Index::At(from, last) => (from, most.min(last + 1)),
            };
            places =
                places.iter().flat_map(|place| (from..to).map(move |i| [place.as_slice(), &[i]].concat())).collect();
        }
        places
    }
}

/// All data, in the order of [`SUBJECTS`].
pub fn all() -> impl Iterator<Item = &'static Gud> {
    SUBJECTS.iter().flat_map(|subject| subject.data)
}

/// A datum by its name in upper case.
pub fn find(name: &str) -> Option<&'static Gud> {
    static BY_NAME: OnceLock<Vec<&Gud>> = OnceLock::new();
    let sorted = BY_NAME.get_or_init(|| {
        let mut sorted: Vec<&Gud> = all().collect();
        sorted.sort_unstable_by_key(|gud| gud.name);
        sorted
    });
    sorted.binary_search_by_key(&name, |gud| gud.name).ok().map(|at| sorted[at])
}

/// A datum by its name with its index, which lies inside of the array: `_WP[0,1]`.
pub fn named(name: &str) -> Option<&'static Gud> {
    place(name).map(|(gud, _)| gud)
}

/// A datum and the indices in its name.
pub fn place(name: &str) -> Option<(&'static Gud, Vec<usize>)> {
    let (stem, at) = arrays::split(name)?;
    let gud = find(stem)?;
    let inside = at.len() == gud.sizes.len() && at.iter().zip(gud.sizes).all(|(i, size)| i < size);
    inside.then_some((gud, at))
}
