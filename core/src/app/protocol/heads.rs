//! The headings of a table that somebody else made: which of its columns is which, by the words that such tables use.

use super::text::{Figure, Line};
use super::{Column, Columns, by_number};
use crate::catalogue::CYCLES;
use crate::message::Message;

/// Lines in which the headings of a table are looked for.
pub const HEAD: usize = 100;

/// Words of headings in lower case.
const NUMBER: &[&str] = &["number", "no", "no.", "nr", "nr.", "nummer", "#", "序号", "编号"];
const LINE: &[&str] = &["line", "program line", "zeile", "programmzeile", "行", "程序行"];
const RESULT: &[&str] = &["variable", "parameter", "ergebnisparameter", "变量", "参数"];
/// Words that may also stand above a verdict: they count above names of results.
const RESULT_OR_VERDICT: &[&str] = &["result", "ergebnis", "resultat", "结果"];
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
    let named = |(at, line): (usize, &Line)| Some((at, table(line, &lines[at + 1..])?));
    let Some(first) = lines.iter().enumerate().take(HEAD).find_map(named) else { return Vec::new() };
    let others = lines.iter().enumerate().skip(first.0 + 1).filter_map(named);
    std::iter::once(first.clone()).chain(others).collect()
}

/// Lines behind words that blanks part, in which the figures of a table are looked for.
const NEAR: usize = 6;

fn figure(line: &Line, column: &Column) -> Option<Figure> {
    line.fields.get(column.index).and_then(|field| Figure::of(field))
}

/// The columns of a line of headings above these lines; none: it is another line. Words that blanks part could be a
/// sentence: below them a line has a figure in each column that is named.
fn table(heads: &Line, below: &[Line]) -> Option<Columns> {
    let found = named(heads)?;
    // `Nr` above names is no number of a call
    let numbered = |column: &Column| below.iter().take(HEAD).any(|line| figure(line, column).is_some());
    let named = |column: &Column| RESULT.contains(&plain(&column.name).as_str()) || names_results(column, below);
    let found = Columns { number: found.number.filter(numbered), result: found.result.filter(named), ..found };
    let values = found.actual.is_some() || found.nominal.is_some() && found.deviation.is_some();
    let Columns { number, line, result, nominal, deviation, .. } = &found;
    let places = [number, line, result, nominal, deviation].into_iter().any(Option::is_some);
    // a line of the program is named by no sentence with signs between its words, and says which call is meant
    let of_line = line.is_some() && heads.parted.is_some() && heads.fields.len() > 1;
    let of_table = |line: &Line| {
        line.fields.len() == heads.fields.len() && found.figures().all(|column| figure(line, column).is_some())
    };
    let holds = heads.parted.is_some() || below.iter().take(NEAR).any(of_table);
    ((values && places || of_line) && holds).then_some(found)
}

/// The columns that the words of a line name; none: it has a figure, or none of them.
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
        result: find(RESULT).or_else(|| find(RESULT_OR_VERDICT)),
        nominal: find(NOMINAL),
        actual: find(ACTUAL),
        deviation: find(DEVIATION),
    };
    let is_known = found.all().next().is_some();
    is_known.then_some(found)
}

/// Whether names of results stand below a heading.
fn names_results(column: &Column, below: &[Line]) -> bool {
    let is_result = |name: &str| {
        let mut results = CYCLES.iter().flat_map(|cycle| cycle.results);
        results.any(|field| field.name.eq_ignore_ascii_case(name))
    };
    below.iter().take(HEAD).filter_map(|line| line.fields.get(column.index)).any(|field| is_result(field))
}

/// Says that another column could be meant as well as one that was taken by its heading; none: each is named once.
/// `words`: whether the words of headings were looked for, and not a heading that somebody chose.
pub fn twice(heads: &Line, columns: &Columns, words: bool) -> Option<Message> {
    let Columns { number, line, result, nominal, actual, deviation } = columns;
    let lists = [NUMBER, LINE, RESULT, NOMINAL, ACTUAL, DEVIATION];
    let taken = [number, line, result, nominal, actual, deviation].into_iter().zip(lists);
    let mut found = taken.filter_map(|(column, list)| {
        let column = column.as_ref().filter(|column| by_number(&column.name).is_none())?;
        let own = plain(&column.name);
        let same = |field: &str| plain(field) == own || words && list.contains(&plain(field).as_str());
        let mut fields = heads.fields.iter().enumerate();
        let (other, _) = fields.find(|(index, field)| *index != column.index && same(field))?;
        let told = Message::new("protocol-two-columns").text("name", &column.name);
        Some(told.number("first", (column.index + 1) as f64).number("other", (other + 1) as f64))
    });
    found.next()
}

/// A heading without the unit behind it: `Actual [mm]`, `Ist (mm)`.
fn plain(field: &str) -> String {
    let end = field.find(['[', '(', '/']).unwrap_or(field.len());
    field[..end].trim().trim_end_matches(':').to_lowercase()
}
