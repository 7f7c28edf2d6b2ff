//! Which lines of a program edits change.

use super::calls::CallSite;
use super::change::{Edit, apply};
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::Program;
use std::ops::RangeInclusive;

/// A line that would be another one.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct TouchedLine {
    /// Number of the line, from 1.
    pub line: u32,
    /// As it is.
    pub before: String,
    /// As it would be; empty where it goes.
    pub after: String,
}

/// The lines that edits change, in the order of the text. One before or behind which others are written stays as it is.
pub fn touched(program: &Program, edits: &[Edit]) -> Vec<TouchedLine> {
    let mut lines: Vec<u32> = Vec::new();
    for edit in edits {
        let first = program.line_of(edit.span.start);
        let last = program.line_of(edit.span.end.max(edit.span.start + 1) - 1);
        lines.extend(first..=last.max(first));
    }
    lines.sort_unstable();
    lines.dedup();
    lines.into_iter().filter_map(|line| one(program, edits, line)).filter(|line| !stays(line)).collect()
}

fn one(program: &Program, edits: &[Edit], line: u32) -> Option<TouchedLine> {
    let span = program.blocks.get(line as usize)?.span;
    let within = |at: u32| at.clamp(span.start, span.end) - span.start;
    let here = edits.iter().filter(|edit| {
        let begins = span.start <= edit.span.start && edit.span.start <= span.end;
        begins || edit.span.start < span.start && edit.span.end > span.start
    });
    // what an edit writes is in the line in which it begins
    let part = |edit: &Edit| Edit {
        span: Span { start: within(edit.span.start), end: within(edit.span.end) },
        insert: if edit.span.start >= span.start { edit.insert.clone() } else { String::new() },
    };
    let edits: Vec<Edit> = here.map(part).collect();
    let before = program.text(span);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim_end().to_owned();
    Some(TouchedLine { line: line + 1, before: text(before), after: text(&apply(before, &edits)) })
}

/// Whether the line is still there as a whole.
fn stays(line: &TouchedLine) -> bool {
    line.after == line.before || line.after.lines().any(|one| one.trim_end() == line.before)
}

/// The lines of a call, from 1: those from its first assignment to itself.
fn own(site: &CallSite) -> RangeInclusive<u32> {
    site.first_line + 1..=site.line + 1
}

/// The lines that edits for a call change outside of its own.
pub fn elsewhere(program: &Program, site: &CallSite, edits: &[Edit]) -> Vec<TouchedLine> {
    let own = own(site);
    touched(program, edits).into_iter().filter(|line| !own.contains(&line.line)).collect()
}

/// The lines that the cure of a finding changes, but for the one where it is told and those of the call around that.
pub fn cured_elsewhere(program: &Program, sites: &[CallSite], found: &Diagnostic) -> Vec<TouchedLine> {
    let Some((cure, span)) = found.cure.as_ref().zip(found.span) else { return Vec::new() };
    let told = program.line_of(span.start) + 1;
    let near: Vec<_> = sites.iter().map(own).filter(|lines| lines.contains(&told)).collect();
    let lines = touched(program, &cure.edits).into_iter();
    let other = |line: &TouchedLine| line.line != told && !near.iter().any(|one| one.contains(&line.line));
    lines.filter(other).collect()
}
