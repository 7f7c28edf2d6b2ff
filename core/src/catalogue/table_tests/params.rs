//! Parameters: which variant needs which, unit and default.

use super::cells::with_condition;
use super::conditions::{level, met};
use super::results::row_name;
use super::{Row, allowed, covers, data, of_the_call, refused, rows, tabled};
use crate::entry::{Cycle, Inputs, Kind, Level, Param, ProbeUse, Unit, Variant, names};
use std::collections::BTreeSet;

#[test]
fn parameters_are_those_of_the_table() {
    // oracle: manual, tests/data/parameters.tsv
    let rows = rows(data!("parameters.tsv"));
    for cycle in tabled() {
        let (mut used, mut settings) = (BTreeSet::new(), BTreeSet::new());
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            for name in names_of(row[1]) {
                if is_result(cycle, &name) {
                    continue;
                }
                match setting(&name) {
                    Some(name) if row[3] != "unused" => drop(settings.insert(name)),
                    Some(_) => {}
                    None => compare(cycle, &name, row, &mut used),
                }
            }
        }
        let ours: BTreeSet<&str> = of_the_call(cycle).map(|param| param.name.as_str()).collect();
        assert_eq!(ours, used, "{}", cycle.name);
        for param in of_the_call(cycle) {
            unused_elsewhere(cycle, param, &rows);
        }
        let ours: BTreeSet<&str> = cycle.settings.iter().copied().collect();
        let missing: Vec<_> = settings.iter().filter(|one| !ours.contains(one.as_str())).collect();
        assert!(missing.is_empty(), "{} {missing:?}", cycle.name);
    }
}

/// A variant that no row names does not use the parameter.
fn unused_elsewhere(cycle: &'static Cycle, param: &Param, rows: &[Row]) {
    let names = |row: &&Row| row[0] == cycle.name && names_of(row[1]).iter().any(|name| param.name == name.as_str());
    let rows: Vec<&Row> = rows.iter().filter(names).collect();
    for variant in cycle.variants {
        let named = |row: &&Row| covers(with_condition(row[2]).0, variant.number);
        if !rows.iter().any(named) {
            let need = param.need(&Inputs::new(cycle, variant.number));
            // `2 outside`, `2 inside`: the start position decides, which a form does not know (B:11136).
            let zone = [names::SZA, names::SZO].contains(&param.name);
            let by_position = cycle.name == "CYCLE994" && variant.number == 2 && zone;
            let expected = by_position.then_some(Level::Optional);
            let what = format!("{} {} {}", cycle.name, param.name, variant.number);
            assert_eq!(need.map(|(level, _)| level), expected, "{what}");
        }
    }
}

/// What a helper cycle hands back stands among the parameters too; it is compared with the results.
fn is_result(cycle: &Cycle, name: &str) -> bool {
    cycle.purpose.probe == ProbeUse::None && cycle.results.iter().any(|field| row_name(field) == name)
}

/// `_CHBIT[2], _SPEED[0..2]` → four names; a comma inside of an index separates nothing.
pub fn names_of(cell: &str) -> Vec<String> {
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
    names.iter().flat_map(|name| elements(name.trim())).collect()
}

/// `_SETV[0..2]` → its three elements; `_SETPOINT[3,3]`, which tells a size → all nine.
fn elements(name: &str) -> Vec<String> {
    if let Some(array) = name.strip_suffix("[3,3]") {
        let element = |at: usize| format!("{array}[{},{}]", at / 3, at % 3);
        return (0..9).map(element).collect();
    }
    let range = name.split_once('[').and_then(|(array, index)| {
        let (from, to) = index.trim_end_matches(']').split_once("..")?;
        Some((array, from.parse::<u32>().ok()?, to.parse::<u32>().ok()?))
    });
    match range {
        Some((array, from, to)) => (from..=to).map(|i| format!("{array}[{i}]")).collect(),
        None => vec![name.to_owned()],
    }
}

/// Data of the machine stand in the tables beside the parameters: the bit, or the name of the array.
fn setting(name: &str) -> Option<String> {
    const ARRAYS: &[&str] = &[
        "_SPEED", "_TP", "_TPW", "_TP_CF", "_KB", "_CM", "_MFS", "_MT_COMP", "_MT_EC_R", "_MT_EC_L", "_WP", "_EV",
        "_MV",
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
fn compare(cycle: &'static Cycle, name: &str, row: &Row, used: &mut BTreeSet<&'static str>) {
    let (variants, of_cell) = with_condition(row[2]);
    let (requirement, of_row) = row[3].split_once(':').unwrap_or((row[3], ""));
    let condition = if of_cell.is_empty() { of_row } else { of_cell };
    let Some(param) = cycle.params.iter().find(|param| param.name == name) else {
        assert_eq!(requirement, "unused", "{} {name}", cycle.name);
        return;
    };
    let level = level(name, requirement, condition);
    if level.is_some() {
        used.insert(param.name.as_str());
        default(cycle, param, row);
        kind(cycle, param, row[4]);
    }
    let covered = |one: &&Variant| covers(variants, one.number);
    for variant in cycle.variants.iter().filter(covered) {
        let what = format!("{} {name} {} if {condition}", cycle.name, variant.number);
        let need = |inputs: &Inputs| param.need(inputs).map(|(level, _)| level);
        let ways = met(condition, cycle, variant.number);
        for inputs in &ways {
            assert_eq!(need(inputs), level, "{what}");
            if level.is_some() {
                assert_eq!(param.unit_with(inputs), unit(param, row), "{what}");
            }
        }
        if ways.is_empty() {
            let plain = need(&Inputs::new(cycle, variant.number));
            assert_ne!(plain, Some(Level::Required), "{what}");
        }
        if level.is_some() {
            for inputs in &ways {
                compare_allowed(cycle, param, inputs, row[5]);
            }
        }
    }
}

/// Unit of a row.
fn unit(param: &Param, row: &Row) -> Unit {
    match row[6] {
        "active-unit" => Unit::ActiveLength,
        "basic-unit" if [names::VMS, names::RF].contains(&param.name) => Unit::BasicFeed,
        "basic-unit" => Unit::BasicLength,
        "always-mm" => Unit::Millimetre,
        "degrees" => Unit::Degree,
        _ => Unit::None,
    }
}

fn default(cycle: &Cycle, param: &Param, row: &Row) {
    // A delivered value that the cycle refuses (_RF=0) is none.
    let delivered = row[7].parse().ok();
    let default = delivered.filter(|value| param.range.contains(*value));
    assert_eq!(param.default, default, "{} {}", cycle.name, param.name);
}

fn kind(cycle: &Cycle, param: &Param, cell: &str) {
    let fits = match (cell, &param.kind) {
        ("STRING[32]", Kind::Text(most)) => *most == 32,
        (_, Kind::Text(_)) => cell.contains("by reference"),
        (_, Kind::Real) => cell.starts_with("REAL"),
        _ => cell.starts_with("INT") || cell.starts_with("REAL"),
    };
    assert!(fits, "{} {} {cell}", cycle.name, param.name);
}

/// Values at the end of what is allowed and beside it, and the alarm for the latter where the table names one.
fn compare_allowed(cycle: &'static Cycle, param: &Param, inputs: &Inputs, cell: &str) {
    // How many probes there are the data of the machine say.
    let Some((allowed, alarm)) = allowed::allowed(cell).filter(|_| param.name != names::PRNUM) else { return };
    let others: Vec<(&str, String)> = inputs
        .numbers
        .iter()
        .filter(|(name, _)| **name != param.name)
        .map(|(name, value)| (name.as_str(), value.to_string()))
        .collect();
    let codes = |value: f64| {
        let value = value.to_string();
        let mut values: Vec<(&str, &str)> = others.iter().map(|(name, value)| (*name, value.as_str())).collect();
        values.push((param.name.as_str(), &value));
        refused(cycle, inputs.variant, &values)
    };
    let what = |value| format!("{} {} {} {value} {cell}", cycle.name, param.name, inputs.variant);
    let right = allowed.right();
    if narrowed(cycle, param, inputs.variant) {
        let some = right.iter().any(|value| codes(*value).is_empty());
        assert!(some, "{} {} {cell}", cycle.name, param.name);
    } else {
        for value in right {
            assert_eq!(codes(value), [], "{}", what(value));
        }
    }
    for value in allowed.wrong() {
        let codes = codes(value);
        assert!(!codes.is_empty(), "{}", what(value));
        if let Some(alarm) = alarm {
            assert!(codes.contains(&alarm), "{} {codes:?}", what(value));
        }
    }
}

#[test]
fn an_angle_is_read_as_nothing_else() {
    // oracle: self: what the table calls degrees is read as an angle, all else as a number
    let stops = |read: &dyn Fn() -> f64| std::panic::catch_unwind(std::panic::AssertUnwindSafe(read)).is_err();
    for cycle in tabled() {
        let inputs = Inputs::new(cycle, cycle.variants[0].number);
        for param in cycle.params {
            let angle = param.unit == Unit::Degree;
            assert_eq!(stops(&|| inputs.number(param.name)), angle, "{}", param.name);
            assert_eq!(stops(&|| inputs.degrees(param.name).0), !angle, "{}", param.name);
        }
    }
}

/// Whether another place allows a part only of what a row does: the axis in which the radius lies (B:9279), measuring
/// axes in the plane (B:7582).
fn narrowed(cycle: &Cycle, param: &Param, variant: i64) -> bool {
    let axis = param.name == names::MA;
    match cycle.name {
        "CYCLE982" => axis && matches!(variant / 1000 % 10, 1 | 2),
        "CYCLE998" => axis && variant == 1105,
        _ => false,
    }
}
