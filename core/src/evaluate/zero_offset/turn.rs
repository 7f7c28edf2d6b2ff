//! Rotations of a corrected frame, after which a turned part stands right (B:7371, B:7844, B:8411, DESIGN.md).

use super::{Measured, SAME, Store, Target, around, coarse, missing, part};
use crate::control::{AXES, Control, Frame, ROTARY};
use crate::evaluate::{Write, level};
use crate::geometry::{Degrees, Rpy, V3, rigid};
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Vector3};

/// A direction of the present WCS as it is seen when the frame to be corrected is active as it is stored.
pub fn seen(control: &Control, target: &Target, direction: [f64; 3]) -> [f64; 3] {
    (towards(control, target) * Vector3::from(direction)).into()
}

/// How the part is turned from where it should be (directions of the part = `turn` · set directions), given for the
/// present WCS, as it is seen when the frame to be corrected is active as it is stored.
pub fn seen_turn(control: &Control, target: &Target, turn: &Rotation3<f64>) -> Rotation3<f64> {
    Rotation3::from_matrix_unchecked(towards(control, target) * turn.matrix())
}

/// Rotation of the frame to correct after which a part turned by `turn` (as [`seen_turn`] gives it) stands right.
pub fn rotation(control: &Control, target: &Target, turn: &Rotation3<f64>) -> Rpy {
    let (_, old, after) = around(control, target);
    let inner = of(&[Frame { rotation: Rpy::default(), ..old }]) * of(&after);
    let outward = Rotation3::from_matrix_unchecked(inner * turn.matrix() * inner.transpose());
    changed(&old, &(rigid::rotation(old.rotation) * outward))
}

/// Rotation of the frame to correct after which a surface with the normal `seen`, which [`seen`] gives, has the normal
/// `wanted`: turned about abscissa and ordinate, about the applicate as the frame is ([`level`]); where frames behind
/// it lean so far that no such rotation gets there, the smallest turn more.
pub fn levelled(control: &Control, target: &Target, wanted: [f64; 3], seen: [f64; 3]) -> Rpy {
    let (_, old, after) = around(control, target);
    let inner = of(&[Frame { rotation: Rpy::default(), ..old }]) * of(&after);
    let before = rigid::rotation(old.rotation);
    let [.., applicate] = control.plane.axes();
    let heading = rigid::rotation(Rpy::about(applicate, level::heading(control.plane, &before)));
    let [wanted, seen]: [V3; 2] = [wanted, seen].map(|normal| inner * V3::from(normal));
    let (there, tilted) = (before * seen, heading.inverse() * before);
    let reached = heading * rigid::rotation(level::tilt(control.plane, &wanted, &(tilted * seen), &tilted));
    let got = reached * wanted;
    if (got.normalize() - there.normalize()).norm() < level::SAME {
        return changed(&old, &reached);
    }
    changed(&old, &(rigid::between(&got, &there) * reached))
}

/// Angles of a rotation; where one is that of the frame but for rounding, it is.
fn changed(old: &Frame, rotation: &Rotation3<f64>) -> Rpy {
    let angles = rigid::angles(rotation);
    Rpy(std::array::from_fn(|axis| {
        if (angles[axis] - old.rotation[axis]).abs() < SAME { old.rotation[axis] } else { angles[axis] }
    }))
}

/// What writes this rotation alone.
pub fn turned(control: &Control, target: &Target, rotation: Rpy) -> Vec<Write> {
    let (_, old, _) = around(control, target);
    part(target, &AXES, "RT", rotation.0, old.rotation.0)
}

/// What writes this rotation and the translation to the set coordinates, into the coarse part (B:7840-7844, B:8411).
pub fn placed(control: &Control, target: &Target, rotation: Rpy, measured: &Measured) -> Vec<Write> {
    let (before, old, after) = around(control, target);
    let turned = Frame { rotation, ..old };
    let shift = missing(control, (&before, &turned, &after), measured);
    let mut writes = coarse(target, &old, shift);
    writes.extend(part(target, &AXES, "RT", rotation.0, old.rotation.0));
    writes
}

/// What writes an angle to the translation of a rotary axis, in addition to what is in effect (B:7410-7411):
/// into the fine part with MD18600 = 1, else, and of a `whole` correction, into the coarse part, which takes the fine
/// one in (B:1990-2003).
pub fn rotary(control: &Control, target: &Target, axis: usize, angle: Degrees, whole: bool) -> Vec<Write> {
    let (_, stored, _) = around(control, target);
    let settable = (Store::Settable(control.settable), &control.active);
    let mut in_effect = control.basic_in_effect().chain([settable]);
    let effective = in_effect.find(|(store, _)| *store == target.store).map_or(stored, |(_, frame)| *frame);
    let rotary_part = |name, value: Degrees, before: [Degrees; 3]| {
        let before = before.map(|angle| angle.0);
        let mut changed = before;
        changed[axis] = value.0;
        part(target, &ROTARY, name, changed, before)
    };
    let (coarse, fine) = (effective.rotary[axis], effective.rotary_fine[axis]);
    let angle = angle + given_up(control, target, axis);
    if !whole && target.store != Store::System && control.number("MD18600") != 0.0 {
        return rotary_part("FI", fine + angle, stored.rotary_fine);
    }
    let mut writes = rotary_part("TR", coarse + fine + angle, stored.rotary);
    writes.extend(rotary_part("FI", Degrees(0.0), stored.rotary_fine));
    writes
}

/// By how much less a rotary axis moves: `_KNUM` = 1000 replaces the settable frame by that of G500.
fn given_up(control: &Control, target: &Target, axis: usize) -> Degrees {
    if !target.without_settable {
        return Degrees(0.0);
    }
    let moved = |frame: &Frame| frame.rotary[axis] + frame.rotary_fine[axis];
    moved(&control.active) - moved(&control.stored_frame(Store::Settable(0)))
}

/// What turns and moves a frame so that what lies where `motion` takes it from its set position has the set coordinates
/// (B:8411); X Y Z of the present WCS, mm. `set` is one of those positions.
pub fn moved(control: &Control, target: &Target, motion: &IsometryMatrix3<f64>, set: [f64; 3]) -> Vec<Write> {
    let rotation = rotation(control, target, &seen_turn(control, target, &motion.rotation));
    let measured = Measured { actual: motion.transform_point(&set.into()).into(), set, axes: [true; 3] };
    placed(control, target, rotation, &measured)
}

/// From directions of the present WCS to those of the WCS with the frame as it is stored.
fn towards(control: &Control, target: &Target) -> Matrix3<f64> {
    let (before, old, after) = around(control, target);
    let stored = of(&before) * of(&[old]) * of(&after);
    stored.transpose() * of(&control.chain())
}

/// Rotations and mirrors of a chain of frames, outermost first.
fn of(chain: &[Frame]) -> Matrix3<f64> {
    chain.iter().fold(Matrix3::identity(), |turn, frame| turn * frame.directions())
}
