//! The record as a table: a line for each quantity of each call, as spreadsheets take it. The page writes the same
//! (www/src/views/csv.ts); `docs/hole.record.csv` holds the two together.

use super::{Record, RecordFile};
use crate::app::answer::{Correction, Figure};
use crate::app::run::RunAnswer;
use crate::message::Message;

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

/// How a table is written.
struct Written<'a> {
    say: &'a dyn Fn(&Message) -> String,
    /// Whether numbers have a decimal comma; fields are parted by semicolons then.
    comma: bool,
}

/// The record as CSV, UTF-8 with a mark. `say`: the words of a message, and with them the decimal sign.
pub fn csv(record: &Record, say: &dyn Fn(&Message) -> String) -> String {
    let written = Written { say, comma: say(&Message::new("record-decimal-sign")) == "," };
    let head = COLUMNS.map(|one| written.key(format!("record-column-{one}")));
    let mut text = String::from(MARK);
    written.line(&mut text, &head);
    for (index, call) in record.calls.iter().enumerate() {
        let figures = call.answer.figures.iter().map(Some);
        let none = call.answer.figures.is_empty().then_some(None);
        for figure in figures.chain(none) {
            written.line(&mut text, &written.row(index, call, figure, &record.files));
        }
    }
    text
}

impl Written<'_> {
    fn row(&self, index: usize, call: &RunAnswer, figure: Option<&Figure>, files: &[RecordFile]) -> [String; 19] {
        let RunAnswer { answer, call: at, probe, alarms, .. } = call;
        let limits = figure.and_then(|figure| figure.limits);
        let say = self.say;
        [
            (index + 1).to_string(),
            at.line.map_or_else(String::new, |line| short_line(files, line)),
            at.cycle.unwrap_or_default().to_owned(),
            say(&answer.feature),
            figure.map_or_else(String::new, |figure| say(&figure.label)),
            self.number(figure.and_then(|figure| figure.set)),
            self.number(limits.map(|limits| limits.low)),
            self.number(limits.map(|limits| limits.high)),
            self.number(figure.map(|figure| figure.actual)),
            self.number(figure.and_then(|figure| figure.deviation)),
            self.number(limits.and_then(|limits| limits.used)),
            figure.map_or("", |figure| unit(figure.unit)).to_owned(),
            self.key(held(figure)),
            say(&answer.verdict_words),
            self.corrected(&answer.corrected),
            say(&probe.name),
            say(&probe.calibration),
            alarms.join(" "),
            say(&answer.why),
        ]
    }

    fn corrected(&self, corrected: &[Correction]) -> String {
        let one = |one: &Correction| {
            let parts = one.parts.iter().map(|part| {
                let unit = if part.unit == "deg" { "°".to_owned() } else { format!(" {}", unit(part.unit)) };
                format!(" {} {}{unit}", part.name, self.number(Some(part.by)))
            });
            (self.say)(&one.target) + &parts.collect::<String>()
        };
        corrected.iter().map(one).collect::<Vec<_>>().join(", ")
    }

    fn key(&self, key: impl Into<std::borrow::Cow<'static, str>>) -> String {
        (self.say)(&Message::new(key))
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
fn held(figure: Option<&Figure>) -> &'static str {
    let limited = figure.and_then(|figure| Some((figure.limits?, figure.deviation?)));
    let Some((limits, deviation)) = limited else { return "record-unlimited" };
    let within = limits.low - ON..=limits.high + ON;
    if within.contains(&deviation) { "record-within" } else { "record-beyond" }
}

/// A unit as it is read everywhere.
fn unit(unit: &'static str) -> &'static str {
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
