//! What the rest of a program has to do with the values of a call: statements that read the same variables, and
//! programs outside of the text that may read or change them between a value and the call.

use super::calls::CallSite;
use super::flow::{Called, LEVELS, called, called_here, callers, named_outside};
use super::held::stem;
use crate::catalogue::list::newer_alone;
use crate::diagnostic::Span;
use crate::name::Name;
use crate::syntax::fold::names_in;
use crate::syntax::programs::{Programs, bare, programs};
use crate::syntax::{Block, ExprId, Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The words that read variables, by the names of these without index.
pub(super) struct Readers {
    words: BTreeMap<String, Vec<Span>>,
}

impl Readers {
    /// Of all variables that may be parameters of a cycle: their names begin so.
    pub fn of(program: &Program) -> Readers {
        let mut words: BTreeMap<String, Vec<Span>> = BTreeMap::new();
        for word in &program.words {
            let mut names = BTreeSet::new();
            read_by(program, word, &mut names);
            for name in names.into_iter().filter(|name| name.starts_with('_')) {
                words.entry(name).or_default().push(word.span);
            }
        }
        Readers { words }
    }

    /// The first line, from 1, of a statement other than the call that reads the variable of this parameter.
    pub fn line(&self, program: &Program, site: &CallSite, name: &str) -> Option<u32> {
        let mut words = self.words.get(stem(name))?.iter();
        words.find(|word| **word != site.span).map(|word| program.line_of(word.start) + 1)
    }
}

/// The variables that a word reads.
fn read_by(program: &Program, word: &Word, names: &mut BTreeSet<String>) {
    let mut of = |id: &ExprId| names_in(program, *id, names);
    match &word.kind {
        WordKind::Address { value, .. } | WordKind::Constant(value) => of(value),
        WordKind::Assign { index, value, .. } => index.iter().chain([value]).for_each(of),
        WordKind::Declare { index, value, .. } => index.iter().chain(value).for_each(of),
        WordKind::Call { args, .. } => args.iter().for_each(of),
        WordKind::Keyword { value, .. } => value.iter().for_each(of),
        WordKind::Unknown => {
            let text = program.written(word.span).to_ascii_uppercase();
            let parts = text.split(|one: char| !one.is_ascii_alphanumeric() && one != '_');
            names.extend(parts.map(str::to_owned));
        }
        WordKind::Label(_) | WordKind::Header => {}
    }
}

/// The programs that are not in the text, by the lines that call them or a program of the text that does.
pub(super) struct Outside {
    names: BTreeMap<usize, String>,
    programs: Programs,
}

impl Outside {
    pub fn of(program: &Program) -> Outside {
        let programs = programs(program);
        let by_unit = by_unit(program, &programs);
        let here = |words: &[Word]| {
            called_here(program, &programs, words).find_map(|(_, unit)| by_unit.get(unit).cloned().flatten())
        };
        let called = |(line, block): (usize, &Block)| {
            let words = program.words_of(block);
            Some((line, named(program, &programs, words).or_else(|| here(words))?))
        };
        let names = program.blocks.iter().enumerate().filter_map(called).collect();
        Outside { names, programs }
    }

    /// One that is called between one of these values and the call, where the value is written outside of the call: the
    /// value, the program.
    pub fn between(&self, program: &Program, site: &CallSite, said: &[Name]) -> Option<(Name, &str)> {
        let outside = |place: &Span| place.end <= site.span.start || place.start >= site.span.end;
        let anew = |name: &Name| site.values.get(name.as_str()).is_some_and(|text| *text != name.as_str());
        said.iter().filter(|name| anew(name)).find_map(|name| {
            let place = site.places.get(name).filter(|place| outside(place))?;
            let lines = self.lines(program.line_of(place.start) as usize, site.line as usize);
            let mut called = lines.into_iter().flat_map(|lines| self.names.range(lines));
            Some((*name, called.next()?.1.as_str()))
        })
    }

    /// The lines between a value and its call: of another program, or of a later line of the same, to its end and from
    /// the beginning of the program with the call.
    fn lines(&self, from: usize, to: usize) -> [Range<usize>; 2] {
        let unit = |line: usize| Some(self.programs.units.get(self.programs.of_line(line as u32)?)?.blocks.clone());
        let (before, with) = (unit(from), unit(to));
        if before == with && from <= to {
            return [from..to + 1, 0..0];
        }
        let end = before.map_or(from + 1, |lines| lines.end.max(from + 1));
        [from..end, with.map_or(0, |lines| lines.start)..to + 1]
    }
}

/// What each program of the text calls outside of it, itself or by others.
fn by_unit(program: &Program, programs: &Programs) -> Vec<Option<String>> {
    let own = |unit| program.blocks_of(unit).iter().find_map(|block| named(program, programs, program.words_of(block)));
    let mut names: Vec<Option<String>> = programs.units.iter().map(own).collect();
    let calls = callers(program, programs);
    for _ in 0..LEVELS {
        for (unit, called) in calls.iter().enumerate() {
            let inner = called.iter().find_map(|other| names.get(*other).cloned().flatten());
            if let Some(name) = names.get_mut(unit).filter(|name| name.is_none()) {
                *name = inner;
            }
        }
    }
    names
}

/// The first program outside that a block calls itself.
fn named(program: &Program, programs: &Programs, words: &[Word]) -> Option<String> {
    let outside = |at: &usize| called(program, programs, words, *at) == Some(Called::Elsewhere);
    (0..words.len()).filter(outside).find_map(|at| name_of(program, programs, words, at))
}

/// How a program outside is called; none: it is a cycle of newer controls.
fn name_of(program: &Program, programs: &Programs, words: &[Word], at: usize) -> Option<String> {
    let name = match named_outside(program, programs, words, at) {
        Some(place) => bare(&program.name(place)).to_owned(),
        None => program.written(words.get(at)?.span).trim().to_owned(),
    };
    newer_alone(&name).is_none().then_some(name)
}
