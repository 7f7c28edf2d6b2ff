//! The little Markdown that the generated pages need.

use crate::words::Words;
use std::fmt::Write;

/// A paragraph.
pub fn line(text: &mut String, paragraph: &str) {
    text.push_str(paragraph);
    text.push_str("\n\n");
}

/// A row of a table.
pub fn row<T: AsRef<str>>(text: &mut String, cells: &[T]) {
    text.push('|');
    for cell in cells {
        let cell = cell.as_ref().replace('|', "\\|").replace('\n', " ");
        let _ = write!(text, " {cell} |");
    }
    text.push('\n');
}

/// A heading with the head of a table under it; columns by the end of the keys of their names.
pub fn heading(text: &mut String, title: &str, columns: &[&str], words: &Words) {
    line(text, &format!("## {title}"));
    let names: Vec<String> = columns.iter().map(|column| words.key(format!("report-column-{column}"))).collect();
    row(text, &names);
    row(text, &vec!["---"; columns.len()]);
}
