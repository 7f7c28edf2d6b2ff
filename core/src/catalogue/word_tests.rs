//! The words of the catalogue against its own message files.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::*;
use crate::diagnostic::Code;
use crate::entry::Kind;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Keys of all English message files.
fn words() -> BTreeMap<String, String> {
    let mut keys = BTreeMap::new();
    for entry in std::fs::read_dir(root().join("core/messages/en")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "ftl") {
            for line in std::fs::read_to_string(&path).unwrap().lines() {
                if let Some((key, text)) = line.split_once(" = ") {
                    keys.insert(key.trim().to_owned(), text.to_owned());
                }
            }
        }
    }
    keys
}

#[test]
fn every_key_of_the_catalogue_has_words() {
    // oracle: self
    let words = words();
    let has = |key: String| assert!(words.contains_key(&key), "no words for {key}");
    for cycle in CYCLES {
        for part in ["title", "help", "words"] {
            has(format!("{}-{part}", cycle.key));
        }
        cycle.variants.iter().for_each(|variant| has(variant.key.into()));
        cycle.results.iter().for_each(|field| has(field.key.into()));
        for param in cycle.params {
            let labels = param.labels.iter().map(|(_, key)| *key);
            for key in labels.chain([param.key]) {
                has(format!("param-{key}"));
                has(format!("param-{key}-help"));
            }
            param.needs.iter().for_each(|need| has(need.reason.into()));
            match &param.kind {
                Kind::Choice(choices) | Kind::ChoiceIf(_, choices) => {
                    choices.iter().for_each(|(_, key)| has((*key).into()))
                }
                Kind::ChoiceBy(lists) => {
                    lists.iter().flat_map(|(_, choices)| *choices).for_each(|(_, key)| has((*key).into()))
                }
                Kind::Variant(groups) | Kind::Digits(groups) => {
                    for group in *groups {
                        has(group.key.into());
                        group.choices.iter().for_each(|(_, key)| has((*key).into()));
                    }
                }
                Kind::Real | Kind::Integer | Kind::Knum | Kind::Text(_) => {}
            }
        }
    }
}

// oracle: self: a cycle, its variants together, one of them, a choice that a number makes
#[test]
fn search_words_belong_to_something_that_is_found_by_them() {
    let of = |cycle: &'static Cycle| {
        let variants = cycle.variants.iter();
        let keys = variants.flat_map(|variant| cycle.choices(variant.number).chain([variant.key]));
        keys.map(str::to_owned).chain([cycle.key.to_owned(), format!("{}-each", cycle.key)])
    };
    let known: BTreeSet<String> = CYCLES.iter().flat_map(|cycle| of(cycle)).collect();
    let words = words();
    // `around-…` is of the blocks around a call, above this room (app/around_tests.rs), `guide-…` of the guides there
    let elsewhere = |key: &str| ["around-", "guide-"].iter().any(|start| key.starts_with(start));
    let of_cycles = words.keys().filter(|key| !elsewhere(key));
    let there: Vec<&str> = of_cycles.filter_map(|key| key.strip_suffix("-words")).collect();
    assert!(there.len() > 90, "{}", there.len());
    let idle: Vec<&&str> = there.iter().filter(|key| !known.contains(**key)).collect();
    assert!(idle.is_empty(), "{idle:?}");
}

#[test]
fn alarms_have_words_and_stand_once() {
    // oracle: self
    let words = words();
    for cycle in CYCLES {
        let alarms = cycle.alarms();
        for (index, code) in alarms.iter().enumerate() {
            assert!(!alarms[..index].contains(code), "{} {code:?}", cycle.name);
            let key = match code {
                Code::Nct(text) => {
                    let plain = text.trim_end_matches(['?', '!']);
                    format!("nct-{}", plain.to_lowercase().replace(' ', "-"))
                }
                Code::Alarm(number) => format!("alarm-{number}"),
                Code::Own(number) => panic!("PW{number} is no alarm of a control"),
            };
            assert!(words.contains_key(&key), "no words for {key}");
        }
    }
}

/// The Rust files below a folder.
fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_finding_has_words() {
    // oracle: self
    let (words, mut files) = (words(), Vec::new());
    for folder in ["check", "catalogue", "form"] {
        sources(&root().join("core/src").join(folder), &mut files);
    }
    let mut seen = 0;
    for key in files.iter().flat_map(|text| text.split('"')) {
        let plain =
            !key.ends_with('-') && key.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        if plain && ["check-", "need-", "knum-zero-", "knum-mode-"].iter().any(|stem| key.starts_with(stem)) {
            assert!(words.contains_key(key), "no words for {key}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
    // what helps against a refusal has the key of its cause and `-hint`
    let ours = ["use crate::check::refused;", "refused};", "use crate::catalogue::prelude::*;"];
    let raising = files.iter().filter(|text| ours.iter().any(|import| text.contains(import)));
    let refused = raising.flat_map(|text| text.split("refused(6").skip(1).chain(text.split("announced(6").skip(1)));
    let keys: Vec<&str> = refused.filter_map(|rest| rest.split('"').nth(1)).collect();
    assert!(keys.len() > 20);
    // a hint that is handed over stands for itself
    let causes = keys.iter().filter(|key| words.contains_key(**key) && !key.ends_with("-hint"));
    let hints = causes.map(|key| format!("{key}-hint"));
    hints.for_each(|hint| assert!(words.contains_key(&hint), "no words for {hint}"));
}
