//! A value changed in a form: edits of the program, and what else they concern.

use super::calls::{CallSite, calls_on};
use super::change::{Edit, apply, change};
use super::compared::{ComparedValue, compared};
use super::jumped::Jumped;
use super::own_words::{emptied, own_words};
use super::touched::{TouchedLine, elsewhere};
use super::variables::{Variable, variables};
use super::{arguments, around};
use crate::check::variants;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{Cycle, Param, Typed};
use crate::name::Name;
use crate::syntax::{Program, WordKind};
use crate::{check, own};
use std::collections::BTreeSet;

/// The values of a call, typed as the second ones, that do not fit the variant that these choose; the first ones chose
/// another. The control is that of the call.
pub type Unfit<'a> = &'a mut dyn FnMut(&'static Cycle, [&Typed; 2], &Control) -> Vec<Name>;

/// What a new value of a call does to the program.
#[derive(Debug, Default)]
pub struct Revision {
    /// Lists of edits, each for the text after the ones before it.
    pub steps: Vec<Vec<Edit>>,
    /// The lines outside of the call's own that they change.
    pub elsewhere: Vec<TouchedLine>,
    /// Parameters that another variant does not know: their values are taken out of the call.
    pub taken: Vec<Name>,
    /// The expression that the value takes the place of; none: there is none, or an expression that is worth something.
    pub replaced: Option<Replaced>,
    /// What the calls of the program say otherwise then.
    pub values: Vec<ComparedValue>,
    /// Whether that is more than the value of this call: it takes others out of it, or calls behind it read the same.
    pub reaches: bool,
    /// What that means: which of them went, and which stay since other calls read them.
    pub findings: Vec<Diagnostic>,
}

/// An expression of a call that another value would take the place of.
#[derive(Clone, Debug, PartialEq)]
pub struct Replaced {
    /// As the call has it.
    pub text: String,
    /// What it is worth there, where that is known.
    pub worth: Option<String>,
    /// Its variables, each with what would make the value the new one.
    pub variables: Vec<Variable>,
}

/// Gives a parameter of the call at `index` this value, as [`change`] does; of a call that becomes another variant
/// nothing stays that this does not know, nor what `unfit` names. The program starts on this control. None: there is no
/// such call.
pub fn revise(
    program: &Program,
    index: usize,
    (name, value): (&str, &str),
    control: &Control,
    unfit: Unfit,
) -> Option<Revision> {
    let sites = calls_on(program, control.clone());
    let site = sites.get(index)?;
    let edits = change(program, site, name, value);
    if edits.is_empty() {
        return Some(Revision::default());
    }
    let mut revision = Revision { elsewhere: elsewhere(program, site, &edits), ..Revision::default() };
    let idle = idle(site, (name, value), control, unfit);
    let mut text = apply(&program.source, &edits);
    let mut after = calls_on(&program.again(&text), control.clone());
    revision.steps.push(edits);
    let stays = |site: &CallSite| site.expressions.contains_key(name);
    if !after.get(index).is_some_and(stays) {
        revision.replaced = replaced(program, (&sites, index), (name, value), control);
    }
    if !idle.is_empty() {
        revision.take(&program.again(&text), (&after, index), idle, control);
        for step in revision.steps.iter().skip(1) {
            text = apply(&text, step);
        }
        after = calls_on(&program.again(&text), control.clone());
    }
    let again = program.again(&text);
    if let Some(now) = after.get(index) {
        let before = around::inputs_at(site, control);
        let carried = around::carried(&again, now, &before, &around::inputs_at(now, control));
        revision.carry(carried);
    }
    revision.values = differing(program, &sites, &after);
    let others = sites.iter().zip(&after).enumerate().any(|(at, (one, other))| {
        let changes = |site: &ComparedValue| at != index || site.param != name;
        compared(program, one, other).iter().any(changes)
    });
    revision.reaches = others || !revision.elsewhere.is_empty();
    Some(revision)
}

/// What calls say otherwise than the same calls of another text.
fn differing(program: &Program, before: &[CallSite], after: &[CallSite]) -> Vec<ComparedValue> {
    before.iter().zip(after).flat_map(|(one, other)| compared(program, one, other)).collect()
}

impl Revision {
    /// The blocks around the call go along with it.
    fn carry(&mut self, carried: around::Carried) {
        let told = |sentence: own::Own, lines: &BTreeSet<u32>| {
            let lines: Vec<String> = lines.iter().map(ToString::to_string).collect();
            (!lines.is_empty()).then(|| sentence.finding().texts("lines", &lines))
        };
        self.findings.extend(told(own::REVISE_AROUND, &carried.lines));
        self.findings.extend(told(own::REVISE_AROUND_LEFT, &carried.left));
        self.steps.extend((!carried.edits.is_empty()).then_some(carried.edits));
    }

    /// Takes these values out of a call, of the program as it is by then, but for what others read.
    fn take(&mut self, program: &Program, (sites, index): (&[CallSite], usize), idle: Vec<Name>, control: &Control) {
        let Some(site) = sites.get(index) else { return };
        let mut taken: Vec<_> = idle.into_iter().filter(|name| site.own_place(name).is_some()).collect();
        let read_by_others = others_read(program, (sites, index), &taken, control);
        taken.retain(|name| !read_by_others.contains(name));
        self.steps.extend(without(program, site, &taken));
        let written: Vec<_> = taken.iter().map(|name| written(site, name)).collect();
        let went = (!taken.is_empty()).then(|| own::REVISE_TAKEN.finding().texts("names", &written));
        let shared = (!read_by_others.is_empty()).then(|| own::REVISE_SHARED.finding().texts("names", &read_by_others));
        self.findings = went.into_iter().chain(shared).collect();
        self.taken = taken;
    }
}

/// A value as it is told: by its name, and an expression too, which nobody knows by heart.
fn written(site: &CallSite, name: &str) -> String {
    site.expression(name).map_or_else(|| name.to_owned(), |text| format!("{name}={text}"))
}

/// Those of the values of a call that other calls would miss without them.
fn others_read(
    program: &Program,
    (sites, index): (&[CallSite], usize),
    names: &[Name],
    control: &Control,
) -> Vec<Name> {
    let Some(edits) = sites.get(index).and_then(|site| without(program, site, names)).filter(|_| sites.len() > 1)
    else {
        return Vec::new();
    };
    let after = calls_on(&program.again(&apply(&program.source, &edits)), control.clone());
    let others = sites.iter().zip(&after).enumerate().filter(|(at, _)| *at != index);
    let missed: Vec<_> = others.flat_map(|(_, (one, other))| compared(program, one, other)).collect();
    names.iter().copied().filter(|name| missed.iter().any(|one| one.param == name.as_str())).collect()
}

/// The expression that a value takes the place of.
fn replaced(
    program: &Program,
    (sites, index): (&[CallSite], usize),
    (name, value): (&str, &str),
    control: &Control,
) -> Option<Replaced> {
    let site = sites.get(index)?;
    let text = site.expression(name).filter(|text| *text != name && *text != value.trim())?.to_owned();
    let worth = site.expressions.get(name).and_then(|_| site.values.get(name)).cloned();
    let mut variables = variables(program, site, name, value);
    for change in variables.iter_mut().filter_map(|variable| variable.change.as_mut().ok()) {
        let text = apply(&program.source, std::slice::from_ref(&change.edit));
        change.values = differing(program, sites, &calls_on(&program.again(&text), control.clone()));
    }
    Some(Replaced { text, worth, variables })
}

/// The parameters that the variant which this value chooses does not know: none of the cycle's own that it asks for on
/// no machine, and none that the call uses now and would not use then; and those whose values do not fit it. A list of
/// a newer control has its arguments in every variant: they stay.
fn idle(site: &CallSite, (name, value): (&str, &str), control: &Control, unfit: Unfit) -> Vec<Name> {
    let cycle = site.cycle;
    if cycle.variant_param().is_none_or(|own| own != name) {
        return Vec::new();
    }
    let control = site.control_at(control);
    let mut values: Typed = site.values.clone();
    values.insert(name.to_owned(), value.to_owned());
    let chosen = |values| variants::chosen(cycle, values, &control);
    let known = |number: &i64| cycle.variants.iter().any(|one| one.number == *number);
    let (before, now) = (chosen(&site.values), chosen(&values));
    if before.is_none() || now.filter(known).is_none() || before == now {
        return Vec::new();
    }
    let inputs = |values| check::read(cycle, values, &control, &mut Vec::new());
    let (before, now) = (inputs(&site.values), inputs(&values));
    let unfit = unfit(cycle, [&site.values, &values], &control);
    let idle = |param: &&Param| {
        let unknown = !param.is_machine_datum() && !param.is_known(&now);
        unknown || param.need(&before).is_some() && param.need(&now).is_none() || unfit.contains(&param.name)
    };
    let listed = |name: Name| site.newer_list().is_some_and(|list| list.position(name).is_some());
    cycle.params.iter().filter(idle).map(|param| param.name).filter(|name| !listed(*name)).collect()
}

/// Edits that take these values out of the words and arguments that are the call's own.
fn without(program: &Program, site: &CallSite, names: &[Name]) -> Option<Vec<Edit>> {
    let is_word = |name: &str| {
        let place = site.own_place(name).filter(|place| *place != site.span);
        let word = place.and_then(|place| program.word_at(place));
        word.is_some_and(|word| matches!(word.kind, WordKind::Assign { .. }))
    };
    let words = own_words(program, site, false, |name| names.iter().any(|one| *one == name) && is_word(name));
    let jumped = Jumped::of(program);
    let mut edits = emptied(program, &words, |line, block| line == site.line || jumped.has(program, block));
    for name in names.iter().filter(|name| !is_word(name)) {
        let place = site.own_place(name);
        let argument = place.filter(|place| arguments::is_argument(program, *place));
        edits.extend(argument.map(|place| Edit::replace(place, "")));
    }
    edits.retain(|edit| edit.span.start < edit.span.end && edit.span != site.span);
    edits.sort_by_key(|edit| edit.span.start);
    (!edits.is_empty()).then_some(edits)
}
