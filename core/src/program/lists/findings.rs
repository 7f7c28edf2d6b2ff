//! Faults of these lists that published programs and posts have: an argument that was lost, so that all behind it stand
//! one place too early; a measuring path in inches; a number that belongs elsewhere. Each has a cure where only one is
//! possible.

use super::{ListCall, list_call, list_calls, set};
use crate::catalogue::CYCLES;
use crate::catalogue::newer::arguments::{Argument, Evidence};
use crate::catalogue::newer::{self, CYCLE150_SHORT, LISTS};
use crate::check::newer::{DIRECTION, MINUS, PROBES, at_argument, is_newer_zero, is_nothing, path, probe_number};
use crate::check::{Parsed, parse};
use crate::control::units::INCH;
use crate::diagnostic::{Code, Diagnostic, Edit, Severity, Span};
use crate::entry::{Inputs, ProbeUse, names};
use crate::message::Message;
use crate::own;
use crate::program::calls::CallSite;
use crate::syntax::{Program, SyntaxError};

/// Mode of a call that says where the centre is.
const BESIDE: f64 = 10.0;

/// What is wrong with a call in such a list, in place of what follows from it; none: what was found is kept.
pub fn of_call(program: &Program, site: &CallSite) -> Option<Vec<Diagnostic>> {
    site.newer_list()?;
    let call = list_call(program, program.word_at(site.span)?)?;
    let shifted = shifted(program, &call);
    if shifted.as_ref().is_some_and(|one| one.severity == Severity::Error) {
        return Some(shifted.into_iter().collect());
    }
    let mut found: Vec<Diagnostic> =
        site.diagnostics.iter().map(|one| with_cure(program, site, &call, one.clone())).collect();
    let inch = inch_path(program, site, &call);
    if inch.is_some() {
        // why the path is as long as it is says more than that it is
        found.retain(|one| one.code != own::NEWER_OPEN.code() || one.param != Some(names::FA));
    }
    found.extend(inch);
    found.extend(shifted);
    found.extend(beyond(&call));
    Some(found.into_iter().map(|one| at_argument(call.list, one)).collect())
}

/// Arguments behind the last one that is published: some control may have them.
fn beyond(call: &ListCall) -> Option<Diagnostic> {
    let most = call.list.args.len();
    let first = call.arguments.iter().skip(most).find(|argument| !argument.text.is_empty())?;
    let finding = own::NEWER_BEYOND.finding().text("cycle", call.list.name).number("most", most as f64);
    Some(finding.on(first.place))
}

/// Calls whose number of arguments leaves open what some of them are.
pub fn of_places(program: &Program) -> impl Iterator<Item = Diagnostic> {
    let open = |call: &ListCall| std::ptr::eq(call.list, &CYCLE150_SHORT) && call.arguments.len() > 1;
    let count = |call: &ListCall| call.arguments.len() as f64;
    let told = move |call: ListCall| {
        let finding = own::NEWER_PLACES.finding().text("cycle", call.list.name).number("count", count(&call));
        finding.on(call.span)
    };
    list_calls(program).into_iter().filter(open).map(told)
}

/// What is wrong with a call of a cycle that the older control does not have, by what is published for all lists.
pub fn of_alone(program: &Program) -> impl Iterator<Item = Diagnostic> {
    let alone = |call: &ListCall| newer::title(call.list).is_some();
    list_calls(program).into_iter().filter(alone).flat_map(|call| {
        let at = |name: &str| call.index(name).and_then(|index| call.arguments.get(index));
        let probe = at("S_PRNUM").and_then(|one| match parse(&one.text) {
            Parsed::Number(number) => Some(probe_number(ProbeUse::Workpiece, number)?.on(one.place)),
            _ => None,
        });
        let path = at("S_FA").and_then(|one| Some(path(&one.text)?.on(one.place)));
        probe.into_iter().chain(path).map(|one| at_argument(call.list, one)).collect::<Vec<_>>()
    })
}

/// The cure of a finding that the list alone has: a measuring path where none is given, another variant or no number
/// for what stands in argument 2.
fn with_cure(program: &Program, site: &CallSite, call: &ListCall, one: Diagnostic) -> Diagnostic {
    if one.code == Code::Alarm(61308) && one.cure.is_none() {
        return with_path(program, site, call, one);
    }
    let target = one.code == own::NEWER_TARGET.code() && one.severity != Severity::Error;
    if target { with_target(program, site, call, one) } else { one }
}

/// The measuring path as delivered.
fn with_path(program: &Program, site: &CallSite, call: &ListCall, one: Diagnostic) -> Diagnostic {
    let default = site.cycle.param(names::FA.as_str()).and_then(|param| param.default);
    let Some((path, index)) = default.zip(call.list.position(names::FA)) else { return one };
    if is_expression(call, index) {
        return one;
    }
    let edits: Vec<Edit> = set(program, call, index, &path.to_string()).into_iter().collect();
    if edits.is_empty() {
        return one;
    }
    one.cured(Message::new("newer-set-path").number("value", path), edits)
}

/// Whether an argument is more than a number: no cure puts a value in its place.
fn is_expression(call: &ListCall, index: usize) -> bool {
    let text = call.arguments.get(index).map_or("", |argument| argument.text.as_str());
    !text.is_empty() && !matches!(parse(text), Parsed::Number(_))
}

/// A number in argument 2 that this variant does not correct: the variant that does, or no number.
fn with_target(program: &Program, site: &CallSite, call: &ListCall, one: Diagnostic) -> Diagnostic {
    let number = |index: usize| match call.arguments.get(index).map(|argument| parse(&argument.text)) {
        Some(Parsed::Number(number)) => Some(number),
        _ => None,
    };
    let written = |variant: f64| call.list.when.holds(&Inputs::new(site.cycle, variant as i64));
    let zero = number(1).filter(|code| is_newer_zero(*code));
    let variant = zero.and_then(|_| number(0)).map(|variant| variant + 100.0).filter(|variant| written(*variant));
    match variant {
        Some(variant) => {
            let text = variant.to_string();
            let label = Message::new("newer-set-variant").text("value", text.as_str());
            one.cured(label, set(program, call, 0, &text).into_iter().collect())
        }
        None if is_expression(call, 1) => one,
        None => one.cured(Message::new("newer-set-none"), set(program, call, 1, "").into_iter().collect()),
    }
}

/// A post that multiplies the measuring path by 25.4 in a program in mm: no path in mm is a number of thousandths of an
/// inch.
fn inch_path(program: &Program, site: &CallSite, call: &ListCall) -> Option<Diagnostic> {
    let metric = matches!(site.unit_function as u16, 71 | 710);
    let index = call.list.position(names::FA).filter(|_| metric)?;
    let argument = call.arguments.get(index)?;
    let Parsed::Number(path) = parse(&argument.text) else { return None };
    let thousandths = path / INCH * 1000.0;
    if path < INCH / 2.0 || (thousandths - thousandths.round()).abs() > 1e-6 {
        return None;
    }
    let meant = thousandths.round() / 1000.0;
    let finding = own::NEWER_INCH.finding().number("value", path).number("meant", meant).on(argument.place);
    let label = Message::new("newer-set-path").number("value", meant);
    let edits = set(program, call, index, &meant.to_string()).into_iter().collect();
    Some(finding.at(names::FA).cured(label, edits))
}

/// An argument too few or too many. An error where something stands at an impossible place, and that explains it; a
/// note where it is only what no published program has there.
fn shifted(program: &Program, call: &ListCall) -> Option<Diagnostic> {
    let texts: Vec<&str> = call.arguments.iter().map(|argument| argument.text.as_str()).collect();
    let find = |tells: &dyn Fn(usize, &str) -> bool| (0..texts.len()).find(|index| tells(*index, texts[*index]));
    let proof = find(&|index, text| is_proof(call, index, text));
    let wrong = proof.or_else(|| find(&|index, text| is_unheard(call, index, text)))?;
    let readings = readings(call, &texts, wrong, proof.is_some());
    let lost = readings.iter().any(|one| one.lost);
    let one = readings.first().filter(|one| readings.iter().all(|other| other.texts == one.texts));
    let places = || readings.iter().filter(|one| one.lost == lost).map(|one| one.at);
    let (mut first, mut last) = (places().min()?, places().max()?);
    if one.is_some() {
        // beside an omitted argument a comma more is the same wherever it is
        (first, last) = if lost { (last, last) } else { (first, first) };
    }
    let sentence = match (proof.is_some(), lost, first == last) {
        (true, true, true) => own::NEWER_LOST,
        (true, true, false) => own::NEWER_LOST_BETWEEN,
        (true, false, true) => own::NEWER_MANY,
        (true, false, false) => own::NEWER_MANY_BETWEEN,
        (false, true, _) => own::NEWER_LOST_PERHAPS,
        (false, false, _) => own::NEWER_MANY_PERHAPS,
    };
    let tells = Argument::at(call.list, wrong);
    let finding = sentence.finding().number("place", first as f64 + 1.0).number("until", last as f64 + 1.0);
    let finding = finding.text("name", tells.key()).text("value", texts[wrong]);
    let finding = finding.on(if proof.is_some() { call.span } else { call.arguments[wrong].place });
    let mut all = call.arguments.iter().map(|argument| argument.place).chain([call.span]);
    if one.is_none() || all.any(|place| program.is_of_macro(place)) {
        return Some(finding);
    }
    let argument = call.arguments.get(first)?;
    let edit = match lost {
        true => Edit::insert(argument.place.start, ","),
        false => Edit::remove(argument.place.start, call.arguments.get(first + 1)?.place.start),
    };
    let label = if lost { "newer-set-lost" } else { "newer-set-many" };
    Some(finding.cured(Message::new(label).number("place", first as f64 + 1.0), vec![edit]))
}

/// A way to read a call with one comma more or less.
struct Reading<'a> {
    /// Whether an argument was lost; else one is too many.
    lost: bool,
    /// Index of that argument.
    at: usize,
    /// The arguments as they are meant.
    texts: Vec<&'a str>,
}

/// Every way in which each argument can be what it is. What is lost may be something that programs always have.
fn readings<'a>(call: &ListCall, texts: &[&'a str], wrong: usize, proven: bool) -> Vec<Reading<'a>> {
    let lost = (1..=wrong).map(|at| Reading { lost: true, at, texts: with(texts, at) });
    let surplus = (1..=wrong).filter(|at| texts[*at].is_empty());
    let surplus = surplus.map(|at| Reading { lost: false, at, texts: without(texts, at) });
    let (mut found, rest): (Vec<_>, Vec<_>) = lost.chain(surplus).partition(|one| fits(call, &one.texts, 0));
    if (proven || !found.is_empty()) && found.iter().all(|one| one.lost) {
        found.extend(rest.into_iter().filter(|one| one.lost && fits(call, &one.texts, 1)));
    }
    // programs leave `S_KNUM1` empty in the lists that are understood
    let tool = call.index("S_KNUM1").filter(|_| call.list.is_written());
    let usual = |one: &Reading| tool.and_then(|tool| one.texts.get(tool)).is_none_or(|text| is_nothing(text));
    if found.iter().any(usual) {
        found.retain(usual);
    }
    found
}

/// The arguments with an empty one before this index.
fn with<'a>(texts: &[&'a str], at: usize) -> Vec<&'a str> {
    let mut texts = texts.to_vec();
    texts.insert(at.min(texts.len()), "");
    texts
}

/// The arguments without the one at this index.
fn without<'a>(texts: &[&'a str], at: usize) -> Vec<&'a str> {
    let mut texts = texts.to_vec();
    texts.remove(at);
    texts
}

/// What cannot stand there, so that the call is wrong: a text where a number belongs, a number of a probe that no
/// control has (61313). A wrong value elsewhere may be just that.
fn is_proof(call: &ListCall, index: usize, text: &str) -> bool {
    let telling = text.starts_with('"') || Argument::at(call.list, index).name == "S_PRNUM";
    telling && cannot_stand(call, index, text)
}

/// What no published program has there, in the lists that are understood.
fn is_unheard(call: &ListCall, index: usize, text: &str) -> bool {
    let Parsed::Number(number) = parse(text) else { return false };
    call.list.is_written() && unheard(call, Argument::at(call.list, index).name, number)
}

/// Whether each argument can be what it is, and what programs always have is there, in the lists that are understood:
/// but for so many.
fn fits(call: &ListCall, texts: &[&str], lacking: usize) -> bool {
    let empty = |name: &str| call.index(name).is_some_and(|index| texts.get(index).is_none_or(|text| text.is_empty()));
    let size = call.index("S_SETV0").map_or("S_SETV", |_| if empty("S_SETV") { "S_SETV0" } else { "S_SETV" });
    let missing = ["S_PRNUM", "S_FA", size].into_iter().filter(|name| empty(name)).count();
    let missing = if call.list.is_written() { missing } else { 0 };
    let stands = |(index, text): (usize, &&str)| !cannot_stand(call, index, text);
    // a centre beside the start goes with its mode
    let centre = ["S_XM", "S_YM"].into_iter().any(|name| call.index(name).is_some() && !empty(name));
    let mode = call.index("_AMODE").and_then(|index| Some(parse(texts.get(index)?)));
    let alone = centre && matches!(mode, Some(Parsed::Number(mode)) if mode < BESIDE);
    let behind = texts.iter().skip(call.list.args.len()).any(|text| !text.is_empty());
    texts.iter().enumerate().all(stands) && missing == lacking && !alone && !behind
}

/// Whether a text cannot be this argument: a number outside what it can be, a text where a number belongs or the
/// reverse, a number that no published program has there. Of arguments whose sort is not published anything can be.
fn cannot_stand(call: &ListCall, index: usize, text: &str) -> bool {
    let argument = Argument::at(call.list, index);
    if text.starts_with('"') {
        let number = argument.param.is_some() || argument.evidence() == Evidence::Values;
        return number && argument.name != "S_TNAME";
    }
    let Parsed::Number(number) = parse(text) else { return false };
    let whole = number.fract() == 0.0;
    if is_unheard(call, index, text) {
        return true;
    }
    match argument.name {
        "S_TNAME" => true,
        "S_PRNUM" => !(whole && (1.0..=PROBES).contains(&number)),
        "S_FA" => number <= 0.0,
        "S_TSA" => number < 0.0,
        _ => false,
    }
}

/// Whether no published program has such a number there, in the lists that are understood: the working plane is 1, the
/// options and the last argument are empty, the axes of CYCLE998 are two digits of an axis. 0 is as if omitted.
fn unheard(call: &ListCall, name: &str, number: f64) -> bool {
    let of_two_axes = call.index("S_SETV3").is_some();
    let never = match name {
        "S_MCBIT" | "_DP" => true,
        "_DMODE" => number < 1.0 || number.fract() != 0.0,
        "S_NMSP" => number < 1.0 || number.fract() != 0.0,
        DIRECTION => ![1.0, MINUS].contains(&number),
        "S_MA" => of_two_axes && !(101.0..=302.0).contains(&number),
        _ => false,
    };
    never && number != 0.0
}

/// The bracket of a call of a cycle that its line does not close: at the end of what is written there.
pub fn unclosed(program: &Program, error: &SyntaxError) -> Option<Edit> {
    if error.sentence != &own::SYNTAX_BRACKET {
        return None;
    }
    let block = program.blocks.get(program.line_of(error.span.start) as usize)?;
    let text = program.text(block.span);
    let (mut open, mut quoted, mut end) = (Vec::new(), false, 0);
    for (at, byte) in text.iter().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            _ if quoted => {}
            b';' => break,
            b'(' => open.push(at),
            b')' => {
                open.pop()?;
            }
            _ => {}
        }
        if !byte.is_ascii_whitespace() {
            end = at + 1;
        }
    }
    let [bracket] = open[..] else { return None };
    let before = text.get(..bracket)?.trim_ascii_end();
    let letters = before.iter().rev().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
    let name =
        Span { start: block.span.start + (before.len() - letters) as u32, end: block.span.start + before.len() as u32 };
    let mut lists = CYCLES.iter().flat_map(|cycle| cycle.lists.iter()).chain(&LISTS);
    let of_cycle = !quoted && lists.any(|list| program.is(name, list.name));
    of_cycle.then(|| Edit::insert(block.span.start + end as u32, ")"))
}
