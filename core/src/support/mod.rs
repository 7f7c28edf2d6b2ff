//! Forms and code as the support in the control's own program editor has them: `_MZ_MASK` decides which fields there
//! are and what is written for those that are not (B:12467-12558). It counts only where the machine says so with
//! [`FORMS`]; otherwise every field is there and only what was typed is written.

mod mark;
mod target;
mod values;

pub use mark::{Changed, Mark};
pub use target::{Offer, finding, offer, usual, usual_zero};
pub use values::{BITS, Before, Entered, MEAN_BIT, SPEEDS_BIT, decimal, restore};

pub use crate::control::FORMS;

use crate::control::Control;
use crate::dialect::Dialect;
use crate::entry::{ArgumentList, Cycle, ProbeUse, Style};

/// Key of its words.
pub const FORMS_KEY: &str = "datum-pw-forms";

/// Entries of `_MZ_MASK` that mean something (B:12501-12539); the sixth is reserved.
pub const ENTRIES: usize = 8;

/// Correction targets: the usual ones, or all (B:12503-12504).
pub const TARGETS: usize = 1;
/// Fields for measuring feed and repetitions (B:12505-12506).
pub const FEED: usize = 2;
/// Field for the memory of the empirical value (B:12507).
pub const EMPIRICAL: usize = 3;
/// Fields for the mean value (B:12518-12532).
pub const MEAN: usize = 4;
/// Multi or mono probe (B:12533-12535).
pub const PROBE: usize = 5;
/// Fields for feed and speed of CYCLE971 (B:12537-12539).
pub const SPEEDS: usize = 7;

/// The active settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Support {
    entries: [bool; ENTRIES],
}

impl Support {
    /// What counts for a cycle on this machine: nothing where forms show everything, or the support has none for it.
    pub fn of(cycle: &Cycle, control: &Control) -> Option<Support> {
        let has_form = cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe != ProbeUse::None;
        (has_form && control.bit(FORMS))
            .then(|| Support { entries: std::array::from_fn(|entry| control.bit(&name(entry))) })
    }

    /// Whether an entry of `_MZ_MASK` is 1.
    pub fn entry(&self, entry: usize) -> bool {
        self.entries.get(entry).copied().unwrap_or(false)
    }

    /// Call style that the first entry chooses, where the cycle has it (B:12501-12502).
    pub fn style(&self, cycle: &Cycle) -> Style {
        let indirect = |list: &ArgumentList| list.style == Style::Indirect;
        if self.entry(0) || !cycle.lists.iter().any(indirect) { Style::Direct } else { Style::Indirect }
    }
}

/// `_MZ_MASK[4]`.
pub fn name(entry: usize) -> String {
    format!("_MZ_MASK[{entry}]")
}
