//! Calls from one style to another, in place: the call's own assignments go, its new text comes where the call is.

use super::calls::{CallSite, calls_on};
use super::change::{Edit, apply, behind_label, line_end};
use super::compared::{ComparedValue, compared};
use super::own_words::{Lines, emptied, mark_before, own_words, without_comment};
use super::write::{Values, Written, snippet_of};
use super::{arguments, carried};
use crate::check::{Parsed, newer, parse};
use crate::control::{Control, gud};
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::{AUXILIARY_ARGS, ArgumentList, Cycle, Param, Style, Typed};
use crate::name::Name;
use crate::support::Mark;
use crate::syntax::{Program, WordKind};
use crate::{check, own};
use std::collections::BTreeSet;

/// Edits that turn calls into another style, and what has to be said about it.
#[derive(Default)]
pub struct Converted {
    /// Empty where it is not possible, or already so.
    pub edits: Vec<Edit>,
    /// What the new way cannot say, and calls behind it that rely on values which are no longer in the data.
    pub findings: Vec<Diagnostic>,
    /// The values that differ between the calls as they are and as they would be.
    pub values: Vec<ComparedValue>,
    /// How many calls are written anew.
    pub calls: usize,
}

/// A call in another style, before it is known what that does to others.
struct Plan {
    index: usize,
    edits: Vec<Edit>,
    written: Written,
}

/// Writes the call at `index` of the program's calls in this way; the program starts on a control in this state.
pub fn convert(program: &Program, index: usize, style: Style, control: &Control) -> Converted {
    let sites = calls_on(program, control.clone());
    let Some(site) = sites.get(index) else { return refused(Vec::new()) };
    if style_of(site) == style {
        return refused(vec![own::CONVERT_SAME.finding()]);
    }
    match planned(program, &sites, index, style, control) {
        Ok(plan) => with_stays(program, &sites, style, together(program, &sites, vec![plan], control)),
        Err(findings) => refused(findings),
    }
}

/// Writes all calls in this way whose cycle has it; those that cannot be written so stay, and the reason is told there.
pub fn convert_all(program: &Program, style: Style, control: &Control) -> Converted {
    let sites = calls_on(program, control.clone());
    let mut plans = Vec::new();
    let mut stay = Vec::new();
    for (index, site) in sites.iter().enumerate() {
        let has_it = style == Style::Direct || site.cycle.lists.iter().any(|list| list.style == style);
        if style_of(site) == style || !has_it {
            continue;
        }
        match planned(program, &sites, index, style, control) {
            Ok(plan) => plans.push(plan),
            Err(findings) => stay.extend(findings.into_iter().map(|one| one.on(site.span))),
        }
    }
    if plans.is_empty() && stay.is_empty() {
        return refused(vec![own::CONVERT_SAME.finding()]);
    }
    let mut done = with_stays(program, &sites, style, together(program, &sites, plans, control));
    done.findings.splice(0..0, stay);
    done
}

/// With what is told of user data that stay: the lists of newer controls do not read them.
fn with_stays(program: &Program, sites: &[CallSite], style: Style, mut done: Converted) -> Converted {
    if style == Style::Operate && done.calls > 0 {
        done.findings.extend(staying(program, sites, &done.edits));
    }
    done
}

/// User data of the control that the program still writes before its last call, by their names.
fn staying(program: &Program, sites: &[CallSite], edits: &[Edit]) -> Option<Diagnostic> {
    let last = sites.last()?.span.start;
    let gone = |place: Span| edits.iter().any(|edit| edit.span.start <= place.start && place.end <= edit.span.end);
    let of_calls: BTreeSet<u32> = sites.iter().flat_map(places).map(|place| place.start).collect();
    let of_call = |word: Span| of_calls.range(word.start..word.end).next().is_some();
    let declared: Vec<String> = program.words.iter().filter_map(|word| Some(program.name(word.declared()?))).collect();
    let mut names: Vec<String> = Vec::new();
    for word in program.words.iter().take_while(|word| word.span.start < last).filter(|word| !gone(word.span)) {
        let WordKind::Assign { name, .. } = &word.kind else { continue };
        let name = program.name(*name);
        if gud::find(&name).is_some() && !of_call(word.span) && !declared.contains(&name) && !names.contains(&name) {
            names.push(name);
        }
    }
    (!names.is_empty()).then_some(own::CONVERT_STAYS.finding().text("names", names.join(", ")))
}

/// Where the values of a call are written.
fn places(site: &CallSite) -> impl Iterator<Item = Span> {
    let alone = site.places.values().copied();
    alone.chain(site.origins.values().flatten().map(|one| one.place))
}

fn style_of(site: &CallSite) -> Style {
    site.list.map_or(Style::Direct, |list| list.style)
}

/// The edits of one call, or why there are none.
fn planned(
    program: &Program,
    sites: &[CallSite],
    index: usize,
    style: Style,
    control: &Control,
) -> Result<Plan, Vec<Diagnostic>> {
    let site = sites.get(index).ok_or_else(Vec::new)?;
    if program.is_of_macro(site.span) || site.places.values().any(|place| program.is_of_macro(*place)) {
        return Err(vec![own::CONVERT_MACRO.finding()]);
    }
    let at_call = site.control_at(control);
    if let Some(finding) = foreign(program, site, &at_call) {
        return Err(vec![finding]);
    }
    let values = Values { typed: &explicit(site, &at_call), expressions: &site.expressions };
    let written = snippet_of(site.cycle, &values, &at_call, style, None);
    if written.text.is_empty() {
        return Err(written.findings);
    }
    let lost = carried::stuck(program, site).or_else(|| carried::moves(program, site, &written.said));
    match lost.or_else(|| carried::skipped(site)) {
        Some(finding) => Err(vec![finding]),
        None => Ok(Plan { index, edits: rewritten(program, site, &written), written }),
    }
}

/// All plans at once. One that would give an expression another worth is left out, and the reason is told at its call.
fn together(program: &Program, sites: &[CallSite], mut plans: Vec<Plan>, control: &Control) -> Converted {
    let alone = plans.len() == 1;
    let mut stay = Vec::new();
    loop {
        let mut edits: Vec<Edit> = plans.iter().flat_map(|plan| plan.edits.iter().cloned()).collect();
        edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
        let after = calls_on(&program.again(&apply(&program.source, &edits)), control.clone());
        let before = plans.len();
        plans.retain(|plan| {
            let pair = sites.get(plan.index).zip(after.get(plan.index));
            let differs =
                pair.and_then(|(site, after)| Some((site, carried::differs(site, after, &plan.written.said)?)));
            let finding = differs.map(|(site, name)| (site.span, carried::changing(site, name)));
            let fits = finding.is_none();
            stay.extend(finding.map(|(span, one)| if alone { one } else { one.on(span) }));
            fits
        });
        if plans.len() == before || plans.is_empty() {
            return told(program, sites, &after, Told { plans, edits, stay }, control);
        }
    }
}

/// What is left of plans, and why others are not done.
struct Told {
    plans: Vec<Plan>,
    edits: Vec<Edit>,
    stay: Vec<Diagnostic>,
}

fn told(program: &Program, sites: &[CallSite], after: &[CallSite], done: Told, control: &Control) -> Converted {
    let Told { plans, edits, stay } = done;
    if plans.is_empty() {
        return refused(stay);
    }
    let mut converted = Converted { edits, findings: stay, calls: plans.len(), ..Converted::default() };
    let mut indices = Vec::with_capacity(plans.len());
    for Plan { index, written, .. } in plans {
        indices.push(index);
        converted.findings.extend(sites.get(index).and_then(|site| unused(site, &written)));
        converted.findings.extend(written.findings);
        if let Some((site, after)) = sites.get(index).zip(after.get(index)) {
            converted.findings.extend(left_out(program, site));
            converted.values.extend(compared(program, site, after));
        }
    }
    converted.findings.extend(others(sites, after, &indices, control));
    converted
}

/// Why no other call style says the same.
fn foreign(program: &Program, site: &CallSite, control: &Control) -> Option<Diagnostic> {
    let list = site.list?;
    let value = |name: &str| site.values.get(name).map_or("", String::as_str);
    let variant = site.cycle.variant_param()?;
    if !list.has_variant(site.cycle) && parse(value(variant.as_str())) == Parsed::Expression {
        let number = value(variant.as_str());
        return Some(own::CONVERT_VARIANT_OPEN.finding().text("value", number).hint_text("value", number));
    }
    let list = site.newer_list()?;
    let said = |name: &str, value: &str| own::CONVERT_NEWER.finding().text("param", name).text("value", value);
    let target = arguments::only_newer(program, list, site.span);
    if let Some((name, text)) = target.iter().find(|(name, _)| *name == TOOL_TARGET) {
        return Some(said(name, text));
    }
    only_listed(site.cycle, list, &site.values, control)
}

/// Why these values of a newer control's list are said by no other call style: what one of them means there.
pub fn only_listed(
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    values: &Typed,
    control: &Control,
) -> Option<Diagnostic> {
    let name = *newer::foreign(cycle, list, values, control).first()?;
    let written = values.get(name.as_str()).map(String::as_str).filter(|text| !text.is_empty());
    // an omitted argument is 0 there
    let said = own::CONVERT_NEWER.finding().text("param", name).text("value", written.unwrap_or("0"));
    Some(said.at(name))
}

/// The argument of newer controls for the tool that is corrected.
const TOOL_TARGET: &str = "S_KNUM1";

/// The values of a call, with those of a newer list's omitted arguments, which elsewhere an earlier call left.
fn explicit(site: &CallSite, control: &Control) -> Typed {
    if site.newer_list().is_none() {
        return site.values.clone();
    }
    let mut values = newer::with_omitted(site.cycle, &site.values);
    let inputs = check::read(site.cycle, &values, control, &mut Vec::new());
    for param in site.cycle.params {
        let counts = param.need(&inputs).is_some() && !values.contains_key(param.name.as_str());
        if let Some(number) = param.fallback(control).filter(|_| counts) {
            values.insert(param.name.to_string(), number.to_string());
        }
    }
    values
}

/// What only the list of the newer control says.
fn left_out(program: &Program, site: &CallSite) -> Option<Diagnostic> {
    let lost = arguments::only_newer(program, site.newer_list()?, site.span);
    let names: Vec<String> = lost.iter().map(|(name, text)| format!("{name} = {text}")).collect();
    (!names.is_empty()).then_some(own::CONVERT_LOST.finding().text("names", names.join(", ")))
}

/// The assignments that go with the call and say nothing to it: no way of writing has them.
fn unused(site: &CallSite, written: &Written) -> Option<Diagnostic> {
    let told = |name: &Name| written.findings.iter().any(|one| one.message.word("name") == Some(name.as_str()));
    let goes = |name: &&Name| {
        let place = site.own_place(name.as_str());
        let outside = place.is_some_and(|place| place.end <= site.span.start || place.start >= site.span.end);
        let value = site.values.get(name.as_str()).map_or("", String::as_str);
        let nothing = matches!(parse(value), Parsed::Empty | Parsed::Number(0.0));
        outside && !nothing && site.expression(name.as_str()).is_none() && !written.said.contains(name) && !told(name)
    };
    let names: Vec<String> =
        site.places.keys().filter(goes).map(|name| format!("{name}={}", site.values[name.as_str()])).collect();
    let finding = own::CONVERT_UNUSED.finding().text("cycle", site.cycle.name).text("names", names.join(", "));
    (!names.is_empty()).then_some(finding)
}

/// Nothing is done, and why.
fn refused(findings: Vec<Diagnostic>) -> Converted {
    Converted { findings, ..Converted::default() }
}

fn rewritten(program: &Program, site: &CallSite, written: &Written) -> Vec<Edit> {
    let text = &written.text;
    let marks = text.lines().next().and_then(Mark::read).is_some();
    // an expression that the new text does not need stays where it is, but for one in a `CYCLE_PARA`, which goes whole
    let goes = |name: &str| {
        let said = written.said.iter().any(|one| *one == name);
        let whole = || site.own_place(name).is_some_and(|place| arguments::is_auxiliary(program, place));
        said || site.expression(name).is_none() || whole()
    };
    let own = own_words(program, site, marks, goes);
    let mut lines: Vec<String> = kept(program, site, &own, &written.said);
    lines.extend(text.lines().map(str::to_owned));
    let call = lines.pop().unwrap_or_default();
    let mut edits: Vec<Edit> = emptied(program, &own, site.line);
    if let (true, Some((_, place))) = (marks, mark_before(program, site)) {
        edits.push(without_comment(program, place));
    }
    edits.push(Edit::replace(site.span, call));
    if let (Some(block), false) = (program.blocks.get(site.line as usize), lines.is_empty()) {
        let end = line_end(program, site.line);
        let at = behind_label(program, site.line).unwrap_or(block.span.start);
        edits.push(Edit::insert(at, lines.iter().map(|line| format!("{line}{end}")).collect::<String>()));
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits
}

/// What goes with the words of the call, but counts for others or is an expression: it stays as assignments.
fn kept(program: &Program, site: &CallSite, own: &Lines, said: &[Name]) -> Vec<String> {
    let mut lines = Vec::new();
    for word in own.values().flatten().filter(|word| word.called().is_some()) {
        for (name, place) in AUXILIARY_ARGS.iter().zip(arguments::places(program, word.span)) {
            let text = program.written(place);
            if !text.is_empty() && text.parse() != Ok(0.0) && site.cycle.param(name).is_none() {
                lines.push(format!("{name}={text}"));
            }
        }
    }
    let spare = site.places.iter().filter(|(name, place)| {
        let gone = program
            .word_at(**place)
            .is_some_and(|word| word.span == site.span || own.values().flatten().any(|other| other.span == word.span));
        gone && !said.contains(name)
    });
    lines.extend(spare.filter_map(|(name, _)| {
        let text = site.expression(name).filter(|text| text != name)?;
        Some(format!("{name}={text}"))
    }));
    lines
}

/// Whether two calls have the same values; a datum that was never written holds its delivered value, or 0.
fn means_the_same(one: &CallSite, other: &CallSite, control: &Control) -> bool {
    let inputs = |site: &CallSite| check::read(site.cycle, &site.values, control, &mut Vec::new());
    let (left, right) = (inputs(one), inputs(other));
    let same = |param: &Param| {
        left.value(param.name) == right.value(param.name) && left.text(param.name) == right.text(param.name)
    };
    one.cycle.params.iter().all(same)
}

/// Calls that would have other values afterwards.
fn others(sites: &[CallSite], after: &[CallSite], converted: &[usize], control: &Control) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    for (place, (before, after)) in sites.iter().zip(after).enumerate() {
        if converted.binary_search(&place).is_err() && !means_the_same(before, after, control) {
            let finding = own::CONVERT_OTHERS.finding().text("cycle", before.cycle.name);
            findings.push(finding.number("line", f64::from(before.line + 1)).on(before.span));
        }
    }
    findings
}
