//! The cycle reference in `docs/cycles/`: one page a cycle, written from the catalogue and the message files.

use crate::catalogue::alarms;
use crate::diagnostic::Code;
use crate::entry::{Cycle, Kind, Level, Param, ProbeUse, Unit, When};
use crate::manual::Cited;
use crate::message::Message;
use crate::range::Range;
use crate::report::help::help;
use crate::report::markdown::{heading, line, row};
use crate::words::Words;

/// The page of one cycle, Markdown.
pub fn page(cycle: &'static Cycle, words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}: {}", cycle.name, words.key(format!("{}-title", cycle.key))));
    line(&mut text, &words.key(format!("{}-help", cycle.key)));
    line(&mut text, &words.key(known(cycle)));
    line(&mut text, &format!("Source: {}. {}", Cited(cycle.source), words.key("report-generated")));
    variants(&mut text, cycle, words);
    help(&mut text, cycle, words);
    parameters(&mut text, cycle, words);
    results(&mut text, cycle, words);
    alarms(&mut text, cycle, words);
    while text.ends_with("\n\n") {
        text.pop();
    }
    text
}

/// Key of how much of the cycle Probewright knows.
fn known(cycle: &Cycle) -> &'static str {
    match cycle.simulation {
        Some(_) => "report-known-simulated",
        None if cycle.purpose.probe == ProbeUse::Log => "report-known-passed",
        None => "report-known-stops",
    }
}

fn variants(text: &mut String, cycle: &Cycle, words: &Words) {
    heading(text, "Measuring variants", &["number", "measures", "source"]);
    for variant in cycle.variants {
        row(text, &[variant.number.to_string(), words.key(variant.key), Cited(variant.source).to_string()]);
    }
    text.push('\n');
}

fn parameters(text: &mut String, cycle: &Cycle, words: &Words) {
    if cycle.params.is_empty() {
        return;
    }
    heading(text, "Parameters", &["name", "meaning", "needed", "unit", "default", "range", "source"]);
    for param in cycle.params {
        row(text, &parameter(param, words));
    }
    text.push('\n');
}

fn parameter(param: &Param, words: &Words) -> [String; 7] {
    let default = match param.default {
        Some(number) => number.to_string(),
        None if param.is_machine_datum() => words.key("report-default-machine"),
        None => String::new(),
    };
    [
        format!("`{}`", param.name),
        words.key(format!("param-{}", param.key)),
        need(param),
        unit(param.unit).to_owned(),
        default,
        range(param),
        Cited(param.source).to_string(),
    ]
}

fn need(param: &Param) -> String {
    let said: Vec<String> = param
        .needs
        .iter()
        .map(|need| {
            let level = match need.level {
                Level::Required => "required",
                Level::Optional => "optional",
            };
            match need.when {
                When::Always => level.to_owned(),
                _ => format!("{level} when {}", when(&need.when)),
            }
        })
        .collect();
    said.join("; ")
}

/// A condition in signs that need no language.
fn when(condition: &When) -> String {
    let list = |conditions: &[When], sign: &str| conditions.iter().map(when).collect::<Vec<_>>().join(sign);
    match condition {
        When::Always => "always".to_owned(),
        When::Variant(numbers) => format!("variant ∈ {numbers:?}"),
        When::Digit { param, place, is } => format!("`{param}` digit {place} ∈ {is:?}"),
        When::Given(param) => format!("`{param}` given"),
        When::Number { param, is } => format!("`{param}` ∈ {is:?}"),
        When::Above { param, than } => format!("`{param}` > {than}"),
        When::Setting { name, is } => format!("`{name}` ∈ {is:?}"),
        When::ToolType(from, to) => format!("tool type {from}..{to}"),
        When::Plane(plane) => format!("{plane:?}"),
        When::Diameters => "DIAMON".to_owned(),
        When::All(conditions) => list(conditions, " and "),
        When::Any(conditions) => format!("({})", list(conditions, " or ")),
        When::Not(condition) => format!("not ({})", when(condition)),
    }
}

fn unit(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::ActiveLength => "active length",
        Unit::BasicLength => "basic length",
        Unit::Millimetre => "mm",
        Unit::Degree => "°",
        Unit::BasicFeed => "basic feed",
    }
}

fn range(param: &Param) -> String {
    let numbers = |choices: &[(i64, &str)]| {
        let list: Vec<String> = choices.iter().map(|(value, _)| value.to_string()).collect();
        list.join(", ")
    };
    match &param.kind {
        Kind::Choice(choices) => return numbers(choices),
        Kind::ChoiceIf(condition, choices) => return format!("{}: {}", when(condition), numbers(choices)),
        Kind::ChoiceBy(lists) => {
            let list =
                |(condition, choices): &(When, &[(i64, &str)])| format!("{}: {}", when(condition), numbers(choices));
            return lists.iter().map(list).collect::<Vec<_>>().join("; ");
        }
        _ => {}
    }
    let Range { min, min_included, max, max_included } = param.range;
    let low = if min.is_finite() { format!("{} {min}", if min_included { "≥" } else { ">" }) } else { String::new() };
    let high =
        if max.is_finite() { format!("{} {max}", if max_included { "≤" } else { "<" }) } else { String::new() };
    [low, high].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

fn results(text: &mut String, cycle: &Cycle, words: &Words) {
    if cycle.results.is_empty() {
        return;
    }
    heading(text, "Results", &["datum", "meaning", "when", "unit", "source"]);
    for field in cycle.results {
        let condition = match field.when {
            When::Always => String::new(),
            _ => when(&field.when),
        };
        let cells = [
            format!("`{}`", field.name),
            words.key(field.key),
            condition,
            unit(field.unit).to_owned(),
            Cited(field.source).to_string(),
        ];
        row(text, &cells);
    }
    text.push('\n');
}

fn alarms(text: &mut String, cycle: &Cycle, words: &Words) {
    let alarms = cycle.alarms();
    if alarms.is_empty() {
        return;
    }
    heading(text, "Alarms", &["number", "meaning", "cure"]);
    for alarm in alarms {
        row(text, &alarm_cells(alarm, words));
    }
    text.push('\n');
}

fn alarm_cells(alarm: Code, words: &Words) -> [String; 3] {
    let key = alarms::key(alarm);
    let cure = words.find(&Message::new(format!("{key}.cure"))).unwrap_or_default();
    [alarm.to_string(), words.key(key), cure]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::CYCLES;

    // oracle: self. With PROBEWRIGHT_UPDATE=1 the pages are written instead.
    #[test]
    fn the_pages_in_docs_are_those_of_the_catalogue() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/cycles");
        let update = std::env::var_os("PROBEWRIGHT_UPDATE").is_some();
        let words = Words::english();
        let mut expected = Vec::new();
        for cycle in CYCLES {
            let name = format!("{}.md", cycle.name.replace(' ', "-"));
            if update {
                std::fs::create_dir_all(&folder).unwrap();
                std::fs::write(folder.join(&name), page(cycle, &words)).unwrap();
            }
            assert_eq!(std::fs::read_to_string(folder.join(&name)).unwrap(), page(cycle, &words), "{name}");
            expected.push(name);
        }
        expected.sort();
        let mut found: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        found.sort();
        assert_eq!(found, expected);
    }
}
