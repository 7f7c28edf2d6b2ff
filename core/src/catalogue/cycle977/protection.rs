//! What a protection zone of CYCLE977 is good for: an obstacle in the element, or clamps around it, that the probe must
//! not meet (B:5892-5951).

use super::params::{OUTSIDE, RECTANGLE, WIDTH};
use crate::catalogue::prelude::*;
use crate::workpiece::{Shape, Solid};

/// Distance of an obstacle from the wall of its zone, mm: more than a probe with errors needs.
const GAP: f64 = 0.5;
/// How far the plate under a post lies below the floor of the hole, mm: it is not to be seen.
const SUNK: f64 = 1.0;
/// Share of the element's size that a clamp is long and thick.
const CLAMP: [f64; 2] = [0.5, 0.12];

/// A protection zone about the set centre, its upper edge at applicate 0.
pub struct Protected {
    outside: bool,
    round: bool,
    /// Whether one axis alone is measured.
    single: bool,
    /// Size of the zone in the first measuring axis and across it, mm.
    zone: [f64; 2],
    /// Size of the element in the same axes, mm.
    element: [f64; 2],
    /// Depth of the element, mm.
    height: f64,
    /// Direction of the first measuring axis: abscissa, ordinate, applicate.
    x: [f64; 3],
}

impl Protected {
    /// The zone that the values describe; none without one.
    pub fn of(inputs: &Inputs, height: f64, x: [f64; 3]) -> Option<Protected> {
        if !super::params::ZONE.holds(inputs) {
            return None;
        }
        let (size, zone) = (inputs.number(names::SETVAL), inputs.number(names::SZA));
        let (rectangle, single) = (RECTANGLE.holds(inputs), WIDTH.holds(inputs));
        let (element, zone) = match (rectangle, single) {
            (true, _) => {
                ([inputs.number(names::SETV0), inputs.number(names::SETV1)], [zone, inputs.number(names::SZO)])
            }
            (_, true) => ([size, place::along(size)], [zone, place::along(size)]),
            _ => ([size; 2], [zone; 2]),
        };
        Some(Protected {
            outside: OUTSIDE.holds(inputs),
            round: !rectangle && !single,
            single,
            zone,
            element,
            height,
            x,
        })
    }

    /// The walls of the zone, to be shown.
    pub fn walls(&self, control: &Control) -> Solid {
        let ([first, across], height) = (self.zone, self.height);
        let shape = match (self.round, self.single) {
            (true, _) => Shape::Shaft { diameter: first, height },
            (_, true) => Shape::Web { width: first, height, length: across },
            _ => Shape::Island { length: self.zone, height },
        };
        self.placed(control, shape, [0.0; 2])
    }

    /// What stands in the zone: a post, a rib or a block inside; a clamp before each measured wall outside.
    pub fn obstacles(&self, control: &Control) -> Vec<Solid> {
        if self.outside {
            return self.clamps(control);
        }
        let [first, across] = self.zone.map(|size| (size - 2.0 * GAP).max(size * 0.5));
        let shape = match (self.round, self.single) {
            (true, _) => Shape::Shaft { diameter: first, height: self.height + SUNK },
            (_, true) => Shape::Block { size: [first, self.zone[1], self.height] },
            _ => Shape::Block { size: [first, across, self.height] },
        };
        vec![self.placed(control, shape, [0.0; 2])]
    }

    fn clamps(&self, control: &Control) -> Vec<Solid> {
        let axes: &[usize] = if self.single { &[0] } else { &[0, 1] };
        let both = axes.iter().flat_map(|axis| [(*axis, 1.0), (*axis, -1.0)]);
        both.map(|(axis, side)| {
            let thick = (self.element[axis] * CLAMP[1]).max(5.0);
            let mut size = [0.0, 0.0, self.height];
            size[axis] = thick;
            size[1 - axis] = self.element[1 - axis] * CLAMP[0];
            let mut at = [0.0; 2];
            at[axis] = side * (self.zone[axis] / 2.0 + GAP + thick / 2.0);
            self.placed(control, Shape::Block { size }, at)
        })
        .collect()
    }

    /// A solid at a place along the first measuring axis and across it.
    fn placed(&self, control: &Control, shape: Shape, [first, across]: [f64; 2]) -> Solid {
        let [x, y, _] = self.x;
        // across: the first axis turned by a quarter about the applicate
        let at = [first * x - across * y, first * y + across * x, 0.0];
        place::solid(control, shape, at, self.x, place::outward(control))
    }
}
