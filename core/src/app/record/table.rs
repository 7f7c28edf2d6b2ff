//! The record as a table: a line for each quantity of each call, as spreadsheets take it; for the terminal from the
//! record, for the page from its document.

use super::{Record, RecordFile};
use crate::app::answer::{Correction, Figure};
use crate::app::run::RunAnswer;
use crate::message::Message;
use serde::Deserialize;

/// The columns in their order; each heading is `record-column-…`.
pub const COLUMNS: [&str; 19] = [
    "number", "line", "cycle", "feature", "quantity", "nominal", "low", "high", "actual", "deviation", "used", "unit",
    "within", "verdict", "corrects", "probe", "calibration", "alarms", "why",
];

/// So that spreadsheets see that it is UTF-8.
const MARK: char = '\u{feff}';
/// Decimals of a value, without needless zeros.
const DECIMALS: usize = 6;

/// How far a deviation on a limit may be off by calculation.
const ON: f64 = 1e-6;

/// A message that is said already: as a document has it, with its sentence beside its key.
#[derive(Clone, Debug, PartialEq, Deserialize)]
struct Said {
    text: String,
}

/// A call of a record in the words of a reader, as far as the table tells it: what a document of the record has, too.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct TableCall {
    line: Option<u32>,
    cycle: Option<String>,
    feature: Said,
    figures: Vec<TableFigure>,
    corrected: Vec<TableCorrection>,
    verdict_words: Said,
    why: Said,
    probe: TableProbe,
    alarms: Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
struct TableFigure {
    label: Said,
    actual: Option<f64>,
    set: Option<f64>,
    deviation: Option<f64>,
    unit: String,
    limits: Option<TableLimits>,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
struct TableLimits {
    low: f64,
    high: f64,
    used: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
struct TableCorrection {
    target: Said,
    parts: Vec<TablePart>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
struct TablePart {
    name: String,
    by: Option<f64>,
    unit: String,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
struct TableProbe {
    name: Said,
    calibration: Said,
}

/// Calls of a record that are to be lines of its table.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct TableRequest {
    /// The calls, with what they say in words.
    pub calls: Vec<TableCall>,
    /// How many calls stand before them; the first ones are below the headings.
    pub first: usize,
    /// Files beside the program.
    pub files: Vec<RecordFile>,
}

impl TableCall {
    fn of(call: &RunAnswer, say: &dyn Fn(&Message) -> String) -> TableCall {
        let said = |message: &Message| Said { text: say(message) };
        let RunAnswer { answer, call: at, probe, alarms, .. } = call;
        let figure = |one: &Figure| TableFigure {
            label: said(&one.label),
            actual: Some(one.actual),
            set: one.set,
            deviation: one.deviation,
            unit: one.unit.to_owned(),
            limits: one.limits.map(|limits| TableLimits { low: limits.low, high: limits.high, used: limits.used }),
        };
        let correction = |one: &Correction| {
            let parts = one.parts.iter();
            let part = parts.map(|part| TablePart {
                name: part.name.to_string(),
                by: Some(part.by),
                unit: part.unit.to_owned(),
            });
            TableCorrection { target: said(&one.target), parts: part.collect() }
        };
        TableCall {
            line: at.line,
            cycle: at.cycle.map(ToOwned::to_owned),
            feature: said(&answer.feature),
            figures: answer.figures.iter().map(figure).collect(),
            corrected: answer.corrected.iter().map(correction).collect(),
            verdict_words: said(&answer.verdict_words),
            why: said(&answer.why),
            probe: TableProbe { name: said(&probe.name), calibration: said(&probe.calibration) },
            alarms: alarms.clone(),
        }
    }
}

/// How a table is written.
struct Written<'a> {
    say: &'a dyn Fn(&str) -> String,
    /// Whether numbers have a decimal comma; fields are parted by semicolons then.
    comma: bool,
}

/// The record as CSV, UTF-8 with a mark. `say`: the words of a message, and with them the decimal sign.
pub fn csv(record: &Record, say: &dyn Fn(&Message) -> String) -> String {
    let calls = record.calls.iter().map(|call| TableCall::of(call, say)).collect();
    let asked = TableRequest { calls, first: 0, files: record.files.clone() };
    record_table(&asked, &|key| say(&Message::new(key.to_owned())))
}

/// A piece of that table, so that a long record can be written in pieces. `say`: the words of a key.
pub fn record_table(asked: &TableRequest, say: &dyn Fn(&str) -> String) -> String {
    let written = Written { say, comma: say("record-decimal-sign") == "," };
    let mut text = String::new();
    if asked.first == 0 {
        text.push(MARK);
        written.line(&mut text, &COLUMNS.map(|one| say(&format!("record-column-{one}"))));
    }
    for (index, call) in asked.calls.iter().enumerate() {
        let figures = call.figures.iter().map(Some);
        let none = call.figures.is_empty().then_some(None);
        for figure in figures.chain(none) {
            written.line(&mut text, &written.row(asked.first + index, call, figure, &asked.files));
        }
    }
    text
}

impl Written<'_> {
    fn row(&self, index: usize, call: &TableCall, figure: Option<&TableFigure>, files: &[RecordFile]) -> [String; 19] {
        let limits = figure.and_then(|figure| figure.limits);
        [
            (index + 1).to_string(),
            call.line.map_or_else(String::new, |line| short_line(files, line)),
            call.cycle.clone().unwrap_or_default(),
            call.feature.text.clone(),
            figure.map_or_else(String::new, |figure| figure.label.text.clone()),
            self.number(figure.and_then(|figure| figure.set)),
            self.number(limits.map(|limits| limits.low)),
            self.number(limits.map(|limits| limits.high)),
            self.number(figure.and_then(|figure| figure.actual)),
            self.number(figure.and_then(|figure| figure.deviation)),
            self.number(limits.and_then(|limits| limits.used)),
            figure.map_or("", |figure| unit(&figure.unit)).to_owned(),
            (self.say)(held(figure)),
            call.verdict_words.text.clone(),
            self.corrected(&call.corrected),
            call.probe.name.text.clone(),
            call.probe.calibration.text.clone(),
            call.alarms.join(" "),
            call.why.text.clone(),
        ]
    }

    fn corrected(&self, corrected: &[TableCorrection]) -> String {
        let one = |one: &TableCorrection| {
            let parts = one.parts.iter().map(|part| {
                let unit = if part.unit == "deg" { "°".to_owned() } else { format!(" {}", unit(&part.unit)) };
                format!(" {} {}{unit}", part.name, self.number(part.by))
            });
            one.target.text.clone() + &parts.collect::<String>()
        };
        corrected.iter().map(one).collect::<Vec<_>>().join(", ")
    }

    /// Without needless zeros; a 0 has no sign.
    fn number(&self, value: Option<f64>) -> String {
        let Some(value) = value.filter(|value| value.is_finite()) else { return String::new() };
        let text = format!("{value:.DECIMALS$}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        let text = if text == "-0" { "0" } else { text };
        if self.comma { text.replace('.', ",") } else { text.to_owned() }
    }

    fn line(&self, text: &mut String, fields: &[String]) {
        let parted = if self.comma { ';' } else { ',' };
        for (index, field) in fields.iter().enumerate() {
            if index > 0 {
                text.push(parted);
            }
            text.push_str(&quoted(field, parted));
        }
        text.push_str("\r\n");
    }
}

/// Key of whether a quantity by itself is within its limits.
fn held(figure: Option<&TableFigure>) -> &'static str {
    let limited = figure.and_then(|figure| Some((figure.limits?, figure.deviation?)));
    let Some((limits, deviation)) = limited else { return "record-unlimited" };
    let within = limits.low - ON..=limits.high + ON;
    if within.contains(&deviation) { "record-within" } else { "record-beyond" }
}

/// A unit as it is read everywhere.
fn unit(unit: &str) -> &str {
    if unit == "deg" { "°" } else { unit }
}

/// In quotes where it has to be; what a spreadsheet would take for a formula gets an apostrophe.
fn quoted(field: &str, parted: char) -> String {
    let safe = if field.starts_with(['=', '@']) { format!("'{field}") } else { field.to_owned() };
    let needs = safe.contains(parted) || safe.contains(['"', '\r', '\n']);
    if needs { format!("\"{}\"", safe.replace('"', "\"\"")) } else { safe }
}

/// `L105.SPF:3`, of the program itself the line alone.
fn short_line(files: &[RecordFile], line: u32) -> String {
    match files.iter().rfind(|file| file.line <= line) {
        Some(file) => format!("{}:{}", file.name, line - file.line + 1),
        None => line.to_string(),
    }
}
