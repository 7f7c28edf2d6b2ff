//! Tool and frame data under the names a part program uses: `$TC_DP6[9,1]`, `$P_UIFR[1,X,FI]`; on NCT by plain names
//! (`H98`, `D1`, `G59 X`), since that control has no such variables in the manual.

use super::rotary::ROTARY;
use super::{Control, Edge, Frame};
use crate::catalogue::Dialect;

/// Axis letters by index.
pub const AXES: [&str; 3] = ["X", "Y", "Z"];

/// Parts of a frame, as `$P_UIFR[1,X,TR]` names them: translation, fine translation, rotation, scale, mirror.
const FRAME_PARTS: [&str; 5] = ["TR", "FI", "RT", "SC", "MI"];

/// Where a quantity is stored.
enum Place {
    /// A frame: store and number, axis 0..2, part.
    Frame(Store, usize, usize, Part),
    /// A tool edge: T, D, quantity.
    Edge(i64, i64, Quantity),
    /// A frame in effect: as above.
    Active(Store, usize, usize, Part),
}

/// A family of frames.
#[derive(Clone, Copy, PartialEq)]
enum Store {
    Settable,
    Channel,
    Global,
    System,
    Program,
    Part,
}

/// Part of a frame.
#[derive(Clone, Copy)]
enum Part {
    Coarse,
    Fine,
    Rotation,
    Rotary,
    RotaryFine,
    Scale,
    Mirror,
}

/// Quantity of an edge. Lengths L1..L3 are 0..2, the radius 3.
#[derive(Clone, Copy)]
enum Quantity {
    Kind,
    Tip,
    Geometry(usize),
    Wear(usize),
    Additive(i64, usize),
    Setup(i64, usize),
    Further(usize),
}

impl Control {
    /// Value of a tool or frame variable, lengths in mm; none when there is no such variable (or no such tool).
    pub fn variable(&self, name: &str) -> Option<f64> {
        match place(self.dialect, name)? {
            Place::Frame(store, number, axis, part) => {
                let frame = self
                    .stored_frame(store, number)
                    .copied()
                    .unwrap_or_default();
                Some(part_of(&frame, part, axis))
            }
            Place::Active(store, number, axis, part) => {
                let frame = self
                    .active_frame(store, number)
                    .copied()
                    .unwrap_or_default();
                Some(part_of(&frame, part, axis))
            }
            Place::Edge(tool, edge, quantity) => {
                let zero = Edge::default();
                let found = self.edge_of(tool, edge);
                let edge = if self.dialect == Dialect::Nct {
                    found.unwrap_or(&zero)
                } else {
                    found?
                };
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
                let edge = self
                    .tools
                    .entry(tool)
                    .or_default()
                    .edges
                    .entry(edge)
                    .or_default();
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
                names.extend(
                    self.frames
                        .keys()
                        .map(numbered)
                        .flat_map(|n| self.frame_names("$P_UIFR", &n)),
                );
                names.extend(
                    self.channel_basic
                        .keys()
                        .map(numbered)
                        .flat_map(|n| self.frame_names("$P_CHBFR", &n)),
                );
                names.extend(
                    self.global_basic
                        .keys()
                        .map(numbered)
                        .flat_map(|n| self.frame_names("$P_NCBFR", &n)),
                );
                names.extend(self.frame_names("$P_SETFR", ""));
            }
            Dialect::Nct => {
                let offsets = self.frames.keys().filter(|number| **number <= 6);
                names.extend(
                    offsets.flat_map(|n| AXES.map(|axis| format!("{} {axis}", nct_offset(*n)))),
                );
            }
        }
        for (tool, edges) in self.tools.iter().map(|(t, tool)| (t, &tool.edges)) {
            for (edge, data) in edges {
                match self.dialect {
                    Dialect::Sinumerik => edge_names(&mut names, *tool, *edge, data),
                    Dialect::Nct => {
                        names.extend(["H", "D", "HW", "DW"].map(|letter| format!("{letter}{edge}")))
                    }
                }
            }
        }
        names
    }

    /// Names of all parts of a frame; `number` with the comma behind it, where there is more than one.
    fn frame_names(&self, store: &str, number: &str) -> Vec<String> {
        let rotary = ROTARY
            .iter()
            .filter(|axis| self.rotary_axis(axis).is_some());
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
    if number == 0 {
        "COMMON".into()
    } else {
        format!("G{}", 53 + number)
    }
}

fn edge_names(names: &mut Vec<String>, tool: i64, edge: i64, data: &Edge) {
    names.extend([1, 2, 3, 4, 5, 6, 12, 13, 14, 15].map(|n| format!("$TC_DP{n}[{tool},{edge}]")));
    names.extend(
        data.further
            .keys()
            .map(|n| format!("$TC_DP{n}[{tool},{edge}]")),
    );
    for (letters, offsets) in [("SCP", &data.additive), ("ECP", &data.setup)] {
        for dl in offsets.keys() {
            names.extend([3, 4, 5, 6].map(|n| format!("$TC_{letters}{dl}{n}[{tool},{edge}]")));
        }
    }
}

fn place(dialect: Dialect, name: &str) -> Option<Place> {
    match dialect {
        Dialect::Sinumerik => sinumerik_place(name),
        Dialect::Nct => nct_place(name),
    }
}

fn sinumerik_place(name: &str) -> Option<Place> {
    let (stem, rest) = name.split_once('[')?;
    let index: Vec<&str> = rest.strip_suffix(']')?.split(',').collect();
    if let Some(quantity) = stem.strip_prefix("$TC_") {
        let [tool, edge] = index[..] else { return None };
        return Some(Place::Edge(
            tool.parse().ok()?,
            edge.parse().ok()?,
            tool_quantity(quantity)?,
        ));
    }
    let family = family(stem)?;
    let (number, [axis, part]) = match (family.numbered, &index[..]) {
        (None, [axis, part]) => (0, [axis, part]),
        (Some(limit), [number, axis, part]) => (limited(number, limit)?, [axis, part]),
        _ => return None,
    };
    let (axis, part) = axis_and_part(axis, part)?;
    Some(match family.in_effect {
        true => Place::Active(family.store, number, axis, part),
        false => Place::Frame(family.store, number, axis, part),
    })
}

/// A variable of frames.
struct Family {
    store: Store,
    /// Of the frames in effect, not of the stored ones.
    in_effect: bool,
    /// Largest number, where there is more than one.
    numbered: Option<usize>,
}

fn family(stem: &str) -> Option<Family> {
    let (store, in_effect, numbered) = match stem {
        "$P_UIFR" => (Store::Settable, false, Some(99)),
        "$P_CHBFR" => (Store::Channel, false, Some(15)),
        "$P_NCBFR" => (Store::Global, false, Some(15)),
        "$P_SETFR" => (Store::System, false, None),
        "$P_IFRAME" => (Store::Settable, true, None),
        "$P_CHBFRAME" => (Store::Channel, true, Some(15)),
        "$P_NCBFRAME" => (Store::Global, true, Some(15)),
        "$P_SETFRAME" => (Store::System, true, None),
        "$P_UBFR" => (Store::Channel, false, None),
        "$P_BFRAME" => (Store::Channel, true, None),
        "$P_PFRAME" => (Store::Program, true, None),
        "$P_PARTFRAME" => (Store::Part, true, None),
        _ => return None,
    };
    Some(Family {
        store,
        in_effect,
        numbered,
    })
}

/// Component of a frame by the names of its axis and its part; none: there is no such component.
pub fn component(frame: &Frame, axis: &str, part: &str) -> Option<f64> {
    let (axis, part) = axis_and_part(axis, part)?;
    Some(part_of(frame, part, axis))
}

/// Writes a component of a frame; false: there is none of this name.
pub fn set_component(frame: &mut Frame, axis: &str, part: &str, value: f64) -> bool {
    let Some((axis, part)) = axis_and_part(axis, part) else {
        return false;
    };
    set_part(frame, part, axis, value);
    true
}

fn limited(number: &str, limit: usize) -> Option<usize> {
    number.parse().ok().filter(|number| *number <= limit)
}

/// Store, whether in effect, and number of a frame: `$P_UIFR[1]`, `$P_SETFRAME`.
fn whole_frame(name: &str) -> Option<(Store, bool, usize)> {
    let (stem, index) = match name.split_once('[') {
        Some((stem, rest)) => (stem, Some(rest.strip_suffix(']')?)),
        None => (name, None),
    };
    let family = family(stem)?;
    let number = match (family.numbered, index) {
        (None, None) => 0,
        (Some(limit), Some(number)) => limited(number, limit)?,
        _ => return None,
    };
    Some((family.store, family.in_effect, number))
}

/// `DP2` cutting edge position, `DP6` radius, `DP15` its wear, `SCP13` L1 of the additive offset DL1, `ECP13` of the setup offset.
fn tool_quantity(name: &str) -> Option<Quantity> {
    if let Some(number) = name.strip_prefix("DP") {
        return match number.parse::<usize>().ok()? {
            1 => Some(Quantity::Kind),
            2 => Some(Quantity::Tip),
            n @ 3..=6 => Some(Quantity::Geometry(n - 3)),
            n @ 12..=15 => Some(Quantity::Wear(n - 12)),
            n @ (7..=11 | 16..=25) => Some(Quantity::Further(n)),
            _ => None,
        };
    }
    let additive = name.strip_prefix("SCP");
    let digits: u8 = additive
        .or_else(|| name.strip_prefix("ECP"))?
        .parse()
        .ok()?;
    let (dl, part) = (i64::from(digits / 10), usize::from(digits % 10));
    if !(1..=6).contains(&dl) || !(3..=6).contains(&part) {
        return None;
    }
    Some(if additive.is_some() {
        Quantity::Additive(dl, part - 3)
    } else {
        Quantity::Setup(dl, part - 3)
    })
}

fn nct_place(name: &str) -> Option<Place> {
    if let Some((offset, axis)) = name.split_once(' ') {
        let number = match offset {
            "COMMON" => 0,
            _ => offset
                .strip_prefix('G')?
                .parse::<usize>()
                .ok()?
                .checked_sub(53)?,
        };
        return (number <= 6).then_some(Place::Frame(
            Store::Settable,
            number,
            axis_index(axis)?,
            Part::Coarse,
        ));
    }
    let (quantity, digits) = match name {
        _ if name.starts_with("HW") => (Quantity::Wear(0), name.get(2..)?),
        _ if name.starts_with("DW") => (Quantity::Wear(3), name.get(2..)?),
        _ if name.starts_with('H') => (Quantity::Geometry(0), name.get(1..)?),
        _ if name.starts_with('D') => (Quantity::Geometry(3), name.get(1..)?),
        _ => return None,
    };
    Some(Place::Edge(0, digits.parse().ok()?, quantity))
}

fn axis_index(name: &str) -> Option<usize> {
    AXES.iter().position(|axis| *axis == name)
}

/// Index of the axis and part of a frame: `X`, `TR`. A rotary axis has translations only.
fn axis_and_part(axis: &str, part: &str) -> Option<(usize, Part)> {
    if let Some(axis) = ROTARY.iter().position(|known| *known == axis) {
        return match part {
            "TR" => Some((axis, Part::Rotary)),
            "FI" => Some((axis, Part::RotaryFine)),
            _ => None,
        };
    }
    let part = match part {
        "TR" => Part::Coarse,
        "FI" => Part::Fine,
        "RT" => Part::Rotation,
        "SC" => Part::Scale,
        "MI" => Part::Mirror,
        _ => return None,
    };
    Some((axis_index(axis)?, part))
}

fn part_of(frame: &Frame, part: Part, axis: usize) -> f64 {
    match part {
        Part::Coarse => frame.coarse[axis],
        Part::Fine => frame.fine[axis],
        Part::Rotation => frame.rotation[axis],
        Part::Rotary => frame.rotary[axis],
        Part::RotaryFine => frame.rotary_fine[axis],
        Part::Scale => frame.scale[axis],
        Part::Mirror => f64::from(u8::from(frame.mirror[axis])),
    }
}

fn set_part(frame: &mut Frame, part: Part, axis: usize, value: f64) {
    match part {
        Part::Coarse => frame.coarse[axis] = value,
        Part::Fine => frame.fine[axis] = value,
        Part::Rotation => frame.rotation[axis] = value,
        Part::Rotary => frame.rotary[axis] = value,
        Part::RotaryFine => frame.rotary_fine[axis] = value,
        Part::Scale => frame.scale[axis] = value,
        Part::Mirror => frame.mirror[axis] = value != 0.0,
    }
}

fn edge_quantity(edge: &Edge, quantity: Quantity) -> f64 {
    match quantity {
        Quantity::Kind => edge.kind as f64,
        Quantity::Tip => edge.tip as f64,
        Quantity::Geometry(3) => edge.radius,
        Quantity::Geometry(i) => edge.length[i],
        Quantity::Wear(3) => edge.radius_wear,
        Quantity::Wear(i) => edge.length_wear[i],
        Quantity::Additive(dl, i) => edge.additive.get(&dl).map_or(0.0, |offset| offset[i]),
        Quantity::Setup(dl, i) => edge.setup.get(&dl).map_or(0.0, |offset| offset[i]),
        Quantity::Further(n) => edge.further.get(&n).copied().unwrap_or(0.0),
    }
}

fn set_edge_quantity(edge: &mut Edge, quantity: Quantity, value: f64) {
    match quantity {
        Quantity::Kind => edge.kind = value as i64,
        Quantity::Tip => edge.tip = value as i64,
        Quantity::Geometry(3) => edge.radius = value,
        Quantity::Geometry(i) => edge.length[i] = value,
        Quantity::Wear(3) => edge.radius_wear = value,
        Quantity::Wear(i) => edge.length_wear[i] = value,
        Quantity::Additive(dl, i) => edge.additive.entry(dl).or_default()[i] = value,
        Quantity::Setup(dl, i) => edge.setup.entry(dl).or_default()[i] = value,
        Quantity::Further(n) => drop(edge.further.insert(n, value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;

    #[test]
    fn every_name_reads_what_was_written() {
        let mut control = delivery(Dialect::Sinumerik);
        let names = [
            "$P_UIFR[1,X,TR]",
            "$P_UIFR[99,Z,FI]",
            "$P_CHBFR[0,Y,RT]",
            "$P_NCBFR[15,X,TR]",
            "$P_SETFR[Z,TR]",
            "$P_UIFR[99,C,TR]",
            "$P_SETFR[C,FI]",
            "$TC_DP21[20,1]",
            "$TC_DP1[20,1]",
            "$TC_DP2[20,1]",
            "$TC_DP3[20,1]",
            "$TC_DP6[20,1]",
            "$TC_DP12[20,1]",
            "$TC_DP15[20,1]",
            "$TC_SCP13[20,1]",
            "$TC_ECP66[20,1]",
        ];
        // oracle: self (write, then read; each value its own)
        for (i, name) in names.iter().enumerate() {
            assert!(control.set_variable(name, i as f64 + 1.0), "{name}");
        }
        for (i, name) in names.iter().enumerate() {
            assert_eq!(control.variable(name), Some(i as f64 + 1.0), "{name}");
            assert!(
                control.variable_names().iter().any(|known| known == name),
                "{name}"
            );
        }
        // oracle: hand
        assert_eq!(control.frames[&1].coarse[0], 1.0);
        assert_eq!(control.tools[&20].edges[&1].radius_wear, 14.0);
    }

    #[test]
    fn other_names_are_refused() {
        let mut control = delivery(Dialect::Sinumerik);
        for name in [
            "$P_UIFR[100,X,TR]",
            "$P_UIFR[1,W,TR]",
            "$P_UIFR[1,C,RT]",
            "$P_UIFR[1,X,MM]",
            "$TC_DP99[1,1]",
            "$TC_SCP73[1,1]",
            "_OVR[0]",
            "$P_UIFR[1,X",
        ] {
            assert!(!control.set_variable(name, 1.0), "{name}");
            assert_eq!(control.variable(name), None, "{name}");
        }
    }

    #[test]
    fn nct_has_plain_names() {
        let mut control = delivery(Dialect::Nct);
        assert!(
            control.set_variable("G59 X", 120.0)
                && control.set_variable("D1", 5.0)
                && control.set_variable("H98", 50.0)
        );
        assert_eq!(control.frames[&6].coarse[0], 120.0);
        assert_eq!(control.register(98).length[0], 50.0);
        assert_eq!(control.register(1).radius, 5.0);
        assert!(!control.set_variable("G60 X", 0.0));
    }
}
