//! The digits of a measuring variant. Not every combination of digits is one (B:5084, B:8256), so each choice says to
//! which variant it leads, and what leaves no choice is not asked.

use super::codes;
use super::fields::Group;
use crate::entry::{DigitGroup, Inputs};

/// Groups of digits and their values in this number. In a variant each group offers what goes with the groups before
/// it; one with a single value is left out. A number that is no variant shows everything, so that it can be fixed.
pub fn groups(inputs: &Inputs, groups: &[DigitGroup], number: i64) -> Vec<Group> {
    let cycle = inputs.cycle;
    let numbers: Vec<i64> = cycle.variants.iter().map(|variant| variant.number).collect();
    let is_variant = numbers.contains(&number);
    let mut shown = Vec::new();
    for (index, mut group) in groups.iter().map(|group| codes::read(group, group.place, number, inputs)).enumerate() {
        if is_variant {
            let going = numbers.iter().filter(|other| agree(&groups[..index], number, **other));
            let offered: Vec<i64> = going.map(|other| groups[index].value(*other)).collect();
            group.choices.retain(|choice| offered.contains(&choice.value));
            if group.choices.len() == 1 {
                continue;
            }
        }
        let leads = group.choices.iter();
        group.leads = leads.filter_map(|choice| nearest(&numbers, groups, index, choice.value, number)).collect();
        shown.push(group);
    }
    shown
}

fn agree(groups: &[DigitGroup], one: i64, other: i64) -> bool {
    groups.iter().all(|group| group.value(one) == group.value(other))
}

/// The variant with this digit in the group at `index` that keeps most of the number, earlier groups before later ones.
fn nearest(numbers: &[i64], groups: &[DigitGroup], index: usize, value: i64, number: i64) -> Option<i64> {
    let with = numbers.iter().copied().filter(|other| groups[index].value(*other) == value);
    let differs = |bits: u64, (other, group): (i64, &DigitGroup)| {
        bits << 1 | u64::from(group.value(other) != group.value(number))
    };
    with.min_by_key(|other| groups.iter().map(|group| (*other, group)).fold(0, differs))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

    use super::*;
    use crate::catalogue::CYCLES;
    use crate::check;
    use crate::control::{MachineSort, Units, delivery_in};
    use crate::entry::{Cycle, Kind, names};

    /// A call of which the variant alone is given, on a machine as delivered.
    fn inputs(cycle: &'static Cycle, number: i64) -> Inputs {
        let typed = cycle.variant_param().map(|name| (name.to_string(), number.to_string()));
        check::read(cycle, &typed.into_iter().collect(), &delivery_in(cycle.dialect, Units::Metric), &mut Vec::new())
    }

    /// The groups of a cycle for a number.
    fn of(cycle: &'static Cycle, number: i64) -> Vec<Group> {
        let param = cycle.params.iter().find(|param| matches!(param.kind, Kind::Variant(_)));
        match param.map(|param| &param.kind) {
            Some(Kind::Variant(digits)) => groups(&inputs(cycle, number), digits, number),
            _ => Vec::new(),
        }
    }

    fn calibration(number: i64) -> Vec<(String, Vec<(i64, i64)>)> {
        let cycle = CYCLES.iter().find(|cycle| cycle.name == "CYCLE976").unwrap();
        let pairs = |group: &Group| {
            let values = group.choices.iter().map(|choice| choice.value);
            values.zip(group.leads.iter().copied()).collect()
        };
        let groups = of(cycle, number);
        groups.iter().map(|group| (group.label.key.to_string(), pairs(group))).collect()
    }

    #[test]
    fn what_leaves_no_choice_is_not_asked() {
        // oracle: manual B:5066-5084, B:5222-5234, B:15595: a surface knows the length alone, an unknown centre always
        // needs four directions, one direction tells neither ball nor skew
        let keys = |number: i64| calibration(number).into_iter().map(|(key, _)| key).collect::<Vec<_>>();
        assert_eq!(keys(0), ["calibrate-place", "calibrate-skew"]);
        assert_eq!(keys(8), ["calibrate-place", "calibrate-ball", "calibrate-skew", "calibrate-angle"]);
        assert_eq!(keys(101_001), ["calibrate-place", "calibrate-directions", "calibrate-angle"]);
        assert_eq!(keys(110_101).len(), 5);
    }

    #[test]
    fn a_choice_keeps_what_goes_with_it() {
        // oracle: manual B:5066-5084
        let leads = |number: i64, place: usize| calibration(number)[place].1.clone();
        assert_eq!(leads(110_101, 0), [(1, 110_101), (8, 110_108), (0, 10_000)]);
        assert_eq!(leads(110_101, 1), [(0, 110_101), (1, 101_001), (2, 112_101)]);
        assert_eq!(leads(0, 0), [(1, 1), (8, 8), (0, 0)]);
    }

    #[test]
    fn a_number_that_is_no_variant_shows_all_its_digits() {
        // oracle: hand
        assert_eq!(calibration(110_100).len(), 5);
        assert_eq!(calibration(110_100)[2].1, [(0, 10_000), (1, 110_101)]);
    }

    #[test]
    fn every_choice_leads_to_a_variant_and_every_variant_can_be_chosen() {
        // oracle: self, over all cycles
        for cycle in CYCLES {
            let numbers = cycle.variants.iter().map(|variant| variant.number);
            let numbers: Vec<i64> = numbers.collect();
            for number in &numbers {
                for group in of(cycle, *number) {
                    assert_eq!(group.choices.len(), group.leads.len(), "{} {number}", cycle.name);
                    assert!(group.leads.iter().all(|lead| numbers.contains(lead)));
                    assert!(group.leads.contains(number), "{} {number}", cycle.name);
                }
            }
            let Some(first) = numbers.first().filter(|first| !of(cycle, **first).is_empty()) else { continue };
            let mut reached = vec![*first];
            let mut next = 0;
            while let Some(number) = reached.get(next).copied() {
                next += 1;
                let leads = of(cycle, number).into_iter().flat_map(|group| group.leads);
                let new: Vec<i64> = leads.filter(|lead| !reached.contains(lead)).collect();
                reached.extend(new);
                reached.dedup();
            }
            assert!(numbers.iter().all(|number| reached.contains(number)), "{}", cycle.name);
        }
    }

    #[test]
    fn digits_that_have_no_effect_are_not_asked_for() {
        // oracle: manual B:1307 (a mean value, which _K weights, with tool offset alone), B:6748 (points of a circle),
        // B:15555 (no type of a probe in a turret)
        for cycle in CYCLES {
            for variant in cycle.variants {
                let inputs = inputs(cycle, variant.number);
                let asked = |param: &&crate::entry::Param| param.need(&inputs).is_some();
                let digits = cycle.params.iter().filter(asked).filter_map(|param| match &param.kind {
                    Kind::Digits(groups) => Some(codes::groups(groups, 0, &inputs)),
                    _ => None,
                });
                let keys: Vec<String> = digits.flatten().map(|group| group.label.key.to_string()).collect();
                let shows = |key: &str| keys.iter().any(|one| one == key);
                let name = format!("{} {}", cycle.name, variant.number);
                assert_eq!(shows("evnum-mean"), inputs.uses(names::K), "{name}");
                assert_eq!(shows("prnum-points"), cycle.name == "CYCLE979" && inputs.uses(names::INCA), "{name}");
                assert!(!shows("prnum-type") || cycle.purpose.machine != MachineSort::Turning, "{name}");
            }
        }
    }
}
