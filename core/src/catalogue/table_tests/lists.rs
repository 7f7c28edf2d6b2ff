//! Argument lists against the tables of the parameterizing calls.

use super::super::*;
use crate::catalogue::newer::{LISTS, arguments::Argument};
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, Param, Style};
use crate::test_data::{data, rows};
use std::collections::BTreeMap;

#[test]
fn parameterizing_calls_are_those_of_the_table() {
    // oracle: manual, tests/data/support_calls.tsv; `?` is a selection, which the form makes of several fields
    let rows = rows(data!("support_calls.tsv"));
    let table: BTreeMap<&str, Vec<&str>> =
        rows.iter().map(|row| (row[0], row[1].split(' ').collect::<Vec<_>>())).collect();
    let ours: Vec<&str> = AUXILIARY_ARGS.iter().map(|name| name.as_str()).collect();
    assert_eq!(table[AUXILIARY], ours);
    for cycle in CYCLES {
        for list in cycle.lists.iter().filter(|list| list.style == Style::Indirect) {
            let rows = &table[list.name];
            assert_eq!(list.args.len(), rows.len(), "{}", list.name);
            for (arg, row) in list.args.iter().zip(rows) {
                match arg {
                    Arg::Param(name) | Arg::Down(name) => assert_eq!(name.as_str(), *row, "{}", list.name),
                    Arg::Select(_) | Arg::Is(_) => {
                        assert_eq!(*row, "?", "{}", list.name);
                    }
                    Arg::Open => {
                        let ours = cycle.param(row);
                        assert!(ours.is_none(), "{} {row} of {}", list.name, cycle.name);
                    }
                    Arg::Variable(_) | Arg::Output(_) | Arg::Newer(..) => {
                        panic!("{} {row}", list.name)
                    }
                }
            }
        }
    }
}

// oracle: peer, tests/data/newer_lists.tsv (the published lists; CYCLE977, CYCLE978 and CYCLE998 agree with programs that
// run on newer controls, argument by argument)
#[test]
fn lists_of_newer_controls_have_the_published_arguments() {
    let rows = rows(data!("newer_lists.tsv"));
    let table: BTreeMap<&str, Vec<&str>> =
        rows.iter().map(|row| (row[0], row[1].split(' ').map(|name| name.trim_matches('?')).collect())).collect();
    assert_eq!(LISTS.len(), table.len());
    for list in &LISTS {
        let names: Vec<&str> = Argument::all(list).map(|one| one.name).collect();
        assert_eq!(names, table[list.name], "{}", list.name);
    }
    for cycle in CYCLES {
        for list in cycle.lists.iter().filter(|list| list.style == Style::Operate) {
            let named = LISTS.iter().find(|one| one.name == cycle.name).unwrap();
            assert!(list.args.iter().map(Arg::param).eq(named.args.iter().map(Arg::param)), "{}", cycle.name);
            let taken = |param: &Param| list.args.iter().filter(|arg| arg.param() == Some(param.name)).count();
            assert!(cycle.params.iter().all(|param| taken(param) < 2), "{}", cycle.name);
        }
    }
}
