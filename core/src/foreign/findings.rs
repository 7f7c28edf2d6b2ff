//! What is told of a program of such a control.

use super::write::are_crossed;
use super::{Foreign, ForeignCall, ForeignCycle, ForeignValue, Page, Parameter, Value, control_of, first_line};
use crate::diagnostic::{Diagnostic, Edit, Severity};
use crate::message::Message;
use crate::own;
use crate::range::Range;

/// Most calls of a program that are told.
const MOST: usize = 1000;

/// What is told of a program in place of what reading another language in it would find; none: it is none of these
/// controls.
pub fn of_program(source: &[u8]) -> Option<Vec<Diagnostic>> {
    let control = control_of(source)?;
    let calls = (control.calls)(source);
    let about = own::FOREIGN_PROGRAM.finding().text("control", control.name).number("count", calls.len() as f64);
    let mut found = vec![about.on(first_line(source))];
    for call in calls.iter().take(MOST) {
        match call.cycle {
            Some(cycle) => found.extend(of_call(control, cycle, call)),
            None => found.push(unknown(control, call)),
        }
    }
    found.sort_by_key(|one| (one.span.map_or(0, |span| span.start), one.severity));
    Some(found)
}

fn unknown(control: &Foreign, call: &ForeignCall) -> Diagnostic {
    own::FOREIGN_UNKNOWN.finding().text("call", call.name.as_str()).text("control", control.name).on(call.span)
}

/// What it measures, and why it is not written.
fn about(control: &Foreign, cycle: &'static ForeignCycle, call: &ForeignCall) -> Diagnostic {
    let told = Diagnostic::new(Severity::Note, own::FOREIGN_CALL.code(), Message::new(cycle.title()));
    let told = told.on(call.span);
    match cycle.unwritten(control) {
        Some(why) => told.hint(why),
        None => told,
    }
}

/// What it measures, and what is wrong with it.
fn of_call(control: &Foreign, cycle: &'static ForeignCycle, call: &ForeignCall) -> Vec<Diagnostic> {
    let mut found = vec![about(control, cycle, call)];
    if cycle.page == Page::Nothing {
        return found;
    }
    let missing: Vec<&Parameter> = cycle.parameters.iter().filter(|one| value(call, one.name).is_none()).collect();
    let twice: Vec<&ForeignValue> = call
        .values
        .iter()
        .enumerate()
        .filter(|(at, one)| named(&call.values[..*at], &one.name))
        .map(|(_, one)| one)
        .collect();
    for one in &twice {
        found.push(written_twice(cycle, call, one, &missing));
    }
    let names: Vec<&str> = missing.iter().filter(|one| !one.optional).map(|one| one.name).collect();
    if !names.is_empty() && twice.is_empty() {
        let lacks = own::FOREIGN_MISSING.finding().text("names", names.join(", "));
        found.push(lacks.text("call", cycle.name).on(call.span));
    }
    for one in &call.values {
        let Some(parameter) = cycle.parameter(&one.name) else {
            let surplus = own::FOREIGN_SURPLUS.finding().text("name", one.name.as_str());
            found.push(surplus.text("call", cycle.name).on(one.name_span));
            continue;
        };
        let named = parameter.value == Value::Tool && one.text.starts_with('"');
        if one.is_nothing() && !named {
            let nothing = own::FOREIGN_VALUE.finding().text("name", parameter.name).text("value", one.text.as_str());
            found.push(nothing.on(one.span));
        }
        if one.number().is_some_and(|value| !parameter.takes(value)) {
            found.push(outside(parameter, one));
        }
    }
    found.extend(limits(cycle, call));
    found
}

fn named(values: &[ForeignValue], name: &str) -> bool {
    values.iter().any(|one| one.name.eq_ignore_ascii_case(name))
}

fn value<'a>(call: &'a ForeignCall, name: &str) -> Option<&'a ForeignValue> {
    call.values.iter().find(|one| one.name.eq_ignore_ascii_case(name))
}

/// A parameter that is written a second time: where the table has the missing one behind it, that is meant.
fn written_twice(
    cycle: &'static ForeignCycle,
    call: &ForeignCall,
    one: &ForeignValue,
    missing: &[&Parameter],
) -> Diagnostic {
    let found = own::FOREIGN_TWICE.finding().text("name", one.name.as_str()).text("call", call.name.as_str());
    let found = found.on(one.name_span);
    let place = cycle.parameters.iter().position(|known| known.name.eq_ignore_ascii_case(&one.name));
    let behind = place.and_then(|place| cycle.parameters.get(place + 1));
    let meant = behind.filter(|behind| missing.iter().any(|known| known.name == behind.name));
    match meant {
        Some(meant) => {
            let label = Message::new("foreign-rename").text("name", meant.name);
            found.cured(label, vec![Edit { span: one.name_span, insert: meant.name.to_owned() }])
        }
        None => found,
    }
}

fn outside(parameter: &Parameter, one: &ForeignValue) -> Diagnostic {
    let within = one.number().is_some_and(|value| parameter.range.contains(value));
    let sentence = if within { own::FOREIGN_NO_SUCH } else { own::FOREIGN_RANGE };
    let found = sentence.finding().text("name", parameter.name).text("value", one.text.as_str());
    let Range { min, max, .. } = parameter.range;
    found.number("min", min).number("max", max).hint_number("min", min).hint_number("max", max).on(one.span)
}

/// Limits of one size that have changed places.
fn limits(cycle: &'static ForeignCycle, call: &ForeignCall) -> Option<Diagnostic> {
    cycle.limits().find_map(|(maximum, minimum)| {
        let (most, least) = (value(call, maximum.name)?, value(call, minimum.name)?);
        let wrong = are_crossed(most.number()?, least.number()?);
        let found = || own::FOREIGN_LIMITS.finding().text("maximum", maximum.name).text("minimum", minimum.name);
        wrong.then(|| found().on(most.span))
    })
}
