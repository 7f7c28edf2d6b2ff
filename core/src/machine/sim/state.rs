//! What decides over the future of a machine.

use super::Sim;
use crate::control::Control;
use crate::geometry::{Degrees, Mcs, Wcs};
use crate::workpiece::{Noise, Tool};
use std::collections::BTreeMap;

/// All on which depends what a machine does next: not what was recorded, and not what never changes.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    position: Mcs,
    control: Control,
    turned: Degrees,
    noise: [Noise; 2],
    real_tools: BTreeMap<(i64, i64), Tool>,
    /// Way with the signal watched, as long as a false one is still to come.
    watched: Option<f64>,
    touching: bool,
    skipped: Option<Wcs>,
    /// Changes of files so far.
    files: u64,
}

impl Sim {
    /// A copy of it.
    pub fn state(&self) -> State {
        State {
            position: self.position,
            control: self.control.clone(),
            turned: self.turned,
            noise: [self.noise, self.tool_noise],
            real_tools: self.real_tools.clone(),
            watched: self.until_false_signal(),
            touching: self.touching,
            skipped: self.skipped,
            files: self.files.changes(),
        }
    }

    /// Whether it is the same. What differs most often is compared first.
    pub fn is(&self, state: &State) -> bool {
        self.position == state.position
            && self.control.data.written_alike(&state.control.data)
            && [self.noise, self.tool_noise] == state.noise
            && self.touching == state.touching
            && self.turned == state.turned
            && self.skipped == state.skipped
            && self.files.changes() == state.files
            && self.until_false_signal() == state.watched
            && self.control == state.control
            && self.real_tools == state.real_tools
    }

    fn until_false_signal(&self) -> Option<f64> {
        let after = self.probe.false_signal?;
        (self.watched <= after).then_some(self.watched)
    }
}
