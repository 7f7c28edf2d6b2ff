//! Ways to a measuring call on which a program is not followed: parts that are repeated by their labels, passes of a
//! subprogram, calls behind every motion or at a signal, jumps whose target only a run knows. With one of them a value
//! may reach a call, or be read, in another order than that of the text.

use crate::diagnostic::Span;
use crate::program::flow::structure::{returns, target};
use crate::program::flow::{Called, called, called_here, callers};
use crate::syntax::fold::NOTHING;
use crate::syntax::language::{BY_TEXT, MODAL, is_word};
use crate::syntax::programs::{Programs, Unit};
use crate::syntax::targets::{Targets, canonical};
use crate::syntax::{Expr, ExprId, Program, Word, WordKind, fold};
use std::collections::BTreeSet;

/// What carries out a text, or the whole program anew.
const COMPUTED: [&str; 3] = ["EXECSTRING", "GOTOS", "ISOCALL"];

/// What a word that could not be read may have in it, so that it leads somewhere.
const LEADS: [&str; 5] = ["GOTO", "REPEAT", "CALL", "EXECSTRING", "SETINT"];

/// The words that lead somewhere on such a way, in the order of the text. `measures`: first bytes of the words that may
/// be a measuring call.
pub(super) fn unfollowed(program: &Program, programs: &Programs, measures: BTreeSet<u32>) -> Vec<Span> {
    let ways = Ways::of(program, programs, measures);
    programs.units.iter().flat_map(|unit| ways.of_unit(unit)).collect()
}

struct Ways<'a> {
    program: &'a Program,
    programs: &'a Programs,
    /// First bytes of the words that may be a measuring call.
    measures: BTreeSet<u32>,
    /// First bytes of the words that call a program of the text which has to do with R parameters or such calls.
    leads: BTreeSet<u32>,
    /// Blocks that may not be carried out once more without another outcome for R parameters.
    busy: Vec<usize>,
    /// Names of variables: a target with such a name is what the variable holds.
    declared: BTreeSet<String>,
}

impl<'a> Ways<'a> {
    fn of(program: &'a Program, programs: &'a Programs, measures: BTreeSet<u32>) -> Self {
        let declared = program.words.iter().filter_map(Word::declared).map(|name| program.name(name)).collect();
        let mut ways = Self { program, programs, measures, leads: BTreeSet::new(), busy: Vec::new(), declared };
        ways.find_leads();
        ways.busy = (0..program.blocks.len()).filter(|at| ways.is_busy(*at)).collect();
        ways
    }

    fn find_leads(&mut self) {
        let (program, programs) = (self.program, self.programs);
        let own = |unit: &Unit| unit.blocks.clone().any(|at| self.concerns(program.words_at(at)));
        let mut busy: Vec<bool> = programs.units.iter().map(own).collect();
        let mut called_by = vec![Vec::new(); busy.len()];
        for (from, calls) in callers(program, programs).into_iter().enumerate() {
            for to in calls {
                called_by[to].push(from);
            }
        }
        let mut open: Vec<usize> = (0..busy.len()).filter(|unit| busy[*unit]).collect();
        while let Some(unit) = open.pop() {
            for from in std::mem::take(&mut called_by[unit]) {
                if !std::mem::replace(&mut busy[from], true) {
                    open.push(from);
                }
            }
        }
        for block in &program.blocks {
            let words = program.words_of(block);
            let leading = called_here(program, programs, words).filter(|(_, unit)| busy[*unit]);
            self.leads.extend(leading.filter_map(|(at, _)| words.get(at)).map(|word| word.span.start));
        }
    }

    /// Whether a block names an R parameter, or may measure.
    fn concerns(&self, words: &[Word]) -> bool {
        words.iter().any(|word| self.measures.contains(&word.span.start) || names_parameter(&self.program.said(word)))
    }

    fn is_busy(&self, at: usize) -> bool {
        let words = self.program.words_at(at);
        let leaves = words.iter().any(|word| target(self.program, word).is_some()) || returns(self.program, words);
        leaves || self.concerns(words) || words.iter().any(|word| self.leads.contains(&word.span.start))
    }

    fn of_unit(&self, unit: &Unit) -> Vec<Span> {
        let places = Targets::within(self.program, unit.blocks.clone());
        unit.blocks.clone().filter_map(|at| self.of_block(&places, at)).collect()
    }

    /// What of a block leads somewhere on a way that is not followed.
    fn of_block(&self, places: &Targets, at: usize) -> Option<Span> {
        let words = self.program.words_at(at);
        let found = (0..words.len()).find(|word| self.computes(words, *word));
        let found = found.or_else(|| self.jump(places, at, words)).or_else(|| self.repetition(places, at, words));
        let found = found.or_else(|| self.called_otherwise(words))?;
        let (first, last) = (words.get(found)?, words.last()?);
        let whole = Span { start: first.span.start, end: last.span.end };
        Some(self.program.placed(whole))
    }

    /// Whether only a run knows what a word carries out, or when.
    fn computes(&self, words: &[Word], at: usize) -> bool {
        let program = self.program;
        let Some(word) = words.get(at) else { return false };
        if word.kind == WordKind::Unknown {
            let said = program.said(word);
            return LEADS.iter().any(|lead| said.contains(lead));
        }
        if program.is_keyword(word, &["DO"]) {
            // a synchronized action: at any time
            return self.concerns(words) || words.iter().any(|word| self.leads.contains(&word.span.start));
        }
        if program.is_call(word, &BY_TEXT) && self.programs.units.len() > 1 {
            return !self.is_named(words, at);
        }
        program.is_call(word, &COMPUTED) || program.is_call(word, &["BLOCK"]) || self.hands_over(words, at)
    }

    /// Whether the name of the called program stands there as a text.
    fn is_named(&self, words: &[Word], at: usize) -> bool {
        let argument = match words.get(at).map(|word| &word.kind) {
            Some(WordKind::Call { args, .. }) => args.first(),
            _ => None,
        };
        let behind = words.get(at + 1).and_then(|word| match &word.kind {
            WordKind::Constant(value) => Some(value),
            _ => None,
        });
        let value = argument.or(behind).and_then(|value| self.program.expr(*value));
        matches!(value, Some(Expr::Text(_)))
    }

    /// Whether a call may write an R parameter that it gets as an argument.
    fn hands_over(&self, words: &[Word], at: usize) -> bool {
        let Some(WordKind::Call { name, args, .. }) = words.get(at).map(|word| &word.kind) else { return false };
        let is_parameter = |value: &ExprId| match self.program.expr(*value) {
            Some(Expr::Name { name, .. }) => self.program.is(*name, "R") || names_parameter(&self.program.name(*name)),
            _ => false,
        };
        if !args.iter().any(is_parameter) {
            return false;
        }
        match called(self.program, self.programs, words, at) {
            Some(Called::Here(unit)) => {
                let signature = self.programs.units.get(unit).map_or(&[][..], |unit| self.program.signature(unit));
                signature.iter().any(|word| self.program.is_keyword(word, &["VAR"]))
            }
            Some(Called::Elsewhere) => self.programs.external.contains(&self.program.name(*name)),
            None => is_word(&self.program.name(*name)),
        }
    }

    /// A jump whose target is not known, or that is followed in another direction than the control takes it.
    fn jump(&self, places: &Targets, at: usize, words: &[Word]) -> Option<usize> {
        let jumps = || words.iter().enumerate().filter_map(|(i, word)| Some((i, word, target(self.program, word)?)));
        let several = jumps().count() > 1;
        let strange = |(_, word, name): &(usize, &Word, Option<String>)| {
            !name.as_ref().is_some_and(|name| self.is_followed(places, at, word, name, several))
        };
        jumps().find(strange).map(|(i, ..)| i)
    }

    fn is_followed(&self, places: &Targets, at: usize, word: &Word, name: &str, several: bool) -> bool {
        let places = places.blocks(name);
        let before = places.first().is_some_and(|place| *place <= at);
        let behind = places.last().is_some_and(|place| *place > at);
        let is = |keyword: &str| self.program.is_keyword(word, &[keyword]);
        let known = match (before, behind) {
            (_, true) if is("GOTOF") => true,
            // of several jumps of a block only one is followed back, and the others then not at all
            (true, _) if is("GOTOB") => !several,
            (false, true) => !is("GOTOB"),
            (true, false) => is("GOTO") && !several,
            _ => false,
        };
        known && !self.declared.contains(name)
    }

    /// An instruction to repeat a part by its labels, where that has to do with R parameters and calls, or goes away.
    fn repetition(&self, places: &Targets, at: usize, words: &[Word]) -> Option<usize> {
        let found = words.iter().position(|word| {
            let labelled = matches!(word.kind, WordKind::Keyword { value: Some(_), .. });
            labelled && self.program.is_keyword(word, &["REPEAT", "REPEATB"])
        })?;
        let Some(WordKind::Keyword { value: Some(value), .. }) = words.get(found).map(|word| &word.kind) else {
            return None;
        };
        let label = match self.program.expr(*value) {
            Some(Expr::Name { name, .. } | Expr::Text(name)) => canonical(&self.program.name(*name)),
            Some(Expr::Number(number, _)) => format!("N{number}"),
            _ => return Some(found),
        };
        let begins = places.blocks(&label);
        if begins.is_empty() || self.declared.contains(&label) {
            return Some(found);
        }
        let ends = words.iter().filter_map(Word::called).map(|name| canonical(&self.program.name(name)));
        let ends = ends.chain(["ENDLABEL".to_owned()]).filter_map(|name| places.blocks(&name).last().copied());
        let first = begins.first().copied().unwrap_or(at).min(at);
        let last = ends.chain(begins.last().copied()).fold(at, usize::max);
        // every block between the first and the last of these labels, which is more than the part
        let busy = self.busy.partition_point(|block| *block < first);
        self.busy.get(busy).filter(|block| **block <= last).map(|_| found)
    }

    /// A call that is carried out otherwise than once in its place, where that has to do with R parameters.
    fn called_otherwise(&self, words: &[Word]) -> Option<usize> {
        let leads = words.iter().any(|word| self.leads.contains(&word.span.start));
        let measures = words.iter().any(|word| self.measures.contains(&word.span.start));
        let manner = |word: &Word| self.program.is_call(word, &[MODAL, "SETINT"]);
        let passes = |word: &Word| {
            let number = self.program.address(word, "P").map(|value| fold::number(self.program, value, NOTHING));
            number.is_some_and(|number| number != Some(1.0))
        };
        // passes of a measuring call itself get the same values
        words.iter().position(|word| (leads || measures) && manner(word) || leads && passes(word))
    }
}

/// Whether a text in upper case names an R parameter, `R32`, `R[5]`, `$R32`, or has an `@` command, which takes any.
fn names_parameter(text: &str) -> bool {
    let bytes = text.as_bytes();
    let begins = |at: usize| at.checked_sub(1).is_none_or(|at| !bytes[at].is_ascii_alphanumeric() && bytes[at] != b'_');
    let numbered = |at: usize| {
        let next = bytes[at + 1..].iter().find(|byte| !byte.is_ascii_whitespace());
        next.is_some_and(|byte| byte.is_ascii_digit() || *byte == b'[')
    };
    text.contains('@') || (0..bytes.len()).any(|at| bytes[at] == b'R' && begins(at) && numbered(at))
}
