//! What the data of a log say together (A:15894-15948). A value that is known at run time only is not judged.

use super::keep::alarm_of;
use super::line::{Columns, Field, fields};
use super::names::{COLUMN, FILE, LINE, TITLES, VALUES};
use super::params::LONGEST_LINE;
use crate::catalogue::prelude::*;
use crate::check::announced;
use crate::machine::files::{self, Fault};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    if inputs.uses(FILE) {
        file(inputs, found);
    }
    if inputs.number(LINE) > LONGEST_LINE {
        let finding = announced(62310, "check-log-line", LINE).number("most", LONGEST_LINE);
        found.push(finding.hint_number("most", LONGEST_LINE));
    }
    empty(inputs, control, found);
    let columns = columns(inputs, found);
    for name in VALUES.into_iter().filter(|name| inputs.uses(*name)) {
        values(inputs, name, &columns, found);
    }
}

/// A name that a program can have, without another ending than that of a main program (B:11192).
fn file(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let name = inputs.text(FILE);
    let fault = match files::named(name) {
        Ok(file) if file.ends_with(".MPF") => return,
        Ok(_) => Fault::Type,
        Err(Fault::NoName) => return, // the form asks for it, a run is told so as of any value that is missing
        Err(fault) => fault,
    };
    found.push(refused(alarm_of(fault), "check-log-file", FILE));
}

/// Whether a program gives this text at run time.
fn open(name: Name, found: &[Diagnostic]) -> bool {
    found.iter().any(|finding| finding.param == Some(name))
}

/// Nothing is to be printed (A:15914). Also what this call does not print counts.
fn empty(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let given = |name: &Name| inputs.written.contains(name) || !control.text(name.as_str()).is_empty();
    let given = TITLES.iter().chain(&VALUES).any(|name| given(name) || open(*name, found));
    if !given {
        let at = if inputs.uses(VALUES[0]) { VALUES[0] } else { TITLES[0] };
        found.push(refused(61370, "check-log-empty", at));
    }
}

/// Widths of the columns; all of them have the fixed one where the title is known at run time only.
fn columns(inputs: &Inputs, found: &mut Vec<Diagnostic>) -> Columns {
    let (width, title) = (inputs.number(COLUMN), inputs.text(TITLES[0]));
    if inputs.given(COLUMN) == Some(0.0) && title.is_empty() && !open(TITLES[0], found) {
        found.push(announced(62308, "check-log-width", COLUMN));
    }
    Columns::new(width, title)
}

/// One line of values: what cannot be shown, what does not fit.
fn values(inputs: &Inputs, name: Name, columns: &Columns, found: &mut Vec<Diagnostic>) {
    let line = inputs.text(name);
    for field in fields(line) {
        if let Field::Unknown(word) = field {
            found.push(refused(61361, "check-log-unknown", name).text("word", word));
        }
    }
    let wide = fields(line).enumerate().find_map(|(column, field)| {
        let needed = field.width()?;
        (needed > columns.width(column)).then_some((column, needed))
    });
    if let Some((column, needed)) = wide {
        let finding = announced(62309, "check-log-narrow", name).number("column", column as f64 + 1.0);
        found.push(finding.number("width", columns.width(column) as f64).number("needed", needed as f64));
    }
    if !line.is_empty() {
        long(inputs, name, columns.total(line) as f64, found);
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
