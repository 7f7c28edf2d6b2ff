//! The cycle reference in `docs/cycles/`: one page a cycle, written from the catalogue and the message files.

use crate::catalogue::alarms;
use crate::diagnostic::Code;
use crate::entry::{Cycle, Kind, Level, Param, ResultField, Unit, Variant, When};
use crate::manual::Cited;
use crate::message::Message;
use crate::range::Range;
use crate::report::help::help;
use crate::report::markdown::{line, table};
use crate::report::said;
use crate::support::{FORMS, FORMS_KEY};
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
    text.trim_end().to_owned() + "\n"
}

/// Key of how much of the cycle Probewright knows.
fn known(cycle: &Cycle) -> &'static str {
    match cycle.simulation {
        Some(_) => "report-known-simulated",
        None => "report-known-stops",
    }
}

fn variants(text: &mut String, cycle: &Cycle, words: &Words) {
    let cells = |one: &Variant| [one.number.to_string(), words.key(one.key), Cited(one.source).to_string()];
    let columns = ["number", "measures", "source"];
    table(text, &words.key("report-variants"), columns, cycle.variants.iter().map(cells), words);
}

fn parameters(text: &mut String, cycle: &Cycle, words: &Words) {
    let columns = ["name", "meaning", "need", "unit", "default", "range", "source"];
    let rows = cycle.params.iter().map(|param| parameter(param, words));
    table(text, &words.key("report-parameters"), columns, rows, words);
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
    let numbers = |name: &str, is: &[f64]| {
        let list: Vec<String> = is.iter().map(f64::to_string).collect();
        format!("{name} ∈ [{}]", list.join(", "))
    };
    match condition {
        When::Always => words.key("report-always"),
        When::Variant(numbers) => said("report-when-variant", &[("numbers", format!("{numbers:?}"))]),
        When::Digit { param, place, is } => {
            let numbers = format!("{is:?}");
            let place = f64::from(place.ilog10() + 1);
            let digit = Message::new("report-when-digit").text("param", param.as_str()).text("numbers", numbers);
            words.text(&digit.number("place", place))
        }
        When::Given(param) => said("report-when-given", &[("param", param.to_string())]),
        When::Number { param, is } => numbers(&format!("`{param}`"), is),
        When::Above { param, than } => format!("`{param}` > {than}"),
        When::Setting { name: FORMS, is } => numbers(&words.key(FORMS_KEY), is),
        When::Setting { name, is } => numbers(&format!("`{name}`"), is),
        When::ToolType(from, to) => said("report-when-tool", &[("from", from.to_string()), ("to", to.to_string())]),
        When::Plane(plane) => format!("{plane:?}"),
        When::Diameters => "DIAMON".to_owned(),
        When::All(conditions) => {
            let limiting: Vec<When> = conditions.iter().copied().filter(|one| *one != When::Always).collect();
            list(&limiting, "report-and")
        }
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
    let under = |condition: &When, choices: &[(i64, &str)]| format!("{}: {}", when(condition, words), numbers(choices));
    match &param.kind {
        Kind::Choice(choices) => numbers(choices),
        Kind::ChoiceIf(condition, choices) => under(condition, choices),
        Kind::ChoiceBy(lists) => {
            let lists: Vec<String> = lists.iter().map(|(condition, choices)| under(condition, choices)).collect();
            lists.join("; ")
        }
        _ => bounds(param.range),
    }
}

fn bounds(Range { min, min_included, max, max_included }: Range) -> String {
    let low = min.is_finite().then(|| format!("{} {min}", if min_included { "≥" } else { ">" }));
    let high = max.is_finite().then(|| format!("{} {max}", if max_included { "≤" } else { "<" }));
    let both: Vec<String> = low.into_iter().chain(high).collect();
    both.join(", ")
}

fn results(text: &mut String, cycle: &Cycle, words: &Words) {
    let cells = |field: &ResultField| {
        let condition = match field.when {
            When::Always => String::new(),
            _ => when(&field.when, words),
        };
        let (name, source) = (format!("`{}`", field.name), Cited(field.source).to_string());
        [name, words.key(field.key), condition, unit(field.unit, words), source]
    };
    let columns = ["datum", "meaning", "when", "unit", "source"];
    table(text, &words.key("report-results"), columns, cycle.results.iter().map(cells), words);
}

fn alarms(text: &mut String, cycle: &Cycle, words: &Words) {
    let cells = |alarm: Code| {
        let key = alarms::key(alarm);
        [alarm.to_string(), words.key(key.clone()), words.key(format!("{key}.cure"))]
    };
    let rows = cycle.alarms().into_iter().map(cells);
    table(text, &words.key("report-alarms-raised"), ["number", "meaning", "cure"], rows, words);
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
