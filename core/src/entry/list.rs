//! Calls with arguments in brackets, beside the assignments that every cycle takes.

use super::{Cycle, When, names};
use crate::entry::Inputs;
use crate::name::Name;

/// A way to write a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Style {
    /// Assignments, then the call (from SW 6.2, B:12497); NCT: one block of addresses.
    Direct,
    /// `CYCLE_PARA(…)` and a parameterizing call (up to SW 5.4, B:11640-12133).
    Indirect,
    /// Parameter list of newer 840D sl controls (SINUMERIK Operate); see `catalogue::newer`.
    Operate,
}

/// An argument list that calls a cycle.
pub struct ArgumentList {
    /// The call style it belongs to; [`Style::Direct`]: arguments that the cycle takes beside the assignments.
    pub style: Style,
    /// Name as called.
    pub name: &'static str,
    /// Calls that it can express; of a list that is only read none ([`super::NEVER`]).
    pub when: When,
    /// Number of the variant to which the arguments [`Arg::Select`] add; counts where the list has no `_MVAR`.
    pub base: i64,
    /// The arguments in order.
    pub args: &'static [Arg],
    /// Of some arguments the numbers whose meaning is published; of the others any number is taken.
    pub published: &'static [(&'static str, Published)],
    /// Where the order is from.
    pub source: &'static str,
}

/// The numbers of an argument whose meaning is published.
pub enum Published {
    /// These.
    OneOf(&'static [f64]),
    /// From one to another, both included.
    Within(f64, f64),
    /// Programs have these; another one is noted, and counts as on the older control.
    Seen(&'static [f64]),
}

impl Published {
    /// Whether the number is one of them.
    pub fn holds(&self, number: f64) -> bool {
        match self {
            Published::OneOf(numbers) | Published::Seen(numbers) => numbers.contains(&number),
            Published::Within(least, most) => (*least..=*most).contains(&number),
        }
    }
}

/// One argument.
pub enum Arg {
    /// The value of this parameter.
    Param(Name),
    /// The value of this parameter, which leads down, without its sign.
    Down(Name),
    /// A selection: number written, what it adds to the number of the variant.
    Select(&'static [(i64, i64)]),
    /// Tells which cycle is meant: this number stands there.
    Is(i64),
    /// A variable of the program; the parameters `NAME[…]` of the entry are its elements.
    Variable(&'static str),
    /// A variable of the program that takes a result.
    Output(&'static str),
    /// Has no counterpart among our parameters, or its meaning is not known.
    Open,
    /// In the list of a newer control: its name there (empty: none is published), and the parameter with its meaning.
    Newer(&'static str, Option<Name>),
}

impl Arg {
    /// The parameter whose value it takes.
    pub const fn param(&self) -> Option<Name> {
        match self {
            Arg::Param(name) | Arg::Down(name) => Some(*name),
            Arg::Newer(_, param) => *param,
            _ => None,
        }
    }
}

/// `CYCLE_PARA`: parameters that count for all cycles; 0 leaves the datum as it is (B:11734-11753).
pub const AUXILIARY: &str = "CYCLE_PARA";
/// Arguments of `CYCLE_PARA` in order.
pub const AUXILIARY_ARGS: &[Name] = {
    use names::*;
    &[FA, VMS, NMSP, RF, PRNUM, CORA, TZL, TMV, TUL, TLL, TSA, EVNUM, K, TDIF]
};

impl ArgumentList {
    /// A call with arguments beside or instead of assignments, of every variant.
    pub const fn direct(name: &'static str, args: &'static [Arg], source: &'static str) -> ArgumentList {
        ArgumentList { style: Style::Direct, name, when: When::Always, base: 0, args, published: &[], source }
    }

    /// This call with these arguments.
    pub const fn args(self, args: &'static [Arg]) -> ArgumentList {
        ArgumentList { args, ..self }
    }

    /// This call, of whose arguments these numbers are published.
    pub const fn publishing(self, published: &'static [(&'static str, Published)]) -> ArgumentList {
        ArgumentList { published, ..self }
    }

    /// This call with arguments among which selections make the variant: they add to this number.
    pub const fn selecting(self, base: i64, args: &'static [Arg]) -> ArgumentList {
        ArgumentList { base, args, ..self }
    }

    /// Whether calls are written with it, or only read.
    pub fn is_written(&self) -> bool {
        !matches!(self.when, When::Any([]))
    }

    /// Whether the variant is an argument of its own.
    pub fn has_variant(&self, cycle: &Cycle) -> bool {
        cycle.variant_param().is_some_and(|name| self.position(name).is_some())
    }

    /// Which argument takes this parameter.
    pub fn position(&self, name: Name) -> Option<usize> {
        self.args.iter().position(|arg| arg.param() == Some(name))
    }

    /// The name under which a value of an argument is typed: of the parameter with its meaning, else its own.
    pub fn typed_as(&self, argument: &'static str) -> Name {
        let same = |arg: &&Arg| matches!(arg, Arg::Newer(name, _) if *name == argument);
        self.args.iter().find(same).and_then(Arg::param).unwrap_or(Name::new(argument))
    }

    /// Whether programs of newer controls have this number in the argument with the meaning of this parameter.
    pub fn publishes(&self, name: Name, number: f64) -> bool {
        self.published.iter().any(|(argument, numbers)| self.typed_as(argument) == name && numbers.holds(number))
    }

    /// Whether it has an argument of this name.
    pub fn has(&self, argument: &str) -> bool {
        self.args.iter().any(|arg| matches!(arg, Arg::Newer(name, _) if *name == argument))
    }

    /// Whether this parameter is an argument or an element of one.
    pub fn gives(&self, name: Name) -> bool {
        let indexed = |array: &str| name.strip_prefix(array).is_some_and(|rest| rest.starts_with('['));
        let element = |arg: &Arg| matches!(arg, Arg::Variable(array) if indexed(array));
        self.position(name).is_some() || self.args.iter().any(element)
    }

    /// The parameter that takes the variant, and the variant that the selections make, where it has no argument of its
    /// own; `number` tells what stands at an argument, an omitted one is 0.
    pub fn composed(&self, cycle: &Cycle, number: impl Fn(usize) -> Option<f64>) -> Option<(Name, i64)> {
        let name = cycle.variant_param()?;
        let own = self.has_variant(cycle);
        (!own).then(|| Some((name, self.selected(number)?)))?
    }

    /// The selections, each behind the index of its argument.
    pub fn selects(&self) -> impl Iterator<Item = (usize, &'static [(i64, i64)])> {
        self.args.iter().enumerate().filter_map(|(index, arg)| match arg {
            Arg::Select(choices) => Some((index, *choices)),
            _ => None,
        })
    }

    /// What to write for each [`Arg::Select`], in order, so that this variant comes out.
    pub fn selections(&self, variant: i64) -> Option<Vec<i64>> {
        let choices: Vec<_> = self.selects().map(|(_, choices)| choices).collect();
        select(&choices, variant - self.base)
    }

    /// The variant that the selections make; an omitted argument is 0. None: a selection that is not known.
    fn selected(&self, number: impl Fn(usize) -> Option<f64>) -> Option<i64> {
        let mut variant = self.base;
        for (index, choices) in self.selects() {
            let written = number(index)?;
            variant += choices.iter().find(|choice| choice.0 as f64 == written)?.1;
        }
        Some(variant)
    }

    /// The first selection that tells no variant: a number that is none of its choices, or one that is not known.
    pub fn unselected(&self, number: impl Fn(usize) -> Option<f64>) -> Option<(usize, &'static [(i64, i64)])> {
        self.selects().find(|(index, choices)| {
            let written = number(*index);
            !choices.iter().any(|one| Some(one.0 as f64) == written)
        })
    }

    /// Whether it can express a call with these values.
    pub fn fits(&self, inputs: &Inputs) -> bool {
        self.when.holds(inputs) && (self.has_variant(inputs.cycle) || self.selections(inputs.variant).is_some())
    }
}

/// One number of each list of choices so that what they add is `rest`.
fn select(choices: &[&[(i64, i64)]], rest: i64) -> Option<Vec<i64>> {
    let Some((first, others)) = choices.split_first() else { return (rest == 0).then(Vec::new) };
    first.iter().find_map(|(written, adds)| {
        let mut chosen = vec![*written];
        chosen.extend(select(others, rest - adds)?);
        Some(chosen)
    })
}
