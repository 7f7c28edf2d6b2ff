//! Argument lists against the tables of the parameterizing calls.

use super::super::*;
use super::common_rows;
use std::collections::BTreeMap;

#[test]
fn parameterizing_calls_are_those_of_the_table() {
    // oracle: manual, spec/common/support_calls.tsv
    let mut table: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for row in common_rows("support_calls.tsv") {
        table
            .entry(row[0].clone())
            .or_default()
            .push(row[2].clone());
    }
    if table.is_empty() {
        return;
    }
    assert_eq!(table[list::AUXILIARY], list::AUXILIARY_ARGS);
    for cycle in CYCLES {
        for list in cycle
            .lists
            .iter()
            .filter(|list| list.style == Style::Indirect)
        {
            let rows = &table[list.name];
            assert_eq!(list.args.len(), rows.len(), "{}", list.name);
            for (arg, row) in list.args.iter().zip(rows) {
                match arg {
                    Arg::Param(name) | Arg::Down(name) => assert_eq!(name, row, "{}", list.name),
                    Arg::Select(_) | Arg::Is(_) => {
                        assert!(row.starts_with("(selection"), "{} {row}", list.name);
                    }
                    Arg::Open => {
                        let ours = cycle.param(row);
                        assert!(ours.is_none(), "{} {row} of {}", list.name, cycle.name);
                    }
                    Arg::Variable(_) | Arg::Output(_) => panic!("{} {row}", list.name),
                }
            }
        }
    }
}
