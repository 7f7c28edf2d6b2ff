//! What a measurement writes: the zero offset that is corrected, and the screen on which it is activated.

use super::{Input, Session};
use crate::control::{Control, Store};
use crate::geometry::{TOLERANCE, Wcs};
use crate::jog::activation::{self, Activation, Reasons};
use crate::jog::mask::Kind;
use crate::jog::offset::{self, Correction};
use crate::jog::upright;
use crate::jog::values::{ROTATION, Value};
use crate::machine::{Machine, MotionKind, Stop};
use crate::message::Message;

impl Session {
    /// The zero offset that the mask corrects; none: measuring only.
    pub fn chosen(&self) -> Option<Store> {
        let mask = self.mask?;
        let field = mask.field("zo")?;
        let Kind::Offset { turned } = field.kind else { return None };
        offset::named(&self.sim.control, self.values.word("zo"), turned)
    }

    /// Whether a zero offset has to be activated whatever is measured: it is not active while measuring, or a rotary
    /// axis takes the angle (B:3092).
    pub fn surely_activates(&self, store: Store) -> bool {
        if self.mask.is_some_and(|mask| mask.older.is_some()) {
            return false;
        }
        let inactive = matches!(store, Store::Settable(number) if number != self.measuring());
        let turned = self.values.word("angle_offset");
        inactive || turned != ROTATION && self.sim.control.rotary_axis(turned).is_some()
    }

    /// Whether what would be written has to be activated.
    pub(super) fn to_activate(&self) -> bool {
        if self.mask.is_some_and(|mask| mask.older.is_some()) {
            return false; // up to SW 6.2 there is no such screen
        }
        let Ok(outcome) = self.calculated() else { return false };
        let (Some(store), Some(correction)) = (self.chosen(), outcome.correction) else { return false };
        self.reasons(store, &correction).0.any()
    }

    /// Why a correction has to be activated, and whether it turns the WCS about the applicate.
    pub(super) fn reasons(&self, store: Store, correction: &Correction) -> (Reasons, bool) {
        let control = &self.sim.control;
        let mut after = control.clone();
        for write in offset::writes(control, store, correction) {
            after.set_variable(&write.name, write.value);
        }
        let (old, new) = (control.stored_frame(store), after.stored_frame(store));
        let rotary = match correction {
            Correction::Rotary(axis, angle) => Some((*axis, control.rotary[*axis] + *angle)),
            _ => None,
        };
        let inactive = matches!(store, Store::Settable(number) if number != control.settable);
        let tilts = offset::tilts(control, &old, &new);
        let swivels = tilts && swivels(&after, store);
        let aligned = matches!(correction, Correction::Rotary(_, angle) if angle.0.abs() <= TOLERANCE);
        (Reasons { inactive, tilts, swivels, rotary, aligned }, !tilts && old.rotation != new.rotation)
    }

    /// Shows the results, writes the zero offset; all points are grey again.
    pub(super) fn write(&mut self) -> Result<(), Message> {
        let outcome = self.calculated()?;
        if let (Some(store), Some(correction)) = (self.chosen(), &outcome.correction) {
            let (reasons, turned) = self.reasons(store, correction);
            self.measured_at = correction.place().map(|place| self.sim.control.to_machine(Wcs(place.actual)));
            self.correct(store, correction);
            if reasons.any() && self.mask.is_some_and(|mask| mask.older.is_none()) {
                self.activation = Some(Activation::new(store, reasons, turned));
            } else {
                let settable = self.sim.control.settable;
                self.sim.control.activate(settable); // effective at once (B:3722)
            }
        }
        self.outcome = outcome;
        self.measured = None;
        self.touched_in = None;
        self.points.fill(None);
        Ok(())
    }

    pub(super) fn correct(&mut self, store: Store, correction: &Correction) {
        for write in offset::writes(&self.sim.control, store, correction) {
            self.sim.write_correction(write.name, write.value);
        }
    }

    pub(super) fn toggle(&mut self, input: Input) -> Result<(), Message> {
        let (Input::Field(name, word), Some(activation)) = (input, &mut self.activation) else { return Ok(()) };
        activation.toggle(name, word)
    }

    /// Activates what was written: the probe is retracted, the zero offset becomes active, then the table turns the
    /// plane under the probe, or the rotary axis moves where the part is aligned (B:3903-3906).
    pub(super) fn activate(&mut self) -> Result<(), Stop> {
        let Some(activation) = self.activation.clone() else { return Ok(()) };
        if activation.says(activation::RETRACT) {
            let mut to = self.sim.position;
            to[2] = self.sim.above_turning().max(to[2]);
            self.sim.travel_machine(to, None, MotionKind::Rapid, 0.0, false)?;
        }
        if activation.says(activation::ACTIVATE) {
            self.sim.control = offset::in_effect(&self.sim.control, activation.store);
        }
        if activation.says(activation::ORIENT) {
            self.orient()?;
        }
        match activation.reasons.rotary.filter(|_| activation.says(activation::POSITION)) {
            Some((axis, to)) => self.sim.turn_table(axis, to),
            None => Ok(()),
        }
    }

    /// Turns the table until the active plane lies across the probe, as CYCLE800 does; the WCS turns with the part.
    pub(super) fn orient(&mut self) -> Result<(), Stop> {
        let Some((turns, table)) = upright::swivelled(&self.sim.control) else { return Ok(()) };
        for (axis, to) in turns.into_iter().enumerate() {
            if self.sim.control.rotary[axis] != to {
                self.sim.turn_table(axis, to)?;
            }
        }
        self.sim.control.part_frame = table;
        Ok(())
    }

    /// The zero offset that was activated is offered for the next measurement: to be active while measuring, and to be
    /// corrected (B:3784).
    pub(super) fn offer(&mut self) {
        let Some(activation) = self.activation.take() else { return };
        if let (Store::Settable(number), true) = (activation.store, activation.says(activation::ACTIVATE)) {
            self.offered = Some(number);
            let name = offset::name(&self.sim.control, activation.store);
            if self.mask.is_some_and(|mask| mask.field("zo").is_some()) {
                self.values.put("zo", Value::Word(name));
            }
        }
    }
}

/// Whether a machine has the rotary axes that have to move until the plane of a zero offset lies across the probe.
fn swivels(control: &Control, store: Store) -> bool {
    upright::swivelled(&offset::in_effect(control, store)).is_some()
}
