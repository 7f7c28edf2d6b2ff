//! The blocks around a call of a program, added, changed in place and taken away.

use super::pattern::{Place, given, is_given};
use super::read::{Found, found, passed};
use super::values::{choices, preset, problem, value};
use super::{Block, Kind, Words, block, blocks, write};
use crate::check;
use crate::control::Control;
use crate::diagnostic::{Edit, Span};
use crate::entry::{Inputs, Typed};
use crate::program::calls::CallSite;
use crate::program::change::line_end;
use crate::syntax::Program;
use std::collections::{BTreeMap, BTreeSet};

/// A block that is wanted, with its values as typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Around {
    /// Its name.
    pub name: String,
    /// Its values.
    pub values: Typed,
}

/// What the control knows of a call of a program.
pub fn inputs_at(site: &CallSite, control: &Control) -> Inputs {
    check::read(site.cycle, &site.values, &site.control_at(control), &mut Vec::new())
}

/// Edits by which exactly these blocks stand around a call: those that are there stay where they are and get the new
/// values, the others go with their lines. What cannot be written is left out.
pub fn revise(
    program: &Program,
    site: &CallSite,
    wanted: &[Around],
    inputs: &Inputs,
    words: Words,
    comments: bool,
) -> Vec<Edit> {
    if program.is_of_macro(site.span) {
        return Vec::new();
    }
    let there = found(program, site, inputs);
    let mut edits = Vec::new();
    for one in &there {
        match wanted.iter().find(|around| around.name == one.block.name) {
            Some(around) => edits.extend(changed(one, &around.values, inputs, words)),
            None => edits.extend(one.before.iter().chain(&one.after).map(|line| without(program, *line))),
        }
    }
    let new = |around: &&Around| !there.iter().any(|one| one.block.name == around.name);
    let known = |around: &Around| writable(block(program.dialect, &around.name)?, around, inputs);
    let mut new: Vec<(&Block, Typed)> = wanted.iter().filter(new).filter_map(known).collect();
    new.sort_by_key(|(block, _)| rank(program, block));
    edits.extend(added(program, site, &there, &new, inputs, words, comments));
    edits
}

/// A block with its values, where all of them can be written.
fn writable(block: &'static Block, around: &Around, inputs: &Inputs) -> Option<(&'static Block, Typed)> {
    let right = block.fields.iter().all(|field| problem(block, field, &around.values, inputs).is_none());
    right.then(|| (block, around.values.clone()))
}

/// How far outside a block stands, 0 next to the call.
fn rank(program: &Program, block: &Block) -> usize {
    let all = blocks(program.dialect);
    all.iter().rev().position(|other| other.name == block.name).unwrap_or(all.len())
}

/// Blocks around a call of which a value has changed, as they belong to it now.
#[derive(Debug, Default)]
pub struct Carried {
    /// What changes in their lines.
    pub edits: Vec<Edit>,
    /// Lines that change, from 1.
    pub lines: BTreeSet<u32>,
    /// First lines of blocks that do not belong to the call any more, from 1.
    pub left: BTreeSet<u32>,
}

/// Blocks that suited a call as it was (`before`), for what it is `now`: what the call gives them is that of the call
/// as it is, and what followed from its values by itself follows again; what was chosen otherwise stays.
pub fn carried(program: &Program, site: &CallSite, before: &Inputs, now: &Inputs) -> Carried {
    let mut carried = Carried::default();
    if program.is_of_macro(site.span) {
        return carried;
    }
    for one in found(program, site, before).iter().filter(|one| one.place == Place::of(before)) {
        let mut edits = given_anew(one, now);
        let mut suits = edits.is_some() && (one.block.suits(now) || !one.block.suits(before));
        for (field, bound) in one.bound.iter().filter_map(|bound| Some((one.block.field(bound.name)?, bound))) {
            let follows = matches!(field.kind, Kind::Result | Kind::Deviation | Kind::Side);
            let value =
                if follows && bound.text == preset(field, before) { preset(field, now) } else { bound.text.clone() };
            if follows && !choices(field, now).iter().any(|(choice, _)| *choice == value) {
                suits = false;
            } else if value != bound.text {
                let places = bound.places.iter().map(|place| Edit::replace(*place, value.clone()));
                edits.iter_mut().for_each(|edits| edits.extend(places.clone()));
            }
        }
        let edits = edits.unwrap_or_default();
        if suits {
            carried.lines.extend(edits.iter().map(|edit| program.line_of(edit.span.start) + 1));
            carried.edits.extend(edits);
        } else {
            carried.left.extend(one.before.first().or(one.after.first()).map(|line| *line as u32 + 1));
        }
    }
    carried.edits.sort_by_key(|edit| edit.span.start);
    carried
}

/// What the call gives, where other text stands in the lines of a block; none: the call gives it not any more.
fn given_anew(one: &Found, inputs: &Inputs) -> Option<Vec<Edit>> {
    let of_call = one.bound.iter().filter(|bound| is_given(bound.name));
    let edits = of_call.map(|bound| {
        let text = given(bound.name, inputs)?;
        let places = bound.places.iter().filter(|_| text != bound.text);
        Some(places.map(|place| Edit::replace(*place, text.clone())).collect::<Vec<_>>())
    });
    Some(edits.collect::<Option<Vec<_>>>()?.concat())
}

/// A block whose lines belong to a call with other values, and the edits with which they belong to this one; none where
/// that is not possible.
pub struct Stray {
    /// Where it names the other place first.
    pub at: Span,
    /// What changes in its lines.
    pub edits: Vec<Edit>,
}

/// Blocks around a call whose lines name another work offset, or the axes of another plane.
pub fn strays(program: &Program, site: &CallSite, inputs: &Inputs) -> Vec<Stray> {
    let away = |one: &Found| one.place != Place::of(inputs);
    let stray = |one: &Found| {
        let named = one.bound.iter().filter(|bound| is_given(bound.name)).flat_map(|bound| &bound.places);
        let at = named.min_by_key(|place| place.start).copied()?;
        Some(Stray { at, edits: given_anew(one, inputs).unwrap_or_default() })
    };
    found(program, site, inputs).iter().filter(|one| away(one)).filter_map(stray).collect()
}

/// New values at each place where the old ones stand, and what the call gives; a value that cannot be written changes
/// nothing.
fn changed(one: &Found, typed: &Typed, inputs: &Inputs, words: Words) -> Vec<Edit> {
    let mut edits = given_anew(one, inputs).unwrap_or_default();
    for bound in &one.bound {
        let Some(field) = one.block.field(bound.name) else { continue };
        let same = typed.get(field.name).is_some_and(|typed| *typed == bound.text);
        if same || problem(one.block, field, typed, inputs).is_some() {
            continue;
        }
        let value = value(field, typed, inputs, words);
        if value != bound.text {
            edits.extend(bound.places.iter().map(|place| Edit::replace(*place, value.clone())));
        }
    }
    edits
}

/// A line goes with its end.
fn without(program: &Program, line: usize) -> Edit {
    let start = |line: usize| program.blocks.get(line).map(|block| block.span.start);
    Edit::remove(start(line).unwrap_or_default(), start(line + 1).unwrap_or(program.end))
}

/// New blocks, the inner ones first, each outside of those that stand further inside.
fn added(
    program: &Program,
    site: &CallSite,
    there: &[Found],
    new: &[(&Block, Typed)],
    inputs: &Inputs,
    words: Words,
    comments: bool,
) -> Vec<Edit> {
    let mut taken = program.written(Span { start: 0, end: program.end });
    let (mut above, mut below) = (BTreeMap::<u32, String>::new(), BTreeMap::<u32, String>::new());
    for (block, typed) in new {
        let lines = write(block, typed, inputs, &taken, words, comments);
        taken = taken + &lines.before + &lines.after;
        let inside = there.iter().rposition(|one| rank(program, one.block) < rank(program, block));
        let inside = there.get(..inside.map_or(0, |at| at + 1)).unwrap_or_default();
        let top = inside.iter().rev().find_map(|one| one.before.first()).copied();
        let bottom = inside.iter().rev().find_map(|one| one.after.last()).copied();
        above
            .entry(start_of(program, top.unwrap_or_else(|| head(program, site))))
            .or_default()
            .insert_str(0, &lines.before);
        below.entry(start_of(program, bottom.unwrap_or(site.line as usize) + 1)).or_default().push_str(&lines.after);
    }
    let end = line_end(program, site.line);
    let open = !program.text(Span { start: 0, end: program.end }).ends_with(b"\n");
    let edit = |(at, text): (u32, String)| {
        let text = text.replace('\n', end);
        let last = at == program.end && open;
        Edit::insert(at, if last { format!("{end}{}", text.trim_end()) } else { text })
    };
    above.into_iter().chain(below).filter(|(_, text)| !text.is_empty()).map(edit).collect()
}

fn start_of(program: &Program, line: usize) -> u32 {
    program.blocks.get(line).map_or(program.end, |block| block.span.start)
}

/// First line that belongs to a call: comments and bits just above its values do.
fn head(program: &Program, site: &CallSite) -> usize {
    let mut top = site.first_line as usize;
    let belongs = |at: usize| {
        let block = program.blocks.get(at);
        let said = block.and_then(|block| block.comment).map(|comment| program.written(comment));
        let of_file = said.as_ref().is_some_and(|said| said.starts_with(";$"));
        let empty = block.is_none_or(|block| block.span.start == block.span.end);
        passed(program, at) && !of_file && !empty
    };
    while top > 0 && belongs(top - 1) {
        top -= 1;
    }
    top
}
