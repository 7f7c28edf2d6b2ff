//! The same session on the part where it would lie had nobody moved it: by it is known where a zero offset should be.
//! It measures from the same places of the part, so what differs is how well the part was found.

use super::chance::Truth;
use super::offset::{self, Correction, Turn};
use super::session::Session;
use super::states::State;
use crate::control::{AXES, Control};
use crate::evaluate::zero_offset::Measured;
use crate::geometry::{Degrees, Mcs, V3, Wcs};
use crate::machine::Setup;
use crate::message::Message;

/// How far a zero offset that was written is from where it should be: by the letters of the axes, mm, and about them,
/// degree.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deviation {
    /// Of what was measured, at the place where it was.
    pub lengths: Vec<(&'static str, f64)>,
    /// How the part lies in the WCS.
    pub angles: Vec<(&'static str, f64)>,
}

/// The session on the part that nobody moved.
#[derive(Clone, Debug)]
pub struct Shadow {
    session: Session,
    setup: Setup,
    truth: Truth,
    /// It could not follow.
    lost: bool,
}

impl Shadow {
    /// Of a machine before its part was put.
    pub fn new(setup: &Setup, truth: Truth) -> Shadow {
        let mut setup = setup.clone();
        Truth { size: truth.size, ..Truth::default() }.put(&mut setup);
        Shadow { session: Session::new(&setup), setup, truth, lost: false }
    }

    /// Does what was done, but for motions.
    pub fn follow(&mut self, done: impl FnOnce(&mut Session) -> Result<(), Message>, after: &Session) {
        let refused = done(&mut self.session).is_err();
        self.lost |= refused || self.session.stopped().is_some();
        self.session.become_like(after);
        self.lost |= self.session.sim.control.rotary != after.sim.control.rotary; // the part was turned away from it
        let stored = |session: &Session| session.points().iter().map(Option::is_some).collect::<Vec<_>>();
        self.lost |= stored(&self.session) != stored(after);
    }

    /// Measures from the same place of the part; what calibrates stays out, so that an error in it shows.
    pub fn measure(&mut self, from: Mcs, after: &Session) {
        let corrects = after.mask().is_some_and(|mask| mask.task.corrects());
        let at = self.truth.moved(&self.setup, from, true);
        let measures = corrects && after.state() != State::Alarm;
        let go = |session: &mut Session| {
            session.sim.position = at;
            if measures { session.carry_out(super::Input::Start) } else { Ok(()) }
        };
        self.follow(go, after);
    }

    /// How far what was written is from where it should be; none: nothing was, or it is not known.
    pub fn deviation(&self, session: &Session) -> Option<Deviation> {
        let (store, wrote) = (session.chosen()?, session.outcome().correction.as_ref()?);
        let known = self.session.outcome().correction.as_ref().filter(|_| !self.lost)?;
        let level = match wrote {
            Correction::Rotary(..) => return None,
            Correction::Turn(turn, _) => matches!(turn, Turn::Level(_)),
            Correction::Place(_) => false,
        };
        let [have, want] = [session, &self.session].map(|one| offset::in_effect(&one.sim.control, store));
        let plane = have.plane.axes();
        let wanted = |at: Wcs| V3::from(self.truth.moved(&self.setup, want.to_machine(at), false));
        let zero = wanted(Wcs([0.0; 3]));
        let axes: [V3; 3] = std::array::from_fn(|axis| (wanted(Wcs(unit(axis))) - zero).normalize());
        let place = wrote.place();
        let pair = place.zip(session.measured_at()).zip(known.place().zip(self.session.measured_at()));
        let lengths = pair.map_or(Vec::new(), |((place, at), (nominal, there))| {
            let found = V3::from(have.to_machine(put(&have, at, place)));
            let off = found - wanted(put(&want, there, nominal));
            (0..3).filter(|axis| place.axes[*axis]).map(|axis| (AXES[axis], off.dot(&axes[axis]))).collect()
        });
        let direction = |axis: usize| direction(&have, axis);
        let [abscissa, ordinate, applicate] = plane;
        let angles = if level {
            let [x, y, z] = [abscissa, ordinate, applicate].map(|axis| direction(applicate).dot(&axes[axis]));
            vec![(abscissa, Degrees::of((-y).atan2(z))), (ordinate, Degrees::of(x.atan2(z)))]
        } else if place.is_none_or(in_plane(plane)) {
            let along = direction(abscissa);
            vec![(applicate, Degrees::of(along.dot(&axes[ordinate]).atan2(along.dot(&axes[abscissa]))))]
        } else {
            Vec::new()
        };
        let angles = angles.into_iter().map(|(axis, angle)| (AXES[axis], angle.0)).collect();
        Some(Deviation { lengths, angles })
    }
}

fn unit(axis: usize) -> [f64; 3] {
    std::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 })
}

/// Direction of an axis of the WCS in the machine.
fn direction(control: &Control, axis: usize) -> V3 {
    let [zero, end] = [[0.0; 3], unit(axis)].map(|at| V3::from(control.to_machine(Wcs(at))));
    (end - zero).normalize()
}

/// Whether something was measured in the plane, where the angle of the part is to be seen.
fn in_plane([abscissa, ordinate, _]: [usize; 3]) -> impl Fn(&Measured) -> bool {
    move |measured| measured.axes[abscissa] || measured.axes[ordinate]
}

/// A place of the machine in the WCS, with the set positions of what was measured there: the set positions alone are
/// no place, because what was not measured has another coordinate in each zero offset.
fn put(control: &Control, at: Mcs, measured: &Measured) -> Wcs {
    let seen = control.to_workpiece(at);
    Wcs(std::array::from_fn(|axis| if measured.axes[axis] { measured.set[axis] } else { seen[axis] }))
}
