//! Which cycle a call with arguments means.

use super::CYCLES;
use super::newer::LISTS;
use crate::catalogue::prelude::*;
use crate::check::listed::{selection, too_many};
use crate::dialect::Dialect;

/// The cycle and the list that a call with so many arguments means; `number` tells what stands at an argument, where it
/// is known. The name of a cycle without arguments is no such call: it takes the data as they are.
pub fn called(
    dialect: Dialect,
    name: &str,
    arguments: usize,
    number: impl Fn(usize) -> Option<f64>,
) -> Option<(&'static Cycle, &'static ArgumentList)> {
    let told = |(index, arg): (usize, &Arg)| match arg {
        Arg::Is(wanted) => number(index) == Some(*wanted as f64),
        _ => true,
    };
    let meant = |list: &&ArgumentList| list.name.eq_ignore_ascii_case(name) && list.args.iter().enumerate().all(told);
    let bare = |cycle: &&Cycle| arguments == 0 && cycle.name.eq_ignore_ascii_case(name);
    let of_control = CYCLES.iter().filter(|cycle| cycle.dialect == dialect && !bare(cycle));
    of_control.copied().find_map(|cycle| Some((cycle, cycle.lists.iter().find(meant)?)))
}

/// The list of newer controls that calls a cycle of this name which the older control does not have, and whether it
/// measures: then it has a variant.
pub fn newer_alone(name: &str) -> Option<(&'static ArgumentList, bool)> {
    let list = LISTS.iter().find(|list| list.name.eq_ignore_ascii_case(name))?;
    let older = CYCLES.iter().any(|cycle| cycle.name == list.name);
    let measures = list.position(names::MVAR).is_some();
    (!older).then_some((list, measures))
}

/// For which argument of a parameterizing call a cycle is chosen, and the numbers that can stand there.
pub fn told_by(name: &str) -> Option<(usize, Vec<i64>)> {
    let lists = CYCLES.iter().flat_map(|cycle| cycle.lists);
    let of_name = lists.filter(|list| list.name.eq_ignore_ascii_case(name));
    let told = of_name.flat_map(|list| list.args.iter().enumerate());
    let told: Vec<(usize, i64)> = told
        .filter_map(|(index, arg)| match arg {
            Arg::Is(number) => Some((index, *number)),
            _ => None,
        })
        .collect();
    let (index, _) = told.first()?;
    Some((*index, told.iter().map(|(_, number)| *number).collect()))
}

/// What is wrong with arguments that no cycle is found for: those of `CYCLE_PARA`, and of a parameterizing call for two
/// cycles whose first argument names neither (B:11767, B:11784, B:11908).
pub fn unmatched(name: &str, count: usize, number: impl Fn(usize) -> Option<f64>) -> Option<Diagnostic> {
    if name == AUXILIARY {
        return too_many(name, AUXILIARY_ARGS.len(), count);
    }
    let (index, numbers) = told_by(name)?;
    let written = number(index)?;
    let known: Vec<(i64, i64)> = numbers.into_iter().map(|one| (one, 0)).collect();
    let wrong = known.iter().all(|one| one.0 as f64 != written);
    wrong.then(|| selection(name, index, written, &known))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entry::{Style, When, names};

    #[test]
    fn selections_add_up_to_the_variant() {
        // oracle: hand
        let list = ArgumentList {
            style: Style::Indirect,
            name: "CYCLE_976",
            when: When::Always,
            base: 1,
            args: &[
                Arg::Select(&[(0, 0), (1, 100_000)]),
                Arg::Param(names::MA),
                Arg::Select(&[(4, 0), (1, 1000), (2, 2000)]),
            ],
            published: &[],
            source: "",
        };
        assert_eq!(list.selections(102_001), Some(vec![1, 2]));
        assert_eq!(list.selections(1), Some(vec![0, 4]));
        assert_eq!(list.selections(2), None);
    }
}
