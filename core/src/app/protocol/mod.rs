//! A protocol of a real machine, matched with the calls of its program and laid onto the part: the same record, from
//! values that were measured.

mod arrows;
mod cells;
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
use text::{Fault, Figure, Line, lines};

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
    let tables = match columns {
        Some(names) => Table::chosen(names, &lines)?,
        None => heads::recognised(&lines).into_iter().map(|(at, columns)| Table::below(at, columns, &lines)).collect(),
    };
    let head = tables.first().filter(|_| columns.is_none());
    let heads = head.and_then(|table| Some(&lines[table.head?])).unwrap_or(first).fields.clone();
    let recognised = head.map(|table| table.columns.numbers()).unwrap_or_default();
    let laid = Lay::of(&lines, &tables, Fit::new(&calls, &outcome.called));
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
    let twice = tables.iter().filter_map(|table| {
        let heads = &lines[table.head?];
        Some(ProtocolLine::of(heads, heads::twice(heads, &table.columns, columns.is_none())?))
    });
    doubtful.extend(twice);
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
    /// Below headings, by them; where there are none the figures of a line tell what they are.
    fn of(lines: &[Line], tables: &[Table], mut fit: Fit) -> Lay {
        let (mut fitted, mut unfit, mut doubtful) = (0, Vec::new(), Vec::new());
        let mut below = tables.iter().peekable();
        let mut table: Option<&Table> = None;
        for (at, line) in lines.iter().enumerate() {
            while let Some(next) = below.next_if(|next| next.from <= at) {
                table = Some(next);
            }
            let is_head = below.peek().is_some_and(|next| next.head == Some(at));
            let tried = match table {
                _ if is_head => continue,
                Some(table) => table.row(line, &mut fit),
                None if tables.is_empty() => fit.plain(line),
                None if line.figures().nth(1).is_none() => continue,
                None => Err(Message::new("protocol-above")),
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

/// Lines of which it is known what stands in which column, as far as the next ones.
struct Table {
    columns: Columns,
    /// Index of the line of its headings, and of its first line.
    head: Option<usize>,
    from: usize,
    /// How many columns have a heading.
    width: Option<usize>,
}

impl Table {
    /// The lines below this line of headings.
    fn below(head: usize, columns: Columns, lines: &[Line]) -> Table {
        let width = lines[head].fields.iter().rposition(|field| !field.is_empty()).map(|last| last + 1);
        Table { columns, head: Some(head), from: head + 1, width }
    }

    /// Those whose columns are chosen, by their headings or by their numbers.
    fn chosen(names: &ProtocolColumns, lines: &[Line]) -> Result<Vec<Table>, Error> {
        let (columns, head) = Columns::of(names, lines)?;
        if let Some(head) = head {
            let others = lines.iter().enumerate().skip(head + 1);
            let again = others.filter_map(|(at, line)| Some(Table::below(at, Columns::at(names, line)?, lines)));
            return Ok(std::iter::once(Table::below(head, columns, lines)).chain(again).collect());
        }
        let known = heads::recognised(lines).into_iter();
        let tables: Vec<Table> = known.map(|(at, _)| Table::below(at, columns.clone(), lines)).collect();
        let whole = || vec![Table { columns, head: None, from: 0, width: None }];
        Ok(if tables.is_empty() { whole() } else { tables })
    }

    /// Lays a line of it.
    fn row(&self, line: &Line, fit: &mut Fit) -> Result<Option<Message>, Message> {
        let cells = line.fields.iter().rposition(|field| !field.is_empty()).map_or(0, |last| last + 1);
        match self.width.filter(|width| cells > *width) {
            Some(width) => {
                let key = if line.parted == Some(',') { "protocol-wide" } else { "protocol-cells" };
                Err(Message::new(key).number("cells", cells as f64).number("heads", width as f64))
            }
            None if line.fault == Some(Fault::Comma) && self.width.is_none() && self.is_cut(line) => {
                Err(Message::new("protocol-comma"))
            }
            None => fit.row(line, &self.columns).map(|()| None),
        }
    }

    /// Whether behind a value stands a figure of which nobody says what it is: it may be its decimals.
    fn is_cut(&self, line: &Line) -> bool {
        let Columns { nominal, actual, deviation, .. } = &self.columns;
        let taken = |index: usize| self.columns.all().any(|column| column.index == index);
        let figure = |index: usize| line.fields.get(index).is_some_and(|field| Figure::of(field).is_some());
        let values = [nominal, actual, deviation].into_iter().flatten();
        values.map(|column| column.index + 1).any(|next| !taken(next) && figure(next))
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
    fn all(&self) -> impl Iterator<Item = &Column> {
        let Columns { number, line, result, nominal, actual, deviation } = self;
        [number, line, result, nominal, actual, deviation].into_iter().flatten()
    }

    /// A column that is named for two things.
    fn shared(&self) -> Option<&Column> {
        let mut others = self.all().enumerate();
        others.find(|(at, one)| self.all().take(*at).any(|other| other.index == one.index)).map(|(_, one)| one)
    }

    /// Those that hold figures.
    fn figures(&self) -> impl Iterator<Item = &Column> {
        let Columns { number, line, nominal, actual, deviation, .. } = self;
        [number, line, nominal, actual, deviation].into_iter().flatten()
    }

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

    /// The columns that are named, and the index of the line of their headings; none: all are numbers.
    fn of(names: &ProtocolColumns, lines: &[Line]) -> Result<(Columns, Option<usize>), Error> {
        if names.actual.is_none() && (names.deviation.is_none() || names.nominal.is_none()) {
            return Err(refused("protocol-no-actual"));
        }
        let named: Vec<&str> = names.all().collect();
        let found = lines.iter().take(HEAD).enumerate().find_map(|(at, line)| Some((at, Columns::at(names, line)?)));
        let Some((at, columns)) = found else {
            let first = lines.first();
            let missing = |name: &&&str| first.is_none_or(|line| place(name, line).is_none());
            let name = named.iter().find(missing).copied().unwrap_or_default();
            let fields = first.map_or_else(String::new, |line| line.fields.join(" | "));
            return Err(Error::new("protocol-no-column", Path::default()).text("name", name).text("fields", fields));
        };
        if let Some(column) = columns.shared() {
            return Err(Error::new("protocol-same-column", Path::default()).text("name", &column.name));
        }
        let headed = named.iter().any(|name| by_number(name).is_none());
        Ok((columns, headed.then_some(at)))
    }

    /// The columns that are named, as they stand below this line; none: it has not all the headings.
    fn at(names: &ProtocolColumns, line: &Line) -> Option<Columns> {
        names.all().all(|name| place(name, line).is_some()).then_some(())?;
        let column = |name: &Option<String>| {
            let name = name.as_ref()?;
            Some(Column { index: place(name, line)?, name: name.clone() })
        };
        Some(Columns {
            number: column(&names.number),
            line: column(&names.line),
            result: column(&names.result),
            nominal: column(&names.nominal),
            actual: column(&names.actual),
            deviation: column(&names.deviation),
        })
    }
}

impl ProtocolColumns {
    fn all(&self) -> impl Iterator<Item = &str> {
        let ProtocolColumns { number, line, result, nominal, actual, deviation } = self;
        [number, line, result, nominal, actual, deviation].into_iter().flatten().map(String::as_str)
    }
}

/// The number from 1 by which a column is named.
fn by_number(name: &str) -> Option<usize> {
    name.trim().parse().ok().filter(|number| *number > 0)
}

/// Index of the column with this number or heading.
fn place(name: &str, line: &Line) -> Option<usize> {
    let same = |field: &String| field.eq_ignore_ascii_case(name.trim());
    by_number(name).map(|number| number - 1).or_else(|| line.fields.iter().position(same))
}
