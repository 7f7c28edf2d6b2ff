//! The tables that tests rest on: `tests/data/`, facts and figures with the place where each is found. Its README names
//! the columns. A build of the tests without a table fails.
#![allow(clippy::panic)]

/// Text of a table.
macro_rules! data {
    ($name:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/", $name))
    };
}
pub(crate) use data;

/// A row of a table: its cells.
pub type Row = Vec<&'static str>;

/// Rows of a table behind the line that names its columns; each has a cell for every column.
pub fn rows(text: &'static str) -> Vec<Row> {
    let mut lines = text.lines().map(|line| line.split('\t').collect::<Row>());
    let Some(columns) = lines.next() else { panic!("a table without columns") };
    let rows: Vec<Row> = lines.collect();
    assert!(!rows.is_empty(), "{columns:?}");
    for row in &rows {
        assert_eq!(row.len(), columns.len(), "{row:?}");
    }
    rows
}
