//! The alarms of every entry against the tables of alarms and messages.

use super::common_rows;
use crate::catalogue::{CYCLES, Cycle, Dialect, nct};
use crate::diagnostic::Code;
use std::collections::BTreeSet;

/// Alarms that an entry names beyond the manual, with the reason in DESIGN.md.
const ADDED: &[Code] = &[Code::Alarm(61334), Code::Alarm(61412), nct::PATH_OBSTRUCTED];

#[test]
fn alarms_are_those_of_the_tables() {
    // oracle: manual, spec/common/alarms_full.tsv (A:15840-15948), spec/common/nct_errors.tsv (C:125-1145)
    let numbers = common_rows("alarms_full.tsv");
    let messages = common_rows("nct_errors.tsv");
    if numbers.is_empty() || messages.is_empty() {
        return;
    }
    let added: BTreeSet<String> = ADDED.iter().copied().map(name).collect();
    for cycle in CYCLES {
        let table: BTreeSet<String> = match cycle.dialect {
            Dialect::Sinumerik => numbers
                .iter()
                .filter(|row| raises(&numbers, &row[2], cycle))
                .map(|row| row[0].clone())
                .collect(),
            Dialect::Nct => messages
                .iter()
                .filter(|row| row[0] == cycle.name)
                .map(|row| row[1].clone())
                .collect(),
        };
        let ours: BTreeSet<String> = cycle.alarms().into_iter().map(name).collect();
        let missing: Vec<_> = table.difference(&ours).collect();
        assert!(missing.is_empty(), "{} lacks {missing:?}", cycle.name);
        let mut more = ours.difference(&table);
        let foreign = more.find(|code| !added.contains(*code));
        assert_eq!(foreign, None, "{} has it too", cycle.name);
    }
}

#[test]
fn what_a_parameter_raises_is_listed() {
    // oracle: self
    for cycle in CYCLES {
        let alarms = cycle.alarms();
        for param in cycle.params {
            let listed = param.alarm.is_none_or(|code| alarms.contains(&code));
            assert!(listed, "{} {} {:?}", cycle.name, param.name, param.alarm);
        }
    }
}

/// Whether the column of sources means this cycle: `all`, `all, except …`, `as 61318`, or a list. A cycle that is named
/// once more after the exceptions has a meaning of its own for the alarm.
fn raises(rows: &[Vec<String>], source: &str, cycle: &Cycle) -> bool {
    if let Some(other) = source.strip_prefix("as ") {
        let row = rows.iter().find(|row| row[0] == other).unwrap();
        return raises(rows, &row[2], cycle);
    }
    let named = source.split_whitespace().filter(|word| *word == cycle.name);
    source.starts_with("all") != (named.count() % 2 == 1)
}

/// An alarm as the tables write it.
fn name(code: Code) -> String {
    match code {
        Code::Alarm(number) => number.to_string(),
        Code::Nct(text) => text.to_owned(),
        Code::Own(number) => panic!("PW{number} is no alarm of a control"),
    }
}
