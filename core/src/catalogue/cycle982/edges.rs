//! Which edge of a milling tool or drill touches: how the milling spindle is turned (B:9194-9200, B:9596-9610).

use super::params::{DRILL, REVERSAL, SPINDLE_AS_IT_IS};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::turnable;

/// Turn from one edge to the one opposite.
const OPPOSITE: Degrees = Degrees(180.0);

/// Angles at which the points are touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edges {
    /// Start angle; none where the spindle is left as it is: it turns already, or `_CHBIT[20]` = 1 (B:10088).
    start: Option<Degrees>,
    /// With a second edge at every point, turned by 180 degree and this angle (B:9600-9602).
    second: Option<Degrees>,
}

impl Edges {
    /// From parameters and the state of the spindle. With reversal it has to stand (61307), and to be turned it has to
    /// be one that can be positioned (61372).
    pub fn of(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Edges, Stop> {
        let control = machine.control();
        // a drill may be in a holder without a spindle
        let held = DRILL.holds(inputs) && !control.spindle_positions;
        let stays = held || SPINDLE_AS_IT_IS.holds(inputs) || control.spindle_speed != 0.0;
        let second = REVERSAL.holds(inputs).then(|| inputs.degrees(names::CORA));
        if stays && second.is_some() {
            return Err(alarm(machine, 61307));
        }
        if !stays {
            turnable(machine)?;
        }
        Ok(Edges { start: (!stays).then(|| inputs.degrees(names::STA1)), second })
    }

    /// Touches a point, `turned`: with the same edge turned to the other side first, unless with reversal, which
    /// touches a second time with the edge opposite. Mean position at switching, mm.
    pub fn touch(
        &self,
        machine: &mut dyn Machine,
        turned: bool,
        touch: impl Fn(&mut dyn Machine) -> Result<f64, Stop>,
    ) -> Result<f64, Stop> {
        let Some(start) = self.start else { return touch(machine) };
        let first = start + if turned && self.second.is_none() { OPPOSITE } else { Degrees(0.0) };
        machine.orient(first.positive());
        let latched = touch(machine)?;
        let Some(offset) = self.second else { return Ok(latched) };
        machine.orient((start + OPPOSITE + offset).positive());
        Ok((latched + touch(machine)?) / 2.0)
    }
}
