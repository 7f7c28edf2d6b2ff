//! Loops and jumps backward: with which states their beginning is passed, and what holds behind them. A body is
//! followed again with what its end leaves, as the control does, until that is nothing new.

use super::structure::{Branches, Open, target};
use super::{ENTRIES, Meet};
use crate::syntax::fold::NOTHING;
use crate::syntax::links::structural;
use crate::syntax::targets::Targets;
use crate::syntax::{Program, Word, WordKind, fold};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

/// All beginnings of loops of a program.
pub struct Passes<S> {
    heads: HashMap<usize, Head<S>>,
    /// Blocks of the labels and block numbers to which a jump may go back.
    labels: BTreeMap<String, Vec<usize>>,
}

/// The beginning of a loop.
#[derive(Default)]
struct Head<S> {
    /// With what its body is followed, and what the end of that pass leaves.
    passes: Vec<(S, Option<S>)>,
    /// The pass with which the present round began, and the one that is followed now; none: nothing comes here.
    round: Option<(usize, usize)>,
    /// Structures that are open before it.
    depth: usize,
    /// The next arrival is another pass of the same round.
    again: bool,
    /// What was open at the jump when it went back.
    left: Vec<Vec<Open<S>>>,
}

impl<S: PartialEq> Head<S> {
    /// The states in which a round that began with this pass leaves the loop.
    fn round_from(&self, first: usize, back: Back) -> Vec<&S> {
        let (mut states, mut passed) = (Vec::new(), Vec::new());
        let mut next = Some(first);
        while let Some(pass) = next.filter(|pass| !passed.contains(pass)) {
            passed.push(pass);
            let Some((begin, end)) = self.passes.get(pass) else { break };
            if matches!(back, Back::Tested(_)) {
                states.push(begin);
            }
            states.extend(end);
            let end = end.as_ref();
            next = end.and_then(|end| self.passes.iter().position(|(state, _)| state == end));
        }
        states
    }
}

/// What a block goes back to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Back {
    /// The beginning of `WHILE` or `FOR`, where the loop is left; perhaps at once.
    Tested(usize),
    /// The beginning of a loop with one pass at least, or a label; it is left here.
    Here(usize),
}

impl Back {
    pub fn head(self) -> usize {
        match self {
            Back::Tested(head) | Back::Here(head) => head,
        }
    }
}

impl<S: Meet> Passes<S> {
    pub fn of(program: &Program) -> Self {
        let mut found = Self { heads: HashMap::new(), labels: BTreeMap::new() };
        let mut names = BTreeSet::new();
        for (at, block) in program.blocks.iter().enumerate() {
            let words = program.words_of(block);
            if words.iter().all(|word| word.keyword().is_none()) {
                continue;
            }
            names.extend(words.iter().filter_map(|word| back_to(program, word)));
            if matches!(structural(program, words), Some("WHILE" | "FOR" | "LOOP" | "REPEAT")) {
                found.heads.insert(at, Head::default());
            }
        }
        if !names.is_empty() {
            let targets = Targets::of(program);
            let blocks = names.into_iter().map(|name| (targets.blocks(&name), name));
            let there = blocks.filter(|(blocks, _)| !blocks.is_empty());
            found.labels = there.map(|(blocks, name)| (name, blocks)).collect();
            found.heads.extend(found.labels.values().flatten().map(|at| (*at, Head::default())));
        }
        found
    }

    /// Whether a loop begins in this block, or a jump goes back to it.
    pub fn begins(&self, at: usize) -> bool {
        self.heads.contains_key(&at)
    }

    /// The present way comes to a block, before its words count.
    pub fn begin(&mut self, branches: &Branches<S>, at: usize) {
        let Some(head) = self.heads.get_mut(&at) else { return };
        let place = head.passes.iter().position(|(state, _)| *state == branches.state).or_else(|| {
            let room = head.passes.len() < 2 * ENTRIES;
            room.then(|| head.passes.push((branches.state.clone(), None)));
            room.then(|| head.passes.len() - 1)
        });
        let place = place.filter(|_| !branches.dead);
        let first = head.round.filter(|_| head.again).map(|(first, _)| first);
        head.round = place.map(|place| (first.unwrap_or(place), place));
        if !head.again {
            head.depth = branches.open.len();
            head.left.clear();
        }
        head.again = false;
    }

    /// What this block goes back to: it ends a loop, or jumps to a label before it.
    pub fn back(&self, program: &Program, branches: &Branches<S>, at: usize, range: &Range<usize>) -> Option<Back> {
        let words = program.words_at(at);
        // a jump back into a structure may bring one along that begins only behind this block
        let begin = branches.loop_begin().filter(|head| *head <= at);
        match structural(program, words) {
            Some("ENDWHILE" | "ENDFOR") => {
                begin.map(|head| if runs_at_least_once(program, head) { Back::Here(head) } else { Back::Tested(head) })
            }
            Some("ENDLOOP" | "UNTIL") => begin.map(Back::Here),
            _ => {
                let name = words.iter().find_map(|word| back_to(program, word))?;
                let blocks = self.labels.get(&name)?;
                let before = blocks.partition_point(|block| *block <= at);
                let head = *blocks.get(before.checked_sub(1)?)?;
                range.contains(&head).then_some(Back::Here(head))
            }
        }
    }

    /// Takes in what goes back where that is new: whether there is room for another pass with it.
    pub fn returns(&mut self, branches: &Branches<S>, back: Back) -> Option<bool> {
        let head = self.heads.get_mut(&back.head()).filter(|_| !branches.dead)?;
        let known = |head: &Head<S>| head.passes.iter().any(|(state, _)| *state == branches.state);
        let Some((_, now)) = head.round else { return (!known(head)).then_some(false) };
        if let Some((_, end)) = head.passes.get_mut(now) {
            *end = Some(end.as_ref().map_or_else(|| branches.state.clone(), |end| end.meet(&branches.state)));
        }
        (!known(head)).then_some(head.passes.len() < ENTRIES)
    }

    /// Goes back for another pass.
    pub fn again(&mut self, branches: &mut Branches<S>, back: Back) {
        if let Some(head) = self.heads.get_mut(&back.head()) {
            head.again = true;
            head.left.push(branches.open.split_off(head.depth.min(branches.open.len())));
        }
    }

    /// What holds behind the block, all passes together.
    pub fn done(&mut self, branches: &mut Branches<S>, back: Back) {
        let Some(head) = self.heads.get_mut(&back.head()) else { return };
        let left = std::mem::take(&mut head.left);
        let nobody = branches.dead && left.is_empty() && matches!(back, Back::Here(_));
        branches.also(left);
        if let Some((first, _)) = head.round.filter(|_| !nobody) {
            let behind = head.round_from(first, back).into_iter().cloned();
            if let Some(state) = behind.reduce(|one, other| one.meet(&other)) {
                branches.state = state;
                branches.dead = false;
            }
        }
    }
}

/// Whether this is a `FOR` from a number to one that is not below it.
fn runs_at_least_once(program: &Program, head: usize) -> bool {
    let ends = program.words_at(head).iter().filter_map(|word| match &word.kind {
        WordKind::Assign { value, .. } | WordKind::Keyword { value: Some(value), .. } => Some(*value),
        _ => None,
    });
    let numbers = ends.map(|value| fold::number(program, value, NOTHING));
    matches!(numbers.collect::<Vec<_>>()[..], [Some(from), Some(to)] if from <= to)
}

/// The label or block number to which a word may jump back.
fn back_to(program: &Program, word: &Word) -> Option<String> {
    target(program, word).flatten().filter(|_| program.is_keyword(word, &["GOTOB", "GOTO"]))
}
