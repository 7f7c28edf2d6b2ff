//! The help page of a measuring variant: lines in five sections that the entry lists, each for the variants of which it
//! is true, and what follows from the rest of the entry: values that have to be given, alarms that can come.

use super::{ProbeUse, When, names};

/// A section of a help page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    /// What it measures or does.
    Measures,
    /// Where the probe or the tool stands before, and what else must be so.
    Before,
    /// What happens, in order.
    Order,
    /// What it corrects or leaves.
    Corrects,
    /// What goes wrong.
    Wrong,
}

impl Section {
    /// Key of its heading where this probe is used: what touches nothing measures and corrects nothing by itself.
    pub fn key(self, probe: ProbeUse) -> &'static str {
        match self {
            Section::Measures if !probe.measures() => "help-section-does",
            Section::Measures => "help-section-measures",
            Section::Before if !probe.measures() => "help-section-before-call",
            Section::Before if probe == ProbeUse::Tool => "help-section-before-tool",
            Section::Before => "help-section-before",
            Section::Order => "help-section-order",
            Section::Corrects if !probe.measures() => "help-section-leaves",
            Section::Corrects => "help-section-corrects",
            Section::Wrong => "help-section-wrong",
        }
    }
}

/// All sections, in the order in which they are read.
pub const SECTIONS: [Section; 5] =
    [Section::Measures, Section::Before, Section::Order, Section::Corrects, Section::Wrong];

/// A sentence or two of a help page.
pub struct HelpLine {
    /// Where it stands.
    pub section: Section,
    /// Variants of which it is true: a condition on the variant alone.
    pub when: When,
    /// Key of its words.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// What it measures.
pub const fn measures(when: When, key: &'static str, source: &'static str) -> HelpLine {
    line(Section::Measures, when, key, source)
}

/// Where the probe or the tool stands before.
pub const fn before(when: When, key: &'static str, source: &'static str) -> HelpLine {
    line(Section::Before, when, key, source)
}

/// What happens, in order.
pub const fn order(when: When, key: &'static str, source: &'static str) -> HelpLine {
    line(Section::Order, when, key, source)
}

/// What it corrects.
pub const fn corrects(when: When, key: &'static str, source: &'static str) -> HelpLine {
    line(Section::Corrects, when, key, source)
}

/// What goes wrong.
pub const fn wrong(when: When, key: &'static str, source: &'static str) -> HelpLine {
    line(Section::Wrong, when, key, source)
}

const fn line(section: Section, when: When, key: &'static str, source: &'static str) -> HelpLine {
    HelpLine { section, when, key, source }
}

/// A digit of `_MVAR` is one of these.
pub const fn mvar(place: i64, is: &'static [i64]) -> When {
    When::Digit { param: names::MVAR, place, is }
}

/// The lines of an entry, in groups; what many cycles share is a group of its own.
pub struct Help {
    groups: &'static [&'static [HelpLine]],
}

impl Help {
    /// Help of these groups.
    pub const fn new(groups: &'static [&'static [HelpLine]]) -> Help {
        Help { groups }
    }

    /// All lines.
    pub fn lines(&self) -> impl Iterator<Item = &'static HelpLine> {
        self.groups.iter().copied().flatten()
    }
}
