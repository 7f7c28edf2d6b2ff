//! No sentence in the core: what a user reads are keys with words in `core/messages`. Literals of the code (outside of
//! tests and the terminal program) are looked through for anything that reads like English.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::{Path, PathBuf};

/// Texts of the controls and places in the literature, which are the same in every language.
const ALLOWED: &[(&str, &str)] = &[
    ("catalogue/operator_messages.rs", ""), // as the control shows them
    ("control/machine_data/table.rs", "all 3 geometry axes present"),
    ("foreign/tnc/log.rs", ""),                         // as the control writes them
    ("foreign/tnc/table.rs", ""),                       // where its values are published
    ("manual.rs", ""),                                  // titles of manuals
    ("entry/named.rs", "a condition looks at a datum"), // the compiler says them, to whoever writes an entry
    ("entry/named.rs", "the entry names a parameter"),
    ("report/drawing.rs", "<svg xmlns"), // a figure, not a sentence
];

/// Source files of the core, without tests and the terminal program.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let of_tests = name == "bin"
            || name == "tests"
            || name.ends_with("_tests")
            || name.starts_with("test")
            || name.ends_with("testing");
        match path.is_dir() {
            _ if of_tests => {}
            true => sources(&path, found),
            false => found.push(path),
        }
    }
}

/// The code before its tests.
fn without_tests(code: &str) -> &str {
    let mut tests = code.match_indices("\n#[cfg(test)]\n").map(|(at, _)| at);
    let inline = tests.find(|at| code[at + 1..].lines().nth(1).is_some_and(|line| line.ends_with('{')));
    &code[..inline.unwrap_or(code.len())]
}

/// The string literals of a piece of code, comments left out.
fn literals(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find(['"', '/', '\'']) {
        let (before, from) = rest.split_at(at);
        rest = match from.as_bytes() {
            [b'/', b'/', ..] => from.find('\n').map_or("", |end| &from[end..]),
            [b'\'', b'\\', _, ..] => from[3..].split_once('\'').map_or("", |(_, rest)| rest),
            [b'\'', ..] => {
                let mut chars = from[1..].char_indices();
                chars.next();
                match chars.next() {
                    Some((next, '\'')) => &from[next + 2..],
                    _ => &from[1..], // a lifetime
                }
            }
            [b'"', ..] => {
                let marks = before.len() - before.trim_end_matches('#').len();
                let raw = before.trim_end_matches('#').ends_with('r');
                let (text, rest) = if raw { raw_text(&from[1..], marks) } else { text(&from[1..]) };
                found.push(text);
                rest
            }
            _ => &from[1..],
        };
    }
    found
}

fn raw_text(from: &str, marks: usize) -> (String, &str) {
    let end = format!("\"{}", "#".repeat(marks));
    let (text, rest) = from.split_once(&end).unwrap();
    (text.to_owned(), rest)
}

fn text(from: &str) -> (String, &str) {
    let mut escaped = false;
    let end = from.find(|c| {
        let ends = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        ends
    });
    let end = end.unwrap();
    (from[..end].replace("\\n", " ").replace("\\\"", "\""), &from[end + 1..])
}

/// Whether it reads like English: three words with small letters one behind the other; what is put in does not count.
fn reads(text: &str) -> bool {
    let plain: String = text.split('{').map(|part| part.split_once('}').map_or(part, |(_, rest)| rest)).collect();
    let is_word = |word: &str| {
        let word = word.trim_matches(|c: char| c.is_ascii_punctuation());
        let letters = word.chars().all(|c| c.is_ascii_alphabetic() || c == '\'');
        letters && word.len() > 1 && word.chars().skip(1).any(|c| c.is_ascii_lowercase())
    };
    let words: Vec<bool> = plain.split_whitespace().map(is_word).collect();
    words.windows(3).any(|three| three.iter().all(|word| *word))
}

// oracle: hand
#[test]
fn what_reads_like_english_is_found() {
    let code = r##"
        //! "This is a comment."
        fn f<'a>(x: &'a str) -> char { '"' } // "and so is this"
        let a = format!("unknown {what}: {name}");
        let b = "not the expected JSON: {0}";
        let c = r#"it is "quoted" here"#;
        let d = ("PROBE FAIL NOW", "G54 G17 G90", '\'', "a\"b c d", "x y z", "$P_UIFR[1,X]");
        let e = format!("{min} to {max}, {name}: {label}");
        const E: &str = "a line that goes on \
            below";
        #[error("the surface has no triangles")]
    "##;
    let found = literals(code);
    assert_eq!(found.len(), 11, "{found:?}");
    let read: Vec<&String> = found.iter().filter(|text| reads(text)).collect();
    let begins = ["not the", "it is", "a line", "the surface"];
    assert_eq!(read.len(), begins.len(), "{read:?}");
    assert!(read.iter().zip(begins).all(|(text, begin)| text.starts_with(begin)), "{read:?}");
    let cut = without_tests("fn f() {}\n#[cfg(test)]\nmod far;\nlet x = 1;\n#[cfg(test)]\nmod tests {\n let a = 1; }");
    assert!(cut.ends_with("let x = 1;"));
}

// oracle: self
#[test]
fn no_sentence_stands_in_the_core() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    assert!(files.len() > 300, "{}", files.len());
    let mut found = Vec::new();
    for path in files {
        let code = std::fs::read_to_string(&path).unwrap();
        let name = path.strip_prefix(&root).unwrap().to_str().unwrap().to_owned();
        let texts = literals(without_tests(&code)).into_iter().filter(|text| reads(text));
        found.extend(texts.map(|text| (name.clone(), text)));
    }
    let mut unused: Vec<_> = ALLOWED.to_vec();
    found.retain(|(name, text)| {
        let known = ALLOWED.iter().find(|(file, begin)| name == file && text.starts_with(begin));
        unused.retain(|one| Some(one) != known);
        known.is_none()
    });
    assert!(found.is_empty(), "sentences belong into core/messages: {found:#?}");
    assert!(unused.is_empty(), "no longer there: {unused:?}");
}
