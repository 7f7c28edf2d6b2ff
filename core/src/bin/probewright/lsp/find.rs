//! From a name to what it means: the assignments that reach a call or an expression, a label, a subprogram; and from an
//! assignment to the calls that it reaches.

use super::known::{Document, Known, name_around, touches};
use probewright_core::diagnostic::Span;
use probewright_core::name;
use probewright_core::program::variables::assigned;
use probewright_core::syntax::programs::{numbered, programs};
use probewright_core::syntax::{Word, WordKind};

/// Places of the joined text to which the name at a byte leads.
pub fn definitions(document: &Document, known: &Known, at: u32) -> Vec<Span> {
    let name = name::numbered(name_around(document.text.as_str(), at as usize).to_ascii_uppercase());
    let word = known.word(at);
    if let Some(found) = word.and_then(|word| label(known, word, &name)) {
        return vec![found];
    }
    let read = word.map_or_else(Vec::new, |word| variable(known, word, &name));
    if !read.is_empty() {
        return read;
    }
    match known.call(at) {
        Some(site) => known.written(site),
        None => subprogram(known, &name).into_iter().chain(own(known, word, &name)).take(1).collect(),
    }
}

/// The calls that what is written at a byte reaches.
pub fn references(known: &Known, at: u32) -> Vec<Span> {
    let mut calls: Vec<Span> = known.valued(at).into_iter().map(|one| one.site.span).collect();
    calls.sort_by_key(|place| place.start);
    calls
}

/// Where a jump leads, in the program of the text that it stands in.
fn label(known: &Known, word: &Word, name: &str) -> Option<Span> {
    let program = &known.program;
    if name.is_empty() || !matches!(word.kind, WordKind::Keyword { value: Some(_), .. }) {
        return None;
    }
    let all = programs(program);
    let unit = all.units.get(all.of_line(program.line_of(word.span.start))?)?;
    program.blocks_of(unit).iter().find_map(|block| {
        let labels = program.words_of(block).iter().filter_map(Word::label);
        block.number.into_iter().chain(labels).find(|place| program.is(*place, name))
    })
}

/// The assignments that may have given a variable the value that a word reads.
fn variable(known: &Known, word: &Word, name: &str) -> Vec<Span> {
    let program = &known.program;
    let bare = name.split('[').next().unwrap_or(name);
    let names = [name, bare];
    let given = names.iter().map(|name| assigned(program, word, name)).find(|found| !found.is_empty());
    let around = |start: u32| program.word_at(Span { start, end: start }).map(|word| word.span);
    given.unwrap_or_default().into_iter().filter_map(around).collect()
}

/// The program of the text with a name: `L10`, `NAME`, NCT `P110`.
fn subprogram(known: &Known, name: &str) -> Option<Span> {
    let all = programs(&known.program);
    let of_number = || numbered(name.strip_prefix('P')?.parse().ok()?);
    let unit = all.named(name).or_else(|| all.named(&of_number()?)).filter(|_| !name.is_empty())?;
    let first = unit.signature.unwrap_or(unit.blocks.start);
    known.program.blocks.get(first).map(|block| block.span)
}

/// The assignment itself, where the name stands on its left.
fn own(known: &Known, word: Option<&Word>, name: &str) -> Option<Span> {
    let word = word?;
    let WordKind::Assign { name: left, .. } = word.kind else { return None };
    let bare = name.split('[').next().unwrap_or(name);
    (known.program.name(left) == bare && touches(word.span, left.start)).then_some(word.span)
}
