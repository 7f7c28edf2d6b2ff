//! Which quantity of which tool `_KNUM` means, and what a correction writes there (B:1894-2060, B:2104-2158).

#[cfg(test)]
mod tests;

use super::knum::Quantity;
use super::{Write, knum};
use crate::control::{Control, Environment};

/// Who names the tool of a correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Names<'a> {
    /// `_KNUM`.
    pub code: i64,
    /// `_TNUM`; greater than 0 it has priority over the name (B:1872-1892).
    pub tool: i64,
    /// `_TNAME`.
    pub tool_name: &'a str,
    /// `_DLNUM`.
    pub location: i64,
    /// `_TENV`.
    pub environment: &'a str,
    /// Measuring axis: 0 abscissa, 1 ordinate, 2 applicate; none: "length in the measuring axis" means nothing.
    pub axis: Option<usize>,
}

/// The quantity to be corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// T number.
    pub tool: i64,
    /// D number.
    pub edge: i64,
    /// 0 to 2: L1 to L3; 3: radius.
    pub part: usize,
    /// DL number, where the setup or additive offset is corrected.
    pub location: Option<i64>,
    /// The sign is turned round.
    pub inverted: bool,
}

/// Index of the radius among L1, L2, L3, radius.
pub const RADIUS: usize = 3;

/// Finds the quantity. None: `_KNUM` is 0. Error: number of the alarm.
pub(crate) fn target(control: &Control, names: &Names) -> Result<Option<Target>, u32> {
    let Some(code) = knum::tool(names.code, knum::five_digit_edges(control))? else { return Ok(None) };
    let environment = match code.environment {
        true => Some(control.environments.get(names.environment).ok_or(61405_u32)?), // B:2086
        false => None,
    };
    let (tool, edge) = tool_and_edge(control, names, code.edge, environment)?;
    let largest = control.number("MD18105");
    if largest > 0.0 && edge as f64 > largest {
        return Err(61345);
    }
    let data = control.edge_of(tool, edge).ok_or(61410_u32)?; // the quantity to be corrected does not exist, A:15931
    let location = environment.filter(|_| names.location == 0).map_or(names.location, |stored| stored.location);
    let location = match (code.location, location) {
        (false, _) => None,
        (true, location @ 1..=6) => Some(location),
        (true, _) => return Err(61406),
    };
    if let Some(number) = location.and_then(|_| missing_memory(control)) {
        return Err(number);
    }
    let part = match code.quantity {
        Quantity::Radius => RADIUS,
        Quantity::Length(number) => usize::from(number.saturating_sub(1)),
        Quantity::MeasuringAxis => {
            let axis = names.axis.ok_or(61322_u32)?;
            let axis = environment.map_or(axis, |stored| turned(control, stored, axis));
            control.length_axes(data).iter().position(|own| *own == axis).unwrap_or(0)
        }
    };
    Ok(Some(Target { tool, edge, part, location, inverted: code.inverted }))
}

/// The alarm for a memory of DL offsets that a correction needs and the machine does not have: 61408 additive
/// offsets, 61409 setup offsets (A:15927-15928). Which it needs, `_CHBIT[6]` and `_CHBIT[8]` say (B:2047-2060).
pub fn missing_memory(control: &Control) -> Option<u32> {
    let only_setup = control.bit("_CHBIT[8]");
    let setup = only_setup || control.bit(GEOMETRY);
    if !only_setup && !control.machine_bit("MD18080", 8) {
        return Some(61408);
    }
    (setup && !control.machine_bit("MD18112", 4)).then_some(61409)
}

/// The measuring axis as seen from the plane that was stored with the environment.
fn turned(control: &Control, environment: &Environment, axis: usize) -> usize {
    let geometry = control.plane.axes()[axis.min(2)];
    environment.plane.axes().iter().position(|own| *own == geometry).unwrap_or(axis)
}

/// T and D: by number, by name, or by the environment.
fn tool_and_edge(control: &Control, names: &Names, edge: i64, stored: Option<&Environment>) -> Result<(i64, i64), u32> {
    let tool = match (names.tool, stored) {
        (tool, _) if tool > 0 => tool,
        (_, Some(stored)) => stored.tool,
        _ => by_name(control, names.tool_name)?,
    };
    if !control.tools.contains_key(&tool) {
        return Err(61320);
    }
    Ok((tool, stored.filter(|_| edge == 0).map_or(edge, |stored| stored.edge)))
}

/// T number of a name; of several sister tools the one in the spindle, else the last (B:1890 "the one last used").
fn by_name(control: &Control, name: &str) -> Result<i64, u32> {
    if name.is_empty() {
        return Err(61320);
    }
    let named = |number: &i64| control.tools.get(number).is_some_and(|tool| tool.name == name);
    if named(&control.tool) {
        return Ok(control.tool);
    }
    control.tools.keys().copied().rfind(named).ok_or(61343)
}

/// Whether corrections are taken into the geometry, and the wear is erased (B:2047-2060).
pub const GEOMETRY: &str = "_CHBIT[6]";

/// What a correction by `amount` (mm, sign included) writes: wear and additive offset grow; or, with `geometry`, they
/// are taken into geometry and setup offset and erased. `_CHBIT[8]` chooses the setup offset alone (B:2047-2060).
pub fn writes(control: &Control, target: &Target, amount: f64, geometry: bool) -> Vec<Write> {
    let Target { tool, edge, part, .. } = *target;
    let at = format!("[{tool},{edge}]");
    let (coarse, fine) = match target.location {
        None => (format!("$TC_DP{}{at}", part + 3), format!("$TC_DP{}{at}", part + 12)),
        Some(dl) => (format!("$TC_ECP{dl}{}{at}", part + 3), format!("$TC_SCP{dl}{}{at}", part + 3)),
    };
    let value = |name: &str| control.variable(name).unwrap_or(0.0);
    let (in_coarse, in_fine) = (value(&coarse), value(&fine));
    if target.location.is_some() && control.bit("_CHBIT[8]") {
        vec![Write { name: coarse, value: in_coarse + amount }]
    } else if geometry {
        vec![Write { name: coarse, value: in_coarse + in_fine + amount }, Write { name: fine, value: 0.0 }]
    } else {
        vec![Write { name: fine, value: in_fine + amount }]
    }
}
