//! The blocks around a call of a program, found by their lines.

use super::pattern::{Bound, Place, matches, place_of};
use super::values::problem;
use super::{Block, Field, Kind, Line, blocks};
use crate::diagnostic::Span;
use crate::entry::{Inputs, Typed};
use crate::program::calls::CallSite;
use crate::program::own_words::sets_bits;
use crate::syntax::Program;
use std::collections::BTreeSet;

/// A block that stands around a call.
pub struct Found {
    /// Which it is.
    pub block: &'static Block,
    /// Its values, as they are written.
    pub bound: Vec<Bound>,
    /// Its lines before the call, from the top.
    pub before: Vec<usize>,
    /// Those behind it.
    pub after: Vec<usize>,
    /// Where a call measures to which it belongs: another place than that of its call, where a value of the call was
    /// changed without it.
    pub place: Place,
}

impl Found {
    /// Its values by their fields.
    pub fn values(&self) -> Typed {
        let fields = self.bound.iter().filter(|bound| self.block.field(bound.name).is_some());
        fields.map(|bound| (bound.name.to_owned(), bound.text.clone())).collect()
    }
}

/// The blocks around a call, the innermost first: around all lines of its values, else around those next to it.
pub fn found(program: &Program, site: &CallSite, inputs: &Inputs) -> Vec<Found> {
    let all = around(program, site, inputs, site.first_line as usize);
    if all.is_empty() { around(program, site, inputs, next_to(program, site)) } else { all }
}

/// First of the lines just above a call that give it values: others may stand further above, before a block.
fn next_to(program: &Program, site: &CallSite) -> usize {
    let line = |place: &Span| program.line_of(place.start) as usize;
    let own: BTreeSet<usize> = site.places.values().filter(|place| place.start >= site.own_from).map(line).collect();
    let mut top = site.line as usize;
    while top > site.first_line as usize && (own.contains(&(top - 1)) || passed(program, top - 1)) {
        top -= 1;
    }
    top
}

/// The blocks around the lines from `top` to the call.
fn around(program: &Program, site: &CallSite, inputs: &Inputs, mut top: usize) -> Vec<Found> {
    let mut all: Vec<Found> = Vec::new();
    let mut bottom = site.line as usize;
    let left = |all: &[Found], block: &Block| !all.iter().any(|found| found.block.name == block.name);
    loop {
        let inner = blocks(program.dialect).iter().rev().filter(|block| left(&all, block));
        let next = inner.filter_map(|block| at(program, block, inputs, top, bottom)).next();
        let Some(next) = next else { return all };
        top = next.before.first().copied().unwrap_or(top);
        bottom = next.after.last().copied().unwrap_or(bottom);
        all.push(next);
    }
}

/// A block whose lines stand just above one line and just below another one.
fn at(program: &Program, block: &'static Block, inputs: &Inputs, top: usize, bottom: usize) -> Option<Found> {
    let mut bound = Vec::new();
    let above = (0..top).rev();
    let mut before = run(program, block.before.iter().rev(), above, inputs, &mut bound)?;
    before.reverse();
    let after = run(program, block.after.iter(), bottom + 1..program.blocks.len(), inputs, &mut bound)?;
    for one in &mut bound {
        one.places.sort_by_key(|place| place.start);
    }
    let place = place_of(&bound, inputs)?;
    let found = Found { block, bound, before, after, place };
    let values = found.values();
    let right = |field: &Field| {
        let free = matches!(field.kind, Kind::Limit | Kind::Text); // of these the form tells what is wrong
        free || problem(block, field, &values, inputs).is_none()
    };
    block.fields.iter().all(right).then_some(found)
}

/// Lines of the program that are these lines in their order; comments and empty lines may stand between.
fn run<'a>(
    program: &Program,
    lines: impl Iterator<Item = &'a Line>,
    mut blocks: impl Iterator<Item = usize>,
    inputs: &Inputs,
    bound: &mut Vec<Bound>,
) -> Option<Vec<usize>>
where
    Line: 'static,
{
    let mut found = Vec::new();
    for line in lines {
        let at = blocks.find(|at| !passed(program, *at))?;
        if !matches(program, &program.blocks[at], line.code, inputs, bound) {
            return None;
        }
        found.push(at);
    }
    Some(found)
}

/// Whether a line says nothing to the control, or sets bits for the call alone.
pub(super) fn passed(program: &Program, at: usize) -> bool {
    let Some(block) = program.blocks.get(at) else { return false };
    let silent = program.words_of(block).is_empty() && block.number.is_none() && !block.plain;
    silent || sets_bits(program, block)
}
