//! Every variant of every cycle has a whole help page, and no word of the help stands idle.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::CYCLES;
use super::help::HelpPage;
use crate::entry::{Inputs, SECTIONS, Section};
use crate::words::{LANGUAGES, Words};
use std::collections::{BTreeMap, BTreeSet};

fn keys(page: &HelpPage, section: Section) -> Vec<&'static str> {
    page.section(section).map(|line| line.key).collect()
}

// oracle: the names of cycles in issue and manual; alarms: tests/data/alarms.tsv, which the entries are held against
#[test]
fn every_variant_of_every_cycle_has_all_five_sections() {
    let mut variants = 0;
    for cycle in CYCLES.iter().copied() {
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            for section in SECTIONS {
                let at = format!("{} {} {section:?}", cycle.name, variant.number);
                assert!(page.section(section).next().is_some(), "{at}");
            }
            assert_eq!(page.alarms.is_empty(), cycle.alarms().is_empty(), "{}", cycle.name);
            variants += 1;
        }
    }
    assert!(variants > 190, "{variants}");
}

// oracle: self: what happens differs where what is measured does
#[test]
fn what_measures_something_else_happens_in_another_order() {
    for cycle in CYCLES.iter().copied() {
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
    for cycle in CYCLES.iter().copied() {
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
        .filter(|(key, _)| !key.starts_with("help-section-") && *key != "help-values" && *key != "help-alarms")
        .map(|(key, text)| (key.to_owned(), text.to_owned()))
        .collect()
}

// oracle: self
#[test]
fn every_line_has_words_and_no_words_are_idle() {
    let pages = CYCLES.iter().flat_map(|cycle| {
        let variants = cycle.variants.iter();
        variants.map(move |variant| HelpPage::of(cycle, variant.number))
    });
    let used: BTreeSet<String> = pages.flat_map(|page| page.lines).map(|line| line.key.to_owned()).collect();
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
            assert_eq!(names(&text), names(&english[&key]), "{} {key}", language.code);
        }
    }
}

// oracle: manual C:984-985, C:1144: a message of pocket and bore; C:1097: if a bore is measured
#[test]
fn a_tool_has_to_fit_into_what_it_cuts_inside_only() {
    let words = Words::english();
    let told = |page: &HelpPage| page.lines.iter().any(|line| words.key(line.key).contains("TOOL DIA OFFS TOO LARGE"));
    let mut found = Vec::new();
    for cycle in CYCLES.iter().copied() {
        let variants = cycle.variants.iter().map(|variant| variant.number);
        found.extend(variants.filter(|number| told(&HelpPage::of(cycle, *number))).map(|number| (cycle.name, number)));
    }
    assert_eq!(found, [("G109", super::g109::POCKET), ("G110", super::g110::BORE)]);
}

// oracle: self: a number that the words give is one of the alarms that the variant can raise
#[test]
fn an_alarm_in_the_words_is_one_that_the_variant_can_raise() {
    let words = Words::english();
    let mut seen = 0;
    for cycle in CYCLES.iter().copied() {
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            let can = |number: u32| {
                let code = crate::diagnostic::Code::Alarm(number);
                page.alarms.contains(&code)
            };
            for line in &page.lines {
                let text = words.key(line.key);
                for number in text.split(|c: char| !c.is_ascii_digit()) {
                    let Ok(number @ 61_000..63_000) = number.parse() else { continue };
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

// oracle: manual: no measuring axis and no zone in B:5989-6024, tolerances with a tool only (B:1346), mean value
// likewise
#[test]
fn alarms_follow_from_what_a_variant_uses() {
    assert!(!raises("CYCLE977", 1, 61325) && raises("CYCLE977", 3, 61325));
    assert!(!raises("CYCLE977", 1, 61334) && raises("CYCLE977", 1001, 61334));
    assert!(raises("CYCLE977", 1, 62304) && !raises("CYCLE977", 101, 62304));
    assert!(raises("CYCLE977", 1, 61318) && !raises("CYCLE977", 101, 61318));
    assert!(!raises("CYCLE977", 1, 61321) && raises("CYCLE977", 101, 61321));
    assert!(!raises("CYCLE971", 10_000, 61303) && raises("CYCLE971", 0, 61303));
}

// oracle: manual B:5675-5724 (a rectangle has two lengths), B:5700 (status of the zero offset)
#[test]
fn results_are_those_of_the_variant() {
    let has = |variant: i64, key: &str| {
        let results = page("CYCLE977", variant).results;
        results.iter().any(|field| field.key == key)
    };
    assert!(has(1, "result-actual-size") && !has(5, "result-actual-size"));
    assert!(has(5, "result-actual-length-ordinate") && !has(1, "result-actual-length-ordinate"));
    assert!(has(101, "result-zero-status") && !has(1, "result-zero-status"));
}

// oracle: manual B:5989-6024
#[test]
fn values_that_every_call_gives_are_named() {
    assert_eq!(page("CYCLE977", 1).required, ["_SETVAL", "_KNUM"]);
    let web = page("CYCLE977", 1004).required;
    assert_eq!(web, ["_SETVAL", "_ID", "_SZA", "_MA", "_KNUM"]);
}

/// Lines that say how often it is touched: so many times, so many more, so many times over.
const TOUCHES: &[(&str, usize)] = &[
    ("help-cycle961-order-three", 3),
    ("help-cycle961-order-four", 4),
    ("help-cycle961-order-infeed", 4),
    ("help-cycle971-order-all-sides", 8),
    ("help-cycle971-order-beside", 1),
    ("help-cycle972-order-travel", 1),
    ("help-cycle973-order-surface", 1),
    ("help-cycle973-order-one", 1),
    ("help-cycle973-order-two", 2),
    ("help-cycle974-measures-point", 1),
    ("help-cycle976-order-one", 1),
    ("help-cycle976-order-two", 2),
    ("help-cycle976-order-four", 4),
    ("help-cycle976-order-no-approach", 1),
    ("help-cycle976-measures-surface", 1),
    ("help-cycle977-order-two-axes", 4),
    ("help-cycle977-order-one-axis", 2),
    ("help-cycle978-measures-point", 1),
    ("help-cycle979-order-circle", 3),
    ("help-cycle979-order-across", 2),
    ("help-cycle979-order-over", 2),
    ("help-cycle982-order-calibrate", 1),
    ("help-cycle982-order-length", 1),
    ("help-cycle982-order-radius", 1),
    ("help-cycle982-order-both", 2),
    ("help-cycle982-order-upper-behind", 4),
    ("help-cycle982-order-upper-across", 4),
    ("help-cycle994-order-plus-first", 2),
    ("help-cycle997-order-paraxial", 5),
    ("help-cycle997-order-three-points", 4),
    ("help-cycle997-order-four-points", 5),
    ("help-cycle998-order-one-angle", 2),
    ("help-cycle998-order-one-paraxial", 2),
    ("help-cycle998-order-two-angle", 3),
    ("help-cycle998-order-two-paraxial", 3),
    ("help-tool-from-here", 1),
];
const MORE: &[&str] = &["help-turned-over", "help-cycle974-order-reversal", "help-cycle997-order-diameter"];
const OVER: &[(&str, usize)] = &[
    ("help-cycle976-order-twice", 2),
    ("help-cycle982-order-reversal", 2),
    ("help-cycle997-order-repeat", 2),
    ("help-cycle997-order-next", 3),
];
/// Lines that say that it ends where it began.
const BACK: &[&str] = &[
    "help-ends-at-start",
    "help-cycle976-order-end-centre",
    "help-cycle982-order-all",
    "help-cycle982-order-upper-behind",
    "help-cycle982-order-upper-across",
    "help-tool-from-here",
];

/// One to three times, by data of the machine.
const BY_MACHINE: &str = "help-cycle971-order-turning";

/// How often a page says that it is touched; none: it does not say exactly.
fn touches(page: &HelpPage) -> Option<usize> {
    let says = |key: &str| page.lines.iter().any(|line| line.key == key);
    let once = TOUCHES.iter().filter(|(key, _)| says(key));
    let mut once: Vec<usize> = once.map(|(_, count)| *count).collect();
    once.dedup();
    let more = MORE.iter().filter(|key| says(key)).count();
    let over = OVER.iter().filter(|(key, _)| says(key));
    let over: usize = over.map(|(_, times)| *times).product();
    assert!(once.len() < 2, "{once:?}");
    let exact = !says(BY_MACHINE);
    exact.then_some((once.first()? + more) * over)
}

// oracle: the simulation, which does not know the words
#[test]
fn a_page_counts_the_touches_that_happen_and_says_where_they_end() {
    let (mut counted, mut ended) = (0, 0);
    for cycle in CYCLES.iter().filter(|cycle| cycle.work().is_some()) {
        for variant in cycle.variants {
            let page = HelpPage::of(cycle, variant.number);
            let values = super::example::example(cycle, variant);
            let request = serde_json::json!({
                "control": cycle.dialect,
                "cycle": cycle.name, "values": values, "predict": true,
            });
            let view = crate::json::asked::form(&request.to_string()).unwrap();
            let entries = view["outcome"]["trace"]["entries"].as_array().unwrap();
            let of = |step: &str| {
                let all = entries.iter().filter(|entry| entry["step"] == step);
                all.collect::<Vec<_>>()
            };
            let at = format!("{} {}", cycle.name, variant.number);
            if let Some(said) = touches(&page) {
                assert_eq!(of("touch").len(), said, "{at}");
                counted += 1;
            }
            if page.lines.iter().any(|line| BACK.contains(&line.key)) {
                let motions = of("motion");
                let begin = &motions.first().unwrap()["from"];
                let end = &motions.last().unwrap()["to"];
                for axis in 0..3 {
                    let way = begin[axis].as_f64().unwrap() - end[axis].as_f64().unwrap();
                    assert!(way.abs() < 1e-6, "{at}: {begin} {end}");
                }
                ended += 1;
            }
        }
    }
    assert!(counted > 170 && ended > 50, "{counted} {ended}");
}
