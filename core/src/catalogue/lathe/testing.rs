//! A turning machine and calls for it, for the tests of its cycles.

#![allow(clippy::unwrap_used)]

use crate::catalogue::example::changed;
use crate::catalogue::{find, sinumerik};
use crate::check::check;
use crate::control::{Control, Edge, Frame, Plane, Tool, Transverse, delivery};
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Inputs, Typed};
use crate::machine::Setup;
use crate::name::Name;

/// The control in G18 with mean value memory and the probe of the manual's examples in use (B:10695-10709): T9, type
/// 580, position 7.
pub fn lathe() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G18;
    control.transverse = Transverse::Diameter;
    control.set("_CHBIT[4]", 1.0);
    let edge = Edge { kind: 580, tip: 7, length: [40.123, 100.456, 0.0], radius: 3.0, ..Edge::default() };
    let probe = Tool { name: "PROBE".into(), edges: [(1, edge)].into() };
    control.tools.insert(9, probe);
    (control.tool, control.edge) = (9, 1);
    control
}

/// The worked example with some values changed.
pub fn call(cycle: &Cycle, changes: &[(&str, &str)]) -> Typed {
    changed(cycle, changes)
}

/// Everything that is found in a call on a changed turning machine; the last is the parameter, empty where there is
/// none.
pub fn found(
    cycle: &'static Cycle,
    changes: &[(&str, &str)],
    prepare: impl Fn(&mut Control),
) -> Vec<(Severity, Code, &'static str)> {
    let mut control = lathe();
    prepare(&mut control);
    let found = check(cycle, &call(cycle, changes), &control).diagnostics;
    let short = found.into_iter();
    short.map(|one| (one.severity, one.code, one.param.map_or("", Name::as_str))).collect()
}

/// T number of the turning tool that the calls of [`measured`] correct.
pub const TURNING_TOOL: i64 = 7;

/// A calibrated turning machine in G54, with a turning tool; X as the call gives it.
pub fn setup(plane: Plane, transverse: Transverse) -> Setup {
    let mut setup = Setup::turning(plane);
    setup.control.transverse = transverse;
    for (name, value) in
        [("$TC_DP1[7,1]", 500.0), ("$TC_DP2[7,1]", 3.0), ("$TC_DP3[7,1]", 60.0), ("$TC_DP4[7,1]", 40.0)]
    {
        assert!(setup.control.set_variable(name, value));
    }
    let frame = Frame::translation([0.0, 0.0, 250.0]);
    setup.control.frames.insert(1, frame);
    setup.control.settable = 1;
    setup.control.activate(1);
    setup
}

/// A call in this plane with default values of what is not given; wide bands, without a mean value.
pub fn inputs(name: &str, plane: Plane, values: &[(&'static str, f64)]) -> Inputs {
    let variant = values.iter().find(|(name, _)| *name == "_MVAR");
    let variant = variant.map_or(0, |(_, value)| *value as i64);
    let mut all = vec![("_KNUM", 1.0), ("_TNUM", TURNING_TOOL as f64), ("_FA", 5.0)];
    all.extend(sinumerik::testing::WIDE_BANDS);
    let cycle = find(Dialect::Sinumerik, name).unwrap();
    all.retain(|(name, _)| cycle.param(name).is_some()); // one that calibrates corrects nothing
    all.extend(values);
    let mut inputs = sinumerik::testing::call(name, variant, &all);
    inputs.plane = plane;
    inputs
}

/// The setup with the part that the call proposes and the probe before it.
pub fn placed(mut setup: Setup, inputs: &Inputs) -> Setup {
    let proposal = (inputs.cycle.work().unwrap().propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids.extend(proposal.fixture);
    setup.position = setup.control.to_machine(proposal.start);
    setup
}
