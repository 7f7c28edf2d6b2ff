//! What CYCLE998 corrects: the rotation of a frame, or the translation of the rotary axis on which the part is clamped
//! (B:7262-7278, B:7371-7391).

use super::angles::Surface;
use super::params::ONE;
use crate::catalogue::place::in_plane;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::correct;
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::Target;
use crate::geometry::{Degrees, Rpy, V3, rigid};
use nalgebra::Rotation3;

/// Where the angle goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// The frame; none with `_KNUM` = 0.
    target: Option<Target>,
    /// Rotary axis of the frame that is corrected; none: the rotation of the frame.
    rotary: Option<usize>,
}

impl Correction {
    /// Finds the frame, and the rotary axis of `_RA` (61329, A:15872).
    pub fn prepare(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Correction, Stop> {
        let target = correct::zero_target(machine, inputs)?;
        let number = if ONE.holds(inputs) { inputs.integer(names::RA) } else { 0 };
        let rotary = machine.control().rotary_channel_axis(number);
        if number != 0 && rotary.is_none() {
            return Err(alarm(machine, 61329));
        }
        Ok(Correction { target, rotary })
    }

    /// Corrects by the angles by which the surface is wrong, in the order of its ways.
    pub fn write(&self, machine: &mut dyn Machine, surface: &Surface, wrong: &[f64]) {
        match wrong {
            [angle] => self.one(machine, surface, *angle),
            both => self.two(machine, surface, both),
        }
    }

    fn one(&self, machine: &mut dyn Machine, surface: &Surface, wrong: f64) {
        let control = machine.control();
        let amount = match (&self.target, self.rotary) {
            (Some(target), None) => seen_wrong(control, target, surface, wrong),
            (_, Some(axis)) => wrong * 1.0_f64.copysign(surface.alike(control, axis)),
            _ => wrong,
        };
        results::angle(machine, 20, amount);
        if let (Some(target), Some(axis)) = (self.target, self.rotary) {
            let writes = zero_offset::rotary(machine.control(), &target, axis, Degrees(amount), false);
            return correct::frame(machine, &target, &writes);
        }
        let axis = machine.control().plane.axes()[surface.third()];
        self.turn(machine, &rigid::rotation(Rpy::about(axis, Degrees(amount))));
    }

    fn two(&self, machine: &mut dyn Machine, surface: &Surface, wrong: &[f64]) {
        let control = machine.control();
        let normal = |wrong: &[f64]| V3::from(in_plane(control, surface.normal(wrong).into()));
        let (wanted, actual) = (normal(&[0.0; 2]), normal(wrong));
        let seen = match &self.target {
            Some(target) => zero_offset::seen(control, target, actual.into()).into(),
            None => actual,
        };
        let turn = rigid::between(&wanted, &seen);
        let angles = rigid::angles(&turn);
        for (index, axis) in control.plane.axes().into_iter().enumerate() {
            results::angle(machine, 21 + index, angles[axis]);
        }
        self.turn(machine, &turn);
    }

    /// Turns the frame, where there is one.
    fn turn(&self, machine: &mut dyn Machine, turn: &Rotation3<f64>) {
        if let Some(target) = self.target {
            let control = machine.control();
            let writes = zero_offset::turned(control, &target, zero_offset::rotation(control, &target, turn));
            correct::frame(machine, &target, &writes);
        }
    }
}

/// By how much a direction of the surface is wrong when the frame is active as it is stored.
fn seen_wrong(control: &Control, target: &Target, surface: &Surface, wrong: f64) -> f64 {
    let leg = surface.legs[0];
    let seen = zero_offset::seen(control, target, in_plane(control, surface.along(wrong).into()));
    let [along, up] = [leg.axis, surface.measuring].map(|axis| seen[control.plane.axes()[axis]]);
    let angle = leg.sense * up.atan2(along).to_degrees() - leg.set;
    // an edge has no beginning: turned by 180 degree it is the same
    angle - 180.0 * (angle / 180.0).round()
}
