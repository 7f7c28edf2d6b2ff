//! Calls one after the other on one machine.

use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Inputs, Typed, Unit};
use probewright_core::machine::Setup;
use probewright_core::run::{Outcome, predict};
use probewright_core::workpiece::PartErrors;

/// All working planes.
pub const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

/// Values of a call, lengths in mm.
pub type Values = Vec<(&'static str, f64)>;

/// The values of a call with some replaced or added.
pub fn with(values: &[(&'static str, f64)], more: &[(&'static str, f64)]) -> Values {
    let kept = values.iter().filter(|(name, _)| more.iter().all(|(other, _)| other != name));
    kept.chain(more).copied().collect()
}

/// A call as it would be typed on this machine, checked.
pub fn inputs(setup: &Setup, name: &str, values: &[(&'static str, f64)]) -> Inputs {
    inputs_with(setup, name, values, &[])
}

/// The same with texts beside the numbers.
pub fn inputs_with(
    setup: &Setup,
    name: &str,
    values: &[(&'static str, f64)],
    texts: &[(&'static str, &'static str)],
) -> Inputs {
    let cycle = cycle(name);
    let control = &setup.control;
    let text = |(name, value): &(&str, f64)| {
        let per = match cycle.param(name).map(|param| param.unit) {
            Some(Unit::ActiveLength) => control.active_factor(),
            Some(Unit::BasicLength | Unit::BasicFeed) => control.basic_factor(),
            _ => 1.0,
        };
        ((*name).to_owned(), format!("{}", value / per))
    };
    let mut typed: Typed = values.iter().map(text).collect();
    typed.extend(texts.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())));
    let checked = check(cycle, &typed, control);
    let refused = || panic!("{name} {values:?}: {:?}", checked.diagnostics);
    checked.inputs.clone().unwrap_or_else(refused)
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

/// Puts the part that a call proposes on the machine, with its errors, and the probe before it.
pub fn place(setup: &mut Setup, inputs: &Inputs, errors: PartErrors) {
    let proposal = (inputs.cycle.work().unwrap().propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        solid.errors = errors;
    }
    setup.workpiece.solids.extend(proposal.fixture);
    setup.position = setup.control.to_machine(proposal.start);
}

/// Carries out a call from where the probe stands; what it wrote stays. Scatter never repeats itself.
pub fn run(setup: &mut Setup, inputs: &Inputs) -> Outcome {
    let outcome = predict(inputs.cycle, inputs, setup);
    let context = format!("{} {}", inputs.cycle.name, inputs.variant);
    assert_eq!(outcome.stop, None, "{context}");
    setup.control = outcome.control.clone();
    setup.probe.repeatability.1 += 1;
    outcome
}

/// Both: a call on the part that it proposes.
pub fn call(setup: &mut Setup, name: &str, values: &[(&'static str, f64)], errors: PartErrors) -> Outcome {
    let inputs = inputs(setup, name, values);
    place(setup, &inputs, errors);
    run(setup, &inputs)
}

/// A result `_OVR[]`, mm.
pub fn result(setup: &Setup, index: usize) -> f64 {
    setup.control.number(&format!("_OVR[{index}]")) * setup.control.active_factor()
}

/// Holds a value against what it should be.
pub fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found}, expected {expected}");
}

/// Abscissa, ordinate, applicate as X Y Z.
pub fn at(plane: Plane, point: [f64; 3]) -> [f64; 3] {
    let mut place = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(point) {
        place[axis] = value;
    }
    place
}
