//! The little Markdown that the generated pages need.

use crate::words::Words;
use std::fmt::Write;

/// A paragraph.
pub fn line(text: &mut String, paragraph: &str) {
    text.push_str(paragraph);
    text.push_str("\n\n");
}

/// A table under its heading, nothing without rows; columns by the end of the keys of their names.
pub fn table<const COLUMNS: usize>(
    text: &mut String,
    title: &str,
    columns: [&str; COLUMNS],
    all: impl Iterator<Item = [String; COLUMNS]>,
    words: &Words,
) {
    let mut all = all.peekable();
    if all.peek().is_some() {
        line(text, &format!("## {title}"));
        rows(text, columns, all, words);
    }
}

/// A table without a heading; columns by the end of the keys of their names.
pub fn rows<const COLUMNS: usize>(
    text: &mut String,
    columns: [&str; COLUMNS],
    all: impl Iterator<Item = [String; COLUMNS]>,
    words: &Words,
) {
    row(text, columns.map(|column| words.key(format!("report-column-{column}"))));
    row(text, columns.map(|_| "---".to_owned()));
    all.for_each(|cells| row(text, cells));
    text.push('\n');
}

fn row<const COLUMNS: usize>(text: &mut String, cells: [String; COLUMNS]) {
    let cells = cells.map(|cell| cell.replace('|', "\\|").replace('\n', " "));
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}
