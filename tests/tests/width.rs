//! No line is wider than the formatters make it: what they leave alone (texts in quotation marks, comments) too.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_tests::{files, root};

/// Characters in a line, as in `rustfmt.toml` and `biome.jsonc`.
const WIDTH: usize = 120;
/// The endings of what people write and read.
const ENDINGS: [&str; 6] = ["rs", "ts", "mjs", "css", "jsonc", "wgsl"];
// oracle: hand
#[test]
fn no_line_is_wider_than_120_characters() {
    let files = files(&root(), &ENDINGS);
    assert!(files.len() > 500, "the sources are found: {}", files.len());
    let wide: Vec<String> = files
        .iter()
        .flat_map(|file| {
            let text = std::fs::read_to_string(file).unwrap();
            let wide = |(at, line): (usize, &str)| {
                (line.chars().count() > WIDTH).then(|| format!("{}:{}", file.display(), at + 1))
            };
            text.lines().enumerate().filter_map(wide).collect::<Vec<_>>()
        })
        .collect();
    assert!(wide.is_empty(), "wider than {WIDTH}:\n{}", wide.join("\n"));
}
