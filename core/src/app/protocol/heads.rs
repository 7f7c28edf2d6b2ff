//! The headings of a table that somebody else made: which of its columns is which, by the words that such tables use.

use super::ProtocolColumns;
use super::text::{Figure, Line};

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
    "messwert", "gemessen", "实际值", "实测值", "测量值",
];
const DEVIATION: &[&str] = &[
    "deviation", "dev", "dev.", "difference", "diff", "diff.", "abweichung", "abw", "abw.", "differenz", "偏差", "差值",
];

/// The columns that the headings of a table name, and the line of the headings; none: it is no such table, or one block
/// of the control's own log after the other, which say themselves what they are (B:11486-11512).
pub fn recognised(lines: &[Line]) -> Option<(ProtocolColumns, &Line)> {
    let own_log = lines.iter().any(|line| line.fields.iter().any(|field| field == "_MVAR"));
    if own_log {
        return None;
    }
    lines.iter().take(HEAD).find_map(|line| Some((named(line)?, line)))
}

/// The columns of a line of headings; none: it is another line.
fn named(line: &Line) -> Option<ProtocolColumns> {
    if line.fields.iter().any(|field| Figure::of(field).is_some()) {
        return None;
    }
    let find = |words: &[&str]| {
        let heading = |field: &&String| words.contains(&plain(field).as_str());
        line.fields.iter().find(heading).cloned()
    };
    let found = ProtocolColumns {
        number: find(NUMBER),
        line: find(LINE),
        result: find(RESULT),
        nominal: find(NOMINAL),
        actual: find(ACTUAL),
        deviation: find(DEVIATION),
    };
    // the number of the call says more than its line
    let line = found.line.filter(|_| found.number.is_none());
    let found = ProtocolColumns { line, ..found };
    let values = found.actual.is_some() || found.nominal.is_some() && found.deviation.is_some();
    let places = [&found.number, &found.line, &found.result, &found.nominal, &found.deviation];
    (values && places.into_iter().any(Option::is_some)).then_some(found)
}

/// A heading without the unit behind it: `Actual [mm]`, `Ist (mm)`.
fn plain(field: &str) -> String {
    let end = field.find(['[', '(', '/']).unwrap_or(field.len());
    field[..end].trim().trim_end_matches(':').to_lowercase()
}
