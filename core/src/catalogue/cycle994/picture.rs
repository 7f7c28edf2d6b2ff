//! CYCLE994 drawn: both points with the way between them, around the protection zone. The second variant is drawn
//! twice, outside with the zone and inside without it.

use super::params::{INSIDE_ZONE, zone};
use crate::catalogue::lathe::figures;
use crate::catalogue::lathe::figures::{RADIUS, axis, per};
use crate::catalogue::prelude::*;
use crate::entry::stage::{Fields, Look, Seen, Staging};

/// The variant that measures inside.
const INSIDE: i64 = 1;
/// Half of the zone along the measuring axis, outside and inside, and along the other one, mm.
const ZONE: [f64; 3] = [48.0, 18.0, 36.0];

/// The part about the zero point.
pub fn stage(inputs: &Inputs) -> Staging {
    let [across, along] = zone(axis(inputs) == 0);
    let inside = INSIDE_ZONE.holds(inputs);
    let look = if axis(inputs) == 2 { Look::section(0) } else { Look::ABOVE };
    let look = |cut| Look { cut, held: true, ..look.clone().ways(along) };
    // sizes along X are diameters, where the call counts so
    let factor = inputs.plane.axes().map(|axis| if axis == 0 && inputs.diameters { 2.0 } else { 1.0 });
    let at = |look: Look, half: f64| {
        figures::stage(inputs, look)
            .with(names::SETVAL, RADIUS * per(inputs))
            .with(across, half * factor[axis(inputs)])
            .with(along, ZONE[2] * factor[usize::from(axis(inputs) == 0)])
    };
    if inside {
        return at(look(true), ZONE[1]);
    }
    let free = Staging {
        proposed: Some(INSIDE),
        fields: Fields { zone: None, ..Fields::CYCLE },
        ..at(Look { held: false, ..look(true).ways(names::MVAR) }, ZONE[1])
    };
    Staging { then: Some(Box::new(free)), ..at(look(false), ZONE[0]) }
}

/// Setpoint, zone and limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let paper = usize::from(axis(inputs) != 0);
    let [across, along] = zone(axis(inputs) == 0);
    let mut shapes = Vec::new();
    for seen in looks {
        let [low, high] = seen.extent;
        shapes.extend(seen.limits(inputs, None));
        shapes.extend(seen.axes(seen.zero, [0, 1].map(|axis| (axis == paper).then_some(names::MA))));
        shapes.extend(seen.path(names::FA, 0, 2.5));
        shapes.extend(figures::set(inputs, seen, paper, low[1 - paper] + 14.0));
        for zone @ [_, end] in &seen.zones {
            let from = if per(inputs) > 1.0 { zone[0] } else { seen.zero };
            shapes.push(seen.along(across, paper, [from, *end], high[1 - paper] + 6.0));
            shapes.push(seen.along(along, 1 - paper, [seen.zero, *end], low[paper] - 6.0));
        }
    }
    shapes
}
