//! A nominal part for CYCLE994 about the zero point: a turned part, with a bore and a pin in it where the zone lies
//! inside. Where the zone is not left along the axis of rotation, a block or a groove with a pin.

use super::params::INSIDE_ZONE;
use super::simulate::Zone;
use crate::catalogue::lathe::{measure, place};
use crate::catalogue::place as plane;
use crate::catalogue::prelude::*;
use crate::workpiece::{Shape, Solid};

/// How much further from the surface than the first block the probe starts, mm.
const AWAY: f64 = 5.0;
/// What is left between ball and part on the way round it, mm.
const CLEAR: f64 = 2.0;
/// Width of a block or groove across, mm.
const ACROSS: f64 = 60.0;
/// How far behind its face a part is touched, mm.
const BEHIND: f64 = 20.0;

/// The measured element as the call describes it, mm.
struct Element<'a> {
    control: &'a Control,
    /// The zone, and the axes in which it is passed.
    zone: Zone,
    /// How far part and pin reach in the axis in which the zone is left.
    end: f64,
}

/// Part and start: opposite the positive point, inside only where the variant says so.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let index = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let ball = plane::ball_radius(inputs, control);
    let zone = Zone::of(control, inputs, index);
    let ([measured, left], [border, end]) = (zone.axes, zone.border);
    let element = Element { control, zone, end: (end - ball - CLEAR).max(ball) };
    let radius = inputs.number(names::SETVAL) / measure::per(control, inputs);
    let (width, gap) = (2.0 * radius, ball + inputs.number(names::FA));
    // what is in the zone; nothing where the ball hardly fits
    let pin = 2.0 * (border - ball - CLEAR);
    let inside = INSIDE_ZONE.holds(inputs);
    let mut start = [0.0; 3];
    start[left] = (element.end - BEHIND).max(0.0);
    start[measured] = if inside { (radius - gap).max(border) } else { radius + gap + AWAY };
    let part = if inside { element.bore(width) } else { element.outside([width, ACROSS, place::LENGTH]) };
    let pin = (inside && pin > 0.0).then(|| element.outside([pin, ACROSS / 2.0, 2.0 * BEHIND]));
    Proposal {
        fixture: pin.into_iter().chain(place::chuck(&part)).collect(),
        zones: vec![element.shown()],
        tools: place::corrected_tools(inputs),
        ..plane::proposal(part, start)
    }
}

impl Element<'_> {
    /// A solid whose depth lies along the axis in which the zone is left and whose X is measured, its face at `end`.
    fn standing(&self, shape: Shape, end: f64) -> Solid {
        let [measured, left] = self.zone.axes.map(plane::unit);
        let at = left.map(|part| part * end);
        place::standing(self.control, shape, at, measured, left)
    }

    /// Whether the zone is left along the axis of rotation Z.
    fn turned(&self) -> bool {
        self.zone.axes[1] == 2
    }

    /// A turned part or a block: width in the measured axis, across both, length.
    fn outside(&self, [width, across, length]: [f64; 3]) -> Solid {
        let shape = match self.turned() {
            true => Shape::Turned { diameter: width, length, bore: [0.0; 2] },
            false => Shape::Block { size: [width, across, length] },
        };
        self.standing(shape, self.end)
    }

    /// A bore in a turned part, or a groove.
    fn bore(&self, width: f64) -> Solid {
        let depth = 2.0 * BEHIND;
        let shape = match self.turned() {
            true => Shape::Turned { diameter: width + BEHIND, length: place::LENGTH, bore: [width, depth] },
            false => Shape::Groove { width, depth, length: ACROSS },
        };
        self.standing(shape, self.end)
    }

    /// The zone, to be shown.
    fn shown(&self) -> Solid {
        let [across, end] = self.zone.border;
        let shape = Shape::Island { length: [2.0 * across, ACROSS], height: place::LENGTH };
        self.standing(shape, end)
    }
}
