//! What a form for a list of newer controls writes and does not simulate.

use crate::catalogue::newer::arguments::Argument;
use crate::check::newer::{self, DIRECTION, MINUS};
use crate::check::{Parsed, parse};
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{ArgumentList, Cycle, Inputs, Typed, names};
use crate::name::Name;
use crate::own;

/// A note at each value that has no part in what is simulated.
pub(super) fn notes(
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    typed: &Typed,
    inputs: Option<&Inputs>,
    control: &Control,
) -> Vec<Diagnostic> {
    let own = Argument::all(list).filter(|one| one.is_field() && says(typed, one.name));
    let own = own.filter(|one| one.name != DIRECTION || !inputs.is_some_and(|inputs| leads(typed, inputs, control)));
    let own = own.map(|one| own::NEWER_UNSIMULATED.finding().text("param", one.name).at(Name::new(one.name)));
    own.chain(newer::unsure(cycle, list, typed, control)).collect()
}

fn says(typed: &Typed, name: &str) -> bool {
    let text = typed.get(name).map_or("", String::as_str);
    !matches!(parse(text), Parsed::Empty | Parsed::Number(0.0))
}

/// Whether the proposed start lies so that the set position is in the direction that the call says.
fn leads(typed: &Typed, inputs: &Inputs, control: &Control) -> bool {
    let Some(work) = inputs.cycle.work() else { return false };
    let axis = control.plane.axes().get((inputs.integer(names::MA) % 10 - 1) as usize).copied();
    let start = (work.propose)(inputs, control).start.0;
    let Some(start) = axis.and_then(|axis| start.get(axis)) else { return false };
    let wanted = if inputs.number(names::SETVAL) < *start { MINUS } else { 1.0 };
    typed.get(DIRECTION).is_some_and(|text| parse(text) == Parsed::Number(wanted))
}
