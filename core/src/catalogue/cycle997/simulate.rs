//! What CYCLE997 does: sphere by sphere, then the frame (B:8341-8417).

use super::params::{ANGLE, DIAMETER, THREE};
use super::points::centres;
use super::sphere::{Plan, Sphere};
use crate::catalogue::place::in_plane;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::{Block, all_calibrated, ball_known};
use crate::catalogue::sinumerik::{correct, tolerance};
use crate::evaluate::position::{correctable, position};
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::Target;
use crate::geometry::V3;
use crate::machine::trace::Step;

/// Runs the cycle from the present position, which is above the first sphere at safety height.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 997);
    results::integer(machine, 0, inputs.integer(names::KNUM));
    results::integer(machine, 11, 0);
    results::integer(machine, 12, 0);
    let block = Block::prepare(machine, inputs)?;
    all_calibrated(machine, &block, sides(inputs))?;
    if ANGLE.holds(inputs) {
        ball_known(machine, &block)?;
    }
    let target = correct::zero_target(machine, inputs)?;
    if let Some(target) = target.filter(|_| THREE.holds(inputs)) {
        correctable(machine.control(), &target).map_err(|number| failed(machine, number))?;
    }
    let plan = Plan { block: &block, inputs, safety: machine.position()[block.axes[2]] };
    let mut spheres = Vec::new();
    for (index, centre) in centres(inputs).into_iter().enumerate() {
        let set = Sphere { centre, diameter: inputs.number(names::SETVAL) };
        let mut found = set;
        until_done(|repetition| {
            found = plan.measure(machine, &set)?;
            let differences = report(machine, index, &set, &found);
            tolerance::safe(machine, inputs, &differences, repetition) // sphere by sphere (B:8373-8379)
        })?;
        spheres.push((set, found));
    }
    let limit = inputs.number(names::TNVL);
    match (target, &spheres[..]) {
        (Some(target), [sphere]) => move_frame(machine, &target, sphere),
        (Some(target), [one, two, three]) => turn_frame(machine, &target, limit, [one, two, three])?,
        _ => {}
    }
    Ok(())
}

/// Axes and directions in which trigger values count: paraxially all around and on top; at an angle the ball counts,
/// and with the diameter one point more (B:8371).
fn sides(inputs: &Inputs) -> &'static [(usize, f64)] {
    const ALL: &[(usize, f64)] = &[(2, -1.0), (0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)];
    match (ANGLE.holds(inputs), DIAMETER.holds(inputs)) {
        (false, _) => ALL,
        (true, true) => &ALL[..2],
        (true, false) => &ALL[..1],
    }
}

/// A sphere as set and as found.
type Measured = (Sphere, Sphere);

/// Diameter and centre as numbers.
fn quantities(sphere: &Sphere) -> [f64; 4] {
    let [x, y, z] = sphere.centre;
    [sphere.diameter, x, y, z]
}

/// Setpoints of the first sphere, actual values and differences of each (B:8267-8297); the differences.
fn report(machine: &mut dyn Machine, index: usize, set: &Sphere, found: &Sphere) -> [f64; 4] {
    let (set, actual) = (quantities(set), quantities(found));
    let differences = std::array::from_fn(|i| actual[i] - set[i]);
    let first = 4 + 8 * index;
    for i in 0..4 {
        if index == 0 {
            results::length(machine, i, set[i]);
        }
        results::length(machine, first + i, actual[i]);
        results::length(machine, first + 4 + i, differences[i]);
    }
    differences
}

/// One sphere: its centre gets the set coordinates, the rotation stays (B:8383-8405).
fn move_frame(machine: &mut dyn Machine, target: &Target, (set, found): &Measured) {
    let [set, actual] = [set, found].map(|sphere| in_plane(machine.control(), sphere.centre));
    correct::zero(machine, target, &zero_offset::Measured { actual, set, axes: [true; 3] });
}

/// Three spheres: CYCLE119 finds translation and rotation; beyond `_TNVL` nothing is corrected (B:8407-8413).
fn turn_frame(machine: &mut dyn Machine, target: &Target, limit: f64, spheres: [&Measured; 3]) -> Result<(), Stop> {
    let control = machine.control();
    let placed = |sphere: &Sphere| V3::from(in_plane(control, sphere.centre));
    let set = spheres.map(|(set, _)| placed(set));
    let actual = spheres.map(|(_, found)| placed(found));
    let position = position(&set, &actual).map_err(|number| failed(machine, number))?;
    let message = Message::new("evaluate-distortion").number("distortion", position.distortion).number("limit", limit);
    machine.record(Step::Decision { message });
    position.within(limit).map_err(|number| failed(machine, number))?;
    correct::position(machine, target, &position.motion, set[0].into());
    Ok(())
}

/// Ends the cycle with an alarm of what follows from the measured points; it stays in `_OVI[12]` too (B:8304).
pub(super) fn failed(machine: &mut dyn Machine, number: u32) -> Stop {
    results::integer(machine, 12, i64::from(number));
    alarm(machine, number)
}
