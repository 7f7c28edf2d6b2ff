//! Numbers whose digits are choices: `_MVAR`, `_PRNUM`, `_EVNUM`, and `_KNUM` by what it corrects.

use super::fields::{Choice, Entry, Group};
use crate::catalogue::newer::variant_key;
use crate::check::{Target, newer, target};
use crate::control::Control;
use crate::entry::{ArgumentList, Cycle, DigitGroup, Inputs, Param};
use crate::evaluate::knum;
use crate::message::Message;

/// Named numbers.
pub fn choices(list: &[(i64, &'static str)]) -> Vec<Choice> {
    list.iter().map(|(value, key)| Choice { value: *value, label: Message::new(*key) }).collect()
}

/// The measuring variants of a cycle.
pub fn variants(cycle: &Cycle) -> Vec<Choice> {
    cycle.variants.iter().map(|variant| Choice { value: variant.number, label: Message::new(variant.key) }).collect()
}

/// The measuring variants of a cycle of which this list is known.
pub fn known_variants(cycle: &'static Cycle, list: &ArgumentList) -> Vec<Choice> {
    let known = cycle.variants.iter().filter(|one| list.when.holds(&Inputs::new(cycle, one.number)));
    known.map(|one| Choice { value: one.number, label: Message::new(variant_key(one.key)) }).collect()
}

/// Groups of digits that have an effect with these inputs, with what they are in this number.
pub fn groups(groups: &[DigitGroup], number: i64, inputs: &Inputs) -> Vec<Group> {
    let asked = groups.iter().filter(|group| group.when.holds(inputs));
    asked.map(|group| read(group, group.place, number, inputs)).collect()
}

/// A group with its lowest digit at this place.
pub fn read(group: &DigitGroup, place: i64, number: i64, inputs: &Inputs) -> Group {
    Group {
        label: Message::new(group.key),
        place,
        digits: group.digits,
        value: DigitGroup { place, ..*group }.value(number),
        choices: choices(&group.choices_with(inputs)),
        leads: Vec::new(),
    }
}

/// `_KNUM`: digits of a tool offset, or a list of zero offsets (B:1894-2029).
pub fn knum(param: &Param, inputs: &Inputs, control: &Control) -> Entry {
    let number = inputs.given(param.name).unwrap_or(0.0) as i64;
    match target(param, inputs) {
        Target::Zero => Entry::Choice { choices: zero_offsets() },
        Target::Tool => Entry::Digits { digits: tool_digits(number, knum::five_digit_edges(control), inputs) },
    }
}

/// The D number, with up to three digits.
pub const EDGE: DigitGroup = DigitGroup::number("knum-edge", 1, 3);

/// The digit above it: length or radius.
pub const KIND: DigitGroup =
    DigitGroup::one("knum-kind", 1000, &[(0, "knum-kind-axis"), (1, "knum-kind-length"), (2, "knum-kind-radius")]);

/// The digits above the D number, their places for D numbers of three digits (B:1902-1926).
const ABOVE_EDGE: &[DigitGroup] = &[
    KIND,
    DigitGroup::one("knum-sign", 10_000, &[(0, "knum-sign-normal"), (1, "knum-sign-inverted")]),
    DigitGroup::one("knum-quantity", 100_000, QUANTITIES),
    DigitGroup::one("knum-mode", 1_000_000, MODES),
];
const QUANTITIES: &[(i64, &str)] = &[
    (0, "knum-quantity-kind"),
    (1, "knum-quantity-l1"),
    (2, "knum-quantity-l2"),
    (3, "knum-quantity-l3"),
    (4, "knum-quantity-radius"),
];
const MODES: &[(i64, &str)] =
    &[(0, "knum-mode-tool"), (1, "knum-mode-location"), (2, "knum-mode-environment"), (3, "knum-mode-both")];

/// With D numbers of five digits all others move by two (B:2009-2029).
fn tool_digits(number: i64, five: bool, inputs: &Inputs) -> Vec<Group> {
    let (edge_digits, shift) = if five { (5, 100) } else { (3, 1) };
    let edge = read(&DigitGroup { digits: edge_digits, ..EDGE }, 1, number, inputs);
    let above = ABOVE_EDGE.iter().map(|group| read(group, group.place * shift, number, inputs));
    std::iter::once(edge).chain(above).collect()
}

/// Every target of a zero offset (B:1930-1965).
fn zero_offsets() -> Vec<Choice> {
    let mut choices = choices(&[(0, "knum-zero-none"), (9999, "knum-zero-active")]);
    choices.extend((1..=99).map(|number| {
        let name = if number <= 4 { 53 + number } else { 500 + number };
        Choice { value: number, label: Message::new("knum-zero-settable").text("name", format!("G{name}")) }
    }));
    choices.extend(self::choices(&[(1000, "knum-zero-last")]));
    choices.extend((0..16).map(|index| frame(1011 + index, "$P_CHBFR", index, "knum-zero-channel")));
    choices.extend((0..16).map(|index| frame(1051 + index, "$P_NCBFR", index, "knum-zero-global")));
    choices.extend(self::choices(&[(2000, "knum-zero-system")]));
    choices
}

/// Every target of a zero offset in the lists of newer controls: published programs, and tools that write them.
pub fn newer_zero_offsets() -> Vec<Choice> {
    let settable = |above: i64, key: &'static str| {
        let name = |number| format!("G{}", if number <= 4 { 53 + number } else { 500 + number });
        (1..=99)
            .map(move |number| Choice { value: above + number, label: Message::new(key).text("name", name(number)) })
    };
    let mut choices = choices(&[(0, "knum-zero-none")]);
    choices.extend(settable(0, "argument-zero-fine"));
    choices.extend(settable(newer::COARSE_FROM, "argument-zero-coarse"));
    choices.extend(self::choices(&[
        (9000, "argument-zero-used"),
        (9999, "knum-zero-active"),
        (19_999, "knum-zero-active"),
    ]));
    choices
}

fn frame(value: i64, array: &str, index: i64, key: &'static str) -> Choice {
    Choice { value, label: Message::new(key).text("name", format!("{array}[{index}]")) }
}
