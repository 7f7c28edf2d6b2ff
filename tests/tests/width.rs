//! No line is wider than the formatters make it: what they leave alone (texts in quotation marks, comments) too.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_tests::root;
use std::path::{Path, PathBuf};

/// Characters in a line, as in `rustfmt.toml` and `biome.jsonc`.
const WIDTH: usize = 120;
/// The endings of what people write and read.
const ENDINGS: [&str; 6] = ["rs", "ts", "mjs", "css", "jsonc", "wgsl"];
/// What is built, fetched or written by a test (json/tests/wire.rs holds the last).
const MADE: [&str; 6] = ["target", "node_modules", "dist", "pkg", ".git", "wire.ts"];

/// Every source file below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let made = |path: &Path| path.file_name().is_some_and(|name| MADE.iter().any(|made| *made == name));
    let known = |path: &Path| path.extension().is_some_and(|own| ENDINGS.iter().any(|ending| *ending == own));
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| match path.is_dir() {
            _ if made(&path) => vec![],
            true => sources(&path),
            false => vec![path],
        })
        .filter(|path| known(path))
        .collect()
}

// oracle: hand
#[test]
fn no_line_is_wider_than_120_characters() {
    let files = sources(&root());
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
