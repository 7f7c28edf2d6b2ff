//! A text that lists columns: what is in it by name, what can be added, and how it is printed.

use super::Inputs;
use crate::control::Control;
use crate::message::Message;
use serde::Serialize;

/// Reads a text, as typed, as columns; none: an expression of the program, known at run time only.
pub type ReadColumns = fn(&str, &Inputs, &Control) -> Option<Columns>;

/// The columns of a text.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Columns {
    /// Those in it, in their order.
    pub list: Vec<Column>,
    /// The text, as typed, up to where a further column is written: its separator is there.
    pub before: String,
    /// What stands behind that.
    pub after: String,
    /// What can be added.
    pub offers: Vec<Offer>,
    /// The lines that are printed, with the values of the last measurement or of an example.
    pub printed: Vec<String>,
    /// The last of them with the mark behind values that exceed a limit; empty: there is no mark, or no such value.
    pub marked: String,
    /// Values that do not fit their columns.
    pub narrow: Vec<Message>,
}

/// A column of a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Column {
    /// As it stands there.
    pub text: String,
    /// What it shows.
    pub label: Message,
    /// The whole text, as typed, without it.
    pub without: String,
}

/// A column that can be added.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ColumnOffer"))]
pub struct Offer {
    /// As it is written; empty: what is typed then.
    pub text: String,
    /// What it shows.
    pub label: Message,
}
