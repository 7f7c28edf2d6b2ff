//! Calls that would read the value of another call: two R parameters of an 840C can be one parameter today, so that an
//! assignment for a later call may lie over that for a nearer one.

use super::{Assigned, Call, Clash, Older};
use crate::catalogue::r_parameters::{numbers, printed};
use crate::diagnostic::Span;
use crate::name::Name;
use crate::program::flow::{Follow, Meet, follow};
use crate::syntax::fold::{NOTHING, number};
use crate::syntax::programs::Programs;
use crate::syntax::{Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};

/// Assignments of one parameter that are told apart at a place: more than come to a call from its R parameters, so that
/// one too many is among them.
const WAYS: usize = 32;

/// What may have given a parameter its value, by the first byte.
#[derive(Clone, Debug, Default, PartialEq)]
struct Given {
    /// Assignments of R parameters.
    converted: BTreeSet<u32>,
    /// An assignment of the name itself.
    named: Option<u32>,
}

/// What the parameters hold at a place of the program.
#[derive(Clone, Debug, Default, PartialEq)]
struct Holds(BTreeMap<Name, Given>);

impl Meet for Holds {
    fn meet(&self, other: &Holds) -> Holds {
        let mut met = self.clone();
        for (name, given) in &other.0 {
            let known = met.0.entry(*name).or_default();
            known.named = known.named.or(given.named);
            known.converted.extend(&given.converted);
            while known.converted.len() > WAYS {
                known.converted.pop_last();
            }
        }
        met
    }
}

struct Walk<'a> {
    program: &'a Program,
    older: &'a Older,
    /// What R parameters can be, as programs write it.
    known: BTreeMap<&'static str, Name>,
    clashes: BTreeMap<(usize, Name), u32>,
    lost: Vec<Span>,
}

/// Each parameter of each call that would come from somewhere else than from its R parameter, once; and where that
/// could not be followed.
pub(super) fn clashes(program: &Program, programs: &Programs, older: &Older) -> (Vec<Clash>, Vec<Span>) {
    if older.calls.is_empty() || older.unclear.is_some() || !older.ways.is_empty() {
        return (Vec::new(), Vec::new());
    }
    let cycles: BTreeMap<&str, _> = older.calls.iter().map(|call| (call.cycle.name, call.cycle)).collect();
    let names = cycles.values().flat_map(|cycle| numbers().flat_map(|number| printed(cycle, number)));
    let known = names.map(|name| (name.as_str(), name)).collect();
    let mut walk = Walk { program, older, known, clashes: BTreeMap::new(), lost: Vec::new() };
    follow(program, programs, &mut walk);
    walk.lost.sort_by_key(|place| place.start);
    walk.lost.dedup();
    (walk.clashes.into_iter().map(|((call, name), from)| Clash { call, name, from }).collect(), walk.lost)
}

impl Walk<'_> {
    /// The names that a word gives a value to when it is converted.
    fn writes(&self, word: &Word) -> Vec<(Name, Given)> {
        let WordKind::Assign { name, .. } = &word.kind else { return Vec::new() };
        let place = word.span.start;
        if let Some(one) = self.assigned(place) {
            let converted = || Given { converted: BTreeSet::from([place]), named: None };
            return one.names.iter().map(|name| (*name, converted())).collect();
        }
        let named = || Given { named: Some(place), ..Given::default() };
        self.known.get(&self.program.name(*name)[..]).map(|name| (*name, named())).into_iter().collect()
    }

    fn assigned(&self, place: u32) -> Option<&Assigned> {
        let at = self.older.assigned.binary_search_by_key(&place, |one| one.word.start).ok()?;
        self.older.assigned.get(at)
    }

    /// The assignments that have to give a call this parameter.
    fn wanted(&self, call: usize, name: Name) -> BTreeSet<u32> {
        let Some(call) = self.older.calls.get(call) else { return BTreeSet::new() };
        let numbers = call.names.iter().filter(|(_, names)| names.contains(&name)).map(|(number, _)| number);
        let places = numbers.filter_map(|number| call.given.get(number)).flatten();
        places.filter_map(|at| self.older.assigned.get(*at)).map(|one| one.word.start).collect()
    }

    /// The assignment that gives a call a value which it must not have. What the program itself gives to a name counts
    /// where no R parameter comes.
    fn wrong(&self, wanted: &BTreeSet<u32>, found: &Given) -> Option<u32> {
        let strange = |place: &&u32| !wanted.contains(place) && !self.is_same(wanted, **place);
        let named = found.named.filter(|_| !wanted.is_empty());
        found.converted.iter().find(strange).copied().or(named)
    }

    /// Whether an assignment gives the number that the others give.
    fn is_same(&self, wanted: &BTreeSet<u32>, place: u32) -> bool {
        let value = |place: u32| number(self.program, self.assigned(place)?.value, NOTHING);
        let own = value(place);
        own.is_some() && !wanted.is_empty() && wanted.iter().all(|one| value(*one) == own)
    }
}

impl Follow for Walk<'_> {
    type State = Holds;

    fn block(&mut self, state: &mut Holds, words: &[Word]) {
        for word in words {
            state.0.extend(self.writes(word));
        }
    }

    fn lost(&mut self, place: Span) {
        self.lost.push(place);
    }

    fn call(&mut self, state: &mut Holds, word: &Word) {
        let at = |call: &Call| call.word.start;
        let Ok(call) = self.older.calls.binary_search_by_key(&word.span.start, at) else { return };
        let reads = self.older.calls.get(call).into_iter().flat_map(|call| &call.reads);
        for name in reads {
            let found = state.0.get(name);
            let wrong = found.and_then(|found| self.wrong(&self.wanted(call, *name), found));
            if let Some(from) = wrong {
                self.clashes.entry((call, *name)).or_insert(from);
            }
        }
    }
}

impl Clash {
    /// The later call for which the assignment is this parameter, where the same assignment comes to both calls: its
    /// R parameter, assigned again between them, parts the two.
    pub(super) fn later<'a>(&self, older: &'a Older) -> Option<&'a Call> {
        let at = older.assigned.binary_search_by_key(&self.from, |one| one.word.start).ok()?;
        let one = older.assigned.get(at)?;
        let mut behind = one.calls.iter().filter(|call| **call > self.call).filter_map(|call| older.calls.get(*call));
        let meant = |call: &&Call| call.names.get(&one.number).is_some_and(|names| names.contains(&self.name));
        behind.find(meant).filter(|_| one.calls.contains(&self.call))
    }

    /// The place of the assignment.
    pub(super) fn place(&self, program: &Program) -> Span {
        let place = Span { start: self.from, end: self.from + 1 };
        program.word_at(place).map_or(place, |word| word.span)
    }
}
