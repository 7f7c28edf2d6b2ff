//! What G65 P9920 does (C:1208-1258). Formulas are not printed: the disk is in the middle of its contacts, its
//! diameter is their distance less that of the reference tool, and a tool is longer by as much as the spindle stands
//! higher than with the reference tool.

use super::touch::{feed_and_speed, feeds, leave, nose, sink, touch, travel};
use super::{CALIBRATE, DEPRESSED, DIAMETER, MEASURING_DEVICE, diameter};
use crate::catalogue::nct::correct;
use crate::catalogue::prelude::*;
use crate::control::Value;

/// Carries out the macro. It works along Z whatever the plane is, and leaves G49 (C:1191, C:1258).
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    ready(machine.control())?;
    let register = match inputs.variant {
        CALIBRATE => reference(machine.control())?,
        _ => inputs.integer(address::T),
    };
    keep(machine, inputs);
    let plane = machine.control().plane;
    machine.select(0);
    machine.control().plane = Plane::G17;
    machine.select(register);
    let outcome = match inputs.variant {
        CALIBRATE => calibrate(machine, inputs),
        _ => measure(machine, inputs, register),
    };
    machine.spin(0.0);
    machine.select(0);
    machine.control().plane = plane;
    outcome
}

/// The signals of the device: RDY at #1003 and TSIG at #1002 (C:1204), assumed to be 1 while the disk is pressed. An
/// input that was never set is as it should be.
fn ready(control: &Control) -> Result<(), Stop> {
    let input = |name: &str, otherwise: f64| match control.data.get(name) {
        Some(Value::Number(value)) => *value,
        _ => otherwise,
    };
    if input("#1003", 1.0) == 0.0 {
        return Err(Stop::Alarm(MEASURING_DEVICE));
    }
    if input("#1002", 0.0) != 0.0 {
        return Err(Stop::Alarm(DEPRESSED));
    }
    Ok(())
}

/// The register of the reference tool: the active one, else the one with the number of the tool in the spindle.
fn reference(control: &Control) -> Result<i64, Stop> {
    let known = |number: &i64| control.edge_of(0, *number).is_some();
    let found = [control.edge, control.tool].into_iter().find(known);
    let missing = Message::new("run-no-tool").text("word", format!("H{}", control.edge));
    found.ok_or(Stop::Fault(missing))
}

/// Given values of feed and speed stay for the next calls (C:1202).
fn keep(machine: &mut dyn Machine, inputs: &Inputs) {
    if let Some(feed) = inputs.given(address::F) {
        correct::calibration(machine, &[("#512", feed)]);
    }
    if let Some(speed) = inputs.given(address::S) {
        machine.write("#511", speed);
    }
}

fn calibrate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let start = nose(machine);
    let [x, half_x] = across(machine, inputs, 0, start)?;
    // the second axis through the middle found in the first
    let mut over = start;
    over[0] = x;
    let [y, half_y] = across(machine, inputs, 1, over)?;
    over[1] = y;
    leave(machine, over)?;
    let feeds = standing(machine, inputs);
    let height = touch(machine, 2, start[2] + inputs.number(address::Z), feeds, start)?;
    leave(machine, over)?;
    // the first pair was touched beside the centre by what the second has found
    let wide = half_x.hypot(start[1] - y) + half_y;
    correct::calibration(
        machine,
        &[
            ("#506", height),
            ("#507", x),
            ("#508", y),
            ("#509", wide - inputs.number(address::D)),
            ("#513", inputs.number(address::H)),
        ],
    );
    Ok(())
}

/// Out beside the disk, down, to the rim, up: from + and from − (C:1224). Middle of both contacts, and half of their
/// distance, mm.
fn across(machine: &mut dyn Machine, inputs: &Inputs, axis: usize, over: [f64; 3]) -> Result<[f64; 2], Stop> {
    let feeds = standing(machine, inputs);
    let way = beside(machine.control(), inputs.number(address::D), inputs.number(address::E));
    let depth = over[2] + inputs.number(address::Z);
    let mut contacts = [0.0; 2];
    for (side, contact) in [1.0, -1.0].into_iter().zip(&mut contacts) {
        let mut out = over;
        out[axis] += side * way;
        leave(machine, out)?;
        sink(machine, depth, over)?;
        *contact = touch(machine, axis, over[axis], feeds, over)?;
        leave(machine, out)?;
    }
    Ok([(contacts[0] + contacts[1]) / 2.0, (contacts[0] - contacts[1]) / 2.0])
}

/// From the centre of the disk to the axis of a tool that sinks beside it, mm.
fn beside(control: &Control, diameter: f64, clearance: f64) -> f64 {
    (diameter + control.basic_length("#509")) / 2.0 + clearance
}

fn measure(machine: &mut dyn Machine, inputs: &Inputs, register: i64) -> Result<(), Stop> {
    let start = nose(machine);
    let wide = diameter(inputs, machine.control());
    let control = machine.control();
    let [z, x, y] = ["#506", "#507", "#508"].map(|name| control.basic_length(name));
    let reference = control.basic_length("#513");
    travel(machine, [x + wide / 2.0, y, start[2]])?;
    let feeds = turned(machine, inputs, false);
    let height = touch(machine, 2, start[2] + inputs.number(address::Z), feeds, start)?;
    let length = height - z + reference;
    let mut results = vec![("LENGTH", length)];
    let mut radius = None;
    if inputs.variant == DIAMETER {
        let lift = inputs.number(address::K);
        let out = x + beside(machine.control(), wide, inputs.number(address::E));
        let mut above = nose(machine);
        above[2] = height + lift;
        leave(machine, above)?;
        travel(machine, [out, y, above[2]])?;
        let feeds = turned(machine, inputs, true);
        sink(machine, height - lift, start)?;
        let rim = touch(machine, 0, x, feeds, start)?;
        let found = 2.0 * (rim - x) - machine.control().basic_length("#509");
        results.push(("DIAMETER", found));
        radius = Some(found / 2.0);
    }
    leave(machine, start)?;
    correct::results(machine, &results);
    write(machine, register, length, radius);
    Ok(())
}

/// The feeds of a tool that stands.
fn standing(machine: &mut dyn Machine, inputs: &Inputs) -> [f64; 2] {
    feeds(feed_and_speed(machine, inputs).0, None)
}

/// Lets the tool turn where M asks for it (C:1240, C:1251); the feeds that go with it.
fn turned(machine: &mut dyn Machine, inputs: &Inputs, rim: bool) -> [f64; 2] {
    let (feed, speed) = feed_and_speed(machine, inputs);
    let direction = match (inputs.integer(address::M), rim) {
        (3, _) | (13, true) => 1.0,
        (4, _) | (14, true) => -1.0,
        _ => 0.0,
    };
    machine.spin(direction * speed);
    feeds(feed, (direction != 0.0).then_some(speed))
}

/// Length and radius of the register, so that with its wear they are those measured.
fn write(machine: &mut dyn Machine, register: i64, length: f64, radius: Option<f64>) {
    let edge = machine.control().register(register);
    let length = length - edge.length_wear[0];
    machine.write_correction(format!("H{register}"), length);
    if let Some(radius) = radius {
        let radius = radius - edge.radius_wear;
        machine.write_correction(format!("D{register}"), radius);
    }
}
