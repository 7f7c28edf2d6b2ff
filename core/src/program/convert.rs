//! One call from one way of writing to another, in place: its own assignments go, its new text comes where the call is.

use super::arguments;
use super::calls::{CallSite, calls};
use super::change::{Edit, apply, line_end};
use super::read;
use super::tree::{Program, Word, WordKind};
use super::write::snippet;
use crate::catalogue::{Param, Style, list};
use crate::check::{self, note, warning};
use crate::control::delivery;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::message::Message;
use std::collections::BTreeMap;

/// A call behind this one would get other values.
const OTHERS: Code = Code::Own(123);
/// The call is written like that already.
const SAME: Code = Code::Own(124);

/// Edits that turn a call into another way of writing, and what has to be said about it.
pub struct Converted {
    /// Empty where it is not possible, or already so.
    pub edits: Vec<Edit>,
    /// What the new way cannot say, and calls behind it that rely on values which are no longer in the data.
    pub findings: Vec<Diagnostic>,
}

/// Writes the call at `index` of the program's calls in this way.
pub fn convert(program: &Program, index: usize, style: Style) -> Converted {
    let sites = calls(program);
    let Some(site) = sites.get(index) else {
        return Converted {
            edits: Vec::new(),
            findings: Vec::new(),
        };
    };
    if site.list.map_or(Style::Direct, |list| list.style) == style {
        return Converted {
            edits: Vec::new(),
            findings: vec![note(SAME, Message::new("convert-same"))],
        };
    }
    let mut control = delivery(program.dialect);
    control.plane = site.plane;
    control.choose_units(site.unit_function);
    let written = snippet(site.cycle, &site.values, &control, style, None);
    let mut findings = written.findings;
    let edits = if written.text.is_empty() {
        Vec::new()
    } else {
        rewritten(program, site, &written.text)
    };
    findings.extend(others(program, &sites, index, &edits));
    Converted { edits, findings }
}

fn rewritten(program: &Program, site: &CallSite, text: &str) -> Vec<Edit> {
    let own = own_words(program, site);
    let mut lines: Vec<String> = kept(program, site, &own);
    lines.extend(text.lines().map(str::to_owned));
    let call = lines.pop().unwrap_or_default();
    let mut edits: Vec<Edit> = emptied(program, &own, site.line);
    edits.push(Edit {
        span: site.span,
        insert: call,
    });
    if let (Some(block), false) = (program.blocks.get(site.line as usize), lines.is_empty()) {
        let end = line_end(program, site.line);
        let start = Span {
            start: block.span.start,
            end: block.span.start,
        };
        edits.push(Edit {
            span: start,
            insert: lines.iter().map(|line| format!("{line}{end}")).collect(),
        });
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits
}

/// The words that give values to this call only, as far as they stand outside of it, by their line.
fn own_words<'a>(program: &'a Program, site: &CallSite) -> BTreeMap<u32, Vec<&'a Word>> {
    let mut found: BTreeMap<u32, Vec<&Word>> = BTreeMap::new();
    let places = site.places.iter().filter(|(name, place)| {
        place.start >= site.own_from && **place != site.span && !site.shared.contains(*name)
    });
    for (_, place) in places {
        let Some(word) = program.word_at(*place) else {
            continue;
        };
        let single = match &word.kind {
            WordKind::Assign { .. } => !program.text(word.span).contains(&b','),
            WordKind::Call { name, .. } => program.is(*name, list::AUXILIARY),
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

/// Data that a `CYCLE_PARA` of this call sets for others: they stay as assignments.
fn kept(program: &Program, site: &CallSite, own: &BTreeMap<u32, Vec<&Word>>) -> Vec<String> {
    let mut lines = Vec::new();
    for word in own.values().flatten() {
        if !matches!(word.kind, WordKind::Call { .. }) {
            continue;
        }
        let places = arguments::places(program, word.span);
        for (name, place) in list::AUXILIARY_ARGS.iter().zip(places) {
            let text = String::from_utf8_lossy(program.text(place)).into_owned();
            let says = !text.is_empty() && text.parse() != Ok(0.0);
            if says && site.cycle.param(name).is_none() {
                lines.push(format!("{name}={text}"));
            }
        }
    }
    lines
}

/// Takes words out of their lines; a line without anything else goes with its end.
fn emptied(program: &Program, own: &BTreeMap<u32, Vec<&Word>>, call_line: u32) -> Vec<Edit> {
    let mut edits = Vec::new();
    for (line, words) in own {
        let Some(block) = program.blocks.get(*line as usize) else {
            continue;
        };
        let alone = program.words_of(block).len() == words.len()
            && block.comment.is_none()
            && *line != call_line;
        if alone {
            let next = program.blocks.get(*line as usize + 1);
            let end = next.map_or(block.span.end, |next| next.span.start);
            edits.push(removed(block.span.start, end));
            continue;
        }
        edits.extend(words.iter().map(|word| without_blanks(program, word.span)));
    }
    edits
}

fn removed(start: u32, end: u32) -> Edit {
    Edit {
        span: Span { start, end },
        insert: String::new(),
    }
}

/// A word with the blanks behind it.
fn without_blanks(program: &Program, word: Span) -> Edit {
    let behind = program
        .source
        .get(word.end as usize..)
        .unwrap_or_default()
        .iter()
        .take_while(|byte| matches!(byte, b' ' | b'\t'))
        .count();
    removed(word.start, word.end + behind as u32)
}

/// Whether two calls have the same values; a datum that was never written holds its delivered value, or 0.
fn means_the_same(one: &CallSite, other: &CallSite) -> bool {
    let control = delivery(one.cycle.dialect);
    let inputs = |site: &CallSite| check::read(site.cycle, &site.values, &control, &mut Vec::new());
    let (left, right) = (inputs(one), inputs(other));
    let same = |param: &Param| {
        left.number(param.name) == right.number(param.name)
            && left.text(param.name) == right.text(param.name)
    };
    one.cycle.params.iter().all(same)
}

/// Calls that would have other values afterwards.
fn others(program: &Program, sites: &[CallSite], index: usize, edits: &[Edit]) -> Vec<Diagnostic> {
    if edits.is_empty() {
        return Vec::new();
    }
    let after = read(program.dialect, &apply(&program.source, edits));
    let after = calls(&after);
    let mut findings = Vec::new();
    for (place, (before, after)) in sites.iter().zip(&after).enumerate() {
        if place != index && !means_the_same(before, after) {
            let message = Message::new("convert-others")
                .text("cycle", before.cycle.name)
                .number("line", f64::from(before.line + 1));
            let mut finding = warning(OTHERS, message);
            finding.hint = Some(Message::new("convert-others-hint"));
            finding.span = Some(before.span);
            findings.push(finding);
        }
    }
    findings
}
