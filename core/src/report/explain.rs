//! Answers to somebody who asks from a terminal, plain text: a cycle, one of its variants, a parameter, a result, a
//! datum of the machine.

use crate::catalogue::newer::LISTS;
use crate::catalogue::newer::arguments::Argument;
use crate::catalogue::{CYCLES, r_parameters, subroutines};
use crate::control::idle::idle;
use crate::control::machine_data::MACHINE_DATA;
use crate::control::versions::{Versions, versions};
use crate::control::{OF_LISTS, setting_data};
use crate::entry::{Cycle, Variant};
use crate::manual::Cited;
use crate::message::Message;
use crate::name::Name;
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
    // a machine datum has its elements by their numbers: what is told is the same of all
    let array = asked.split('[').next().filter(|stem| machine_datum(stem)).unwrap_or(asked);
    for (name, source, mut lines) in machine::told(|name| means(asked, name) || means(array, name), words) {
        let datum = name.split(' ').next().unwrap_or_default();
        lines.extend(versions(datum).map(|found| version(found, words)));
        lines.extend(idle(datum).then(|| words.key("explain-idle")));
        let whose = if source.is_empty() { String::new() } else { Cited(source).to_string() };
        tell(format!("{name}: {}", lines.join("\n  ")), whose);
    }
    let paragraph = |(meaning, owners): (String, Vec<String>)| match owners.join(", ") {
        none if none.is_empty() => format!("{meaning}\n"),
        owners => format!("{meaning}\n  {owners}\n"),
    };
    told.into_iter().map(paragraph).collect()
}

/// `From measuring cycles SW 6.3.`
fn version(found: &Versions, words: &Words) -> String {
    let message = Message::new(if found.until.is_empty() { "version-from" } else { "version-until" });
    words.text(&message.text("from", found.from).text("until", found.until))
}

/// An argument of a list of newer controls: name, meaning, and how that is known.
pub fn argument(argument: &Argument, words: &Words) -> String {
    let place = Message::new("argument-place").number("place", argument.place as f64).text("cycle", argument.list.name);
    format!("{}\n  {}\n  {}\n", heading(argument, words), words.text(&place), about(argument, words).join("\n  "))
}

/// Name and meaning of an argument.
fn heading(argument: &Argument, words: &Words) -> String {
    let meaning = words.key(argument.meaning());
    match argument.name {
        "" => meaning,
        name => words.text(&Message::new("argument-name").text("name", name).text("meaning", meaning)),
    }
}

/// What else is known of an argument, a line each.
pub fn about(argument: &Argument, words: &Words) -> Vec<String> {
    let help = words.find(&Message::new(format!("{}-help", argument.meaning())));
    help.into_iter().chain(argument.about().iter().map(|line| words.text(line))).collect()
}

/// The list of newer controls that calls this cycle, an argument a line. Empty: none is published.
pub fn list(asked: &str, words: &Words) -> String {
    let list = LISTS.iter().find(|list| list.name.eq_ignore_ascii_case(asked));
    let Some(list) = list else { return String::new() };
    let mut text = format!("{}\n", words.text(&Message::new("argument-list").text("cycle", list.name)));
    for argument in Argument::all(list) {
        let _ = writeln!(text, "{:>4}  {}", argument.place, heading(&argument, words));
    }
    text
}

/// An argument by its name in these lists: each meaning, with the lists and places where it has it. Empty: none has it.
pub fn arguments(asked: &str, words: &Words) -> String {
    let mut told: Vec<(String, Vec<String>)> = Vec::new();
    let all = LISTS.iter().flat_map(Argument::all);
    for one in all.filter(|one| !one.name.is_empty() && one.name.eq_ignore_ascii_case(asked)) {
        let meaning = format!("{}\n  {}", heading(&one, words), about(&one, words).join("\n  "));
        let place = format!("{} ({})", one.list.name, one.place);
        match told.iter_mut().find(|(known, _)| *known == meaning) {
            Some((_, places)) => places.push(place),
            None => told.push((meaning, vec![place])),
        }
    }
    told.into_iter().map(|(meaning, places)| format!("{meaning}\n  {}\n", places.join(", "))).collect()
}

/// A setting datum of newer controls by its number, `SD54600`, or identifier. Empty: none has it.
pub fn setting_datum(asked: &str, words: &Words) -> String {
    let Some(datum) = setting_data::find(asked) else { return String::new() };
    let mut text = format!("{} {}: {}\n", datum.name(), datum.identifier(), words.key(datum.key(OF_LISTS)));
    if let Some(line) = words.find(&Message::new(format!("{}.help", datum.key(OF_LISTS)))) {
        let _ = writeln!(text, "  {line}");
    }
    for value in datum.older(OF_LISTS).map_or(&[][..], |(_, element)| element.choices) {
        let _ = writeln!(text, "  {value}: {}", words.key(format!("{}.v{value}", datum.key(OF_LISTS))));
    }
    let _ = match datum.older_name().as_str() {
        "" => writeln!(text, "  {}", words.key("argument-no-older")),
        older => writeln!(text, "  {}", words.text(&Message::new("argument-older").text("name", older.to_owned()))),
    };
    text
}

/// An R parameter of the 840C (`R19`), a measuring call there (`L977`), or a subprogram of the measuring cycles that
/// older programs call (`CYCLE103`). Empty: it is none.
pub fn older(asked: &str, words: &Words) -> String {
    let asked = asked.to_ascii_uppercase();
    let told = |key: &'static str, name: &str, value: &str| {
        words.text(&Message::new(key).text("name", name.to_owned()).text("text", name).text("what", value.to_owned()))
    };
    if let Some(one) = subroutines::find(&asked) {
        return format!("{}\n  {}\n", told("older-subroutine", one.name, one.key), Cited(one.source));
    }
    if let Some(cycle) = r_parameters::called(&asked) {
        let mut text = format!("{}\n", told("older-cycle", &asked, cycle.name));
        for number in r_parameters::numbers() {
            let names = r_parameters::printed(cycle, number).filter_map(|name| cycle.param(&name));
            for param in names {
                let label = words.key(format!("param-{}", param.key));
                let _ = writeln!(text, "  {:>3}  {}: {label}", format!("R{number}"), param.name);
            }
        }
        return text;
    }
    let Some(number) = r_parameters::number(&asked) else { return String::new() };
    let mut names: Vec<(Name, Vec<&str>)> = Vec::new();
    for cycle in CYCLES.iter().filter(|one| r_parameters::is_printed(one)) {
        for name in r_parameters::printed(cycle, number).filter(|name| cycle.param(name).is_some()) {
            match names.iter_mut().find(|(known, _)| *known == name) {
                Some((_, cycles)) => cycles.push(cycle.name),
                None => names.push((name, vec![cycle.name])),
            }
        }
    }
    let line = |(name, cycles): &(Name, Vec<&str>)| format!("  {name}: {}", cycles.join(", "));
    let lines: Vec<String> = names.iter().map(line).collect();
    let factor = (number == r_parameters::FACTOR).then(|| format!("  {}\n", told("older-factor", &asked, "")));
    format!("{}\n{}\n{}", told("older-parameter", &asked, ""), lines.join("\n"), factor.unwrap_or_default())
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
/// Whether this is the number of a machine datum, `MD13200`.
fn machine_datum(name: &str) -> bool {
    MACHINE_DATA.iter().any(|datum| datum.number.eq_ignore_ascii_case(name))
}

fn means(asked: &str, name: &str) -> bool {
    let array = name.split('[').next().unwrap_or(name);
    name.eq_ignore_ascii_case(asked) || array.eq_ignore_ascii_case(asked)
}
