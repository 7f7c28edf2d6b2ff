//! Words of a program that could not be read: told as reading tells them and named at the end. What they would have
//! written is not known from then on, so that nothing is calculated or measured with an older value.

use super::{Address, Interpreter, Words, diameters, macro_system, stem};
use crate::catalogue::CYCLES;
use crate::check;
use crate::control::{AXES, gud, nct_data};
use crate::diagnostic::{Diagnostic, Span};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Typed};
use crate::message::printable;
use crate::name::numbered;
use crate::problem::Problem;
use crate::program::not_understood;
use crate::syntax::{Program, tree::Word, tree::WordKind};
use std::collections::BTreeMap;

/// What is not known, as a program names it (`_FA`, `_SETV[0]`, `R5`, `X`), with the word that would have written it.
pub type Unread = BTreeMap<String, Span>;

/// Addresses that decide where and with what is measured. H is the length register of NCT.
const PLACES: [&str; 9] = ["X", "Y", "Z", "A", "B", "C", "T", "D", "H"];

/// Words that decide where a program goes on.
const WAYS: [&str; 14] = [
    "IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "FOR", "ENDFOR", "LOOP", "UNTIL", "CASE", "GOTO", "GOTOF", "GOTOB",
    "REPEAT",
];

/// Passes over a word of a block that could not be read; where the way of the program depends on it, the run stops.
pub fn pass(run: &mut Interpreter, word: &Word, found: &mut Words) -> Result<(), Problem> {
    // every word of a block has the same block about it: the first one asks
    let first = !std::mem::replace(&mut found.unread, true);
    run.pass_over(printable(&run.program.written(word.span)), word.span);
    let text = run.program.said(word);
    let begins = |way: &str| {
        let rest = text.strip_prefix(way);
        rest.is_some_and(|rest| !rest.starts_with(|next: char| next.is_ascii_alphanumeric() || next == '_'))
    };
    let words = run.program.words_at(found.at);
    let branches = first && words.iter().any(|other| run.program.is_keyword(other, &WAYS));
    if branches || WAYS.iter().any(|way| begins(way)) {
        return Err(Problem::new("run-unread-way", word.span, printable(&text)));
    }
    if let Some(target) = target(run.program.dialect, &text) {
        run.unread.insert(target, word.span);
    }
    Ok(())
}

/// Passes over a block whose G function means something else on another control; nobody knows where its axes stand.
pub fn of_another_control(run: &mut Interpreter, cycle: &'static Cycle, found: &Words) {
    let span = found.path.span;
    let word = run.functions.written(cycle);
    let of_macro = |address: &&Address| {
        address.name == "G" && address.value.number().is_some_and(|code| word == format!("G{code}"))
    };
    let at = found.addresses.iter().find(of_macro).map_or(span, |word| word.span);
    run.tell_once(Diagnostic { span: Some(at), ..cycle.foreign(&word) });
    run.pass_over(cycle.name.to_owned(), span);
    leave_axes(run, found);
}

/// Nobody knows where the axes of a block stand behind it.
pub fn leave_axes(run: &mut Interpreter, found: &Words) {
    for axis in found.addresses.iter().filter(|address| ["X", "Y", "Z"].contains(&&*address.name)) {
        run.unread.insert(axis.name.clone(), axis.span);
    }
}

/// Nobody knows where any axis is behind a word.
pub fn leave_all_axes(run: &mut Interpreter, place: Span) {
    for axis in ["X", "Y", "Z"] {
        run.unread.insert(axis.to_owned(), place);
    }
}

/// Findings of reading by their blocks.
pub type Errors = BTreeMap<usize, Vec<Diagnostic>>;

/// Where reading found what.
pub fn errors(program: &Program) -> Errors {
    let mut found = Errors::new();
    for error in &program.errors {
        let block = program.line_of(error.span.start) as usize;
        found.entry(block).or_default().push(not_understood(program, error));
    }
    found
}

/// Tells what reading found in a block, when it comes for the first time.
pub fn tell(run: &mut Interpreter, at: usize) {
    for one in run.errors.remove(&at).unwrap_or_default() {
        run.tell_once(one);
    }
}

/// What a word would have written: a variable, or one of the addresses that count for a measurement.
fn target(dialect: Dialect, text: &str) -> Option<String> {
    let in_name = |one: char| one.is_ascii_alphanumeric() || "_$#".contains(one);
    let (name, rest) = text.split_at(text.find(|one| !in_name(one)).unwrap_or(text.len()));
    let rest = rest.trim_start();
    let (index, rest) = match rest.strip_prefix('[').and_then(|inside| inside.split_once(']')) {
        Some((index, rest)) => (Some(index), rest.trim_start()),
        None => (None, rest),
    };
    if let Some(code) = name.strip_prefix('G').and_then(leading) {
        return group(code).map(|_| format!("G{code}"));
    }
    if name.starts_with(diameters::BEGIN) {
        return Some(name.to_owned());
    }
    let address = name.get(..1).filter(|letter| PLACES.contains(letter));
    if let Some(letter) = address.filter(|_| name.len() == 1 || index.is_none() && !rest.starts_with('=')) {
        let number = name.len() == 1 || name[1..].starts_with(|one: char| one.is_ascii_digit());
        return number.then(|| letter.to_owned());
    }
    let assigns = rest.starts_with('=') || dialect == Dialect::Nct && name.starts_with('#');
    if !assigns || name.is_empty() {
        return None;
    }
    let Some(index) = index else { return Some(numbered(name.to_owned())) };
    let index: String = index.chars().filter(|one| !one.is_whitespace()).collect();
    let number = index.chars().all(|one| one.is_ascii_digit() || one == ',');
    Some(match (name, number) {
        ("R" | "#", true) => numbered(format!("{name}{index}")),
        (_, true) => format!("{name}[{index}]"),
        _ => name.to_owned(),
    })
}

/// The number with which a text begins.
fn leading(text: &str) -> Option<u32> {
    let end = text.find(|one: char| !one.is_ascii_digit()).unwrap_or(text.len());
    text.get(..end)?.parse().ok()
}

/// Groups of G functions that decide over a measurement: plane, compensation, zero offset, units, G90 and G91.
fn group(code: u32) -> Option<u32> {
    Some(match code {
        17..=19 => 17,
        40..=42 => 40,
        54..=59 | 500 | 505..=599 => 54,
        20 | 21 | 70 | 71 | 700 | 710 => 70,
        90 | 91 => 90,
        _ => return None,
    })
}

/// The G functions of a block say anew what those of their groups left unknown.
pub fn functions(run: &mut Interpreter, addresses: &[Address]) {
    let codes = addresses.iter().filter(|address| address.name == "G").filter_map(|address| address.value.number());
    for code in codes.filter(|code| code.fract() == 0.0) {
        let new = group(code as u32);
        let said = |name: &str| name.strip_prefix('G').and_then(leading).and_then(group);
        run.unread.retain(|name, _| new.is_none() || said(name) != new);
    }
}

/// Whether nobody knows where some axis stands.
pub fn somewhere(run: &Interpreter) -> bool {
    !run.unread.is_empty() && AXES.iter().any(|axis| run.unread.contains_key(*axis))
}

/// The addresses of a block say anew where the axes stand and which tool is in use.
pub fn placed(run: &mut Interpreter, addresses: &[Address]) {
    for address in addresses {
        let absolute = match address.mode.as_deref() {
            Some(mode) => !mode.contains("IC"),
            None => run.modal.absolute || ["T", "D", "H"].contains(&address.name.as_str()),
        };
        if absolute {
            run.unread.remove(&address.name);
        }
    }
}

/// A variable is read whose value may be unknown.
pub fn known(run: &Interpreter, key: &str, place: Span) -> Result<(), Problem> {
    let unread = [key, stem(key)].into_iter().find_map(|name| run.unread.get(name));
    let number = key.strip_prefix('#').filter(|_| !run.unread.is_empty()).and_then(|number| number.parse().ok());
    let told = || number.and_then(|number| macro_system::left_open(&run.unread, number));
    unread.or_else(told).map_or(Ok(()), |word| Err(unknown(run, key, *word, place)))
}

/// A call measures where the machine stands, with the tool in use and the data of the machine.
pub fn measures(run: &Interpreter, place: Span) -> Result<(), Problem> {
    run.unread.keys().find(|name| of_machine(run, name)).map_or(Ok(()), |name| known(run, name, place))
}

/// Whether a name decides over every measurement: a place, the tool, data that no call hands over or leaves.
fn of_machine(run: &Interpreter, name: &str) -> bool {
    if name.strip_prefix('G').and_then(leading).is_some() || name.starts_with(diameters::BEGIN) {
        return true;
    }
    if PLACES.contains(&name) {
        return !["A", "B", "C"].contains(&name) || run.sim.control.rotary_axis(name).is_some();
    }
    let stem = stem(name);
    let own = |cycle: &&'static Cycle| {
        let params = cycle.params.iter().map(|param| param.name.as_str());
        params.chain(cycle.results.iter().map(|result| result.name)).any(|known| self::stem(known) == stem)
    };
    gud::find(stem).is_some() && !CYCLES.iter().any(own) || name.starts_with('$') || nct_data::find(name).is_some()
}

/// A call takes these parameters from the data of the control.
pub fn takes(run: &Interpreter, cycle: &'static Cycle, typed: &Typed, place: Span) -> Result<(), Problem> {
    if run.unread.is_empty() {
        return Ok(());
    }
    let inputs = check::read(cycle, typed, &run.sim.control, &mut Vec::new());
    let mut used = cycle.params.iter().filter(|param| inputs.uses(param.name));
    used.try_for_each(|param| known(run, param.name.as_str(), place))
}

/// An address of the block itself that calls a macro could not be read.
pub fn own(run: &Interpreter, block: &[Word], place: Span) -> Result<(), Problem> {
    let word = block.iter().find(|word| word.kind == WordKind::Unknown);
    word.map_or(Ok(()), |word| Err(unknown(run, &printable(&run.program.name(word.span)), word.span, place)))
}

fn unknown(run: &Interpreter, name: &str, word: Span, place: Span) -> Problem {
    let line = f64::from(run.program.line_of(word.start) + 1);
    Problem::new("run-unread-value", place, name).number("line", line)
}
