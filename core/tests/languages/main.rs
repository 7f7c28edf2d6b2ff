//! Every language says everything that English says, with the same arguments and the same names of parameters.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod wording;

use probewright_core::words::LANGUAGES;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Units and names, which are the same in every language.
const SAME: &[&str] = &[
    "app-name", "compatibility-version", "equipment-shape", "program-file-nct", "program-file-sinumerik", "term-frame",
    "term-microsoft", "term-software", "unit-ft-per-min", "unit-hex", "unit-inch", "unit-inch-per-min",
    "unit-m-per-min", "unit-mm-per-min", "unit-rpm",
];

/// Words that another language shares with English.
const SHARED: &[(&str, &[&str])] = &[
    (
        "de",
        &[
            "Alarm", "minus", "Name", "null", "optional", "Optional", "Ordinate", "Pause", "plus", "Position",
            "Radius", "Register", "Scan", "Shift", "Signal", "Standard", "Text",
        ],
    ),
    // as they stand on the keys
    ("zh", &["Ctrl", "Down", "End", "Enter", "Home", "Page", "Shift", "Up"]),
];

/// Texts whose names differ by language: the key Home is Pos1 on a German keyboard.
const OTHER_NAMES: &[&str] = &["keys-tree"];

/// Folders of the core's messages and of the page's.
fn folders() -> [PathBuf; 2] {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    [root.join("core/messages"), root.join("www/messages")]
}

fn files(folder: &Path) -> BTreeSet<String> {
    std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".ftl"))
        .collect()
}

/// Texts of a file: of a message under its key, of an attribute under `key.attribute`.
fn texts(path: &Path) -> BTreeMap<String, String> {
    let mut texts: BTreeMap<String, String> = BTreeMap::new();
    let (mut key, mut part) = (String::new(), String::new());
    for line in std::fs::read_to_string(path).unwrap().lines() {
        let inside = line.starts_with(' ');
        match line.trim_start().split_once(" =") {
            Some((name, text)) if !inside && !line.starts_with('#') => {
                key = name.to_owned();
                part = key.clone();
                texts.insert(part.clone(), text.to_owned());
            }
            Some((name, text)) if inside && name.starts_with('.') => {
                part = format!("{key}{name}");
                texts.insert(part.clone(), text.to_owned());
            }
            _ if inside => texts.get_mut(&part).unwrap().push_str(line),
            _ => {}
        }
    }
    texts
}

/// What stands in braces: arguments and names. The forms of a number differ by language and are not looked at.
fn placeables(text: &str) -> BTreeSet<&str> {
    text.split('{').skip(1).map(|rest| rest.split(['}', '-']).next().unwrap().trim()).collect()
}

/// Names that every language writes alike: parameters, variables, cycles, G and M functions (a capital, and a digit or
/// a sign), and machine data and alarms (five digits).
fn names(text: &str) -> BTreeSet<&str> {
    let part = |c: char| c.is_ascii_alphanumeric() || "_$[]".contains(c);
    let is_name = |word: &&str| {
        let sign = |c: char| c.is_ascii_digit() || c == '_' || c == '$';
        let number = word.len() == 5 && word.bytes().all(|one| one.is_ascii_digit());
        number || word.contains(|c: char| c.is_ascii_uppercase()) && word.contains(sign)
    };
    text.split(|c| !part(c)).filter(is_name).collect()
}

/// Whether a text holds a word of English alone: not only shared ones, names, numbers and units of a letter or two.
fn has_words(text: &str, language: &str) -> bool {
    let shared = SHARED.iter().find(|(code, _)| *code == language).map_or(&[][..], |(_, words)| words);
    let outside = text.split('{').map(|part| part.rsplit('}').next().unwrap());
    let plain = outside.collect::<Vec<_>>().join(" ");
    plain
        .split(|c: char| !c.is_alphanumeric() && c != '_' && c != '$')
        .filter(|word| !shared.contains(word))
        .any(|word| word.len() > 2 && word.chars().skip(1).all(|c| c.is_ascii_lowercase()))
}

fn compare(english: &Path, other: &Path, language: &str) {
    let (english, other) = (texts(english), texts(other).into_iter());
    let other: BTreeMap<String, String> = other.collect();
    let keys = |texts: &BTreeMap<String, String>| texts.keys().cloned().collect::<BTreeSet<_>>();
    let (wanted, there) = (keys(&english), keys(&other));
    let missing: Vec<_> = wanted.difference(&there).collect();
    let unknown: Vec<_> = there.difference(&wanted).collect();
    assert!(missing.is_empty(), "no text for {missing:?}");
    assert!(unknown.is_empty(), "English has no message for {unknown:?}");
    for (key, text) in &english {
        let said = &other[key];
        assert_eq!(placeables(text), placeables(said), "{key}");
        let alike = names(text) == names(said) || key.ends_with("-words") || OTHER_NAMES.contains(&key.as_str());
        assert!(alike, "{key} in {language}: {:?} are {:?}", names(text), names(said));
        let translated = said != text || !has_words(text, language) || SAME.contains(&key.as_str());
        assert!(translated, "{key} is still English: {text}");
    }
}

// oracle: self (English is the list of what has to be said)
#[test]
fn every_language_is_complete() {
    for folder in folders() {
        let english = folder.join("en");
        for language in LANGUAGES.iter().filter(|language| language.code != "en") {
            let other = folder.join(language.code);
            assert_eq!(files(&english), files(&other), "{}", other.display());
            for name in files(&english) {
                compare(&english.join(&name), &other.join(&name), language.code);
            }
        }
    }
}

// oracle: self
#[test]
fn every_folder_is_a_language_and_every_file_is_read() {
    let [core, page] = folders();
    let known: BTreeSet<&str> = LANGUAGES.iter().map(|language| language.code).collect();
    for folder in [&core, &page] {
        let there = std::fs::read_dir(folder).unwrap();
        let there: BTreeSet<String> = there.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        assert!(there.iter().map(String::as_str).eq(known.iter().copied()));
    }
    for language in LANGUAGES {
        let listed = language.files.iter().map(|(name, _)| (*name).to_owned());
        let listed: BTreeSet<String> = listed.collect();
        assert_eq!(listed, files(&core.join(language.code)));
    }
}

// oracle: hand
#[test]
fn names_are_told_from_words() {
    let text = " In { \"_TP[k,8]\" } with { $value } mm: MD\u{a0}18080, $TC_DP1=710, G54至G57, ALARM 61301, 100";
    let told = ["$TC_DP1", "18080", "61301", "G54", "G57", "_TP[k"];
    assert_eq!(names(text), BTreeSet::from(told));
}

// oracle: hand
#[test]
fn english_words_are_told_from_names() {
    for text in [" Feed", " { $param } is missing", " a b see { $c }"] {
        assert!(has_words(text, "en"), "{text}");
    }
    for text in [" G17 · X Y", " { $value } mm", " _MVAR=1", " 3", " SINUMERIK"] {
        assert!(!has_words(text, "en"), "{text}");
    }
}
