//! The headings of a table that somebody else made: which of its columns is which, by the words that such tables use.

use super::text::{Figure, Line};
use super::{Column, Columns};

/// Lines in which the headings of a table are looked for.
pub const HEAD: usize = 100;

/// Words of headings in lower case.
const NUMBER: &[&str] = &["number", "no", "no.", "nr", "nr.", "nummer", "#", "序号", "编号"];
const LINE: &[&str] = &["line", "program line", "zeile", "programmzeile", "行", "程序行"];
const RESULT: &[&str] = &["variable", "parameter", "ergebnisparameter", "变量", "参数"];
const NOMINAL: &[&str] = &[
    "setpoint", "set", "set value", "nominal", "nominal value", "target", "soll", "sollwert", "nennmaß", "nennmass",
    "设定值", "名义值", "标称值", "理论值",
];
const ACTUAL: &[&str] = &[
    "actual", "act", "act.", "actual value", "act. value", "measured", "measured value", "ist", "istwert", "ist-wert",
    "messwert", "gemessen", "value", "reading", "wert", "实际值", "实测值", "测量值",
];
const DEVIATION: &[&str] = &[
    "deviation", "dev", "dev.", "difference", "diff", "diff.", "abweichung", "abw", "abw.", "differenz", "偏差", "差值",
];

/// The columns that each line of headings names, by the index of the line; none: it is no such table, or one block of
/// the control's own log after the other, which say themselves what they are (B:11486-11512).
pub fn recognised(lines: &[Line]) -> Vec<(usize, Columns)> {
    let own_log = lines.iter().any(|line| line.fields.iter().any(|field| field == "_MVAR"));
    if own_log {
        return Vec::new();
    }
    let named = |(at, line): (usize, &Line)| Some((at, named(line).filter(|found| holds(found, line, &lines[at..]))?));
    let Some(first) = lines.iter().enumerate().take(HEAD).find_map(named) else { return Vec::new() };
    let others = lines.iter().enumerate().skip(first.0 + 1).filter_map(named);
    std::iter::once(first.clone()).chain(others).collect()
}

/// Lines behind words that blanks part, in which the figures of a table are looked for.
const NEAR: usize = 6;

/// Whether these are the headings of a table. Words that blanks part could be a sentence: below them a line has a figure
/// in each column that is named.
fn holds(found: &Columns, heads: &Line, lines: &[Line]) -> bool {
    let figure = |line: &Line, column: &Column| line.fields.get(column.index).and_then(|field| Figure::of(field));
    let below = |line: &Line| {
        let of_table = line.fields.len() == heads.fields.len();
        of_table && found.figures().all(|column| figure(line, column).is_some())
    };
    heads.parted.is_some() || lines.iter().skip(1).take(NEAR).any(below)
}

/// The columns of a line of headings; none: it is another line.
fn named(line: &Line) -> Option<Columns> {
    if line.fields.iter().any(|field| Figure::of(field).is_some()) {
        return None;
    }
    let find = |words: &[&str]| {
        let index = line.fields.iter().position(|field| words.contains(&plain(field).as_str()))?;
        Some(Column { index, name: line.fields[index].clone() })
    };
    let found = Columns {
        number: find(NUMBER),
        line: find(LINE),
        result: find(RESULT),
        nominal: find(NOMINAL),
        actual: find(ACTUAL),
        deviation: find(DEVIATION),
    };
    let values = found.actual.is_some() || found.nominal.is_some() && found.deviation.is_some();
    let places = [&found.number, &found.line, &found.result, &found.nominal, &found.deviation];
    // a line of the program is named by no sentence with signs between its words, and says which call is meant
    let of_line = found.line.is_some() && line.parted.is_some() && line.fields.len() > 1;
    (values && places.into_iter().any(Option::is_some) || of_line).then_some(found)
}

/// A heading without the unit behind it: `Actual [mm]`, `Ist (mm)`.
fn plain(field: &str) -> String {
    let end = field.find(['[', '(', '/']).unwrap_or(field.len());
    field[..end].trim().trim_end_matches(':').to_lowercase()
}
