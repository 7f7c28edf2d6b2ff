//! The cycle reference in `docs/cycles/`: one page a cycle, written from the catalogue and the message files.

use crate::catalogue::alarms;
use crate::diagnostic::Code;
use crate::entry::{Cycle, Kind, Level, Param, ProbeUse, Unit, When};
use crate::manual::Cited;
use crate::message::Message;
use crate::range::Range;
use crate::report::help::help;
use crate::report::markdown::{heading, line, row};
use crate::report::said;
use crate::words::Words;

/// The page of one cycle, Markdown.
pub fn page(cycle: &'static Cycle, words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}: {}", cycle.name, words.key(format!("{}-title", cycle.key))));
    line(&mut text, &words.key(format!("{}-help", cycle.key)));
    line(&mut text, &words.key(known(cycle)));
    let source = said(words, "report-source", &[("source", Cited(cycle.source).to_string())]);
    line(&mut text, &format!("{source} {}", words.key("report-generated")));
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
    heading(text, &words.key("report-variants"), &["number", "measures", "source"], words);
    for variant in cycle.variants {
        row(text, &[variant.number.to_string(), words.key(variant.key), Cited(variant.source).to_string()]);
    }
    text.push('\n');
}

fn parameters(text: &mut String, cycle: &Cycle, words: &Words) {
    if cycle.params.is_empty() {
        return;
    }
    heading(
        text,
        &words.key("report-parameters"),
        &["name", "meaning", "need", "unit", "default", "range", "source"],
        words,
    );
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
        need(param, words),
        unit(param.unit, words),
        default,
        range(param, words),
        Cited(param.source).to_string(),
    ]
}

fn need(param: &Param, words: &Words) -> String {
    let needs = param.needs.iter().map(|need| {
        let level = match need.level {
            Level::Required => "report-required",
            Level::Optional => "report-optional",
        };
        match need.when {
            When::Always => words.key(level),
            _ => said(words, format!("{level}-when"), &[("condition", when(&need.when, words))]),
        }
    });
    needs.collect::<Vec<_>>().join("; ")
}

/// A condition in signs and few words.
fn when(condition: &When, words: &Words) -> String {
    let list = |conditions: &[When], sign: &'static str| {
        let all: Vec<String> = conditions.iter().map(|one| when(one, words)).collect();
        all.join(&format!(" {} ", words.key(sign)))
    };
    let said = |key: &'static str, args: &[(&'static str, String)]| said(words, key, args);
    match condition {
        When::Always => words.key("report-always"),
        When::Variant(numbers) => said("report-when-variant", &[("numbers", format!("{numbers:?}"))]),
        When::Digit { param, place, is } => {
            let numbers = format!("{is:?}");
            said(
                "report-when-digit",
                &[("param", param.to_string()), ("place", place.to_string()), ("numbers", numbers)],
            )
        }
        When::Given(param) => said("report-when-given", &[("param", param.to_string())]),
        When::Number { param, is } => format!("`{param}` ∈ {is:?}"),
        When::Above { param, than } => format!("`{param}` > {than}"),
        When::Setting { name, is } => format!("`{name}` ∈ {is:?}"),
        When::ToolType(from, to) => said("report-when-tool", &[("from", from.to_string()), ("to", to.to_string())]),
        When::Plane(plane) => format!("{plane:?}"),
        When::Diameters => "DIAMON".to_owned(),
        When::All(conditions) => list(conditions, "report-and"),
        When::Any(conditions) => format!("({})", list(conditions, "report-or")),
        When::Not(condition) => said("report-when-not", &[("condition", when(condition, words))]),
    }
}

fn unit(unit: Unit, words: &Words) -> String {
    match unit {
        Unit::None => String::new(),
        Unit::ActiveLength => words.key("report-unit-active"),
        Unit::BasicLength => words.key("report-unit-basic"),
        Unit::Millimetre => "mm".to_owned(),
        Unit::Degree => "°".to_owned(),
        Unit::BasicFeed => words.key("report-feed-basic"),
    }
}

fn range(param: &Param, words: &Words) -> String {
    let numbers = |choices: &[(i64, &str)]| {
        let list: Vec<String> = choices.iter().map(|(value, _)| value.to_string()).collect();
        list.join(", ")
    };
    match &param.kind {
        Kind::Choice(choices) => return numbers(choices),
        Kind::ChoiceIf(condition, choices) => return format!("{}: {}", when(condition, words), numbers(choices)),
        Kind::ChoiceBy(lists) => {
            let list = |(condition, choices): &(When, &[(i64, &str)])| {
                format!("{}: {}", when(condition, words), numbers(choices))
            };
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
    heading(text, &words.key("report-results"), &["datum", "meaning", "when", "unit", "source"], words);
    for field in cycle.results {
        let condition = match field.when {
            When::Always => String::new(),
            _ => when(&field.when, words),
        };
        let cells = [
            format!("`{}`", field.name),
            words.key(field.key),
            condition,
            unit(field.unit, words),
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
    heading(text, &words.key("report-alarms-raised"), &["number", "meaning", "cure"], words);
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
    use crate::report::{docs, held};
    use crate::words::LANGUAGES;

    // oracle: self. With PROBEWRIGHT_UPDATE=1 the pages are written instead.
    #[test]
    fn the_pages_in_docs_are_those_of_the_catalogue() {
        let name = |cycle: &Cycle| format!("{}.md", cycle.name.replace(' ', "-"));
        for cycle in CYCLES {
            held(&format!("cycles/{}", name(cycle)), |words| page(cycle, words));
        }
        let mut expected: Vec<String> = CYCLES.iter().map(|cycle| name(cycle)).collect();
        expected.sort();
        for language in LANGUAGES {
            let entries = std::fs::read_dir(docs(language.code).join("cycles")).unwrap();
            let mut found: Vec<String> =
                entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
            found.sort();
            assert_eq!(found, expected, "{}", language.code);
        }
    }
}
