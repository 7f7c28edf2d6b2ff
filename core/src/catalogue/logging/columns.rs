//! Title lines and lines of values as columns with names, to be put together by choosing.

use super::contents::{first_page, header_of, texts};
use super::line::{self, Field, RESULTS};
use super::names::{COLUMN, SEPARATOR, TITLES};
use super::simulate::put;
use crate::catalogue::CYCLES;
use crate::catalogue::prelude::*;
use crate::check::{Text, parse_text};
use crate::entry::{Column, Columns, Offer};
use crate::message::Message;
use std::collections::BTreeSet;

/// Texts that CYCLE118 fills (B:11320).
const FILLED: usize = 10;
/// Values where nothing has been measured yet: places in `_OVR[]` of setpoints, actual values and differences
/// (B:5681-5685), with the figures of the sample (B:11513-11638).
const SAMPLE: [(usize, f64); 3] = [(0, 80.0), (4, 79.987), (16, -0.013)];
/// Results of a sort: the size and one for each axis (B:5681-5685).
const OF_A_SORT: usize = 4;
/// The axis, the text and the time of the sample (B:11513-11638).
const SAMPLE_AXIS: f64 = 3.0;
const SAMPLE_TEXT: &str = "1";
const SAMPLE_TIME: &str = "09:35:12";
const SAMPLE_DATE: &str = "98/11/15";

/// A title line: its columns are texts.
pub fn titles(typed: &str, _: &Inputs, _: &Control) -> Option<Columns> {
    let comment = |text: &str| Message::new("log-column-comment").text("text", text.trim());
    let columns = split(typed, comment)?;
    let printed = inner(typed).filter(|text| !text.is_empty()).map(str::to_owned);
    Some(Columns { offers: vec![free()], printed: printed.into_iter().collect(), ..columns })
}

/// A line of values.
pub fn values(typed: &str, inputs: &Inputs, control: &Control) -> Option<Columns> {
    let results = results();
    let columns = split(typed, |text| label(text, &results))?;
    let control = sample(inputs, control);
    let (mut printed, mut narrow) = (Vec::new(), Vec::new());
    printed.extend(header_of(&control, SAMPLE_DATE, SAMPLE_TIME, first_page(&control)));
    printed.retain(|line: &String| !line.trim().is_empty());
    let line = inner(typed).filter(|line| !line.is_empty());
    let beyond = beyond();
    let mut marked = String::new();
    let of = |names: &BTreeSet<&str>| line.and_then(|line| texts(&control, line, names, SAMPLE_TIME));
    if let Some((texts, with_marks)) = of(&BTreeSet::new()).zip(of(&beyond.iter().map(String::as_str).collect())) {
        let widths = line::Columns::new(control.number(COLUMN.as_str()), control.text(TITLES[0].as_str()));
        let separator = control.text(SEPARATOR.as_str());
        printed.push(widths.line(&texts, separator));
        if with_marks != texts {
            marked = widths.line(&with_marks, separator);
        }
        let wider = texts.iter().enumerate().filter(|(column, text)| widths.narrow(*column, text));
        narrow.extend(wider.map(|(column, text)| {
            let message = Message::new("check-log-narrow").number("column", column as f64 + 1.0);
            let message = message.number("width", widths.width(column) as f64);
            message.number("needed", text.chars().count() as f64)
        }));
    }
    Some(Columns { offers: offers(&results), printed, marked, narrow, ..columns })
}

/// Results behind which a mark can stand: actual values and their differences (B:11439-11441, B:5681-5685).
fn beyond() -> Vec<String> {
    let places = [SAMPLE[1].0, SAMPLE[2].0].into_iter().flat_map(|first| first..first + OF_A_SORT);
    places.map(|place| format!("_OVR[{place}]")).collect()
}

/// The characters of a text; none of an expression.
fn inner(typed: &str) -> Option<&str> {
    match parse_text(typed) {
        Text::Plain(inner) => Some(inner),
        Text::Expression => None,
    }
}

/// The columns of a text as typed; all other characters stay where they are when one is added or taken away.
fn split(typed: &str, label: impl Fn(&str) -> Message) -> Option<Columns> {
    let inner = inner(typed)?;
    let blank = typed.len() - typed.trim_start().len();
    let quote = usize::from(inner.len() != typed.trim().len()); // only quotes are taken off
    let start = blank + quote;
    let (head, after) = (&typed[..start], &typed[start + inner.len()..]);
    if inner.trim().is_empty() {
        return Some(Columns { before: head.to_owned(), after: after.to_owned(), ..Columns::default() });
    }
    let parts: Vec<&str> = inner.split(',').collect();
    let column = |(index, part): (usize, &&str)| {
        let mut others = parts.clone();
        others.remove(index);
        Column {
            text: part.trim().to_owned(),
            label: label(part),
            without: format!("{head}{}{after}", others.join(",")),
        }
    };
    Some(Columns {
        list: parts.iter().enumerate().map(column).collect(),
        before: format!("{head}{inner},"),
        after: after.to_owned(),
        ..Columns::default()
    })
}

/// What a result is called by most of the cycles that leave it, by its place in `_OVR[]`.
fn results() -> Vec<Option<&'static str>> {
    (0..RESULTS).map(name_of).collect()
}

/// Of the keys of this place first the sort counts in which most cycles agree (`actual` of `result-actual-size`), so
/// that one cycle of its own does not name what many have as an actual value; then the key of that sort in most cycles.
fn name_of(place: usize) -> Option<&'static str> {
    let name = format!("_OVR[{place}]");
    let measuring = CYCLES.iter().filter(|cycle| cycle.is_measuring_cycle());
    let keys = |cycle: &&Cycle| -> BTreeSet<&'static str> {
        cycle.results.iter().filter(|one| one.name == name).map(|one| one.key).collect()
    };
    let by_cycle: Vec<_> = measuring.map(keys).collect();
    let sorts = by_cycle.iter().map(|keys| keys.iter().map(|key| sort(key)).collect::<BTreeSet<_>>());
    let chosen = most(sorts.flatten())?;
    most(by_cycle.iter().flatten().copied().filter(|key| sort(key) == chosen))
}

/// `actual` of `result-actual-size`.
fn sort(key: &'static str) -> &'static str {
    key.split('-').nth(1).unwrap_or_default()
}

/// The word that comes most often; of several the first.
fn most(words: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    let mut counts: Vec<(&'static str, usize)> = Vec::new();
    for word in words {
        match counts.iter_mut().find(|(known, _)| *known == word) {
            Some((_, count)) => *count += 1,
            None => counts.push((word, 1)),
        }
    }
    let highest = counts.iter().map(|(_, count)| *count).max()?;
    counts.iter().find(|(_, count)| *count == highest).map(|(word, _)| *word)
}

/// What a column shows.
fn label(text: &str, results: &[Option<&'static str>]) -> Message {
    let with = |key: &'static str, text: &str| Message::new(key).text("text", text);
    match line::field(text.trim()) {
        Field::Time => Message::new("log-column-time"),
        Field::Axis(None) => Message::new("log-column-axis"),
        Field::Axis(Some(place)) => Message::new("log-column-axis-place").number("place", place as f64 + 1.0),
        Field::Number(name) => {
            let key = line::result(&name.to_ascii_uppercase()).and_then(|place| results.get(place).copied().flatten());
            key.map_or_else(|| with("log-column-number", name), Message::new)
        }
        Field::Text(name) => with("log-column-text", name),
        Field::Comment(text) => with("log-column-comment", text),
        Field::Unknown(name) => with("log-column-unknown", name),
    }
}

/// What is typed by hand.
fn free() -> Offer {
    Offer { text: String::new(), label: Message::new("log-column-free") }
}

/// All that a line of values can show. A date comes into it as a text, from CYCLE113 (B:11258).
fn offers(results: &[Option<&'static str>]) -> Vec<Offer> {
    let named = results.iter().enumerate().filter(|(_, key)| key.is_some()).map(|(place, _)| format!("_OVR[{place}]"));
    let axes = ["_AXIS", "_AXIS1", "_AXIS2", "_AXIS3", "_TIME"].map(str::to_owned);
    let texts = (0..FILLED).map(|place| format!("_TXT[{place}]"));
    let all = named.chain(axes).chain(texts).chain(["R1".to_owned()]);
    let offer = |text: String| Offer { label: label(&text, results), text };
    all.map(offer).chain([free()]).collect()
}

/// The control as the call leaves it, with values to print: those that it has, else those of the sample.
fn sample(inputs: &Inputs, control: &Control) -> Control {
    let mut control = control.clone();
    put(&mut control, inputs);
    if (0..RESULTS).all(|place| control.number(&format!("_OVR[{place}]")) == 0.0) {
        for (first, value) in SAMPLE {
            (first..first + OF_A_SORT).for_each(|place| control.set(format!("_OVR[{place}]"), value));
        }
        if control.number(names::MA.as_str()) == 0.0 {
            control.set(names::MA.as_str(), SAMPLE_AXIS);
        }
    }
    if control.text("_TXT[0]").is_empty() {
        control.data.insert("_TXT[0]".into(), crate::control::Value::Text(SAMPLE_TEXT.into()));
    }
    control
}
