//! A milling machine with a tool probe and calls for it, for the tests of CYCLE971.

#![allow(clippy::unwrap_used)]

use crate::catalogue::cycle971::CYCLE971;
use crate::catalogue::sinumerik::testing;
use crate::control::{Plane, Units};
use crate::entry::Inputs;
use crate::machine::{Setup, Sim};
use crate::workpiece::{Cut, Cutter, Noise, Tool};

pub const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

/// Default values, wide bands, and these.
pub fn call(variant: i64, plane: Plane, values: &[(&'static str, f64)]) -> Inputs {
    let mut all = vec![("_FA", 4.0), ("_TZL", 0.0), ("_TDIF", 1.9), ("_TSA", 2.0)];
    all.extend(values);
    let mut inputs = testing::call("CYCLE971", variant, &all);
    inputs.plane = plane;
    inputs
}

/// The machine with the probe that the call proposes and the mill before it.
pub fn setup(inputs: &Inputs) -> Setup {
    setup_in(inputs, Units::Metric)
}

/// A setup on a machine with this basic system of units.
pub fn setup_in(inputs: &Inputs, units: Units) -> Setup {
    let mut setup = Setup::calibrated_in(crate::dialect::Dialect::Sinumerik, inputs.plane, units);
    setup.suit(&CYCLE971, 0);
    place(setup, inputs)
}

/// A machine as it is with the probe that the call proposes and the mill before it.
pub fn place(mut setup: Setup, inputs: &Inputs) -> Setup {
    let proposal = (CYCLE971.work().unwrap().propose)(inputs, &setup.control);
    setup.tool_probes = proposal.tool_probes;
    setup.position = setup.control.to_machine(proposal.start);
    setup
}

/// What the mill really is.
pub fn real(setup: &mut Setup, length: f64, cutter: Cutter) {
    let tool = Tool { length: [length, 0.0, 0.0], cut: Cut::Cutter(cutter) };
    setup.real_tools.insert((3, 1), tool);
}

/// The call on a machine, which has to end well.
pub fn measured(setup: &Setup, inputs: &Inputs) -> Sim {
    let (sim, outcome) = testing::called(setup, inputs);
    assert_eq!(outcome, Ok(()), "{:?}", inputs.numbers);
    sim
}

/// Evenly spread between -0.5 and 0.5.
pub fn random(noise: &mut Noise) -> f64 {
    noise.uniform() - 0.5
}

/// Moves the real probe by errors in X, Y, Z, and makes it wider in abscissa and ordinate.
pub fn displace(setup: &mut Setup, shift: [f64; 3], size: f64) {
    let errors = &mut setup.tool_probes[0].solid.errors;
    (errors.shift, errors.size) = (shift, size);
}

/// Data of the probe by axis (X Y Z) and direction.
pub fn name(array: &str, axis: usize, plus: bool) -> String {
    format!("{array}[0,{}]", 2 * axis + usize::from(plus))
}

/// Where a side of the displaced probe is.
pub fn side(before: &Setup, array: &str, axis: usize, plus: bool, shift: [f64; 3], size: f64) -> f64 {
    let grown = if plus { -size / 2.0 } else { size / 2.0 };
    before.control.number(&name(array, axis, plus)) + shift[axis] + grown
}
