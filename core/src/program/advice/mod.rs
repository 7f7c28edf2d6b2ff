//! Warnings about a program as a whole: what a colleague who reads it from top to bottom would ask.

mod around;
mod at_call;
mod behind;
mod generation;
mod inherited;
mod logs;
mod nct;
mod nct_frames;
mod nct_levels;
mod older;
mod read_back;
mod subprograms;
mod unsaid;

use super::calls::{CallSite, Way};
use super::change::{line_at_begin, line_before, line_end};
use super::flow::{State, changes_tools};
use super::r_parameters::Older;
use super::tools::ToolInUse;
use crate::check::newer;
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic, Edit, Severity, Span};
use crate::entry::{Inputs, Typed};
use crate::message::Message;
use crate::syntax::links::links;
use crate::syntax::programs::{Programs, programs};
use crate::syntax::{Program, Word, WordKind};
use crate::{check, own};
use std::collections::BTreeMap;

/// What the rules look at: a call, what is active there, what it means.
struct Seen<'a> {
    program: &'a Program,
    control: &'a Control,
    sites: &'a [CallSite],
    index: usize,
    site: &'a CallSite,
    /// It changes tools with M6.
    changes_tools: bool,
    /// What is active on a way to the call.
    force: &'a State,
    /// Tool in use on it.
    tool: Option<ToolInUse>,
    /// Values on it.
    values: &'a Typed,
    inputs: Inputs,
    programs: &'a Programs,
}

impl Seen<'_> {
    /// Whether a place lies behind the call in the same program: what it activates comes back with the next pass.
    fn comes_back(&self, place: Span) -> bool {
        let line = self.program.line_of(place.start);
        let unit = self.programs.of_line(line);
        line > self.site.line && unit.is_some() && unit == self.programs.of_line(self.site.line)
    }
}

/// Tells what a program with calls of an 840C calls that the text does not hold.
pub(super) fn outside_older(program: &Program, programs: &Programs, older: &Older, found: &mut Vec<Diagnostic>) {
    subprograms::outside(program, programs, &older::known(program, programs, older), found);
}

/// Findings about the measuring calls of a program that starts on a control in this state.
pub fn advice(program: &Program, sites: &[CallSite], control: &Control) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let programs = programs(program);
    let known = older::look(program, &programs, &mut found);
    subprograms::outside(program, &programs, &known, &mut found);
    subprograms::misnamed(program, &programs, &mut found);
    around::look(program, control, sites, &mut found);
    if program.grammar().by_address {
        nct::look(program, &programs, sites, &mut found);
        nct_frames::look(program, &programs, sites, &mut found);
        nct_levels::look(program, &programs, control, sites, &mut found);
        return found;
    }
    let generation = generation::look(program, sites, control);
    if sites.is_empty() {
        found.extend(generation);
        return found;
    }
    let mut asked = at_call::Asked::of(program);
    // Asked once: a long program has many calls and many words.
    let changes_tools = changes_tools(program);
    let mut at_call = control.clone();
    let mut corrected = BTreeMap::new();
    let (links, mut begun) = (links(program, &programs), logs::Logs::new());
    for (index, site, way) in in_order(sites) {
        at_call.plane = way.state.plane.is().copied().unwrap_or(site.plane);
        at_call.transverse = way.state.transverse.is().copied().unwrap_or(site.transverse);
        at_call.choose_units(site.unit_function as u16);
        let values = site.values_on(way);
        let shifted = site.diagnostics.iter().any(|one| one.code == own::NEWER_LOST.code());
        if shifted || site.newer_list().is_some_and(|list| newer::is_open(site.cycle, list, values, &at_call)) {
            continue;
        }
        let seen = Seen {
            program,
            control,
            sites,
            index,
            site,
            changes_tools,
            force: &way.state,
            tool: way.tool,
            values,
            inputs: check::read(site.cycle, values, &at_call, &mut Vec::new()),
            programs: &programs,
        };
        at_call::look(&seen, &mut asked, &mut found);
        read_back::look(&seen, &at_call, &mut found);
        found.extend(logs::look(&seen, &links, &mut begun));
        match behind::corrected(&seen) {
            Some(frame) => corrected.insert(index, frame),
            None => corrected.remove(&index),
        };
    }
    behind::look(program, &programs, sites, &corrected, &mut found);
    subprograms::too_deep(program, &programs, sites, &mut found);
    inherited::overwritten(program, sites, &mut found);
    // What these rules say comes from the manuals of the older control; about a list of a newer one it is a note, but
    // that the tool is no probe, or that it turns.
    for one in &mut found {
        let certain = [Code::Alarm(61309), own::ADVICE_SPINDLE.code()].contains(&one.code);
        if !certain && sites.iter().any(|site| Some(site.span) == one.span && site.newer_list().is_some()) {
            one.severity = Severity::Note;
        }
    }
    found.extend(generation);
    found
}

/// The calls as the run comes to them, each once a way.
fn in_order(sites: &[CallSite]) -> Vec<(usize, &CallSite, &Way)> {
    let ways = sites.iter().enumerate().flat_map(|(index, site)| site.ways.iter().map(move |way| (index, site, way)));
    let mut all: Vec<_> = ways.collect();
    all.sort_by_key(|(_, _, way)| way.order);
    all
}

/// The first of the lines directly before a call that hold nothing but assignments for it: what is inserted there is in
/// force at the call, whatever stands between values that were written earlier and the call.
fn begin(program: &Program, site: &CallSite) -> u32 {
    let assigns = |word: &Word| matches!(word.kind, WordKind::Assign { .. });
    let plain = |line: u32| program.blocks.get(line as usize).is_some_and(|block| block.plain);
    let only = |line: &u32| !plain(*line) && program.words_at(*line as usize).iter().all(assigns);
    (site.first_line..site.line).rev().take_while(only).last().unwrap_or(site.line)
}

/// Offers a line before the call and its assignments.
fn with_line(finding: Diagnostic, seen: &Seen, text: &str) -> Diagnostic {
    let edit = line_at_begin(seen.program, begin(seen.program, seen.site), text);
    finding.cured(Message::new("advice-insert").text("text", text), edit.into_iter().collect())
}

/// Offers a line before the call and its assignments, and one behind it.
fn between(finding: Diagnostic, seen: &Seen, before: &str, behind: &str) -> Diagnostic {
    let first = line_at_begin(seen.program, begin(seen.program, seen.site), before);
    let edits = first.map(|first| vec![first, line_behind(seen.program, seen.site, behind)]);
    let label = Message::new("advice-insert-around").text("before", before).text("behind", behind);
    finding.cured(label, edits.unwrap_or_default())
}

/// Offers a line behind the call.
fn behind_call(finding: Diagnostic, program: &Program, site: &CallSite, text: &str) -> Diagnostic {
    finding.cured(Message::new("advice-insert-behind").text("text", text), vec![line_behind(program, site, text)])
}

fn line_behind(program: &Program, site: &CallSite, text: &str) -> Edit {
    if let Some(edit) = line_before(program, site.line + 1, text) {
        return edit;
    }
    let end = program.end;
    let eol = line_end(program, site.line);
    let ended = program.text(Span { start: 0, end }).ends_with(b"\n");
    Edit::insert(end, if ended { format!("{text}{eol}") } else { format!("{eol}{text}") })
}
