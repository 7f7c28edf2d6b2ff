//! From values to program text: assignments, then the call; a call with arguments; on NCT one block of addresses.

pub mod definition_files;
mod list;
pub mod machine;
pub mod setting_data;
mod support;

use crate::catalogue::Functions;
use crate::check;
use crate::check::{Parsed, Text, expression, parse, parse_text};
use crate::control::{Control, GENERATION, OF_LISTS};
use crate::diagnostic::{Diagnostic, Span};
use crate::dialect::Dialect;
use crate::entry::{ArgumentList, Cycle, Inputs, Kind, Param, ProbeUse, Style, Typed};
use crate::name::Name;
use crate::own;
use crate::support::Support;
use crate::syntax::Grammar;
use std::collections::BTreeMap;

/// Widest line of assignments, as in the programs of the manual.
const WIDTH: usize = 78;

/// Words for comments: name of a parameter and key of its label → text.
pub type Words<'a> = &'a dyn Fn(&str, &str) -> String;

/// Program text of a call.
pub struct Written {
    /// Lines ended by LF; empty where the call cannot be written in this way.
    pub text: String,
    /// Where in it each value stands, an assignment or an address with its name; the variant that selections make: the
    /// first of them.
    pub places: BTreeMap<Name, Span>,
    /// The parameters whose values are in it.
    pub said: Vec<Name>,
    /// What this call style cannot say.
    pub findings: Vec<Diagnostic>,
}

/// What a call style starts from: the values that are used and can be written, in the order of the manual's tables.
struct Source<'a> {
    cycle: &'static Cycle,
    inputs: Inputs,
    /// What was typed, also what only the lists of newer controls have.
    typed: Typed,
    control: &'a Control,
    values: Vec<(&'static Param, String)>,
    /// Whether the control's own support writes it.
    form: bool,
    /// Bits that the support writes too; see [`crate::support`].
    bits: Vec<(&'static str, bool)>,
}

/// Program text of one call; `words` adds a comment line for each value. On a machine whose forms are those of the
/// control's own support it is what that support writes; the lists of newer controls know nothing of it.
pub fn snippet(cycle: &'static Cycle, typed: &Typed, control: &Control, style: Style, words: Option<Words>) -> Written {
    snippet_of(cycle, &Values { typed, expressions: &Typed::new() }, control, style, words)
}

/// Whether a new call is written in the list of newer controls on this machine.
pub fn is_listed_on(cycle: &Cycle, control: &Control) -> bool {
    let listed = |list: &ArgumentList| list.style == Style::Operate && list.is_written();
    control.number(GENERATION) == OF_LISTS && cycle.lists.iter().any(listed)
}

/// Why a control of the generation of this machine does not take a new call in this style, or why it is not written in
/// its list.
pub fn other_generation(cycle: &Cycle, style: Style, control: &Control) -> Option<Diagnostic> {
    let generation = control.number(GENERATION);
    let list = cycle.lists.iter().find(|list| list.style == Style::Operate).filter(|_| generation > 0.0)?;
    let sentence = match (style == Style::Operate, generation == OF_LISTS) {
        (true, false) => own::GENERATION_LIST,
        (false, true) if list.is_written() => own::GENERATION_ASSIGNED,
        (false, true) => return Some(own::WRITE_ASSIGNED.finding().text("cycle", cycle.name)),
        _ => return None,
    };
    Some(sentence.finding().text("cycle", cycle.name).number("generation", generation))
}

/// Values of a call: what they are worth, and of some how a program writes them.
pub struct Values<'a> {
    /// As typed.
    pub typed: &'a Typed,
    /// Expressions of the program whose worth was typed: they are written, and never what they are worth today.
    pub expressions: &'a Typed,
}

/// Program text of one call, as [`snippet`], with values that a program writes as expressions.
pub fn snippet_of(
    cycle: &'static Cycle,
    values: &Values,
    control: &Control,
    style: Style,
    words: Option<Words>,
) -> Written {
    let mut source = match Support::of(cycle, control) {
        Some(support) => support::source(support, cycle, values.typed, control, style),
        None => source(cycle, values.typed, control),
    };
    source.write(values.expressions);
    let mut written = match style {
        Style::Direct if source.form => source.whole(support::blocks(&source)),
        Style::Direct if Grammar::of(cycle.dialect).by_address => source.whole(addresses(&source)),
        _ => list::write(&source, style),
    };
    if written.text.is_empty() {
        return written;
    }
    if source.form {
        written.put_before(&support::head(&source, style));
    }
    if let Some(words) = words {
        written.put_before(&comments(&source, &written.said, words));
    }
    written
}

/// The values that were typed and are not in what was written, where nothing else tells: the variant does not use them.
pub fn unsaid(cycle: &Cycle, typed: &Typed, written: &Written) -> Option<Diagnostic> {
    let told = |one: &Diagnostic, name: &str| {
        one.message.word("name") == Some(name) || one.param.is_some_and(|param| param == name)
    };
    // an argument that the variant does not use may hold what programs usually write there
    let at = |name: &str| written.places.iter().find(|(one, _)| **one == name).map(|(_, place)| *place);
    let text_of = |place: Span| written.text.get(place.start as usize..place.end as usize).unwrap_or_default();
    let holds = |place: Span, text: &str| {
        let (there, typed) = (text_of(place), text.trim());
        let bare = there.rsplit('=').next().unwrap_or(there).trim_matches('"');
        bare == typed.trim_matches('"') || parse(there) == parse(typed)
    };
    let lost = |(name, text): &(&String, &String)| {
        let said = written.said.iter().any(|one| one.as_str() == name.as_str());
        let said = said || at(name).is_some_and(|place| holds(place, text));
        let nothing = matches!(parse(text), Parsed::Empty | Parsed::Number(0.0));
        !said && !nothing && !written.findings.iter().any(|one| told(one, name))
    };
    let names: Vec<String> = typed.iter().filter(lost).map(|(name, text)| format!("{name}={text}")).collect();
    let finding = own::CONVERT_UNUSED.finding().text("cycle", cycle.name).texts("names", &names);
    (!written.text.is_empty() && !names.is_empty()).then_some(finding)
}

impl Written {
    fn put_before(&mut self, lines: &str) {
        self.text.insert_str(0, lines);
        let by = lines.len() as u32;
        for place in self.places.values_mut() {
            *place = Span { start: place.start + by, end: place.end + by };
        }
    }
}

/// A text as it is written, and where in it the values stand.
#[derive(Default)]
struct Lines {
    text: String,
    places: BTreeMap<Name, Span>,
    /// Bytes in the line that is being written.
    width: usize,
}

impl Lines {
    fn push(&mut self, text: &str) {
        self.text.push_str(text);
        self.width += text.len();
    }

    /// A word, and the parameter whose value it is.
    fn word(&mut self, of: Option<Name>, word: &str) {
        let start = self.text.len() as u32;
        self.push(word);
        if let Some(name) = of {
            self.places.entry(name).or_insert(Span { start, end: self.text.len() as u32 });
        }
    }

    fn line_end(&mut self) {
        self.text.push('\n');
        self.width = 0;
    }

    /// Lines of assignments, each with the parameter that it gives a value.
    fn assignments(&mut self, words: &[(Option<Name>, String)]) {
        for (of, word) in words {
            if self.width > 0 && self.width + 1 + word.len() > WIDTH {
                self.line_end();
            } else if self.width > 0 {
                self.push(" ");
            }
            self.word(*of, word);
        }
        if self.width > 0 {
            self.line_end();
        }
    }
}

impl Source<'_> {
    /// A value as it is written.
    fn value(&self, name: &str) -> Option<&str> {
        self.values.iter().find(|(param, _)| param.name == name).map(|(_, text)| text.as_str())
    }

    /// A text that says everything.
    fn whole(&self, Lines { text, places, .. }: Lines) -> Written {
        Written { text, places, said: self.names(), findings: Vec::new() }
    }

    /// The parameters whose values are written.
    fn names(&self) -> Vec<Name> {
        self.values.iter().map(|(param, _)| param.name).collect()
    }

    /// Writes values as these expressions, also where the settings of the machine would give another value.
    fn write(&mut self, expressions: &Typed) {
        for (param, text) in &mut self.values {
            if let Some(expression) = expressions.get(param.name.as_str()) {
                expression.trim().clone_into(text);
            }
        }
    }
}

/// Whether a value, as written, is known at run time only.
pub(super) fn is_expression(param: &Param, text: &str) -> bool {
    match param.kind {
        Kind::Text(_) => parse_text(text) == Text::Expression,
        _ => parse(text) == Parsed::Expression,
    }
}

/// The values that are used and can be written, and data of the machine that were set for the call.
fn source<'a>(cycle: &'static Cycle, typed: &Typed, control: &'a Control) -> Source<'a> {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let written = cycle.params.iter().filter_map(|param| {
        let text = value(cycle.dialect, param, typed.get(param.name.as_str())?)?;
        let of_log = cycle.purpose.probe == ProbeUse::Log; // its data are those of the log as a whole
        let set = || !of_log && param.is_machine_datum() && parse(&text) != Parsed::Number(0.0);
        (param.need(&inputs).is_some() || set()).then_some((param, text))
    });
    let values = written.collect();
    Source { cycle, inputs, typed: typed.clone(), control, values, form: false, bits: Vec::new() }
}

fn addresses(source: &Source) -> Lines {
    let mut text = Lines::default();
    text.push(&Functions::of(source.control).written(source.cycle));
    for (param, value) in &source.values {
        text.push(" ");
        text.word(Some(param.name), &format!("{}{value}", param.name));
    }
    text.line_end();
    text
}

/// A value as a program of this control writes it; none for one that cannot be written.
pub fn value(dialect: Dialect, param: &Param, typed: &str) -> Option<String> {
    let typed = typed.trim();
    if let Kind::Text(_) = param.kind {
        let Text::Plain(inner) = parse_text(typed) else { return Some(typed.to_owned()) };
        let plain = !inner.is_empty() && !inner.contains('"') && !inner.chars().any(char::is_control);
        return plain.then(|| format!("\"{inner}\""));
    }
    match parse(typed) {
        Parsed::Number(number) => Some(format!("{number}")),
        Parsed::Expression => expression::written(dialect, typed),
        Parsed::Empty | Parsed::Wrong => None,
    }
}

/// One assignment.
fn word(name: &str, value: &str) -> String {
    format!("{name}={value}")
}

/// `;_FA: measuring path`, NCT `(D: nominal diameter)`, of the values that are in the call.
fn comments(source: &Source, said: &[Name], words: Words) -> String {
    let mut text = String::new();
    for (param, _) in source.values.iter().filter(|(param, _)| said.contains(&param.name)) {
        let label = words(param.name.as_str(), &format!("param-{}", param.label(&source.inputs)));
        if label.is_empty() {
            continue; // a value without a field
        }
        // without the value: that of the call may change, the comment stays
        let line = format!("{}: {label}", param.name);
        let line: String = line.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        text.push_str(&(Grammar::of(source.cycle.dialect).commented)(&line));
    }
    text
}
