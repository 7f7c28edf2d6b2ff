//! The machine that a user describes, as tables: shown, given what it lacks, and changed field by field.

use super::beside::{Beside, Whole};
use super::form::{FormRequest, form};
use super::start::{Machine, Start, start};
use super::supply::Supply;
use super::{Error, ProgramText};
use crate::dialect::Dialect;
use crate::form::equipment::{CAPS, Row, SHAPES, Table, add, copy, drop_row, put_on, rows, set, shift};
use crate::form::machine::Refusal;
use crate::machine::Setup;
use crate::syntax;
use crate::syntax::definitions::definitions;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Which machine is changed how.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct EquipRequest {
    /// Control.
    pub control: Dialect,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// What is done to it; absent: nothing.
    pub change: Option<EquipmentChange>,
    /// The program that it is for.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    pub text: ProgramText,
    /// Files beside it; absent: none.
    pub with: Option<Vec<Beside>>,
    /// The call whose part it gets.
    pub call: Option<FormRequest>,
}

/// What is done to a machine.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum EquipmentChange {
    /// It gets what it lacks.
    Give(Supply),
    /// A text is typed into a field.
    Set(CellText),
    /// A row more, of this sort.
    Add(RowOf),
    /// The same row once more.
    Copy(RowOf),
    /// A row less.
    Remove(RowOf),
    /// A row is in use from the start.
    Use(RowOf),
    /// A row stands one place earlier.
    Earlier(RowOf),
    /// A row stands one place later.
    Later(RowOf),
    /// The part gets what a call measures.
    Measured,
    /// It gets the user data of a definition file: its text.
    Define(String),
}

/// A row, or the sort of a new one.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RowOf {
    /// Its table.
    pub table: Table,
    /// Which one it is in its table; of a new one its sort.
    pub row: String,
}

/// A text for a field.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CellText {
    /// Its table.
    pub table: Table,
    /// Its row.
    pub row: String,
    /// Key of its name.
    pub cell: String,
    /// What is typed.
    pub text: String,
}

/// The machine afterwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct EquipView {
    /// The machine.
    pub setup: Setup,
    /// Its tables.
    pub tables: Vec<EquipmentRows>,
    /// The row that was changed or added, as it is called now.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<String>,
    /// Why nothing was changed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<Refusal>,
}

/// A table with its rows.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct EquipmentRows {
    /// Which table.
    pub table: Table,
    /// Its rows.
    pub rows: Vec<Row>,
    /// Sorts of rows that can be added: keys of their names, empty where there is one sort only; none: no row can.
    pub adds: Vec<&'static str>,
}

/// Shows a machine, and does to it what is asked.
///
/// # Errors
/// The machine cannot be.
pub fn equip(mut asked: EquipRequest) -> Result<EquipView, Error> {
    let Start { mut setup, described } = start(asked.control, asked.setup.take())?;
    let done = match asked.change.take() {
        None => Ok(None),
        Some(change) => changed(&mut setup, change, described, asked),
    };
    let (row, problem) = match done {
        Ok(row) => (row, None),
        Err(refusal) => (None, Some(refusal)),
    };
    let tables = Table::ALL.into_iter();
    let tables =
        tables.map(|table| EquipmentRows { table, rows: rows(table, &setup), adds: adds(table, &setup) }).collect();
    Ok(EquipView { setup, tables, row, problem })
}

/// The machine with one change, which is not made where the machine could not be then; gives the row concerned.
fn changed(
    setup: &mut Setup,
    change: EquipmentChange,
    described: bool,
    asked: EquipRequest,
) -> Result<Option<String>, Refusal> {
    use EquipmentChange::{Add, Copy, Define, Earlier, Give, Later, Measured, Remove, Set, Use};
    let mut next = setup.clone();
    let row = match change {
        Set(CellText { table, row, cell, text }) => Some(set(&mut next, table, &row, &cell, &text)?),
        Add(RowOf { table, row }) => add(&mut next, table, &row),
        Copy(RowOf { table, row }) => copy(&mut next, table, &row),
        Earlier(RowOf { row, .. }) => shift(&mut next, &row, -1),
        Later(RowOf { row, .. }) => shift(&mut next, &row, 1),
        Remove(RowOf { table, row }) => {
            drop_row(&mut next, table, &row);
            None
        }
        Use(RowOf { table, row }) => {
            put_on(&mut next, table, &row);
            Some(row)
        }
        Give(supply) => {
            give(&mut next, &supply, described, &asked);
            None
        }
        Measured => {
            measured(&mut next, asked.call);
            next.workpiece.solids.len().checked_sub(1).map(|last| last.to_string())
        }
        Define(text) => {
            Arc::make_mut(&mut next.control.definitions).add(definitions(text.as_bytes()).definitions);
            None
        }
    };
    next.possible().map_err(Refusal::of)?;
    *setup = next;
    Ok(row)
}

fn give(setup: &mut Setup, supply: &Supply, described: bool, asked: &EquipRequest) {
    let whole = Whole::new(asked.control, asked.text.clone(), asked.with.clone());
    let definitions = Arc::clone(&setup.control.definitions);
    let program = || syntax::read_held(asked.control, whole.text(), &definitions.macros, &mut |_| {});
    match supply {
        Supply::Tool(new) => setup.give_tool(new),
        Supply::Tools => setup.give_all(&program(), false),
        Supply::Parts if described => setup.give_all(&program(), true),
        Supply::Parts => setup.become_of(&program()),
    }
}

/// The part that the call of a form measures stands beside what is there.
fn measured(setup: &mut Setup, call: Option<FormRequest>) {
    let Some(call) = call else { return };
    let Ok(view) = form(FormRequest { predict: true, errors: None, ..call }) else { return };
    let Some(made) = view.outcome.and(view.setup) else { return };
    for solid in made.workpiece.solids {
        if !setup.workpiece.solids.contains(&solid) {
            setup.workpiece.solids.push(solid);
        }
    }
    if setup.tool_probes.is_empty() {
        setup.tool_probes = made.tool_probes;
    }
}

/// Sorts of rows that can be added.
fn adds(table: Table, setup: &Setup) -> Vec<&'static str> {
    match table {
        Table::Offsets if setup.control.make().registers => Vec::new(), // all of them are there
        Table::ToolProbes => CAPS.iter().map(|(key, _)| *key).collect(),
        Table::Part => SHAPES.iter().map(|(key, _)| *key).collect(),
        Table::Tools | Table::Offsets => vec![""],
        Table::Machine | Table::Probe => Vec::new(),
    }
}
