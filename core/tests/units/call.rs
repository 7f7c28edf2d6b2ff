//! A call with physical values, written by the form and run.

use super::machines::machine_for;
use super::{Errors, Physical};
use probewright_core::check::check;
use probewright_core::control::{Control, Units};
use probewright_core::entry::{Cycle, Style, Typed, factor};
use probewright_core::program::write::snippet;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax;

/// Physical values as a form takes them on this control.
fn typed(cycle: &Cycle, values: &Physical, control: &Control) -> Typed {
    let as_typed = |(name, value): &(&'static str, f64)| {
        let param = cycle.params.iter().find(|param| param.name == *name);
        let per = factor(param.expect(name).unit, control);
        ((*name).to_owned(), format!("{}", value / per))
    };
    values.iter().map(as_typed).collect()
}

/// The call, written by the form and run as a program that begins with a G function of units.
pub fn measure(cycle: &'static Cycle, values: &Physical, basic: Units, code: u16, errors: Errors) -> Outcome {
    let mut setup = machine_for(cycle, values, basic);
    let mut at_call = setup.control.clone();
    assert!(at_call.choose_units(code));
    let typed = typed(cycle, values, &at_call);
    let checked = check(cycle, &typed, &at_call);
    let inputs = checked.inputs.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        (solid.errors.shift, solid.errors.size) = errors;
    }
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    for probe in &mut setup.tool_probes {
        probe.solid.errors.shift = errors.0;
    }
    if let Some(tool) = proposal.real_tool {
        let in_use = (setup.control.tool, setup.control.edge);
        setup.real_tools.insert(in_use, tool);
    }
    setup.position = setup.control.to_machine(proposal.start);
    let text = format!("G{code}\n{}M30\n", snippet(cycle, &typed, &at_call, Style::Direct, None).text);
    let outcome = run(&syntax::read(cycle.dialect, text.as_bytes()), &setup, Limits::default());
    assert_eq!(outcome.stop, None, "{text}{:?}", outcome.diagnostics);
    outcome
}
