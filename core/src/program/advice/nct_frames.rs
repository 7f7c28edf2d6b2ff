//! Measurements where a run does not know where the machine measures, as it does not drive what stands before them: it
//! stops there, and this tells it without a run.

use super::nct::called_here;
use crate::control::{AXES, Plane};
use crate::diagnostic::{Diagnostic, Span};
use crate::own;
use crate::program::calls::CallSite;
use crate::program::flow::{self, Follow, LEVELS, Meet};
use crate::program::nct_functions::{Left, Said, Unknown, is_open, pass, tenths};
use crate::syntax::programs::Programs;
use crate::syntax::{Block, Program, Word};
use std::collections::BTreeMap;

/// Tells the first measurement behind each word that leaves unknown where it is.
pub fn look(program: &Program, programs: &Programs, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    if sites.is_empty() {
        return;
    }
    let sites = sites.iter().map(|site| (site.line, site.span)).collect();
    let mut rules = Rules { program, programs, sites, met: BTreeMap::new(), depth: 0 };
    flow::follow(program, programs, &mut rules);
    found.extend(rules.met.into_values().map(|(word, place, site)| {
        let line = f64::from(program.line_of(place.start) + 1);
        own::NCT_PLACE_OPEN.finding().text("word", word).number("line", line).on(site)
    }));
}

/// What holds at a place of the program on every way to it.
#[derive(Clone, Debug, Default, PartialEq)]
struct State {
    unknown: Unknown,
    drilling: Option<Span>,
    incremental: bool,
    plane: Plane,
}

impl Meet for State {
    fn meet(&self, other: &State) -> State {
        let both = |(name, _): &(&String, &Span)| other.unknown.contains_key(*name);
        State {
            unknown: self.unknown.iter().filter(both).map(|(name, span)| (name.clone(), *span)).collect(),
            drilling: self.drilling.and(other.drilling),
            incremental: self.incremental || other.incremental,
            plane: self.plane,
        }
    }
}

struct Rules<'a> {
    program: &'a Program,
    programs: &'a Programs,
    /// Places of the measuring calls by their lines.
    sites: BTreeMap<u32, Span>,
    /// The word, its place and the first measurement behind it, by the first byte of the word.
    met: BTreeMap<u32, (String, Span, Span)>,
    /// Programs in which the present one was called.
    depth: usize,
}

impl Rules<'_> {
    /// Meets a measuring call.
    fn measures(&mut self, state: &State, site: Span) {
        let concerns = |name: &str| is_open(name) || AXES.contains(&name);
        let Some((name, place)) = state.unknown.iter().find(|(name, _)| concerns(name)) else { return };
        let word = match AXES.contains(&name.as_str()) {
            true => self.program.written(*place),
            false => name.split(' ').next().unwrap_or(name).to_owned(),
        };
        self.met.entry(place.start).or_insert((word, *place, site));
    }

    fn take(&self, state: &mut State, codes: &[(u16, Span)], axes: [Option<(Option<f64>, Span)>; 3]) {
        for (code, _) in codes {
            match code {
                170 | 180 | 190 => state.plane = Plane::of(code / 10).unwrap_or_default(),
                900 | 910 => state.incremental = *code == 910,
                _ => {}
            }
        }
        let said = Said { codes, axes, absolute: !state.incremental, plane: state.plane };
        _ = pass(&said, &mut Left { unknown: &mut state.unknown, drilling: &mut state.drilling });
    }

    /// Goes through a program that a block calls, in the order of its lines; beside its jumps nothing more is certain
    /// than before it.
    fn through(&mut self, state: &mut State, unit: usize) {
        let program = self.program;
        let Some(unit) = self.programs.units.get(unit).filter(|_| self.depth < LEVELS) else { return };
        let before = state.clone();
        self.depth += 1;
        let mut jumps = false;
        for block in program.blocks_of(unit) {
            let words = program.words_of(block);
            jumps |= block.skip.is_some() || words.iter().any(|word| word.keyword().is_some());
            self.words(state, words);
            self.motion(state, block);
            if jumps {
                *state = state.meet(&before);
            }
            if block.skip.is_none() && goes_back(program, words) {
                break;
            }
        }
        self.depth -= 1;
    }
}

impl Follow for Rules<'_> {
    type State = State;

    fn block(&mut self, state: &mut State, words: &[Word]) {
        self.words(state, words);
        if goes_back(self.program, words) {
            *state = State::default();
        }
    }

    fn motion(&mut self, state: &mut State, block: &Block) {
        let Some(motion) = self.program.plain(block) else { return };
        if state.unknown.is_empty() && state.drilling.is_none() {
            return;
        }
        let (mut codes, mut axes) = (Vec::new(), [None; 3]);
        for part in motion.parts() {
            match part.letter {
                b'G' => codes.extend(tenths(part.value).map(|code| (code, part.span))),
                letter @ b'X'..=b'Z' => axes[usize::from(letter - b'X')] = Some((Some(part.value), part.span)),
                _ => {}
            }
        }
        self.take(state, &codes, axes);
    }
}

/// Whether nothing comes to the block behind this one: M99 without a condition.
fn goes_back(program: &Program, words: &[Word]) -> bool {
    let back = words.iter().any(|word| program.machine_function(word) == Some(99.0));
    back && !words.iter().any(|word| program.is_keyword(word, &["IF"]))
}

impl Rules<'_> {
    /// Takes in the words of a block, and the program that it calls.
    fn words(&mut self, state: &mut State, words: &[Word]) {
        let Some(first) = words.first() else { return };
        let program = self.program;
        let code = |word: &Word| Some((tenths(program.constant(word, "G")?)?, word.span));
        let codes: Vec<(u16, Span)> = words.iter().filter_map(code).collect();
        let site = self.sites.get(&program.line_of(first.span.start)).copied();
        let calls = codes.iter().any(|(code, _)| [650, 660, 661].contains(code));
        let written = |axis| {
            let value = |word: &Word| program.address(word, axis).map(|_| (program.constant(word, axis), word.span));
            words.iter().rev().find_map(value)
        };
        let axes = if site.is_some() || calls { [None; 3] } else { AXES.map(written) };
        self.take(state, &codes, axes);
        if let Some(site) = site {
            self.measures(state, site);
        }
        let line = program.line_of(first.span.start) as usize;
        let unit = program.blocks.get(line).and_then(|block| called_here(program, self.programs, block));
        let later = codes.iter().any(|(code, _)| *code == 660);
        if let Some(unit) = unit.filter(|_| !later) {
            self.through(state, unit);
        }
    }
}
