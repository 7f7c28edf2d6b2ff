//! What a protection zone of CYCLE977 is good for: an obstacle in the element, or clamps around it, that the probe must
//! not meet (B:5892-5951).

use super::element::Element;
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
    /// What it lies in or around.
    element: Element,
    /// Size of the zone in the first measuring axis and across it, mm.
    zone: [f64; 2],
    /// Depth of the element, mm.
    height: f64,
}

impl Protected {
    /// The zone of an element; none without one. Across its axis a groove or web has no zone: there it is as long.
    pub fn of(mut element: Element, height: f64) -> Option<Protected> {
        let mut zone = element.zone?;
        if element.single().is_some() {
            element.size[1] = place::along(element.size[0]);
            zone[1] = element.size[1];
        }
        Some(Protected { element, zone, height })
    }

    /// The walls of the zone, to be shown.
    pub fn walls(&self, control: &Control) -> Solid {
        let (length, height) = (self.zone, self.height);
        let shape = match (self.element.round, self.element.single()) {
            (true, _) => Shape::Shaft { diameter: length[0], height },
            (_, Some(_)) => Shape::Web { width: length[0], height, length: length[1] },
            _ => Shape::Island { length, height },
        };
        self.placed(control, shape, [0.0; 2])
    }

    /// What is in the zone: a post, a rib or a block inside; a clamp before each measured wall outside.
    pub fn obstacles(&self, control: &Control) -> Vec<Solid> {
        if !self.element.inside {
            return self.clamps(control);
        }
        let [first, across] = self.zone.map(|size| (size - 2.0 * GAP).max(size * 0.5));
        let across = if self.element.single().is_some() { self.zone[1] } else { across };
        let shape = match self.element.round {
            true => Shape::Shaft { diameter: first, height: self.height + SUNK },
            false => Shape::Block { size: [first, across, self.height] },
        };
        vec![self.placed(control, shape, [0.0; 2])]
    }

    fn clamps(&self, control: &Control) -> Vec<Solid> {
        let size = self.element.size;
        let axes = 0..self.element.axes.len();
        let both = axes.flat_map(|axis| [(axis, 1.0), (axis, -1.0)]);
        both.map(|(axis, side)| {
            let (mut clamp, mut at) = ([0.0, 0.0, self.height], [0.0; 2]);
            clamp[axis] = (size[axis] * CLAMP[1]).max(5.0);
            clamp[1 - axis] = size[1 - axis] * CLAMP[0];
            at[axis] = side * (self.zone[axis] / 2.0 + GAP + clamp[axis] / 2.0);
            self.placed(control, Shape::Block { size: clamp }, at)
        })
        .collect()
    }

    /// A solid at a place along the first measuring axis and across it.
    fn placed(&self, control: &Control, shape: Shape, [first, across]: [f64; 2]) -> Solid {
        let direction @ [x, y, _] = place::unit(self.element.axes[0]);
        // across: the first axis turned by a quarter about the applicate
        let at = [first * x - across * y, first * y + across * x, 0.0];
        place::solid(control, shape, at, direction, place::outward(control))
    }
}
