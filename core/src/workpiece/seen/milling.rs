//! What is drawn of a milling tool or drill: what it sweeps, or its teeth where they stand.

use super::{Drawn, cylinder};
use crate::control::Plane;
use crate::geometry::{Degrees, V3};
use crate::workpiece::{Cutter, Spindle, tool::across};

/// Radius of the shank of a groove mill, of the core of a cutter, thickness of a tooth, in radii of the edge.
const NECK: f64 = 0.2;
const CORE: f64 = 0.7;
const TOOTH: f64 = 0.2;
/// How far the core of a cutter ends behind its teeth, in radii of the edge.
const RISES: f64 = 0.05;

/// A milling tool: what cuts and, of a groove mill, the shank that reaches from its upper edge to where it is held.
pub(super) fn tool(cutter: &Cutter, carrier: V3, plane: Plane, spindle: Option<Spindle>) -> (Vec<Drawn>, V3) {
    let (along, body) = cutter.stands(plane.axes());
    let up = V3::ith(along, 1.0);
    let swept = |radius: f64, drop: f64| Drawn::Round { outline: cutter.outline(radius), axis: body, at: up * -drop };
    let mut pieces = match spindle {
        _ if cutter.teeth == 0 => vec![swept(cutter.radius, 0.0)],
        Some(Spindle::Stands(angle)) => toothed(cutter, along, body, angle),
        _ => cutter.edges().into_iter().map(|(radius, _, drop)| swept(radius, drop)).collect(),
    };
    let reach = carrier.dot(&up);
    if cutter.disc > 0.0 && reach > 0.0 {
        pieces.push(Drawn::Round { outline: cylinder(NECK * cutter.radius, 0.0, reach), axis: up, at: V3::zeros() });
    }
    (pieces, up)
}

/// A cutter that stands: its core, and behind each edge, as M3 turns it, a tooth.
fn toothed(cutter: &Cutter, along: usize, body: V3, angle: Degrees) -> Vec<Drawn> {
    let core = cutter.outline(CORE * cutter.radius);
    let tooth = |(radius, direction, drop): (f64, Degrees, f64)| {
        let out = across(along, direction + angle);
        let end = V3::ith(along, 1.0) * -drop;
        let place = |[away, high]: [f64; 2]| end + out * away + body * high;
        Drawn::Plate {
            corners: cutter.outline(radius).into_iter().map(place).collect(),
            thick: across(along, direction + angle + Degrees(90.0)) * (TOOTH * radius),
            cuts: true,
        }
    };
    let core = Drawn::Round { outline: core, axis: body, at: body * (RISES * cutter.radius) };
    let teeth = cutter.edges().into_iter().map(tooth);
    std::iter::once(core).chain(teeth).collect()
}
