//! Every variant of every measuring cycle has a whole help page, and no word of the help stands idle.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::help::{HelpPage, SECTIONS, Section};
use super::{CYCLES, Cycle, Dialect, ProbeUse};
use crate::check::Inputs;
use crate::words::{LANGUAGES, Words};
use std::collections::{BTreeMap, BTreeSet};

/// Cycles that touch something, and G101, which guards the way there.
fn measuring() -> impl Iterator<Item = &'static Cycle> {
    let cycles = CYCLES.iter().copied();
    cycles.filter(|cycle| cycle.dialect == Dialect::Nct || cycle.purpose.probe.measures())
}

fn keys(page: &HelpPage, section: Section) -> Vec<&'static str> {
    page.section(section).map(|line| line.key).collect()
}

// oracle: the names of cycles in issue and manual; helpers compute or print and have no variant
#[test]
fn every_variant_of_every_measuring_cycle_has_all_five_sections() {
    let mut variants = 0;
    for cycle in measuring() {
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            for section in SECTIONS {
                let at = format!("{} {} {section:?}", cycle.name, variant.number);
                assert!(page.section(section).next().is_some(), "{at}");
            }
            assert!(!page.alarms.is_empty(), "{}", cycle.name);
            variants += 1;
        }
    }
    let others = CYCLES.iter().filter(|cycle| {
        cycle.dialect == Dialect::Sinumerik
            && matches!(cycle.purpose.probe, ProbeUse::None | ProbeUse::Log)
    });
    for cycle in others {
        assert_eq!(cycle.help.lines().count(), 0, "{}", cycle.name);
    }
    assert!(variants > 190, "{variants}");
}

// oracle: self: what happens differs where what is measured does
#[test]
fn what_measures_something_else_happens_in_another_order() {
    for cycle in measuring() {
        let mut known: BTreeMap<Vec<&str>, Vec<&str>> = BTreeMap::new();
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            let measures = keys(&page, Section::Measures);
            let at = format!("{} {}", cycle.name, variant.number);
            let first = known.entry(keys(&page, Section::Order));
            assert_eq!(*first.or_insert(measures.clone()), measures, "{at}");
        }
    }
}

// oracle: self: a condition on other values would make a page that changes with the form
#[test]
fn the_variant_alone_decides_which_lines_stand_in_its_page() {
    for cycle in measuring() {
        for line in cycle.help.lines() {
            let decide = |number| line.when.of_variant(&Inputs::new(cycle, number));
            let mut variants = cycle.variants.iter();
            let decided = variants.all(|variant| decide(variant.number).is_some());
            assert!(decided, "{} {}", cycle.name, line.key);
        }
    }
}

/// The lines of help in a language, by key.
fn lines(language: &str) -> BTreeMap<String, String> {
    let files = LANGUAGES.iter().find(|one| one.code == language).unwrap();
    let texts = files.files.iter().flat_map(|(_, text)| text.lines());
    texts
        .filter_map(|line| line.split_once(" = "))
        .filter(|(key, _)| key.starts_with("help-"))
        .filter(|(key, _)| {
            !key.starts_with("help-section-") && *key != "help-values" && *key != "help-alarms"
        })
        .map(|(key, text)| (key.to_owned(), text.to_owned()))
        .collect()
}

// oracle: self
#[test]
fn every_line_has_words_and_no_words_are_idle() {
    let pages = measuring().flat_map(|cycle| {
        let variants = cycle.variants.iter();
        variants.map(move |variant| HelpPage::of(cycle, variant.number))
    });
    let used: BTreeSet<String> = pages
        .flat_map(|page| page.lines)
        .map(|line| line.key.to_owned())
        .collect();
    for language in LANGUAGES {
        let there: BTreeSet<String> = lines(language.code).into_keys().collect();
        assert_eq!(there, used, "{}", language.code);
    }
}

// oracle: self: what two variants share is one line of both
#[test]
fn no_sentence_is_written_twice() {
    for language in LANGUAGES {
        let mut seen: BTreeMap<String, String> = BTreeMap::new();
        for (key, text) in lines(language.code) {
            assert_eq!(seen.insert(text, key.clone()), None, "{key}");
        }
    }
}

/// Names of data and parameters, numbers of alarms and G functions: what is the same in every language.
fn names(text: &str) -> BTreeSet<&str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && !"_[],#$".contains(c))
        .map(|word| word.trim_matches([',', '[', ']']))
        .filter(|word| word.contains('_') || word.chars().filter(char::is_ascii_digit).count() > 1)
        .collect()
}

// oracle: self
#[test]
fn every_language_names_the_same_data_and_alarms() {
    let english = lines("en");
    for language in LANGUAGES {
        for (key, text) in lines(language.code) {
            assert_eq!(
                names(&text),
                names(&english[&key]),
                "{} {key}",
                language.code
            );
        }
    }
}

// oracle: self: a number that the words give is one of the alarms that the variant can raise
#[test]
fn an_alarm_in_the_words_is_one_that_the_variant_can_raise() {
    let words = Words::english();
    let mut seen = 0;
    for cycle in measuring() {
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            let can = |number: u32| {
                let code = crate::diagnostic::Code::Alarm(number);
                page.alarms.contains(&code)
            };
            for line in &page.lines {
                let text = words.key(line.key);
                for number in text.split(|c: char| !c.is_ascii_digit()) {
                    let Ok(number @ 61_000..63_000) = number.parse() else {
                        continue;
                    };
                    let at = format!("{} {} {}", cycle.name, variant.number, line.key);
                    assert!(can(number), "{at}: {number}");
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 300, "{seen}");
}

/// The page of a variant of a cycle.
fn page(name: &str, variant: i64) -> HelpPage {
    let cycle = CYCLES.iter().find(|cycle| cycle.name == name).unwrap();
    HelpPage::of(cycle, variant)
}

fn raises(name: &str, variant: i64, number: u32) -> bool {
    let code = crate::diagnostic::Code::Alarm(number);
    page(name, variant).alarms.contains(&code)
}

// oracle: manual: no measuring axis and no zone in B:5989-6024, tolerances with a tool only (B:1346), mean value likewise
#[test]
fn alarms_follow_from_what_a_variant_uses() {
    assert!(!raises("CYCLE977", 1, 61325) && raises("CYCLE977", 3, 61325));
    assert!(!raises("CYCLE977", 1, 61334) && raises("CYCLE977", 1001, 61334));
    assert!(raises("CYCLE977", 1, 62304) && !raises("CYCLE977", 101, 62304));
    assert!(raises("CYCLE977", 1, 61318) && !raises("CYCLE977", 101, 61318));
    assert!(!raises("CYCLE977", 1, 61321) && raises("CYCLE977", 101, 61321));
    assert!(!raises("CYCLE971", 10_000, 61303) && raises("CYCLE971", 0, 61303));
}

// oracle: manual B:5989-6024
#[test]
fn values_that_every_call_gives_are_named() {
    assert_eq!(page("CYCLE977", 1).required, ["_SETVAL", "_KNUM"]);
    let web = page("CYCLE977", 1004).required;
    assert_eq!(web, ["_SETVAL", "_ID", "_SZA", "_MA", "_KNUM"]);
}
