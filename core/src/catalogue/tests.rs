//! The catalogue against the tables of the manual (when that folder is there), and against its own message files.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Rows of a table of the manual; none where the folder is not present.
fn rows(table: &str) -> Option<Vec<Vec<String>>> {
    let text = std::fs::read_to_string(root().join("../shared/spec").join(table)).ok()?;
    let row = |line: &str| line.split('\t').map(str::to_owned).collect();
    Some(text.lines().skip(1).map(row).collect())
}

fn sinumerik() -> Vec<&'static Cycle> {
    let all = CYCLES.iter().copied();
    all.filter(|cycle| cycle.dialect == Dialect::Sinumerik)
        .collect()
}

#[test]
fn counts() {
    // oracle: manual B:5641-5667 with 1106 of B:6192, B:6323-6328
    let cycle = |name| find(Dialect::Sinumerik, name).unwrap();
    assert_eq!(cycle("cycle977").variants.len(), 24);
    assert_eq!(cycle("CYCLE978").variants.len(), 4);
    assert_eq!(cycle("CYCLE977").params.len(), 26);
    assert_eq!(cycle("CYCLE978").params.len(), 21);
    assert!(find(Dialect::Nct, "CYCLE977").is_none());
}

#[test]
fn names_stand_once() {
    // oracle: self
    for cycle in CYCLES {
        let names: BTreeSet<&str> = cycle.params.iter().map(|param| param.name).collect();
        assert_eq!(names.len(), cycle.params.len(), "{}", cycle.name);
        let numbers: BTreeSet<i64> = cycle
            .variants
            .iter()
            .map(|variant| variant.number)
            .collect();
        assert_eq!(numbers.len(), cycle.variants.len(), "{}", cycle.name);
        for (name, _) in cycle.example {
            assert!(names.contains(name), "{} example {name}", cycle.name);
        }
    }
}

#[test]
fn variants_are_those_of_the_table() {
    // oracle: manual, spec/milling/variants.tsv
    let Some(rows) = rows("milling/variants.tsv") else {
        return;
    };
    for cycle in sinumerik() {
        let table: BTreeSet<i64> = rows
            .iter()
            .filter(|row| row[0] == cycle.name)
            .map(|row| row[1].parse().unwrap())
            .collect();
        let ours: BTreeSet<i64> = cycle
            .variants
            .iter()
            .map(|variant| variant.number)
            .collect();
        assert_eq!(ours, table, "{}", cycle.name);
    }
}

#[test]
fn results_are_those_of_the_table() {
    // oracle: manual, spec/milling/results.tsv
    let Some(rows) = rows("milling/results.tsv") else {
        return;
    };
    for cycle in sinumerik() {
        let of_cycle = rows.iter().filter(|row| row[0] == cycle.name);
        let table: BTreeSet<&str> = of_cycle.map(|row| row[2].as_str()).collect();
        let ours: BTreeSet<&str> = cycle.results.iter().map(|field| field.name).collect();
        assert_eq!(ours, table, "{}", cycle.name);
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            for variant in cycle
                .variants
                .iter()
                .filter(|variant| covers(&row[1], variant.number))
            {
                let set = axes(cycle, variant.number).iter().any(|inputs| {
                    cycle
                        .results
                        .iter()
                        .any(|field| field.name == row[2] && field.when.holds(inputs))
                });
                let zero = variant.number / 100 % 10 == 1;
                let expected = match row[5].as_str() {
                    "footnote 1: only with tool offset" => !zero,
                    "footnote 2: only with ZO correction" => zero,
                    _ => true,
                };
                assert_eq!(
                    set, expected,
                    "{} {} {}",
                    cycle.name, variant.number, row[2]
                );
            }
        }
    }
}

/// Inputs of a variant with each measuring axis.
fn axes(cycle: &'static Cycle, variant: i64) -> Vec<crate::check::Inputs> {
    let with = |axis: f64| {
        let mut inputs = crate::check::Inputs::new(cycle, variant);
        inputs.numbers.insert(names::MA, axis);
        inputs
    };
    [1.0, 2.0, 3.0].map(with).into()
}

/// Whether a cell of the tables means this variant: `all`, `1..6, 1001..1006`, `xxx5, xxx6`, `all 1xxx`.
fn covers(cell: &str, variant: i64) -> bool {
    cell.replace(" and ", ",")
        .replace("all 1xxx", "1001..1199")
        .replace("0xxx (1..6,101..106)", "1..106")
        .split(',')
        .any(|part| {
            let part = part.trim();
            match (part, part.split_once("..")) {
                ("all", _) => true,
                (_, Some((from, to))) if from.starts_with('x') => {
                    let digit = |text: &str| text.trim_start_matches('x').parse::<i64>().unwrap();
                    (digit(from)..=digit(to)).contains(&(variant % 10))
                }
                (_, Some((from, to))) => {
                    (from.parse::<i64>().unwrap()..=to.parse().unwrap()).contains(&variant)
                }
                _ if part.starts_with('x') => {
                    part.trim_start_matches('x').parse::<i64>() == Ok(variant % 10)
                }
                _ => part.parse() == Ok(variant),
            }
        })
}

#[test]
fn parameters_are_those_of_the_table() {
    // oracle: manual, spec/milling/params.tsv
    let Some(rows) = rows("milling/params.tsv") else {
        return;
    };
    for cycle in sinumerik() {
        let mut used = BTreeSet::new();
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            for name in row[1].split(',').map(str::trim) {
                compare(cycle, name, row, &mut used);
            }
        }
        let ours: BTreeSet<&str> = cycle.params.iter().map(|param| param.name).collect();
        assert_eq!(ours, used, "{}", cycle.name);
    }
}

/// One parameter of one row; collects the names that any row lets be used.
fn compare(cycle: &'static Cycle, name: &str, row: &[String], used: &mut BTreeSet<&'static str>) {
    let (variants, requirement) = (&row[2], row[3].as_str());
    let Some(param) = cycle.params.iter().find(|param| param.name == name) else {
        assert_eq!(requirement, "unused", "{} {name}", cycle.name);
        return;
    };
    if requirement != "unused" {
        used.insert(param.name);
        unit(cycle, param, row);
    }
    for variant in cycle
        .variants
        .iter()
        .filter(|variant| covers(variants, variant.number))
    {
        let inputs = crate::check::Inputs::new(cycle, variant.number);
        let need = param.need(&inputs).map(|(level, _)| level);
        let expected = match requirement {
            "required" => Some(Level::Required),
            "unused" => None,
            text if text.starts_with("optional") => Some(Level::Optional),
            text if text.starts_with("required-if") => {
                return conditional(param, variant.number, cycle);
            }
            other => panic!("{other}"),
        };
        assert_eq!(need, expected, "{} {name} {}", cycle.name, variant.number);
    }
}

/// `required-if`: not needed without values, and required once the condition of the row holds.
fn conditional(param: &Param, variant: i64, cycle: &'static Cycle) {
    let mut inputs = crate::check::Inputs::new(cycle, variant);
    assert_eq!(param.need(&inputs), None, "{} {variant}", param.name);
    inputs.numbers.insert(names::PRNUM, 101.0);
    inputs.numbers.insert(names::KNUM, 3_002_001.0);
    let (level, _) = param.need(&inputs).unwrap();
    let instead = param.name == names::TNAME; // the T number is the one that is asked for
    assert_eq!(
        level == Level::Required,
        !instead,
        "{} {variant}",
        param.name
    );
}

fn unit(cycle: &Cycle, param: &Param, row: &[String]) {
    let expected = match row[6].as_str() {
        "active-unit" => Unit::ActiveLength,
        "basic-unit" if param.name == names::VMS => Unit::BasicFeed,
        "basic-unit" => Unit::BasicLength,
        "always-mm" => Unit::Millimetre,
        "degrees" => Unit::Degree,
        _ => Unit::None,
    };
    assert_eq!(param.unit, expected, "{} {}", cycle.name, param.name);
    assert_eq!(
        param.default,
        row[7].parse().ok(),
        "{} {}",
        cycle.name,
        param.name
    );
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
        cycle
            .variants
            .iter()
            .for_each(|variant| has(variant.key.into()));
        cycle.results.iter().for_each(|field| has(field.key.into()));
        for param in cycle.params {
            let labels = param.labels.iter().map(|(_, key)| *key);
            for key in labels.chain([param.key]) {
                has(format!("param-{key}"));
                has(format!("param-{key}-help"));
            }
            param.needs.iter().for_each(|need| has(need.reason.into()));
            match &param.kind {
                Kind::Choice(choices) => choices.iter().for_each(|(_, key)| has((*key).into())),
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

/// Rust files below a folder.
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
    for key in files.iter().flat_map(|file| file.split('"')) {
        let plain = !key.ends_with('-')
            && key
                .chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        if plain
            && ["check-", "need-", "knum-zero-", "knum-mode-"]
                .iter()
                .any(|stem| key.starts_with(stem))
        {
            assert!(words.contains_key(key), "no words for {key}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}
