//! Argument lists against the tables of the parameterizing calls.

use super::super::*;
use crate::dialect::Dialect;
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, Cycle, Style};
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
                    Arg::Variable(_) | Arg::Output(_) | Arg::Newer(_) => {
                        panic!("{} {row}", list.name)
                    }
                }
            }
        }
    }
}

/// Name of a list, number of its arguments, what stands at some places, counted from 1.
type Published = (&'static str, usize, &'static [(usize, &'static str)]);

// oracle: peer (number of arguments and places in the published lists of the calls; CYCLE977, CYCLE978 and CYCLE998
// agree with programs that run on newer controls, argument by argument)
#[test]
fn lists_of_newer_controls_have_the_published_arguments() {
    let published: [Published; 12] = [
        ("CYCLE961", 22, &[(1, "_MVAR"), (13, "S_SETV9"), (14, "_STA1"), (16, "_ID"), (17, "_FA"), (22, "_AMODE")]),
        ("CYCLE971", 22, &[(4, "_MA"), (9, "_VMS"), (13, "_MFS[1]"), (14, "_MFS[0]"), (19, "_EVNUM")]),
        ("CYCLE973", 13, &[(2, "_PRNUM"), (4, "_SETVAL"), (7, "_FA"), (10, "_NMSP")]),
        ("CYCLE974", 23, &[(3, "S_KNUM1"), (5, "_SETVAL"), (9, "_STA1"), (18, "_K"), (23, "_DP")]),
        ("CYCLE976", 14, &[(3, "_SETVAL"), (5, "_MA"), (10, "_STA1"), (14, "_AMODE")]),
        (
            "CYCLE977",
            30,
            &[(3, "S_KNUM1"), (8, "_FA"), (11, "_ID"), (16, "_TNAME"), (18, "_TZL"), (24, "_EVNUM"), (28, "S_XM")],
        ),
        ("CYCLE978", 23, &[(8, "_MA"), (9, "S_MD"), (11, "_TNAME"), (14, "_TDIF"), (19, "_EVNUM")]),
        ("CYCLE979", 27, &[(8, "_CPA"), (11, "_INCA"), (21, "_EVNUM"), (25, "S_MPVAL1")]),
        ("CYCLE982", 18, &[(4, "_MA"), (11, "_CORA"), (15, "_EVNUM")]),
        ("CYCLE994", 24, &[(7, "_SZA"), (9, "_FA"), (19, "_K"), (24, "_DP")]),
        ("CYCLE997", 22, &[(9, "_SETV[0]"), (17, "_SETV[8]"), (18, "_TNVL"), (19, "_NMSP")]),
        ("CYCLE998", 20, &[(3, "_RA"), (10, "_MA"), (12, "_ID"), (13, "_SETV[0]"), (18, "_EVNUM"), (20, "_AMODE")]),
    ];
    let newer = |cycle: &&&Cycle| cycle.lists.iter().any(|list| list.style == Style::Operate);
    assert_eq!(CYCLES.iter().filter(newer).count(), published.len());
    for (name, count, places) in published {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        let mut lists = cycle.lists.iter();
        let list = lists.find(|list| list.style == Style::Operate).unwrap();
        assert_eq!(list.args.len(), count, "{name}");
        let names: Vec<&str> = list
            .args
            .iter()
            .map(|arg| match arg {
                Arg::Param(name) => {
                    assert!(cycle.param(name).is_some(), "{name} of {}", cycle.name);
                    name.as_str()
                }
                Arg::Newer(name) => *name,
                _ => panic!("{name}"),
            })
            .collect();
        for (place, argument) in places {
            assert_eq!(names[place - 1], *argument, "{name} {place}");
        }
        assert!(cycle.params.iter().all(|param| names.iter().filter(|one| **one == param.name).count() < 2));
    }
}
