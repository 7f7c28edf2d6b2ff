//! Parameters: which variant needs which, unit and default.

use super::super::*;
use super::conditions::{level, met};
use super::{covers, rows, sinumerik};
use crate::check::Inputs;
use std::collections::BTreeSet;

#[test]
fn parameters_are_those_of_the_table() {
    // oracle: manual, spec/milling/params.tsv, spec/turning/params.tsv
    let rows = rows("params.tsv");
    for cycle in sinumerik().filter(|_| !rows.is_empty()) {
        let (mut used, mut settings) = (BTreeSet::new(), BTreeSet::new());
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            for name in names_of(&row[1]) {
                match setting(&name) {
                    Some(name) if row[3] != "unused" => drop(settings.insert(name)),
                    Some(_) => {}
                    None => compare(cycle, &name, row, &mut used),
                }
            }
        }
        let ours: BTreeSet<&str> = cycle.params.iter().map(|param| param.name).collect();
        assert_eq!(ours, used, "{}", cycle.name);
        let ours: BTreeSet<&str> = cycle.settings.iter().copied().collect();
        let missing: Vec<_> = settings
            .iter()
            .filter(|one| !ours.contains(one.as_str()))
            .collect();
        assert!(missing.is_empty(), "{} {missing:?}", cycle.name);
    }
}

/// `_CHBIT[2], _SPEED[0..2]` → two names; a comma inside of an index separates nothing.
fn names_of(cell: &str) -> Vec<String> {
    let mut names = vec![String::new()];
    let mut depth = 0;
    for c in cell.replace(" / ", ",").chars() {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        match names.last_mut() {
            Some(last) if c != ',' || depth > 0 => last.push(c),
            _ => names.push(String::new()),
        }
    }
    names.iter().map(|name| name.trim().to_owned()).collect()
}

/// Data of the machine stand in the tables beside the parameters: the bit, or the name of the array.
fn setting(name: &str) -> Option<String> {
    const ARRAYS: &[&str] = &[
        "_SPEED", "_TP", "_TPW", "_TP_CF", "_KB", "_CM", "_MFS", "_MT_COMP", "_MT_EC_R",
        "_MT_EC_L", "_WP", "_EV", "_MV",
    ];
    if name.starts_with("_CHBIT") || name.starts_with("_CBIT") {
        return Some(name.to_owned());
    }
    if let Some(number) = name.strip_prefix("SD ") {
        return Some(format!("SD{}", number.split(' ').next()?));
    }
    let array = name.split('[').next()?;
    ARRAYS.contains(&array).then(|| array.to_owned())
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
    let covered = |one: &&Variant| covers(variants, one.number);
    for variant in cycle.variants.iter().filter(covered) {
        let what = format!("{} {name} {}", cycle.name, variant.number);
        let need = |inputs: &Inputs| param.need(inputs).map(|(level, _)| level);
        let plain = need(&Inputs::new(cycle, variant.number));
        match requirement.split_once(':').unwrap_or((requirement, "")) {
            ("required", _) => assert_eq!(plain, Some(Level::Required), "{what}"),
            ("unused", _) => assert_eq!(plain, None, "{what}"),
            (text, _) if text.starts_with("optional") => {
                assert_eq!(plain, Some(Level::Optional), "{what}")
            }
            ("required-if", condition) => {
                let Some(inputs) = met(condition, cycle, variant.number) else {
                    assert_ne!(plain, Some(Level::Required), "{what}");
                    continue;
                };
                let expected = Some(level(name, condition));
                assert_eq!(need(&inputs), expected, "{what} if {condition}");
            }
            other => panic!("{other:?}"),
        }
    }
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
