//! What the manuals take for granted in each sentence: concepts, a page each, and terms, a definition each; and guides,
//! which tell how to work with what a measurement leaves. Their words are messages: `concept-…` and `guide-…` with
//! their numbered lines, `guide-…-words` by which one is found, `term-…` and `term-…-is`.

use super::{Cited, rows, several};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A concept with a page of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Concept {
    /// End of its keys.
    pub id: &'static str,
    /// End of the key of the group in which it stands.
    pub group: &'static str,
    /// How many lines its page has.
    pub lines: usize,
    /// Parameters and data that it explains.
    pub names: Vec<&'static str>,
    /// Where the manuals tell of it.
    pub source: Cited,
    /// Its live picture; else the end of the key that says why no picture carries it.
    pub shown: Result<Example, &'static str>,
}

/// A picture that changes while a value is dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Example {
    /// `CYCLE977/1`: the worked measurement of a variant; `sketch/…`: what is calculated, drawn.
    pub of: &'static str,
    /// What is dragged: a parameter, or a quantity of the sketch.
    pub drag: &'static str,
    /// Ends of its range, in its unit.
    pub from: f64,
    /// The other end.
    pub to: f64,
}

/// A term with its definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// End of its keys.
    pub id: &'static str,
    /// Parameters and data that hold it.
    pub names: Vec<&'static str>,
    /// Terms that help to understand it, by their ids.
    pub see: Vec<&'static str>,
    /// Where the manuals tell of it.
    pub source: Cited,
}

/// What a part of Probewright is for, where it is, what to look out for.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// End of its keys.
    pub id: &'static str,
    /// End of the key of the group in which it stands.
    pub group: &'static str,
    /// How many lines of its own its page has.
    pub lines: usize,
    /// Keys of messages that follow them and are said elsewhere too.
    pub further: Vec<&'static str>,
    /// Command of the page that leads there.
    pub way: &'static str,
    /// Lines for the terminal that do the same.
    pub terminal: Vec<&'static str>,
    /// Where the manuals tell of it; of most they do not.
    pub source: Cited,
}

/// All guides, those of a group together.
pub static GUIDES: LazyLock<Vec<Guide>> = LazyLock::new(|| {
    let guide = |[id, group, lines, further, way, terminal, source]: [&'static str; 7]| {
        let (further, terminal) = (several(further), several(terminal));
        Some(Guide { id, group, lines: lines.parse().ok()?, further, way, terminal, source: Cited(source) })
    };
    rows(include_str!("guides.tsv")).filter_map(guide).collect()
});

/// All concepts, those of a group together.
pub static CONCEPTS: LazyLock<Vec<Concept>> = LazyLock::new(|| {
    let concept = |[id, group, lines, names, source, of, drag, from, to]: [&'static str; 9]| {
        let shown = match of {
            "-" => Err(drag),
            _ => Ok(Example { of, drag, from: from.parse().ok()?, to: to.parse().ok()? }),
        };
        let (names, source) = (several(names), Cited(source));
        Some(Concept { id, group, lines: lines.parse().ok()?, names, source, shown })
    };
    rows(include_str!("concepts.tsv")).filter_map(concept).collect()
});

/// All terms, by the alphabet of English.
pub static TERMS: LazyLock<Vec<Term>> = LazyLock::new(|| {
    let term = |[id, names, see, source]: [&'static str; 4]| Term {
        id,
        names: several(names),
        see: several(see),
        source: Cited(source),
    };
    rows(include_str!("terms.tsv")).map(term).collect()
});

/// The concepts by what they explain; of several the one that is about the fewest. Made once: each field asks.
static BY_NAME: LazyLock<BTreeMap<&str, &Concept>> = LazyLock::new(|| {
    let mut by_name = BTreeMap::new();
    for concept in CONCEPTS.iter() {
        for name in &concept.names {
            let known = by_name.entry(*name).or_insert(concept);
            if concept.names.len() < known.names.len() {
                *known = concept;
            }
        }
    }
    by_name
});

/// The concept that explains a parameter or datum.
pub fn concept_of(name: &str) -> Option<&'static Concept> {
    BY_NAME.get(name).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    // oracle: self: no row of a table is lost, each place of a manual is found, and what is named exists
    #[test]
    fn the_tables_are_whole() {
        assert_eq!(CONCEPTS.len() + 1, include_str!("concepts.tsv").lines().count());
        assert_eq!(TERMS.len() + 1, include_str!("terms.tsv").lines().count());
        let ids: BTreeSet<&str> = TERMS.iter().map(|term| term.id).collect();
        assert_eq!(ids.len(), TERMS.len());
        for term in TERMS.iter() {
            assert!(term.see.iter().all(|see| ids.contains(see) && *see != term.id), "{term:?}");
            assert!(!term.source.to_string().is_empty(), "{term:?}");
        }
        let concepts: BTreeSet<&str> = CONCEPTS.iter().map(|concept| concept.id).collect();
        assert_eq!(concepts.len(), CONCEPTS.len());
        assert!(CONCEPTS.iter().all(|one| one.lines > 0 && !one.source.to_string().is_empty()));
        let without = CONCEPTS.iter().filter(|one| one.shown.is_err()).count();
        assert!(3 * without <= CONCEPTS.len(), "most have a picture: {without} have none");
        let groups: Vec<&str> =
            CONCEPTS.chunk_by(|one, next| one.group == next.group).map(|all| all[0].group).collect();
        assert_eq!(groups.iter().collect::<BTreeSet<_>>().len(), groups.len(), "those of a group stand together");
    }

    // oracle: self: no row is lost, each leads somewhere in page and terminal, and those of a group stand together
    #[test]
    fn the_guides_are_whole() {
        assert_eq!(GUIDES.len() + 1, include_str!("guides.tsv").lines().count());
        assert_eq!(GUIDES.iter().map(|one| one.id).collect::<BTreeSet<_>>().len(), GUIDES.len());
        assert!(GUIDES.iter().all(|one| one.lines > 0 && !one.way.is_empty() && !one.terminal.is_empty()));
        let groups: Vec<&str> = GUIDES.chunk_by(|one, next| one.group == next.group).map(|all| all[0].group).collect();
        assert_eq!(groups.iter().collect::<BTreeSet<_>>().len(), groups.len());
        let unfound = |one: &&Guide| !one.source.0.is_empty() && one.source.to_string().is_empty();
        assert_eq!(GUIDES.iter().find(unfound), None);
    }

    // oracle: hand
    #[test]
    fn a_parameter_leads_to_its_concept() {
        assert!(concept_of("_FA").is_some());
        assert_eq!(concept_of("_NOBODY"), None);
    }
}
