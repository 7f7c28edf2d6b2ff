//! Measuring programs of the 840C: calls of subprograms (`L977`) whose parameters are R parameters, and the same with
//! the names and cycles of today. Each assignment is changed at its place; every other byte stays.

mod clash;
mod edits;
mod findings;
#[cfg(test)]
mod loop_tests;
#[cfg(test)]
mod tests;
mod walk;
mod ways;

pub use edits::edits;
pub use findings::{findings, is_of_call, left_out, reasons};

use crate::catalogue::r_parameters::{Called, SETPOINTS, VARIANT};
use crate::diagnostic::Span;
use crate::entry::Cycle;
use crate::name::Name;
use crate::syntax::fold::{NOTHING, names_in, number};
use crate::syntax::programs::Programs;
use crate::syntax::{ExprId, Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};

/// What somebody answered: which name an R parameter is, where the manual leaves it open.
pub type Answers = BTreeMap<u16, Name>;

/// Measuring calls of an 840C and what gives them values.
#[derive(Default)]
pub struct Older {
    /// The calls in the order of the text.
    pub calls: Vec<Call>,
    /// Assignments that reach one of them, in the order of the text.
    pub assigned: Vec<Assigned>,
    /// R parameters that are read behind a call as results of it: number, and the word that reads it.
    pub results: Vec<(u16, Span)>,
    /// Where the program gives an R parameter a value that cannot be followed.
    pub unclear: Option<Span>,
    /// What leads to a call, or away from it, on a way that is not followed.
    pub ways: Vec<Span>,
    /// Words that could not be read: they may assign R parameters of a call, or read them.
    pub unread: Vec<Span>,
    /// Calls with the number of a cycle that no 840C had, to which a variant comes: name in the call, and the cycle.
    pub newer: Vec<(Span, &'static Cycle)>,
    /// Where a call would read the value of another call.
    pub clashes: Vec<Clash>,
    /// What was answered.
    answers: Answers,
    /// R parameters for which an answer counted.
    answered: BTreeSet<u16>,
}

/// A parameter that would come to a call with the value that another call means by it.
pub struct Clash {
    /// Place of the call in [`Older::calls`].
    pub call: usize,
    /// What it reads.
    pub name: Name,
    /// First byte of the assignment that would give it its value.
    pub from: u32,
}

/// A measuring call.
pub struct Call {
    /// What it is today.
    pub cycle: &'static Cycle,
    /// The word that calls it.
    pub word: Span,
    /// The name in it.
    pub name: Span,
    /// The values that arrive, by R parameter: places in [`Older::assigned`].
    pub given: BTreeMap<u16, Vec<usize>>,
    /// The names that each of these R parameters is here; several: the manual does not say which.
    pub names: BTreeMap<u16, BTreeSet<Name>>,
    /// R parameters that do not count here, because another one is the same parameter: that one.
    pub instead: BTreeMap<u16, u16>,
    /// What it reads of what R parameters can be.
    reads: BTreeSet<Name>,
}

/// An assignment of an R parameter that reaches a measuring call.
pub struct Assigned {
    /// Number of the R parameter.
    pub number: u16,
    /// The whole word.
    pub word: Span,
    /// What it is called on the left side.
    pub target: Span,
    /// The right side.
    pub value: ExprId,
    /// Something else reads it too.
    pub read: bool,
    /// Calls that it reaches: places in [`Older::calls`].
    pub calls: Vec<usize>,
    /// The names that it is for these calls; none: no call takes it.
    pub names: BTreeSet<Name>,
    /// Names of which the manual does not say which is meant.
    pub open: BTreeSet<Name>,
}

/// Looks for measuring calls of an 840C: subprograms with the number of a cycle, not in the text, to which a variant
/// comes in R23.
pub fn find(program: &Program, programs: &Programs, answers: &Answers) -> Older {
    let mut older = walk::walk(program, programs);
    let variants: Vec<Vec<Called>> = older.calls.iter().map(|call| variants(program, &older, call)).collect();
    let meant: Vec<BTreeMap<u16, Meant>> =
        older.calls.iter().zip(&variants).map(|(call, variants)| meant(program, &older, call, variants)).collect();
    for ((call, meant), variants) in older.calls.iter_mut().zip(&meant).zip(&variants) {
        call.reads = variants.iter().flat_map(Called::read).collect();
        for (number, places) in &call.given {
            let Some(meant) = meant.get(number) else { continue };
            let (names, open) = meant.with(*number, answers);
            older.answered.extend((meant.open && !open).then_some(*number));
            call.instead.extend(meant.rival.filter(|_| names.is_empty()).map(|rival| (*number, rival)));
            for at in places {
                let Some(assigned) = older.assigned.get_mut(*at) else { continue };
                if open { &mut assigned.open } else { &mut assigned.names }.extend(&names);
            }
            call.names.insert(*number, names);
        }
    }
    older.answers.clone_from(answers);
    let (clashes, lost) = clash::clashes(program, programs, &older);
    older.clashes = clashes;
    older.ways.extend(lost);
    older
}

/// The cycle of a call with each variant that comes to it.
fn variants(program: &Program, older: &Older, call: &Call) -> Vec<Called> {
    let places = call.given.get(&VARIANT).into_iter().flatten();
    let values = places.filter_map(|at| older.assigned.get(*at)).map(|one| number(program, one.value, NOTHING));
    values.map(|value| Called::of(call.cycle, value)).collect()
}

/// What an R parameter is for one call.
#[derive(Default)]
struct Meant {
    names: BTreeSet<Name>,
    /// Which of the names is meant, or whether it is meant at all, is open.
    open: bool,
    /// The other R parameter that may be meant.
    rival: Option<u16>,
}

impl Meant {
    /// The names with what was answered, and whether it is still open which of them is meant.
    fn with(&self, number: u16, answers: &Answers) -> (BTreeSet<Name>, bool) {
        match answers.get(&number).filter(|name| self.names.contains(*name)) {
            Some(name) => (BTreeSet::from([*name]), false),
            None if self.rival.is_some_and(|rival| answers.contains_key(&rival)) => (BTreeSet::new(), false),
            None => (self.names.clone(), self.open),
        }
    }
}

/// What the R parameters that come to a call are for it.
fn meant(program: &Program, older: &Older, call: &Call, variants: &[Called]) -> BTreeMap<u16, Meant> {
    let of = |number: &u16| call.given.get(number).into_iter().flatten().filter_map(|at| older.assigned.get(*at));
    let mut all: BTreeMap<u16, Meant> = BTreeMap::new();
    for number in call.given.keys() {
        let meant = all.entry(*number).or_default();
        for variant in variants {
            let names = variant.meant(*number);
            meant.open |= names.len() > 1;
            meant.names.extend(names);
        }
        meant.open |= meant.names.len() > 1;
    }
    let [first, second] = SETPOINTS;
    if [first, second].iter().all(|number| all.get(number).is_some_and(|one| !one.names.is_empty())) {
        if is_same(program, &of(&first).collect::<Vec<_>>(), &of(&second).collect::<Vec<_>>()) {
            let without = Meant { rival: Some(first), ..Meant::default() };
            all.insert(second, without);
        } else {
            for (number, rival) in [(first, second), (second, first)] {
                all.entry(number).and_modify(|one| (one.open, one.rival) = (true, Some(rival)));
            }
        }
    }
    all
}

/// Whether two R parameters have one value: the same number, whichever assignments come, or what the same variables
/// hold at the same time.
fn is_same(program: &Program, first: &[&Assigned], second: &[&Assigned]) -> bool {
    let value = |one: &&Assigned| number(program, one.value, NOTHING);
    let known: Option<Vec<f64>> = first.iter().chain(second).map(value).collect();
    match (known, first, second) {
        (Some(values), ..) => values.windows(2).all(|pair| pair[0] == pair[1]),
        (None, [first], [second]) => {
            let text = |one: &Assigned| program.written(program.place(one.value));
            let [before, behind] = if first.word.start < second.word.start { [first, second] } else { [second, first] };
            text(first) == text(second) && holds(program, before, behind)
        }
        _ => false,
    }
}

/// Whether what an assignment reads is the same at a later one of its block: nothing between them writes it.
fn holds(program: &Program, before: &Assigned, behind: &Assigned) -> bool {
    let mut read = BTreeSet::new();
    names_in(program, before.value, &mut read);
    let known = read.iter().all(|name| name != "R" && !name.starts_with('$'));
    let from = program.words.partition_point(|word| word.span.start < before.word.start);
    let between = program.words.iter().skip(from).take_while(|word| word.span.start < behind.word.start);
    let keeps = |word: &Word| match &word.kind {
        WordKind::Assign { name, index, .. } => index.is_empty() && !read.contains(&program.name(*name)),
        WordKind::Address { .. } => true,
        _ => false,
    };
    known && program.line_of(before.word.start) == program.line_of(behind.word.start) && between.into_iter().all(keeps)
}

impl Older {
    /// Whether every assignment is known to be one parameter, or none, and every call would get its own values.
    pub fn is_clear(&self) -> bool {
        let followed = self.unclear.is_none() && self.ways.is_empty() && self.unread.is_empty();
        followed && self.clashes.is_empty() && self.assigned.iter().all(|one| one.open.is_empty())
    }
}

impl Assigned {
    /// Whether another R parameter gives the same calls the same parameter, so that one of the two has to go.
    fn rival(&self) -> Option<u16> {
        let [first, second] = SETPOINTS;
        let of = |number, other| (self.number == number && self.open.len() == 1).then_some(other);
        of(first, second).or_else(|| of(second, first))
    }

    /// `R19=-20`, as it is written.
    pub fn text(&self, program: &Program) -> String {
        program.written(self.word)
    }
}

/// The assignment that a word is: what it is called on the left, and the right side.
fn assignment(program: &Program, kind: &WordKind, word: Span) -> Option<(Span, ExprId)> {
    let WordKind::Assign { value, .. } = kind else { return None };
    let left = Span { start: word.start, end: program.place(*value).start };
    let text = program.text(left);
    let end = text.iter().rposition(|byte| *byte == b'=')?;
    let name = text.get(..end)?.trim_ascii_end().len() as u32;
    Some((Span { start: word.start, end: word.start + name }, *value))
}
