//! The help of a cycle in `docs/cycles/`: first what is true of every variant, then what each says beside it; variants
//! that say the same stand together. For the terminal the page of one variant, plain.

use crate::app::whereabouts;
use crate::catalogue::help::HelpPage;
use crate::entry::{Cycle, SECTIONS, Section, Variant};
use crate::manual::Cited;
use crate::report;
use crate::report::markdown::line;
use crate::words::Words;

/// Something that a help page says.
#[derive(Clone, PartialEq)]
enum Said {
    /// A sentence, with its place in the manual.
    Line(Section, String),
    /// A value that has to be given.
    Value(&'static str),
    /// An alarm that can come.
    Alarm(String),
    /// Where it is on the control.
    Place(String),
}

impl Said {
    /// Where it stands; none: behind all sections.
    fn section(&self) -> Option<Section> {
        match self {
            Said::Line(section, _) => Some(*section),
            Said::Value(_) => Some(Section::Before),
            Said::Alarm(_) => Some(Section::Wrong),
            Said::Place(_) => None,
        }
    }
}

/// Appends the help of a cycle.
pub fn help(text: &mut String, cycle: &'static Cycle, words: &Words) {
    let pages: Vec<(&Variant, Vec<Said>)> =
        cycle.variants.iter().map(|variant| (variant, said(cycle, variant, words))).collect();
    let Some((_, first)) = pages.first() else { return };
    let of_all = |one: &Said| pages.iter().all(|(_, page)| page.contains(one));
    let every: Vec<Said> = first.iter().filter(|one| of_all(one)).cloned().collect();
    line(text, &format!("## {}", words.key("report-about")));
    if pages.len() > 1 {
        line(text, &format!("### {}", words.key("report-every-variant")));
    }
    write(text, cycle, &every, words);
    for (own, variants) in groups(&pages, &every) {
        line(text, &title(&variants, words));
        write(text, cycle, &own, words);
    }
}

fn said(cycle: &'static Cycle, variant: &Variant, words: &Words) -> Vec<Said> {
    let page = HelpPage::of(cycle, variant.number);
    let sentence = |key, source| format!("{} ({source})", words.key(key));
    let lines = page.lines.iter().map(|line| Said::Line(line.section, sentence(line.key, Cited(line.source))));
    let values = page.required.iter().map(|name| Said::Value(name.as_str()));
    let alarms = page.alarms.iter().map(|alarm| Said::Alarm(alarm.to_string()));
    let places = whereabouts(cycle, variant.number);
    let places = places.iter().map(|one| Said::Place(format!("{} ({})", words.text(&one.message), one.source)));
    lines.chain(values).chain(alarms).chain(places).collect()
}

/// What variants say beside what all say, each with the variants that say the same, in the order of the variants.
fn groups<'a>(pages: &[(&'a Variant, Vec<Said>)], every: &[Said]) -> Vec<(Vec<Said>, Vec<&'a Variant>)> {
    let mut groups: Vec<(Vec<Said>, Vec<&Variant>)> = Vec::new();
    for (variant, page) in pages {
        let own: Vec<Said> = page.iter().filter(|one| !every.contains(one)).cloned().collect();
        match groups.iter_mut().find(|(known, _)| *known == own) {
            Some((_, variants)) => variants.push(variant),
            None => groups.push((own, vec![variant])),
        }
    }
    groups.retain(|(own, _)| !own.is_empty());
    groups
}

/// The variants of a group by number and name.
fn title(variants: &[&Variant], words: &Words) -> String {
    let names: Vec<String> =
        variants.iter().map(|variant| format!("{} {}", variant.number, words.key(variant.key))).collect();
    format!("### {}", names.join(" / "))
}

/// The help page of a variant: headings, each with its sentences.
pub fn of_variant(cycle: &'static Cycle, variant: &Variant, words: &Words) -> Vec<(String, Vec<String>)> {
    sections(cycle, &said(cycle, variant, words), "", words)
}

fn write(text: &mut String, cycle: &Cycle, page: &[Said], words: &Words) {
    for (heading, items) in sections(cycle, page, "`", words) {
        line(text, &format!("**{heading}**"));
        line(text, &format!("- {}", items.join("\n- ")));
    }
}

/// The sections that say something; names of values are in marks.
fn sections(cycle: &Cycle, page: &[Said], mark: &str, words: &Words) -> Vec<(String, Vec<String>)> {
    let mut sections = Vec::new();
    for section in SECTIONS {
        let (mut items, mut values, mut alarms) = (Vec::new(), Vec::new(), Vec::new());
        for one in page.iter().filter(|one| one.section() == Some(section)) {
            match one {
                Said::Line(_, sentence) => items.push(sentence.clone()),
                Said::Value(name) => values.push(format!("{mark}{name}{mark}")),
                Said::Alarm(code) => alarms.push(code.clone()),
                Said::Place(_) => {}
            }
        }
        items.extend(listed("help-values", &values, words));
        items.extend(listed("help-alarms", &alarms, words));
        if !items.is_empty() {
            sections.push((words.key(section.key(cycle.purpose.probe)), items));
        }
    }
    let place = |one: &Said| match one {
        Said::Place(sentence) => Some(sentence.clone()),
        _ => None,
    };
    let places: Vec<String> = page.iter().filter_map(place).collect();
    sections.extend((!places.is_empty()).then(|| (words.key("where-title"), places)));
    sections
}

/// A sentence that lists names; none without names.
fn listed(key: &'static str, names: &[String], words: &Words) -> Option<String> {
    (!names.is_empty()).then(|| report::said(words, key, &[("names", names.join(", "))]))
}
