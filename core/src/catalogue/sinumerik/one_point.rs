//! One dimension in one axis, which CYCLE978, CYCLE974 and CYCLE994 find: results, and what they correct (B:6336-6349,
//! B:10461-10505, B:10936-10975).

use super::tolerance::Sizes;
use super::{target, tolerance};
use crate::catalogue::prelude::*;
use crate::evaluate::mean;
use crate::evaluate::zero_offset::Measured;

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnePoint {
    /// Measuring axis: 0 abscissa, 1 ordinate, 2 applicate.
    pub axis: usize,
    /// Axis in which a zero offset is corrected.
    pub corrected: usize,
    /// Direction of probing, +1 or -1.
    pub direction: f64,
    /// Where the centre of the ball was in the axes that were not measured, X Y Z of the WCS, mm.
    pub ball: [f64; 3],
    /// As given, mm.
    pub set: f64,
    /// As measured, mm.
    pub actual: f64,
    /// How much both are of a length along the axis: 2 for a diameter.
    pub per: f64,
}

/// Setpoint, actual value and difference, each also in the entry of its axis (B:6336-6349).
fn report(machine: &mut dyn Machine, found: &OnePoint, set: f64) {
    for (first, value) in [(0, set), (4, found.actual), (16, found.actual - set)] {
        results::length(machine, first, value);
        results::length(machine, first + 1 + found.axis, value);
    }
}

impl target::Found for OnePoint {
    /// The position decides over the tool: undivided, of a diameter half (B:6698-6699, B:10743-10745).
    fn sizes(&self, machine: &mut dyn Machine, inputs: &Inputs) -> Sizes {
        let middle = tolerance::middle(inputs, self.set);
        report(machine, self, middle.setpoint);
        results::length(machine, 8, middle.upper);
        results::length(machine, 12, middle.lower);
        let difference = self.actual - middle.setpoint;
        Sizes { differences: vec![difference], factor: 1.0 / self.per, radius_sign: self.direction }
    }

    /// The position, less the empirical value, decides over the zero offset (B:6436-6450, B:10525).
    fn place(&self, machine: &mut dyn Machine, inputs: &Inputs) -> (Vec<f64>, Measured) {
        report(machine, self, self.set);
        tolerance::report_empirical(machine, inputs);
        results::begin_zero(machine, inputs);
        results::integer(machine, 7, mean::memories(inputs.integer(names::EVNUM)).empirical);
        let counted = self.actual - tolerance::empirical(machine.control(), inputs);
        let axes = machine.control().plane.axes();
        let [own, corrected] = [self.axis, self.corrected].map(|axis| axes[axis.min(2)]);
        let mut place = self.ball;
        place.swap(own, corrected); // as if it had been measured in the axis that is corrected
        let mut measured = Measured::at(place);
        measured.put(corrected, self.set / self.per, counted / self.per);
        (vec![counted - self.set], measured)
    }
}
