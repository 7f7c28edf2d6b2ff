//! Changes of one value as edits of the text; every other byte stays.

use super::calls::{CallSite, Origin};
use super::lists::{ListCall, list_call, set};
use super::{arguments, write};
use crate::catalogue::newer::arguments::Argument;
use crate::check::{Parsed, Text, expression::shown, newer, parse, parse_text};
use crate::control::delivery;
pub use crate::diagnostic::Edit;
use crate::diagnostic::Span;
use crate::entry::{Arg, Kind, names};
use crate::syntax::{Block, Program, Word};

/// Gives a parameter of a call this value, as typed; an empty one takes the parameter away.
/// A value that an earlier call or another parameter shares is left alone: the call gets an assignment of its own.
pub fn change(program: &Program, site: &CallSite, name: &str, value: &str) -> Vec<Edit> {
    let Some(param) = site.cycle.param(name) else { return of_list(program, site, name, value) };
    let (name, text) = (param.name.as_str(), matches!(param.kind, Kind::Text(_)));
    // what cannot be written as one value stays in the form, where its problem is told
    let written = write::value(program.dialect, param, value).unwrap_or_default();
    if written.is_empty() && !value.trim().is_empty() {
        return Vec::new();
    }
    let calculated = !text && parse(value) == Parsed::Expression;
    let value = if text || calculated { written } else { plain(value) };
    if param.name == names::KNUM && takes_no_tool(program, site, &value) {
        return Vec::new();
    }
    if let Some(edits) = arguments::change(program, site, name, &value) {
        // what a macro says stays
        let own = edits.iter().all(|edit| !program.is_of_macro(edit.span)) && !program.is_of_macro(site.span);
        return if own { edits } else { Vec::new() };
    }
    if site.newer_list().is_some() {
        return Vec::new();
    }
    if let Some(edits) = elsewhere(program, site, name, &value) {
        return edits;
    }
    match site.own_place(name) {
        Some(place) if program.is_of_macro(place) => {
            add(program, site, name, &value).filter(|_| !value.is_empty()).into_iter().collect()
        }
        Some(place) if program.text(around(program, place)) == value.as_bytes() => Vec::new(),
        Some(place) if arguments::is_auxiliary(program, place) && nothing(&value) => {
            let anew = add(program, site, name, &value).filter(|_| !value.is_empty());
            std::iter::once(Edit::replace(place, "")).chain(anew).collect()
        }
        Some(place) if value.is_empty() => vec![remove(program, place)],
        Some(place) => vec![replace(program, place, value)],
        None if value.is_empty() => Vec::new(),
        None => add(program, site, name, &value).into_iter().collect(),
    }
}

/// A value that only the list of a newer control has, by its name there.
fn of_list(program: &Program, site: &CallSite, name: &str, value: &str) -> Vec<Edit> {
    let call = site.newer_list().and_then(|_| list_call(program, program.word_at(site.span)?));
    let own = |call: &ListCall| call.index(name).filter(|index| Argument::at(call.list, *index).param.is_none());
    let edit = call.and_then(|call| set(program, &call, own(&call)?, &plain(value)));
    edit.into_iter().collect()
}

/// Whether a new `_KNUM` would be a tool target in the list of a newer control, where it has an argument of its own. A
/// number of a zero offset is none: that this variant corrects none is told at its field.
fn takes_no_tool(program: &Program, site: &CallSite, value: &str) -> bool {
    if matches!(parse(value), Parsed::Number(number) if newer::is_newer_zero(number)) {
        return false;
    }
    let mut values = site.values.clone();
    values.insert(names::KNUM.to_string(), value.to_owned());
    site.newer_list().is_some() && newer::has_tool_target(site.cycle, &values, &delivery(program.dialect))
}

/// Edits of a value that is written in other programs of the text, or on more ways than one: of each place where all
/// give the same, of none where they differ. None: they belong to other calls too, and this one gets its own.
fn elsewhere(program: &Program, site: &CallSite, name: &str, value: &str) -> Option<Vec<Edit>> {
    let origins = site.origins.get(name)?;
    if site.differs(name) || site.is_of_many(name) {
        return Some(Vec::new());
    }
    if !origins.iter().all(|origin| origin.own) {
        return None;
    }
    let whole = |place: Span| program.word_at(place).is_some_and(|word| word.span == place);
    if origins.iter().any(|origin| program.is_of_macro(origin.place)) {
        return Some(Vec::new());
    }
    if origins.iter().filter(|origin| origin.argument).any(|origin| value.is_empty() || whole(origin.place)) {
        return Some(Vec::new()); // an argument is not taken away, and none is added
    }
    let mut edits: Vec<Edit> = Vec::new();
    for Origin { place, .. } in origins {
        let same = program.text(around(program, *place)) == value.as_bytes();
        let gone = value.is_empty();
        let edit = if gone { remove(program, *place) } else { replace(program, *place, value.to_owned()) };
        if !same && !edits.contains(&edit) {
            edits.push(edit);
        }
    }
    Some(edits)
}

/// The place of a value with the quotes around it.
fn around(program: &Program, place: Span) -> Span {
    let byte = |at: Option<u32>| at.and_then(|at| program.source.get(at as usize));
    match [place.start.checked_sub(1), Some(place.end)].map(byte) {
        [Some(b'"'), Some(b'"')] => Span { start: place.start - 1, end: place.end + 1 },
        _ => place,
    }
}

/// Another value at a place; quotes that stand there already stay.
fn replace(program: &Program, place: Span, value: String) -> Edit {
    let whole = around(program, place);
    match parse_text(&value) {
        Text::Plain(inner) if whole != place => Edit::replace(place, inner),
        _ => Edit::replace(whole, value),
    }
}

/// The program after edits, in any order and without overlap; one that overlaps an earlier one is left out.
pub fn apply(source: &[u8], edits: &[Edit]) -> Vec<u8> {
    let mut ordered: Vec<&Edit> = edits.iter().collect();
    ordered.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut result = Vec::with_capacity(source.len() + 32);
    let mut at = 0;
    for edit in ordered {
        let (start, end) = (edit.span.start as usize, edit.span.end as usize);
        let Some(kept) = source.get(at..start).filter(|_| end >= start && end <= source.len()) else { continue };
        result.extend_from_slice(kept);
        result.extend_from_slice(edit.insert.as_bytes());
        at = end;
    }
    result.extend_from_slice(source.get(at..).unwrap_or_default());
    result
}

/// What `CYCLE_PARA` cannot give: 0 keeps the datum there (B:11734).
fn nothing(value: &str) -> bool {
    value.is_empty() || value.parse() == Ok(0.0)
}

/// The name under which the program writes a parameter: an element of the array that it hands to the call, if it does.
fn written_name(program: &Program, site: &CallSite, name: &str) -> Option<String> {
    let places = arguments::places(program, site.span);
    let own = site.list.map_or(&[][..], |list| list.args).iter().zip(places).find_map(|(arg, place)| match arg {
        Arg::Variable(array) => {
            let element = name.strip_prefix(array)?;
            let variable = program.name(place);
            Some(is_array(&variable).then(|| format!("{variable}{element}")))
        }
        _ => None,
    });
    own.unwrap_or_else(|| Some(name.to_owned()))
}

/// Whether this is a name in upper case, and not that of a single arithmetic parameter.
fn is_array(name: &str) -> bool {
    let letters = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    letters && name.strip_prefix('R').unwrap_or(name).bytes().any(|byte| !byte.is_ascii_digit())
}

/// A typed number with its decimal comma as a point, and without an exponent, which each control writes otherwise.
fn plain(value: &str) -> String {
    let trimmed = value.trim();
    match parse(trimmed) {
        Parsed::Number(number) if trimmed.contains(['e', 'E']) => shown(number),
        Parsed::Number(_) => trimmed.replace(',', "."),
        _ => trimmed.to_owned(),
    }
}

/// Takes away the word around a place, with the blanks before it (behind it, if it is the line's first).
fn remove(program: &Program, place: Span) -> Edit {
    let span = word_around(program, place);
    let block = program.blocks.get(program.line_of(place.start) as usize);
    let line = block.map_or(span, |block| block.span);
    match blanks_before(program, line, span.start) {
        start if start > line.start => Edit::remove(start, span.end),
        _ => Edit::remove(span.start, blanks_behind(program, line, span.end)),
    }
}

fn is_blank(byte: &&u8) -> bool {
    matches!(byte, b' ' | b'\t')
}

/// Where the blanks before a place of a line begin.
pub(super) fn blanks_before(program: &Program, line: Span, at: u32) -> u32 {
    at - program.text(Span { end: at, ..line }).iter().rev().take_while(is_blank).count() as u32
}

/// Where the blanks behind a place of a line end.
pub(super) fn blanks_behind(program: &Program, line: Span, at: u32) -> u32 {
    at + program.text(Span { start: at, ..line }).iter().take_while(is_blank).count() as u32
}

/// The whole assignment around a value; the value itself where it is an element of a list.
pub(super) fn word_around(program: &Program, place: Span) -> Span {
    let Some(word) = program.word_at(place) else { return place };
    let between = |start, end| program.text(Span { start, end });
    let element = between(word.span.start, place.start).contains(&b',') && !program.grammar().by_address;
    if element || between(place.end, word.span.end).contains(&b',') { place } else { word.span }
}

/// Writes a new value behind the call's last one, if the program goes straight on from there, else on a line before it.
fn add(program: &Program, site: &CallSite, name: &str, value: &str) -> Option<Edit> {
    let by_address = program.grammar().by_address;
    let written =
        if by_address { format!("{name}{value}") } else { format!("{}={value}", written_name(program, site, name)?) };
    let own = site.places.keys().filter_map(|name| site.place_of_its_own(name)).filter(|place| {
        let before = site.behind <= place.start && program.line_of(place.start) <= site.line;
        before && !arguments::is_argument(program, *place)
    });
    let last =
        own.max_by_key(|place| place.start).map(|place| program.word_at(place).map_or(place.end, |word| word.span.end));
    let last = last.filter(|end| goes_straight(program, *end, site.span.start));
    Some(match last {
        Some(end) => Edit::insert(end, format!(" {written}")),
        None if by_address => Edit::insert(site.span.end, format!(" {written}")),
        None => line_at_begin(program, site.line, &written)
            .unwrap_or_else(|| Edit::insert(site.span.start, format!("{written} "))),
    })
}

/// Whether the program comes from the line of one place to another on no way but past every line between.
fn goes_straight(program: &Program, from: u32, to: u32) -> bool {
    let line = |place: u32| program.line_of(place) as usize;
    let skips = program.blocks.get(line(from)..line(to)).into_iter().flatten().any(|block| block.skip.is_some());
    let first = program.words.partition_point(|word| word.span.end < from);
    let words = program.words.get(first..).unwrap_or_default();
    let turns = |word: &Word| word.keyword().or(word.label()).is_some();
    !skips && !words.iter().take_while(|word| word.span.start < to).any(turns)
}

/// Writes a line of its own before this line; where a jump may come to the line, behind its label.
pub(super) fn line_at_begin(program: &Program, line: u32, written: &str) -> Option<Edit> {
    match behind_label(program, line) {
        Some(at) => Some(Edit::insert(at, format!("{written}{}", line_end(program, line)))),
        None => line_before(program, line, written),
    }
}

/// Where a line goes on behind its label; none: it has no label, or nothing behind it.
pub(super) fn behind_label(program: &Program, line: u32) -> Option<u32> {
    let mut from_label = program.words_at(line as usize).iter().skip_while(|word| word.label().is_none());
    Some(from_label.find(|word| word.label().is_none())?.span.start)
}

/// Writes a line of its own before this line, indented and numbered like it.
pub(super) fn line_before(program: &Program, line: u32, written: &str) -> Option<Edit> {
    let block = program.blocks.get(line as usize)?;
    let indent = program.written(Span { end: blanks_behind(program, block.span, block.span.start), ..block.span });
    let number = number_between(program, line, block).map_or(String::new(), |number| format!("N{number} "));
    Some(Edit::insert(block.span.start, format!("{indent}{number}{written}{}", line_end(program, line))))
}

/// A block number between the line's own and the one before it, if there is room.
fn number_between(program: &Program, line: u32, block: &Block) -> Option<u64> {
    let read = |span: Span| std::str::from_utf8(program.text(span)).ok()?.get(1..)?.parse::<u64>().ok();
    let own = read(block.number?)?;
    let before = program.blocks.get(..line as usize)?.iter().rev().find_map(|block| block.number);
    let before = before.map_or(Some(0), read)?;
    let middle = before + own.checked_sub(before)? / 2;
    (middle > before && middle < own).then_some(middle)
}

/// How this line, else the one before it, ends.
pub(super) fn line_end(program: &Program, line: u32) -> &'static str {
    let ends = |line: usize| {
        let end = program.blocks.get(line)?.span.end as usize;
        let rest = program.source.get(end..program.end as usize)?;
        (!rest.is_empty()).then_some(if rest.starts_with(b"\r\n") { "\r\n" } else { "\n" })
    };
    ends(line as usize).or_else(|| ends((line as usize).checked_sub(1)?)).unwrap_or("\n")
}
