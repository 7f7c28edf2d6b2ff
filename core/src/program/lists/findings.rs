//! Faults of these lists that published programs and posts have: an argument that was lost, so that all behind it stand
//! one place too early; a measuring path in inches; a number that belongs elsewhere. Each has a cure where only one is
//! possible.

use super::{ListCall, list_call, set};
use crate::catalogue::CYCLES;
use crate::catalogue::newer::LISTS;
use crate::catalogue::newer::arguments::Argument;
use crate::check::newer::{DIRECTION, MINUS, is_newer_zero, is_nothing};
use crate::check::{Parsed, parse};
use crate::diagnostic::{Diagnostic, Edit, Severity, Span};
use crate::entry::{Inputs, names};
use crate::message::Message;
use crate::own;
use crate::program::calls::CallSite;
use crate::syntax::{Program, SyntaxError};

/// Mode of a call that says where the centre is.
const BESIDE: f64 = 10.0;
/// mm of an inch.
const INCH: f64 = 25.4;

/// What is wrong with a call in such a list, in place of what follows from it; none: what was found is kept.
pub fn of_call(program: &Program, site: &CallSite) -> Option<Vec<Diagnostic>> {
    site.newer_list()?;
    let call = list_call(program, program.word_at(site.span)?)?;
    if let Some(shifted) = shifted(program, &call) {
        return Some(vec![shifted]);
    }
    let mut found: Vec<Diagnostic> =
        site.diagnostics.iter().map(|one| with_cure(program, site, &call, one.clone())).collect();
    let inch = inch_path(program, site, &call);
    if inch.is_some() {
        // why the path is as long as it is says more than that it is
        found.retain(|one| one.code != own::NEWER_OPEN.code() || one.param != Some(names::FA));
    }
    found.extend(inch);
    found.extend(beyond(&call));
    Some(found)
}

/// Arguments behind the last one that is published: some control may have them.
fn beyond(call: &ListCall) -> Option<Diagnostic> {
    let most = call.list.args.len();
    let first = call.arguments.iter().skip(most).find(|argument| !argument.text.is_empty())?;
    let finding = own::NEWER_BEYOND.finding().text("cycle", call.list.name).number("most", most as f64);
    Some(finding.on(first.place))
}

/// A number in argument 2 that this variant does not correct: the variant that does, or no number.
fn with_cure(program: &Program, site: &CallSite, call: &ListCall, one: Diagnostic) -> Diagnostic {
    if one.code != own::NEWER_TARGET.code() || one.severity == Severity::Error {
        return one;
    }
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

/// An argument too few or too many, where that alone explains what stands at impossible places.
fn shifted(program: &Program, call: &ListCall) -> Option<Diagnostic> {
    let texts: Vec<&str> = call.arguments.iter().map(|argument| argument.text.as_str()).collect();
    let wrong = misplaced(call, &texts)?;
    let lost = |missing| {
        let all = (1..=wrong).map(|at| (at, with(&texts, at)));
        different(call, all.filter(|(_, texts)| fits(call, texts, missing)))
    };
    let many = || {
        let all = (1..=wrong).filter(|at| texts.get(*at).is_some_and(|text| text.is_empty()));
        different(call, all.map(|at| (at, without(&texts, at))).filter(|(_, texts)| fits(call, texts, 0)))
    };
    // what is lost may be something that programs always have
    let ways = [(own::NEWER_LOST, lost(0)), (own::NEWER_MANY, many()), (own::NEWER_LOST, lost(1))];
    let (sentence, places) = ways.into_iter().find(|(_, places)| !places.is_empty())?;
    let (at, _) = if sentence == own::NEWER_LOST { places.last()? } else { places.first()? };
    let finding = sentence.finding().number("place", *at as f64 + 1.0).on(call.span);
    let mut all = call.arguments.iter().map(|argument| argument.place).chain([call.span]);
    if places.len() > 1 || all.any(|place| program.is_of_macro(place)) {
        return Some(finding);
    }
    let argument = call.arguments.get(*at)?;
    let edit = match sentence == own::NEWER_LOST {
        true => Edit::insert(argument.place.start, ","),
        false => Edit::remove(argument.place.start, call.arguments.get(at + 1)?.place.start),
    };
    let label = if sentence == own::NEWER_LOST { "newer-set-lost" } else { "newer-set-many" };
    Some(finding.cured(Message::new(label).number("place", *at as f64 + 1.0), vec![edit]))
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

/// Those that differ in their arguments: a comma more beside an empty argument gives the same. Programs leave `S_KNUM1`
/// empty in the lists that are understood, so a way on which something comes there counts only where no other does.
fn different<'a>(call: &ListCall, all: impl Iterator<Item = (usize, Vec<&'a str>)>) -> Vec<(usize, Vec<&'a str>)> {
    let mut found: Vec<(usize, Vec<&str>)> = Vec::new();
    for (at, texts) in all {
        if found.iter().all(|(_, other)| *other != texts) {
            found.push((at, texts));
        }
    }
    let tool = call.index("S_KNUM1").filter(|_| call.list.is_written());
    let usual =
        |(_, texts): &(usize, Vec<&str>)| tool.and_then(|tool| texts.get(tool)).is_none_or(|text| is_nothing(text));
    if found.iter().any(usual) {
        found.retain(usual);
    }
    found
}

/// Arguments that tell of a shift by a number that cannot stand there; in the lists that are understood, those behind
/// the first too.
const TELLING: [&str; 7] = ["S_PRNUM", "S_MCBIT", "_DMODE", "S_MA", DIRECTION, "S_NMSP", "_DP"];

/// The first argument that tells of a shift: a text where none belongs, a number that no program has there. What else
/// is wrong may be a wrong value.
fn misplaced(call: &ListCall, texts: &[&str]) -> Option<usize> {
    let known = if call.list.is_written() { &TELLING[..] } else { &TELLING[..1] };
    let tells = |index: &usize| {
        let text = texts.get(*index).copied().unwrap_or_default();
        let telling = known.contains(&Argument::at(call.list, *index).name);
        (telling || text.starts_with('"')) && cannot_stand(call, *index, text)
    };
    (0..texts.len()).find(tells)
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
    texts.iter().enumerate().all(stands) && missing == lacking && !alone
}

/// Whether a text cannot be this argument: a number outside what it can be, a name where a number belongs or the
/// reverse, anything where programs leave it empty.
fn cannot_stand(call: &ListCall, index: usize, text: &str) -> bool {
    let argument = Argument::at(call.list, index);
    if text.starts_with('"') {
        return !matches!(argument.name, "S_TNAME" | "S_PATH" | "");
    }
    let Parsed::Number(number) = parse(text) else { return false };
    let whole = number.fract() == 0.0;
    if call.list.is_written() && unheard(call, argument.name, number) {
        return true;
    }
    match argument.name {
        "S_TNAME" => true,
        "S_PRNUM" => !(whole && (1.0..=12.0).contains(&number)),
        "S_FA" => number <= 0.0,
        "S_TSA" => number < 0.0,
        "S_NMSP" => !(whole && number >= 1.0),
        _ => false,
    }
}

/// Whether no program has such a number there, in the lists that are understood: the working plane is 1, the options
/// and the last argument are empty, the axes of CYCLE998 are two digits of an axis.
fn unheard(call: &ListCall, name: &str, number: f64) -> bool {
    let of_two_axes = call.index("S_SETV3").is_some();
    match name {
        "S_MCBIT" | "_DP" => true,
        "_DMODE" => number < 1.0 || number.fract() != 0.0,
        DIRECTION => ![1.0, MINUS].contains(&number),
        "S_MA" => of_two_axes && !(101.0..=302.0).contains(&number),
        _ => false,
    }
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
