//! G101: protected positioning of the stylus (C:106-144).

use super::nct;
use super::nct::part;
use crate::catalogue::prelude::*;
use crate::machine::MotionKind;

const TARGET: Param = Param {
    kind: Kind::Real,
    unit: Unit::ActiveLength,
    needs: &[optional(When::Always, "need-g101-target")],
    source: "C:114",
    ..PARAM
};

/// The macro.
pub static G101: Cycle = Cycle {
    name: "G101",
    key: "g101",
    variants: &[Variant { number: 0, key: "g101-positioning", source: "C:106" }],
    purpose: Purpose::MILLING,
    params: &[
        Param { name: address::X, key: "g101-x", example: "120", ..TARGET },
        Param { name: address::Y, key: "g101-y", ..TARGET },
        Param { name: address::Z, key: "g101-z", example: "200", ..TARGET },
        Param {
            default: Some(1500.0),
            default_inch: Some(60.0),
            unit: Unit::BasicFeed,
            range: Range::POSITIVE,
            usual: Range::closed(1.0, 5000.0),
            needs: &[optional(When::Always, "need-nct-optional")],
            ..param(address::F, "g101-f", "C:115")
        },
    ],
    alarms: &[&[
        nct::NO_TOOL_LENGTH,
        nct::PATH_OBSTRUCTED,
        nct::STYLUS_IN_CONTACT,
        nct::FALSE_TRIGGER,
        nct::OUT_OF_POSITION,
    ]],
    checks,
    help: Help::new(&[
        &[
            measures(When::Always, "help-g101-measures-nothing", "C:106-112"),
            before(When::Always, "help-g101-before-free", "C:125-132"),
            order(When::Always, "help-g101-order-straight", "C:106-112"),
            corrects(When::Always, "help-g101-corrects-nothing", "C:121-123"),
            wrong(When::Always, "help-g101-wrong-obstructed", "C:125-132"),
            wrong(When::Always, "help-g101-wrong-incremental", "C:108"),
        ],
        nct::help::NO_MACRO,
    ]),
    picture: Drawing::new(picture),
    simulation: Some(Simulation::new(propose, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Move)],
        corrects: &[(When::Always, Corrects::Nothing, &[])],
        options: &[],
    },
    source: "C:106-144",
    ..nct::MACRO
};

fn target(inputs: &Inputs, from: [f64; 3], incremental: bool) -> [f64; 3] {
    std::array::from_fn(|axis| match inputs.given(nct::axis_name(axis)) {
        Some(way) if incremental => from[axis] + way,
        Some(position) => position,
        None => from[axis],
    })
}

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready(machine)?;
    let incremental = machine.control().incremental;
    let to = target(inputs, machine.position().0, incremental);
    let outcome = go(machine, Wcs(to), inputs.number(address::F));
    machine.control().set(nct::POSITION_LOST, f64::from(u8::from(outcome.is_err())));
    outcome
}

/// To the target, or as far as the limits of the axes let it: then it is not reached (C:121-123, C:132).
fn go(machine: &mut dyn Machine, to: Wcs, feed: f64) -> Result<(), Stop> {
    let from = machine.position();
    let limited = machine.control().limited(from, to);
    let end = limited.unwrap_or(to);
    machine.travel(end, MotionKind::Positioning, feed, true)?;
    match limited {
        Some(_) => Err(Stop::Alarm(nct::OUT_OF_POSITION)),
        None => Ok(()),
    }
}

fn checks(inputs: &Inputs, _: &Control, findings: &mut Vec<Diagnostic>) {
    if address::AXES.iter().all(|axis| inputs.given(*axis).is_none()) {
        findings.push(own::G101_NO_TARGET.finding());
    }
}

/// A flat part well below the way.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let [abscissa, ordinate, height] = control.plane.axes().map(|axis| target(inputs, [0.0; 3], false)[axis]);
    let block = Shape::Block { size: [100.0, 100.0, 20.0] };
    let top = [abscissa, ordinate, height.min(0.0) - 20.0];
    part::propose(block, top, [0.0, 0.0, height.max(0.0) + 50.0], control)
}

/// Ball radius of the drawing, and half the length of the part, mm.
const BALL: f64 = 3.0;
const FACE: f64 = 30.0;

/// Of its own, as nothing is touched. From the side: an axis of the plane to the right, the tool axis up; the way goes
/// over what lies below. An axis without an address keeps its position.
fn picture(inputs: &Inputs) -> Picture {
    let axes = inputs.plane.axes();
    let given = |axis: usize| inputs.given(nct::axis_name(axis)).is_some();
    let [abscissa, ordinate, applicate] = axes;
    let start = [-FACE, FACE / 2.0];
    let across = given(abscissa) || given(ordinate);
    let end = [if across { FACE } else { start[0] }, if given(applicate) { FACE } else { start[1] }];
    let zero = [-1.5 * FACE, -FACE];
    let mut shapes = vec![
        line(ShapeKind::Axis, vec![zero, [zero[0], FACE]]),
        line(ShapeKind::Axis, vec![zero, [1.5 * FACE, zero[1]]]).text("0"),
        rectangle(ShapeKind::Cut, [0.0, -FACE / 2.0], [FACE, FACE]),
        line(ShapeKind::Path, vec![start, end]).of(address::F),
        circle(ShapeKind::Path, start, BALL),
        circle(ShapeKind::Probe, end, BALL),
    ];
    let along = [abscissa, ordinate].into_iter().filter(|axis| given(*axis));
    for (row, axis) in along.enumerate() {
        let below = zero[1] - (row + 1) as f64 * BALL * 2.0;
        let name = nct::axis_name(axis);
        shapes.push(dimension(name, [zero[0], below], [end[0], below]));
    }
    if given(applicate) {
        let beside = end[0] + 3.0 * BALL;
        let name = nct::axis_name(applicate);
        shapes.push(dimension(name, [beside, zero[1]], [beside, end[1]]));
    }
    Picture { view: View::Section, shapes }
}
