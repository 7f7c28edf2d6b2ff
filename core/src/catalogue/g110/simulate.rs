//! What G110 does: four walls, centre and diameter, corrections, messages, print-out.
//!
//! The manual names neither the order of the walls nor the formulas (C:1036-1183). Here: first axis +, −; then, on the
//! centre line just found, second axis +, −. The first chord lies beside the centre by the distance then known, so
//! that its diameter follows from the circle of the ball centre; the mean of both diameters counts.

use super::{BOSS, depth};
use crate::catalogue::nct::touch::{Calibration, POSITIONING, touch};
use crate::catalogue::nct::{self, axis_name, print};
use crate::check::Inputs;
use crate::evaluate::tolerance::exceeds;
use crate::message::Message;
use crate::run::trace::{MotionKind, Step};
use crate::run::{Machine, Stop};

/// Values of the call, mm.
struct Call {
    boss: Option<f64>,
    diameter: f64,
    clearance: f64,
    overtravel: f64,
    start: [f64; 3],
    axes: [usize; 3],
}

/// Walls of one axis.
struct Chord {
    /// Middle between the walls, WCS, mm.
    middle: f64,
    /// Half way of the ball centre between the contacts, mm.
    half: f64,
    /// Mean effective ball radius, mm.
    ball: f64,
}

/// What was measured, mm.
struct Measured {
    centre: [f64; 2],
    shift: [f64; 2],
    diameter: f64,
    deviation: f64,
}

/// Carries out the macro.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let call = call(machine, inputs);
    let first = chord(machine, &call, 0)?;
    let middle = first.middle - Calibration::of(machine, 0).offset;
    travel(machine, call.axes[0], middle)?;
    let second = chord(machine, &call, 1)?;
    let applicate = call.axes[2];
    travel(machine, applicate, call.start[applicate])?;
    machine.travel(call.start, MotionKind::Positioning, POSITIONING, true)?;
    let measured = evaluate(machine, &call, &first, &second);
    results(machine, &measured);
    correct(machine, inputs, &call, &measured);
    log(machine, inputs, &call, &measured);
    Ok(())
}

fn call(machine: &mut dyn Machine, inputs: &Inputs) -> Call {
    Call {
        boss: depth(inputs).filter(|_| inputs.variant == BOSS),
        diameter: inputs.number("D"),
        clearance: inputs.number("R"),
        overtravel: inputs.number("Q"),
        start: machine.position(),
        axes: machine.control().plane.axes(),
    }
}

/// Both walls of the first (0) or second (1) axis, + side first.
fn chord(machine: &mut dyn Machine, call: &Call, index: usize) -> Result<Chord, Stop> {
    let calibration = Calibration::of(machine, index);
    let axis = call.axes[index];
    let mut ball_at = [0.0; 2];
    for (side, ball) in [1.0, -1.0].into_iter().zip(&mut ball_at) {
        let position = match call.boss {
            Some(depth) => touch_outside(machine, call, &calibration, axis, side, depth)?,
            None => touch_inside(machine, call, &calibration, axis, side)?,
        };
        *ball = position + calibration.offset;
    }
    let moving = if call.boss.is_some() { -1.0 } else { 1.0 };
    let (upper, lower) = (calibration.radius(moving), calibration.radius(-moving));
    let walls = [ball_at[0] + moving * upper, ball_at[1] - moving * lower];
    Ok(Chord {
        middle: (walls[0] + walls[1]) / 2.0,
        half: (ball_at[0] - ball_at[1]) / 2.0,
        ball: (upper + lower) / 2.0,
    })
}

/// From the centre to the wall of a bore, and back.
fn touch_inside(
    machine: &mut dyn Machine,
    call: &Call,
    calibration: &Calibration,
    axis: usize,
    side: f64,
) -> Result<f64, Stop> {
    let centre = call.start[axis];
    let reach = call.diameter / 2.0 - calibration.radius(side) + call.overtravel;
    let position = touch(machine, axis, centre + side * reach - calibration.offset)?;
    travel(machine, axis, centre)?;
    Ok(position)
}

/// Over the boss to the clearance beside it, down, to the wall, back and up (C:1076-1077).
fn touch_outside(
    machine: &mut dyn Machine,
    call: &Call,
    calibration: &Calibration,
    axis: usize,
    side: f64,
    depth: f64,
) -> Result<f64, Stop> {
    let applicate = call.axes[2];
    let wall = call.start[axis] + side * (call.diameter / 2.0 + calibration.radius(-side))
        - calibration.offset;
    let beside = wall + side * call.clearance;
    travel(machine, axis, beside)?;
    travel(machine, applicate, depth)?;
    let position = touch(machine, axis, wall - side * call.overtravel)?;
    travel(machine, axis, beside)?;
    travel(machine, applicate, call.start[applicate])?;
    Ok(position)
}

/// Protected positioning along one axis.
fn travel(machine: &mut dyn Machine, axis: usize, to: f64) -> Result<(), Stop> {
    let mut target = machine.position();
    if target[axis] == to {
        return Ok(());
    }
    target[axis] = to;
    machine.travel(target, MotionKind::Positioning, POSITIONING, true)
}

fn evaluate(machine: &mut dyn Machine, call: &Call, first: &Chord, second: &Chord) -> Measured {
    let side = if call.boss.is_some() { -1.0 } else { 1.0 };
    // the first chord was taken where the ball centre stood in the second axis at the start
    let beside = call.start[call.axes[1]] + Calibration::of(machine, 1).offset - second.middle;
    let one = 2.0 * (first.half.hypot(beside) + side * first.ball);
    let two = 2.0 * (second.half + side * second.ball);
    let diameter = (one + two) / 2.0;
    let centre = [first.middle, second.middle];
    let shift = [0, 1].map(|i| centre[i] - call.start[call.axes[i]]);
    Measured {
        centre,
        shift,
        diameter,
        deviation: diameter - call.diameter,
    }
}

fn results(machine: &mut dyn Machine, measured: &Measured) {
    let control = machine.control();
    let per = control.active_factor();
    for (name, value) in [
        ("DIAMETER", measured.diameter),
        ("DEVIATION", measured.deviation),
        ("CENTRE_1", measured.centre[0]),
        ("CENTRE_2", measured.centre[1]),
        ("SHIFT_1", measured.shift[0]),
        ("SHIFT_2", measured.shift[1]),
    ] {
        let before = machine.control().number(name);
        let after = value / per;
        machine.control().set(name, after);
        machine.record(Step::Set {
            name: name.into(),
            before,
            after,
        });
    }
}

/// Messages first, then M, and unless U is exceeded T or S (C:1083-1099).
fn correct(machine: &mut dyn Machine, inputs: &Inputs, call: &Call, measured: &Measured) {
    let given = |name: &str| inputs.numbers.get(name).copied();
    let beyond =
        |name: &str| given(name).is_some_and(|limit| exceeds(measured.deviation.abs(), limit));
    if beyond("H") {
        machine.record(Step::Alarm(nct::OUT_OF_TOLERANCE));
    }
    let side = if call.boss.is_some() { 1.0 } else { -1.0 };
    let excess = side * measured.deviation; // metal on is positive (C:1092-1095)
    if let Some(register) = given("M") {
        write(machine, format!("D{register}"), excess);
    }
    if beyond("U") {
        machine.record(Step::Alarm(nct::UPPER_TOLERANCE));
        machine.record(Step::Decision(Message::new("decision-nct-no-update")));
        return;
    }
    if let Some(register) = given("T") {
        correct_tool(machine, register as i64, call, excess);
    }
    if let Some(offset) = given("S") {
        correct_offset(machine, offset as usize, call, measured);
    }
}

/// The wear of the radius takes half of the excess metal: a smaller register brings the tool nearer to the wall.
fn correct_tool(machine: &mut dyn Machine, register: i64, call: &Call, excess: f64) {
    let name = format!("DW{register}");
    let before = machine.control().variable(&name).unwrap_or(0.0);
    write(machine, name, before - excess / 2.0);
    let diameter = 2.0 * machine.control().register(register).total_radius();
    if call.boss.is_none() && diameter > call.diameter {
        machine.record(Step::Alarm(nct::TOOL_TOO_LARGE));
    }
}

/// The offset moves so that the measured centre gets the coordinates of the start; the one in effect counts at once,
/// as in the example, which never calls it again (C:1159-1183).
fn correct_offset(machine: &mut dyn Machine, offset: usize, call: &Call, measured: &Measured) {
    let mut shift = [0.0; 3];
    for (i, value) in measured.shift.into_iter().enumerate() {
        shift[call.axes[i]] = value;
    }
    let shift = machine.control().direction_to_machine(shift);
    let system = if offset == 0 {
        "COMMON".into()
    } else {
        format!("G{}", 53 + offset)
    };
    for axis in call.axes.into_iter().filter(|axis| shift[*axis] != 0.0) {
        let name = format!("{system} {}", axis_name(axis));
        let before = machine.control().variable(&name).unwrap_or(0.0);
        write(machine, name, before + shift[axis]);
    }
    let control = machine.control();
    let active = control.settable;
    if offset == 0 || offset == active {
        control.activate(active);
    }
}

/// Writes a register or an offset, mm, and records it.
fn write(machine: &mut dyn Machine, name: String, after: f64) {
    let before = machine.control().variable(&name).unwrap_or(0.0);
    if machine.control().set_variable(&name, after) {
        machine.record(Step::Set {
            name,
            before,
            after,
        });
    }
}

/// Print-out by V and W (C:1100-1116).
fn log(machine: &mut dyn Machine, inputs: &Inputs, call: &Call, measured: &Measured) {
    let control = machine.control();
    if control.data.contains_key(nct::PRINT_ENABLED) && !control.bit(nct::PRINT_ENABLED) {
        return;
    }
    let per = control.active_factor();
    let given = |name: &str| inputs.numbers.get(name).copied();
    let mut lines: Vec<String> = Vec::new();
    if inputs.integer("V") == 2 {
        lines.extend(print::DIMENSION_HEADER.map(String::from));
    }
    if inputs.integer("V") > 0 {
        let register = given("T").map(|register| register as i64);
        let tolerance = given("H").map(|limit| limit / per);
        lines.push(print::dimension(
            register,
            call.diameter / per,
            tolerance,
            measured.deviation / per,
        ));
    }
    if inputs.integer("W") == 2 {
        lines.extend(print::POSITION_HEADER.map(String::from));
    }
    if inputs.integer("W") > 0 {
        let offset = given("S").map(|offset| offset as i64);
        lines.extend([0, 1].map(|i| {
            let axis = call.axes[i];
            print::position(
                offset,
                axis_name(axis),
                call.start[axis] / per,
                measured.shift[i] / per,
            )
        }));
    }
    lines
        .into_iter()
        .for_each(|line| machine.record(Step::Log(line)));
}
