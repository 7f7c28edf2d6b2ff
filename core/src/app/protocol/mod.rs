//! A protocol of a real machine, matched with the calls of its program and laid onto the part: the same record, from
//! values that were measured.

mod arrows;
mod fit;
mod gaps;
mod heads;
#[cfg(test)]
mod tests;
mod text;

pub use arrows::Arrow;

use super::answer::{Value, Values, measured};
use super::record::RecordAbout;
use super::run::{Run, RunAnswer, RunRequest};
use super::{Error, record};
use crate::encoding::recognise;
use crate::machine::Setup;
use crate::message::{Message, printable};
use crate::refused::Path;
use crate::run::Outcome;
use fit::{Fit, Quantity};
use heads::HEAD;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use text::{Line, lines};

/// Most lines of a protocol.
const MOST: usize = 1_000_000;
/// A protocol, and the program that it is about.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ProtocolRequest {
    /// The program and the machine.
    pub run: RunRequest,
    /// The files of the protocol in their order: a log goes on in files that follow.
    pub protocol: Vec<String>,
    /// Their names, by which a file that is missing is noticed; absent: nobody knows.
    pub names: Option<Vec<String>>,
    /// What stands in which column; absent: the figures of a line tell it.
    pub columns: Option<ProtocolColumns>,
}

/// Columns of a table, each by its heading or its number from 1.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ProtocolColumns {
    /// Number of the call, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub number: Option<String>,
    /// Line of the call in the program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<String>,
    /// Name of the result: `_OVR[4]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub result: Option<String>,
    /// Setpoint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nominal: Option<String>,
    /// Actual value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub actual: Option<String>,
    /// Actual value minus setpoint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<String>,
}

/// A protocol laid onto the calls of a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ProtocolView {
    /// What each call came to on the machine.
    pub answers: Vec<RunAnswer>,
    /// Where the values come from.
    pub about: RecordAbout,
    /// How many lines fit, and how many calls have no value, in words.
    pub ending: Message,
    /// Lines of the protocol whose values stand in the answers.
    pub fitted: usize,
    /// Calls of which the protocol has no value.
    pub missing: usize,
    /// Lines that fit no call, in their order.
    pub unfit: Vec<ProtocolLine>,
    /// Lines that were laid though something in them contradicts it, in their order.
    pub doubtful: Vec<ProtocolLine>,
    /// A file of the log that is missing; absent: none is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<Message>,
    /// How the faces that were touched lie, in their order.
    pub arrows: Vec<Arrow>,
    /// Fields of the line with the headings, else of the first line of the protocol: names of its columns, where it is
    /// a table.
    pub heads: Vec<String>,
    /// What stands in which column, each by its number, where nobody chose it and the headings tell it.
    pub recognised: ProtocolColumns,
}

/// A line of a protocol that is told.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ProtocolLine {
    /// Index of the file.
    pub file: usize,
    /// Number of the line in it, from 1.
    pub line: u32,
    /// What stands in it, shortened.
    pub text: String,
    /// Why it fits no call, or what is in doubt, and what helps.
    pub why: Message,
}

/// A column of the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Column {
    index: usize,
    name: String,
}

/// What stands where.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Columns {
    number: Option<Column>,
    line: Option<Column>,
    result: Option<Column>,
    nominal: Option<Column>,
    actual: Option<Column>,
    deviation: Option<Column>,
}

/// Runs the program and lays the protocol onto what it measures.
///
/// # Errors
/// The machine has no such G function of units, or the protocol has nothing to read: why.
pub fn protocol(asked: ProtocolRequest) -> Result<ProtocolView, Error> {
    let mut run = Run::new(asked.run)?;
    while !run.advance(10_000) {}
    let source = run.view().trace;
    let view = laid(&asked.protocol, asked.columns.as_ref(), &source.setup, &source.outcome)?;
    Ok(ProtocolView { gap: missing_file(&asked.names.unwrap_or_default(), &source.outcome), ..view })
}

/// Lays a protocol onto what a program measured in a run.
///
/// # Errors
/// The protocol has nothing to read: why.
pub fn laid(
    texts: &[impl AsRef<str>],
    columns: Option<&ProtocolColumns>,
    setup: &Setup,
    outcome: &Outcome,
) -> Result<ProtocolView, Error> {
    let calls = super::run::answers(setup, outcome);
    if calls.is_empty() {
        return Err(refused("protocol-no-calls"));
    }
    if let Some(what) = texts.iter().find_map(|text| recognise(text.as_ref().as_bytes()).err()) {
        return Err(refused(what));
    }
    let units = outcome.called.first().map_or(setup.control.basic_units, |called| called.units);
    let lines: Vec<Line> =
        texts.iter().enumerate().flat_map(|(file, text)| lines(file, text.as_ref(), units)).collect();
    if lines.len() > MOST {
        return Err(Error::new("protocol-large", Path::default()).number("most", MOST as f64));
    }
    let first = lines.first().ok_or_else(|| refused("protocol-empty"))?;
    let lay = |columns: Option<(Columns, usize)>| Lay::of(&lines, columns.as_ref(), Fit::new(&calls, &outcome.called));
    let (mut heads, mut recognised) = (first.fields.clone(), ProtocolColumns::default());
    let laid = match columns {
        Some(names) => lay(Some(Columns::of(names, &lines)?)),
        None => {
            let plain = lay(None);
            let known =
                heads::recognised(&lines).and_then(|(names, line)| Some((Columns::of(&names, &lines).ok()?, line)));
            let by_heads = known.map(|(columns, line)| (columns.0.numbers(), line, lay(Some(columns))));
            match by_heads.filter(|(.., by_heads)| by_heads.fitted > plain.fitted) {
                Some((numbers, line, by_heads)) => {
                    (heads, recognised) = (line.fields.clone(), numbers);
                    by_heads
                }
                None => plain,
            }
        }
    };
    let Lay { quantities, fitted, unfit, mut doubtful } = laid;
    let mut values: BTreeMap<usize, Values> = BTreeMap::new();
    for one in &quantities {
        if let Some(actual) = one.actual {
            values.entry(one.call).or_default().insert(
                one.name,
                Value {
                    actual,
                    set: one.told.map(|set| set.value),
                    half: one.told.map_or(0.0, |set| set.half),
                    limits: one.limits,
                },
            );
        }
    }
    let missing = calls.len() - values.len();
    let arrows = arrows::arrows(&values, outcome);
    let answers = answers(calls, &values, outcome);
    doubtful.extend(quantities.into_iter().filter_map(|one| within(one, &answers)));
    doubtful.sort_by_key(|one| (one.file, one.line));
    let about = RecordAbout::measured(setup);
    let counts = Message::new("protocol-ending").number("fitted", fitted as f64).number("unfit", unfit.len() as f64);
    let ending = counts.number("missing", missing as f64);
    let gap = None;
    Ok(ProtocolView { answers, about, ending, fitted, missing, unfit, doubtful, gap, arrows, heads, recognised })
}

/// Says which file of a log is missing among those with these names; none: none is, or they say nothing.
pub fn missing_file(names: &[String], outcome: &Outcome) -> Option<Message> {
    gaps::gap(names, outcome.files.iter().map(|(name, _)| name))
}

impl ProtocolLine {
    fn of(line: &Line, why: Message) -> ProtocolLine {
        ProtocolLine { file: line.file, line: line.number, text: printable(&line.text), why }
    }
}

/// Lines of a protocol as they were laid.
struct Lay {
    quantities: Vec<Quantity>,
    fitted: usize,
    unfit: Vec<ProtocolLine>,
    doubtful: Vec<ProtocolLine>,
}

impl Lay {
    /// With the columns and the number of lines above their values; none: the figures of a line tell what they are.
    fn of(lines: &[Line], columns: Option<&(Columns, usize)>, mut fit: Fit) -> Lay {
        let (mut fitted, mut unfit, mut doubtful) = (0, Vec::new(), Vec::new());
        for (at, line) in lines.iter().enumerate() {
            let tried = match columns {
                Some((_, behind)) if at < *behind => continue,
                Some((columns, _)) => fit.row(line, columns).map(|()| None),
                None => fit.plain(line),
            };
            let told = |why| ProtocolLine::of(line, why);
            match tried {
                Ok(doubt) => {
                    fitted += 1;
                    doubtful.extend(doubt.map(told));
                }
                Err(why) => unfit.push(told(why)),
            }
        }
        Lay { quantities: fit.quantities, fitted, unfit, doubtful }
    }
}

/// A value that the machine marked as beyond a limit, and that is within its tolerance here.
fn within(one: Quantity, answers: &[RunAnswer]) -> Option<ProtocolLine> {
    let line = one.marked?;
    let figure = answers[one.call].answer.figures.iter().find(|figure| figure.name == one.name)?;
    let beyond = figure.limits.as_ref()?.used.is_none_or(|used| used > 1.0);
    let why = || Message::new("protocol-marked").number("actual", figure.actual);
    (!beyond).then(|| ProtocolLine::of(&line, why()))
}

/// The answers with the values of the protocol in the place of those of the run.
fn answers(calls: Vec<RunAnswer>, values: &BTreeMap<usize, Values>, outcome: &Outcome) -> Vec<RunAnswer> {
    let none = BTreeMap::new();
    let answer = |(index, (call, called)): (usize, (RunAnswer, _))| RunAnswer {
        answer: measured(called, outcome, values.get(&index).unwrap_or(&none)),
        probe: record::of_machine(call.probe),
        alarms: Vec::new(),
        ..call
    };
    calls.into_iter().zip(&outcome.called).enumerate().map(answer).collect()
}

fn refused(key: &'static str) -> Error {
    Error::new(key, Path::default())
}

impl Columns {
    /// Each by its number from 1.
    fn numbers(&self) -> ProtocolColumns {
        let number = |column: &Option<Column>| column.as_ref().map(|column| (column.index + 1).to_string());
        ProtocolColumns {
            number: number(&self.number),
            line: number(&self.line),
            result: number(&self.result),
            nominal: number(&self.nominal),
            actual: number(&self.actual),
            deviation: number(&self.deviation),
        }
    }

    /// The columns that are named, and how many lines stand above their values.
    fn of(names: &ProtocolColumns, lines: &[Line]) -> Result<(Columns, usize), Error> {
        let all = [&names.number, &names.line, &names.result, &names.nominal, &names.actual, &names.deviation];
        let named: Vec<&str> = all.into_iter().flatten().map(String::as_str).collect();
        if names.actual.is_none() && (names.deviation.is_none() || names.nominal.is_none()) {
            return Err(refused("protocol-no-actual"));
        }
        let by_number = |name: &str| name.trim().parse::<usize>().ok().filter(|number| *number > 0);
        let place = |name: &str, line: &Line| {
            let same = |field: &String| field.eq_ignore_ascii_case(name.trim());
            by_number(name).map(|number| number - 1).or_else(|| line.fields.iter().position(same))
        };
        let holds = |line: &&Line| named.iter().all(|name| by_number(name).is_some() || place(name, line).is_some());
        let Some((at, head)) = lines.iter().take(HEAD).enumerate().find(|(_, line)| holds(line)) else {
            let first = lines.first();
            let missing = |name: &&&str| first.is_none_or(|line| place(name, line).is_none());
            let name = named.iter().find(missing).copied().unwrap_or_default();
            let fields = first.map_or_else(String::new, |line| line.fields.join(" | "));
            return Err(Error::new("protocol-no-column", Path::default()).text("name", name).text("fields", fields));
        };
        let column = |name: &Option<String>| {
            let name = name.as_ref()?;
            Some(Column { index: place(name, head)?, name: name.clone() })
        };
        let columns = Columns {
            number: column(&names.number),
            line: column(&names.line),
            result: column(&names.result),
            nominal: column(&names.nominal),
            actual: column(&names.actual),
            deviation: column(&names.deviation),
        };
        let headed = named.iter().any(|name| by_number(name).is_none());
        Ok((columns, if headed { at + 1 } else { 0 }))
    }
}
