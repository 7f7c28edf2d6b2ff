//! What CYCLE998 corrects: the rotation of a frame, or the translation of the rotary axis on which the part is clamped
//! (B:7262-7278, B:7371-7391).

use super::angles::Surface;
use super::params::ONE;
use crate::catalogue::place::in_plane;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::correct;
use crate::evaluate::level;
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::Target;
use crate::geometry::{Degrees, Rpy, rigid};
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
        let axes = control.plane.axes();
        let normal = |wrong: &[f64]| in_plane(control, surface.normal(wrong).into());
        let (wanted, actual) = (normal(&[0.0; 2]), normal(wrong));
        let Some(target) = self.target else {
            let turn = level::tilt(control.plane, &wanted.into(), &actual.into(), &Rotation3::identity());
            return added(machine, axes, turn);
        };
        let before = control.stored_frame(target.store).rotation;
        let seen = zero_offset::seen(control, &target, actual);
        let rotation = zero_offset::levelled(control, &target, wanted, seen);
        let writes = zero_offset::turned(control, &target, rotation);
        let turn = level::added(machine.control().plane, before, rotation);
        added(machine, axes, turn);
        correct::frame(machine, &target, &writes);
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

/// Reports what is added to the rotation of a frame about abscissa, ordinate and applicate, from -180 to 180 degree
/// (B:7339-7348).
fn added(machine: &mut dyn Machine, axes: [usize; 3], turn: Rpy) {
    for (index, axis) in axes.into_iter().enumerate() {
        let angle = turn[axis];
        results::angle(machine, 21 + index, angle - 360.0 * (angle / 360.0).round());
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
