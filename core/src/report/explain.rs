//! Answers to somebody who asks from a terminal, plain text: a cycle, one of its variants, a parameter, a result, a
//! datum of the machine.

use crate::catalogue::CYCLES;
use crate::entry::{Cycle, Variant};
use crate::manual::Cited;
use crate::message::Message;
use crate::report::{help, machine};
use crate::words::Words;
use std::fmt::Write;

/// A cycle: what it is for and its variants; the help page where there is only one.
pub fn cycle(cycle: &'static Cycle, words: &Words) -> String {
    if let [only] = cycle.variants {
        return variant(cycle, only, words);
    }
    let title = words.key(format!("{}-title", cycle.key));
    let mut text = format!("{}: {title}\n{}\n\n", cycle.name, summary(cycle, words));
    for variant in cycle.variants {
        let _ = writeln!(text, "{:>8}  {}", variant.number, words.key(variant.key));
    }
    text
}

/// The help page of a variant.
pub fn variant(cycle: &'static Cycle, variant: &Variant, words: &Words) -> String {
    let (number, title) = (variant.number, words.key(variant.key));
    let mut text = format!("{} {number}: {title}\n{}\n", cycle.name, summary(cycle, words));
    for (heading, items) in help::of_variant(cycle, variant, words) {
        let _ = writeln!(text, "\n{heading}\n  {}", items.join("\n  "));
    }
    text
}

fn summary(cycle: &Cycle, words: &Words) -> String {
    words.key(format!("{}-help", cycle.key))
}

/// What a name means, as a parameter, as a result and in the machine, each with where it does. Empty: nothing has this
/// name.
pub fn datum(asked: &str, words: &Words) -> String {
    let mut told: Vec<(String, Vec<String>)> = Vec::new();
    let mut tell = |meaning: String, whose: String| match told.iter_mut().find(|(known, _)| *known == meaning) {
        Some((_, owners)) if owners.contains(&whose) => {}
        Some((_, owners)) => owners.push(whose),
        None => told.push((meaning, vec![whose])),
    };
    for cycle in CYCLES {
        for param in cycle.params.iter().filter(|one| means(asked, one.name.as_str())) {
            let labels = param.labels.iter().map(|(_, key)| *key);
            for key in [param.key].into_iter().chain(labels) {
                tell(meaning(param.name.as_str(), &format!("param-{key}"), words), cycle.name.to_owned());
            }
        }
        for field in cycle.results.iter().filter(|one| means(asked, one.name)) {
            tell(meaning(field.name, field.key, words), cycle.name.to_owned());
        }
    }
    for (name, source, lines) in machine::told(|name| means(asked, name), words) {
        tell(format!("{name}: {}", lines.join("\n  ")), Cited(source).to_string());
    }
    let paragraph = |(meaning, owners): (String, Vec<String>)| format!("{meaning}\n  {}\n", owners.join(", "));
    told.into_iter().map(paragraph).collect()
}

/// Label and, where there is one, help.
fn meaning(name: &str, key: &str, words: &Words) -> String {
    let label = words.key(key.to_owned());
    match words.find(&Message::new(format!("{key}-help"))) {
        Some(help) => format!("{name}: {label}\n  {help}"),
        None => format!("{name}: {label}"),
    }
}

/// Whether somebody who asks for this means the datum: by its name, or by that of the array that it is in.
fn means(asked: &str, name: &str) -> bool {
    let array = name.split('[').next().unwrap_or(name);
    name.eq_ignore_ascii_case(asked) || array.eq_ignore_ascii_case(asked)
}
