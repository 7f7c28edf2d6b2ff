//! What an editor shows where the pointer rests: a value, a call, an alarm, a datum of the machine.

use super::known::{Document, Known, Valued, name_around};
use crate::alarms;
use probewright_core::app;
use probewright_core::foreign;
use probewright_core::form::{Choice, Entry, Field, Group};
use probewright_core::message::Message;
use probewright_core::program::calls::CallSite;
use probewright_core::program::lists::list_call;
use probewright_core::program::r_parameters::is_of_call;
use probewright_core::report::alarms::named;
use probewright_core::report::explain;
use probewright_core::report::findings::finding;
use probewright_core::report::foreign::{cycle, parameter};
use probewright_core::words::Words;

/// What there is to say at a byte, in the layout of `probewright explain`: lines, those of a list two blanks in.
pub fn at(document: &Document, known: &Known, at: u32, words: &Words) -> Option<String> {
    if let Some(told) = argument(known, at, words) {
        return Some(told);
    }
    if let Some(one) = known.valued(at).first() {
        return Some(value(known, one, at, words));
    }
    if let Some(site) = known.call(at) {
        return Some(call(known, site, words));
    }
    if let Some(told) = of_foreign_call(known, at, words) {
        return Some(told);
    }
    let name = name_around(document.text.as_str(), at as usize);
    let of_foreign = foreign::control_of(&known.program.source).map(|_| parameter(name, words)).unwrap_or_default();
    let newer = explain::list(name, words) + &explain::setting_datum(name, words);
    let own = explain::datum(name, words) + &finding(name, words) + &newer;
    let told = own + &of_older(known, name, words) + &of_foreign;
    let alarm = || named(name, words).or_else(|| named(&message_around(document, at as usize)?, words));
    let alarm = || alarm().map(|told| alarms::explained(&told, words));
    if told.is_empty() { alarm() } else { Some(told) }.filter(|_| !name.is_empty())
}

/// A probe cycle of a control that is read and not run, by its name.
fn of_foreign_call(known: &Known, at: u32, words: &Words) -> Option<String> {
    let source = &known.program.source;
    let calls = (foreign::control_of(source)?.calls)(source);
    let call = calls.into_iter().find(|call| call.span.start <= at && at <= call.span.end)?;
    Some(cycle(&call.name, words)).filter(|told| !told.is_empty())
}

/// An R parameter or a measuring call in a program with measuring calls of an 840C; a subprogram of older programs.
fn of_older(known: &Known, name: &str, words: &Words) -> String {
    let is_840c = || known.found.iter().any(is_of_call);
    let counts = name.to_ascii_uppercase().starts_with("CYCLE") || is_840c();
    if counts { explain::older(name, words) } else { String::new() }
}

/// The text for the operator or alarm of several words that a byte is in: `PROBE FAIL`.
fn message_around(document: &Document, at: usize) -> Option<String> {
    let position = document.text.position(at);
    let (before, _) = document.text.before(position);
    let start = at - before.len();
    let line = document.text.as_str().get(start..)?.lines().next()?;
    let around = |code: &String| {
        line.match_indices(code.as_str()).any(|(from, _)| (from..=from + code.len()).contains(&before.len()))
    };
    app::alarms().into_iter().map(|alarm| alarm.code).find(|code| code.contains(' ') && around(code))
}

/// An argument of a list of newer controls, and what its value says by the form of the call that it reaches.
fn argument(known: &Known, at: u32, words: &Words) -> Option<String> {
    let calls = list_call(&known.program, known.word(at)?)?;
    let one = calls.at(at)?;
    let told = explain::argument(&one.argument, words);
    let valued = known.valued(at).into_iter().find(|valued| one.argument.param == Some(valued.name));
    Some(valued.map_or_else(|| told.clone(), |valued| format!("{told}\n{}", value(known, &valued, at, words))))
}

/// A call: the help page of its variant, where that is known; in the list of a newer control its arguments, because the
/// page is that of the older one.
fn call(known: &Known, site: &CallSite, words: &Words) -> String {
    let chosen = known.variant(site);
    if let Some(list) = site.newer_list() {
        let number = chosen.map_or_else(String::new, |number| format!(" {number}"));
        let title = words.text(&known.title(site));
        return format!("{}{number}: {title}\n\n{}", list.name, explain::list(list.name, words));
    }
    let variant = site.cycle.variants.iter().find(|one| chosen == Some(one.number));
    variant.map_or_else(|| explain::cycle(site.cycle, words), |one| explain::variant(site.cycle, one, words))
}

/// A value by the form of the call that it reaches.
fn value(known: &Known, one: &Valued, at: u32, words: &Words) -> String {
    let fields = known.fields(one.site);
    match fields.into_iter().find(|field| field.name == one.name) {
        Some(field) => told(&field, &digit(known, one, at), one, words),
        None => explain::datum(&one.name, words),
    }
}

/// The place (1, 10, 100, …) of the digit at a byte, where the value is written as a plain number.
fn digit(known: &Known, one: &Valued, at: u32) -> Option<i64> {
    let text = known.program.written(one.place);
    let start = text.rfind('=').map_or(0, |sign| sign + 1);
    let digits = text.get(start..)?.trim();
    let first = one.place.start as usize + start + text.get(start..)?.find(digits)?;
    let before = (at as usize).checked_sub(first)?;
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit()) && digits.len() < 16;
    let behind = digits.len().checked_sub(before.min(digits.len().saturating_sub(1)) + 1)?;
    (plain && !digits.is_empty()).then(|| 10_i64.pow(behind as u32))
}

/// Name, meaning, unit, and what the number says.
fn told(field: &Field, digit: &Option<i64>, one: &Valued, words: &Words) -> String {
    let mut lines = vec![format!("{}: {}", field.name, words.text(&field.label))];
    lines.extend(words.find(&field.help).map(|help| format!("  {help}")));
    let said = |key: &'static str, name: &'static str, value: String| {
        format!("  {}", words.text(&Message::new(key).text(name, value)))
    };
    if !field.unit.is_empty() {
        lines.push(said("server-unit", "unit", field.unit.to_owned()));
    }
    if let Some(value) = field.fallback {
        lines.push(format!("  {}", words.text(&Message::new("server-fallback").number("value", value))));
    }
    lines.extend(words.find(&field.reason).map(|reason| format!("  {reason}")));
    lines.push(said("server-source", "source", field.source.to_string()));
    let number = one.site.values.get(&*one.name).and_then(|text| text.trim().parse::<f64>().ok());
    let number = number.map(|number| number as i64);
    match &field.entry {
        Entry::Choice { choices } => {
            let chosen = choices.iter().find(|choice| number == Some(choice.value));
            lines.extend(chosen.map(|choice| format!("\n{}", choice_text(choice, words))));
        }
        Entry::Digits { digits } => {
            lines.push(format!("\n{}", number.map_or_else(|| field.value.clone(), |number| number.to_string())));
            lines.extend(digits.iter().map(|group| group_text(group, *digit, words)));
        }
        _ => {}
    }
    lines.join("\n") + "\n"
}

fn choice_text(choice: &Choice, words: &Words) -> String {
    format!("{}: {}", choice.value, words.text(&choice.label))
}

/// A group of digits; the one under the pointer is marked.
fn group_text(group: &Group, digit: Option<i64>, words: &Words) -> String {
    let above = group.place.saturating_mul(10_i64.saturating_pow(group.digits));
    let here = digit.is_some_and(|place| group.place <= place && place < above);
    let chosen = group.choices.iter().find(|choice| choice.value == group.value);
    let value = chosen.map_or_else(|| group.value.to_string(), |choice| choice_text(choice, words));
    format!("  {}{}: {value}", if here { "→ " } else { "" }, words.text(&group.label))
}

/// Lines of `probewright explain` as Markdown: the first one and those above a list are headings.
pub fn markdown(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut out = String::new();
    for (at, line) in lines.iter().enumerate() {
        let listed = |line: &&&str| line.starts_with("  ");
        let heads = at == 0 || lines.get(at + 1).as_ref().is_some_and(listed);
        out += &match line.strip_prefix("  ") {
            _ if line.is_empty() => String::new(),
            Some(item) => format!("- {}\n", escaped(item.trim())),
            None if heads => format!("\n**{}**\n\n", escaped(line)),
            None => format!("{}\n", escaped(line)),
        };
    }
    out.trim().to_owned()
}

/// Text in which nothing is Markdown.
fn escaped(text: &str) -> String {
    let marks = |one: char| "\\`*_[]<>#|".contains(one);
    text.chars().flat_map(|one| marks(one).then_some('\\').into_iter().chain([one])).collect()
}
