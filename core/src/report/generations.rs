//! The generations of the control, the argument lists of the newest, and its alarms: `docs/generations.md`.

use super::explain::about;
use crate::catalogue::newer::LISTS;
use crate::catalogue::newer::alarms::NEWER;
use crate::catalogue::newer::arguments::Argument;
use crate::catalogue::{CYCLES, alarms};
use crate::control::OF_LISTS;
use crate::control::setting_data::SETTING_DATA;
use crate::entry::{ArgumentList, When, names};
use crate::message::{Arg, Message};
use crate::report::foreign;
use crate::report::markdown::{line, rows, table};
use crate::words::Words;

/// The page, Markdown.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-generations")));
    line(&mut text, &words.key("report-generations-intro"));
    line(&mut text, &words.key("report-generated"));
    let generations = (1..=3).map(|number| ["parameters", "data"].map(|what| format!("generation-{number}-{what}")));
    let generations = generations.map(|[parameters, data]| [words.key(parameters), words.key(data)]);
    table(&mut text, &words.key("datum-pw-generation"), ["name", "datum"], generations, words);
    line(&mut text, &format!("## {}", words.key("report-generations-lists")));
    let lists = LISTS.iter().map(|list| summary(list, words));
    rows(&mut text, ["name", "count", "read", "written", "simulated"], lists, words);
    for list in &LISTS {
        let title = words.text(&Message::new("argument-list").text("cycle", list.name));
        table(
            &mut text,
            &title,
            ["number", "name", "meaning"],
            Argument::all(list).map(|one| cells(&one, words)),
            words,
        );
    }
    let settings = SETTING_DATA.iter().map(|datum| {
        let label = words.key(datum.key(OF_LISTS));
        let help = words.find(&Message::new(format!("{}.help", datum.key(OF_LISTS))));
        let meaning = help.map_or_else(|| label.clone(), |help| format!("{label}. {help}"));
        [datum.name(), format!("`{}`", datum.identifier()), meaning, datum.older_name()]
    });
    table(&mut text, &words.key("machine-group-setting-data"), ["number", "name", "meaning", "datum"], settings, words);
    let told = NEWER.iter().map(|number| {
        let known = alarms::find(&number.to_string()).is_some();
        let known = words.key(if known { "report-generations-cure" } else { "report-generations-new" });
        [number.to_string(), known, words.key(format!("newer-alarm-{number}"))]
    });
    table(&mut text, &words.key("report-generations-alarms"), ["number", "standard", "meaning"], told, words);
    foreign::section(&mut text, words);
    text.trim_end().to_owned() + "\n"
}

const SIMULATED: &str = "generations-simulated";

/// What is read, written and simulated of a list, and why not.
fn summary(list: &'static ArgumentList, words: &Words) -> [String; 5] {
    let entry = CYCLES.iter().find(|cycle| cycle.name == list.name);
    let variants = match &list.when {
        When::Variant(numbers) => numbers.iter().map(i64::to_string).collect::<Vec<_>>().join(", "),
        _ => String::new(),
    };
    let reason = if entry.is_some() { "generations-digits" } else { "generations-no-counterpart" };
    let measures = list.position(names::MVAR).is_some();
    let done = |key: &'static str| {
        if key == SIMULATED && entry.is_none() && !measures {
            return words.key("generations-shows");
        }
        let with = || {
            let message = Message { args: vec![("variants", Arg::Text(variants.clone()))], ..Message::new(key) };
            let tool = Argument::all(list).any(|one| one.name == "S_KNUM1").then(|| words.key("generations-no-tool"));
            [words.text(&message)].into_iter().chain(tool).collect::<Vec<_>>().join(" ")
        };
        if variants.is_empty() { words.key(reason) } else { with() }
    };
    [
        format!("`{}`", list.name),
        list.args.len().to_string(),
        words.key(if entry.is_some() { "generations-read" } else { "generations-read-only" }),
        done("generations-written"),
        done(SIMULATED),
    ]
}

fn cells(argument: &Argument, words: &Words) -> [String; 3] {
    let name = if argument.name.is_empty() { String::new() } else { format!("`{}`", argument.name) };
    let meaning = words.key(argument.meaning());
    [argument.place.to_string(), name, format!("{meaning}<br>{}", about(argument, words).join("<br>"))]
}

#[cfg(test)]
mod tests {
    use crate::report::held;

    // oracle: self
    #[test]
    fn the_page_is_the_generated_one() {
        held("generations.md", super::page);
    }
}
