//! Guides to what Probewright does, and concepts and terms of the manuals.

use super::concept::{ConceptExample, example};
use crate::manual::Cited;
use crate::manual::explained::{CONCEPTS, Concept, GUIDES, Guide, TERMS, Term};
use crate::message::Message;
use serde::Serialize;
use std::sync::LazyLock;

/// All of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct TermsView {
    /// Guides, those of a group together.
    pub guides: Vec<GuideView>,
    /// Concepts, those of a group together.
    pub concepts: Vec<ConceptView>,
    /// Terms, by the alphabet of English.
    pub terms: Vec<TermView>,
}

/// A guide with its page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct GuideView {
    /// By which a link names it.
    pub id: &'static str,
    /// Group in which it stands.
    pub group: Message,
    /// Title of the page.
    pub title: Message,
    /// What it says.
    pub lines: Vec<Message>,
    /// Command of the page that leads there.
    pub way: &'static str,
    /// Lines for the terminal that do the same.
    pub terminal: Vec<&'static str>,
    /// Place in the manual; empty: they do not tell of it.
    pub source: Cited,
}

/// A concept with its page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ConceptView {
    /// By which a field names it.
    pub id: &'static str,
    /// Group in which it stands.
    pub group: Message,
    /// Title of the page.
    pub title: Message,
    /// What it says.
    pub lines: Vec<Message>,
    /// Parameters and data that it explains.
    pub names: Vec<&'static str>,
    /// Place in the manual.
    pub source: Cited,
    /// Its live picture; absent: no picture carries it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub example: Option<ConceptExample>,
    /// Why no picture carries it; absent: it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub still: Option<Message>,
}

/// A term with its definition.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct TermView {
    /// The term.
    pub term: Message,
    /// What it means.
    pub meaning: Message,
    /// Parameters and data that hold it.
    pub names: Vec<&'static str>,
    /// Terms that help to understand it.
    pub see: Vec<Message>,
    /// Place in the manual.
    pub source: Cited,
}

/// The concepts, made once: what is dragged in each picture is a field of a form.
static VIEWS: LazyLock<Vec<ConceptView>> = LazyLock::new(|| CONCEPTS.iter().map(concept).collect());

/// Guides, and concepts and terms of the manuals.
pub fn terms() -> TermsView {
    TermsView {
        guides: GUIDES.iter().map(guide).collect(),
        concepts: VIEWS.clone(),
        terms: TERMS.iter().map(term).collect(),
    }
}

fn guide(guide: &Guide) -> GuideView {
    let Guide { id, group, lines, further, way, terminal, source } = guide;
    let own = (1..=*lines).map(|number| Message::new(format!("guide-{id}-{number}")));
    GuideView {
        id,
        group: Message::new(format!("guide-group-{group}")),
        title: Message::new(format!("guide-{id}")),
        lines: own.chain(further.iter().map(|key| Message::new(*key))).collect(),
        way,
        terminal: terminal.clone(),
        source: *source,
    }
}

fn concept(concept: &Concept) -> ConceptView {
    let Concept { id, group, lines, names, source, shown } = concept;
    let line = |number| Message::new(format!("concept-{id}-{number}"));
    ConceptView {
        id,
        group: Message::new(format!("concept-group-{group}")),
        title: Message::new(format!("concept-{id}")),
        lines: (1..=*lines).map(line).collect(),
        names: names.clone(),
        source: *source,
        example: shown.as_ref().ok().and_then(example),
        still: shown.as_ref().err().map(|why| Message::new(format!("concept-still-{why}"))),
    }
}

fn term(term: &Term) -> TermView {
    let Term { id, names, see, source } = term;
    TermView {
        term: Message::new(format!("term-{id}")),
        meaning: Message::new(format!("term-{id}-is")),
        names: names.clone(),
        see: see.iter().map(|id| Message::new(format!("term-{id}"))).collect(),
        source: *source,
    }
}
