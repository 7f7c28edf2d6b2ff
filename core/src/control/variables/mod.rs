//! Tool and frame data under the names a part program uses: `$TC_DP6[9,1]`, `$P_UIFR[1,X,FI]`; on NCT by plain names
//! (`H98`, `D1`, `G59 X`), since that control has no such variables in the manual.

mod parts;
mod place;
#[cfg(test)]
mod tests;

pub use parts::{component, set_component};

use super::rotary::ROTARY;
use super::{Control, Edge, Frame};
use crate::dialect::Dialect;
use parts::{edge_quantity, part_of, set_edge_quantity, set_part};
use place::{Place, Store, place, whole_frame};

/// Axis letters by index.
pub const AXES: [&str; 3] = ["X", "Y", "Z"];

/// Parts of a frame, as `$P_UIFR[1,X,TR]` names them: translation, fine translation, rotation, scale, mirror.
const FRAME_PARTS: [&str; 5] = ["TR", "FI", "RT", "SC", "MI"];

impl Control {
    /// Value of a tool or frame variable, lengths in mm; none when there is no such variable (or no such tool).
    pub fn variable(&self, name: &str) -> Option<f64> {
        match place(self.dialect, name)? {
            Place::Frame(store, number, axis, part) => {
                let frame = self.stored_frame(store, number).copied().unwrap_or_default();
                Some(part_of(&frame, part, axis))
            }
            Place::Active(store, number, axis, part) => {
                let frame = self.active_frame(store, number).copied().unwrap_or_default();
                Some(part_of(&frame, part, axis))
            }
            Place::Edge(tool, edge, quantity) => {
                let zero = Edge::default();
                let found = self.edge_of(tool, edge);
                let edge = if self.dialect == Dialect::Nct { found.unwrap_or(&zero) } else { found? };
                Some(edge_quantity(edge, quantity))
            }
        }
    }

    /// Writes a tool or frame variable. An edge that is not there is made, as `$TC_DP1[t,d]` does.
    /// False: there is no such variable.
    pub fn set_variable(&mut self, name: &str, value: f64) -> bool {
        match place(self.dialect, name) {
            Some(Place::Frame(store, number, axis, part)) => {
                set_part(self.stored_frame_mut(store, number), part, axis, value);
            }
            Some(Place::Active(store, number, axis, part)) => {
                set_part(self.active_frame_mut(store, number), part, axis, value);
            }
            Some(Place::Edge(tool, edge, quantity)) => {
                let edge = self.tools.entry(tool).or_default().edges.entry(edge).or_default();
                set_edge_quantity(edge, quantity, value);
            }
            None => return false,
        }
        true
    }

    /// Names of all stored tool and frame data.
    pub fn variable_names(&self) -> Vec<String> {
        let mut names = Vec::new();
        match self.dialect {
            Dialect::Sinumerik => {
                let numbered = |number: &usize| format!("{number},");
                names.extend(self.frames.keys().map(numbered).flat_map(|n| self.frame_names("$P_UIFR", &n)));
                names.extend(self.channel_basic.keys().map(numbered).flat_map(|n| self.frame_names("$P_CHBFR", &n)));
                names.extend(self.global_basic.keys().map(numbered).flat_map(|n| self.frame_names("$P_NCBFR", &n)));
                names.extend(self.frame_names("$P_SETFR", ""));
            }
            Dialect::Nct => {
                let offsets = self.frames.keys().filter(|number| **number <= 6);
                names.extend(offsets.flat_map(|n| AXES.map(|axis| format!("{} {axis}", nct_offset(*n)))));
            }
        }
        for (tool, edges) in self.tools.iter().map(|(t, tool)| (t, &tool.edges)) {
            for (edge, data) in edges {
                match self.dialect {
                    Dialect::Sinumerik => edge_names(&mut names, *tool, *edge, data),
                    Dialect::Nct => names.extend(["H", "D", "HW", "DW"].map(|letter| format!("{letter}{edge}"))),
                }
            }
        }
        names
    }

    /// Names of all parts of a frame; `number` with the comma behind it, where there is more than one.
    fn frame_names(&self, store: &str, number: &str) -> Vec<String> {
        let rotary = ROTARY.iter().filter(|axis| self.rotary_axis(axis).is_some());
        let linear = AXES.iter().map(|axis| (axis, &FRAME_PARTS[..]));
        linear
            .chain(rotary.map(|axis| (axis, &FRAME_PARTS[..2])))
            .flat_map(|(axis, parts)| parts.iter().map(move |part| (axis, part)))
            .map(|(axis, part)| format!("{store}[{number}{axis},{part}]"))
            .collect()
    }

    fn stored_frame(&self, store: Store, number: usize) -> Option<&Frame> {
        match store {
            Store::Settable => self.frames.get(&number),
            Store::Channel => self.channel_basic.get(&number),
            Store::Global => self.global_basic.get(&number),
            Store::System => Some(&self.system),
            Store::Program => Some(&self.program_frame),
            Store::Part => Some(&self.part_frame),
        }
    }

    fn active_frame(&self, store: Store, number: usize) -> Option<&Frame> {
        match store {
            Store::Settable => Some(&self.active),
            Store::Channel => self.basic.channel.get(&number),
            Store::Global => self.basic.global.get(&number),
            Store::System => Some(&self.basic.system),
            Store::Program => Some(&self.program_frame),
            Store::Part => Some(&self.part_frame),
        }
    }

    fn active_frame_mut(&mut self, store: Store, number: usize) -> &mut Frame {
        match store {
            Store::Settable => &mut self.active,
            Store::Channel => self.basic.channel.entry(number).or_default(),
            Store::Global => self.basic.global.entry(number).or_default(),
            Store::System => &mut self.basic.system,
            Store::Program => &mut self.program_frame,
            Store::Part => &mut self.part_frame,
        }
    }

    /// A frame by the name of its variable without axis and part: `$P_UIFR[1]`, `$P_CHBFRAME[0]`, `$P_PFRAME`.
    pub fn frame(&self, name: &str) -> Option<Frame> {
        let (store, in_effect, number) = whole_frame(name)?;
        let frame = match in_effect {
            true => self.active_frame(store, number),
            false => self.stored_frame(store, number),
        };
        Some(frame.copied().unwrap_or_default())
    }

    /// Writes a frame by the name of its variable; false: there is no such frame.
    pub fn set_frame(&mut self, name: &str, frame: Frame) -> bool {
        match whole_frame(name) {
            Some((store, true, number)) => *self.active_frame_mut(store, number) = frame,
            Some((store, false, number)) => *self.stored_frame_mut(store, number) = frame,
            None => return false,
        }
        true
    }

    fn stored_frame_mut(&mut self, store: Store, number: usize) -> &mut Frame {
        match store {
            Store::Settable => self.frames.entry(number).or_default(),
            Store::Channel => self.channel_basic.entry(number).or_default(),
            Store::Global => self.global_basic.entry(number).or_default(),
            Store::System => &mut self.system,
            Store::Program => &mut self.program_frame,
            Store::Part => &mut self.part_frame,
        }
    }
}

/// Name of an NCT work offset as shown: `COMMON`, `G54`..`G59`.
pub fn nct_offset(number: usize) -> String {
    if number == 0 { "COMMON".into() } else { format!("G{}", 53 + number) }
}

fn edge_names(names: &mut Vec<String>, tool: i64, edge: i64, data: &Edge) {
    names.extend([1, 2, 3, 4, 5, 6, 12, 13, 14, 15].map(|n| format!("$TC_DP{n}[{tool},{edge}]")));
    names.extend(data.further.keys().map(|n| format!("$TC_DP{n}[{tool},{edge}]")));
    for (letters, offsets) in [("SCP", &data.additive), ("ECP", &data.setup)] {
        for dl in offsets.keys() {
            names.extend([3, 4, 5, 6].map(|n| format!("$TC_{letters}{dl}{n}[{tool},{edge}]")));
        }
    }
}
