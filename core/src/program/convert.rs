//! Calls from one style to another, in place: the call's own assignments go, its new text comes where the call is.

use super::calls::{CallSite, calls_on};
use super::change::{Edit, apply, behind_label, line_end};
use super::compared::{ComparedValue, compared};
use super::flow::is_main;
use super::jumped::Jumped;
use super::own_words::{Lines, emptied, mark_before, own_words, without_comment};
use super::readers::{Outside, Readers};
use super::write::{Values, Written, snippet_of, value};
use super::{arguments, carried};
use crate::catalogue::newer::arguments::Argument;
use crate::check::{Parsed, newer, parse};
use crate::control::{Control, gud};
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::{AUXILIARY_ARGS, ArgumentList, Cycle, Param, Style, Typed, names};
use crate::name::Name;
use crate::support::Mark;
use crate::syntax::programs::{Programs, programs};
use crate::syntax::{Program, WordKind};
use crate::{check, own};
use std::collections::{BTreeMap, BTreeSet};

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
    /// The values whose assignments stay, each with the first line of another statement that reads it.
    stays: BTreeMap<Name, u32>,
}

/// What calls are converted with.
struct Job<'a> {
    program: &'a Program,
    sites: &'a [CallSite],
    readers: Readers,
    outside: Outside,
    jumped: Jumped,
    programs: Programs,
    style: Style,
    control: &'a Control,
    /// Whether all calls are converted: what is said of one is told where it stands.
    all: bool,
}

/// Writes the call at `index` of the program's calls in this way; the program starts on a control in this state.
pub fn convert(program: &Program, index: usize, style: Style, control: &Control) -> Converted {
    let sites = calls_on(program, control.clone());
    let Some(site) = sites.get(index) else { return refused(Vec::new()) };
    if style_of(site) == style {
        return refused(vec![own::CONVERT_SAME.finding()]);
    }
    let job = Job::new(program, &sites, style, control, false);
    match job.planned(index) {
        Ok(plan) => with_stays(program, &sites, style, job.together(vec![plan])),
        Err(findings) => refused(findings),
    }
}

/// Writes all calls in this way whose cycle has it; those that cannot be written so stay, and the reason is told there.
pub fn convert_all(program: &Program, style: Style, control: &Control) -> Converted {
    let sites = calls_on(program, control.clone());
    let job = Job::new(program, &sites, style, control, true);
    let mut plans = Vec::new();
    let mut stay = Vec::new();
    for (index, site) in sites.iter().enumerate() {
        let has_it = style == Style::Direct || site.cycle.lists.iter().any(|list| list.style == style);
        if style_of(site) == style || !has_it {
            continue;
        }
        match job.planned(index) {
            Ok(plan) => plans.push(plan),
            Err(findings) => stay.extend(findings.into_iter().map(|one| one.on(site.span))),
        }
    }
    if plans.is_empty() && stay.is_empty() {
        return refused(vec![own::CONVERT_SAME.finding()]);
    }
    let mut done = with_stays(program, &sites, style, job.together(plans));
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
    // the edits are in the order of the text, and none meets another
    let gone = |place: Span| {
        let before = edits.partition_point(|edit| edit.span.start <= place.start);
        before.checked_sub(1).and_then(|at| edits.get(at)).is_some_and(|edit| place.end <= edit.span.end)
    };
    let of_calls: BTreeSet<u32> = sites.iter().flat_map(places).map(|place| place.start).collect();
    let of_call = |word: Span| of_calls.range(word.start..word.end).next().is_some();
    let declared: BTreeSet<String> =
        program.words.iter().filter_map(|word| Some(program.name(word.declared()?))).collect();
    let mut names: Vec<String> = Vec::new();
    for word in program.words.iter().take_while(|word| word.span.start < last).filter(|word| !gone(word.span)) {
        let WordKind::Assign { name, .. } = &word.kind else { continue };
        let name = program.name(*name);
        if gud::find(&name).is_some() && !of_call(word.span) && !declared.contains(&name) && !names.contains(&name) {
            names.push(name);
        }
    }
    (!names.is_empty()).then_some(own::CONVERT_STAYS.finding().texts("names", &names))
}

/// Where the values of a call are written.
fn places(site: &CallSite) -> impl Iterator<Item = Span> {
    let alone = site.places.values().copied();
    alone.chain(site.origins.values().flatten().map(|one| one.place))
}

fn style_of(site: &CallSite) -> Style {
    site.list.map_or(Style::Direct, |list| list.style)
}

impl<'a> Job<'a> {
    fn new(program: &'a Program, sites: &'a [CallSite], style: Style, control: &'a Control, all: bool) -> Job<'a> {
        let (readers, outside) = (Readers::of(program), Outside::of(program));
        let (jumped, programs) = (Jumped::of(program), programs(program));
        Job { program, sites, readers, outside, jumped, programs, style, control, all }
    }

    /// The edits of one call, or why there are none.
    fn planned(&self, index: usize) -> Result<Plan, Vec<Diagnostic>> {
        let Job { program, style, control, .. } = *self;
        let site = self.sites.get(index).ok_or_else(Vec::new)?;
        if program.is_of_macro(site.span) || site.places.values().any(|place| program.is_of_macro(*place)) {
            return Err(vec![own::CONVERT_MACRO.finding()]);
        }
        let at_call = site.control_at(control);
        if let Some(finding) = foreign(program, site, &at_call).or_else(|| unsaid(site)) {
            return Err(vec![finding]);
        }
        let values = Values { typed: &explicit(site, &at_call), expressions: &site.expressions };
        let written = snippet_of(site.cycle, &values, &at_call, style, None);
        if written.text.is_empty() {
            return Err(written.findings);
        }
        let said = &written.said;
        let lost = carried::stuck(program, site).or_else(|| carried::moves(program, site, said));
        let lost = lost
            .or_else(|| carried::called(program, &self.outside, site, said))
            .or_else(|| carried::skipped(program, site, said));
        if let Some(finding) = lost.or_else(|| self.overwrites(site, &values, said)) {
            return Err(vec![finding]);
        }
        let stays = self.stays(site);
        let edits = self.rewritten(site, &written, &stays);
        Ok(Plan { index, edits, written, stays })
    }

    /// The values of a call that other statements read: their assignments stay.
    fn stays(&self, site: &CallSite) -> BTreeMap<Name, u32> {
        let names = site.places.keys().filter(|name| site.own_place(name.as_str()).is_some());
        let read = names.filter_map(|name| Some((*name, self.readers.line(self.program, site, name.as_str())?)));
        if site.newer_list().is_some() { BTreeMap::new() } else { read.collect() }
    }

    /// A value of a list that another statement reads as a variable: the call would assign it.
    fn overwrites(&self, site: &CallSite, values: &Values, said: &[Name]) -> Option<Diagnostic> {
        site.newer_list()?;
        let anew = |name: &Name| values.typed.get(name.as_str()).is_some_and(|text| *text != name.as_str());
        let mut names = said.iter().filter(|name| anew(name));
        let read = |name: &Name| Some((*name, self.readers.line(self.program, site, name.as_str())?));
        let (name, line) = names.find_map(read)?;
        let finding = own::CONVERT_OVERWRITES.finding().text("name", name).number("line", f64::from(line));
        Some(finding.hint_text("name", name))
    }

    /// All plans at once. One that would give an expression another worth is left out, and the reason is told at its
    /// call.
    fn together(&self, mut plans: Vec<Plan>) -> Converted {
        let Job { program, sites, control, .. } = *self;
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
                stay.extend(finding.map(|(span, one)| if self.all { one.on(span) } else { one }));
                fits
            });
            if plans.len() == before || plans.is_empty() {
                return self.told(&after, Told { plans, edits, stay });
            }
        }
    }

    /// What has to be said about it.
    fn told(&self, after: &[CallSite], done: Told) -> Converted {
        let Job { program, sites, style, .. } = *self;
        let Told { plans, edits, stay } = done;
        if plans.is_empty() {
            return refused(stay);
        }
        let mut converted = Converted { edits, findings: stay, calls: plans.len(), ..Converted::default() };
        let mut indices = Vec::with_capacity(plans.len());
        for Plan { index, written, stays, .. } in plans {
            indices.push(index);
            let Some(site) = sites.get(index) else { continue };
            let mut said: Vec<Diagnostic> = unused(site, &written, &stays).into_iter().collect();
            said.extend(read_still(site, &written, &stays, style));
            said.extend(written.findings);
            said.extend(left_out(program, site));
            said.extend(doubtful(site, self.control));
            if let Some(after) = after.get(index) {
                let differing = compared(program, site, after);
                said.extend(added(program, &self.programs, site, &differing));
                converted.values.extend(differing);
            }
            let placed = |one: Diagnostic| if self.all { one.on(site.span) } else { one };
            converted.findings.extend(said.into_iter().map(placed));
        }
        converted.findings.extend(others(sites, after, &indices, self.control));
        converted
    }
}

/// What is left of plans, and why others are not done.
struct Told {
    plans: Vec<Plan>,
    edits: Vec<Edit>,
    stay: Vec<Diagnostic>,
}

/// Variables that the program still reads: their assignments stay, or the call itself reads them.
fn read_still(site: &CallSite, written: &Written, stays: &BTreeMap<Name, u32>, style: Style) -> Vec<Diagnostic> {
    let newer = style == Style::Operate;
    let names: Vec<String> = stays.iter().map(|(name, line)| format!("{name} ({line})")).collect();
    let left = if newer { own::CONVERT_READ } else { own::CONVERT_READ.as_note() };
    let left = (!names.is_empty()).then(|| left.finding().texts("names", &names));
    let itself = |name: &&Name| site.values.get(name.as_str()).is_some_and(|text| *text == name.as_str());
    let names: Vec<&str> = written.said.iter().filter(itself).map(|name| name.as_str()).collect();
    let variable = own::CONVERT_VARIABLE.finding().texts("names", &names);
    left.into_iter().chain((newer && !names.is_empty()).then_some(variable)).collect()
}

/// Why a call of which no value says what is measured stays: a list would say it for every program that calls this one.
fn unsaid(site: &CallSite) -> Option<Diagnostic> {
    let variant = site.cycle.variant_param().filter(|_| site.list.is_none())?;
    let said = site.values.get(variant.as_str()).is_some_and(|text| !text.trim().is_empty());
    (!said).then(|| own::CONVERT_NO_VARIANT.finding().text("name", variant).hint_text("name", variant).at(variant))
}

/// The values that a list has and that no assignment gave: on the control an earlier program's counted. In a program
/// that others call they are theirs.
fn added(program: &Program, programs: &Programs, site: &CallSite, differing: &[ComparedValue]) -> Option<Diagnostic> {
    let new = differing.iter().filter(|one| one.before.is_none() && site.list.is_none());
    let shown = |one: &ComparedValue| {
        let text = one.after.as_deref().filter(|text| !newer::is_nothing(text) && *text != "\"\"")?;
        Some(format!("{} = {text}", one.param))
    };
    let names: Vec<String> = new.filter_map(shown).collect();
    let unit = programs.of_line(site.line).and_then(|unit| programs.units.get(unit));
    let called = unit.is_some_and(|unit| !is_main(program, unit));
    let sentence = if called { own::CONVERT_ADDED } else { own::CONVERT_ADDED.as_note() };
    (!names.is_empty()).then_some(sentence.finding().texts("names", &names))
}

/// What an argument of a newer control's list means is not sure, though the older call has a place for it.
fn doubtful(site: &CallSite, control: &Control) -> Vec<Diagnostic> {
    let Some(list) = site.newer_list() else { return Vec::new() };
    let inputs = check::read(site.cycle, &site.values, control, &mut Vec::new());
    let used = |name: Name| site.values.get(name.as_str()).filter(|_| inputs.uses(name));
    let value = |name: Name| used(name).filter(|text| !newer::is_nothing(text));
    let of = |name: Name, sentence: own::Own| {
        Some(sentence.finding().text("value", value(name)?.as_str()).at(name)).filter(|_| list.position(name).is_some())
    };
    let infeed = newer::is_infeed(list).then(|| of(names::ID, own::CONVERT_INFEED)).flatten();
    infeed.into_iter().chain(of(names::RA, own::CONVERT_ROTARY)).collect()
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
    let lost = lost.iter().map(|(name, text)| format!("{name} = {text}"));
    let beyond = arguments::beyond(program, site.newer_list()?, site.span);
    let names: Vec<String> = lost.chain(beyond.map(|(place, text)| format!("{place} = {text}"))).collect();
    (!names.is_empty()).then_some(own::CONVERT_LOST.finding().texts("names", &names))
}

/// The values that go with the call and say nothing to it: no other way of writing has them.
fn unused(site: &CallSite, written: &Written, stays: &BTreeMap<Name, u32>) -> Option<Diagnostic> {
    let told = |name: &Name| written.findings.iter().any(|one| one.message.word("name") == Some(name.as_str()));
    let goes = |name: &Name| {
        let value = site.values.get(name.as_str()).map_or("", String::as_str);
        let nothing = matches!(parse(value), Parsed::Empty | Parsed::Number(0.0));
        let own = site.own_place(name.as_str()).is_some() && site.expression(name.as_str()).is_none();
        own && !nothing && !written.said.contains(name) && !stays.contains_key(name) && !told(name)
    };
    let called = |name: &Name| {
        let mut arguments = site.newer_list().into_iter().flat_map(Argument::all);
        arguments.find(|one| one.param == Some(*name)).map_or(name.as_str(), |one| one.name)
    };
    let names = site.places.keys().filter(|name| site.cycle.param(name.as_str()).is_some());
    let names = names.filter(|name| goes(name));
    let names: Vec<String> = names.map(|name| format!("{}={}", called(name), site.values[name.as_str()])).collect();
    let finding = own::CONVERT_UNUSED.finding().text("cycle", site.cycle.name).texts("names", &names);
    (!names.is_empty()).then_some(finding)
}

/// Nothing is done, and why.
fn refused(findings: Vec<Diagnostic>) -> Converted {
    Converted { findings, ..Converted::default() }
}

impl Job<'_> {
    fn rewritten(&self, site: &CallSite, written: &Written, stays: &BTreeMap<Name, u32>) -> Vec<Edit> {
        let (program, text) = (self.program, &written.text);
        let marks = text.lines().next().and_then(Mark::read).is_some();
        // what others read stays where it is, as does an expression that the new text does not need, but for what is in
        // a `CYCLE_PARA`, which goes whole
        let goes = |name: &str| {
            let said = written.said.iter().any(|one| *one == name);
            let read = stays.keys().any(|one| *one == name);
            let whole = || site.own_place(name).is_some_and(|place| arguments::is_auxiliary(program, place));
            !read && (said || site.expression(name).is_none()) || whole()
        };
        let own = own_words(program, site, marks, goes);
        let mut lines: Vec<String> = self.kept(site, &own, &written.said, stays);
        lines.extend(text.lines().map(str::to_owned));
        let call = lines.pop().unwrap_or_default();
        let mut edits: Vec<Edit> =
            emptied(program, &own, |line, block| line == site.line || self.jumped.has(program, block));
        if let (true, Some((_, place))) = (marks, mark_before(program, site)) {
            edits.push(without_comment(program, place));
        }
        edits.push(Edit::replace(site.span, call));
        edits.extend(before(program, site.line, &lines));
        edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
        edits
    }

    /// What goes with the words of the call, but counts for others or is an expression: it stays as assignments.
    fn kept(&self, site: &CallSite, own: &Lines, said: &[Name], stays: &BTreeMap<Name, u32>) -> Vec<String> {
        let program = self.program;
        let mut lines = Vec::new();
        for word in own.values().flatten().filter(|word| word.called().is_some()) {
            for (name, place) in AUXILIARY_ARGS.iter().zip(arguments::places(program, word.span)) {
                let text = program.written(place);
                if !text.is_empty() && text.parse() != Ok(0.0) && site.cycle.param(name).is_none() {
                    lines.push(format!("{name}={text}"));
                }
            }
        }
        let assigned = |name: &Name| self.style == Style::Operate && stays.contains_key(name);
        let spare = site.places.iter().filter(|(name, place)| {
            let gone = program.word_at(**place).is_some_and(|word| {
                word.span == site.span || own.values().flatten().any(|other| other.span == word.span)
            });
            gone && (!said.contains(name) || assigned(name))
        });
        lines.extend(spare.filter_map(|(name, _)| {
            let read = || value(program.dialect, site.cycle.param(name)?, site.values.get(name.as_str())?);
            let text = site.expression(name).map(str::to_owned).or_else(|| read().filter(|_| assigned(name)));
            Some(format!("{name}={}", text.filter(|text| text != name.as_str())?))
        }));
        lines
    }
}

/// Lines before that of the call, behind its label; they are skipped as it is.
fn before(program: &Program, line: u32, lines: &[String]) -> Option<Edit> {
    let block = program.blocks.get(line as usize).filter(|_| !lines.is_empty())?;
    let end = line_end(program, line);
    let digits = |text: &[u8]| text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let slash = program.text(block.span).trim_ascii_start().strip_prefix(b"/").filter(|_| block.skip.is_some());
    let skip = slash.map_or(String::new(), |rest| {
        format!("/{} ", String::from_utf8_lossy(rest.get(..digits(rest)).unwrap_or_default()))
    });
    Some(match behind_label(program, line) {
        Some(at) => Edit::insert(at, lines.iter().map(|line| format!("{line}{end}{skip}")).collect::<String>()),
        None => {
            Edit::insert(block.span.start, lines.iter().map(|line| format!("{skip}{line}{end}")).collect::<String>())
        }
    })
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
