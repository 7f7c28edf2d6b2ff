//! From values to program text: assignments, then the call; a call with arguments; on NCT one block of addresses.

mod list;
pub mod machine;

use crate::catalogue::{Cycle, Dialect, Kind, Param, Style};
use crate::check::{self, Inputs, Parsed, Typed, parse};
use crate::control::Control;
use crate::diagnostic::Diagnostic;

/// Widest line of assignments, as in the programs of the manual.
const WIDTH: usize = 78;

/// Words for comments: name of a parameter and key of its label → text.
pub type Words<'a> = &'a dyn Fn(&str, &str) -> String;

/// Program text of a call.
pub struct Written {
    /// Lines ended by LF; empty where the call cannot be written in this way.
    pub text: String,
    /// What this way of writing cannot say.
    pub findings: Vec<Diagnostic>,
}

/// What a way of writing starts from: the values that are used and can be written, in the order of the manual's tables.
struct Source<'a> {
    cycle: &'static Cycle,
    inputs: Inputs,
    control: &'a Control,
    values: Vec<(&'static Param, String)>,
}

/// Program text of one call; `words` adds a comment line for each value.
pub fn snippet(
    cycle: &'static Cycle,
    typed: &Typed,
    control: &Control,
    style: Style,
    words: Option<Words>,
) -> Written {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let used = cycle
        .params
        .iter()
        .filter(|param| param.need(&inputs).is_some());
    let values = used
        .filter_map(|param| Some((param, value(param, typed.get(param.name)?)?)))
        .collect();
    let source = Source {
        cycle,
        inputs,
        control,
        values,
    };
    let mut written = if style == Style::Direct && cycle.dialect == Dialect::Nct {
        Written {
            text: addresses(&source),
            findings: Vec::new(),
        }
    } else {
        list::write(&source, style)
    };
    if let Some(words) = words.filter(|_| !written.text.is_empty()) {
        written.text.insert_str(0, &comments(&source, words));
    }
    written
}

fn addresses(source: &Source) -> String {
    let mut text = source.cycle.name.to_owned();
    for (param, value) in &source.values {
        text.push(' ');
        text.push_str(param.name);
        text.push_str(value);
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

/// Lines of assignments.
fn assignments(values: &[&(&Param, String)]) -> String {
    let (mut text, mut width) = (String::new(), 0);
    for (param, value) in values {
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
    text
}

/// `;_FA: measuring path`, NCT `(D: nominal diameter)`.
fn comments(source: &Source, words: Words) -> String {
    let mut text = String::new();
    for (param, value) in &source.values {
        let label = words(
            param.name,
            &format!("param-{}", param.label(&source.inputs)),
        );
        let line = format!("{}={value}: {label}", param.name);
        let line: String = line
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        match source.cycle.dialect {
            Dialect::Sinumerik => text.push_str(&format!("; {line}\n")),
            Dialect::Nct => text.push_str(&format!("({})\n", line.replace(['(', ')'], " "))),
        }
    }
    text
}
