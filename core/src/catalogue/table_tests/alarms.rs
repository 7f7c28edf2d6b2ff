//! The alarms of every entry against the tables of alarms and messages.

use crate::catalogue::alarms::{ALARMS, stops};
use crate::catalogue::{CYCLES, find, nct};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::Cycle;
use crate::test_data::{Row, data, rows};
use std::collections::BTreeSet;

/// Alarms that an entry names beyond the manual, with the reason in DESIGN.md.
const ADDED: &[Code] = &[
    Code::Alarm(61316),
    Code::Alarm(61321),
    Code::Alarm(61326),
    Code::Alarm(61330),
    Code::Alarm(61334),
    Code::Alarm(61341),
    Code::Alarm(61351),
    Code::Alarm(61401),
    Code::Alarm(61412),
    nct::PATH_OBSTRUCTED,
];
/// What a helper cycle hands back as a number, and the measuring cycle that calls it raises (B:2448); what comes from
/// the cycles of the log that one calls (B:11217, B:11253).
const HANDED_BACK: &[(&str, &[u32])] = &[
    ("CYCLE116", &[61316, 61317]),
    ("CYCLE106", OF_CONTENTS),
    ("CYCLE100", OF_CONTENTS),
    ("CYCLE100", &[61352, 61353, 61354, 61355, 61356, 61357, 61358, 61359, 61360]),
];
/// Raised by CYCLE105.
const OF_CONTENTS: &[u32] = &[61361, 61363, 61370, 61371, 62307, 62308, 62309, 62310, 62311];

#[test]
fn alarms_are_those_of_the_tables() {
    // oracle: manual, tests/data/alarms.tsv (A:15840-15948), tests/data/nct_messages.tsv (C:125-1145)
    let numbers = rows(data!("alarms.tsv"));
    let messages = rows(data!("nct_messages.tsv"));
    let added: BTreeSet<String> = ADDED.iter().copied().map(name).collect();
    for cycle in CYCLES {
        let table: BTreeSet<String> = match cycle.dialect {
            Dialect::Sinumerik => numbers
                .iter()
                .filter(|row| raises(&numbers, row[2], cycle))
                .map(|row| row[0].to_owned())
                .chain(handed_back(cycle))
                .collect(),
            Dialect::Nct => messages
                .iter()
                .filter(|row| super::nct::belongs(row, cycle))
                .map(|row| printed(row[1]).to_owned())
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

/// A message without what the table says about its print: `D TOO SMALL! (printed D KICSI!)`.
fn printed(cell: &str) -> &str {
    cell.split(" (").next().unwrap_or(cell)
}

#[test]
fn the_table_of_alarms_is_that_of_the_manual() {
    // oracle: manual, tests/data/alarms.tsv (A:15840-15948): number, effect, programs that are no measuring cycle
    let rows = rows(data!("alarms.tsv"));
    let table: Vec<(Code, bool, BTreeSet<&str>, String)> = rows
        .iter()
        .map(|row| {
            let helpers = row[2].split_whitespace().filter(|word| is_helper(word));
            let helpers = helpers.filter(|word| find(Dialect::Sinumerik, word).is_none());
            let stops = match row[1] {
                "stops" => true,
                "shows" => false,
                other => panic!("{other}"),
            };
            let code = Code::Alarm(row[0].parse().unwrap());
            (code, stops, helpers.collect(), row[3].to_owned())
        })
        .collect();
    let ours: Vec<(Code, bool, BTreeSet<&str>, String)> = ALARMS
        .iter()
        .filter(|alarm| matches!(alarm.code, Code::Alarm(_)))
        .map(|alarm| {
            let programs = alarm.programs.iter().copied().collect();
            let place = alarm.source.to_owned();
            (alarm.code, stops(alarm.code), programs, place)
        })
        .collect();
    assert_eq!(ours, table);
    assert_eq!(ours.len(), 95);
}

#[test]
fn the_messages_of_the_macros_have_the_effect_of_the_table() {
    // oracle: manual, tests/data/nct_messages.tsv (C:125-1145)
    for row in rows(data!("nct_messages.tsv")) {
        let known = ALARMS.iter().find(|alarm| name(alarm.code) == row[1]);
        if let Some(alarm) = known {
            assert_eq!(stops(alarm.code), row[2] == "error", "{row:?}");
        }
    }
}

#[test]
fn what_an_entry_raises_stands_in_the_table_of_alarms_once() {
    // oracle: self
    let table: Vec<Code> = ALARMS.iter().map(|alarm| alarm.code).collect();
    let distinct: BTreeSet<String> = table.iter().copied().map(name).collect();
    assert_eq!(distinct.len(), table.len());
    for cycle in CYCLES {
        for code in cycle.alarms() {
            assert!(table.contains(&code), "{} {code:?}", cycle.name);
        }
    }
    for code in table {
        let raised = CYCLES.iter().any(|cycle| cycle.alarms().contains(&code));
        assert!(raised || matches!(code, Code::Alarm(_)), "{code:?}");
    }
}

/// Whether a program of the column of sources is no measuring cycle: a helper of the cycles, or measuring in JOG.
fn is_helper(word: &str) -> bool {
    word.starts_with("E_") || word.starts_with("CYCLE1")
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

fn handed_back(cycle: &Cycle) -> impl Iterator<Item = String> {
    let of_cycle = HANDED_BACK.iter().filter(|(name, _)| *name == cycle.name);
    of_cycle.flat_map(|(_, numbers)| numbers.iter().map(u32::to_string))
}

/// Whether the column of sources means this cycle: `all` (that measure), `all, except …`, `as 61318`, or a list. A
/// cycle that is named once more after the exceptions has a meaning of its own for the alarm.
fn raises(rows: &[Row], source: &str, cycle: &Cycle) -> bool {
    if let Some(other) = source.strip_prefix("as ") {
        let row = rows.iter().find(|row| row[0] == other).unwrap();
        return raises(rows, row[2], cycle);
    }
    let named = source.split_whitespace().filter(|word| *word == cycle.name);
    let all = source.starts_with("all") && cycle.purpose.probe.measures();
    all != (named.count() % 2 == 1)
}

/// An alarm as the tables write it.
fn name(code: Code) -> String {
    match code {
        Code::Alarm(number) => number.to_string(),
        Code::Nct(text) => text.to_owned(),
        Code::Own(number) => panic!("PW{number} is no alarm of a control"),
    }
}
