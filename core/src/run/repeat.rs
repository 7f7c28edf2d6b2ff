//! Repeated program parts: `REPEAT LABEL P=3`, `REPEAT FIRST LAST`, `REPEATB LABEL`, up to an `ENDLABEL` between them.

use super::{Address, Interpreter, Next, branch, expression, subprogram};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::{ExprId, Word, WordKind};

/// Most repetitions that `P` may ask for.
const MOST: f64 = 9999.0;

/// A program part that is being repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repetition {
    first: usize,
    last: usize,
    /// Passes that are still to come.
    left: u32,
    /// Block of the instruction.
    instruction: usize,
}

/// Begins the repetition that a block asks for.
pub fn begin(run: &mut Interpreter, at: usize, keyword: Span, start: ExprId, words: &[Word]) -> Result<Next, Problem> {
    let passes = written(run, words)?;
    if passes == 0 {
        return Ok(Next::Block);
    }
    let single = run.program.is(keyword, "REPEATB");
    let label = branch::target(run, start)?;
    let first = nearest(run, at, &label).ok_or_else(|| Problem::new("run-label", keyword, &*label))?;
    // the second label of `REPEAT FIRST LAST`
    let last = match words.iter().find_map(Word::called).map(|name| run.program.name(name)) {
        Some(end) => {
            let found = branch::places(run, &end).into_iter().find(|block| *block >= first);
            found.ok_or_else(|| Problem::new("run-label", keyword, end))?
        }
        None if single => first,
        None => default_end(run, at, first, keyword)?,
    };
    subprogram::room(run, keyword)?;
    if let Some(level) = run.levels.last_mut() {
        level.repeats.push(Repetition { first, last, left: passes - 1, instruction: at });
    }
    Ok(Next::Jump(first))
}

/// Whether a block with an instruction to repeat says nothing else: beside its labels and `P` nothing is carried out.
pub fn alone(run: &Interpreter, words: &[Word]) -> Result<(), Problem> {
    let other = |word: &&Word| match &word.kind {
        WordKind::Keyword { .. } | WordKind::Label(_) => false,
        WordKind::Call { args, .. } => !args.is_empty(),
        WordKind::Address { name, .. } => !run.program.is(*name, "P"),
        _ => true,
    };
    words.iter().find(other).map_or(Ok(()), |word| Err(branch::not_alone(run, word)))
}

/// Block behind a block that was carried out to its end.
pub fn after(run: &mut Interpreter, mut at: usize) -> usize {
    let Some(level) = run.levels.last_mut() else { return at + 1 };
    while let Some(part) = level.repeats.last_mut().filter(|part| part.last == at) {
        if part.left > 0 {
            part.left -= 1;
            return part.first;
        }
        at = part.instruction;
        level.repeats.pop();
    }
    at + 1
}

/// A jump out of a repeated part ends its repetition.
pub fn jumped(run: &mut Interpreter, to: usize) {
    if let Some(level) = run.levels.last_mut() {
        let outside = |part: &Repetition| to < part.first || to > part.last;
        while level.repeats.last().is_some_and(outside) {
            level.repeats.pop();
        }
    }
}

/// How many passes the `P` of an instruction asks for; without it one.
fn written(run: &Interpreter, words: &[Word]) -> Result<u32, Problem> {
    let asked = words.iter().find_map(|word| Some((run.program.address(word, "P")?, word.span)));
    asked.map_or(Ok(1), |(value, span)| count(expression::number(run, value)?, span))
}

/// How many passes an address of a call asks for; without it one.
pub fn passes(address: Option<&Address>) -> Result<u32, Problem> {
    address.map_or(Ok(1), |address| count(address.value.number().unwrap_or(f64::NAN), address.span))
}

/// A number of passes.
fn count(number: f64, place: Span) -> Result<u32, Problem> {
    let whole = number.fract() == 0.0 && (0.0..=MOST).contains(&number);
    whole.then_some(number as u32).ok_or_else(|| Problem::new("run-range", place, "P"))
}

/// The end of a part where no label names it: `ENDLABEL`, else the block before the instruction.
fn default_end(run: &Interpreter, at: usize, first: usize, keyword: Span) -> Result<usize, Problem> {
    let before = first < at;
    let mut ends = branch::places(run, "ENDLABEL").into_iter();
    match ends.find(|block| *block >= first && (!before || *block < at)) {
        Some(end) => Ok(end),
        None if before => Ok(at - 1),
        None => Err(Problem::new("run-label", keyword, "ENDLABEL")),
    }
}

/// The label before the instruction that is nearest, else the first behind it.
fn nearest(run: &Interpreter, at: usize, label: &str) -> Option<usize> {
    let blocks = branch::places(run, label);
    blocks.iter().rfind(|block| **block < at).or_else(|| blocks.iter().find(|block| **block > at)).copied()
}
