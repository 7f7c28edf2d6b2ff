//! What a name of a tool or frame variable means: where the quantity is stored.

use super::AXES;
use crate::control::{NCT, ROTARY, Store};

/// Where a quantity is stored.
pub(in crate::control) enum Place {
    /// A frame, axis 0..2, part.
    Frame(Kept, usize, Part),
    /// A tool edge: T, D, quantity.
    Edge(i64, i64, Quantity),
}

/// A frame of the control: a stored one, or one in effect.
#[derive(Clone, Copy)]
pub(in crate::control) enum Kept {
    Stored(Store),
    System,
    Global(usize),
    Channel(usize),
    Active,
    Program,
    Plane,
    Part,
}

#[derive(Clone, Copy)]
pub(in crate::control) enum Part {
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
pub(in crate::control) enum Quantity {
    Kind,
    Tip,
    Geometry(usize),
    Wear(usize),
    Additive(i64, usize),
    Setup(i64, usize),
    Further(usize),
}

/// Parts of a frame, as `$P_UIFR[1,X,TR]` names them.
pub(super) const PARTS: [(&str, Part); 5] =
    [("TR", Part::Coarse), ("FI", Part::Fine), ("RT", Part::Rotation), ("SC", Part::Scale), ("MI", Part::Mirror)];
/// Parts of a frame along a rotary axis.
pub(super) const ROTARY_PARTS: [(&str, Part); 2] = [("TR", Part::Rotary), ("FI", Part::RotaryFine)];

/// What the name of a SINUMERIK variable means.
pub(in crate::control) fn sinumerik(name: &str) -> Option<Place> {
    let (stem, rest) = name.split_once('[')?;
    let index: Vec<&str> = rest.strip_suffix(']')?.split(',').collect();
    if let Some(quantity) = stem.strip_prefix("$TC_") {
        let [tool, edge] = index[..] else { return None };
        return Some(Place::Edge(tool.parse().ok()?, edge.parse().ok()?, tool_quantity(quantity)?));
    }
    let (number, axis, part) = match index[..] {
        [axis, part] => (None, axis, part),
        [number, axis, part] => (Some(number), axis, part),
        _ => return None,
    };
    let (axis, part) = axis_and_part(axis, part)?;
    Some(Place::Frame(kept(stem, number)?, axis, part))
}

/// The frame of a variable with a number, where there is more than one.
fn kept(stem: &str, number: Option<&str>) -> Option<Kept> {
    let up_to = |largest| number?.parse().ok().filter(|number| *number <= largest);
    let basic = || up_to(15);
    Some(match (stem, number) {
        ("$P_UIFR", Some(_)) => Kept::Stored(Store::Settable(up_to(99)?)),
        ("$P_CHBFR", Some(_)) => Kept::Stored(Store::ChannelBasic(basic()?)),
        ("$P_NCBFR", Some(_)) => Kept::Stored(Store::GlobalBasic(basic()?)),
        ("$P_SETFR", None) => Kept::Stored(Store::System),
        ("$P_UBFR", None) => Kept::Stored(Store::ChannelBasic(0)),
        ("$P_CHBFRAME", Some(_)) => Kept::Channel(basic()?),
        ("$P_NCBFRAME", Some(_)) => Kept::Global(basic()?),
        ("$P_SETFRAME", None) => Kept::System,
        ("$P_BFRAME", None) => Kept::Channel(0),
        ("$P_IFRAME", None) => Kept::Active,
        ("$P_PFRAME", None) => Kept::Program,
        ("$P_WPFRAME", None) => Kept::Plane,
        ("$P_PARTFRAME", None) => Kept::Part,
        _ => return None,
    })
}

/// The frame of a variable without axis and part: `$P_UIFR[1]`, `$P_SETFRAME`.
pub(super) fn whole_frame(name: &str) -> Option<Kept> {
    match name.split_once('[') {
        Some((stem, rest)) => kept(stem, Some(rest.strip_suffix(']')?)),
        None => kept(name, None),
    }
}

/// `DP2` cutting edge position, `DP6` radius, `DP15` its wear, `SCP13` L1 of the additive, `ECP13` of setup offset DL1.
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
    let digits: u8 = additive.or_else(|| name.strip_prefix("ECP"))?.parse().ok()?;
    let (dl, part) = (i64::from(digits / 10), usize::from(digits % 10));
    if !(1..=6).contains(&dl) || !(3..=6).contains(&part) {
        return None;
    }
    Some(if additive.is_some() { Quantity::Additive(dl, part - 3) } else { Quantity::Setup(dl, part - 3) })
}

/// Registers of NCT and their wear, by the letters before their number.
pub(super) const REGISTERS: [(&str, Quantity); 4] =
    [("H", Quantity::Geometry(0)), ("D", Quantity::Geometry(3)), ("HW", Quantity::Wear(0)), ("DW", Quantity::Wear(3))];

/// What a name means on NCT.
pub(in crate::control) fn nct(name: &str) -> Option<Place> {
    if let Some((offset, axis)) = name.split_once(' ') {
        let kept = Kept::Stored(Store::Settable(NCT.settable_named(offset)?));
        return Some(Place::Frame(kept, AXES.iter().position(|known| *known == axis)?, Part::Coarse));
    }
    let register = |letters: &str| name.strip_prefix(letters)?.parse().ok();
    REGISTERS.iter().find_map(|(letters, quantity)| Some(Place::Edge(0, register(letters)?, *quantity)))
}

/// Index of the axis and part of a frame: `X`, `TR`. A rotary axis has translations only.
pub(super) fn axis_and_part(axis: &str, part: &str) -> Option<(usize, Part)> {
    let (axes, parts) = if ROTARY.contains(&axis) { (ROTARY, &ROTARY_PARTS[..]) } else { (AXES, &PARTS[..]) };
    let (_, part) = parts.iter().find(|(name, _)| *name == part)?;
    Some((axes.iter().position(|known| *known == axis)?, *part))
}
