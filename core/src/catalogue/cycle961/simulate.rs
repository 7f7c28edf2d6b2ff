//! What CYCLE961 does: touch two edges, and make their corner the zero of a frame (B:7980-8026, B:8136-8170).

use super::corner::corner;
use super::lines::Point;
use super::params::{MOVED_ABSCISSA, MOVED_ORDINATE, OUTSIDE, POINTS};
use super::touches::{Touch, touches};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::correct;
use crate::catalogue::sinumerik::measuring_block::{self, Block, all_calibrated};
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::{Measured, Target};
use crate::geometry::{Dir, Rpy, rigid};

/// Order in which the points are touched: P2, P1, P3, P4 (B:7998, B:8166).
const ORDER: [usize; 4] = [1, 0, 2, 3];

/// Runs the cycle from the present position, which is opposite the corner, or above it at positioning height.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 961);
    results::integer(machine, 3, inputs.variant);
    let block = Block::prepare(machine, inputs)?;
    let start = machine.position();
    let [abscissa, ordinate, _] = block.axes;
    let here = [start[abscissa], start[ordinate]];
    let touches = touches(inputs, machine.control(), here);
    let sides = touches.iter().map(|touch| (touch.axis, touch.direction));
    all_calibrated(machine, &block, &sides.collect::<Vec<_>>())?;
    let target = correct::zero_target(machine, inputs)?;
    let probing = Probing { inputs, block: &block, touches: &touches, start: start.0 };
    let centres = probing.measure(machine)?;
    let corner = corner(&touches, &centres, probing.radius()).map_err(|number| alarm(machine, number))?;
    let edge = block.placed([0.0; 3], corner.edge);
    let point = block.placed(probing.height(), corner.point);
    report(machine, edge, point);
    if let Some(target) = target {
        write(machine, inputs, &target, edge, point);
    }
    Ok(())
}

/// Edges that are touched from the position at the call, X Y Z of the WCS, mm.
struct Probing<'a> {
    inputs: &'a Inputs,
    block: &'a Block,
    touches: &'a [Touch],
    start: [f64; 3],
}

impl Probing<'_> {
    /// A place at the height of the ball's centre while it touched: of the start, with places the infeed below it.
    fn height(&self) -> [f64; 3] {
        let ball = self.block.ball_at(self.start);
        if POINTS.holds(self.inputs) { self.raised(ball) } else { ball }
    }

    /// Radius of the active ball, mm; where it was never determined that of the tool.
    fn radius(&self) -> f64 {
        if self.block.ball > 0.0 { self.block.ball } else { self.block.radius }
    }

    /// Touches all points; centres of the ball at switching, P1 first. Ends at the start or above P4 (B:8016, B:8170).
    fn measure(&self, machine: &mut dyn Machine) -> Result<Vec<Point>, Stop> {
        let Probing { block, touches, .. } = self;
        let mut centres = vec![[0.0; 2]; touches.len()];
        let by_points = POINTS.holds(self.inputs);
        for index in ORDER.into_iter().filter(|index| *index < touches.len()) {
            let touch = &touches[index];
            if index == 2 && !by_points {
                self.pass(machine, touch)?;
            }
            let over = block.placed(self.start, touch.at);
            block.travel(machine, Wcs(over))?;
            if by_points {
                block.travel(machine, Wcs(self.raised(over)))?;
            }
            centres[index] = self.ball(machine, touch)?;
            block.travel(machine, Wcs(over))?; // up again
        }
        if !by_points {
            block.travel(machine, Wcs(self.start))?;
        }
        Ok(centres)
    }

    /// From P1 to P3 past an outside corner: over it by `_ID`, or around through the start (B:8002-8012).
    fn pass(&self, machine: &mut dyn Machine, next: &Touch) -> Result<(), Stop> {
        if !OUTSIDE.holds(self.inputs) {
            return Ok(());
        }
        if self.inputs.number(names::ID) == 0.0 {
            return self.block.travel(machine, Wcs(self.start));
        }
        let here = machine.position().0;
        self.block.travel(machine, Wcs(self.raised(here)))?;
        self.block.travel(machine, Wcs(self.raised(self.block.placed(self.start, next.at))))
    }

    /// A position moved up by `_ID`.
    fn raised(&self, from: [f64; 3]) -> [f64; 3] {
        let mut to = from;
        to[self.block.axes[2]] += self.inputs.number(names::ID);
        to
    }

    /// Touches an edge from here; where the centre of the ball stood. Along the measuring axis it follows from the
    /// trigger value, which holds the skew, across from the skew.
    fn ball(&self, machine: &mut dyn Machine, touch: &Touch) -> Result<Point, Stop> {
        let Touch { axis, direction, path, .. } = *touch;
        let point = measuring_block::Point { axis, direction, set: 0.0, path };
        let surface = self.block.measure_from_here(machine, &point)?;
        let mut centre = [0, 1].map(|axis| touch.at[axis] + self.block.skew[axis]);
        centre[axis] = surface - direction * self.radius();
        Ok(centre)
    }
}

/// Direction of the edge and corner in the WCS, then in the machine (B:16033-16057).
fn report(machine: &mut dyn Machine, edge: [f64; 3], point: [f64; 3]) {
    let control = machine.control();
    let [abscissa, ordinate, _] = control.plane.axes();
    let (machine_edge, machine_point) = (control.direction_to_machine(Dir::new(edge)), control.to_machine(Wcs(point)));
    for (first, edge, point) in [(4, edge, point), (20, machine_edge.0, machine_point.0)] {
        results::angle(machine, first, edge[ordinate].atan2(edge[abscissa]).to_degrees());
        results::length(machine, first + 1, point[abscissa]);
        results::length(machine, first + 2, point[ordinate]);
    }
}

/// Abscissa along the reference edge, corner or a point beside it as zero; the applicate stays (B:7840-7844). Where the
/// zero lies from the corner counts in the turned system (B:7929-7935, B:8018-8026).
fn write(machine: &mut dyn Machine, inputs: &Inputs, target: &Target, edge: [f64; 3], point: [f64; 3]) {
    let control = machine.control();
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let edge = zero_offset::seen(control, target, edge);
    let turn = rigid::rotation(Rpy::about(applicate, Degrees::of(edge[ordinate].atan2(edge[abscissa]))));
    let rotation = zero_offset::rotation(control, target, &turn);
    let mut measured = Measured::at(point);
    for (axis, moved, name) in [(abscissa, MOVED_ABSCISSA, names::SETV2), (ordinate, MOVED_ORDINATE, names::SETV3)] {
        let beside = if moved.holds(inputs) { inputs.number(name) } else { 0.0 };
        measured.put(axis, -beside, point[axis]);
    }
    let writes = zero_offset::placed(control, target, rotation, &measured);
    correct::apply(machine, target, &writes); // no result tells so (B:7877-7888)
}
