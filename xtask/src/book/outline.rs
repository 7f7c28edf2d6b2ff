//! What a page is divided into: headings with their names in an address, and what stands below each, for the search.

use std::collections::BTreeSet;

/// A heading of a page, or an entry: a row of a table that begins with a name in code, a paragraph that begins with a
/// term in bold.
#[derive(Debug, PartialEq)]
pub struct Section {
    /// 1: the title of the page; [`ENTRY`]: an entry.
    pub level: usize,
    pub id: String,
    pub title: String,
    /// Paragraphs, entries of lists, cells of other rows, without marks.
    pub texts: Vec<String>,
}

/// Level of an entry.
pub const ENTRY: usize = 7;

/// Sections in the order of the page, their ids unique.
#[derive(Default)]
pub struct Outline {
    pub sections: Vec<Section>,
    taken: BTreeSet<String>,
}

impl Outline {
    /// Begins a section; gives its id.
    pub fn begin(&mut self, level: usize, title: &str) -> String {
        let plain = slug(title);
        let numbered = (2..).map(|number| format!("{plain}-{number}"));
        let id = std::iter::once(plain.clone()).chain(numbered).find(|id| !self.taken.contains(id));
        let id = id.unwrap_or(plain);
        self.taken.insert(id.clone());
        self.sections.push(Section { level, id: id.clone(), title: title.to_owned(), texts: Vec::new() });
        id
    }

    /// Text below the last heading, or in the last entry.
    pub fn add(&mut self, text: &str, entry: bool) {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let of = |section: &&mut Section| entry || section.level != ENTRY;
        let section = self.sections.iter_mut().rev().find(of);
        if let Some(section) = section.filter(|_| !text.is_empty()) {
            section.texts.push(text);
        }
    }

    /// Id of the heading under which the page is at.
    pub fn heading(&self) -> &str {
        self.sections.iter().rev().find(|section| section.level != ENTRY).map_or("", |section| &section.id)
    }
}

/// A title as part of an address: letters and digits of any script, lines between them.
fn slug(title: &str) -> String {
    let words = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let slug = words.map(str::to_lowercase).collect::<Vec<_>>().join("-");
    if slug.is_empty() { "section".to_owned() } else { slug }
}
