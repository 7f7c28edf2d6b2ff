//! A line of a manual that code cites stands in a chapter, and what users read names chapters, never lines.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::manual::Cited;
use probewright_tests::{files, root};

/// Citations such as `B:2408-2469` in a text: a letter of a manual alone, a colon and lines.
fn citations(text: &str) -> Vec<&str> {
    let is_line = |letter: char| letter.is_ascii_digit() || letter == '-';
    let letters = text.match_indices(['A', 'B', 'C']);
    let alone =
        letters.filter(|(at, _)| !text[..*at].ends_with(|letter: char| letter.is_alphanumeric() || letter == '_'));
    let cited = alone.filter_map(|(at, _)| {
        let digits = text[at + 1..].strip_prefix(':')?;
        let length = digits.find(|letter| !is_line(letter)).unwrap_or(digits.len());
        digits
            .starts_with(|letter: char| letter.is_ascii_digit())
            .then(|| text[at..at + 2 + length].trim_end_matches('-'))
    });
    cited.collect()
}

// oracle: self (the table of chapters is read off the headings of the manuals)
#[test]
fn each_cited_line_stands_in_a_chapter() {
    let mut count = 0;
    for file in files(&root().join("core/src"), &["rs"]) {
        let text = std::fs::read_to_string(&file).unwrap();
        for cited in citations(&text) {
            let shown = Cited(cited.to_owned().leak()).to_string();
            assert!(!shown.is_empty(), "{}: {cited}", file.display());
            count += 1;
        }
    }
    assert!(count > 3000, "{count}");
}

// oracle: self
#[test]
fn what_users_read_names_no_line_of_a_text() {
    let mut read = 0;
    let folders = [("docs", ["md", "json"]), ("core/messages", ["ftl", "md"]), ("www/messages", ["ftl", "md"])];
    for (folder, kinds) in folders {
        for file in files(&root().join(folder), &kinds) {
            let text = std::fs::read_to_string(&file).unwrap();
            let said: String = text.lines().filter(|line| !line.starts_with('#') || folder == "docs").collect();
            assert_eq!(citations(&said), [""; 0], "{}", file.display());
            read += 1;
        }
    }
    assert!(read > 100, "{read}");
}
