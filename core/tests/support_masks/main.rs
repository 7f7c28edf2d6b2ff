//! Forms and code with the settings of the control's own support, and what is said when a program is read back under
//! other ones (B:12412-12558).
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod reading;
mod rows;
mod samples;
mod targets;

use probewright_core::catalogue::example::example;
use probewright_core::catalogue::find;
use probewright_core::control::{Control, delivery};
use probewright_core::diagnostic::{Code, Diagnostic};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Style, Typed};
use probewright_core::form::{Entry, fields};
use probewright_core::program::findings_on;
use probewright_core::program::write::{Written, snippet};
use probewright_core::support;
use probewright_core::support::Support;
use probewright_core::syntax::read;

/// With default data (B:12501-12539).
const DELIVERED: [u8; 8] = [1, 0, 0, 0, 0, 0, 0, 0];

fn machine(mask: [u8; 8]) -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.set(support::FORMS, 1.0);
    for (entry, value) in mask.into_iter().enumerate() {
        control.set(support::name(entry), f64::from(value));
    }
    control
}

/// The default mask with one entry.
fn with(entry: usize, value: u8) -> Control {
    let mut mask = DELIVERED;
    mask[entry] = value;
    machine(mask)
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

fn typed(pairs: &str) -> Typed {
    let pair = |word: &str| {
        let (name, value) = word.split_once('=').unwrap();
        (name.to_owned(), value.to_owned())
    };
    pairs.split_whitespace().map(pair).collect()
}

/// The worked measurement of a variant of a cycle.
fn values(name: &str, variant: i64) -> Typed {
    let variants = cycle(name).variants.iter();
    let variant = variants.into_iter().find(|one| one.number == variant);
    example(cycle(name), variant.unwrap())
}

fn written(name: &str, values: &Typed, control: &Control, style: Style) -> Written {
    snippet(cycle(name), values, control, style, None)
}

fn code(name: &str, values: &Typed, control: &Control) -> String {
    written(name, values, control, Style::Direct).text
}

/// Assignments of a text, in order.
fn words(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| !line.starts_with(';'));
    let words = lines.flat_map(str::split_whitespace);
    words.map(str::to_owned).collect()
}

fn has(text: &str, word: &str) -> bool {
    words(text).iter().any(|one| one == word)
}

fn shown(name: &str, values: &Typed, control: &Control) -> Vec<&'static str> {
    let entered = Support::of(cycle(name), control).map(|support| {
        let mut control = control.clone();
        let entered = support.entered(cycle(name), values, &control);
        entered.write(&mut control);
        fields(cycle(name), &entered.values, &control)
    });
    let fields = entered.unwrap_or_else(|| fields(cycle(name), values, control));
    fields.iter().map(|field| field.name.as_str()).collect()
}

fn entry(name: &str, values: &Typed, control: &Control, field: &str) -> Entry {
    let all = fields(cycle(name), values, control);
    all.into_iter().find(|one| one.name == field).unwrap().entry
}

fn said(text: &str, control: &Control) -> Vec<Diagnostic> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let mut found = findings_on(&program, control.clone());
    found.retain(|one| matches!(one.code, Code::Own(140..=143)));
    found
}

fn codes(text: &str, control: &Control) -> Vec<Code> {
    said(text, control).iter().map(|one| one.code).collect()
}
