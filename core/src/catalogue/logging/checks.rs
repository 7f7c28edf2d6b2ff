//! What the data of a log say together (A:15894-15948). A value that is known at run time only is not judged.

use super::line::{Field, fields, widths};
use super::names::{COLUMN, FILE, LINE, TITLES, VALUES};
use super::params::LONGEST_LINE;
use crate::catalogue::prelude::*;
use crate::check::announced;

/// Width of a column where the titles give none, characters (A:15945).
const FIXED: usize = 12;

/// All of them.
pub fn checks(inputs: &Inputs, _: &Control, found: &mut Vec<Diagnostic>) {
    if inputs.uses(FILE) {
        file(inputs, found);
    }
    if inputs.number(LINE) > LONGEST_LINE {
        let finding = announced(62310, "check-log-line", LINE).number("most", LONGEST_LINE);
        found.push(finding.hint_number("most", LONGEST_LINE));
    }
    empty(inputs, found);
    let widths = columns(inputs, found);
    for name in VALUES.into_iter().filter(|name| inputs.uses(*name)) {
        values(inputs, name, &widths, found);
    }
}

/// Letters, digits and underscores; two letters first, or a letter and an underscore (B:11192).
fn file(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let name = inputs.text(FILE);
    let known = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let starts = match name.as_bytes() {
        [first, second, ..] => first.is_ascii_alphabetic() && (second.is_ascii_alphabetic() || *second == b'_'),
        _ => false,
    };
    let right = starts && name.chars().all(known);
    if !name.is_empty() && !right {
        found.push(own::LOG_FILE.finding().at(FILE));
    }
}

/// Whether a program gives this text at run time.
fn open(name: Name, found: &[Diagnostic]) -> bool {
    found.iter().any(|finding| finding.param == Some(name))
}

/// Nothing is to be printed (A:15914).
fn empty(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let mut all = TITLES.iter().chain(&VALUES);
    let given = all.any(|name| !inputs.text(*name).is_empty() || open(*name, found));
    if !given {
        let at = if inputs.uses(VALUES[0]) { VALUES[0] } else { TITLES[0] };
        found.push(refused(61370, "check-log-empty", at));
    }
}

/// Widths of the columns; empty where all of them are as wide as the number says.
fn columns(inputs: &Inputs, found: &mut Vec<Diagnostic>) -> Vec<usize> {
    if inputs.given(COLUMN) != Some(0.0) || open(TITLES[0], found) {
        return Vec::new();
    }
    let title = inputs.text(TITLES[0]);
    if title.is_empty() {
        found.push(announced(62308, "check-log-width", COLUMN));
        return Vec::new();
    }
    widths(title).collect()
}

/// One line of values: what cannot be shown, what does not fit.
fn values(inputs: &Inputs, name: Name, widths: &[usize], found: &mut Vec<Diagnostic>) {
    let line = inputs.text(name);
    for field in fields(line) {
        if let Field::Unknown(word) = field {
            found.push(refused(61361, "check-log-unknown", name).text("word", word));
        }
    }
    let fixed = match inputs.number(COLUMN) as usize {
        0 => FIXED,
        width => width,
    };
    let width = |column: usize| widths.get(column).copied().unwrap_or(fixed);
    let wide = fields(line).enumerate().find_map(|(column, field)| {
        let needed = field.width()?;
        (needed > width(column)).then_some((column, needed))
    });
    if let Some((column, needed)) = wide {
        let finding = announced(62309, "check-log-narrow", name).number("column", column as f64 + 1.0);
        found.push(finding.number("width", width(column) as f64).number("needed", needed as f64));
    }
    let total: usize = (0..fields(line).count()).map(width).sum();
    if !line.is_empty() {
        long(inputs, name, total as f64, found);
    }
}

/// A line that is longer than allowed: by the cycles (A:15915), by the program (A:15944).
fn long(inputs: &Inputs, name: Name, total: f64, found: &mut Vec<Diagnostic>) {
    let (finding, most) = match inputs.given(LINE) {
        _ if total > LONGEST_LINE => (refused(61371, "check-log-long", name), LONGEST_LINE),
        Some(most) if total > most => (announced(62307, "check-log-longer", name), most),
        _ => return,
    };
    found.push(finding.number("total", total).number("most", most));
}
