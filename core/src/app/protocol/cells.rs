//! The cells of a line of a table of which it is known what stands in which column.

use super::fit::is_difference;
use super::text::{Fault, Figure, Line};
use super::{Column, Columns};
use crate::message::Message;

/// What a line says: each none where nothing stands in its cell, or no column has it.
pub struct Cells<'a> {
    /// Number of the call.
    pub number: Option<Figure>,
    /// Line of the call.
    pub line: Option<Figure>,
    /// Name of the result.
    pub result: Option<&'a str>,
    /// Setpoint.
    pub nominal: Option<Figure>,
    /// Actual value, as it is written.
    pub written: &'a str,
    /// Actual value.
    pub actual: Option<Figure>,
    /// Actual value minus setpoint.
    pub deviation: Option<Figure>,
}

impl<'a> Cells<'a> {
    /// # Errors
    /// A cell has no figure, or none that says which call is meant or what was measured: why.
    pub fn of(line: &'a Line, columns: &Columns) -> Result<Cells<'a>, Message> {
        if line.fault == Some(Fault::Quote) {
            return Err(Message::new("protocol-quote"));
        }
        let text = |column: &Column| line.fields.get(column.index).map_or("", String::as_str);
        let figure = |column: &Option<Column>| {
            let Some(column) = column.as_ref().filter(|column| !text(column).is_empty()) else { return Ok(None) };
            let bad = || Message::new("protocol-no-number").text("column", &column.name).text("text", text(column));
            line.figure(text(column)).map(Some).ok_or_else(bad)
        };
        let cells = Cells {
            number: figure(&columns.number)?,
            line: figure(&columns.line)?,
            result: columns.result.as_ref().map(text).filter(|name| !name.is_empty()),
            nominal: figure(&columns.nominal)?,
            written: columns.actual.as_ref().map(text).unwrap_or_default(),
            actual: figure(&columns.actual)?,
            deviation: figure(&columns.deviation)?,
        };
        cells.missing(columns).map_or(Ok(cells), Err)
    }

    /// Whether it has setpoint, actual value and the difference of both.
    pub fn agree(&self) -> bool {
        let all = self.nominal.zip(self.actual).zip(self.deviation);
        all.is_some_and(|((set, actual), by)| is_difference(set, actual, by))
    }

    /// Says which cell has to be filled in; none: what stands there is enough.
    fn missing(&self, columns: &Columns) -> Option<Message> {
        let Columns { number, line, nominal, actual, deviation, .. } = columns;
        let blank =
            |column: &Option<Column>| Some(Message::new("protocol-blank").text("column", &column.as_ref()?.name));
        let placed = self.number.is_some() || self.line.is_some();
        let by_set = self.result.is_some() || self.nominal.is_some();
        if self.actual.is_none() && self.deviation.is_none() {
            return blank(actual).or_else(|| blank(deviation)).or_else(|| Some(Message::new("protocol-no-actual")));
        }
        if !placed && let Some(told) = blank(number).or_else(|| blank(line)) {
            return Some(told);
        }
        blank(nominal).filter(|_| !placed && !by_set)
    }
}
