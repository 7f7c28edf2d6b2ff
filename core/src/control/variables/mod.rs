//! Tool and frame data under the names a part program uses: `$TC_DP6[9,1]`, `$P_UIFR[1,X,FI]`; on NCT by plain names
//! (`H98`, `D1`, `G59 X`), since that control has no such variables in the manual.

mod parts;
mod place;
#[cfg(test)]
mod tests;

pub use parts::{component, set_component};

use super::rotary::ROTARY;
use super::{Control, Edge, Frame, Store, Tool};
use crate::dialect::Dialect;
use parts::{edge_quantity, part_of, set_edge_quantity, set_part};
use place::{Kept, PARTS, Place, REGISTERS, ROTARY_PARTS, whole_frame};
use std::collections::BTreeMap;

/// Axis letters by index.
pub const AXES: [&str; 3] = ["X", "Y", "Z"];

impl Control {
    /// Value of a tool or frame variable, lengths in mm; none when there is no such variable (or no such tool).
    pub fn variable(&self, name: &str) -> Option<f64> {
        match self.place(name)? {
            Place::Frame(kept, axis, part) => Some(part_of(&self.frame_at(kept), part, axis)),
            Place::Edge(tool, edge, quantity) => {
                let zero = self.make().registers.then(Edge::default);
                Some(edge_quantity(self.edge_of(tool, edge).or(zero.as_ref())?, quantity))
            }
        }
    }

    /// Writes a tool or frame variable; `$TC_DP1[t,d]` makes an edge that is not there. False: no such variable.
    pub fn set_variable(&mut self, name: &str, value: f64) -> bool {
        match self.place(name) {
            Some(Place::Frame(kept, axis, part)) => set_part(self.frame_at_mut(kept), part, axis, value),
            Some(Place::Edge(tool, edge, quantity)) => set_edge_quantity(self.edge_made(tool, edge), quantity, value),
            None => return false,
        }
        true
    }

    /// All stored tool and frame data by their names.
    pub fn variables(&self) -> impl Iterator<Item = (String, f64)> {
        self.variables_but(None)
    }

    /// The same without frames and edges that are alike in the other control: of many, few differ after a measurement.
    pub fn variables_unlike(&self, other: &Control) -> impl Iterator<Item = (String, f64)> {
        self.variables_but(Some(other))
    }

    fn variables_but(&self, alike: Option<&Control>) -> impl Iterator<Item = (String, f64)> {
        let names = match self.dialect {
            Dialect::Sinumerik => sinumerik_names(self, alike),
            Dialect::Nct => nct_names(self, alike),
        };
        names.into_iter().filter_map(|name| self.variable(&name).map(|value| (name, value)))
    }

    /// What the name of a tool or frame variable means. Not in [`super::Make`], as the names are not: the page's first
    /// module asks for neither, and would carry what a table points to.
    fn place(&self, name: &str) -> Option<Place> {
        match self.dialect {
            Dialect::Sinumerik => place::sinumerik(name),
            Dialect::Nct => place::nct(name),
        }
    }

    /// Tools and edges, each with what it holds; without those that are alike in the other control.
    fn edges<'a>(&'a self, alike: Option<&'a Control>) -> impl Iterator<Item = (i64, i64, &'a Edge)> {
        let edges = |(tool, data): (&'a i64, &'a Tool)| data.edges.iter().map(move |(edge, data)| (*tool, *edge, data));
        let differs = move |(tool, edge, data): &(i64, i64, &Edge)| {
            alike.is_none_or(|other| other.edge_of(*tool, *edge) != Some(*data))
        };
        self.tools.iter().flat_map(edges).filter(differs)
    }

    /// Names of all parts of a frame; `number` with the comma behind it, where there is more than one.
    fn frame_names(&self, store: &str, number: &str) -> Vec<String> {
        let rotary = ROTARY.iter().filter(|axis| self.rotary_axis(axis).is_some());
        let linear = AXES.iter().map(|axis| (axis, &PARTS[..]));
        linear
            .chain(rotary.map(|axis| (axis, &ROTARY_PARTS[..])))
            .flat_map(|(axis, parts)| parts.iter().map(move |(part, _)| (axis, part)))
            .map(|(axis, part)| format!("{store}[{number}{axis},{part}]"))
            .collect()
    }

    /// A frame by the name of its variable without axis and part: `$P_UIFR[1]`, `$P_CHBFRAME[0]`, `$P_PFRAME`.
    pub fn frame(&self, name: &str) -> Option<Frame> {
        whole_frame(name).map(|kept| self.frame_at(kept))
    }

    /// Writes a frame by the name of its variable; false: there is no such frame.
    pub fn set_frame(&mut self, name: &str, frame: Frame) -> bool {
        let Some(kept) = whole_frame(name) else { return false };
        *self.frame_at_mut(kept) = frame;
        true
    }

    fn frame_at(&self, kept: Kept) -> Frame {
        match kept {
            Kept::Stored(store) => self.stored_frame(store),
            Kept::System => self.basic.system,
            Kept::Global(index) => self.basic.global.get(&index).copied().unwrap_or_default(),
            Kept::Channel(index) => self.basic.channel.get(&index).copied().unwrap_or_default(),
            Kept::Active => self.active,
            Kept::Program => self.program_frame,
            Kept::Plane => self.plane_frame,
            Kept::Part => self.part_frame,
        }
    }

    fn frame_at_mut(&mut self, kept: Kept) -> &mut Frame {
        match kept {
            Kept::Stored(Store::System) => &mut self.stored.system,
            Kept::Stored(Store::GlobalBasic(index)) => self.stored.global.entry(index).or_default(),
            Kept::Stored(Store::ChannelBasic(index)) => self.stored.channel.entry(index).or_default(),
            Kept::Stored(Store::Settable(number)) => self.frames.entry(number).or_default(),
            Kept::System => &mut self.basic.system,
            Kept::Global(index) => self.basic.global.entry(index).or_default(),
            Kept::Channel(index) => self.basic.channel.entry(index).or_default(),
            Kept::Active => &mut self.active,
            Kept::Program => &mut self.program_frame,
            Kept::Plane => &mut self.plane_frame,
            Kept::Part => &mut self.part_frame,
        }
    }
}

/// Frames of one store by their numbers.
type Frames = BTreeMap<usize, Frame>;

/// Where a control has such frames.
type Stored = fn(&Control) -> &Frames;

/// Their numbers; without those of frames that are alike in the other control.
fn numbers<'a>(control: &'a Control, alike: Option<&'a Control>, store: Stored) -> impl Iterator<Item = usize> {
    let differs =
        move |(number, frame): &(&usize, &Frame)| alike.is_none_or(|other| store(other).get(number) != Some(*frame));
    store(control).iter().filter(differs).map(|(number, _)| *number)
}

/// Names of all stored tool and frame data of SINUMERIK; without frames and edges that are alike in the other control.
fn sinumerik_names(control: &Control, alike: Option<&Control>) -> Vec<String> {
    let mut names = Vec::new();
    let stores: [(&str, Stored); 3] = [
        ("$P_UIFR", |control| &control.frames),
        ("$P_CHBFR", |control| &control.stored.channel),
        ("$P_NCBFR", |control| &control.stored.global),
    ];
    for (name, store) in stores {
        let numbers = numbers(control, alike, store);
        names.extend(numbers.flat_map(|number| control.frame_names(name, &format!("{number},"))));
    }
    if alike.is_none_or(|other| other.stored.system != control.stored.system) {
        names.extend(control.frame_names("$P_SETFR", ""));
    }
    for (tool, edge, data) in control.edges(alike) {
        edge_names(&mut names, tool, edge, data);
    }
    names
}

/// Names of all stored tool and frame data of NCT; without frames and edges that are alike in the other control.
fn nct_names(control: &Control, alike: Option<&Control>) -> Vec<String> {
    let offsets = numbers(control, alike, |control| &control.frames).filter(|number| *number <= 6);
    let offsets = offsets.map(|number| control.make().settable_name(number));
    let offsets = offsets.flat_map(|offset| AXES.map(|axis| format!("{offset} {axis}")));
    let registers =
        control.edges(alike).flat_map(|(_, edge, _)| REGISTERS.map(|(letters, _)| format!("{letters}{edge}")));
    offsets.chain(registers).collect()
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
