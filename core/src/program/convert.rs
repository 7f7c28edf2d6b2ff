//! One call from one way of writing to another, in place: its own assignments go, its new text comes where the call is.

use super::arguments;
use super::calls::{CallSite, calls_on};
use super::change::{Edit, apply, behind_label, line_end};
use super::marked::mark_before;
use super::read;
use super::tree::{Program, Word, WordKind};
use super::write::snippet;
use crate::catalogue::{ArgumentList, Param, Style, list};
use crate::check::{self, Parsed, Typed, newer, parse};
use crate::control::Control;
use crate::diagnostic::{Diagnostic, Span};
use crate::own;
use crate::support::Mark;
use std::collections::BTreeMap;

/// Edits that turn a call into another way of writing, and what has to be said about it.
pub struct Converted {
    /// Empty where it is not possible, or already so.
    pub edits: Vec<Edit>,
    /// What the new way cannot say, and calls behind it that rely on values which are no longer in the data.
    pub findings: Vec<Diagnostic>,
}

/// Writes the call at `index` of the program's calls in this way; the program starts on a control in this state.
pub fn convert(program: &Program, index: usize, style: Style, control: &Control) -> Converted {
    let sites = calls_on(program, control.clone());
    let Some(site) = sites.get(index) else {
        return Converted {
            edits: Vec::new(),
            findings: Vec::new(),
        };
    };
    if site.list.map_or(Style::Direct, |list| list.style) == style {
        return Converted {
            edits: Vec::new(),
            findings: vec![own::CONVERT_SAME.finding()],
        };
    }
    let mut at_call = control.clone();
    at_call.plane = site.plane;
    at_call.choose_units(site.unit_function);
    if let Some(finding) = refused(program, site, &at_call) {
        return Converted {
            edits: Vec::new(),
            findings: vec![finding],
        };
    }
    let values = explicit(site, &at_call);
    let written = snippet(site.cycle, &values, &at_call, style, None);
    let mut findings = written.findings;
    findings.extend(left_out(program, site));
    let edits = if written.text.is_empty() {
        Vec::new()
    } else {
        rewritten(program, site, &written.text)
    };
    findings.extend(others(program, &sites, index, &edits, control));
    Converted { edits, findings }
}

/// The list of a newer control in which the call is written.
fn of_newer(site: &CallSite) -> Option<&'static ArgumentList> {
    site.list.filter(|list| list.style == Style::Operate)
}

/// Why no other way of writing says the same.
fn refused(program: &Program, site: &CallSite, control: &Control) -> Option<Diagnostic> {
    let list = site.list?;
    let value = |name: &str| site.values.get(name).map_or("", String::as_str);
    let variant = site.cycle.variant_param()?;
    if !list.has_variant(site.cycle) && parse(value(variant)) == Parsed::Expression {
        let finding = own::WRITE_VARIANT_OPEN.finding();
        return Some(finding.text("value", value(variant)));
    }
    let list = of_newer(site)?;
    let said = |name: &str, value: &str| {
        let finding = own::CONVERT_NEWER.finding().text("param", name);
        finding.text("value", value)
    };
    let target = arguments::only_newer(program, list, site.span);
    if let Some((name, text)) = target.iter().find(|(name, _)| *name == TOOL_TARGET) {
        return Some(said(name, text));
    }
    let name = newer::foreign(site.cycle, list, &site.values, control)?;
    Some(said(name, value(name)).at(name))
}

/// The argument of newer controls for the tool that is corrected.
const TOOL_TARGET: &str = "S_KNUM1";

/// The values of a call, those included that an omitted argument of a newer list stands for: other ways of writing take
/// what an earlier call left.
fn explicit(site: &CallSite, control: &Control) -> Typed {
    if of_newer(site).is_none() {
        return site.values.clone();
    }
    let mut values = newer::with_omitted(site.cycle, &site.values);
    let inputs = check::read(site.cycle, &values, control, &mut Vec::new());
    for param in site.cycle.params {
        let counts = param.need(&inputs).is_some() && !values.contains_key(param.name);
        if let Some(number) = param.fallback(control).filter(|_| counts) {
            values.insert(param.name.to_owned(), number.to_string());
        }
    }
    values
}

/// What only the list of the newer control says.
fn left_out(program: &Program, site: &CallSite) -> Option<Diagnostic> {
    let lost = arguments::only_newer(program, of_newer(site)?, site.span);
    let names: Vec<String> = lost
        .iter()
        .map(|(name, text)| format!("{name} = {text}"))
        .collect();
    let finding = own::CONVERT_LOST.finding().text("names", names.join(", "));
    (!names.is_empty()).then_some(finding)
}

fn rewritten(program: &Program, site: &CallSite, text: &str) -> Vec<Edit> {
    let marks = text.lines().next().and_then(Mark::read).is_some();
    let own = own_words(program, site, marks);
    let mut lines: Vec<String> = kept(program, site, &own);
    lines.extend(text.lines().map(str::to_owned));
    let call = lines.pop().unwrap_or_default();
    let mut edits: Vec<Edit> = emptied(program, &own, site.line);
    if let (true, Some((_, place))) = (marks, mark_before(program, site)) {
        edits.push(without_comment(program, place));
    }
    edits.push(Edit {
        span: site.span,
        insert: call,
    });
    if let (Some(block), false) = (program.blocks.get(site.line as usize), lines.is_empty()) {
        let end = line_end(program, site.line);
        let at = behind_label(program, site.line).unwrap_or(block.span.start);
        edits.push(Edit {
            span: Span { start: at, end: at },
            insert: lines.iter().map(|line| format!("{line}{end}")).collect(),
        });
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits
}

/// The words that give values to this call only, as far as they stand outside of it, by their line. `bits`: those that
/// set bits for it too.
fn own_words<'a>(
    program: &'a Program,
    site: &CallSite,
    bits: bool,
) -> BTreeMap<u32, Vec<&'a Word>> {
    let mut found: BTreeMap<u32, Vec<&Word>> = BTreeMap::new();
    let of_values = site.places.keys();
    let of_values = of_values.filter_map(|name| site.own_place(name));
    let of_bits = site.bits.iter().filter(|_| bits);
    let of_bits = of_bits.map(|(_, _, place)| *place);
    let of_bits =
        of_bits.filter(|place| site.own_from <= place.start && place.end <= site.span.end);
    let places = of_values.chain(of_bits).filter(|place| *place != site.span);
    for place in places {
        let Some(word) = program.word_at(place) else {
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
            edits.push(without_line(program, *line, block.span.start));
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

/// A line from a byte on, with its end.
fn without_line(program: &Program, line: u32, from: u32) -> Edit {
    let behind = program.blocks.get(line as usize + 1);
    removed(from, behind.map_or(program.end, |next| next.span.start))
}

/// A comment; a line without anything else goes with its end.
fn without_comment(program: &Program, comment: Span) -> Edit {
    let line = program.line_of(comment.start);
    match program.blocks.get(line as usize) {
        Some(block) if program.words_of(block).is_empty() => {
            without_line(program, line, block.span.start)
        }
        _ => removed(comment.start, comment.end),
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
fn means_the_same(one: &CallSite, other: &CallSite, control: &Control) -> bool {
    let inputs = |site: &CallSite| check::read(site.cycle, &site.values, control, &mut Vec::new());
    let (left, right) = (inputs(one), inputs(other));
    let same = |param: &Param| {
        left.number(param.name) == right.number(param.name)
            && left.text(param.name) == right.text(param.name)
    };
    one.cycle.params.iter().all(same)
}

/// Calls that would have other values afterwards.
fn others(
    program: &Program,
    sites: &[CallSite],
    index: usize,
    edits: &[Edit],
    control: &Control,
) -> Vec<Diagnostic> {
    if edits.is_empty() {
        return Vec::new();
    }
    let after = read(program.dialect, &apply(&program.source, edits));
    let after = calls_on(&after, control.clone());
    let mut findings = Vec::new();
    for (place, (before, after)) in sites.iter().zip(&after).enumerate() {
        if place != index && !means_the_same(before, after, control) {
            let finding = own::CONVERT_OTHERS.finding();
            findings.push(Diagnostic {
                span: Some(before.span),
                ..finding
                    .text("cycle", before.cycle.name)
                    .number("line", f64::from(before.line + 1))
            });
        }
    }
    findings
}
