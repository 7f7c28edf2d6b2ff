//! CYCLE116: centre and radius of a circle through points that the program has (B:2408-2469). It measures nothing; a
//! program calls it with variables of its own.

#[cfg(test)]
mod tests;

use super::common::{CYCLE, PARAM, alarms, integer, length, required};
use super::sinumerik::results;
use super::spread;
use crate::catalogue::prelude::*;
use crate::control::MachineSort;
use crate::entry::*;
use crate::evaluate;
use crate::geometry::fit;
use crate::picture::figures::{circle, dimension};
use crate::picture::{Picture, View};

/// The cycle. Example: that of the manual, B:2456-2466.
pub static CYCLE116: Cycle = Cycle {
    name: "CYCLE116",
    key: "cycle116",
    variants: &[Variant { number: 0, key: "cycle116-circle", source: "B:2408;A:2591" }],
    purpose: Purpose { probe: ProbeUse::None, machine: MachineSort::Any, ..Purpose::MILLING },
    lists: &[ArgumentList::direct("CYCLE116", &[Arg::Variable("_DATE"), Arg::Output("_ALM")], "B:2422")],
    params: PARAMS,
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
    simulation: Some(Simulation::new(|_, _| Proposal::default(), simulate)),
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

/// Number of points.
const COUNT: Name = Name::new("_DATE[0]");
/// Abscissa and ordinate of each point.
const POINTS: [[Name; 2]; 4] = [
    [Name::new("_DATE[1]"), Name::new("_DATE[2]")],
    [Name::new("_DATE[3]"), Name::new("_DATE[4]")],
    [Name::new("_DATE[5]"), Name::new("_DATE[6]")],
    [Name::new("_DATE[7]"), Name::new("_DATE[8]")],
];

const FOUR: When = When::Number { param: COUNT, is: &[4.0] };

/// The elements of the array that the program hands over (B:2430-2438), in their order.
const PARAMS: &[Param] = &[
    Param {
        name: COUNT,
        key: "116-count",
        kind: Kind::Choice(&[(3, "cycle116-three"), (4, "cycle116-four")]),
        alarm: Some(Code::Alarm(61317)),
        needs: &[required(When::Always, "need-116-points")],
        example: "3",
        source: "B:2430;A:15858",
        ..PARAM
    },
    abscissa(0, "0", "B:2431"),
    ordinate(0, "10", "B:2432"),
    abscissa(1, "-10", "B:2433"),
    ordinate(1, "0", "B:2434"),
    abscissa(2, "0", "B:2435"),
    ordinate(2, "-10", "B:2436"),
    Param { needs: &[required(FOUR, "need-116-fourth")], ..abscissa(3, "", "B:2437") },
    Param { needs: &[required(FOUR, "need-116-fourth")], ..ordinate(3, "", "B:2438") },
];

const fn abscissa(point: usize, example: &'static str, source: &'static str) -> Param {
    Param { name: POINTS[point][0], key: "116-abscissa", example, source, ..COORDINATE }
}

const fn ordinate(point: usize, example: &'static str, source: &'static str) -> Param {
    Param { name: POINTS[point][1], key: "116-ordinate", example, source, ..COORDINATE }
}

/// The unit is not named; the result has the same (B:2431-2446).
const COORDINATE: Param =
    Param { unit: Unit::ActiveLength, needs: &[required(When::Always, "need-116-points")], ..PARAM };

/// No circle through the points (A:15857).
const NO_CIRCLE: u32 = 61316;
/// The number of points is neither 3 nor 4 (A:15858).
const NUMBER: u32 = 61317;

/// What it computes and hands back (B:2440-2448), stopping no program: centre, radius and status into the array, the
/// number of the alarm beside it.
fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let found = computed(inputs);
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
fn computed(inputs: &Inputs) -> Result<([f64; 2], f64), u32> {
    let count = inputs.number(COUNT);
    if count != 3.0 && count != 4.0 {
        return Err(NUMBER);
    }
    let places: Vec<[f64; 2]> = points(inputs).iter().map(|(_, place)| *place).collect();
    let complete = places.len() as f64 == count;
    complete.then(|| fit::circle(&places)).flatten().ok_or(NO_CIRCLE)
}
