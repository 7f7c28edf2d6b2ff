//! A value that a subprogram writes too, called between the assignment and the measuring call: what is read at the
//! assignment is not what counts at the call. Parameters are data of the channel: all programs share them.

use super::at;
use crate::check::{Finding, Parsed, parse, warning};
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;
use crate::program::calls::CallSite;
use crate::program::flow::{Called, LEVELS, called, callers};
use crate::program::fold::{self, Known};
use crate::program::tree::{Program, WordKind};
use crate::run::programs::{Programs, Unit, programs};
use std::collections::BTreeMap;

/// What a program writes, by name; no number where it depends on the run, or differs from one place to the next.
type Written = BTreeMap<String, Option<f64>>;

/// Where programs are called that write a datum, by its name, in the order of the text; with what they write.
type Writers = BTreeMap<String, Vec<(u32, Option<f64>)>>;

/// Each measuring call whose value was written anew since.
pub fn look(program: &Program, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    let programs = programs(program);
    if programs.units.len() < 2 || sites.is_empty() {
        return;
    }
    let writers = writers(program, &programs);
    if writers.is_empty() {
        return;
    }
    let unit = |line: usize| {
        let units = &programs.units;
        units.partition_point(|unit| unit.blocks.start <= line)
    };
    for site in sites {
        for (name, place) in &site.places {
            if unit(program.line_of(place.start) as usize) != unit(site.line as usize) {
                continue;
            }
            let calls = writers.get(*name).map(Vec::as_slice).unwrap_or_default();
            let next = calls.partition_point(|(start, _)| *start < place.end);
            let between = calls
                .get(next)
                .filter(|(start, _)| *start < site.span.start);
            let Some((call, number)) = between else {
                continue;
            };
            let typed = site.values.get(*name).map(String::as_str);
            if number.is_none() || *number != number_of(typed.unwrap_or_default()) {
                found.push(at(finding(name, program.line_of(*call) + 1), *place));
            }
        }
    }
}

fn number_of(typed: &str) -> Option<f64> {
    match parse(typed) {
        Parsed::Number(number) => Some(number),
        _ => None,
    }
}

fn finding(name: &str, line: u32) -> Diagnostic {
    let text = |key: &'static str| Message::new(key).text("name", name);
    let message = text("advice-overwritten").number("line", f64::from(line));
    warning(Code::Own(150), message).hint(text("advice-overwritten-hint"))
}

fn writers(program: &Program, programs: &Programs) -> Writers {
    let written = written(program, programs);
    let mut writers = Writers::new();
    for block in &program.blocks {
        let words = program.words_of(block);
        for (index, word) in words.iter().enumerate() {
            let Some(Called::Here(unit)) = called(program, programs, words, index) else {
                continue;
            };
            for (name, number) in written.get(unit).into_iter().flatten() {
                let calls = writers.entry(name.clone()).or_default();
                calls.push((word.span.start, *number));
            }
        }
    }
    writers
}

/// The data that each program writes, itself or in one that it calls.
fn written(program: &Program, programs: &Programs) -> Vec<Written> {
    let mut written: Vec<Written> = programs
        .units
        .iter()
        .map(|unit| own(program, unit))
        .collect();
    let calls = callers(program, programs);
    for _ in 0..LEVELS {
        let before = written.clone();
        for (names, called) in written.iter_mut().zip(&calls) {
            for (name, number) in called.iter().filter_map(|unit| before.get(*unit)).flatten() {
                add(names, name.clone(), *number);
            }
        }
        if written == before {
            break;
        }
    }
    written
}

fn add(names: &mut Written, name: String, number: Option<f64>) {
    let known = names.entry(name).or_insert(number);
    if *known != number {
        *known = None;
    }
}

/// What a program writes itself.
fn own(program: &Program, unit: &Unit) -> Written {
    let known = Known::new();
    let mut names = Written::new();
    let blocks = program.blocks.get(unit.blocks.clone()).unwrap_or_default();
    for word in blocks.iter().flat_map(|block| program.words_of(block)) {
        if let WordKind::Assign {
            name, index, value, ..
        } = &word.kind
            && let Some(name) = fold::name(program, *name, index, &known)
        {
            add(&mut names, name, fold::number(program, *value, &known));
        }
    }
    names
}
