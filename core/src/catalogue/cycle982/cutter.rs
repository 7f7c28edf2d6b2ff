//! Milling tools and drills (B:9192-9210, B:9578-9690, B:9738-9793, B:10082-10094). The ways round the probe are ours
//! where figures are lost.

use super::edges::Edges;
use super::params::{AUTOMATIC, BOTH, DRILL, INCREMENTAL, OPPOSITE, RADIAL, RADIUS, UPPER, WITH_RADIUS};
use super::stand::{found, part};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::evaluate::tool_offset;

/// A milling tool or drill before the probe.
struct Cutter<'a> {
    stand: &'a Stand<'a>,
    edges: Edges,
    /// Axis along which it lies, and the one across, in which its radius counts.
    along: usize,
    across: usize,
}

/// Measures what the task names.
pub fn measure(machine: &mut dyn Machine, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    let inputs = stand.inputs;
    let along = usize::from(RADIAL.holds(inputs));
    let cutter = Cutter { stand, edges: Edges::of(machine, inputs)?, along, across: 1 - along };
    if AUTOMATIC.holds(inputs) {
        return cutter.automatic(machine);
    }
    let axis = axis(machine, inputs, 1..=2)?;
    if WITH_RADIUS.holds(inputs) && axis != cutter.across {
        return Err(alarm(machine, 61325)); // the radius does not lie there (B:9279)
    }
    if !WITH_RADIUS.holds(inputs) && axis == cutter.across && stand.block.radius == 0.0 {
        return Err(alarm(machine, 61351)); // touched with the side, whose distance is not known (B:9208)
    }
    if INCREMENTAL.holds(inputs) {
        let direction = direction(machine, inputs)?;
        let touch = |machine: &mut dyn Machine| stand.touch_from_here(machine, axis, direction);
        let touched = cutter.edges.touch(machine, false, touch)?;
        return Ok(vec![cutter.one(machine, axis, direction, touched)]);
    }
    let [first, second] = cutter.sides(machine)?;
    if BOTH.holds(inputs) {
        return cutter.both(machine, second, stand.start[along]);
    }
    let direction = if axis == along { first } else { second };
    match axis == along {
        true => stand.go(machine, cutter.across, cutter.edge_on_probe(-second))?,
        false => cutter.go_to_middle(machine)?,
    }
    let touched = cutter.touch(machine, axis, direction, false)?;
    Ok(vec![cutter.one(machine, axis, direction, touched)])
}

impl Cutter<'_> {
    /// Directions from the start towards the probe, along the tool and across it: the tool stands beside the probe in
    /// both axes (B:9642).
    fn sides(&self, machine: &mut dyn Machine) -> Result<[f64; 2], Stop> {
        let along = self.stand.approach(machine, self.along)?;
        Ok([along, self.stand.approach(machine, self.across)?])
    }

    /// Where the axis of the tool stands across so that its edge is over the middle of the probe (B:9590); `side`: on
    /// which side of the middle the axis stands.
    fn edge_on_probe(&self, side: f64) -> f64 {
        self.stand.probe.middle(self.across) + side * self.stand.block.radius
    }

    /// Along the tool to the middle of the probe.
    fn go_to_middle(&self, machine: &mut dyn Machine) -> Result<(), Stop> {
        self.stand.go(machine, self.along, self.stand.probe.middle(self.along))
    }

    /// Where the axis of the tool stands beside a side that is touched across in this direction.
    fn beside(&self, direction: f64) -> f64 {
        self.stand.probe.trigger(self.across, direction) - direction * (self.stand.block.radius + self.stand.block.path)
    }

    /// How far the axis of the tool is from a touched side, mm.
    fn reach(&self, axis: usize, direction: f64) -> f64 {
        if axis == self.across { direction * self.stand.block.radius } else { 0.0 }
    }

    /// Touches one side of the probe from where the tool stands beside it; its position at switching, mm.
    fn touch(&self, machine: &mut dyn Machine, axis: usize, direction: f64, turned: bool) -> Result<f64, Stop> {
        let set = self.stand.probe.trigger(axis, direction) - self.reach(axis, direction);
        self.edges.touch(machine, turned, |machine| self.stand.touch(machine, axis, direction, set))
    }

    /// What one touch tells: a length, or the radius (B:9635-9637). The length that it would mean for the axis of the
    /// tool has the radius in it across.
    fn one(&self, machine: &mut dyn Machine, axis: usize, direction: f64, latched: f64) -> Measured {
        let apparent = self.stand.apparent(machine.control(), axis, direction, latched);
        if RADIUS.holds(self.stand.inputs) {
            let length = active(machine.control(), part(axis));
            return found(tool_offset::RADIUS, (apparent - length).abs());
        }
        found(part(axis), apparent + self.reach(axis, direction))
    }

    /// Length across and radius from two sides, round the probe to the second one: out along the tool, across, in again
    /// (B:9638, B:9644).
    fn both(&self, machine: &mut dyn Machine, direction: f64, out: f64) -> Result<Vec<Measured>, Stop> {
        self.go_to_middle(machine)?;
        let first = self.touch(machine, self.across, direction, false)?;
        self.stand.go(machine, self.along, out)?;
        self.stand.go(machine, self.across, self.beside(-direction))?;
        self.go_to_middle(machine)?;
        let second = self.touch(machine, self.across, -direction, true)?;
        let first = self.stand.apparent(machine.control(), self.across, direction, first);
        let second = self.stand.apparent(machine.control(), self.across, -direction, second);
        let radius = found(tool_offset::RADIUS, (first - second).abs() / 2.0);
        Ok(vec![found(part(self.across), (first + second) / 2.0), radius])
    }

    /// All that the tool allows, what lies in the abscissa first, and back to the start (B:9702-9706, B:9738-9793).
    fn automatic(&self, machine: &mut dyn Machine) -> Result<Vec<Measured>, Stop> {
        let [towards, across] = self.sides(machine)?;
        let crosses = OPPOSITE.holds(self.stand.inputs);
        let start = self.stand.start;
        let beyond = 2.0 * self.stand.probe.middle(self.along) - start[self.along];
        let way = match crosses {
            true => Way { direction: -towards, across, out: beyond },
            false => Way { direction: towards, across, out: start[self.along] },
        };
        let with_side = !DRILL.holds(self.stand.inputs);
        let mut found = Vec::new();
        if with_side && self.across == 0 {
            found.extend(self.side(machine, &way)?);
        }
        found.push(self.tip(machine, &way)?);
        if with_side && self.across == 1 {
            found.extend(self.side(machine, &way)?);
        }
        if crosses {
            self.stand.go(machine, self.along, way.out)?;
            self.stand.go(machine, self.across, start[self.across])?;
        }
        self.stand.back_to_start(machine)?;
        Ok(found)
    }

    /// Length along the tool from two touches: the same edge over the middle from both sides, or twice at one place, of
    /// an upper edge and with no radius (B:9756, B:9766).
    fn tip(&self, machine: &mut dyn Machine, way: &Way) -> Result<Measured, Stop> {
        let upper = UPPER.holds(self.stand.inputs);
        self.stand.go(machine, self.along, way.out)?;
        self.stand.go(machine, self.across, self.edge_on_probe(-way.across))?;
        let mut latched = self.touch(machine, self.along, way.direction, false)?;
        if self.stand.block.radius > 0.0 {
            if !upper {
                self.stand.go(machine, self.across, self.edge_on_probe(way.across))?;
            }
            let second = self.touch(machine, self.along, way.direction, !upper)?;
            latched = (latched + second) / 2.0;
        }
        Ok(self.stand.length(machine, self.along, way.direction, latched))
    }

    /// Length across and radius from both sides; without a radius one side gives the length (B:9704).
    fn side(&self, machine: &mut dyn Machine, way: &Way) -> Result<Vec<Measured>, Stop> {
        self.stand.go(machine, self.along, way.out)?;
        self.stand.go(machine, self.across, self.beside(way.across))?;
        let found = if self.stand.block.radius == 0.0 {
            self.go_to_middle(machine)?;
            let latched = self.touch(machine, self.across, way.across, false)?;
            vec![self.stand.length(machine, self.across, way.across, latched)]
        } else {
            self.both(machine, way.across, way.out)?
        };
        self.stand.go(machine, self.along, way.out)?;
        Ok(found)
    }
}

/// How the probe is gone round in automatic measurement.
struct Way {
    /// Directions of the touch along the tool, and of the first one across it.
    direction: f64,
    across: f64,
    /// Where the tool is clear of the probe along its axis, mm.
    out: f64,
}
