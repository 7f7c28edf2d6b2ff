//! Calls in the list of a newer control. The checks hold the rules of the older one, whose manuals we have; here stands
//! which of them a newer control has as well. Of the others nothing is published: a value that only they refuse is
//! named in a note where it is not one that programs of newer controls have, and the call is neither simulated nor
//! written otherwise.
//! An argument that is omitted is 0 there.

use super::{Checked, Parsed, Target, check, error, parse, target, typed, variants};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::entry::{ArgumentList, Cycle, Inputs, ProbeUse, Typed, names};
use crate::message::Message;
use crate::name::Name;
use crate::own;
use crate::own::Own;

/// Highest number of a workpiece probe (61313).
const PROBES: f64 = 12.0;

/// Findings that follow from what the arguments mean and from the part, whichever control measures.
const SAME: [Own; 6] =
    [own::NOT_A_NUMBER, own::EXPRESSION, own::TOO_LARGE, own::TEXT_CHARACTERS, own::UNUSUAL, own::BALL];

/// Alarms whose condition is published for newer controls: `S_FA` above 0, the protection zone.
const SAME_ALARMS: [u32; 2] = [61308, 61334];

/// Doubts about two values that hold where both are written: what counts for an omitted one is another datum there.
const ORDERS: [(Own, &[Name]); 4] = [
    (own::TOLERANCE_ORDER, &[names::TUL, names::TLL]),
    (own::BAND_DIFFERENCE, &[names::TUL, names::TLL, names::TDIF]),
    (own::ZERO_MEAN, &[names::TZL, names::TMV]),
    (own::DIFFERENCE_SAFE, &[names::TDIF, names::TSA]),
];

/// What says what is measured: each published program gives it.
const NEEDED: [Name; 4] = [names::SETVAL, names::SETV0, names::SETV1, names::MA];

/// Checks the values of a list.
pub fn check_listed(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Checked {
    let typed = with_omitted(cycle, typed);
    let judged = judged(cycle, list, &typed, control);
    let older = judged.foreign.is_empty();
    Checked { diagnostics: judged.found, inputs: judged.inputs.filter(|_| older) }
}

/// The first parameter whose value means something else on the older control, or whose meaning is not known.
pub fn foreign(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Option<Name> {
    let typed = with_omitted(cycle, typed);
    judged(cycle, list, &typed, control).foreign.first().copied()
}

/// The same of the values that are to be written.
pub fn foreign_of(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Option<Name> {
    let foreign = judged(cycle, list, &with_omitted(cycle, typed), control).foreign;
    foreign.into_iter().find(|name| typed.contains_key(name.as_str()))
}

/// Whether nothing is known of the variant.
pub fn is_open(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> bool {
    let typed = with_omitted(cycle, typed);
    let variant = variants::chosen(cycle, &typed, control);
    !variant.is_some_and(|number| list.when.holds(&Inputs::new(cycle, number)))
}

/// Values with a 0 where an omitted argument is one that the older control asks for.
pub fn with_omitted(cycle: &Cycle, typed: &Typed) -> Typed {
    let mut typed = typed.clone();
    for name in cycle.variant_param().into_iter().chain([names::KNUM]) {
        let nothing = typed.get(name.as_str()).is_none_or(|text| text.trim().is_empty());
        if nothing && cycle.param(name.as_str()).is_some() {
            typed.insert(name.to_string(), "0".to_owned());
        }
    }
    typed
}

/// Whether these values hold a tool target, which has an argument of its own in a list.
pub fn has_tool_target(cycle: &'static Cycle, typed: &Typed, control: &Control) -> bool {
    let inputs = super::read(cycle, typed, control, &mut Vec::new());
    corrects(cycle, &inputs) == Some(Target::Tool) && !is_nothing(typed, names::KNUM)
}

/// Whether a zero offset has the same number on both controls.
pub fn is_same_zero(code: f64) -> bool {
    code.fract() == 0.0 && matches!(code as i64, 0..=99 | 9999)
}

/// Numbers of zero offsets in programs of newer controls: fine, coarse, and the active one in three ways.
fn is_newer_zero(code: f64) -> bool {
    let known = matches!(code as i64, 10_001..=10_099 | 9000 | 19_999);
    is_same_zero(code) || code.fract() == 0.0 && known
}

/// What is said about a list, and what of it the older control cannot say.
struct Judged {
    found: Vec<Diagnostic>,
    foreign: Vec<Name>,
    inputs: Option<Inputs>,
}

fn judged(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Judged {
    let Checked { diagnostics, inputs } = check(cycle, typed, control);
    let mut judged = Judged { found: Vec::new(), foreign: Vec::new(), inputs };
    if is_open(cycle, list, typed, control) {
        unknown(cycle, typed, control, diagnostics, &mut judged);
    } else {
        let mut rest = diagnostics;
        correction(cycle, typed, control, &mut rest, &mut judged);
        for one in rest {
            keep(one, typed, &mut judged);
        }
    }
    probe(cycle, typed, &mut judged);
    judged
}

/// A variant of which nothing is published: the path has to be right all the same.
fn unknown(cycle: &'static Cycle, typed: &Typed, control: &Control, said: Vec<Diagnostic>, judged: &mut Judged) {
    let Some(name) = cycle.variant_param() else { return };
    judged.foreign.push(name);
    let unread = |one: &Diagnostic| one.param == Some(name) && is_one_of(one, &SAME);
    let unread: Vec<Diagnostic> = said.into_iter().filter(unread).collect();
    if unread.is_empty() {
        judged.found.push(open(name, typed));
    }
    judged.found.extend(unread);
    let path = cycle.param(names::FA.as_str()).filter(|param| typed.contains_key(param.name.as_str()));
    let inputs = super::read(cycle, typed, control, &mut Vec::new());
    judged.found.extend(path.and_then(|param| typed::judge(param, &inputs, control)));
}

/// `_KNUM`: a tool target belongs to another argument, a zero offset has numbers of its own.
fn correction(
    cycle: &'static Cycle,
    typed: &Typed,
    control: &Control,
    rest: &mut Vec<Diagnostic>,
    judged: &mut Judged,
) {
    let inputs = super::read(cycle, typed, control, &mut Vec::new());
    let Some(target) = corrects(cycle, &inputs) else { return };
    let code = inputs.given(names::KNUM);
    if target == Target::Tool && !is_nothing(typed, names::KNUM) {
        rest.retain(|one| one.param.is_none_or(|name| !OF_TOOL.contains(&name)));
        let text = typed.get(names::KNUM.as_str()).map_or("", String::as_str);
        judged.found.push(own::NEWER_TARGET.finding().text("value", text).at(names::KNUM));
        judged.foreign.push(names::KNUM);
    } else if let Some(code) = code.filter(|code| !is_same_zero(*code)) {
        rest.retain(|one| one.param != Some(names::KNUM));
        judged.foreign.push(names::KNUM);
        if !is_newer_zero(code) {
            judged.found.push(open(names::KNUM, typed));
        }
    }
}

/// What is needed of a tool that is corrected.
const OF_TOOL: [Name; 5] = [names::KNUM, names::TNUM, names::TNAME, names::DLNUM, names::TENV];

/// A finding of the older control, as far as it counts.
fn keep(one: Diagnostic, typed: &Typed, judged: &mut Judged) {
    if one.param == Some(names::PRNUM) && one.severity == Severity::Error {
        return judged.foreign.push(names::PRNUM); // what is wrong with it, `probe` says
    }
    let written = |name: &Name| typed.get(name.as_str()).is_some_and(|text| !text.trim().is_empty());
    let missing = one.code == own::MISSING.code();
    let order = ORDERS.iter().find(|(sentence, _)| sentence.code() == one.code);
    let counts = match order {
        Some((_, values)) => values.iter().all(written),
        None if missing => one.param.is_some_and(|name| NEEDED.contains(&name)),
        None => is_one_of(&one, &SAME) || is_same_alarm(one.code),
    };
    if counts {
        return judged.found.push(one);
    }
    // which sign of the infeed leads down differs by the program
    let infeed = one.code == own::INFEED.code();
    let stops = infeed || one.severity == Severity::Error && order.is_none();
    let Some(name) = one.param.filter(|_| stops) else { return };
    if !judged.foreign.contains(&name) {
        judged.foreign.push(name);
        if written(&name) && !infeed {
            judged.found.push(open(name, typed));
        }
    }
}

/// The number of a workpiece probe.
fn probe(cycle: &Cycle, typed: &Typed, judged: &mut Judged) {
    let number = typed.get(names::PRNUM.as_str()).map(|text| parse(text));
    let Some(Parsed::Number(number)) = number else { return };
    let workpiece = cycle.purpose.probe == ProbeUse::Workpiece;
    if workpiece && !(1.0..=PROBES).contains(&number) {
        let message = Message::new("check-probe-number").number("number", number);
        let hint = Message::new("check-probe-number-hint").number("fields", PROBES);
        judged.found.push(error(Code::Alarm(61313), message).hint(hint).at(names::PRNUM));
        judged.foreign.push(names::PRNUM);
    }
}

/// A value whose meaning is not known.
fn open(name: Name, typed: &Typed) -> Diagnostic {
    let text = typed.get(name.as_str()).map_or("", String::as_str);
    own::NEWER_OPEN.finding().text("param", name).text("value", text).at(name)
}

/// Which sort of target `_KNUM` names; none where the cycle has no target.
fn corrects(cycle: &'static Cycle, inputs: &Inputs) -> Option<Target> {
    cycle.param(names::KNUM.as_str()).map(|param| target(param, inputs))
}

fn is_nothing(typed: &Typed, name: Name) -> bool {
    let text = typed.get(name.as_str()).map_or("", String::as_str);
    matches!(parse(text), Parsed::Empty | Parsed::Number(0.0))
}

fn is_one_of(one: &Diagnostic, sentences: &[Own]) -> bool {
    sentences.iter().any(|sentence| sentence.code() == one.code)
}

fn is_same_alarm(code: Code) -> bool {
    matches!(code, Code::Alarm(number) if SAME_ALARMS.contains(&number))
}
