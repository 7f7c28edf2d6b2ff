//! The little Markdown that the generated pages need.

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

/// A heading with the head of a table under it.
pub fn heading(text: &mut String, title: &str, columns: &[&str]) {
    line(text, &format!("## {title}"));
    row(text, columns);
    row(text, &vec!["---"; columns.len()]);
}
