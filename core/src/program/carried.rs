//! Expressions of a call that is written in another way: they go along as text, or the call stays as it is and the
//! reason is told. What an expression is worth today is never written in its place.

use super::arguments;
use super::calls::CallSite;
use super::readers::Outside;
use crate::check::{expression::is_parameter, parse};
use crate::diagnostic::{Diagnostic, Span};
use crate::dialect::Dialect;
use crate::entry::{AUXILIARY, Arg};
use crate::name::Name;
use crate::own;
use crate::syntax::fold::names_in;
use crate::syntax::programs::programs;
use crate::syntax::{Block, Program, Word, WordKind, read};
use std::collections::BTreeSet;

/// Why the call cannot be written in another way without losing an expression among its own arguments; none: it can.
pub(super) fn stuck(program: &Program, site: &CallSite) -> Option<Diagnostic> {
    let list = site.list?;
    list.args.iter().zip(arguments::places(program, site.span)).find_map(|(arg, place)| {
        let text = program.written(place);
        let said = !text.is_empty() && !is_literal(&text);
        let lost = said && matches!(arg, Arg::Select(_) | Arg::Open | Arg::Is(_));
        lost.then(|| own::CONVERT_ARGUMENT.finding().text("value", &*text).hint_text("value", text))
    })
}

/// A number or a text in quotes.
fn is_literal(text: &str) -> bool {
    text.len() > 1 && text.starts_with('"') && text.ends_with('"') || text.parse::<f64>().is_ok()
}

/// The first of these values that is an expression and may be worth something else directly before the call than where
/// it is written. What is known of its worth is compared afterwards, see [`differs`].
pub(super) fn moves(program: &Program, site: &CallSite, said: &[Name]) -> Option<Diagnostic> {
    let moves = |text: &str, name: Name| text != name.as_str() && !stays(program, site, name.as_str(), text);
    let mut names = said.iter().copied();
    let name = names.find(|name| site.expression(name).is_some_and(|text| moves(text, *name)))?;
    Some(changing(site, name))
}

/// A value that is written on some ways to the call only: on the others it is what an earlier call left, and in the
/// call it would always count. So it is with one in a block that can be skipped where the call cannot.
pub(super) fn skipped(program: &Program, site: &CallSite, said: &[Name]) -> Option<Diagnostic> {
    let skip = |place: Span| program.blocks.get(program.line_of(place.start) as usize).and_then(|block| block.skip);
    let of_call = skip(site.span);
    let skips = |name: &&Name| {
        let alone = site.places.get(*name).copied().into_iter();
        let mut places = alone.chain(site.origins.get(*name).into_iter().flatten().map(|origin| origin.place));
        places.any(|place| skip(place).is_some_and(|level| Some(level) != of_call))
    };
    if let Some(name) = said.iter().find(skips) {
        return Some(own::CONVERT_SKIP_BLOCK.finding().text("name", name.as_str()).hint_text("name", name.as_str()));
    }
    let name = site.sometimes.first()?;
    Some(own::CONVERT_SKIPPED.finding().text("name", name.as_str()).hint_text("name", name.as_str()))
}

/// A program outside of the text that is called between a value and the call: it may read the value or change it.
pub(super) fn called(program: &Program, outside: &Outside, site: &CallSite, said: &[Name]) -> Option<Diagnostic> {
    let (name, called) = outside.between(program, site, said)?;
    let finding = own::CONVERT_CALLED.finding().text("name", name.as_str()).text("program", called);
    Some(finding.hint_text("name", name.as_str()))
}

/// The expression of a value is not worth the same at the call.
pub(super) fn changing(site: &CallSite, name: Name) -> Diagnostic {
    let value = site.expression(name.as_str()).unwrap_or_default();
    let finding = own::CONVERT_EXPRESSION.finding().text("name", name).text("value", value).hint_text("name", name);
    finding.hint_text("value", value)
}

/// Whether an expression means directly before the call what it means where it is written.
fn stays(program: &Program, site: &CallSite, name: &str, text: &str) -> bool {
    let Some(place) = site.places.get(name).copied() else {
        return false; // several assignments come here
    };
    if place.start >= site.span.start && place.end <= site.span.end {
        return true;
    }
    let reads = Reads::of(program, text);
    let programs = programs(program);
    let unit = |place: Span| programs.of_line(program.line_of(place.start));
    if unit(place) != unit(site.span) {
        // names of another program may mean nothing here
        return reads.parameters && site.expressions.contains_key(name);
    }
    site.expressions.contains_key(name) || straight(program, place, site, &reads)
}

/// The variables that an expression reads.
struct Reads {
    names: BTreeSet<String>,
    /// All are arithmetic parameters, `R1`.
    parameters: bool,
    /// All are arithmetic parameters or variables that the text declares: only assignments change them.
    plain: bool,
}

impl Reads {
    fn of(program: &Program, text: &str) -> Reads {
        let names = names(text);
        let declared =
            |name: &String| program.words.iter().filter_map(Word::declared).any(|place| program.is(place, name));
        Reads {
            parameters: names.iter().all(|name| is_parameter(name)),
            plain: names.iter().all(|name| is_parameter(name) || declared(name)),
            names,
        }
    }
}

/// The names in an expression, without functions, in upper case; one that is no name where it cannot be read.
fn names(text: &str) -> BTreeSet<String> {
    let program = read(Dialect::Sinumerik, format!("_X={text}").as_bytes());
    let mut found = BTreeSet::new();
    match program.words[..] {
        [Word { kind: WordKind::Assign { value, .. }, .. }] => names_in(&program, value, &mut found),
        _ => drop(found.insert(String::new())),
    }
    found
}

/// Whether the program goes on no way from a value to the call but past words that leave what the value reads.
fn straight(program: &Program, place: Span, site: &CallSite, reads: &Reads) -> bool {
    if place.start < site.own_from || place.end > site.span.start {
        return false;
    }
    let line = |at: u32| program.line_of(at) as usize;
    let lines = program.blocks.get(line(place.end)..=line(site.span.start));
    let parts = |block: &Block| block.skip.is_some() || block.plain && !reads.plain;
    if lines.into_iter().flatten().any(parts) {
        return false;
    }
    let first = program.words.partition_point(|word| word.span.end <= place.end);
    let words = program.words.get(first..).unwrap_or_default().iter();
    words.take_while(|word| word.span.start < site.span.start).all(|word| leaves(program, word, site, reads))
}

fn leaves(program: &Program, word: &Word, site: &CallSite, reads: &Reads) -> bool {
    match &word.kind {
        WordKind::Assign { name, .. } => {
            let name = program.name(*name);
            let of_call = |param: &str| param.split('[').next() == Some(&name);
            let for_call = site.cycle.params.iter().any(|param| of_call(param.name.as_str()));
            !reads.names.contains(&name) && (reads.plain || for_call)
        }
        WordKind::Address { .. } => reads.plain,
        WordKind::Call { name, .. } => program.is(*name, AUXILIARY),
        _ => false,
    }
}

/// The first of these values that is another expression, or worth something else, at the call as it is written now.
pub(super) fn differs(site: &CallSite, after: &CallSite, said: &[Name]) -> Option<Name> {
    said.iter().copied().find(|name| {
        let Some(text) = site.expression(name) else { return false };
        let now = after.expression(name);
        let known = |site: &CallSite| site.values.get(name.as_str()).map(|text| parse(text));
        now.is_none_or(|now| plain(now) != plain(text)) || known(site) != known(after)
    })
}

/// An expression without blanks.
fn plain(text: &str) -> String {
    text.split_whitespace().collect()
}
