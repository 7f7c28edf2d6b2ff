//! Addresses of a block: axes, arcs, feed, speed, spindle angle.

use super::{
    Address, Coordinate, Datum, Interpreter, Path, action::machine_function, diameters, motion, noted, other_axes,
    path::Corner,
};
use crate::control::AXES;
use crate::geometry::Degrees;
use crate::machine::Machine;
use crate::problem::Problem;

/// Takes an address into the path of the block or the modal data.
pub fn take(run: &mut Interpreter, address: &Address, path: &mut Path) -> Result<(), Problem> {
    let rules = run.rules();
    let factor = run.sim.control.active_factor();
    let name = address.name.as_str();
    if let Some(mode) = address.mode.as_deref().filter(|mode| diameters::by_block(mode).is_some()) {
        diameters::takes(address, mode)?;
    }
    match name {
        "X" | "Y" | "Z" if address.extension.is_none() => {
            put(&mut path.axes, AXES, name, coordinate(address, factor)?);
        }
        "I" | "J" | "K" => {
            let list = match address.extension {
                None => &mut path.centre,
                Some(1) => &mut path.middle,
                Some(_) => return Err(Problem::new("run-unknown-word", address.span, name)),
            };
            put(list, ["I", "J", "K"], name, coordinate(address, factor)?);
        }
        "AP" => path.polar.angle = Some(coordinate(address, 1.0)?),
        "RP" => path.polar.radius = Some(coordinate(address, factor)?),
        _ if name == rules.radius => path.radius = Some(number(address)? * factor),
        "AR" => path.angle = Some(number(address)?),
        "ANG" => path.slope = Some(number(address)?),
        "TURN" => path.turns = turns(address)?,
        "F" if !path.dwell => {
            run.modal.feed = number(address)?;
            run.modal.feed_factor = run.sim.control.data_factor();
        }
        "FB" => path.feed = Some(number(address)?),
        "S" if !path.dwell && matches!(address.extension, None | Some(1)) => {
            run.modal.speed = number(address)?;
            let turns = run.sim.control.spindle_speed;
            if turns != 0.0 {
                run.sim.spin(motion::spindle_speed(run).copysign(turns));
            }
        }
        "S" | "T" if address.extension.is_some_and(|spindle| spindle > 1) => {
            let word = address.extension.map_or_else(|| name.to_owned(), |number| format!("{name}{number}"));
            noted::without(run, "run-passed", address.span, &word);
        }
        "SPOS" | "SPOSA" => {
            let stands = if address.mode.as_deref() == Some("IC") { run.sim.control.spindle } else { Degrees(0.0) };
            run.sim.orient(stands + Degrees(number(address)?));
        }
        "T" => {} // number or name, see `tool`
        "RND" => path.corner = Some(Corner::Radius(number(address)?.abs() * factor)),
        "CHF" => path.corner = Some(Corner::Chamfer(number(address)?.abs() * factor)),
        "CHR" => path.corner = Some(Corner::Leg(number(address)?.abs() * factor)),
        "RNDM" => run.modal.rounding = number(address)?.abs() * factor,
        "FRC" => path.corner_feed = Some(number(address)?),
        "FRCM" => run.modal.corner_feed = number(address)?,
        "F" => run.sim.seconds += number(address)?.max(0.0), // with G4: s, and S revolutions
        "S" if run.modal.speed != 0.0 => run.sim.seconds += 60.0 * number(address)?.max(0.0) / run.modal.speed.abs(),
        // the last three tune a path or a spline, of which only the programmed points are passed
        "G" | "M" | "S" | "D" | "DL" | "SF" | "PW" | "SD" | "PL" => drop(number(address)?),
        "DISR" | "DISCL" | "FAD" => drop(number(address)?), // those of smooth approach are told with it
        _ if rules.beside.contains(&name) => drop(number(address)?),
        "H" => machine_function(run, address.span, &format!("H{}", Datum::Number(number(address)?).shown())),
        _ if path.stays => {}
        _ => return other(run, address, path),
    }
    Ok(())
}

/// Puts a coordinate where its name stands among those of the axes.
fn put(list: &mut [Option<Coordinate>; 3], names: [&str; 3], name: &str, coordinate: Coordinate) {
    let mut places = list.iter_mut().zip(names);
    if let Some((place, _)) = places.find(|(_, one)| *one == name) {
        *place = Some(coordinate);
    }
}

/// Most full circles before the end of an arc (`TURN`), as SINUMERIK takes them.
const MOST_TURNS: f64 = 999.0;

/// How many full circles an arc goes before its end.
fn turns(address: &Address) -> Result<f64, Problem> {
    let turns = Some(number(address)?.trunc()).filter(|turns| (0.0..=MOST_TURNS).contains(turns));
    turns.ok_or_else(|| Problem::new("run-range", address.span, &*address.name))
}

/// The value of an address as a number.
pub fn number(address: &Address) -> Result<f64, Problem> {
    let number = address.value.number().filter(|value| value.is_finite());
    number.ok_or_else(|| Problem::new("run-not-a-number", address.span, &*address.name))
}

/// Where an axis goes, absolute or by an increment.
pub fn coordinate(address: &Address, factor: f64) -> Result<Coordinate, Problem> {
    let [absolute, diameter] = match address.mode.as_deref() {
        None => [None, None],
        Some("AC") => [Some(true), None],
        Some("IC") => [Some(false), None],
        Some(mode) => match diameters::by_block(mode) {
            Some(meant) => meant.map(Some),
            None => return Err(Problem::new("run-function", address.span, mode)),
        },
    };
    Ok(Coordinate { value: number(address)? * factor, absolute, diameter })
}

/// A rotary axis of the machine, another axis, else something that is not simulated.
fn other(run: &mut Interpreter, address: &Address, path: &mut Path) -> Result<(), Problem> {
    let there = run.sim.control.rotary_axis(&address.name).filter(|_| address.extension.is_none());
    let Some(axis) = there else {
        if other_axes::take(run, address)? {
            return Ok(());
        }
        noted::without(run, "run-passed", address.span, &address.name);
        return Ok(());
    };
    let written = Degrees(number(address)?);
    let control = &run.sim.control;
    path.rotary[axis] = Some(match address.mode.as_deref() {
        Some("IC" | "CIC") => control.rotary[axis] + written,
        None if !run.modal.absolute => control.rotary[axis] + written,
        _ => control.rotary_to_machine(axis, written),
    });
    Ok(())
}
