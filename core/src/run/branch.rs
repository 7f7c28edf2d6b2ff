//! Where a block sends the program: `IF`, loops, `CASE`, jumps.

use super::{Datum, Interpreter, Next, Words, evaluate, expression, locals, names};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::links::Link;
use crate::syntax::tree::{Expr, ExprId, Word, WordKind};
use std::rc::Rc;

/// The last word that belongs to a control structure in a block that is left by a jump behind it.
const ENDS_OF_STRUCTURE: [&str; 8] = ["ELSE", "ENDIF", "ENDWHILE", "ENDFOR", "ENDLOOP", "TO", "END", "DO"];

/// `IF` with a jump (or NCT `THEN`) decides over the rest of the block, else over the blocks up to `ELSE` or `ENDIF`.
pub fn condition(
    run: &mut Interpreter,
    place: Span,
    value: Option<ExprId>,
    found: &mut Words,
) -> Result<bool, Problem> {
    let holds = truth(run, place, value)?;
    match run.link(found.at) {
        Some(Link::If(other)) if !holds => {
            found.next = Some(behind(run, other)?);
            Ok(false)
        }
        // an IF with ELSE is linked to the ELSE block, which is passed over from above
        Some(Link::If(_)) => Ok(true),
        Some(Link::Alone) => Err(Problem::new("run-unmatched", place, "IF")),
        _ => Ok(holds),
    }
}

fn truth(run: &Interpreter, place: Span, value: Option<ExprId>) -> Result<bool, Problem> {
    let value = value.ok_or_else(|| Problem::new("run-not-a-number", place, run.program.name(place)))?;
    Ok(expression::number(run, value)? != 0.0)
}

/// Loops and the parts of `IF`.
pub fn structure(
    run: &mut Interpreter,
    place: Span,
    value: Option<ExprId>,
    found: &mut Words,
) -> Result<bool, Problem> {
    let (link, name) = (run.link(found.at), run.program.name(place));
    if link == Some(Link::Alone) || (link.is_none() && name != "TO") {
        return Err(Problem::new("run-unmatched", place, name));
    }
    match (&*name, link) {
        ("WHILE", Some(Link::Begin(end))) if !truth(run, place, value)? => {
            found.next = Some(behind(run, end)?);
            return Ok(false);
        }
        ("TO", Some(Link::Begin(end))) => {
            let last = value.map(|value| expression::number(run, value)).transpose()?;
            if found.counter.zip(last).is_some_and(|(counter, last)| counter > last) {
                found.next = Some(behind(run, end)?);
                return Ok(false);
            }
        }
        ("ELSE", Some(Link::Else(_))) => drop(behind(run, found.at)?),
        ("ENDWHILE" | "ENDLOOP" | "END", Some(Link::End(begin))) => found.next = Some(Next::Jump(begin)),
        ("UNTIL", Some(Link::End(begin))) if !truth(run, place, value)? => {
            found.next = Some(Next::Jump(begin + 1));
        }
        ("ENDFOR", Some(Link::End(begin))) => found.next = again(run, begin)?,
        _ => {}
    }
    Ok(found.next.is_none())
}

/// Counts the variable of the `FOR` in this block up; where its body goes on, if it does.
fn again(run: &mut Interpreter, begin: usize) -> Result<Option<Next>, Problem> {
    let program = Rc::clone(&run.program);
    let (mut counter, mut last) = (None, None);
    for word in program.words_at(begin) {
        match &word.kind {
            WordKind::Assign { name, index, .. } => {
                let key = names::key(run, *name, index)?;
                let value = names::read(run, &key, *name)?.number().unwrap_or(0.0) + 1.0;
                names::write(run, &key, &Datum::Number(value), *name)?;
                counter = Some(value);
            }
            WordKind::Keyword { name, value: Some(value) } if program.is(*name, "TO") => {
                last = Some(expression::number(run, *value)?);
            }
            _ => {}
        }
    }
    counter.zip(last).filter(|(counter, last)| counter <= last).map(|_| behind(run, begin)).transpose()
}

/// The block behind one of a control structure. Words behind the structure's own need a block of their own.
pub fn behind(run: &Interpreter, block: usize) -> Result<Next, Problem> {
    let words = run.program.words_at(block);
    let last = words.iter().rposition(|word| run.program.is_keyword(word, &ENDS_OF_STRUCTURE));
    match last.and_then(|last| words.get(last + 1)) {
        None => Ok(Next::Jump(block + 1)),
        Some(word) => Err(not_alone(run, word)),
    }
}

/// A word that needs a block of its own.
pub fn not_alone(run: &Interpreter, word: &Word) -> Problem {
    Problem::new("run-alone", word.span, run.program.written(word.span))
}

/// Block of a jump target; none for GOTOC without target.
pub fn jump(run: &Interpreter, place: Span, value: Option<ExprId>, at: usize) -> Result<Option<usize>, Problem> {
    let word = run.program.name(place);
    let target = value.map(|id| target(run, id)).transpose()?.unwrap_or_default();
    let [forward, backward] = nearest(run, &target, at);
    let found = match &*word {
        "GOTOF" => forward,
        "GOTOB" => backward,
        _ => forward.or(backward),
    };
    match found {
        None if word != "GOTOC" => Err(Problem::new("run-label", place, target)),
        found => Ok(found),
    }
}

/// A target is a label, a block number, a text or a number.
pub fn target(run: &Interpreter, id: ExprId) -> Result<String, Problem> {
    if let Some(Expr::Name { name, index }) = run.program.expr(id)
        && index.is_empty()
        && !run.program.text(*name).starts_with(b"#")
        && !locals::declared(run, &run.program.name(*name))
    {
        return Ok(run.program.name(*name));
    }
    match evaluate(run, id)? {
        Datum::Vacant => {
            let place = run.program.place(id);
            Err(Problem::new("run-not-a-number", place, run.program.written(place)))
        }
        value => Ok(named(&value)),
    }
}

/// How far a number that was worked out may lie from the whole one that is meant.
const NEARLY: f64 = 1e-9;

/// The target that a value tells.
pub fn named(value: &Datum) -> String {
    match value {
        Datum::Number(number) if (number - number.round()).abs() < NEARLY => format!("N{}", number.round()),
        Datum::Number(number) => format!("N{number}"),
        other => other.shown().to_ascii_uppercase(),
    }
}

/// The block of a target in the present program that comes next behind a block, and the last one before.
pub fn nearest(run: &Interpreter, target: &str, at: usize) -> [Option<usize>; 2] {
    let blocks = places(run, target);
    let forward = blocks.iter().copied().find(|block| *block > at);
    [forward, blocks.into_iter().rfind(|block| *block <= at)]
}

/// Blocks of a label or a block number in the present program.
pub fn places(run: &Interpreter, target: &str) -> Vec<usize> {
    let blocks = run.targets().blocks(target);
    let own = run.levels.last().map(|level| level.blocks.clone());
    let inside = |block: &usize| own.as_ref().is_none_or(|own| own.contains(block));
    blocks.into_iter().filter(inside).collect()
}
