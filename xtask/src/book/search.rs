//! The search index of a language: the text of every section once, since many say the same.

use super::markdown::Made;
use super::outline::ENTRY;
use super::sources::Source;
use serde_json::{Value, json};
use std::collections::HashMap;

/// A script, not JSON: a page from a disk may load that. `book/index.ts` reads it.
pub fn index(pages: &[(&Source, Made)]) -> String {
    let mut texts = Texts::default();
    let mut sections: Vec<Value> = Vec::new();
    for (at, (_, made)) in pages.iter().enumerate() {
        for section in &made.sections {
            let told: Vec<usize> = section.texts.iter().map(|text| texts.number(text)).collect();
            let sort = match section.level {
                1 => 0,
                ENTRY => 2,
                _ => 1,
            };
            sections.push(json!([at, sort, section.id, section.title, told]));
        }
    }
    let pages: Vec<Value> =
        pages.iter().map(|(source, _)| json!([format!("{}.html", source.name), source.title])).collect();
    format!("probewrightBook({});\n", json!({ "pages": pages, "sections": sections, "texts": texts.all }))
}

/// Different texts, in the order in which they were met.
#[derive(Default)]
struct Texts<'a> {
    all: Vec<&'a str>,
    known: HashMap<&'a str, usize>,
}

impl<'a> Texts<'a> {
    fn number(&mut self, text: &'a str) -> usize {
        *self.known.entry(text).or_insert_with(|| {
            self.all.push(text);
            self.all.len() - 1
        })
    }
}
