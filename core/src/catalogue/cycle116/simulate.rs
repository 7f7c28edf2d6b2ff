//! What CYCLE116 computes and hands back (B:2440-2448). It stops no program.

use super::params::COUNT;
use super::points;
use crate::catalogue::sinumerik::results;
use crate::entry::Inputs;
use crate::geometry::fit;
use crate::machine::{Machine, Stop};

/// No circle through the points (A:15857).
const NO_CIRCLE: u32 = 61316;
/// The number of points is neither 3 nor 4 (A:15858).
const NUMBER: u32 = 61317;

/// Centre, radius and status into the array, the number of the alarm beside it.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let found = circle(inputs);
    if let Ok(([abscissa, ordinate], radius)) = found {
        for (name, value) in [("_DATE[9]", abscissa), ("_DATE[10]", ordinate), ("_DATE[11]", radius)] {
            results::named_length(machine, name, value);
        }
    }
    let failed = f64::from(u8::from(found.is_err()));
    results::set(machine, "_DATE[12]", failed);
    results::hand_back(machine, "_ALM", found.err());
    Ok(())
}

/// Centre and radius, mm. Error: number of the alarm.
fn circle(inputs: &Inputs) -> Result<([f64; 2], f64), u32> {
    let count = inputs.number(COUNT);
    if count != 3.0 && count != 4.0 {
        return Err(NUMBER);
    }
    let places: Vec<[f64; 2]> = points(inputs).iter().map(|(_, place)| *place).collect();
    let complete = places.len() as f64 == count;
    complete.then(|| fit::circle(&places)).flatten().ok_or(NO_CIRCLE)
}
