//! CYCLE116: centre and radius of a circle through points that the program has (B:2408-2469). It measures nothing; a
//! program calls it with variables of its own.

#[cfg(test)]
mod tests;

use super::common::{CYCLE, length};
use super::spread;
use crate::catalogue::prelude::*;
use crate::evaluate;
use crate::geometry::fit;

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
    aims: Aims {
        elements: &[(When::Always, Element::Points)],
        corrects: &[(When::Always, Corrects::Nothing, &[])],
        options: &[(When::Always, "aim-from", "aim-from-circle")],
    },
    source: "B:2408-2469",
    ..CYCLE
};

/// The names of the coordinates of the points that are given completely, and where these are.
fn points(inputs: &Inputs) -> (Vec<[Name; 2]>, Vec<[f64; 2]>) {
    let count = inputs.integer(COUNT).clamp(3, 4) as usize;
    let given = |names: &[Name; 2]| {
        let [x, y] = names.map(|name| inputs.given(name));
        Some((*names, [x?, y?]))
    };
    POINTS[..count].iter().filter_map(given).unzip()
}

/// Points in line or upon each other: the cycle gives 61316 back (B:2447-2448). Close together they determine it badly.
fn checks(inputs: &Inputs, _: &Control, found: &mut Vec<Diagnostic>) {
    let (_, places) = points(inputs);
    let complete = inputs.given(COUNT) == Some(places.len() as f64);
    let at = POINTS[0][0];
    match fit::circle(&places) {
        _ if !complete => {}
        None => found.push(refused(61316, "cycle116-no-circle", at)),
        Some(([x, y], _)) => {
            let seen = |[a, b]: &[f64; 2]| Degrees::of((b - y).atan2(a - x));
            let directions: Vec<Degrees> = places.iter().map(seen).collect();
            let uncertain = evaluate::spread::circle(&directions);
            found.extend(uncertain.and_then(|circle| spread::circle(circle, at)));
        }
    }
}

/// The points with their coordinates, and the circle through them.
fn picture(inputs: &Inputs) -> Picture {
    let (names, places) = points(inputs);
    let found = fit::circle(&places);
    let size = found.map_or(10.0, |(_, radius)| radius);
    let mut shapes = Vec::new();
    if let Some((centre, radius)) = found {
        shapes.push(circle(ShapeKind::Edge, centre, radius).of(COUNT));
        shapes.push(circle(ShapeKind::Axis, centre, radius / 40.0));
    }
    for ([abscissa, ordinate], [x, y]) in names.into_iter().zip(places) {
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

const NEEDED: &[Need] = &[required(When::Always, "need-116-points")];
const FOUR: When = When::Number { param: COUNT, is: &[4.0] };

/// The elements of the array that the program hands over (B:2430-2438), in their order.
const PARAMS: &[Param] = &[
    Param {
        kind: Kind::Choice(&[(3, "cycle116-three"), (4, "cycle116-four")]),
        alarm: Some(Code::Alarm(61317)),
        needs: NEEDED,
        example: "3",
        ..param(COUNT, "116-count", "B:2430;A:15858")
    },
    coordinate(0, 0, "0", "B:2431"),
    coordinate(0, 1, "10", "B:2432"),
    coordinate(1, 0, "-10", "B:2433"),
    coordinate(1, 1, "0", "B:2434"),
    coordinate(2, 0, "0", "B:2435"),
    coordinate(2, 1, "-10", "B:2436"),
    Param { needs: &[required(FOUR, "need-116-fourth")], ..coordinate(3, 0, "", "B:2437") },
    Param { needs: &[required(FOUR, "need-116-fourth")], ..coordinate(3, 1, "", "B:2438") },
];

/// Abscissa (0) or ordinate (1) of a point. The unit is not named; the result has the same (B:2431-2446).
const fn coordinate(point: usize, axis: usize, example: &'static str, source: &'static str) -> Param {
    Param {
        unit: Unit::ActiveLength,
        needs: NEEDED,
        example,
        ..param(POINTS[point][axis], ["116-abscissa", "116-ordinate"][axis], source)
    }
}

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

/// Centre and radius, mm. Error: 61317 for neither 3 nor 4 points (A:15858), 61316 without a circle through them
/// (A:15857).
fn computed(inputs: &Inputs) -> Result<([f64; 2], f64), u32> {
    let count = inputs.number(COUNT);
    if count != 3.0 && count != 4.0 {
        return Err(61317);
    }
    let (_, places) = points(inputs);
    let complete = places.len() as f64 == count;
    complete.then(|| fit::circle(&places)).flatten().ok_or(61316)
}
