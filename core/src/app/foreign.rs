//! A program or a log of a control that is read and not run.

use crate::catalogue::log;
use crate::dialect::Dialect;
use crate::foreign::{self, Foreign, ForeignCall, Log, LogRow};
use crate::message::Message;
use serde::Serialize;

/// What such a text has.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignView {
    /// Name of the control.
    pub control: &'static str,
    /// Its probe cycles, in their order.
    pub calls: Vec<ForeignCallView>,
    /// Its logs.
    pub logs: Vec<ForeignLog>,
}

/// A probe cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignCallView {
    /// As the program calls it.
    pub cycle: String,
    /// Line of the call, from 1.
    pub line: u32,
    /// What it does; absent: it is not described.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<Message>,
    /// Its values, in the order of the text.
    pub values: Vec<ForeignParameter>,
}

/// A value of a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignParameter {
    /// Name of the parameter.
    pub name: String,
    /// As written.
    pub value: String,
    /// What it means; absent: it is not described.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub meaning: Option<Message>,
}

/// A log, as a record of what was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignLog {
    /// Cycle that wrote it.
    pub cycle: String,
    /// Date as written.
    pub date: String,
    /// Time as written.
    pub time: String,
    /// Program that measured.
    pub program: String,
    /// Unit of its lengths.
    pub unit: &'static str,
    /// What was measured.
    pub figures: Vec<ForeignFigure>,
    /// Lines, from 1, at whose figure something else stands.
    pub unread: Vec<u32>,
}

/// A quantity of a log; absent: the log does not have it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignFigure {
    /// What the control calls it.
    pub name: String,
    /// Set value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<f64>,
    /// Largest permissible value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Smallest permissible value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Actual value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub actual: Option<f64>,
    /// Actual value minus set value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<f64>,
}

/// A program or log of such a control; none: it is no text of one.
pub fn foreign(source: &[u8]) -> Option<ForeignView> {
    if let Some(control) = foreign::control_of(source) {
        return Some(of_program(control, (control.calls)(source)));
    }
    let (control, logs) = foreign::logs(&String::from_utf8_lossy(source))?;
    Some(ForeignView { control: control.name, calls: Vec::new(), logs: logs.into_iter().map(of_log).collect() })
}

/// The control of which a text is a measuring log, by its beginning: no program, though names of cycles stand in it.
pub fn log_of(source: &[u8]) -> Option<&'static str> {
    let own = || log::is_log(&foreign::beginning(source)).then(|| Dialect::Sinumerik.name());
    foreign::log_of(source).map(|control| control.name).or_else(own)
}

fn of_program(control: &Foreign, calls: Vec<ForeignCall>) -> ForeignView {
    let view = |call: ForeignCall| {
        let cycle = call.cycle;
        let meaning = |name: &str| cycle.and_then(|cycle| cycle.parameter(name)).map(|one| Message::new(one.key));
        let values = call.values.into_iter().map(|one| ForeignParameter {
            meaning: meaning(&one.name),
            name: one.name,
            value: one.text,
        });
        ForeignCallView {
            cycle: call.name,
            line: call.line + 1,
            title: cycle.map(|cycle| Message::new(cycle.title())),
            values: values.collect(),
        }
    };
    ForeignView { control: control.name, calls: calls.into_iter().map(view).collect(), logs: Vec::new() }
}

fn of_log(log: Log) -> ForeignLog {
    let number = |text: &str| foreign::figure(text);
    let figure = |row: LogRow| ForeignFigure {
        set: number(&row.nominal),
        upper: number(&row.maximum),
        lower: number(&row.minimum),
        actual: number(&row.actual),
        deviation: number(&row.deviation),
        name: row.label,
    };
    ForeignLog {
        cycle: log.cycle,
        date: log.date,
        time: log.time,
        program: log.program,
        unit: if log.is_inch { "inch" } else { "mm" },
        figures: log.rows.into_iter().map(figure).collect(),
        unread: log.unread,
    }
}
