//! Controls that are read and not run: their cycles and parameters, for the terminal and `docs/generations.md`.

use crate::foreign::{CONTROLS, ForeignCycle, find};
use crate::message::Message;
use crate::report::markdown::{line, rows};
use crate::words::Words;
use std::fmt::Write;

/// A cycle with its parameters. Empty: none has this name.
pub fn cycle(asked: &str, words: &Words) -> String {
    let Some((control, cycle)) = find(asked) else { return String::new() };
    let mut text = format!("{} ({}): {}\n", cycle.name, control.name, words.key(cycle.title()));
    for parameter in cycle.parameters {
        let _ = writeln!(text, "{:>8}  {}", parameter.name, words.key(parameter.key));
    }
    if let Some(why) = cycle.unwritten(control) {
        let _ = writeln!(text, "{}", words.text(&why));
    }
    if !cycle.source.is_empty() {
        let _ = writeln!(text, "{}", words.text(&Message::new("foreign-source").source(cycle.source)));
    }
    text
}

/// A parameter, with the cycles that have it. Empty: none has this name.
pub fn parameter(asked: &str, words: &Words) -> String {
    let mut text = String::new();
    for control in CONTROLS {
        let with = |cycle: &&ForeignCycle| cycle.parameter(asked).is_some();
        let owners: Vec<&ForeignCycle> = control.cycles.iter().filter(with).collect();
        let Some(parameter) = owners.first().and_then(|cycle| cycle.parameter(asked)) else { continue };
        let names: Vec<&str> = owners.iter().map(|cycle| cycle.name).collect();
        let meaning = words.key(parameter.key);
        let _ = writeln!(text, "{} ({}): {meaning}\n  {}", parameter.name, control.name, names.join(", "));
    }
    text
}

/// What is read and written of each control, Markdown.
pub fn section(text: &mut String, words: &Words) {
    for control in CONTROLS {
        let title = words.text(&Message::new("report-foreign").text("control", control.name));
        line(text, &format!("## {title}"));
        let cycles = control.cycles.iter().map(|cycle| {
            let written = cycle.unwritten(control).unwrap_or_else(|| Message::new("foreign-written"));
            let names: Vec<&str> = cycle.parameters.iter().map(|one| one.name).collect();
            let name = format!("`{}`", cycle.name);
            [name, words.key(cycle.title()), names.join(" "), words.text(&written), cycle.source.to_owned()]
        });
        rows(text, ["name", "meaning", "read", "written", "source"], cycles, words);
        line(text, &words.key(control.unpublished));
    }
}
