//! Concepts and terms of the manuals: their page in `docs/`, and what the terminal says of one.

use super::markdown::line;
use crate::app::{ConceptView, TermView, TermsView, terms};
use crate::message::Message;
use crate::words::Words;
use std::fmt::Write;

/// The page, Markdown.
pub fn page(words: &Words) -> String {
    let TermsView { concepts, terms, .. } = terms();
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-terms")));
    line(&mut text, &words.key("report-terms-intro"));
    for group in concepts.chunk_by(|one, next| one.group == next.group) {
        if let Some(first) = group.first() {
            line(&mut text, &format!("## {}", words.text(&first.group)));
        }
        for concept in group {
            line(&mut text, &format!("### {}", words.text(&concept.title)));
            line(&mut text, &format!("{} {}", said(concept, words), place(&concept.names, concept.source.to_string())));
            if concept.example.is_some() {
                let title = words.text(&concept.title);
                line(&mut text, &format!("![{title}]({}concepts/{}.svg)", top(words), concept.id));
            }
            line(&mut text, &picture(concept, words));
        }
    }
    line(&mut text, &format!("## {}", words.key("report-terms-list")));
    for term in &terms {
        let (name, place) = (words.text(&term.term), place(&term.names, term.source.to_string()));
        line(&mut text, &format!("**{name}**: {}{} {place}", words.text(&term.meaning), further(term, words)));
    }
    text.trim_end().to_owned() + "\n"
}

/// The way from a page to the folder of the pictures, which all languages share.
fn top(words: &Words) -> &'static str {
    if words.language() == "en" { "" } else { "../" }
}

fn said(concept: &ConceptView, words: &Words) -> String {
    concept.lines.iter().map(|line| words.text(line)).collect::<Vec<_>>().join(" ")
}

/// What its picture shows in the page, or why it has none.
fn picture(concept: &ConceptView, words: &Words) -> String {
    let live =
        concept.example.as_ref().map(|live| Message::new("report-terms-live").text("what", words.text(&live.label)));
    live.or_else(|| concept.still.clone()).map_or_else(String::new, |message| words.text(&message))
}

/// What else helps to understand a term.
fn further(term: &TermView, words: &Words) -> String {
    let see: Vec<String> = term.see.iter().map(|see| words.text(see)).collect();
    if see.is_empty() { String::new() } else { format!(" → {}", see.join(", ")) }
}

/// Data and place in the manual.
fn place(names: &[&str], source: String) -> String {
    let names = names.iter().map(|name| format!("`{name}`"));
    format!("({})", names.chain([source]).collect::<Vec<_>>().join(", "))
}

/// A concept or a term by its name or short form in the language, or by its id with spaces. Empty: none has it.
pub fn explained(asked: &str, words: &Words) -> String {
    let asked = plain(asked);
    let TermsView { concepts, terms, .. } = terms();
    let is = |title: &crate::message::Message| {
        let id = title.key.split_once('-').map_or("", |(_, id)| id);
        let title = words.text(title);
        [plain(&title), plain(id), plain(short(&title))].contains(&asked)
    };
    let mut text = String::new();
    for concept in concepts.iter().filter(|concept| is(&concept.title)) {
        let _ = writeln!(text, "{}", words.text(&concept.title));
        for line in &concept.lines {
            let _ = writeln!(text, "  {}", words.text(line));
        }
        let _ = writeln!(text, "  {}", picture(concept, words));
        let _ = writeln!(text, "  {}", place(&concept.names, concept.source.to_string()));
    }
    for term in terms.iter().filter(|term| is(&term.term)) {
        let (name, meaning) = (words.text(&term.term), words.text(&term.meaning));
        let _ = writeln!(text, "{name}: {meaning}{}", further(term, words));
        let _ = writeln!(text, "  {}", place(&term.names, term.source.to_string()));
    }
    text
}

/// The short form of a term, which stands behind it in brackets: `WCS`; empty where there is none.
fn short(title: &str) -> &str {
    let behind = title.split_once(['(', '（']).map_or("", |(_, behind)| behind);
    behind.trim_end_matches([')', '）'])
}

/// A name as somebody types it: without what stands in brackets, in lower case, its parts by spaces.
pub(super) fn plain(name: &str) -> String {
    let name = name.split(['(', '（']).next().unwrap_or_default();
    name.to_lowercase().split(['-', ' ']).filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: self
    #[test]
    fn the_page_is_that_of_the_tables() {
        super::super::held("terms.md", page);
    }

    // oracle: self: each is found by its name in each language
    #[test]
    fn a_term_is_found_by_its_name() {
        for language in crate::words::LANGUAGES {
            let words = Words::of(language.code).unwrap();
            let TermsView { concepts, terms, .. } = terms();
            let titles = concepts.iter().map(|one| &one.title).chain(terms.iter().map(|one| &one.term));
            for title in titles {
                let name = words.text(title);
                assert!(explained(&name, &words).contains(&name), "{name}");
                let short = short(&name);
                assert!(short.is_empty() || explained(short, &words).contains(&name), "{short}");
            }
        }
        assert_eq!(explained("nobody's word", &Words::of("en").unwrap()), "");
    }
}
