//! Sizes and a centre, which CYCLE977 and CYCLE979 find: results, and what they correct (B:5675-5724, B:6779-6814).

use super::tolerance::Sizes;
use super::{target, tolerance};
use crate::catalogue::place::in_plane;
use crate::catalogue::prelude::*;
use crate::evaluate::zero_offset::Measured;

/// A value as it should be and as it was measured, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// As given.
    pub set: f64,
    /// As measured.
    pub actual: f64,
}

/// What was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Diameter or width, or both lengths of a rectangle.
    pub sizes: Vec<Pair>,
    /// Centre in abscissa and ordinate. Where an axis is not measured, both values are the same.
    pub centre: [Pair; 2],
    /// Applicate of the ball's centre while measuring, mm: at this height lies the centre that was found.
    pub height: f64,
    /// Axes in which the centre was measured: 0 abscissa, 1 ordinate.
    pub axes: &'static [usize],
    /// Hole, groove or inside rectangle.
    pub inside: bool,
}

/// Setpoints, actual values and differences: first the sizes, then the centre.
fn report(machine: &mut dyn Machine, sizes: &[Pair], centre: &[Pair]) {
    for (index, Pair { set, actual }) in sizes.iter().chain(centre).enumerate() {
        results::length(machine, index, *set);
        results::length(machine, 4 + index, *actual);
        results::length(machine, 16 + index, actual - set);
    }
}

impl target::Found for Found {
    /// The size decides over the tool (B:6123-6137, B:7105-7117).
    fn sizes(&self, machine: &mut dyn Machine, inputs: &Inputs) -> Sizes {
        let mut sizes = self.sizes.clone();
        for (index, size) in sizes.iter_mut().enumerate() {
            let middle = tolerance::middle(inputs, size.set);
            size.set = middle.setpoint;
            results::length(machine, 8 + index, middle.upper);
            results::length(machine, 12 + index, middle.lower);
        }
        report(machine, &sizes, &self.centre);
        let differences = sizes.iter().map(|size| size.actual - size.set).collect();
        Sizes { differences, factor: 0.5, radius_sign: if self.inside { 1.0 } else { -1.0 } }
    }

    /// The centre decides over the zero offset (B:6153-6171, B:7133-7149).
    fn place(&self, machine: &mut dyn Machine, inputs: &Inputs) -> (Vec<f64>, Measured) {
        report(machine, &self.sizes, &self.centre);
        results::begin_zero(machine, inputs);
        let [abscissa, ordinate] = self.centre.map(|pair| pair.actual);
        let control = machine.control();
        let mut measured = Measured::at(in_plane(control, [abscissa, ordinate, self.height]));
        let mut differences = Vec::new();
        for axis in self.axes.iter().copied() {
            let Pair { set, actual } = self.centre[axis];
            measured.put(control.plane.axes()[axis], set, actual);
            differences.push(actual - set);
        }
        (differences, measured)
    }
}
