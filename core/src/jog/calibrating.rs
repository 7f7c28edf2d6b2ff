//! Calibrating the workpiece probe: length on a surface, ball in a ring, and what is stored (B:2876-2977). How it was
//! calibrated is noted with it.

use super::evaluate;
use super::touching::Touching;
use crate::catalogue::sinumerik::calibrated_as::Used;
use crate::machine::{Machine, Stop};

/// Geometry of L1, L2, L3 and of the radius in the tool memory.
const LENGTHS: [&str; 3] = ["$TC_DP3", "$TC_DP4", "$TC_DP5"];
const RADIUS: &str = "$TC_DP6";

/// Length of the probe, and the trigger value of the applicate, on a surface at this height in the WCS.
///
/// # Errors
/// No signal, or what was hit or refused.
pub fn length(machine: &mut dyn Machine, height: f64) -> Result<(), Stop> {
    let touching = Touching::prepare(machine, true)?;
    let [.., applicate] = touching.stylus.plane.axes();
    let position = touching.first(machine, applicate, -1.0)?.at[applicate];
    let control = machine.control();
    let circumference = control.bit("_CBIT[14]");
    let stored = control.active_length()[applicate];
    let (found, trigger) = evaluate::length(stored, position, height, touching.stylus.radius, circumference);
    let along = control.active_edge().map_or(0, |edge| control.length_along_applicate(edge));
    let name = format!("{}[{},{}]", LENGTHS[along], control.tool, control.edge);
    let geometry = control.variable(&name).unwrap_or_default();
    store(machine, &touching, &[(5, trigger)]);
    machine.write_correction(name, geometry + found - stored);
    Ok(())
}

/// Trigger values of the plane, active diameter of the ball and skew, in a ring of this diameter.
///
/// # Errors
/// No signal, or what was hit or refused.
pub fn ring(machine: &mut dyn Machine, diameter: f64) -> Result<(), Stop> {
    let touching = Touching::prepare(machine, true)?;
    let found = touching.ring(machine, diameter)?;
    let control = machine.control();
    let axes = control.plane.axes();
    // the data count in the directions of the machine
    let mirrored = [0, 1].map(|place| control.mirrored(axes[place]));
    let of = |place: usize| match (found.triggers[place], mirrored[place]) {
        (triggers, false) => triggers,
        ([minus, plus], true) => [-plus, -minus],
    };
    let skew = |place: usize| if mirrored[place] { -found.skew[place] } else { found.skew[place] };
    let ([x, to_x], [y, to_y]) = (of(0), of(1));
    let data = [(0, found.ball), (1, x), (2, to_x), (3, y), (4, to_y), (7, skew(0)), (8, skew(1))];
    let into_tool = control.bit("_CBIT[15]"); // B:13655-13656
    let name = format!("{RADIUS}[{},{}]", control.tool, control.edge);
    store(machine, &touching, &data);
    if into_tool {
        machine.write_correction(name, found.ball / 2.0);
    }
    Ok(())
}

/// Writes data of the probe, mm, and notes how it was calibrated.
fn store(machine: &mut dyn Machine, touching: &Touching, data: &[(usize, f64)]) {
    let (field, mono) = touching.settings.probe;
    let per = machine.control().basic_factor();
    for (place, value) in data {
        machine.write(&format!("_WP[{},{place}]", field - 1), value / per);
    }
    for (name, code) in (Used { field, mono, milling: true }).noted(machine.control()) {
        machine.write(&name, code);
    }
}
