//! Measuring with the spindle turning: speeds and feeds of up to three probings, and the table of the probe
//! (B:4276-4310, B:4328-4383, B:4772-4807).

use super::params::IN_PLANE;
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::control::Units;

/// Speed, 1/min, and feed, mm/min.
type Probing = (f64, f64);

/// Touches as often as `_CM[]` or `_MFS[]` say; the last probing counts. Gives its position, and what the table takes
/// off the measured value, mm.
pub fn touch(machine: &mut dyn Machine, stand: &Stand, point: &Point) -> Result<(f64, f64), Stop> {
    let control = machine.control();
    let before = control.spindle_speed;
    let direction = match (before, control.number("_CM[5]")) {
        (turning, _) if turning != 0.0 => turning.signum(),
        (_, 3.0) => 1.0,
        (_, 4.0) => -1.0,
        _ => return Err(alarm(machine, 61366)),
    };
    let probings = if control.bit("_CBIT[12]") { own(control) } else { calculated(control, stand.block.radius) };
    if probings.is_empty() || probings.iter().any(|(_, feed)| *feed <= 0.0) {
        return Err(alarm(machine, 61350));
    }
    let mut last = (0.0, 0.0);
    for (index, (speed, feed)) in probings.iter().enumerate() {
        let counts = index + 1 == probings.len();
        let repeats = if counts { stand.block.repeats } else { 1 };
        machine.spin(direction * speed);
        last = (*speed, stand.block.at_feed(*feed, repeats).latch(machine, point)?);
    }
    if before == 0.0 {
        machine.spin(0.0);
    }
    let (speed, touched) = last;
    Ok((touched, compensation(machine, stand, speed)))
}

/// `_MFS[]`: pairs of speed and feed; the first speed of 0 ends them (B:4779-4787).
fn own(control: &Control) -> Vec<Probing> {
    let pairs = [["_MFS[0]", "_MFS[1]"], ["_MFS[2]", "_MFS[3]"], ["_MFS[4]", "_MFS[5]"]];
    let pairs = pairs.map(|[speed, feed]| (control.number(speed), control.basic_length(feed)));
    pairs.into_iter().take_while(|(speed, _)| *speed > 0.0).collect()
}

/// Peripheral speed in the unit of `_CM[0]` (m/min, feet/min) of 1 mm or 1 inch of circumference a minute.
fn per_circumference(control: &Control) -> f64 {
    match control.basic_units {
        Units::Metric => 0.001,
        Units::Inch => 1.0 / 12.0,
    }
}

/// `_CM[]`: speed from the peripheral speed, feed from the accuracy for a revolution; with feed factors faster probings
/// before (B:4284-4310, B:4789-4803).
fn calculated(control: &Control, radius: f64) -> Vec<Probing> {
    let limit = |index: usize| control.number(&format!("_CM[{index}]"));
    let circumference = std::f64::consts::TAU * radius / control.basic_factor();
    let speed = (limit(0) / (circumference * per_circumference(control))).min(limit(1));
    let feed = speed * limit(3);
    let first = feed.max(limit(2));
    let feeds = match (limit(6), limit(7)) {
        (one, _) if one < 1.0 => vec![first],
        (one, two) if two < 1.0 => vec![first * one, feed],
        (one, two) => vec![first * one, feed * two, feed],
    };
    feeds.into_iter().map(|feed| feed.min(limit(4))).map(|feed| (speed, feed * control.basic_factor())).collect()
}

/// What is taken off the measured value, mm: nothing, or the entry of the user's own table. The tables of the makes
/// (`_MT_COMP` = 1) are inside of the control and in no manual, so that nothing is taken off then, which is told.
fn compensation(machine: &mut dyn Machine, stand: &Stand, speed: f64) -> f64 {
    let control = machine.control();
    let (message, amount) = match control.number("_MT_COMP") as i64 {
        1 if control.number("_TP_CF") != 0.0 => {
            let make = control.number("_TP_CF");
            (Message::new("evaluate-compensation-make").number("make", make), 0.0)
        }
        2 => {
            let table = if IN_PLANE.holds(stand.inputs) { "_MT_EC_R" } else { "_MT_EC_L" };
            let amount = entry(control, table, stand.block.radius, speed);
            let message = Message::new("evaluate-compensation").text("table", table);
            (message.number("amount", amount), amount)
        }
        _ => return 0.0,
    };
    machine.record(Step::Decision { message });
    amount
}

/// The entry at the next lower peripheral speed and radius of a table, mm; 0 below the first (B:4383).
fn entry(control: &Control, table: &str, radius: f64, speed: f64) -> f64 {
    let cell = |row: usize, column: usize| control.number(&format!("{table}[{row},{column}]"));
    let radius = radius / control.basic_factor();
    let peripheral = std::f64::consts::TAU * radius * speed * per_circumference(control);
    let row = (1..=5).rfind(|row| below(cell(*row, 0), peripheral));
    let column = (1..=4).rfind(|column| below(cell(0, *column), radius));
    match (row, column) {
        (Some(row), Some(column)) => cell(row, column) * control.basic_factor(),
        _ => 0.0,
    }
}

/// Whether a heading of the table is filled in and not above the value.
fn below(heading: f64, value: f64) -> bool {
    heading > 0.0 && heading <= value * (1.0 + 1e-9)
}
