//! How a table turns until a plane lies across the probe, with the rotary axes that the machine has: where all three
//! are there, or the others need not move, the WCS lies as the machine; else a turn about the probe is left, which
//! needs no axis, because the frames have it (B:3808, B:3816).

use crate::control::{Control, Frame, ROTARY};
use crate::evaluate::level;
use crate::geometry::{Degrees, Rpy, TOLERANCE, V3, rigid};
use nalgebra::Rotation3;

/// Where the rotary axes A B C go until the active frames lie across the probe, and the frame that turns with the
/// table; none: those of the machine do not get there, or the frames shear.
pub fn swivelled(control: &Control) -> Option<([Degrees; 3], Frame)> {
    let (whole, table) = control.swivelled()?;
    let free = ROTARY.map(|name| control.rotary_axis(name).is_some());
    let stays = |axis: usize| (whole[axis] - control.rotary[axis]).0.abs() <= level::SAME;
    if (0..3).all(|axis| free[axis] || stays(axis)) {
        return Some((whole, table));
    }
    let [.., applicate] = control.plane.axes();
    let along = V3::ith(applicate, 1.0);
    let normal = rigid::rotation(Rpy(whole.map(|angle| angle.0))) * along;
    let turns = upright(&control.rotary, free, &along, &normal)?;
    let turn = rigid::rotation(Rpy(turns.map(|angle| angle.0))).inverse();
    let centre = V3::from(control.rotary_centre);
    let coarse = (centre - turn * centre).into();
    Some((turns, Frame { coarse, rotation: rigid::angles(&turn), ..Frame::default() }))
}

/// The turn about an axis of the machine.
fn about(axis: usize, angle: Degrees) -> Rotation3<f64> {
    rigid::rotation(Rpy::about(axis, angle))
}

/// Where those rotary axes that are there (`free`) go so that the table, where it turns all as A, then B, then C do,
/// takes `along` to `normal`; of two ways the shorter one.
fn upright(now: &[Degrees; 3], free: [bool; 3], along: &V3, normal: &V3) -> Option<[Degrees; 3]> {
    let there: Vec<usize> = (0..3).filter(|axis| free[*axis]).collect();
    let reached = |turns: &[Degrees; 3]| {
        let turned = rigid::rotation(Rpy(turns.map(|angle| angle.0))) * along;
        (turned - normal).norm() <= level::SAME
    };
    let way = |turns: &[Degrees; 3]| (0..3).map(|axis| (turns[axis] - now[axis]).0.abs()).sum::<f64>();
    let candidates: Vec<[Degrees; 3]> = match there[..] {
        [only] => {
            let mut turns = *now;
            turns[only] = outer(now, only, along, normal);
            vec![turns]
        }
        [first, second] => inner(now, [first, second], along, normal)
            .into_iter()
            .map(|angle| {
                let mut turns = *now;
                turns[first] = angle;
                turns[second] = outer(&turns, second, along, normal);
                turns
            })
            .collect(),
        _ => Vec::new(),
    };
    let fits = candidates.into_iter().filter(reached);
    fits.min_by(|one, other| way(one).total_cmp(&way(other)))
}

/// What the axes before one make of a direction, and what those behind it have to get.
fn split(turns: &[Degrees; 3], axis: usize, along: &V3, normal: &V3) -> (V3, V3) {
    let inside = (0..axis).fold(*along, |direction, one| about(one, turns[one]) * direction);
    let outside = (axis + 1..3).rev().fold(*normal, |direction, one| about(one, turns[one]).inverse() * direction);
    (inside, outside)
}

/// The angle of an axis that takes one direction to the other as seen along it; where it turns nothing, the axis stays.
fn outer(turns: &[Degrees; 3], axis: usize, along: &V3, normal: &V3) -> Degrees {
    let (from, to) = split(turns, axis, along, normal);
    let about = V3::ith(axis, 1.0);
    let [from, to] = [from, to].map(|one| one - about * one.dot(&about));
    if from.norm() <= TOLERANCE || to.norm() <= TOLERANCE {
        return turns[axis];
    }
    Degrees::of(about.dot(&from.cross(&to)).atan2(from.dot(&to)))
}

/// The angles of the inner of two axes with which the component along the outer one is right, which that one leaves:
/// `c + a·cos θ + b·sin θ`, from its values at 0, 90 and 180 degree.
fn inner(now: &[Degrees; 3], [first, second]: [usize; 2], along: &V3, normal: &V3) -> Vec<Degrees> {
    let component = |angle: Degrees| {
        let mut turns = *now;
        turns[first] = angle;
        split(&turns, second, along, normal).0[second]
    };
    let [zero, right, half] = [0.0, 90.0, 180.0].map(|angle| component(Degrees(angle)));
    let (middle, cosine) = ((zero + half) / 2.0, (zero - half) / 2.0);
    let sine = right - middle;
    let wanted = split(now, second, along, normal).1[second] - middle;
    let most = cosine.hypot(sine);
    if most <= TOLERANCE {
        return vec![now[first]];
    }
    let (phase, apart) = (sine.atan2(cosine), (wanted / most).clamp(-1.0, 1.0).acos());
    let within = |angle: f64| Degrees::of(angle.sin().atan2(angle.cos()));
    [apart, -apart].map(|apart| within(phase + apart)).into()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Plane, Value, delivery};
    use crate::dialect::Dialect;
    use crate::geometry::Mcs;

    fn with(axes: &[&str]) -> Control {
        let mut control = delivery(Dialect::Sinumerik);
        for place in 0..3 {
            let axis = axes.get(place).copied().unwrap_or("");
            control.data.insert(format!("MD20080[{}]", 3 + place), Value::Text(axis.to_owned()));
            control.set(format!("MD30300[{}]", 3 + place), if axis.is_empty() { 0.0 } else { 1.0 });
        }
        control
    }

    // oracle: hand: two axes bring any normal upright if neither turns about it, one axis those across it; what is left
    // is a turn about the probe
    #[test]
    fn two_axes_bring_any_plane_upright() {
        let tilts = [[4.0, -6.0, 0.0], [4.0, -6.0, 3.0], [-30.0, 20.0, -70.0], [0.0, -6.0, 0.0], [4.0, 0.0, 0.0]];
        for (axes, fits) in [
            (&["A", "C"][..], [true; 5]),
            (&["B", "C"], [true; 5]),
            (&["A", "B"], [true; 5]),
            (&["A", "B", "C"], [true; 5]),
            (&["A"], [false, false, false, false, true]),
            (&["B"], [false, false, false, true, false]),
            (&["C"], [false; 5]),
            (&[], [false; 5]),
        ] {
            for (tilt, fits) in tilts.into_iter().zip(fits) {
                let mut control = with(axes);
                control.plane = Plane::G17;
                control.rotary_centre = Mcs([10.0, 20.0, -300.0]);
                control.frames.insert(1, Frame { coarse: [7.0, 8.0, 9.0], rotation: Rpy(tilt), ..Frame::default() });
                control.activate(1);
                let found = swivelled(&control);
                assert_eq!(found.is_some(), fits, "{axes:?} {tilt:?}");
                let Some((turns, table)) = found else { continue };
                for (axis, name) in ROTARY.into_iter().enumerate() {
                    assert!(axes.contains(&name) || turns[axis] == control.rotary[axis], "{axes:?} {tilt:?}");
                }
                // the frame turns as the table does
                let turned = Control { rotary: turns, ..control.clone() }.table_turn();
                let apart = (rigid::rotation(table.rotation).matrix() - turned.matrix()).norm();
                assert!(apart < 1e-9, "{axes:?} {tilt:?}: {apart}");
                control.part_frame = table;
                let up = control.direction_to_machine(V3::z().into());
                assert!((V3::from(up) - V3::z()).norm() < 1e-9, "{axes:?} {tilt:?}: {up:?}");
            }
        }
    }
}
