//! What a field offers where the machine's forms are those of the control's own support; see [`crate::support`].

use super::codes::{EDGE, KIND};
use super::fields::{Entry, Group};
use crate::entry::{Inputs, PROBE_TYPE};
use crate::evaluate::knum::Quantity;
use crate::support::{PROBE, Support, TARGETS, usual, usual_zero};

/// Groups of digits, the type of the probe as it is set (B:12533-12535).
pub fn groups(support: Option<Support>, mut groups: Vec<Group>) -> Vec<Group> {
    let Some(support) = support else { return groups };
    let set = i64::from(support.entry(PROBE));
    for group in groups.iter_mut().filter(|group| group.label.key == PROBE_TYPE.key) {
        group.choices.retain(|choice| choice.value == set);
    }
    groups
}

/// `_KNUM` with the targets that are offered (B:12503-12504): of a tool the edge and the one usual correction.
pub fn target(support: Option<Support>, entry: Entry, inputs: &Inputs) -> Entry {
    if support.is_none_or(|support| support.entry(TARGETS)) {
        return entry;
    }
    match entry {
        Entry::Choice { mut choices } => {
            choices.retain(|choice| usual_zero(choice.value));
            Entry::Choice { choices }
        }
        Entry::Digits { mut digits } => {
            digits.retain(|group| [EDGE.key, KIND.key].contains(&&*group.label.key));
            for group in digits.iter_mut().filter(|group| group.label.key == KIND.key) {
                let usual = kind_of(usual(inputs));
                group.choices.retain(|choice| choice.value == usual);
            }
            Entry::Digits { digits }
        }
        entry => entry,
    }
}

/// Digit above the D number (B:1902-1926).
fn kind_of(quantity: Quantity) -> i64 {
    match quantity {
        Quantity::Radius => 2,
        Quantity::MeasuringAxis | Quantity::Length(_) => 0,
    }
}
