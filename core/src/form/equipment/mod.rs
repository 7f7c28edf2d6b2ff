//! The machine that a user describes, as tables of fields: its own data, tools, zero offsets, probes and part. Each
//! field is shown in the unit of the machine, and written back as the setup keeps it.

mod own;
mod part;
mod rows;
mod slot;

pub use part::{CAPS, SHAPES};
pub use rows::{add, copy, drop_row, put_on, shift};
pub use slot::Cell;

use super::machine::Refusal;
use crate::machine::Setup;
use crate::message::Message;
use rows::Content;
use serde::{Deserialize, Serialize};

/// A table of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "EquipmentTable"))]
pub enum Table {
    /// What it is and where it begins: one row.
    Machine,
    /// Cutting edges.
    Tools,
    /// Zero offsets.
    Offsets,
    /// The workpiece probe as it really is: one row.
    Probe,
    /// Tool probes as they really are.
    ToolProbes,
    /// Solids of the part.
    Part,
}

impl Table {
    /// In the order in which they are shown.
    pub const ALL: [Table; 6] =
        [Table::Machine, Table::Tools, Table::Offsets, Table::Probe, Table::ToolProbes, Table::Part];
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "EquipmentRow"))]
pub struct Row {
    /// Which one it is in its table.
    pub id: String,
    /// What it is called.
    pub title: Message,
    /// Whether it is in use at the start; absent: none of its table ever is.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub active: Option<bool>,
    /// Whether it can be taken away.
    pub removable: bool,
    /// Its fields.
    pub cells: Vec<Cell>,
}

/// The rows of a table.
pub fn rows(table: Table, setup: &Setup) -> Vec<Row> {
    let ids = rows::ids(table, setup);
    ids.into_iter().filter_map(|id| row(table, &id, setup)).collect()
}

fn row(table: Table, id: &str, setup: &Setup) -> Option<Row> {
    let mut content = Content::of(table, id, setup)?;
    Some(Row {
        title: content.title(id),
        active: rows::active(table, id, setup),
        removable: rows::removable(table, id, setup),
        cells: content.slots(&setup.control).into_iter().map(|slot| slot.cell(&setup.control)).collect(),
        id: id.to_owned(),
    })
}

/// Writes a typed text into a field; gives the row, which may be called otherwise now.
///
/// # Errors
/// Why it is not taken; the machine is as it was then.
pub fn set(setup: &mut Setup, table: Table, id: &str, key: &str, text: &str) -> Result<String, Refusal> {
    let gone = || Refusal { message: Message::new("equip-gone"), hint: Message::new("equip-gone-hint") };
    let mut content = Content::of(table, id, setup).ok_or_else(gone)?;
    let slot = content.slots(&setup.control).into_iter().find(|slot| slot.key == key).ok_or_else(gone)?;
    slot.take(&setup.control, text)?;
    let mut after = setup.clone();
    let id = content.put(&mut after, id)?;
    after.possible().map_err(Refusal::of)?;
    *setup = after;
    Ok(id)
}
