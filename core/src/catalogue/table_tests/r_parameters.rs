//! R parameters of the 840C against the tables of the manual.

use super::super::r_parameters::{Called, called, numbers, printed};
use super::*;
use crate::entry::Cycle;
use std::collections::BTreeMap;

/// What the table says of an R parameter in a variant: the row that names it, else that for all others.
fn row<'a>(rows: &'a [&Row], variant: i64) -> Option<&'a Row> {
    let rest = |row: &&&Row| ["all", "else"].contains(&row[3]);
    let named = |row: &&&Row| !rest(row) && covers(row[3], variant);
    rows.iter().find(named).or_else(|| rows.iter().find(rest)).copied()
}

// oracle: manual, tests/data/r_parameters.tsv (which names are printed beside each R parameter; which of them the
// variant asks for follows from the tables of the cycles)
#[test]
fn r_parameters_are_those_of_the_table() {
    let rows = rows(data!("r_parameters.tsv"));
    let mut table: BTreeMap<(&str, u16), Vec<&Row>> = BTreeMap::new();
    for row in &rows {
        table.entry((row[0], row[1][1..].parse().unwrap())).or_default().push(row);
    }
    let cycles: BTreeSet<&str> = rows.iter().map(|row| row[0]).collect();
    for cycle in CYCLES {
        let today: Option<&Cycle> = called(&cycle.name.replace("CYCLE", "L"));
        assert_eq!(today.is_some(), cycles.contains(cycle.name), "{}", cycle.name);
    }
    let mut wrong = Vec::new();
    for name in cycles {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        for number in numbers() {
            let Some(rows) = table.get(&(name, number)) else { continue };
            let names: BTreeSet<&str> = printed(cycle, number).map(|name| name.as_str()).collect();
            assert_eq!(names, rows[0][2].split(' ').collect(), "{name} R{number}");
            for variant in cycle.variants {
                let Some(row) = row(rows, variant.number) else { continue };
                let meant = Called::of(cycle, Some(variant.number as f64)).meant(number);
                let found = match &meant[..] {
                    [] => "-",
                    [one] => one.as_str(),
                    _ => "?",
                };
                if found != row[4] {
                    wrong.push(format!("{name} {} R{number}: {found}, table {}", variant.number, row[4]));
                }
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}
