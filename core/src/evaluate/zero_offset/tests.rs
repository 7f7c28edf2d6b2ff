//! Zero offsets in every frame.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::geometry::{Degrees, Dir, Rpy, Wcs};

fn control() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.set("MD18600", 1.0);
    control.activate(1);
    control
}

fn correct(control: &mut Control, code: i64, measured: &Measured) -> Vec<String> {
    let target = target(control, code).unwrap().unwrap();
    let writes = writes(control, &target, measured);
    for write in &writes {
        assert!(control.set_variable(&write.name, write.value), "{}", write.name);
    }
    writes.into_iter().map(|write| write.name).collect()
}

const RECTANGLE: Measured =
    Measured { actual: [151.2, 169.4, 120.0], set: [150.0, 170.0, 120.0], axes: [true, true, false] };

#[test]
fn the_difference_goes_into_the_fine_part() {
    // oracle: manual B:6276-6278, B:1990
    let mut control = control();
    assert_eq!(correct(&mut control, 1, &RECTANGLE), ["$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]"]);
    let frame = control.frames[&1];
    assert!((frame.fine[0] - 1.2).abs() < 1e-12 && (frame.fine[1] + 0.6).abs() < 1e-12);
    assert_eq!(frame.fine[2], 0.0);
}

#[test]
fn or_with_the_fine_part_into_the_coarse_one() {
    // oracle: manual B:14039
    let mut control = control();
    control.frames.insert(1, Frame { fine: [0.1, 0.2, 0.0], ..Frame::default() });
    control.activate(1);
    control.set("_CHBIT[21]", 1.0);
    correct(&mut control, 1, &RECTANGLE);
    let frame = control.frames[&1];
    assert!((frame.coarse[0] - 1.3).abs() < 1e-12 && (frame.coarse[1] + 0.4).abs() < 1e-12);
    assert_eq!(frame.fine, [0.0; 3]);
}

/// A control with something in every frame.
fn chained() -> Control {
    let mut control = control();
    let frame = |x: f64, turn: f64| Frame {
        coarse: [x, 2.0 * x, 3.0],
        fine: [0.01, 0.0, 0.02],
        rotation: Rpy([0.0, 0.0, turn]),
        ..Frame::default()
    };
    control.stored.system = Frame::translation([1.0, 2.0, 3.0]);
    control.stored.global.insert(0, Frame::translation([5.0, 0.0, 0.0]));
    control.stored.channel.insert(0, frame(10.0, 30.0));
    control.stored.channel.insert(1, frame(-4.0, -12.0));
    control.frames.insert(1, frame(100.0, 20.0));
    control.frames.insert(2, frame(50.0, -75.0));
    control.program_frame = frame(7.0, 11.0);
    control.activate(1);
    control
}

#[test]
fn afterwards_the_point_has_the_set_coordinates() {
    // oracle: self (the definition of B:6153 by the control's own transformation)
    for code in [1, 1011, 1012, 1051, 2000, 9999] {
        for coarse in [0.0, 1.0] {
            let mut control = chained();
            control.set("_CHBIT[21]", coarse);
            let measured = Measured { actual: [31.0, 42.0, 5.0], set: [30.5, 41.7, 5.3], axes: [true; 3] };
            let machine = control.to_machine(Wcs(measured.actual));
            correct(&mut control, code, &measured);
            control.activate(1);
            let seen = control.to_workpiece(machine);
            for axis in 0..3 {
                assert!((seen[axis] - measured.set[axis]).abs() < 1e-9, "{code}: {seen:?}");
            }
        }
    }
}

#[test]
fn another_settable_frame_keeps_its_rotation() {
    // oracle: self (B:6147, B:6153)
    let mut control = chained();
    let measured = Measured { actual: [31.0, 42.0, 5.0], set: [0.0, 0.0, 0.0], axes: [true; 3] };
    let machine = control.to_machine(Wcs(measured.actual));
    correct(&mut control, 2, &measured);
    assert_eq!(control.frames[&2].rotation, [0.0, 0.0, -75.0]);
    control.activate(2);
    assert!(control.to_workpiece(machine).iter().all(|x| x.abs() < 1e-9));
}

#[test]
fn the_last_basic_frame_is_calculated_without_a_settable_one() {
    // oracle: self (B:1938: right as soon as G500 is activated, which has a frame of its own)
    let mut control = chained();
    let own =
        Frame { fine: [0.02, -0.01, 0.0], rotation: Rpy([0.0, 0.0, 8.0]), ..Frame::translation([6.0, -7.0, 8.0]) };
    control.frames.insert(0, own);
    let measured = Measured { actual: [31.0, 42.0, 5.0], set: [1.0, 2.0, 3.0], axes: [true; 3] };
    let machine = control.to_machine(Wcs(measured.actual));
    let names = correct(&mut control, 1000, &measured);
    assert!(names.iter().all(|name| name.starts_with("$P_CHBFR[1,")), "{names:?}");
    control.activate(0);
    let seen = control.to_workpiece(machine);
    assert!(seen.iter().zip(measured.set).all(|(a, b)| (a - b).abs() < 1e-9), "{seen:?}");
}

#[test]
fn a_table_stands_right_in_the_corrected_basic_frame_with_g500() {
    // oracle: hand: of the 3 + 0.5 degree in G54 only the 2 degree of G500 are left, so that the basic frame takes the
    // rest, and the angle of 0.25
    let mut control = control();
    let about_z = |rotary: f64, rotary_fine: f64| Frame {
        rotary: [0.0, 0.0, rotary].map(Degrees),
        rotary_fine: [0.0, 0.0, rotary_fine].map(Degrees),
        ..Frame::default()
    };
    control.frames.insert(0, about_z(2.0, 0.0));
    control.frames.insert(1, about_z(3.0, 0.5));
    control.stored.channel.insert(0, about_z(10.0, 0.0));
    control.activate(1);
    let stood = control.rotary_to_machine(2, Degrees(5.0)).0;
    let target = target(&control, 1000).unwrap().unwrap();
    let writes = rotary(&control, &target, 2, Degrees(0.25), false);
    write_all(&mut control, &writes);
    control.activate(0);
    assert!((control.rotary_to_machine(2, Degrees(5.0)).0 - stood - 0.25).abs() < 1e-12);
}

#[test]
fn the_last_basic_frame_is_that_of_the_machine_data() {
    // oracle: manual B:1938 (MD28081 says how many there are), A:15931 (the remedy of 61412)
    let last = |control: &Control| target(control, 1000).map(|found| found.unwrap().store);
    let mut control = control();
    assert_eq!(last(&control), Err(61412));
    control.set("MD28081", 3.0);
    assert_eq!(last(&control), Ok(Store::ChannelBasic(2)));
    control.set("$P_CHBFRMASK", 2.0);
    assert_eq!(last(&control), Ok(Store::ChannelBasic(1)));
}

#[test]
fn what_does_not_exist_alarms() {
    // oracle: manual A:15862, A:15931
    let mut control = control();
    assert_eq!(target(&control, 100), Err(61321));
    assert_eq!(target(&control, 0), Ok(None));
    control.stored.channel.clear();
    control.set("$P_CHBFRMASK", 0.0);
    assert_eq!(target(&control, 1000), Err(61412));
    // oracle: manual B:1984
    let mut without = control.clone();
    without.set("MD28082", 32.0);
    assert_eq!(target(&without, 2000), Err(61321));
    control.set("$P_CHBFRMASK", 5.0);
    assert_eq!(target(&control, 1000).unwrap().unwrap().store, Store::ChannelBasic(2));
}

/// A control with X reversed in a basic frame, in the settable ones, or in the programmed one; 0: in none.
fn mirrored_in(place: usize) -> Control {
    let mut control = chained();
    let mirror = [true, false, false];
    match place {
        1 => control.stored.channel.entry(0).or_default().mirror = mirror,
        2 => {
            for frame in control.frames.values_mut() {
                frame.mirror = mirror;
            }
        }
        3 => control.program_frame.mirror = mirror,
        _ => {}
    }
    control.activate(1);
    control
}

/// A part that is turned and moved in the present WCS.
fn turned_part() -> (nalgebra::Rotation3<f64>, Measured) {
    let turn = crate::geometry::rigid::rotation(Rpy([3.0, -7.0, 12.0]));
    let measured = Measured { actual: [31.0, 42.0, 5.0], set: [1.0, -2.0, 3.0], axes: [true; 3] };
    (turn, measured)
}

fn write_all(control: &mut Control, writes: &[Write]) {
    for write in writes {
        assert!(control.set_variable(&write.name, write.value));
    }
}

#[test]
fn afterwards_a_turned_part_stands_right() {
    // oracle: self (the definition of B:7371 and B:8411 by the control's own transformation)
    let set = [0.6, -0.48, 0.64];
    let codes = [1, 2, 1011, 1012, 2000, 9999];
    for (mirrored, code) in (0..4).flat_map(|mirrored| codes.map(|code| (mirrored, code))) {
        let mut control = mirrored_in(mirrored);
        let (turn, measured) = turned_part();
        let target = target(&control, code).unwrap().unwrap();
        let machine = control.to_machine(Wcs(measured.actual));
        let actual = (turn * nalgebra::Vector3::from(set)).into();
        let direction = control.direction_to_machine(Dir::new(actual)).0;
        let seen = seen_turn(&control, &target, &turn);
        let rotation = rotation(&control, &target, &seen);
        let writes = placed(&control, &target, rotation, &measured);
        write_all(&mut control, &writes);
        control.activate(if code == 2 { 2 } else { 1 });
        let (found, place) = (control.direction_to_workpiece(Dir::new(direction)), control.to_workpiece(machine));
        for axis in 0..3 {
            assert!((found[axis] - set[axis]).abs() < 1e-9, "{code}: {found:?}");
            assert!((place[axis] - measured.set[axis]).abs() < 1e-9, "{code}");
        }
        assert_eq!(control.frames[&1].fine == [0.0; 3], matches!(code, 1 | 9999));
    }
}

#[test]
fn a_turn_about_the_axis_of_the_frame_adds_to_its_angle() {
    // oracle: hand
    let mut control = control();
    control.frames.insert(1, Frame { rotation: Rpy([0.0, 0.0, 20.0]), ..Frame::default() });
    control.activate(1);
    let target = target(&control, 1).unwrap().unwrap();
    let turn = crate::geometry::rigid::rotation(Rpy([0.0, 0.0, 12.5]));
    let rotation = rotation(&control, &target, &seen_turn(&control, &target, &turn));
    assert!((rotation[2] - 32.5).abs() < 1e-12 && rotation[..2] == [0.0; 2]);
    let names: Vec<String> = turned(&control, &target, rotation).into_iter().map(|write| write.name).collect();
    assert_eq!(names, ["$P_UIFR[1,Z,RT]"]);
    // another frame, not turned, is corrected to the same direction
    let other = super::target(&control, 2).unwrap().unwrap();
    let direction = seen(&control, &other, [1.0, 0.0, 0.0]);
    assert!((direction[1].atan2(direction[0]).to_degrees() - 20.0).abs() < 1e-12);
}
