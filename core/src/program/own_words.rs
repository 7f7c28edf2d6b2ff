//! The words outside of a call that give values to it only, the comment with its settings, and edits without them.

use super::calls::CallSite;
use super::change::{Edit, blanks_before, blanks_behind};
use super::values::{Spread, spread};
use crate::diagnostic::Span;
use crate::entry::AUXILIARY;
use crate::support::{BITS, Mark};
use crate::syntax::{Block, Program, Word, WordKind};
use std::collections::BTreeMap;

/// Words of a program by their line.
pub(super) type Lines<'a> = BTreeMap<u32, Vec<&'a Word>>;

/// The words outside of a call that give these values to it only; `bits`: those that set bits for it too.
pub(super) fn own_words<'a>(
    program: &'a Program,
    site: &CallSite,
    bits: bool,
    wanted: impl Fn(&str) -> bool,
) -> Lines<'a> {
    let mut found = Lines::new();
    let of_values = site.places.keys().filter(|name| wanted(name)).filter_map(|name| site.own_place(name));
    let of_bits = site.bits.iter().filter(|_| bits).map(|(_, _, place)| *place);
    let of_bits = of_bits.filter(|place| site.own_from <= place.start && place.end <= site.span.end);
    for place in of_values.chain(of_bits).filter(|place| *place != site.span) {
        let Some(word) = program.word_at(place) else { continue };
        let single = match &word.kind {
            WordKind::Assign { value, .. } => matches!(spread(program, *value), Spread::One),
            WordKind::Call { name, .. } => program.is(*name, AUXILIARY),
            _ => false,
        };
        let line = found.entry(program.line_of(word.span.start)).or_default();
        if single && !line.iter().any(|other| other.span == word.span) {
            line.push(word);
        }
    }
    found.retain(|_, words| !words.is_empty());
    for words in found.values_mut() {
        words.sort_by_key(|word| word.span.start);
    }
    found
}

/// Takes words out of their lines; a line without anything else goes with its end, unless it `stays`.
pub(super) fn emptied(program: &Program, own: &Lines, stays: impl Fn(u32, &Block) -> bool) -> Vec<Edit> {
    let mut edits = Vec::new();
    for (line, words) in own {
        let Some(block) = program.blocks.get(*line as usize) else { continue };
        if program.words_of(block).len() == words.len() && block.comment.is_none() && !stays(*line, block) {
            edits.push(without_line(program, *line, block.span.start));
        } else {
            edits.extend(without_words(program, words, block.span));
        }
    }
    edits
}

/// Words of a line with the blanks behind them; behind the last word of all, with those before.
fn without_words(program: &Program, words: &[&Word], line: Span) -> Vec<Edit> {
    let mut gaps: Vec<Span> = Vec::new();
    for word in words {
        let end = blanks_behind(program, line, word.span.end);
        match gaps.last_mut().filter(|gap| gap.end == word.span.start) {
            Some(gap) => gap.end = end,
            None => gaps.push(Span { end, ..word.span }),
        }
    }
    if let Some(last) = gaps.last_mut().filter(|gap| gap.end == line.end) {
        last.start = blanks_before(program, line, last.start);
    }
    gaps.into_iter().map(|gap| Edit::remove(gap.start, gap.end)).collect()
}

/// A line from a byte on, with its end.
fn without_line(program: &Program, line: u32, from: u32) -> Edit {
    let behind = program.blocks.get(line as usize + 1);
    Edit::remove(from, behind.map_or(program.source.len() as u32, |next| next.span.start))
}

/// A comment; a line without anything else goes with its end.
pub(super) fn without_comment(program: &Program, comment: Span) -> Edit {
    let line = program.line_of(comment.start);
    match program.blocks.get(line as usize) {
        Some(block) if program.words_of(block).is_empty() => without_line(program, line, block.span.start),
        _ => Edit::remove(comment.start, comment.end),
    }
}

/// The comment with the settings, before the call's first line; lines that only set bits may stand between.
pub fn mark_before(program: &Program, site: &CallSite) -> Option<(Mark, Span)> {
    let block = program.blocks.get(..site.first_line as usize)?.iter().rfind(|block| !sets_bits(program, block))?;
    let place = block.comment?;
    Some((Mark::read(std::str::from_utf8(program.text(place)).ok()?)?, place))
}

pub(super) fn sets_bits(program: &Program, block: &Block) -> bool {
    let words = program.words_of(block);
    let is_bit = |word: &Word| match &word.kind {
        WordKind::Assign { value, .. } => {
            let target = Span { end: program.place(*value).start, ..word.span };
            let text: String = program.name(target).chars().filter(|one| !one.is_whitespace()).collect();
            BITS.iter().any(|bit| text.strip_suffix('=') == Some(bit))
        }
        _ => false,
    };
    !words.is_empty() && block.comment.is_none() && words.iter().all(is_bit)
}
