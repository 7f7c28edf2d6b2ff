//! From values to program text: assignments, then the call; on NCT one block of addresses.

use crate::catalogue::{Cycle, Dialect, Kind, Param};
use crate::check::{self, Inputs, Parsed, Typed, parse};
use crate::control::Control;

/// Widest line of assignments, as in the programs of the manual.
const WIDTH: usize = 78;

/// Words for comments: name of a parameter and key of its label → text.
pub type Words<'a> = &'a dyn Fn(&str, &str) -> String;

/// Program text of one call, lines ended by LF. Values that are used and can be written stand in it, in the order of the
/// manual's tables; `words` adds a comment line for each.
pub fn snippet(
    cycle: &'static Cycle,
    typed: &Typed,
    control: &Control,
    words: Option<Words>,
) -> String {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let written: Vec<(&Param, String)> = cycle
        .params
        .iter()
        .filter(|param| param.need(&inputs).is_some())
        .filter_map(|param| Some((param, value(param, typed.get(param.name)?)?)))
        .collect();
    let mut text = String::new();
    if let Some(words) = words {
        comments(&mut text, cycle, &inputs, &written, words);
    }
    match cycle.dialect {
        Dialect::Sinumerik => assignments(&mut text, &written),
        Dialect::Nct => {}
    }
    text.push_str(cycle.name);
    if cycle.dialect == Dialect::Nct {
        for (param, value) in &written {
            text.push(' ');
            text.push_str(param.name);
            text.push_str(value);
        }
    }
    text.push('\n');
    text
}

/// A value as a program writes it; none for one that cannot be written.
pub fn value(param: &Param, typed: &str) -> Option<String> {
    let typed = typed.trim();
    if let Kind::Text(_) = param.kind {
        let inner = typed
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'))
            .unwrap_or(typed);
        let plain =
            !inner.is_empty() && !inner.contains('"') && !inner.chars().any(char::is_control);
        return plain.then(|| format!("\"{inner}\""));
    }
    match parse(typed) {
        Parsed::Number(number) => Some(format!("{number}")),
        Parsed::Expression => Some(typed.to_owned()),
        Parsed::Empty | Parsed::Wrong => None,
    }
}

fn assignments(text: &mut String, written: &[(&Param, String)]) {
    let mut width = 0;
    for (param, value) in written {
        let word = format!("{}={value}", param.name);
        if width > 0 && width + 1 + word.len() > WIDTH {
            text.push('\n');
            width = 0;
        } else if width > 0 {
            text.push(' ');
            width += 1;
        }
        text.push_str(&word);
        width += word.len();
    }
    if width > 0 {
        text.push('\n');
    }
}

/// `;_FA: measuring path`, NCT `(D: nominal diameter)`.
fn comments(
    text: &mut String,
    cycle: &Cycle,
    inputs: &Inputs,
    written: &[(&Param, String)],
    words: Words,
) {
    for (param, value) in written {
        let label = words(param.name, &format!("param-{}", param.label(inputs)));
        let line = format!("{}={value}: {label}", param.name);
        let line: String = line
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        match cycle.dialect {
            Dialect::Sinumerik => text.push_str(&format!("; {line}\n")),
            Dialect::Nct => text.push_str(&format!("({})\n", line.replace(['(', ')'], " "))),
        }
    }
}
