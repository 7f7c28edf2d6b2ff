//! What must not stand somewhere: the invariants of ARCHITECTURE.md that are about what is absent.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_tests::root;
use probewright_tests::rust::{Found, Sources};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Names of cycles as they are called.
fn names() -> BTreeSet<&'static str> {
    assert!(CYCLES.len() > 30, "the whole catalogue: {}", CYCLES.len());
    CYCLES.iter().flat_map(|cycle| cycle.name.split(' ')).filter(|name| *name != "G65").collect()
}

/// Stems of their messages, which are also names of their modules.
fn stems() -> BTreeSet<&'static str> {
    CYCLES.iter().map(|cycle| cycle.key).collect()
}

/// Names of parameters that are no mere letter.
fn parameters() -> BTreeSet<&'static str> {
    let all = CYCLES.iter().flat_map(|cycle| cycle.params);
    all.map(|param| param.name.as_str()).filter(|name| name.len() > 2).collect()
}

/// The words of a text, names with their underscores.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
}

/// Without `// …` and `/* … */`; that a text in quotes may end there too loses nothing that a name would hide in.
fn without_comments(text: &str) -> String {
    let blocks = text.split("/*").enumerate();
    let code: String = blocks
        .map(|(at, piece)| if at == 0 { piece } else { piece.split_once("*/").map_or("", |(_, behind)| behind) })
        .collect();
    code.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Files of the page and its bindings that a person wrote.
fn of_the_page(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let inside = |path: PathBuf| match path.extension().and_then(|ending| ending.to_str()) {
        _ if path.ends_with("node_modules") => Vec::new(),
        _ if path.is_dir() => of_the_page(&path),
        Some("rs" | "ts" | "html" | "css" | "ftl") => vec![path],
        _ => Vec::new(),
    };
    entries.flat_map(inside).collect()
}

// oracle: the catalogue
#[test]
fn page_and_bindings_name_no_cycle_and_no_parameter() {
    let names: BTreeSet<&str> = names().into_iter().chain(stems()).chain(parameters()).collect();
    let files: Vec<PathBuf> = ["web", "www"].iter().flat_map(|folder| of_the_page(&root().join(folder))).collect();
    assert!(files.len() > 80, "{}", files.len());
    for file in files {
        let code = without_comments(&std::fs::read_to_string(&file).unwrap());
        let found: Vec<&str> = words(&code).filter(|word| names.contains(word)).collect();
        assert!(found.is_empty(), "{}: {found:?}", file.display());
    }
}

fn core() -> Sources {
    let core = Sources::read(&root().join("core/src/lib.rs")).unwrap();
    assert!(core.texts.len() > 3_000, "{}", core.texts.len());
    core
}

/// Where a text stands, and the text.
fn shown(one: &Found) -> String {
    let file = one.file.strip_prefix(root()).unwrap_or(&one.file);
    format!("{}:{} {}", file.display(), one.line, one.what.concat())
}

// oracle: the catalogue
#[test]
fn cycles_are_named_in_the_catalogue_alone() {
    let (names, stems, core) = (names(), stems(), core());
    let outside = |one: &&Found| one.module.first().is_none_or(|room| room != "catalogue");
    let texts = core.texts.iter().filter(outside).filter(|one| words(&one.what[0]).any(|word| names.contains(word)));
    let paths = core.paths.iter().filter(outside);
    let paths = paths.filter(|one| one.what.iter().any(|segment| stems.contains(segment.as_str())));
    assert_eq!(texts.chain(paths).map(shown).collect::<Vec<_>>(), [""; 0]);
}

// oracle: hand (what a style sheet would call a colour or a length)
#[test]
fn colours_and_pixels_are_the_pages_own() {
    let is_colour = |word: &str| {
        let digits = word.strip_prefix('#').unwrap_or("");
        [6, 8].contains(&digits.len()) && digits.chars().all(|c| c.is_ascii_hexdigit())
    };
    let is_function = |word: &str| word.starts_with("rgb(") || word.starts_with("rgba(") || word.starts_with("hsl(");
    let is_length = |word: &str| word.strip_suffix("px").is_some_and(|number| number.parse::<f64>().is_ok());
    let says = |text: &str| {
        text.split(['"', ' ', ';', ':']).any(|word| is_colour(word) || is_function(word) || is_length(word))
    };
    assert!(says("fill: #0a7d55") && says("1.5px") && !says("#500 = 1") && !says("pixels"));
    let core = core();
    let wrong: Vec<String> = core.texts.iter().filter(|one| says(&one.what[0])).map(shown).collect();
    assert_eq!(wrong, [""; 0]);
}
