//! The measuring variant that values choose, and what is said about a number that is none.

use super::Parsed;
use crate::control::Control;
use crate::entry::{Cycle, DigitGroup, Inputs, Kind, Param, Typed};
use crate::message::Message;

/// Why there is no such variant: two choices that are right alone and not together, where its digits show them.
pub fn cause(cycle: &Cycle, param: &Param, number: f64) -> Message {
    let pair = match param.kind {
        Kind::Variant(groups) => pair(cycle, groups, number as i64),
        _ => None,
    };
    let message = match pair {
        Some([(one, first), (other, second)]) => {
            let message = Message::new("check-variant-pair").text("one", one.key).text("first", first);
            message.text("other", other.key).text("second", second)
        }
        None => Message::new("check-variant"),
    };
    message.number("value", number).text("cycle", cycle.name)
}

/// Number of the variant that typed values choose on this machine; none where they choose none.
pub fn chosen(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<i64> {
    chosen_by(&super::read(cycle, typed, control, &mut Vec::new()), typed)
}

/// Number of the variant that typed values choose, which were read as these inputs; none where they choose none.
pub fn chosen_by(inputs: &Inputs, typed: &Typed) -> Option<i64> {
    let (cycle, number) = (inputs.cycle, inputs.variant);
    let name = cycle.variant_param();
    let given = name.and_then(|name| typed.get(name.as_str()));
    let meant = |text: &String| matches!(super::parse(text), Parsed::Number(one) if one == number as f64);
    let known = cycle.variants.iter().any(|one| one.number == number);
    (known && given.is_none_or(meant)).then_some(number)
}

/// A group of digits, and the key of the name of what it says in a number.
type Chosen = (&'static DigitGroup, &'static str);

/// The first two choices that no variant has together. None: a digit says nothing that can be chosen, or it takes more
/// than two choices to be wrong.
fn pair(cycle: &Cycle, groups: &'static [DigitGroup], number: i64) -> Option<[Chosen; 2]> {
    let chosen = groups.iter().map(|group| Some((group, group.choice(number)?)));
    let all: Vec<Chosen> = chosen.collect::<Option<_>>()?;
    let said: i64 = groups.iter().map(|group| group.value(number) * group.place).sum();
    if said != number {
        return None; // other digits are not 0
    }
    let has = |(group, _): &Chosen, variant: i64| group.value(variant) == group.value(number);
    let refused = |one: &Chosen, other: &Chosen| {
        !cycle.variants.iter().any(|variant| has(one, variant.number) && has(other, variant.number))
    };
    let mut pairs = all.iter().enumerate().flat_map(|(at, one)| all[at + 1..].iter().map(move |other| [*one, *other]));
    pairs.find(|[one, other]| refused(one, other))
}

/// Names the variants that differ from a wrong number in the fewest digits; a number that is far from all gets none.
pub fn hint(cycle: &Cycle, number: f64) -> Message {
    const FAR: u32 = 3;
    let numbers = || cycle.variants.iter().map(|variant| variant.number);
    let apart = |other: i64| differing_digits(number as i64, other);
    let least = numbers().map(apart).min().unwrap_or(FAR);
    if number < 0.0 || least >= FAR {
        return Message::new("check-variant-hint");
    }
    let near: Vec<String> = numbers().filter(|other| apart(*other) == least).map(|other| other.to_string()).collect();
    Message::new("check-variant-near-hint").text("near", near.join(", "))
}

/// How many decimal digits of two numbers are not the same.
fn differing_digits(mut one: i64, mut other: i64) -> u32 {
    let mut count = 0;
    while one != other {
        count += u32::from(one % 10 != other % 10);
        (one, other) = (one / 10, other / 10);
    }
    count
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::{CYCLES, find};
    use crate::dialect::Dialect;
    use std::collections::BTreeMap;

    // oracle: manual B:5066-5084 (the skew is determined in both directions of a hole: one direction cannot tell it)
    #[test]
    fn two_choices_that_do_not_go_together_are_named() {
        let cycle = find(Dialect::Sinumerik, "CYCLE976").unwrap();
        let param = cycle.param("_MVAR").unwrap();
        let said = cause(cycle, param, 11_001.0);
        let args: BTreeMap<&str, _> = said.args.iter().map(|(name, arg)| (*name, arg.clone())).collect();
        assert_eq!(said.key, "check-variant-pair", "{args:?}");
        assert_eq!(cause(cycle, param, 9.0).key, "check-variant", "9 is no choice");
        assert_eq!(cause(cycle, param, -1.0).key, "check-variant");
    }

    // oracle: self (each number that its digits allow and the table of variants does not)
    #[test]
    fn a_pair_that_is_named_is_in_no_variant() {
        let mut named = 0;
        for cycle in CYCLES {
            for param in cycle.params {
                let Kind::Variant(groups) = param.kind else { continue };
                let combined = groups.iter().fold(vec![0], |numbers, group| {
                    let more = |number: &i64| {
                        let number = *number;
                        group.choices.iter().map(move |(value, _)| number + value * group.place)
                    };
                    numbers.iter().flat_map(more).collect::<Vec<i64>>()
                });
                for number in combined {
                    let Some([one, other]) = pair(cycle, groups, number) else { continue };
                    named += 1;
                    let both = cycle.variants.iter().find(|variant| {
                        [one, other].iter().all(|(group, _)| group.value(variant.number) == group.value(number))
                    });
                    assert!(both.is_none(), "{} {number}", cycle.name);
                }
            }
        }
        assert!(named > 20, "{named}");
    }
}
