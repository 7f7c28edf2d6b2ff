//! Arguments of a call in brackets: where they stand, which list of the catalogue they fill, changes of one of them.

use super::calls::CallSite;
use super::change::Edit;
use super::values::{Value, opposite};
use crate::catalogue::newer::arguments::Argument;
use crate::diagnostic::Span;
use crate::entry::{AUXILIARY, Arg, ArgumentList, Cycle, Kind, Style};
use crate::name::Name;
use crate::syntax::{Program, WordKind};

/// Place of each argument of the call at `span`; an empty one where one is omitted.
pub(super) fn places(program: &Program, span: Span) -> Vec<Span> {
    let Some(WordKind::Call { args, .. }) = program.word_at(span).map(|word| &word.kind) else { return Vec::new() };
    args.iter().map(|id| program.place(*id)).collect()
}

/// Place and text of each argument, as the control reads it: with what macros say; no text where one is omitted.
pub(super) fn texts(program: &Program, span: Span) -> Vec<(Span, String)> {
    let Some(WordKind::Call { args, .. }) = program.word_at(span).map(|word| &word.kind) else { return Vec::new() };
    let text = |id| program.given(id).map_or_else(String::new, |id| program.said_of(id).trim().to_owned());
    args.iter().map(|id| (program.place(*id), text(*id))).collect()
}

/// Whether a place is an argument of a call.
pub(super) fn is_argument(program: &Program, place: Span) -> bool {
    program.word_at(place).is_some_and(|word| word.called().is_some())
}

/// Whether a place is an argument of `CYCLE_PARA`, where 0 says nothing.
pub(super) fn is_auxiliary(program: &Program, place: Span) -> bool {
    program.word_at(place).is_some_and(|word| program.is_call(word, &[AUXILIARY]))
}

/// Arguments of the list of a newer control that have no counterpart here and say something, by their names there.
pub(crate) fn only_newer(program: &Program, list: &'static ArgumentList, call: Span) -> Vec<(&'static str, String)> {
    let said = Argument::all(list).zip(texts(program, call)).filter_map(|(argument, (_, text))| {
        let nothing = text.is_empty() || text == "\"\"" || text.parse() == Ok(0.0) || text == USUAL_MODE;
        let mode = matches!(argument.name, "_DMODE" | "_AMODE");
        let says = argument.param.is_none() && !(nothing && (mode || text != USUAL_MODE));
        says.then_some((argument.key(), text))
    });
    said.collect()
}

/// Arguments of a call behind the last one of its list, by their places.
pub(super) fn beyond(
    program: &Program,
    list: &'static ArgumentList,
    call: Span,
) -> impl Iterator<Item = (usize, String)> {
    let all = texts(program, call).into_iter().enumerate().skip(list.args.len());
    all.filter(|(_, (_, text))| !text.is_empty()).map(|(index, (_, text))| (index + 1, text))
}

/// What programs of newer controls write in `_DMODE` and `_AMODE` of every call: it says nothing about the measurement.
const USUAL_MODE: &str = "1";

/// Edits that give an argument of the call's own list this text (empty: omitted). None: the list has no such argument.
pub(super) fn change(program: &Program, site: &CallSite, name: &str, text: &str) -> Option<Vec<Edit>> {
    let list = site.list?;
    if site.cycle.variant_param().is_some_and(|own| own == name) && !list.has_variant(site.cycle) {
        return Some(select(program, site, list, text).unwrap_or_default());
    }
    let index = list.position(site.cycle.param(name)?.name)?;
    let text = match list.args[index] {
        Arg::Down(_) => opposite(text),
        _ => text.to_owned(),
    };
    Some(put(program, site.span, index, &text).into_iter().collect())
}

/// Writes an argument at its index, with the commas that are missing before it.
pub(super) fn put(program: &Program, call: Span, index: usize, text: &str) -> Option<Edit> {
    let places = places(program, call);
    if let Some(place) = places.get(index) {
        return (program.text(*place) != text.as_bytes()).then(|| Edit::replace(*place, text));
    }
    if text.is_empty() {
        return None;
    }
    let closing = program.text(call).iter().rposition(|byte| *byte == b')');
    let commas = index - places.len().saturating_sub(1).min(index);
    let closing = closing.map_or(call.end, |at| call.start + at as u32);
    Some(Edit::insert(closing, format!("{}{text}", ",".repeat(commas))))
}

/// The variant as selections; only those that say something else change, of an expression what it is worth.
fn select(program: &Program, site: &CallSite, list: &ArgumentList, text: &str) -> Option<Vec<Edit>> {
    let selections = |text: &str| list.selections(text.trim().parse().ok()?);
    let mut wanted = selections(text)?.into_iter();
    let now = site.cycle.variant_param().and_then(|name| selections(site.values.get(name.as_str())?));
    let mut now = now.unwrap_or_default().into_iter();
    let places = places(program, site.span);
    let mut edits = Vec::new();
    for (index, _) in list.selects() {
        let (number, now) = (wanted.next()?, now.next());
        if places.get(index).map_or(Some(0), |place| written(program, *place).or(now)) != Some(number) {
            edits.extend(put(program, site.span, index, &number.to_string()));
        }
    }
    Some(edits)
}

/// The whole number at a place; 0 where it is omitted.
fn written(program: &Program, place: Span) -> Option<i64> {
    match std::str::from_utf8(program.text(place)).ok()? {
        "" => Some(0),
        text => text.parse().ok(),
    }
}

/// The first selection that only the run tells, as what the variant depends on.
pub(super) fn open_variant<'a>(
    cycle: &'static Cycle,
    list: &ArgumentList,
    arguments: &'a [Option<Value>],
) -> Option<(Name, &'a Value)> {
    let (index, _) = list.unselected(|index| number(arguments, index))?;
    let value = arguments.get(index)?.as_ref().filter(|value| value.number.is_none())?;
    Some((cycle.variant_param()?, value))
}

/// The number of an argument, 0 where it is omitted; none: only the run tells.
pub(super) fn number(arguments: &[Option<Value>], index: usize) -> Option<f64> {
    arguments.get(index).and_then(Option::as_ref).map_or(Some(0.0), |value| value.number)
}

/// Values of the parameters by the arguments and selections; an indirect call gives 0 or no text for an omitted one.
pub(super) fn given(
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    span: Span,
    arguments: &[Option<Value>],
) -> Vec<(Name, Value)> {
    let mut found = Vec::new();
    for (index, arg) in list.args.iter().enumerate() {
        let own = Argument::at(list, index);
        if own.param.is_none() && !own.key().is_empty() {
            let value = arguments.get(index).cloned().flatten();
            found.extend(value.map(|value| (Name::new(own.key()), value)));
        }
        let Some(name) = arg.param() else { continue };
        let omitted = || {
            let text = cycle.param(name.as_str()).is_some_and(|param| matches!(param.kind, Kind::Text(_)));
            if text { Value::at(String::new(), None, span) } else { Value::at("0".to_owned(), Some(0.0), span) }
        };
        let value = arguments.get(index).cloned().flatten().map(|value| match arg {
            Arg::Down(_) => value.opposite(),
            _ => value,
        });
        let value = value.or_else(|| (list.style == Style::Indirect).then(omitted));
        found.extend(value.map(|value| (name, value)));
    }
    if let Some((name, variant)) = list.composed(cycle, |index| number(arguments, index)) {
        found.push((name, Value::at(variant.to_string(), Some(variant as f64), span)));
    } else if let Some((name, value)) = open_variant(cycle, list, arguments) {
        found.push((name, value.clone()));
    }
    found
}
