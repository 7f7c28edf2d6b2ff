//! CYCLE116: centre and radius of a circle through points that the program has (B:2408-2469). It measures nothing; a
//! program calls it with variables of its own.

mod params;
mod simulate;
#[cfg(test)]
mod tests;

use super::common::{CYCLE, alarms, integer, length};
use super::spread;
use crate::check::refused;
use crate::control::{Control, MachineSort};
use crate::diagnostic::Diagnostic;
use crate::entry::*;
use crate::evaluate;
use crate::geometry::fit;
use crate::name::Name;
use crate::picture::figures::{circle, dimension};
use crate::picture::{Picture, ShapeKind, View};
use params::{COUNT, POINTS};

/// The cycle. Example: that of the manual, B:2456-2466.
pub static CYCLE116: Cycle = Cycle {
    name: "CYCLE116",
    key: "cycle116",
    variants: &[Variant { number: 0, key: "cycle116-circle", source: "B:2408;A:2591" }],
    purpose: Purpose { probe: ProbeUse::None, machine: MachineSort::Any, ..Purpose::MILLING },
    lists: &[ArgumentList::direct("CYCLE116", &[Arg::Variable("_DATE"), Arg::Output("_ALM")], "B:2422")],
    params: params::PARAMS,
    results: &[
        length("_DATE[9]", "result-116-abscissa", When::Always, "B:2444;A:2632"),
        length("_DATE[10]", "result-116-ordinate", When::Always, "B:2445;A:2633"),
        length("_DATE[11]", "result-116-radius", When::Always, "B:2446;A:2634"),
        integer("_DATE[12]", "result-116-status", When::Always, "A:2635"),
        integer("_ALM", "result-116-alarm", When::Always, "B:2448;A:2636"),
    ],
    alarms: &[&alarms([61316, 61317])], // B:2448
    checks,
    // B:2408-2469
    help: Help::new(&[&[
        measures(When::Always, "help-cycle116-does", "B:2414"),
        before(When::Always, "help-cycle116-variables", "B:2418;B:2448"),
        before(When::Always, "help-cycle116-points", "B:2430-2438"),
        order(When::Always, "help-cycle116-circle", "B:2414;B:2430"),
        corrects(When::Always, "help-cycle116-left", "B:2444-2448;A:2635"),
        wrong(When::Always, "help-cycle116-line", "B:2448;A:15857"),
        wrong(When::Always, "help-cycle116-count", "B:2448;A:15858"),
        wrong(When::Always, "help-cycle116-unseen", "B:2448"),
    ]]),
    picture: Drawing::new(picture),
    simulation: Some(Simulation::new(|_, _| Proposal::default(), simulate::simulate)),
    source: "B:2408-2469",
    ..CYCLE
};

/// The points that are given completely, with the names of their coordinates.
fn points(inputs: &Inputs) -> Vec<([Name; 2], [f64; 2])> {
    let count = inputs.integer(COUNT).clamp(3, 4) as usize;
    let given = |names: &[Name; 2]| {
        let [x, y] = names.map(|name| inputs.given(name));
        Some((*names, [x?, y?]))
    };
    POINTS[..count].iter().filter_map(given).collect()
}

/// Points in line or upon each other: the cycle gives 61316 back (B:2447-2448). Close together they determine it badly.
fn checks(inputs: &Inputs, _: &Control, found: &mut Vec<Diagnostic>) {
    let points = points(inputs);
    let complete = inputs.given(COUNT) == Some(points.len() as f64);
    let places: Vec<[f64; 2]> = points.iter().map(|(_, place)| *place).collect();
    let at = POINTS[0][0];
    match fit::circle(&places) {
        _ if !complete => {}
        None => found.push(refused(61316, "cycle116-no-circle", at)),
        Some(([x, y], _)) => {
            let seen = |[a, b]: &[f64; 2]| (b - y).atan2(a - x).to_degrees();
            let directions: Vec<f64> = places.iter().map(seen).collect();
            let uncertain = evaluate::spread::circle(&directions);
            found.extend(uncertain.and_then(|circle| spread::circle(circle, at)));
        }
    }
}

/// The points with their coordinates, and the circle through them.
fn picture(inputs: &Inputs) -> Picture {
    let points = points(inputs);
    let places: Vec<[f64; 2]> = points.iter().map(|(_, place)| *place).collect();
    let found = fit::circle(&places);
    let size = found.map_or(10.0, |(_, radius)| radius);
    let mut shapes = Vec::new();
    if let Some((centre, radius)) = found {
        shapes.push(circle(ShapeKind::Edge, centre, radius).of(COUNT));
        shapes.push(circle(ShapeKind::Axis, centre, radius / 40.0));
    }
    for ([abscissa, ordinate], [x, y]) in points {
        shapes.push(dimension(abscissa, [0.0, y], [x, y]));
        shapes.push(dimension(ordinate, [x, 0.0], [x, y]));
        shapes.push(circle(ShapeKind::Touch, [x, y], size / 25.0));
    }
    Picture { view: View::Plane, shapes }
}
