//! CYCLE800: the table turns the part until a plane lies across the tool, and the coordinate systems turn with it
//! (B:7696-7786, B:7773-7782). The machine axes stay where they are. Data set and retraction choose between ways that
//! end in the same plane. How its digits count is from memory of the field: the guide of the cycle is not among the
//! manuals of this project.

use super::{Call, Datum, Halt, Interpreter, contour, noted, transformed::Axes, unread};
use crate::control::Frame;
use crate::geometry::rigid::{angles, rotation};
use crate::geometry::{Degrees, Rpy};
use crate::problem::Problem;
use crate::program::of_control::SWIVEL;

/// Argument with the name of the swivel data set, and the name by which none is meant.
const DATA_SET: usize = 1;
const NO_DATA_SET: &str = "0";
/// Argument whose last digit is 1 where the plane adds to the one before.
const STATE: usize = 2;
/// Argument with the meaning and the order of the angles.
const MODE: usize = 3;
/// X0 Y0 Z0, the angles, X1 Y1 Z1.
const SHIFT: usize = 4;
const ANGLES: usize = 7;
const SHIFT_BEHIND: usize = 10;
/// Argument that is 0 where the axes do not turn.
const DIRECTION: usize = 13;

/// Carries out a call.
pub fn swivel(run: &mut Interpreter, call: &Call) -> Result<(), Halt> {
    contour::finish(run)?;
    if run.modal.axes == Axes::Swivelled {
        run.modal.axes = Axes::Move;
    }
    if given_up(call) {
        let control = &mut run.sim.control;
        (control.part_frame, control.plane_frame) = (Frame::default(), Frame::default());
        return Ok(());
    }
    let Some(plane) = plane(run, call)? else {
        noted::without(run, "run-swivel", call.span, SWIVEL);
        run.modal.axes = Axes::Swivelled;
        unread::leave_all_axes(run, call.span);
        return Ok(());
    };
    run.sim.control.plane_frame = plane;
    if call.arg(DIRECTION) == Some(&Datum::Number(0.0)) {
        return Ok(());
    }
    let planned = run.sim.control.swivelled();
    let (turns, table) = planned.ok_or_else(|| Problem::new("run-shear", call.span, SWIVEL))?;
    for (axis, to) in turns.into_iter().enumerate() {
        if run.sim.control.rotary[axis] != to {
            run.sim.turn_table(axis, to).map_err(Halt::at(call.span))?;
        }
    }
    run.sim.control.part_frame = table;
    Ok(())
}

/// Whether the call gives the plane up: without values, or with the data set "0". The table stays where it is.
fn given_up(call: &Call) -> bool {
    call.args.iter().all(Option::is_none) || call.arg(DATA_SET) == Some(&Datum::Text(NO_DATA_SET.into()))
}

/// The plane that the call describes, in the WCS before it; none: its angles are not simulated.
fn plane(run: &Interpreter, call: &Call) -> Result<Option<Frame>, Problem> {
    let wrong = || Problem::new("run-not-a-number", call.span, SWIVEL);
    let number = |index: usize| call.number(index).filter(|number| number.is_finite()).ok_or_else(wrong);
    let triple = |from: usize| Ok([number(from)?, number(from + 1)?, number(from + 2)?]);
    let factor = run.sim.control.active_factor();
    let shift = |from: usize| Ok(Frame::translation(triple(from)?.map(|length: f64| length * factor)));
    let Some(turn) = turned(number(MODE)? as i64, triple(ANGLES)?) else { return Ok(None) };
    let own = shift(SHIFT)?.then(&turn).then(&shift(SHIFT_BEHIND)?);
    let adds = number(STATE)? as i64 % 10 == 1;
    Ok(Some(if adds { run.sim.control.plane_frame.then(&own) } else { own }))
}

/// The rotation by three angles. Bits 6 and 7 of the mode tell what they are: 0 about one axis after the other, which
/// the lower pairs of bits name (1 X, 2 Y, 3 Z), 1 about Z and then Y. Projections and positions of the rotary axes
/// are not simulated, unless all are 0.
fn turned(mode: i64, given: [f64; 3]) -> Option<Frame> {
    let about = |axis: usize, angle: f64| rotation(Rpy::about(axis, Degrees(angle)));
    let [first, second, third] = given;
    let turn = match mode >> 6 & 3 {
        _ if given == [0.0; 3] => return Some(Frame::default()),
        0 => {
            let axis = |place: usize| (mode >> (2 * place) & 3) as usize;
            let pairs = given.into_iter().enumerate().filter(|(place, _)| axis(*place) > 0);
            pairs.fold(about(0, 0.0), |turn, (place, angle)| turn * about(axis(place) - 1, angle))
        }
        1 => about(2, first) * about(1, second) * about(2, third),
        _ => return None,
    };
    Some(Frame { rotation: angles(&turn), ..Frame::default() })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::V3;

    // oracle: hand (57 is 11 10 01: about X, then Y, then Z; 27 is 01 10 11: about Z, then Y, then X)
    #[test]
    fn angles_turn_about_one_axis_after_the_other() {
        let turn = |mode: i64, angles: [f64; 3]| turned(mode, angles).map(|frame| rotation(frame.rotation));
        let z = V3::new(0.0, 0.0, 1.0);
        let near = |found: V3, wanted: [f64; 3]| assert!((found - V3::from(wanted)).norm() < 1e-12, "{found}");
        near(turn(57, [90.0, 0.0, 0.0]).unwrap() * z, [0.0, -1.0, 0.0]);
        near(turn(57, [90.0, 90.0, 0.0]).unwrap() * z, [1.0, 0.0, 0.0]);
        near(turn(27, [90.0, 90.0, 0.0]).unwrap() * z, [0.0, 1.0, 0.0]);
        near(turn(64, [90.0, 90.0, 0.0]).unwrap() * z, [0.0, 1.0, 0.0]);
        assert!(turn(192, [10.0, 0.0, 0.0]).is_none() && turn(192, [0.0; 3]).is_some());
    }
}
