//! From typed values to inputs, parameter by parameter.

use super::{Parsed, Text, braking, error, expression::written, parse, targets, text, variants};
use crate::check::upkeep;
use crate::control::{Control, Edge, Transverse, tools::side};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::entry::{Cycle, Inputs, Kind, Level, Param, Typed, Unit, factor, unit_behind};
use crate::evaluate::knum;
use crate::message::Message;
use crate::name::Name;
use crate::own::{self, Own};
use crate::range::Range;

/// Beyond this no length, angle or feed of a machine makes sense, and contact could not be computed to 1e-9 mm.
const LIMIT: f64 = 1e6;
/// Beyond this no number counts or names anything; `_KNUM` has nine digits.
const WHOLE_LIMIT: f64 = 1e9;

/// Result of a check.
pub struct Checked {
    /// Findings in the order of the parameters, those over several parameters last.
    pub diagnostics: Vec<Diagnostic>,
    /// What the call means; none when there is an error or a value is known at run time only.
    pub inputs: Option<Inputs>,
}

/// Checks typed values of a call on a control in this state; what the call does with its data first counts as done.
pub fn check(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Checked {
    let due = upkeep::due(cycle, control);
    if due.is_empty() {
        return checked(cycle, typed, control);
    }
    let mut checked = checked(cycle, typed, &upkeep::done(control, &due));
    let doubts = due.into_iter().map(|one| one.finding);
    checked.diagnostics.extend(doubts);
    checked
}

fn checked(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Checked {
    let mut diagnostics = Vec::new();
    let mut inputs = read(cycle, typed, control, &mut diagnostics);
    match variant(cycle, &inputs, &diagnostics) {
        Ok(number) => inputs.variant = number,
        Err(finding) => return Checked { diagnostics: vec![*finding], inputs: None },
    }
    let whole = inputs.clone();
    for param in cycle.params {
        let Some((level, reason)) = param.need(&whole) else {
            diagnostics.retain(|other| other.param != Some(param.name));
            inputs.numbers.remove(&param.name);
            inputs.texts.remove(&param.name);
            continue;
        };
        let machine = !whole.text(param.name).is_empty();
        if empty(typed, param) && !machine {
            absent(param, level, reason, control, &mut diagnostics);
        } else if let Some(finding) = judge(param, &whole, control) {
            if finding.severity == Severity::Error {
                inputs.numbers.remove(&param.name);
            }
            diagnostics.push(finding);
        }
    }
    (cycle.checks)(&inputs, control, &mut diagnostics);
    braking::look(&inputs, control, &mut diagnostics);
    let stops = |other: &Diagnostic| other.severity == Severity::Error || other.code == own::EXPRESSION.code();
    let complete = !diagnostics.iter().any(stops);
    Checked { diagnostics, inputs: complete.then_some(inputs) }
}

/// Tells the inputs which tool is in use; the data of the machine that count for it are there.
pub fn tool_in_use(inputs: &mut Inputs, control: &Control) {
    let edge = control.active_edge();
    inputs.tool_type = edge.map_or(0, |edge| edge.kind);
    inputs.body = edge.and_then(Edge::body);
    let nose = edge.filter(|edge| edge.is_turning()).map(|edge| side(edge.tip, inputs.recodes()));
    inputs.nose = nose.filter(|sides| *sides != [0.0; 2]);
}

/// Values by parameter with defaults filled in, in mm; the first variant where it cannot be read.
pub fn read(cycle: &'static Cycle, typed: &Typed, control: &Control, diagnostics: &mut Vec<Diagnostic>) -> Inputs {
    let mut inputs = Inputs::new(cycle, cycle.variants.first().map_or(0, |variant| variant.number));
    inputs.five_digit_edges = knum::five_digit_edges(control);
    inputs.plane = control.plane;
    inputs.units = control.active_units;
    inputs.diameters = control.transverse != Transverse::Radius;
    for name in cycle.settings {
        inputs.settings.insert(name, control.number(name));
    }
    tool_in_use(&mut inputs, control);
    for param in cycle.params {
        let text = typed.get(param.name.as_str()).map_or("", |text| text.trim());
        if let Kind::Text(most) = param.kind {
            match written_text(text, most) {
                Ok("") if param.is_machine_datum() => {
                    inputs.texts.insert(param.name, control.text(param.name.as_str()).into());
                }
                Ok("") => {}
                Ok(text) => {
                    inputs.written.insert(param.name);
                    inputs.texts.insert(param.name, text.into());
                }
                Err(finding) => diagnostics.push((*finding).at(param.name)),
            }
            continue;
        }
        if !text.is_empty() {
            inputs.written.insert(param.name);
        }
        let unit = param.unit_with(&inputs);
        match value(param, unit, text, control) {
            Ok(Some(number)) => drop(inputs.numbers.insert(param.name, number)),
            Ok(None) => {}
            Err(finding) => diagnostics.push((*finding).at(param.name)),
        }
        if let Kind::Variant(_) = param.kind
            && let Ok(number) = variant(cycle, &inputs, diagnostics)
        {
            inputs.variant = number; // decides what the others are
        }
    }
    if let Ok(number) = variant(cycle, &inputs, diagnostics) {
        inputs.variant = number;
    }
    inputs
}

/// A number in mm, or the default.
fn value(param: &Param, unit: Unit, text: &str, control: &Control) -> Result<Option<f64>, Box<Diagnostic>> {
    let number = match parse(text) {
        Parsed::Empty => return Ok(param.fallback(control).map(|number| number * factor(unit, control))),
        Parsed::Number(number) => number,
        Parsed::Expression if written(control.dialect, text).is_some() => return Err(Box::new(expression(text))),
        Parsed::Expression | Parsed::Wrong => return Err(Box::new(own::NOT_A_NUMBER.finding().text("value", text))),
    };
    if number.abs() > limit(param) && !param.watches {
        return Err(Box::new(own::TOO_LARGE.finding().text("value", text)));
    }
    if whole(&param.kind) && number.fract() != 0.0 {
        return Err(Box::new(own::NOT_WHOLE.finding().text("value", text)));
    }
    Ok(Some(number * factor(unit, control)))
}

/// Beyond this a value of a parameter is refused. A bare number, as one that is only made into a text, has no bound.
fn limit(param: &Param) -> f64 {
    match (whole(&param.kind), param.unit) {
        (true, _) => WHOLE_LIMIT,
        (false, Unit::None) => f64::MAX,
        _ => LIMIT,
    }
}

/// Whether only whole numbers count.
fn whole(kind: &Kind) -> bool {
    !matches!(kind, Kind::Real | Kind::ChoiceIf(..) | Kind::Text(_))
}

/// A text that can be written, or what is wrong with it.
fn written_text(text: &str, most: usize) -> Result<&str, Box<Diagnostic>> {
    let inner = match text::parse(text) {
        Text::Plain(inner) => inner,
        Text::Expression => return Err(Box::new(expression(text))),
    };
    if inner.chars().count() > most {
        return Err(Box::new(own::TEXT_LONG.finding().number("most", most as f64)));
    }
    if inner.chars().any(|c| c == '"' || c.is_control()) {
        return Err(Box::new(own::TEXT_CHARACTERS.finding()));
    }
    Ok(inner)
}

/// What is known at run time only.
fn expression(text: &str) -> Diagnostic {
    own::EXPRESSION.finding().text("value", text)
}

/// The variant, or the only finding that counts without it.
fn variant(cycle: &'static Cycle, inputs: &Inputs, said: &[Diagnostic]) -> Result<i64, Box<Diagnostic>> {
    let Some(param) = cycle.params.iter().find(|param| matches!(param.kind, Kind::Variant(_))) else {
        return Ok(chosen(cycle, inputs));
    };
    if let Some(finding) = said.iter().find(|other| other.param == Some(param.name)) {
        return Err(Box::new(finding.clone()));
    }
    let Some(number) = inputs.given(param.name) else {
        return Err(Box::new(missing(param, "need-always").under(param.alarm.unwrap_or(own::MISSING.code()))));
    };
    if cycle.variants.iter().any(|variant| variant.number as f64 == number) {
        return Ok(number as i64);
    }
    let finding = error(param.alarm.unwrap_or(own::RANGE.code()), variants::cause(cycle, param, number));
    Err(Box::new(finding.hint(variants::hint(cycle, number)).at(param.name)))
}

/// The variant that an address chooses by being given; the first one where none does.
fn chosen(cycle: &'static Cycle, inputs: &Inputs) -> i64 {
    let by_address = cycle.params.iter().find_map(|param| {
        inputs.given(param.name)?;
        Some(param.chooses.iter().find(|one| one.when.holds(inputs))?.variant)
    });
    by_address.unwrap_or(inputs.variant)
}

/// Whether nothing was typed.
fn empty(typed: &Typed, param: &Param) -> bool {
    typed.get(param.name.as_str()).is_none_or(|text| text.trim().is_empty())
}

/// The value is missing; `reason` says when it is needed.
fn missing(param: &Param, reason: &'static str) -> Diagnostic {
    own::MISSING.finding().text("param", param.name).hint(Message::new(reason)).at(param.name)
}

/// Nothing was typed.
fn absent(param: &Param, level: Level, reason: &'static str, control: &Control, diagnostics: &mut Vec<Diagnostic>) {
    match (level, param.fallback(control)) {
        (Level::Optional, _) => {}
        (Level::Required, Some(number)) => {
            let finding = own::DELIVERED.finding().text("param", param.name).number("value", number);
            let finding = finding.text("unit", unit_behind(param.unit, control));
            diagnostics.push(finding.hint(Message::new(reason)).at(param.name));
        }
        (Level::Required, None) => {
            let finding = missing(param, reason);
            diagnostics.push(match param.alarm {
                // the macro itself refuses a missing address
                Some(code @ Code::Nct(_)) => finding.under(code),
                // a cycle of the log does without no text that it needs
                Some(code) if matches!(param.kind, Kind::Text(_)) => finding.under(code),
                _ => finding,
            });
        }
    }
}

/// A value against its own parameter: range, choices, code, usual range.
pub(super) fn judge(param: &Param, inputs: &Inputs, control: &Control) -> Option<Diagnostic> {
    let number = inputs.given(param.name)?;
    let unit = param.unit_with(inputs);
    let shown = number / factor(unit, control);
    let code = param.alarm.unwrap_or(own::RANGE.code());
    let choices = param.kind.choices(inputs);
    let allowed = match choices {
        Some(choices) => choices.iter().any(|(value, _)| *value as f64 == number),
        None => param.range.contains(number),
    };
    if !allowed {
        let finding = outside(own::RANGE, param.name, (shown, unit), control);
        return Some(finding.under(code).hint(range_hint(param, choices, control)));
    }
    if matches!(param.kind, Kind::Knum) {
        return targets::findings(param, inputs, control);
    }
    let usual = param.usual.contains(number);
    (!usual).then(|| {
        let finding = outside(own::UNUSUAL, param.name, (shown, unit), control);
        finding.hint(bounds(own::UNUSUAL.hint, param.usual, param.unit, control))
    })
}

fn outside(sentence: Own, param: Name, (shown, unit): (f64, Unit), control: &Control) -> Diagnostic {
    sentence.finding().text("param", param).number("value", shown).text("unit", unit_behind(unit, control)).at(param)
}

/// What is allowed, in words that fit the kind and the ends of the range.
fn range_hint(param: &Param, choices: Option<&[(i64, &str)]>, control: &Control) -> Message {
    if let Some(choices) = choices {
        let list: Vec<String> = choices.iter().map(|(value, _)| value.to_string()).collect();
        return Message::new("check-range-choice-hint").text("choices", list.join(", "));
    }
    let range = param.range;
    match (range.min.is_finite(), range.max.is_finite(), range.min_included) {
        (true, true, _) => bounds(own::RANGE.hint, range, param.unit, control),
        (true, false, true) => bounds("check-range-from-hint", range, param.unit, control),
        (true, false, false) => bounds("check-range-above-hint", range, param.unit, control),
        _ => bounds("check-range-below-hint", range, param.unit, control),
    }
}

/// Both ends in the unit of the field.
fn bounds(key: &'static str, range: Range, unit: Unit, control: &Control) -> Message {
    let per = factor(unit, control);
    let mut message = Message::new(key).text("unit", unit_behind(unit, control));
    if range.min.is_finite() {
        message = message.number("min", range.min / per);
    }
    if range.max.is_finite() {
        message = message.number("max", range.max / per);
    }
    message
}
