//! Milling tools and drills (B:9192-9210, B:9578-9690, B:9738-9793, B:10082-10094). The ways round the probe are ours
//! where figures are lost.

use super::edges::Edges;
use super::nose::{axis, told};
use super::params::{AUTOMATIC, BOTH, DRILL, INCREMENTAL, OPPOSITE, RADIAL, RADIUS, UPPER};
use super::stand::{Stand, found, part};
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::entry::Inputs;
use crate::evaluate::tool_offset;
use crate::machine::{Machine, Stop};

/// A milling tool or drill before the probe.
pub struct Cutter<'a> {
    stand: &'a Stand,
    edges: Edges,
    /// Axis along which it lies, and the one across, in which its radius counts.
    along: usize,
    across: usize,
}

/// Measures what the task names.
pub fn measure(machine: &mut dyn Machine, inputs: &Inputs, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    let along = usize::from(RADIAL.holds(inputs));
    let cutter = Cutter { stand, edges: Edges::of(machine, inputs)?, along, across: 1 - along };
    if AUTOMATIC.holds(inputs) {
        return cutter.automatic(machine, inputs);
    }
    let axis = axis(machine, inputs)?;
    if (RADIUS.holds(inputs) || BOTH.holds(inputs)) && axis != cutter.across {
        return Err(alarm(machine, 61325)); // the radius does not lie there (B:9279)
    }
    if !RADIUS.holds(inputs) && !BOTH.holds(inputs) && axis == cutter.across && stand.radius == 0.0 {
        return Err(alarm(machine, 61351)); // touched with the side, whose distance is not known (B:9208)
    }
    if INCREMENTAL.holds(inputs) {
        let direction = told(machine, inputs)?;
        let touched = cutter
            .edges
            .touch(machine, stand, false, |machine, stand| stand.touch_from_here(machine, axis, direction))?;
        return Ok(vec![cutter.one(machine, inputs, (axis, direction), touched)]);
    }
    let [first, second] = cutter.sides(machine)?;
    if BOTH.holds(inputs) {
        return cutter.both(machine, second);
    }
    let direction = if axis == cutter.along { first } else { second };
    if axis == cutter.along {
        let to = cutter.edge_on_probe(-second, false);
        stand.go(machine, cutter.across, to)?;
    } else {
        stand.go(machine, cutter.along, stand.middle(cutter.along))?;
    }
    let touched = cutter.touch(machine, axis, direction, false)?;
    Ok(vec![cutter.one(machine, inputs, (axis, direction), touched)])
}

impl Cutter<'_> {
    /// Directions from the start towards the probe, along the tool and across it: the tool stands beside the probe in
    /// both axes (B:9642).
    fn sides(&self, machine: &mut dyn Machine) -> Result<[f64; 2], Stop> {
        let along = self.stand.approach(machine, self.along)?;
        Ok([along, self.stand.approach(machine, self.across)?])
    }

    /// Where the axis of the tool stands across so that its edge is over the middle of the probe (B:9590); `side`: on
    /// which side of the middle the axis stands; `beyond`: on the other one.
    fn edge_on_probe(&self, side: f64, beyond: bool) -> f64 {
        let side = if beyond { -side } else { side };
        self.stand.middle(self.across) + side * self.stand.radius
    }

    /// Touches one side of the probe from where the tool stands beside it; its position at switching, mm.
    fn touch(&self, machine: &mut dyn Machine, axis: usize, direction: f64, turned: bool) -> Result<f64, Stop> {
        let reach = if axis == self.across { direction * self.stand.radius } else { 0.0 };
        let set = self.stand.trigger(axis, direction) - reach;
        self.edges.touch(machine, self.stand, turned, |machine, stand| stand.touch(machine, axis, direction, set))
    }

    /// Length that the touch would mean for the axis of the tool, mm: across, the radius is in it.
    fn apparent(&self, machine: &mut dyn Machine, axis: usize, direction: f64, latched: f64) -> f64 {
        self.stand.apparent(machine.control(), axis, direction, latched)
    }

    /// What one touch tells: a length, or the radius (B:9635-9637).
    fn one(
        &self,
        machine: &mut dyn Machine,
        inputs: &Inputs,
        (axis, direction): (usize, f64),
        latched: f64,
    ) -> Measured {
        let apparent = self.apparent(machine, axis, direction, latched);
        if RADIUS.holds(inputs) {
            let length = active(machine.control(), part(axis));
            return found(tool_offset::RADIUS, (apparent - length).abs());
        }
        let reach = if axis == self.across { direction * self.stand.radius } else { 0.0 };
        found(part(axis), apparent + reach)
    }

    /// Length across and radius from two sides (B:9638, B:9644).
    fn both(&self, machine: &mut dyn Machine, direction: f64) -> Result<Vec<Measured>, Stop> {
        self.stand.go(machine, self.along, self.stand.middle(self.along))?;
        let first = self.touch(machine, self.across, direction, false)?;
        let out = self.stand.start[self.along];
        self.second_side(machine, direction, out)?;
        let second = self.touch(machine, self.across, -direction, true)?;
        Ok(self.two_sides(machine, direction, [first, second]))
    }

    /// Round the probe to its other side: out along the tool, across, in again.
    fn second_side(&self, machine: &mut dyn Machine, direction: f64, out: f64) -> Result<(), Stop> {
        self.stand.go(machine, self.along, out)?;
        let reach = self.stand.radius + self.stand.block.path;
        let beyond = self.stand.trigger(self.across, -direction) + direction * reach;
        self.stand.go(machine, self.across, beyond)?;
        self.stand.go(machine, self.along, self.stand.middle(self.along))
    }

    fn two_sides(&self, machine: &mut dyn Machine, direction: f64, latched: [f64; 2]) -> Vec<Measured> {
        let first = self.apparent(machine, self.across, direction, latched[0]);
        let second = self.apparent(machine, self.across, -direction, latched[1]);
        vec![found(part(self.across), (first + second) / 2.0), found(tool_offset::RADIUS, (first - second).abs() / 2.0)]
    }

    /// All that the tool allows, what lies in the abscissa first, and back to the start (B:9702-9706, B:9738-9793).
    fn automatic(&self, machine: &mut dyn Machine, inputs: &Inputs) -> Result<Vec<Measured>, Stop> {
        let [towards, across] = self.sides(machine)?;
        let upper = UPPER.holds(inputs);
        let crosses = OPPOSITE.holds(inputs);
        let way = Way {
            direction: if crosses { -towards } else { towards },
            across,
            out: match crosses {
                true => 2.0 * self.stand.middle(self.along) - self.stand.start[self.along],
                false => self.stand.start[self.along],
            },
            upper,
        };
        let mut found = Vec::new();
        if DRILL.holds(inputs) {
            found.push(self.tip(machine, &way)?);
        } else if self.along == 0 {
            found.push(self.tip(machine, &way)?);
            found.extend(self.side(machine, &way)?);
        } else {
            found.extend(self.side(machine, &way)?);
            found.push(self.tip(machine, &way)?);
        }
        if crosses {
            self.stand.go(machine, self.along, way.out)?;
            self.stand.go(machine, self.across, self.stand.start[self.across])?;
        }
        self.stand.back_to_start(machine)?;
        Ok(found)
    }

    /// Length along the tool from two touches: the same edge over the middle from both sides, or twice at one place, of
    /// an upper edge and with no radius (B:9756, B:9766).
    fn tip(&self, machine: &mut dyn Machine, way: &Way) -> Result<Measured, Stop> {
        self.stand.go(machine, self.along, way.out)?;
        let to = self.edge_on_probe(-way.across, false);
        self.stand.go(machine, self.across, to)?;
        let mut latched = self.touch(machine, self.along, way.direction, false)?;
        if self.stand.radius > 0.0 {
            if !way.upper {
                let beyond = self.edge_on_probe(-way.across, true);
                self.stand.go(machine, self.across, beyond)?;
            }
            let second = self.touch(machine, self.along, way.direction, !way.upper)?;
            latched = (latched + second) / 2.0;
        }
        let actual = self.apparent(machine, self.along, way.direction, latched);
        Ok(found(part(self.along), actual))
    }

    /// Length across and radius from both sides; without a radius one side gives the length (B:9704).
    fn side(&self, machine: &mut dyn Machine, way: &Way) -> Result<Vec<Measured>, Stop> {
        let reach = self.stand.radius + self.stand.block.path;
        let beside = self.stand.trigger(self.across, way.across) - way.across * reach;
        self.stand.go(machine, self.along, way.out)?;
        self.stand.go(machine, self.across, beside)?;
        self.stand.go(machine, self.along, self.stand.middle(self.along))?;
        let first = self.touch(machine, self.across, way.across, false)?;
        if self.stand.radius == 0.0 {
            self.stand.go(machine, self.along, way.out)?;
            let actual = self.apparent(machine, self.across, way.across, first);
            return Ok(vec![found(part(self.across), actual)]);
        }
        self.second_side(machine, way.across, way.out)?;
        let second = self.touch(machine, self.across, -way.across, true)?;
        self.stand.go(machine, self.along, way.out)?;
        Ok(self.two_sides(machine, way.across, [first, second]))
    }
}

/// How the probe is gone round in automatic measurement.
struct Way {
    /// Directions of the touch along the tool, and of the first one across it.
    direction: f64,
    across: f64,
    /// Where the tool is clear of the probe along its axis, mm.
    out: f64,
    /// The upper cutting edge is measured.
    upper: bool,
}
