//! Which assignments of R parameters come to which measuring call of an 840C, along branches, loops and subprograms.

use super::ways::unfollowed;
use super::{Assigned, Call, Older, assignment};
use crate::catalogue::r_parameters::{VARIANT, called, is_printed, is_result, newer, number};
use crate::diagnostic::Span;
use crate::entry::Cycle;
use crate::program::flow::{Follow, Meet, follow};
use crate::program::values::{Spread, spread};
use crate::program::variables::plain_name;
use crate::syntax::fold::{self, NOTHING, names_in};
use crate::syntax::programs::Programs;
use crate::syntax::{ExprId, Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};

/// Assignments of one R parameter that are told apart at a place.
const WAYS: usize = 8;

/// What the R parameters hold at a place of the program.
#[derive(Clone, Debug, Default, PartialEq)]
struct Holds {
    /// Assignments that may have given a parameter its value, by their first byte.
    given: BTreeMap<u16, BTreeSet<u32>>,
    /// There may be more.
    more: bool,
    /// A measuring call was passed.
    measured: bool,
    /// What was assigned since.
    fresh: BTreeSet<u16>,
    /// A word on the way that could not be read: it may assign anything.
    unread: Option<Span>,
}

impl Meet for Holds {
    fn meet(&self, other: &Holds) -> Holds {
        let mut met = self.clone();
        met.more |= other.more;
        met.measured |= other.measured;
        met.unread = met.unread.or(other.unread);
        met.fresh.extend(&other.fresh);
        for (number, places) in &other.given {
            let known = met.given.entry(*number).or_default();
            known.extend(places);
            met.more |= known.len() > WAYS;
            while known.len() > WAYS {
                known.pop_last();
            }
        }
        met
    }
}

/// A call by its first byte, and the assignments that come to it.
struct Met {
    cycle: &'static Cycle,
    word: Span,
    name: Span,
    given: BTreeMap<u16, BTreeSet<u32>>,
}

struct Walk<'a> {
    program: &'a Program,
    /// The cycle that each word calls which looks like a measuring call, by its first byte.
    candidates: BTreeMap<u32, &'static Cycle>,
    met: BTreeMap<u32, Met>,
    /// Calls with the number of a cycle that no 840C had.
    newer: BTreeMap<u32, (Span, &'static Cycle)>,
    /// Assignments that something else reads.
    read: BTreeSet<u32>,
    /// Results that a word reads, by its first byte and their number.
    results: BTreeMap<(u32, u16), (u16, Span)>,
    unclear: Option<Span>,
    /// Where the walk lost its way, by the first byte.
    lost: BTreeMap<u32, Span>,
    /// Words that could not be read, by their first byte.
    unread: BTreeMap<u32, Span>,
}

/// The measuring calls with what comes to them; what it means is open still.
pub(super) fn walk(program: &Program, programs: &Programs) -> Older {
    let of = |word: &Word| {
        let name = program.name(word.called()?);
        let cycle = called(&name).or_else(|| newer(&name)).filter(|_| programs.place(&name).is_none())?;
        Some((word.span.start, cycle))
    };
    let candidates: BTreeMap<u32, _> = program.words.iter().filter_map(of).collect();
    if candidates.is_empty() || program.grammar().by_address {
        return Older::default();
    }
    let mut walk = Walk {
        program,
        candidates,
        met: BTreeMap::new(),
        newer: BTreeMap::new(),
        read: BTreeSet::new(),
        results: BTreeMap::new(),
        unclear: None,
        lost: BTreeMap::new(),
        unread: BTreeMap::new(),
    };
    follow(program, programs, &mut walk);
    walk.found(programs)
}

impl Walk<'_> {
    fn found(mut self, programs: &Programs) -> Older {
        // R23 makes it a measuring call: other subprograms have numbers too
        self.met.retain(|_, met| met.given.contains_key(&VARIANT));
        let newer = std::mem::take(&mut self.newer).into_values().collect();
        if self.met.is_empty() {
            return Older { newer, ..Older::default() };
        }
        let places: BTreeSet<u32> = self.met.values().flat_map(|met| met.given.values().flatten().copied()).collect();
        let assigned: Vec<Assigned> = places.iter().filter_map(|place| self.assigned(*place)).collect();
        let at = |place: &u32| assigned.binary_search_by_key(place, |one| one.word.start).ok();
        let mut older = Older { results: self.results.into_values().collect(), newer, ..Older::default() };
        older.unclear = self.unclear;
        let ways = unfollowed(self.program, programs, self.candidates.keys().copied().collect());
        self.lost.extend(ways.into_iter().map(|place| (place.start, place)));
        older.ways = self.lost.into_values().collect();
        older.unread = self.unread.into_values().collect();
        for met in self.met.into_values() {
            let given = met.given.iter().map(|(number, places)| (*number, places.iter().filter_map(at).collect()));
            let (names, instead, reads) = (BTreeMap::new(), BTreeMap::new(), BTreeSet::new());
            let given = given.collect();
            older.calls.push(Call { cycle: met.cycle, word: met.word, name: met.name, given, names, instead, reads });
        }
        older.assigned = assigned;
        for (index, call) in older.calls.iter().enumerate() {
            for at in call.given.values().flatten() {
                if let Some(one) = older.assigned.get_mut(*at) {
                    one.calls.push(index);
                }
            }
        }
        older
    }

    fn assigned(&self, place: u32) -> Option<Assigned> {
        let word = self.program.word_at(Span { start: place, end: place + 1 })?;
        let (target, value) = assignment(self.program, &word.kind, word.span)?;
        Some(Assigned {
            number: number(&written(self.program, word)?)?,
            word: word.span,
            target,
            value,
            read: self.read.contains(&place),
            calls: Vec::new(),
            names: BTreeSet::new(),
            open: BTreeSet::new(),
        })
    }

    /// What a word reads.
    fn reads(&mut self, state: &Holds, word: &Word) {
        let mut names = BTreeSet::new();
        let mut read = |id: &ExprId| names_in(self.program, *id, &mut names);
        match &word.kind {
            WordKind::Assign { index, value, .. } => index.iter().chain([value]).for_each(&mut read),
            WordKind::Declare { index, value, .. } => index.iter().chain(value).for_each(&mut read),
            WordKind::Address { value, .. } | WordKind::Keyword { value: Some(value), .. } => read(value),
            WordKind::Constant(value) => read(value),
            WordKind::Call { args, .. } => args.iter().for_each(&mut read),
            _ => {}
        }
        for name in &names {
            if name == "R" {
                self.read.extend(state.given.values().flatten()); // any of them: the number is in brackets
            } else if let Some(number) = name.strip_prefix('R').and_then(|digits| digits.parse().ok()) {
                self.read.extend(state.given.get(&number).into_iter().flatten());
                if state.measured && is_result(number) && !state.fresh.contains(&number) {
                    self.results.insert((word.span.start, number), (number, word.span));
                }
            }
        }
    }

    /// What a word writes; `counts`: a loop counts it.
    fn writes(&mut self, state: &mut Holds, word: &Word, counts: bool) {
        let WordKind::Assign { value, name, .. } = &word.kind else { return };
        let known = written(self.program, word);
        if known.as_ref().is_none_or(|name| name.contains('[')) && self.program.is(*name, "R") {
            self.unclear = self.unclear.or(Some(word.span));
            return;
        }
        let number_of = |name: &String| name.strip_prefix('R').and_then(|digits| digits.parse::<u16>().ok());
        let Some(written) = known.as_ref().and_then(number_of) else { return };
        state.fresh.insert(written);
        if number(&format!("R{written}")).is_none() {
            return;
        }
        let single = matches!(spread(self.program, *value), Spread::One) && !counts;
        if !single || self.program.is_of_macro(word.span) || self.is_elsewhere(*name) {
            self.unclear = self.unclear.or(Some(word.span));
            return;
        }
        state.given.insert(written, BTreeSet::from([word.span.start]));
    }

    /// Whether a macro says a name: there is no place for another one.
    fn is_elsewhere(&self, name: Span) -> bool {
        self.program.placed(name) != name
    }

    /// A block with a word that could not be read: where it has to do with R parameters, it may read what was assigned,
    /// and assign what comes to a call.
    fn unread(&mut self, state: &mut Holds, words: &[Word]) {
        let Some(word) = words.iter().find(|word| word.kind == WordKind::Unknown) else { return };
        let whole = words.first().zip(words.last()).map(|(first, last)| Span { end: last.span.end, ..first.span });
        let unknown = words.iter().filter(|word| word.kind == WordKind::Unknown).map(|word| self.program.said(word));
        let mut texts = whole.map(|whole| self.program.name(whole)).into_iter().chain(unknown);
        if !texts.any(|text| has_parameter(&text)) {
            return;
        }
        state.unread = state.unread.or(Some(word.span));
        if !state.given.is_empty() {
            self.unread.insert(word.span.start, word.span);
        }
    }
}

/// Whether a text in upper case may name an R parameter: `R32`, `R[5]`, or an `@` command, which takes any.
fn has_parameter(text: &str) -> bool {
    let begins = |part: &str| part.trim_start().starts_with(|next: char| next.is_ascii_digit() || next == '[');
    text.contains('@') || text.split('R').skip(1).any(begins)
}

/// `R23` for `R23=…` and `R[23]=…`; none: the number is not known.
fn written(program: &Program, word: &Word) -> Option<String> {
    let WordKind::Assign { name, index, .. } = &word.kind else { return None };
    Some(plain_name(&fold::name(program, *name, index, NOTHING)?))
}

impl Follow for Walk<'_> {
    type State = Holds;

    fn block(&mut self, state: &mut Holds, words: &[Word]) {
        let counts = words.iter().any(|word| self.program.is_keyword(word, &["FOR"]));
        self.unread(state, words);
        for word in words {
            self.reads(state, word);
            self.writes(state, word, counts);
        }
    }

    fn lost(&mut self, place: Span) {
        self.lost.insert(place.start, place);
    }

    fn call(&mut self, state: &mut Holds, word: &Word) {
        let Some((cycle, name)) = self.candidates.get(&word.span.start).copied().zip(word.called()) else { return };
        if !is_printed(cycle) {
            let counts = state.given.contains_key(&VARIANT);
            self.newer.extend(counts.then(|| (word.span.start, (self.program.placed(name), cycle))));
            return;
        }
        if state.more || self.program.is_of_macro(word.span) || self.is_elsewhere(name) {
            self.unclear = self.unclear.or(Some(self.program.placed(name)));
        }
        self.unread.extend(state.unread.map(|place| (place.start, place)));
        (state.measured, state.fresh) = (true, BTreeSet::new());
        let new = || Met { cycle, word: word.span, name, given: BTreeMap::new() };
        let met = self.met.entry(word.span.start).or_insert_with(new);
        for (number, places) in &state.given {
            met.given.entry(*number).or_default().extend(places);
        }
    }
}
