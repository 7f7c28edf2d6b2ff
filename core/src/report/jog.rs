//! Measuring in JOG as a person reads it: in `docs/jog.md` every mask with its help, fields, results and alarms; in the
//! terminal the help of one.

use crate::app::{HelpText, whereabouts_in_jog};
use crate::catalogue::alarms;
use crate::control::OLDER_JOG;
use crate::diagnostic::Code;
use crate::jog::help::{Line, alarms as raised, cure, help};
use crate::jog::mask::{Field, Kind, Least, Mask, Show, key};
use crate::jog::practice::{machine, piece};
use crate::jog::values::taken as choices;
use crate::jog::{FUNCTIONS, Input, Session, masks};
use crate::manual::Cited;
use crate::message::Message;
use crate::report::markdown::{line, rows, table};
use crate::report::said;
use crate::words::Words;
use std::collections::BTreeSet;
use std::fmt::Write;

/// The page of all masks, Markdown.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-jog")));
    line(&mut text, &words.key("report-jog-intro"));
    line(&mut text, &words.key("report-generated"));
    for (area, masks) in masks::menu(FUNCTIONS) {
        line(&mut text, &format!("## {}", words.key(area.key())));
        masks.into_iter().for_each(|mask| section(&mut text, mask, words));
    }
    line(&mut text, &format!("## {}", words.key("report-jog-older")));
    line(&mut text, &words.key("report-jog-older-intro"));
    masks::all().filter(|mask| mask.older.is_some()).for_each(|mask| section(&mut text, mask, words));
    let known: BTreeSet<Code> = masks::all().flat_map(raised).collect();
    let cells = |code: Code| {
        let raise = masks::all().filter(|mask| raised(mask).contains(&code));
        let cures: BTreeSet<String> = raise.map(|mask| cure(code, Some(mask))).collect();
        let cures: Vec<String> = cures.into_iter().map(|key| words.key(key)).collect();
        [code.to_string(), words.key(alarms::key(code)), cures.join(" ")]
    };
    let columns = ["number", "meaning", "cure"];
    table(&mut text, &words.key("report-alarms-raised"), columns, known.into_iter().map(cells), words);
    text.trim_end().to_owned() + "\n"
}

/// The help of a mask, plain.
pub fn explained(mask: &'static Mask, words: &Words) -> String {
    let mut text = format!("{}: {}\n", mask.name, words.key(key("mask", mask.name)));
    for (heading, items) in sections(mask, words) {
        let _ = writeln!(text, "\n{heading}\n  {}", items.join("\n  "));
    }
    text
}

fn section(text: &mut String, mask: &'static Mask, words: &Words) {
    line(text, &format!("### {}", words.key(key("mask", mask.name))));
    let named = [("mask", format!("`mask {}`", mask.name)), ("source", Cited(mask.source).to_string())];
    line(text, &said(words, "report-jog-mask", &named));
    for (heading, items) in sections(mask, words) {
        line(text, &format!("**{heading}**"));
        line(text, &format!("- {}", items.join("\n- ")));
    }
    let session = opened(mask);
    let fields = mask.fields.iter().map(|field| cells(&session, field, words));
    rows(text, ["name", "meaning", "range", "unit", "when", "source"], fields, words);
    let results = mask.shows.iter().filter_map(|show| match show {
        Show::Length(name) | Show::Angle(name) => Some(words.text(&session.label("result", name))),
        _ => None,
    });
    let results: Vec<String> = results.collect();
    if !results.is_empty() {
        line(text, &said(words, "report-jog-results", &[("names", results.join(", "))]));
    }
}

/// The mask as it is opened on the machine to practise on.
fn opened(mask: &'static Mask) -> Session {
    let mut setup = machine(piece(mask));
    setup.control.set(OLDER_JOG, f64::from(u8::from(mask.older.is_some())));
    let mut session = Session::new(&setup);
    // every mask that is listed can be opened from the bar
    let _ = session.press(Input::Function(mask.name));
    session
}

/// Headings with their sentences, the alarms behind what goes wrong.
fn sections(mask: &'static Mask, words: &Words) -> Vec<(String, Vec<String>)> {
    let sentence = |one: &Line| format!("{} ({})", words.key(one.key), Cited(one.source));
    let of = |(heading, lines): (&'static str, Vec<&'static Line>)| {
        (words.key(heading), lines.into_iter().map(sentence).collect())
    };
    let mut sections: Vec<(String, Vec<String>)> = help(mask).into_iter().map(of).collect();
    let codes: Vec<String> = raised(mask).iter().map(ToString::to_string).collect();
    if let Some((_, last)) = sections.last_mut() {
        last.push(said(words, "help-alarms", &[("names", codes.join(", "))]));
    }
    let place = |one: &HelpText| format!("{} ({})", words.text(&one.message), one.source);
    sections.push((words.key("where-title"), whereabouts_in_jog(mask).iter().map(place).collect()));
    sections
}

/// A field: name in a script, what it is called, what it takes, unit, when it is shown, source.
fn cells(session: &Session, field: &'static Field, words: &Words) -> [String; 6] {
    let label = words.text(&session.label("field", field.name));
    let (range, unit) = match field.kind {
        Kind::Length(Least::Any) => (String::new(), "mm"),
        Kind::Length(Least::Zero) => ("≥ 0".to_owned(), "mm"),
        Kind::Length(Least::Above) => ("> 0".to_owned(), "mm"),
        Kind::Angle => (String::new(), "°"),
        _ => (taken(session, field, words), ""),
    };
    let shown = field.when.iter().map(|(name, is)| format!("`{name}` = {}", is.join(", ")));
    let shown = shown.collect::<Vec<_>>().join(&format!(" {} ", words.key("report-and")));
    [format!("`{}`", field.name), label, range, unit.to_owned(), shown, Cited(field.source).to_string()]
}

/// The words from which a field chooses, each with what it is called.
fn taken(session: &Session, field: &'static Field, words: &Words) -> String {
    let known = choices(field, session.values(), &session.sim.control).unwrap_or_default();
    let one = |word: String| match words.find(&Message::new(key("word", &word))) {
        Some(label) => format!("`{word}` ({label})"),
        None => format!("`{word}`"),
    };
    known.into_iter().map(one).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::held;

    // oracle: self. With PROBEWRIGHT_UPDATE=1 the page is written instead.
    #[test]
    fn the_page_in_docs_is_that_of_the_masks() {
        held("jog.md", page);
    }
}
