//! Walls on both sides of a centre, in one axis of the plane: pocket, web, bore, boss, and the ring of calibration.

use super::correct::{Found, Place, RADIUS};
use super::touch::{Calibration, POSITIONING, touch};
use super::{given, part};
use crate::catalogue::prelude::*;
use crate::machine::MotionKind;

/// The stylus stands between the walls.
pub const INSIDE: i64 = 0;
/// The stylus stands above; the address of the tool axis says how deep to measure.
pub const OUTSIDE: i64 = 1;

/// The address of the tool axis means that it is measured from outside, whatever its value (C:911, C:1076).
pub const fn from_outside(along_tool: When) -> Chooses {
    Chooses { when: along_tool, variant: OUTSIDE, typed: "0" }
}

/// Coordinate of the tool axis at which walls are touched from outside, mm.
pub fn depth(inputs: &Inputs) -> Option<f64> {
    given(inputs, 2).filter(|_| inputs.variant == OUTSIDE)
}

/// An opening whose upper face is the zero of the WCS, the stylus inside it; or a body with the stylus above it.
/// `shape` gets whether it is touched from outside, and its height or depth, mm.
pub fn propose(inputs: &Inputs, control: &Control, shape: impl Fn(bool, f64) -> Shape) -> Proposal {
    let (height, top, start) = match depth(inputs) {
        Some(depth) => {
            let top = (depth + 10.0).max(0.0);
            (top - depth + 20.0, top, top + 20.0)
        }
        None => (30.0, 0.0, -10.0),
    };
    part::propose(shape(depth(inputs).is_some(), height), [0.0, 0.0, top], [0.0, 0.0, start], control)
}

/// Where walls are looked for.
pub struct Walls<'a> {
    inputs: &'a Inputs,
    /// Nominal distance, mm.
    pub size: f64,
    /// Position at the call: over or in the nominal centre, WCS, mm.
    pub start: [f64; 3],
    /// Axes of the plane, then that of the tool.
    pub axes: [usize; 3],
}

/// Walls of one axis as found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// Middle between the walls, WCS, mm.
    pub middle: f64,
    /// Half way of the ball centre between the contacts, mm.
    pub half: f64,
    /// Mean effective ball radius, mm.
    pub ball: f64,
}

impl Walls<'_> {
    /// Of a macro with this nominal distance.
    pub fn of<'a>(machine: &mut dyn Machine, inputs: &'a Inputs, size: f64) -> Walls<'a> {
        Walls { inputs, size, start: machine.position().0, axes: machine.control().plane.axes() }
    }

    /// What was found between them: deviation of their distance, and the places of their middle.
    pub fn found<'a>(&self, deviation: f64, places: &'a [Place]) -> Found<'a> {
        Found { deviation, size: Some(self.size), metal: self.material(), places, register: RADIUS }
    }

    /// +1 where the material is between the walls (web, boss), so that a greater size is more metal; −1 where it is
    /// beyond them (pocket, bore).
    pub fn material(&self) -> f64 {
        if depth(self.inputs).is_some() { 1.0 } else { -1.0 }
    }

    /// Over the part to the clearance beside it, down, to the wall, back and up (C:1076-1077).
    fn outside(&self, machine: &mut dyn Machine, axis: usize, wall: f64, side: f64, depth: f64) -> Result<f64, Stop> {
        let applicate = self.axes[2];
        let beside = wall + side * self.inputs.number(address::R);
        travel(machine, axis, beside)?;
        travel(machine, applicate, depth)?;
        let position = touch(machine, axis, wall - side * self.inputs.number(address::Q))?;
        travel(machine, axis, beside)?;
        travel(machine, applicate, self.start[applicate])?;
        Ok(position)
    }
}

/// Both walls of the first (0) or second (1) axis of the plane, + side first; ends where it began.
pub fn chord(machine: &mut dyn Machine, walls: &Walls, index: usize) -> Result<Chord, Stop> {
    let calibration = Calibration::of(machine, index);
    let axis = walls.axes[index];
    let at = |side: f64, way: f64| walls.start[axis] + side * way - calibration.offset;
    let spindle = match depth(walls.inputs) {
        Some(depth) => {
            let [upper, lower] = [1.0, -1.0].map(|side| at(side, walls.size / 2.0 + calibration.radius(-side)));
            let first = walls.outside(machine, axis, upper, 1.0, depth)?;
            [first, walls.outside(machine, axis, lower, -1.0, depth)?]
        }
        None => {
            let past = walls.inputs.number(address::Q);
            let end = |side: f64| at(side, walls.size / 2.0 - calibration.radius(side) + past);
            across(machine, axis, [1.0, -1.0].map(end))?
        }
    };
    let moving = -walls.material();
    let ball_at = spindle.map(|position| position + calibration.offset);
    let (upper, lower) = (calibration.radius(moving), calibration.radius(-moving));
    let wall = [ball_at[0] + moving * upper, ball_at[1] - moving * lower];
    Ok(Chord { middle: (wall[0] + wall[1]) / 2.0, half: (ball_at[0] - ball_at[1]) / 2.0, ball: (upper + lower) / 2.0 })
}

/// Touches along one axis towards both ends, the + side first, from where the machine stands and back to there each
/// time. Coordinates of the spindle at the contacts.
pub fn across(machine: &mut dyn Machine, axis: usize, ends: [f64; 2]) -> Result<[f64; 2], Stop> {
    let from = machine.position()[axis];
    let mut contacts = [0.0; 2];
    for (end, contact) in ends.into_iter().zip(&mut contacts) {
        *contact = touch(machine, axis, end)?;
        travel(machine, axis, from)?;
    }
    Ok(contacts)
}

/// Protected positioning along one axis.
pub fn travel(machine: &mut dyn Machine, axis: usize, to: f64) -> Result<(), Stop> {
    let mut target = machine.position();
    if target[axis] == to {
        return Ok(());
    }
    target[axis] = to;
    machine.travel(target, MotionKind::Positioning, POSITIONING, true)
}

/// Back to the start: along the tool axis first, then in the plane.
pub fn home(machine: &mut dyn Machine, start: Wcs) -> Result<(), Stop> {
    let [.., applicate] = machine.control().plane.axes();
    travel(machine, applicate, start[applicate])?;
    machine.travel(Wcs(start.0), MotionKind::Positioning, POSITIONING, true)
}
