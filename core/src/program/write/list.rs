//! SINUMERIK: assignments and the call, with the arguments that its call style takes.

use super::{Lines, Source, Written, is_expression, value, word};
use crate::catalogue::newer::arguments::Argument;
use crate::check::{Parsed, Target, expression, newer, parse, target};
use crate::control::Plane;
use crate::diagnostic::Diagnostic;
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, ArgumentList, Kind, Param, Style, Typed, names};
use crate::name::Name;
use crate::own;
use crate::program::values::opposite;
use std::collections::BTreeMap;

/// The call in this call style.
pub(super) fn write(source: &Source, style: Style) -> Written {
    let of_style = |list: &&ArgumentList| list.style == style;
    let mut lists = source.cycle.lists.iter().filter(of_style);
    let none = !lists.clone().any(ArgumentList::is_written);
    let list = lists.find(|list| list.fits(&source.inputs));
    if let (Some(value), Some(list)) = (open_variant(source), list)
        && (style == Style::Operate || !list.has_variant(source.cycle))
    {
        // selections make the variant, and its number is not known before the run; nor is what its target means
        return nothing(own::WRITE_VARIANT_OPEN.finding().text("value", value));
    }
    if let (Style::Operate, Some(list)) = (style, list)
        && let Some(finding) = target_elsewhere(source).or_else(|| foreign(source, list))
    {
        return nothing(finding);
    }
    match list {
        Some(list) => listed(source, list),
        None if style == Style::Direct && none => {
            let words = source.values.iter().filter(|(param, value)| param.name != value.as_str());
            let words: Vec<_> = words.map(|(param, value)| assignment(param, value)).collect();
            let mut text = Lines::default();
            text.assignments(&words);
            text.push(source.cycle.name);
            text.line_end();
            source.whole(text)
        }
        None => nothing(unwritten(source, style, none)),
    }
}

/// Why a call style has no call for these values; `none`: for no values of this cycle. Of the lists of newer controls
/// the digits that are published are written.
fn unwritten(source: &Source, style: Style, none: bool) -> Diagnostic {
    let listed = style == Style::Operate && source.cycle.lists.iter().any(|list| list.style == style);
    let sentence = match (listed, none) {
        (true, true) => own::WRITE_UNPUBLISHED,
        (true, false) => own::WRITE_UNPUBLISHED_VARIANT,
        (false, true) => own::WRITE_NO_LIST,
        (false, false) => own::WRITE_NO_LIST_VARIANT,
    };
    let finding = sentence.finding().text("cycle", source.cycle.name);
    if sentence == own::WRITE_UNPUBLISHED_VARIANT {
        return finding.number("value", source.inputs.variant as f64);
    }
    finding
}

/// No text, and why.
fn nothing(finding: Diagnostic) -> Written {
    Written { text: String::new(), places: BTreeMap::new(), said: Vec::new(), findings: vec![finding] }
}

fn assignment(param: &Param, value: &str) -> (Option<Name>, String) {
    (Some(param.name), word(&param.name, value))
}

/// The variant where it is known at run time only, as written: selections cannot say it.
fn open_variant<'a>(source: &'a Source) -> Option<&'a str> {
    let text = source.value(&source.cycle.variant_param()?)?;
    (parse(text) == Parsed::Expression).then_some(text)
}

/// A value that means something else in the list of newer controls.
fn foreign(source: &Source, list: &ArgumentList) -> Option<Diagnostic> {
    let values: Typed = source.values.iter().map(|(param, text)| (param.name.to_string(), text.clone())).collect();
    let foreign = newer::foreign(source.cycle, list, &values, source.control);
    // a zero offset of newer controls goes there as it is, as does a number that their programs have
    let number = |name: &Name| match parse(values.get(name.as_str())?) {
        Parsed::Number(number) => Some(number),
        _ => None,
    };
    let published = |name: &Name| number(name).is_some_and(|number| list.publishes(*name, number));
    let zero = |name: &Name| *name == names::KNUM && source.inputs.given(*name).is_some_and(newer::is_newer_zero);
    let known = |name: &Name| zero(name) || published(name);
    let name = foreign.into_iter().find(|name| values.contains_key(name.as_str()) && !known(name))?;
    Some(own::WRITE_NEWER.finding().text("param", name).text("value", values.get(name.as_str())?.as_str()).at(name))
}

/// A target that the list of newer controls takes in another argument, or under a number that is not known.
fn target_elsewhere(source: &Source) -> Option<Diagnostic> {
    let (param, text) = source.values.iter().find(|(param, _)| param.name == names::KNUM)?;
    match target(param, &source.inputs) {
        Target::Tool if parse(text) == Parsed::Number(0.0) => None,
        Target::Tool => Some(own::WRITE_NEWER_TOOL.finding()),
        Target::Zero => {
            let code = source.inputs.given(names::KNUM);
            code.filter(|code| !newer::is_newer_zero(*code))?;
            Some(own::WRITE_NEWER_ZERO.finding().text("value", text))
        }
    }
}

fn listed(source: &Source, list: &'static ArgumentList) -> Written {
    let (mut before, mut auxiliary, mut findings) = (Vec::new(), Vec::new(), Vec::new());
    let mut said = source.names();
    for value in source.values.iter().filter(|(param, _)| !takes(source, list, param)) {
        let (param, text) = value;
        match list.style {
            // the datum holds it already, on whichever way it came there
            Style::Direct | Style::Indirect if param.name == text.as_str() => {}
            Style::Direct => before.push(assignment(param, text)),
            Style::Indirect if is_auxiliary(param, text) => auxiliary.push(value),
            Style::Indirect => {
                findings.push(beside(param, text));
                before.push(assignment(param, text));
            }
            // what it is worth at the call only the run tells
            Style::Operate if is_expression(param, text) => {
                return nothing(own::WRITE_EXPRESSION_LOST.finding().text("name", param.name).text("value", text));
            }
            Style::Operate => {
                said.retain(|name| *name != param.name);
                let default = param.fallback(source.control).map_or(Parsed::Empty, Parsed::Number);
                let lost = || own::WRITE_LOST.finding().text("name", param.name).at(param.name);
                findings.extend((parse(text) != default).then(lost));
            }
        }
    }
    if list.style == Style::Operate {
        findings.extend(to_look_at(source, list));
    }
    let mut text = Lines::default();
    text.assignments(&before);
    if !auxiliary.is_empty() {
        let value = |name: &Name| {
            let given = auxiliary.iter().find(|(param, _)| param.name == *name);
            (Some(*name), given.map_or(String::new(), |(_, text)| text.clone()))
        };
        call(&mut text, AUXILIARY, &AUXILIARY_ARGS.iter().map(value).collect::<Vec<_>>());
    }
    call(&mut text, list.name, &arguments(source, list));
    Written { said, findings, ..source.whole(text) }
}

/// Whether the list says the value: as an argument, or the variant as selections.
fn takes(source: &Source, list: &ArgumentList, param: &Param) -> bool {
    list.position(param.name).is_some()
        || source.cycle.variant_param() == Some(param.name) && list.style != Style::Direct
}

/// Whether `CYCLE_PARA` can give it: a 0 there keeps the value of before (B:11734); an expression may come to one.
fn is_auxiliary(param: &Param, text: &str) -> bool {
    let may_be_zero = parse(text) == Parsed::Number(0.0) || is_expression(param, text);
    AUXILIARY_ARGS.contains(&param.name) && !may_be_zero
}

fn beside(param: &Param, text: &str) -> Diagnostic {
    let sentence = match (AUXILIARY_ARGS.contains(&param.name), is_expression(param, text)) {
        (true, true) => own::WRITE_EXPRESSION,
        (true, false) => own::WRITE_ZERO,
        (false, _) => own::WRITE_BESIDE,
    };
    sentence.finding().text("name", param.name).text("value", text)
}

/// The arguments in order, each with its parameter. An omitted one is 0: what is used and was not typed is as delivered
/// or as on the machine.
fn arguments(source: &Source, list: &'static ArgumentList) -> Vec<(Option<Name>, String)> {
    let mut selections = list.selections(source.inputs.variant).unwrap_or_default().into_iter();
    let variant = source.cycle.variant_param();
    let written = |(index, arg): (usize, &Arg)| match arg {
        Arg::Param(name) => (Some(*name), parameter(source, name)),
        Arg::Newer(..) => newer_argument(source, &Argument::at(list, index)),
        Arg::Down(name) => (Some(*name), opposite(&parameter(source, name))),
        Arg::Select(_) => (variant, selections.next().map_or(String::new(), |number| number.to_string())),
        Arg::Is(number) => (None, number.to_string()),
        Arg::Variable(name) | Arg::Output(name) => (None, (*name).to_owned()),
        Arg::Open => (None, String::new()),
    };
    list.args.iter().enumerate().map(written).collect()
}

/// An argument of the list of a newer control: the value, else what programs write there.
fn newer_argument(source: &Source, argument: &Argument) -> (Option<Name>, String) {
    let param = argument.param.and_then(|name| source.cycle.param(name.as_str()));
    let own = match param.filter(|param| matches!(param.kind, Kind::Text(_))) {
        Some(param) => source.typed.get(argument.name).and_then(|text| value(source.cycle.dialect, param, text)),
        None => Some(own_value(source, argument.key())),
    };
    let own = own.unwrap_or_default();
    let named = (!argument.key().is_empty()).then(|| Name::new(argument.key()));
    if !own.is_empty() {
        return (named, own);
    }
    let unsaid = argument.param.is_some_and(|name| newer::is_unsaid(name, &source.inputs));
    let text = match argument.param {
        Some(param) if unsaid => source.value(&param).map_or(String::new(), str::to_owned),
        // what programs write counts before what the older control has as delivered
        Some(param) if source.value(&param).is_none() && !argument.usual().is_empty() => String::new(),
        Some(param) => parameter(source, &param),
        None => own,
    };
    let name = argument.param.or(named);
    if !text.is_empty() {
        return (name, text);
    }
    let beside = argument.name == newer::MODE && newer::CENTRE.iter().any(|name| !own_value(source, name).is_empty());
    let usual = match beside {
        true => newer::BESIDE.to_string(),
        false if unsaid => String::new(),
        false => argument.usual().to_owned(),
    };
    (name.filter(|_| usual != NO_TEXT), usual) // an empty text is read as no value
}

/// A text that says nothing.
const NO_TEXT: &str = "\"\"";

/// What was typed for something that only the lists of newer controls have, or under its name there.
fn own_value(source: &Source, name: &str) -> String {
    let text = source.typed.get(name).map_or("", |text| text.trim());
    match parse(text) {
        Parsed::Number(number) => number.to_string(),
        Parsed::Expression => expression::written(source.cycle.dialect, text).unwrap_or_default(),
        Parsed::Wrong if is_quoted(text) => text.to_owned(),
        Parsed::Empty | Parsed::Wrong => String::new(),
    }
}

fn is_quoted(text: &str) -> bool {
    let inside = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    inside.is_some_and(|inside| !inside.contains(['"', '\n', '\r']))
}

/// What of a call in the list of a newer control has to be looked at before the first run: the measuring direction,
/// which the older call does not say, the infeed, whose sign differs between programs, and the rotary axis.
fn to_look_at(source: &Source, list: &'static ArgumentList) -> Vec<Diagnostic> {
    let has = |name: &str| Argument::all(list).any(|one| one.name == name);
    let direction = has(newer::DIRECTION) && own_value(source, newer::DIRECTION).is_empty();
    let direction = direction.then(|| own::WRITE_DIRECTION.finding().at(Name::new(newer::DIRECTION)));
    let infeed = source.value(&names::ID).filter(|text| parse(text) != Parsed::Number(0.0));
    let infeed = infeed.filter(|_| Argument::all(list).any(|one| one.is_infeed() && one.param == Some(names::ID)));
    let infeed = infeed.map(|text| own::WRITE_INFEED.finding().text("value", text).at(names::ID));
    let rotary = source.value(&names::RA).filter(|_| list.position(names::RA).is_some());
    let rotary = rotary.map(|text| own::WRITE_ROTARY.finding().text("value", text).at(names::RA));
    let plane = source.control.plane;
    let unknown = plane != Plane::G17 && has(PLANE) && own_value(source, PLANE).is_empty();
    let plane = || own::WRITE_PLANE.finding().text("plane", format!("{plane:?}")).at(Name::new(PLANE));
    let plane = unknown.then(plane);
    direction.into_iter().chain(infeed).chain(rotary).chain(plane).chain(coarse(source, list)).collect()
}

/// The argument for the plane: every published program has 1 there, and none says in which plane it runs.
const PLANE: &str = "_DMODE";

/// The number of a settable zero offset whose coarse part the older control corrects by a user datum: in the list that
/// number means the fine part.
fn coarse(source: &Source, list: &ArgumentList) -> Option<Diagnostic> {
    let number = source.inputs.given(names::KNUM).filter(|_| list.position(names::KNUM).is_some())?;
    let settable = (1.0..=99.0).contains(&number) && number.fract() == 0.0;
    let coarse = settable && source.control.number(newer::COARSE) == 1.0;
    let found = || {
        let told = own::WRITE_COARSE.finding().number("value", number).number("coarse", number + 10_000.0);
        told.hint_number("coarse", number + 10_000.0)
    };
    coarse.then(|| found().at(names::KNUM))
}

fn parameter(source: &Source, name: &str) -> String {
    if let Some(text) = source.value(name) {
        return text.to_owned();
    }
    let kept = |param: &&Param| param.is_machine_datum() || param.need(&source.inputs).is_some();
    let param = source.cycle.param(name).filter(kept);
    param
        .and_then(|param| param.fallback(source.control))
        .filter(|number| *number != 0.0)
        .map_or(String::new(), |number| number.to_string())
}

/// `NAME(1,,3)`; omitted arguments at the end are left out, and have no place elsewhere.
fn call(text: &mut Lines, name: &str, arguments: &[(Option<Name>, String)]) {
    let said = arguments.iter().rposition(|(_, argument)| !argument.is_empty()).map_or(0, |last| last + 1);
    text.push(name);
    text.push("(");
    for (index, (of, argument)) in arguments.iter().take(said).enumerate() {
        if index > 0 {
            text.push(",");
        }
        text.word(of.filter(|_| !argument.is_empty()), argument);
    }
    text.push(")");
    text.line_end();
}
