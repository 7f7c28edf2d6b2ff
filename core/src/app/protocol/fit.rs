//! Lines of a protocol laid onto the quantities that the calls of a program measure.

use super::Columns;
use super::cells::Cells;
use super::text::{Fault, Figure, Line};
use crate::app::run::RunAnswer;
use crate::catalogue::log::{Layout, Unmarked};
use crate::message::Message;
use crate::run::called::Called;
use std::collections::BTreeMap;

/// A quantity that a call measures, and its value in the protocol.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Index of the call.
    pub call: usize,
    /// The result that has it.
    pub name: &'static str,
    /// As it should be.
    pub set: Option<f64>,
    /// As it was measured.
    pub actual: Option<f64>,
    /// The setpoint of the protocol where it is another one.
    pub told: Option<Figure>,
    /// Smallest and largest permissible value, where the protocol has them.
    pub limits: Option<[f64; 2]>,
    /// The line in which the machine marked it as beyond a limit (B:11439-11441).
    pub marked: Option<Line>,
}

/// Farthest that an actual value without a difference beside it is from its setpoint, mm or degree.
const NEAR: f64 = 5.0;
/// Figures of a line that are compared with each other, the first ones.
const FIGURES: usize = 40;
/// Farthest that a quantity is looked for of which neither call nor setpoint is known.
const AHEAD: usize = 1000;
/// Setpoints that agree in so many parts of a unit stand beside each other.
const PARTS: f64 = 1000.0;

/// The calls of a program as a protocol has their values.
pub struct Fit<'a> {
    calls: &'a [RunAnswer],
    called: &'a [Called],
    /// All quantities, in the order of the calls.
    pub quantities: Vec<Quantity>,
    /// Index of the first quantity of each call, and one behind the last.
    starts: Vec<usize>,
    /// By the setpoint, in parts of a unit: the quantities that have it, the last one first; those before `from` are
    /// taken away as they are met.
    by_set: BTreeMap<i64, Vec<usize>>,
    /// The quantities that the next line may be about.
    from: usize,
    until: usize,
    /// The quantity of the last line.
    last: Option<usize>,
    /// The call of the last heading, and the line of its block of values that comes next.
    block: Option<(usize, usize)>,
    /// One behind the call of the last heading.
    headed: usize,
    /// Calls by cycle and variant, the last one first; those before `headed` are taken away as they are met.
    by_kind: BTreeMap<(&'static str, i64), Vec<usize>>,
    /// Calls by their line of the program, the last one first; those with all their values are taken away.
    by_line: BTreeMap<u32, Vec<usize>>,
}

/// Why a line is not laid onto a call.
type Unfit = Message;

/// What a line below a heading of a log is.
enum Block {
    /// Laid by its columns, with a doubt about it.
    Laid(Option<Message>),
    /// A number of it cannot be read: why.
    Unread(Message),
    /// No line of the block of values.
    Other,
}

impl<'a> Fit<'a> {
    /// No line is laid yet.
    pub fn new(calls: &'a [RunAnswer], called: &'a [Called]) -> Fit<'a> {
        let (mut quantities, mut starts) = (Vec::new(), vec![0]);
        for (call, answer) in calls.iter().enumerate() {
            let figures = answer.answer.figures.iter();
            quantities.extend(figures.map(|one| Quantity {
                call,
                name: one.name,
                set: one.set,
                actual: None,
                told: None,
                limits: None,
                marked: None,
            }));
            starts.push(quantities.len());
        }
        let (mut by_kind, mut by_line) = (BTreeMap::new(), BTreeMap::new());
        for (index, (answer, one)) in calls.iter().zip(called).enumerate().rev() {
            let kind = (answer.call.cycle.unwrap_or_default(), one.inputs.variant);
            by_kind.entry(kind).or_insert_with(Vec::new).push(index);
            if let Some(line) = answer.call.line {
                by_line.entry(line).or_insert_with(Vec::new).push(index);
            }
        }
        let mut by_set: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
        for (index, set) in quantities.iter().enumerate().rev().filter_map(|(index, one)| Some((index, one.set?))) {
            by_set.entry(part(set)).or_default().push(index);
        }
        let until = quantities.len();
        let block = None;
        Fit {
            calls,
            called,
            quantities,
            starts,
            by_set,
            from: 0,
            until,
            last: None,
            block,
            headed: 0,
            by_kind,
            by_line,
        }
    }

    /// Lays a line whose figures say by themselves what they are, or takes it as a heading; gives a doubt about what
    /// was laid.
    ///
    /// # Errors
    /// It fits no call: why.
    pub fn plain(&mut self, line: &Line) -> Result<Option<Message>, Unfit> {
        if let Some(heading) = self.heading(line) {
            return heading.map(|()| None);
        }
        let alike = self.layout(line).map(|layout| line.marked_alike(layout));
        let line = alike.as_ref().unwrap_or(line);
        match self.of_block(line) {
            Block::Laid(doubt) => Ok(doubt),
            Block::Unread(why) => self.by_figures(line).map_err(|_| why),
            Block::Other => self.by_figures(line),
        }
    }

    /// How the log prints of which this is a line; none: it is of no log that a call of the program writes.
    fn layout(&self, line: &Line) -> Option<&'a Layout> {
        let of_block = self.block.and_then(|(call, _)| self.called.get(call)?.log.as_ref());
        let any = || self.called.iter().find_map(|called| called.log.as_ref());
        of_block.or_else(any).filter(|_| line.own)
    }

    /// Lays a line by its figures alone.
    fn by_figures(&mut self, line: &Line) -> Result<Option<Message>, Unfit> {
        match line.fault {
            Some(Fault::Quote) => return Err(Message::new("protocol-quote")),
            Some(Fault::Comma) => return Err(Message::new("protocol-comma")),
            None => {}
        }
        let figures: Vec<Figure> = line.figures().take(FIGURES).collect();
        if figures.len() < 2 {
            return Err(Message::new("protocol-no-value"));
        }
        let mut best: Option<(bool, usize, f64, usize)> = None;
        for (at, set) in figures.iter().enumerate() {
            let Some((sure, actual)) = actual(*set, &figures[at + 1..]) else { continue };
            let Some(index) = self.next(*set) else { continue };
            if best.is_none_or(|(known, first, ..)| (!sure, index) < (!known, first)) {
                best = Some((sure, index, actual, at));
            }
        }
        let Some((sure, index, actual, at)) = best else {
            let (index, set, actual) = self.following(&figures).ok_or_else(|| Message::new("protocol-no-call"))?;
            self.put(index, line, actual, Some(set));
            return Ok(None);
        };
        self.put(index, line, actual, None);
        self.quantities[index].marked = line.fields.iter().any(|field| is_marked(field)).then(|| line.clone());
        Ok(if sure { None } else { doubt(&figures[at..]) })
    }

    /// Lays a line of the block of values below a heading by what the program prints in its columns.
    fn of_block(&mut self, line: &Line) -> Block {
        let Some((call, at)) = self.block else { return Block::Other };
        let Some(layout) = self.called.get(call).and_then(|called| called.log.as_ref()) else { return Block::Other };
        let columns = layout.lines.get(at).filter(|columns| columns.len() == line.fields.len());
        let Some(columns) = columns else { return Block::Other };
        let numbers = columns.iter().zip(&line.fields).filter_map(|(name, field)| Some((name.as_deref()?, field)));
        let mut read: Vec<(&str, &String, Figure)> = Vec::new();
        for (name, field) in numbers {
            if layout.unmarked(field) == Unmarked::Either {
                return Block::Unread(Message::new("protocol-mark").text("text", field).text("mark", &layout.mark));
            }
            let Some(figure) = line.figure(field) else {
                return Block::Unread(Message::new("protocol-no-number").text("column", name).text("text", field));
            };
            read.push((name, field, figure));
        }
        let column = |wanted: Option<String>| read.iter().find(|(name, ..)| Some(*name) == wanted.as_deref());
        self.block = Some((call, at + 1));
        let mut doubt = None;
        for index in self.starts[call]..self.starts[call + 1] {
            let Quantity { name, set, .. } = self.quantities[index];
            let Some((_, field, actual)) = column(Some(name.to_owned())) else { continue };
            let near = |told: &Figure| set.is_some_and(|set| (told.value - set).abs() <= NEAR);
            let told = column(beside(name, SETPOINT)).map(|(.., figure)| *figure).filter(near);
            let by = column(beside(name, DIFFERENCE)).map(|(.., figure)| *figure);
            let wrong = told.zip(by).filter(|(told, by)| !is_difference(*told, *actual, *by));
            doubt = doubt.or_else(|| wrong.map(|(told, by)| contradicted(told, *actual, by)));
            self.put(index, line, actual.value, told.filter(|told| set.is_some_and(|set| !told.is(set))));
            self.quantities[index].marked = is_marked(field).then(|| line.clone());
        }
        Block::Laid(doubt)
    }

    fn put(&mut self, index: usize, line: &Line, actual: f64, told: Option<Figure>) {
        let quantity = &mut self.quantities[index];
        (quantity.actual, quantity.told, quantity.limits) = (Some(actual), told, line.limits);
        self.from = self.from.max(self.starts[quantity.call]);
        self.last = Some(index);
    }

    /// The quantity behind that of the last line, or the next one of the call of the heading, for a line with setpoint,
    /// actual value and difference: where a centre is expected where the probe stands, its setpoint is another one.
    fn following(&self, figures: &[Figure]) -> Option<(usize, Figure, f64)> {
        let open = |index: &usize| self.quantities.get(*index).is_some_and(|one| one.actual.is_none());
        let call = |index: usize| self.quantities.get(index).map(|one| one.call);
        let behind = self.last.map(|last| last + 1).filter(|next| call(*next) == call(next - 1)).filter(open);
        let alone = call(self.from).is_some() && call(self.from) == call(self.until.saturating_sub(1));
        let headed = || alone.then(|| (self.from..self.until).find(open)).flatten();
        let index = behind.or_else(headed)?;
        let near = |set: Figure| self.quantities[index].set.is_some_and(|own| (set.value - own).abs() <= NEAR);
        let mut sure = figures.iter().enumerate().filter(|(_, set)| near(**set)).filter_map(|(at, set)| {
            let (sure, actual) = actual(*set, &figures[at + 1..])?;
            sure.then_some((index, *set, actual))
        });
        sure.next()
    }

    /// The heading of a block of the log: cycle, `_MVAR` and its number (B:11486-11512).
    fn heading(&mut self, line: &Line) -> Option<Result<(), Unfit>> {
        let at = line.fields.iter().position(|field| field == "_MVAR")?;
        let cycle = line.fields[..at].last()?;
        let variant = Figure::of(line.fields.get(at + 1)?)?.value as i64;
        let of_kind = self.by_kind.iter_mut().find(|((name, number), _)| name == cycle && *number == variant);
        let found = of_kind.and_then(|(_, calls)| {
            while calls.last().is_some_and(|call| *call < self.headed) {
                calls.pop();
            }
            calls.pop()
        });
        let Some(call) = found else {
            (self.from, self.until, self.last, self.block) = (0, 0, None, None);
            let why = Message::new("protocol-no-heading").text("cycle", cycle).number("variant", variant as f64);
            return Some(Err(why));
        };
        self.headed = call + 1;
        (self.from, self.until, self.last) = (self.starts[call], self.starts[call + 1], None);
        self.block = Some((call, 0));
        Some(Ok(()))
    }

    /// The next quantity without a value that has this setpoint.
    fn next(&mut self, set: Figure) -> Option<usize> {
        let (from, until) = (self.from, self.until);
        let around = part(set.value - set.half) - 1..=part(set.value + set.half) + 1;
        if around.end() - around.start() > 2 * PARTS as i64 {
            return None;
        }
        let quantities = &self.quantities;
        let mut found: Option<usize> = None;
        for (_, indices) in self.by_set.range_mut(around) {
            while indices.last().is_some_and(|index| *index < from || quantities[*index].actual.is_some()) {
                indices.pop();
            }
            let own = |index: &&usize| quantities[**index].set.is_some_and(|value| set.is(value));
            let open = |index: &&usize| quantities[**index].actual.is_none();
            let first = indices.iter().rev().take_while(|index| **index < until).filter(open).find(own);
            found = found.into_iter().chain(first.copied()).min();
        }
        found
    }

    /// Lays a line of a table of which it is known what stands in which column.
    ///
    /// # Errors
    /// It fits no call: why.
    pub fn row(&mut self, line: &Line, columns: &Columns) -> Result<(), Unfit> {
        if let Some(heading) = self.heading(line) {
            return heading;
        }
        let alike = self.layout(line).map(|layout| line.marked_alike(layout));
        let line = alike.as_ref().unwrap_or(line);
        let cells = Cells::of(line, columns)?;
        let call = self.called(cells.number, cells.line)?;
        let index = self.of_cells(call, &cells)?;
        let own = self.quantities[index].set;
        let actual = value(&cells, cells.nominal.map(|figure| figure.value).or(own))?;
        let told = cells.nominal.filter(|nominal| own.is_some_and(|own| !nominal.is(own)));
        let (from, last) = (self.from, self.last);
        self.put(index, line, actual, told);
        self.quantities[index].marked = is_marked(cells.written).then(|| line.clone());
        if call.is_some() {
            (self.from, self.last) = (from, last);
        }
        Ok(())
    }

    /// The quantity of a line of a table; where only its values are told, it may be that behind the last line.
    fn of_cells(&mut self, call: Option<usize>, cells: &Cells) -> Result<usize, Unfit> {
        let found = self.quantity(call, cells);
        if found.is_ok() || call.is_some() || cells.result.is_some() {
            return found;
        }
        let figures: Vec<Figure> = [cells.nominal, cells.actual, cells.deviation].into_iter().flatten().collect();
        found.or_else(|why| self.following(&figures).map(|(index, ..)| index).ok_or(why))
    }

    /// The call with this number, or the next one of this line of the program; none: neither is told.
    fn called(&mut self, number: Option<Figure>, line: Option<Figure>) -> Result<Option<usize>, Unfit> {
        if let Some(number) = number {
            let call = whole(number).and_then(|number| number.checked_sub(1));
            let missing = || Message::new("protocol-no-number-of-call").number("number", number.value);
            let call = call.map(|call| call as usize).filter(|call| *call < self.calls.len()).ok_or_else(missing)?;
            let own = self.calls[call].call.line;
            let other = line.filter(|line| own.is_some_and(|own| whole(*line) != Some(own)));
            return other.map_or(Ok(Some(call)), |line| Err(other_line(number, line, own.unwrap_or_default())));
        }
        let Some(line) = line else { return Ok(None) };
        let missing = || Message::new("protocol-no-line").number("line", line.value);
        let line = whole(line).ok_or_else(missing)?;
        let (quantities, starts) = (&self.quantities, &self.starts);
        let full = |call: usize| quantities[starts[call]..starts[call + 1]].iter().all(|one| one.actual.is_some());
        let calls = self.by_line.entry(line).or_default();
        while calls.last().is_some_and(|call| full(*call)) {
            calls.pop();
        }
        calls.last().copied().map(Some).ok_or_else(missing)
    }

    /// The quantity of a call, or of any, with this result, with this setpoint, or the next one without a value. One
    /// with another setpoint counts where the result is named, or setpoint, actual value and difference agree.
    fn quantity(&mut self, call: Option<usize>, cells: &Cells) -> Result<usize, Unfit> {
        let (name, nominal) = (cells.result, cells.nominal);
        if let (None, None, Some(nominal)) = (call, name, nominal) {
            return self.next(nominal).ok_or_else(|| Message::new("protocol-no-call"));
        }
        while call.is_none() && self.quantities.get(self.from).is_some_and(|one| one.actual.is_some()) {
            self.from += 1;
        }
        let ahead = self.until.min(self.from + AHEAD);
        let range = call.map_or(self.from..ahead, |call| self.starts[call]..self.starts[call + 1]);
        let open = |index: &usize| self.quantities[*index].actual.is_none();
        let named = |index: &usize| name.is_none_or(|name| self.quantities[*index].name.eq_ignore_ascii_case(name));
        let of_set = |index: &usize| match (nominal, self.quantities[*index].set) {
            (Some(nominal), Some(set)) => nominal.is(set),
            _ => true,
        };
        let sure = name.is_some() || cells.agree();
        let near = |index: &usize| match (nominal, self.quantities[*index].set) {
            (Some(nominal), Some(set)) => call.is_some() && sure && (nominal.value - set).abs() <= NEAR,
            _ => false,
        };
        let all = || range.clone().filter(named).filter(open);
        let found = all().find(of_set).or_else(|| all().find(near));
        found.ok_or_else(|| match (name, nominal) {
            (Some(name), _) => Message::new("protocol-no-result").text("name", name),
            (None, Some(nominal)) if range.clone().any(|index| self.has(index, nominal)) => {
                Message::new("protocol-again").number("set", nominal.value)
            }
            _ => Message::new("protocol-no-call"),
        })
    }
}

impl Fit<'_> {
    /// Whether a quantity has this setpoint, and its value.
    fn has(&self, index: usize, nominal: Figure) -> bool {
        let Quantity { set, actual, .. } = self.quantities[index];
        actual.is_some() && set.is_some_and(|set| nominal.is(set))
    }
}

/// A setpoint and an actual value beside it: behind them stands what looks like their difference and is none, or what
/// could be the actual value as well.
fn doubt(figures: &[Figure]) -> Option<Message> {
    let [set, actual, others @ ..] = figures else { return None };
    if let Some(by) = others.first().filter(|by| by.value.abs() <= NEAR) {
        return Some(contradicted(*set, *actual, *by));
    }
    let other = others.iter().find(|other| (other.value - set.value).abs() <= NEAR)?;
    Some(taken("protocol-ambiguous", *set, *actual).number("other", other.value))
}

/// A number of which there is no half.
fn whole(figure: Figure) -> Option<u32> {
    let is_whole = figure.value.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&figure.value);
    is_whole.then_some(figure.value as u32)
}

/// Says that the call with this number is in another line of the program.
fn other_line(number: Figure, line: Figure, own: u32) -> Message {
    let told = Message::new("protocol-other-line").number("number", number.value).number("line", line.value);
    told.number("own", f64::from(own))
}

/// The actual value of a line of a table; `set`: its setpoint.
fn value(cells: &Cells, set: Option<f64>) -> Result<f64, Unfit> {
    match (cells.actual, cells.deviation, set) {
        (Some(actual), Some(by), Some(set))
            if !(Figure { half: actual.half + by.half, ..by }).is(actual.value - set) =>
        {
            Err(Message::new("protocol-differs").number("by", by.value).number("is", actual.value - set))
        }
        (Some(actual), _, _) => Ok(actual.value),
        (None, Some(by), Some(set)) => Ok(set + by.value),
        _ => Err(Message::new("protocol-no-value")),
    }
}

/// What was taken as setpoint and actual value.
fn taken(key: &'static str, set: Figure, actual: Figure) -> Message {
    Message::new(key).number("set", set.value).number("actual", actual.value)
}

/// Says that a figure is not the difference of both.
fn contradicted(set: Figure, actual: Figure, by: Figure) -> Message {
    taken("protocol-contradicted", set, actual).number("by", by.value)
}

/// How far in `_OVR[]` setpoint and difference stand from an actual value, which are 4 to 7 (B:5675-5683);
/// of a calibration other things stand there.
const SETPOINT: i64 = -4;
const DIFFERENCE: i64 = 12;

/// The result that belongs to an actual value.
fn beside(name: &str, by: i64) -> Option<String> {
    let (stem, rest) = name.split_once('[')?;
    let number: i64 = rest.trim_end_matches(']').parse().ok()?;
    (stem == "_OVR" && (4..8).contains(&number)).then(|| format!("{stem}[{}]", number + by))
}

/// Whether a figure is the difference of setpoint and actual value, as all three are rounded.
pub(super) fn is_difference(set: Figure, actual: Figure, by: Figure) -> bool {
    Figure { half: by.half + actual.half + set.half, ..by }.is(actual.value - set.value)
}

/// Whether a figure has the mark of a value beyond its limits behind it (B:11439-11441).
fn is_marked(field: &str) -> bool {
    let behind = field.trim().chars().last();
    Figure::of(field).is_some() && behind.is_some_and(|sign| !sign.is_alphanumeric() && !".,°".contains(sign))
}

fn part(value: f64) -> i64 {
    (value * PARTS).round() as i64
}

/// The actual value behind a setpoint, and whether the difference of both stands there too.
fn actual(set: Figure, behind: &[Figure]) -> Option<(bool, f64)> {
    let sure = behind.iter().enumerate().find(|(at, actual)| {
        let mut others = behind.iter().enumerate().filter(|(other, _)| other != at);
        others.any(|(_, by)| is_difference(set, **actual, *by))
    });
    let near = || behind.first().filter(|actual| (actual.value - set.value).abs() <= NEAR);
    sure.map(|(_, actual)| (true, actual.value)).or_else(|| near().map(|actual| (false, actual.value)))
}
