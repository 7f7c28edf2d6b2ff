//! What a name of a tool or frame variable means: where the quantity is stored.

use super::AXES;
use crate::control::rotary::ROTARY;
use crate::dialect::Dialect;

/// Where a quantity is stored.
pub(super) enum Place {
    /// A frame: store and number, axis 0..2, part.
    Frame(Store, usize, usize, Part),
    /// A tool edge: T, D, quantity.
    Edge(i64, i64, Quantity),
    /// A frame in effect: as above.
    Active(Store, usize, usize, Part),
}

/// A family of frames.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Store {
    Settable,
    Channel,
    Global,
    System,
    Program,
    Part,
}

/// Part of a frame.
#[derive(Clone, Copy)]
pub(super) enum Part {
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
pub(super) enum Quantity {
    Kind,
    Tip,
    Geometry(usize),
    Wear(usize),
    Additive(i64, usize),
    Setup(i64, usize),
    Further(usize),
}

pub(super) fn place(dialect: Dialect, name: &str) -> Option<Place> {
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
        return Some(Place::Edge(tool.parse().ok()?, edge.parse().ok()?, tool_quantity(quantity)?));
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
    Some(Family { store, in_effect, numbered })
}

fn limited(number: &str, limit: usize) -> Option<usize> {
    number.parse().ok().filter(|number| *number <= limit)
}

/// Store, whether in effect, and number of a frame: `$P_UIFR[1]`, `$P_SETFRAME`.
pub(super) fn whole_frame(name: &str) -> Option<(Store, bool, usize)> {
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

/// `DP2` cutting edge position, `DP6` radius, `DP15` its wear, `SCP13` L1 of the additive offset DL1, `ECP13` of the
/// setup offset.
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

fn nct_place(name: &str) -> Option<Place> {
    if let Some((offset, axis)) = name.split_once(' ') {
        let number = match offset {
            "COMMON" => 0,
            _ => offset.strip_prefix('G')?.parse::<usize>().ok()?.checked_sub(53)?,
        };
        return (number <= 6).then_some(Place::Frame(Store::Settable, number, axis_index(axis)?, Part::Coarse));
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
pub(super) fn axis_and_part(axis: &str, part: &str) -> Option<(usize, Part)> {
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
